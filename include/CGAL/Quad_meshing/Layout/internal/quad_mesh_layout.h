// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUAD_MESH_LAYOUT_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUAD_MESH_LAYOUT_H

#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/internal/Base_complex_arrays.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

inline Surface_layout::Place place_of(const Indexed_quad_mesh::Point_3& p)
{
  Surface_layout::Place place;
  place.point = { { p.x(), p.y(), p.z() } };
  return place;
}

// A layout whose arcs are chains of edges of a quad mesh. `is_cut` tells the edges, per halfedge, `is_node` the nodes;
// the regions between the edges must be rectangles, else the result is empty.
inline Surface_layout layout_of_edges(const Indexed_quad_mesh& m, const std::vector<char>& is_cut,
                                      const std::vector<char>& is_node)
{
  Surface_layout layout;
  std::vector<std::size_t> node(m.number_of_vertices(), Surface_layout::none);
  for(int v = 0; v < m.number_of_vertices(); ++v)
    if(is_node[v] && m.halfedge_of_vertex[v] != -1)
    {
      node[v] = layout.nodes.size();
      layout.nodes.push_back(place_of(m.points[v]));
    }
  // the halfedge that goes on straight along a chain of edges in the face of h, or turns the corner there
  auto turns = [&](int h) { return is_cut[m.next(h)] != 0; };
  auto follow = [&](int h) { return turns(h) ? m.next(h) : m.next(m.opposite[m.next(h)]); };

  // an arc per chain; the chain begins at a node, and is known to both its sides
  std::vector<Surface_layout::Side_arc> arc_of(m.number_of_halfedges());
  for(int start = 0; start < m.number_of_halfedges(); ++start)
  {
    if(!is_cut[start] || !is_node[m.source(start)] || arc_of[start].arc != Surface_layout::none)
      continue;
    const std::size_t a = layout.arcs.size();
    layout.arcs.emplace_back();
    Surface_layout::Arc& arc = layout.arcs.back();
    arc.source = node[m.source(start)];
    arc.is_aligned = true;
    for(int h = start;; h = follow(h))
    {
      arc_of[h] = Surface_layout::Side_arc{ a, true };
      if(m.opposite[h] != -1)
        arc_of[m.opposite[h]] = Surface_layout::Side_arc{ a, false };
      arc.is_aligned = arc.is_aligned && m.is_feature[h];
      arc.target = node[m.target(h)];
      if(is_node[m.target(h)])
        break;
      arc.way.push_back(place_of(m.points[m.target(h)]));
    }
  }

  // a patch per region: from a corner along its four sides
  std::vector<char> seen(m.number_of_halfedges(), 0);
  for(int start = 0; start < m.number_of_halfedges(); ++start)
  {
    if(!is_cut[start] || !is_cut[m.prev(start)] || seen[start])
      continue;
    Surface_layout::Patch patch;
    int side = 0;
    for(int h = start; side < 4; h = follow(h))
    {
      if(arc_of[h].arc == Surface_layout::none)
        return Surface_layout(); // a closed chain without a node
      seen[h] = 1;
      if(is_node[m.source(h)])
        patch.sides[side].push_back(arc_of[h]);
      if(turns(h))
      {
        if(++side == 4 && follow(h) != start)
          return Surface_layout();
      }
    }
    layout.patches.push_back(patch);
  }
  // a chain that no corner leads to bounds a region that is no rectangle
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(is_cut[h] && !seen[h])
      return Surface_layout();
  return layout;
}

// The whole mesh as a layout: all vertices are nodes, all faces patches.
inline Surface_layout quad_mesh_layout(const Indexed_quad_mesh& m)
{
  return layout_of_edges(m, std::vector<char>(m.number_of_halfedges(), 1),
                         std::vector<char>(m.number_of_vertices(), 1));
}

// The base complex as a layout.
inline Surface_layout base_complex_layout(const Indexed_quad_mesh& m)
{
  const Base_complex_arrays complex = make_base_complex(m);
  for(int corners : complex.corners_of_patch)
    if(corners != 4)
      return Surface_layout();
  return layout_of_edges(m, complex.is_separatrix, complex.is_node);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUAD_MESH_LAYOUT_H
