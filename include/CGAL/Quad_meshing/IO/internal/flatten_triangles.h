// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_FLATTEN_TRIANGLES_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_FLATTEN_TRIANGLES_H

#include <CGAL/Quad_meshing/IO/internal/Soup_triangles.h>
#include <CGAL/Quad_meshing/IO/internal/soup_geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Removes triangles without a height, see Flatness. The longest side of such a triangle holds its third vertex, so the
// surface, as a set of points, stays what it is if that vertex is inserted into the other triangles at that side and
// the flat one is taken away. Two flat triangles with the same vertices go together.
//
// This comes before edges with more than two faces are looked for: flat triangles are what makes many of them.
class Flat_triangles
{
  Soup_triangles& m_triangles;
  const Flatness m_is_flat;
  std::vector<char> m_is_removed;
  std::vector<char> m_is_marked; // per place: all triangles there are in the table
  std::unordered_map<std::uint64_t, std::vector<Soup_index>> m_at_side;

public:
  std::size_t number_removed = 0;

  Flat_triangles(Soup_triangles& triangles, const Flatness& is_flat) : m_triangles(triangles), m_is_flat(is_flat) {}

  // The triangles that are flat.
  std::vector<Soup_index> find() const
  {
    std::vector<Soup_index> flat;
    int longest = 0;
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      if(is_flat_triangle(f, longest))
        flat.push_back(static_cast<Soup_index>(f));
    return flat;
  }

  void operator()()
  {
    std::vector<Soup_index> flat = find();
    const std::size_t number_before = flat.size();
    // Every triangle that is removed leaves others whose longest side is no longer than its own; the bounds are for
    // chains of collinear vertices.
    std::size_t steps = 10 * flat.size();
    for(int round = 0; round < 10 && !flat.empty(); ++round)
    {
      m_is_removed.assign(m_triangles.size(), 0);
      make_table(flat);
      std::deque<Soup_index> queue(flat.begin(), flat.end());
      for(; !queue.empty() && steps > 0; queue.pop_front())
        if(!m_is_removed[queue.front()] && remove(queue.front(), queue))
          --steps;
      m_triangles.keep_if([&](std::size_t f) { return m_is_removed[f] == 0; });
      const std::size_t last_number = flat.size();
      flat = find();
      if(flat.size() == last_number || steps == 0)
        break;
    }
    number_removed = number_before > flat.size() ? number_before - flat.size() : 0;
  }

private:
  bool is_flat_triangle(std::size_t f, int& longest) const
  {
    return m_is_flat(m_triangles.point(f, 0), m_triangles.point(f, 1), m_triangles.point(f, 2), longest);
  }

  Soup_index place(std::size_t f, std::size_t k) const { return m_triangles.place_of(m_triangles.corners[f][k % 3]); }

  static std::uint64_t key(Soup_index a, Soup_index b)
  {
    return (static_cast<std::uint64_t>((std::min)(a, b)) << 32) | (std::max)(a, b);
  }

  // The table holds the sides at the vertices of flat triangles only: a scan has millions of others.
  void make_table(const std::vector<Soup_index>& flat)
  {
    m_at_side.clear();
    m_is_marked.assign(m_triangles.points.size(), 0);
    for(Soup_index f : flat)
      for(std::size_t k = 0; k < 3; ++k)
        m_is_marked[place(f, k)] = 1;
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      enter(f);
  }

  void enter(std::size_t f)
  {
    for(std::size_t k = 0; k < 3; ++k)
      if(m_is_marked[place(f, k)] || m_is_marked[place(f, k + 1)])
        m_at_side[key(place(f, k), place(f, k + 1))].push_back(static_cast<Soup_index>(f));
  }

  // Returns false if the triangle has to wait for a table with other vertices.
  bool remove(Soup_index f, std::deque<Soup_index>& queue)
  {
    int longest = 0;
    is_flat_triangle(f, longest);
    const std::size_t k = static_cast<std::size_t>(longest);
    const Soup_index a = place(f, k), b = place(f, k + 1);
    const Soup_index middle = m_triangles.corners[f][(k + 2) % 3];
    if(!m_is_marked[a] && !m_is_marked[b])
      return false;

    m_is_removed[f] = 1;
    const std::vector<Soup_index> at_side = m_at_side[key(a, b)];
    for(Soup_index g : at_side)
    {
      if(m_is_removed[g])
        continue;
      m_is_removed[g] = 1;
      std::size_t l = 0;
      while(key(place(g, l), place(g, l + 1)) != key(a, b))
        ++l;
      const std::array<Soup_index, 3> c = m_triangles.corners[g];
      if(place(g, l + 2) == m_triangles.place_of(middle))
        continue; // a flat triangle with the same vertices
      // Copies: the vectors grow.
      const Soup_index face = m_triangles.file_face[g], other = m_triangles.other_side_of(g);
      add({ { c[l], middle, c[(l + 2) % 3] } }, face, other, queue);
      add({ { middle, c[(l + 1) % 3], c[(l + 2) % 3] } }, face, other, queue);
    }
    return true;
  }

  void add(const std::array<Soup_index, 3>& triangle, Soup_index face, Soup_index other, std::deque<Soup_index>& queue)
  {
    const std::size_t f = m_triangles.size();
    m_triangles.add(triangle, face, other);
    m_is_removed.push_back(0);
    enter(f);
    int longest = 0;
    if(is_flat_triangle(f, longest))
      queue.push_back(static_cast<Soup_index>(f));
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_FLATTEN_TRIANGLES_H
