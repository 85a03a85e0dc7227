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

// Branch-and-cut (thesis 4.3): a branch-and-bound method that adds mixed-integer Gomory cuts at a node as long as
// they raise its bound significantly.
//
// Bounds and cuts come from linear programs in exact rationals. A quadratic objective enters them as tangent planes: at
// each node the quadratic relaxation is solved first, and the plane that touches the objective at its minimum lifts
// the linear program to the same bound, from where cuts lift it further (Quesada and Grossmann 1992).
class Branch_and_cut
{
  typedef CGAL::Exact_rational Rational;

  struct Node
  {
    Exact_dual_simplex program;
    Eigen::VectorXd lower, upper;
    double bound;
    int depth;
    Eigen::VectorXd y;
  };

public:
  // `cut_rounds` is the number of rounds of cuts at a node; 0 is branch-and-bound.
  Branch_and_cut(const Linear_master& master, const Solver_options& options, int cut_rounds,
                 const std::function<bool()>& go_further)
    : m_master(master)
    , m_options(options)
    , m_cut_rounds(cut_rounds)
    , m_go_further(go_further)
    , m_pseudo_costs(Eigen::VectorXd::Ones(master.problem().size()))
  {}

  // Minimizes the objective. `incumbent` is a feasible point to start with; it may be empty.
  Search_result run(const Eigen::VectorXd& incumbent, double incumbent_energy)
  {
    return search(m_master.make_program(), m_master.is_linear(), incumbent, incumbent_energy);
  }

  // Solves a mixed-integer linear program over the variables of the problem, and eta if there is one, as it stands.
  Search_result run(const Exact_dual_simplex& program)
  {
    return search(program, true, Eigen::VectorXd(), 0.);
  }

private:
  typedef std::tuple<double, long, std::shared_ptr<Node> > Entry;

  // Values of linear programs are exact but for their conversion, those of quadratic ones are not.
  double integer_tolerance() const { return m_is_linear ? 1e-9 : 1e-6; }

  Search_result search(const Exact_dual_simplex& program, bool is_linear, const Eigen::VectorXd& incumbent,
                       double incumbent_energy)
  {
    m_result = Search_result();
    m_queue.clear();
    m_bounds.clear();
    m_fathomed_bound = std::numeric_limits<double>::infinity();
    m_is_linear = is_linear;
    if(incumbent.size() > 0)
      m_result.accept(incumbent, incumbent_energy);
    evaluate(std::make_shared<Node>(Node{ program, m_master.problem().lower, m_master.problem().upper,
                                          -std::numeric_limits<double>::infinity(), 0, Eigen::VectorXd() }));
    bool is_stopped = false;
    while(!m_queue.empty() && !gap_closed(*m_bounds.begin()))
    {
      if(m_result.nodes >= m_options.maximum_number_of_nodes || !m_go_further())
      {
        is_stopped = true;
        break;
      }
      const std::shared_ptr<Node> node = std::get<2>(*m_queue.begin());
      m_bounds.erase(m_bounds.find(node->bound));
      m_queue.erase(m_queue.begin());
      if(gap_closed(node->bound))
        m_fathomed_bound = (std::min)(m_fathomed_bound, node->bound);
      else
        branch(*node);
    }
    m_result.is_complete = !is_stopped;
    const double open = m_bounds.empty() ? std::numeric_limits<double>::infinity() : *m_bounds.begin();
    m_result.lower_bound = (std::min)({ open, m_fathomed_bound, m_result.energy });
    m_result.is_unbounded = m_result.is_found && m_master.is_at_artificial_bound(m_result.y);
    return m_result;
  }

  bool gap_closed(double bound) const
  {
    const double epsilon = 1e-10, round_off = 1e-9;
    return m_result.is_found &&
           m_result.energy - bound <= (std::max)(m_options.relative_gap_tolerance, round_off)
                                      * (std::fabs(m_result.energy) + epsilon);
  }

  int variable_of(const Eigen::VectorXd& y) const
  {
    return branching_variable(y, m_master.problem().is_integer, integer_tolerance(), m_options.branching_rule,
                              m_pseudo_costs);
  }

  // Whether nothing better is left in a node with a bound.
  bool is_pruned(double bound)
  {
    if(!gap_closed(bound))
      return false;
    m_fathomed_bound = (std::min)(m_fathomed_bound, bound);
    return true;
  }

  // An integral point with the energy of its subproblem.
  void fathom(const Eigen::VectorXd& y, double bound)
  {
    Eigen::VectorXd polished = y;
    double energy = bound;
    if(m_is_linear || m_master.polish(y, polished, energy))
      m_result.accept(polished, energy);
    m_fathomed_bound = (std::min)(m_fathomed_bound, bound);
  }

  bool solve_program(Node& node) const
  {
    if(!node.program.solve())
      return false;
    const int n = m_master.problem().size();
    node.y.resize(n);
    for(int i = 0; i < n; ++i)
      node.y[i] = CGAL::to_double(node.program.value(i));
    const double value = m_master.is_linear() ? m_master.energy(node.y) : CGAL::to_double(node.program.objective());
    node.bound = (std::max)(node.bound, value);
    return true;
  }

