// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_DROP_COPIES_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_DROP_COPIES_H

#include <CGAL/Quad_meshing/IO/internal/Point_numbers.h>
#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Quad_meshing/IO/internal/soup_geometry.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Decides about polygons with the same vertices, given as cycles of places without repetitions:
//
//  - of copies in one direction the first one stays;
//  - of the two sides of a face one stays, wherever nothing else is there: sheets and solids whose every face is there
//    once per side, and faces that are needed to close a surface;
//  - both sides stay where they divide a solid: then they are two solids that touch;
//  - none stays in a small fin that stands off a surface which is complete without it.
//
// The last three are decided for whole regions of double faces, joined by edges that no other face has.
class Copied_polygons
{
  // Fins are rests of modelling operations; larger ones are somebody's flags and leaves.
  static constexpr std::size_t most_faces_of_fin = 4;
  static constexpr double largest_area_of_fin = 1e-3; // in squares of the model's diagonal

  struct Double
  {
    std::array<Soup_index, 2> copy; // the first polygon of each direction, no_index if there is none
    std::size_t region;
  };

  struct Double_edge
  {
    Soup_index low, high;
    std::size_t number_of_doubles;
    std::size_t first_double;
    std::size_t number_of_singles;
    std::array<std::pair<Soup_index, bool>, 2> single; // polygon, and whether it runs upwards; the first two
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

  const Polygon_soup& m_places; // the corners are places; the points lie elsewhere
  const std::vector<Soup_vector>& m_points;
  const double m_largest_area;
  std::vector<char> m_is_dropped;
  std::vector<Soup_index> m_other_side;
  std::vector<Soup_index> m_original; // of a dropped copy: the one that may have stayed
  std::vector<Double> m_doubles;
  std::vector<Soup_index> m_double_of; // per polygon
  std::vector<Double_edge> m_edges;
  std::vector<Region> m_regions;

public:
  std::size_t number_dropped = 0;     // copies
  std::size_t number_of_sides = 0;    // those among them that were the other side of what stays
  std::size_t number_in_fins = 0;     // polygons

  Copied_polygons(const Polygon_soup& places, const std::vector<Soup_vector>& points, const Soup_size& size)
    : m_places(places)
    , m_points(points)
    , m_largest_area(largest_area_of_fin * size.diagonal * size.diagonal)
  {}

  // Returns false if there are no copies; else is_dropped() and other_side() are there.
  bool operator()()
  {
    find_doubles();
    if(m_doubles.empty())
      return number_dropped > 0;
    collect_edges();
    make_regions();
    for(Double& d : m_doubles)
      decide(d, m_regions[d.region]);
    return true;
  }

  bool is_dropped(std::size_t f) const { return m_is_dropped[f] != 0; }

  // The polygon that stays for f, no_index if none does.
  Soup_index stays_for(std::size_t f) const
  {
    Soup_index g = static_cast<Soup_index>(f);
    while(g != no_index && m_is_dropped[g])
      g = m_original[g];
    return g;
  }

  // The polygon that was dropped as the other side of f, no_index if there is none.
  Soup_index other_side(std::size_t f) const { return m_other_side[f]; }

private:
  // The cycle from its smallest place in the direction of its smaller neighbor, and whether that reverses it.
  std::pair<std::vector<Soup_index>, bool> canonical(std::size_t f) const
  {
    std::vector<Soup_index> cycle(m_places.begin(f), m_places.end(f));
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    const bool is_reversed = cycle[1] > cycle.back();
    if(is_reversed)
      std::reverse(cycle.begin() + 1, cycle.end());
    return { std::move(cycle), is_reversed };
  }

  void find_doubles()
  {
    const std::size_t n = m_places.size();
    m_is_dropped.assign(n, 0);
    m_other_side.assign(n, no_index);
    m_original.assign(n, no_index);
    std::vector<std::pair<std::uint64_t, Soup_index> > hashes(n);
    for(std::size_t f = 0; f < n; ++f)
    {
      std::uint64_t sum = 0;
      for(const Soup_index* v = m_places.begin(f); v != m_places.end(f); ++v)
        sum += mixed_bits(*v + std::uint64_t(1));
      hashes[f] = { sum, static_cast<Soup_index>(f) };
    }
    std::sort(hashes.begin(), hashes.end());
    for(std::size_t i = 0, j; i < n; i = j)
    {
      for(j = i + 1; j < n && hashes[j].first == hashes[i].first;)
        ++j;
      if(j - i > 1)
        sort_copies(hashes.data() + i, hashes.data() + j);
    }
    std::sort(m_doubles.begin(), m_doubles.end(), [](const Double& a, const Double& b)
              { return (std::min)(a.copy[0], a.copy[1]) < (std::min)(b.copy[0], b.copy[1]); });
  }

  // Polygons with one hash, in ascending order.
  void sort_copies(const std::pair<std::uint64_t, Soup_index>* begin, const std::pair<std::uint64_t, Soup_index>* end)
  {
    typedef std::pair<std::vector<Soup_index>, bool> Cycle;
    std::vector<std::tuple<std::vector<Soup_index>, Soup_index, bool> > cycles;
    for(const auto* it = begin; it != end; ++it)
    {
      Cycle cycle = canonical(it->second);
      cycles.emplace_back(std::move(cycle.first), it->second, cycle.second);
    }
    std::sort(cycles.begin(), cycles.end());
    for(std::size_t i = 0, j; i < cycles.size(); i = j)
    {
      Double d = { {{ no_index, no_index }}, 0 };
      for(j = i; j < cycles.size() && std::get<0>(cycles[j]) == std::get<0>(cycles[i]); ++j)
      {
        const Soup_index f = std::get<1>(cycles[j]);
        Soup_index& first = d.copy[std::get<2>(cycles[j])];
        if(first == no_index)
          first = f;
        else
        {
          m_is_dropped[f] = 1;
          m_original[f] = first;
          ++number_dropped;
        }
      }
      if(j - i > 1)
        m_doubles.push_back(d);
    }
  }

