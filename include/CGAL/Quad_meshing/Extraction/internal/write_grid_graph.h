// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_WRITE_GRID_GRAPH_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_WRITE_GRID_GRAPH_H

#include <CGAL/Quad_meshing/Extraction/internal/Grid_graph.h>

#include <CGAL/boost/graph/properties.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Gives every ray that bounds a face its vertex, and returns the node of each vertex. The rays of
// a node share one vertex if faces connect them, so the faces of a vertex form one fan, open or closed: a
// node at which faces only touch becomes several vertices.
inline std::vector<int> make_vertices(const Grid_graph& g, std::vector<int>& vertex_of_ray)
{
  std::vector<int> node_of_vertex;
  vertex_of_ray.assign(g.number_of_rays(), -1);
  auto left = [&](int r) { return g.face[r] >= 0; };
  auto right = [&](int r) { return g.opposite[r] >= 0 && g.face[g.opposite[r]] >= 0; };

  for(int n = 0; n < g.number_of_nodes(); ++n)
  {
    const int start = g.first[n];
    if(start == Grid_graph::NONE)
      continue;
    // First the open fans, from their clockwise ends; what then remains is one closed fan.
    int r = start;
    bool closed = true;
    do
    {
      if(left(r) && !right(r))
      {
        const int v = static_cast<int>(node_of_vertex.size());
        node_of_vertex.push_back(n);
        int s = r;
        for(; left(s); s = g.ccw[s])
          vertex_of_ray[s] = v;
        vertex_of_ray[s] = v;
      }
      closed &= left(r) && right(r);
      r = g.ccw[r];
    }
    while(r != Grid_graph::NONE && r != start);
    if(!closed)
      continue;
    const int v = static_cast<int>(node_of_vertex.size());
    node_of_vertex.push_back(n);
    do
    {
      vertex_of_ray[r] = v;
      r = g.ccw[r];
    }
    while(r != start);
  }
  return node_of_vertex;
}

// Adds the faces of the graph to a mesh, with the same orientation. `new_vertex(i)` adds vertex i and returns its
// descriptor. Works on the halfedges themselves, so that no connectivity is excluded: two edges may join
// the same vertices, and a face may meet itself.
template <typename QuadMesh, typename NewVertex>
void write_grid_graph(const Grid_graph& g, const std::vector<int>& vertex_of_ray, std::size_t number_of_vertices,
                      QuadMesh& qm, const NewVertex& new_vertex)
{
  typedef boost::graph_traits<QuadMesh> Traits;
  typedef typename Traits::vertex_descriptor vertex_descriptor;
  typedef typename Traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Traits::face_descriptor face_descriptor;

  std::vector<vertex_descriptor> vertex;
  vertex.reserve(number_of_vertices);
  for(std::size_t i = 0; i < number_of_vertices; ++i)
    vertex.push_back(new_vertex(i));

  std::vector<face_descriptor> faces;
  faces.reserve(g.number_of_faces());
  for(int i = 0; i < g.number_of_faces(); ++i)
    faces.push_back(add_face(qm));

  const int n = g.number_of_rays();
  std::vector<halfedge_descriptor> halfedge_of_ray(n);
  for(int r = 0; r < n; ++r)
  {
    const int o = g.opposite[r];
    if(o < r || (g.face[r] < 0 && g.face[o] < 0))
      continue;
    const halfedge_descriptor h = halfedge(add_edge(qm), qm);
    halfedge_of_ray[r] = h;
    halfedge_of_ray[o] = opposite(h, qm);
    set_target(h, vertex[vertex_of_ray[o]], qm);
    set_target(opposite(h, qm), vertex[vertex_of_ray[r]], qm);
  }

  // A border vertex keeps the border halfedge that comes in, as the graphs of CGAL expect it.
  std::vector<char> has_halfedge(number_of_vertices, false);
  for(int r = 0; r < n; ++r)
  {
    const int o = g.opposite[r];
    if(o < 0 || (g.face[r] < 0 && g.face[o] < 0))
      continue;
    const halfedge_descriptor h = halfedge_of_ray[r];
    const vertex_descriptor v = vertex[vertex_of_ray[r]];
    if(g.face[r] >= 0)
    {
      const face_descriptor f = faces[g.face[r]];
      set_face(h, f, qm);
      set_halfedge(f, h, qm);
      set_next(h, halfedge_of_ray[g.next(r)], qm);
      if(g.face[o] >= 0)
      {
        if(!has_halfedge[vertex_of_ray[r]])
          set_halfedge(v, opposite(h, qm), qm);
        has_halfedge[vertex_of_ray[r]] = true;
        continue;
      }
      set_next(opposite(h, qm), halfedge_of_ray[g.next_on_border(o)], qm);
      set_halfedge(v, opposite(h, qm), qm);
      has_halfedge[vertex_of_ray[r]] = true;
    }
    else
      set_face(h, Traits::null_face(), qm);
  }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_WRITE_GRID_GRAPH_H
