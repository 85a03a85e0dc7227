// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_POINT_NUMBERS_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_POINT_NUMBERS_H

#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A number with well mixed bits, the same on every machine (the finalizer of MurmurHash3).
inline std::uint64_t mixed_bits(std::uint64_t x)
{
  x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdULL;
  x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33);
}

// Gives equal points one number: a table with open addressing of positions in a vector of points.
class Point_numbers
{
  const std::vector<Polygon_soup::Point>& m_points;
  std::vector<Soup_index> m_table;
  std::size_t m_size = 0;

  static std::uint64_t hash(const Polygon_soup::Point& p)
  {
    std::uint64_t h = 0;
    for(double x : p)
    {
      x += 0.; // -0 and 0 are one place
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof(bits));
      h = mixed_bits(h * 31 + bits);
    }
    return h;
  }

  void insert(Soup_index v)
  {
    std::size_t i = hash(m_points[v]) & (m_table.size() - 1);
    while(m_table[i] != no_index)
      i = (i + 1) & (m_table.size() - 1);
    m_table[i] = v;
  }

public:
  // The points may grow later.
  explicit Point_numbers(const std::vector<Polygon_soup::Point>& points, std::size_t expected) : m_points(points)
  {
    std::size_t capacity = 16;
    while(capacity < 2 * expected)
      capacity *= 2;
    m_table.assign(capacity, no_index);
  }

  // The number of the first point that was found here and is equal to p, or `number`, which is then the number of p.
  Soup_index find(const Polygon_soup::Point& p, Soup_index number)
  {
    if(2 * m_size >= m_table.size())
    {
      std::vector<Soup_index> old(2 * m_table.size(), no_index);
      old.swap(m_table);
      for(Soup_index v : old)
        if(v != no_index)
          insert(v);
    }
    std::size_t i = hash(p) & (m_table.size() - 1);
    for(; m_table[i] != no_index; i = (i + 1) & (m_table.size() - 1))
      if(m_points[m_table[i]] == p)
        return m_table[i];
    m_table[i] = number;
    ++m_size;
    return number;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_POINT_NUMBERS_H
