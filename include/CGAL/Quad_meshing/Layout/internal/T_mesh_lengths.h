// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_T_MESH_LENGTHS_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_T_MESH_LENGTHS_H

#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Integer lengths of the arcs of a T-mesh, such that opposite sides of every patch are equally long.
//
// They change along dual walks: if one arc becomes longer by one, then in the patches at its sides either an arc of
// the opposite side becomes longer too, or another one of the same side shorter, and so on until the walk is closed
// or leaves the surface over the border. This is a flow on a bidirected graph, whose nodes are the two pairs of
// sides of each patch and whose edges are the arcs (Heistermann, Warnett and Bommes, "Min-deviation-flow in bi-
// directed graphs for T-mesh quantization", 2023). The walks found are cheapest ones for the energy below; where a
// walk comes back to an arc it may be none, so this is a local search. Longer arcs are always possible: the real
// lengths are a sum of walks on which nothing becomes shorter.
class T_mesh_lengths
{
public:
  // The lengths, per arc; they must be consistent. Those in `at_least` are bounds from below.
  T_mesh_lengths(const T_mesh& t, std::vector<int>& length, const std::vector<int>& at_least)
    : m_t(t), m_length(length), m_at_least(at_least), m_side(2 * t.arcs.size(), -1), m_extent(t.patches.size())
  {
    for(std::size_t p = 0; p < t.patches.size(); ++p)
      for(int k = 0; k < 4; ++k)
      {
        for(int d : t.patches[p].sides[k])
          m_side[d] = k;
        if(k < 2)
          m_extent[p][k] = t.length(static_cast<int>(p), k);
      }
    m_sum.resize(t.patches.size());
    for(std::size_t p = 0; p < t.patches.size(); ++p)
      for(int k = 0; k < 2; ++k)
      {
        m_sum[p][k] = 0;
        for(int d : t.patches[p].sides[k])
          m_sum[p][k] += length[d / 2];
      }
    m_cost.assign(4 * t.arcs.size(), -1.);
    m_from.assign(4 * t.arcs.size(), -1);
    m_is_open.assign(2 * t.arcs.size(), 1);
    m_readers.resize(t.patches.size());
    m_last_reader.assign(t.patches.size(), -1);
  }

  // Sum over all patches of the Dirichlet energy of the differences between the lengths and the real ones.
  double energy() const
  {
    double sum = 0;
    for(std::size_t p = 0; p < m_extent.size(); ++p)
      for(int k = 0; k < 2; ++k)
        sum += stiffness(static_cast<int>(p), k) * square(m_sum[p][k] - m_extent[p][k]);
    return sum;
  }

  // Lengthens arcs until all bounds hold. Returns false if a walk is missing: then the T-mesh is none.
  bool satisfy_bounds()
  {
    std::vector<int> order;
    for(std::size_t a = 0; a < m_length.size(); ++a)
      if(m_length[a] < m_at_least[a])
        order.push_back(static_cast<int>(a));
    std::stable_sort(order.begin(), order.end(),
                     [this](int a, int b) { return m_t.arcs[a].length > m_t.arcs[b].length; });
    for(int a : order)
      while(m_length[a] < m_at_least[a])
        if(!change(a, 1, Rule::ANY) && !change(a, 1, Rule::ONLY_LONGER))
          return false;
    return true;
  }

  // Takes walks that lessen the energy until none is found. Where a search has found none, another one is no use before
  // a patch changes that it has seen.
  void improve()
  {
    std::fill(m_is_open.begin(), m_is_open.end(), 1); // bounds may have changed
    bool is_better = true;
    for(int sweep = 0; is_better && sweep < most_sweeps; ++sweep)
    {
      is_better = false;
      for(int first = 0; first < static_cast<int>(m_is_open.size()); ++first)
        while(m_is_open[first])
        {
          m_is_open[first] = 0;
          m_reader = first;
          if(change(first / 2, sign(first), Rule::IF_BETTER))
            m_is_open[first] = is_better = true;
          m_reader = -1;
        }
    }
  }

private:
  enum class Rule
  {
    ANY,         // no bound may be broken that holds
    ONLY_LONGER, // nothing becomes shorter
    IF_BETTER    // and the energy falls
  };

  struct Walk
  {
    std::vector<std::pair<int, int>> arcs; // each with what it changes by, 1 or -1
  };

  static constexpr int most_sweeps = 50; // each lessens the energy; far more than it takes

