// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SOLVE_MIXED_INTEGER_KERNEL_IMPL_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SOLVE_MIXED_INTEGER_KERNEL_IMPL_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Convex_methods.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Feasibility_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Mixed_integer_solver.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Search_limits.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/solve_mixed_integer_kernel.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Runs a search as a stage of its own, within the limits of the options.
template <typename Result, typename Search>
Result run_as_stage(const char* stage_name, const Solver_options& options, Any_visitor& visitor, const Search& search)
{
  const Visited_stage stage(visitor, stage_name);
  Search_limits limits(visitor, options.maximum_running_time);
  Result result = search(limits);
  if(limits.is_stopped())
  {
    result = Result();
    result.status = Mixed_integer_status::STOPPED;
    result.message = "The visitor asked to stop.";
  }
  result.seconds = limits.seconds();
  return result;
}

CGAL_QUAD_MESHING_INLINE Mixed_integer_solution solve_mixed_integer_kernel(const Mixed_integer_problem& problem,
                                                                           const Solver_options& options,
                                                                           const Sparse_cholesky<double>& linear_solver,
                                                                           Any_visitor& visitor)
{
  return run_as_stage<Mixed_integer_solution>(
    "mixed-integer solution", options, visitor,
    [&](Search_limits& limits)
    {
      return problem.convex_constraints().empty()
               ? Mixed_integer_solver(problem, options, linear_solver, limits).solve()
               : Convex_methods(problem, options, linear_solver, limits).solve();
    });
}

CGAL_QUAD_MESHING_INLINE Feasible_point find_feasible_point_kernel(const Mixed_integer_problem& problem,
                                                                   const Solver_options& options,
                                                                   const Sparse_cholesky<double>& linear_solver,
                                                                   Any_visitor& visitor)
{
  return run_as_stage<Feasible_point>("feasible point", options, visitor,
                                      [&](Search_limits& limits)
                                      { return Feasibility_problem(problem, options, linear_solver, limits).solve(); });
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SOLVE_MIXED_INTEGER_KERNEL_IMPL_H
