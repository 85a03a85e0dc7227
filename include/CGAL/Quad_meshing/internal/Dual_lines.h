// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_DUAL_LINES_H
#define CGAL_QUAD_MESHING_INTERNAL_DUAL_LINES_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The dual lines of a quad mesh. A directed dual edge is a halfedge h: in the face of h, heading
// across the edge of h. Going straight on partitions the halfedges into directed lines, which close
// up or run from border to border. The line of h^2 is the one of h walked backwards, position p
// becoming length-1-p on an open line.
struct Dual_lines
{
  std::vector<int> line, position; // per halfedge
  std::vector<int> first;          // per line: its first halfedge
  std::vector<int> length;         // per line: number of its halfedges
  std::vector<char> is_closed;     // per line
  std::vector<int> reverse;        // per line: the line in the other direction

  int number_of_lines() const { return static_cast<int>(length.size()); }

  // One direction of every line stands for both.
  bool is_representative(int l) const { return l < reverse[l]; }

  explicit Dual_lines(const Indexed_quad_mesh& m)
    : line(m.number_of_halfedges(), -1), position(m.number_of_halfedges(), 0)
  {
    auto trace = [&](int start, bool closed)
    {
      int p = 0;
      for(int h = start; h != -1 && line[h] == -1; h = m.forward(h), ++p)
      {
        line[h] = number_of_lines();
        position[h] = p;
      }
      first.push_back(start);
      length.push_back(p);
      is_closed.push_back(closed);
    };
    // open lines begin behind the border
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      if(m.opposite[m.across(h)] == -1)
        trace(h, false);
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      if(line[h] == -1)
        trace(h, true);
    reverse.resize(length.size());
    for(int l = 0; l < number_of_lines(); ++l)
      reverse[l] = line[m.across(first[l])];
  }
};

// The vertices that lines pass straight, inside with four edges, and those that are irregular; by counting corners,
// without walking around each vertex.
struct Vertex_regularity
{
  std::vector<char> is_inner_regular, is_irregular;

  explicit Vertex_regularity(const Indexed_quad_mesh& m)
    : is_inner_regular(m.number_of_vertices()), is_irregular(m.number_of_vertices())
  {
    std::vector<int> corners(m.number_of_vertices(), 0);
    std::vector<char> on_border(m.number_of_vertices(), 0);
    for(int h = 0; h < m.number_of_halfedges(); ++h)
    {
      ++corners[m.source(h)];
      if(m.is_border(h))
        on_border[m.source(h)] = on_border[m.target(h)] = 1;
    }
    for(int v = 0; v < m.number_of_vertices(); ++v)
    {
      is_inner_regular[v] = !on_border[v] && corners[v] == 4;
      is_irregular[v] = corners[v] > 0 && corners[v] != (on_border[v] ? 2 : 4);
    }
  }
};

inline std::vector<char> inner_regular_vertices(const Indexed_quad_mesh& m)
{
  return Vertex_regularity(m).is_inner_regular;
}

// Four edges inside and three on the border are regular.
inline bool is_irregular(const Indexed_quad_mesh& m, int v)
{
  return m.halfedge_of_vertex[v] != -1 && m.valence(v) != (m.is_border_vertex(v) ? 3 : 4);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_DUAL_LINES_H
