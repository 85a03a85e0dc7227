// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_READ_POLYGON_SOUP_H
#define CGAL_QUAD_MESHING_IO_READ_POLYGON_SOUP_H

#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>
#include <CGAL/Quad_meshing/IO/internal/read_soup_file.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief reads points and polygons from a file, as the function template of this name does. It is compiled once with
 * the package.
 */
CGAL_QUAD_MESHING_INLINE Mesh_reading_result read_polygon_soup(const std::string& filename,
                                                               std::vector<std::array<double, 3>>& points,
                                                               std::vector<std::vector<std::size_t>>& polygons);

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief reads points and polygons from a file and checks them, without any repair.
 *
 * The format is told by the extension: OFF, OBJ, PLY or STL; \ref Quad_meshing_IO_formats says which variants. After
 * success there is at least one polygon, all indices are valid and all coordinates are finite; nothing is said about
 * the shape of the polygons and how they fit together. The function never throws and never prints on account of the
 * file; if it cannot read it says why, and `points` and `polygons` stay as they were.
 *
 * \tparam PointRange a model of `BackInsertionSequence` whose value type can be constructed from three numbers of type
 * `double`
 * \tparam PolygonRange a model of `BackInsertionSequence` whose value type is a model of
 *                      `BackInsertionSequence` with value type `std::size_t`
 *
 * \param filename the name of the file
 * \param points the points, in place of what was there
 * \param polygons the polygons as indices of points, in place of what was there
 *
 * \return whether and how it ended
 *
 * \sa `read_triangle_mesh()`
 */
template <typename PointRange, typename PolygonRange>
Mesh_reading_result read_polygon_soup(const std::string& filename, PointRange& points, PolygonRange& polygons)
{
  typedef typename PointRange::value_type Point;
  typedef typename PolygonRange::value_type Polygon;

  Mesh_reading_result result;
  internal::Polygon_soup soup;
  if(!internal::read_soup_file(filename, soup, result))
    return result;

  points.clear();
  for(const internal::Polygon_soup::Point& p : soup.points)
    points.push_back(Point{ p[0], p[1], p[2] });
  polygons.clear();
  for(std::size_t f = 0; f < soup.size(); ++f)
    polygons.push_back(Polygon(soup.begin(f), soup.end(f)));
  result.vertices = File_numbers(soup.points.size());
  result.faces = File_numbers(soup.size());
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/IO/internal/read_polygon_soup_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_IO_READ_POLYGON_SOUP_H
