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
#include <CGAL/Quad_meshing/Mixed_integer/internal/Branch_and_bound.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Branch_and_cut.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Constraint_elimination.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dense_greedy_rounding.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dense_lattice_rounding.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Sparse_rounding.h>

#include <chrono>
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
                       const Sparse_cholesky<double>& linear_solver)
    : m_problem(problem), m_options(options), m_linear_solver(linear_solver)
  {}

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

    m_constraints = eliminate_constraints(m_problem, m_options.constraint_tolerance);
    m_solution.redundant_constraints = m_constraints.redundant;
    m_solution.conflicting_constraints = m_constraints.conflicting;
    m_reduced = reduce(m_A, m_b, m_problem.constant(), m_constraints);
    m_solution.free_variables = m_reduced.size();
    m_solution.free_integers = static_cast<int>(m_reduced.integers.size());

    m_ran = true;
    switch(m_options.method)
    {
      case Rounding_method::RELAXED: run_relaxed(); break;
      case Rounding_method::DIRECT: m_ran = direct_rounding(m_linear_solver, m_reduced, m_z, m_solution); break;
      case Rounding_method::NAIVE:
        m_ran = naive_rounding(m_linear_solver, m_reduced, m_z, m_solution, m_options);
        break;
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

  void run_greedy()
  {
    if(!has_few_integers())
    {
      m_ran = sparse_greedy_rounding(m_linear_solver, m_reduced, m_z, m_solution, m_options);
      return;
    }
    Integer_energy schur(m_linear_solver);
    if(!keep_integers(schur))
      return;
    m_z = schur.complete(dense_greedy_rounding(schur.factor(), schur.target()));
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

  // Asks the visitor and the clock.
  std::function<bool()> limits()
  {
    const std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    return [this, begin]()
    {
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      return seconds < m_options.maximum_running_time && m_options.go_further(0.5);
    };
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
    const std::function<bool()> go_further = limits();
    const Eigen::VectorXd greedy = dense_greedy_rounding(schur.factor(), schur.target());
    m_z = schur.complete(greedy);
    if(is_unbounded())
      return;
    Dense_lattice_rounding lattice(schur.matrix(), schur.target(), m_options.maximum_number_of_nodes,
                                   m_options.number_of_bound_rounds, go_further);
    const Lattice_result result = lattice.run(greedy);
    m_z = schur.complete(result.y);
    m_solution.nodes = result.nodes;
    m_is_proven = result.is_optimal;
    m_solution.lower_bound = m_reduced.constant + schur.relaxed_energy() + result.cost_bound;
  }

  // The general methods of thesis Ch. 4.
  Mixed_integer_solution run_search()
  {
    const Bounded_problem bounded = make_bounded_problem(m_problem, m_constraints);
    if(bounded.is_infeasible)
      return fail(Mixed_integer_status::INFEASIBLE, "A bound contradicts the other constraints.");
    double largest = 0.;
    for(int j = 0; j < m_reduced.A.cols(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(m_reduced.A, j); it; ++it)
        largest = (std::max)(largest, std::fabs(it.value()));
    return largest == 0. ? search_linear(bounded) : search_quadratic(bounded);
  }

  Mixed_integer_solution search_linear(const Bounded_problem& bounded)
  {
    std::vector<char> is_kept(m_reduced.size(), 0);
    for(int v : bounded.kept)
      is_kept[v] = 1;
    for(int v = 0; v < m_reduced.size(); ++v)
      if(!is_kept[v] && m_reduced.b[v] != 0.)
        return fail(Mixed_integer_status::UNBOUNDED, "The energy is unbounded below.");
    const std::function<bool()> go_further = limits();
    const Eigen::VectorXd c = -subvector(m_reduced.b, bounded.kept);
    const Linear_master master(bounded, c, m_reduced.constant);
    Exact_dual_simplex relaxation = master.make_program();
    if(relaxation.solve())
      m_solution.relaxed_energy = m_reduced.constant + CGAL::to_double(relaxation.objective());
    Search_result result;
    if(m_options.method == Rounding_method::CUTTING_PLANES)
      result = cutting_planes(master, m_options, go_further);
    else
    {
      Branch_and_cut search(master, m_options, m_options.method == Rounding_method::BRANCH_AND_BOUND ? 0 : cut_rounds,
                            go_further);
      result = search.run(Eigen::VectorXd(), 0.);
    }
    if(result.is_found)
    {
      m_z = Eigen::VectorXd::Zero(m_reduced.size());
      for(int i = 0; i < bounded.size(); ++i)
        m_z[bounded.kept[i]] = result.y[i];
    }
    return finish_search(result);
  }

  Mixed_integer_solution search_quadratic(const Bounded_problem& bounded)
  {
    if(m_options.method == Rounding_method::CUTTING_PLANES)
      return fail(Mixed_integer_status::UNSUPPORTED_PROBLEM,
                  "Cutting planes alone need a linear objective; outer approximation takes convex ones.");
    // The other variables follow from those that matter to the search.
    Integer_energy schur(m_linear_solver);
    m_ran = compute(schur, bounded.kept);
    if(!m_ran || bounded.size() == 0)
    {
      if(m_ran)
      {
        m_z = schur.complete(schur.target());
        m_solution.relaxed_energy = m_solution.lower_bound = m_reduced.constant + schur.relaxed_energy();
      }
      return finish();
    }

    const std::function<bool()> go_further = limits();
    const double constant = m_reduced.constant + schur.relaxed_energy();
    Eigen::VectorXd incumbent;
    double radius = std::numeric_limits<double>::infinity();
    if(!m_problem.has_inequalities())
    {
      incumbent = dense_greedy_rounding(schur.factor(), schur.target());
      radius = schur.cost(incumbent);
      m_solution.relaxed_energy = constant;
      m_z = schur.complete(incumbent);
      if(is_unbounded())
        return finish();
    }
    Search_result result;
    if(m_options.method == Rounding_method::BRANCH_AND_BOUND)
    {
      Branch_and_bound search(bounded, schur.matrix(), schur.target(), constant, m_options, go_further);
      if(incumbent.size() == 0)
        m_solution.relaxed_energy = search.relaxed_energy();
      result = search.run(incumbent, constant + radius);
    }
    else
    {
      const Linear_master master(bounded, schur.matrix(), schur.target(), constant, radius);
      if(incumbent.size() == 0)
        m_solution.relaxed_energy =
          Branch_and_bound(bounded, schur.matrix(), schur.target(), constant, m_options, go_further).relaxed_energy();
      if(m_options.method == Rounding_method::OUTER_APPROXIMATION)
        result = outer_approximation(master, m_options, incumbent, constant + radius, go_further);
      else
      {
        Branch_and_cut search(master, m_options, cut_rounds, go_further);
        result = search.run(incumbent, constant + radius);
      }
    }
    if(result.is_found)
      m_z = schur.complete(result.y);
    return finish_search(result);
  }

  Mixed_integer_solution finish_search(const Search_result& result)
  {
    m_solution.nodes = result.nodes;
    m_solution.cuts = result.cuts;
    if(result.is_unbounded)
      return fail(Mixed_integer_status::UNBOUNDED, "The energy is unbounded below.");
    if(!result.is_found && result.is_complete)
      return fail(Mixed_integer_status::INFEASIBLE, "No point meets all constraints, bounds and integer conditions.");
    m_solution.lower_bound = result.lower_bound;
    if(!result.is_found)
      return fail(Mixed_integer_status::LIMIT_REACHED, "A limit was met before a feasible solution was found.");
    m_is_proven = result.is_complete && m_options.relative_gap_tolerance <= proof_tolerance;
    return finish();
  }

  // A search that may leave a larger gap reports the bound it has proven, not the energy.
  static constexpr double proof_tolerance = 1e-6;
  static constexpr int cut_rounds = 5;

  Mixed_integer_solution finish()
  {
    if(!m_ran)
    {
      if(!m_options.go_further(1.))
        return fail(Mixed_integer_status::LIMIT_REACHED, "The visitor asked to stop.");
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
      ? m_solution.relaxed_energy : -std::numeric_limits<double>::infinity();
    m_solution.lower_bound = (std::max)(m_solution.lower_bound, bound);
    if(m_is_proven || m_solution.lower_bound > m_solution.energy)
      m_solution.lower_bound = m_solution.energy;
    m_solution.gap = std::fabs(m_solution.energy - m_solution.lower_bound)
                     / (std::fabs(m_solution.energy) + epsilon);

    if(!m_solution.conflicting_constraints.empty())
    {
      m_solution.status = Mixed_integer_status::CONFLICTING_CONSTRAINTS;
      m_solution.message = std::to_string(m_solution.conflicting_constraints.size())
        + " constraints contradict the others or the integer conditions and were ignored.";
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
      m_solution.message = "All conditions hold; the energy is not proven minimal.";
    }
    return m_solution;
  }

  // Whether the energy falls for ever along some direction in which it is not curved. The shift that made the singular matrix
  // invertible then leaves a residual, and sends the solution far away.
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

  void expand()
  {
    // Dependent integers are sums of integers; this is what round-off in real coefficients may leave.
    const double round_off = 1e-9;
    if(m_constraints.is_identity)
      m_solution.x = m_z;
    else
      m_solution.x = m_constraints.T * m_z + m_constraints.t;
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
    m_solution.energy = m_solution.x.dot(0.5 * (m_A * m_solution.x) - m_b) + m_problem.constant();
  }

  const Mixed_integer_problem& m_problem;
  const Solver_options& m_options;
  const Sparse_cholesky<double>& m_linear_solver;
  Eigen::SparseMatrix<double> m_A;
  Eigen::VectorXd m_b;
  Eliminated_constraints m_constraints;
  Reduced_problem m_reduced;
  Eigen::VectorXd m_z; // the solution over the free variables
  bool m_ran = false;
  bool m_is_proven = false; // the method has proven its solution optimal
  Mixed_integer_solution m_solution;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_MIXED_INTEGER_SOLVER_H
