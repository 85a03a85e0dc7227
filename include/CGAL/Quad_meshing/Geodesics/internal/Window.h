// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_H

#include <CGAL/Quad_meshing/Geodesics/internal/Number_functions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// All tolerances of the windows. Lengths are relative to the edge on which the window lies,
// distances to the distances compared. The numbers given are those for double.
template <typename FT>
struct Window_tolerances
{
  // Window ends this close to each other (or to a vertex) are the same place; narrower windows are dropped: 1e-11.
  static FT place()
  {
    static const FT t(tolerance_of_digits<FT>(11));
    return t;
  }

  // A gap between a window and its neighbour on the edge (or a vertex) is closed if its width, measured
  // across the rays, is up to this part of the edge or of the distance to the source: then it comes from
  // rounding. Rays that graze the edge make the gap wider along the edge; it never may exceed `wide_gap`: 1e-12, 1e-4.
  // A wider gap is the shadow of a saddle, however shallow, and must stay open for the window that comes from there: it
  // grows on the way.
  static FT gap()
  {
    static const FT t(tolerance_of_digits<FT>(12));
    return t;
  }
  static FT wide_gap()
  {
    static const FT t(tolerance_of_digits<FT>(4));
    return t;
  }

  // Two distances that differ by less are equal, and the window that was there first stays: 1e-14.
  static FT tie()
  {
    static const FT t(tolerance_of_digits<FT>(14));
    return t;
  }

  // Neighbouring windows whose sources lie this close together (relative to their distance) are one window: 1e-13.
  static FT source()
  {
    static const FT t(tolerance_of_digits<FT>(13));
    return t;
  }

  // Windows are filtered out by way of vertices only if they are longer by more than this, so that a
  // vertex whose distance is a rounding error too small does no harm: 1e-9.
  static FT filter()
  {
    static const FT t(tolerance_of_digits<FT>(9));
    return t;
  }
};

template <>
struct Window_tolerances<double>
{
  static constexpr double place() { return 1e-11; }
  static constexpr double gap() { return 1e-12; }
  static constexpr double wide_gap() { return 1e-4; }
  static constexpr double tie() { return 1e-14; }
  static constexpr double source() { return 1e-13; }
  static constexpr double filter() { return 1e-9; }
};

// A part of an edge whose points are reached from one side by straight rays: from one point
// (circular window) or from a straight front (linear window).
//
// Let t be the place on the edge. The distance is
//   circular:  sigma + sqrt((t - x)^2 + y^2), the source unfolded into the edge's frame lies at
//              distance y >= 0 from the edge's line, above x,
//   linear:    sigma + x t, where (x, y) is the unit direction of the rays and y >= 0.
// `from_left` tells on which side of the canonical halfedge the source lies; the rays go on to the other side.
// A window with y = 0 lies along its rays and does not propagate.
template <typename FT>
struct Window
{
  FT b0, b1;
  FT x, y;
  FT sigma;
  int origin : 29; // the pseudo-source: a vertex if >= 0, the source element ~origin otherwise
  bool linear : 1;
  bool from_left : 1;
  bool pending : 1; // not propagated yet
  float error;      // a bound of the error of the distance, 0 unless windows were merged

  FT distance(const FT& t) const
  {
    if(linear)
      return sigma + x * t;
    const FT d = t - x;
    return sigma + square_root(d * d + y * y);
  }

  // The derivative of the distance at t.
  FT slope(const FT& t) const
  {
    if(linear)
      return x;
    const FT d = t - x;
    return d / square_root(d * d + y * y);
  }

  // Where the ray to the point (px, py) before the edge crosses it.
  FT place_of_ray(const FT& px, const FT& py) const
  {
    return linear ? FT(px - py * x / y) : FT(x + (px - x) * y / (py + y));
  }