  // Finds the bound of a node, raises it by cuts, and queues the node unless it is done with. Returns its bound.
  double evaluate(const std::shared_ptr<Node>& node)
  {
    const double significant = 0.02; // improvement, relative to the gap, that is worth another round of cuts
    const double infinity = std::numeric_limits<double>::infinity();
    ++m_result.nodes;
    Eigen::VectorXd y;
    if(!m_is_linear)
    {
      double energy;
      if(!m_master.relax(node->lower, node->upper, y, energy))
        return infinity;
      node->bound = (std::max)(node->bound, energy);
      if(is_pruned(node->bound))
        return node->bound;
      if(variable_of(y) < 0)
      {
        fathom(y, energy);
        return node->bound;
      }
      if(m_cut_rounds > 0)
      {
        std::vector<Rational> a;
        Rational b;
        m_master.tangent(y, a, b);
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
        if(variable_of(node->y) < 0)
        {
          if(m_is_linear)
          {
            fathom(node->y, node->bound);
            return node->bound;
          }
          break;
        }
        const double scale = m_result.is_found ? m_result.energy - node->bound : std::fabs(node->bound) + 1.;
        if(round >= m_cut_rounds || (round > 0 && node->bound < previous + significant * scale) || !m_go_further())
          break;
        node->program.drop_loose_cuts();
        m_result.cuts += node->program.add_all_cuts();
      }
    if(!m_is_linear)
      node->y = y; // it lies inside, where the choice of a variable means more than at a corner
    enqueue(node);
    return node->bound;
  }

  void enqueue(const std::shared_ptr<Node>& node)
  {
    double key = node->bound;
    if(m_options.subproblem_selection == Subproblem_selection::DEPTH_FIRST)
      key = -node->depth;
    else if(m_options.subproblem_selection == Subproblem_selection::BEST_ESTIMATE)
      for(int i = 0; i < node->y.size(); ++i)
        if(m_master.problem().is_integer[i])
        {
          const double below = node->y[i] - std::floor(node->y[i]);
          key += (std::min)(below * m_pseudo_costs.estimate(i, 0), (1. - below) * m_pseudo_costs.estimate(i, 1));
        }
    m_bounds.insert(node->bound);
    m_queue.insert(Entry(key, -(++m_number), node)); // the youngest of equals first
  }

  void branch(const Node& node)
  {
    const int i = variable_of(node.y);
    const double below = std::floor(node.y[i]), fraction = node.y[i] - below;
    const int order[2] = { fraction < 0.5 ? 1 : 0, fraction < 0.5 ? 0 : 1 }; // the nearer side last
    for(int direction : order)
    {
      std::shared_ptr<Node> child = std::make_shared<Node>(node);
      child->depth = node.depth + 1;
      (direction == 0 ? child->upper : child->lower)[i] = direction == 0 ? below : below + 1.;
      child->program.add_bound(i, Rational(direction == 0 ? below : below + 1.), direction == 0);
      const double bound = evaluate(child);
      if(bound < std::numeric_limits<double>::infinity())
        m_pseudo_costs.learn(i, direction, direction == 0 ? fraction : 1. - fraction,
                             (std::max)(0., bound - node.bound));
    }
  }

  const Linear_master& m_master;
  const Solver_options& m_options;
  int m_cut_rounds;
  const std::function<bool()>& m_go_further;
  Pseudo_costs m_pseudo_costs;
  bool m_is_linear = true; // subproblems are linear: of a linear objective, or of tangent planes alone
  Search_result m_result;
  std::set<Entry> m_queue;
  std::multiset<double> m_bounds;
  double m_fathomed_bound = std::numeric_limits<double>::infinity();
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
  Eigen::VectorXd y;
  double energy;
  if(!master.relax(master.problem().lower, master.problem().upper, y, energy))
  {
    result.is_complete = true;
    return result;
  }
  result.lower_bound = energy;
  add_tangent(y);
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
    if(!linear.is_found)
    {
      result.is_complete = linear.is_complete;
      return result;
    }
    if(linear.is_complete)
      result.lower_bound = (std::max)(result.lower_bound, linear.lower_bound);
    const bool is_feasible = master.polish(linear.y, y, energy);
    if(is_feasible && energy < result.energy)
    {
      result.is_found = true;
      result.y = y;
      result.energy = energy;
    }
    if(!linear.is_complete || !go_further())
      return result;
    if(result.energy - result.lower_bound
         <= (std::max)(options.relative_gap_tolerance * std::fabs(result.energy),
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

// The cutting-plane method (thesis 4.2) for linear objectives. With integers only, Gomory's fractional cuts from the
// first row that has no integer value end after finitely many steps; with real variables too, mixed-integer cuts may not.
inline Search_result cutting_planes(const Linear_master& master, const Solver_options& options,
                                    const std::function<bool()>& go_further)
{
  Search_result result;
  if(master.problem().is_infeasible)
  {
    result.is_complete = true;
    return result;
  }
  Exact_dual_simplex program = master.make_program();
  const bool has_integer_objective = master.has_integer_objective();
  for(;;)
  {
    ++result.nodes;
    if(!program.solve())
    {
      result.is_complete = true;
      return result;
    }
    Eigen::VectorXd y(master.problem().size());
    for(int i = 0; i < y.size(); ++i)
      y[i] = CGAL::to_double(program.value(i));
    result.lower_bound = master.energy(y);
    program.drop_loose_cuts();
    if(!program.add_first_cut(has_integer_objective))
    {
      result.is_found = result.is_complete = true;
      result.y = y;
      result.energy = result.lower_bound;
      result.is_unbounded = master.is_at_artificial_bound(y);
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
