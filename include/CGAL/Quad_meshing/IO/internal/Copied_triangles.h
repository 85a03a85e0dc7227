// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_COPIED_TRIANGLES_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_COPIED_TRIANGLES_H

#include <CGAL/Quad_meshing/IO/internal/Soup_triangles.h>
#include <CGAL/Quad_meshing/IO/internal/soup_geometry.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Decides about triangles with their corners at the same three places:
//
//  - of copies in one direction the first one stays;
//  - of the two sides of a face one stays, wherever nothing else is there: sheets and solids whose every face is there
//    once per side, and faces that are needed to close a surface;
//  - both sides stay where they divide a solid: then they are two solids that touch;
//  - none stays in a small fin that stands off a surface which is complete without it.
//
// The last three are decided for whole regions of double faces, joined by edges that no single face has.
class Copied_triangles
{
  // Fins are rests of modelling operations; larger ones are somebody's flags and leaves.
  static constexpr std::size_t most_faces_of_fin = 4;
  static constexpr double largest_area_of_fin = 1e-3; // in squares of the model's diagonal

  struct Double
  {
    std::array<Soup_index, 2> copy; // the first triangle of each direction, no_index if there is none
    std::size_t region;
  };

  struct Double_edge
  {
    Soup_index low, high;
    std::size_t number_of_doubles;
    std::size_t first_double;
    std::vector<std::pair<Soup_index, bool>> singles; // other triangles, and whether they run upwards
  };

  struct Region
  {
    std::size_t faces = 0;
    double area = 0;
    bool is_missed = false;   // an edge with one other face
    bool is_attached = false; // an edge with several other faces
    bool is_free = false;     // an edge without any
    bool divides = true;      // there is material on both of its sides wherever it is attached
  };

  const Soup_triangles& m_triangles;
  const double m_largest_area;
  std::vector<char> m_is_dropped;
  std::vector<Soup_index> m_other_side;
  std::vector<Soup_index> m_original; // of a dropped copy: the one that may have stayed
  std::vector<Double> m_doubles;
  std::vector<Soup_index> m_double_of; // per triangle
  std::vector<Double_edge> m_edges;
  std::vector<Region> m_regions;

public:
  Copied_triangles(const Soup_triangles& triangles, const Soup_size& size)
    : m_triangles(triangles), m_largest_area(largest_area_of_fin * size.diagonal * size.diagonal)
  {
  }

  // Returns false if there are no copies; else is_dropped() and the others are there.
  bool operator()()
  {
    find_doubles();
    if(m_doubles.empty())
      return false;
    collect_edges();
    make_regions();
    for(Double& d : m_doubles)
      decide(d, m_regions[d.region]);
    return true;
  }

  bool is_dropped(std::size_t f) const { return m_is_dropped[f] != 0; }

  // Whether a triangle was dropped and no other one stays for it.
  bool is_in_fin(std::size_t f) const { return m_is_dropped[f] && stays_for(f) == no_index; }

  // Whether a triangle was dropped as the other side of one that stays.
  bool is_other_side(std::size_t f) const
  {
    return m_is_dropped[f] && stays_for(f) != no_index && m_other_side[stays_for(f)] == f;
  }

  // The triangle that stays for f, no_index if none does.
  Soup_index stays_for(std::size_t f) const
  {
    Soup_index g = static_cast<Soup_index>(f);
    while(g != no_index && m_is_dropped[g])
      g = m_original[g];
    return g;
  }

  // The triangle that was dropped as the other side of f, no_index if there is none.
  Soup_index other_side(std::size_t f) const { return m_other_side[f]; }

private:
  void find_doubles()
  {
    struct Sorted
    {
      std::array<Soup_index, 3> places; // in ascending order
      Soup_index triangle;
      bool is_odd; // the order of the corners
    };
    const std::size_t n = m_triangles.size();
    m_is_dropped.assign(n, 0);
    m_other_side.assign(n, no_index);
    m_original.assign(n, no_index);
    std::vector<Sorted> sorted;
    sorted.reserve(n);
    for(std::size_t f = 0; f < n; ++f)
    {
      std::array<Soup_index, 3> p = { { place(f, 0), place(f, 1), place(f, 2) } };
      const bool is_odd = (p[0] > p[1]) != (p[1] > p[2]) ? p[0] < p[2] : p[0] > p[2];
      std::sort(p.begin(), p.end());
      sorted.push_back({ p, static_cast<Soup_index>(f), is_odd });
    }
    std::sort(sorted.begin(), sorted.end(),
              [](const Sorted& a, const Sorted& b)
              { return std::tie(a.places, a.triangle) < std::tie(b.places, b.triangle); });
    for(std::size_t i = 0, j; i < n; i = j)
    {
      Double d = { { { no_index, no_index } }, 0 };
      for(j = i; j < n && sorted[j].places == sorted[i].places; ++j)
      {
        const Soup_index f = sorted[j].triangle;
        Soup_index& first = d.copy[sorted[j].is_odd];
        if(first == no_index)
          first = f;
        else
        {
          m_is_dropped[f] = 1;
          m_original[f] = first;
        }
      }
      if(j - i > 1)
        m_doubles.push_back(d);
    }
    std::sort(m_doubles.begin(), m_doubles.end(),
              [&](const Double& a, const Double& b) { return first_copy(a) < first_copy(b); });
  }

  Soup_index place(std::size_t f, std::size_t k) const { return m_triangles.place_of(m_triangles.corners[f][k]); }

  // The triangle of a double that comes first in the file.
  Soup_index first_copy(const Double& d) const { return (std::min)(d.copy[0], d.copy[1]); }

