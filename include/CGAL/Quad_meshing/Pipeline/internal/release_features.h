// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RELEASE_FEATURES_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RELEASE_FEATURES_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/internal/Distance_front.h>

#include <CGAL/squared_distance_3.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Unmarks the feature edges with an end within a distance of some faces, measured along edges. Returns their length.
// Edges that are kept stay marked.
template <typename EdgeIsKeptMap, typename EdgeIsFeatureMap>
double release_features(const Quadrangulation_mesh& mesh,
                        const std::vector<Quadrangulation_mesh::Face_index>& faces_without_room, double radius,
                        EdgeIsKeptMap is_kept, EdgeIsFeatureMap is_feature)
{
  typedef Quadrangulation_mesh Mesh;

  auto length = [&](Mesh::Halfedge_index h)
  { return std::sqrt(squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)))); };
  Distance_front front(static_cast<int>(mesh.num_vertices()));
  for(Mesh::Face_index f : faces_without_room)
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      front.reach(static_cast<int>(v), 0);
  int i;
  for(double d; front.pop(i, d);)
    for(Mesh::Halfedge_index h :
        mesh.halfedges_around_target(mesh.halfedge(Mesh::Vertex_index(static_cast<Mesh::size_type>(i)))))
      if(d + length(h) <= radius)
        front.reach(static_cast<int>(mesh.source(h)), d + length(h));
  double released = 0;
  for(Mesh::Edge_index e : mesh.edges())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    if(get(is_feature, e) && !get(is_kept, e) &&
       (front.is_reached(static_cast<int>(mesh.source(h))) || front.is_reached(static_cast<int>(mesh.target(h)))))
    {
      put(is_feature, e, false);
      released += length(h);
    }
  }
  return released;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RELEASE_FEATURES_H
