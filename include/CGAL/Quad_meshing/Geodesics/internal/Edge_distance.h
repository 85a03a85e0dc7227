// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_EDGE_DISTANCE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_EDGE_DISTANCE_H

#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_propagation.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The distance of the field along an edge as a function without gaps: the smallest of its windows and of the ways over
// the ends of the edge, and where neither is known to be right the ways from the ends of the windows.
class Edge_distance
{
  typedef Window<double> W;

public:
  std::vector<W> pieces; // sorted, without gaps, from 0 to the length (as rounded)
  double at_source, at_target;
  double length;

  void make(const Unfolded_mesh<double>& mesh, const Window_propagation<double>& propagation, int e)
  {
    const int h = mesh.halfedge_of_edge[e];
    length = mesh.length[e];
    at_source = propagation.label(mesh.source(h)).distance;
    at_target = propagation.label(mesh.target(h)).distance;
    pieces.clear();
    if(length == 0)
      return;
    // no distance grows faster than the way along the edge, so what is longer than the way from an end is so up to some
    // place
    const W from_source = way(0., length, 0., at_source), from_target = way(0., length, length, at_target);
    const auto& windows = propagation.windows(e);
    double end = 0, value = at_source;
    for(int i = 0; i < windows.size; ++i)
    {
      W w = windows[i];
      w.b0 = (std::max)(w.b0, end);
      w.b1 = (std::min)(w.b1, length);
      if(!(w.b1 - w.b0 > rounding() * length))
        continue;
      if(w.b1 - w.b0 <= narrow() * length &&
         ((!pieces.empty() && is_nearer(pieces.back(), w)) || (i + 1 < windows.size && is_nearer(windows[i + 1], w))))
        continue;
      const double first = crossing(w, from_source, w.b0, w.b1);
      const double last = crossing(w, from_target, w.b1, w.b0);
      if(!(first < last))
        continue;
      w.b0 = first;
      w.b1 = last;
      if(w.b0 > end)
      {
        if(!pieces.empty() && w.b0 - end <= thin() * (length + value - pieces.back().sigma))
          pieces.back().b1 = w.b0;
        else
          fill(end, value, w.b0, w.distance(w.b0));
      }
      pieces.push_back(w);
      end = w.b1;
      value = w.distance(end);
    }
    if(end < length)
      fill(end, value, length, at_target);
  }

  double minimum() const
  {
    double d = (std::min)(at_source, at_target);
    for(const W& w : pieces)
      d = (std::min)(d, w.minimum());
    return d;
  }

private:
  // A window narrower than this part of the length is left to a neighbour if that is nearer by more than the width: it
  // is the remainder of one that was replaced by two others which do not meet for rounding.
  static double narrow() { return 1e-6; }
  // A gap up to this part of the length or of the distance to the source is left to the window before it: the window of
  // a shadow that was too narrow to be kept on an edge before. Both neighbours are right in there up to the square of
  // the width.
  static double thin() { return 1e-9; }

  static double rounding() { return 1e-15; }

  static bool is_nearer(const W& v, const W& w)
  {
    const double width = w.b1 - w.b0;
    return v.distance(w.b0) < w.distance(w.b0) - width && v.distance(w.b1) < w.distance(w.b1) - width;
  }

  static W way(double b0, double b1, double from, double d)
  {
    return W{ b0, b1, from, 0., d, 0, false, false, false, 0.f };
  }

  // How far from `near`, in the direction of `far`, w is longer than the way v from an end of the edge.
  static double crossing(const W& w, const W& v, double near, double far)
  {
    const auto is_longer = [&](double t) { return w.distance(t) > v.distance(t) * (1 + 1e-14); };
    if(!is_longer(near))
      return near;
    for(int i = 0; i < 60 && near != far; ++i)
    {
      const double middle = (near + far) / 2;
      (is_longer(middle) ? near : far) = middle;
    }
    return far;
  }

  // Ways from both ends of a gap.
  void fill(double b0, double d0, double b1, double d1)
  {
    const double middle = (std::min)((std::max)((b0 + b1 + d1 - d0) / 2, b0), b1);
    if(b0 < middle)
      pieces.push_back(way(b0, middle, b0, d0));
    if(middle < b1)
      pieces.push_back(way(middle, b1, b1, d1));
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_EDGE_DISTANCE_H
