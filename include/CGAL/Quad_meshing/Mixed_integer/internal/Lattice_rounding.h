// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_ROUNDING_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_ROUNDING_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Lattice_enumeration.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Lattice_reduction.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>

#include <CGAL/Quad_meshing/Mixed_integer/internal/Subtree_bounds.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

struct Lattice_result
{
  Eigen::VectorXd y;
  double cost = 0.;       // 1/2 |R (y - y*)|^2
  double cost_bound = 0.; // no integer point costs less
  bool is_optimal = false;
  double nodes = 0.;
};

// The closest-vector problem of a dense energy: min 1/2 (y - y*)' S (y - y*) over integer y.
//
// Reduces the lattice of R, S = R'R; takes the better of the nearest plane and a given start. If the whole tree
// promises to fit in the limit it is searched, which proves the optimum. Otherwise trees pruned less and less are
// searched for better points, and the rest of the nodes goes into a bound: a complete search that finds nothing
// within a radius proves that no point lies there. Large trees are searched with bounds for their subtrees.
class Lattice_rounding
{
public:
  Lattice_rounding(const Eigen::MatrixXd& R, const Eigen::VectorXd& target, double maximum_nodes,
                   const std::function<bool()>& go_further)
    : m_R(R), m_target(target), m_maximum_nodes(maximum_nodes), m_go_further(go_further), m_reduction(R)
  {
  }

  Lattice_result run(const Eigen::VectorXd& start, bool wants_bound)
  {
    const int block_size = 24, tours = 12;
    // The origin is moved next to the target: all numbers stay small.
    const int m = static_cast<int>(m_target.size());
    Eigen::VectorXd origin(m);
    for(int i = 0; i < m; ++i)
      origin[i] = nearest_integer(m_target[i]);
    const Eigen::VectorXd target = m_target - origin;

    m_reduction.run(block_size, tours, m_go_further);
    Lattice_enumeration enumeration(m_reduction.factor(), m_reduction.coordinates(target));

    Eigen::VectorXd best = enumeration.nearest_plane();
    m_radius = enumeration.squared_distance(best);
    const Eigen::VectorXd z = m_reduction.coordinates(start - origin).array().round();
    const double start_radius = enumeration.squared_distance(z);
    if(start_radius < m_radius)
    {
      best = z;
      m_radius = start_radius;
    }

    if(!wants_bound)
      search(enumeration, best, m_maximum_nodes);
    else
    {
      // A short search often finds the optimum, and shrinks what is to be prepared and proven.
      const double probe_fraction = 0.01, short_search = 2e6, short_fraction = 0.1;
      if(!is_within_reach(enumeration, short_search))
        search(enumeration, best, (std::min)(short_search, short_fraction * m_maximum_nodes));
      prepare_test(enumeration);
      prove(enumeration, best, probe_fraction * m_maximum_nodes);
      if(m_bound < m_radius && !is_within_reach(enumeration, m_maximum_nodes - nodes(enumeration)))
        search(enumeration, best, m_maximum_nodes - nodes(enumeration));
      prove(enumeration, best, m_maximum_nodes);
    }

    Lattice_result result;
    result.is_optimal = m_bound >= m_radius;
    result.y = origin + m_reduction.transformation() * best;
    const Eigen::VectorXd d = m_R * (result.y - m_target);
    result.cost = 0.5 * d.squaredNorm();
    // Sums of squares in the search carry round-off; it must not lift the bound above the truth.
    const double round_off = 1e-9;
    result.cost_bound = result.is_optimal ? result.cost : (std::min)(result.cost, 0.5 * m_bound * (1. - round_off));
    result.nodes = nodes(enumeration);
    return result;
  }

  // The basis that the search ran in.
  const Lattice_reduction& reduction() const { return m_reduction; }

private:
  // Visited in the tree, and as many as take the time of the preparation.
  double nodes(const Lattice_enumeration& enumeration) const { return enumeration.nodes() + m_test_nodes; }

  // Prepares bounds for subtrees, at as many levels as a part of the nodes pays for, if the tree is large.
  void prepare_test(Lattice_enumeration& enumeration)
  {
    const double large_tree = 2e6;            // nodes, about what the bounds of sixty integers take
    const double share = 0.3;                 // of all nodes
    const int smallest = 24, least_fixed = 8; // subtrees over fewer integers are searched before a test ends
    const int m = static_cast<int>(m_target.size());
    const double plain_nodes = enumeration.expected_nodes(m_radius);
    if(plain_nodes < large_tree)
      return;
    for(int spacing : { 2, 4, 8, 16 })
    {
      std::vector<int> sizes;
      double cost = 0.;
      for(int k = smallest; k <= m - least_fixed; k += spacing)
      {
        sizes.push_back(k);
        cost += Subtree_bounds::nodes_to_prepare(k);
      }
      if(sizes.empty() || cost > share * m_maximum_nodes)
        continue;
      m_test.reset(new Subtree_bounds(m_reduction.factor(), enumeration.center(), sizes, m_go_further));
      m_test_nodes = m_test->nodes();
      enumeration.set_test(m_test.get());
      // In lattices that are far from orthogonal the bounds may be too weak.
      if(enumeration.expected_nodes(m_radius) > plain_nodes)
        enumeration.set_test(nullptr);
      return;
    }
  }

