// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_LOCATION_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_LOCATION_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <array>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A point of a face: its weights with respect to the corners 0, 1, 2.
struct Grid_location
{
  int face;
  std::array<double, 3> weights;
};

inline Indexed_triangle_mesh::Point_3 position(const Indexed_triangle_mesh& m, const Grid_location& l)
{
  double c[3] = { 0, 0, 0 };
  for(int k = 0; k < 3; ++k)
    for(int i = 0; i < 3; ++i)
      c[i] += l.weights[k] * m.points[m.corners[l.face][k]][i];
  return Indexed_triangle_mesh::Point_3(c[0], c[1], c[2]);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_LOCATION_H
