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
#include <CGAL/Quad_meshing/Mixed_integer/internal/Mixed_integer_solver.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Search_limits.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/solve_mixed_integer_kernel.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Mixed_integer_solution solve_mixed_integer_kernel(const Mixed_integer_problem& problem,
                                                                           const Solver_options& options,
                                                                           const Sparse_cholesky<double>& linear_solver,
                                                                           Any_visitor& visitor)
{
  const Visited_stage stage(visitor, "mixed-integer solution");
  Search_limits limits(visitor, options.maximum_running_time);
  Mixed_integer_solution solution = problem.convex_constraints().empty()
                                      ? Mixed_integer_solver(problem, options, linear_solver, limits).solve()
                                      : Convex_methods(problem, options, linear_solver, limits).solve();
  if(limits.is_stopped())
  {
    solution = Mixed_integer_solution();
    solution.status = Mixed_integer_status::STOPPED;
    solution.message = "The visitor asked to stop.";
  }
  solution.seconds = limits.seconds();
  return solution;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SOLVE_MIXED_INTEGER_KERNEL_IMPL_H
