// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_PLACES_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_PLACES_H

#include <CGAL/Quad_meshing/IO/internal/Point_numbers.h>
#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Quad_meshing/IO/internal/Side_groups.h>
#include <CGAL/Quad_meshing/IO/internal/soup_geometry.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Tells which vertices of a soup lie at the same place: the place of a vertex is the smallest number of a vertex there.
//
//  - Vertices with equal coordinates are at one place.
//  - So are the ends of a side of a face that is as short as rounding, see Soup_size::vanishing_length().
//  - Two vertices at the border, that is on sides that no other face shares, are at one place if they are closer than
//  the
//    share `merging_distance` of the diagonal of the model, and than a tenth of the shortest side of a face at either
//    of them. So no side that is longer than rounding loses its length, and what has no border is left alone, however
//    narrow it is. The vertices of one place are never farther apart than that either.
class Soup_places
{
  const Polygon_soup& m_soup;
  Soup_size m_size;
  std::vector<Soup_index> m_place;
  bool m_is_trivial = true;

  static constexpr double share_of_side = 0.1;

  struct Candidate
  {
    Soup_index vertex;
    double tolerance;
  };

public:
  Soup_places(const Polygon_soup& soup, double merging_distance)
    : m_soup(soup), m_size(soup.points), m_place(soup.points.size())
  {
    Point_numbers numbers(soup.points, soup.points.size());
    for(std::size_t v = 0; v < soup.points.size(); ++v)
    {
      m_place[v] = numbers.find(soup.points[v], static_cast<Soup_index>(v));
      m_is_trivial = m_is_trivial && m_place[v] == v;
    }
    join_short_sides();
    if(merging_distance > 0 && !is_closed())
      join_borders(merging_distance * m_size.diagonal);
  }

  // Whether every vertex has a place of its own.
  bool is_trivial() const { return m_is_trivial; }

  Soup_index operator[](std::size_t v) const { return m_place[v]; }

  const Soup_size& size() const { return m_size; }

  std::vector<Soup_index>& numbers() { return m_place; }

private:
  // Calls f(corner, next corner) for every side.
  template <typename F>
  void for_each_side(F f) const
  {
    for(std::size_t p = 0; p < m_soup.size(); ++p)
    {
      const std::size_t first = m_soup.first_corner[p], last = m_soup.first_corner[p + 1];
      for(std::size_t c = first; c < last; ++c)
        f(c, c + 1 < last ? c + 1 : first);
    }
  }

  // Whether every edge is passed as often in one direction as in the other, so that no side is alone. The sum of random
  // numbers of the edges, with signs, is 0 then; otherwise it is with a probability of 2^-64.
  bool is_closed() const
  {
    std::uint64_t sum = 0;
    for_each_side(
      [&](std::size_t c, std::size_t d)
      {
        const std::uint64_t a = place_of_corner(c), b = place_of_corner(d);
        if(a != b)
          sum += a < b ? mixed_bits((a << 32) | b) : ~mixed_bits((b << 32) | a) + 1;
      });
    return sum == 0;
  }

  Soup_index place_of_corner(std::size_t c) const { return m_place[m_soup.corners[c]]; }

  void join_short_sides()
  {
    const double vanishing = m_size.vanishing_length();
    std::vector<std::array<Soup_index, 2>> short_sides;
    for_each_side(
      [&](std::size_t c, std::size_t d)
      {
        const Soup_index a = place_of_corner(c), b = place_of_corner(d);
        if(a != b && soup_distance(m_soup.points[a], m_soup.points[b]) <= vanishing)
          short_sides.push_back({ { a, b } });
      });
    for(const auto& side : short_sides)
      join(side[0], side[1]);
    if(!short_sides.empty())
      flatten();
  }

  // Places are trees of vertices until flatten() makes every vertex point to its root, the smallest number.
  Soup_index root(Soup_index v) const
  {
    while(m_place[v] != v)
      v = m_place[v];
    return v;
  }

  void join(Soup_index a, Soup_index b)
  {
    a = root(a);
    b = root(b);
    m_place[(std::max)(a, b)] = (std::min)(a, b);
    m_is_trivial = m_is_trivial && a == b;
  }

  void flatten()
  {
    for(std::size_t v = 0; v < m_place.size(); ++v)
      m_place[v] = m_place[m_place[v]]; // smaller numbers are done
  }

