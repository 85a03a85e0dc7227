// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_LANDING_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_LANDING_H

#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_predicates.h>

#include <boost/config.hpp>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Where windows arrive: an edge, seen from a face. Made once for many windows.
template <typename FT>
struct Window_landing
{
  int edge;
  bool is_canonical;
  bool is_closed; // whether nothing that arrives can be the nearest
  FT length;
  FT at_source, at_target; // the distances of the ends
  int hint;                // see Window_envelope::insert

  // Prepares a window that comes through the face of the halfedge, in the frame of the halfedge, for the list of the
  // edge. Returns false if it has nothing to do there.
  BOOST_FORCEINLINE bool admits(Window<FT>& w) const
  {
    typedef Window_predicates<FT> Predicates;
    const FT l = length;
    if(!(w.y > FT(0)))
      return false;
    if(w.b0 < FT(0))
      w.b0 = FT(0);
    if(l < w.b1)
      w.b1 = l;
    if(!(w.b0 < w.b1))
      return false;

    // rays that are longer than the way over an end of the edge lead nowhere
    if(Predicates::is_longer_than_way(w, w.b1, at_source, w.b1, FT(0)) ||
       Predicates::is_longer_than_way(w, w.b0, at_target, l, w.b0))
      return false;

    w.from_left = true;
    w.pending = true;
    if(!is_canonical)
      w.reverse(l);
    return true;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_LANDING_H
