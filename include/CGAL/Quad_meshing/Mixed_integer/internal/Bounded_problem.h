// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BOUNDED_PROBLEM_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BOUNDED_PROBLEM_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Constraint_row.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dual_active_set.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Eliminated_constraints.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Elimination_number.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The inequality constraints and bounds of a problem over its free variables. `kept` lists the free variables that
// are integers or occur in a constraint or bound, ascending: only they matter to a search; all indices below
// are positions in `kept`.
struct Bounded_problem
{
  typedef CGAL::Exact_rational Rational;

  // form'y <= rhs
  struct Row
  {
    std::vector<std::pair<int, Rational>> form;
    Rational rhs;
    bool is_integral; // integers times integer variables
  };

  std::vector<int> kept;
  std::vector<char> is_integer;
  std::vector<Row> rows;
  Eigen::MatrixXd G; // the rows, G y <= h
  Eigen::VectorXd h;
  Eigen::VectorXd lower, upper;
  std::vector<Rational> exact_lower, exact_upper; // where there are bounds
  bool is_infeasible = false;                     // a bound or constraint on a constant is violated

  int size() const { return static_cast<int>(kept.size()); }

  bool has_lower(int i) const { return lower[i] > -std::numeric_limits<double>::infinity(); }
  bool has_upper(int i) const { return upper[i] < std::numeric_limits<double>::infinity(); }

  // The problem where all variables but some are zero.
  Bounded_problem restricted(const std::vector<int>& variables) const
  {
    Bounded_problem result;
    std::vector<int> position(size(), -1);
    const int n = static_cast<int>(variables.size());
    result.lower.resize(n);
    result.upper.resize(n);
    result.G.resize(G.rows(), n);
    result.h = h;
    for(int i = 0; i < n; ++i)
    {
      const int v = variables[i];
      position[v] = i;
      result.kept.push_back(kept[v]);
      result.is_integer.push_back(is_integer[v]);
      result.lower[i] = lower[v];
      result.upper[i] = upper[v];
      result.exact_lower.push_back(exact_lower[v]);
      result.exact_upper.push_back(exact_upper[v]);
      result.G.col(i) = G.col(v);
    }
    for(const Row& row : rows)
    {
      result.rows.push_back(Row{ {}, row.rhs, row.is_integral });
      for(const std::pair<int, Rational>& a : row.form)
        if(position[a.first] >= 0)
          result.rows.back().form.emplace_back(position[a.first], a.second);
    }
    return result;
  }

  // Whether a constraint has a real variable or coefficient.
  bool has_real_rows() const
  {
    return std::any_of(rows.begin(), rows.end(), [](const Row& row) { return !row.is_integral; });
  }

  // Whether a point whose integer variables are integers meets all constraints and bounds: exactly where they ask for
  // integers, and up to what the rounding of real numbers explains elsewhere.
  bool is_met_by(const Eigen::VectorXd& y) const
  {
    const double round_off = 1e-9; // relative to one and to the numbers that are compared
    for(int i = 0; i < size(); ++i)
    {
      const double allowed = is_integer[i] ? 0. : round_off * (std::max)(1., std::fabs(y[i]));
      if(!(y[i] >= lower[i] - allowed && y[i] <= upper[i] + allowed))
        return false;
    }
    for(const Row& row : rows)
    {
      Rational value = -row.rhs;
      double magnitude = (std::max)(1., std::fabs(CGAL::to_double(row.rhs)));
      for(const std::pair<int, Rational>& a : row.form)
      {
        const Rational term = a.second * Rational(y[a.first]);
        value += term;
        magnitude = (std::max)(magnitude, std::fabs(CGAL::to_double(term)));
      }
      if(CGAL::is_positive(value) && (row.is_integral || CGAL::to_double(value) > round_off * magnitude))
        return false;
    }
    return true;
  }
};

