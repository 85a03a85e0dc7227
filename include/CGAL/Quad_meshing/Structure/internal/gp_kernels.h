// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_KERNELS_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_KERNELS_H

#include <CGAL/Quad_meshing/Structure/internal/Gp_path.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the public functions on grid-preserving operators do, on flat arrays. `merge_singularities` is their named
// parameter.

// Searches an operator that begins with a step, in the numbers of `gp_step()`. Without `cost`, it has few steps, else a
// small sum of the costs of its steps. Empty if none is found.
CGAL_QUAD_MESHING_INLINE Gp_path find_gp_operator(const Structure_state& state, bool merge_singularities,
                                                  int first_step, const std::function<double(const Gp_step&)>& cost);

// The operator that does the same to all edges that the dual curve through h crosses; empty if it is not allowed.
CGAL_QUAD_MESHING_INLINE Gp_path dual_curve_gp_operator(const Structure_state& state, bool merge_singularities, int h,
                                                        Gp_kind kind);

// Executes an operator; false if it is no closed path, not allowed, or its result cannot be represented.
CGAL_QUAD_MESHING_INLINE bool apply_gp_operator(const Structure_state& state, bool merge_singularities,
                                                const Gp_path& path, Structure_state& result);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Structure/internal/gp_kernels_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_KERNELS_H
