// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GUIDES_CUT_TRIANGLES_H
#define CGAL_QUAD_MESHING_GUIDES_CUT_TRIANGLES_H

#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Triangles in flat arrays. Side k of a triangle runs from corner k to corner k + 1.
struct Guided_triangles
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;

  std::vector<Point_3> points;
  std::vector<std::array<int, 3>> triangles;
};

// A place in a triangle: the weights of its corners.
struct Triangle_place
{
  int triangle;
  std::array<double, 3> weight;
};

// What became of triangles that were cut along curves.
struct Cut_triangles : Guided_triangles
{
  std::vector<std::size_t> origin;           // per triangle: the one that it lies in
  std::vector<std::array<char, 3>> side;     // per triangle: the side of the origin that a side lies on, or `inside`
  std::vector<std::array<char, 3>> is_curve; // per triangle: whether a side lies on a curve
  std::string error;                         // a sentence; empty if all went well

  static constexpr char inside = 3;
};

// Cuts triangles along curves: any two consecutive places of a curve lie in a common triangle, sides and corners
// included. Where curves cross, there is a vertex. The points that were there keep their numbers.
CGAL_QUAD_MESHING_INLINE Cut_triangles cut_triangles(const Guided_triangles& input,
                                                     const std::vector<std::vector<Triangle_place>>& curves);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Guides/internal/cut_triangles_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_GUIDES_CUT_TRIANGLES_H