// The inequalities of a problem and bounds that may be tighter than its own. Returns false if a lower bound exceeds
// an upper one.
inline bool make_constraints(const Bounded_problem& problem, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                             std::vector<Dual_active_set::Constraint>& constraints)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const int n = problem.size();
  for(int i = 0; i < n; ++i)
  {
    if(lower[i] > upper[i])
      return false;
    if(lower[i] > -infinity)
      constraints.push_back(Dual_active_set::Constraint{ Eigen::VectorXd::Unit(n, i), lower[i] });
    if(upper[i] < infinity)
      constraints.push_back(Dual_active_set::Constraint{ -Eigen::VectorXd::Unit(n, i), -upper[i] });
  }
  for(int r = 0; r < problem.G.rows(); ++r)
    constraints.push_back(Dual_active_set::Constraint{ -problem.G.row(r).transpose(), -problem.h[r] });
  return true;
}

// Makes a `Bounded_problem` of a problem whose equality constraints were eliminated exactly.
class Bounded_problem_builder
{
  typedef CGAL::Exact_rational Rational;
  typedef Elimination_number<Rational> Number;
  typedef Bounded_problem::Row Row;

public:
  Bounded_problem_builder(const Mixed_integer_problem& problem, const Eliminated_constraints& constraints)
    : m_problem(problem), m_constraints(constraints)
  {
  }

  Bounded_problem run()
  {
    const double infinity = std::numeric_limits<double>::infinity();
    const int m = static_cast<int>(m_constraints.is_integer.size());
    m_lower.assign(m, Bound());
    m_upper.assign(m, Bound());
    for(const Mixed_integer_problem::Linear_constraint& c : m_problem.inequality_constraints())
      add(c.form, Rational(c.rhs), 1);
    for(int v = 0; v < m_problem.number_of_variables(); ++v)
    {
      const double low = m_problem.lower_bound(v), high = m_problem.upper_bound(v);
      m_result.is_infeasible = m_result.is_infeasible || low == infinity || high == -infinity;
      if(high < infinity && high > -infinity)
        add({ { v, 1. } }, Rational(high), 1);
      if(low > -infinity && low < infinity)
        add({ { v, 1. } }, Rational(low), -1);
    }
    collect();
    return m_result;
  }

private:
  struct Bound
  {
    bool exists = false;
    Rational value;
  };

  // Adds sign * form <= sign * rhs.
  void add(const Mixed_integer_problem::Linear_form& form, const Rational& rhs, int sign)
  {
    // What real coefficients leave when they cancel, relative to what cancels.
    const double noise = 1e-12;
    std::map<int, Rational> sum;
    std::map<int, double> magnitude;
    Row row;
    row.rhs = Rational(sign) * rhs;
    for(const std::pair<int, double>& a : form)
    {
      const Rational coefficient = Rational(sign) * Rational(a.second);
      row.rhs -= coefficient * m_constraints.exact_t[a.first];
      for(const std::pair<int, Rational>& e : m_constraints.exact_T[a.first])
      {
        const Rational term = coefficient * e.second;
        sum[e.first] += term;
        magnitude[e.first] = (std::max)(magnitude[e.first], std::fabs(CGAL::to_double(term)));
      }
    }
    bool has_integers_only = true;
    for(const std::pair<const int, Rational>& e : sum)
      if(std::fabs(CGAL::to_double(e.second)) > noise * magnitude[e.first])
      {
        row.form.push_back(e);
        has_integers_only = has_integers_only && m_constraints.is_integer[e.first];
      }
    row.is_integral = has_integers_only && make_integral(row);
    if(row.form.empty())
      m_result.is_infeasible = m_result.is_infeasible || is_negative(row);
    else if(row.form.size() == 1)
      add_bound(row);
    else
      m_result.rows.push_back(row);
  }

  static bool is_negative(const Row& row)
  {
    const double tolerance = 1e-9;
    return row.is_integral ? CGAL::is_negative(row.rhs) : CGAL::to_double(row.rhs) < -tolerance;
  }

