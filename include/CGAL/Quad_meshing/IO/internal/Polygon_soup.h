// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_POLYGON_SOUP_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_POLYGON_SOUP_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Numbers of vertices, polygons, corners: half the memory of std::size_t.
typedef std::uint32_t Soup_index;
constexpr Soup_index no_index = 0xFFFFFFFF;

// Polygons as they are in a file.
struct Polygon_soup
{
  typedef std::array<double, 3> Point;

  std::vector<Point> points;
  std::vector<Soup_index> corners;           // the vertices of all polygons, one polygon behind the other
  std::vector<Soup_index> first_corner{ 0 }; // of each polygon, and the end of the last one

  // The first corner with a number that no vertex can have, and that number.
  std::size_t impossible_corner = static_cast<std::size_t>(-1);
  long long impossible_index = 0;

  // The relative accuracy of coordinates: single precision where the format stores them so.
  double rounding_unit = std::numeric_limits<double>::epsilon();

  // Elements of the file that are no polygons and were passed over.
  std::size_t number_of_lines = 0, number_of_points = 0;

  std::size_t size() const { return first_corner.size() - 1; }
  std::size_t size(std::size_t f) const { return first_corner[f + 1] - first_corner[f]; }
  const Soup_index* begin(std::size_t f) const { return corners.data() + first_corner[f]; }
  const Soup_index* end(std::size_t f) const { return corners.data() + first_corner[f + 1]; }

  void add_corner(long long v)
  {
    if(v < 0 || v >= static_cast<long long>(no_index))
    {
      if(impossible_corner == static_cast<std::size_t>(-1))
      {
        impossible_corner = corners.size();
        impossible_index = v;
      }
      corners.push_back(no_index);
    }
    else
      corners.push_back(static_cast<Soup_index>(v));
  }

  void set_single_precision() { rounding_unit = static_cast<double>(std::numeric_limits<float>::epsilon()); }

  void end_polygon() { first_corner.push_back(static_cast<Soup_index>(corners.size())); }

  void add_triangle(Soup_index a, Soup_index b, Soup_index c)
  {
    corners.insert(corners.end(), { a, b, c });
    end_polygon();
  }
};

// A number with the word for what is counted.
inline std::string count_of(std::size_t n, const std::string& singular, const std::string& plural)
{
  return std::to_string(n) + " " + (n == 1 ? singular : plural);
}

// What is wrong with a face that names vertex v of nv.
inline std::string names_missing_vertex(long long v, std::size_t nv)
{
  return " names vertex " + std::to_string(v) + ", but there are only " + count_of(nv, "vertex", "vertices") +
         " (numbers count from 0)";
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_POLYGON_SOUP_H
