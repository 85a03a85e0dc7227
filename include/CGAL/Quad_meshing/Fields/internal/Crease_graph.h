// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_CREASE_GRAPH_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_CREASE_GRAPH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The graph of sharp edges, from which what is noise at the scale of the quads is dropped.
class Crease_graph
{
public:
  typedef Simple_cartesian<double>::Point_3 Point_3;

  std::vector<bool> is_held; // per vertex: a crease that ends here does not end freely
  std::vector<bool> is_kept; // per edge

  explicit Crease_graph(const std::vector<Point_3>& points)
    : is_held(points.size(), false), m_points(points), m_incident(points.size())
  {
  }

  void add_edge(int v, int w)
  {
    const int e = static_cast<int>(m_ends.size());
    m_ends.push_back({ { v, w } });
    is_kept.push_back(true);
    m_incident[v].push_back(e);
    m_incident[w].push_back(e);
  }

  double distance(int v, int w) const { return std::sqrt((m_points[v] - m_points[w]).squared_length()); }

  double length(int e) const { return distance(m_ends[e][0], m_ends[e][1]); }

  // Drops branches and components until nothing changes; returns the number of pieces that were dropped.
  std::size_t drop_noise(double quad_edge_length)
  {
    if(!(quad_edge_length > 0))
      return 0;
    const double shortest_branch = 1.5 * quad_edge_length;
    const double shortest_open = 25 * quad_edge_length, shortest_closed = 5 * quad_edge_length;
    const double shortest_loop =
      1.5 * quad_edge_length; // of a rim: three quads around it are not half as long as asked
    // An open crease as straight as a ruler is no noise, nor are curves that turn little from edge to edge.
    const double least_straightness_of_open = 0.97, shortest_ruled = 3 * quad_edge_length;
    const double most_mean_turn = 20 * CGAL_PI / 180;
    const double least_straightness = 0.85, shortest_mean_chain = 1.5 * quad_edge_length;
    std::size_t dropped = 0;
    while(drop_short_branches(shortest_branch, dropped))
      ;
    std::vector<bool> seen(m_points.size(), false);
    for(int s = 0; s < static_cast<int>(m_points.size()); ++s)
    {
      if(seen[s] || degree(s) == 0)
        continue;
      const std::vector<int> component = component_of(s, seen);
      double total = 0;
      bool ends_freely = false;
      for(int e : component)
      {
        total += length(e);
        for(int v : m_ends[e])
          ends_freely = ends_freely || (degree(v) == 1 && !is_held[v]);
      }
      if(total >= shortest_loop && is_round(component))
        continue;
      const double straight = straightness(component, 2 * quad_edge_length);
      const bool is_ruled = ends_freely && straight >= least_straightness_of_open && total >= shortest_ruled;
      if((!is_ruled && total < (ends_freely ? shortest_open : shortest_closed)) ||
         (straight < least_straightness && mean_turn(component) > most_mean_turn) ||
         mean_chain_length(component) < shortest_mean_chain)
      {
        for(int e : component)
          is_kept[e] = false;
        ++dropped;
      }
    }
    return dropped;
  }

private:
  const std::vector<Point_3>& m_points;     // per vertex
  std::vector<std::array<int, 2>> m_ends;   // per edge
  std::vector<std::vector<int>> m_incident; // per vertex: all edges, kept or not

  int other_end(int e, int v) const { return m_ends[e][0] == v ? m_ends[e][1] : m_ends[e][0]; }

  int degree(int v) const
  {
    int d = 0;
    for(int e : m_incident[v])
      d += is_kept[e];
    return d;
  }

  // The edges from v, over e, to the next vertex that is no inner vertex of a chain, or back to v.
  std::vector<int> chain(int v, int e) const
  {
    const int start = v;
    std::vector<int> result(1, e);
    v = other_end(e, v);
    while(v != start && !is_node(v))
    {
      for(int f : m_incident[v])
        if(is_kept[f] && f != result.back())
        {
          result.push_back(f);
          break;
        }
      v = other_end(result.back(), v);
    }
    return result;
  }

