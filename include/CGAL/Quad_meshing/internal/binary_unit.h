// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_BINARY_UNIT_H
#define CGAL_QUAD_MESHING_INTERNAL_BINARY_UNIT_H

#include <cmath>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The power of two such that its multiples up to `largest` in absolute value have so many significant bits. Sums of
// such multiples are exact in doubles as long as they need 53 bits at most.
inline double binary_unit(double largest, int significant_bits)
{
  return std::ldexp(1., std::ilogb(largest) + 1 - significant_bits);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_BINARY_UNIT_H
