// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_HELIX_DETECTION_H
#define CGAL_QUAD_MESHING_INTERNAL_HELIX_DETECTION_H

#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A q-helix (thesis, section 10.2): on the directed dual line `line`, from position `start` on,
// `length` dual edges for which walking `turn_length` steps ahead is the same as |pitch| steps to
// the left (pitch > 0) or to the right (pitch < 0). There is a consistent frame along a helix, so none of its turns
// crosses itself.
struct Helix_record
{
  int line;
  int start;
  int pitch;
  int turn_length;
  int length;
  int number_of_relations; // dual edges that have their equivalent one turn ahead
  bool is_whole_line;      // goes around a closed line
};

// The sideways relations of all directed dual edges, in time linear in their number: s and t are on
// one line, t is `sidesteps` steps to the left of s and the first one of their line there, and lies
// `offset` positions ahead of s (the shorter way on a closed line).
struct Side_relation
{
  int target = -1;
  int sidesteps = 0;
  int offset = 0;
};

inline std::vector<Side_relation> side_relations(const Indexed_quad_mesh& m, const Dual_lines& lines)
{
  const int nh = m.number_of_halfedges(), nl = lines.number_of_lines();
  std::vector<Side_relation> relation(nh);
  auto relate = [&](int s, int t, int sidesteps)
  {
    const int l = lines.line[s], n = lines.length[l];
    int d = lines.position[t] - lines.position[s];
    if(lines.is_closed[l])
    {
      d = (d % n + n) % n;
      d = 2 * d <= n ? d : d - n;
    }
    relation[s] = Side_relation{ t, sidesteps, d };
  };

  // Steps to the left of s are steps along the line of next(s). Walking along such a line, remember
  // where each line was crossed last; `stamp` tells what was remembered during this walk.
  std::vector<int> stamp(nl, -1), first_crossing(nl), last_crossing(nl), first_at(nl), last_at(nl), crossed;
  for(int side = 0; side < nl; ++side)
  {
    crossed.clear();
    int q = lines.first[side];
    for(int p = 0; p < lines.length[side]; ++p, q = m.forward(q))
    {
      const int s = m.prev(q), l = lines.line[s];
      if(!lines.is_representative(l))
        continue;
      if(stamp[l] != side)
      {
        stamp[l] = side;
        first_crossing[l] = s;
        first_at[l] = p;
        crossed.push_back(l);
      }
      else
        relate(last_crossing[l], s, p - last_at[l]);
      last_crossing[l] = s;
      last_at[l] = p;
    }
    if(lines.is_closed[side])
      for(int l : crossed)
        if(first_at[l] != last_at[l])
          relate(last_crossing[l], first_crossing[l], lines.length[side] - last_at[l] + first_at[l]);
  }
  return relation;
}

// Smallest value inserted at or behind a position.
class Suffix_minimum
{
  std::vector<int> m_tree;

public:
  explicit Suffix_minimum(int n) : m_tree(n + 1, (std::numeric_limits<int>::max)()) {}

  void insert(int i, int value)
  {
    for(int k = static_cast<int>(m_tree.size()) - 1 - i; k < static_cast<int>(m_tree.size()); k += k & -k)
      m_tree[k] = (std::min)(m_tree[k], value);
  }

  int from(int i) const
  {
    int smallest = (std::numeric_limits<int>::max)();
    for(int k = static_cast<int>(m_tree.size()) - 1 - i; k > 0; k -= k & -k)
      smallest = (std::min)(smallest, m_tree[k]);
    return smallest;
  }
};

// Drops every helix on whose path a turn of a helix with smaller pitch lies. All are on one line.
inline void keep_minimal_helices(std::vector<Helix_record>& helices, int line_length, bool closed)
{
  if(helices.size() < 2)
    return;
  std::stable_sort(helices.begin(), helices.end(),
                   [](const Helix_record& a, const Helix_record& b) { return std::abs(a.pitch) < std::abs(b.pitch); });
  if(std::abs(helices.front().pitch) == std::abs(helices.back().pitch))
    return;

  // the ends of the turns that start at each position; on a closed line the positions of two rounds
  const int rounds = closed ? 2 : 1, largest = rounds * line_length;
  Suffix_minimum turn_end(largest);
  std::vector<Helix_record> kept;
  for(std::size_t i = 0, j; i < helices.size(); i = j)
  {
    const int pitch = std::abs(helices[i].pitch);
    for(j = i; j < helices.size() && std::abs(helices[j].pitch) == pitch; ++j)
    {
      const Helix_record& a = helices[j];
      const bool any_smaller = i > 0;
      const bool hit =
        a.is_whole_line ? any_smaller : turn_end.from(a.start) <= a.start + a.number_of_relations - 1 + a.turn_length;
      if(!hit)
        kept.push_back(a);
    }
    for(std::size_t k = i; k < j; ++k)
      for(int p = helices[k].start; p < helices[k].start + helices[k].number_of_relations; ++p)
        for(int q = closed ? p % line_length : p; q < largest; q += line_length)
          turn_end.insert(q, q + helices[k].turn_length);
  }
  helices.swap(kept);
}

