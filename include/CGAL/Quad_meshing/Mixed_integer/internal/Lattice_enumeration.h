// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_ENUMERATION_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_ENUMERATION_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Subtree_test.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Schnorr-Euchner enumeration: integer points z with |R (z - c)|^2 < radius, R upper triangular.
//
// Depth first from the last coordinate to the first; on each level the candidates are visited in the order of
// their distance from the center that the coordinates above leave, so a level ends with the first one too far.
// Partial sums are kept per level and only brought up to date from the highest coordinate that changed
// (Gama, Nguyen, Regev 2010). Nothing allocates after the construction.
//
// Large subtrees may be tested for a lower bound of what their free coordinates add (for bounds in such trees see
// Stojnic, Vikalo, Hassibi, Speeding up the sphere decoder with H-infinity and SDP inspired lower bounds, 2008).
class Lattice_enumeration
{
public:
  // R is m x m upper triangular with a positive diagonal.
  Lattice_enumeration(const Eigen::MatrixXd& R, const Eigen::VectorXd& center)
    : m_size(static_cast<int>(R.rows()))
    , m_center(center.data(), center.data() + center.size())
    , m_mu(static_cast<std::size_t>(m_size) * m_size, 0.)
    , m_square(m_size)
    , m_sums(static_cast<std::size_t>(m_size) * (m_size + 1), 0.)
    , m_pruning(m_size, 1.)
    , m_threshold(m_size + 1, infinity)
    , m_best(m_size, 0.)
  {
    for(int i = 0; i < m_size; ++i)
    {
      m_square[i] = R(i, i) * R(i, i);
      for(int j = i + 1; j < m_size; ++j)
        m_mu[index(i, j)] = R(i, j) / R(i, i);
    }
  }

  Eigen::VectorXd center() const { return Eigen::Map<const Eigen::VectorXd>(m_center.data(), m_size); }

  // Nearest plane: rounds the coordinates from the last to the first.
  Eigen::VectorXd nearest_plane() const
  {
    Eigen::VectorXd z(m_size);
    for(int k = m_size - 1; k >= 0; --k)
    {
      double c = m_center[k];
      for(int j = k + 1; j < m_size; ++j)
        c -= m_mu[index(k, j)] * (z[j] - m_center[j]);
      z[k] = std::floor(c + 0.5);
    }
    return z;
  }

  // |R (z - c)|^2
  double squared_distance(const Eigen::VectorXd& z) const
  {
    double sum = 0.;
    for(int k = m_size - 1; k >= 0; --k)
    {
      double d = z[k] - m_center[k];
      for(int j = k + 1; j < m_size; ++j)
        d += m_mu[index(k, j)] * (z[j] - m_center[j]);
      sum += d * d * m_square[k];
    }
    return sum;
  }

  // Level k may use the fraction ((m - k) / m)^exponent of the radius: 0 prunes nothing, 1 expects the distance to
  // be spread evenly over the coordinates.
  void set_pruning(double exponent)
  {
    for(int k = 0; k < m_size; ++k)
      m_pruning[k] = exponent > 0. ? std::pow(double(m_size - k) / m_size, exponent) : 1.;
  }

  // Tests subtrees from now on, or, with a null pointer, no more.
  void set_test(Subtree_test* test)
  {
    m_test = test;
    for(int k = 0; k <= m_size; ++k)
      m_threshold[k] =
        m_test != nullptr && m_test->has_level(k) ? radius_of_subtree(k, m_test->nodes_per_test(k)) : infinity;
  }

