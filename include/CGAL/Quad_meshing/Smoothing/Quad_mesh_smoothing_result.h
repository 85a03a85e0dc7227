// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_QUAD_MESH_SMOOTHING_RESULT_H
#define CGAL_QUAD_MESHING_SMOOTHING_QUAD_MESH_SMOOTHING_RESULT_H

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief is the outcome of `smooth_quad_mesh()`.
 */
enum class Quad_mesh_smoothing_status
{
  SMOOTHED,        ///< the mesh has been smoothed
  NOT_A_QUAD_MESH, ///< the mesh has faces that are not quads; it has not been touched
  EMPTY_REFERENCE, ///< the reference has no triangle of positive area; the mesh has not been touched
  STOPPED          ///< the visitor asked for an early end; the mesh is as it was
};

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief returns the name of the enumerator in lower case.
 */
inline const char* status_name(Quad_mesh_smoothing_status status)
{
  switch(status)
  {
    case Quad_mesh_smoothing_status::SMOOTHED: return "smoothed";
    case Quad_mesh_smoothing_status::NOT_A_QUAD_MESH: return "not_a_quad_mesh";
    case Quad_mesh_smoothing_status::EMPTY_REFERENCE: return "empty_reference";
    case Quad_mesh_smoothing_status::STOPPED: return "stopped";
  }
  return "unknown";
}

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief tells what `smooth_quad_mesh()` did.
 *
 * A quad is *folded* if it is not strictly convex (its scaled Jacobian is not positive) or if its
 * normal is opposed, by more than 120 degrees, to the normal of the reference surface below it.
 */
struct Quad_mesh_smoothing_result
{
  Quad_mesh_smoothing_status status = Quad_mesh_smoothing_status::SMOOTHED; ///< the outcome
  std::string message;                                                      ///< the outcome as a sentence
  std::size_t folded_quads_before = 0;                                      ///< number of folded quads in the input
  std::size_t folded_quads_after = 0;                                       ///< number of folded quads in the output
  Quad_mesh_quality quality_before;                                         ///< measures of the input
  Quad_mesh_quality quality_after;                                          ///< measures of the output
  unsigned int iterations = 0; ///< number of sweeps over the vertices, and of steps of all together

  /// whether the mesh has been smoothed and no quad is folded.
  bool is_valid() const { return status == Quad_mesh_smoothing_status::SMOOTHED && folded_quads_after == 0; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_QUAD_MESH_SMOOTHING_RESULT_H
