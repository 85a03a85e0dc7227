// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SIDE_GROUPS_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SIDE_GROUPS_H

#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The sides of faces, those with the same two ends behind each other. A side has the number of the corner where it
// begins; sides whose two ends are the same are left out. Within a group sides are in ascending order.
class Side_groups
{
  struct Entry
  {
    Soup_index high, side;
  };

  std::vector<Entry> m_entries;
  std::vector<Soup_index> m_first; // per lower end, and the end

public:
  // source(s) and target(s) give the ends of side s < n, numbers below `ends`.
  template <typename Source, typename Target>
  Side_groups(std::size_t n, std::size_t ends, Source source, Target target) : m_first(ends + 1, 0)
  {
    for(std::size_t s = 0; s < n; ++s)
    {
      const Soup_index a = source(s), b = target(s);
      if(a != b)
        ++m_first[(std::min)(a, b) + 1];
    }
    for(std::size_t v = 0; v < ends; ++v)
      m_first[v + 1] += m_first[v];
    m_entries.resize(m_first[ends]);
    std::vector<Soup_index> next(m_first.begin(), m_first.end() - 1);
    for(std::size_t s = 0; s < n; ++s)
    {
      const Soup_index a = source(s), b = target(s);
      if(a != b)
        m_entries[next[(std::min)(a, b)]++] = { (std::max)(a, b), static_cast<Soup_index>(s) };
    }
    for(std::size_t v = 0; v < ends; ++v)
      std::sort(m_entries.begin() + m_first[v], m_entries.begin() + m_first[v + 1],
                [](const Entry& a, const Entry& b)
                { return a.high < b.high || (a.high == b.high && a.side < b.side); });
  }

  // Calls f(low, high, sides) for every group; the vector is the same one each time.
  template <typename F>
  void for_each(F f) const
  {
    std::vector<Soup_index> sides;
    for(std::size_t v = 0; v + 1 < m_first.size(); ++v)
      for(std::size_t i = m_first[v], j; i < m_first[v + 1]; i = j)
      {
        sides.clear();
        for(j = i; j < m_first[v + 1] && m_entries[j].high == m_entries[i].high; ++j)
          sides.push_back(m_entries[j].side);
        f(static_cast<Soup_index>(v), m_entries[i].high, sides);
      }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SIDE_GROUPS_H
