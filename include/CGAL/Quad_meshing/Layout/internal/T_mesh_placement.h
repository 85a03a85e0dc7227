// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_T_MESH_PLACEMENT_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_T_MESH_PLACEMENT_H

#include <CGAL/Quad_meshing/Layout/internal/T_mesh_grid.h>
#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Where the vertices of the quads of a T-mesh lie on the triangle mesh.
class T_mesh_placement
{
  typedef T_mesh::Location Location;

public:
  T_mesh_placement(const T_mesh& t, const std::vector<int>& length)
    : m_t(t), m_length(length), m_grid(t, length), m_vertex(m_grid.number_of_points, -1)
  {
    for(const T_mesh_grid::Quad& q : m_grid.quads)
      for(int i : q.points)
        if(m_vertex[i] == -1)
          m_vertex[i] = static_cast<int>(m_number_of_vertices++);
  }

  const T_mesh_grid& grid() const { return m_grid; }

  // The number of the vertex that a representative point is.
  std::size_t vertex(int point) const { return static_cast<std::size_t>(m_vertex[point]); }

  std::vector<Location> locations()
  {
    std::vector<Location> result(m_number_of_vertices);
    const int on_arcs = m_grid.collapsed.number_of_points();
    std::vector<std::vector<Candidate>> candidates(on_arcs);
    offer_nodes(candidates);
    offer_points_of_arcs(candidates);
    for(int i = 0; i < on_arcs; ++i)
      if(!candidates[i].empty() && m_vertex[i] != -1)
        result[m_vertex[i]] = choose(candidates[i]);
    for(std::size_t p = 0; p < m_t.patches.size(); ++p)
      place_inside(static_cast<int>(p), result);
    return result;
  }

private:
  struct Candidate
  {
    int rank; // critical nodes, then what lies on features, then others
    Location location;
  };

  const T_mesh& m_t;
  const std::vector<int>& m_length;
  T_mesh_grid m_grid;
  std::vector<int> m_vertex; // per point: the number of its vertex, -1 if it is no representative
  std::size_t m_number_of_vertices = 0;

  static constexpr int any = 0, on_feature = 1, critical = 2;

  void offer_nodes(std::vector<std::vector<Candidate>>& candidates)
  {
    for(std::size_t i = 0; i < m_t.nodes.size(); ++i)
    {
      const T_mesh::Node& n = m_t.nodes[i];
      int rank = n.is_critical ? critical : any;
      for(int d : n.directions)
        if(m_t.arcs[d / 2].is_aligned)
          rank = (std::max)(rank, on_feature);
      const int d = n.directions.front();
      candidates[m_grid.representative(static_cast<int>(i))].push_back(
        { rank, m_t.locate(d / 2, d & 1 ? m_t.arcs[d / 2].length : 0) });
    }
  }

  void offer_points_of_arcs(std::vector<std::vector<Candidate>>& candidates)
  {
    for(std::size_t a = 0; a < m_t.arcs.size(); ++a)
      for(int i = 1; i < m_length[a]; ++i)
      {
        const int arc = static_cast<int>(a);
        candidates[m_grid.representative(m_grid.collapsed.point(2 * arc, i))].push_back(
          { m_t.arcs[a].is_aligned ? on_feature : any, m_t.locate(arc, m_t.arcs[a].length * i / m_length[a]) });
      }
  }

  // Of the first in rank, the one nearest to their middle.
  Location choose(const std::vector<Candidate>& list) const
  {
    int rank = any;
    for(const Candidate& c : list)
      rank = (std::max)(rank, c.rank);
    std::array<double, 3> middle{ { 0, 0, 0 } };
    int number = 0;
    for(const Candidate& c : list)
      if(c.rank == rank)
      {
        const std::array<double, 3> p = m_t.position(c.location);
        for(int k = 0; k < 3; ++k)
          middle[k] += p[k];
        ++number;
      }
    double least = (std::numeric_limits<double>::max)();
    const Candidate* best = nullptr;
    for(const Candidate& c : list)
    {
      if(c.rank != rank)
        continue;
      const std::array<double, 3> p = m_t.position(c.location);
      double distance = 0;
      for(int k = 0; k < 3; ++k)
        distance += square(p[k] - middle[k] / number);
      if(distance < least)
      {
        least = distance;
        best = &c;
      }
    }
    return best->location;
  }

  // The real distances of the points of a side from its beginning; in the middle, where several are one point.
  std::vector<double> stations(int patch, int side) const
  {
    std::vector<double> sum(1, 0.), count(1, 1.);
    double begin = 0;
    for(int d : m_t.patches[patch].sides[side])
    {
      const double l = m_t.arcs[d / 2].length;
      const int n = m_length[d / 2];
      for(int i = 1; i <= n; ++i)
      {
        sum.push_back(begin + l * i / n);
        count.push_back(1);
      }
      begin += l;
      if(n == 0)
      {
        sum.back() += begin;
        ++count.back();
      }
    }
    for(std::size_t i = 0; i < sum.size(); ++i)
      sum[i] /= count[i];
    sum.front() = 0;
    sum.back() = begin;
    return sum;
  }

  void place_inside(int p, std::vector<Location>& result) const
  {
    const T_mesh_grid::Block& b = m_grid.blocks[p];
    if(b.width < 2 || b.height < 2)
      return;
    const double width = m_t.length(p, 0), height = m_t.length(p, 1);
    std::array<std::vector<double>, 4> s;
    for(int k = 0; k < 4; ++k)
      s[k] = stations(p, k);
    for(int j = 1; j < b.height; ++j)
      for(int i = 1; i < b.width; ++i)
      {
        // The lines from side 0 to side 2 and from side 3 to side 1 cross here:
        // u = u0 + (u1 - u0) v / height, v = v0 + (v1 - v0) u / width.
        const double u0 = s[0][i], u1 = width - s[2][b.width - i];
        const double v0 = height - s[3][b.height - j], v1 = s[1][j];
        const double a = (u1 - u0) / height, c = (v1 - v0) / width;
        const double u = (u0 + a * v0) / (1 - a * c);
        result[m_vertex[b.first + (j - 1) * (b.width - 1) + i - 1]] = m_t.locate_in_patch(p, u, v0 + c * u);
      }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_T_MESH_PLACEMENT_H
