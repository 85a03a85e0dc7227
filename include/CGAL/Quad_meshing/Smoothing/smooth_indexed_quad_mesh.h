// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_SMOOTH_INDEXED_QUAD_MESH_H
#define CGAL_QUAD_MESHING_SMOOTHING_SMOOTH_INDEXED_QUAD_MESH_H

#include <CGAL/Quad_meshing/Smoothing/Quad_mesh_smoothing_result.h>
#include <CGAL/Quad_meshing/Smoothing/Smoothing_reference.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// How a quad mesh is smoothed.
struct Smoothing_options
{
  unsigned int iterations = 20; // largest number of sweeps and steps
  bool globally = false;        // vertices may have to go far: after a few sweeps all of them are moved at once
};

// The smoothing of `smooth_quad_mesh()` on flat arrays: what it offers to other rooms. `is_fixed_vertex` tells, per
// vertex, what must not move. If the visitor asks for an end, the mesh is as it was.
CGAL_QUAD_MESHING_INLINE Quad_mesh_smoothing_result smooth_indexed_quad_mesh(Indexed_quad_mesh& m,
                                                                             Smoothing_reference& reference,
                                                                             const std::vector<char>& is_fixed_vertex,
                                                                             const Smoothing_options& options,
                                                                             Any_visitor& visitor);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Smoothing/internal/smooth_indexed_quad_mesh_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_SMOOTHING_SMOOTH_INDEXED_QUAD_MESH_H
