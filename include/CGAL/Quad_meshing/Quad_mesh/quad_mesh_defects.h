// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEFECTS_H
#define CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEFECTS_H

#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief counts what keeps points and polygons from being a pure quad mesh, that is an oriented
 * 2-manifold, with or without boundary, all of whose faces are quads.
 */
struct Quad_mesh_defects
{
  std::size_t faces = 0;                    ///< number of faces in all
  std::size_t faces_not_quads = 0;          ///< faces with another number of corners than four
  std::size_t faces_repeating_vertices = 0; ///< faces that use a vertex twice
  std::size_t invalid_indices = 0;          ///< corners that name a vertex that does not exist
  std::size_t invalid_coordinates = 0;      ///< vertices with a coordinate that is not finite
  std::size_t non_manifold_edges = 0;       ///< edges with more than two faces
  std::size_t inconsistent_edges = 0;       ///< edges whose two faces have opposite orientations
  std::size_t non_manifold_vertices = 0;    ///< vertices whose faces are not a single fan
  std::size_t isolated_vertices = 0;        ///< vertices without a face

  /// returns whether there are faces and none of the defects, isolated vertices aside.
  bool is_pure_quad_mesh() const { return faces > 0 && reasons().empty(); }

  /// returns one short sentence for each kind of defect that occurs, isolated vertices aside.
  std::vector<std::string> reasons() const
  {
    std::vector<std::string> list;
    auto say = [&](std::size_t n, const char* one, const char* many)
    {
      if(n > 0)
        list.push_back(std::to_string(n) + (n == 1 ? one : many));
    };
    if(faces == 0)
      list.push_back("there are no faces");
    say(faces_not_quads, " face is not a quad", " faces are not quads");
    say(invalid_indices, " corner names a vertex that does not exist", " corners name vertices that do not exist");
    say(invalid_coordinates, " vertex has a coordinate that is not finite",
        " vertices have coordinates that are not finite");
    say(faces_repeating_vertices, " face uses a vertex twice", " faces use a vertex twice");
    say(non_manifold_edges, " edge has more than two faces", " edges have more than two faces");
    say(inconsistent_edges, " edge lies between faces of opposite orientation",
        " edges lie between faces of opposite orientation");
    say(non_manifold_vertices, " vertex has faces that are not a single fan",
        " vertices have faces that are not a single fan");
    return list;
  }
};

namespace internal {

// Points and polygons in flat arrays.
struct Flat_polygons
{
  std::size_t number_of_points = 0;
  std::size_t invalid_coordinates = 0; // points with a coordinate that is not finite
  std::vector<std::size_t> vertex_of_corner;
  std::vector<std::size_t> first_corner = { 0 }; // per polygon, and the number of corners at the end
};

CGAL_QUAD_MESHING_INLINE Quad_mesh_defects defects_of_polygons(const Flat_polygons& polygons);

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief looks for everything that keeps points and polygons from being a pure quad mesh.
 *
 * Nothing is assumed about the input. If the result is without defects,
 * `CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh()` makes a quad mesh of it.
 *
 * \tparam PointRange a random access range of 3D points
 * \tparam PolygonRange a range of random access ranges of indices into the points
 *
 * \param points the vertices
 * \param polygons the faces
 */
template <typename PointRange, typename PolygonRange>
Quad_mesh_defects find_quad_mesh_defects(const PointRange& points, const PolygonRange& polygons)
{
  internal::Flat_polygons flat;
  flat.number_of_points = points.size();
  for(const auto& p : points)
    if(!is_finite(to_double(p.x())) || !is_finite(to_double(p.y())) || !is_finite(to_double(p.z())))
      ++flat.invalid_coordinates;
  for(const auto& polygon : polygons)
  {
    for(const auto& v : polygon)
      flat.vertex_of_corner.push_back(static_cast<std::size_t>(v));
    flat.first_corner.push_back(flat.vertex_of_corner.size());
  }
  return internal::defects_of_polygons(flat);
}

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Quad_mesh/internal/quad_mesh_defects_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEFECTS_H
