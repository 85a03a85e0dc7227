// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_LAYOUT_QUANTIZATION_H
#define CGAL_QUAD_MESHING_LAYOUT_LAYOUT_QUANTIZATION_H

#include <CGAL/Quad_meshing/Layout/Arc_subdivision.h>
#include <CGAL/Quad_meshing/Layout/Layout_weights.h>
#include <CGAL/Quad_meshing/Layout/Motorcycle_complex.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Chooses the lengths of the arcs of a motorcycle complex.
//
// A closed path through the complex that leaves each rectangle on the side opposite to where it has entered
// keeps opposite sides equal when all arcs that it crosses become shorter (or longer) by one. Shortening is
// a grid-preserving operator: where the path leaves by another arc than straight ahead it shifts, but that
// changes nothing in the rectangle and costs nothing here. So a search among the few arcs replaces one in
// all edges of the mesh. Arcs that get the length 0 turn T-junctions into nodes of a layout without
// T-junctions (Lyon, Campen, Kobbelt: Quad layouts via constrained T-mesh quantization, Computer Graphics
// Forum 40(2), 2021).
class Layout_quantization
{
public:
  // Number of paths that are tried before an arc is left as it is.
  static constexpr int repairs = 12;

  std::vector<int> length; // per arc

  Layout_quantization(const Indexed_quad_mesh& mesh, const Motorcycle_complex& complex,
                      const std::vector<char>& is_fixed, bool merge_singularities)
    : m_complex(complex)
    , m_rules(make_quad_vertex_rules(mesh, merge_singularities))
    , m_node_number(mesh.number_of_vertices(), -1)
  {
    for(const Motorcycle_complex::Arc& a : complex.arcs)
    {
      length.push_back(a.length());
      for(int v : a.nodes)
        if(m_node_number[v] == -1)
        {
          m_node_number[v] = static_cast<int>(m_vertex_of_node.size());
          m_vertex_of_node.push_back(v);
          m_rules.is_special[v] |= is_fixed[v];
        }
    }
    Disjoint_sets components(static_cast<int>(complex.patches.size()));
    for(const Motorcycle_complex::Arc& a : complex.arcs)
      if(a.patch[1] != -1)
        components.join(a.patch[0], a.patch[1]);
    for(int p = 0; p < static_cast<int>(complex.patches.size()); ++p)
      m_component.push_back(components.smallest(p));
    m_euler_characteristic = check().euler_characteristic;
  }

  Arc_subdivision subdivision(const std::vector<int>& lengths) const
  {
    return Arc_subdivision(m_complex, lengths, m_node_number, static_cast<int>(m_vertex_of_node.size()));
  }

  const Motorcycle_complex& complex() const { return m_complex; }
  const std::vector<int>& vertex_of_node() const { return m_vertex_of_node; }
  const Quad_vertex_rules& rules() const { return m_rules; }

  int number_of_quads(const std::vector<int>& lengths) const
  {
    auto sum = [&](const std::vector<Motorcycle_complex::Piece>& side)
    {
      int n = 0;
      for(const Motorcycle_complex::Piece& s : side)
        n += lengths[s.arc];
      return n;
    };
    int quads = 0;
    for(const Motorcycle_complex::Patch& p : m_complex.patches)
      quads += sum(p.sides[0]) * sum(p.sides[1]);
    return quads;
  }

  // Shortens arcs until they have about their original length divided by `scale`, as far as that does not
  // merge what must stay apart; the one that is too long by most comes first.
  template <typename GoFurther>
  void shorten(double scale, const GoFurther& go_further)
  {
    std::vector<char> has_failed(length.size(), 0);
    while(go_further())
    {
      int worst = -1;
      double worst_excess = 0.5;
      for(std::size_t a = 0; a < length.size(); ++a)
        if(!has_failed[a] && length[a] > 0 && excess(a, scale) > worst_excess)
        {
          worst = static_cast<int>(a);
          worst_excess = excess(a, scale);
        }
      if(worst == -1)
        return;
      // much at once, as far as the other arcs allow it
      int by = -(std::max)(1, static_cast<int>(worst_excess / 2));
      auto price = [&](std::size_t a, int change) { return -gain(a, change, scale); };
      while(by < -1 && !change(worst, by, price, 0, true))
        by /= 2;
      if(by == -1 && !change(worst, by, price, 0, true))
        has_failed[worst] = 1;
    }
  }

