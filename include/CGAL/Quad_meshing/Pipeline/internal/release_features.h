// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RELEASE_FEATURES_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RELEASE_FEATURES_H

#include <CGAL/number_utils.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Unmarks the feature edges with an end within a distance of some faces, measured along edges. Returns their length.
template <typename TriangleMesh, typename VertexPointMap, typename FaceRange, typename EdgeIsFeatureMap>
double release_features(const TriangleMesh& tm, VertexPointMap vpm, const FaceRange& faces_without_room, double radius,
                        EdgeIsFeatureMap is_feature)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef std::pair<double, vertex_descriptor> Entry;

  auto distance = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  for(vertex_descriptor v : vertices(tm))
    put(distance, v, (std::numeric_limits<double>::max)());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > front;
  auto reach = [&](vertex_descriptor v, double d)
  {
    if(d <= radius && d < get(distance, v))
    {
      put(distance, v, d);
      front.push(Entry(d, v));
    }
  };
  auto edge_length = [&](auto h)
  {
    return CGAL::approximate_sqrt(to_double((get(vpm, target(h, tm)) - get(vpm, source(h, tm))).squared_length()));
  };
  for(auto f : faces_without_room)
    for(vertex_descriptor v : vertices_around_face(halfedge(f, tm), tm))
      reach(v, 0);
  while(!front.empty())
  {
    const Entry top = front.top();
    front.pop();
    if(top.first > get(distance, top.second))
      continue;
    for(auto h : halfedges_around_target(top.second, tm))
      reach(source(h, tm), top.first + edge_length(h));
  }
  double released = 0;
  for(auto e : edges(tm))
    if(get(is_feature, e) && (get(distance, source(e, tm)) <= radius || get(distance, target(e, tm)) <= radius))
    {
      put(is_feature, e, false);
      released += edge_length(halfedge(e, tm));
    }
  return released;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RELEASE_FEATURES_H
