// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "test_cases.h"

// The test checks itself by assertions.
#ifdef NDEBUG
#undef NDEBUG
#endif

#include <CGAL/Quad_meshing/Mixed_integer/internal/Lattice_rounding.h>

#include <CGAL/Random.h>

#include <cassert>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <vector>

namespace QMi = CGAL::Quad_meshing::internal;

const std::function<bool()> go_on = [] { return true; };

// A lattice whose basis is far from orthogonal, reduced.
Eigen::MatrixXd random_factor(CGAL::Random& random, int m)
{
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(m, m);
  for(int j = 0; j < m; ++j)
    for(int i = 0; i <= j; ++i)
      R(i, j) = i == j ? random.get_double(0.8, 1.6) : random.get_double(-2., 2.);
  QMi::Lattice_reduction reduction(R);
  reduction.run(10, 4, go_on);
  return reduction.factor();
}

// A lattice as those of parametrizations are once they are reduced: the diagonal is flat, and the others are at most
// half as large.
Eigen::MatrixXd flat_factor(CGAL::Random& random, int m)
{
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(m, m);
  for(int i = 0; i < m; ++i)
  {
    R(i, i) = random.get_double(1.1, 1.5);
    for(int j = i + 1; j < m; ++j)
      R(i, j) = R(i, i) * random.get_double(-0.2, 0.2);
  }
  return R;
}

Eigen::VectorXd random_target(CGAL::Random& random, int m)
{
  Eigen::VectorXd target(m);
  for(double& x : target)
    x = random.get_double(-3., 3.);
  return target;
}

double squared_distance(const Eigen::MatrixXd& R, const Eigen::VectorXd& target)
{
  QMi::Lattice_enumeration enumeration(R, target);
  double radius = std::numeric_limits<double>::infinity();
  const bool is_complete = enumeration.run(radius, 1e18, go_on);
  assert(is_complete && enumeration.found());
  return radius;
}

// Bounds lie below the distance, found by a search without them; with any number of changes of the weights, and for
// targets anywhere, lattice points among them. In the mean they are worth something.
void sublattice_bounds()
{
  CGAL::Random random(11);
  for(int m : { 1, 2, 5, 12, 24 })
  {
    double bounds = 0., distances = 0.;
    for(int lattice = 0; lattice < 4; ++lattice)
    {
      const Eigen::MatrixXd R = random_factor(random, m);
      QMi::Sublattice_bound bound(R, 2);
      const double infinity = std::numeric_limits<double>::infinity();
      for(int i = 0; i < 30; ++i)
      {
        Eigen::VectorXd target = random_target(random, m);
        if(i % 10 == 0)
          target = target.array().round();
        const double distance = squared_distance(R, target);
        const Eigen::VectorXd products = bound.normals().transpose() * target;
        const double best = bound.bound(products, infinity);
        assert(best <= distance * (1. + 1e-9) + 1e-9);
        // A goal is reached or not, the bound holds.
        for(double part : { 0.1, 0.5, 0.9, 1.1 })
          assert(bound.bound(products, part * distance) <= distance * (1. + 1e-9) + 1e-9);
        bounds += best;
        distances += distance;
      }
    }
    std::cout << m << " integers: " << bounds / distances << " of the distances" << std::endl;
    assert(bounds > 0.4 * distances);
  }
}

// A search that tests subtrees finds the same optimum as one that does not, and visits far fewer of the nodes.
void tested_subtrees()
{
  CGAL::Random random(7);
  for(int m : { 20, 52 })
  {
    const Eigen::MatrixXd R = flat_factor(random, m);
    const Eigen::VectorXd target = random_target(random, m);
    std::vector<int> sizes;
    for(int k = m < 40 ? 2 : 20; k < m; k += 4)
      sizes.push_back(k);
    QMi::Lattice_enumeration plain(R, target), tested(R, target);
    QMi::Subtree_bounds bounds(R, target, sizes, go_on);
    tested.set_test(&bounds);
    double plain_radius = plain.squared_distance(plain.nearest_plane()) * 2., tested_radius = plain_radius;
    const bool are_complete = plain.run(plain_radius, 1e18, go_on) && tested.run(tested_radius, 1e18, go_on);
    std::cout << m << " integers: " << plain.nodes() << " nodes, with tests " << tested.nodes() << std::endl;
    assert(are_complete && plain.found() && tested.found());
    assert(plain.best() == tested.best());
    assert(m < 40 || tested.nodes() < plain.nodes());
    // Nothing below the optimum, either.
    double below = plain_radius * (1. - 1e-9);
    const bool is_complete = tested.run(below, 1e18, go_on);
    assert(is_complete && !tested.found());
  }
}

// A lattice of 64 dimensions whose tree is large: the optimum is proven with bounds, and a search without them for
// any point that is better finds none.
void proof_by_subtrees()
{
  CGAL::Random random(5);
  const int m = 64;
  const Eigen::MatrixXd R = flat_factor(random, m);
  const Eigen::VectorXd target = random_target(random, m);
  QMi::Lattice_rounding rounding(R, target, 1e9, go_on);
  const QMi::Lattice_result result = rounding.run(target.array().round(), true);
  assert(result.is_optimal);
  const double cost = 0.5 * (R * (result.y - target)).squaredNorm();
  assert(std::fabs(result.cost - cost) <= 1e-9 * cost);
  QMi::Lattice_enumeration plain(R, target);
  double radius = 2. * cost * (1. - 1e-9);
  const double expected = plain.expected_nodes(radius);
  const bool is_complete = plain.run(radius, 1e18, go_on);
  assert(is_complete && !plain.found());
  std::cout << result.nodes << " nodes, without bounds " << plain.nodes() << ", expected " << expected << std::endl;
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   {
                     { "sublattice_bounds", sublattice_bounds },
                     { "tested_subtrees", tested_subtrees },
                     { "proof_by_subtrees", proof_by_subtrees },
                   });
}
