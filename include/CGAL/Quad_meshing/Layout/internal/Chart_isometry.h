// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_CHART_ISOMETRY_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_CHART_ISOMETRY_H

#include <CGAL/Quad_meshing/Layout/internal/Layout_charts.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// How far the map of a patch is from an isometry, as a function of the corners of its chart (thesis, section 7.2).
//
// A triangle has the energy |J'J - I|^2 (7.7), weighted by its area (7.10). Its vertices keep their bilinear
// coordinates in the chart (7.9), so J is linear in the parameters q = (a, b, c, d, e) of the chart, J = sum q_m J_m,
// and the energy is a polynomial of degree four. With C = J'J - I,
//   dE/dq_m = 4 <C, J'J_m>,
//   d2E/dq_m dq_n = 4 <C, J_n'J_m> + 2 <J_n'J + J'J_n, J_m'J + J'J_m> .
class Chart_isometry
{
public:
  typedef Eigen::Matrix<double, 5, 1> Parameters;
  typedef Eigen::Matrix<double, 5, 5> Hessian;

  // Triangles with an area below this part of the square of their longest edge have no shape to be kept.
  static constexpr double least_flatness = 1e-12;

  // Adds a triangle with the vertices (0, 0), (x1, 0), (x2, y2) in its plane, whose vertices have the bilinear
  // coordinates st.
  void add(double x1, double x2, double y2, const std::array<Eigen::Vector2d, 3>& st)
  {
    if(!(x1 * y2 > least_flatness * (x1 * x1 + x2 * x2 + y2 * y2)))
      return;
    Triangle t;
    t.area = 0.5 * x1 * y2;
    Eigen::Matrix2d D;
    D << x1, x2, 0, y2;
    const Eigen::Matrix2d inverse = D.inverse();
    std::array<Eigen::Matrix<double, 2, 5>, 3> N;
    for(int i = 0; i < 3; ++i)
    {
      const double s = st[i].x(), r = st[i].y();
      N[i] << s * (1 - r), (1 - s) * r, 0, s * r, 0, //
        0, 0, (1 - s) * r, 0, s * r;
    }
    for(int k = 0; k < 5; ++k)
    {
      Eigen::Matrix2d U;
      U << N[1].col(k) - N[0].col(k), N[2].col(k) - N[0].col(k);
      t.J[k] = U * inverse;
    }
    m_triangles.push_back(t);
    m_area += t.area;
  }

  bool empty() const { return m_triangles.empty(); }
  double area() const { return m_area; }

  double energy(const Parameters& q) const
  {
    double sum = 0;
    for(const Triangle& t : m_triangles)
      sum += t.area * defect(jacobian(t, q)).squaredNorm();
    return sum;
  }

  void derivatives(const Parameters& q, Parameters& gradient, Hessian& hessian) const
  {
    gradient.setZero();
    hessian.setZero();
    for(const Triangle& t : m_triangles)
    {
      const Eigen::Matrix2d J = jacobian(t, q), C = defect(J);
      std::array<Eigen::Matrix2d, 5> S;
      for(int m = 0; m < 5; ++m)
      {
        const Eigen::Matrix2d P = J.transpose() * t.J[m];
        gradient[m] += t.area * 4 * C.cwiseProduct(P).sum();
        S[m] = P + P.transpose();
      }
      for(int m = 0; m < 5; ++m)
        for(int n = 0; n <= m; ++n)
        {
          const Eigen::Matrix2d P = t.J[n].transpose() * t.J[m];
          hessian(m, n) += t.area * (4 * C.cwiseProduct(P).sum() + 2 * S[n].cwiseProduct(S[m]).sum());
        }
    }
    for(int m = 0; m < 5; ++m)
      for(int n = m + 1; n < 5; ++n)
        hessian(m, n) = hessian(n, m);
  }

private:
  struct Triangle
  {
    double area;
    std::array<Eigen::Matrix2d, 5> J;
  };

  static Eigen::Matrix2d jacobian(const Triangle& t, const Parameters& q)
  {
    Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
    for(int k = 0; k < 5; ++k)
      J += q[k] * t.J[k];
    return J;
  }

  static Eigen::Matrix2d defect(const Eigen::Matrix2d& J) { return J.transpose() * J - Eigen::Matrix2d::Identity(); }

  std::vector<Triangle> m_triangles;
  double m_area = 0;
};

// Moves the corners of a chart to a minimum of the energy, with two degrees of freedom or with five, by Newton's
// method. The chart stays convex, and no step raises the energy.
inline Quadrilateral_chart optimize_chart(const Chart_isometry& isometry, const Quadrilateral_chart& start,
                                          bool is_rectangle)
{
  constexpr int most_steps = 50, most_halvings = 40;
  constexpr double relative_decrease = 1e-12; // of the energy, at which it counts as minimal
  constexpr double least_curvature = 1e-6;    // relative to the largest one
  if(isometry.empty())
    return start;
  // the width and height of a rectangle, (a, 0, c, a, c), or all five parameters
  Eigen::Matrix<double, 5, Eigen::Dynamic> K;
  Eigen::VectorXd r;
  const Chart_isometry::Parameters q0 = start.parameters();
  if(is_rectangle)
  {
    K.setZero(5, 2);
    K(0, 0) = K(3, 0) = K(2, 1) = K(4, 1) = 1;
    r = Eigen::Vector2d(0.5 * (q0[0] + q0[3]), 0.5 * (q0[2] + q0[4]));
  }
  else
  {
    K.setIdentity(5, 5);
    r = q0;
  }
  double energy = isometry.energy(K * r);
  for(int step = 0; step < most_steps; ++step)
  {
    Chart_isometry::Parameters gradient;
    Chart_isometry::Hessian hessian;
    isometry.derivatives(K * r, gradient, hessian);
    const Eigen::VectorXd g = K.transpose() * gradient;
    const Eigen::MatrixXd H = K.transpose() * hessian * K;
    // a direction of negative curvature is descended as one of positive curvature
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(H);
    const double largest = eigen.eigenvalues().cwiseAbs().maxCoeff();
    if(!(largest > 0))
      break;
    const Eigen::VectorXd curvature = eigen.eigenvalues().cwiseAbs().cwiseMax(least_curvature * largest);
    const Eigen::VectorXd direction =
      -(eigen.eigenvectors() * (eigen.eigenvectors().transpose() * g).cwiseQuotient(curvature));
    double length = 1, next = energy;
    bool found = false;
    for(int i = 0; i < most_halvings && !found; ++i, length /= 2)
    {
      const Eigen::VectorXd candidate = r + length * direction;
      next = isometry.energy(K * candidate);
      found = next < energy && Quadrilateral_chart(K * candidate).is_convex();
      if(found)
        r = candidate;
    }
    const double decrease = energy - next;
    if(!found)
      break;
    energy = next;
    if(decrease <= relative_decrease * energy)
      break;
  }
  return Quadrilateral_chart(K * r);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_CHART_ISOMETRY_H
