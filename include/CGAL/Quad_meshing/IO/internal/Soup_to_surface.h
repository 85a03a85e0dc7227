// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_TO_SURFACE_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_TO_SURFACE_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Quad_meshing/IO/internal/Soup_file_reader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Disjoint sets of numbers, each number with a sign relative to the representative of its set.
class Signed_union_find
{
  std::vector<std::size_t> m_parent;
  std::vector<char> m_is_reversed; // against the parent

public:
  explicit Signed_union_find(std::size_t n) : m_parent(n), m_is_reversed(n, 0)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }

  // The representative of i and whether i is reversed against it.
  std::pair<std::size_t, bool> find(std::size_t i)
  {
    std::size_t root = i;
    bool reversed = false;
    for(; m_parent[root] != root; root = m_parent[root])
      reversed ^= (m_is_reversed[root] != 0);
    const bool result = reversed;
    while(m_parent[i] != root && i != root)
    {
      const std::size_t next = m_parent[i];
      const bool next_reversed = reversed ^ (m_is_reversed[i] != 0);
      m_parent[i] = root;
      m_is_reversed[i] = reversed;
      i = next;
      reversed = next_reversed;
    }
    return { root, result };
  }

  // Joins the sets of a and b such that b is reversed against a, or not. Returns false if they are
  // in one set already with the other sign. The smaller representative stays.
  bool join(std::size_t a, std::size_t b, bool reversed)
  {
    const auto fa = find(a), fb = find(b);
    const bool between_roots = fa.second ^ fb.second ^ reversed;
    if(fa.first == fb.first)
      return !between_roots;
    const std::size_t root = (std::min)(fa.first, fb.first), other = (std::max)(fa.first, fb.first);
    m_parent[other] = root;
    m_is_reversed[other] = between_roots;
    return true;
  }
};

// Makes a soup of polygons the soup of an oriented manifold surface, without moving anything:
//
//  1. polygons joined by an edge of their two get one orientation, that of the majority of them;
//     if there is none (a Moebius strip), the soup is refused;
//  2. at an edge with more than two polygons they are paired: where sides alternate, as at two
//     solids that touch along an edge, around the material between them, else by straightness; who
//     finds no partner gets a border there;
//  3. corners that hang together through the edges left are one vertex; a vertex at which several
//     sheets touch becomes one vertex for each.
//
// The soup must have valid indices and no vertex twice in a polygon. Side k of a polygon runs from
// its vertex k to the next one; sides and corners are numbered through all polygons.
class Soup_to_surface
{
  typedef Polygon_soup::Point_3 Point_3;
  typedef Simple_cartesian<double>::Vector_3 Vector_3;

  struct Edge { std::size_t low, high, side; };

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Polygon_soup& m_soup;
  std::vector<std::size_t> m_first_side; // per polygon
  std::vector<std::size_t> m_polygon_of; // per side
  std::vector<Edge> m_edges;             // per side, those of one edge behind each other
  std::vector<std::size_t> m_partner;    // per side: the one it is joined to
  std::vector<std::size_t> m_midpoint;   // per side: a vertex to be inserted

public:
  std::size_t reversed_polygons = 0;
  std::size_t non_manifold_edges = 0;
  std::size_t split_vertices = 0;
  std::pair<std::size_t, std::size_t> conflict_edge = { 0, 0 };

  explicit Soup_to_surface(Polygon_soup& soup) : m_soup(soup) {}

  // Returns false if the soup is not orientable; `conflict_edge` then closes a one-sided strip.
  bool operator()()
  {
    index_sides();
    if(!orient())
      return false;
    pair_sides();
    split_corners();
    insert_midpoints();
    return true;
  }

private:
  std::size_t size(std::size_t polygon) const { return m_soup.polygons[polygon].size(); }

  std::size_t source(std::size_t side) const
  {
    const std::size_t f = m_polygon_of[side];
    return m_soup.polygons[f][side - m_first_side[f]];
  }

  std::size_t next(std::size_t side) const
  {
    const std::size_t f = m_polygon_of[side];
    return side + 1 == m_first_side[f] + size(f) ? m_first_side[f] : side + 1;
  }

  std::size_t target(std::size_t side) const { return source(next(side)); }

  bool runs_upwards(std::size_t side) const { return source(side) < target(side); }

