// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_NUMBER_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_NUMBER_H

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A real number that is known up to a radius: it lies in [high + low - radius, high + low + radius], where
// |low| is at most half a unit in the last place of `high`.
//
// The center has about 106 bits, so that a long computation still tells apart numbers that are equal in double: what
// remains of a difference of distances is the rounding of the stored windows. The radius is a proven bound: the
// error-free transformations of Knuth and Dekker give the rounding errors of the operations on `high` as numbers; what
// is lost in the operations on `low` is less than 2^-102 of the operands (Joldes, Muller, Popescu 2017), for which
// 2^-100 is added, and every operation on radii is rounded up by a factor. Needs rounding to nearest.
class Certified_number
{
public:
  Certified_number(double x = 0) : m_high(x) {}
  Certified_number(double high, double low, double radius) : m_high(high), m_low(low), m_radius(radius) {}

  // The exact difference of two numbers.
  static Certified_number difference(double a, double b)
  {
    Certified_number d;
    two_sum(a, -b, d.m_high, d.m_low);
    return d;
  }

  double high() const { return m_high; }
  double lower() const { return rounded(m_high + (m_low - m_radius), -1); }
  double upper() const { return rounded(m_high + (m_low + m_radius), 1); }

  // A bound of the difference to `high()`.
  double magnitude_of_error() const { return rounded(std::fabs(m_low) + m_radius, 1); }

  // A bound of the absolute value.
  double magnitude() const { return rounded(std::fabs(m_high) + (std::fabs(m_low) + m_radius), 1); }

  Certified_number operator-() const { return Certified_number(-m_high, -m_low, m_radius); }

  friend Certified_number operator+(const Certified_number& a, const Certified_number& b)
  {
    double s, e;
    two_sum(a.m_high, b.m_high, s, e);
    e += a.m_low + b.m_low;
    Certified_number r;
    two_sum(s, e, r.m_high, r.m_low);
    r.m_radius = inflated(a.m_radius + b.m_radius + lost() * (std::fabs(a.m_high) + std::fabs(b.m_high)));
    return r;
  }

  friend Certified_number operator-(const Certified_number& a, const Certified_number& b) { return a + (-b); }

  friend Certified_number operator*(const Certified_number& a, const Certified_number& b)
  {
    double p, e;
    two_product(a.m_high, b.m_high, p, e);
    e += a.m_high * b.m_low + a.m_low * b.m_high;
    Certified_number r;
    two_sum(p, e, r.m_high, r.m_low);
    r.m_radius = inflated(std::fabs(a.m_high) * b.m_radius + (std::fabs(b.m_high) + b.m_radius) * a.m_radius +
                          lost() * std::fabs(p) + underflow());
    return r;
  }

  // The radius follows from the remainder: |a/b - q| = |a - q b| / |b|.
  friend Certified_number operator/(const Certified_number& a, const Certified_number& b)
  {
    const double least = b.m_high > 0 ? b.lower() : (-b).lower();
    if(!(least > 0))
      return unknown();
    const double q = a.m_high / b.m_high;
    Certified_number r;
    two_sum(q, (a - Certified_number(q) * b).m_high / b.m_high, r.m_high, r.m_low);
    r.m_radius = inflated((a - r * b).magnitude() / least);
    return r;
  }

  // The square root of a number that is known not to be negative, whatever its radius says.
  // |sqrt(a) - s| is at most |a - s^2| / s, and at most the root of |a - s^2|.
  friend Certified_number sqrt(const Certified_number& a)
  {
    Certified_number r;
    const double s = std::sqrt((std::max)(a.m_high, 0.));
    if(s > 0)
      two_sum(s, (a - Certified_number(s) * Certified_number(s)).m_high / (2 * s), r.m_high, r.m_low);
    const double rest = (a - r * r).magnitude(), least = r.lower();
    r.m_radius = inflated(std::sqrt(rest));
    if(least > 0)
      r.m_radius = (std::min)(r.m_radius, inflated(rest / least));
    return r;
  }

  friend Certified_number abs(const Certified_number& a) { return a.m_high < 0 ? -a : a; }

private:
  static Certified_number unknown() { return Certified_number(0, 0, std::numeric_limits<double>::infinity()); }

  static constexpr double lost() { return 0x1p-100; }
  static constexpr double underflow() { return 0x1p-1000; } // more than what products of tiny numbers lose
  static double inflated(double radius) { return radius * (1 + 0x1p-48); }
  static double rounded(double x, int direction)
  {
    return x + direction * (0x1p-51 * std::fabs(x) + std::numeric_limits<double>::denorm_min());
  }

  static void two_sum(double a, double b, double& s, double& e)
  {
    s = a + b;
    const double c = s - a;
    e = (a - (s - c)) + (b - c);
  }

  static void two_product(double a, double b, double& p, double& e)
  {
#ifdef FP_FAST_FMA
    p = a * b;
    e = std::fma(a, b, -p);
#else
    const double factor = 134217729; // 2^27 + 1
    const double ca = factor * a, cb = factor * b;
    const double ah = ca - (ca - a), bh = cb - (cb - b), al = a - ah, bl = b - bh;
    p = a * b;
    e = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
#endif
  }

  double m_high, m_low = 0, m_radius = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_NUMBER_H
