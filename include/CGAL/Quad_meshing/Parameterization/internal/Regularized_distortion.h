// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_REGULARIZED_DISTORTION_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_REGULARIZED_DISTORTION_H

#include <CGAL/Quad_meshing/internal/Regularized_determinant.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <limits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A distortion of 2x2 Jacobians that is finite on folded ones and grows without bound towards them as
// epsilon vanishes (Garanzha et al., "Foldover-free maps in 50 lines of code", 2021), plus a pull
// towards the identity, the combed field:
//
//   N(J) / chi(det J) + a/2 |J - I|^2,   N(J) = |J|^2 / 2 + l/2 (det^2 + 1),   chi(D) = (D + sqrt(D^2 + epsilon^2)) /
//   2.
//
// With epsilon = 0 it is the exact barrier, infinite for det <= 0.
class Regularized_distortion
{
public:
  typedef Eigen::Matrix<double, 4, 1> Vector_4; // (J00, J01, J10, J11)
  typedef Eigen::Matrix<double, 4, 4> Matrix_4;

  double epsilon = 0;
  double area_weight = 0.5;      // l: how much keeping the area counts against keeping the angles
  double alignment_weight = 0.5; // a

  double value(const Eigen::Matrix2d& J) const
  {
    const double D = J.determinant(), c = chi().value(D);
    if(c <= 0)
      return (std::numeric_limits<double>::infinity)();
    return numerator(J, D) / c + 0.5 * alignment_weight * (J - Eigen::Matrix2d::Identity()).squaredNorm();
  }

  // Gradient, and the Hessian with its negative eigenvalues set to zero.
  void derivatives(const Eigen::Matrix2d& J, Vector_4& gradient, Matrix_4& hessian) const
  {
    const double D = J.determinant(), N = numerator(J, D);
    const double c = chi().value(D), dc = chi().derivative(D), ddc = chi().second_derivative(D);
    const Vector_4 a(J(0, 0), J(0, 1), J(1, 0), J(1, 1));
    const Vector_4 dD(J(1, 1), -J(1, 0), -J(0, 1), J(0, 0));
    Matrix_4 ddD = Matrix_4::Zero();
    ddD(0, 3) = ddD(3, 0) = 1;
    ddD(1, 2) = ddD(2, 1) = -1;

    const Vector_4 dN = a + area_weight * D * dD;
    gradient = dN / c - (N * dc / (c * c)) * dD + alignment_weight * (a - Vector_4(1, 0, 0, 1));

    hessian = (Matrix_4::Identity() + area_weight * (dD * dD.transpose() + D * ddD)) / c -
              (dc / (c * c)) * (dN * dD.transpose() + dD * dN.transpose()) +
              (2 * N * dc * dc / (c * c * c) - N * ddc / (c * c)) * (dD * dD.transpose()) - (N * dc / (c * c)) * ddD;
    const Eigen::SelfAdjointEigenSolver<Matrix_4> eigen(hessian);
    const Vector_4 values = eigen.eigenvalues().cwiseMax(0.);
    hessian = eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose() +
              alignment_weight * Matrix_4::Identity();
  }

private:
  Regularized_determinant chi() const { return Regularized_determinant{ epsilon }; }

  double numerator(const Eigen::Matrix2d& J, double D) const
  {
    return 0.5 * J.squaredNorm() + 0.5 * area_weight * (D * D + 1);
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_REGULARIZED_DISTORTION_H