  void index_sides()
  {
    m_first_side.clear();
    m_polygon_of.clear();
    for(std::size_t f = 0; f < m_soup.polygons.size(); ++f)
    {
      m_first_side.push_back(m_polygon_of.size());
      m_polygon_of.insert(m_polygon_of.end(), size(f), f);
    }
    m_edges.clear();
    m_edges.reserve(m_polygon_of.size());
    for(std::size_t s = 0; s < m_polygon_of.size(); ++s)
      m_edges.push_back({ (std::min)(source(s), target(s)), (std::max)(source(s), target(s)), s });
    std::sort(m_edges.begin(), m_edges.end(), [](const Edge& a, const Edge& b)
              { return std::tie(a.low, a.high, a.side) < std::tie(b.low, b.high, b.side); });
  }

  // Calls f(first, last) with the range of m_edges of every edge.
  template <typename F>
  void for_each_edge(F f) const
  {
    for(std::size_t i = 0, j; i < m_edges.size(); i = j)
    {
      for(j = i + 1; j < m_edges.size() && m_edges[j].low == m_edges[i].low && m_edges[j].high == m_edges[i].high;)
        ++j;
      f(i, j);
    }
  }

  bool orient()
  {
    const std::size_t nf = m_soup.polygons.size();
    Signed_union_find orientation(nf);
    bool is_orientable = true;
    for_each_edge([&](std::size_t i, std::size_t j)
    {
      if(j - i != 2)
        return;
      const std::size_t a = m_edges[i].side, b = m_edges[i + 1].side;
      if(!orientation.join(m_polygon_of[a], m_polygon_of[b], runs_upwards(a) == runs_upwards(b)) && is_orientable)
      {
        is_orientable = false;
        conflict_edge = { m_edges[i].low, m_edges[i].high };
      }
    });
    if(!is_orientable)
      return false;

    std::vector<std::size_t> number(nf, 0), number_reversed(nf, 0);
    for(std::size_t f = 0; f < nf; ++f)
    {
      const auto found = orientation.find(f);
      ++number[found.first];
      number_reversed[found.first] += found.second;
    }
    for(std::size_t f = 0; f < nf; ++f)
    {
      const auto found = orientation.find(f);
      const bool majority_reversed = 2 * number_reversed[found.first] > number[found.first];
      if(found.second != majority_reversed)
      {
        std::reverse(m_soup.polygons[f].begin(), m_soup.polygons[f].end());
        ++reversed_polygons;
      }
    }
    if(reversed_polygons > 0)
      index_sides();
    return true;
  }

  // The angle of the polygon of a side around the edge low-high, in [0, 2 pi), against the frame
  // (x, y) orthogonal to the edge.
  double angle(std::size_t side, std::size_t low, const Vector_3& x, const Vector_3& y) const
  {
    // A point inside a convex polygon, and good enough in others to tell their order.
    Vector_3 sum = NULL_VECTOR;
    const std::size_t f = m_polygon_of[side];
    for(std::size_t v : m_soup.polygons[f])
      sum = sum + (m_soup.points[v] - m_soup.points[low]);
    const double a = std::atan2(sum * y, sum * x);
    return a < 0 ? a + 2 * CGAL_PI : a;
  }

  void pair_sides()
  {
    m_partner.assign(m_polygon_of.size(), none);
    for_each_edge([&](std::size_t i, std::size_t j)
    {
      if(j - i == 2)
        join_sides(m_edges[i].side, m_edges[i + 1].side);
      else if(j - i > 2)
      {
        ++non_manifold_edges;
        pair_sides_of_edge(i, j);
      }
    });
  }

  void join_sides(std::size_t a, std::size_t b)
  {
    m_partner[a] = b;
    m_partner[b] = a;
  }

