// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_EXACT_WINDOW_SIGNS_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_EXACT_WINDOW_SIGNS_H

#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The signs behind the predicates of `Window_predicates`, exact for the numbers that are stored. These functions are
// called when a filter in double leaves a doubt, so they are short rather than fast. All numbers must be finite.
class Exact_window_signs
{
public:
  typedef Window<double> W;
  typedef Exact_rational Q;

  // The sign of p + sqrt(q) - sqrt(r), where q and r are not negative.
  static int root_difference(const Q& p, const Q& q, const Q& r)
  {
    const int s = CGAL::sign(p), d = CGAL::compare(q, r);
    if(d == 0 || s == d)
      return s;
    if(s == 0)
      return d;
    // The two parts have different signs. |p| is the larger one if p^2 > q + r - 2 sqrt(q r).
    const Q m = q + r - p * p;
    const int larger = m < 0 ? 1 : static_cast<int>(CGAL::sign(Q(4 * q * r - m * m)));
    return larger == 0 ? 0 : larger > 0 ? s : d;
  }

  // Of v.distance(t) - w.distance(t), and 0 if that is at most `slack` times the length of the two parts of
  // w.distance(t).
  static int distance_difference(const W& v, const W& w, double t, double slack)
  {
    const Distance d(v, t), e(w, t);
    const Q rest = d.rational - e.rational, scale = Q(slack) * e.rational_length, s(slack), one(1);
    if(root_difference(rest - scale, d.square, (one + s) * (one + s) * e.square) > 0)
      return 1;
    return root_difference(rest + scale, d.square, (one - s) * (one - s) * e.square) < 0 ? -1 : 0;
  }

  // Whether w.distance(t) is more than d + (a - b) with (1 + slack) times each part.
  static bool is_beyond(const W& w, double t, double d, double a, double b, double slack)
  {
    const Distance e(w, t);
    const Q way = Q(a) - Q(b), start(d);
    const Q rest = start + way + Q(slack) * (CGAL::abs(start) + way) - e.rational;
    return rest < 0 || e.square > rest * rest;
  }

  // Of the place where the ray of w to (x, y) crosses the edge, minus b + slack.
  static int ray_side(const W& w, double x, double y, double b, double slack)
  {
    const Q place = Q(b) + Q(slack), cx(x), cy(y), wx(w.x), wy(w.y);
    if(w.linear)
      return CGAL::sign(Q((cx - place) * wy - cy * wx));
    return CGAL::sign(Q((cx - wx) * wy - (place - wx) * (cy + wy)));
  }

private:
  // A distance as the sum of a rational number and a root.
  struct Distance
  {
    Q rational, square;
    Q rational_length; // the lengths of its parts

    Distance(const W& w, double t)
    {
      if(w.linear)
      {
        const Q rise = Q(w.x) * Q(t);
        rational = Q(w.sigma) + rise;
        rational_length = CGAL::abs(Q(w.sigma)) + CGAL::abs(rise);
        square = 0;
      }
      else
      {
        const Q d = Q(t) - Q(w.x), y(w.y);
        rational = Q(w.sigma);
        rational_length = CGAL::abs(rational);
        square = d * d + y * y;
      }
    }
  };
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_EXACT_WINDOW_SIGNS_H
