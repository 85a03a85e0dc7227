// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BRANCH_AND_BOUND_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BRANCH_AND_BOUND_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Bounded_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dual_active_set.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What a search over a `Bounded_problem` found.
struct Search_result
{
  bool is_found = false;
  bool is_complete = false;    // the tree was searched to its end, up to the gap asked for
  bool is_unbounded = false;
  Eigen::VectorXd y;
  double energy = std::numeric_limits<double>::infinity();
  double lower_bound = -std::numeric_limits<double>::infinity();
  double nodes = 0.;
  int cuts = 0;

  // Takes a solution if it is the best so far.
  void accept(const Eigen::VectorXd& solution, double its_energy)
  {
    if(is_found && its_energy >= energy)
      return;
    is_found = true;
    y = solution;
    energy = its_energy;
  }
};

// The choice of a branching variable by the change of the bound that branchings on it brought so far (thesis 4.1,
// pseudo-costs), per unit of change of the variable, downwards and upwards.
class Pseudo_costs
{
public:
  // `initial` is a guess for each variable.
  explicit Pseudo_costs(const Eigen::VectorXd& initial)
    : m_sum{ initial, initial }
    , m_count{ Eigen::VectorXd::Ones(initial.size()), Eigen::VectorXd::Ones(initial.size()) }
  {}

  void learn(int variable, int direction, double change, double gain)
  {
    m_sum[direction][variable] += gain / (std::max)(change, 1e-6);
    m_count[direction][variable] += 1.;
  }

  double estimate(int variable, int direction) const
  {
    return m_sum[direction][variable] / m_count[direction][variable];
  }

private:
  Eigen::VectorXd m_sum[2], m_count[2];
};

// Returns the integer variable to branch on, -1 if all are integers up to `tolerance`.
inline int branching_variable(const Eigen::VectorXd& y, const std::vector<char>& is_integer, double tolerance,
                              Branching_rule rule, const Pseudo_costs& pseudo_costs)
{
  int best = -1;
  double best_score = -std::numeric_limits<double>::infinity();
  for(int i = 0; i < y.size(); ++i)
  {
    if(!is_integer[i])
      continue;
    const double below = y[i] - std::floor(y[i]), above = 1. - below;
    const double infeasibility = (std::min)(below, above);
    if(infeasibility <= tolerance)
      continue;
    double score = 0.;
    switch(rule)
    {
      case Branching_rule::MINIMUM_INFEASIBILITY: score = -infeasibility; break;
      case Branching_rule::MAXIMUM_INFEASIBILITY: score = infeasibility; break;
      case Branching_rule::PSEUDO_COSTS:
        score = (below * pseudo_costs.estimate(i, 0)) * (above * pseudo_costs.estimate(i, 1));
        break;
    }
    if(score > best_score)
    {
      best_score = score;
      best = i;
    }
  }
  return best;
}

// Branch-and-bound (thesis 4.1) for E(y) = 1/2 (y - y*)' S (y - y*) + constant with constraints, by the dual
// active-set method, whose cost is the bound of a subproblem.
class Branch_and_bound
{
  struct Node
  {
    Eigen::VectorXd lower, upper, y;
    double energy, estimate;
    int depth;
  };

public:
  Branch_and_bound(const Bounded_problem& problem, const Eigen::MatrixXd& S, const Eigen::VectorXd& target,
                   double constant, const Solver_options& options, const std::function<bool()>& go_further)
    : m_problem(problem)
    , m_inverse_factor(inverse_transposed_factor(S))
    , m_target(target)
    , m_constant(constant)
    , m_options(options)
    , m_go_further(go_further)
    , m_quadratic(m_inverse_factor, m_target)
    , m_pseudo_costs(initial_costs(m_inverse_factor))
  {}

  // The least energy without integer conditions, infinite if the constraints contradict each other.
  double relaxed_energy()
  {
    Eigen::VectorXd y;
    double energy;
    return relax(m_problem.lower, m_problem.upper, y, energy) ? energy : std::numeric_limits<double>::infinity();
  }

  // `incumbent` is a feasible point to start with; it may be empty.
  Search_result run(const Eigen::VectorXd& incumbent, double incumbent_energy)
  {
    m_result = Search_result();
    if(incumbent.size() > 0)
      m_result.accept(incumbent, incumbent_energy);
    if(m_problem.is_infeasible)
    {
      m_result.is_complete = true;
      return m_result;
    }
    add(m_problem.lower, m_problem.upper, 0);
    bool is_stopped = false;
    while(!m_queue.empty())
    {
      if(gap_closed(lower_bound()))
        break;
      if(m_result.nodes >= m_options.maximum_number_of_nodes || !m_go_further())
      {
        is_stopped = true;
        break;
      }
      // A branch-and-bound step: select, fathom or branch.
      const std::shared_ptr<Node> node = std::get<2>(*m_queue.begin());
      remove(m_queue.begin());
      if(gap_closed(node->energy))
      {
        m_fathomed_bound = (std::min)(m_fathomed_bound, node->energy);
        continue;
      }
      branch(*node);
    }
    m_result.is_complete = !is_stopped;
    m_result.lower_bound = (std::min)({ lower_bound(), m_fathomed_bound, m_result.energy });
    return m_result;
  }

private:
  // Ascending: the first is taken next. The number keeps the order of nodes that are otherwise equal.
  typedef std::tuple<double, long, std::shared_ptr<Node> > Entry;

  static constexpr double integer_tolerance = 1e-6;

