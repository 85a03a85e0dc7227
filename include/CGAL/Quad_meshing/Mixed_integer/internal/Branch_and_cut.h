// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BRANCH_AND_CUT_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BRANCH_AND_CUT_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Branch_and_bound.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Convex_quadratic.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Elimination_number.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Exact_dual_simplex.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Linear_master.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>

#include <Eigen/Core>

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

// Branch-and-cut [Bom12, 4.3]: a branch-and-bound method that adds mixed-integer Gomory cuts at a node as long as
// they raise its bound significantly.
//
// Bounds and cuts come from linear programs in exact rationals. A quadratic objective enters them as tangent planes: at
// each node the quadratic relaxation is solved first, and the plane that touches the objective at its minimum lifts
// the linear program to the same bound, from where cuts lift it further (Quesada and Grossmann 1992).
class Branch_and_cut
{
  typedef CGAL::Exact_rational Rational;
  typedef Elimination_number<Rational> Number;

  struct Node
  {
    Exact_dual_simplex program;
    Eigen::VectorXd lower, upper;
    double bound = -std::numeric_limits<double>::infinity();
    int depth = 0;
    Eigen::VectorXd fractions; // of the integer variables, 0 for integers
    std::vector<Rational> floors;
    // The subproblems of the node: the variable is at most this number, or more than it.
    int variable = -1;
    Rational split;

    explicit Node(const Exact_dual_simplex& p) : program(p) {}
  };

public:
  // `cut_rounds` is the number of rounds of cuts at a node; 0 is branch-and-bound.
  Branch_and_cut(const Linear_master& master, const Solver_options& options, int cut_rounds,
                 const std::function<bool()>& go_further)
    : m_master(master)
    , m_problem(master.problem())
    , m_options(options)
    , m_cut_rounds(cut_rounds)
    , m_go_further(go_further)
    , m_pseudo_costs(Eigen::VectorXd::Ones(master.problem().size()))
  {
  }

  // Minimizes the objective. `incumbent` is a feasible point to start with; it may be empty.
  Search_result run(const Eigen::VectorXd& incumbent, double incumbent_energy)
  {
    return search(m_master.make_program(), m_master.is_linear(), incumbent, incumbent_energy);
  }

  // Solves a mixed-integer linear program over the variables of the problem, and eta if there is one, as it stands.
  Search_result run(const Exact_dual_simplex& program) { return search(program, true, Eigen::VectorXd(), 0.); }

private:
  typedef std::tuple<double, long, std::shared_ptr<Node>> Entry;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  // Of coordinates that come from quadratic programs; those of linear ones are exact.
  static constexpr double integer_tolerance = 1e-6;
  // The fraction of a number that is not an integer is at least this, and at most one minus this.
  static constexpr double least_fraction = 1e-9;

  Search_result search(const Exact_dual_simplex& program, bool is_linear, const Eigen::VectorXd& incumbent,
                       double incumbent_energy)
  {
    m_result = Search_result();
    m_queue.clear();
    m_bounds.clear();
    m_fathomed_bound = infinity;
    m_is_linear = is_linear;
    m_is_stopped = false;
    if(incumbent.size() > 0)
      m_result.accept(incumbent, incumbent_energy);
    const std::shared_ptr<Node> root = std::make_shared<Node>(program);
    root->lower = m_problem.lower;
    root->upper = m_problem.upper;
    evaluate(root);
    while(!m_queue.empty() && !gap_closed(*m_bounds.begin()) && !m_is_stopped)
    {
      if(m_result.nodes >= m_options.maximum_number_of_nodes || !m_go_further())
      {
        m_is_stopped = true;
        break;
      }
      const std::shared_ptr<Node> node = std::get<2>(*m_queue.begin());
      m_bounds.erase(m_bounds.find(node->bound));
      m_queue.erase(m_queue.begin());
      if(!is_pruned(node->bound))
        branch(*node);
    }
    m_result.is_complete = !m_is_stopped && !m_result.is_uncertain;
    const double open = m_bounds.empty() ? infinity : *m_bounds.begin();
    m_result.lower_bound =
      m_is_stopped && m_bounds.empty() ? -infinity : (std::min)({ open, m_fathomed_bound, m_result.energy });
    m_result.bound_in_box = m_result.lower_bound;
    if(m_result.rests_on_box || m_result.is_uncertain)
      m_result.lower_bound = -infinity;
    return m_result;
  }

