// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONVEX_QUADRATIC_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONVEX_QUADRATIC_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Bounded_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dual_active_set.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// E(y) = 1/2 y'Sy - c'y + constant with a positive semidefinite S, and its minimum under linear constraints.
//
// S may be a Schur complement: what is small against the diagonal before, the reference, is round-off.
//
// Let D be the root of the diagonal of S. The eigenvectors N of D^-1 S D^-1 whose eigenvalues are round-off are the
// flat directions: there the energy is linear. If there are none, the dual active-set method solves a problem at
// once. Else it solves, one after the other, problems with the additional term delta/2 |N'D (y - y_previous)|^2: the
// proximal point method (Rockafellar 1976) in these directions only. Where the energy has a minimum it arrives after
// a few steps, since the constraints that hold it are polyhedral.
class Convex_quadratic
{
public:
  Convex_quadratic(const Eigen::MatrixXd& S, const Eigen::VectorXd& c, double constant,
                   const Eigen::VectorXd& reference)
    : m_S(S), m_c(c), m_constant(constant), m_reference(reference), m_scale(scale_of(S, reference))
  {
    const int n = static_cast<int>(S.rows());
    const double flat_eigenvalue = 1e-11; // relative to one; what a Schur complement leaves of zeros is smaller
    // A linear term that is shorter in the flat directions, relative to its length, is round-off.
    const double flat_slope = 1e-9;

    const Eigen::VectorXd inverse_scale = m_scale.cwiseInverse();
    const Eigen::MatrixXd C = inverse_scale.asDiagonal() * S * inverse_scale.asDiagonal();
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
    if(n > 0)
      eigen.compute(C);
    m_eigenvalues = n > 0 ? Eigen::VectorXd(eigen.eigenvalues()) : Eigen::VectorXd(0);
    m_eigenvectors = n > 0 ? Eigen::MatrixXd(eigen.eigenvectors()) : Eigen::MatrixXd(0, 0);
    m_is_convex = n == 0 || m_eigenvalues.minCoeff() > -flat_eigenvalue * n;
    while(m_flat < n && m_eigenvalues[m_flat] <= flat_eigenvalue * n)
      ++m_flat;
    // Eigenvalues ascend: the flat directions come first.
    Eigen::VectorXd slope = m_eigenvectors.transpose() * (inverse_scale.asDiagonal() * m_c);
    m_has_slope = m_flat > 0 && slope.head(m_flat).norm() > flat_slope * slope.norm();
    if(!m_has_slope)
      slope.head(m_flat).setZero();
    m_slope = slope;
    set_proximity(first_proximity);
    m_center = compute_target();
    m_center_energy = m_center.dot(0.5 * (m_S * m_center) - m_c) + m_constant;
    m_center_gradient = m_has_slope ? Eigen::VectorXd(m_S * m_center - m_c) : Eigen::VectorXd::Zero(n);
  }

  // The root of the diagonal, or where it is round-off of the reference.
  static Eigen::VectorXd scale_of(const Eigen::MatrixXd& S, const Eigen::VectorXd& reference)
  {
    const double round_off = 1e-13;
    const double largest = reference.size() > 0 ? reference.maxCoeff() : 0.;
    Eigen::VectorXd scale(S.rows());
    for(int i = 0; i < scale.size(); ++i)
      scale[i] = S(i, i) > round_off * reference[i] ? std::sqrt(S(i, i))
                 : reference[i] > 0.                ? std::sqrt(reference[i])
                 : largest > 0.                     ? std::sqrt(largest)
                                                    : 1.;
    return scale;
  }

  const Eigen::VectorXd& reference() const { return m_reference; }
  int size() const { return static_cast<int>(m_c.size()); }
  const Eigen::MatrixXd& matrix() const { return m_S; }
  const Eigen::VectorXd& linear_term() const { return m_c; }
  double constant() const { return m_constant; }

  bool is_convex() const { return m_is_convex; }
  bool is_definite() const { return m_flat == 0; }
  // Whether the energy falls along a flat direction, constraints aside.
  bool has_slope() const { return m_has_slope; }

  // Computed from the minimum without constraints, for the differences that count to be accurate.
  double energy(const Eigen::VectorXd& y) const
  {
    const Eigen::VectorXd d = y - m_center;
    return m_center_energy + d.dot(0.5 * (m_S * d) + m_center_gradient);
  }

