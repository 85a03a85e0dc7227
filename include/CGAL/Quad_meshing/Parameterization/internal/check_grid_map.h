// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CHECK_GRID_MAP_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CHECK_GRID_MAP_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Which simplices of a map break a condition of integer-grid maps, by their numbers.
struct Grid_map_defects
{
  std::vector<int> edges_without_transition;
  std::vector<int> vertices_off_grid;
  std::vector<int> folded_faces;
  std::vector<int> edges_off_grid;
  std::vector<int> faces_not_finite; // if there are some, nothing else is looked at
};

// `uv` per halfedge: the image of its source in the chart of its face.
CGAL_QUAD_MESHING_INLINE Grid_map_defects check_grid_map(const Indexed_triangle_mesh& mesh,
                                                         const std::vector<std::array<double, 2>>& uv,
                                                         const std::vector<bool>& is_aligned);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Parameterization/internal/check_grid_map_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CHECK_GRID_MAP_H
