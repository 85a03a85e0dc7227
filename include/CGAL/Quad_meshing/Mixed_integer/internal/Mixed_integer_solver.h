// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_MIXED_INTEGER_SOLVER_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_MIXED_INTEGER_SOLVER_H

#include <CGAL/Quad_meshing/Mixed_integer/Integer_energy.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_solution.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Constraint_elimination.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dense_greedy_rounding.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dense_lattice_rounding.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Exact_verification.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/General_methods.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Search_limits.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Sparse_rounding.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The way of every problem: eliminate equality constraints, run the method on what is left, expand.
class Mixed_integer_solver
{
public:
  // `linear_solver` shows how to solve.
  Mixed_integer_solver(const Mixed_integer_problem& problem, const Solver_options& options,
                       const Sparse_cholesky<double>& linear_solver, Search_limits& limits)
    : m_problem(problem)
    , m_options(options)
    , m_linear_solver(linear_solver)
    , m_limits(limits)
    , m_go_further([&limits] { return limits.go_further(); })
  {
  }

  Mixed_integer_solution solve()
  {
    m_solution.integers = m_problem.number_of_integers();
    m_solution.constraints = static_cast<int>(m_problem.equality_constraints().size());
    m_A = m_problem.matrix();
    m_b = m_problem.linear_term();
    if(!is_finite())
      return fail(Mixed_integer_status::NUMERICAL_FAILURE, "A coefficient is not a finite number.");
    if(m_problem.has_inequalities() && m_options.method < Rounding_method::BRANCH_AND_BOUND)
      return fail(Mixed_integer_status::UNSUPPORTED_PROBLEM,
                  "Only the branch-and-bound family of methods knows inequality constraints and bounds.");

    m_constraints = eliminate_constraints(m_problem, m_options, m_options.method >= Rounding_method::BRANCH_AND_BOUND);
    m_solution.redundant_constraints = m_constraints.redundant;
    m_solution.conflicting_constraints = m_constraints.conflicting;
    m_reduced = reduce(m_A, m_b, m_problem.constant(), m_constraints);
    m_solution.matrix_entries = static_cast<double>(m_reduced.A.nonZeros());
    m_solution.free_variables = m_reduced.size();
    m_solution.free_integers = static_cast<int>(m_reduced.integers.size());

    m_ran = true;
    switch(m_options.method)
    {
      case Rounding_method::RELAXED: run_relaxed(); break;
      case Rounding_method::DIRECT: m_ran = direct_rounding(m_linear_solver, m_reduced, m_z, m_solution); break;
      case Rounding_method::NAIVE: m_ran = naive_rounding(m_linear_solver, m_reduced, m_z, m_solution, m_limits); break;
      case Rounding_method::GREEDY: run_greedy(); break;
      case Rounding_method::LATTICE: run_lattice(); break;
      default: return run_search();
    }
    return finish();
  }

private:
  bool is_finite() const
  {
    for(int j = 0; j < m_A.cols(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(m_A, j); it; ++it)
        if(!std::isfinite(it.value()))
          return false;
    for(const auto* constraints : { &m_problem.equality_constraints(), &m_problem.inequality_constraints() })
      for(const Mixed_integer_problem::Linear_constraint& c : *constraints)
      {
        if(!std::isfinite(c.rhs))
          return false;
        for(const std::pair<int, double>& a : c.form)
          if(!std::isfinite(a.second))
            return false;
      }
    for(int i = 0; i < m_problem.number_of_variables(); ++i)
      if(std::isnan(m_problem.lower_bound(i)) || std::isnan(m_problem.upper_bound(i)))
        return false;
    return m_b.allFinite() && std::isfinite(m_problem.constant());
  }

  Mixed_integer_solution fail(Mixed_integer_status status, const std::string& message)
  {
    m_solution.status = status;
    m_solution.message = message;
    m_solution.x.resize(0);
    m_solution.energy = std::numeric_limits<double>::quiet_NaN();
    return m_solution;
  }

  void run_relaxed()
  {
    Sparse_cholesky<double> solver = m_linear_solver.make_another();
    m_ran = factorize_semidefinite(solver, m_reduced.A, m_solution.factorizations);
    if(!m_ran)
      return;
    m_z = solver.solve(m_reduced.b);
    m_solution.relaxed_energy = m_solution.lower_bound = m_reduced.energy(m_z);
  }

  bool has_few_integers() const
  {
    return static_cast<int>(m_reduced.integers.size()) <= m_options.maximum_dense_integers;
  }

  // Whether naive rounding, which gives the same result as dense updates, is expected to take less time than these.
  bool is_naive_cheaper() const
  {
    const double few_integers = 200.; // dense updates of so many take milliseconds
    // Operations per second of dense and of sparse code, their ratio is what counts: measured with fields and maps.
    const double dense_speed = 3., sparse_speed = 1.;
    const double columns_at_once = 64.; // of `Three_level_solver::fix_exactly()`, half of them on average
    const double m = static_cast<double>(m_reduced.integers.size()), n = m_reduced.size();
    const bool is_dense = 2. * m_solution.matrix_entries >= n * n; // sparse code has nothing to gain
    if(m <= few_integers || is_dense)
      return false;
    Sparse_cholesky<double> symbolic = m_linear_solver.make_another();
    symbolic.analyze(m_reduced.A);
    const double entries = symbolic.number_of_entries();
    if(entries == 0.)
      return false;
    // The complement over the integers, its factor and inverse, and the updates; against solutions and products with
    // columns.
    const double dense = m * m * (n - m) + 3. * m * m * m;
    const double naive = m * (4. * entries + columns_at_once * n) + m / columns_at_once * entries * entries / n;
    return naive / sparse_speed < dense / dense_speed;
  }

  void run_greedy()
  {
    if(has_few_integers() && is_naive_cheaper())
    {
      m_ran = naive_rounding(m_linear_solver, m_reduced, m_z, m_solution, m_limits);
      return;
    }
    if(!has_few_integers())
    {
      m_ran = sparse_greedy_rounding(m_linear_solver, m_reduced, m_z, m_solution, m_options, m_limits);
      return;
    }
    Integer_energy schur(m_linear_solver);
    if(!keep_integers(schur))
      return;
    m_z = schur.complete(dense_greedy_rounding(schur.factor(), schur.target(), m_limits));
    m_solution.dense_roundings = schur.size();
  }

  // Reduces the energy to that of some of the free variables. Returns false if it is not convex.
  bool compute(Integer_energy& schur, const std::vector<int>& kept)
  {
    std::vector<bool> is_kept(m_reduced.size(), false);
    for(int v : kept)
      is_kept[v] = true;
    const bool is_convex = schur.compute(m_reduced.A, m_reduced.b, is_kept);
    m_solution.factorizations += schur.number_of_factorizations();
    return is_convex;
  }

  bool keep_integers(Integer_energy& schur)
  {
    m_ran = compute(schur, m_reduced.integers);
    if(m_ran)
      m_solution.relaxed_energy = m_reduced.constant + schur.relaxed_energy();
    return m_ran;
  }

  void run_lattice()
  {
    if(!has_few_integers())
    {
      run_greedy();
      return;
    }
    Integer_energy schur(m_linear_solver);
    if(!keep_integers(schur))
      return;
    const Eigen::VectorXd greedy = dense_greedy_rounding(schur.factor(), schur.target(), m_limits);
    m_z = schur.complete(greedy);
    if(is_unbounded())
      return;
    // A search divides its nodes between the ways to look for a point: where time is short, those that it will reach.
    // About what one core visits in a second, the reduction of the basis included.
    const double nodes_per_second = 3e7;
    const double nodes = (std::min)(m_options.maximum_number_of_nodes, nodes_per_second * m_limits.seconds_left());
    m_is_limited_by_time = nodes < m_options.maximum_number_of_nodes;
    Dense_lattice_rounding lattice(schur.matrix(), schur.target(), nodes, m_options.number_of_bound_rounds,
                                   m_go_further);
    const Lattice_result result = lattice.run(greedy);
    m_z = schur.complete(result.y);
    m_solution.nodes = result.nodes;
    m_is_proven = result.is_optimal;
    m_solution.lower_bound = m_reduced.constant + schur.relaxed_energy() + result.cost_bound;
  }

  // The general methods of [Bom12, Ch. 4].
  Mixed_integer_solution run_search()
  {
    General_methods methods(m_problem, m_constraints, m_reduced, m_options, m_linear_solver, m_limits, m_solution);
    const General_methods::Outcome outcome = methods.run();
    m_is_proven = outcome.is_proven;
    if(!outcome.is_found)
      return fail(outcome.status, outcome.message);
    m_z = outcome.z;
    return finish();
  }

  Mixed_integer_solution finish()
  {
    if(!m_ran)
    {
      return fail(Mixed_integer_status::NUMERICAL_FAILURE,
                  "A factorization failed: the energy is not convex where the constraints hold.");
    }
    if(!m_z.allFinite())
      return fail(Mixed_integer_status::NUMERICAL_FAILURE, "The linear system is numerically singular.");
    if(is_unbounded())
      return fail(Mixed_integer_status::UNBOUNDED, "The energy is unbounded below.");
    expand();

    const double epsilon = 1e-10; // keeps the gap finite for zero energies
    const double bound = (std::isfinite(m_solution.relaxed_energy) && m_solution.conflicting_constraints.empty())
                           ? m_solution.relaxed_energy
                           : -std::numeric_limits<double>::infinity();
    m_solution.lower_bound = (std::max)(m_solution.lower_bound, bound);
    if(m_is_proven || m_solution.lower_bound > m_solution.energy)
      m_solution.lower_bound = m_solution.energy;
    m_solution.gap = std::fabs(m_solution.energy - m_solution.lower_bound) / (std::fabs(m_solution.energy) + epsilon);

    const std::string complaint =
      m_options.method == Rounding_method::RELAXED || !m_solution.all_integers_satisfied
        ? std::string()
        : Exact_verification(m_problem, m_solution.conflicting_constraints, m_options.constraint_tolerance)
            .complaint(m_solution.x);
    if(!complaint.empty())
      return fail(Mixed_integer_status::NUMERICAL_FAILURE,
                  "The numbers are too large for the solution to meet " + complaint + " exactly.");
    if(!m_solution.conflicting_constraints.empty())
    {
      m_solution.status = Mixed_integer_status::CONFLICTING_CONSTRAINTS;
      m_solution.message = std::to_string(m_solution.conflicting_constraints.size()) +
                           " constraints contradict the others or the integer conditions and were ignored.";
    }
    else if(m_options.method != Rounding_method::RELAXED && !m_solution.all_integers_satisfied)
    {
      m_solution.status = Mixed_integer_status::INFEASIBLE;
      m_solution.message = "A constraint with real coefficients leaves an integer variable no integer value.";
    }
    else if(m_is_proven || m_solution.gap <= m_options.relative_gap_tolerance)
    {
      m_solution.status = Mixed_integer_status::OPTIMAL;
      m_solution.message = "The energy is minimal.";
    }
    else
    {
      m_solution.status = Mixed_integer_status::FEASIBLE;
      m_solution.message = m_limits.is_out_of_time() || m_is_limited_by_time
                             ? "All conditions hold; the time limit was met before the energy was proven minimal."
                             : "All conditions hold; the energy is not proven minimal.";
    }
    return m_solution;
  }

  // Whether the energy falls for ever along some direction in which it is not curved. The shift that made the
  // singular matrix invertible then leaves a residual, and sends the solution far away.
  bool is_unbounded()
  {
    const double far_away = 1e5, relative_residual = 1e-6;
    if(m_problem.has_inequalities() || m_z.size() == 0 || !(m_z.cwiseAbs().maxCoeff() > far_away))
      return false;
    Sparse_cholesky<double> solver = m_linear_solver.make_another();
    if(!factorize_semidefinite(solver, m_reduced.A, m_solution.factorizations))
      return false;
    const Eigen::VectorXd residual = m_reduced.A * solver.solve(m_reduced.b) - m_reduced.b;
    return residual.cwiseAbs().maxCoeff() > relative_residual * m_reduced.b.cwiseAbs().maxCoeff();
  }

  // The original variables from the free ones.
  Eigen::VectorXd expanded() const
  {
    if(m_constraints.is_identity)
      return m_z;
    Eigen::VectorXd x = m_constraints.T * m_z + m_constraints.t;
    // Where coefficients are large, integers are computed exactly.
    for(std::size_t i = 0; i < m_constraints.exact_T.size(); ++i)
      if(m_problem.is_integer(static_cast<int>(i)))
      {
        CGAL::Exact_rational sum = m_constraints.exact_t[i];
        for(const std::pair<int, CGAL::Exact_rational>& a : m_constraints.exact_T[i])
          sum += a.second * CGAL::Exact_rational(m_z[a.first]);
        x[i] = CGAL::to_double(sum);
      }
    return x;
  }

  void expand()
  {
    // Dependent integers are sums of integers; this is what round-off in real coefficients may leave.
    const double round_off = 1e-9;
    m_solution.x = expanded();
    m_solution.all_integers_satisfied = true;
    for(int i = 0; i < m_problem.number_of_variables(); ++i)
    {
      if(!m_problem.is_integer(i))
        continue;
      double& v = m_solution.x[i];
      const double rounded = std::floor(v + 0.5) + 0.; // no negative zeros
      if(m_options.method != Rounding_method::RELAXED &&
         std::fabs(v - rounded) <= round_off * (std::max)(1., std::fabs(v)))
        v = rounded;
      m_solution.all_integers_satisfied = m_solution.all_integers_satisfied && v == rounded;
    }
    if(m_problem.has_inequalities())
      Exact_verification(m_problem, m_solution.conflicting_constraints, m_options.constraint_tolerance)
        .settle(m_solution.x);
    m_solution.energy = m_solution.x.dot(0.5 * (m_A * m_solution.x) - m_b) + m_problem.constant();
  }

  const Mixed_integer_problem& m_problem;
  const Solver_options& m_options;
  const Sparse_cholesky<double>& m_linear_solver;
  Search_limits& m_limits;
  const std::function<bool()> m_go_further;
  Eigen::SparseMatrix<double> m_A;
  Eigen::VectorXd m_b;
  Eliminated_constraints m_constraints;
  Reduced_problem m_reduced;
  Eigen::VectorXd m_z; // the solution over the free variables
  bool m_ran = false;
  bool m_is_proven = false; // the method has proven its solution optimal
  bool m_is_limited_by_time = false;
  Mixed_integer_solution m_solution;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_MIXED_INTEGER_SOLVER_H
