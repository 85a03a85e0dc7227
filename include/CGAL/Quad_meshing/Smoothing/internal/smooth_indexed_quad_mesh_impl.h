// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_SMOOTH_INDEXED_QUAD_MESH_IMPL_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_SMOOTH_INDEXED_QUAD_MESH_IMPL_H

#include <CGAL/Quad_meshing/Smoothing/internal/Quad_untangler.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Smoothing_reference_impl.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Watched_visitor.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Quad_mesh_smoothing_result smooth_indexed_quad_mesh(Indexed_quad_mesh& m,
                                                                             Smoothing_reference& reference,
                                                                             const std::vector<char>& is_fixed_vertex,
                                                                             const Smoothing_options& options,
                                                                             Any_visitor& visitor)
{
  // Sweeps before all vertices are moved at once, where quads have just been unfolded.
  constexpr unsigned int sweeps_after_unfolding = 2;
  // How many of these steps there are at most: so many that this is the number of quads in all of them together.
  constexpr unsigned int most_quads_moved = 200000, least_number_of_steps = 4;

  Quad_mesh_smoothing_result result;
  result.quality_before = result.quality_after = quality_of_quad_mesh(m);
  if(m.number_of_faces() == 0)
  {
    result.message = "The mesh has no faces.";
    return result;
  }

  Watched_visitor watched(visitor);
  const std::vector<Indexed_quad_mesh::Point_3> input_points = m.points;
  {
    const Visited_stage stage(watched, "smoothing");
    Smoothing_reference::Data& data = reference.data();
    Quad_untangler smoother(m, data.surface, data.features, data.borders, is_fixed_vertex, data.length,
                            data.directions.get(), watched);
    smoother.project();
    smoother.set_start();
    std::vector<int> folded = smoother.folded_quads();
    result.folded_quads_before = folded.size();
    if(!folded.empty())
      smoother.unfold(folded);

    const unsigned int sweeps = !options.globally ? options.iterations : folded.empty() ? 0 : sweeps_after_unfolding;
    const unsigned int steps =
      (std::max)(least_number_of_steps, most_quads_moved / static_cast<unsigned int>(m.number_of_faces()));
    const unsigned int iterations = (std::min)(options.iterations, sweeps + steps);
    smoother.start_sweeps();
    bool moving = true;
    for(; moving && result.iterations < iterations && watched.go_further(); ++result.iterations)
    {
      if(result.iterations < sweeps)
        moving = smoother.sweep() || options.globally;
      else
        moving = smoother.step();
      moving = smoother.project_leftovers() || moving;
      watched.progress(double(result.iterations + 1) / iterations);
    }
    if(options.globally && result.iterations > 0)
      smoother.mend();
    if(result.iterations > 0)
      smoother.untangle();
    const std::vector<int> left = smoother.folded_quads();
    result.folded_quads_after = left.size();
    for(int f : left)
      if(smoother.flat_corner(f) != -1)
        result.flat_corners.push_back(static_cast<std::size_t>(smoother.flat_corner(f)));
  }

  if(!watched.go_further())
  {
    m.points = input_points;
    result.status = Quad_mesh_status::STOPPED;
    result.folded_quads_after = result.folded_quads_before;
    result.message = "The smoothing was stopped; the mesh is as it was.";
    return result;
  }
  result.quality_after = quality_of_quad_mesh(m);
  result.message =
    result.folded_quads_after == 0
      ? "The mesh has been smoothed; no quad is folded."
      : "The mesh has been smoothed; number of folded quads: " + std::to_string(result.folded_quads_after) + ".";
  if(!result.flat_corners.empty())
    result.message += " Corners at which curves leave a quad no angle: " + std::to_string(result.flat_corners.size()) +
                      ", the first one at vertex " + std::to_string(result.flat_corners.front()) + ".";
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_SMOOTH_INDEXED_QUAD_MESH_IMPL_H
