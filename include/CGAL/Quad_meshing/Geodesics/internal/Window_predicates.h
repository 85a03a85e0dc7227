// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_PREDICATES_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_PREDICATES_H

#include <CGAL/Quad_meshing/Geodesics/internal/Certified_number.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Exact_window_signs.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Number_functions.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The questions by whose answers windows are cut, joined and dropped. Each answer is a function of the stored numbers:
// of windows, places, distances and corners as they are, whatever rounding has made of them before. What counts as
// equal is said by a slack, which is an argument and a part of the question: no answer depends on how the expressions
// in it are rounded.
//
// Here for any number type, with its own operations: exact if these are. For double see below.
template <typename FT>
struct Window_comparisons
{
  typedef Window<FT> W;

  // Whether b - a > slack.
  static bool is_wider(const FT& a, const FT& b, const FT& slack) { return b - a > slack; }

  // -1 if w.distance(t) is smaller than old.distance(t), 1 if it is larger, 0 if they differ by no more than `slack`
  // times |sigma| + |distance - sigma| of the old one. `d` and `old_d` are the distances, up to rounding.
  static int compare_distances(const W&, const FT& d, const W& old, const FT& old_d, const FT&, const FT& slack)
  {
    const FT difference = d - old_d, tie = slack * (absolute(old.sigma) + absolute(old_d - old.sigma));
    return difference > tie ? 1 : difference < -tie ? -1 : 0;
  }

  // Whether w.distance(t) is more than the way d + (a - b), by more than `slack` times |d| + (a - b).
  static bool is_beyond(const W& w, const FT& t, const FT& d, const FT& a, const FT& b, const FT& slack)
  {
    const FT way = a - b, rest = d + way + slack * (absolute(d) + way) - w.sigma;
    if(w.linear)
      return w.x * t > rest;
    return rest < FT(0) || (t - w.x) * (t - w.x) + w.y * w.y > rest * rest;
  }

  // Whether the ray of w to the point (x, y) before the edge crosses it at a greater place than b + slack, or at a
  // smaller one.
  static bool is_right_of(const W& w, const FT& x, const FT& y, const FT& b, const FT& slack)
  {
    return w.place_of_ray(x, y) - b > slack;
  }
  static bool is_left_of(const W& w, const FT& x, const FT& y, const FT& b, const FT& slack)
  {
    return w.place_of_ray(x, y) - b < slack;
  }

  // Whether the point (x, y), which may lie behind the edge, is on the right of the ray of w through b, where right is
  // where places are greater.
  static bool is_right_of_ray(const W& w, const FT& x, const FT& y, const FT& b)
  {
    return (w.linear ? w.x : FT(b - w.x)) * y < w.y * (x - b);
  }
};

// Numbers of type double: a filter with a bound of the rounding errors, and exact arithmetic where it leaves a doubt.
//
// u is the unit of rounding, 2^-53. The bounds are for rounding to nearest, with fused operations or without. What is
// lost by underflow is less than `underflow()`, in squares less than `underflow_of_squares()`.
template <>
struct Window_comparisons<double>
{
  typedef Window<double> W;

  // A difference is rounded to a number on the same side of `slack`, or to slack itself.
  static bool is_wider(double a, double b, double slack)
  {
    const double d = b - a;
    if(BOOST_LIKELY(d != slack))
      return d > slack;
    return lost_in_sum(b, -a, d) > 0;
  }

  // |sigma| + |distance - sigma| is at most twice |sigma| + |distance|.
  BOOST_FORCEINLINE static int compare_distances(const W& w, double d, const W& old, double old_d, double t,
                                                 double slack)
  {
    const double difference = d - old_d;
    const double doubtful =
      (2 * slack + 32 * unit()) * (std::fabs(w.sigma) + std::fabs(d) + std::fabs(old.sigma) + std::fabs(old_d));
    if(std::fabs(difference) > doubtful + underflow())
      return difference > 0 ? 1 : -1;
    return compare_close_distances(w, d, old, old_d, t, slack);
  }