  bool gap_closed(double bound) const
  {
    const double epsilon = 1e-10, round_off = 1e-9, absolute_round_off = 1e-12;
    return m_result.is_found && m_result.energy - bound <=
                                  (std::max)(m_options.relative_gap_tolerance, m_master.is_linear() ? 0. : round_off) *
                                      (std::fabs(m_result.energy) + epsilon) +
                                    (m_master.is_linear() ? 0. : absolute_round_off * m_master.magnitude());
  }

  int variable_of(const Eigen::VectorXd& y, double tolerance, int depth) const
  {
    return branching_variable(y, m_problem.is_integer, tolerance, m_options.branching_rule, m_pseudo_costs, depth);
  }

  // Whether nothing better is left in a node with a bound.
  bool is_pruned(double bound)
  {
    if(!gap_closed(bound))
      return false;
    m_fathomed_bound = (std::min)(m_fathomed_bound, bound);
    return true;
  }

  // A point whose integer variables are integers, in a linear program.
  void fathom_linear(const Node& node, const Eigen::VectorXd& y)
  {
    m_fathomed_bound = (std::min)(m_fathomed_bound, node.bound);
    if(m_master.is_linear() && !m_problem.is_met_by(y))
      m_result.is_uncertain = true; // numbers beyond those that a double holds
    else
      m_result.accept(y, m_master.is_linear() ? m_master.energy(y) : node.bound);
  }

  // A point whose integer variables are integers up to round-off, in a quadratic program. Returns whether the node
  // may hold something better still; it then knows how to be divided.
  bool fathom_quadratic(Node& node, const Eigen::VectorXd& y)
  {
    double farthest = -1.;
    for(int i = 0; i < m_problem.size(); ++i)
      if(m_problem.is_integer[i] && node.lower[i] < node.upper[i])
      {
        const double rounded = std::floor(y[i] + 0.5);
        if(std::fabs(y[i] - rounded) > farthest)
        {
          farthest = std::fabs(y[i] - rounded);
          node.variable = i;
          node.split = Rational(rounded < node.upper[i] ? rounded : rounded - 1.);
        }
      }
    Eigen::VectorXd polished;
    double energy;
    if(m_master.polish(y, polished, energy))
    {
      m_result.accept(polished, energy);
      if(node.variable < 0)
        node.bound = (std::max)(node.bound, energy);
    }
    else if(node.variable < 0 && m_problem.has_real_rows())
      m_result.is_uncertain = true;
    if(node.variable < 0)
      m_fathomed_bound = (std::min)(m_fathomed_bound, node.bound);
    return node.variable >= 0;
  }

  // Returns false if there is no point, or if the search has to end.
  bool solve_program(Node& node)
  {
    const bool is_solved = node.program.solve(m_go_further);
    if(!is_solved && !m_go_further())
    {
      m_is_stopped = true;
      return false;
    }
    m_result.rests_on_box = m_result.rests_on_box || node.program.rests_on_artificial_bounds();
    if(!is_solved)
      return false;
    const int n = m_problem.size();
    node.fractions = Eigen::VectorXd::Zero(n);
    node.floors.assign(n, Rational(0));
    for(int i = 0; i < n; ++i)
      if(m_problem.is_integer[i])
      {
        const Rational value = node.program.value(i);
        node.floors[i] = Rational(Number::floor(value));
        if(node.floors[i] != value)
          node.fractions[i] =
            (std::min)(1. - least_fraction, (std::max)(least_fraction, CGAL::to_double(value - node.floors[i])));
      }
    double value = CGAL::to_double(node.program.objective());
    if(m_master.is_linear())
      value += m_master.energy(Eigen::VectorXd::Zero(n));
    node.bound = (std::max)(node.bound, value);
    return true;
  }

  Eigen::VectorXd point_of(const Node& node) const
  {
    Eigen::VectorXd y(m_problem.size());
    for(int i = 0; i < y.size(); ++i)
      y[i] = CGAL::to_double(node.program.value(i));
    return y;
  }

