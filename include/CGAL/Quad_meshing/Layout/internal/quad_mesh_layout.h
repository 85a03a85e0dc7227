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
#include <CGAL/Quad_meshing/internal/Dual_lines.h>
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
    for(int h = start;; h = follow(h))
    {
      arc_of[h] = Surface_layout::Side_arc{ a, true };
      if(m.opposite[h] != -1)
        arc_of[m.opposite[h]] = Surface_layout::Side_arc{ a, false };
      arc.is_aligned = arc.is_aligned || m.is_feature[h];
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

// Lets the lines of a partition end on other lines only: where one ends, or bends, inside the mesh, it goes straight on
// up to the next line, which gets a T-vertex there.
inline void extend_lines(const Indexed_quad_mesh& m, std::vector<char>& is_cut)
{
  const std::vector<char> inner_regular = inner_regular_vertices(m);
  for(int start = 0; start < m.number_of_halfedges(); ++start)
    for(int h = start; is_cut[h] && inner_regular[m.target(h)];)
    {
      // the edges around the target: h comes in, then to its right, straight on, and to its left
      const int left = m.next(h), straight = m.next(m.opposite[left]), right = m.next(m.opposite[straight]);
      if(is_cut[straight] || (is_cut[left] && is_cut[right]))
        break;
      is_cut[straight] = 1;
      if(m.opposite[straight] != -1)
        is_cut[m.opposite[straight]] = 1;
      h = straight;
    }
}

// The base complex as a layout, with the feature edges, as they may run through patches, and what lets these end.
inline Surface_layout base_complex_layout(const Indexed_quad_mesh& m)
{
  std::vector<char> is_cut = separatrix_halfedges(m);
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    is_cut[h] = is_cut[h] || m.is_feature[h];
  extend_lines(m, is_cut);

  // a vertex is a node unless a line runs straight through it, or along the border
  const std::vector<char> inner_regular = inner_regular_vertices(m);
  std::vector<int> degree(m.number_of_vertices(), 0);
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(is_cut[h] && m.edge(h) == h)
    {
      ++degree[m.source(h)];
      ++degree[m.target(h)];
    }
  std::vector<char> is_node(m.number_of_vertices(), 0);
  for(int v = 0; v < m.number_of_vertices(); ++v)
    is_node[v] = degree[v] > 2 || (degree[v] > 0 && !inner_regular[v] && !(m.is_border_vertex(v) && m.valence(v) == 3));
  return layout_of_edges(m, is_cut, is_node);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUAD_MESH_LAYOUT_H
