// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_NUMBER_FUNCTIONS_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_NUMBER_FUNCTIONS_H

#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the windows need of a number type: arithmetic, comparisons, a square root found by argument
// dependent lookup, conversion to double, explicit or by `CGAL::to_double()`, and `std::numeric_limits`. CGAL's own
// functions know double but not the floating point types of Boost.Multiprecision.

template <typename FT>
FT square_root(const FT& x)
{
  using std::sqrt;
  return sqrt(x);
}

template <typename FT>
FT absolute(const FT& x)
{
  return x < FT(0) ? FT(-x) : x;
}
inline double absolute(double x) { return std::fabs(x); }

template <typename FT>
std::enable_if_t<std::is_constructible<double, const FT&>::value, double> as_double(const FT& x)
{
  return static_cast<double>(x);
}
template <typename FT>
std::enable_if_t<!std::is_constructible<double, const FT&>::value, double> as_double(const FT& x)
{
  return CGAL::to_double(x);
}

// A tolerance that is 10^-d for double, as much smaller for a type of more digits, and zero for an exact type.
template <typename FT>
double tolerance_of_digits(double d)
{
  return std::numeric_limits<FT>::digits10 == 0
           ? 0.
           : std::pow(10., -d * std::numeric_limits<FT>::digits10 / std::numeric_limits<double>::digits10);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_NUMBER_FUNCTIONS_H
