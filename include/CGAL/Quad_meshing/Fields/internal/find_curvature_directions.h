// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_CURVATURE_DIRECTIONS_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_CURVATURE_DIRECTIONS_H

#include <CGAL/Quad_meshing/Fields/Curvature_guide_result.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The directions in which the surface bends least, of length one, in some faces, and their weights; see
// `curvature_directions()`. `is_feature` has a value per edge, `face_length` the target edge length per face, or
// nothing where it is the same everywhere.
CGAL_QUAD_MESHING_INLINE Curvature_guide_result find_curvature_directions(
  const Indexed_triangle_mesh& mesh, double target_edge_length, const std::vector<double>& face_length,
  const std::vector<char>& is_feature, std::optional<double> minimum_anisotropy, Any_visitor& visitor,
  std::vector<Indexed_triangle_mesh::Vector_3>& direction, std::vector<double>& weight);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Fields/internal/find_curvature_directions_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_CURVATURE_DIRECTIONS_H
