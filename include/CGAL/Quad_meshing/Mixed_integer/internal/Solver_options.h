// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SOLVER_OPTIONS_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SOLVER_OPTIONS_H

#include <CGAL/Quad_meshing/Mixed_integer/Rounding_method.h>

#include <limits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The named parameters of `solve_mixed_integer()`, read once.
struct Solver_options
{
  Rounding_method method = Rounding_method::GREEDY;
  Elimination_order elimination_order = Elimination_order::FEWEST_COEFFICIENTS;
  Elimination_pivot elimination_pivot = Elimination_pivot::FEWEST_CONSTRAINTS;
  double constraint_tolerance = 1e-6;
  double rounding_tolerance = 3e-4;
  int gauss_seidel_iterations = 20000;
  int conjugate_gradient_iterations = 10;
  bool allow_refactorization = true;
  bool simultaneous_rounding = true;
  int maximum_dense_integers = 1000;
  double maximum_running_time = std::numeric_limits<double>::infinity();
  // Nodes of a lattice: about two seconds of one core. It proves 80 integers of a parametrization, and parts of a tree
  // of 100 and more.
  double maximum_number_of_nodes = 1e8;
  int number_of_bound_rounds = 0;
  double relative_gap_tolerance = 1e-9;
  Subproblem_selection subproblem_selection = Subproblem_selection::BEST_BOUND;
  Branching_rule branching_rule = Branching_rule::PSEUDO_COSTS;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SOLVER_OPTIONS_H