  bool drop_short_branches(double shortest, std::size_t& dropped)
  {
    bool changed = false;
    for(int v = 0; v < static_cast<int>(m_points.size()); ++v)
    {
      if(degree(v) != 1 || is_held[v])
        continue;
      int first = -1;
      for(int e : m_incident[v])
        if(is_kept[e])
          first = e;
      const std::vector<int> branch = chain(v, first);
      double total = 0;
      int end = v;
      for(int e : branch)
      {
        total += length(e);
        end = other_end(e, end);
      }
      if(total >= shortest || (degree(end) == 1 && !is_held[end]))
        continue; // long, or a component of its own
      for(int e : branch)
        is_kept[e] = false;
      ++dropped;
      changed = true;
    }
    return changed;
  }

  std::vector<int> component_of(int s, std::vector<bool>& seen) const
  {
    std::vector<int> edges, stack(1, s);
    seen[s] = true;
    while(!stack.empty())
    {
      const int v = stack.back();
      stack.pop_back();
      for(int e : m_incident[v])
      {
        if(!is_kept[e])
          continue;
        if(m_ends[e][0] == v)
          edges.push_back(e); // once, from its first end
        const int w = other_end(e, v);
        if(!seen[w])
        {
          seen[w] = true;
          stack.push_back(w);
        }
      }
    }
    return edges;
  }

  // Whether a component is one closed curve that turns little more than once around: no closed curve turns less, and
  // only plane convex ones as little (Fenchel). Rims of holes and pins do, creases of noise run to and fro.
  bool is_round(const std::vector<int>& component) const
  {
    const double most_turning =
      1.15 * 2 * CGAL_PI; // a choice: noise of a tenth of the edges turns a circle so much more
    for(int e : component)
      for(int v : m_ends[e])
        if(is_node(v))
          return false;
    const int start = m_ends[component.front()][0];
    const std::vector<int> loop = chain(start, component.front());
    double turning = 0;
    int v = start;
    for(std::size_t i = 0; i < loop.size(); ++i)
    {
      const int w = other_end(loop[i], v);
      turning += turn(v, w, other_end(loop[(i + 1) % loop.size()], w));
      v = w;
    }
    return turning <= most_turning;
  }

  // The angle by which a path over three vertices turns.
  double turn(int v, int w, int x) const
  {
    const auto a = m_points[w] - m_points[v], b = m_points[x] - m_points[w];
    return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
  }

  // Over the inner vertices of the chains of a component.
  double mean_turn(const std::vector<int>& component) const
  {
    double sum = 0;
    int count = 0;
    for(int e : component)
      for(int v : m_ends[e])
      {
        if(is_node(v))
          continue;
        std::vector<int> ends;
        for(int f : m_incident[v])
          if(is_kept[f])
            ends.push_back(other_end(f, v));
        sum += turn(ends[0], v, ends[1]);
        ++count;
      }
    return count > 0 ? sum / count : 0;
  }

  bool is_node(int v) const { return degree(v) != 2 || is_held[v]; }

  // Between nodes; the length of a component without nodes, a closed curve.
  double mean_chain_length(const std::vector<int>& component) const
  {
    double total = 0;
    int ends_at_nodes = 0;
    for(int e : component)
    {
      total += length(e);
      for(int v : m_ends[e])
        ends_at_nodes += is_node(v);
    }
    return ends_at_nodes == 0 ? total : 2 * total / ends_at_nodes;
  }

  // The mean, over pieces of the chains of a component with the given arc length, of chord to arc.
  double straightness(const std::vector<int>& component, double arc) const
  {
    double sum = 0;
    int count = 0;
    auto measure = [&](int start, const std::vector<int>& edges)
    {
      std::vector<int> path(1, start);
      std::vector<double> at(1, 0.);
      for(int e : edges)
      {
        at.push_back(at.back() + length(e));
        path.push_back(other_end(e, path.back()));
      }
      std::size_t j = 0;
      for(std::size_t i = 0; i + 1 < path.size(); ++i)
      {
        while(j + 1 < path.size() && at[j] < at[i] + arc)
          ++j;
        if(i > 0 && at[j] < at[i] + arc)
          break; // the last pieces are shorter; one piece of a short chain counts
        if(at[j] > at[i])
        {
          sum += std::sqrt((m_points[path[j]] - m_points[path[i]]).squared_length()) / (at[j] - at[i]);
          ++count;
        }
      }
    };
    bool has_nodes = false;
    for(int e : component)
      for(int v : m_ends[e])
        if(is_node(v))
        {
          has_nodes = true;
          measure(v, chain(v, e));
        }
    if(!has_nodes)
      measure(m_ends[component.front()][0], chain(m_ends[component.front()][0], component.front()));
    return count > 0 ? sum / count : 1.;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_CREASE_GRAPH_H