  // The error of the way is at most 3.3 u (|d| + (a - b)), which changing the slack by 8 u makes up for. What follows
  // are operations on positive numbers with relative errors, 8 u in all.
  static bool is_beyond(const W& w, double t, double d, double a, double b, double slack)
  {
    const double way = a - b, length = std::fabs(d) + way;
    if(w.linear)
    {
      const double rise = w.x * t, difference = rise - (d + way + slack * length - w.sigma);
      const double error = 16 * unit() * (std::fabs(rise) + length + std::fabs(w.sigma)) + underflow();
      return std::fabs(difference) > error ? difference > 0 : exact_is_beyond(w, t, d, a, b, slack);
    }
    const double square = (t - w.x) * (t - w.x) + w.y * w.y, up = 1 + 16 * unit();
    const double least = d + way + (slack - 8 * unit()) * length - w.sigma;
    if(least >= 0 && square * up + underflow_of_squares() <= least * least)
      return false;
    const double most = d + way + (slack + 8 * unit()) * length - w.sigma;
    if(most < 0 || square > most * most * up + underflow_of_squares())
      return true;
    return exact_is_beyond(w, t, d, a, b, slack);
  }

  static bool is_right_of(const W& w, double x, double y, double b, double slack)
  {
    return side_of(w, x, y, b, slack) > 0;
  }
  static bool is_left_of(const W& w, double x, double y, double b, double slack)
  {
    return side_of(w, x, y, b, slack) < 0;
  }

  static bool is_right_of_ray(const W& w, double x, double y, double b)
  {
    const double left = (w.linear ? w.x : b - w.x) * y, right = w.y * (x - b), difference = right - left;
    if(std::fabs(difference) > 4 * unit() * (std::fabs(left) + std::fabs(right)) + underflow() ||
       !are_finite({ w.x, w.y, x, y, b }))
      return difference > 0;
    return Exact_window_signs::ray_side(w, x, y, b, 0) > 0;
  }

private:
  static constexpr double unit() { return 1.1102230246251565e-16; }
  static constexpr double underflow() { return 1e-150; }
  static constexpr double underflow_of_squares() { return 1e-300; }

  // The exact rest of the rounded sum s = a + b (Knuth).
  static double lost_in_sum(double a, double b, double s)
  {
    const double c = s - a;
    return (a - (s - c)) + (b - c);
  }

  static bool are_finite(std::initializer_list<double> numbers)
  {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  }
  static bool is_finite(const W& w) { return are_finite({ w.x, w.y, w.sigma }); }

  // With r = sqrt((t - x)^2 + y^2), the error of r is at most 3.1 u r, and that of sigma + r at most 4.2 u (|sigma| +
  // r); for linear windows it is smaller, with |x t| for r. `scale` has the same error. The difference adds u times
  // both scales. What overflows is equal, and nothing is cut there.
  BOOST_NOINLINE static int compare_close_distances(const W& w, double d, const W& old, double old_d, double t,
                                                    double slack)
  {
    const double difference = d - old_d;
    const double scale = std::fabs(w.sigma) + std::fabs(d - w.sigma),
                 old_scale = std::fabs(old.sigma) + std::fabs(old_d - old.sigma);
    const double tie = slack * old_scale, error = 6 * unit() * (scale + old_scale) + underflow();
    if(std::fabs(difference) > tie + error)
      return difference > 0 ? 1 : -1;
    if(std::fabs(difference) < tie - error || !is_finite(w) || !is_finite(old) || !std::isfinite(t))
      return 0;
    return exact_comparison(w, old, t, slack);
  }

  // In twice the precision first.
  static int exact_comparison(const W& w, const W& old, double t, double slack)
  {
    typedef Certified_number Number;
    const auto way = [t](const W& w)
    {
      const Number d = Number::difference(t, w.x);
      return w.linear ? Number(w.x) * Number(t) : sqrt(d * d + Number(w.y) * Number(w.y));
    };
    const Number way_w = way(w), way_old = way(old);
    const Number difference = Number::difference(w.sigma, old.sigma) + (way_w - way_old),
                 tie = Number(slack) * (Number(std::fabs(old.sigma)) + abs(way_old));
    const Number above = difference - tie, below = difference + tie;
    if(above.lower() > 0)
      return 1;
    if(below.upper() < 0)
      return -1;
    if(above.upper() < 0 && below.lower() > 0)
      return 0;
    return Exact_window_signs::distance_difference(w, old, t, slack);
  }

