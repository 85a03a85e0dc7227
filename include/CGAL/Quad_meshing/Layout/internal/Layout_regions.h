// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_REGIONS_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_REGIONS_H

#include <CGAL/Quad_meshing/Layout/internal/Embedded_layout.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The halfedge on an arc, or on the border, that follows h around the region to its left.
inline int next_on_region_border(const Split_surface& s, int h)
{
  int g = s.mesh.next(h);
  while(!s.is_on_arc(g) && s.mesh.opposite[g] != -1)
    g = s.mesh.next(s.mesh.opposite[g]);
  return g;
}

// The chain of vertices along an arc, and the halfedges that run along it in both directions.
inline void trace_arcs(Embedded_layout& e)
{
  const Indexed_triangle_mesh& m = e.surface.mesh;
  const int arcs = e.number_of_arcs();
  e.chain.assign(arcs, std::vector<int>());
  e.border.assign(2 * arcs, std::vector<int>());
  for(int a = 0; a < arcs; ++a)
  {
    const int end = e.vertex_of_node[e.layout.arcs[a].target];
    int v = e.vertex_of_node[e.layout.arcs[a].source];
    do
    {
      e.chain[a].push_back(v);
      int next = -1;
      for_each_corner_of_vertex(m, v,
                                [&](int h)
                                {
                                  if(e.surface.direction[h] == 2 * a)
                                  {
                                    next = m.target(h);
                                    e.border[2 * a].push_back(h);
                                  }
                                  if(e.surface.direction[m.prev(h)] == 2 * a + 1)
                                  {
                                    next = m.source(m.prev(h));
                                    e.border[2 * a + 1].push_back(m.prev(h));
                                  }
                                });
      CGAL_assertion(next != -1);
      v = next;
    }
    while(v != end);
    e.chain[a].push_back(v);
    std::reverse(e.border[2 * a + 1].begin(), e.border[2 * a + 1].end());
  }
}

