// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_EXACT_VERIFICATION_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_EXACT_VERIFICATION_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Constraint_row.h>

#include <CGAL/Exact_rational.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Checks a solution against the constraints and bounds as they were given, in exact arithmetic. Rows of integers over
// integer variables must hold exactly, all others up to the rounding of real variables.
class Exact_verification
{
  typedef CGAL::Exact_rational Rational;
  typedef Mixed_integer_problem::Linear_constraint Constraint;

public:
  // Equality constraints that are listed in `ignored`, which ascends, do not count.
  Exact_verification(const Mixed_integer_problem& problem, const std::vector<int>& ignored, double constraint_tolerance)
    : m_problem(problem), m_ignored(ignored), m_tolerance(constraint_tolerance)
  {
  }

  // Returns what is wrong, nothing if all is well.
  std::string complaint(const Eigen::VectorXd& x) const
  {
    for(int i = 0; i < m_problem.number_of_variables(); ++i)
    {
      const double allowed = m_problem.is_integer(i) ? 0. : round_off * (std::max)(1., std::fabs(x[i]));
      if(!(x[i] >= m_problem.lower_bound(i) - allowed && x[i] <= m_problem.upper_bound(i) + allowed))
        return "a bound of variable " + std::to_string(i);
    }
    const std::vector<Constraint>& equalities = m_problem.equality_constraints();
    for(std::size_t c = 0; c < equalities.size(); ++c)
      if(!std::binary_search(m_ignored.begin(), m_ignored.end(), static_cast<int>(c)) &&
         !is_met(equalities[c], x, true))
        return "equality constraint " + std::to_string(c);
    const std::vector<Constraint>& inequalities = m_problem.inequality_constraints();
    for(std::size_t c = 0; c < inequalities.size(); ++c)
      if(!is_met(inequalities[c], x, false))
        return "inequality constraint " + std::to_string(c);
    return std::string();
  }

  // Moves real variables by round-off, for the inequality constraints that can hold exactly to do so.
  void settle(Eigen::VectorXd& x) const
  {
    const int passes = 4;
    bool has_moved = true;
    for(int pass = 0; pass < passes && has_moved; ++pass)
    {
      has_moved = false;
      for(const Constraint& c : m_problem.inequality_constraints())
      {
        const double excess = CGAL::to_double(value(c, x));
        int best = -1;
        double coefficient = 0.;
        for(const std::pair<int, double>& a : c.form)
          if(!m_problem.is_integer(a.first) && std::fabs(a.second) > std::fabs(coefficient))
          {
            best = a.first;
            coefficient = a.second;
          }
        if(!(excess > 0.) || best < 0 || excess > round_off * (std::max)(1., magnitude(c, x)))
          continue;
        const double moved = std::nextafter(x[best] - excess / coefficient,
                                            coefficient > 0. ? -m_problem.infinity() : m_problem.infinity());
        if(moved < m_problem.lower_bound(best) || moved > m_problem.upper_bound(best))
          continue;
        x[best] = moved;
        has_moved = true;
      }
    }
  }

private:
  static constexpr double round_off = 1e-9; // of a sum of real numbers, relative to one and to the largest of them

  static Rational value(const Constraint& c, const Eigen::VectorXd& x)
  {
    Rational sum = -Rational(c.rhs);
    for(const std::pair<int, double>& a : c.form)
      sum += Rational(a.second) * Rational(x[a.first]);
    return sum;
  }

  static double magnitude(const Constraint& c, const Eigen::VectorXd& x)
  {
    double largest = std::fabs(c.rhs);
    for(const std::pair<int, double>& a : c.form)
      largest = (std::max)(largest, std::fabs(a.second * x[a.first]));
    return largest;
  }

  bool is_met(const Constraint& c, const Eigen::VectorXd& x, bool is_equality) const
  {
    const double exact_sums = 4503599627370496.; // 2^52: sums of integers below are exact
    bool has_integers_only = true;
    double sum = -c.rhs, size = std::fabs(c.rhs);
    for(const std::pair<int, double>& a : c.form)
    {
      has_integers_only = has_integers_only && m_problem.is_integer(a.first);
      sum += a.second * x[a.first];
      size += std::fabs(a.second * x[a.first]);
    }
    const Mixed_integer_problem::Linear_form form = collected(c.form);
    const Integral_factor f = has_integers_only ? integral_factor(form) : Integral_factor();
    if(f.factor > 0.)
    {
      if(f.is_exact && f.factor == 1. && size < exact_sums)
        return is_equality ? is_close(sum) : sum <= 0.;
      Rational exact = -Rational(c.rhs) * Rational(f.factor);
      for(const std::pair<int, double>& a : form)
        exact +=
          Rational(f.is_exact ? a.second * f.factor : std::floor(a.second * f.factor + 0.5)) * Rational(x[a.first]);
      if(is_equality || !f.is_exact)
        return is_close(CGAL::to_double(exact)) || (!is_equality && CGAL::is_negative(exact));
      return !CGAL::is_positive(exact);
    }
    double largest = (std::max)(1., std::fabs(c.rhs));
    for(const std::pair<int, double>& a : c.form)
      largest = (std::max)(largest, std::fabs(a.second));
    const double allowed =
      (std::max)(round_off * (std::max)(1., magnitude(c, x)), is_equality ? m_tolerance * largest : 0.);
    return is_equality ? std::fabs(sum) <= allowed : sum <= allowed;
  }

  // Whether an integer that may miss its value by a right-hand side that is not exact is zero.
  static bool is_close(double a)
  {
    const double allowed = 1e-3;
    return std::fabs(a) <= allowed;
  }

  const Mixed_integer_problem& m_problem;
  const std::vector<int>& m_ignored;
  double m_tolerance;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_EXACT_VERIFICATION_H
