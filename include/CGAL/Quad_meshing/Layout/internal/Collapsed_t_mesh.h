// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_COLLAPSED_T_MESH_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_COLLAPSED_T_MESH_H

#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What becomes of a T-mesh whose arcs have integer lengths, some of them zero.
//
// Points are the nodes, and what divides the arcs into unit edges. An arc of length zero makes one point of its two
// ends; a patch of width zero glues the points and the edges of its two sides to each other. The surface stays what it
// is if all that becomes one point is a disc or a tree, and all that becomes one edge is a row (then the quotient map
// is cell-like). The quads are what is asked for if no two things that must stay apart, nodes or features, become one.
class Collapsed_t_mesh
{
public:
  Collapsed_t_mesh(const T_mesh& t, const std::vector<int>& length) : m_t(t), m_length(length)
  {
    m_number_of_points = static_cast<int>(t.nodes.size());
    for(int n : length)
    {
      m_first_point.push_back(m_number_of_points);
      m_first_edge.push_back(m_number_of_edges);
      m_number_of_points += (std::max)(n - 1, 0);
      m_number_of_edges += n;
    }
    glue();
  }

  int number_of_points() const { return m_number_of_points; }

  // The point at a distance from the beginning of a direction.
  int point(int direction, int i) const
  {
    const int a = direction / 2, n = m_length[a];
    if(i == 0)
      return m_t.source(direction);
    if(i == n)
      return m_t.target(direction);
    return m_first_point[a] + (direction & 1 ? n - i : i) - 1;
  }

  // The points along a side of a patch, one more than it is long.
  std::vector<int> points(int patch, int side) const
  {
    std::vector<int> result;
    for(int d : m_t.patches[patch].sides[side])
      for(int i = result.empty() ? 0 : 1; i <= m_length[d / 2]; ++i)
        result.push_back(point(d, i));
    return result;
  }

  int length(int patch, int side) const
  {
    int sum = 0;
    for(int d : m_t.patches[patch].sides[side])
      sum += m_length[d / 2];
    return sum;
  }

  // Of the arcs of a side of a patch and of the opposite one, the longest in the map.
  int longest_arc(int patch, int side) const
  {
    int best = -1;
    for(int k : { side, (side + 2) & 3 })
      for(int d : m_t.patches[patch].sides[k])
        if(best == -1 || m_t.arcs[d / 2].length > m_t.arcs[best].length)
          best = d / 2;
    return best;
  }

  // Arcs that have to become longer before the surface can stay what it is, and what must stay apart does: one for each
  // conflict, not necessarily all of them.
  std::vector<int> conflicts()
  {
    std::vector<int> arcs;
    conflicts_of_points(arcs);
    conflicts_of_edges(arcs);
    std::sort(arcs.begin(), arcs.end());
    arcs.erase(std::unique(arcs.begin(), arcs.end()), arcs.end());
    return arcs;
  }

  // The point that stands for all those that a point is one with.
  int representative(int point) { return m_points.find(point); }

private:
  // Two points, or two edges, become one, unless an arc is longer.
  struct Glue
  {
    int a, b;
    int arc;
  };

  const T_mesh& m_t;
  const std::vector<int>& m_length;
  int m_number_of_points = 0, m_number_of_edges = 0;
  std::vector<int> m_first_point, m_first_edge; // per arc
  std::vector<Glue> m_glued_points, m_glued_edges;
  std::vector<std::array<int, 2>> m_discs; // patches that become a point: one of their nodes, and an arc
  Disjoint_sets m_points{ 0 }, m_edges{ 0 };

  std::vector<int> edges(int patch, int side) const
  {
    std::vector<int> result;
    for(int d : m_t.patches[patch].sides[side])
      for(int i = 0; i < m_length[d / 2]; ++i)
        result.push_back(m_first_edge[d / 2] + (d & 1 ? m_length[d / 2] - 1 - i : i));
    return result;
  }

  void glue()
  {
    for(std::size_t a = 0; a < m_length.size(); ++a)
      if(m_length[a] == 0)
        m_glued_points.push_back({ m_t.arcs[a].source, m_t.arcs[a].target, static_cast<int>(a) });
    for(std::size_t i = 0; i < m_t.patches.size(); ++i)
    {
      const int p = static_cast<int>(i);
      const int width = length(p, 0), height = length(p, 1);
      if(width == 0 && height == 0)
        m_discs.push_back({ { m_t.source(m_t.patches[p].sides[0].front()), longest_arc(p, 0) } });
      if((width == 0) == (height == 0))
        continue;
      const int side = width == 0 ? 1 : 0, n = width + height; // the one that is not of length zero
      const int arc = longest_arc(p, 1 - side);
      const std::vector<int> a = points(p, side), b = points(p, side + 2);
      for(int k = 1; k < n; ++k) // at the ends, arcs of length zero join them
        m_glued_points.push_back({ a[k], b[n - k], arc });
      const std::vector<int> c = edges(p, side), d = edges(p, side + 2);
      for(int k = 0; k < n; ++k)
        m_glued_edges.push_back({ c[k], d[n - 1 - k], arc });
    }
    m_points = Disjoint_sets(m_number_of_points);
    for(const Glue& g : m_glued_points)
      m_points.join(g.a, g.b);
    m_edges = Disjoint_sets(m_number_of_edges);
    for(const Glue& g : m_glued_edges)
      m_edges.join(g.a, g.b);
  }

  // The arc of the greatest real length.
  int longest(const std::vector<int>& arcs) const
  {
    return *std::max_element(arcs.begin(), arcs.end(),
                             [this](int a, int b) { return m_t.arcs[a].length < m_t.arcs[b].length; });
  }

