// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUAD_COUNTS_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUAD_COUNTS_H

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// By which factor, as a logarithm, a number of quads misses the one asked for.
inline double count_deviation(double quads, double requested)
{
  return quads > 0 ? std::abs(std::log(quads / requested)) : 1e9;
}

// Whether a number of quads needs no better one. What a user may count on is ten percent; the rest is for what the
// smoothing and the optimization of the structure change afterwards.
inline bool is_about(double quads, double requested)
{
  const double tolerance = 0.08;
  return quads >= (1 - tolerance) * requested && quads <= (1 + tolerance) * requested;
}

// The length of quad edges in one of several components: where quads of the length asked for are too few for a mesh, it
// is shorter.
inline double edge_length_of_component(double area, double length, std::size_t number_of_components)
{
  const double least_quads = 24; // four on each side of a cube
  return number_of_components > 1 && area > 0 ? (std::min)(length, std::sqrt(area / least_quads)) : length;
}

// Whether a number of quads is what a user may count on without being told otherwise.
inline bool is_as_promised(double quads, double requested)
{
  const double tolerance = 0.1;
  return quads >= (1 - tolerance) * requested && quads <= (1 + tolerance) * requested;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUAD_COUNTS_H
