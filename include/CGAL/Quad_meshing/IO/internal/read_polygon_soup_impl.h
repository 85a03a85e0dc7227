// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_POLYGON_SOUP_IMPL_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_POLYGON_SOUP_IMPL_H

#include <CGAL/Quad_meshing/IO/internal/read_soup_file.h>
#include <CGAL/Quad_meshing/IO/read_polygon_soup.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

CGAL_QUAD_MESHING_INLINE Mesh_reading_result read_polygon_soup(const std::string& filename,
                                                               std::vector<std::array<double, 3>>& points,
                                                               std::vector<std::vector<std::size_t>>& polygons)
{
  Mesh_reading_result result;
  internal::Polygon_soup soup;
  if(!internal::read_soup_file(filename, soup, result))
    return result;
  points.swap(soup.points);
  polygons.clear();
  polygons.reserve(soup.size());
  for(std::size_t f = 0; f < soup.size(); ++f)
    polygons.emplace_back(soup.begin(f), soup.end(f));
  result.vertices = File_numbers(points.size());
  result.faces = File_numbers(polygons.size());
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_READ_POLYGON_SOUP_IMPL_H
