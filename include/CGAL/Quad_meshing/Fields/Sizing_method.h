// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_SIZING_METHOD_H
#define CGAL_QUAD_MESHING_FIELDS_SIZING_METHOD_H

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief What the lengths of quad edges adapt to where the user gives none.
 */
enum class Sizing_method
{
  CONSTANT,    ///< The same length everywhere.
  CURVATURE,   ///< Edges leave the surface by the same distance everywhere (`curvature_sizing()`).
  FEATURE_SIZE ///< Edges are in proportion to the thickness of the shape (`local_feature_size()`).
};

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief returns the name of a method in lower case, for instance `"feature_size"`.
 */
inline const char* method_name(Sizing_method method)
{
  switch(method)
  {
    case Sizing_method::CONSTANT: return "constant";
    case Sizing_method::CURVATURE: return "curvature";
    case Sizing_method::FEATURE_SIZE: return "feature_size";
  }
  return "";
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_SIZING_METHOD_H
