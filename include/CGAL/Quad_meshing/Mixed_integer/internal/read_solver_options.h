// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_READ_SOLVER_OPTIONS_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_READ_SOLVER_OPTIONS_H

#include <CGAL/Quad_meshing/Linear_algebra/Custom_sparse_cholesky.h>
#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/read_parameter.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <type_traits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The options that a pack of named parameters sets; `default_method` holds where it names none.
template <typename NamedParameters>
Solver_options read_solver_options(const NamedParameters& np, Rounding_method default_method)
{
  check_parameters<
    NamedParameters, internal_np::rounding_method_t, internal_np::sparse_linear_solver_t,
    internal_np::elimination_order_t, internal_np::elimination_pivot_t, internal_np::constraint_tolerance_t,
    internal_np::rounding_tolerance_t, internal_np::gauss_seidel_iterations_t,
    internal_np::conjugate_gradient_iterations_t, internal_np::allow_refactorization_t,
    internal_np::simultaneous_rounding_t, internal_np::maximum_dense_integers_t, internal_np::maximum_number_of_nodes_t,
    internal_np::number_of_bound_rounds_t, internal_np::maximum_running_time_t, internal_np::relative_gap_tolerance_t,
    internal_np::subproblem_selection_t, internal_np::branching_rule_t, internal_np::visitor_t>();
  Solver_options options;
  options.method = default_method;
  read_parameter(np, internal_np::rounding_method, options.method);
  read_parameter(np, internal_np::elimination_order, options.elimination_order);
  read_parameter(np, internal_np::elimination_pivot, options.elimination_pivot);
  read_parameter(np, internal_np::constraint_tolerance, options.constraint_tolerance);
  read_parameter(np, internal_np::rounding_tolerance, options.rounding_tolerance);
  read_parameter(np, internal_np::gauss_seidel_iterations, options.gauss_seidel_iterations);
  read_parameter(np, internal_np::conjugate_gradient_iterations, options.conjugate_gradient_iterations);
  read_parameter(np, internal_np::allow_refactorization, options.allow_refactorization);
  read_parameter(np, internal_np::simultaneous_rounding, options.simultaneous_rounding);
  read_parameter(np, internal_np::maximum_dense_integers, options.maximum_dense_integers);
  read_parameter(np, internal_np::maximum_number_of_nodes, options.maximum_number_of_nodes);
  read_parameter(np, internal_np::number_of_bound_rounds, options.number_of_bound_rounds);
  read_parameter(np, internal_np::maximum_running_time, options.maximum_running_time);
  read_parameter(np, internal_np::relative_gap_tolerance, options.relative_gap_tolerance);
  read_parameter(np, internal_np::subproblem_selection, options.subproblem_selection);
  read_parameter(np, internal_np::branching_rule, options.branching_rule);
  return options;
}

// The way to solve that goes with the type of the named parameter `sparse_linear_solver`.
template <typename NamedParameters>
Sparse_cholesky<double> read_linear_solver(const NamedParameters&)
{
  typedef Parameter_type<internal_np::sparse_linear_solver_t, NamedParameters, Sparse_cholesky<double>> Linear_solver;
  if constexpr(std::is_same<Linear_solver, Sparse_cholesky<double>>::value)
    return Sparse_cholesky<double>();
  else
    return custom_sparse_cholesky<Linear_solver>();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_READ_SOLVER_OPTIONS_H
