// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_READ_TRIANGLE_MESH_H
#define CGAL_QUAD_MESHING_IO_READ_TRIANGLE_MESH_H

#include <CGAL/Quad_meshing/IO/internal/Soup_to_surface.h>
#include <CGAL/Quad_meshing/IO/internal/clean_soup.h>
#include <CGAL/Quad_meshing/IO/internal/flatten_degenerate_faces.h>
#include <CGAL/Quad_meshing/IO/read_polygon_soup.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

// Triangulates all faces. Polygons that the triangulation of CGAL gives up become fans.
template <typename FaceGraph, typename VertexPointMap>
void triangulate(FaceGraph& g, VertexPointMap vpm)
{
  Polygon_mesh_processing::triangulate_faces(g, parameters::vertex_point_map(vpm));

  typedef typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge_descriptor;
  std::vector<halfedge_descriptor> fans;
  for(auto f : faces(g))
    if(!is_triangle(halfedge(f, g), g))
      fans.push_back(halfedge(f, g));
  for(halfedge_descriptor h : fans)
    while(!is_triangle(h, g))
      h = Euler::split_face(h, next(next(h, g), g), g);
}

// Whether a polygon has an area that numbers of type double can tell from none.
inline bool has_area(const Polygon_soup& soup, const Polygon_soup::Polygon& polygon)
{
  const Polygon_soup::Point_3& p = soup.points[polygon[0]];
  for(std::size_t k = 2; k < polygon.size(); ++k)
    if(cross_product(soup.points[polygon[k - 1]] - p, soup.points[polygon[k]] - p).squared_length() > 0)
      return true;
  return false;
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief reads a triangle mesh from a file, checks it and repairs what can be repaired without
 * changing the surface as a set of points.
 *
 * The format is told by the extension: OFF, OBJ, PLY or STL. The function never throws and never
 * prints on account of the file; if it cannot give a mesh it says why, and `g` stays as it was.
 *
 * - Polygons are triangulated.
 * - Vertices at the same place are merged where that closes gaps between faces and does not join more
 *   than two of them at an edge.
 * - Vertices without a face, faces with fewer than three distinct vertices and faces that are there
 *   twice are dropped, and both where they are the two sides of a fin that stands off a surface.
 * - Faces are oriented consistently, with the orientation of the majority of each component. A surface
 *   with one side only is refused: cutting it open would be the user's choice.
 * - At an edge with more than two faces these are separated into sheets, solids that touch there along
 *   their material, others by straightness; a sheet without continuation gets a border there. A vertex
 *   at which several sheets touch is split.
 * - Triangles of zero area are flipped away.
 *
 * Everything of that kind is listed in the result. If the file holds a proper triangle mesh, vertices
 * and faces of `g` are numbered in the order of the file.
 *
 * \tparam FaceGraph a model of `MutableFaceGraph`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param filename the name of the file
 * \param g the mesh, whose former content is replaced
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `g`}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<FaceGraph>::%vertex_descriptor`
 *                    as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, g)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return whether and how it ended, and what was repaired
 */
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Mesh_reading_result
read_triangle_mesh(const std::string& filename,
                   FaceGraph& g,
                   const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef typename GetVertexPointMap<FaceGraph, NamedParameters>::type VertexPointMap;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;

  Mesh_reading_result result;
  auto refuse = [&](Mesh_reading_status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    return result;
  };

  internal::Polygon_soup soup;
  if(!internal::read_soup(filename, soup, result))
    return result;

  internal::clean_soup(soup, result.repairs);
  if(soup.polygons.empty())
    return refuse(Mesh_reading_status::NO_FACES, "no face has three distinct vertices");
  if(std::none_of(soup.polygons.begin(), soup.polygons.end(),
                  [&](const internal::Polygon_soup::Polygon& polygon) { return internal::has_area(soup, polygon); }))
    return refuse(Mesh_reading_status::NO_FACES, "no face has an area");

  const auto polygons = std::count_if(soup.polygons.begin(), soup.polygons.end(),
                                      [](const internal::Polygon_soup::Polygon& p) { return p.size() > 3; });
  if(polygons > 0)
    result.repairs.push_back(internal::count_of(static_cast<std::size_t>(polygons), "polygon", "polygons") + " triangulated");

  internal::Soup_to_surface make_surface(soup);
  if(!make_surface())
    return refuse(Mesh_reading_status::NOT_ORIENTABLE,
                  "the surface is not orientable: a strip of faces comes back to where it began with its other side up, as in a Moebius strip");
  if(make_surface.reversed_polygons > 0)
    result.repairs.push_back(internal::count_of(make_surface.reversed_polygons, "face", "faces") +
                             " reversed to orient the surface consistently");
  if(make_surface.non_manifold_edges > 0)
    result.repairs.push_back(internal::count_of(make_surface.non_manifold_edges, "edge", "edges") +
                             " with more than two faces separated into sheets");
  if(make_surface.split_vertices > 0)
    result.repairs.push_back(internal::count_of(make_surface.split_vertices, "vertex", "vertices") +
                             " at which the surface touches itself split");

  std::vector<Point> points;
  points.reserve(soup.points.size());
  for(const auto& p : soup.points)
    points.push_back(Point(p.x(), p.y(), p.z()));

  clear(g);
  VertexPointMap vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                        get_property_map(vertex_point, g));
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.polygons, g, parameters::default_values(),
                                                        parameters::vertex_point_map(vpm));

  if(!is_triangle_mesh(g))
    internal::triangulate(g, vpm);

  std::size_t flattened = 0;
  result.number_of_degenerate_faces = internal::flatten_degenerate_faces(g, vpm, flattened);
  if(flattened > 0)
    result.repairs.push_back(internal::count_of(flattened, "triangle", "triangles") + " of zero area flipped away");
  if(result.number_of_degenerate_faces > 0)
    result.repairs.push_back(internal::count_of(result.number_of_degenerate_faces, "triangle", "triangles") +
                             " of zero area left");
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_READ_TRIANGLE_MESH_H
