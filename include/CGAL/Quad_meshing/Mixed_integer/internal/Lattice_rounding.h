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

#include <Eigen/Cholesky>

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

struct Lattice_result
{
  Eigen::VectorXd y;
  double cost = 0.;             // 1/2 |R (y - y*)|^2
  double cost_bound = 0.;       // no integer point costs less
  bool is_optimal = false;
  double nodes = 0.;
};

// The closest-vector problem of a dense energy: min 1/2 (y - y*)' S (y - y*) over integer y.
//
// Reduces the lattice of R, S = R'R; takes the better of the nearest plane and a given start; then searches
// trees pruned less and less for better points, and if the whole tree promises to fit in the limit, searches it,
// which proves the optimum. Otherwise the rest of the nodes goes into a bound: a complete search that finds
// nothing within a radius proves that no point lies there.
class Lattice_rounding
{
public:
  Lattice_rounding(const Eigen::MatrixXd& R, const Eigen::VectorXd& target, double maximum_nodes,
                   const std::function<bool()>& go_further)
    : m_R(R), m_target(target), m_maximum_nodes(maximum_nodes), m_go_further(go_further)
  {}

  Lattice_result run(const Eigen::VectorXd& start, bool wants_bound)
  {
    const int block_size = 24, tours = 12;
    // The origin is moved next to the target: all numbers stay small.
    const int m = static_cast<int>(m_target.size());
    Eigen::VectorXd origin(m);
    for(int i = 0; i < m; ++i)
      origin[i] = nearest_integer(m_target[i]);
    const Eigen::VectorXd target = m_target - origin;

    Lattice_reduction reduction(m_R);
    reduction.run(block_size, tours, m_go_further);
    Lattice_enumeration enumeration(reduction.factor(), reduction.coordinates(target));

    Eigen::VectorXd best = enumeration.nearest_plane();
    double radius = enumeration.squared_distance(best);
    const Eigen::VectorXd z = reduction.coordinates(start - origin).array().round();
    const double start_radius = enumeration.squared_distance(z);
    if(start_radius < radius)
    {
      best = z;
      radius = start_radius;
    }

    Lattice_result result;
    double bound = 0.;
    result.is_optimal = search(enumeration, best, radius);
    if(result.is_optimal)
      bound = radius;
    else if(wants_bound)
    {
      bound = prove_bound(enumeration, best, radius);
      result.is_optimal = (bound >= radius);
    }

    result.y = origin + reduction.transformation() * best;
    const Eigen::VectorXd d = m_R * (result.y - m_target);
    result.cost = 0.5 * d.squaredNorm();
    // Sums of squares in the search carry round-off; it must not lift the bound above the truth.
    const double round_off = 1e-9;
    result.cost_bound = (std::min)(result.cost, 0.5 * bound * (1. - round_off));
    if(result.is_optimal)
      result.cost_bound = result.cost;
    result.nodes = enumeration.nodes();
    return result;
  }

private:
  // Returns true if `best` is proven to be the closest point.
  bool search(Lattice_enumeration& enumeration, Eigen::VectorXd& best, double& radius)
  {
    const double pruning_exponents[] = { 1., 0.7, 0.5, 0.35 };
    const double pruned_fraction = 0.12; // of all nodes, per pruned search
    for(double exponent : pruning_exponents)
    {
      if(enumeration.expected_nodes(radius) <= pruned_fraction * m_maximum_nodes)
        break;
      enumeration.set_pruning(exponent);
      enumeration.run(radius, pruned_fraction * m_maximum_nodes, m_go_further);
      if(enumeration.found())
        best = enumeration.best();
    }
    const double left = m_maximum_nodes - enumeration.nodes();
    if(enumeration.expected_nodes(radius) > estimate_slack * left)
      return false;
    enumeration.set_pruning(0.);
    const bool complete = enumeration.run(radius, left, m_go_further);
    if(enumeration.found())
      best = enumeration.best();
    return complete;
  }

  // Returns a squared radius within which no point lies, other than `best` on its border.
  double prove_bound(Lattice_enumeration& enumeration, Eigen::VectorXd& best, double& radius)
  {
    const int steps = 40;
    const double share = 0.8; // of the nodes left, in view of the error of estimates
    const double left = m_maximum_nodes - enumeration.nodes();
    double low = 0., high = radius;
    for(int i = 0; i < steps; ++i)
    {
      const double middle = 0.5 * (low + high);
      (enumeration.expected_nodes(middle) > share * left ? high : low) = middle;
    }
    double reach = low;
    enumeration.set_pruning(0.);
    const bool complete = enumeration.run(reach, left, m_go_further);
    if(enumeration.found())
    {
      best = enumeration.best();
      radius = reach;
    }
    return complete ? reach : 0.;
  }

  // The estimate of the size of a tree may be too large by this factor before it is believed.
  static constexpr double estimate_slack = 1.25;

  const Eigen::MatrixXd& m_R;
  const Eigen::VectorXd& m_target;
  double m_maximum_nodes;
  const std::function<bool()>& m_go_further;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_ROUNDING_H