  // The number of nodes to expect without pruning: level by level, the volume of the ball of the radius over the
  // volume of the lattice cell (Gaussian heuristic). Each point inside also costs the visits outside that end the
  // two directions of its zigzag. With tests, those count whose coordinates above the last tested level leave more than
  // the bound there, which is taken to be distributed normally: of the points of a ball, the part of the squared
  // distance in some of the coordinates has a beta distribution.
  double expected_nodes(double squared_radius) const
  {
    double total = 0., log_cell = 0.;
    int tested = m_size; // the last level with a test
    for(int k = m_size - 1; k >= 0; --k)
    {
      log_cell += 0.5 * std::log(m_square[k]);
      const double points = points_in_ball(m_size - k, squared_radius, log_cell);
      const double left = points * (tested < m_size ? part_left(tested, k, squared_radius) : 1.);
      total += visits_per_point * left;
      if(k > 0 && m_test != nullptr && m_test->has_level(k))
      {
        const double large = points_in_ball(m_size - k, squared_radius - m_threshold[k], log_cell);
        total += (std::min)(left, large) * m_test->nodes_per_test(k);
        tested = k;
      }
    }
    return total;
  }

  // Searches for points with a squared distance below `squared_radius`, which shrinks with every point found.
  // Stops after `maximum_nodes`, or if `go_further`, asked now and then, says so.
  // Returns true if the search was complete.
  bool run(double& squared_radius, double maximum_nodes, const std::function<bool()>& go_further)
  {
    const int m = m_size;
    m_found = false;
    if(m == 0)
      return true;
    std::vector<double> z(m), c(m), step(m), distance(m + 1, 0.), bound(m);
    std::vector<int> stale(m + 1, m - 1); // sums of level k miss changes of coordinates up to stale[k]
    const auto update_bounds = [&]()
    {
      for(int k = 0; k < m; ++k)
        bound[k] = squared_radius < infinity ? squared_radius * m_pruning[k] : infinity;
    };
    update_bounds();
    const auto start_level = [&](int k, double center)
    {
      c[k] = center;
      z[k] = std::floor(center + 0.5);
      step[k] = center >= z[k] ? 1. : -1.;
    };

    long long nodes = 0, next_question = question_interval;
    const long long limit =
      maximum_nodes < 9e18 ? static_cast<long long>(maximum_nodes) : (std::numeric_limits<long long>::max)();
    int k = m - 1;
    start_level(k, m_center[k]);
    for(;;)
    {
      ++nodes;
      const double d = z[k] - c[k];
      const double partial = distance[k + 1] + d * d * m_square[k];
      if(partial < bound[k])
      {
        if(k > 0 && squared_radius - partial > m_threshold[k] && is_far(k, z, squared_radius - partial, nodes))
        {
          // The next sibling.
        }
        else if(k > 0)
        {
          distance[k] = partial;
          --k;
          double* const sums = &m_sums[static_cast<std::size_t>(k) * (m + 1)];
          const double* const mu = &m_mu[static_cast<std::size_t>(k) * m];
          const int highest = (std::max)(stale[k], k + 1);
          for(int j = highest; j > k; --j)
            sums[j] = sums[j + 1] + mu[j] * (z[j] - m_center[j]);
          stale[k] = k + 1;
          if(k > 0)
            stale[k - 1] = (std::max)(stale[k - 1], highest);
          start_level(k, m_center[k] - sums[k + 1]);
          continue;
        }
        else
        {
          m_found = true;
          m_best = z;
          squared_radius = partial;
          update_bounds();
        }
      }
      else
      {
        ++k;
        if(k == m)
        {
          m_nodes += double(nodes);
          return true;
        }
      }
      if(nodes >= next_question)
      {
        next_question += question_interval;
        if(nodes >= limit || !go_further())
        {
          m_nodes += double(nodes);
          return false;
        }
      }
      z[k] += step[k];
      step[k] = step[k] > 0. ? -step[k] - 1. : -step[k] + 1.;
      if(k > 0)
        stale[k - 1] = (std::max)(stale[k - 1], k);
    }
  }

  // Whether the last run found a point, and the last, best one.
  bool found() const { return m_found; }
  Eigen::VectorXd best() const { return Eigen::Map<const Eigen::VectorXd>(m_best.data(), m_size); }

  // The number of nodes of all runs, tests of subtrees included by the time they take.
  double nodes() const { return m_nodes; }

private:
  enum
  {
    question_interval = 16384
  };

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double visits_per_point = 2.5; // measured on lattices of parametrizations

