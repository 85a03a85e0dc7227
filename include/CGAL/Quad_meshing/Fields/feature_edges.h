// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_H
#define CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_H

#include <CGAL/Quad_meshing/Fields/internal/Crease_graph.h>
#include <CGAL/Quad_meshing/Fields/internal/merge_narrow_patches.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingFieldsRef

\brief The answer of `detect_feature_edges()`.
*/
struct Feature_edges_result
{
  /// The number of edges marked.
  std::size_t number_of_edges = 0;
  /// Their total length.
  double length = 0;
  /// The number of edges with a sharp angle that were not marked.
  std::size_t number_of_dropped_edges = 0;
  /// The total length of those.
  double dropped_length = 0;
  /// The number of pieces that were dropped: whole components of the graph of sharp edges, dangling branches, and sides of narrow patches.
  std::size_t number_of_dropped_pieces = 0;
};

/*!
\ingroup PkgQuadMeshingFieldsRef

\brief marks the sharp edges of a triangle mesh that are worth a chain of quad edges.

An edge is sharp if the normals of its two faces differ by at least `angle_in_degrees`. On scanned surfaces this
finds hundreds of short creases that are noise, and each of them would force the quads around it. With `l` for the target
edge length, a patch of the surface between sharp edges that is narrower than `l / 4` (twice its area over its perimeter) is joined to the
neighbor that it bends least to: of the two creases along a sliver one is left. Then the following pieces of the
graph of sharp edges are dropped, repeatedly:
- branches that end freely and are shorter than `1.5 l`;
- components with a free end that are shorter than `25 l`, components without one (closed curves) that are shorter than `5 l`;
- components that zigzag: the mean ratio of chord to arc over pieces of arc length `2 l` is below 0.85;
- components whose chains between two nodes (vertices with other than two sharp edges) have a mean length below `1.5 l`: quads of
  that size cannot follow them.

Border edges are not marked; a crease that ends on the border does not end freely.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsFeatureMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
        as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param angle_in_degrees the least angle between the normals at a sharp edge; 180 or more marks nothing
\param target_edge_length the length of a quad edge, in the unit of the points; with 0 nothing is dropped
\param is_feature receives a value for every edge
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `geom_traits`

\return the counts of what was marked and what was dropped
*/
template <typename TriangleMesh, typename EdgeIsFeatureMap,
          typename NamedParameters = parameters::Default_named_parameters>
Feature_edges_result detect_feature_edges(const TriangleMesh& tm, double angle_in_degrees,
                                          double target_edge_length, EdgeIsFeatureMap is_feature,
                                          const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename GetGeomTraits<TriangleMesh, NamedParameters>::type Geom_traits;

  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                              get_const_property_map(vertex_point, tm));
  Feature_edges_result result;
  for(edge_descriptor e : edges(tm))
    put(is_feature, e, false);
  if(angle_in_degrees >= 180)
    return result;

  typedef CGAL::dynamic_edge_property_t<bool> Edge_bool_tag;
  auto is_sharp = get(Edge_bool_tag(), tm);
  for(edge_descriptor e : edges(tm))
    put(is_sharp, e, false);
  const Geom_traits gt = choose_parameter<Geom_traits>(get_parameter(np, internal_np::geom_traits));
  // PMP marks border edges too and works on a mutable mesh only to find the property map types.
  Polygon_mesh_processing::detect_sharp_edges(const_cast<TriangleMesh&>(tm), angle_in_degrees, is_sharp,
                                              parameters::vertex_point_map(vpm).geom_traits(gt));

  // Half a quad of a grid of twice the density: nothing can be followed on both sides there.
  const double least_width = target_edge_length / 4;
  std::vector<edge_descriptor> sharp_edges;
  for(edge_descriptor e : edges(tm))
    if(is_border(e, tm))
      put(is_sharp, e, false);
    else if(get(is_sharp, e))
      sharp_edges.push_back(e);
  result.number_of_dropped_pieces = internal::merge_narrow_patches(tm, vpm, least_width, is_sharp);

  auto vim = internal::vertex_numbers(tm, np);
  internal::Crease_graph creases(vertices(tm).size());
  for(vertex_descriptor v : vertices(tm))
  {
    const auto& p = get(vpm, v);
    creases.points[get(vim, v)] = internal::Crease_graph::Point_3(to_double(p.x()), to_double(p.y()), to_double(p.z()));
  }
  for(edge_descriptor e : edges(tm))
  {
    const std::size_t a = get(vim, source(e, tm)), b = get(vim, target(e, tm));
    if(is_border(e, tm))
      creases.is_held[a] = creases.is_held[b] = true;
    else if(get(is_sharp, e))
      creases.add_edge(static_cast<int>(a), static_cast<int>(b));
  }
  result.number_of_dropped_pieces += creases.drop_noise(target_edge_length);
  int i = 0; // in the graph
  for(edge_descriptor e : sharp_edges)
  {
    const double length = creases.distance(static_cast<int>(get(vim, source(e, tm))), static_cast<int>(get(vim, target(e, tm))));
    if(get(is_sharp, e) && creases.is_kept[i++])
    {
      put(is_feature, e, true);
      ++result.number_of_edges;
      result.length += length;
    }
    else
    {
      ++result.number_of_dropped_edges;
      result.dropped_length += length;
    }
  }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_H
