// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_SPATIAL_NUMBERS_H
#define CGAL_QUAD_MESHING_INTERNAL_SPATIAL_NUMBERS_H

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The numbers that elements get when they are sorted by keys from 0 to n - 1; elements of the same key keep their
// order.
inline std::vector<int> numbers_in_order(const std::vector<int>& keys, std::size_t n)
{
  std::vector<int> next(n, 0);
  for(int key : keys)
    ++next[key];
  int sum = 0;
  for(int& count : next)
  {
    const int first = sum;
    sum += count;
    count = first;
  }
  std::vector<int> numbers;
  numbers.reserve(keys.size());
  for(int key : keys)
    numbers.push_back(next[key]++);
  return numbers;
}

// The cells of a grid of about as many cells as there are points, in the order of the Z-curve (Morton 1966): most cells
// that are neighbours in space are near each other in that order.
class Z_curve
{
public:
  Z_curve(const Bbox_3& box, std::size_t number_of_points)
  {
    while((std::size_t(8) << (3 * m_bits)) <= number_of_points)
      ++m_bits;
    // half of each number, as the extent may be too large for the type
    double extent = 0;
    for(int k = 0; k < 3; ++k)
    {
      m_corner[k] = box.min(k) / 2;
      extent = (std::max)(extent, box.max(k) / 2 - m_corner[k]);
    }
    m_extent = extent > 0 ? extent : 1;
  }

  std::size_t number_of_cells() const { return std::size_t(1) << (3 * m_bits); }

  template <typename Point_3>
  int cell(const Point_3& p) const
  {
    int cell = 0;
    for(int k = 0; k < 3; ++k)
    {
      const int place =
        (std::min)(static_cast<int>((p[k] / 2 - m_corner[k]) / m_extent * cells_of_side()), cells_of_side() - 1);
      for(int bit = 0; bit < m_bits; ++bit)
        cell |= (place >> bit & 1) << (3 * bit + k);
    }
    return cell;
  }

private:
  int cells_of_side() const { return 1 << m_bits; }

  int m_bits = 0;
  double m_corner[3], m_extent;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_SPATIAL_NUMBERS_H