  const T_mesh& m_t;
  std::vector<int>& m_length;
  const std::vector<int>& m_at_least;
  std::vector<int> m_side;                     // per direction: of the patch on its left
  std::vector<std::array<double, 2>> m_extent; // per patch: real lengths of sides 0 and 1
  std::vector<std::array<int, 2>> m_sum;       // their integer lengths
  // Per state, 2 * direction + (1 if its arc becomes shorter): the arc is changed, and the patch on the left of the
  // direction has to follow.
  std::vector<double> m_cost; // of the cheapest walk to it; -1: none is known
  std::vector<int> m_from;    // the state before it
  std::vector<int> m_touched; // states with a cost
  // Per change that a walk may begin with, 2 * arc + (1 if it becomes shorter): whether to look for a walk.
  std::vector<char> m_is_open;
  std::vector<std::vector<int>> m_readers; // per patch: changes with which no walk began when it was as it is
  std::vector<int> m_last_reader;          // per patch
  int m_reader = -1;                       // the one that is tried; -1: none

  // A patch much longer than wide feels a change of its width all along.
  double stiffness(int p, int k) const
  {
    const double thinnest = 0.25; // in quad edges: what is thinner has to give way anyway
    return (std::max)(thinnest, m_extent[p][1 - k]) / (std::max)(thinnest, m_extent[p][k]);
  }

  double change_of_energy(int p, int k, int s) const
  {
    const double d = m_sum[p][k] - m_extent[p][k];
    return stiffness(p, k) * (2 * s * d + 1);
  }

  bool may_change(int arc, int s, Rule rule) const
  {
    return s > 0 || (rule != Rule::ONLY_LONGER && m_length[arc] - 1 >= m_at_least[arc]);
  }

  static int sign(int state) { return state & 1 ? -1 : 1; }

  // What is found depends on this patch.
  void read(int p)
  {
    if(m_reader == -1 || m_last_reader[p] == m_reader)
      return;
    m_last_reader[p] = m_reader;
    m_readers[p].push_back(m_reader);
  }

  void touch(int p)
  {
    for(int first : m_readers[p])
      m_is_open[first] = 1;
    m_readers[p].clear();
    m_last_reader[p] = -1;
  }
  static int state(int direction, int s) { return 2 * direction + (s < 0); }

  bool change(int arc, int s, Rule rule)
  {
    for(int p : m_t.arcs[arc].patch)
      if(p != -1)
        read(p);
    if(!may_change(arc, s, rule))
      return false;
    double limit = (std::numeric_limits<double>::infinity)();
    if(rule == Rule::IF_BETTER)
    {
      // Only walks that begin with a gain, and that cost no more than twice of it elsewhere: others gain there, too.
      double gain = 0;
      for(int d : { 2 * arc, 2 * arc + 1 })
        if(m_t.arcs[arc].patch[d & 1] != -1)
          gain = (std::max)(gain, -change_of_energy(m_t.arcs[arc].patch[d & 1], m_side[d] & 1, s));
      if(gain <= 0)
        return false;
      limit = 2 * gain;
    }
    Walk walk;
    if(!find(arc, s, rule, limit, walk))
      return false;
    return apply(walk, rule);
  }

  // The cheapest closed walk, or one from border to border, over an arc.
  bool find(int arc, int s, Rule rule, double limit, Walk& walk)
  {
    const int left = 2 * arc, right = 2 * arc + 1;
    int end[2] = { -1, -1 };
    double to_border[2] = { 0, 0 };
    bool is_closed = false;
    for(int d : { left, right })
    {
      if(m_t.arcs[arc].patch[d & 1] == -1)
        continue; // nothing to follow on this side
      double closed = 0;
      search(state(d, s), rule, limit, end[d & 1], to_border[d & 1], closed);
      if(d == left && closed >= 0 && m_t.arcs[arc].patch[1] != -1)
      {
        // against two ways to the border
        std::vector<std::pair<int, int>> around;
        trace(state(left, s), m_from[state(left, s)], around);
        const int first_end = end[0];
        Walk first;
        if(first_end != -1)
          trace(state(left, s), first_end, first.arcs);
        double other = -1, ignored = 0;
        clear();
        search(state(right, s), rule, limit, end[1], other, ignored);
        is_closed = first_end == -1 || end[1] == -1 || closed <= to_border[0] + other;
        if(is_closed)
          walk.arcs = around;
        else
        {
          walk.arcs = first.arcs;
          trace(state(right, s), end[1], walk.arcs);
        }
        clear();
        break;
      }
      if(end[d & 1] == -1)
      {
        clear();
        return false;
      }
      trace(state(d, s), end[d & 1], walk.arcs);
      clear();
    }
    walk.arcs.emplace_back(arc, s);
    return true;
  }

  void clear()
  {
    for(int i : m_touched)
      m_cost[i] = -1;
    m_touched.clear();
  }

