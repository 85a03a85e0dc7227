// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_EMBEDDING_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_EMBEDDING_H

#include <CGAL/Quad_meshing/Layout/internal/Arc_router.h>
#include <CGAL/Quad_meshing/Layout/internal/Embedded_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_places.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_regions.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <queue>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Draws a layout on a triangle mesh, which is cut so that all arcs are chains of edges.
//
// Border arcs follow the border. The others are drawn one after the other, those whose way is given first, short ones
// before long ones, and each leaves its nodes in the sector between the neighbours that the patches give it. An arc
// that is in the way of another one is erased and drawn again after it.
class Layout_embedding
{
public:
  // The refinement does not make more vertices than this, or than this many times those of the input.
  static constexpr int most_new_vertices = 20000, most_vertices_per_vertex = 2;
  // How many times longer an arc without a way may be than it would be without other arcs.
  static constexpr double largest_detour = 3;
  // How often arcs are drawn again because they were in the way, per arc.
  static constexpr std::size_t largest_redrawings = 3;

  explicit Layout_embedding(Embedded_layout& e) : m_e(e), m_router(e.surface) {}

  // Returns what makes it impossible, an empty sentence if nothing does, or if the visitor asked for an end.
  std::string run(const Indexed_triangle_mesh& input, Any_visitor& visitor)
  {
    m_e.topology = make_layout_topology(m_e.layout);
    if(!m_e.topology.error.empty())
      return m_e.topology.error;
    std::string error = place_nodes(input);
    if(error.empty())
      error = draw_arcs(visitor);
    if(!error.empty() || !visitor.go_further())
      return error;
    if(m_e.layout.patches.empty())
    {
      error = find_patches(m_e);
      if(!error.empty())
        return error;
      m_e.topology = make_layout_topology(m_e.layout);
      if(!m_e.topology.error.empty())
        return m_e.topology.error;
    }
    split_chords();
    return find_regions(m_e);
  }

  // Splits edges until none is longer than `length`, the longest first.
  void refine(double length)
  {
    const Indexed_triangle_mesh& m = m_e.surface.mesh;
    typedef std::pair<double, int> Item;
    std::priority_queue<Item> queue;
    auto add = [&](int h)
    {
      const double l = m.vector(h).squared_length();
      if(l > length * length && (m.opposite[h] == -1 || h < m.opposite[h]))
        queue.push(Item(l, h));
    };
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      add(h);
    const int most =
      (std::max)(m.number_of_vertices() + most_new_vertices, most_vertices_per_vertex * m.number_of_vertices());
    while(!queue.empty() && m.number_of_vertices() < most)
    {
      const Item item = queue.top();
      queue.pop();
      const int h = item.second;
      if(m.vector(h).squared_length() != item.first)
        continue; // it has been split, or has another number: that one is in the queue, too
      const int before = m.number_of_faces();
      m_e.surface.split_edge(h, midpoint(m.points[m.source(h)], m.points[m.target(h)]));
      std::vector<int> changed{ h, m.next(h), m.prev(h) };
      for(int f = before; f < m.number_of_faces(); ++f)
        for(int k = 0; k < 3; ++k)
          changed.push_back(3 * f + k);
      if(m.opposite[3 * before] != -1)
        changed.push_back(m.opposite[3 * before]);
      for(int g : changed)
        add(m.opposite[g] == -1 ? g : (std::min)(g, m.opposite[g]));
    }
  }

private:
  const Split_surface::Point_3& node_point(std::size_t n) const { return m_e.mesh().points[m_e.vertex_of_node[n]]; }

