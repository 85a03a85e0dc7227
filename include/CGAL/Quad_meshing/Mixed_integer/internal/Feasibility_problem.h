// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_FEASIBILITY_PROBLEM_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_FEASIBILITY_PROBLEM_H

#include <CGAL/Quad_meshing/Mixed_integer/Feasible_point.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Convex_methods.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Exact_verification.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Mixed_integer_solver.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Search_limits.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Tangent_cuts.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The feasibility problem [Bom12, Ch. 3]: one more variable z, at least zero, that all inequalities may be exceeded by,
// and that is minimized.
class Feasibility_problem
{
  typedef Mixed_integer_problem Problem;
  typedef Mixed_integer_solution Solution;
  typedef Mixed_integer_status Status;

public:
  Feasibility_problem(const Problem& problem, const Solver_options& options,
                      const Sparse_cholesky<double>& linear_solver, Search_limits& limits)
    : m_problem(problem)
    , m_options(options)
    , m_linear_solver(linear_solver)
    , m_limits(limits)
    , m_cuts(m_problem)
    , m_is_relaxed(options.method == Rounding_method::RELAXED)
  {
    if(!m_is_relaxed)
      return;
    m_options.method = Rounding_method::BRANCH_AND_BOUND;
    for(int i = 0; i < m_problem.number_of_variables(); ++i)
      m_problem.set_integer(i, false);
  }

  Feasible_point solve()
  {
    if(m_options.method < Rounding_method::BRANCH_AND_BOUND)
      return ended(Status::UNSUPPORTED_PROBLEM, "Only the branch-and-bound family of methods finds feasible points.");
    if(!m_cuts.are_convex())
      return ended(Status::NUMERICAL_FAILURE, "A quadratic constraint is not convex.");
    bool is_infeasible = false;
    // Where constraints are curved, going from point to point costs less than to minimize z.
    if(m_is_relaxed && has_curves())
    {
      const Solution point = Convex_methods(m_problem, m_options, m_linear_solver, m_limits).relaxed_point();
      m_result.cuts = point.cuts;
      is_infeasible = point.status == Status::INFEASIBLE;
      if(point.status == Status::OPTIMAL)
        return found(point.x, 0., false);
      if(!is_infeasible)
        return ended(point.status, point.message);
    }
    const Problem relaxed = with_excess();
    const Solution solution = has_curves()
                                ? Convex_methods(relaxed, m_options, m_linear_solver, m_limits).solve()
                                : Mixed_integer_solver(relaxed, m_options, m_linear_solver, m_limits).solve();
    m_result.cuts += solution.cuts;
    if(!solution.conflicting_constraints.empty())
      return ended(Status::INFEASIBLE, std::to_string(solution.conflicting_constraints.size()) +
                                         " equality constraints contradict the others or the integer conditions.");
    if(solution.status == Status::INFEASIBLE)
      return ended(Status::INFEASIBLE, "No point meets the equality constraints, bounds and integer conditions.");
    if(!solution.is_valid())
      return ended(solution.status, solution.message);
    return found(solution.x.head(m_problem.number_of_variables()), solution.lower_bound, is_infeasible);
  }

private:
  bool has_curves() const { return !m_problem.convex_constraints().empty(); }

  // The problem with z as its last variable and as its energy.
  Problem with_excess() const
  {
    const int n = m_problem.number_of_variables();
    Problem result(n + 1);
    for(int i = 0; i < n; ++i)
    {
      result.set_integer(i, m_problem.is_integer(i));
      result.set_bounds(i, m_problem.lower_bound(i), m_problem.upper_bound(i));
    }
    result.set_bounds(n, 0., Problem::infinity());
    result.set_energy(Eigen::SparseMatrix<double>(n + 1, n + 1), -Eigen::VectorXd::Unit(n + 1, n));
    for(const Problem::Linear_constraint& c : m_problem.equality_constraints())
      result.add_equality_constraint(c.form, c.rhs);
    for(const Problem::Linear_constraint& c : m_problem.inequality_constraints())
    {
      Problem::Linear_form form = c.form;
      form.emplace_back(n, -1.);
      result.add_inequality_constraint(form, c.rhs);
    }
    for(const Problem::Convex_constraint& c : m_problem.convex_constraints())
    {
      std::vector<int> variables = c.variables;
      variables.push_back(n);
      result.add_convex_constraint(variables, with_excess(c.function, static_cast<int>(c.variables.size())));
    }
    return result;
  }

  // A function of n variables, minus one more variable.
  static Problem::Convex_function with_excess(const Problem::Convex_function& function, int n)
  {
    return [function, n](const Eigen::VectorXd& x, Eigen::VectorXd& gradient)
    {
      Eigen::VectorXd inner = Eigen::VectorXd::Zero(n);
      const double value = function(x.head(n), inner) - x[n];
      gradient.resize(n + 1);
      gradient << inner, -1.;
      return value;
    };
  }

  double violation(const Eigen::VectorXd& x) const
  {
    double result = m_cuts.largest_value(x);
    for(const Problem::Linear_constraint& c : m_problem.inequality_constraints())
    {
      double sum = -c.rhs;
      for(const std::pair<int, double>& a : c.form)
        sum += a.second * x[a.first];
      result = (std::max)(result, sum);
    }
    return result;
  }

  Feasible_point found(const Eigen::VectorXd& x, double lower_bound, bool is_infeasible)
  {
    // A bound that may be due to the accuracy of tangents proves nothing.
    const double least_bound = has_curves() ? 1e-7 : 0.;
    m_result.x = x;
    m_result.violation = violation(x);
    m_result.lower_bound = (std::max)(0., (std::min)(lower_bound, m_result.violation));
    if(!is_infeasible && m_cuts.are_met(x) &&
       Exact_verification(m_problem, {}, m_options.constraint_tolerance).complaint(x).empty())
      return ended(Status::FEASIBLE, "The point meets all constraints.");
    if(is_infeasible || m_result.lower_bound > least_bound)
      return ended(Status::INFEASIBLE, "No point meets all constraints; this one violates the inequalities least.");
    return ended(Status::LIMIT_REACHED, "A limit was met before a feasible point was found.");
  }

  Feasible_point ended(Status status, const std::string& message)
  {
    m_result.status = status;
    m_result.message = message;
    return m_result;
  }

  Problem m_problem;
  Solver_options m_options;
  const Sparse_cholesky<double>& m_linear_solver;
  Search_limits& m_limits;
  const Tangent_cuts m_cuts;
  const bool m_is_relaxed;
  Feasible_point m_result;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_FEASIBILITY_PROBLEM_H
