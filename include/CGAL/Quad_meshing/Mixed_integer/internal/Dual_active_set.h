// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DUAL_ACTIVE_SET_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DUAL_ACTIVE_SET_H

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Solves min 1/2 (y - y*)' S (y - y*) subject to a_i'y >= b_i for a positive definite S by the dual active-set
// method of Goldfarb and Idnani (1983): from the unconstrained minimum, violated constraints become active one
// after the other, and the cost only rises. An active set is kept as a QR factorization: with J = L^-T Q,
// S = LL', and N the matrix of active rows, L^-1 N = Q (R 0)'.
class Dual_active_set
{
public:
  struct Constraint
  {
    Eigen::VectorXd a;
    double b;
  };

  // J is L^-T for S = LL'.
  Dual_active_set(const Eigen::MatrixXd& J, const Eigen::VectorXd& target)
    : m_inverse_factor(J), m_target(target), m_size(static_cast<int>(target.size()))
  {
  }

  // Returns false if the constraints contradict each other. The cost is that over the unconstrained minimum.
  bool solve(const std::vector<Constraint>& constraints, Eigen::VectorXd& y, double& cost)
  {
    m_J = m_inverse_factor;
    m_R = Eigen::MatrixXd::Zero(m_size, m_size);
    m_active.clear();
    m_multipliers.clear();
    y = m_target;
    cost = 0.;
    std::vector<char> is_active(constraints.size(), 0);
    // Cycling is impossible but for round-off; this many exchanges never happen without.
    const std::size_t maximum_steps = 50 * (constraints.size() + m_size + 1);
    for(std::size_t step = 0; step < maximum_steps; ++step)
    {
      const int p = most_violated(constraints, is_active, y);
      if(p < 0)
      {
        settle(constraints, y);
        return true;
      }
      if(!activate(constraints, p, is_active, y, cost))
        return false;
    }
    return true;
  }

private:
  // Violations below this, relative to the size of the numbers compared, are round-off.
  static constexpr double tolerance = 1e-10;

  static int most_violated(const std::vector<Constraint>& constraints, const std::vector<char>& is_active,
                           const Eigen::VectorXd& y)
  {
    int worst = -1;
    double least = -tolerance;
    for(std::size_t i = 0; i < constraints.size(); ++i)
    {
      if(is_active[i])
        continue;
      const double largest = constraints[i].a.cwiseProduct(y).lpNorm<Eigen::Infinity>();
      const double slack =
        (constraints[i].a.dot(y) - constraints[i].b) / (std::max)({ 1., std::fabs(constraints[i].b), largest });
      if(slack < least)
      {
        least = slack;
        worst = static_cast<int>(i);
      }
    }
    return worst;
  }

  // The way from a minimum far away leaves round-off: takes it out of the active constraints.
  void settle(const std::vector<Constraint>& constraints, Eigen::VectorXd& y) const
  {
    const int q = static_cast<int>(m_active.size()), passes = 2;
    for(int pass = 0; pass < passes && q > 0; ++pass)
    {
      Eigen::VectorXd residual(q);
      for(int k = 0; k < q; ++k)
        residual[k] = constraints[m_active[k]].b - constraints[m_active[k]].a.dot(y);
      // N'J = (R' 0) for the active rows N.
      m_R.topLeftCorner(q, q).transpose().triangularView<Eigen::Lower>().solveInPlace(residual);
      y += m_J.leftCols(q) * residual;
    }
  }

  bool activate(const std::vector<Constraint>& constraints, int p, std::vector<char>& is_active, Eigen::VectorXd& y,
                double& cost)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    const Eigen::VectorXd& a = constraints[p].a;
    double multiplier = 0.;
    for(;;)
    {
      const int q = static_cast<int>(m_active.size());
      Eigen::VectorXd d = m_J.transpose() * a;
      // The step in the variables, orthogonal to the active rows, and the one in their multipliers.
      const Eigen::VectorXd z = m_J.rightCols(m_size - q) * d.tail(m_size - q);
      const Eigen::VectorXd r = m_R.topLeftCorner(q, q).triangularView<Eigen::Upper>().solve(d.head(q));
      const double curvature = z.dot(a); // = |d.tail|^2

      double t_dual = infinity;
      int blocking = -1;
      for(int j = 0; j < q; ++j)
        if(r[j] > 0. && m_multipliers[j] / r[j] < t_dual)
        {
          t_dual = m_multipliers[j] / r[j];
          blocking = j;
        }
      const bool has_direction = curvature > 1e-14 * d.squaredNorm() && d.tail(m_size - q).norm() > 1e-11 * d.norm();
      const double slack = a.dot(y) - constraints[p].b;
      const double t_primal = has_direction ? (std::max)(0., -slack / curvature) : infinity;
      const double t = (std::min)(t_dual, t_primal);
      if(t == infinity)
        return false;

      if(has_direction)
      {
        y += t * z;
        cost += t * curvature * (0.5 * t + multiplier);
      }
      for(int j = 0; j < q; ++j)
        m_multipliers[j] -= t * r[j];
      multiplier += t;

      if(t == t_primal)
      {
        add(p, d);
        m_multipliers.push_back(multiplier);
        is_active[p] = 1;
        return true;
      }
      is_active[m_active[blocking]] = 0;
      drop(blocking);
    }
  }

  // Givens rotation of columns i and i + 1 of J, and of the vector d or of the rows of R.
  void rotate_columns(int i, double c, double s)
  {
    for(int k = 0; k < m_size; ++k)
    {
      const double u = m_J(k, i), v = m_J(k, i + 1);
      m_J(k, i) = c * u + s * v;
      m_J(k, i + 1) = c * v - s * u;
    }
  }

  void add(int p, Eigen::VectorXd& d)
  {
    const int q = static_cast<int>(m_active.size());
    for(int i = m_size - 2; i >= q; --i)
    {
      const double h = std::hypot(d[i], d[i + 1]);
      if(h == 0.)
        continue;
      const double c = d[i] / h, s = d[i + 1] / h;
      d[i] = h;
      d[i + 1] = 0.;
      rotate_columns(i, c, s);
    }
    m_R.col(q).head(q + 1) = d.head(q + 1);
    m_active.push_back(p);
  }

  void drop(int l)
  {
    const int q = static_cast<int>(m_active.size());
    m_active.erase(m_active.begin() + l);
    m_multipliers.erase(m_multipliers.begin() + l);
    for(int j = l; j + 1 < q; ++j)
      m_R.col(j) = m_R.col(j + 1);
    m_R.col(q - 1).setZero();
    for(int i = l; i + 1 < q; ++i)
    {
      const double h = std::hypot(m_R(i, i), m_R(i + 1, i));
      if(h == 0.)
        continue;
      const double c = m_R(i, i) / h, s = m_R(i + 1, i) / h;
      for(int j = i; j + 1 < q; ++j)
      {
        const double u = m_R(i, j), v = m_R(i + 1, j);
        m_R(i, j) = c * u + s * v;
        m_R(i + 1, j) = c * v - s * u;
      }
      m_R(i + 1, i) = 0.;
      rotate_columns(i, c, s);
    }
  }

  const Eigen::MatrixXd& m_inverse_factor;
  const Eigen::VectorXd& m_target;
  int m_size;
  Eigen::MatrixXd m_J, m_R;
  std::vector<int> m_active;
  std::vector<double> m_multipliers;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DUAL_ACTIVE_SET_H
