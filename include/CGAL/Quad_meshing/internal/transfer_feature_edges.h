// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_TRANSFER_FEATURE_EDGES_H
#define CGAL_QUAD_MESHING_INTERNAL_TRANSFER_FEATURE_EDGES_H

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Marks the edges of an extracted quad mesh that run along feature edges of the triangle mesh.
//
// The feature edges lie on grid lines, so they pass through quad vertices, and two that follow each other on a chain of
// feature edges are joined by a quad edge. `location` gives for each quad vertex its face and weights on the triangle mesh;
// exact zeros among the weights tell vertices and edges. `vim` and `eim` number vertices and edges of the triangle mesh.
template <typename TriangleMesh, typename EdgeIsFeatureMap, typename VertexIndexMap, typename EdgeIndexMap,
          typename QuadMesh, typename LocationMap, typename QuadEdgeIsFeatureMap>
void transfer_feature_edges(const TriangleMesh& tm, EdgeIsFeatureMap is_feature, VertexIndexMap vim, EdgeIndexMap eim,
                            const QuadMesh& qm, LocationMap location, QuadEdgeIsFeatureMap quad_edge_is_feature)
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<QuadMesh>::vertex_descriptor quad_vertex_descriptor;

  // Stops on the feature chains: quad vertices from 0, then triangle vertices that are no quad vertex.
  std::vector<quad_vertex_descriptor> quad_vertices(vertices(qm).begin(), vertices(qm).end());
  const int first_vertex = static_cast<int>(quad_vertices.size());
  std::vector<int> stop_of_vertex(vertices(tm).size());
  for(std::size_t i = 0; i < stop_of_vertex.size(); ++i)
    stop_of_vertex[i] = first_vertex + static_cast<int>(i);
  std::vector<std::vector<std::pair<double, int> > > stops_of_edge(edges(tm).size()); // from the source of halfedge(e)

  for(int q = 0; q < first_vertex; ++q)
  {
    const auto& l = get(location, quad_vertices[q]);
    int zeros = 0, zero = 0, nonzero = 0;
    for(int k = 0; k < 3; ++k)
    {
      if(l.second[k] == 0)
      {
        ++zeros;
        zero = k;
      }
      else
        nonzero = k;
    }
    halfedge_descriptor h = halfedge(l.first, tm); // weight 0 belongs to its source
    if(zeros == 2)
    {
      for(int k = 0; k < nonzero; ++k)
        h = next(h, tm);
      stop_of_vertex[get(vim, source(h, tm))] = q;
    }
    else if(zeros == 1)
    {
      for(int k = 0; k < (zero + 1) % 3; ++k)
        h = next(h, tm);
      const double t = l.second[(zero + 2) % 3]; // of the target of h
      stops_of_edge[get(eim, edge(h, tm))].emplace_back(h == halfedge(edge(h, tm), tm) ? t : 1 - t, q);
    }
  }

  std::vector<std::vector<int> > neighbours(first_vertex + stop_of_vertex.size());
  for(auto e : edges(tm))
  {
    if(!get(is_feature, e))
      continue;
    auto& inner = stops_of_edge[get(eim, e)];
    std::sort(inner.begin(), inner.end());
    int last = stop_of_vertex[get(vim, source(e, tm))];
    auto connect = [&](int stop)
    {
      neighbours[last].push_back(stop);
      neighbours[stop].push_back(last);
      last = stop;
    };
    for(const auto& s : inner)
      connect(s.second);
    connect(stop_of_vertex[get(vim, target(e, tm))]);
  }

  for(int q = 0; q < first_vertex; ++q)
    for(int stop : neighbours[q])
    {
      int previous = q;
      while(stop >= first_vertex && neighbours[stop].size() == 2) // passes a vertex between grid points
      {
        const int ahead = neighbours[stop][0] == previous ? neighbours[stop][1] : neighbours[stop][0];
        previous = stop;
        stop = ahead;
      }
      if(stop >= first_vertex || stop == q)
        continue;
      const auto found = halfedge(quad_vertices[q], quad_vertices[stop], qm);
      if(found.second)
        put(quad_edge_is_feature, edge(found.first, qm), true);
    }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_TRANSFER_FEATURE_EDGES_H
