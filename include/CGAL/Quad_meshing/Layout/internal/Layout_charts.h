// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_CHARTS_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_CHARTS_H

#include <CGAL/Quad_meshing/Layout/internal/Embedded_layout.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

inline double cross_product_2(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

// A chart: a convex quadrilateral in the plane, its corners counterclockwise (thesis, section 7.1). The first corner
// is the origin, the second one lies on the first axis, so five numbers remain: (a, 0), (d, e) and (b, c).
struct Quadrilateral_chart
{
  // How convex a chart has to be: the sine of each angle is at least this.
  static constexpr double least_sine = 0.05;
  static constexpr double pi = 3.14159265358979323846;

  std::array<Eigen::Vector2d, 4> corner;

  static Quadrilateral_chart rectangle(double width, double height)
  {
    Eigen::Matrix<double, 5, 1> q;
    q << width, 0, height, width, height;
    return Quadrilateral_chart(q);
  }

  // The quadrilateral with sides of these lengths and these inner angles at its corners, as nearly as they fit: the
  // angles are scaled to 360 degrees together, and what is missing between the ends is shared by the corners.
  static Quadrilateral_chart from_sides(const std::array<double, 4>& length, const std::array<double, 4>& angle)
  {
    double sum = 0;
    for(double a : angle)
      sum += a;
    std::array<Eigen::Vector2d, 5> p;
    p[0].setZero();
    double heading = 0;
    for(int k = 0; k < 4; ++k)
    {
      p[k + 1] = p[k] + length[k] * Eigen::Vector2d(std::cos(heading), std::sin(heading));
      heading += pi - 2 * pi * angle[(k + 1) % 4] / sum;
    }
    for(int k = 1; k < 4; ++k)
      p[k] -= k / 4. * p[4];
    // into the frame in which the second corner lies on the first axis
    const double width = p[1].norm();
    const Eigen::Vector2d x = p[1] / width, y(-x.y(), x.x());
    Eigen::Matrix<double, 5, 1> q;
    q << width, x.dot(p[3]), y.dot(p[3]), x.dot(p[2]), y.dot(p[2]);
    return Quadrilateral_chart(q);
  }

  // From (a, b, c, d, e).
  explicit Quadrilateral_chart(const Eigen::Matrix<double, 5, 1>& q)
    : corner{ { Eigen::Vector2d(0, 0), Eigen::Vector2d(q[0], 0), Eigen::Vector2d(q[3], q[4]),
                Eigen::Vector2d(q[1], q[2]) } }
  {
  }

  Eigen::Matrix<double, 5, 1> parameters() const
  {
    Eigen::Matrix<double, 5, 1> q;
    q << corner[1].x(), corner[3].x(), corner[3].y(), corner[2].x(), corner[2].y();
    return q;
  }

  Eigen::Vector2d on_side(int side, double t) const { return (1 - t) * corner[side] + t * corner[(side + 1) % 4]; }

  // The bilinear coordinates of corner k: (0, 0), (1, 0), (1, 1), (0, 1).
  Eigen::Vector2d bilinear(const Eigen::Vector2d& st) const
  {
    const double s = st.x(), t = st.y();
    return (1 - s) * (1 - t) * corner[0] + s * (1 - t) * corner[1] + s * t * corner[2] + (1 - s) * t * corner[3];
  }

  // The bilinear coordinates of a point. With p = s B + t C + s t D, the cross product of p - t C and B + t D vanishes:
  // a quadratic equation in t, of which the solution nearer to the chart is taken.
  Eigen::Vector2d inverse_bilinear(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d B = corner[1] - corner[0], C = corner[3] - corner[0],
                          D = corner[2] - corner[1] - corner[3] + corner[0], q = p - corner[0];
    const double k0 = cross_product_2(q, B), k1 = cross_product_2(q, D) - cross_product_2(C, B),
                 k2 = -cross_product_2(C, D);
    double roots[2];
    const double discriminant = (std::max)(k1 * k1 - 4 * k0 * k2, 0.);
    // the stable form: one root by the quotient that does not cancel, the other one by the product of both
    const double z = -0.5 * (k1 + (k1 < 0 ? -1 : 1) * std::sqrt(discriminant));
    roots[0] = z != 0 ? k0 / z : 0;
    roots[1] = k2 != 0 ? z / k2 : roots[0];
    auto outside = [](double x) { return std::isfinite(x) ? (std::max)((std::max)(-x, x - 1), 0.) : 1e300; };
    Eigen::Vector2d best(0, 0);
    double best_distance = 1e301;
    for(double t : roots)
    {
      const Eigen::Vector2d along = B + t * D;
      const double s = (q - t * C).dot(along) / along.squaredNorm();
      const double d = outside(s) + outside(t);
      if(d < best_distance)
      {
        best = Eigen::Vector2d(s, t);
        best_distance = d;
      }
    }
    return best;
  }

  bool is_convex() const
  {
    for(int k = 0; k < 4; ++k)
    {
      const Eigen::Vector2d e = corner[(k + 1) % 4] - corner[k], f = corner[(k + 2) % 4] - corner[(k + 1) % 4];
      if(!(cross_product_2(e, f) >= least_sine * e.norm() * f.norm()) || !(e.squaredNorm() > 0))
        return false;
    }
    return true;
  }
};

// The charts of all patches of a layout, and where the sides of the patches lie in them.
struct Layout_charts
{
  // An arc in a chart: the point s of the way from its source to its target and n off it to the left lies at
  // origin + s along + n normal. Two charts that meet at an arc have one frame each, so (s, n) leads from one to the
  // other: a translation, a rotation, a scaling along the arc and the same back, the transition function (7.4).
  struct Frame
  {
    Eigen::Vector2d origin, along, normal;

    Eigen::Matrix2d matrix() const
    {
      Eigen::Matrix2d m;
      m << along, normal;
      return m;
    }
    Eigen::Vector2d point(const Eigen::Vector2d& sn) const { return origin + matrix() * sn; }
    Eigen::Vector2d coordinates(const Eigen::Vector2d& p) const { return matrix().inverse() * (p - origin); }
  };

  std::vector<Quadrilateral_chart> chart;              // per patch
  std::vector<std::array<double, 2>> interval_on_side; // per direction: the part of its side, by lengths

  explicit Layout_charts(const Embedded_layout& e) : m_e(&e), m_length(e.number_of_arcs())
  {
    for(int a = 0; a < e.number_of_arcs(); ++a)
      m_length[a] = e.arc_length(a);
    interval_on_side.resize(2 * e.number_of_arcs());
    for(const Surface_layout::Patch& p : e.layout.patches)
      for(const std::vector<Surface_layout::Side_arc>& side : p.sides)
      {
        const double sum = side_length(side);
        double at = 0;
        for(const Surface_layout::Side_arc& s : side)
        {
          const double begin = at;
          at += m_length[s.arc];
          interval_on_side[Layout_topology::direction(s)] = { { begin / sum, &s == &side.back() ? 1. : at / sum } };
        }
      }
  }

  double arc_length(int arc) const { return m_length[arc]; }

  double side_length(const std::vector<Surface_layout::Side_arc>& side) const
  {
    double sum = 0;
    for(const Surface_layout::Side_arc& s : side)
      sum += m_length[s.arc];
    return sum;
  }

  // Where a direction begins (t = 0), ends (t = 1), or is in between, in the chart to its left.
  Eigen::Vector2d position(int d, double t) const
  {
    const std::array<double, 2>& i = interval_on_side[d];
    return chart[m_e->topology.patch_of_direction[d]].on_side(m_e->topology.side_of_direction[d],
                                                              (1 - t) * i[0] + t * i[1]);
  }

  // The frame of an arc in the chart to the left of one of its directions.
  Frame frame(int d) const
  {
    const Eigen::Vector2d p = position(d, d % 2 == 0 ? 0 : 1), q = position(d, d % 2 == 0 ? 1 : 0);
    const Eigen::Vector2d along = q - p;
    return Frame{ p, along, Eigen::Vector2d(-along.y(), along.x()) / along.norm() };
  }

private:
  const Embedded_layout* m_e;
  std::vector<double> m_length; // per arc
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_CHARTS_H