  // The size of the numbers in the energy: it carries round-off relative to this.
  double magnitude() const { return 1. + std::fabs(m_constant) + std::fabs(m_center_energy - m_constant); }

  // The minimum without constraints; in the flat directions it stays at zero.
  const Eigen::VectorXd& target() const { return m_center; }

private:
  Eigen::VectorXd compute_target() const
  {
    Eigen::VectorXd t = Eigen::VectorXd::Zero(size());
    t.tail(size() - m_flat) = m_slope.tail(size() - m_flat).cwiseQuotient(m_eigenvalues.tail(size() - m_flat));
    Eigen::VectorXd y = m_scale.cwiseInverse().asDiagonal() * (m_eigenvectors * t);
    // One step of iterative refinement: targets that are integers should look like integers.
    Eigen::VectorXd r = m_eigenvectors.transpose() * (m_scale.cwiseInverse().asDiagonal() * (m_c - m_S * y));
    r.head(m_flat).setZero();
    r.tail(size() - m_flat) = r.tail(size() - m_flat).cwiseQuotient(m_eigenvalues.tail(size() - m_flat));
    y += m_scale.cwiseInverse().asDiagonal() * (m_eigenvectors * r);
    return y;
  }

public:
  // The diagonal of the inverse of S, which is definite.
  Eigen::VectorXd inverse_diagonal() const
  {
    return (m_scale.cwiseInverse().asDiagonal() * m_eigenvectors *
            m_eigenvalues.cwiseSqrt().cwiseInverse().asDiagonal())
      .rowwise()
      .squaredNorm();
  }

  // A solution for S x = b, up to the flat directions.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const
  {
    Eigen::VectorXd r = m_eigenvectors.transpose() * (m_scale.cwiseInverse().asDiagonal() * b);
    r.head(m_flat).setZero();
    r.tail(size() - m_flat) = r.tail(size() - m_flat).cwiseQuotient(m_eigenvalues.tail(size() - m_flat));
    return m_scale.cwiseInverse().asDiagonal() * (m_eigenvectors * r);
  }

  // What moving one variable alone by one costs at least.
  Eigen::VectorXd step_costs() const { return 0.5 * m_J.rowwise().squaredNorm().cwiseInverse(); }

  struct Minimum
  {
    bool is_feasible = false;
    bool is_exact = false; // up to round-off; else the energy is no lower bound
    Eigen::VectorXd y;
    double energy = 0.;
  };

  // Minimizes the energy under constraints.
  Minimum minimize(const std::vector<Dual_active_set::Constraint>& constraints)
  {
    Minimum result;
    if(m_flat == 0)
    {
      double cost = 0.;
      result.is_feasible = Dual_active_set(m_J, m_center).solve(constraints, result.y, cost);
      result.is_exact = true;
      result.energy = m_center_energy + cost;
      return result;
    }
    const int maximum_steps = 60, steps_until_weaker = 4;
    const double proximity_factor = 0.1, last_proximity = 1e-9;
    const double converged = 1e-10; // step, relative to one and to the coordinates
    set_proximity(first_proximity);
    Eigen::VectorXd previous = Eigen::VectorXd::Zero(m_flat);
    for(int step = 0; step < maximum_steps && !result.is_exact; ++step)
    {
      if(step % steps_until_weaker == steps_until_weaker - 1 && m_proximity > last_proximity)
        set_proximity(proximity_factor * m_proximity);
      Eigen::VectorXd t = m_slope;
      t.head(m_flat) = t.head(m_flat) / m_proximity + previous;
      t.tail(size() - m_flat) = t.tail(size() - m_flat).cwiseQuotient(m_eigenvalues.tail(size() - m_flat));
      const Eigen::VectorXd center = m_scale.cwiseInverse().asDiagonal() * (m_eigenvectors * t);
      double cost;
      result.is_feasible = Dual_active_set(m_J, center).solve(constraints, result.y, cost);
      if(!result.is_feasible)
        return result;
      const Eigen::VectorXd next = m_eigenvectors.leftCols(m_flat).transpose() * (m_scale.asDiagonal() * result.y);
      result.is_exact =
        (next - previous).lpNorm<Eigen::Infinity>() <= converged * (1. + next.lpNorm<Eigen::Infinity>());
      previous = next;
    }
    result.energy = energy(result.y);
    return result;
  }

private:
  // Relative to the curvature of the other directions, which is about one: large enough for well-conditioned systems.
  static constexpr double first_proximity = 1e-4;