  // Scales a row over integer variables to integers without a common divisor, and rounds its right-hand side down.
  // Coefficients that doubles hold only up to round-off, as those of 0.1 x + 0.2 y <= 0.3, are taken for the
  // fractions that they stand for.
  static bool make_integral(Row& row)
  {
    const Rational largest_denominator(1048576.);
    const double round_off = 1e-9; // of a right-hand side, relative to one and to its size
    Rational factor(1);
    for(const std::pair<int, Rational>& a : row.form)
      factor = factor * Rational(Number::denominator(a.second * factor));
    if(factor <= largest_denominator)
    {
      for(std::pair<int, Rational>& a : row.form)
        a.second = a.second * factor;
      row.rhs = row.rhs * factor;
    }
    else
    {
      Mixed_integer_problem::Linear_form form;
      for(const std::pair<int, Rational>& a : row.form)
        form.emplace_back(a.first, CGAL::to_double(a.second));
      const Integral_factor f = integral_factor(form);
      if(f.factor == 0.)
        return false;
      for(std::pair<int, Rational>& a : row.form)
        a.second = Number::nearest_integer(a.second * Rational(f.factor));
      row.rhs = row.rhs * Rational(f.factor);
      const Rational nearest = Number::nearest_integer(row.rhs);
      if(std::fabs(CGAL::to_double(row.rhs - nearest)) <=
         round_off * (std::max)(1., std::fabs(CGAL::to_double(nearest))))
        row.rhs = nearest;
    }
    Rational divisor(0);
    for(const std::pair<int, Rational>& a : row.form)
      divisor = Number::gcd(divisor, a.second);
    if(!CGAL::is_zero(divisor))
    {
      for(std::pair<int, Rational>& a : row.form)
        a.second = a.second / divisor;
      row.rhs = row.rhs / divisor;
    }
    row.rhs = Rational(Number::floor(row.rhs));
    return true;
  }

  void add_bound(const Row& row)
  {
    const int v = row.form[0].first;
    const bool is_upper = CGAL::is_positive(row.form[0].second);
    Rational value = row.rhs / row.form[0].second;
    if(m_constraints.is_integer[v])
      value = is_upper ? Rational(Number::floor(value)) : Rational(-Rational(Number::floor(-value)));
    Bound& bound = (is_upper ? m_upper : m_lower)[v];
    if(!bound.exists || (is_upper ? value < bound.value : value > bound.value))
      bound.value = value;
    bound.exists = true;
  }

  void collect()
  {
    const double infinity = std::numeric_limits<double>::infinity();
    const int m = static_cast<int>(m_constraints.is_integer.size());
    std::vector<char> occurs(m, 0);
    for(const Row& row : m_result.rows)
      for(const std::pair<int, Rational>& a : row.form)
        occurs[a.first] = 1;
    std::vector<int> position(m, -1);
    for(int v = 0; v < m; ++v)
      if(occurs[v] || m_constraints.is_integer[v] || m_lower[v].exists || m_upper[v].exists)
      {
        position[v] = m_result.size();
        m_result.kept.push_back(v);
      }
    const int n = m_result.size();
    m_result.lower.resize(n);
    m_result.upper.resize(n);
    for(int i = 0; i < n; ++i)
    {
      const Bound &low = m_lower[m_result.kept[i]], &high = m_upper[m_result.kept[i]];
      m_result.is_integer.push_back(m_constraints.is_integer[m_result.kept[i]]);
      m_result.exact_lower.push_back(low.value);
      m_result.exact_upper.push_back(high.value);
      m_result.lower[i] = low.exists ? CGAL::to_double(low.value) : -infinity;
      m_result.upper[i] = high.exists ? CGAL::to_double(high.value) : infinity;
      m_result.is_infeasible = m_result.is_infeasible || (low.exists && high.exists && low.value > high.value);
    }
    m_result.G = Eigen::MatrixXd::Zero(m_result.rows.size(), n);
    m_result.h.resize(m_result.rows.size());
    for(std::size_t r = 0; r < m_result.rows.size(); ++r)
    {
      Row& row = m_result.rows[r];
      for(std::pair<int, Rational>& a : row.form)
      {
        a.first = position[a.first];
        m_result.G(r, a.first) = CGAL::to_double(a.second);
      }
      m_result.h[r] = CGAL::to_double(row.rhs);
    }
  }

  const Mixed_integer_problem& m_problem;
  const Eliminated_constraints& m_constraints;
  std::vector<Bound> m_lower, m_upper; // per free variable
  Bounded_problem m_result;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BOUNDED_PROBLEM_H
