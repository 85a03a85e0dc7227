// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_MIRRORED_QUADS_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_MIRRORED_QUADS_H

#include <CGAL/Quad_meshing/Guides/mirror_triangles.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Adds the mirror image of a quad mesh, joined to it along its border in the mirror. Returns null if that is no mesh.
inline std::unique_ptr<Quadrangulation_quads> with_mirror_image(const Quadrangulation_quads& half, const Mirror& mirror,
                                                                double tolerance)
{
  typedef Quadrangulation_mesh Mesh;
  const Mesh& m = half.mesh;
  auto result = std::make_unique<Quadrangulation_quads>();
  std::vector<char> is_in_mirror(m.number_of_vertices(), 0);
  auto is_near = [&](Mesh::Vertex_index v) { return std::abs(mirror.distance(m.point(v))) <= tolerance; };
  for(Mesh::Edge_index e : m.edges())
    if(m.is_border(e) && is_near(m.vertex(e, 0)) && is_near(m.vertex(e, 1)))
      is_in_mirror[m.vertex(e, 0)] = is_in_mirror[m.vertex(e, 1)] = 1;
  std::vector<Mesh::Vertex_index> copy, image;
  for(Mesh::Vertex_index v : m.vertices())
  {
    copy.push_back(result->mesh.add_vertex(is_in_mirror[v] ? mirror.projection(m.point(v)) : m.point(v)));
    image.push_back(is_in_mirror[v] ? copy.back() : result->mesh.add_vertex(mirror.image(m.point(v))));
  }
  for(Mesh::Face_index f : m.faces())
  {
    std::vector<Mesh::Vertex_index> corners, mirrored;
    for(Mesh::Vertex_index v : m.vertices_around_face(m.halfedge(f)))
    {
      corners.push_back(copy[v]);
      mirrored.insert(mirrored.begin(), image[v]);
    }
    if(result->mesh.add_face(corners) == Mesh::null_face() || result->mesh.add_face(mirrored) == Mesh::null_face())
      return nullptr;
  }
  for(Mesh::Edge_index e : m.edges())
  {
    const Mesh::Vertex_index v = m.vertex(e, 0), w = m.vertex(e, 1);
    if(!half.is_feature[e] || (is_in_mirror[v] && is_in_mirror[w] && m.is_border(e)))
      continue;
    result->is_feature[result->mesh.edge(result->mesh.halfedge(copy[v], copy[w]))] = true;
    result->is_feature[result->mesh.edge(result->mesh.halfedge(image[v], image[w]))] = true;
  }
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_MIRRORED_QUADS_H
