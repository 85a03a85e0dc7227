// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_SIZES_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_SIZES_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The local feature size of every face, see `local_feature_size()`. Returns false if the visitor stops it.
CGAL_QUAD_MESHING_INLINE bool find_feature_sizes(const Indexed_triangle_mesh& mesh, Stage_progress& progress,
                                                 std::vector<double>& size);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Fields/internal/find_feature_sizes_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_SIZES_H
