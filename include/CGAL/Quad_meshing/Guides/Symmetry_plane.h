// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GUIDES_SYMMETRY_PLANE_H
#define CGAL_QUAD_MESHING_GUIDES_SYMMETRY_PLANE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingGuidesRef

\brief A plane that the quad mesh is to be symmetric to.
*/
struct Symmetry_plane
{
  typedef Exact_predicates_inexact_constructions_kernel::Vector_3 Vector_3;

  /// What is known of the plane.
  enum class Kind
  {
    NORMAL, ///< it goes through the center of the bounding box
    PLANE,  ///< its equation
    FOUND   ///< nothing: the best plane is looked for
  };

  Kind kind = Kind::FOUND;
  Vector_3 normal = Vector_3(0, 0, 0); ///< of any length
  double offset = 0;                   ///< of the plane normal * p + offset = 0

  /// The plane with this normal through the center of the bounding box.
  static Symmetry_plane with_normal(double a, double b, double c)
  {
    Symmetry_plane p;
    p.kind = Kind::NORMAL;
    p.normal = Vector_3(a, b, c);
    return p;
  }

  /// The plane a x + b y + c z + d = 0.
  static Symmetry_plane with_equation(double a, double b, double c, double d)
  {
    Symmetry_plane p = with_normal(a, b, c);
    p.kind = Kind::PLANE;
    p.offset = d;
    return p;
  }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GUIDES_SYMMETRY_PLANE_H
