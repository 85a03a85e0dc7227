// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_ELIMINATION_NUMBER_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_ELIMINATION_NUMBER_H

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstdlib>
#include <numeric>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the elimination of constraints asks of its numbers. Integer coefficients stay integers through
// the elimination; in `double` this holds as long as they fit, which `is_safe()` tells.
template <typename NT>
struct Elimination_number;

template <>
struct Elimination_number<double>
{
  // Products of two safe numbers, plus another, fit the 53 bits of a double.
  static bool is_safe(double a) { return std::fabs(a) < 67108864.; } // 2^26
  static bool is_zero(double a) { return a == 0.; }
  static double abs(double a) { return std::fabs(a); }
  static double to_double(double a) { return a; }
  static double nearest_integer(double a) { return std::floor(a + 0.5); }

  static double gcd(double a, double b)
  {
    return static_cast<double>(std::gcd(static_cast<long long>(a), static_cast<long long>(b)));
  }

  // Division of integers that leaves the remainder of least absolute value.
  static double nearest_quotient(double a, double b) { return std::floor(a / b + 0.5); }
};

template <>
struct Elimination_number<CGAL::Exact_rational>
{
  typedef CGAL::Exact_rational Rational;
  typedef CGAL::Exact_integer Integer;
  typedef CGAL::Fraction_traits<Rational> Fraction;

  static bool is_safe(const Rational&) { return true; }
  static bool is_zero(const Rational& a) { return CGAL::is_zero(a); }
  static Rational abs(const Rational& a) { return CGAL::abs(a); }
  static double to_double(const Rational& a) { return CGAL::to_double(a); }

  static Integer numerator(const Rational& a)
  {
    typename Fraction::Numerator_type n;
    typename Fraction::Denominator_type d;
    typename Fraction::Decompose()(a, n, d);
    return n;
  }

  static Integer denominator(const Rational& a)
  {
    typename Fraction::Numerator_type n;
    typename Fraction::Denominator_type d;
    typename Fraction::Decompose()(a, n, d);
    return d;
  }

  static Integer floor(const Rational& a)
  {
    typename Fraction::Numerator_type n;
    typename Fraction::Denominator_type d;
    typename Fraction::Decompose()(a, n, d);
    Integer q, r;
    CGAL::div_mod(Integer(n), Integer(d), q, r);
    // The sign of the remainder is left to the number type; the floor is not.
    if(CGAL::is_negative(r))
      q -= 1;
    return q;
  }

  static Rational nearest_integer(const Rational& a) { return Rational(floor(a + Rational(1, 2))); }

  static Rational gcd(const Rational& a, const Rational& b)
  {
    return Rational(CGAL::abs(CGAL::gcd(numerator(a), numerator(b))));
  }

  static Rational nearest_quotient(const Rational& a, const Rational& b) { return nearest_integer(a / b); }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_ELIMINATION_NUMBER_H