  static Eigen::MatrixXd inverse_transposed_factor(const Eigen::MatrixXd& S)
  {
    const Eigen::LLT<Eigen::MatrixXd> cholesky(S);
    const Eigen::MatrixXd L = cholesky.matrixL();
    const Eigen::MatrixXd inverse = L.triangularView<Eigen::Lower>().solve(
      Eigen::MatrixXd::Identity(S.rows(), S.cols()));
    return inverse.transpose();
  }

  // Moving variable i alone by d costs 1/2 d^2 / (S^-1)_ii.
  static Eigen::VectorXd initial_costs(const Eigen::MatrixXd& J)
  {
    Eigen::VectorXd costs(J.rows());
    for(int i = 0; i < J.rows(); ++i)
      costs[i] = 0.5 / J.row(i).squaredNorm();
    return costs;
  }

  bool gap_closed(double bound) const
  {
    const double epsilon = 1e-10;
    return m_result.is_found &&
           m_result.energy - bound <= m_options.relative_gap_tolerance * (std::fabs(m_result.energy) + epsilon)
                                      + 1e-12 * (1. + std::fabs(m_constant));
  }

  double lower_bound() const
  {
    return m_bounds.empty() ? std::numeric_limits<double>::infinity() : *m_bounds.begin();
  }

  // Solves the relaxation of a subproblem.
  bool relax(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, Eigen::VectorXd& y, double& energy)
  {
    std::vector<Dual_active_set::Constraint> constraints;
    if(!make_constraints(m_problem, lower, upper, constraints))
      return false;
    double cost;
    const bool is_feasible = m_quadratic.solve(constraints, y, cost);
    energy = m_constant + cost;
    return is_feasible;
  }

  // Solves a subproblem and queues it, unless it is infeasible, worse than the incumbent, or solved.
  // Returns its bound.
  double add(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, int depth)
  {
    ++m_result.nodes;
    std::shared_ptr<Node> node = std::make_shared<Node>();
    if(!relax(lower, upper, node->y, node->energy))
      return std::numeric_limits<double>::infinity();
    if(gap_closed(node->energy))
    {
      m_fathomed_bound = (std::min)(m_fathomed_bound, node->energy);
      return node->energy;
    }
    if(branching_variable(node->y, m_problem.is_integer, integer_tolerance, m_options.branching_rule,
                          m_pseudo_costs) < 0)
    {
      fathom(*node);
      return node->energy;
    }
    node->lower = lower;
    node->upper = upper;
    node->depth = depth;
    node->estimate = node->energy;
    for(int i = 0; i < m_problem.size(); ++i)
      if(m_problem.is_integer[i])
      {
        const double below = node->y[i] - std::floor(node->y[i]);
        node->estimate +=
            (std::min)(below * m_pseudo_costs.estimate(i, 0), (1. - below) * m_pseudo_costs.estimate(i, 1));
      }
    double key = node->energy;
    if(m_options.subproblem_selection == Subproblem_selection::DEPTH_FIRST)
      key = -depth;
    else if(m_options.subproblem_selection == Subproblem_selection::BEST_ESTIMATE)
      key = node->estimate;
    m_bounds.insert(node->energy);
    m_queue.insert(Entry(key, -(++m_number), node)); // the youngest of equals first
    return node->energy;
  }

  void remove(std::set<Entry>::iterator it)
  {
    m_bounds.erase(m_bounds.find(std::get<2>(*it)->energy));
    m_queue.erase(it);
  }

  // All integers are integers up to round-off: makes them so and solves for the rest once more.
  void fathom(const Node& node)
  {
    Eigen::VectorXd lower = m_problem.lower, upper = m_problem.upper, y;
    for(int i = 0; i < m_problem.size(); ++i)
      if(m_problem.is_integer[i])
        lower[i] = upper[i] = std::floor(node.y[i] + 0.5);
    double energy;
    if(!relax(lower, upper, y, energy))
      return;
    for(int i = 0; i < m_problem.size(); ++i)
      if(m_problem.is_integer[i])
        y[i] = lower[i];
    m_result.accept(y, energy);
    m_fathomed_bound = (std::min)(m_fathomed_bound, node.energy);
  }

  void branch(const Node& node)
  {
    const int i = branching_variable(node.y, m_problem.is_integer, integer_tolerance, m_options.branching_rule,
                                     m_pseudo_costs);
    const double below = std::floor(node.y[i]), fraction = node.y[i] - below;
    // The nearer side last: of two new subproblems of one key the younger one is taken first.
    const int order[2] = { fraction < 0.5 ? 1 : 0, fraction < 0.5 ? 0 : 1 };
    for(int direction : order)
    {
      Eigen::VectorXd lower = node.lower, upper = node.upper;
      if(direction == 0)
        upper[i] = below;
      else
        lower[i] = below + 1.;
      const double bound = add(lower, upper, node.depth + 1);
      if(bound < std::numeric_limits<double>::infinity())
        m_pseudo_costs.learn(i, direction, direction == 0 ? fraction : 1. - fraction,
                             (std::max)(0., bound - node.energy));
    }
  }

  const Bounded_problem& m_problem;
  const Eigen::MatrixXd m_inverse_factor;
  const Eigen::VectorXd& m_target;
  double m_constant;
  const Solver_options& m_options;
  const std::function<bool()>& m_go_further;
  Dual_active_set m_quadratic;
  Pseudo_costs m_pseudo_costs;
  Search_result m_result;
  std::set<Entry> m_queue;
  std::multiset<double> m_bounds; // of the queued subproblems
  double m_fathomed_bound = std::numeric_limits<double>::infinity();
  long m_number = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BRANCH_AND_BOUND_H
