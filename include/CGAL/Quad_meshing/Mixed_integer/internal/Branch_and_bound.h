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
#include <CGAL/Quad_meshing/Mixed_integer/internal/Convex_quadratic.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dual_active_set.h>
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
  bool is_complete = false;  // the tree was searched to its end, up to the gap asked for
  bool rests_on_box = false; // on bounds that stand in for missing ones: without them there may be something better
  bool is_uncertain = false; // a part of the search was given up for want of accuracy
  Eigen::VectorXd y;
  double energy = std::numeric_limits<double>::infinity();
  double lower_bound = -std::numeric_limits<double>::infinity();
  // like the lower bound, even where it rests on the box
  double bound_in_box = -std::numeric_limits<double>::infinity();
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

// The choice of a branching variable by the change of the bound that branchings on it brought so far ([Bom12, 4.1],
// pseudo-costs), per unit of change of the variable, downwards and upwards.
class Pseudo_costs
{
public:
  // `initial` is a guess for each variable.
  explicit Pseudo_costs(const Eigen::VectorXd& initial)
    : m_sum{ initial, initial }, m_count{ Eigen::VectorXd::Ones(initial.size()), Eigen::VectorXd::Ones(initial.size()) }
  {
  }

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

// Returns the integer variable to branch on, -1 if all are integers up to `tolerance`. The root has the depth 1.
inline int branching_variable(const Eigen::VectorXd& y, const std::vector<char>& is_integer, double tolerance,
                              Branching_rule rule, const Pseudo_costs& pseudo_costs, int depth)
{
  const int critical_depth = 8; // down to which the most fractional variable is taken first; some steps [Bom12, 4.1]
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
      case Branching_rule::MAXIMUM_THEN_MINIMUM_INFEASIBILITY:
        score = depth <= critical_depth ? infeasibility : -infeasibility;
        break;
      case Branching_rule::MINIMUM_PSEUDO_COSTS:
      case Branching_rule::MAXIMUM_PSEUDO_COSTS:
        score = (std::min)(below * pseudo_costs.estimate(i, 0), above * pseudo_costs.estimate(i, 1));
        if(rule == Branching_rule::MINIMUM_PSEUDO_COSTS)
          score = -score;
        break;
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

// Branch-and-bound [Bom12, 4.1] for a convex quadratic energy with constraints, by the dual active-set method, whose
// cost is the bound of a subproblem.
class Branch_and_bound
{
  struct Node
  {
    Eigen::VectorXd lower, upper, y;
    double energy = -std::numeric_limits<double>::infinity(); // a lower bound
    double estimate = 0.;
    int depth = 0;
    // The subproblems of the node: the variable is at most this number, or more than it.
    int variable = -1;
    double split = 0.;
  };

public:
  Branch_and_bound(const Bounded_problem& problem, Convex_quadratic& quadratic, const Solver_options& options,
                   const std::function<bool()>& go_further)
    : m_problem(problem)
    , m_quadratic(quadratic)
    , m_options(options)
    , m_go_further(go_further)
    , m_pseudo_costs(quadratic.step_costs())
  {
  }

  // The least energy without integer conditions: infinite if the constraints contradict each other, minus infinity if
  // it is not known.
  double relaxed_energy()
  {
    const Convex_quadratic::Minimum minimum = relax(m_problem.lower, m_problem.upper);
    if(!minimum.is_feasible)
      return std::numeric_limits<double>::infinity();
    return minimum.is_exact ? minimum.energy : -std::numeric_limits<double>::infinity();
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
    add(m_problem.lower, m_problem.upper, Node());
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
    m_result.is_complete = !is_stopped && !m_is_uncertain;
    m_result.lower_bound = m_is_uncertain ? -std::numeric_limits<double>::infinity()
                                          : (std::min)({ lower_bound(), m_fathomed_bound, m_result.energy });
    return m_result;
  }

private:
  // Ascending: the first is taken next. The number keeps the order of nodes that are otherwise equal.
  typedef std::tuple<double, long, std::shared_ptr<Node>> Entry;

  static constexpr double integer_tolerance = 1e-6;

  bool gap_closed(double bound) const
  {
    const double epsilon = 1e-10, round_off = 1e-12;
    return m_result.is_found &&
           m_result.energy - bound <= m_options.relative_gap_tolerance * (std::fabs(m_result.energy) + epsilon) +
                                        round_off * m_quadratic.magnitude();
  }

  double lower_bound() const { return m_bounds.empty() ? std::numeric_limits<double>::infinity() : *m_bounds.begin(); }

  // Solves the relaxation of a subproblem.
  Convex_quadratic::Minimum relax(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper)
  {
    std::vector<Dual_active_set::Constraint> constraints;
    if(!make_constraints(m_problem, lower, upper, constraints))
      return Convex_quadratic::Minimum();
    return m_quadratic.minimize(constraints);
  }

  // Solves a subproblem and queues it, unless it is infeasible, worse than the incumbent, or solved. Returns its bound.
  double add(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, const Node& parent)
  {
    ++m_result.nodes;
    const Convex_quadratic::Minimum minimum = relax(lower, upper);
    if(!minimum.is_feasible)
      return std::numeric_limits<double>::infinity();
    const std::shared_ptr<Node> node = std::make_shared<Node>();
    node->y = minimum.y;
    node->energy = minimum.is_exact ? (std::max)(parent.energy, minimum.energy) : parent.energy;
    node->lower = lower;
    node->upper = upper;
    node->depth = parent.depth + 1;
    node->variable = branching_variable(node->y, m_problem.is_integer, integer_tolerance, m_options.branching_rule,
                                        m_pseudo_costs, node->depth);
    if(node->variable >= 0)
    {
      node->split = std::floor(node->y[node->variable]);
      try_rounding(node->y);
    }
    else if(!fathom(*node))
      return node->energy;
    if(gap_closed(node->energy))
    {
      m_fathomed_bound = (std::min)(m_fathomed_bound, node->energy);
      return node->energy;
    }
    enqueue(node);
    return node->energy;
  }

  void enqueue(const std::shared_ptr<Node>& node)
  {
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
      key = -node->depth;
    else if(m_options.subproblem_selection == Subproblem_selection::BEST_ESTIMATE)
      key = node->estimate;
    m_bounds.insert(node->energy);
    m_queue.insert(Entry(key, -(++m_number), node)); // the youngest of equals first
  }

  void remove(std::set<Entry>::iterator it)
  {
    m_bounds.erase(m_bounds.find(std::get<2>(*it)->energy));
    m_queue.erase(it);
  }

  // A node may be close to a feasible point: without one, a search that is stopped has nothing to show.
  void try_rounding(Eigen::VectorXd y)
  {
    const long interval = 64; // once there is a point, so few of the nodes are rounded
    if(m_result.is_found && static_cast<long>(m_result.nodes) % interval != 1)
      return;
    for(int i = 0; i < m_problem.size(); ++i)
      if(m_problem.is_integer[i])
        y[i] = std::floor(y[i] + 0.5);
    const Convex_quadratic::Minimum minimum = complete_reals(m_problem, m_quadratic, y);
    if(minimum.is_feasible && m_problem.is_met_by(minimum.y))
      m_result.accept(minimum.y, m_quadratic.energy(minimum.y));
  }

  // All integers of a node are integers up to round-off: makes them so and solves for the rest once more. Returns
  // whether the node may hold something better still; it then knows how to be divided.
  bool fathom(Node& node)
  {
    Eigen::VectorXd rounded = node.y;
    double farthest = -1.;
    for(int i = 0; i < m_problem.size(); ++i)
      if(m_problem.is_integer[i])
      {
        rounded[i] = std::floor(node.y[i] + 0.5);
        if(node.lower[i] < node.upper[i] && std::fabs(node.y[i] - rounded[i]) > farthest)
        {
          farthest = std::fabs(node.y[i] - rounded[i]);
          node.variable = i;
          node.split = rounded[i] < node.upper[i] ? rounded[i] : rounded[i] - 1.;
        }
      }
    const Convex_quadratic::Minimum minimum = complete_reals(m_problem, m_quadratic, rounded);
    if(minimum.is_feasible)
    {
      if(m_problem.is_met_by(minimum.y))
        m_result.accept(minimum.y, m_quadratic.energy(minimum.y));
      else if(node.variable < 0 && m_problem.has_real_rows())
        m_is_uncertain = true; // what cannot be computed accurately is not said to be infeasible
      if(node.variable < 0 && minimum.is_exact)
        node.energy = (std::max)(node.energy, minimum.energy);
    }
    if(node.variable < 0 && minimum.is_feasible && !minimum.is_exact)
      m_is_uncertain = true;
    return node.variable >= 0;
  }

  void branch(const Node& node)
  {
    const int i = node.variable;
    const double fraction = (std::min)(1., (std::max)(0., node.y[i] - node.split));
    // The nearer side last: of two new subproblems of one key the younger one is taken first.
    const int order[2] = { fraction < 0.5 ? 1 : 0, fraction < 0.5 ? 0 : 1 };
    for(int direction : order)
    {
      Eigen::VectorXd lower = node.lower, upper = node.upper;
      if(direction == 0)
        upper[i] = node.split;
      else
        lower[i] = node.split + 1.;
      const double bound = add(lower, upper, node);
      if(bound < std::numeric_limits<double>::infinity() && node.energy > -std::numeric_limits<double>::infinity())
        m_pseudo_costs.learn(i, direction, direction == 0 ? fraction : 1. - fraction,
                             (std::max)(0., bound - node.energy));
    }
  }

  const Bounded_problem& m_problem;
  Convex_quadratic& m_quadratic;
  const Solver_options& m_options;
  const std::function<bool()>& m_go_further;
  Pseudo_costs m_pseudo_costs;
  Search_result m_result;
  std::set<Entry> m_queue;
  std::multiset<double> m_bounds; // of the queued subproblems
  double m_fathomed_bound = std::numeric_limits<double>::infinity();
  bool m_is_uncertain = false; // a subproblem was given up for want of accuracy
  long m_number = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BRANCH_AND_BOUND_H
