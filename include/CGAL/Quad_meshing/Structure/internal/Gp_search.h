// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_SEARCH_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_SEARCH_H

#include <CGAL/Quad_meshing/Structure/internal/Gp_path.h>
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

// Checks, step by step, whether a path can be executed: no edge is crossed twice, no face is passed
// twice but in the ways that are compatible, and no vertices become one that must not.
class Gp_legality
{
public:
  // What is wrong with a path: the step `at` collides with what the steps up to `earlier` do, or is a
  // collapse that merges what must not be merged (`earlier` is -1).
  struct Conflict
  {
    int at = -1;
    int earlier = -1;
    explicit operator bool() const { return at != -1; }
  };

  Gp_legality(const Indexed_quad_mesh& mesh, const Quad_vertex_rules& vertex_rules)
    : m_mesh(mesh)
    , m_rules(vertex_rules)
    , m_crossed_at(mesh.number_of_halfedges(), -1)
    , m_passages(mesh.number_of_faces())
    , m_parent(mesh.number_of_vertices(), -1)
    , m_group(mesh.number_of_vertices())
  {
  }

  // The first conflict of a closed path.
  Conflict check(const Gp_path& path)
  {
    Conflict conflict;
    const int n = static_cast<int>(path.size());
    for(int i = 0; i < n && !conflict; ++i)
    {
      const Gp_step& s = path[i];
      if(m_crossed_at[s.edge()] != -1)
        conflict = Conflict{ i, m_crossed_at[s.edge()] };
      else
      {
        m_crossed_at[s.edge()] = i;
        if(i > 0 && path[i - 1].in != -1)
          conflict = pass(path[i - 1], s, i);
        if(!conflict && s.kind == gp_collapse && !merge(s))
          conflict = Conflict{ i, -1 };
      }
    }
    if(!conflict && n > 0 && path[n - 1].in != -1)
    {
      conflict = pass(path[n - 1], path[0], n);
      if(conflict)
        conflict.at = n - 1;
    }
    reset(path);
    return conflict;
  }

  // Whether a single collapse merges vertices that may become one.
  bool may_collapse(const Gp_step& s)
  {
    const bool allowed = merge(s);
    m_parent[s.left(m_mesh)] = m_parent[s.right(m_mesh)] = -1;
    return allowed;
  }

private:
  struct Passages
  {
    Gp_passage kind[2] = { gp_not_visited, gp_not_visited };
    int side[2], at[2];
  };

  // The face between two steps; `at` is the number of the later one.
  Conflict pass(const Gp_step& enter, const Gp_step& leave, int at)
  {
    Passages& p = m_passages[enter.in / 4];
    const Gp_passage kind = gp_passage(enter, leave);
    const int slot = p.kind[0] == gp_not_visited ? 0 : 1;
    if(slot == 1 && (p.kind[1] != gp_not_visited || !gp_passages_are_compatible(p.kind[0], p.side[0], kind, enter.in)))
      return Conflict{ at, p.at[0] };
    p.kind[slot] = kind;
    p.side[slot] = enter.in;
    p.at[slot] = at;
    return Conflict();
  }

  struct Group
  {
    int special, irregular_inside, features, borders;
  };

  int find(int v)
  {
    if(m_parent[v] == -1)
    {
      m_parent[v] = v;
      const bool on_curve = m_rules.on_feature[v] || m_rules.on_border[v];
      m_group[v] = Group{ m_rules.is_special[v], m_rules.is_irregular[v] && !on_curve, m_rules.on_feature[v],
                          m_rules.on_border[v] };
    }
    while(m_parent[v] != v)
      v = m_parent[v] = m_parent[m_parent[v]];
    return v;
  }

  bool merge(const Gp_step& s)
  {
    const int a = find(s.left(m_mesh)), b = find(s.right(m_mesh));
    if(a == b)
      return true;
    const int h = s.edge();
    const bool border = m_mesh.is_border(h), feature = m_mesh.is_feature[h] && !border;
    m_parent[b] = a;
    Group& g = m_group[a];
    g.special += m_group[b].special;
    g.irregular_inside += m_group[b].irregular_inside;
    // a feature and the border that meet in a corner are told apart by the corner
    g.features += m_group[b].features - (feature ? 1 : 0);
    g.borders += m_group[b].borders - (border ? 1 : 0);
    return g.special <= 1 && g.features <= 1 && g.borders <= 1 &&
           (g.features == 0 || g.borders == 0 || g.special == 1) &&
           (g.irregular_inside == 0 || (g.features == 0 && g.borders == 0));
  }

