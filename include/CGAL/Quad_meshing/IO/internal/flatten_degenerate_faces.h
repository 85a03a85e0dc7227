// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_FLATTEN_DEGENERATE_FACES_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_FLATTEN_DEGENERATE_FACES_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <set>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Removes triangles of zero area without moving anything: the longest edge of such a triangle holds
// its third vertex, so flipping that edge leaves the surface, as a set of points, what it was, and
// at the border the triangle is taken away. Returns how many triangles of zero area are left, as
// some are where the flipped edge exists already or where only such triangles meet.
template <typename TriangleMesh, typename VertexPointMap>
std::size_t flatten_degenerate_faces(TriangleMesh& tm, VertexPointMap vpm, std::size_t& removed)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  auto point = [&](halfedge_descriptor h) -> const auto& { return get(vpm, target(h, tm)); };
  auto is_degenerate = [&](face_descriptor f)
  {
    const halfedge_descriptor h = halfedge(f, tm);
    return collinear(point(h), point(next(h, tm)), point(prev(h, tm)));
  };

  // Every face waits at most once, so that no face is taken up again after it was removed.
  std::deque<face_descriptor> queue;
  std::set<face_descriptor> waiting;
  for(face_descriptor f : faces(tm))
    if(is_degenerate(f))
      queue.push_back(f);
  waiting.insert(queue.begin(), queue.end());

  // A flip may make the neighbor one of zero area, which then waits for its own turn; a bound on the
  // number of flips ends what would run in circles among collinear vertices.
  const std::size_t number = queue.size();
  std::size_t flips = 10 * number;
  for(; !queue.empty(); queue.pop_front())
  {
    const face_descriptor f = queue.front();
    waiting.erase(f);
    if(!is_degenerate(f))
      continue;
    halfedge_descriptor longest = halfedge(f, tm);
    for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, tm), tm))
      if(squared_distance(point(h), point(prev(h, tm))) > squared_distance(point(longest), point(prev(longest, tm))))
        longest = h;

    const halfedge_descriptor other = opposite(longest, tm);
    const halfedge_descriptor n = next(longest, tm), p = prev(longest, tm);
    if(is_border(other, tm))
    {
      // The middle vertex comes to lie on the border, so it must not lie there yet.
      bool is_at_border = false;
      for(halfedge_descriptor h : CGAL::halfedges_around_target(n, tm))
        is_at_border = is_at_border || is_border(h, tm);
      if(!is_at_border)
        Euler::remove_face(longest, tm);
      continue;
    }

    if(flips == 0 || halfedge(target(n, tm), target(next(other, tm), tm), tm).second ||
       target(n, tm) == target(next(other, tm), tm))
      continue;
    --flips;
    Euler::flip_edge(longest, tm);
    for(face_descriptor g : { face(n, tm), face(p, tm) })
      if(is_degenerate(g) && waiting.insert(g).second)
        queue.push_back(g);
  }
  const std::size_t left = number == 0 ? 0 : std::count_if(faces(tm).begin(), faces(tm).end(), is_degenerate);
  removed = number > left ? number - left : 0;
  return left;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_FLATTEN_DEGENERATE_FACES_H