  // The places on sides that no other face shares, with the distance up to which they may be joined.
  std::vector<Candidate> candidates(double largest_distance) const
  {
    std::vector<Soup_index> next(m_soup.corners.size());
    for_each_side([&](std::size_t c, std::size_t d) { next[c] = static_cast<Soup_index>(d); });
    const Side_groups groups(
      m_soup.corners.size(), m_place.size(), [&](std::size_t c) { return place_of_corner(c); },
      [&](std::size_t c) { return place_of_corner(next[c]); });

    std::vector<Candidate> result;
    std::vector<char> is_candidate(m_place.size(), 0);
    groups.for_each(
      [&](Soup_index low, Soup_index high, const std::vector<Soup_index>& sides)
      {
        if(sides.size() == 1)
          is_candidate[low] = is_candidate[high] = 1;
      });
    std::vector<double> shortest(m_place.size(), (std::numeric_limits<double>::max)());
    groups.for_each(
      [&](Soup_index low, Soup_index high, const std::vector<Soup_index>&)
      {
        if(!is_candidate[low] && !is_candidate[high])
          return;
        const double l = soup_distance(m_soup.points[low], m_soup.points[high]);
        shortest[low] = (std::min)(shortest[low], l);
        shortest[high] = (std::min)(shortest[high], l);
      });
    for(std::size_t v = 0; v < m_place.size(); ++v)
      if(is_candidate[v])
        result.push_back({ static_cast<Soup_index>(v), (std::min)(largest_distance, share_of_side * shortest[v]) });
    return result;
  }

  void join_borders(double largest_distance)
  {
    typedef Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Box;
    struct Pair
    {
      double distance;
      std::size_t a, b;
    };

    const std::vector<Candidate> vertices = candidates(largest_distance);
    std::vector<Box> boxes;
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      const Polygon_soup::Point& p = m_soup.points[vertices[i].vertex];
      const double r = 0.5 * vertices[i].tolerance;
      boxes.emplace_back(Bbox_3(p[0] - r, p[1] - r, p[2] - r, p[0] + r, p[1] + r, p[2] + r), i);
    }
    std::vector<Pair> pairs;
    box_self_intersection_d(boxes.begin(), boxes.end(),
                            [&](const Box& s, const Box& t)
                            {
                              const std::size_t a = (std::min)(s.info(), t.info()), b = (std::max)(s.info(), t.info());
                              const double d =
                                soup_distance(m_soup.points[vertices[a].vertex], m_soup.points[vertices[b].vertex]);
                              if(d <= (std::min)(vertices[a].tolerance, vertices[b].tolerance))
                                pairs.push_back({ d, a, b });
                            });
    if(pairs.empty())
      return;

    // The closest first; a place that would become too wide is not joined.
    std::sort(pairs.begin(), pairs.end(),
              [](const Pair& s, const Pair& t)
              { return std::tie(s.distance, s.a, s.b) < std::tie(t.distance, t.a, t.b); });
    std::vector<std::size_t> cluster(vertices.size());
    std::iota(cluster.begin(), cluster.end(), std::size_t(0));
    std::vector<std::vector<std::size_t>> members(vertices.size());
    for(std::size_t i = 0; i < vertices.size(); ++i)
      members[i] = { i };
    for(const Pair& pair : pairs)
    {
      const std::size_t a = cluster[pair.a], b = cluster[pair.b];
      if(a == b || !is_narrow(vertices, members[a], members[b]))
        continue;
      for(std::size_t i : members[b])
        cluster[i] = a;
      members[a].insert(members[a].end(), members[b].begin(), members[b].end());
      members[b].clear();
      join(vertices[pair.a].vertex, vertices[pair.b].vertex);
    }
    flatten();
  }

  bool is_narrow(const std::vector<Candidate>& vertices, const std::vector<std::size_t>& a,
                 const std::vector<std::size_t>& b) const
  {
    for(std::size_t i : a)
      for(std::size_t j : b)
        if(soup_distance(m_soup.points[vertices[i].vertex], m_soup.points[vertices[j].vertex]) >
           (std::min)(vertices[i].tolerance, vertices[j].tolerance))
          return false;
    return true;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_PLACES_H
