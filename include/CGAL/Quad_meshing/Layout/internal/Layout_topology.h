// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_TOPOLOGY_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_TOPOLOGY_H

#include <CGAL/Quad_meshing/Layout/Surface_layout.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// How arcs, ends of arcs and patches of a layout hang together, as the layout says it; no surface is known here.
//
// An arc `a` has two directions: 2*a from its source to its target, 2*a+1 back. A direction also names the end of the
// arc where it starts. A patch lies to the left of the directions of its sides.
struct Layout_topology
{
  std::string error; // what is wrong, empty if nothing is

  std::vector<int> patch_of_direction; // the patch to the left, -1 if there is none
  std::vector<int> side_of_direction;  // the side of that patch, 0 to 3
  // per end of an arc: the next one counterclockwise around the node, behind the patch between them; -1 behind the last
  std::vector<int> next_end, previous_end;

  static int direction(const Surface_layout::Side_arc& s)
  {
    return 2 * static_cast<int>(s.arc) + (s.is_forward ? 0 : 1);
  }

  bool is_border(int arc) const { return patch_of_direction[2 * arc] == -1 || patch_of_direction[2 * arc + 1] == -1; }
};

inline std::size_t layout_node_of_end(const Surface_layout& layout, int end)
{
  const Surface_layout::Arc& a = layout.arcs[end / 2];
  return end % 2 == 0 ? a.source : a.target;
}

// The directions around a patch, counterclockwise.
inline std::vector<int> directions_around(const Surface_layout::Patch& patch)
{
  std::vector<int> around;
  for(const std::vector<Surface_layout::Side_arc>& side : patch.sides)
    for(const Surface_layout::Side_arc& s : side)
      around.push_back(Layout_topology::direction(s));
  return around;
}

// What is wrong with the numbers of nodes and arcs alone.
inline std::string layout_number_error(const Surface_layout& layout)
{
  const std::size_t n = layout.nodes.size();
  if(n == 0 || layout.arcs.empty())
    return "The layout has no nodes or no arcs.";
  for(std::size_t i = 0; i < layout.arcs.size(); ++i)
  {
    const Surface_layout::Arc& a = layout.arcs[i];
    if(a.source >= n || a.target >= n)
      return "Arc " + std::to_string(i) + " names a node that there is not.";
    if(a.source == a.target && a.way.empty())
      return "Arc " + std::to_string(i) + " is a loop at node " + std::to_string(a.source) +
             ", which has to say where it passes.";
    if(!(a.edge_length >= 0) || std::isinf(a.edge_length))
      return "The edge length of arc " + std::to_string(i) + " is not a positive number.";
  }
  for(std::size_t p = 0; p < layout.patches.size(); ++p)
    for(int k = 0; k < 4; ++k)
    {
      if(layout.patches[p].sides[k].empty())
        return "Side " + std::to_string(k) + " of patch " + std::to_string(p) + " has no arc: a corner is missing.";
      for(const Surface_layout::Side_arc& s : layout.patches[p].sides[k])
        if(s.arc >= layout.arcs.size())
          return "Patch " + std::to_string(p) + " names an arc that there is not.";
    }
  return std::string();
}

// Finds the relations, or what is wrong with them.
inline Layout_topology make_layout_topology(const Surface_layout& layout)
{
  Layout_topology t;
  t.error = layout_number_error(layout);
  if(!t.error.empty())
    return t;
  const std::size_t directions = 2 * layout.arcs.size();
  t.patch_of_direction.assign(directions, -1);
  t.side_of_direction.assign(directions, -1);
  t.next_end.assign(directions, -1);
  t.previous_end.assign(directions, -1);
  for(std::size_t p = 0; p < layout.patches.size(); ++p)
  {
    const std::vector<int> around = directions_around(layout.patches[p]);
    for(std::size_t i = 0; i < around.size(); ++i)
    {
      const int d = around[i], before = around[(i + around.size() - 1) % around.size()];
      const std::size_t here = layout_node_of_end(layout, d), there = layout_node_of_end(layout, before ^ 1);
      if(here != there)
      {
        t.error = "In patch " + std::to_string(p) + ", arc " + std::to_string(before / 2) + " ends at node " +
                  std::to_string(there) + ", but arc " + std::to_string(d / 2) + ", which follows it, begins at node " +
                  std::to_string(here) + ".";
        return t;
      }
      if(t.patch_of_direction[d] != -1)
      {
        t.error = "Patches " + std::to_string(t.patch_of_direction[d]) + " and " + std::to_string(p) +
                  " lie on the same side of arc " + std::to_string(d / 2) + ".";
        return t;
      }
      t.patch_of_direction[d] = static_cast<int>(p);
      t.next_end[d] = before ^ 1;
      t.previous_end[before ^ 1] = d;
    }
    for(int k = 0; k < 4; ++k)
      for(const Surface_layout::Side_arc& s : layout.patches[p].sides[k])
        t.side_of_direction[Layout_topology::direction(s)] = k;
  }
  if(!layout.patches.empty())
    for(std::size_t a = 0; a < layout.arcs.size(); ++a)
      if(t.patch_of_direction[2 * a] == -1 && t.patch_of_direction[2 * a + 1] == -1)
      {
        t.error = "Arc " + std::to_string(a) + " belongs to no patch.";
        return t;
      }
  return t;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_TOPOLOGY_H