  // Finds the bound of a node, raises it by cuts, and queues the node unless it is done with. Returns its bound.
  double evaluate(const std::shared_ptr<Node>& node)
  {
    const double significant = 0.02; // improvement, relative to the gap, that is worth another round of cuts
    ++m_result.nodes;
    node->variable = -1;
    Convex_quadratic::Minimum minimum;
    if(!m_is_linear)
    {
      minimum = m_master.relax(node->lower, node->upper);
      if(!minimum.is_feasible)
        return infinity;
      if(minimum.is_exact)
        node->bound = (std::max)(node->bound, minimum.energy);
      if(is_pruned(node->bound))
        return node->bound;
      node->variable = variable_of(minimum.y, integer_tolerance, node->depth);
      if(node->variable >= 0)
      {
        node->split = Rational(std::floor(minimum.y[node->variable]));
        // Without a feasible point a search that is stopped has nothing to show.
        Eigen::VectorXd rounded;
        double energy;
        if(!m_result.is_found && m_master.polish(minimum.y, rounded, energy))
          m_result.accept(rounded, energy);
      }
      else if(!fathom_quadratic(*node, minimum.y) || is_pruned(node->bound))
        return node->bound;
      if(m_cut_rounds > 0)
      {
        std::vector<Rational> a;
        Rational b;
        m_master.tangent(minimum.y, a, b);
        node->program.add_constraint(a, b, false);
      }
    }
    if(m_is_linear || m_cut_rounds > 0)
      for(int round = 0;; ++round)
      {
        const double previous = node->bound;
        if(!solve_program(*node))
          return infinity;
        if(is_pruned(node->bound))
          return node->bound;
        const int fractional = variable_of(node->fractions, 0.5 * least_fraction, node->depth);
        if(m_is_linear)
          node->variable = fractional;
        if(fractional < 0)
        {
          if(!m_is_linear)
            break;
          fathom_linear(*node, point_of(*node));
          return node->bound;
        }
        if(m_is_linear)
          node->split = node->floors[fractional];
        const double scale = m_result.is_found ? m_result.energy - node->bound : std::fabs(node->bound) + 1.;
        if(round >= m_cut_rounds || (round > 0 && node->bound < previous + significant * scale) || !m_go_further())
          break;
        node->program.drop_loose_cuts();
        m_result.cuts += node->program.add_all_cuts();
      }
    if(!m_is_linear)
    {
      // The quadratic minimum lies inside, where the choice of a variable means more than at a corner.
      node->fractions = minimum.y;
      for(int i = 0; i < m_problem.size(); ++i)
        node->fractions[i] -= std::floor(node->fractions[i]);
    }
    enqueue(node);
    return node->bound;
  }

  void enqueue(const std::shared_ptr<Node>& node)
  {
    double key = node->bound;
    if(m_options.subproblem_selection == Subproblem_selection::DEPTH_FIRST)
      key = -node->depth;
    else if(m_options.subproblem_selection == Subproblem_selection::BEST_ESTIMATE)
      for(int i = 0; i < m_problem.size(); ++i)
        if(m_problem.is_integer[i])
        {
          const double below = node->fractions[i];
          key += (std::min)(below * m_pseudo_costs.estimate(i, 0), (1. - below) * m_pseudo_costs.estimate(i, 1));
        }
    m_bounds.insert(node->bound);
    m_queue.insert(Entry(key, -(++m_number), node)); // the youngest of equals first
  }

  void branch(const Node& node)
  {
    const int i = node.variable;
    const double fraction = node.fractions[i];
    const int order[2] = { fraction < 0.5 ? 1 : 0, fraction < 0.5 ? 0 : 1 }; // the nearer side last
    for(int direction : order)
    {
      std::shared_ptr<Node> child = std::make_shared<Node>(node);
      const Rational limit = direction == 0 ? node.split : Rational(node.split + Rational(1));
      child->depth = node.depth + 1;
      (direction == 0 ? child->upper : child->lower)[i] = CGAL::to_double(limit);
      child->program.add_bound(i, limit, direction == 0);
      const double bound = evaluate(child);
      if(bound < infinity && node.bound > -infinity)
        m_pseudo_costs.learn(i, direction, direction == 0 ? fraction : 1. - fraction,
                             (std::max)(0., bound - node.bound));
    }
  }

  const Linear_master& m_master;
  const Bounded_problem& m_problem;
  const Solver_options& m_options;
  int m_cut_rounds;
  const std::function<bool()>& m_go_further;
  Pseudo_costs m_pseudo_costs;
  bool m_is_linear = true; // subproblems are linear: of a linear objective, or of tangent planes alone
  bool m_is_stopped = false;
  Search_result m_result;
  std::set<Entry> m_queue;
  std::multiset<double> m_bounds;
  double m_fathomed_bound = infinity;
  long m_number = 0;
};

