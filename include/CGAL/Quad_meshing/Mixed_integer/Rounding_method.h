// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_ROUNDING_METHOD_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_ROUNDING_METHOD_H

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief The ways to meet the integer conditions of a `Mixed_integer_problem`.

The first group approximates and never needs more than the energy and equality constraints; the second
group finds the optimum, or a solution with a proven gap, and also knows inequality constraints and bounds.
*/
enum class Rounding_method
{
  /// Integer conditions are ignored.
  RELAXED,
  /// All integers are rounded at once from the relaxed solution. Two linear systems, poor energy.
  DIRECT,
  /// One integer at a time, the one nearest to an integer first, with the exact solution of the others after each
  /// rounding: one sparse system, and every 64 roundings a factorization. The reference for greedy rounding.
  NAIVE,
  /// The same order of roundings, at a fraction of the cost: one factorization and dense updates if
  /// integers are few, else local Gauss-Seidel, preconditioned conjugate gradient and sparse Cholesky,
  /// whichever suffices.
  GREEDY,
  /// Decodes the integers as a closest-vector problem: lattice reduction, nearest plane, enumeration.
  /// Gives the best solution found within the limits, and a proven lower bound.
  LATTICE,
  /// Branch-and-bound on the convex quadratic relaxation. Knows inequality constraints and bounds.
  BRANCH_AND_BOUND,
  /// Branch-and-bound with cutting planes in the nodes. Knows inequality constraints and bounds.
  BRANCH_AND_CUT,
  /// Gomory and mixed-integer Gomory cuts in exact rational arithmetic, for linear objectives; for convex constraints,
  /// extended cutting planes.
  CUTTING_PLANES,
  /// Outer approximation of the convex objective, and of convex constraints, by tangent planes, for small problems with
  /// bounds.
  OUTER_APPROXIMATION
};

/*!
\ingroup PkgQuadMeshingMixedIntegerRef
\brief The order in which branch-and-bound takes up its open subproblems.
*/
enum class Subproblem_selection
{
  BEST_BOUND,   ///< the smallest lower bound first: the fewest subproblems to a proof
  DEPTH_FIRST,  ///< the deepest first: soon a feasible solution, little memory
  BEST_ESTIMATE ///< the smallest estimate of the best integer solution of a subproblem first
};

/*!
\ingroup PkgQuadMeshingMixedIntegerRef
\brief The choice of the variable on which branch-and-bound splits a subproblem.
*/
enum class Branching_rule
{
  MINIMUM_INFEASIBILITY, ///< the variable nearest to an integer
  MAXIMUM_INFEASIBILITY, ///< the variable farthest from an integer
  PSEUDO_COSTS,          ///< the variable whose past branchings raised the bound most: downwards times upwards
  /// the variable farthest from an integer near the root, where decisions matter most, and the nearest deeper in the
  /// tree, where feasible points are wanted
  MAXIMUM_THEN_MINIMUM_INFEASIBILITY,
  MINIMUM_PSEUDO_COSTS, ///< the variable that, by past branchings, is the cheapest to round
  MAXIMUM_PSEUDO_COSTS  ///< the variable that, by past branchings, is the most expensive to round
};

/*!
\ingroup PkgQuadMeshingMixedIntegerRef
\brief The order in which equality constraints are eliminated.
*/
enum class Elimination_order
{
  FEWEST_COEFFICIENTS, ///< the one with the fewest coefficients left first: the matrix stays sparse [Bom12, 5.3]
  AS_GIVEN             ///< in the order of the problem, for comparison
};

/*!
\ingroup PkgQuadMeshingMixedIntegerRef
\brief The variable that is eliminated with an equality constraint, if several of its real variables, or several
integers with a coefficient of one, could be.
*/
enum class Elimination_pivot
{
  FEWEST_CONSTRAINTS, ///< one that occurs in the fewest other constraints, which keeps those sparse
  LARGEST_COEFFICIENT ///< the first one with the largest coefficient, as in [Bom12, 5.1.2], for comparison
};

/*!
\ingroup PkgQuadMeshingMixedIntegerRef
\brief returns the name of a method as programs spell it, for instance `"branch-and-bound"`.
*/
inline const char* rounding_method_name(Rounding_method method)
{
  static const char* const names[] = { "relaxed",        "direct",         "naive",
                                       "greedy",         "lattice",        "branch-and-bound",
                                       "branch-and-cut", "cutting-planes", "outer-approximation" };
  static_assert(sizeof(names) / sizeof(names[0]) == static_cast<int>(Rounding_method::OUTER_APPROXIMATION) + 1,
                "every rounding method needs a name");
  return names[static_cast<int>(method)];
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_ROUNDING_METHOD_H
