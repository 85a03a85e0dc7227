// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SUBLATTICE_BOUND_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SUBLATTICE_BOUND_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Mean_slab_relaxation.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Lower bounds of the squared distances of many targets from one lattice, each in some microseconds.
//
// The bound with the weights of `Mean_slab_relaxation` comes first. Where it does not suffice, weights are changed one
// after the other, each as much as serves this target best. With C = B'N^-1 B, the distances s of the minimum from the
// middles of the slabs and the curvatures q = diag C, a change d of one weight changes the bound by
//   d/4 - d s^2 / (1 - d q),
// whose maximum is (1 - 2|s|)^2 / 4q, at d = (1 - 2|s|)/q; C changes by a multiple of the outer product of its column,
// so that s and q follow from the columns that were used.
class Sublattice_bound
{
public:
  Sublattice_bound(const Eigen::MatrixXd& R, int rounds)
  {
    const Mean_slab_relaxation relaxation(R, rounds);
    m_normals = relaxation.normals();
    m_weights = relaxation.weights();
    const Eigen::MatrixXd& B = relaxation.B();
    const int m = static_cast<int>(R.rows()), n = size();
    Eigen::LLT<Eigen::MatrixXd> cholesky;
    for(;;)
    {
      cholesky.compute(Eigen::MatrixXd::Identity(m, m) - B * m_weights.asDiagonal() * B.transpose());
      if(cholesky.info() == Eigen::Success)
        break;
      m_weights *= 0.5; // round-off at the boundary; any weights that pass are as valid
    }
    m_C = B.transpose() * cholesky.solve(B);
    m_H = m_C * m_weights.asDiagonal();
    m_H.diagonal().array() += 1.;
    m_columns.resize(n, maximum_changes);
    m_factors.resize(maximum_changes);
    m_operations = relaxation.operations() + 2. * n * n * m;
  }

  // A column per slab.
  const Eigen::MatrixXd& normals() const { return m_normals; }
  int size() const { return static_cast<int>(m_weights.size()); }

  // A bound for the target whose products with the normals these are: at least `goal` if that can be reached, and the
  // best that can be had if `goal` is infinite.
  double bound(const Eigen::VectorXd& products, double goal)
  {
    // The sum of the gains to come is taken to be at most so many times the last one: they fall, the first half of the
    // changes brings most.
    const double gains_to_come = 15.;
    const double round_off = 1e-10; // of a sum of terms of the size of the weights
    const double infinity = std::numeric_limits<double>::infinity();
    const int n = size();
    m_u = products.array() - products.array().floor() - 0.5;
    m_s.noalias() = m_H * m_u;
    m_operations += double(n) * n;
    const double total = m_weights.sum();
    double bound = 0.25 * total - (m_weights.array() * m_u.array() * m_s.array()).sum() - round_off * (1. + total);
    if(bound >= goal)
      return bound;
    m_q = m_C.diagonal();
    m_w = m_weights;
    for(int count = 0; count < maximum_changes && bound < goal; ++count)
    {
      int best = -1;
      double gain = 0, change = 0;
      for(int i = 0; i < n; ++i)
      {
        // Not quite as far as to where there is no minimum.
        const double least_rest = 0.1;
        const double s = std::fabs(m_s[i]), d = (std::max)((1. - (std::max)(2. * s, least_rest)) / m_q[i], -m_w[i]);
        const double g = 0.25 * d - d * s * s / (1. - d * m_q[i]);
        if(g > gain)
        {
          gain = g;
          change = d;
          best = i;
        }
      }
      m_operations += n * (count + 6.);
      if(best < 0 ||
         (goal < infinity && goal - bound > gain * (std::min)(gains_to_come, double(maximum_changes - count))))
        return bound;
      auto column = m_columns.col(count);
      column = m_C.col(best);
      for(int l = 0; l < count; ++l)
        column += (m_factors[l] * m_columns(best, l)) * m_columns.col(l);
      m_factors[count] = change / (1. - change * m_q[best]);
      bound += gain;
      m_s += (m_factors[count] * m_s[best]) * column;
      m_q.array() += m_factors[count] * column.array().square();
      m_w[best] += change;
    }
    return bound;
  }

  // Multiplications and additions so far, about.
  double operations() const { return m_operations; }

private:
  enum
  {
    maximum_changes = 40
  };

  Eigen::MatrixXd m_normals;
  Eigen::VectorXd m_weights;
  Eigen::MatrixXd m_C, m_H;           // H = I + CW
  Eigen::VectorXd m_u, m_s, m_q, m_w; // of one call
  Eigen::MatrixXd m_columns;          // those of C that were used
  Eigen::VectorXd m_factors;          // of their outer products in the change of C
  double m_operations = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SUBLATTICE_BOUND_H