  void reset(const Gp_path& path)
  {
    for(const Gp_step& s : path)
    {
      m_crossed_at[s.edge()] = -1;
      if(s.in != -1)
        m_passages[s.in / 4] = Passages();
      m_parent[s.left(m_mesh)] = m_parent[s.right(m_mesh)] = -1;
    }
  }

  const Indexed_quad_mesh& m_mesh;
  const Quad_vertex_rules& m_rules;
  std::vector<int> m_crossed_at;    // per edge: the step that crosses it
  std::vector<Passages> m_passages; // per face
  std::vector<int> m_parent;        // per vertex: union-find of the merged ones, -1 if untouched
  std::vector<Group> m_group;       // per root of the union-find
};

// Searches closed paths in the graph of states (thesis, section 10.1).
class Gp_search
{
public:
  // Number of repairs of an illegal path before the search gives up.
  static constexpr int repairs = 60;

  Gp_search(const Indexed_quad_mesh& mesh, const Quad_vertex_rules& vertex_rules)
    : m_mesh(mesh)
    , m_legality(mesh, vertex_rules)
    , m_forbidden(4 * mesh.number_of_halfedges(), 0)
    , m_blocked(4 * mesh.number_of_halfedges(), 0)
    , m_reached(4 * mesh.number_of_halfedges(), 0)
    , m_origin(4 * mesh.number_of_halfedges())
  {
    const int n = m_mesh.number_of_halfedges();
    for(int h = 0; h < n; ++h)
    {
      if(m_mesh.is_feature[h] || m_mesh.is_border(h))
        m_forbidden[3 * h + gp_shift_left] = m_forbidden[3 * h + gp_shift_right] = 1;
      if(!m_legality.may_collapse(gp_step(m_mesh, 3 * h + gp_collapse)))
        m_forbidden[3 * h + gp_collapse] = m_forbidden[3 * n + h] = 1;
      if(m_mesh.is_border(h))
        m_entries.push_back(h);
      else
        m_forbidden[3 * n + h] = 1;
    }
  }

  // Takes a state out of the graph for good.
  void forbid(int state) { m_forbidden[state] = 1; }
  bool is_forbidden(int state) const { return m_forbidden[state] != 0; }

  // Extends an open path, given as states each of which may follow the one before, to a closed one
  // that can be executed; empty if none is found. Without `cost`, the number of steps is kept small,
  // with it the sum of cost(state), which must be positive.
  Gp_path close(const std::vector<int>& given, const std::function<double(int)>& cost = std::function<double(int)>())
  {
    for(int s : given)
      if(m_forbidden[s])
        return Gp_path();

    std::vector<int> fixed = given, removed;
    Gp_path path;
    for(int attempt = 0; attempt < repairs; ++attempt)
    {
      block(fixed, removed);
      std::vector<int> states = fixed;
      const bool found = cost ? cheapest(states, cost) : shortest(states);
      unblock();
      if(!found)
        return Gp_path();
      path.clear();
      for(int s : states)
        path.push_back(gp_step(m_mesh, s));
      const Gp_legality::Conflict conflict = m_legality.check(path);
      if(!conflict)
        return path;
      if(conflict.earlier == -1)
      {
        // the collapse that merges too much does not come back; the path from the given one is free
        if(conflict.at < static_cast<int>(given.size()))
          return Gp_path();
        removed.push_back(states[conflict.at]);
        if(conflict.at < static_cast<int>(fixed.size()))
          fixed = given;
      }
      else
      {
        // what came first stays, with all that it excludes
        const std::size_t keep = conflict.earlier + 1;
        if(keep <= fixed.size())
          return Gp_path();
        fixed.assign(states.begin(), states.begin() + keep);
      }
    }
    return Gp_path();
  }

private:
  // Removes what cannot be part of a path that begins with the given states: a second way over an
  // edge that they cross, a way into a face that they pass unless it leads straight through and is
  // compatible, and any way out of the face that the path must come back to.
  void block(const std::vector<int>& fixed, const std::vector<int>& removed)
  {
    for(int s : removed)
      set_blocked(s);
    for(std::size_t i = 0; i < fixed.size(); ++i)
    {
      const Gp_step s = gp_step(m_mesh, fixed[i]);
      for(int h : { s.out, s.in })
        if(h != -1)
          block_edge(h, -1);
      if(i == 0)
        continue;
      const Gp_step before = gp_step(m_mesh, fixed[i - 1]);
      if(before.in == -1)
        continue;
      const Gp_passage passage = gp_passage(before, s);
      if(passage == gp_turn)
        for(int h : { m_mesh.next(before.in), m_mesh.prev(before.in), m_mesh.across(before.in), before.in })
          block_edge(h, -1);
      else if(passage == gp_straight_shift)
        for(int h : { m_mesh.next(before.in), m_mesh.prev(before.in) })
          block_edge(h, gp_collapse);
    }
    const int start = fixed.front();
    const Gp_step first = gp_step(m_mesh, start);
    if(first.out != -1)
    {
      const int base = 4 * (first.out / 4);
      for(int h = base; h < base + 4; ++h)
        for(int kind = 0; kind < 3; ++kind)
          set_blocked(3 * h + kind);
    }
    m_target = start;
  }

