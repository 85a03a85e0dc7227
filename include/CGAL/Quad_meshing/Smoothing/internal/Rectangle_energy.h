// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_RECTANGLE_ENERGY_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_RECTANGLE_ENERGY_H

#include <CGAL/Quad_meshing/Smoothing/internal/Corner_energy.h>

#include <CGAL/Simple_cartesian.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// One corner of a quad as a function of its two sides, that are to be orthogonal first, and equal second.
//
// With the angle theta between the sides, the logarithm s of the ratio of their lengths, and that of the ratio of the
// area of their parallelogram to the area A that it should have, t, every corner pays
//     ( l cosh(s) + 1 - l ) / sin(theta) + w cosh(t).
// With l = 1 this is the energy of `Corner_energy`. A smaller l lets quads be rectangles where the connectivity asks
// for it. In s, theta and t the energy is convex. So the matrix of its second derivatives is positive semidefinite if
// those of s, theta and t themselves are left out.
struct Rectangle_energy
{
  typedef Simple_cartesian<double>::Vector_3 Vector_3;
  typedef Eigen::Vector4d Sides; // x and y of both sides in the plane of the quad

  // The weights l, the ratio of those of stretch and shear in `Layout_distortion`, and w.
  static constexpr double squareness = 0.25, area_weight = Corner_energy::area_weight;
  // The sine of the angle, the part of the area and that of its root that count at least: folded corners have finite
  // energies.
  static constexpr double least_sine = 0.05, least_area = 0.05, least_length = 0.01;
  // The energy of a square of the right size.
  static constexpr double least = 1 + area_weight;
  static constexpr double least_with(double weight) { return 1 + weight; }

  // For the sides a and b, a corner of a quad with unit normal n, and the weight w.
  static double value(const Vector_3& a, const Vector_3& b, const Vector_3& n, double aim, double weight = area_weight)
  {
    return Rectangle_energy(std::sqrt(a * a), std::sqrt(b * b), a * b, cross_product(a, b) * n, aim).value(weight);
  }

  // The gradient, and the matrix of second derivatives without those that are left out.
  static void derivatives(const Sides& x, double aim, Sides& gradient, Eigen::Matrix4d& matrix,
                          double weight = area_weight)
  {
    const Eigen::Vector2d a = x.head<2>(), b = x.tail<2>();
    const Rectangle_energy e(a.norm(), b.norm(), a.dot(b), a[0] * b[1] - a[1] * b[0], aim);
    const double aa = e.m_la * e.m_la, bb = e.m_lb * e.m_lb;
    Sides s, theta, t;
    s << a / aa, -b / bb;
    theta << a[1] / aa, -a[0] / aa, -b[1] / bb, b[0] / bb;
    t << a / aa, b / bb;
    t += e.m_cosine / e.m_sine * theta;

    const double ratio = e.m_la / e.m_lb, sinh_s = (ratio - 1 / ratio) / 2;
    const double per_s = squareness * sinh_s / e.m_sine, per_theta = -e.top() * e.m_cosine / (e.m_sine * e.m_sine);
    gradient = per_s * s + per_theta * theta + weight / 2 * (e.m_area - 1 / e.m_area) * t;
    matrix = squareness * e.cosh_s() / e.m_sine * s * s.transpose() -
             per_s * e.m_cosine / e.m_sine * (s * theta.transpose() + theta * s.transpose()) +
             e.top() * (1 + e.m_cosine * e.m_cosine) / (e.m_sine * e.m_sine * e.m_sine) * theta * theta.transpose() +
             weight / 2 * (e.m_area + 1 / e.m_area) * t * t.transpose();
  }

private:
  Rectangle_energy(double a, double b, double dot, double cross, double aim)
    : m_la((std::max)(a, least_length * std::sqrt(aim)))
    , m_lb((std::max)(b, least_length * std::sqrt(aim)))
    , m_cosine(dot / (m_la * m_lb))
    , m_sine((std::max)(cross / (m_la * m_lb), least_sine))
    , m_area((std::max)(cross / aim, least_area))
  {
  }

  double cosh_s() const { return (m_la / m_lb + m_lb / m_la) / 2; }
  double top() const { return squareness * cosh_s() + 1 - squareness; }
  double value(double weight) const { return top() / m_sine + weight / 2 * (m_area + 1 / m_area); }

  double m_la, m_lb, m_cosine, m_sine, m_area;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_RECTANGLE_ENERGY_H
