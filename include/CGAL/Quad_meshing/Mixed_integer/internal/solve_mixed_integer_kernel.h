// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SOLVE_MIXED_INTEGER_KERNEL_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SOLVE_MIXED_INTEGER_KERNEL_H

#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Mixed_integer/Feasible_point.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_solution.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// `linear_solver` shows how to solve.
CGAL_QUAD_MESHING_INLINE Mixed_integer_solution solve_mixed_integer_kernel(const Mixed_integer_problem& problem,
                                                                           const Solver_options& options,
                                                                           const Sparse_cholesky<double>& linear_solver,
                                                                           Any_visitor& visitor);

CGAL_QUAD_MESHING_INLINE Feasible_point find_feasible_point_kernel(const Mixed_integer_problem& problem,
                                                                   const Solver_options& options,
                                                                   const Sparse_cholesky<double>& linear_solver,
                                                                   Any_visitor& visitor);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Mixed_integer/internal/solve_mixed_integer_kernel_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SOLVE_MIXED_INTEGER_KERNEL_H