  // Removes the ways over an edge, but for one kind.
  void block_edge(int h, int but)
  {
    for(int side : { h, m_mesh.opposite[h] })
      if(side != -1)
      {
        for(int kind = 0; kind < 3; ++kind)
          if(kind != but)
            set_blocked(3 * side + kind);
        if(but != gp_collapse)
          set_blocked(3 * m_mesh.number_of_halfedges() + side);
      }
  }

  void set_blocked(int s)
  {
    if(!m_blocked[s])
    {
      m_blocked[s] = 1;
      m_blocked_states.push_back(s);
    }
  }

  void unblock()
  {
    for(int s : m_blocked_states)
      m_blocked[s] = 0;
    m_blocked_states.clear();
  }

  bool is_open(int s) const { return s == m_target || !(m_blocked[s] || m_forbidden[s]); }

  // Calls f for the states that may follow one.
  template <typename Function>
  void for_each_successor(int state, const Function& f) const
  {
    const Gp_step s = gp_step(m_mesh, state);
    if(s.in == -1)
      for(int h : m_entries)
        f(3 * m_mesh.number_of_halfedges() + h);
    else
      for_each_next_gp_state(s, f);
  }

  bool append_way(std::vector<int>& states, int last)
  {
    std::vector<int> way;
    for(int s = last; s != states.back(); s = m_origin[s])
      way.push_back(s);
    states.insert(states.end(), way.rbegin(), way.rend());
    return true;
  }

  bool leads_to_target(int state) const
  {
    bool found = false;
    for_each_successor(state, [&](int next) { found = found || next == m_target; });
    return found;
  }

  // Appends a way with as few steps as possible from the last state to one before the first.
  bool shortest(std::vector<int>& states)
  {
    ++m_round;
    std::vector<int> front(1, states.back());
    m_reached[states.back()] = m_round;
    bool outside_done = false;
    for(std::size_t i = 0; i < front.size(); ++i)
    {
      const int state = front[i];
      if(leads_to_target(state))
        return append_way(states, state);
      if(gp_step(m_mesh, state).in == -1)
      {
        if(outside_done)
          continue;
        outside_done = true;
      }
      for_each_successor(state,
                         [&](int next)
                         {
                           if(is_open(next) && m_reached[next] != m_round)
                           {
                             m_reached[next] = m_round;
                             m_origin[next] = state;
                             front.push_back(next);
                           }
                         });
    }
    return false;
  }

  bool cheapest(std::vector<int>& states, const std::function<double(int)>& cost)
  {
    ++m_round;
    typedef std::pair<double, int> Item;
    std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
    std::vector<double> distance(4 * m_mesh.number_of_halfedges(), (std::numeric_limits<double>::max)());
    distance[states.back()] = 0;
    queue.push(Item(0, states.back()));
    while(!queue.empty())
    {
      const Item item = queue.top();
      queue.pop();
      const int state = item.second;
      if(m_reached[state] == m_round)
        continue;
      m_reached[state] = m_round;
      if(leads_to_target(state))
        return append_way(states, state);
      for_each_successor(state,
                         [&](int next)
                         {
                           if(!is_open(next))
                             return;
                           const double d = item.first + cost(next);
                           if(d < distance[next])
                           {
                             distance[next] = d;
                             m_origin[next] = state;
                             queue.push(Item(d, next));
                           }
                         });
    }
    return false;
  }

  const Indexed_quad_mesh& m_mesh;
  Gp_legality m_legality;
  std::vector<char> m_forbidden, m_blocked; // per state: out of the graph for good, for one search
  std::vector<int> m_blocked_states;
  std::vector<int> m_reached, m_origin; // per state: the search that reached it, from where
  std::vector<int> m_entries;           // border halfedges
  int m_round = 0, m_target = -1;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_SEARCH_H