  // The polygon of a double that comes first in the file.
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
    const std::size_t n = m_places.size(f);
    for(std::size_t k = 0; k < n; ++k)
      call(m_places.begin(f)[k], m_places.begin(f)[k + 1 == n ? 0 : k + 1]);
  }

  void collect_edges()
  {
    m_double_of.assign(m_places.size(), no_index);
    std::vector<char> is_touched(m_points.size(), 0);
    std::vector<std::array<Soup_index, 3> > sides; // low, high, double
    for(std::size_t d = 0; d < m_doubles.size(); ++d)
    {
      for(Soup_index f : m_doubles[d].copy)
        if(f != no_index)
          m_double_of[f] = static_cast<Soup_index>(d);
      for_each_side(first_copy(m_doubles[d]), [&](Soup_index a, Soup_index b)
      {
        is_touched[a] = is_touched[b] = 1;
        sides.push_back({{ (std::min)(a, b), (std::max)(a, b), static_cast<Soup_index>(d) }});
      });
    }
    std::sort(sides.begin(), sides.end());
    for(const auto& side : sides)
    {
      if(m_edges.empty() || m_edges.back().low != side[0] || m_edges.back().high != side[1])
        m_edges.push_back({ side[0], side[1], 0, side[2], 0, {} });
      ++m_edges.back().number_of_doubles;
    }
    for(std::size_t f = 0; f < m_places.size(); ++f)
    {
      if(m_double_of[f] != no_index || m_is_dropped[f])
        continue;
      for_each_side(f, [&](Soup_index a, Soup_index b)
      {
        Double_edge* const e = is_touched[a] && is_touched[b] ? find_edge(a, b) : nullptr;
        if(e == nullptr)
          return;
        if(e->number_of_singles < 2)
          e->single[e->number_of_singles] = { static_cast<Soup_index>(f), a < b };
        ++e->number_of_singles;
      });
    }
  }

  void make_regions()
  {
    Disjoint_sets regions(static_cast<int>(m_doubles.size()));
    for(std::size_t d = 0; d < m_doubles.size(); ++d)
      for_each_side(first_copy(m_doubles[d]), [&](Soup_index a, Soup_index b)
      {
        const Double_edge& e = *find_edge(a, b);
        if(e.number_of_singles == 0 && e.number_of_doubles == 2)
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
      for_each_side(first_copy(m_doubles[d]), [&](Soup_index a, Soup_index b)
      {
        const Double_edge& e = *find_edge(a, b);
        r.is_missed = r.is_missed || e.number_of_singles == 1;
        r.is_attached = r.is_attached || e.number_of_singles > 1;
        r.is_free = r.is_free || (e.number_of_singles == 0 && e.number_of_doubles == 1);
        if(e.number_of_singles > 0 || e.number_of_doubles > 2)
          r.divides = r.divides && is_inside(e, first_copy(m_doubles[d]));
      });
    }
  }

  Soup_vector centroid(std::size_t f) const
  {
    Soup_vector sum = {{ 0, 0, 0 }};
    for(const Soup_index* v = m_places.begin(f); v != m_places.end(f); ++v)
      for(std::size_t k = 0; k < 3; ++k)
        sum[k] += m_points[*v][k];
    return soup_scaled(sum, 1. / static_cast<double>(m_places.size(f)));
  }

  double area(std::size_t f) const
  {
    Soup_vector sum = {{ 0, 0, 0 }};
    const Polygon_soup::Point& o = m_points[*m_places.begin(f)];
    for_each_side(f, [&](Soup_index a, Soup_index b)
    {
      const Soup_vector n = soup_cross(soup_difference(m_points[a], o), soup_difference(m_points[b], o));
      for(std::size_t k = 0; k < 3; ++k)
        sum[k] += n[k];
    });
    return 0.5 * soup_length(sum);
  }

  // Whether a double face lies between the two other faces of an edge, on the side of their material. That is the side
  // from which one comes to a face that runs upwards, counterclockwise around the edge.
  bool is_inside(const Double_edge& e, std::size_t f) const
  {
    if(e.number_of_singles != 2 || e.number_of_doubles != 1 || e.single[0].second == e.single[1].second)
      return false;
    const Angles_around_edge angle(m_points[e.low], m_points[e.high]);
    const bool first_is_up = e.single[0].second;
    const double up = angle(centroid(e.single[first_is_up ? 0 : 1].first));
    const double down = angle(centroid(e.single[first_is_up ? 1 : 0].first));
    auto turn = [](double from, double to) { return to >= from ? to - from : to - from + 2 * CGAL_PI; };
    return turn(down, angle(centroid(f))) < turn(down, up);
  }

  void decide(const Double& d, const Region& r)
  {
    if(r.is_attached && !r.is_free && !r.is_missed && r.divides)
      return;
    if(r.is_attached && r.is_free && !r.is_missed && r.faces <= most_faces_of_fin && r.area <= m_largest_area)
    {
      // The dropped copies in one direction count here, not there.
      for(Soup_index f : d.copy)
        if(f != no_index)
        {
          m_is_dropped[f] = 1;
          ++number_in_fins;
        }
      return;
    }
    if(d.copy[0] == no_index || d.copy[1] == no_index)
      return;
    const Soup_index kept = first_copy(d), dropped = (std::max)(d.copy[0], d.copy[1]);
    m_is_dropped[dropped] = 1;
    m_original[dropped] = kept;
    ++number_dropped;
    ++number_of_sides;
    m_other_side[kept] = dropped;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_DROP_COPIES_H
