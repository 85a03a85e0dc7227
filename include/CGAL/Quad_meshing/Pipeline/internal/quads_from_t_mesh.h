// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUADS_FROM_T_MESH_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUADS_FROM_T_MESH_H

#include <CGAL/Quad_meshing/Layout/quads_of_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/quantize_t_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>

#include <CGAL/boost/graph/helpers.h>

#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The quads of a T-mesh with integer lengths, null if there are none.
inline std::shared_ptr<Quadrangulation_quads> quads_from_t_mesh(const T_mesh& t)
{
  typedef Quadrangulation_mesh Mesh;

  std::vector<int> lengths;
  if(!quantize_t_mesh(t, lengths).is_valid)
    return nullptr;
  const T_mesh_quads made = quads_of_t_mesh(t, lengths);
  auto quads = std::make_shared<Quadrangulation_quads>();
  Mesh& mesh = quads->mesh;
  std::vector<Mesh::Vertex_index> vertex;
  for(const T_mesh::Location& l : made.vertices)
  {
    const std::array<double, 3> p = t.position(l);
    vertex.push_back(mesh.add_vertex(Quadrangulation_kernel::Point_3(p[0], p[1], p[2])));
    quads->location[vertex.back()] =
      Quadrangulation_quads::Location(Mesh::Face_index(static_cast<Mesh::size_type>(l.first)), l.second);
  }
  for(const auto& q : made.quads)
    if(mesh.add_face(vertex[q[0]], vertex[q[1]], vertex[q[2]], vertex[q[3]]) == Mesh::null_face())
      return nullptr;
  for(const auto& e : made.aligned_edges)
  {
    const Mesh::Halfedge_index h = mesh.halfedge(vertex[e[0]], vertex[e[1]]);
    if(h == Mesh::null_halfedge())
      return nullptr;
    quads->is_feature[mesh.edge(h)] = !mesh.is_border(mesh.edge(h));
  }
  return quads;
}

inline std::size_t number_of_irregular_vertices(const Quadrangulation_mesh& mesh)
{
  std::size_t n = 0;
  for(Quadrangulation_mesh::Vertex_index v : mesh.vertices())
    n += mesh.degree(v) != (mesh.is_border(v) ? 3u : 4u);
  return n;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUADS_FROM_T_MESH_H