// Assigns the faces to the patches. Returns what shows that the arcs do not cut the surface into them.
inline std::string find_regions(Embedded_layout& e)
{
  const Indexed_triangle_mesh& m = e.surface.mesh;
  trace_arcs(e);
  e.patch.assign(m.number_of_faces(), -1);
  std::vector<int> stack;
  for(int p = 0; p < e.number_of_patches(); ++p)
  {
    const std::string name = "Patch " + std::to_string(p);
    const std::vector<int> around = directions_around(e.layout.patches[p]);
    // its sides follow each other around the region
    for(std::size_t i = 0; i < around.size(); ++i)
    {
      const std::vector<int>&here = e.border[around[i]], &then = e.border[around[(i + 1) % around.size()]];
      if(here.empty() || then.empty())
        return name + " lies outside the surface at arc " + std::to_string(around[i] / 2) +
               " or the arc behind it: is its orientation that of the mesh?";
      if(next_on_region_border(e.surface, here.back()) != then.front())
        return name + ": on the surface, arc " + std::to_string(around[i] / 2) + " is not followed by arc " +
               std::to_string(around[(i + 1) % around.size()] / 2) + " at node " +
               std::to_string(layout_node_of_end(e.layout, around[i] ^ 1)) +
               ", counterclockwise around the patch, as the layout says.";
    }
    // vertices - edges + faces of its inside
    long inner_edges = 0, faces = 0;
    stack.assign(1, e.border[around[0]].front() / 3);
    if(e.patch[stack[0]] != -1)
      return name + " and patch " + std::to_string(e.patch[stack[0]]) + " are one region of the surface.";
    e.patch[stack[0]] = p;
    std::vector<int> vertices;
    while(!stack.empty())
    {
      const int f = stack.back();
      stack.pop_back();
      ++faces;
      for(int h = 3 * f; h < 3 * f + 3; ++h)
      {
        vertices.push_back(m.source(h));
        if(e.surface.is_on_arc(h))
        {
          if(e.topology.patch_of_direction[e.surface.direction[h]] != p)
            return name + " is not bounded by its sides alone, but by arc " +
                   std::to_string(e.surface.direction[h] / 2) + ", too.";
          continue;
        }
        const int o = m.opposite[h];
        if(o == -1)
          return name + " reaches the border of the mesh near " + Embedded_layout::place_name(m.points[m.source(h)]) +
                 ", where no arc runs along it.";
        inner_edges += h < o;
        if(e.patch[o / 3] == -1)
        {
          e.patch[o / 3] = p;
          stack.push_back(o / 3);
        }
      }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    long inner_vertices = 0;
    for(int v : vertices)
    {
      bool is_inner = true;
      for_each_corner_of_vertex(
        m, v, [&](int h) { is_inner = is_inner && !e.surface.is_on_arc(h) && !e.surface.is_on_arc(m.prev(h)); });
      inner_vertices += is_inner;
    }
    if(inner_vertices - inner_edges + faces != 1)
      return name + " is not a disc: its Euler characteristic is " +
             std::to_string(inner_vertices - inner_edges + faces) + ".";
  }
  for(int f = 0; f < m.number_of_faces(); ++f)
    if(e.patch[f] == -1)
      return "The surface near " + Embedded_layout::place_name(m.points[m.corners[f][0]]) + " belongs to no patch.";
  return std::string();
}

// Arcs for the pieces of the border between nodes that have none, where a layout names no patches.
inline void draw_border_pieces(Embedded_layout& e)
{
  const Indexed_triangle_mesh& m = e.surface.mesh;
  std::vector<int> node(m.number_of_vertices(), -1);
  for(std::size_t n = 0; n < e.vertex_of_node.size(); ++n)
    node[e.vertex_of_node[n]] = static_cast<int>(n);
  for(std::size_t n = 0; n < e.vertex_of_node.size(); ++n)
  {
    int h = m.halfedge_of_vertex[e.vertex_of_node[n]];
    if(m.opposite[h] != -1 || e.surface.is_on_arc(h))
      continue;
    const int a = e.number_of_arcs();
    e.layout.arcs.emplace_back();
    e.layout.arcs[a].source = n;
    do
    {
      e.surface.draw(h, 2 * a);
      e.layout.arcs[a].target = static_cast<std::size_t>(node[m.target(h)]);
      h = m.halfedge_of_vertex[m.target(h)];
    }
    while(node[m.source(h)] == -1 && !e.surface.is_on_arc(h));
  }
}

// The patches of a layout that names none: the regions between its arcs. The four nodes of a region with the smallest
// inner angles are its corners.
inline std::string find_patches(Embedded_layout& e)
{
  draw_border_pieces(e);
  const Indexed_triangle_mesh& m = e.surface.mesh;
  std::vector<char> seen(m.number_of_halfedges(), 0);
  for(int start = 0; start < m.number_of_halfedges(); ++start)
  {
    if(seen[start] || !e.surface.is_on_arc(start))
      continue;
    // the directions around the region from there, and the angle of the region before each of them
    std::vector<int> around;
    std::vector<double> angle;
    int h = start;
    do
    {
      seen[h] = 1;
      const int n = next_on_region_border(e.surface, h);
      const int d = e.surface.direction[n];
      if(d == -1)
        return "The border of the mesh near " + Embedded_layout::place_name(m.points[m.source(n)]) +
               " lies on no arc, and has no node.";
      const int v = m.source(n);
      if(v == e.vertex_of_node[layout_node_of_end(e.layout, d)])
      {
        double sum = 0;
        for(int g = n;; g = m.opposite[m.prev(g)])
        {
          sum += approximate_angle(m.vector(g), -m.vector(m.prev(g)));
          if(m.prev(g) == h)
            break;
        }
        around.push_back(d);
        angle.push_back(sum);
      }
      h = n;
    }
    while(h != start);
    const int n = static_cast<int>(around.size());
    const std::string place = Embedded_layout::place_name(m.points[m.source(start)]);
    if(n < 4)
      return "The region next to arc " + std::to_string(e.surface.direction[start] / 2) + " near " + place + " has " +
             std::to_string(n) + " nodes on its border; a patch needs four.";
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return angle[i] < angle[j]; });
    std::array<int, 5> corner = { { order[0], order[1], order[2], order[3], 0 } };
    std::sort(corner.begin(), corner.begin() + 4);
    corner[4] = corner[0] + n;
    Surface_layout::Patch patch;
    for(int k = 0; k < 4; ++k)
      for(int i = corner[k]; i < corner[k + 1]; ++i)
        patch.sides[k].push_back(
          Surface_layout::Side_arc{ static_cast<std::size_t>(around[i % n] / 2), around[i % n] % 2 == 0 });
    e.layout.patches.push_back(patch);
  }
  return std::string();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_REGIONS_H
