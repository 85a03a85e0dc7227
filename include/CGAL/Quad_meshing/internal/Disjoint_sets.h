// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_DISJOINT_SETS_H
#define CGAL_QUAD_MESHING_INTERNAL_DISJOINT_SETS_H

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A partition of the numbers 0, ..., n - 1: Boost's disjoint sets with storage of its own.
//
// Boost's own class with storage uses iterators as property maps. Its calls of get() find those of Boost's compressed
// graph alone, once a header of CGAL has included that graph; property maps that are classes of Boost are found always.
class Disjoint_sets
{
  typedef boost::iterator_property_map<std::vector<int>::iterator, boost::typed_identity_property_map<int>> Map;

public:
  explicit Disjoint_sets(int n)
    : m_rank(n, 0), m_parent(n), m_smallest(n), m_sets(Map(m_rank.begin()), Map(m_parent.begin()))
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
    std::iota(m_smallest.begin(), m_smallest.end(), 0);
  }

  // The iterators of a vector stay valid when it is moved, so the maps need no repair.
  Disjoint_sets(Disjoint_sets&&) = default;
  Disjoint_sets& operator=(Disjoint_sets&&) = default;

  // Some element that stands for the set of i.
  int find(int i) { return m_sets.find_set(i); }

  // The smallest element of the set of i, whatever the order in which it was joined.
  int smallest(int i) { return m_smallest[find(i)]; }

  bool are_joined(int i, int j) { return find(i) == find(j); }

  // Returns whether they were in different sets before.
  bool join(int i, int j)
  {
    const int a = find(i), b = find(j);
    if(a == b)
      return false;
    m_sets.link(a, b);
    m_smallest[find(a)] = (std::min)(m_smallest[a], m_smallest[b]);
    return true;
  }

private:
  std::vector<int> m_rank, m_parent;
  std::vector<int> m_smallest; // per representative
  boost::disjoint_sets<Map, Map> m_sets;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_DISJOINT_SETS_H