  // Adds `by` to the lengths along a cheap path across an arc; false if none is found, or with
  // `only_with_gain` if its price is not negative. The path is cheap by the sum of `price(arc, change)` over the arcs,
  // and if it crosses few edges of the input, each of which costs `edge_cost`.
  template <typename Price>
  bool change(int arc, int by, const Price& price, double edge_cost, bool only_with_gain)
  {
    std::vector<char> forbidden(length.size(), 0);
    if(by < 0)
      for(std::size_t a = 0; a < length.size(); ++a)
      {
        const Motorcycle_complex::Arc& x = m_complex.arcs[a];
        forbidden[a] =
          length[a] < -by || (length[a] == -by && m_rules.is_special[x.nodes[0]] && m_rules.is_special[x.nodes[1]]);
      }
    if(forbidden[arc])
      return false;

    std::vector<int> path, times(length.size());
    for(int attempt = 0; attempt < repairs; ++attempt)
    {
      if(!find_path(arc, by, price, edge_cost, forbidden, path))
        return false;
      std::fill(times.begin(), times.end(), 0);
      for(int a : path)
        ++times[a];
      double sum = 0;
      int conflict = -1;
      for(int a : path)
      {
        if(length[a] + by * times[a] < 0)
          conflict = a;
        sum -= price(a, by * times[a]) / times[a];
      }
      if(conflict == -1)
      {
        if(only_with_gain && !(sum > 0))
          return false;
        for(int a : path)
          length[a] += by;
        // longer arcs do not merge anything, nor does anything else as long as no arc has vanished
        if(by > 0 || std::find(length.begin(), length.end(), 0) == length.end())
          return true;
        const Check c = check();
        if(c.is_allowed && c.euler_characteristic == m_euler_characteristic)
          return true;
        // the longest of those that have vanished stays
        for(int a : path)
          if(a != arc && length[a] == 0 &&
             (conflict == -1 || m_complex.arcs[a].length() > m_complex.arcs[conflict].length()))
            conflict = a;
        for(int a : path)
          length[a] -= by;
      }
      if(conflict == -1 || conflict == arc)
        return false;
      forbidden[conflict] = 1;
    }
    return false;
  }

  // The same, the price of an arc being what it then fits worse to the scale.
  bool change(int arc, int by, double scale, double edge_cost, bool only_with_gain)
  {
    return change(
      arc, by, [&](std::size_t a, int change) { return -gain(a, change, scale); }, edge_cost, only_with_gain);
  }

private:
  double excess(std::size_t arc, double scale) const { return length[arc] - m_complex.arcs[arc].length() / scale; }

  // How much less the squared excess becomes when an arc changes.
  double gain(std::size_t arc, int by, double scale) const
  {
    const double e = excess(arc, scale);
    return e * e - (e + by) * (e + by);
  }

  // A cheap closed path across an arc, or one that begins and ends at the border. State 2*a + i stands for
  // the way across arc a into its patch i.
  template <typename Price>
  bool find_path(int arc, int by, const Price& price, double edge_cost, const std::vector<char>& forbidden,
                 std::vector<int>& path)
  {
    // the patch of a border arc is its patch 0
    const bool at_border = m_complex.arcs[arc].is_border;
    path.assign(1, arc);
    auto append_way = [&](int start, int end)
    {
      for(int s = end; s != start; s = m_origin[s])
        path.push_back(s / 2);
    };
    const int forward = 2 * arc, backward = 2 * arc + 1;
    const int end = search(forward, at_border ? -1 : forward, by, price, edge_cost, forbidden);
    if(end == -1)
      return false;
    if(end == forward)
    {
      append_way(forward, m_origin[forward]);
      return true;
    }
    append_way(forward, end);
    if(at_border)
      return true;
    const int other_end = search(backward, -1, by, price, edge_cost, forbidden);
    if(other_end == -1)
      return false;
    append_way(backward, other_end);
    return true;
  }