  static double points_in_ball(int dimension, double squared_radius, double log_cell)
  {
    const double pi = 3.14159265358979323846;
    if(!(squared_radius > 0.))
      return 0.;
    const double log_ball = 0.5 * dimension * std::log(pi * squared_radius) - std::lgamma(0.5 * dimension + 1.);
    return std::exp((std::min)(log_ball - log_cell, 600.));
  }

  // The distribution function of a beta distribution: Lentz's method for the continued fraction of the incomplete beta
  // function, in the half where it converges fast.
  static double beta_distribution(double a, double b, double x)
  {
    const int maximum_steps = 200;
    const double accuracy = 1e-8, tiny = 1e-300;
    if(!(x > 0.))
      return 0.;
    if(!(x < 1.))
      return 1.;
    if(x > (a + 1.) / (a + b + 2.))
      return 1. - beta_distribution(b, a, 1. - x);
    const double log_front =
      std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x) - std::log(a);
    double f = 1., c = 1., d = 0.;
    for(int i = 0; i <= maximum_steps; ++i)
    {
      const int m = i / 2;
      const double numerator = i == 0       ? 1.
                               : i % 2 == 0 ? m * (b - m) * x / ((a + 2. * m - 1.) * (a + 2. * m))
                                            : -(a + m) * (a + b + m) * x / ((a + 2. * m) * (a + 2. * m + 1.));
      d = 1. + numerator * d;
      d = 1. / (std::fabs(d) < tiny ? tiny : d);
      c = 1. + numerator / c;
      c = std::fabs(c) < tiny ? tiny : c;
      f *= c * d;
      if(std::fabs(1. - c * d) < accuracy)
        break;
    }
    return std::exp(log_front) * (f - 1.);
  }

  // Of the points of level k in the ball, the part whose subtrees pass the test at level `tested`.
  double part_left(int tested, int k, double squared_radius) const
  {
    const int range = 4; // standard deviations to either side
    const Subtree_test::Distance distance = m_test->distance(tested);
    double sum = 0., weights = 0.;
    for(int i = -range; i <= range; ++i)
    {
      const double weight = std::exp(-0.5 * i * i), bound = (std::max)(0., distance.mean + i * distance.deviation);
      weights += weight;
      if(bound < squared_radius)
        sum +=
          weight * beta_distribution(0.5 * (m_size - tested), 0.5 * (tested - k) + 1., 1. - bound / squared_radius);
    }
    return sum / weights;
  }

  // The squared radius for which the subtree over the first k coordinates is expected to have so many nodes.
  double radius_of_subtree(int k, double nodes) const
  {
    const int steps = 60;
    double low = 0., high = 0.;
    for(int i = 0; i < k; ++i)
      high += m_square[i]; // far more than enough
    for(int i = 0; i < steps; ++i)
    {
      const double middle = 0.5 * (low + high);
      double total = 0., log_cell = 0.;
      for(int j = k - 1; j >= 0; --j)
      {
        log_cell += 0.5 * std::log(m_square[j]);
        total += visits_per_point * points_in_ball(k - j, middle, log_cell);
      }
      (total > nodes ? high : low) = middle;
    }
    return low;
  }

  bool is_far(int k, const std::vector<double>& z, double squared_radius, long long& nodes)
  {
    const double before = m_test->nodes();
    const bool result = m_test->exceeds(k, z, squared_radius);
    nodes += static_cast<long long>(m_test->nodes() - before);
    return result;
  }

  std::size_t index(int i, int j) const { return static_cast<std::size_t>(i) * m_size + j; }

  int m_size;
  std::vector<double> m_center;
  std::vector<double> m_mu;     // R divided by its diagonal, row by row
  std::vector<double> m_square; // the squared diagonal of R
  std::vector<double> m_sums;   // sums[k][j] = sum over i >= j of mu_ki (z_i - c_i)
  std::vector<double> m_pruning;
  Subtree_test* m_test = nullptr;
  std::vector<double> m_threshold; // of the squared radius left, per level, from which on a subtree is tested
  std::vector<double> m_best;
  bool m_found = false;
  double m_nodes = 0.;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_ENUMERATION_H
