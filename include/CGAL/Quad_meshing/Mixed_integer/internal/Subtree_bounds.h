// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SUBTREE_BOUNDS_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SUBTREE_BOUNDS_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Sublattice_bound.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Subtree_test.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Lower bounds for the subtrees of a `Lattice_enumeration`. Where the coordinates k, ..., m - 1 are fixed, what is left
// is the distance of a target from the lattice of the first k basis vectors; bounds for some of these lattices are
// prepared. A subtree is tested if it promises to be larger than a test is long.
class Subtree_bounds : public Subtree_test
{
public:
  // Visits of nodes of the plain enumeration take as long as so many multiplications and additions here; measured.
  static constexpr double operations_per_node = 100.;

  // What the bounds for k free coordinates take to prepare, in nodes; measured.
  static double nodes_to_prepare(int k) { return 4. * k * k * k; }

  // R is the factor of the basis, `center` the target in it; `sizes` are numbers of free coordinates.
  Subtree_bounds(const Eigen::MatrixXd& R, const Eigen::VectorXd& center, const std::vector<int>& sizes,
                 const std::function<bool()>& go_further)
    : m_size(static_cast<int>(R.rows())), m_center(center), m_level_of(R.rows() + 1, -1)
  {
    const int rounds = 2, samples = 32;
    for(int k : sizes)
    {
      if(!go_further())
        return;
      const auto corner = R.topLeftCorner(k, k);
      Level level{ k, Sublattice_bound(corner, rounds), {}, {}, {}, {}, Distance(), 0 };
      const Eigen::MatrixXd& normals = level.bound.normals();
      level.slopes = normals.transpose() * corner.template triangularView<Eigen::Upper>().solve(
                                             Eigen::MatrixXd(R.topRightCorner(k, m_size - k)));
      level.products = level.at_center = normals.transpose() * center.head(k);
      level.coordinates = center.tail(m_size - k);
      level.distance = sample(level.bound, samples);
      m_level_of[k] = static_cast<int>(m_levels.size());
      m_levels.push_back(level);
    }
  }

  bool has_level(int k) const override { return m_level_of[k] >= 0; }

  Distance distance(int k) const override { return m_levels[m_level_of[k]].distance; }

  double nodes_per_test(int k) const override
  {
    const double changes = 4., passes = 8.; // over the slabs, per change; most tests need next to none
    const double n = m_levels[m_level_of[k]].bound.size();
    return (n * n + n * changes * passes) / operations_per_node;
  }

  bool exceeds(int k, const std::vector<double>& z, double squared_radius) override
  {
    const long refresh_interval = 4096; // after so many steps round-off is taken away
    const double round_off = 1e-9;
    Level& level = m_levels[m_level_of[k]];
    if(++level.steps % refresh_interval == 0)
    {
      level.products = level.at_center;
      level.coordinates = m_center.tail(m_size - k);
    }
    for(int j = k; j < m_size; ++j)
      if(z[j] != level.coordinates[j - k])
      {
        level.products -= (z[j] - level.coordinates[j - k]) * level.slopes.col(j - k);
        level.coordinates[j - k] = z[j];
      }
    const double goal = squared_radius * (1. + round_off);
    return level.bound.bound(level.products, goal) >= goal;
  }

  double nodes() const override
  {
    double operations = 0;
    for(const Level& level : m_levels)
      operations += level.bound.operations();
    return operations / operations_per_node;
  }

private:
  struct Level
  {
    int size;
    Sublattice_bound bound;
    Eigen::MatrixXd slopes;      // of the products of the target with the normals, by the fixed coordinates
    Eigen::VectorXd at_center;   // the products where these are those of the center
    Eigen::VectorXd coordinates; // the fixed ones of the last test
    Eigen::VectorXd products;    // and the products there
    Distance distance;
    long steps;
  };

  static Distance sample(Sublattice_bound& bound, int count)
  {
    std::mt19937 generator(1);
    const double range = 4294967296.; // of the generator
    double sum = 0, squares = 0;
    for(int i = 0; i < count; ++i)
    {
      Eigen::VectorXd target(bound.normals().rows());
      for(double& x : target)
        x = generator() / range;
      const double d = bound.bound(bound.normals().transpose() * target, std::numeric_limits<double>::infinity());
      sum += d;
      squares += d * d;
    }
    const double mean = sum / count;
    return Distance{ mean, std::sqrt((std::max)(0., squares / count - mean * mean)) };
  }

  int m_size = 0;
  Eigen::VectorXd m_center;
  std::vector<int> m_level_of; // by the number of free coordinates
  std::vector<Level> m_levels;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SUBTREE_BOUNDS_H