  // Along a shortest way from a to something of another class, the arc of the greatest length.
  int arc_between(const std::map<int, std::vector<std::pair<int, int>>>& neighbours, int start,
                  const std::map<int, int>& class_of) const
  {
    std::map<int, std::pair<int, int>> from; // the one before, and the arc
    std::queue<int> front;
    front.push(start);
    from[start] = { -1, -1 };
    while(!front.empty())
    {
      const int i = front.front();
      front.pop();
      const auto c = class_of.find(i);
      if(c != class_of.end() && c->second != class_of.at(start))
      {
        std::vector<int> arcs;
        for(int j = i; from[j].first != -1; j = from[j].first)
          arcs.push_back(from[j].second);
        return longest(arcs);
      }
      const auto n = neighbours.find(i);
      if(n == neighbours.end())
        continue;
      for(const auto& next : n->second)
        if(from.emplace(next.first, std::make_pair(i, next.second)).second)
          front.push(next.first);
    }
    return -1;
  }

  void conflicts_of_points(std::vector<int>& result)
  {
    // Things that must stay apart: critical nodes, and pieces of features that become a point.
    Disjoint_sets things(m_number_of_points);
    std::vector<char> is_special(m_number_of_points, 0);
    for(std::size_t n = 0; n < m_t.nodes.size(); ++n)
      is_special[n] = m_t.nodes[n].is_critical;
    for(std::size_t a = 0; a < m_length.size(); ++a)
      if(m_t.arcs[a].is_aligned)
      {
        for(int i = 0; i <= m_length[a]; ++i)
          is_special[point(2 * static_cast<int>(a), i)] = 1;
        // A critical node may swallow T-vertices of its features, but not another critical node.
        if(m_length[a] == 0)
          things.join(m_t.arcs[a].source, m_t.arcs[a].target);
      }

    struct Cluster
    {
      int euler = 0;
      int specials = 0, nodes = 0;
      std::vector<int> arcs, members;
    };
    std::map<int, Cluster> clusters;
    for(const Glue& g : m_glued_points)
    {
      Cluster& c = clusters[m_points.find(g.a)];
      --c.euler;
      c.arcs.push_back(g.arc);
    }
    for(const auto& d : m_discs)
    {
      Cluster& c = clusters[m_points.find(d[0])];
      ++c.euler;
      c.arcs.push_back(d[1]);
    }
    for(int i = 0; i < m_number_of_points; ++i)
    {
      const auto c = clusters.find(m_points.find(i));
      if(c == clusters.end())
        continue;
      ++c->second.euler;
      c->second.members.push_back(i);
    }
    std::map<int, std::vector<std::pair<int, int>>> neighbours;
    for(const Glue& g : m_glued_points)
    {
      neighbours[g.a].emplace_back(g.b, g.arc);
      neighbours[g.b].emplace_back(g.a, g.arc);
    }
    for(const auto& entry : clusters)
    {
      const Cluster& c = entry.second;
      std::map<int, int> class_of;       // of special points: the thing
      std::map<int, int> class_of_nodes; // of critical nodes: itself
      std::vector<int> classes;
      for(int i : c.members)
        if(is_special[i])
        {
          class_of[i] = things.find(i);
          classes.push_back(things.find(i));
          if(i < static_cast<int>(m_t.nodes.size()) && m_t.nodes[i].is_critical)
            class_of_nodes[i] = i;
        }
      std::sort(classes.begin(), classes.end());
      const bool has_several = !classes.empty() && classes.front() != classes.back();
      if(class_of_nodes.size() > 1)
        result.push_back(arc_between(neighbours, class_of_nodes.begin()->first, class_of_nodes));
      if(has_several)
        for(const auto& s : class_of)
          if(s.second != class_of.begin()->second)
          {
            result.push_back(arc_between(neighbours, s.first, class_of));
            break;
          }
      if(c.euler != 1 && class_of_nodes.size() <= 1 && !has_several)
        result.push_back(longest(c.arcs));
    }
  }

  void conflicts_of_edges(std::vector<int>& result)
  {
    std::vector<char> is_aligned(m_number_of_edges, 0);
    for(std::size_t a = 0; a < m_length.size(); ++a)
      for(int i = 0; i < m_length[a]; ++i)
        is_aligned[m_first_edge[a] + i] = m_t.arcs[a].is_aligned;
    struct Row
    {
      int euler = 0;
      std::vector<int> arcs, members;
    };
    std::map<int, Row> rows;
    std::map<int, std::vector<std::pair<int, int>>> neighbours;
    for(const Glue& g : m_glued_edges)
    {
      Row& r = rows[m_edges.find(g.a)];
      --r.euler;
      r.arcs.push_back(g.arc);
      neighbours[g.a].emplace_back(g.b, g.arc);
      neighbours[g.b].emplace_back(g.a, g.arc);
    }
    for(int i = 0; i < m_number_of_edges; ++i)
    {
      const auto r = rows.find(m_edges.find(i));
      if(r == rows.end())
        continue;
      ++r->second.euler;
      r->second.members.push_back(i);
    }
    for(const auto& entry : rows)
    {
      const Row& r = entry.second;
      std::map<int, int> class_of;
      for(int i : r.members)
        if(is_aligned[i])
          class_of[i] = i;
      if(class_of.size() > 1)
        result.push_back(arc_between(neighbours, class_of.begin()->first, class_of));
      else if(r.euler != 1)
        result.push_back(longest(r.arcs));
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_COLLAPSED_T_MESH_H