// Outer approximation (Duran and Grossmann 1986): the linear master problem over the tangent planes known so far
// gives integers and a lower bound; the best point with these integers gives an upper bound and a new plane.
inline Search_result outer_approximation(const Linear_master& master, const Solver_options& options,
                                         const Eigen::VectorXd& incumbent, double incumbent_energy,
                                         const std::function<bool()>& go_further)
{
  const double tolerance = 1e-7; // between the bounds, relative to one and the energy
  const int cut_rounds = 0, maximum_iterations = 1000;
  Branch_and_cut search(master, options, cut_rounds, go_further);
  if(master.is_linear())
    return search.run(incumbent, incumbent_energy);

  Exact_dual_simplex program = master.make_program();
  const auto add_tangent = [&](const Eigen::VectorXd& y)
  {
    std::vector<CGAL::Exact_rational> a;
    CGAL::Exact_rational b;
    master.tangent(y, a, b);
    program.add_constraint(a, b, false);
  };
  Search_result result;
  const Convex_quadratic::Minimum relaxed = master.relax(master.problem().lower, master.problem().upper);
  if(!relaxed.is_feasible)
  {
    result.is_complete = true;
    return result;
  }
  if(relaxed.is_exact)
    result.lower_bound = relaxed.energy;
  add_tangent(relaxed.y);
  if(incumbent.size() > 0)
  {
    result.is_found = true;
    result.y = incumbent;
    result.energy = incumbent_energy;
    add_tangent(incumbent);
  }
  for(int iteration = 0; iteration < maximum_iterations; ++iteration)
  {
    const Search_result linear = search.run(program);
    result.nodes += linear.nodes;
    result.cuts += linear.cuts;
    result.rests_on_box = linear.rests_on_box; // earlier bounds are not used
    result.is_uncertain = result.is_uncertain || linear.is_uncertain;
    if(!linear.is_found)
    {
      result.is_complete = linear.is_complete;
      return result;
    }
    if(linear.is_complete)
      result.lower_bound = (std::max)(result.lower_bound, linear.lower_bound);
    Eigen::VectorXd y;
    double energy;
    const bool is_feasible = master.polish(linear.y, y, energy);
    if(is_feasible && energy < result.energy)
    {
      result.is_found = true;
      result.y = y;
      result.energy = energy;
    }
    if(!linear.is_complete || !go_further())
      return result;
    if(result.is_found && result.energy - (std::max)(result.lower_bound, linear.bound_in_box) <=
                            (std::max)(options.relative_gap_tolerance * std::fabs(result.energy),
                                       tolerance * (1. + std::fabs(result.energy))))
    {
      result.is_complete = true;
      return result;
    }
    add_tangent(linear.y);
    if(is_feasible)
      add_tangent(y);
  }
  return result;
}

// The cutting-plane method [Bom12, 4.2] for linear objectives. With integers only, Gomory's fractional cuts from the
// first row that has no integer value end after finitely many steps; with real variables too, mixed-integer cuts may
// not.
inline Search_result cutting_planes(const Linear_master& master, const Solver_options& options,
                                    const std::function<bool()>& go_further)
{
  Search_result result;
  Exact_dual_simplex program = master.make_program();
  const bool has_integer_objective = master.has_integer_objective();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(master.problem().size());
  for(;;)
  {
    ++result.nodes;
    const bool is_solved = program.solve(go_further);
    if(!is_solved && !go_further())
      return result;
    // A cut rests on the box only if the solution does that it cuts off, or a later one.
    result.rests_on_box = program.rests_on_artificial_bounds();
    if(!is_solved)
    {
      result.is_complete = true;
      return result;
    }
    Eigen::VectorXd y(master.problem().size());
    for(int i = 0; i < y.size(); ++i)
      y[i] = CGAL::to_double(program.value(i));
    if(!result.rests_on_box)
      result.lower_bound = (std::max)(result.lower_bound, CGAL::to_double(program.objective()) + master.energy(zero));
    program.drop_loose_cuts();
    if(!program.add_first_cut(has_integer_objective))
    {
      result.is_uncertain = !master.problem().is_met_by(y);
      result.is_complete = !result.is_uncertain;
      if(result.is_complete)
        result.accept(y, master.energy(y));
      return result;
    }
    ++result.cuts;
    if(result.nodes >= options.maximum_number_of_nodes || !go_further())
      return result;
  }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BRANCH_AND_CUT_H
