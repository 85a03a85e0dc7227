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

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Passes on to the visitor of the call that is going on.
class Changing_visitor : public Any_visitor
{
public:
  Any_visitor* visitor = nullptr;

  void on_stage_begin(const std::string& name) override { visitor->on_stage_begin(name); }
  void on_stage_end(const std::string& name) override { visitor->on_stage_end(name); }
  void progress(double completed) override { visitor->progress(completed); }
  bool go_further() override { return visitor->go_further(); }
};

struct Grid_map_solver::Data
{
  const Grid_map_problem problem;
  const Grid_map_options options;
  Changing_visitor visitor;
  Stage_progress progress;
  std::unique_ptr<Integer_grid_solver> solver;
  double relative_length = 1; // of the seamless map
  double area = 0;            // of its image at first
  double distortion = 1;

  Data(Grid_map_problem&& p, const Grid_map_options& o) : problem(std::move(p)), options(o), progress(visitor) {}
};

CGAL_QUAD_MESHING_INLINE Grid_map_solver::Grid_map_solver(Grid_map_problem problem, const Grid_map_options& options)
  : m_data(std::make_unique<Data>(std::move(problem), options))
{
}

CGAL_QUAD_MESHING_INLINE Grid_map_solver::Grid_map_solver(Grid_map_solver&& other) = default;

CGAL_QUAD_MESHING_INLINE Grid_map_solver::~Grid_map_solver() = default;

CGAL_QUAD_MESHING_INLINE double Grid_map_solver::area() const { return m_data->area; }

CGAL_QUAD_MESHING_INLINE double Grid_map_solver::distortion() const { return m_data->distortion; }

CGAL_QUAD_MESHING_INLINE const Indexed_triangle_mesh& Grid_map_solver::mesh() const { return m_data->problem.mesh; }

CGAL_QUAD_MESHING_INLINE Integer_grid_map_status Grid_map_solver::solve(Any_visitor& visitor,
                                                                        Integer_grid_map_result& result)
{
  const double set_up = 0.2; // how far the progress has come at the end of this part

  const Visited_stage stage(visitor, "seamless map");
  Data& d = *m_data;
  d.visitor.visitor = &visitor;
  d.progress.restart();
  d.progress.begin_part(set_up);
  if(!d.progress.go_further())
    return Integer_grid_map_status::STOPPED;
  d.solver = std::make_unique<Integer_grid_solver>(d.problem.mesh, d.problem.angle, d.problem.period_jump,
                                                   d.problem.quarters, d.problem.is_aligned, d.problem.sizing,
                                                   d.problem.is_node, d.options.number_of_threads, d.progress);
  result.variables = d.solver->coordinates.number_of_variables();
  result.integers = d.solver->number_of_integers();
  if(!d.progress.go_further(set_up))
    return Integer_grid_map_status::STOPPED;
  d.progress.begin_part(1.);
  const bool is_solved =
    d.solver->solve_seamless(d.problem.weight, d.options.anisotropy_weight, d.options.stiffening_iterations);
  if(!d.progress.go_further(1.))
    return Integer_grid_map_status::STOPPED;
  if(!is_solved)
    return Integer_grid_map_status::NUMERICAL_FAILURE;
  d.area = d.solver->seamless_area();
  d.distortion = d.solver->seamless_distortion();
  result.relaxed_energy = d.solver->relaxed_energy;
  result.folded_before_rounding.assign(d.solver->folded_before_rounding.begin(),
                                       d.solver->folded_before_rounding.end());
  return Integer_grid_map_status::VALID;
}

CGAL_QUAD_MESHING_INLINE Integer_grid_map_status Grid_map_solver::round(double relative_length, Rounding_method method,
                                                                        bool repairs, Any_visitor& visitor,
                                                                        std::vector<std::array<double, 2>>& uv,
                                                                        Integer_grid_map_result& result)
{
  const double rounded = 0.6; // how far the progress has come at the end of this part

  const Visited_stage stage(visitor, "integer-grid map");
  Data& d = *m_data;
  d.visitor.visitor = &visitor;
  d.progress.restart();
  d.progress.begin_part(rounded);
  if(!d.progress.go_further())
    return Integer_grid_map_status::STOPPED;
  Integer_grid_solver& solver = *d.solver;
  if(relative_length != d.relative_length)
    solver.scale(d.relative_length / relative_length);
  d.relative_length = relative_length;
  solver.round(method, d.problem.is_aligned, repairs);
  if(!d.progress.go_further(rounded))
    return Integer_grid_map_status::STOPPED;
  d.progress.begin_part(1.);
  if(repairs)
    solver.remove_fold_overs(d.options.stiffening_iterations, d.options.anisotropy_weight);
  solver.make_exact();
  if(!d.progress.go_further(1.))
    return Integer_grid_map_status::STOPPED;

  result.relaxed_energy = solver.relaxed_energy;
  result.energy = solver.rounded_energy;
  result.separations = solver.number_of_separations;
  result.broken_separations = solver.number_of_broken_separations;
  const std::vector<int> folded = solver.folded_faces();
  result.folded_faces.assign(folded.begin(), folded.end());
  uv.resize(d.problem.mesh.number_of_halfedges());
  for(int h = 0; h < d.problem.mesh.number_of_halfedges(); ++h)
  {
    const auto p = solver.corner(h / 3, h % 3);
    uv[h] = { { p.x(), p.y() } };
  }
  return folded.empty() ? Integer_grid_map_status::VALID : Integer_grid_map_status::FOLDED;
}

CGAL_QUAD_MESHING_INLINE T_mesh Grid_map_solver::t_mesh(Any_visitor& visitor) const
{
  Data& d = *m_data;
  if(!d.solver || d.solver->x.size() == 0)
    return T_mesh();
  const Visited_stage stage(visitor, "T-mesh");
  d.visitor.visitor = &visitor;
  d.progress.restart();
  d.progress.begin_part(1.);
  return d.solver->t_mesh(d.problem.is_aligned);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SOLVE_GRID_MAP_IMPL_H
