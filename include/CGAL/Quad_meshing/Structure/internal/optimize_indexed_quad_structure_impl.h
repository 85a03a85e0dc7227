// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_OPTIMIZE_INDEXED_QUAD_STRUCTURE_IMPL_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_OPTIMIZE_INDEXED_QUAD_STRUCTURE_IMPL_H

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/internal/Accepted_shape.h>
#include <CGAL/Quad_meshing/Structure/internal/Shape_watch.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_methods.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_optimizer.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/Structure/internal/optimize_indexed_quad_structure.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Watched_visitor.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The method that is asked for, the collapses of section 10.4, and the smoothing.
CGAL_QUAD_MESHING_INLINE Quad_structure_optimization_result optimize_indexed_quad_structure(
  Structure_state& state, Smoothing_reference& reference, const Structure_options& options, Any_visitor& visitor)
{
  Quad_structure_optimization_result result;
  Watched_visitor watched(visitor, options.maximum_running_time);
  Structure_optimizer optimizer(std::move(state), options.merge_singularities);
  result.structure_before = structure_of_quad_mesh(optimizer.state.mesh);
  auto target_reached = [&]
  {
    return (options.target_quads > 0 && optimizer.state.mesh.corners.size() <= options.target_quads) ||
           (options.target_patches > 0 && std::size_t(optimizer.score().patches) <= options.target_patches);
  };
  Silent_visitor silent(watched);
  // the vertices of a new layout may have to go far
  const bool is_new_layout =
    options.method == Structure_method::LAYOUT && result.structure_before.number_of_irregular_vertices > 0;
  auto smooth_with = [&](Structure_state& s, unsigned int sweeps, bool globally)
  {
    return options.smoothing_iterations == 0
             ? Quad_mesh_smoothing_result()
             : smooth_indexed_quad_mesh(s.mesh, reference, s.is_fixed, Smoothing_options{ sweeps, globally }, silent);
  };
  auto smooth = [&](Structure_state& s, unsigned int sweeps) { return smooth_with(s, sweeps, false); };
  Accepted_shape accepted;
  if(options.smoothing_iterations > 0)
  {
    Structure_state input = optimizer.state;
    accepted = Accepted_shape(smooth(input, 0), options.merge_singularities || options.collapse_dual_curves);
  }

  {
    const Visited_stage stage(watched, "structure");
    if(is_new_layout)
      optimize_layout(
        optimizer, options, accepted,
        [&](Structure_state& s, unsigned int sweeps) { return smooth_with(s, sweeps, true); }, watched);
    else
    {
      Shape_watch<decltype(smooth)> watch(optimizer, accepted, smooth, options.smoothing_iterations);
      remove_helices(optimizer, watch, target_reached, watched);
    }
    if(options.collapse_dual_curves)
    {
      Shape_watch<decltype(smooth)> watch(optimizer, accepted, smooth, options.smoothing_iterations);
      collapse_dual_curves(optimizer, watch, target_reached, watched);
    }
  }
  result.operators_applied = optimizer.operators;

  // what has been accepted stays so
  Indexed_quad_mesh& m = optimizer.state.mesh;
  const std::vector<Indexed_quad_mesh::Point_3> points = m.points;
  const bool is_smoothed = watched.go_further() && options.smoothing_iterations > 0;
  if(is_smoothed)
    result.smoothing =
      smooth_indexed_quad_mesh(m, reference, optimizer.state.is_fixed,
                               Smoothing_options{ options.smoothing_iterations, is_new_layout }, watched);
  if(!is_smoothed || !accepted.accepts(result.smoothing))
  {
    m.points = points;
    result.smoothing = Quad_mesh_smoothing_result();
    result.smoothing.quality_before = result.smoothing.quality_after = quality_of_quad_mesh(m);
    result.smoothing.message = "The mesh has not been smoothed.";
  }
  watched.go_further();
  if(watched.is_stopped())
  {
    result.status = Quad_mesh_status::STOPPED;
    result.operators_applied = 0;
    result.structure_after = result.structure_before;
    result.message = "The optimization was stopped; the mesh is as it was.";
    return result;
  }
  result.is_time_up = watched.is_time_up();
  result.structure_after = structure_of_quad_mesh(m);
  result.message = "The base complex has " + std::to_string(result.structure_after.number_of_patches) + " patches, " +
                   std::to_string(result.structure_before.number_of_patches) + " before; the number of helices is " +
                   std::to_string(result.structure_after.number_of_helices) + ", " +
                   std::to_string(result.structure_before.number_of_helices) + " before.";
  if(options.target_patches > 0 && result.structure_after.number_of_patches > options.target_patches)
    result.message += " The target of " + std::to_string(options.target_patches) + " patches has not been reached.";
  if(options.target_quads > 1 && result.structure_after.number_of_quads > options.target_quads)
    result.message += " The target of " + std::to_string(options.target_quads) + " quads has not been reached.";
  if(result.is_time_up)
    result.message += " The search ended because its time was up.";
  state = std::move(optimizer.state);
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_OPTIMIZE_INDEXED_QUAD_STRUCTURE_IMPL_H
