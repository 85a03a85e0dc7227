// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_ARC_ROUTER_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_ARC_ROUTER_H

#include <CGAL/Quad_meshing/Layout/internal/Split_surface.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Draws arcs as short paths that do not cross what is drawn already.
//
// A path is searched in the graph of the free vertices and of some points on each free edge (Lanthier, Maheshwari,
// Sack: Approximating shortest paths on weighted polyhedral surfaces, Algorithmica 30(4), 2001), then pulled straight
// within the triangles that it crosses. Two steps of it always lie in one triangle, so that splitting its edges one
// after the other makes it a chain of edges, whatever the rounding. As every free edge has points of the graph,
// there is a path whenever the arcs leave the two ends in one piece of the surface.
class Arc_router
{
public:
  // Points of the graph on each edge.
  static constexpr int points_on_edge = 3;
  // Sweeps that pull a path straight.
  static constexpr int sweeps = 40;
  // Part of an edge next to a vertex in which a path takes the vertex, if that is free; and how near to a vertex it
  // may come where it is not.
  static constexpr double snapping = 0.1, margin = 0.02;

  // A step along a feature edge costs this part of its length, so that arcs near features run along them.
  static constexpr double cost_along_features = 0.7;

  // A vertex, or a point on an edge: source + t (target - source) of a halfedge.
  struct Step
  {
    int vertex;
    int halfedge;
    double t;
  };

  // The corners of a vertex, as halfedges that leave it, in which a path may leave or reach it; empty: all.
  typedef std::vector<int> Sector;

  explicit Arc_router(Split_surface& surface)
    : m_surface(surface)
    , m_least_cost(std::find(surface.is_feature.begin(), surface.is_feature.end(), 1) == surface.is_feature.end()
                     ? 1
                     : cost_along_features)
  {
  }

  // Vertices that no path may pass through.
  void block(int v)
  {
    if(v >= static_cast<int>(m_is_blocked.size()))
      m_is_blocked.resize(m_surface.mesh.number_of_vertices(), 0);
    m_is_blocked[v] = 1;
  }

  void release(int v)
  {
    if(is_blocked(v))
      m_is_blocked[v] = 0;
  }

  bool is_blocked(int v) const { return v < static_cast<int>(m_is_blocked.size()) && m_is_blocked[v]; }

  // A short path, false if the arcs leave none. Without `respects_arcs` it may cross them.
  bool find_path(int source, int target, const Sector& from, const Sector& into, bool respects_arcs,
                 std::vector<Step>& path)
  {
    m_respects_arcs = respects_arcs;
    m_source = source;
    m_target = target;
    m_into = &into;
    if(!search(from))
      return false;
    path.clear();
    for(int node = target; node != source; node = m_origin[node])
      path.push_back(step(node));
    path.push_back(step(source));
    std::reverse(path.begin(), path.end());
    straighten(path);
    return true;
  }

  // Splits the edges that a path crosses and marks its edges as those of an arc, in a direction of it. Its inner
  // vertices are blocked from now on.
  void draw(std::vector<Step> path, int direction)
  {
    const Indexed_triangle_mesh& m = m_surface.mesh;
    std::vector<int> chain;
    for(std::size_t i = 0; i < path.size(); ++i)
    {
      int v = path[i].vertex;
      if(v == -1)
      {
        auto rename = [&](int from, int to)
        {
          for(std::size_t j = i + 1; j < path.size(); ++j)
            if(path[j].halfedge == from)
              path[j].halfedge = to;
        };
        v = m_surface.split_edge(path[i].halfedge, point(path[i]), rename);
      }
      chain.push_back(v);
    }
    for(std::size_t i = 0; i + 1 < chain.size(); ++i)
    {
      const int h = halfedge_between(m, chain[i], chain[i + 1]);
      CGAL_assertion(h != -1);
      m_surface.draw(h, m.source(h) == chain[i] ? direction : direction ^ 1);
      if(i > 0)
        block(chain[i]);
    }
  }

  Split_surface::Point_3 point(const Step& s) const
  {
    const Indexed_triangle_mesh& m = m_surface.mesh;
    if(s.vertex != -1)
      return m.points[s.vertex];
    return m.points[m.source(s.halfedge)] + s.t * m.vector(s.halfedge);
  }

  double length(const std::vector<Step>& path) const
  {
    double sum = 0;
    for(std::size_t i = 0; i + 1 < path.size(); ++i)
      sum += std::sqrt(squared_distance(point(path[i]), point(path[i + 1])));
    return sum;
  }

  // A halfedge of the edge between two vertices, -1 if they have none.
  static int halfedge_between(const Indexed_triangle_mesh& m, int a, int b)
  {
    int found = -1;
    for_each_corner_of_vertex(m, a,
                              [&](int h)
                              {
                                if(m.target(h) == b)
                                  found = h;
                                else if(found == -1 && m.source(m.prev(h)) == b)
                                  found = m.prev(h);
                              });
    return found;
  }

private:
  typedef std::pair<double, int> Item;

  int canonical(int h) const
  {
    return m_surface.mesh.opposite[h] == -1 ? h : (std::min)(h, m_surface.mesh.opposite[h]);
  }

  bool is_crossable(int h) const { return !m_respects_arcs || !m_surface.is_on_arc(h); }

  Step step(int node) const
  {
    const int nv = m_surface.mesh.number_of_vertices();
    if(node < nv)
      return Step{ node, -1, 0 };
    return Step{ -1, (node - nv) / points_on_edge, double((node - nv) % points_on_edge + 1) / (points_on_edge + 1) };
  }

  bool may_visit(int v, int corner) const
  {
    if(v == m_target)
      return !m_respects_arcs || m_into->empty() || std::find(m_into->begin(), m_into->end(), corner) != m_into->end();
    return !is_blocked(v);
  }

