// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_ARC_SUBDIVISION_H
#define CGAL_QUAD_MESHING_LAYOUT_ARC_SUBDIVISION_H

#include <CGAL/Quad_meshing/Layout/Motorcycle_complex.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>
#include <CGAL/Quad_meshing/internal/Dual_lines.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What becomes of the walls of a motorcycle complex when its arcs get other lengths.
//
// An arc of length n consists of n edges and n + 1 points. Opposite sides of a rectangle have the same
// length. A rectangle of width (or height) 0 makes its two long sides one, edge by edge and point by point;
// an arc of length 0 makes its nodes one.
class Arc_subdivision
{
  typedef std::vector<Motorcycle_complex::Piece> Side;

  const std::vector<int>& m_length;
  std::vector<std::array<int, 2>> m_nodes;
  std::vector<int> m_first_point, m_first_edge;

public:
  Disjoint_sets points, edges; // which of them are the same

  // `node_number` numbers the nodes of the complex from 0, per vertex of the mesh.
  Arc_subdivision(const Motorcycle_complex& complex, const std::vector<int>& length,
                  const std::vector<int>& node_number, int number_of_nodes)
    : m_length(length)
    , m_nodes(length.size())
    , m_first_point(length.size() + 1)
    , m_first_edge(length.size() + 1)
    , points(0)
    , edges(0)
  {
    m_first_point[0] = number_of_nodes;
    for(std::size_t a = 0; a < length.size(); ++a)
    {
      m_first_edge[a + 1] = m_first_edge[a] + length[a];
      m_first_point[a + 1] = m_first_point[a] + (std::max)(0, length[a] - 1);
    }
    for(std::size_t a = 0; a < length.size(); ++a)
      m_nodes[a] = { { node_number[complex.arcs[a].nodes[0]], node_number[complex.arcs[a].nodes[1]] } };
    points = Disjoint_sets(m_first_point.back());
    edges = Disjoint_sets(m_first_edge.back());

    for(std::size_t a = 0; a < length.size(); ++a)
      if(length[a] == 0)
        points.join(m_nodes[a][0], m_nodes[a][1]);
    std::vector<int> one, other;
    for(const Motorcycle_complex::Patch& p : complex.patches)
      for(int k = 0; k < 2; ++k)
        if(side_length(p.sides[k]) == 0 && side_length(p.sides[k + 1]) > 0)
        {
          // sides k+1 and k+3 run in opposite directions
          points_of(p.sides[k + 1], one);
          points_of(p.sides[(k + 3) % 4], other);
          for(std::size_t i = 0; i < one.size(); ++i)
            points.join(one[i], other[one.size() - 1 - i]);
          edges_of(p.sides[k + 1], one);
          edges_of(p.sides[(k + 3) % 4], other);
          for(std::size_t i = 0; i < one.size(); ++i)
            edges.join(one[i], other[one.size() - 1 - i]);
        }
  }

  int number_of_points() const { return m_first_point.back(); }
  int number_of_edges() const { return m_first_edge.back(); }
  int point(int arc, int i) const
  {
    return i == 0 ? m_nodes[arc][0] : i == m_length[arc] ? m_nodes[arc][1] : m_first_point[arc] + i - 1;
  }
  int edge(int arc, int i) const { return m_first_edge[arc] + i; }

  int side_length(const Side& side) const
  {
    int sum = 0;
    for(const Motorcycle_complex::Piece& s : side)
      sum += m_length[s.arc];
    return sum;
  }

  // The points and edges along a side; not those of arcs of length 0 in between, which are the same points.
  void points_of(const Side& side, std::vector<int>& result) const
  {
    result.clear();
    for(const Motorcycle_complex::Piece& s : side)
      for(int n = m_length[s.arc], i = result.empty() ? 0 : 1; i <= n; ++i)
        if(n > 0)
          result.push_back(point(s.arc, s.forward ? i : n - i));
  }

  void edges_of(const Side& side, std::vector<int>& result) const
  {
    result.clear();
    for(const Motorcycle_complex::Piece& s : side)
      for(int n = m_length[s.arc], i = 0; i < n; ++i)
        result.push_back(edge(s.arc, s.forward ? i : n - 1 - i));
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_ARC_SUBDIVISION_H