  // Searches trees pruned less and less, as long as the next one could not as well be searched as a whole.
  void search(Lattice_enumeration& enumeration, Eigen::VectorXd& best, double maximum_nodes)
  {
    const double end = nodes(enumeration) + maximum_nodes;
    const double pruning_exponents[] = { 1., 0.7, 0.5, 0.35 };
    const double pruned_fraction = 0.12; // of all nodes, per pruned search
    for(double exponent : pruning_exponents)
    {
      if(m_correction * enumeration.expected_nodes(m_radius) <= pruned_fraction * maximum_nodes)
        break;
      enumeration.set_pruning(exponent);
      enumeration.run(m_radius, pruned_fraction * maximum_nodes, m_go_further);
      if(enumeration.found())
        best = enumeration.best();
    }
    const double left = end - nodes(enumeration);
    if(!is_within_reach(enumeration, left))
      return;
    enumeration.set_pruning(0.);
    if(enumeration.run(m_radius, left, m_go_further))
      m_bound = (std::numeric_limits<double>::max)();
    if(enumeration.found())
      best = enumeration.best();
  }

  // Whether a search of the whole tree promises to take no more than so many nodes.
  bool is_within_reach(const Lattice_enumeration& enumeration, double nodes) const
  {
    // The estimate may be too large by this factor before it is believed.
    const double estimate_slack = 1.25;
    return m_correction * enumeration.expected_nodes(m_radius) <= estimate_slack * nodes;
  }

  // Searches balls of growing radius as a whole, until so many nodes have been visited in all or the optimum is proven.
  // How much larger their trees are than the Gaussian heuristic says (much, if the basis is almost orthogonal) tells
  // how far the next radius may reach.
  void prove(Lattice_enumeration& enumeration, Eigen::VectorXd& best, double maximum_nodes)
  {
    const double growth = 10.;       // of the trees from one ball to the next
    const double least_growth = 1.5; // less of it is not worth a search
    const double share = 0.8;        // of the nodes left, in view of the error of estimates
    // With tests the heuristic errs to both sides, and more for small trees.
    const double least_correction = m_test ? 0.1 : 1.;
    while(m_bound < m_radius && m_go_further())
    {
      const double left = maximum_nodes - nodes(enumeration);
      const bool is_last = is_within_reach(enumeration, left);
      const double next =
        is_last ? m_radius : radius_of_tree(enumeration, (std::min)(m_tree, share * left / m_correction));
      const double expected = enumeration.expected_nodes(next);
      if(!is_last && !(expected > least_growth * enumeration.expected_nodes(m_bound)))
        return;
      double reach = next;
      const double before = enumeration.nodes(); // the preparation aside
      enumeration.set_pruning(0.);
      const bool is_complete = enumeration.run(reach, left, m_go_further);
      if(enumeration.found())
      {
        best = enumeration.best();
        m_radius = reach;
      }
      if(!is_complete)
        return;
      m_bound = reach;
      m_correction = (std::max)(least_correction, (enumeration.nodes() - before) / expected);
      m_tree = growth * expected;
    }
  }

  // The squared radius, at most that of the best point, whose tree is expected to have so many nodes.
  double radius_of_tree(const Lattice_enumeration& enumeration, double nodes) const
  {
    const int steps = 16;
    if(enumeration.expected_nodes(m_radius) <= nodes)
      return m_radius;
    double low = 0., high = m_radius;
    for(int i = 0; i < steps; ++i)
    {
      const double middle = 0.5 * (low + high);
      (enumeration.expected_nodes(middle) > nodes ? high : low) = middle;
    }
    return low;
  }

  const Eigen::MatrixXd& m_R;
  const Eigen::VectorXd& m_target;
  const double m_maximum_nodes;
  const std::function<bool()>& m_go_further;
  Lattice_reduction m_reduction;
  std::unique_ptr<Subtree_bounds> m_test;
  double m_test_nodes = 0.; // that its preparation took
  double m_radius = 0.;     // the squared distance of the best point
  double m_bound = 0.;      // no point but the best one is nearer
  double m_tree = 100.;     // the size of the next one to search as a whole, by the Gaussian heuristic
  double m_correction = 1.; // of the Gaussian heuristic, as observed
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_ROUNDING_H
