// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_BRIDGE_CREASES_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_BRIDGE_CREASES_H

#include <CGAL/Quad_meshing/Fields/internal/find_sharp_edges.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Joins two creases that end at the two ends of one short edge, if it is half as sharp as creases are and leads on from
// one to the other. Where a crease is so short of an edge, its tessellation is bad there: two ends nearer to each other
// than a quad would have to be corners of quads of their own.
inline void bridge_creases(const Indexed_triangle_mesh& m, double angle_in_degrees, double target_edge_length,
                           std::vector<char>& is_sharp)
{
  const double longest_gap = target_edge_length / 2; // what a grid of twice the density cannot tell apart
  const double largest_turn = CGAL_PI / 4;           // at either end: halfway to a corner of quads
  const std::vector<char> is_half_as_sharp = find_sharp_edges(m, angle_in_degrees / 2);
  std::vector<int> degree(m.number_of_vertices(), 0), end(m.number_of_vertices(), -1);
  for(int e = 0; e < m.number_of_edges(); ++e)
  {
    const int h = m.halfedge_of_edge[e];
    if(!is_sharp[e] && !m.is_border_edge(e))
      continue;
    ++degree[m.source(h)];
    ++degree[m.target(h)];
    end[m.source(h)] = m.target(h);
    end[m.target(h)] = m.source(h);
  }
  auto turn = [&](int p, int q, int r)
  {
    const auto a = m.points[q] - m.points[p], b = m.points[r] - m.points[q];
    return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
  };
  for(int e = 0; e < m.number_of_edges(); ++e)
  {
    const int h = m.halfedge_of_edge[e], v = m.source(h), w = m.target(h);
    if(is_sharp[e] || !is_half_as_sharp[e] || degree[v] != 1 || degree[w] != 1 ||
       m.vector(h).squared_length() > longest_gap * longest_gap || turn(end[v], v, w) > largest_turn ||
       turn(v, w, end[w]) > largest_turn)
      continue;
    is_sharp[e] = true;
    degree[v] = degree[w] = 2;
  }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_BRIDGE_CREASES_H
