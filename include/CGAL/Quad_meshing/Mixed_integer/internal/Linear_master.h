// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LINEAR_MASTER_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LINEAR_MASTER_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Bounded_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dual_active_set.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Exact_dual_simplex.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A convex objective over the variables of a `Bounded_problem`, given to linear programs as tangent planes
// (thesis 4.2, extension to nonlinear problems): either linear, c'y + constant, or quadratic,
// E(y) = 1/2 (y - y*)' S (y - y*) + constant. In linear programs a quadratic objective is one more variable, eta,
// after those of the problem, that lies above all tangent planes.
class Linear_master
{
public:
  typedef CGAL::Exact_rational Rational;

  // A linear objective.
  Linear_master(const Bounded_problem& problem, const Eigen::VectorXd& c, double constant)
    : m_problem(problem), m_is_linear(true), m_linear(c), m_constant(constant)
  {}

  // A quadratic objective. `radius` bounds the energy over its minimum of the points that matter.
  Linear_master(const Bounded_problem& problem, const Eigen::MatrixXd& S, const Eigen::VectorXd& target,
                double constant, double radius)
    : m_problem(problem), m_is_linear(false), m_constant(constant), m_S(S), m_target(target), m_cholesky(S)
    , m_radius(radius)
  {
    const Eigen::MatrixXd L = m_cholesky.matrixL();
    m_inverse_factor = L.triangularView<Eigen::Lower>().solve(
      Eigen::MatrixXd::Identity(S.rows(), S.cols())).transpose();
  }

  bool is_linear() const { return m_is_linear; }
  const Bounded_problem& problem() const { return m_problem; }

  double energy(const Eigen::VectorXd& y) const
  {
    if(m_is_linear)
      return m_linear.dot(y) + m_constant;
    const Eigen::VectorXd d = y - m_target;
    return m_constant + 0.5 * d.dot(m_S * d);
  }

  // Whether all variables are integers and so are the values of a linear objective, up to its constant.
  bool has_integer_objective() const
  {
    if(!m_is_linear)
      return false;
    for(int i = 0; i < m_problem.size(); ++i)
      if(!m_problem.is_integer[i] || std::floor(m_linear[i]) != m_linear[i])
        return false;
    return true;
  }

  // Whether y lies at a bound that stands in for a missing one.
  bool is_at_artificial_bound(const Eigen::VectorXd& y) const
  {
    if(!m_is_linear)
      return false;
    for(int i = 0; i < m_problem.size(); ++i)
      if(std::fabs(y[i]) >= artificial_bound && m_linear[i] != 0.)
        return true;
    return false;
  }

  // The relaxation, without tangent planes.
  Exact_dual_simplex make_program() const
  {
    const int n = m_problem.size();
    std::vector<Rational> objective, lower, upper;
    std::vector<char> is_integer = m_problem.is_integer;
    for(int i = 0; i < n; ++i)
    {
      objective.push_back(m_is_linear ? Rational(m_linear[i]) : Rational(0));
      double reach = artificial_bound, center = 0.;
      if(!m_is_linear && m_radius < std::numeric_limits<double>::infinity())
      {
        // |y_i - y*_i| <= sqrt(2 radius (S^-1)_ii) where the energy is that small; rounded outwards.
        reach = std::ceil(std::sqrt(2. * m_radius) * m_inverse_factor.row(i).norm() * (1. + 1e-9)) + 1.;
        center = std::floor(m_target[i] + 0.5);
      }
      lower.push_back(Rational((std::max)(m_problem.lower[i], center - reach)));
      upper.push_back(Rational((std::min)(m_problem.upper[i], center + reach)));
      if(upper.back() < lower.back())
        upper.back() = lower.back();
    }
    if(!m_is_linear)
    {
      objective.push_back(Rational(1));
      lower.push_back(Rational(std::floor(m_constant) - 1.));
      upper.push_back(Rational(artificial_energy));
      is_integer.push_back(0);
    }
    Exact_dual_simplex program(objective, lower, upper, is_integer);
    for(int r = 0; r < m_problem.G.rows(); ++r)
      add_row(program, r);
    return program;
  }