  BOOST_NOINLINE static bool exact_is_beyond(const W& w, double t, double d, double a, double b, double slack)
  {
    return is_finite(w) && are_finite({ t, d, a, b }) && Exact_window_signs::is_beyond(w, t, d, a, b, slack);
  }

  // The quotient has an error of at most 5 u times itself, and is the difference of t and x, or of t and w.x.
  BOOST_NOINLINE static int side_of(const W& w, double x, double y, double b, double slack)
  {
    const double t = w.place_of_ray(x, y), difference = t - b - slack;
    const double error =
      8 * unit() * (std::fabs(t) + std::fabs(w.linear ? x : w.x) + std::fabs(b) + std::fabs(slack)) + underflow();
    if(std::fabs(difference) > error || !are_finite({ w.x, w.y, x, y, b, slack }))
      return difference > 0 ? 1 : -1;
    return Exact_window_signs::ray_side(w, x, y, b, slack);
  }
};

// The predicates of windows, which say how much slack each question has.
template <typename FT>
struct Window_predicates : Window_comparisons<FT>
{
  typedef Window_comparisons<FT> Base;
  typedef Window<FT> W;
  typedef Window_tolerances<FT> Tol;

  // Which of two windows is nearer at t: -1 the first, 1 the second, 0 if they tie. The distances there are given.
  static int compare_distances(const W& w, const FT& d, const W& old, const FT& old_d, const FT& t)
  {
    return Base::compare_distances(w, d, old, old_d, t, FT(Tol::tie()));
  }

  // Whether a distance is shorter than one that is known.
  static bool is_shorter(const FT& d, const FT& known)
  {
    return Base::is_wider(d, known, FT(FT(Tol::tie()) * absolute(known)));
  }

  // Whether the window is longer at t than the way over an end of the edge, which is a - b away from there and has the
  // distance d (Xin and Wang 2009).
  static bool is_longer_than_way(const W& w, const FT& t, const FT& d, const FT& a, const FT& b)
  {
    return Base::is_beyond(w, t, d, a, b, FT(Tol::filter()));
  }

  // With a source (for linear windows: a point) less far along the edge than this, the place where a ray to a point
  // crosses it is found in double with an error of at most 8 u (3 + 1e10) lengths, or 16 u times the place if that is
  // farther: less than 2e-5 of the length or of the place.
  static FT far(const FT& length) { return FT(1e10) * length; }

  // Whether a gap between a and b beside an end of the window, which is `end`, comes from rounding, see
  // Window_tolerances.
  BOOST_FORCEINLINE static bool is_closed_gap(const W& w, const FT& a, const FT& b, const FT& end, const FT& length)
  {
    if(!(a < b))
      return true;
    if(b - a > FT(2) * FT(Tol::wide_gap()) * length)
      return false;
    return is_closed_narrow_gap(w, a, b, end, length);
  }

  // Whether two windows continue each other: same origin at the same place.
  static bool have_same_source(const W& a, const W& b)
  {
    if(a.origin != b.origin || a.linear != b.linear || a.from_left != b.from_left)
      return false;
    const FT scale = a.linear ? FT(1) : FT(absolute(a.b1 - a.x) + a.y), close = FT(Tol::source()) * scale;
    return are_close(a.x, b.x, close) && are_close(a.y, b.y, close) &&
           are_close(a.sigma, b.sigma, FT(FT(Tol::source()) * (absolute(a.sigma) + scale)));
  }

private:
  BOOST_NOINLINE static bool is_closed_narrow_gap(const W& w, const FT& a, const FT& b, const FT& end, const FT& length)
  {
    return !Base::is_wider(a, b, w.largest_gap(end, length));
  }

  static bool are_close(const FT& a, const FT& b, const FT& slack)
  {
    return !Base::is_wider(a, b, slack) && !Base::is_wider(b, a, slack);
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_PREDICATES_H
