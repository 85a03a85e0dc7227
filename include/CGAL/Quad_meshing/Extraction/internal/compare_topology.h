// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_COMPARE_TOPOLOGY_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_COMPARE_TOPOLOGY_H

#include <CGAL/Quad_meshing/Extraction/internal/Grid_graph.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/surface_topology.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

inline Halfedge_arrays halfedge_arrays(const Indexed_triangle_mesh& m)
{
  Halfedge_arrays a;
  a.number_of_faces = m.number_of_faces();
  a.number_of_vertices = m.number_of_vertices();
  a.opposite = m.opposite;
  for(int h = 0; h < m.number_of_halfedges(); ++h)
  {
    a.next.push_back(m.next(h));
    a.face.push_back(h / 3);
    a.source.push_back(m.source(h));
  }
  std::vector<int> on_border; // the halfedges inside that the border halfedges are opposite to
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(m.opposite[h] == -1)
    {
      a.opposite[h] = m.number_of_halfedges() + static_cast<int>(on_border.size());
      on_border.push_back(h);
    }
  for(int h : on_border)
  {
    int g = m.prev(h); // the next one on the border leaves the source of h
    while(m.opposite[g] != -1)
      g = m.prev(m.opposite[g]);
    a.opposite.push_back(h);
    a.next.push_back(a.opposite[g]);
    a.face.push_back(-1);
    a.source.push_back(m.target(h));
  }
  return a;
}

// The faces of the graph, with vertices as `make_vertices()` makes them.
inline Halfedge_arrays halfedge_arrays(const Grid_graph& g, const std::vector<int>& vertex_of_ray,
                                       std::size_t number_of_vertices)
{
  Halfedge_arrays a;
  a.number_of_faces = g.number_of_faces();
  a.number_of_vertices = static_cast<int>(number_of_vertices);
  std::vector<int> number(g.number_of_rays(), -1), rays;
  for(int r = 0; r < g.number_of_rays(); ++r)
    if(g.opposite[r] >= 0 && (g.face[r] >= 0 || g.face[g.opposite[r]] >= 0))
    {
      number[r] = static_cast<int>(rays.size());
      rays.push_back(r);
    }
  for(int r : rays)
  {
    a.opposite.push_back(number[g.opposite[r]]);
    a.next.push_back(number[g.face[r] >= 0 ? g.next(r) : g.next_on_border(r)]);
    a.face.push_back(g.face[r] >= 0 ? g.face[r] : -1);
    a.source.push_back(vertex_of_ray[r]);
  }
  return a;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_COMPARE_TOPOLOGY_H
