// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_MIXED_INTEGER_SOLUTION_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_MIXED_INTEGER_SOLUTION_H

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief What became of a mixed-integer problem.
*/
enum class Mixed_integer_status
{
  /// The energy is proven minimal, within the relative gap asked for.
  OPTIMAL,
  /// All conditions hold, optimality is not proven.
  FEASIBLE,
  /// Some constraints contradict others and were ignored; all other conditions hold.
  CONFLICTING_CONSTRAINTS,
  /// No point meets all the constraints, bounds and integer conditions.
  INFEASIBLE,
  /// The energy is unbounded below.
  UNBOUNDED,
  /// The time or node limit was met before a feasible solution was found.
  LIMIT_REACHED,
  /// The visitor asked to stop.
  STOPPED,
  /// The method cannot treat this problem; the message says why.
  UNSUPPORTED_PROBLEM,
  /// A factorization failed: the energy is not convex, or a coefficient is not finite.
  NUMERICAL_FAILURE
};

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief The answer of `solve_mixed_integer()`.
*/
struct Mixed_integer_solution
{
  /// What became of the problem.
  Mixed_integer_status status = Mixed_integer_status::NUMERICAL_FAILURE;
  /// One sentence that says what happened.
  std::string message;

  /// The solution; integers are exact. Empty if none was found.
  Eigen::VectorXd x;
  /// The energy at `x`.
  double energy = std::numeric_limits<double>::quiet_NaN();
  /// The smallest energy when integer conditions are ignored.
  double relaxed_energy = std::numeric_limits<double>::quiet_NaN();
  /// A proven lower bound of the energy of all integer solutions.
  double lower_bound = -std::numeric_limits<double>::infinity();
  /// `|energy - lower_bound| / (|energy| + epsilon)`
  double gap = std::numeric_limits<double>::infinity();
  /// Whether every variable that must be an integer is one, exactly.
  bool all_integers_satisfied = false;

  /// The number of integer variables of the problem.
  int integers = 0;
  /// The number of integer variables left after the elimination of constraints.
  int free_integers = 0;
  /// The number of variables left after the elimination of constraints.
  int free_variables = 0;
  /// The number of entries of the matrix left after the elimination of constraints.
  double matrix_entries = 0;
  /// The number of equality constraints.
  int constraints = 0;
  /// Equality constraints that follow from the others, by index, ascending.
  std::vector<int> redundant_constraints;
  /// Equality constraints that contradict the others, by index, ascending; they were ignored.
  std::vector<int> conflicting_constraints;

  /// Integers rounded together with the one before, without a new solution in between.
  int simultaneous_roundings = 0;
  /// Roundings whose effect was computed by dense updates over the integers alone.
  int dense_roundings = 0;
  /// Roundings whose effect local Gauss-Seidel computed.
  int gauss_seidel_roundings = 0;
  /// Roundings that needed the preconditioned conjugate gradient.
  int conjugate_gradient_roundings = 0;
  /// Roundings that needed a new sparse factorization.
  int factorization_roundings = 0;
  /// The number of numerical factorizations of a sparse matrix.
  int factorizations = 0;
  /// The number of visited enumeration nodes or solved subproblems.
  double nodes = 0;
  /// The number of cutting planes added.
  int cuts = 0;
  /// The wall-clock time.
  double seconds = 0;

  /// tells whether `x` meets all the conditions that do not contradict each other.
  bool is_valid() const
  {
    return status == Mixed_integer_status::OPTIMAL || status == Mixed_integer_status::FEASIBLE ||
           (status == Mixed_integer_status::CONFLICTING_CONSTRAINTS && all_integers_satisfied);
  }
};

/*!
\ingroup PkgQuadMeshingMixedIntegerRef
\brief returns the name of a status in lower case, for instance `"optimal"`.
*/
inline const char* status_name(Mixed_integer_status status)
{
  static const char* const names[] = {
    "optimal",       "feasible", "conflicting_constraints", "infeasible",       "unbounded",
    "limit_reached", "stopped",  "unsupported_problem",     "numerical_failure"
  };
  static_assert(sizeof(names) / sizeof(names[0]) == static_cast<int>(Mixed_integer_status::NUMERICAL_FAILURE) + 1,
                "every status needs a name");
  return names[static_cast<int>(status)];
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_MIXED_INTEGER_SOLUTION_H
