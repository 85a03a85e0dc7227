// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_FEASIBLE_POINT_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_FEASIBLE_POINT_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_solution.h>

#include <Eigen/Core>

#include <limits>
#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief The answer of `find_feasible_point()`.
*/
struct Feasible_point
{
  /// `FEASIBLE` if `x` meets the constraints; `INFEASIBLE` if it is proven that no point does; `LIMIT_REACHED` if
  /// neither was found; `STOPPED`, `UNSUPPORTED_PROBLEM` or `NUMERICAL_FAILURE`.
  Mixed_integer_status status = Mixed_integer_status::NUMERICAL_FAILURE;
  /// One sentence that says what happened.
  std::string message;

  /// The point; if there is no feasible one, the one that violates the inequalities least, of those that were found.
  /// Empty if no point was found that meets equality constraints, bounds and integer conditions.
  Eigen::VectorXd x;
  /// The largest excess at `x` of an inequality constraint over its right-hand side, or of a convex function over zero;
  /// zero if there is none.
  double violation = std::numeric_limits<double>::quiet_NaN();
  /// A proven lower bound of the violation of all points.
  double lower_bound = 0;

  /// The number of tangents of convex constraints that were added.
  int cuts = 0;
  /// The wall-clock time.
  double seconds = 0;

  /// tells whether `x` meets all constraints.
  bool is_valid() const { return status == Mixed_integer_status::FEASIBLE; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_FEASIBLE_POINT_H
