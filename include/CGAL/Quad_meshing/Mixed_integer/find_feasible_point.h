// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_FIND_FEASIBLE_POINT_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_FIND_FEASIBLE_POINT_H

#include <CGAL/Quad_meshing/Mixed_integer/Feasible_point.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/read_solver_options.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/solve_mixed_integer_kernel.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/parameters.h>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief finds a point that meets the constraints of a problem, or tells how far all points are from that.

This is the feasibility problem of \cgalCite{Bom12} , Chapter 3,
\f[ \min_{x, z} \; z \quad\mbox{subject to}\quad Gx - h \le z,\; g(x) \le z,\; z \ge 0,\; Cx = d,\; l \le x \le u , \f]
with the integers taken for reals, or kept as integers if a method is named. The energy plays no part. If the smallest
\f$ z \f$ is zero its point is a start for other methods; if it is not, \f$ z \f$ is by how much right-hand sides have
to be raised until there is a point. Convex constraints hold up to \f$ 10^{-7} \f$, as for `solve_mixed_integer()`.
The input is never changed, no exception is thrown and nothing is printed.

\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param problem the variables and the constraints
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{rounding_method}
    \cgalParamDescription{`Rounding_method::RELAXED`: integers are taken for reals; a method of the branch-and-bound
                          family: integers are integers, and this method finds them; others are not supported}
    \cgalParamType{`Rounding_method`}
    \cgalParamDefault{`Rounding_method::RELAXED`}
  \cgalParamNEnd
  \cgalParamNBegin{constraint_tolerance}
    \cgalParamDescription{relative size of what counts as zero when equality constraints depend on each other}
    \cgalParamType{`double`}
    \cgalParamDefault{`1e-6`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number_of_nodes}
    \cgalParamDescription{the number of subproblems after which the search for integers ends}
    \cgalParamType{`double`}
    \cgalParamDefault{`1e8`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{the number of seconds, by the clock on the wall, after which the search ends}
    \cgalParamType{`double`}
    \cgalParamDefault{unlimited}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{the solver of symmetric positive definite systems; only its type matters}
    \cgalParamType{`Sparse_cholesky<double>` or a model of `SparseLinearAlgebraWithFactorTraits_d`}
    \cgalParamDefault{`Sparse_cholesky<double>`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{told about the progress, and asked whether to go on}
    \cgalParamType{a class like `Default_visitor`, by `std::ref`}
    \cgalParamDefault{`Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the point, its violation with a lower bound, and what happened
*/
template <typename NamedParameters = parameters::Default_named_parameters>
Feasible_point find_feasible_point(const Mixed_integer_problem& problem,
                                   const NamedParameters& np = parameters::default_values())
{
  internal::check_parameters<NamedParameters, internal_np::rounding_method_t, internal_np::constraint_tolerance_t,
                             internal_np::maximum_number_of_nodes_t, internal_np::maximum_running_time_t,
                             internal_np::sparse_linear_solver_t, internal_np::visitor_t>();

  const internal::Solver_options options = internal::read_solver_options(np, Rounding_method::RELAXED);
  internal::Named_visitor<NamedParameters> visitor(np);
  return internal::find_feasible_point_kernel(problem, options, internal::read_linear_solver(np), visitor);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_FIND_FEASIBLE_POINT_H
