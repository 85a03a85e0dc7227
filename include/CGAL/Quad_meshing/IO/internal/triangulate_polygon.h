// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_TRIANGULATE_POLYGON_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_TRIANGULATE_POLYGON_H

#include <CGAL/Quad_meshing/IO/internal/soup_geometry.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Cuts a polygon into triangles, given as positions of its corners.
//
// A polygon with four corners is cut at the diagonal whose triangles have the larger scalar product of normals,
// weighted with their areas. Others are projected along their mean normal, cut by removing ears, and improved by flips
// to the Delaunay triangulation. A polygon may touch itself, as one does that reaches its holes over slits. The
// orientation of corners is tested exactly; a polygon that crosses itself gets triangles that do.
class Polygon_triangulator
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_2 Point_2;
  typedef std::array<std::size_t, 3> Triangle;

  std::vector<Point_2> m_points;
  std::vector<Triangle> m_triangles;

public:
  const std::vector<Triangle>& operator()(const std::vector<Soup_vector>& corners)
  {
    m_triangles.clear();
    if(corners.size() == 4)
      cut_quad(corners);
    else if(corners.size() > 4)
    {
      project(corners);
      remove_ears();
      flip_to_delaunay();
    }
    else if(corners.size() == 3)
      m_triangles.push_back({ { 0, 1, 2 } });
    return m_triangles;
  }

