// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_READ_POLYGON_SOUP_H
#define CGAL_QUAD_MESHING_IO_READ_POLYGON_SOUP_H

#include <CGAL/Quad_meshing/IO/internal/Soup_file_reader.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/// \ingroup PkgQuadMeshingIORef
/// is how the reading of a mesh ended.
enum class Mesh_reading_status
{
  SUCCESS,             ///< the mesh is there
  CANNOT_OPEN,         ///< the file does not exist or cannot be read
  EMPTY_FILE,          ///< the file has no content
  UNKNOWN_FORMAT,      ///< the extension of the file is not `off`, `obj`, `ply` or `stl`
  MALFORMED_FILE,      ///< the content is not what the format prescribes
  INVALID_INDEX,       ///< a face names a vertex that does not exist
  INVALID_COORDINATE,  ///< a coordinate is not a finite number, or too large to compute with
  NO_FACES,            ///< there is no face, or none with an area
  NOT_ORIENTABLE       ///< the surface has one side only, as a Moebius strip has
};

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief is the result of `read_triangle_mesh()` and of `read_polygon_soup()`.
 */
struct Mesh_reading_result
{
  /// how it ended
  Mesh_reading_status status = Mesh_reading_status::SUCCESS;

  /// the reason in one sentence without the name of the file, empty after success
  std::string message;

  /// what was done to make the content of the file a triangle mesh, one short sentence each
  std::vector<std::string> repairs;

  /// the number of triangles of zero area that could not be removed
  std::size_t number_of_degenerate_faces = 0;

  /// returns whether the mesh was read.
  explicit operator bool() const { return status == Mesh_reading_status::SUCCESS; }
};

namespace internal {

// Larger coordinates make squares of areas overflow.
constexpr double largest_coordinate = 1e70;

// Looks for faces with vertices that are not there and for coordinates that are not numbers.
// Numbers of vertices and faces in messages count from 0 in the order of the file.
inline bool check_soup(const Polygon_soup& soup, Mesh_reading_result& result)
{
  auto refuse = [&](Mesh_reading_status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    return false;
  };

  if(soup.polygons.empty())
    return refuse(Mesh_reading_status::NO_FACES, "there are " + count_of(soup.points.size(), "vertex", "vertices") +
                                                 " but no faces");
  const std::size_t nv = soup.points.size();
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
  {
    for(std::size_t v : soup.polygons[f])
    {
      if(v < nv)
        continue;
      const bool is_negative = v > (std::numeric_limits<std::size_t>::max)() / 2;
      return refuse(Mesh_reading_status::INVALID_INDEX,
                    "face " + std::to_string(f) + " names " +
                    (is_negative ? std::string("a vertex before the first one")
                                 : "vertex " + std::to_string(v)) +
                    ", but there are only " + count_of(nv, "vertex", "vertices") + " (numbers count from 0)");
    }
  }
  for(std::size_t v = 0; v < nv; ++v)
  {
    for(int d = 0; d < 3; ++d)
    {
      const double c = soup.points[v][d];
      if(!std::isfinite(c))
        return refuse(Mesh_reading_status::INVALID_COORDINATE,
                      "vertex " + std::to_string(v) + " has a coordinate that is not a finite number (numbers count from 0)");
      if(std::abs(c) > largest_coordinate)
        return refuse(Mesh_reading_status::INVALID_COORDINATE,
                      "vertex " + std::to_string(v) + " has a coordinate too large to compute with (numbers count from 0)");
    }
  }
  return true;
}

// Reads the file and checks its content. Leaves the reason in `result` if it is of no use.
inline bool read_soup(const std::string& filename, Polygon_soup& soup, Mesh_reading_result& result)
{
  auto refuse = [&](Mesh_reading_status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    return false;
  };

  std::string bytes, error;
  if(!read_bytes(filename, bytes, error))
    return refuse(Mesh_reading_status::CANNOT_OPEN, "cannot be read: " + error);
  const std::string extension = file_extension(filename);
  if(!is_readable_format(extension))
    return refuse(Mesh_reading_status::UNKNOWN_FORMAT, "the format '" + extension + "' is not one of off, obj, ply, stl");
  if(bytes.find_first_not_of(" \t\r\n") == std::string::npos)
    return refuse(Mesh_reading_status::EMPTY_FILE, "the file is empty");
  if(!parse_polygon_soup(extension, bytes, soup, error))
    return refuse(Mesh_reading_status::MALFORMED_FILE, error);
  return check_soup(soup, result);
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief reads points and polygons from a file and checks them, without any repair.
 *
 * The format is told by the extension: OFF, OBJ, PLY or STL. After success there is at least one
 * polygon, all indices are valid and all coordinates are finite; nothing is said about the shape of
 * the polygons and how they fit together. The function never throws and never prints on account of
 * the file; if it cannot read it says why, and `points` and `polygons` stay as they were.
 *
 * \tparam PointRange a model of `BackInsertionSequence` whose value type can be constructed from three numbers of type `double`
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
Mesh_reading_result
read_polygon_soup(const std::string& filename,
                  PointRange& points,
                  PolygonRange& polygons)
{
  typedef typename PointRange::value_type Point;
  typedef typename PolygonRange::value_type Polygon;

  Mesh_reading_result result;
  internal::Polygon_soup soup;
  if(!internal::read_soup(filename, soup, result))
    return result;

  points.clear();
  for(const auto& p : soup.points)
    points.push_back(Point(p.x(), p.y(), p.z()));
  polygons.clear();
  for(const internal::Polygon_soup::Polygon& polygon : soup.polygons)
    polygons.push_back(Polygon(polygon.begin(), polygon.end()));
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_READ_POLYGON_SOUP_H