  // The plane that touches the energy near `y`. Its slope is rounded, for short rationals, and its height rounded
  // down: it never cuts a point off.
  void tangent(const Eigen::VectorXd& y, std::vector<Rational>& a, Rational& b) const
  {
    const double grid = 1. / 65536.; // 2^-16, of the largest slope
    Eigen::VectorXd slope = m_S * (y - m_target);
    const double scale = std::exp2(std::ceil(std::log2((std::max)(1., slope.cwiseAbs().maxCoeff()))));
    slope = (slope / (grid * scale)).array().round() * (grid * scale);
    const double height = m_constant - 0.5 * slope.dot(m_cholesky.solve(slope)) - slope.dot(m_target);
    const double round_off = 1e-12 * (std::fabs(m_constant) + std::fabs(slope.dot(m_target)) + 1.);
    // eta >= height + slope'y, as slope'y - eta <= -height
    a.clear();
    for(int i = 0; i < slope.size(); ++i)
      a.push_back(Rational(slope[i]));
    a.push_back(Rational(-1));
    const double height_grid = grid * grid * scale;
    b = -Rational(std::floor((height - round_off) / height_grid) * height_grid);
  }

  // The minimum of a quadratic objective between other bounds, integer conditions aside. Returns false if there
  // is no such point.
  bool relax(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, Eigen::VectorXd& y, double& value) const
  {
    std::vector<Dual_active_set::Constraint> constraints;
    if(!make_constraints(m_problem, lower, upper, constraints))
      return false;
    Dual_active_set quadratic(m_inverse_factor, m_target);
    if(!quadratic.solve(constraints, y, value))
      return false;
    value += m_constant;
    return true;
  }

  // The best point with the integers of `y`, rounded. Returns false if there is none.
  bool polish(const Eigen::VectorXd& y, Eigen::VectorXd& polished, double& value) const
  {
    Eigen::VectorXd lower = m_problem.lower, upper = m_problem.upper, rounded = y;
    for(int i = 0; i < m_problem.size(); ++i)
      if(m_problem.is_integer[i])
        rounded[i] = lower[i] = upper[i] = std::floor(y[i] + 0.5);
    polished = rounded;
    if(!m_is_linear)
    {
      if(!relax(lower, upper, polished, value))
        return false;
      for(int i = 0; i < m_problem.size(); ++i)
        if(m_problem.is_integer[i])
          polished[i] = rounded[i];
    }
    value = energy(polished);
    return true;
  }

private:
  // Stand-ins for missing bounds. Solutions of linear programs that reach them are unbounded.
  static constexpr double artificial_bound = 1048576.;       // 2^20
  static constexpr double artificial_energy = 1099511627776.; // 2^40

  void add_row(Exact_dual_simplex& program, int r) const
  {
    const double tolerance = 1e-9; // of a constraint of integers, relative to one and to its right-hand side
    std::vector<Rational> a;
    bool is_integral = true;
    double factor = 1.;
    // Powers of two that make the coefficients integers do not change the constraint.
    const double largest_factor = 1048576.;
    for(; factor <= largest_factor; factor *= 2.)
    {
      is_integral = true;
      for(int i = 0; i < m_problem.size(); ++i)
        is_integral = is_integral && (m_problem.G(r, i) == 0. ||
          (m_problem.is_integer[i] && std::floor(m_problem.G(r, i) * factor) == m_problem.G(r, i) * factor));
      if(is_integral)
        break;
    }
    if(!is_integral)
      factor = 1.;
    for(int i = 0; i < m_problem.size(); ++i)
      a.push_back(Rational(m_problem.G(r, i) * factor));
    double b = m_problem.h[r] * factor;
    if(is_integral)
      b = std::floor(b + tolerance * (std::max)(1., std::fabs(b)));
    if(!m_is_linear)
      a.push_back(Rational(0));
    program.add_constraint(a, Rational(b), is_integral);
  }

  const Bounded_problem& m_problem;
  bool m_is_linear;
  Eigen::VectorXd m_linear;
  double m_constant;
  Eigen::MatrixXd m_S;
  Eigen::VectorXd m_target;
  Eigen::LLT<Eigen::MatrixXd> m_cholesky;
  Eigen::MatrixXd m_inverse_factor;
  double m_radius = std::numeric_limits<double>::infinity();
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LINEAR_MASTER_H
