// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SIGNED_SETS_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SIGNED_SETS_H

#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Disjoint sets of numbers, each number with a sign relative to the representative of its set.
class Signed_sets
{
  std::vector<Soup_index> m_parent;
  std::vector<char> m_is_reversed; // against the parent

public:
  explicit Signed_sets(std::size_t n) : m_parent(n), m_is_reversed(n, 0)
  {
    std::iota(m_parent.begin(), m_parent.end(), Soup_index(0));
  }

  // The representative of i and whether i is reversed against it.
  std::pair<Soup_index, bool> find(std::size_t i)
  {
    Soup_index root = static_cast<Soup_index>(i);
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

  // Joins the sets of a and b such that b is reversed against a, or not. Returns false if they are in one set already
  // with the other sign. The smaller representative stays.
  bool join(std::size_t a, std::size_t b, bool reversed)
  {
    const auto fa = find(a), fb = find(b);
    const bool between_roots = fa.second ^ fb.second ^ reversed;
    if(fa.first == fb.first)
      return !between_roots;
    const Soup_index root = (std::min)(fa.first, fb.first), other = (std::max)(fa.first, fb.first);
    m_parent[other] = root;
    m_is_reversed[other] = between_roots;
    return true;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SIGNED_SETS_H
