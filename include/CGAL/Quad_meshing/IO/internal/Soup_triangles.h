// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_TRIANGLES_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_TRIANGLES_H

#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Triangles on their way from a file to a surface. Side 3 f + k runs from corner k of triangle f to the next one.
struct Soup_triangles
{
  std::vector<Polygon_soup::Point> points; // of the file, and inserted ones behind them
  std::vector<std::array<Soup_index, 3>> corners;
  std::vector<Soup_index> file_face;  // the polygon of the file that a triangle comes from
  std::vector<Soup_index> other_side; // the polygon that was dropped as its other side; may be empty
  std::vector<Soup_index> place;      // of each point; empty: each has its own

  std::size_t size() const { return corners.size(); }
  std::size_t number_of_sides() const { return 3 * corners.size(); }

  static std::size_t next(std::size_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static std::size_t previous(std::size_t side) { return side % 3 == 0 ? side + 2 : side - 1; }

  Soup_index source(std::size_t side) const { return corners[side / 3][side % 3]; }
  Soup_index target(std::size_t side) const { return source(next(side)); }

  Soup_index place_of(Soup_index v) const { return place.empty() ? v : place[v]; }
  Soup_index source_place(std::size_t side) const { return place_of(source(side)); }
  Soup_index target_place(std::size_t side) const { return place_of(target(side)); }

  const Polygon_soup::Point& point(std::size_t f, std::size_t k) const { return points[corners[f][k]]; }

  void add(const std::array<Soup_index, 3>& triangle, Soup_index face, Soup_index other)
  {
    corners.push_back(triangle);
    file_face.push_back(face);
    if(!other_side.empty() || other != no_index)
    {
      other_side.resize(corners.size() - 1, no_index);
      other_side.push_back(other);
    }
  }

  Soup_index other_side_of(std::size_t f) const { return other_side.empty() ? no_index : other_side[f]; }

  void set_other_side(std::size_t f, Soup_index face)
  {
    other_side.resize(corners.size(), no_index);
    other_side[f] = face;
  }

  // Keeps the triangles for which `keeps` says so, in their order.
  template <typename Keeps>
  void keep_if(Keeps keeps)
  {
    std::size_t n = 0;
    if(!other_side.empty())
      other_side.resize(corners.size(), no_index);
    for(std::size_t f = 0; f < corners.size(); ++f)
    {
      if(!keeps(f))
        continue;
      corners[n] = corners[f];
      file_face[n] = file_face[f];
      if(!other_side.empty())
        other_side[n] = other_side[f];
      ++n;
    }
    corners.resize(n);
    file_face.resize(n);
    if(!other_side.empty())
      other_side.resize(n);
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_TRIANGLES_H
