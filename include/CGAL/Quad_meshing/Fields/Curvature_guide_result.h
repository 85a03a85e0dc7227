// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_CURVATURE_GUIDE_RESULT_H
#define CGAL_QUAD_MESHING_FIELDS_CURVATURE_GUIDE_RESULT_H

#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 * \brief says how `salient_directions()` or `curvature_sizing()` ended.
 */
enum class Curvature_guide_status
{
  SUCCESS,            ///< the map was written
  STOPPED,            ///< the visitor asked for an early end; nothing was written
  INVALID_LENGTH,     ///< a length is not positive, or the smallest is larger than the largest; nothing was written
  NOT_A_TRIANGLE_MESH ///< a face has not three vertices; nothing was written
};

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 * \brief returns the name of a status in lower case, for instance `"invalid_length"`.
 */
inline const char* status_name(Curvature_guide_status status)
{
  switch(status)
  {
    case Curvature_guide_status::SUCCESS: return "success";
    case Curvature_guide_status::STOPPED: return "stopped";
    case Curvature_guide_status::INVALID_LENGTH: return "invalid_length";
    case Curvature_guide_status::NOT_A_TRIANGLE_MESH: return "not_a_triangle_mesh";
  }
  return "";
}

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 * \brief holds what `salient_directions()` and `curvature_sizing()` have to say about their result.
 */
struct Curvature_guide_result
{
  /// how it ended
  Curvature_guide_status status = Curvature_guide_status::SUCCESS;
  /// the same as a sentence
  std::string message;
  /// the number of faces that got a direction, or a length shorter than the largest one
  int number_of_faces = 0;

  /// returns whether the map was written.
  bool is_valid() const { return status == Curvature_guide_status::SUCCESS; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_CURVATURE_GUIDE_RESULT_H
