// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_ADD_FIGURES_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_ADD_FIGURES_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_result.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Adds the figures of a component to those of all of them.
inline void add_figures(const Quadrangulation_result& r, Quadrangulation_result& sum)
{
  sum.feature_edges += r.feature_edges;
  sum.dropped_feature_edges += r.dropped_feature_edges;
  sum.prepared_faces += r.prepared_faces;
  sum.singularities += r.singularities;
  sum.field_integers += r.field_integers;
  sum.field_energy += r.field_energy;
  sum.field_seconds += r.field_seconds;
  sum.parameterization_integers += r.parameterization_integers;
  sum.parameterization_energy += r.parameterization_energy;
  sum.relaxed_parameterization_energy += r.relaxed_parameterization_energy;
  sum.parameterization_seconds += r.parameterization_seconds;
  sum.parameterization_attempts += r.parameterization_attempts;
  sum.flipped_triangles += r.flipped_triangles;
  sum.quads += r.quads;
  sum.other_faces += r.other_faces;
  sum.irregular_vertices += r.irregular_vertices;
  sum.extraction_seconds += r.extraction_seconds;
  sum.folded_quads += r.folded_quads;
  sum.smoothing_seconds += r.smoothing_seconds;
  sum.structure_seconds += r.structure_seconds;
  sum.not_semi_regular_components += r.not_semi_regular_components;
  sum.layout_seconds += r.layout_seconds;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_ADD_FIGURES_H
