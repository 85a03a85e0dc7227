// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_PREPARE_MESH_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_PREPARE_MESH_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief splits edges of a triangle mesh until it can carry a seamless map with aligned features.

Two conditions hold afterwards. No edge is longer than `longest_edge`: a map that is linear on triangles needs several
of them per quad to bend. And every edge between two feature vertices is a feature edge, every triangle has at most one
of them: otherwise alignment forces two sides of a triangle onto one grid line and its area to zero.

Only edges are split, at their midpoints, and triangles with three feature edges at their
centroids, so the surface stays the same point set, and every new face lies in an old one.

\tparam TriangleMesh a model of `MutableFaceGraph`
\tparam VertexPointMap a model of `ReadWritePropertyMap` with a \cgal point as value type
\tparam EdgeIsFeatureMap a model of `ReadWritePropertyMap` with value type `bool`
\tparam FaceOriginMap a model of `ReadWritePropertyMap` with the faces as keys; any value type

\param tm the triangle mesh
\param vpm the points of the vertices
\param is_feature the feature edges; the halves of a split feature edge become feature edges
\param border_is_feature whether border edges count as feature edges
\param origin a value that new faces inherit from the face that they were split from
\param longest_edge the length above which edges are split, in the unit of the points; 0 or less splits none for its
length

\return the number of edges and faces that were split
*/
template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsFeatureMap, typename FaceOriginMap>
std::size_t split_for_alignment(TriangleMesh& tm, VertexPointMap vpm, EdgeIsFeatureMap is_feature,
                                bool border_is_feature, FaceOriginMap origin, double longest_edge)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  std::size_t number_of_splits = 0;

  auto on_feature = [&](edge_descriptor e) { return get(is_feature, e) || (border_is_feature && is_border(e, tm)); };
  auto squared_length = [&](edge_descriptor e)
  { return to_double(squared_distance(get(vpm, source(e, tm)), get(vpm, target(e, tm)))); };
  auto split = [&](edge_descriptor e)
  {
    const bool feature = get(is_feature, e);
    const auto middle = midpoint(get(vpm, source(e, tm)), get(vpm, target(e, tm)));
    const halfedge_descriptor h = halfedge(e, tm);
    const halfedge_descriptor first = Euler::split_edge(h, tm); // ends at the new vertex, before h
    put(vpm, target(first, tm), middle);
    put(is_feature, edge(first, tm), feature);
    put(is_feature, edge(h, tm), feature);
    for(halfedge_descriptor g : { first, opposite(h, tm) }) // both end at the new vertex
      if(!is_border(g, tm))
      {
        const face_descriptor f = face(g, tm);
        const halfedge_descriptor d = Euler::split_face(g, next(next(g, tm), tm), tm);
        put(is_feature, edge(d, tm), false);
        const auto value = get(origin, f);
        put(origin, face(d, tm), value);
        put(origin, face(opposite(d, tm), tm), value);
      }
    ++number_of_splits;
    return target(first, tm);
  };

  if(longest_edge > 0)
  {
    typedef std::pair<double, edge_descriptor> Entry;
    auto shorter = [](const Entry& a, const Entry& b)
    { return a.first < b.first || (a.first == b.first && b.second < a.second); };
    std::priority_queue<Entry, std::vector<Entry>, decltype(shorter)> queue(shorter);
    const double limit = longest_edge * longest_edge;
    for(edge_descriptor e : edges(tm))
      if(squared_length(e) > limit)
        queue.push(Entry(squared_length(e), e));
    while(!queue.empty())
    {
      const Entry top = queue.top();
      queue.pop();
      if(squared_length(top.second) != top.first)
        continue; // it was split since
      const vertex_descriptor v = split(top.second);
      for(halfedge_descriptor h : halfedges_around_target(v, tm))
        if(squared_length(edge(h, tm)) > limit)
          queue.push(Entry(squared_length(edge(h, tm)), edge(h, tm)));
    }
  }

  // triangles with three feature edges
  std::vector<face_descriptor> enclosed;
  for(face_descriptor f : faces(tm))
  {
    int n = 0;
    for(halfedge_descriptor h : halfedges_around_face(halfedge(f, tm), tm))
      n += on_feature(edge(h, tm));
    if(n == 3)
      enclosed.push_back(f);
  }
  for(face_descriptor f : enclosed)
  {
    halfedge_descriptor h = halfedge(f, tm);
    const auto c = centroid(get(vpm, source(h, tm)), get(vpm, target(h, tm)), get(vpm, target(next(h, tm), tm)));
    const auto value = get(origin, f);
    h = Euler::add_center_vertex(h, tm);
    put(vpm, target(h, tm), c);
    for(halfedge_descriptor g : halfedges_around_target(h, tm))
    {
      put(is_feature, edge(g, tm), false);
      put(origin, face(g, tm), value);
    }
    ++number_of_splits;
  }

  // edges between feature vertices
  auto vertex_on_feature = get(CGAL::dynamic_vertex_property_t<bool>(), tm);
  for(vertex_descriptor v : vertices(tm))
    put(vertex_on_feature, v, false);
  for(edge_descriptor e : edges(tm))
    if(on_feature(e))
    {
      put(vertex_on_feature, source(e, tm), true);
      put(vertex_on_feature, target(e, tm), true);
    }
  std::vector<edge_descriptor> bridges;
  for(edge_descriptor e : edges(tm))
    if(!on_feature(e) && get(vertex_on_feature, source(e, tm)) && get(vertex_on_feature, target(e, tm)))
      bridges.push_back(e);
  for(edge_descriptor e : bridges)
    split(e);
  return number_of_splits;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_PREPARE_MESH_H