  std::string place_nodes(const Indexed_triangle_mesh& input)
  {
    const Surface_layout& layout = m_e.layout;
    const Layout_topology& t = m_e.topology;
    Layout_places places(input, m_e.surface);
    if(places.is_empty())
      return "The mesh has no triangle of positive area.";
    std::vector<char> is_border(layout.nodes.size(), 0);
    if(!layout.patches.empty())
      for(int a = 0; a < m_e.number_of_arcs(); ++a)
        if(t.is_border(a))
          is_border[layout.arcs[a].source] = is_border[layout.arcs[a].target] = 1;
    for(std::size_t n = 0; n < layout.nodes.size(); ++n)
    {
      const int v = is_border[n] ? places.border_vertex(layout.nodes[n]) : places.vertex(layout.nodes[n]);
      if(v == -1)
        return is_border[n] ? "Node " + std::to_string(n) +
                                " ends an arc of one patch only, but does not lie on the border of the mesh."
                            : "Node " + std::to_string(n) + " names a vertex that there is not, or no finite point.";
      if(m_router.is_blocked(v))
      {
        const std::size_t other =
          std::find(m_e.vertex_of_node.begin(), m_e.vertex_of_node.end(), v) - m_e.vertex_of_node.begin();
        return "Nodes " + std::to_string(other) + " and " + std::to_string(n) + " lie at the same vertex.";
      }
      m_e.vertex_of_node.push_back(v);
      m_router.block(v);
    }
    // the places that arcs pass through belong to them
    m_way.resize(layout.arcs.size());
    for(std::size_t a = 0; a < layout.arcs.size(); ++a)
    {
      if(!layout.patches.empty() && t.is_border(static_cast<int>(a)))
        continue;
      for(const Surface_layout::Place& p : layout.arcs[a].way)
      {
        const int v = places.vertex(p);
        if(v == -1)
          return "Arc " + std::to_string(a) + " passes through a place that there is not.";
        if(!m_router.is_blocked(v))
        {
          m_way[a].push_back(v);
          m_router.block(v);
        }
      }
    }
    return std::string();
  }