  double least_cost_to_target(int node) const
  {
    return m_least_cost * std::sqrt(squared_distance(point(step(node)), m_surface.mesh.points[m_target]));
  }

  void reach(int from, int node, double distance, bool along_feature = false)
  {
    const double d = distance + (along_feature ? cost_along_features : 1) *
                                  std::sqrt(squared_distance(point(step(from)), point(step(node))));
    if(m_stamp[node] == m_search && m_distance[node] <= d)
      return;
    m_stamp[node] = m_search;
    m_distance[node] = d;
    m_origin[node] = from;
    // the straight distance to the target never overestimates what is left
    m_queue.push(Item(d + least_cost_to_target(node), node));
  }

  void reach_edge(int from, int h, double distance)
  {
    if(!is_crossable(h))
      return;
    const int first = m_surface.mesh.number_of_vertices() + points_on_edge * canonical(h);
    for(int i = 0; i < points_on_edge; ++i)
      reach(from, first + i, distance);
  }

  bool search(const Sector& from)
  {
    const Indexed_triangle_mesh& m = m_surface.mesh;
    const int nv = m.number_of_vertices(), nodes = nv + points_on_edge * m.number_of_halfedges();
    // the numbers of nodes change with each arc that is drawn
    m_stamp.resize(nodes, 0);
    m_distance.resize(nodes);
    m_origin.resize(nodes);
    ++m_search;
    m_queue = Queue();
    m_stamp[m_source] = m_search;
    m_distance[m_source] = 0;
    bool is_first = true;
    for(int node = m_source;;)
    {
      const double d = m_distance[node];
      if(!is_first && node == m_target)
        return true;
      if(node < nv)
        for_each_corner_of_vertex(
          m, node,
          [&](int h)
          {
            if(is_first && m_respects_arcs && !from.empty() && std::find(from.begin(), from.end(), h) == from.end())
              return;
            if(is_crossable(h) && may_visit(m.target(h), m.next(h)))
              reach(node, m.target(h), d, m_surface.is_feature[h]);
            const int p = m.prev(h);
            if(m.opposite[p] == -1 && is_crossable(p) && may_visit(m.source(p), p))
              reach(node, m.source(p), d, m_surface.is_feature[p]);
            reach_edge(node, m.next(h), d);
          });
      else
      {
        const int e = (node - nv) / points_on_edge;
        for(int g : { e, m.opposite[e] })
        {
          if(g == -1)
            continue;
          const int apex = m.source(m.prev(g));
          if(may_visit(apex, m.prev(g)))
            reach(node, apex, d);
          reach_edge(node, m.next(g), d);
          reach_edge(node, m.prev(g), d);
        }
      }
      is_first = false;
      for(;;)
      {
        if(m_queue.empty())
          return false;
        const Item item = m_queue.top();
        m_queue.pop();
        node = item.second;
        if(item.first <= m_distance[node] + least_cost_to_target(node))
          break;
      }
    }
  }

  // Where the straight line between two points meets the line of an edge, after the triangles at the edge have been
  // unfolded into one plane.
  double unfolded_crossing(const Split_surface::Point_3& p, const Split_surface::Point_3& q, int h, double t) const
  {
    const Indexed_triangle_mesh& m = m_surface.mesh;
    const Split_surface::Point_3& a = m.points[m.source(h)];
    const Indexed_triangle_mesh::Vector_3 e = m.vector(h);
    const double length2 = e.squared_length();
    if(!(length2 > 0))
      return t;
    const double tp = ((p - a) * e) / length2, tq = ((q - a) * e) / length2;
    const double dp = std::sqrt((p - (a + tp * e)).squared_length()),
                 dq = std::sqrt((q - (a + tq * e)).squared_length());
    return dp + dq > 0 ? (tp * dq + tq * dp) / (dp + dq) : t;
  }

  void straighten(std::vector<Step>& path) const
  {
    const Indexed_triangle_mesh& m = m_surface.mesh;
    for(int sweep = 0; sweep < sweeps; ++sweep)
      for(std::size_t i = 1; i + 1 < path.size(); ++i)
        if(path[i].vertex == -1)
        {
          const double t = unfolded_crossing(point(path[i - 1]), point(path[i + 1]), path[i].halfedge, path[i].t);
          path[i].t = (std::min)((std::max)(t, margin), 1 - margin);
        }
    for(Step& s : path)
      if(s.vertex == -1 && (s.t < snapping || s.t > 1 - snapping))
      {
        const int v = s.t < snapping ? m.source(s.halfedge) : m.target(s.halfedge);
        if(!is_blocked(v) && v != m_source && v != m_target)
          s = Step{ v, -1, 0 };
      }
    remove_loops(path);
  }

  // A path that comes back to a vertex or an edge goes on from there at once. Its ends may be one vertex.
  static void remove_loops(std::vector<Step>& path)
  {
    for(std::size_t i = 1; i + 1 < path.size(); ++i)
      for(std::size_t j = path.size() - 2; j > i; --j)
        if(path[i].vertex == path[j].vertex && path[i].halfedge == path[j].halfedge)
        {
          path.erase(path.begin() + i, path.begin() + j);
          break;
        }
  }

  typedef std::priority_queue<Item, std::vector<Item>, std::greater<Item>> Queue;

  Split_surface& m_surface;
  const double m_least_cost;      // per length
  std::vector<char> m_is_blocked; // per vertex, as far as any is
  bool m_respects_arcs = true;
  int m_source = -1, m_target = -1;
  const Sector* m_into = nullptr;
  Queue m_queue;
  int m_search = 0;
  std::vector<int> m_stamp, m_origin; // per node of the graph: the last search that has reached it, and from where
  std::vector<double> m_distance;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_ARC_ROUTER_H
