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
#include <CGAL/Quad_meshing/Mixed_integer/internal/Convex_quadratic.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dual_active_set.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Elimination_number.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Exact_dual_simplex.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A convex objective over the variables of a `Bounded_problem`, given to linear programs as tangent planes ([Bom12,
// 4.2], extension to nonlinear problems): either linear, c'y + constant, or quadratic. In linear programs a quadratic
// objective is one more variable, eta, after those of the problem, that lies above all tangent planes.
class Linear_master
{
public:
  typedef CGAL::Exact_rational Rational;

  // A linear objective. Missing bounds of variables are replaced by the artificial ones -`box` and `box`.
  Linear_master(const Bounded_problem& problem, const Eigen::VectorXd& c, double constant, const Rational& box)
    : m_problem(problem), m_linear(c), m_constant(constant), m_box(box)
  {
  }

  // A quadratic objective. `radius` bounds the energy over its minimum of the points that matter, `least_energy` is a
  // lower bound.
  Linear_master(const Bounded_problem& problem, Convex_quadratic& quadratic, double radius, double least_energy,
                const Rational& box)
    : m_problem(problem)
    , m_quadratic(&quadratic)
    , m_constant(quadratic.constant())
    , m_radius(radius)
    , m_least_energy(least_energy)
    , m_box(box)
  {
  }

  bool is_linear() const { return m_quadratic == nullptr; }
  const Bounded_problem& problem() const { return m_problem; }

  double energy(const Eigen::VectorXd& y) const
  {
    return is_linear() ? m_linear.dot(y) + m_constant : m_quadratic->energy(y);
  }

  // Round-off of energies is relative to this.
  double magnitude() const { return is_linear() ? 1. : m_quadratic->magnitude(); }

  // Whether all variables are integers and so are the values of a linear objective, up to its constant.
  bool has_integer_objective() const
  {
    if(!is_linear())
      return false;
    for(int i = 0; i < m_problem.size(); ++i)
      if(!m_problem.is_integer[i] || std::floor(m_linear[i]) != m_linear[i])
        return false;
    return true;
  }

  // The relaxation, without tangent planes.
  Exact_dual_simplex make_program() const
  {
    typedef Exact_dual_simplex::Bound Bound;
    const int n = m_problem.size();
    std::vector<Rational> objective;
    std::vector<Bound> lower, upper;
    std::vector<char> is_integer = m_problem.is_integer;
    // |y_i - y*_i| <= sqrt(2 radius (S^-1)_ii) where the energy is that small; rounded outwards.
    Eigen::VectorXd reach;
    if(!is_linear() && m_quadratic->is_definite() && m_radius < std::numeric_limits<double>::infinity())
      reach = (2. * m_radius * m_quadratic->inverse_diagonal()).cwiseSqrt();
    for(int i = 0; i < n; ++i)
    {
      objective.push_back(is_linear() ? Rational(m_linear[i]) : Rational(0));
      Bound low{ -m_box, true }, high{ m_box, true };
      if(reach.size() > 0)
      {
        const double r = std::ceil(reach[i] * (1. + 1e-9)) + 1., center = std::floor(m_quadratic->target()[i] + 0.5);
        low = Bound{ Rational(center - r), false };
        high = Bound{ Rational(center + r), false };
      }
      if(m_problem.has_lower(i) && (low.is_artificial || m_problem.exact_lower[i] > low.value))
        low = Bound{ m_problem.exact_lower[i], false };
      if(m_problem.has_upper(i) && (high.is_artificial || m_problem.exact_upper[i] < high.value))
        high = Bound{ m_problem.exact_upper[i], false };
      // An artificial bound on the wrong side of a real one moves away from it.
      if(low.is_artificial && high.value < Rational(0))
        low.value += high.value;
      if(high.is_artificial && low.value > Rational(0))
        high.value += low.value;
      if(m_problem.is_integer[i] && low.is_artificial)
        low.value = Rational(Elimination_number<Rational>::floor(low.value));
      if(m_problem.is_integer[i] && high.is_artificial)
        high.value = Rational(Elimination_number<Rational>::floor(high.value));
      if(high.value < low.value) // no point is near enough: the program finds that out by itself
        high.value = low.value;
      lower.push_back(low);
      upper.push_back(high);
    }
    if(!is_linear())
    {
      objective.push_back(Rational(1));
      const bool is_bounded = m_least_energy > -std::numeric_limits<double>::infinity();
      lower.push_back(is_bounded ? Bound{ Rational(std::floor(m_least_energy) - 1.), false }
                                 : Bound{ -m_box * m_box, true });
      upper.push_back(Bound{ lower.back().value + m_box * m_box, true });
      is_integer.push_back(0);
    }
    Exact_dual_simplex program(objective, lower, upper, is_integer);
    for(const Bounded_problem::Row& row : m_problem.rows)
    {
      std::vector<Rational> a(objective.size(), Rational(0));
      for(const std::pair<int, Rational>& e : row.form)
        a[e.first] = e.second;
      program.add_constraint(a, row.rhs, row.is_integral);
    }
    return program;
  }

