// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_TRIANGLE_SURFACE_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_TRIANGLE_SURFACE_H

#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>
#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// An oriented manifold triangle mesh with borders. Side 3 f + k runs from corner k of triangle f to the next one.
struct Triangle_surface
{
  std::vector<Polygon_soup::Point> points;
  std::vector<std::array<Soup_index, 3>> triangles;
  std::vector<Soup_index> opposite; // per side: that of the neighbor, no_index at the border
};

// Reads a file and makes a surface of it; see read_triangle_mesh(). Returns false if the result says why not.
CGAL_QUAD_MESHING_INLINE bool read_triangle_surface(const std::string& filename, const Mesh_repairs& repairs,
                                                    Triangle_surface& surface, Mesh_reading_result& result);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/IO/internal/Triangle_surface_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_TRIANGLE_SURFACE_H
