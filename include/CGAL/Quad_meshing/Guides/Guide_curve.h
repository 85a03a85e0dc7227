// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GUIDES_GUIDE_CURVE_H
#define CGAL_QUAD_MESHING_GUIDES_GUIDE_CURVE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingGuidesRef

\brief A curve that the user has drawn on a surface.

Its points are projected to the surface; consecutive ones are joined by shortest paths on it.
*/
struct Guide_curve
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;

  std::vector<Point_3> points; ///< at least two
  bool is_closed = false;      ///< whether the last point is joined to the first one
  std::string name;            ///< what messages call it; empty: its number
};

/*!
\ingroup PkgQuadMeshingGuidesRef

\brief A curve whose direction the quads should follow.
*/
struct Guide_stroke : Guide_curve
{
  /// In every triangle that the stroke crosses, the weight of the squared deviation of the cross field from its
  /// direction, against the squared differences between neighboring triangles. Infinite: the stroke is hard, the field
  /// has its direction.
  double weight = 10;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GUIDES_GUIDE_CURVE_H
