// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_H
#define CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_H

#include <CGAL/Quad_meshing/Fields/Feature_edges_result.h>
#include <CGAL/Quad_meshing/Fields/internal/find_feature_edges.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingFieldsRef

\brief marks the sharp edges of a triangle mesh that are worth a chain of quad edges.

An edge is sharp if the normals of its two faces differ by at least `angle_in_degrees`. On scanned surfaces this
finds hundreds of short creases that are noise, and each of them would force the quads around it. With `l` for the
target edge length, a patch between sharp edges that is narrower than `l / 4` (twice its area over its perimeter) is
joined to the neighbor that it bends least to, so that one crease is left, unless it is the wall of a thin part. In a
band of triangles that are lower than `l / 16` and four times as long, edges that turn the surface by a quarter of the
angle are sharp if the band as a whole turns it by the angle: so a chamfer of several strips is one crease. Where two
sharp sides of a triangle lead a crease to and fro, its third side replaces them if the crease turns less along
it. Two creases that end at one short blunt edge are joined by it. The following pieces of the graph are dropped:
- branches that end freely and are shorter than `1.5 l`;
- components with a free end that are shorter than `25 l`, or than `3 l` if they are nearly straight (the ratio of
  chord to arc below is at least 0.97), and components without a free end that are shorter than `5 l`;
- components that zigzag: the mean ratio of chord to arc over pieces of arc length `2 l` is below 0.85, and the
  chains turn by more than 20 degrees from edge to edge on average;
- components whose chains between two nodes (vertices with other than two sharp edges) have a mean length below `1.5 l`:
  quads of that size cannot follow them.

A closed curve of at least `1.5 l` that turns little more than once around, as the rims of holes and pins do, is always
kept.

Border edges are not marked; a crease that ends on the border does not end freely.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsFeatureMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
        as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param angle_in_degrees the least angle between the normals at a sharp edge; 180 or more marks nothing
\param target_edge_length the length of a quad edge, in the unit of the points; with 0 nothing is dropped or replaced
\param is_feature receives a value for every edge
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_index_map`

\return the counts of what was marked and what was dropped

\pre `is_triangle_mesh(tm)`
*/
template <typename TriangleMesh, typename EdgeIsFeatureMap,
          typename NamedParameters = parameters::Default_named_parameters>
Feature_edges_result detect_feature_edges(const TriangleMesh& tm, double angle_in_degrees, double target_edge_length,
                                          EdgeIsFeatureMap is_feature,
                                          const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition(is_triangle_mesh(tm));

  const internal::Indexed_triangle_mesh mesh = internal::make_indexed_triangle_mesh(tm, np);
  std::vector<char> is_feature_edge;
  const Feature_edges_result result =
    internal::find_feature_edges(mesh, angle_in_degrees, target_edge_length, is_feature_edge);
  for(auto e : edges(tm))
    put(is_feature, e, false);
  internal::for_each_edge_of_faces(tm,
                                   [&](auto e, int i)
                                   {
                                     if(is_feature_edge[i])
                                       put(is_feature, e, true);
                                   });
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_H
