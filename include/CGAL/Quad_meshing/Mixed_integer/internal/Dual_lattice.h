// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DUAL_LATTICE_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DUAL_LATTICE_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Lattice_reduction.h>

#include <Eigen/Core>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A reduced basis of the dual of the lattice that has the upper triangular factor `R`: one vector of integers per
// column, reduced in the length of R^-T a.
inline Eigen::MatrixXd reduced_dual_basis(const Eigen::MatrixXd& R)
{
  // The inverse transpose is lower triangular; in reverse order it is upper triangular.
  const int m = static_cast<int>(R.rows());
  const Eigen::MatrixXd inverse =
    R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd(Eigen::MatrixXd::Identity(m, m)));
  Lattice_reduction reduction(inverse.transpose().reverse());
  reduction.run(0, 0, []() { return true; }); // no blocks: LLL
  return reduction.transformation().colwise().reverse();
}

// Of two opposite vectors, the one whose first nonzero coordinate is positive.
inline void choose_sign(Eigen::VectorXd& a)
{
  for(double x : a)
    if(x != 0)
    {
      if(x < 0)
        a = -a;
      return;
    }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DUAL_LATTICE_H
