// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_DISTANCE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_DISTANCE_H

#include <CGAL/Quad_meshing/Geodesics/internal/Certified_number.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A distance along a line as windows have it, with certified coefficients: sigma + sqrt((t - x)^2 + y^2), or sigma + x
// t.
struct Certified_distance
{
  typedef Certified_number Number;

  Number x, y, sigma;
  bool is_linear;

  Certified_distance(const Number& x, const Number& y, const Number& sigma, bool is_linear)
    : x(x), y(y), sigma(sigma), is_linear(is_linear)
  {
  }

  explicit Certified_distance(const Window<double>& w) : x(w.x), y(w.y), sigma(w.sigma), is_linear(w.linear) {}

  Number operator()(const Number& t) const
  {
    if(is_linear)
      return sigma + x * t;
    const Number d = t - x;
    return sigma + sqrt(d * d + y * y);
  }

  // The same seen from the other end of an edge.
  void reverse(const Number& length)
  {
    if(is_linear)
    {
      sigma = sigma + x * length;
      x = -x;
    }
    else
      x = length - x;
  }
};

// Bounds the largest excess of one distance over another.
class Distance_excess
{
  typedef Window<double> W;

public:
  // Returns an upper bound of w - f on [low, high], or `known` if that is larger. The bound is found in double first,
  // with its rounding error, and computed with certified numbers only if it may exceed `known`.
  static double bound(const W& w, const Certified_distance& f, double low, double high, double known)
  {
    const double everywhere = bound_everywhere(w, f);
    if(everywhere <= known)
      return known;
    if(!is_largest_at_ends(w, f, low, high))
      return everywhere;
    const double at_ends = (std::max)(bound_at(w, f, low, known), bound_at(w, f, high, known));
    return (std::min)(everywhere, (std::max)(known, at_ends));
  }

private:
  // The rounding error of a few operations, relative to the largest number in them.
  static constexpr double rounding() { return 0x1p-47; }

  static double bound_everywhere(const W& w, const Certified_distance& f)
  {
    const Certified_number gap = Certified_number(w.sigma) - f.sigma;
    if(!w.linear && !f.is_linear)
    {
      // the triangle inequality for the sources
      const Certified_number dx = f.x - Certified_number(w.x), dy = abs(f.y) - Certified_number(w.y);
      const double x = dx.magnitude(), y = dy.magnitude();
      return (gap + Certified_number(std::sqrt(x * x + y * y) * (1 + rounding()))).upper();
    }
    if(w.linear && !f.is_linear)
    {
      // the tangent of f with the slope of w
      const Certified_number x(w.x), square = Certified_number(1) - x * x;
      if(!(square.lower() >= 0))
        return std::numeric_limits<double>::infinity();
      return (gap + x * f.x - abs(f.y) * sqrt(square)).upper();
    }
    return std::numeric_limits<double>::infinity();
  }

  // Whether w - f has no maximum between low and high that is not at an end.
  static bool is_largest_at_ends(const W& w, const Certified_distance& f, double low, double high)
  {
    if(f.is_linear)
      return true; // w - f is convex
    if(w.linear)
    {
      if(!(std::fabs(w.x) < 1))
        return true; // f is flatter
      // f has the slope of w where (t - x) sqrt(1 - s^2) = s y
      const double x = f.x.high(), y = std::fabs(f.y.high()), root = std::sqrt((std::max)(0., (1 - w.x) * (1 + w.x)));
      const double error = rounding() * (std::fabs(x) + y + std::fabs(low) + std::fabs(high)) +
                           f.x.magnitude_of_error() + f.y.magnitude_of_error();
      const double a = (low - x) * root - w.x * y, b = (high - x) * root - w.x * y;
      return (a > error && b > error) || (a < -error && b < -error);
    }
    if(w.y == 0 || abs(f.y).lower() >= w.y)
      return true; // the only place of equal slopes is a minimum
    // the slopes are equal where both sources appear under one angle
    const double x = f.x.high(), y = std::fabs(f.y.high());
    const auto difference = [&](double t) { return (t - w.x) * y - (t - x) * w.y; };
    const auto error = [&](double t)
    {
      return rounding() * ((std::fabs(t) + std::fabs(w.x)) * y + (std::fabs(t) + std::fabs(x)) * w.y) +
             f.x.magnitude_of_error() * w.y + f.y.magnitude_of_error() * (std::fabs(t) + std::fabs(w.x));
    };
    const double a = difference(low), b = difference(high);
    return (a > error(low) && b > error(high)) || (a < -error(low) && b < -error(high));
  }

  static double bound_at(const W& w, const Certified_distance& f, double t, double known)
  {
    const double fx = f.x.high(), fy = f.y.high(), fs = f.sigma.high();
    const double at = f.is_linear ? fs + fx * t : fs + std::sqrt((t - fx) * (t - fx) + fy * fy);
    const double scale = std::fabs(w.sigma) + std::fabs(w.x) + std::fabs(w.y) + std::fabs(fs) + std::fabs(t) +
                         std::fabs(fx) + std::fabs(fy);
    const double error = rounding() * scale * (f.is_linear || w.linear ? 1 + std::fabs(t) : 1.) +
                         f.sigma.magnitude_of_error() + f.y.magnitude_of_error() +
                         f.x.magnitude_of_error() * (f.is_linear ? std::fabs(t) : 1.);
    const double bound = w.distance(t) - at + error;
    if(bound <= known)
      return known;
    return (Certified_distance(w)(t) - f(t)).upper();
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_DISTANCE_H
