// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_REQUEST_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_REQUEST_H

#include <CGAL/Quad_meshing/Pipeline/internal/Component_guides.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What one component is asked for.
struct Component_request
{
  double length = 0;          // of a quad edge, in the unit of the points; on average, if it differs
  bool is_graded = false;     // the lengths on the surface are not all the same
  double requested_quads = 0; // 0: an edge length was asked for
  double number_of_quads = 0; // that the length stands for
  bool has_features = false;  // marked by the user: none are detected, none are released
  bool has_curves = false;    // of the user: those of its feature edges that are kept have nodes
  Component_wishes wishes;    // of the user
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_REQUEST_H
