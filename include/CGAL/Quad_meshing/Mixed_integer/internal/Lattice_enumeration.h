// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_ENUMERATION_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_ENUMERATION_H

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
    , m_best(m_size, 0.)
  {
    for(int i = 0; i < m_size; ++i)
    {
      m_square[i] = R(i, i) * R(i, i);
      for(int j = i + 1; j < m_size; ++j)
        m_mu[index(i, j)] = R(i, j) / R(i, i);
    }
  }

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

  // The number of nodes to expect without pruning: level by level, the volume of the ball of the radius over the
  // volume of the lattice cell (Gaussian heuristic). Each point inside also costs the visits outside that end the
  // two directions of its zigzag.
  double expected_nodes(double squared_radius) const
  {
    const double pi = 3.14159265358979323846;
    const double visits_per_point = 2.5; // measured on lattices of parametrizations
    double total = 0., log_cell = 0.;
    for(int d = 1; d <= m_size; ++d)
    {
      log_cell += 0.5 * std::log(m_square[m_size - d]);
      const double log_ball = 0.5 * d * std::log(pi * squared_radius) - std::lgamma(0.5 * d + 1.);
      total += std::exp((std::min)(log_ball - log_cell, 600.));
    }
    return visits_per_point * total;
  }

  // Searches for points with a squared distance below `squared_radius`, which shrinks with every point found.
  // Stops after `maximum_nodes`, or if `go_further`, asked now and then, says so.
  // Returns true if the search was complete.
  bool run(double& squared_radius, double maximum_nodes, const std::function<bool()>& go_further)
  {
    const double infinity = std::numeric_limits<double>::infinity();
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
        if(k > 0)
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
        m_found = true;
        m_best = z;
        squared_radius = partial;
        update_bounds();
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

  // The number of nodes of all runs.
  double nodes() const { return m_nodes; }

private:
  enum
  {
    question_interval = 16384
  };

  std::size_t index(int i, int j) const { return static_cast<std::size_t>(i) * m_size + j; }

  int m_size;
  std::vector<double> m_center;
  std::vector<double> m_mu;     // R divided by its diagonal, row by row
  std::vector<double> m_square; // the squared diagonal of R
  std::vector<double> m_sums;   // sums[k][j] = sum over i >= j of mu_ki (z_i - c_i)
  std::vector<double> m_pruning;
  std::vector<double> m_best;
  bool m_found = false;
  double m_nodes = 0.;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_ENUMERATION_H
