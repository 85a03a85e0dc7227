// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_GEOMETRY_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_GEOMETRY_H

#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

typedef std::array<double, 3> Soup_vector;

inline Soup_vector soup_difference(const Soup_vector& a, const Soup_vector& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

inline Soup_vector soup_scaled(const Soup_vector& a, double s) { return { { s * a[0], s * a[1], s * a[2] } }; }

inline Soup_vector soup_cross(const Soup_vector& a, const Soup_vector& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

inline double soup_dot(const Soup_vector& a, const Soup_vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline double soup_length(const Soup_vector& a) { return std::sqrt(soup_dot(a, a)); }

inline double soup_distance(const Soup_vector& a, const Soup_vector& b) { return soup_length(soup_difference(a, b)); }

// How large a model is.
struct Soup_size
{
  double diagonal = 0;           // of its bounding box
  double largest_coordinate = 0; // in absolute value

  explicit Soup_size(const std::vector<Polygon_soup::Point>& points)
  {
    if(points.empty())
      return;
    Polygon_soup::Point low = points[0], high = points[0];
    for(const Polygon_soup::Point& p : points)
      for(std::size_t d = 0; d < 3; ++d)
      {
        low[d] = (std::min)(low[d], p[d]);
        high[d] = (std::max)(high[d], p[d]);
        largest_coordinate = (std::max)(largest_coordinate, std::abs(p[d]));
      }
    diagonal = soup_distance(low, high);
  }

  // Lengths up to this one are rounding of computations in double precision: eight units in the last place of the
  // largest coordinate. Sums and products of three coordinates, and their conversion from decimal digits, lose up to
  // that much.
  double vanishing_length() const
  {
    constexpr double units = 8;
    return units * std::numeric_limits<double>::epsilon() * largest_coordinate;
  }
};

// Tells whether a triangle is flat.
class Flatness
{
  double m_vanishing_length, m_unit;

  // A vertex that was rounded to the accuracy of the file is off a line through two other such vertices by less than
  // four units in the last place of the largest coordinate.
  static constexpr double units = 4;
  // What is called flat on account of the accuracy of the file must be a sliver too, with its middle vertex well
  // between the others: not a triangle of a mesh that is as fine as its file can say.
  static constexpr double largest_sliver = 1e-3; // height over the longest side
  static constexpr double shortest_side = 10;    // in heights

public:
  Flatness(const Soup_size& size, double rounding_unit)
    : m_vanishing_length(size.vanishing_length()), m_unit(rounding_unit)
  {
  }

  // Whether the height over the longest side is rounding. `longest` becomes the corner where that side begins.
  bool operator()(const Soup_vector& p, const Soup_vector& q, const Soup_vector& r, int& longest) const
  {
    const std::array<Soup_vector, 3> sides = { { soup_difference(q, p), soup_difference(r, q),
                                                 soup_difference(p, r) } };
    const std::array<double, 3> lengths = { { soup_length(sides[0]), soup_length(sides[1]), soup_length(sides[2]) } };
    const auto largest = std::max_element(lengths.begin(), lengths.end());
    longest = static_cast<int>(largest - lengths.begin());
    if(!(*largest > m_vanishing_length))
      return true;
    // The cross product of scaled vectors, which cannot underflow.
    const Soup_vector u = soup_scaled(sides[0], 1 / *largest), v = soup_scaled(sides[1], 1 / *largest);
    const double height = soup_length(soup_cross(u, v)) * *largest;
    if(height <= m_vanishing_length)
      return true;
    if(height > largest_sliver * *largest || height * shortest_side > *std::min_element(lengths.begin(), lengths.end()))
      return false;
    double coordinate = 0;
    for(const Soup_vector* x : { &p, &q, &r })
      for(double c : *x)
        coordinate = (std::max)(coordinate, std::abs(c));
    return height <= units * m_unit * coordinate;
  }
};

// Angles around an edge, counterclockwise as it is looked at from its second end.
class Angles_around_edge
{
  Soup_vector m_origin, m_x, m_y;

public:
  Angles_around_edge(const Soup_vector& p, const Soup_vector& q) : m_origin(p)
  {
    const Soup_vector axis = soup_difference(q, p);
    std::size_t smallest = 0;
    for(std::size_t d = 1; d < 3; ++d)
      if(std::abs(axis[d]) < std::abs(axis[smallest]))
        smallest = d;
    Soup_vector helper = { { 0, 0, 0 } };
    helper[smallest] = 1;
    m_x = soup_cross(axis, helper);
    m_y = soup_scaled(soup_cross(axis, m_x), 1 / (std::max)(soup_length(axis), (std::numeric_limits<double>::min)()));
  }

  // The angle of a point, in [0, 2 pi).
  double operator()(const Soup_vector& p) const
  {
    const Soup_vector d = soup_difference(p, m_origin);
    double a = std::atan2(soup_dot(d, m_y), soup_dot(d, m_x));
    if(a < 0)
      a += 2 * CGAL_PI;
    constexpr double rounding = 1e-9; // radians: what is as good as a full turn
    return a > 2 * CGAL_PI - rounding ? 0 : a;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_GEOMETRY_H