// Per position p of a line: the first position at which the line crosses a quad that it has crossed before, but not
// before p. Positions go on behind the length of a closed line, which is walked twice.
inline std::vector<int> first_self_crossings(const Indexed_quad_mesh& m, const Dual_lines& lines, int line)
{
  constexpr int never = (std::numeric_limits<int>::max)();
  const int n = lines.length[line], rounds = lines.is_closed[line] ? 2 : 1;
  std::vector<int> result(rounds * n, never);
  for(int p = 0, h = lines.first[line]; p < n; ++p, h = m.forward(h))
    for(int g : { m.next(h), m.prev(h) })
      if(lines.line[g] == line)
      {
        const int other = lines.position[g];
        if(other > p)
          result[p] = other;
        else if(rounds == 2)
          result[p] = other + n;
        if(rounds == 2)
          result[p + n] = result[p] + n;
      }
  for(int p = rounds * n - 1; p-- > 0;)
    result[p] = (std::min)(result[p], result[p + 1]);
  return result;
}

// All minimal q-helices, line by line. `relation` is the result of `side_relations()`. No turn of a helix crosses
// itself, unless `may_cross_itself`.
inline std::vector<Helix_record> minimal_helices(const Indexed_quad_mesh& m, const Dual_lines& lines,
                                                 const std::vector<Side_relation>& relation,
                                                 bool may_cross_itself = false)
{
  const int nh = m.number_of_halfedges();
  const std::vector<char> inner_regular = inner_regular_vertices(m);

  // number of vertices along each line that are not inner regular, before each of its positions:
  // the source of q, on its line, lies left of the head of the dual edge prev(q)
  std::vector<int> bad_before(nh);
  for(int l = 0; l < lines.number_of_lines(); ++l)
    for(int p = 0, q = lines.first[l], sum = 0; p < lines.length[l]; ++p, q = m.forward(q))
    {
      bad_before[q] = sum;
      sum += !inner_regular[m.source(q)];
    }
  std::vector<int> bad_on_line(lines.number_of_lines());
  for(int l = 0; l < lines.number_of_lines(); ++l)
    for(int p = 0, q = lines.first[l]; p < lines.length[l]; ++p, q = m.forward(q))
      bad_on_line[l] = bad_before[q] + !inner_regular[m.source(q)];
  // whether the way from s, its sidesteps to the left, passes only inner regular vertices ahead
  auto is_clear = [&](int s)
  {
    const int q = m.next(s), t = m.next(relation[s].target);
    int bad = bad_before[t] - bad_before[q];
    if(lines.position[t] <= lines.position[q])
      bad += bad_on_line[lines.line[q]];
    return bad == 0;
  };
  std::vector<int> self_crossing; // of the line that is searched
  auto is_helical = [&](int s)
  {
    const Side_relation& r = relation[s];
    if(r.target == -1 || r.sidesteps > std::abs(r.offset))
      return false;
    const int start = lines.position[r.offset > 0 ? s : r.target];
    return may_cross_itself || self_crossing[start] > start + std::abs(r.offset);
  };
  // a dual edge and the one ahead belong to one helix
  auto is_linked = [&](int s, int t)
  {
    return t != -1 && is_helical(s) && is_helical(t) && relation[s].sidesteps == relation[t].sidesteps &&
           relation[s].offset == relation[t].offset && is_clear(s);
  };

  std::vector<Helix_record> all, on_line;
  for(int l = 0; l < lines.number_of_lines(); ++l)
  {
    if(!lines.is_representative(l))
      continue;
    const int n = lines.length[l];
    const bool closed = lines.is_closed[l];
    on_line.clear();
    if(!may_cross_itself)
      self_crossing = first_self_crossings(m, lines, l);

    // runs of linked dual edges begin where the link from behind is missing
    std::vector<int> edges(n);
    for(int p = 0, s = lines.first[l]; p < n; ++p, s = m.forward(s))
      edges[p] = s;
    std::vector<char> linked_ahead(n);
    bool all_linked = closed;
    for(int p = 0; p < n; ++p)
    {
      linked_ahead[p] = is_linked(edges[p], p + 1 < n ? edges[p + 1] : closed ? edges[0] : -1);
      all_linked = all_linked && linked_ahead[p];
    }
    auto add = [&](int p, int relations, bool whole)
    {
      const Side_relation& r = relation[edges[p]];
      const int tau = std::abs(r.offset);
      Helix_record a;
      a.line = l;
      a.start = r.offset > 0 ? p : lines.position[r.target];
      a.pitch = r.offset > 0 ? r.sidesteps : -r.sidesteps;
      a.turn_length = tau;
      a.number_of_relations = relations;
      a.length = whole ? n : closed ? (std::min)(relations + tau, n) : relations + tau;
      a.is_whole_line = whole;
      on_line.push_back(a);
    };
    if(all_linked)
      add(0, n, true);
    else
      for(int p = 0; p < n; ++p)
      {
        if(!is_helical(edges[p]) || (p > 0 ? linked_ahead[p - 1] : closed && linked_ahead[n - 1]))
          continue;
        int relations = 1;
        for(int q = p; linked_ahead[q]; q = (q + 1) % n)
          ++relations;
        add(p, relations, false);
      }
    keep_minimal_helices(on_line, n, closed);
    all.insert(all.end(), on_line.begin(), on_line.end());
  }
  return all;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_HELIX_DETECTION_H