  // The plane that touches the energy near `y`. It never cuts a point off: its numbers are those of a point rounded
  // for short rationals, or its slope is rounded and its height is rounded down.
  void tangent(const Eigen::VectorXd& y, std::vector<Rational>& a, Rational& b) const
  {
    const double grid = 1. / 65536.; // 2^-16, of a coordinate or of the largest slope
    const double relative_round_off = 1e-12;
    const Eigen::MatrixXd& S = m_quadratic->matrix();
    const Eigen::VectorXd& c = m_quadratic->linear_term();
    a.clear();
    if(m_quadratic->is_definite())
    {
      Eigen::VectorXd slope = S * (y - m_quadratic->target());
      const double scale = std::exp2(std::ceil(std::log2((std::max)(1., slope.cwiseAbs().maxCoeff()))));
      slope = (slope / (grid * scale)).array().round() * (grid * scale);
      const double base = m_quadratic->energy(m_quadratic->target());
      const double height = base - 0.5 * slope.dot(m_quadratic->solve(slope)) - slope.dot(m_quadratic->target());
      const double round_off =
        relative_round_off * (m_quadratic->magnitude() + std::fabs(slope.dot(m_quadratic->target())));
      // eta >= height + slope'y, as slope'y - eta <= -height
      for(int i = 0; i < slope.size(); ++i)
        a.push_back(Rational(slope[i]));
      const double height_grid = grid * grid * scale;
      b = -Rational(std::floor((height - round_off) / height_grid) * height_grid);
    }
    else
    {
      const Eigen::VectorXd p = (y / grid).array().round() * grid;
      std::vector<Rational> at;
      for(int i = 0; i < p.size(); ++i)
        at.push_back(Rational(p[i]));
      // E(y) >= E(p) + (Sp - c)'(y - p) = slope'y + constant - 1/2 p'Sp
      Rational curved(0);
      for(int i = 0; i < p.size(); ++i)
      {
        Rational sum(0);
        for(int j = 0; j < p.size(); ++j)
          sum += Rational(S(i, j)) * at[j];
        curved += sum * at[i];
        a.push_back(sum - Rational(c[i]));
      }
      b = curved / Rational(2) - Rational(m_constant) + Rational(relative_round_off * m_quadratic->magnitude());
    }
    a.push_back(Rational(-1));
  }

  // The minimum of a quadratic objective between other bounds, integer conditions aside.
  Convex_quadratic::Minimum relax(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) const
  {
    std::vector<Dual_active_set::Constraint> constraints;
    if(!make_constraints(m_problem, lower, upper, constraints))
      return Convex_quadratic::Minimum();
    return m_quadratic->minimize(constraints);
  }

  // The best point with the integers of `y`, rounded. Returns false if there is none.
  bool polish(const Eigen::VectorXd& y, Eigen::VectorXd& polished, double& value) const
  {
    polished = y;
    for(int i = 0; i < m_problem.size(); ++i)
      if(m_problem.is_integer[i])
        polished[i] = std::floor(y[i] + 0.5);
    if(!is_linear())
    {
      const Convex_quadratic::Minimum minimum = complete_reals(m_problem, *m_quadratic, polished);
      if(!minimum.is_feasible)
        return false;
      polished = minimum.y;
    }
    value = energy(polished);
    return m_problem.is_met_by(polished);
  }

private:
  const Bounded_problem& m_problem;
  Convex_quadratic* m_quadratic = nullptr;
  Eigen::VectorXd m_linear;
  double m_constant;
  double m_radius = std::numeric_limits<double>::infinity();
  double m_least_energy = -std::numeric_limits<double>::infinity();
  Rational m_box;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LINEAR_MASTER_H
