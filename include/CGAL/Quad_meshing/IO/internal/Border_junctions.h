// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_BORDER_JUNCTIONS_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_BORDER_JUNCTIONS_H

#include <CGAL/Quad_meshing/IO/internal/Side_groups.h>
#include <CGAL/Quad_meshing/IO/internal/Soup_triangles.h>
#include <CGAL/Quad_meshing/IO/internal/soup_geometry.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Puts vertices of the border into the border sides that they lie on, so that the pieces of a side can be joined to the
// shorter sides across a crack.
//
// A vertex lies on a side if it is closer to it than `largest_distance`, and than a tenth of the shortest side of a
// triangle at the vertex or at the ends of the side, which is the rule by which vertices are merged. A side is only
// split where that makes a piece that another border side matches: a surface that merely touches the border of another
// is left alone.
class Border_junctions
{
  static constexpr double share_of_side = 0.1;

  Soup_triangles& m_triangles;
  const double m_largest_distance;

  std::vector<Soup_index> m_sides;                // those that no other triangle shares
  std::vector<double> m_tolerance;                // per vertex
  std::vector<std::vector<Soup_index>> m_on_side; // per entry of m_sides: the vertices on it, from its source on

public:
  std::size_t number_split = 0; // sides

  Border_junctions(Soup_triangles& triangles, double largest_distance)
    : m_triangles(triangles), m_largest_distance(largest_distance)
  {
  }

  // `groups` are the sides between the same vertices. Returns whether sides were split; sides have other numbers then.
  bool operator()(const Side_groups& groups)
  {
    if(!(m_largest_distance > 0))
      return false;
    find_border_sides(groups);
    if(m_sides.size() < 3)
      return false;
    find_tolerances();
    if(!find_vertices_on_sides())
      return false;
    keep_what_matches();
    split_triangles();
    return number_split > 0;
  }

private:
  typedef std::array<Soup_index, 2> Ends;

  Ends ends(Soup_index a, Soup_index b) const
  {
    a = m_triangles.place_of(a);
    b = m_triangles.place_of(b);
    return { { (std::min)(a, b), (std::max)(a, b) } };
  }

  Ends ends(std::size_t side) const { return ends(m_triangles.source(side), m_triangles.target(side)); }

  void find_border_sides(const Side_groups& groups)
  {
    groups.for_each(
      [&](Soup_index, Soup_index, const std::vector<Soup_index>& sides)
      {
        if(sides.size() == 1)
          m_sides.push_back(sides[0]);
      });
    if(m_triangles.place.empty())
      return;
    // Of sides between different vertices, those that lie between the same places are not at the border.
    std::vector<std::pair<Ends, Soup_index>> sorted;
    for(Soup_index s : m_sides)
      sorted.emplace_back(ends(s), s);
    std::sort(sorted.begin(), sorted.end());
    m_sides.clear();
    for(std::size_t i = 0, j; i < sorted.size(); i = j)
    {
      for(j = i + 1; j < sorted.size() && sorted[j].first == sorted[i].first;)
        ++j;
      if(j == i + 1)
        m_sides.push_back(sorted[i].second);
    }
  }

  void find_tolerances()
  {
    std::vector<char> is_at_border(m_triangles.points.size(), 0);
    for(Soup_index s : m_sides)
      is_at_border[m_triangles.source(s)] = is_at_border[m_triangles.target(s)] = 1;
    m_tolerance.assign(m_triangles.points.size(), m_largest_distance);
    for(std::size_t s = 0; s < m_triangles.number_of_sides(); ++s)
    {
      const Soup_index a = m_triangles.source(s), b = m_triangles.target(s);
      if(!is_at_border[a] && !is_at_border[b])
        continue;
      const double l = share_of_side * soup_distance(m_triangles.points[a], m_triangles.points[b]);
      m_tolerance[a] = (std::min)(m_tolerance[a], l);
      m_tolerance[b] = (std::min)(m_tolerance[b], l);
    }
  }

  // Where on a side, from 0 to 1, the point nearest to a vertex lies; -1 if the vertex is not on the side.
  double parameter_on_side(Soup_index v, std::size_t s) const
  {
    const Soup_index a = m_triangles.source(s), b = m_triangles.target(s);
    const double tolerance = (std::min)(m_tolerance[v], (std::min)(m_tolerance[a], m_tolerance[b]));
    const Soup_vector d = soup_difference(m_triangles.points[b], m_triangles.points[a]);
    const double length = soup_length(d);
    const Soup_vector x = soup_difference(m_triangles.points[v], m_triangles.points[a]);
    const double along = soup_dot(x, d) / length;
    if(!(along > tolerance && along < length - tolerance))
      return -1;
    const double t = along / length;
    const Soup_vector offset = { { x[0] - t * d[0], x[1] - t * d[1], x[2] - t * d[2] } };
    return soup_length(offset) <= tolerance ? t : -1;
  }

