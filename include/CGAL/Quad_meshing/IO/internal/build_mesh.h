// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_BUILD_MESH_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_BUILD_MESH_H

#include <CGAL/Quad_meshing/IO/internal/Triangle_surface.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Makes a halfedge structure of a surface, in linear time since neighbors are known. Halfedges and the halfedges of
// vertices and faces are those that CGAL::Euler::add_face() gives when it adds one face after the other.
template <typename FaceGraph, typename VertexPointMap>
void build_mesh(const Triangle_surface& surface, FaceGraph& g, VertexPointMap vpm)
{
  typedef boost::graph_traits<FaceGraph> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;

  const std::size_t nv = surface.points.size(), nf = surface.triangles.size(), ns = 3 * nf;
  std::size_t border = 0;
  for(Soup_index s : surface.opposite)
    border += s == no_index;
  reserve(g, static_cast<typename Graph_traits::vertices_size_type>(nv),
          static_cast<typename Graph_traits::edges_size_type>((ns + border) / 2),
          static_cast<typename Graph_traits::faces_size_type>(nf));

  std::vector<vertex_descriptor> vertices(nv);
  for(std::size_t v = 0; v < nv; ++v)
  {
    vertices[v] = add_vertex(g);
    put(vpm, vertices[v], Point(surface.points[v][0], surface.points[v][1], surface.points[v][2]));
  }

  std::vector<halfedge_descriptor> halfedges(ns);
  std::vector<Soup_index> border_side(border > 0 ? nv : 0, no_index); // the one that ends at a vertex
  for(std::size_t f = 0; f < nf; ++f)
  {
    const std::array<Soup_index, 3>& t = surface.triangles[f];
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t s = 3 * f + k, o = surface.opposite[s];
      const vertex_descriptor source = vertices[t[k]], target = vertices[t[(k + 1) % 3]];
      if(o != no_index && o < s)
      {
        halfedges[s] = opposite(halfedges[o], g);
        continue;
      }
      halfedges[s] = halfedge(add_edge(g), g);
      const halfedge_descriptor other = opposite(halfedges[s], g);
      set_target(halfedges[s], target, g);
      set_target(other, source, g);
      if(o != no_index)
        continue;
      set_face(other, Graph_traits::null_face(), g);
      border_side[t[(k + 1) % 3]] = static_cast<Soup_index>(s);
    }
    const face_descriptor face = add_face(g);
    set_halfedge(face, halfedges[3 * f + 2], g);
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t s = 3 * f + k;
      set_face(halfedges[s], face, g);
      set_next(halfedges[s], halfedges[3 * f + (k + 1) % 3], g);
      set_halfedge(vertices[t[(k + 1) % 3]], halfedges[s], g);
    }
  }
  // A vertex at the border gets the halfedge there.
  for(std::size_t s = 0; s < ns && border > 0; ++s)
  {
    if(surface.opposite[s] != no_index)
      continue;
    const Soup_index v = surface.triangles[s / 3][s % 3];
    const halfedge_descriptor h = opposite(halfedges[s], g);
    set_next(h, opposite(halfedges[border_side[v]], g), g);
    set_halfedge(vertices[v], h, g);
  }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_BUILD_MESH_H
