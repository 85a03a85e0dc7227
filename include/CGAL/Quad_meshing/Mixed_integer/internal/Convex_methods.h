// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONVEX_METHODS_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONVEX_METHODS_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_solution.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Branch_and_bound.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Mixed_integer_solver.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Search_limits.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Tangent_cuts.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Problems with convex constraints g(x) <= 0 ([Bom12, Ch. 3 and 4.2]). Tangents of violated constraints,
//   g(p) + g'(p) (x - p) <= 0,
// are linear constraints that all feasible points meet. With them the problem without g, the master, has the methods of
// `General_methods`, and its bounds are bounds of the whole.
//
// - Extended cutting planes (Westerlund and Pettersson 1995): solve the master, add tangents at its solution, until
//   it violates nothing.
// - Outer approximation (Duran and Grossmann 1986; Fletcher and Leyffer 1994): besides, solve for the reals with the
//   integers of the master fixed, which gives a point and an upper bound, and tangents there. If there is no such point
//   the tangents that prove it exclude these integers.
// - Branch-and-bound: the relaxations of the nodes are solved by tangents, which all nodes share.
//
// First comes the feasibility problem with the integers taken for reals.
class Convex_methods
{
  typedef Mixed_integer_status Status;

public:
  Convex_methods(const Mixed_integer_problem& problem, const Solver_options& options,
                 const Sparse_cholesky<double>& linear_solver, Search_limits& limits)
    : m_problem(problem)
    , m_options(options)
    , m_linear_solver(linear_solver)
    , m_limits(limits)
    , m_master(problem)
    , m_cuts(problem)
  {
    m_master.clear_convex_constraints();
  }

  Mixed_integer_solution solve()
  {
    if(m_options.method < Rounding_method::BRANCH_AND_BOUND)
      return failure(Status::UNSUPPORTED_PROBLEM,
                     "Only the branch-and-bound family of methods knows convex constraints.");
    const Mixed_integer_solution point = relaxed_point();
    if(point.status != Status::OPTIMAL)
      return point;
    m_center = point.x;
    m_cuts.set_inside(m_center);
    const Mixed_integer_solution solution = search();
    if(!m_cuts.are_finite())
      return failure(Status::NUMERICAL_FAILURE, "A function of a constraint has no finite value.");
    return solution;
  }