private:
  void cut_quad(const std::vector<Soup_vector>& p)
  {
    auto normal = [&](std::size_t a, std::size_t b, std::size_t c)
    { return soup_cross(soup_difference(p[b], p[a]), soup_difference(p[c], p[b])); };
    const double p1p3 = soup_dot(normal(1, 2, 3), normal(3, 0, 1)), p0p2 = soup_dot(normal(0, 1, 2), normal(2, 3, 0));
    if(p0p2 > p1p3)
      m_triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
    else
      m_triangles = { { { 0, 1, 3 } }, { { 1, 2, 3 } } };
  }

  void project(const std::vector<Soup_vector>& corners)
  {
    const std::size_t n = corners.size();
    Soup_vector normal = { { 0, 0, 0 } };
    for(std::size_t i = 1; i + 1 < n; ++i)
    {
      const Soup_vector c =
        soup_cross(soup_difference(corners[i], corners[0]), soup_difference(corners[i + 1], corners[0]));
      for(std::size_t d = 0; d < 3; ++d)
        normal[d] += c[d];
    }
    std::size_t largest = 0;
    for(std::size_t d = 1; d < 3; ++d)
      if(std::abs(normal[d]) > std::abs(normal[largest]))
        largest = d;
    // Leaving a coordinate out moves no digit, so collinear corners stay collinear.
    std::size_t x = (largest + 1) % 3, y = (largest + 2) % 3;
    if(normal[largest] < 0)
      std::swap(x, y);
    m_points.clear();
    for(const Soup_vector& p : corners)
      m_points.emplace_back(p[x], p[y]);
  }

  int turn(std::size_t a, std::size_t b, std::size_t c) const
  {
    return static_cast<int>(orientation(m_points[a], m_points[b], m_points[c]));
  }

  // Removes corners that make a triangle without another corner in it. Only corners where the polygon does not turn
  // left can lie in such a triangle. If there is none, as in a polygon that crosses itself, any left turn is taken.
  void remove_ears()
  {
    const std::size_t n = m_points.size();
    std::vector<std::size_t> next(n), prev(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      next[i] = (i + 1) % n;
      prev[i] = (i + n - 1) % n;
    }
    auto is_convex = [&](std::size_t i) { return turn(prev[i], i, next[i]) > 0; };
    std::vector<std::size_t> others; // the corners that are not convex, and some that have become so
    for(std::size_t i = 0; i < n; ++i)
      if(!is_convex(i))
        others.push_back(i);

    auto is_ear = [&](std::size_t i)
    {
      if(!is_convex(i))
        return false;
      const Point_2 &a = m_points[prev[i]], &b = m_points[i], &c = m_points[next[i]];
      for(std::size_t j : others)
        if(j != i && j != prev[i] && j != next[i] && m_points[j] != a && m_points[j] != b && m_points[j] != c &&
           turn(prev[i], i, j) >= 0 && turn(i, next[i], j) >= 0 && turn(next[i], prev[i], j) >= 0)
          return false;
      return true;
    };

    std::size_t left = n, i = 0, failures = 0;
    while(left > 3)
    {
      const bool takes_any = failures > left;
      if(!(takes_any ? is_convex(i) || failures > 2 * left : is_ear(i)))
      {
        ++failures;
        i = next[i];
        continue;
      }
      failures = 0;
      m_triangles.push_back({ { prev[i], i, next[i] } });
      next[prev[i]] = next[i];
      prev[next[i]] = prev[i];
      --left;
      others.erase(
        std::remove_if(others.begin(), others.end(),
                       [&](std::size_t j) { return j == i || ((j == prev[i] || j == next[i]) && is_convex(j)); }),
        others.end());
      i = next[next[i]]; // not the neighbor: that would make a fan of slivers
    }
    m_triangles.push_back({ { prev[i], i, next[i] } });
  }

  void flip_to_delaunay()
  {
    typedef std::pair<std::size_t, std::size_t> Key;
    std::map<Key, std::array<std::size_t, 2>> triangles_at; // inner edges: their two triangles
    const std::size_t none = m_triangles.size(), n = m_points.size();
    auto key = [](std::size_t a, std::size_t b) { return Key(std::minmax(a, b)); };
    auto add = [&](std::size_t t, std::size_t a, std::size_t b)
    {
      if((a + 1) % n == b || (b + 1) % n == a)
        return; // a side of the polygon
      auto& entry = triangles_at.emplace(key(a, b), std::array<std::size_t, 2>{ { none, none } }).first->second;
      entry[entry[0] == none ? 0 : 1] = t;
    };
    auto remove = [&](std::size_t t, std::size_t a, std::size_t b)
    {
      const auto found = triangles_at.find(key(a, b));
      if(found != triangles_at.end())
        found->second[found->second[0] == t ? 0 : 1] = none;
    };
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      for(std::size_t k = 0; k < 3; ++k)
        add(t, m_triangles[t][k], m_triangles[t][(k + 1) % 3]);

    std::vector<Key> queue;
    for(const auto& entry : triangles_at)
      queue.push_back(entry.first);
    // Flips end by themselves; rounding cannot enter, as the tests are exact. The bound is for polygons that cross
    // themselves.
    for(std::size_t flips = 0; !queue.empty() && flips < 10 * n * n;)
    {
      const Key e = queue.back();
      queue.pop_back();
      const auto found = triangles_at.find(e);
      if(found == triangles_at.end() || found->second[0] == none || found->second[1] == none)
        continue;
      const std::size_t s = found->second[0], t = found->second[1];
      std::size_t k = 0;
      while(m_triangles[s][k] == e.first || m_triangles[s][k] == e.second)
        ++k;
      const std::size_t c = m_triangles[s][k], a = m_triangles[s][(k + 1) % 3], b = m_triangles[s][(k + 2) % 3];
      std::size_t d = m_triangles[t][0];
      for(std::size_t v : m_triangles[t])
        if(v != a && v != b)
          d = v;
      // c a d b is the quadrilateral; a flip must leave two triangles with an area.
      if(turn(c, a, d) <= 0 || turn(d, b, c) <= 0 ||
         side_of_oriented_circle(m_points[a], m_points[b], m_points[c], m_points[d]) != ON_POSITIVE_SIDE)
        continue;
      if(triangles_at.count(key(c, d)) != 0 && triangles_at[key(c, d)][0] != none)
        continue;
      ++flips;
      triangles_at.erase(found);
      remove(s, b, c);
      remove(t, a, d);
      m_triangles[s] = { { c, a, d } };
      m_triangles[t] = { { c, d, b } };
      triangles_at.erase(key(c, d));
      add(s, a, d);
      add(s, c, d);
      add(t, c, d);
      add(t, b, c);
      for(const Key& side : { key(c, a), key(a, d), key(d, b), key(b, c) })
        queue.push_back(side);
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_TRIANGULATE_POLYGON_H
