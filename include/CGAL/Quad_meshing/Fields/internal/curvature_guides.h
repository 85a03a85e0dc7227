// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_CURVATURE_GUIDES_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_CURVATURE_GUIDES_H

#include <CGAL/Quad_meshing/Fields/Curvature_guide_result.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The direction of every salient face, the zero vector for all other faces; see `salient_directions()`.
CGAL_QUAD_MESHING_INLINE Curvature_guide_result
find_salient_directions(const Indexed_triangle_mesh& mesh, double target_edge_length, double minimum_anisotropy,
                        Any_visitor& visitor, std::vector<Indexed_triangle_mesh::Vector_3>& direction);

// The target edge length of every face; see `curvature_sizing()`.
// The radius of curvature where the surface is flat.
constexpr double flat_radius = 1e300;

// The radius of the stronger principal curvature of every face, averaged over disks of at least a given radius that end
// at features (per edge, or empty). Returns false if the visitor stops it.
CGAL_QUAD_MESHING_INLINE bool find_curvature_radii(const Indexed_triangle_mesh& mesh,
                                                   const std::vector<char>& is_feature, double least_disk,
                                                   Stage_progress& progress, std::vector<double>& radius);

CGAL_QUAD_MESHING_INLINE Curvature_guide_result find_curvature_sizing(const Indexed_triangle_mesh& mesh,
                                                                      double tolerance, double minimum, double maximum,
                                                                      double gradation, Any_visitor& visitor,
                                                                      std::vector<double>& length);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Fields/internal/curvature_guides_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_CURVATURE_GUIDES_H
