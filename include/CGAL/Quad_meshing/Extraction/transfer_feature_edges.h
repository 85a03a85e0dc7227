// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_TRANSFER_FEATURE_EDGES_H
#define CGAL_QUAD_MESHING_EXTRACTION_TRANSFER_FEATURE_EDGES_H

#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingExtractionRef
 *
 * \brief marks the edges of an extracted quad mesh that run along feature edges of the triangle mesh.
 *
 * In an integer-grid map the feature edges lie on grid lines, so they pass through quad vertices, and two of these that
 * follow each other on a chain of feature edges are joined by a quad edge.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `EdgeListGraph`
 * \tparam EdgeIsFeatureMap a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
 *         as key type and `bool` as value type
 * \tparam QuadMesh a model of `EdgeListGraph` and `VertexListGraph`
 * \tparam FaceLocationMap a model of `ReadablePropertyMap` with `boost::graph_traits<QuadMesh>::%vertex_descriptor` as
 *         key type and `Polygon_mesh_processing::Face_location<TriangleMesh, double>` as value type
 * \tparam QuadEdgeIsFeatureMap a model of `WritablePropertyMap` with `boost::graph_traits<QuadMesh>::%edge_descriptor`
 *         as key type and `bool` as value type
 *
 * \param tm the triangle mesh
 * \param is_feature its feature edges
 * \param qm the quad mesh
 * \param location where each vertex of `qm` lies on `tm`, as `extract_quad_mesh()` writes it with the named parameter
 *        `face_location_map`: weights that are zero exactly tell vertices and edges
 * \param quad_edge_is_feature gets a value for every edge of `qm`
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_index_map`, of `tm`
 *
 * \return the number of edges that are marked
 *
 * \sa `extract_quad_mesh()`
 */
template <typename TriangleMesh, typename EdgeIsFeatureMap, typename QuadMesh, typename FaceLocationMap,
          typename QuadEdgeIsFeatureMap, typename NamedParameters = parameters::Default_named_parameters>
std::size_t transfer_feature_edges(const TriangleMesh& tm, EdgeIsFeatureMap is_feature, const QuadMesh& qm,
                                   FaceLocationMap location, QuadEdgeIsFeatureMap quad_edge_is_feature,
                                   const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<QuadMesh>::vertex_descriptor quad_vertex_descriptor;

  const auto vim = internal::vertex_numbers(tm, np);

  // Stops on the feature chains: quad vertices from 0, then triangle vertices that are no quad vertex.
  std::vector<quad_vertex_descriptor> quad_vertices(vertices(qm).begin(), vertices(qm).end());
  const int first_vertex = static_cast<int>(quad_vertices.size());
  std::size_t number_of_vertices = 0;
  for(auto v : vertices(tm))
    number_of_vertices = (std::max)(number_of_vertices, std::size_t(get(vim, v)) + 1);
  std::vector<int> stop_of_vertex(number_of_vertices);
  for(std::size_t i = 0; i < stop_of_vertex.size(); ++i)
    stop_of_vertex[i] = first_vertex + static_cast<int>(i);
  auto eim = get(CGAL::dynamic_edge_property_t<int>(), tm);
  int number_of_edges = 0;
  for(auto e : edges(tm))
    put(eim, e, number_of_edges++);
  std::vector<std::vector<std::pair<double, int>>> stops_of_edge(number_of_edges); // from the source of halfedge(e)

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

  std::vector<std::vector<int>> neighbours(first_vertex + stop_of_vertex.size());
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

  auto is_marked = get(CGAL::dynamic_edge_property_t<bool>(), qm);
  for(auto e : edges(qm))
  {
    put(is_marked, e, false);
    put(quad_edge_is_feature, e, false);
  }
  std::size_t number_of_marked_edges = 0;
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
      if(!found.second || get(is_marked, edge(found.first, qm)))
        continue;
      put(is_marked, edge(found.first, qm), true);
      put(quad_edge_is_feature, edge(found.first, qm), true);
      ++number_of_marked_edges;
    }
  return number_of_marked_edges;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_TRANSFER_FEATURE_EDGES_H
