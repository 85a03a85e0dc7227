// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_GRID_AUTOMORPHISM_H
#define CGAL_QUAD_MESHING_INTERNAL_GRID_AUTOMORPHISM_H

#include <cmath>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// An orientation-preserving automorphism of the integer grid, p -> R90^r p + (tx, ty).
//
// The rotation only swaps and negates coordinates, so it is exact on doubles. The translation is
// kept in doubles as well: an integer below 2^53 in absolute value is exact there, and a map that
// is not integer (a seamless map) has a place too; `is_integer()` tells them apart. Applying an
// automorphism is exact wherever the sum of a coordinate and a translation is a double; this is so
// if all coordinates are multiples of one power of two and small enough.
struct Grid_automorphism
{
  int r = 0; // number of quarter turns counterclockwise, 0 to 3
  double tx = 0;
  double ty = 0;

  Grid_automorphism() = default;
  Grid_automorphism(int quarter_turns, double x, double y) : r(quarter_turns & 3), tx(x), ty(y) {}

  // (x, y) turned by `quarter_turns` quarter turns. Works for negative numbers of turns.
  static void rotate(int quarter_turns, double& x, double& y)
  {
    const double u = x;
    switch(quarter_turns & 3)
    {
      case 1:
        x = -y;
        y = u;
        break;
      case 2:
        x = -x;
        y = -y;
        break;
      case 3:
        x = y;
        y = -u;
        break;
      default: break;
    }
  }

  // Transforms a point: any type with `x()`, `y()` and a constructor from two doubles.
  template <typename Point>
  Point operator()(const Point& p) const
  {
    double x = p.x(), y = p.y();
    rotate(r, x, y);
    return Point(x + tx, y + ty);
  }

  // Transforms a direction 0 (+x), 1 (+y), 2 (-x) or 3 (-y).
  int direction(int d) const { return (d + r) & 3; }

  Grid_automorphism inverse() const
  {
    double x = -tx, y = -ty;
    rotate(-r, x, y);
    return Grid_automorphism(-r, x, y);
  }

  // The product: first `b`, then `*this`.
  Grid_automorphism operator*(const Grid_automorphism& b) const
  {
    double x = b.tx, y = b.ty;
    rotate(r, x, y);
    return Grid_automorphism(r + b.r, x + tx, y + ty);
  }

  bool is_integer() const { return tx == std::floor(tx) && ty == std::floor(ty); }
  bool is_identity() const { return r == 0 && tx == 0 && ty == 0; }

  bool operator==(const Grid_automorphism& b) const { return r == b.r && tx == b.tx && ty == b.ty; }
  bool operator!=(const Grid_automorphism& b) const { return !(*this == b); }
};

// What `recover_grid_automorphism()` found out about the two images of an edge.
enum class Transition_kind
{
  EXACT,       // the automorphism maps one image onto the other exactly; its translation is integer
  NOT_INTEGER, // it maps one image onto the other exactly, but the translation is not integer
  INEXACT,     // no automorphism does so exactly; the one given is the nearest
  ZERO_LENGTH  // an image is a point: every rotation would do, the one given is rotation 0
};

// a - b, and whether that difference is a double (Knuth's error term, which needs no size order).
inline bool exact_difference(double a, double b, double& difference)
{
  difference = a - b;
  const double c = a - difference, e = difference + c;
  return (a - e) + (c - b) == 0;
}

// The automorphism that maps the image (a0, a1) of an edge in one chart to its image (b0, b1) in the
// neighbouring chart.
//
// Where the answer is `EXACT` or `NOT_INTEGER`, the equations R a0 + t = b0 and R a1 + t = b1 hold
// over the reals, whatever the sizes of the coordinates. Where it is `INEXACT` the rotation is the one that turns
// a1 - a0 nearest to b1 - b0, and the translation is the mean over both ends, rounded to integers;
// where it is `ZERO_LENGTH` the translation is taken at the first end and left unrounded.
// NaN or infinite coordinates give `INEXACT`.
template <typename Point>
Transition_kind recover_grid_automorphism(const Point& a0, const Point& a1, const Point& b0, const Point& b1,
                                          Grid_automorphism& g)
{
  const double ax = a1.x() - a0.x(), ay = a1.y() - a0.y();
  const double bx = b1.x() - b0.x(), by = b1.y() - b0.y();

  if((ax == 0 && ay == 0) || (bx == 0 && by == 0))
  {
    g = Grid_automorphism(0, b0.x() - a0.x(), b0.y() - a0.y());
    const bool both = ax == 0 && ay == 0 && bx == 0 && by == 0;
    return both ? Transition_kind::ZERO_LENGTH : Transition_kind::INEXACT;
  }

  // Rounding to nearest commutes with negation, and equal differences round equally: the right
  // rotation matches the rounded differences exactly.
  for(int r = 0; r < 4; ++r)
  {
    double x = ax, y = ay;
    Grid_automorphism::rotate(r, x, y);
    if(x != bx || y != by)
      continue;

    double x0 = a0.x(), y0 = a0.y(), x1 = a1.x(), y1 = a1.y();
    Grid_automorphism::rotate(r, x0, y0);
    Grid_automorphism::rotate(r, x1, y1);
    double tx, ty, sx, sy;
    const bool exact = exact_difference(b0.x(), x0, tx) && exact_difference(b0.y(), y0, ty) &&
                       exact_difference(b1.x(), x1, sx) && exact_difference(b1.y(), y1, sy);
    if(!exact || tx != sx || ty != sy)
      break;
    g = Grid_automorphism(r, tx, ty);
    return g.is_integer() ? Transition_kind::EXACT : Transition_kind::NOT_INTEGER;
  }

  // The rotation with the largest scalar product.
  const double dot = ax * bx + ay * by, cross = ax * by - ay * bx;
  int r;
  if(std::fabs(dot) >= std::fabs(cross))
    r = dot >= 0 ? 0 : 2;
  else
    r = cross >= 0 ? 1 : 3;
  double x = 0.5 * (a0.x() + a1.x()), y = 0.5 * (a0.y() + a1.y());
  Grid_automorphism::rotate(r, x, y);
  g =
    Grid_automorphism(r, std::floor(0.5 * (b0.x() + b1.x()) - x + 0.5), std::floor(0.5 * (b0.y() + b1.y()) - y + 0.5));
  return Transition_kind::INEXACT;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_GRID_AUTOMORPHISM_H
