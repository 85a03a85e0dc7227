// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_QUAD_MESH_STATUS_H
#define CGAL_QUAD_MESHING_SMOOTHING_QUAD_MESH_STATUS_H

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief says how a function ended that changes a quad mesh on a reference surface: `smooth_quad_mesh()` and
 * `optimize_quad_structure()`.
 */
enum class Quad_mesh_status
{
  SUCCESS,         ///< the mesh has been smoothed, or its structure optimized, as far as the time allowed it
  NOT_A_QUAD_MESH, ///< the mesh has faces that are not quads; it has not been touched
  EMPTY_REFERENCE, ///< the reference has no triangle of positive area; the mesh has not been touched
  STOPPED          ///< the visitor asked for an early end; the mesh is as it was
};

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief returns the name of a status in lower case, for instance `"not_a_quad_mesh"`.
 */
inline const char* status_name(Quad_mesh_status status)
{
  switch(status)
  {
    case Quad_mesh_status::SUCCESS: return "success";
    case Quad_mesh_status::NOT_A_QUAD_MESH: return "not_a_quad_mesh";
    case Quad_mesh_status::EMPTY_REFERENCE: return "empty_reference";
    case Quad_mesh_status::STOPPED: return "stopped";
  }
  return "";
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_QUAD_MESH_STATUS_H
