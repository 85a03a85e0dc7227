// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_SOLVE_MIXED_INTEGER_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_SOLVE_MIXED_INTEGER_H

#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_solution.h>
#include <CGAL/Quad_meshing/Mixed_integer/Rounding_method.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/read_solver_options.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/solve_mixed_integer_kernel.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/parameters.h>

namespace CGAL {
namespace Quad_meshing {
/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief minimizes a convex quadratic energy over real and integer variables with linear constraints.

Equality constraints are eliminated first: each takes one variable away, dependent ones drop out, and those
that contradict others or the integer conditions are reported and ignored. Constraints over integers with
integer coefficients are met exactly, whatever their greatest common divisors, and all integers of the
solution are exact. What is left is solved by the method chosen. The input is never changed, no
exception is thrown and nothing is printed.

\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param problem the energy, the variables and the constraints
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{rounding_method}
    \cgalParamDescription{the way to meet the integer conditions}
    \cgalParamType{`Rounding_method`}
    \cgalParamDefault{`Rounding_method::GREEDY`, or `BRANCH_AND_BOUND` if there are inequality constraints or bounds}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{the solver of symmetric positive definite systems; only its type matters}
    \cgalParamType{`Sparse_cholesky<double>` or a model of `SparseLinearAlgebraWithFactorTraits_d`}
    \cgalParamDefault{`Sparse_cholesky<double>`}
  \cgalParamNEnd
  \cgalParamNBegin{elimination_order}
    \cgalParamDescription{the order in which equality constraints are eliminated; `matrix_entries` of the
                          solution tells what it does to the matrix}
    \cgalParamType{`Elimination_order`}
    \cgalParamDefault{`Elimination_order::FEWEST_COEFFICIENTS`}
  \cgalParamNEnd
  \cgalParamNBegin{elimination_pivot}
    \cgalParamDescription{the variable that goes with an equality constraint, where there is a choice}
    \cgalParamType{`Elimination_pivot`}
    \cgalParamDefault{`Elimination_pivot::FEWEST_CONSTRAINTS`}
  \cgalParamNEnd
  \cgalParamNBegin{constraint_tolerance}
    \cgalParamDescription{An equality constraint depends on others if, with them, its coefficients cancel up
                          to this fraction of the largest, and contradicts them if its right-hand
                          side then differs by more than this (relative to 1, its largest coefficient and its
                          right-hand side).}
    \cgalParamType{`double`}
    \cgalParamDefault{`1e-6`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_dense_integers}
    \cgalParamDescription{Up to so many free integers, greedy rounding and the lattice work on the dense Schur
                          complement over the integers; beyond it, greedy rounding uses its three levels.}
    \cgalParamType{`int`}
    \cgalParamDefault{`1000`}
  \cgalParamNEnd
  \cgalParamNBegin{rounding_tolerance}
    \cgalParamDescription{the accuracy to which the iterative levels of greedy rounding update the variables, in
                          units of the variables}
    \cgalParamType{`double`}
    \cgalParamDefault{`3e-4`}
  \cgalParamNEnd
  \cgalParamNBegin{gauss_seidel_iterations}
    \cgalParamDescription{the number of local Gauss-Seidel steps per rounding before the next level takes over;
                          0 switches the level off}
    \cgalParamType{`int`}
    \cgalParamDefault{`20000`}
  \cgalParamNEnd
  \cgalParamNBegin{conjugate_gradient_iterations}
    \cgalParamDescription{the number of steps of the preconditioned conjugate gradient before a new factorization;
                          0 switches the level off}
    \cgalParamType{`int`}
    \cgalParamDefault{`10`}
  \cgalParamNEnd
  \cgalParamNBegin{allow_refactorization}
    \cgalParamDescription{whether greedy rounding may compute a new factorization where the steps of the other levels
                          do not suffice, and after a tenth of all roundings. Without, it goes on with what these
                          steps have reached.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{simultaneous_rounding}
    \cgalParamDescription{whether greedy rounding rounds several integers at once as long as their deviations
                          from integers sum up to less than one half}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number_of_nodes}
    \cgalParamDescription{the number of nodes (enumeration of the lattice) or subproblems (branch-and-bound)
                          after which the best solution so far is returned. Nodes of the lattice stand for work: all
                          that is done besides counts as many as take the same time, and `1e8` of them take about two
                          seconds.}
    \cgalParamType{`double`}
    \cgalParamDefault{`1e8`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_bound_rounds}
    \cgalParamDescription{the number of rounds of the semidefinite relaxation that raises the lower bound of `LATTICE`
                          where the enumeration has not proven the optimum. A round adds as many inequalities as there
                          are integers; six take some seconds with 100 integers, and each step takes time cubic in
                          them.}
    \cgalParamType{`int`}
    \cgalParamDefault{`0`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{the number of seconds, by the clock on the wall, after which the best solution so far is
                          returned; `message` then says so. The first factorization and one rounding of all integers are
                          made in any case. Results that meet this limit depend on the machine.}
    \cgalParamType{`double`}
    \cgalParamDefault{unlimited}
  \cgalParamNEnd
  \cgalParamNBegin{relative_gap_tolerance}
    \cgalParamDescription{The search ends when energy and lower bound differ by less than this fraction of the energy.}
    \cgalParamType{`double`}
    \cgalParamDefault{`1e-9`}
  \cgalParamNEnd
  \cgalParamNBegin{subproblem_selection}
    \cgalParamDescription{the order in which branch-and-bound takes up its subproblems}
    \cgalParamType{`Subproblem_selection`}
    \cgalParamDefault{`Subproblem_selection::BEST_BOUND`}
  \cgalParamNEnd
  \cgalParamNBegin{branching_rule}
    \cgalParamDescription{the variable on which branch-and-bound splits}
    \cgalParamType{`Branching_rule`}
    \cgalParamDefault{`Branching_rule::PSEUDO_COSTS`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{told about the progress, and asked whether to go on}
    \cgalParamType{a class like `Default_visitor`, by `std::ref`}
    \cgalParamDefault{`Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the solution, what is known about its quality, and what happened
*/
template <typename NamedParameters = parameters::Default_named_parameters>
Mixed_integer_solution solve_mixed_integer(const Mixed_integer_problem& problem,
                                           const NamedParameters& np = parameters::default_values())
{
  const internal::Solver_options options = internal::read_solver_options(
    np, problem.has_inequalities() ? Rounding_method::BRANCH_AND_BOUND : Rounding_method::GREEDY);
  internal::Named_visitor<NamedParameters> visitor(np);
  return internal::solve_mixed_integer_kernel(problem, options, internal::read_linear_solver(np), visitor);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_SOLVE_MIXED_INTEGER_H
