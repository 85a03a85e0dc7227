// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_BUILD_WORKING_MESH_H
#define CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_BUILD_WORKING_MESH_H

#include <CGAL/Quad_meshing/Working_mesh/Working_mesh_result.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Reference_surface.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A working mesh in flat arrays.
struct Working_triangles
{
  std::vector<Indexed_triangle_mesh::Point_3> points;
  std::vector<int> input_face; // per vertex: a face of the input at or near the vertex
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<char, 3>> is_feature; // per triangle: whether the side that starts at a corner is a feature
};

// is_feature: per edge of the input
// `face_length`: the target edge length per face, or empty where it is the same everywhere.
CGAL_QUAD_MESHING_INLINE Working_mesh_result build_working_mesh(Reference_surface& input,
                                                                const std::vector<char>& is_feature,
                                                                double target_edge_length,
                                                                const std::vector<double>& face_length,
                                                                Any_visitor& visitor, Working_triangles& result);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Working_mesh/internal/build_working_mesh_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_BUILD_WORKING_MESH_H
