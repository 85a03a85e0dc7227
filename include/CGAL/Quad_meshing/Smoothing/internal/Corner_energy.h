// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_CORNER_ENERGY_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_CORNER_ENERGY_H

#include <CGAL/Quad_meshing/Smoothing/internal/Side_turn_energy.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// One corner of a quad as a function of the position of one of its vertices.
//
// Every corner, with sides a and b and signed area D = (a x b).n of their parallelogram, pays
//     ( |a|^2 + |b|^2 + w (A + D^2/A) ) / (2 chi(D)),
// where A is the area it should have. The first part is least for a square corner of any size, the second for
// D = A. With epsilon = 0, chi(D) = D: the energy is infinite before a corner folds. With a larger epsilon, chi is
// the smooth positive function (D + sqrt(D^2 + epsilon^2))/2 of Garanzha et al. 2021 (Foldover-free maps in
// 50 lines of code), which keeps the energy of folded corners finite and pulls them open.
struct Corner_energy
{
  typedef Simple_cartesian<double>::Point_3 Point_3;
  typedef Simple_cartesian<double>::Vector_3 Vector_3;

  // Weight w of the area part against the shape part.
  static constexpr double area_weight = 0.1;

  double lengths, area; // squared lengths of the sides, and D, which is linear in the position
  Vector_3 lengths_gradient, area_gradient;
  double lengths_curvature;

  double value(double aim, double epsilon) const { return top(aim) / (2 * chi(root(epsilon), epsilon)); }

  double top(double aim) const { return lengths + area_weight * (aim + area * area / aim); }
  double root(double epsilon) const { return std::sqrt(area * area + epsilon * epsilon); }

  // (area + root)/2 without cancellation
  double chi(double root, double epsilon) const
  {
    return (area > 0 ? area + root : epsilon * epsilon / (root - area)) / 2;
  }

  // The three corners of the quad p, p1, p2, p3 with normal n that move with p.
  static std::array<Corner_energy, 3> around(const Point_3& p, const Point_3& p1, const Point_3& p2, const Point_3& p3,
                                             const Vector_3& n)
  {
    const Vector_3 a = p1 - p, b = p3 - p, s = p2 - p1, t = p2 - p3;
    const double aa = a * a, bb = b * b;
    return { { Corner_energy{ aa + bb, cross_product(a, b) * n, -2 * (a + b), cross_product(n, p3 - p1), 4 },
               Corner_energy{ aa + s * s, cross_product(a, s) * n, -2 * a, cross_product(n, s), 2 },
               Corner_energy{ bb + t * t, cross_product(t, b) * n, -2 * b, cross_product(t, n), 2 } } };
  }
};

// Value, gradient and Hessian of a sum of corner energies along two directions u and w.
class Corner_energy_model
{
  typedef Corner_energy::Vector_3 Vector_3;

  // Smallest eigenvalue of the Hessian, relative to the largest, that a step divides by.
  static constexpr double least_curvature = 1e-3;

  Vector_3 m_u, m_w;
  double m_value = 0, m_gu = 0, m_gw = 0, m_huu = 0, m_huw = 0, m_hww = 0;

public:
  Corner_energy_model(const Vector_3& u, const Vector_3& w) : m_u(u), m_w(w) {}

  double value() const { return m_value; }
  std::array<double, 2> gradient() const { return { { m_gu, m_gw } }; }
  std::array<double, 3> hessian() const { return { { m_huu, m_huw, m_hww } }; } // its entries (u,u), (u,w), (w,w)

  void add(const Corner_energy& t, double aim, double epsilon)
  {
    constexpr double area_weight = Corner_energy::area_weight;
    const double root = t.root(epsilon), chi = t.chi(root, epsilon), top = t.top(aim);
    const double chi1 = chi / root, chi2 = epsilon * epsilon / (2 * root * root * root);
    const double du = t.area_gradient * m_u, dw = t.area_gradient * m_w;
    const double slope = 2 * area_weight * t.area / aim;
    const double nu = t.lengths_gradient * m_u + slope * du, nw = t.lengths_gradient * m_w + slope * dw;
    const double c1 = 1 / (2 * chi), c2 = chi1 / (2 * chi * chi);
    const double c3 = top * (chi1 * chi1 / (chi * chi * chi) - chi2 / (2 * chi * chi)) + area_weight / (aim * chi);
    m_value += top * c1;
    m_gu += nu * c1 - top * c2 * du;
    m_gw += nw * c1 - top * c2 * dw;
    m_huu += t.lengths_curvature * c1 - 2 * c2 * nu * du + c3 * du * du;
    m_huw += -c2 * (nu * dw + nw * du) + c3 * du * dw;
    m_hww += t.lengths_curvature * c1 - 2 * c2 * nw * dw + c3 * dw * dw;
  }

  // A side, from the vertex that moves on, for which a direction is wanted; `across` is orthogonal to it.
  void add_side(const Vector_3& side, const Vector_3& along, const Vector_3& across, double weight)
  {
    const double x = side * along, y = side * across, square = x * x + y * y;
    if(!(square > 0))
      return;
    const Side_turn_energy e(x, y);
    const Vector_3 turn = (y * along - x * across) / square; // of the side, when the vertex moves
    const double tu = turn * m_u, tw = turn * m_w;
    m_value += weight * e.value();
    m_gu += weight * e.slope() * tu;
    m_gw += weight * e.slope() * tw;
    m_huu += weight * e.curvature() * tu * tu;
    m_huw += weight * e.curvature() * tu * tw;
    m_hww += weight * e.curvature() * tw * tw;
  }

  // Newton's step with the absolute values of the eigenvalues, zero where there is none; along u only, and in the
  // plane.
  Vector_3 step_along_u() const { return m_huu == 0 ? Vector_3(0, 0, 0) : (-m_gu / CGAL::abs(m_huu)) * m_u; }

  Vector_3 step_in_plane() const
  {
    const double mean = (m_huu + m_hww) / 2, half = (m_huu - m_hww) / 2;
    const double radius = std::sqrt(half * half + m_huw * m_huw);
    const double floor = least_curvature * (CGAL::abs(mean) + radius);
    if(!(floor > 0))
      return Vector_3(0, 0, 0);
    const double e1 = (std::max)(CGAL::abs(mean + radius), floor), e2 = (std::max)(CGAL::abs(mean - radius), floor);
    double c = 1, s = 0; // unit eigenvector of mean + radius
    if(radius > 0)
    {
      const double angle = std::atan2(m_huw, half) / 2;
      c = std::cos(angle);
      s = std::sin(angle);
    }
    const double x = -(c * m_gu + s * m_gw) / e1, y = -(c * m_gw - s * m_gu) / e2;
    return (c * x - s * y) * m_u + (s * x + c * y) * m_w;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_CORNER_ENERGY_H
