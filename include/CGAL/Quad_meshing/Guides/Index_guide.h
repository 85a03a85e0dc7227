// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GUIDES_INDEX_GUIDE_H
#define CGAL_QUAD_MESHING_GUIDES_INDEX_GUIDE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingGuidesRef

\brief Where an irregular vertex must be, where none may be, or what the indices in a region sum up to.

The index of an inner vertex is 4 minus the number of quads around it, that of a border vertex 2 minus this number. On a
surface whose borders are chains of quad edges, all indices sum up to four times the Euler number.
*/
struct Index_guide
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;

  Point_3 point; ///< is projected to the surface
  /// In quarters: 1 for three quads, -1 for five; 0: the vertex is regular.
  int index = 0;
  /// With an index of 0: no irregular vertex in the part of the surface around the point that lies within this distance
  /// of it, in the unit of the points. Infinite: none on the whole component but at the points of other guides, and on
  /// borders and features.
  double radius = 0;
  /// Whether `index` is the sum of the indices in the region with the given radius. Irregular vertices that are missing
  /// are put where there is room, and those that are too many are forbidden.
  bool is_sum = false;
  std::string name; ///< what messages call it; empty: its number
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GUIDES_INDEX_GUIDE_H
