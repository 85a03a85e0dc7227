// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GUIDES_GUIDE_CONNECTION_H
#define CGAL_QUAD_MESHING_GUIDES_GUIDE_CONNECTION_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingGuidesRef

\brief Two vertices that a straight chain of quad edges is to join: a separatrix, if they are irregular.

The chain follows the shortest path between the two points. To have irregular vertices at its ends, place these by an
`Index_guide` at each; an end can also lie on a feature or the border.
*/
struct Guide_connection
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;

  Point_3 from, to; ///< are projected to the surface
  std::string name; ///< what messages call it; empty: its number
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GUIDES_GUIDE_CONNECTION_H
