// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_OPTIMIZE_INDEXED_QUAD_STRUCTURE_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_OPTIMIZE_INDEXED_QUAD_STRUCTURE_H

#include <CGAL/Quad_meshing/Smoothing/Smoothing_reference.h>
#include <CGAL/Quad_meshing/Structure/Quad_structure_optimization_result.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The named parameters of `optimize_quad_structure()`.
struct Structure_options
{
  Structure_method method = Structure_method::LAYOUT;
  bool merge_singularities = false;
  bool collapse_dual_curves = false;
  std::size_t target_quads = 0;
  std::size_t target_patches = 0;
  bool is_layout_wanted = false; // the base complex alone: quads are made anew along it, as many as are wanted
  unsigned int layouts = 10000;
  unsigned int smoothing_iterations = 20;
  double maximum_running_time = (std::numeric_limits<double>::infinity)(); // seconds
};

// Optimizes the mesh of `state`, which has faces. If the visitor asks for an end, the state is of no use.
CGAL_QUAD_MESHING_INLINE Quad_structure_optimization_result optimize_indexed_quad_structure(
  Structure_state& state, Smoothing_reference& reference, const Structure_options& options, Any_visitor& visitor);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Structure/internal/optimize_indexed_quad_structure_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_OPTIMIZE_INDEXED_QUAD_STRUCTURE_H
