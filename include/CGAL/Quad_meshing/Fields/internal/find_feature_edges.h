// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_EDGES_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_EDGES_H

#include <CGAL/Quad_meshing/Fields/Feature_edges_result.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The feature edges of a mesh, one flag per edge; see `detect_feature_edges()`.
CGAL_QUAD_MESHING_INLINE Feature_edges_result find_feature_edges(const Indexed_triangle_mesh& mesh,
                                                                 double angle_in_degrees, double target_edge_length,
                                                                 std::vector<char>& is_feature);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Fields/internal/find_feature_edges_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_EDGES_H