  std::string draw_arcs(Any_visitor& visitor)
  {
    const Surface_layout& layout = m_e.layout;
    const int arcs = m_e.number_of_arcs();
    m_is_drawn.assign(arcs, 0);
    std::vector<int> order;
    for(int a = 0; a < arcs; ++a)
      if(!layout.patches.empty() && m_e.topology.is_border(a))
      {
        const std::string error = draw_border_arc(a);
        if(!error.empty())
          return error;
      }
      else
        order.push_back(a);
    // an order that does not depend on the numbers of the arcs
    typedef std::tuple<bool, double, Split_surface::Point_3, Split_surface::Point_3> Key;
    std::vector<Key> key(arcs);
    for(int a : order)
    {
      const Split_surface::Point_3 &p = node_point(layout.arcs[a].source), &q = node_point(layout.arcs[a].target);
      key[a] = Key(m_way[a].empty(), squared_distance(p, q), (std::min)(p, q), (std::max)(p, q));
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key[a] < key[b]; });
    // what is in the way of an arc is drawn again after it
    std::deque<int> waiting(order.begin(), order.end());
    double completed = 0;
    std::size_t redrawings = largest_redrawings * order.size();
    while(!waiting.empty() && visitor.go_further())
    {
      const int a = waiting.front();
      int obstacle = -1;
      const std::string error = draw_arc(a, obstacle);
      if(error.empty())
        waiting.pop_front();
      else if(obstacle == -1 || redrawings == 0)
        return error;
      else
      {
        --redrawings;
        erase(obstacle);
        waiting.push_back(obstacle);
      }
      completed = (std::max)(completed, 1 - double(waiting.size()) / double(order.size()));
      visitor.progress(completed);
    }
    return std::string();
  }

  std::string draw_border_arc(int a)
  {
    const Indexed_triangle_mesh& m = m_e.surface.mesh;
    const int d = m_e.topology.patch_of_direction[2 * a] != -1 ? 2 * a : 2 * a + 1;
    const int end = m_e.vertex_of_node[layout_node_of_end(m_e.layout, d ^ 1)];
    int v = m_e.vertex_of_node[layout_node_of_end(m_e.layout, d)];
    do
    {
      const int h = m.halfedge_of_vertex[v];
      if(m.opposite[h] != -1 || m_e.surface.is_on_arc(h))
        return "Arc " + std::to_string(a) + " belongs to one patch only, but cannot follow the border of the mesh.";
      m_e.surface.draw(h, d);
      v = m.target(h);
      if(v != end && m_router.is_blocked(v))
        return "Border arc " + std::to_string(a) + " passes through a node that is not its end.";
      m_router.block(v);
    }
    while(v != end);
    m_is_drawn[a] = 1;
    return std::string();
  }

  // If it cannot be drawn, `obstacle` is an arc that is in the way, -1 if there is none that may be erased.
  std::string draw_arc(int a, int& obstacle)
  {
    const Surface_layout::Arc& arc = m_e.layout.arcs[a];
    const std::string name = "Arc " + std::to_string(a) + " from node " + std::to_string(arc.source) + " to node " +
                             std::to_string(arc.target);
    std::vector<int> stops(1, m_e.vertex_of_node[arc.source]);
    stops.insert(stops.end(), m_way[a].begin(), m_way[a].end());
    stops.push_back(m_e.vertex_of_node[arc.target]);
    if(stops.size() == 2 && stops[0] == stops[1])
      return name + " is a loop whose way does not leave its node.";
    // from the end that comes first in space, whatever the layout calls the source
    const int d = node_point(arc.target) < node_point(arc.source) ? 2 * a + 1 : 2 * a;
    if(d % 2 == 1)
      std::reverse(stops.begin(), stops.end());
    int from = stops.front();
    bool is_first = true;
    for(std::size_t i = 1; i < stops.size(); ++i)
    {
      const bool is_last = i + 1 == stops.size();
      const Arc_router::Sector out = is_first ? sector(d) : Arc_router::Sector();
      const Arc_router::Sector into = is_last ? sector(d ^ 1) : Arc_router::Sector();
      std::vector<Arc_router::Step> path;
      const bool is_found = m_router.find_path(from, stops[i], out, into, true, path);
      if(is_found && !(arc.way.empty() && is_detour(path, from, stops[i])))
      {
        m_router.draw(path, d);
        from = stops[i];
        is_first = false;
      }
      else if(!is_last && (arc.source != arc.target || !is_first || i + 2 < stops.size()))
        m_router.release(stops[i]); // a place that other arcs have closed off is left out
      else
      {
        Split_surface::Point_3 place(0, 0, 0);
        obstacle = obstacle_of(a, from, stops[i], place);
        const bool has_neighbour = obstacle == -1;
        if(has_neighbour)
          obstacle = neighbour_of(is_first ? d : d ^ 1);
        erase(a);
        if(is_found)
          return name + " cannot be drawn but with a long detour around other arcs: is the orientation of the patches "
                        "that of the mesh?";
        if(has_neighbour)
          return name + " cannot be drawn in the order in which the patches lie around its nodes: is their "
                        "orientation that of the mesh?";
        return name + " cannot be drawn without crossing arc " + std::to_string(obstacle) + " near " +
               Embedded_layout::place_name(place) + ".";
      }
    }
    m_is_drawn[a] = 1;
    return std::string();
  }

  // Takes an arc from the surface; the vertices that it has made stay.
  void erase(int a)
  {
    const Indexed_triangle_mesh& m = m_e.surface.mesh;
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      if(m_e.surface.direction[h] / 2 == a && m_e.surface.is_on_arc(h))
      {
        m_e.surface.direction[h] = -1;
        m_router.release(m.source(h));
        m_router.release(m.target(h));
      }
    for(int v : m_way[a])
      m_router.block(v);
    for(int v : m_e.vertex_of_node)
      m_router.block(v);
    m_is_drawn[a] = 0;
  }

  // Whether a path is much longer than it would be without other arcs. A layout of the wrong orientation can be drawn,
  // with arcs that wind around each other, but is not what was meant.
  bool is_detour(const std::vector<Arc_router::Step>& path, int from, int to)
  {
    const double length = m_router.length(path);
    if(length <= largest_detour * std::sqrt(squared_distance(m_e.mesh().points[from], m_e.mesh().points[to])))
      return false;
    std::vector<Arc_router::Step> free_path;
    return m_router.find_path(from, to, Arc_router::Sector(), Arc_router::Sector(), false, free_path) &&
           length > largest_detour * m_router.length(free_path);
  }

  // The first drawn arc on the short way between two vertices, and where; -1 if there is none.
  int obstacle_of(int a, int from, int to, Split_surface::Point_3& place)
  {
    std::vector<Arc_router::Step> path;
    if(!m_router.find_path(from, to, Arc_router::Sector(), Arc_router::Sector(), false, path))
      return -1;
    for(const Arc_router::Step& s : path)
    {
      int d = -1;
      if(s.vertex == -1)
        d = m_e.surface.direction[s.halfedge];
      else if(s.vertex != from && s.vertex != to)
        for_each_corner_of_vertex(m_e.mesh(), s.vertex, [&](int h) { d = (std::max)(d, m_e.surface.direction[h]); });
      if(d != -1 && d / 2 != a && may_be_erased(d / 2))
      {
        place = m_router.point(s);
        return d / 2;
      }
    }
    return -1;
  }

  // A drawn arc next to an end of an arc at its node, -1 if there is none.
  int neighbour_of(int end) const
  {
    for(const std::vector<int>* next : { &m_e.topology.previous_end, &m_e.topology.next_end })
      for(int e = (*next)[end]; e != -1 && e != end; e = (*next)[e])
        if(e / 2 != end / 2 && may_be_erased(e / 2))
          return e / 2;
    return -1;
  }

  // Border arcs have no other way.
  bool may_be_erased(int a) const
  {
    return m_is_drawn[a] && (m_e.layout.patches.empty() || !m_e.topology.is_border(a));
  }

  // The corners between the drawn neighbours of an end of an arc; none if there are no neighbours yet.
  Arc_router::Sector sector(int end) const
  {
    const Layout_topology& t = m_e.topology;
    const Indexed_triangle_mesh& m = m_e.surface.mesh;
    auto neighbour = [&](const std::vector<int>& next)
    {
      int e = next[end];
      while(e != -1 && e != end && !is_drawn(e))
        e = next[e];
      return e == end ? -1 : e;
    };
    const int previous = neighbour(t.previous_end), next = neighbour(t.next_end);
    Arc_router::Sector corners;
    if(previous == -1 && next == -1)
      return corners;
    const int v = m_e.vertex_of_node[layout_node_of_end(m_e.layout, end)];
    std::vector<int> fan;
    for_each_corner_of_vertex(m, v, [&](int h) { fan.push_back(h); });
    const int n = static_cast<int>(fan.size());
    auto find = [&](int e)
    {
      for(int i = 0; i < n; ++i)
        if(m_e.surface.direction[fan[i]] == e)
          return i;
      return n; // the edge behind the last corner
    };
    int i = previous == -1 ? find(next) : find(previous);
    if(previous == -1)
      do // clockwise from the next one to the end of the fan, or once around
      {
        i = (i + n - 1) % n;
        corners.push_back(fan[i]);
      }
      while(!m_e.surface.is_on_arc(fan[i]) && m.opposite[fan[i]] != -1);
    else
      for(i %= n;;)
      {
        corners.push_back(fan[i]);
        if(m.next_around_source(fan[i]) == -1)
          break;
        i = (i + 1) % n;
        if(m_e.surface.is_on_arc(fan[i]))
          break;
      }
    return corners;
  }

  // An arc that is being drawn leaves a node twice if it is a loop; its first end counts as drawn then.
  bool is_drawn(int end) const
  {
    if(m_is_drawn[end / 2])
      return true;
    bool found = false;
    for_each_corner_of_vertex(m_e.mesh(), m_e.vertex_of_node[layout_node_of_end(m_e.layout, end)],
                              [&](int h) { found = found || m_e.surface.direction[h] == end; });
    return found;
  }

  // An edge across a patch between two of its sides would be squeezed to nothing where these are one side of a chart.
  void split_chords()
  {
    const Indexed_triangle_mesh& m = m_e.surface.mesh;
    std::vector<char> on_arc(m.number_of_vertices(), 0);
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      if(m_e.surface.is_on_arc(h))
        on_arc[m.source(h)] = on_arc[m.target(h)] = 1;
    for(int h = 0; h < m.number_of_halfedges(); ++h)
    {
      const int a = m.source(h), b = m.target(h), n = static_cast<int>(on_arc.size());
      if(!m_e.surface.is_on_arc(h) && a < n && b < n && on_arc[a] && on_arc[b])
        m_e.surface.split_edge(h, midpoint(m.points[a], m.points[b]));
    }
  }

  Embedded_layout& m_e;
  Arc_router m_router;
  std::vector<std::vector<int>> m_way; // per arc: the vertices that it passes through
  std::vector<char> m_is_drawn;        // per arc
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_EMBEDDING_H