  void pair_sides_of_edge(std::size_t first, std::size_t last)
  {
    struct Sheet { double angle; std::size_t side; bool upwards; };

    const Point_3& p = m_soup.points[m_edges[first].low];
    const Vector_3 axis = m_soup.points[m_edges[first].high] - p;
    const Vector_3 helper = std::abs(axis.x()) <= std::abs(axis.y()) && std::abs(axis.x()) <= std::abs(axis.z())
                          ? Vector_3(1, 0, 0)
                          : std::abs(axis.y()) <= std::abs(axis.z()) ? Vector_3(0, 1, 0) : Vector_3(0, 0, 1);
    const Vector_3 x = cross_product(axis, helper);
    const Vector_3 y = cross_product(axis, x) / std::sqrt((std::max)(axis.squared_length(), (std::numeric_limits<double>::min)()));

    std::vector<Sheet> sheets;
    for(std::size_t i = first; i < last; ++i)
      sheets.push_back({ angle(m_edges[i].side, m_edges[i].low, x, y), m_edges[i].side, runs_upwards(m_edges[i].side) });
    std::sort(sheets.begin(), sheets.end(),
              [](const Sheet& a, const Sheet& b) { return std::tie(a.angle, a.side) < std::tie(b.angle, b.side); });

    const std::size_t n = sheets.size();
    bool alternates = (n % 2 == 0);
    for(std::size_t i = 0; i < n; ++i)
      alternates = alternates && sheets[i].upwards != sheets[(i + 1) % n].upwards;

    if(alternates)
    {
      // Counterclockwise about the edge, what follows an upward sheet is outside; so the material lies
      // between it and the downward sheet before it.
      for(std::size_t i = 0; i < n; ++i)
        if(sheets[i].upwards)
          join_sides(sheets[i].side, sheets[(i + n - 1) % n].side);
      return;
    }

    for(;;)
    {
      std::size_t best_a = n, best_b = n;
      double best = -1;
      for(std::size_t a = 0; a < n; ++a)
      {
        for(std::size_t b = 0; b < n; ++b)
        {
          if(!sheets[a].upwards || sheets[b].upwards ||
             m_partner[sheets[a].side] != none || m_partner[sheets[b].side] != none)
            continue;
          const double d = std::abs(sheets[a].angle - sheets[b].angle);
          const double opening = (std::min)(d, 2 * CGAL_PI - d);
          if(opening > best)
          {
            best = opening;
            best_a = a;
            best_b = b;
          }
        }
      }
      if(best_a == n)
        return;
      join_sides(sheets[best_a].side, sheets[best_b].side);
    }
  }

  // Gives every class of corners that hang together its own vertex.
  void split_corners()
  {
    // A corner has the number of the side that starts there.
    Signed_union_find corners(m_polygon_of.size());
    for(std::size_t s = 0; s < m_polygon_of.size(); ++s)
    {
      const std::size_t t = m_partner[s];
      if(t == none || t < s)
        continue;
      corners.join(s, next(t), false);
      corners.join(next(s), t, false);
    }

    std::vector<std::size_t> class_at_vertex(m_soup.points.size(), none); // the first one found there
    std::vector<std::size_t> vertex_of_class(m_polygon_of.size(), none);
    std::vector<char> is_split(m_soup.points.size(), 0);
    std::vector<std::size_t> vertex_of_corner(m_polygon_of.size());
    for(std::size_t c = 0; c < m_polygon_of.size(); ++c)
    {
      const std::size_t v = source(c), k = corners.find(c).first;
      if(vertex_of_class[k] == none)
      {
        if(class_at_vertex[v] == none)
        {
          class_at_vertex[v] = k;
          vertex_of_class[k] = v;
        }
        else
        {
          vertex_of_class[k] = m_soup.points.size();
          m_soup.points.push_back(Point_3(m_soup.points[v]));
          split_vertices += !is_split[v];
          is_split[v] = 1;
        }
      }
      vertex_of_corner[c] = vertex_of_class[k];
    }

    mark_double_edges(vertex_of_corner);
    for(std::size_t c = 0; c < m_polygon_of.size(); ++c)
      m_soup.polygons[m_polygon_of[c]][c - m_first_side[m_polygon_of[c]]] = vertex_of_corner[c];
  }

  // Two pairs that shared one edge may still end at the same two vertices. A mesh has room for one
  // edge there: the others get a vertex in the middle.
  void mark_double_edges(const std::vector<std::size_t>& vertex_of_corner)
  {
    m_midpoint.assign(m_polygon_of.size(), none);
    for_each_edge([&](std::size_t i, std::size_t j)
    {
      if(j - i <= 2)
        return;
      std::vector<std::array<std::size_t, 2> > seen;
      for(std::size_t e = i; e < j; ++e)
      {
        const std::size_t s = m_edges[e].side, t = m_partner[s];
        if(t != none && t < s)
          continue;
        std::array<std::size_t, 2> ends = {{ vertex_of_corner[s], vertex_of_corner[next(s)] }};
        std::sort(ends.begin(), ends.end());
        if(std::find(seen.begin(), seen.end(), ends) == seen.end())
        {
          seen.push_back(ends);
          continue;
        }
        m_midpoint[s] = m_soup.points.size();
        if(t != none)
          m_midpoint[t] = m_soup.points.size();
        m_soup.points.push_back(CGAL::midpoint(m_soup.points[m_edges[e].low], m_soup.points[m_edges[e].high]));
      }
    });
  }

  void insert_midpoints()
  {
    for(std::size_t f = 0; f < m_soup.polygons.size(); ++f)
    {
      const std::size_t first = m_first_side[f], n = size(f);
      for(std::size_t k = n; k-- > 0;)
        if(m_midpoint[first + k] != none)
          m_soup.polygons[f].insert(m_soup.polygons[f].begin() + k + 1, m_midpoint[first + k]);
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_TO_SURFACE_H