  void set_proximity(double delta)
  {
    if(m_flat == 0 && m_J.size() > 0)
      return;
    m_proximity = delta;
    Eigen::VectorXd curvature = m_eigenvalues;
    curvature.head(m_flat).setConstant(delta);
    m_J = m_scale.cwiseInverse().asDiagonal() * m_eigenvectors * curvature.cwiseSqrt().cwiseInverse().asDiagonal();
  }

  Eigen::MatrixXd m_S;
  Eigen::VectorXd m_c;
  double m_constant;
  Eigen::VectorXd m_reference;
  Eigen::VectorXd m_scale;       // D
  Eigen::VectorXd m_eigenvalues; // of D^-1 S D^-1, ascending
  Eigen::MatrixXd m_eigenvectors;
  Eigen::VectorXd m_slope; // D^-1 c in the basis of eigenvectors
  int m_flat = 0;          // the number of flat directions
  bool m_is_convex = false, m_has_slope = false;
  double m_proximity = 0.;
  Eigen::MatrixXd m_J; // J J' is the inverse of S, with delta in the flat directions
  Eigen::VectorXd m_center, m_center_gradient;
  double m_center_energy = 0.;
};

// The best real variables for the integer variables of `y`, which are integers: a problem over the real ones alone.
// Whether it is feasible does not tell about the constraints without real variables.
inline Convex_quadratic::Minimum complete_reals(const Bounded_problem& problem, const Convex_quadratic& quadratic,
                                                const Eigen::VectorXd& y)
{
  Convex_quadratic::Minimum result;
  result.y = y;
  std::vector<int> reals;
  std::vector<int> position(problem.size(), -1);
  for(int i = 0; i < problem.size(); ++i)
    if(!problem.is_integer[i])
    {
      position[i] = static_cast<int>(reals.size());
      reals.push_back(i);
      result.y[i] = 0.;
    }
  const int n = static_cast<int>(reals.size());
  if(n == 0)
  {
    result.is_feasible = result.is_exact = true;
    result.energy = quadratic.energy(y);
    return result;
  }
  const Eigen::VectorXd slope = quadratic.linear_term() - quadratic.matrix() * result.y;
  Eigen::MatrixXd S(n, n);
  Eigen::VectorXd c(n), reference(n);
  std::vector<Dual_active_set::Constraint> constraints;
  for(int k = 0; k < n; ++k)
  {
    const int i = reals[k];
    c[k] = slope[i];
    reference[k] = quadratic.reference()[i];
    for(int l = 0; l < n; ++l)
      S(k, l) = quadratic.matrix()(i, reals[l]);
    if(problem.has_lower(i))
      constraints.push_back(Dual_active_set::Constraint{ Eigen::VectorXd::Unit(n, k), problem.lower[i] });
    if(problem.has_upper(i))
      constraints.push_back(Dual_active_set::Constraint{ -Eigen::VectorXd::Unit(n, k), -problem.upper[i] });
  }
  for(const Bounded_problem::Row& row : problem.rows)
  {
    Dual_active_set::Constraint constraint{ Eigen::VectorXd::Zero(n), 0. };
    Bounded_problem::Rational rhs = row.rhs;
    for(const std::pair<int, Bounded_problem::Rational>& a : row.form)
      if(position[a.first] >= 0)
        constraint.a[position[a.first]] = -CGAL::to_double(a.second);
      else
        rhs -= a.second * Bounded_problem::Rational(y[a.first]);
    constraint.b = -CGAL::to_double(rhs);
    if(!constraint.a.isZero(0.))
      constraints.push_back(constraint);
  }
  const Convex_quadratic::Minimum of_reals = Convex_quadratic(S, c, 0., reference).minimize(constraints);
  result.is_feasible = of_reals.is_feasible;
  result.is_exact = of_reals.is_exact;
  if(result.is_feasible)
  {
    for(int k = 0; k < n; ++k)
      result.y[reals[k]] = of_reals.y[k];
    result.energy = quadratic.energy(result.y);
  }
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONVEX_QUADRATIC_H