  // Dijkstra's algorithm. `end`: a state behind which there is no patch; `closed`: the cost of a way back to the start,
  // whose last but one state is then m_from[start]; -1 if there is none.
  void search(int start, Rule rule, double limit, int& end, double& to_border, double& closed)
  {
    typedef std::pair<double, int> Key;
    std::priority_queue<Key, std::vector<Key>, std::greater<Key>> front;
    end = -1;
    closed = -1;
    m_from[start] = -1;
    front.emplace(0., start);
    m_cost[start] = 0;
    m_touched.push_back(start);
    while(!front.empty())
    {
      const double cost = front.top().first;
      const int i = front.top().second;
      front.pop();
      if(cost > m_cost[i] && !(i == start && cost > 0))
        continue;
      if(i == start && cost > 0)
      {
        closed = cost;
        return; // nothing cheaper is left, but for ways to the border, which have been found then
      }
      const int d = i / 2, s = sign(i), p = m_t.arcs[d / 2].patch[d & 1];
      if(p == -1)
      {
        if(end == -1)
        {
          end = i;
          to_border = cost;
        }
        if(m_t.arcs[start / 4].patch[1 - ((start / 2) & 1)] == -1)
          return; // the arc lies on the border: there is no way round
        continue;
      }
      read(p);
      const int k = m_side[d];
      const double least = 1e-3; // so that of two walks as good the shorter one is taken
      const double shear = 0.25; // times the stiffness: what it costs to move a side along itself; a choice
      for(int opposite : { 0, 2 })
      {
        if(opposite == 0 && rule == Rule::ONLY_LONGER)
          continue;
        const double step = opposite == 0 ? shear * stiffness(p, k & 1) : change_of_energy(p, k & 1, s);
        const int change = opposite == 0 ? -s : s;
        const double sum = cost + (std::max)(least, step);
        if(sum > limit)
          continue;
        for(int e : m_t.patches[p].sides[(k + opposite) & 3])
        {
          const int j = state(e ^ 1, change);
          if(e == d || !may_change(e / 2, change, rule))
            continue;
          if(j == start)
          {
            if(closed < 0 || sum < closed)
            {
              closed = sum;
              m_from[start] = i;
              front.emplace(sum, start);
            }
            continue;
          }
          if(m_cost[j] >= 0 && m_cost[j] <= sum)
            continue;
          if(m_cost[j] < 0)
            m_touched.push_back(j);
          m_cost[j] = sum;
          m_from[j] = i;
          front.emplace(sum, j);
        }
      }
    }
  }

  // The changes from the start, exclusively, to a state.
  void trace(int start, int i, std::vector<std::pair<int, int>>& arcs) const
  {
    for(; i != -1 && i != start; i = m_from[i])
      arcs.emplace_back(i / 4, sign(i));
  }

  bool apply(const Walk& walk, Rule rule)
  {
    const double before = rule == Rule::IF_BETTER ? energy_around(walk) : 0;
    add(walk, 1);
    bool is_allowed = true;
    for(const auto& a : walk.arcs)
      is_allowed = is_allowed && (m_length[a.first] >= m_at_least[a.first] || a.second > 0);
    if(is_allowed && rule == Rule::IF_BETTER)
    {
      const double smallest_gain = 1e-9; // beyond rounding errors
      is_allowed = energy_around(walk) < before - smallest_gain;
    }
    if(!is_allowed)
    {
      add(walk, -1);
      return false;
    }
    for(const auto& a : walk.arcs)
      for(int p : m_t.arcs[a.first].patch)
        if(p != -1)
          touch(p);
    return true;
  }

  void add(const Walk& walk, int times)
  {
    for(const auto& a : walk.arcs)
    {
      m_length[a.first] += times * a.second;
      for(int d : { 2 * a.first, 2 * a.first + 1 })
      {
        const int p = m_t.arcs[a.first].patch[d & 1];
        if(p != -1 && m_side[d] < 2)
          m_sum[p][m_side[d]] += times * a.second;
      }
    }
  }

  // Of the patches that a walk passes.
  double energy_around(const Walk& walk) const
  {
    std::vector<int> patches;
    for(const auto& a : walk.arcs)
      for(int p : m_t.arcs[a.first].patch)
        if(p != -1)
          patches.push_back(p);
    std::sort(patches.begin(), patches.end());
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    double sum = 0;
    for(int p : patches)
      for(int k = 0; k < 2; ++k)
        sum += stiffness(p, k) * square(m_sum[p][k] - m_extent[p][k]);
    return sum;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_T_MESH_LENGTHS_H