  bool find_vertices_on_sides()
  {
    typedef Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Box;
    std::vector<Box> sides, vertices;
    std::vector<char> is_done(m_triangles.points.size(), 0); // per place
    for(std::size_t i = 0; i < m_sides.size(); ++i)
    {
      const Soup_vector &p = m_triangles.points[m_triangles.source(m_sides[i])],
                        &q = m_triangles.points[m_triangles.target(m_sides[i])];
      const double r = m_largest_distance;
      sides.emplace_back(Bbox_3((std::min)(p[0], q[0]) - r, (std::min)(p[1], q[1]) - r, (std::min)(p[2], q[2]) - r,
                                (std::max)(p[0], q[0]) + r, (std::max)(p[1], q[1]) + r, (std::max)(p[2], q[2]) + r),
                         i);
      for(Soup_index v : { m_triangles.source(m_sides[i]), m_triangles.target(m_sides[i]) })
      {
        char& done = is_done[m_triangles.place_of(v)];
        if(done)
          continue;
        done = 1;
        const Soup_vector& x = m_triangles.points[v];
        vertices.emplace_back(Bbox_3(x[0], x[1], x[2], x[0], x[1], x[2]), v);
      }
    }
    typedef std::pair<double, Soup_index> Vertex_on_side;
    std::vector<std::vector<Vertex_on_side>> found(m_sides.size());
    bool is_any = false;
    struct Too_many
    {
    };
    constexpr std::size_t most_pairs = 20000000; // some seconds
    std::size_t number_of_pairs = 0;
    try
    {
      box_intersection_d(vertices.begin(), vertices.end(), sides.begin(), sides.end(),
                         [&](const Box& a, const Box& b)
                         {
                           if(++number_of_pairs > most_pairs)
                             throw Too_many();
                           const Soup_index v = static_cast<Soup_index>(a.info());
                           const std::size_t s = m_sides[b.info()];
                           const Ends e = ends(s);
                           const Soup_index place = m_triangles.place_of(v);
                           if(place == e[0] || place == e[1])
                             return;
                           const double t = parameter_on_side(v, s);
                           if(t < 0)
                             return;
                           found[b.info()].emplace_back(t, v);
                           is_any = true;
                         });
    }
    catch(const Too_many&)
    {
      return false; // the algorithm of the boxes can only be left this way
    }
    if(!is_any)
      return false;
    m_on_side.resize(m_sides.size());
    for(std::size_t i = 0; i < m_sides.size(); ++i)
    {
      std::sort(found[i].begin(), found[i].end());
      for(const Vertex_on_side& v : found[i])
        m_on_side[i].push_back(v.second);
    }
    return true;
  }

  // The pieces of a border side, between consecutive vertices on it.
  template <typename F>
  void for_each_piece(std::size_t i, F f) const
  {
    const std::vector<Soup_index>& on = m_on_side[i];
    Soup_index a = m_triangles.source(m_sides[i]);
    for(std::size_t k = 0; k <= on.size(); ++k)
    {
      const Soup_index b = k < on.size() ? on[k] : m_triangles.target(m_sides[i]);
      f(k, ends(a, b));
      a = b;
    }
  }

  // A vertex stays on a side if a piece that ends there lies between the same places as a piece of another side.
  void keep_what_matches()
  {
    std::vector<Ends> pieces;
    for(std::size_t i = 0; i < m_sides.size(); ++i)
      for_each_piece(i, [&](std::size_t, const Ends& e) { pieces.push_back(e); });
    std::sort(pieces.begin(), pieces.end());
    auto has_match = [&](const Ends& e)
    {
      const auto range = std::equal_range(pieces.begin(), pieces.end(), e);
      return range.second - range.first > 1;
    };
    std::vector<char> matches;
    for(std::size_t i = 0; i < m_sides.size(); ++i)
    {
      std::vector<Soup_index>& on = m_on_side[i];
      if(on.empty())
        continue;
      matches.assign(on.size() + 1, 0);
      for_each_piece(i, [&](std::size_t k, const Ends& e) { matches[k] = has_match(e); });
      std::size_t n = 0;
      for(std::size_t k = 0; k < on.size(); ++k)
        if(matches[k] || matches[k + 1])
          on[n++] = on[k];
      on.resize(n);
      number_split += n > 0;
    }
  }

  void split_triangles()
  {
    if(number_split == 0)
      return;
    std::vector<std::pair<Soup_index, std::size_t>> split_sides; // side, position in m_sides
    for(std::size_t i = 0; i < m_sides.size(); ++i)
      if(!m_on_side[i].empty())
        split_sides.emplace_back(m_sides[i], i);
    std::sort(split_sides.begin(), split_sides.end());
    std::vector<std::array<Soup_index, 3>> parts;
    for(std::size_t i = 0; i < split_sides.size();)
    {
      const std::size_t f = split_sides[i].first / 3;
      std::array<std::vector<Soup_index>, 3> on;
      for(; i < split_sides.size() && split_sides[i].first / 3 == f; ++i)
        on[split_sides[i].first % 3] = m_on_side[split_sides[i].second];
      parts.clear();
      split(m_triangles.corners[f], on, parts);
      m_triangles.corners[f] = parts.front();
      for(std::size_t k = 1; k < parts.size(); ++k)
        m_triangles.add(parts[k], m_triangles.file_face[f], m_triangles.other_side_of(f));
    }
  }

  // Cuts a triangle from the corner across a side to the vertices on it; the other two sides belong to the outer parts.
  // No part has three corners on one side.
  static void split(std::array<Soup_index, 3> c, std::array<std::vector<Soup_index>, 3> on,
                    std::vector<std::array<Soup_index, 3>>& parts)
  {
    if(on[0].empty() && on[1].empty() && on[2].empty())
    {
      parts.push_back(c);
      return;
    }
    while(on[0].empty())
    {
      std::rotate(c.begin(), c.begin() + 1, c.end());
      std::rotate(on.begin(), on.begin() + 1, on.end());
    }
    Soup_index a = c[0];
    for(std::size_t k = 0; k <= on[0].size(); ++k)
    {
      const bool is_first = k == 0, is_last = k == on[0].size();
      const Soup_index b = is_last ? c[1] : on[0][k];
      split({ { a, b, c[2] } },
            { { {}, is_last ? on[1] : std::vector<Soup_index>(), is_first ? on[2] : std::vector<Soup_index>() } },
            parts);
      a = b;
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_BORDER_JUNCTIONS_H
