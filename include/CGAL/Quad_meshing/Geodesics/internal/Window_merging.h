// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_MERGING_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_MERGING_H

#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_lists.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Merging of neighbouring windows for the approximation (Surazhsky et al. 2005, thesis Ch. 9).
//
// The merged window keeps the distances at both ends and its rays cover those of both windows. If
// its error on the edge is at most e, it is at most e beyond as well: the distance of a point behind
// the edge is the smallest sum of the distance of a place on the edge and the way from there, and
// only the first part of the sum is wrong. So errors add up only where windows are merged again; each
// window carries the sum, and the farther the front is, the larger it may be.

// The largest difference between two windows of one kind within `old`.
template <typename FT>
double largest_difference(const Window<FT>& merged, const Window<FT>& old)
{
  const auto at = [&](const FT& t) { return std::abs(as_double(FT(merged.distance(t) - old.distance(t)))); };
  const double worst = (std::max)(at(old.b0), at(old.b1));
  if(merged.linear || merged.y == old.y)
    return worst;
  // the slopes are equal where the two sources appear under one angle
  const FT t = (merged.y * old.x - old.y * merged.x) / (merged.y - old.y);
  return t > old.b0 && t < old.b1 ? (std::max)(worst, at(t)) : worst;
}

// Merges `l` and its right neighbour `r` if the relative error of the distances stays within `allowed`.
template <typename FT>
bool merge_windows(const Window<FT>& l, const Window<FT>& r, double allowed, Window<FT>& merged)
{
  if(l.linear != r.linear || l.from_left != r.from_left || l.b1 != r.b0)
    return false;
  const FT width = r.b1 - l.b0, at_l = l.distance(l.b0), at_r = r.distance(r.b1), rise = at_r - at_l;
  if(!(absolute(rise) < width))
    return false;
  const FT slope_l = l.slope(l.b0), slope_r = r.slope(r.b1);
  merged = l;
  merged.b1 = r.b1;
  if(l.linear)
  {
    // the rays must not part
    if(slope_l < slope_r)
      return false;
    merged.x = rise / width;
    merged.y = square_root(FT(1) - merged.x * merged.x);
    merged.sigma = at_l - merged.x * l.b0;
  }
  else
  {
    // With the distance d to the source at the left end and d + rise at the right end, the rays at the ends
    // spread the further, the smaller d is; each end bounds d from above.
    const FT square = (width - rise) * (width + rise) / FT(2);
    const FT excess_l = rise - width * slope_l, excess_r = width * slope_r - rise;
    if(!(excess_l > FT(0)) && !(excess_r > FT(0)))
      return false;
    FT d = excess_l > FT(0) ? FT(square / excess_l) : FT(square / excess_r - rise);
    if(excess_l > FT(0) && excess_r > FT(0))
      d = (std::min)(d, FT(square / excess_r - rise));
    if(!(d > FT(0)) || !(d + rise > FT(0)))
      return false;
    // the place of the source
    const FT x = (width - rise * (FT(2) * d + rise) / width) / FT(2);
    const FT y2 = (d - x) * (d + x);
    if(!(y2 > FT(0)))
      return false;
    merged.x = l.b0 + x;
    merged.y = square_root(y2);
    merged.sigma = at_l - d;
  }
  const double error = (std::max)(l.error + largest_difference(merged, l), r.error + largest_difference(merged, r));
  const double nearest = as_double((std::min)(l.minimum(), r.minimum()));
  const double with_rounding = error * (1 + 1e-6);
  if(!(with_rounding <= allowed * (nearest - with_rounding)))
    return false;
  merged.error = static_cast<float>(with_rounding);
  return true;
}

// Merges what may be merged of the pending windows of an edge.
template <typename FT>
void merge_neighbours(Window_lists<FT>& lists, Window_list<FT>& list, double allowed)
{
  int n = 0;
  Window<FT> merged;
  for(const Window<FT>& w : list)
  {
    if(n > 0 && list[n - 1].pending && w.pending && merge_windows(list[n - 1], w, allowed, merged))
      list[n - 1] = merged;
    else
      list[n++] = w;
  }
  lists.splice(list, n, list.size - n, 0);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_MERGING_H