  // The first phase alone: a point that meets all constraints if integers are taken for reals, with the status
  // `OPTIMAL`.
  Mixed_integer_solution relaxed_point()
  {
    if(!m_cuts.are_convex())
      return failure(Status::NUMERICAL_FAILURE, "A quadratic constraint is not convex.");
    Mixed_integer_solution point;
    const Status status = find_relaxed_point(point);
    if(!m_cuts.are_finite())
      return failure(Status::NUMERICAL_FAILURE, "A function of a constraint has no finite value.");
    if(status != Status::OPTIMAL)
      return ended(status, point);
    point.cuts = m_cuts.count();
    return point;
  }

private:
  Mixed_integer_solution search()
  {
    return m_options.method == Rounding_method::BRANCH_AND_BOUND ? branch_and_bound() : cutting_planes();
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  // Between the bounds, relative to one and the energy: tangents approach a curved constraint, they do not reach it.
  static constexpr double gap_tolerance = 1e-7;
  static constexpr int maximum_rounds = 2000; // of tangents for one relaxation

  Mixed_integer_solution failure(Status status, const std::string& message) const
  {
    Mixed_integer_solution solution;
    solution.status = status;
    solution.message = message;
    solution.integers = m_problem.number_of_integers();
    solution.constraints = static_cast<int>(m_problem.equality_constraints().size());
    solution.nodes = m_nodes;
    solution.cuts = m_cuts.count();
    return solution;
  }

  // The end of a search without a solution.
  Mixed_integer_solution ended(Status status, const Mixed_integer_solution& last) const
  {
    if(status == Status::INFEASIBLE)
      return failure(status, "No point meets all constraints, bounds and integer conditions.");
    if(status == Status::LIMIT_REACHED)
      return failure(status, m_limits.is_out_of_time() ? "The time limit was met before a feasible solution was found."
                                                       : "A limit was met before a feasible solution was found.");
    return failure(status, last.message);
  }

  // Solves a problem with linear constraints.
  Mixed_integer_solution run(const Mixed_integer_problem& problem, Rounding_method method)
  {
    Solver_options options = m_options;
    options.method = method;
    Mixed_integer_solution solution = Mixed_integer_solver(problem, options, m_linear_solver, m_limits).solve();
    m_nodes += solution.nodes;
    return solution;
  }

  // Like `run()`, where the energy may be unbounded without the convex constraints: they are given tangents far away.
  Mixed_integer_solution run_bounded(const Mixed_integer_problem& problem, Rounding_method method)
  {
    // Of boxes around a point that meets the convex constraints. Far away the tangents of steep functions have numbers
    // of any size, so the first box is small.
    const double first_radius = 16., last_radius = 1099511627776.;
    Mixed_integer_solution solution = run(problem, method);
    if(solution.status != Status::UNBOUNDED)
      return solution;
    Mixed_integer_problem bounded = problem;
    for(double radius = first_radius; radius <= last_radius;)
    {
      Mixed_integer_problem boxed = bounded;
      for(int v = 0; v < boxed.number_of_variables(); ++v)
        boxed.set_bounds(v, (std::max)(boxed.lower_bound(v), std::floor(m_center[v] - radius)),
                         (std::min)(boxed.upper_bound(v), std::ceil(m_center[v] + radius)));
      const Mixed_integer_solution far = run(boxed, Rounding_method::BRANCH_AND_BOUND);
      if(!far.is_valid() || !m_limits.go_further())
        return far;
      const int before = m_cuts.count();
      if(!m_cuts.add_violated(far.x, m_master))
      {
        radius *= first_radius;
        continue;
      }
      m_cuts.copy_since(before, bounded);
      solution = run(bounded, method);
      if(solution.status != Status::UNBOUNDED)
        return solution;
    }
    solution.message = "The energy is unbounded below, as far as numbers reach.";
    return solution;
  }

  Mixed_integer_problem with_bounds(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, bool are_reals) const
  {
    Mixed_integer_problem result = m_master;
    for(int v = 0; v < result.number_of_variables(); ++v)
    {
      result.set_bounds(v, lower[v], upper[v]);
      if(are_reals)
        result.set_integer(v, false);
    }
    return result;
  }

  // Minimizes the energy with all constraints where integers are reals or fixed. Bounds are proven all along.
  Mixed_integer_solution minimize_reals(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, bool are_reals)
  {
    for(int round = 0;; ++round)
    {
      const Mixed_integer_solution solution =
        run_bounded(with_bounds(lower, upper, are_reals), Rounding_method::BRANCH_AND_BOUND);
      if(!solution.is_valid() || !m_cuts.add_violated(solution.x, m_master))
        return solution;
      if(round == maximum_rounds || !m_limits.go_further())
        return failure(Status::LIMIT_REACHED, "");
    }
  }

  // Phase one, the feasibility problem [Bom12, Ch. 3]: with the integers taken for reals, a point where the largest of
  // all g is at most zero. Among the points that meet the tangents, the one nearest to the last is next: so the points
  // stay where tangents are good, and if there is none, none meets the constraints.
  Status find_relaxed_point(Mixed_integer_solution& solution)
  {
    const int n = m_problem.number_of_variables();
    Eigen::VectorXd last = Eigen::VectorXd::Zero(n);
    Eigen::SparseMatrix<double> identity(n, n);
    identity.setIdentity();
    for(int round = 0;; ++round)
    {
      Mixed_integer_problem nearest = m_master;
      for(int v = 0; v < n; ++v)
        nearest.set_integer(v, false);
      nearest.set_energy(identity, last);
      solution = run(nearest, Rounding_method::BRANCH_AND_BOUND);
      if(solution.status == Status::FEASIBLE)
        solution.status = Status::OPTIMAL; // any point will do
      if(solution.status != Status::OPTIMAL || !m_cuts.add_violated(solution.x, m_master))
        return solution.status;
      if(round == maximum_rounds || !m_limits.go_further())
        return Status::LIMIT_REACHED;
      last = solution.x;
    }
  }

  bool is_closed(double bound) const
  {
    return m_best.is_valid() && m_best.energy - bound <= (std::max)(m_options.relative_gap_tolerance, gap_tolerance) *
                                                           (1. + std::fabs(m_best.energy));
  }

  void accept(const Mixed_integer_solution& solution)
  {
    if(!m_best.is_valid() || solution.energy < m_best.energy)
      m_best = solution;
  }

  // The best solution with what is known of it.
  Mixed_integer_solution finished(double lower_bound, bool is_complete)
  {
    const double epsilon = 1e-10; // keeps the gap finite for zero energies
    if(!m_best.is_valid())
      return ended(is_complete ? Status::INFEASIBLE : Status::LIMIT_REACHED, m_best);
    m_best.lower_bound = (std::min)(lower_bound, m_best.energy);
    m_best.gap = (m_best.energy - m_best.lower_bound) / (std::fabs(m_best.energy) + epsilon);
    m_best.nodes = m_nodes;
    m_best.cuts = m_cuts.count();
    m_best.relaxed_energy = m_relaxed_energy;
    const bool is_optimal = is_complete && is_closed(m_best.lower_bound);
    m_best.status = is_optimal ? Status::OPTIMAL : Status::FEASIBLE;
    m_best.message = is_optimal ? "The energy is minimal."
                     : m_limits.is_out_of_time()
                       ? "All conditions hold; the time limit was met before the energy was proven minimal."
                       : "All conditions hold; the energy is not proven minimal.";
    return m_best;
  }

  // Extended cutting planes and outer approximation.
  Mixed_integer_solution cutting_planes()
  {
    const bool is_outer_approximation = m_options.method == Rounding_method::OUTER_APPROXIMATION;
    const Rounding_method method =
      is_outer_approximation ? Rounding_method::BRANCH_AND_BOUND : Rounding_method::BRANCH_AND_CUT;
    double lower_bound = -infinity;
    for(int round = 0;; ++round)
    {
      const Mixed_integer_solution solution = run_bounded(m_master, method);
      if(solution.status == Status::INFEASIBLE)
        return finished(infinity, true);
      if(!solution.is_valid())
        return m_best.is_valid() ? finished(lower_bound, false) : ended(solution.status, solution);
      lower_bound = (std::max)(lower_bound, solution.lower_bound);
      if(!std::isfinite(m_relaxed_energy))
        m_relaxed_energy = solution.relaxed_energy;
      const bool is_proven = solution.status == Status::OPTIMAL;
      if(!m_cuts.add_violated(solution.x, m_master))
      {
        accept(solution);
        return finished(lower_bound, is_proven);
      }
      if(!is_proven || round == maximum_rounds || m_nodes >= m_options.maximum_number_of_nodes ||
         !m_limits.go_further())
        return finished(lower_bound, false);
      if(is_outer_approximation)
      {
        Eigen::VectorXd lower(solution.x.size()), upper(solution.x.size());
        for(int v = 0; v < lower.size(); ++v)
        {
          lower[v] = m_problem.is_integer(v) ? solution.x[v] : m_problem.lower_bound(v);
          upper[v] = m_problem.is_integer(v) ? solution.x[v] : m_problem.upper_bound(v);
        }
        const Mixed_integer_solution completed = minimize_reals(lower, upper, false);
        if(completed.is_valid())
          accept(completed);
      }
      if(is_closed(lower_bound))
        return finished(lower_bound, true);
    }
  }

  struct Node
  {
    Eigen::VectorXd lower, upper, x;
    double bound = -infinity;
    int depth = 0;
    int variable = -1;
  };
  // Ascending: the first is taken next. The number keeps the order of nodes that are otherwise equal.
  typedef std::tuple<double, long, std::shared_ptr<Node>> Entry;

  Mixed_integer_solution branch_and_bound()
  {
    const int n = m_problem.number_of_variables();
    m_is_integer.resize(n);
    Node root;
    root.lower.resize(n);
    root.upper.resize(n);
    for(int v = 0; v < n; ++v)
    {
      m_is_integer[v] = m_problem.is_integer(v);
      root.lower[v] = m_problem.lower_bound(v);
      root.upper[v] = m_problem.upper_bound(v);
    }
    m_pseudo_costs.reset(new Pseudo_costs(Eigen::VectorXd::Ones(n)));
    Status status = evaluate(root);
    if(status != Status::OPTIMAL)
      return failure(status, m_last_message);
    m_relaxed_energy = root.bound;
    double fathomed =
      infinity; // the least bound of nodes that were given up as they were no better than the best point
    while(!m_queue.empty())
    {
      if(m_nodes >= m_options.maximum_number_of_nodes || !m_limits.go_further())
        return finished((std::min)(fathomed, open_bound()), false);
      const std::shared_ptr<Node> node = std::get<2>(*m_queue.begin());
      m_queue.erase(m_queue.begin());
      if(is_closed(node->bound))
      {
        fathomed = (std::min)(fathomed, node->bound);
        continue;
      }
      const int v = node->variable;
      const double below = node->x[v] - std::floor(node->x[v]);
      for(int direction : { below < 0.5 ? 1 : 0, below < 0.5 ? 0 : 1 }) // the nearer side last
      {
        Node child = *node;
        ++child.depth;
        (direction == 0 ? child.upper : child.lower)[v] = std::floor(node->x[v]) + direction;
        const double parent_bound = node->bound;
        status = evaluate(child);
        if(status == Status::OPTIMAL)
          m_pseudo_costs->learn(v, direction, direction == 0 ? below : 1. - below,
                                (std::max)(0., child.bound - parent_bound));
        else if(status != Status::INFEASIBLE)
          return finished((std::min)({ fathomed, open_bound(), parent_bound }), false);
      }
    }
    return finished((std::min)(fathomed, m_best.is_valid() ? m_best.lower_bound : infinity), true);
  }

  double open_bound() const
  {
    double bound = infinity;
    for(const Entry& e : m_queue)
      bound = (std::min)(bound, std::get<2>(e)->bound);
    return bound;
  }

  // Solves the relaxation of a node, and queues it if it has to be divided.
  Status evaluate(Node& node)
  {
    const double integer_tolerance = 1e-6;
    const Mixed_integer_solution relaxed = minimize_reals(node.lower, node.upper, true);
    m_last_message = relaxed.message;
    if(!relaxed.is_valid())
      return relaxed.status;
    node.bound = (std::max)(node.bound, relaxed.lower_bound);
    node.x = relaxed.x;
    node.variable = branching_variable(node.x, m_is_integer, integer_tolerance, m_options.branching_rule,
                                       *m_pseudo_costs, node.depth);
    if(node.variable < 0)
    {
      // With the integers at integers; where these do not fit, the node is divided on.
      Eigen::VectorXd lower = node.lower, upper = node.upper;
      for(int v = 0; v < lower.size(); ++v)
        if(m_is_integer[v])
          lower[v] = upper[v] = std::floor(node.x[v] + 0.5);
      Mixed_integer_solution completed = minimize_reals(lower, upper, false);
      if(!completed.is_valid() && completed.status != Status::INFEASIBLE)
        return completed.status;
      if(completed.is_valid())
      {
        completed.lower_bound = node.bound;
        accept(completed);
      }
      for(int v = 0; v < lower.size() && node.variable < 0; ++v)
        if(m_is_integer[v] && node.lower[v] < node.upper[v] && !is_closed(node.bound))
        {
          node.variable = v;
          node.x[v] = lower[v] < node.upper[v] ? lower[v] + 0.5 : lower[v] - 0.5;
        }
      if(node.variable < 0)
        return Status::OPTIMAL;
    }
    if(is_closed(node.bound))
    {
      m_best.lower_bound = (std::min)(m_best.lower_bound, node.bound);
      return Status::OPTIMAL;
    }
    double key = node.bound;
    if(m_options.subproblem_selection == Subproblem_selection::DEPTH_FIRST)
      key = -node.depth;
    else if(m_options.subproblem_selection == Subproblem_selection::BEST_ESTIMATE)
      for(int v = 0; v < node.x.size(); ++v)
        if(m_is_integer[v])
        {
          const double below = node.x[v] - std::floor(node.x[v]);
          key += (std::min)(below * m_pseudo_costs->estimate(v, 0), (1. - below) * m_pseudo_costs->estimate(v, 1));
        }
    m_queue.insert(Entry(key, -(++m_number), std::make_shared<Node>(node)));
    return Status::OPTIMAL;
  }

  const Mixed_integer_problem& m_problem;
  const Solver_options& m_options;
  const Sparse_cholesky<double>& m_linear_solver;
  Search_limits& m_limits;
  Mixed_integer_problem m_master; // without the convex constraints, with tangents
  Tangent_cuts m_cuts;
  Eigen::VectorXd m_center; // meets the convex constraints
  Mixed_integer_solution m_best;
  double m_relaxed_energy = std::numeric_limits<double>::quiet_NaN();
  double m_nodes = 0;
  std::vector<char> m_is_integer;
  std::unique_ptr<Pseudo_costs> m_pseudo_costs;
  std::set<Entry> m_queue;
  std::string m_last_message;
  long m_number = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONVEX_METHODS_H