  Double_edge* find_edge(Soup_index a, Soup_index b)
  {
    const std::pair<Soup_index, Soup_index> key = std::minmax(a, b);
    const auto found = std::lower_bound(m_edges.begin(), m_edges.end(), key,
                                        [](const Double_edge& e, const std::pair<Soup_index, Soup_index>& k)
                                        { return std::tie(e.low, e.high) < std::tie(k.first, k.second); });
    return found != m_edges.end() && found->low == key.first && found->high == key.second ? &*found : nullptr;
  }

  template <typename F>
  void for_each_side(std::size_t f, F call) const
  {
    for(std::size_t k = 0; k < 3; ++k)
      call(place(f, k), place(f, (k + 1) % 3));
  }

  void collect_edges()
  {
    m_double_of.assign(m_triangles.size(), no_index);
    std::vector<char> is_touched(m_triangles.points.size(), 0);
    std::vector<std::array<Soup_index, 3>> sides; // low, high, double
    for(std::size_t d = 0; d < m_doubles.size(); ++d)
    {
      for(Soup_index f : m_doubles[d].copy)
        if(f != no_index)
          m_double_of[f] = static_cast<Soup_index>(d);
      for_each_side(first_copy(m_doubles[d]),
                    [&](Soup_index a, Soup_index b)
                    {
                      is_touched[a] = is_touched[b] = 1;
                      sides.push_back({ { (std::min)(a, b), (std::max)(a, b), static_cast<Soup_index>(d) } });
                    });
    }
    std::sort(sides.begin(), sides.end());
    for(const auto& side : sides)
    {
      if(m_edges.empty() || m_edges.back().low != side[0] || m_edges.back().high != side[1])
        m_edges.push_back({ side[0], side[1], 0, side[2], {} });
      ++m_edges.back().number_of_doubles;
    }
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
    {
      if(m_double_of[f] != no_index || m_is_dropped[f])
        continue;
      for_each_side(f,
                    [&](Soup_index a, Soup_index b)
                    {
                      Double_edge* const e = is_touched[a] && is_touched[b] ? find_edge(a, b) : nullptr;
                      if(e != nullptr)
                        e->singles.emplace_back(static_cast<Soup_index>(f), a < b);
                    });
    }
  }

  void make_regions()
  {
    Disjoint_sets regions(static_cast<int>(m_doubles.size()));
    for(std::size_t d = 0; d < m_doubles.size(); ++d)
      for_each_side(first_copy(m_doubles[d]),
                    [&](Soup_index a, Soup_index b)
                    {
                      const Double_edge& e = *find_edge(a, b);
                      if(e.singles.empty())
                        regions.join(static_cast<int>(d), static_cast<int>(e.first_double));
                    });
    m_regions.resize(m_doubles.size());
    for(std::size_t d = 0; d < m_doubles.size(); ++d)
    {
      m_doubles[d].region = static_cast<std::size_t>(regions.find(static_cast<int>(d)));
      Region& r = m_regions[m_doubles[d].region];
      ++r.faces;
      r.area += area(first_copy(m_doubles[d]));
      r.divides = r.divides && m_doubles[d].copy[0] != no_index && m_doubles[d].copy[1] != no_index;
      for_each_side(first_copy(m_doubles[d]),
                    [&](Soup_index a, Soup_index b)
                    {
                      const Double_edge& e = *find_edge(a, b);
                      r.is_missed = r.is_missed || e.singles.size() == 1;
                      r.is_attached = r.is_attached || e.singles.size() > 1;
                      r.is_free = r.is_free || (e.singles.empty() && e.number_of_doubles == 1);
                      if(!e.singles.empty())
                        r.divides = r.divides && is_inside(e, first_copy(m_doubles[d]));
                    });
    }
  }

  double area(std::size_t f) const
  {
    const Soup_vector& p = m_triangles.point(f, 0);
    return 0.5 * soup_length(soup_cross(soup_difference(m_triangles.point(f, 1), p),
                                        soup_difference(m_triangles.point(f, 2), p)));
  }

  // Whether a double face lies in the material between the other faces of an edge, which must bound some.
  // Counterclockwise around the edge, material ends at a face that runs upwards and begins at one that runs downwards.
  bool is_inside(const Double_edge& e, std::size_t f) const
  {
    const Angles_around_edge angle_of_point(m_triangles.points[e.low], m_triangles.points[e.high]);
    auto angle = [&](std::size_t g)
    {
      for(std::size_t k = 0; k < 3; ++k)
        if(place(g, k) != e.low && place(g, k) != e.high)
          return angle_of_point(m_triangles.point(g, k));
      return 0.;
    };
    std::vector<std::pair<double, bool>> singles;
    for(const auto& single : e.singles)
      singles.emplace_back(angle(single.first), single.second);
    std::sort(singles.begin(), singles.end());
    for(std::size_t i = 0; i < singles.size(); ++i)
      if(singles[i].second == singles[(i + 1) % singles.size()].second)
        return false;
    // the last one before the double face
    const auto after = std::upper_bound(singles.begin(), singles.end(), std::make_pair(angle(f), false));
    return !(after == singles.begin() ? singles.back() : *(after - 1)).second;
  }

  void decide(const Double& d, const Region& r)
  {
    if(r.is_attached && !r.is_free && !r.is_missed && r.divides)
      return;
    if(r.is_attached && r.is_free && !r.is_missed && r.faces <= most_faces_of_fin && r.area <= m_largest_area)
    {
      for(Soup_index f : d.copy)
        if(f != no_index)
          m_is_dropped[f] = 1;
      return;
    }
    if(d.copy[0] == no_index || d.copy[1] == no_index)
      return;
    const Soup_index kept = first_copy(d), dropped = (std::max)(d.copy[0], d.copy[1]);
    m_is_dropped[dropped] = 1;
    m_original[dropped] = kept;
    m_other_side[kept] = dropped;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_COPIED_TRIANGLES_H
