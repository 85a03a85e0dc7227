// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GUIDES_SIZE_DISC_H
#define CGAL_QUAD_MESHING_GUIDES_SIZE_DISC_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingGuidesRef

\brief The length that quad edges should have around a point.

It holds in the part of the surface around the point that lies within the radius. Where discs overlap, the shortest
length counts.
*/
struct Size_disc
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;

  Point_3 center;    ///< is projected to the surface
  double radius = 0; ///< in the unit of the points
  double length = 0; ///< of a quad edge, in the unit of the points
  std::string name;  ///< what messages call it; empty: its number
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GUIDES_SIZE_DISC_H
