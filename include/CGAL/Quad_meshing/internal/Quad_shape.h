// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_QUAD_SHAPE_H
#define CGAL_QUAD_MESHING_INTERNAL_QUAD_SHAPE_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

typedef Simple_cartesian<double>::Point_3 Shape_point_3;
typedef Simple_cartesian<double>::Vector_3 Shape_vector_3;

// The shape of one quad with corners p[0], .., p[3].
//
// The normal of a quad is the cross product of its diagonals; its length is twice the area of the
// quad's projection along it. At corner k, `jacobian` is the area of the parallelogram of the two
// sides that meet there, signed by that normal, and `scaled_jacobian` the same of unit sides.
struct Quad_shape
{
  Shape_vector_3 normal;        // unit, or zero for a quad without area
  double area;                  // of the projection along the normal
  std::array<double, 4> length; // of side k, from corner k to corner k+1
  std::array<double, 4> scaled_jacobian;
  std::array<double, 4> angle; // interior, in degrees, in [0, 360)
  double planarity;            // gap between the diagonals over the mean side

  double minimal_scaled_jacobian() const { return *std::min_element(scaled_jacobian.begin(), scaled_jacobian.end()); }

  double aspect_ratio() const
  {
    const auto mm = std::minmax_element(length.begin(), length.end());
    return *mm.first > 0 ? *mm.second / *mm.first : std::numeric_limits<double>::infinity();
  }
};

inline Shape_vector_3 unit_or_zero(const Shape_vector_3& v)
{
  const double l = std::sqrt(v.squared_length());
  return l > 0 ? v / l : Shape_vector_3(0, 0, 0);
}

inline Quad_shape shape_of_quad(const std::array<Shape_point_3, 4>& p)
{
  Quad_shape s;
  const Shape_vector_3 twice = cross_product(p[2] - p[0], p[3] - p[1]);
  s.normal = unit_or_zero(twice);
  s.area = std::sqrt(twice.squared_length()) / 2;

  std::array<Shape_vector_3, 4> side;
  double mean = 0;
  for(int k = 0; k < 4; ++k)
  {
    side[k] = p[(k + 1) % 4] - p[k];
    s.length[k] = std::sqrt(side[k].squared_length());
    mean += s.length[k] / 4;
  }
  for(int k = 0; k < 4; ++k)
  {
    const int j = (k + 3) % 4;
    const Shape_vector_3 cross = cross_product(side[j], side[k]);
    const double jacobian = cross * s.normal, product = s.length[j] * s.length[k];
    s.scaled_jacobian[k] = product > 0 ? jacobian / product : 0;
    const double angle = std::atan2(std::sqrt(cross.squared_length()), -(side[j] * side[k])) * 180 / CGAL_PI;
    s.angle[k] = jacobian < 0 ? 360 - angle : angle;
  }
  s.planarity = mean > 0 ? CGAL::abs(side[0] * s.normal) / mean : 0;
  return s;
}

// The smallest scaled jacobian alone, which is what the inner loops need.
inline double minimal_scaled_jacobian(const Shape_point_3& p0, const Shape_point_3& p1, const Shape_point_3& p2,
                                      const Shape_point_3& p3, Shape_vector_3& normal)
{
  normal = unit_or_zero(cross_product(p2 - p0, p3 - p1));
  const Shape_vector_3 side[4] = { p1 - p0, p2 - p1, p3 - p2, p0 - p3 };
  double squared[4];
  for(int k = 0; k < 4; ++k)
    squared[k] = side[k].squared_length();
  double smallest = 1;
  for(int k = 0; k < 4; ++k)
  {
    const int j = (k + 3) % 4;
    const double product = squared[j] * squared[k];
    const double sj = product > 0 ? (cross_product(side[j], side[k]) * normal) / std::sqrt(product) : 0;
    smallest = (std::min)(smallest, sj);
  }
  return smallest;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_QUAD_SHAPE_H
