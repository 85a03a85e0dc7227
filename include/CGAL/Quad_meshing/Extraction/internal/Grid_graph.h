// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_GRAPH_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_GRAPH_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The graph of the grid lines on the surface, with the cyclic order of its rays around every node: a
// halfedge data structure in which ray r is the halfedge from `node[r]` to `node[opposite[r]]`, and
// the face of r is on its left.
struct Grid_graph
{
  enum
  {
    NONE = -1,          // no ray follows: the border of the surface lies there
    CUT_BY_BORDER = -1, // the ray leaves the surface before it reaches another node
    FAILED = -2,        // the ray could not be followed
    REMOVED = -3
  };

  std::vector<int> node;           // per ray: where it starts
  std::vector<int> opposite;       // per ray: the one it runs to, or a reason why there is none
  std::vector<signed char> sign;   // per ray: orientation of the map where it starts
  std::vector<signed char> length; // per ray: of its edge, in the direction of the ray; 1 but at fold-overs
  std::vector<char> open_on_left;  // per ray: the border touches its edge from the left
  std::vector<int> ccw, cw;        // per ray: the next one around its node, or NONE
  std::vector<int> first;          // per node: one of its rays, or NONE; at a border the one with no ray before it
  std::vector<int> face;           // per ray: the face on its left, or NONE where that is open to the border
  std::vector<int> degree;         // per face

  int number_of_nodes() const { return static_cast<int>(first.size()); }
  int number_of_rays() const { return static_cast<int>(node.size()); }
  int number_of_faces() const { return static_cast<int>(degree.size()); }
  bool is_alive(int r) const { return opposite[r] != REMOVED; }

  // The ray after r around the face on the left of r, or NONE.
  int next(int r) const { return opposite[r] < 0 ? static_cast<int>(NONE) : cw[opposite[r]]; }

  // The border halfedge that follows r, which has no face on its left but one on its right: past the fan of faces
  // at the other end of r.
  int next_on_border(int r) const
  {
    int s = opposite[r];
    while(face[s] >= 0)
      s = ccw[s];
    return s;
  }

  template <typename Function>
  void for_each_ray_of_node(int n, const Function& f) const
  {
    int r = first[n];
    if(r == NONE)
      return;
    do
    {
      f(r);
      r = ccw[r];
    }
    while(r != NONE && r != first[n]);
  }

  // Takes a ray out of the order around its node.
  void unlink(int r)
  {
    const int n = node[r];
    if(first[n] == r)
      first[n] = (ccw[r] == r) ? static_cast<int>(NONE) : ccw[r];
    if(ccw[r] != NONE)
      cw[ccw[r]] = cw[r];
    if(cw[r] != NONE)
      ccw[cw[r]] = ccw[r];
    opposite[r] = REMOVED;
  }

  bool is_on_border(int n) const { return first[n] != NONE && cw[first[n]] == NONE; }

  // Contracts the edge of r: its two nodes become one. Returns whether this is possible; it is not for a loop, nor
  // if it would join two places of the border.
  bool contract(int r)
  {
    if(is_on_border(node[opposite[r]]))
      r = opposite[r];
    const int o = opposite[r], p = node[r], q = node[o];
    if(p == q || is_on_border(q))
      return false;

    // Around p: before, r, after; around q: from, o, to. Around the joined node: before, to, ..., from, after.
    const int before = cw[r], after = ccw[r], from = cw[o], to = ccw[o];
    for_each_ray_of_node(q, [&](int s) { node[s] = p; });
    auto link = [&](int s, int t)
    {
      if(s != NONE)
        ccw[s] = t;
      if(t != NONE)
        cw[t] = s;
    };
    const bool p_is_alone = before == r, q_is_alone = to == o;
    int start = q_is_alone ? after : to;
    if(p_is_alone && q_is_alone)
      start = NONE;
    else if(p_is_alone)
      link(from, to);
    else if(q_is_alone)
      link(before, after);
    else
    {
      link(before, to);
      link(from, after);
    }
    if(first[p] == r)
      first[p] = start;
    first[q] = NONE;
    opposite[r] = opposite[o] = REMOVED;
    return true;
  }

  // Removes a ray and the one at its other end.
  void remove_edge(int r)
  {
    const int o = opposite[r];
    unlink(r);
    if(o >= 0)
      unlink(o);
  }

  void find_faces()
  {
    const int UNKNOWN = -2;
    face.assign(number_of_rays(), UNKNOWN);
    degree.clear();
    for(int s = 0; s < number_of_rays(); ++s)
    {
      if(face[s] != UNKNOWN)
        continue;
      // Walk to see whether the face closes. An open chain ends at a border, or in one found open before.
      int n = 0, r = s;
      do
      {
        ++n;
        r = next(r);
      }
      while(r != NONE && r != s && face[r] == UNKNOWN);
      const bool closed = r == s;
      const int id = closed ? number_of_faces() : static_cast<int>(NONE);
      if(closed)
        degree.push_back(n);
      r = s;
      for(int i = 0; i < n; ++i, r = next(r))
        face[r] = id;
    }
  }

  // Makes holes of the faces that are bad, and returns how many these are.
  template <typename Predicate>
  std::size_t drop_faces(const Predicate& is_bad)
  {
    std::vector<int> id(degree.size()), kept;
    for(std::size_t i = 0; i < degree.size(); ++i)
    {
      id[i] = is_bad(static_cast<int>(i)) ? static_cast<int>(NONE) : static_cast<int>(kept.size());
      if(id[i] != NONE)
        kept.push_back(degree[i]);
    }
    for(int& f : face)
      if(f >= 0)
        f = id[f];
    const std::size_t dropped = degree.size() - kept.size();
    degree.swap(kept);
    return dropped;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_GRAPH_H
