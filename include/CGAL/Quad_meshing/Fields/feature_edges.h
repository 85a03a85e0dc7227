// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_H
#define CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_H

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
  /// The number of pieces that were dropped: whole components of the graph of sharp edges, and dangling branches.
  std::size_t number_of_dropped_pieces = 0;
};

/*!
\ingroup PkgQuadMeshingFieldsRef

\brief marks the sharp edges of a triangle mesh that are worth a chain of quad edges.

An edge is sharp if the normals of its two faces differ by at least `angle_in_degrees`. On scanned surfaces this
finds hundreds of short creases that are noise, and each of them would force the quads around it. So two
kinds of pieces are dropped: components of the graph of sharp edges whose total length is below
`4 * target_edge_length`, and then, repeatedly, branches that end freely and are shorter than `1.5 * target_edge_length`. A closed
loop is no branch. Border edges are not marked; they serve as ends that hold a branch.

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
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename GetGeomTraits<TriangleMesh, NamedParameters>::type Geom_traits;

  const double component_length_factor = 4, branch_length_factor = 1.5;

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

  auto vim = get_initialized_vertex_index_map(tm, np);
  std::vector<std::vector<halfedge_descriptor> > leaving(vertices(tm).size());
  std::vector<bool> on_border(vertices(tm).size(), false);
  auto length = [&](halfedge_descriptor h)
  {
    return CGAL::approximate_sqrt(to_double(squared_distance(get(vpm, source(h, tm)), get(vpm, target(h, tm)))));
  };
  for(edge_descriptor e : edges(tm))
  {
    const halfedge_descriptor h = halfedge(e, tm);
    if(is_border(e, tm))
    {
      put(is_sharp, e, false);
      on_border[get(vim, source(h, tm))] = on_border[get(vim, target(h, tm))] = true;
    }
    else if(get(is_sharp, e))
    {
      leaving[get(vim, source(h, tm))].push_back(h);
      leaving[get(vim, target(h, tm))].push_back(opposite(h, tm));
    }
  }

  auto drop = [&](const std::vector<halfedge_descriptor>& piece)
  {
    ++result.number_of_dropped_pieces;
    for(halfedge_descriptor h : piece)
    {
      put(is_sharp, edge(h, tm), false);
      ++result.number_of_dropped_edges;
      result.dropped_length += length(h);
    }
  };

  // components
  std::vector<bool> seen(vertices(tm).size(), false);
  for(vertex_descriptor s : vertices(tm))
  {
    if(seen[get(vim, s)] || leaving[get(vim, s)].empty())
      continue;
    std::vector<vertex_descriptor> stack(1, s);
    std::vector<halfedge_descriptor> piece;
    double total = 0;
    seen[get(vim, s)] = true;
    while(!stack.empty())
    {
      const vertex_descriptor v = stack.back();
      stack.pop_back();
      for(halfedge_descriptor h : leaving[get(vim, v)])
      {
        if(h == halfedge(edge(h, tm), tm)) // count every edge once
        {
          piece.push_back(h);
          total += length(h);
        }
        if(!seen[get(vim, target(h, tm))])
        {
          seen[get(vim, target(h, tm))] = true;
          stack.push_back(target(h, tm));
        }
      }
    }
    if(total < component_length_factor * target_edge_length)
      drop(piece);
  }

  // dangling branches; dropping one can leave another
  auto degree_of = [&](vertex_descriptor v)
  {
    int d = 0;
    for(halfedge_descriptor h : leaving[get(vim, v)])
      d += get(is_sharp, edge(h, tm));
    return d;
  };
  bool changed = target_edge_length > 0;
  while(changed)
  {
    changed = false;
    for(vertex_descriptor s : vertices(tm))
    {
      if(on_border[get(vim, s)] || degree_of(s) != 1)
        continue;
      std::vector<halfedge_descriptor> piece;
      double total = 0;
      vertex_descriptor v = s;
      do
      {
        for(halfedge_descriptor h : leaving[get(vim, v)])
          if(get(is_sharp, edge(h, tm)) && (piece.empty() || h != opposite(piece.back(), tm)))
          {
            piece.push_back(h);
            total += length(h);
            v = target(h, tm);
            break;
          }
      }
      while(degree_of(v) == 2 && !on_border[get(vim, v)]);
      if(degree_of(v) > 1 && total < branch_length_factor * target_edge_length)
      {
        drop(piece);
        changed = true;
      }
    }
  }

  for(edge_descriptor e : edges(tm))
    if(get(is_sharp, e))
    {
      put(is_feature, e, true);
      ++result.number_of_edges;
      result.length += length(halfedge(e, tm));
    }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_H
