// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_SCENE_LAYERS_H
#define CGAL_QUAD_MESHING_IO_SCENE_LAYERS_H

#include <CGAL/Quad_meshing/IO/Scene.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/size.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/// \ingroup PkgQuadMeshingIORef
/// \brief The number of triangles up to which pages show a mesh as it is.
constexpr std::size_t most_triangles_of_page = 100000;

namespace internal {

template <typename Point>
std::array<double, 3> coordinates(const Point& p)
{
  return { { to_double(p.x()), to_double(p.y()), to_double(p.z()) } };
}

inline Scene_layer empty_layer(const std::string& name, const std::string& group, Scene_layer_kind kind)
{
  Scene_layer layer;
  layer.name = name;
  layer.group = group;
  layer.kind = kind;
  return layer;
}

// Collapses edges of the triangles of a layer until so many are left; does nothing if they are no manifold. Numbers
// and grid are given up.
CGAL_QUAD_MESHING_INLINE void simplify_layer(Scene_layer& layer, std::size_t most_triangles);

} // namespace internal

/*!
\ingroup PkgQuadMeshingIORef

\brief makes a layer of the faces of a mesh, in the order of `faces(mesh)`.

\tparam FaceGraph a model of `FaceListGraph` whose vertices have an internal point map

\param mesh the mesh
\param name the name of the layer
\param group the heading above it
*/
template <typename FaceGraph>
Scene_layer make_faces_layer(const FaceGraph& mesh, const std::string& name, const std::string& group)
{
  Scene_layer layer = internal::empty_layer(name, group, Scene_layer_kind::FACES);
  std::unordered_map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, std::size_t> number;
  const auto vpm = get(vertex_point, mesh);
  for(auto v : vertices(mesh))
    number.emplace(v, layer.add_point(internal::coordinates(get(vpm, v))));
  std::vector<std::size_t> corners;
  for(auto f : faces(mesh))
  {
    corners.clear();
    for(auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      corners.push_back(number[target(h, mesh)]);
    layer.add_element(corners);
  }
  return layer;
}

/*!
\ingroup PkgQuadMeshingIORef

\brief makes a layer of polygons that may be no mesh; those of fewer than three corners are left away.

\tparam PointRange a range of 3D points
\tparam PolygonRange a range of ranges of numbers of points

\param points the points
\param polygons the polygons, as numbers of points
\param name the name of the layer
\param group the heading above it
*/
template <typename PointRange, typename PolygonRange>
Scene_layer make_polygons_layer(const PointRange& points, const PolygonRange& polygons, const std::string& name,
                                const std::string& group)
{
  Scene_layer layer = internal::empty_layer(name, group, Scene_layer_kind::FACES);
  for(const auto& p : points)
    layer.add_point(internal::coordinates(p));
  for(const auto& polygon : polygons)
    if(boost::size(polygon) >= 3)
      layer.add_element(polygon);
  return layer;
}

/*!
\ingroup PkgQuadMeshingIORef

\brief makes a layer of the faces of a triangle mesh; of one with more than `most_triangles_of_page`, edges are
collapsed, which a remark of the scene says.
*/
template <typename TriangleMesh>
Scene_layer make_display_layer(const TriangleMesh& tm, const std::string& name, const std::string& group, Scene& scene)
{
  Scene_layer layer = make_faces_layer(tm, name, group);
  const std::size_t number_of_triangles = layer.size();
  if(number_of_triangles > most_triangles_of_page)
  {
    internal::simplify_layer(layer, most_triangles_of_page);
    scene.remarks.push_back("'" + name + "' has " + std::to_string(number_of_triangles) + " triangles; " +
                            std::to_string(layer.size()) + " are shown, after collapses of edges.");
  }
  layer.has_sides = layer.size() <= most_triangles_of_page / 4; // more lines would hide the faces
  return layer;
}

/*!
\ingroup PkgQuadMeshingIORef

\brief makes a layer of some edges of a mesh.

\tparam FaceGraph a model of `HalfedgeListGraph` whose vertices have an internal point map
\tparam EdgePredicate a function object that takes an edge

\param mesh the mesh
\param is_shown whether an edge belongs to the layer
\param name the name of the layer
\param group the heading above it
*/
template <typename FaceGraph, typename EdgePredicate>
Scene_layer make_edges_layer(const FaceGraph& mesh, EdgePredicate is_shown, const std::string& name,
                             const std::string& group)
{
  Scene_layer layer = internal::empty_layer(name, group, Scene_layer_kind::LINES);
  const auto vpm = get(vertex_point, mesh);
  for(auto e : edges(mesh))
    if(is_shown(e))
    {
      const std::size_t p = layer.add_point(internal::coordinates(get(vpm, source(e, mesh))));
      const std::size_t q = layer.add_point(internal::coordinates(get(vpm, target(e, mesh))));
      layer.add_element(std::array<std::size_t, 2>{ { p, q } });
    }
  return layer;
}

/*!
\ingroup PkgQuadMeshingIORef

\brief makes a layer of polylines; those of fewer than two points are left away.

\tparam PolylineRange a range of ranges of 3D points

\param polylines the polylines
\param name the name of the layer
\param group the heading above it
*/
template <typename PolylineRange>
Scene_layer make_polylines_layer(const PolylineRange& polylines, const std::string& name, const std::string& group)
{
  Scene_layer layer = internal::empty_layer(name, group, Scene_layer_kind::LINES);
  std::vector<std::size_t> corners;
  for(const auto& polyline : polylines)
  {
    if(boost::size(polyline) < 2)
      continue;
    corners.clear();
    for(const auto& p : polyline)
      corners.push_back(layer.add_point(internal::coordinates(p)));
    layer.add_element(corners);
  }
  return layer;
}

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/IO/internal/simplify_layer_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_IO_SCENE_LAYERS_H