  // Cheapest way from a state back to `target`, or out of the mesh; gives the state where it ends.
  template <typename Price>
  int search(int start, int target, int by, const Price& price, double edge_cost, const std::vector<char>& forbidden)
  {
    typedef std::pair<double, int> Item;
    std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
    m_distance.assign(2 * length.size(), (std::numeric_limits<double>::max)());
    m_origin.assign(2 * length.size(), -1);
    queue.push(Item(0, start));
    for(bool first = true; !queue.empty(); first = false)
    {
      const Item item = queue.top();
      queue.pop();
      const int state = item.second;
      const Motorcycle_complex::Arc& a = m_complex.arcs[state / 2];
      const int p = a.patch[state % 2], side = a.side[state % 2];
      if(!first && (state == target || p == -1))
        return state;
      if(!first && item.first > m_distance[state])
        continue;
      const Motorcycle_complex::Patch& patch = m_complex.patches[p];
      const double crossing = edge_cost * (side % 2 == 0 ? patch.height : patch.width);
      for(const Motorcycle_complex::Piece& s : patch.sides[(side + 2) % 4])
      {
        if(forbidden[s.arc])
          continue;
        const double d = item.first + crossing + (std::max)(Layout_weights::least_arc, price(s.arc, by));
        // the rectangle lies on the left of the arc if the side runs along it
        const int next = 2 * s.arc + (s.forward ? 1 : 0);
        if(d < m_distance[next])
        {
          m_distance[next] = d;
          m_origin[next] = state;
          queue.push(Item(d, next));
        }
      }
    }
    return -1;
  }

  // Whether the vertices that become one may do so, and vertices - edges + faces: walls that close up around a
  // handle merge nothing but change that.
  struct Check
  {
    bool is_allowed = true;
    int euler_characteristic = 0;
  };

  Check check() const
  {
    Arc_subdivision s = subdivision(length);
    Check result;
    for(int e = 0; e < s.number_of_edges(); ++e)
      result.euler_characteristic -= s.edges.smallest(e) == e;
    for(int p = 0; p < s.number_of_points(); ++p)
      result.euler_characteristic += s.points.smallest(p) == p;
    // a component that becomes a circle is gone, too
    std::vector<char> is_left(m_component.size(), 0);
    for(std::size_t p = 0; p < m_complex.patches.size(); ++p)
    {
      const Motorcycle_complex::Patch& patch = m_complex.patches[p];
      if(s.side_length(patch.sides[0]) > 0 && s.side_length(patch.sides[1]) > 0)
      {
        ++result.euler_characteristic;
        is_left[m_component[p]] = 1;
      }
    }
    for(int c : m_component)
      result.is_allowed = result.is_allowed && is_left[c];

    // what becomes one; an edge of a feature that vanishes merges two vertices of the same feature
    struct Group
    {
      int special = 0, irregular_inside = 0, features = 0, borders = 0;
    };
    std::vector<Group> groups(s.number_of_points());
    for(std::size_t i = 0; i < m_vertex_of_node.size(); ++i)
    {
      const int v = m_vertex_of_node[i];
      Group& g = groups[s.points.smallest(static_cast<int>(i))];
      g.special += m_rules.is_special[v];
      g.irregular_inside += m_rules.is_irregular[v] && !m_rules.on_feature[v] && !m_rules.on_border[v];
      g.features += m_rules.on_feature[v];
      g.borders += m_rules.on_border[v];
    }
    for(std::size_t a = 0; a < length.size(); ++a)
    {
      const Motorcycle_complex::Arc& x = m_complex.arcs[a];
      if(!x.is_feature && !x.is_border)
        continue;
      for(int i = 1; i < length[a]; ++i)
      {
        Group& g = groups[s.points.smallest(s.point(static_cast<int>(a), i))];
        g.features += x.is_feature;
        g.borders += x.is_border;
      }
      if(length[a] == 0)
      {
        Group& g = groups[s.points.smallest(s.point(static_cast<int>(a), 0))];
        g.features -= x.is_feature;
        g.borders -= x.is_border;
      }
    }
    result.is_allowed =
      result.is_allowed && std::all_of(groups.begin(), groups.end(),
                                       [](const Group& g)
                                       {
                                         return g.special <= 1 && g.features <= 1 && g.borders <= 1 &&
                                                (g.features == 0 || g.borders == 0 || g.special == 1) &&
                                                (g.irregular_inside == 0 || (g.features == 0 && g.borders == 0));
                                       });
    return result;
  }

  const Motorcycle_complex& m_complex;
  Quad_vertex_rules m_rules;
  std::vector<int> m_node_number, m_vertex_of_node;
  std::vector<int> m_component; // per patch: the first one of its connected component
  int m_euler_characteristic = 0;
  std::vector<double> m_distance; // of the last search, per state
  std::vector<int> m_origin;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_LAYOUT_QUANTIZATION_H
