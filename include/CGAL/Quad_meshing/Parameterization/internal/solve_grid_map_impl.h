// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SOLVE_GRID_MAP_IMPL_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SOLVE_GRID_MAP_IMPL_H

#include <CGAL/Quad_meshing/Parameterization/internal/Integer_grid_solver.h>
#include <CGAL/Quad_meshing/Parameterization/internal/solve_grid_map.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Integer_grid_map_status solve_grid_map(const Grid_map_problem& problem,
                                                                const Grid_map_options& options, Any_visitor& visitor,
                                                                std::vector<std::array<double, 2>>& uv,
                                                                Integer_grid_map_result& result)
{
  // How far the progress has come at the end of each part.
  const double set_up = 0.1, seamless = 0.5, rounded = 0.8;

  const Visited_stage stage(visitor, "parameterization");
  Stage_progress progress(visitor);
  progress.begin_part(set_up);
  if(!progress.go_further())
    return Integer_grid_map_status::STOPPED;
  Integer_grid_solver solver(problem.mesh, problem.angle, problem.period_jump, problem.quarters, problem.is_aligned,
                             problem.sizing, options.number_of_threads, progress);
  result.variables = solver.coordinates.number_of_variables();
  result.integers = solver.number_of_integers();
  if(!progress.go_further(set_up))
    return Integer_grid_map_status::STOPPED;

  progress.begin_part(seamless);
  const bool is_solved = solver.solve_seamless(options.anisotropy_weight, options.stiffening_iterations);
  if(!progress.go_further(seamless))
    return Integer_grid_map_status::STOPPED;
  if(!is_solved)
    return Integer_grid_map_status::NUMERICAL_FAILURE;

  progress.begin_part(rounded);
  solver.round(options.rounding_method, problem.is_aligned);
  if(!progress.go_further(rounded))
    return Integer_grid_map_status::STOPPED;

  progress.begin_part(1.);
  solver.remove_fold_overs(options.stiffening_iterations, options.anisotropy_weight);
  solver.make_exact();
  if(!progress.go_further(1.))
    return Integer_grid_map_status::STOPPED;

  result.relaxed_energy = solver.relaxed_energy;
  result.energy = solver.rounded_energy;
  result.separations = solver.number_of_separations;
  result.broken_separations = solver.number_of_broken_separations;
  const std::vector<int> folded = solver.folded_faces();
  result.folded_faces.assign(folded.begin(), folded.end());
  result.folded_before_rounding.assign(solver.folded_before_rounding.begin(), solver.folded_before_rounding.end());
  uv.resize(problem.mesh.number_of_halfedges());
  for(int h = 0; h < problem.mesh.number_of_halfedges(); ++h)
  {
    const auto p = solver.corner(h / 3, h % 3);
    uv[h] = { { p.x(), p.y() } };
  }
  return folded.empty() ? Integer_grid_map_status::VALID : Integer_grid_map_status::FOLDED;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SOLVE_GRID_MAP_IMPL_H