  // How wide a gap at the end b of the window may be to be closed, see Window_tolerances.
  FT largest_gap(const FT& b, const FT& length) const
  {
    typedef Window_tolerances<FT> Tol;
    const FT widest = FT(Tol::wide_gap()) * length;
    if(!(y > FT(0)))
      return widest;
    const FT r = linear ? FT(1) : FT(absolute(b - x) + y), across = linear ? length : FT(length + r);
    return (std::min)(widest, FT(r * FT(Tol::gap()) * across / y));
  }

  // The smallest distance between b0 and b1.
  FT minimum() const
  {
    if(linear)
      return x >= FT(0) ? distance(b0) : distance(b1);
    return distance((std::min)((std::max)(x, b0), b1));
  }

  // The same window seen from the other end of the edge.
  void reverse(const FT& length)
  {
    std::swap(b0, b1);
    b0 = length - b0;
    b1 = length - b1;
    if(linear)
    {
      sigma = sigma + x * length;
      x = -x;
    }
    else
      x = length - x;
    from_left = !from_left;
  }
};

// The places z in ]0, width[ at which the distances of two windows are equal, where z = t - l.
// There are at most two: squaring either equation away leaves a quadratic one. Returns their number.
template <typename FT>
int equal_distance_places(const Window<FT>& v, const Window<FT>& w, const FT& l, const FT& width, FT (&z)[2])
{
  if(v.linear && w.linear)
  {
    const FT slope = v.x - w.x;
    if(slope == FT(0))
      return 0;
    z[0] = (w.distance(l) - v.distance(l)) / slope;
    return z[0] > FT(0) && z[0] < width ? 1 : 0;
  }

  FT a, half_b, c; // a z^2 + 2 half_b z + c = 0
  FT side0, side1; // a root counts if side1 z + side0 >= 0
  FT discriminant;
  if(v.linear || w.linear)
  {
    // sqrt(Q) = m z + k with Q = (z - p)^2 + y^2
    const Window<FT>& line = v.linear ? v : w;
    const Window<FT>& circle = v.linear ? w : v;
    const FT p = circle.x - l, m = line.x, k = line.sigma + line.x * l - circle.sigma;
    a = FT(1) - m * m;
    half_b = -(p + m * k);
    c = (p - k) * (p + k) + circle.y * circle.y;
    side0 = k;
    side1 = m;
    // half_b^2 - a c without its cancellation: windows of a curve meet those of its corners where both distances are
    // zero
    const FT at_foot = m * p + k;
    discriminant = at_foot * at_foot - a * circle.y * circle.y;
  }
  else
  {
    // sqrt(Qv) - sqrt(Qw) = d; then Qv - Qw - d^2 = g z + h equals 2 d sqrt(Qw)
    const FT pv = v.x - l, pw = w.x - l, d = w.sigma - v.sigma;
    const FT g = FT(2) * (pw - pv);
    const FT h = (pv - pw) * (pv + pw) + (v.y - w.y) * (v.y + w.y) - d * d;
    if(absolute(d) <= FT(Window_tolerances<FT>::tie()) * (absolute(v.sigma) + absolute(w.sigma)))
    {
      // the equation would be the square of this one, up to rounding
      if(g == FT(0))
        return 0;
      z[0] = -h / g;
      return z[0] > FT(0) && z[0] < width ? 1 : 0;
    }
    const FT d2 = FT(4) * d * d;
    a = g * g - d2;
    half_b = g * h + d2 * pw;
    c = h * h - d2 * (pw * pw + w.y * w.y);
    side0 = d > FT(0) ? h : FT(-h);
    side1 = d > FT(0) ? g : FT(-g);
    discriminant = half_b * half_b - a * c;
  }

  if(!(discriminant > FT(0)))
    return 0;
  const FT root = square_root(discriminant);
  const FT q = half_b > FT(0) ? FT(-half_b - root) : FT(-half_b + root);
  int n = 0;
  const auto add = [&](const FT& r)
  {
    if(r > FT(0) && r < width && side1 * r + side0 >= FT(0))
      z[n++] = r;
  };
  if(a != FT(0))
    add(q / a);
  if(q != FT(0))
    add(c / q);
  if(n == 2 && z[1] < z[0])
    std::swap(z[0], z[1]);
  return n;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_H
