// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RUN_QUADRANGULATION_IMPL_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RUN_QUADRANGULATION_IMPL_H

#include <CGAL/Quad_meshing/Pipeline/internal/Quadrangulation_run.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Symmetric_quadrangulation.h>
#include <CGAL/Quad_meshing/Pipeline/internal/run_quadrangulation.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Quadrangulation_result run_quadrangulation(const Triangle_input& input,
                                                                    const Quadrangulation_options& options,
                                                                    Any_visitor& visitor,
                                                                    std::unique_ptr<Quadrangulation_surface>& surface,
                                                                    std::unique_ptr<Quadrangulation_quads>& quads)
{
  const bool is_finite =
    std::all_of(input.points.begin(), input.points.end(), [](const auto& p) { return is_finite_point(p); });
  const bool has_planes = !options.symmetry_planes.empty() && is_finite && !input.triangles.empty() &&
                          (options.target_edge_length > 0 || options.target_number_of_quads > 0);
  if(!has_planes) // what is wrong with the input is found in any case
    return Quadrangulation_run(input, options, visitor).run(surface, quads);
  Quadrangulation_result result;
  Symmetric_quadrangulation symmetric(input, options);
  surface = std::make_unique<Quadrangulation_surface>();
  quads = std::make_unique<Quadrangulation_quads>();
  if(!symmetric.prepare(result))
    return result;
  result =
    Quadrangulation_run(symmetric.part(), symmetric.part_options(), visitor, symmetric.copies()).run(surface, quads);
  for(Quadrangulation_mesh::Face_index f : surface->mesh.faces())
    surface->origin[f] = symmetric.part().original(surface->origin[f]);
  for(Invalid_component& c : result.invalid_components)
    c.face = symmetric.part().original(c.face);
  symmetric.complete(result, quads);
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_RUN_QUADRANGULATION_IMPL_H
