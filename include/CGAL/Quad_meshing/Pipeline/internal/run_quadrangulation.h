// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RUN_QUADRANGULATION_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RUN_QUADRANGULATION_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_result.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Triangle_input.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <memory>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Quadrangulates the components of the input one by one and joins the results. `surface` and `quads` receive them; they
// are empty where there is no result.
CGAL_QUAD_MESHING_INLINE Quadrangulation_result run_quadrangulation(const Triangle_input& input,
                                                                    const Quadrangulation_options& options,
                                                                    Any_visitor& visitor,
                                                                    std::unique_ptr<Quadrangulation_surface>& surface,
                                                                    std::unique_ptr<Quadrangulation_quads>& quads);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Pipeline/internal/run_quadrangulation_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RUN_QUADRANGULATION_H
