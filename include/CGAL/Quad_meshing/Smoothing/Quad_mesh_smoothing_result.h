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
#include <CGAL/Quad_meshing/Smoothing/Quad_mesh_status.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

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
  Quad_mesh_status status = Quad_mesh_status::SUCCESS; ///< the outcome
  std::string message;                                 ///< the outcome as a sentence
  std::size_t folded_quads_before = 0;                 ///< number of folded quads in the input
  std::size_t folded_quads_after = 0;                  ///< number of folded quads in the output
  /// vertices that cannot move, at which two curves of the reference leave a folded quad an angle of 0 or 180 degrees:
  /// that quad cannot be unfolded. By number, in the order of the vertices of the mesh.
  std::vector<std::size_t> flat_corners;
  Quad_mesh_quality quality_before; ///< measures of the input
  Quad_mesh_quality quality_after;  ///< measures of the output
  unsigned int iterations = 0;      ///< number of sweeps over the vertices, and of steps of all together

  /// whether the mesh has been smoothed and no quad is folded.
  bool is_valid() const { return status == Quad_mesh_status::SUCCESS && folded_quads_after == 0; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_QUAD_MESH_SMOOTHING_RESULT_H
