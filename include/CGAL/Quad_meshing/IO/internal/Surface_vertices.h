// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SURFACE_VERTICES_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SURFACE_VERTICES_H

#include <CGAL/Quad_meshing/IO/internal/Side_groups.h>
#include <CGAL/Quad_meshing/IO/internal/Soup_triangles.h>
#include <CGAL/Quad_meshing/IO/internal/soup_geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Gives every class of corners that hang together through joined sides one vertex.
//
// A class takes the smallest of its vertices of the file that no class before has taken; if there is none, as at a
// vertex where several sheets touch, it gets a new one at the same place, behind the others.
class Surface_vertices
{
  Soup_triangles& m_triangles;
  std::vector<Soup_index>& m_partner;

  std::vector<Soup_index> m_vertex_of, m_origin;

public:
  std::size_t number_split = 0; // vertices that became several

  Surface_vertices(Soup_triangles& triangles, std::vector<Soup_index>& partner)
    : m_triangles(triangles), m_partner(partner)
  {
  }

  void operator()()
  {
    const std::size_t n = m_triangles.number_of_sides(), nv = m_triangles.points.size();
    std::vector<char> is_done(n, 0), is_taken(nv, 0), is_split(nv, 0);
    m_vertex_of.assign(nv, no_index);
    std::vector<Soup_index> fan, ids;
    for(std::size_t c = 0; c < n; ++c)
    {
      if(is_done[c])
        continue;
      collect_fan(static_cast<Soup_index>(c), fan);
      ids.clear();
      Soup_index best = no_index;
      for(Soup_index d : fan)
      {
        const Soup_index v = m_triangles.source(d);
        is_done[d] = 1;
        if(!is_taken[v] && v < best)
          best = v;
      }
      if(best == no_index)
      {
        const Soup_index v = m_triangles.source(c);
        best = static_cast<Soup_index>(m_triangles.points.size());
        m_triangles.points.push_back(Polygon_soup::Point(m_triangles.points[v]));
        m_origin.push_back(v);
        number_split += !is_split[v];
        is_split[v] = 1;
        if(!m_triangles.place.empty())
          m_triangles.place.push_back(m_triangles.place[v]);
      }
      else
        is_taken[best] = 1;
      for(Soup_index d : fan)
      {
        Soup_index& v = m_triangles.corners[d / 3][d % 3];
        if(m_vertex_of[v] == no_index || v == best)
          m_vertex_of[v] = best;
        v = best;
      }
    }
  }

  // The vertex that a vertex became, itself or the first one; no_index if no triangle has it.
  const std::vector<Soup_index>& vertex_of() const { return m_vertex_of; }

  // The vertices that new ones, which lie behind all others, were split from.
  const std::vector<Soup_index>& origin() const { return m_origin; }

  // Two edges may have got the same two ends. A mesh has room for one edge there: the others get a vertex in the
  // middle.
  void separate_double_edges()
  {
    std::vector<Soup_index> midpoint(m_triangles.number_of_sides(), no_index);
    bool is_any = false;
    const Side_groups groups = group_sides();
    groups.for_each(
      [&](Soup_index low, Soup_index high, const std::vector<Soup_index>& sides)
      {
        bool is_first = true;
        for(Soup_index s : sides)
        {
          const Soup_index t = m_partner[s];
          if(t != no_index && t < s)
            continue;
          if(!is_first)
          {
            is_any = true;
            midpoint[s] = static_cast<Soup_index>(m_triangles.points.size());
            if(t != no_index)
              midpoint[t] = midpoint[s];
            const Polygon_soup::Point p = m_triangles.points[low], q = m_triangles.points[high];
            m_triangles.points.push_back({ { 0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]) } });
          }
          is_first = false;
        }
      });
    if(!is_any)
      return;
    const std::size_t nf = m_triangles.size();
    for(std::size_t f = 0; f < nf; ++f)
      split(f, { { midpoint[3 * f], midpoint[3 * f + 1], midpoint[3 * f + 2] } });
    // Now every edge has ends of its own.
    m_partner.assign(m_triangles.number_of_sides(), no_index);
    group_sides().for_each(
      [&](Soup_index, Soup_index, const std::vector<Soup_index>& sides)
      {
        if(sides.size() == 2)
        {
          m_partner[sides[0]] = sides[1];
          m_partner[sides[1]] = sides[0];
        }
      });
  }

private:
  // A corner has the number of the side that begins there.
  void collect_fan(Soup_index first, std::vector<Soup_index>& fan) const
  {
    fan.assign(1, first);
    for(Soup_index c = first;;)
    {
      c = m_partner[Soup_triangles::previous(c)];
      if(c == first)
        return;
      if(c == no_index)
        break;
      fan.push_back(c);
    }
    for(Soup_index c = first;;)
    {
      const Soup_index t = m_partner[c];
      if(t == no_index)
        return;
      c = static_cast<Soup_index>(Soup_triangles::next(t));
      fan.push_back(c);
    }
  }

  Side_groups group_sides() const
  {
    return Side_groups(
      m_triangles.number_of_sides(), m_triangles.points.size(), [&](std::size_t s) { return m_triangles.source(s); },
      [&](std::size_t s) { return m_triangles.target(s); });
  }

  // Puts vertices into the sides of a triangle; no_index stands for none.
  void split(std::size_t f, std::array<Soup_index, 3> m)
  {
    const auto number = 3 - std::count(m.begin(), m.end(), no_index);
    std::array<Soup_index, 3> c = m_triangles.corners[f];
    auto add = [&](Soup_index p, Soup_index q, Soup_index r) {
      m_triangles.add({ { p, q, r } }, m_triangles.file_face[f], m_triangles.other_side_of(f));
    };
    // The sides with a vertex come first.
    while(number > 0 && number < 3 && (m[0] == no_index || m[2] != no_index))
    {
      std::rotate(c.begin(), c.begin() + 1, c.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    }
    if(number == 1)
    {
      m_triangles.corners[f] = { { c[0], m[0], c[2] } };
      add(m[0], c[1], c[2]);
    }
    else if(number == 2)
    {
      m_triangles.corners[f] = { { m[0], c[1], m[1] } };
      add(c[0], m[0], m[1]);
      add(c[0], m[1], c[2]);
    }
    else if(number == 3)
    {
      m_triangles.corners[f] = { { m[0], m[1], m[2] } };
      add(c[0], m[0], m[2]);
      add(m[0], c[1], m[1]);
      add(m[1], c[2], m[2]);
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SURFACE_VERTICES_H
