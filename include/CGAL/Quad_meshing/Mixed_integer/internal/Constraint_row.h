// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONSTRAINT_ROW_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONSTRAINT_ROW_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Elimination_number.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// An equality constraint on its way through the elimination.
template <typename NT>
struct Constraint_row
{
  typedef Elimination_number<NT> Number;
  typedef std::pair<int, NT> Entry;

  std::vector<Entry> entries; // ascending variables
  NT rhs;
  NT scale;         // the row is the original one, modulo others, times this
  double tolerance; // for the right-hand side, in units of the original row
  bool is_integral; // the coefficients are integers
  bool is_exact;    // so is the right-hand side, and that of all rows that came in
  bool is_open;

  // Rows of integers, or of multiples of integers, are scaled to integers without a common divisor. In a row over
  // integer variables the right-hand side may miss an integer by round-off.
  Constraint_row(const Mixed_integer_problem::Linear_constraint& constraint, double relative_tolerance,
                 const std::vector<char>& is_integer_variable);

  void divide_by_gcd()
  {
    NT g(0);
    for(const Entry& e : entries)
      g = Number::gcd(g, e.second);
    if(Number::is_zero(g) || g == NT(1))
      return;
    for(Entry& e : entries)
      e.second = e.second / g;
    rhs = rhs / g;
    scale = scale / g;
  }

  // The place of the entry with the largest or smallest coefficient, the first one of several.
  int largest_entry() const
  {
    int best = 0;
    for(std::size_t i = 1; i < entries.size(); ++i)
      if(Number::abs(entries[i].second) > Number::abs(entries[best].second))
        best = static_cast<int>(i);
    return best;
  }
  int smallest_entry() const
  {
    int best = 0;
    for(std::size_t i = 1; i < entries.size(); ++i)
      if(Number::abs(entries[i].second) < Number::abs(entries[best].second))
        best = static_cast<int>(i);
    return best;
  }
};

// A factor that makes all coefficients of a form integers.
struct Integral_factor
{
  double factor = 0.;    // 0 if none was found
  bool is_exact = false; // the products are integers as they stand, and not only up to round-off
};

inline Integral_factor integral_factor(const std::vector<std::pair<int, double>>& form)
{
  const double largest_exact = 9007199254740992.;             // 2^53: all smaller integers are doubles
  const double relative_error = 1e-12, largest_rounded = 1e6; // of fractions that doubles hold only up to round-off
  const int max_denominator = 1000;
  double smallest = 0., largest = 0.;
  for(const std::pair<int, double>& a : form)
    if(a.second != 0.)
    {
      smallest = (smallest == 0.) ? std::fabs(a.second) : (std::min)(smallest, std::fabs(a.second));
      largest = (std::max)(largest, std::fabs(a.second));
    }
  if(smallest == 0.)
    return { 1., true };
  // Powers of two scale without rounding.
  for(double factor = 1.; factor <= 1048576. && largest * factor <= largest_exact; factor *= 2.)
  {
    bool ok = true;
    for(const std::pair<int, double>& a : form)
      ok = ok && std::floor(a.second * factor) == a.second * factor;
    if(ok)
      return { factor, true };
  }
  for(int d = 1; d <= max_denominator; ++d)
  {
    const double factor = d / smallest;
    bool ok = largest * factor < largest_rounded;
    for(const std::pair<int, double>& a : form)
    {
      const double v = a.second * factor;
      ok = ok && std::fabs(v - std::floor(v + 0.5)) <= relative_error * (std::max)(1., std::fabs(v));
    }
    if(ok)
      return { factor, false };
  }
  return {};
}

// The form with the entries of each variable added up, in ascending order of variables.
inline Mixed_integer_problem::Linear_form collected(Mixed_integer_problem::Linear_form form)
{
  std::stable_sort(form.begin(), form.end(),
                   [](const std::pair<int, double>& a, const std::pair<int, double>& b) { return a.first < b.first; });
  Mixed_integer_problem::Linear_form sum;
  for(const std::pair<int, double>& a : form)
    if(!sum.empty() && sum.back().first == a.first)
      sum.back().second += a.second;
    else
      sum.push_back(a);
  return sum;
}

template <typename NT>
Constraint_row<NT>::Constraint_row(const Mixed_integer_problem::Linear_constraint& constraint,
                                   double relative_tolerance, const std::vector<char>& is_integer_variable)
{
  const double round_off = 1e-9; // of a right-hand side, relative to one and to its size
  const Mixed_integer_problem::Linear_form form = collected(constraint.form);
  double largest = 0.;
  for(const std::pair<int, double>& a : form)
    largest = (std::max)(largest, std::fabs(a.second));
  const double factor = integral_factor(form).factor;
  is_integral = factor > 0.;
  is_open = true;
  // Rows of reals are brought to a largest coefficient of one, to have a meaning for tolerances.
  const double scaling = is_integral ? factor : (largest > 0. ? 1. / largest : 1.);
  scale = NT(scaling);
  rhs = NT(constraint.rhs) * scale;
  tolerance = relative_tolerance * (std::max)({ 1., largest, std::fabs(constraint.rhs) });
  for(const std::pair<int, double>& a : form)
  {
    if(a.second == 0.)
      continue;
    NT value = NT(a.second) * scale;
    if(is_integral)
      value = Number::nearest_integer(value);
    entries.emplace_back(a.first, value);
  }
  const NT nearest = Number::nearest_integer(rhs);
  bool has_integers_only = true;
  for(const Entry& e : entries)
    has_integers_only = has_integers_only && is_integer_variable[e.first];
  if(is_integral && has_integers_only &&
     std::fabs(Number::to_double(rhs - nearest)) <= round_off * (std::max)(1., std::fabs(Number::to_double(rhs))) &&
     relative_tolerance >= round_off)
    rhs = nearest;
  is_exact = is_integral && rhs == nearest;
  if(is_integral)
    divide_by_gcd();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONSTRAINT_ROW_H
