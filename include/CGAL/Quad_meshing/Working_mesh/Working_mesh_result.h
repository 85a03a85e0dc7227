// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_WORKING_MESH_RESULT_H
#define CGAL_QUAD_MESHING_WORKING_MESH_RESULT_H

#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingWorkingMeshRef

\brief How `make_working_mesh()` ended.
*/
enum class Working_mesh_status
{
  MADE,                ///< There is a working mesh.
  NOT_A_TRIANGLE_MESH, ///< The input has a face that is not a triangle; there is no working mesh.
  INVALID_PARAMETERS,  ///< A parameter cannot be used; the message says which. There is no working mesh.
  STOPPED              ///< The visitor asked to stop; there is no working mesh.
};

/*!
\ingroup PkgQuadMeshingWorkingMeshRef

\brief the name of a status, in lower case.
*/
inline const char* status_name(Working_mesh_status status)
{
  switch(status)
  {
    case Working_mesh_status::MADE: return "made";
    case Working_mesh_status::NOT_A_TRIANGLE_MESH: return "not_a_triangle_mesh";
    case Working_mesh_status::INVALID_PARAMETERS: return "invalid_parameters";
    case Working_mesh_status::STOPPED: return "stopped";
  }
  return "";
}

/*!
\ingroup PkgQuadMeshingWorkingMeshRef

\brief The answer of `make_working_mesh()`.
*/
struct Working_mesh_result
{
  Working_mesh_status status = Working_mesh_status::MADE; ///< how it ended
  std::string message;                                    ///< one sentence for the user
  std::size_t input_faces = 0;                            ///< the number of faces of the input
  std::size_t faces = 0;                                  ///< the number of faces of the working mesh
  std::size_t collapsed_edges = 0;                        ///< the number of edges that became points
  std::size_t split_edges = 0;                            ///< the number of edges that were split
  std::size_t flipped_edges = 0;                          ///< the number of edges that were flipped
  std::size_t moved_vertices = 0;                         ///< how often a vertex was moved along the input
  double largest_error = 0; ///< an estimate of the largest distance to the input, in the unit of the points
  double seconds = 0;       ///< wall-clock time

  /// whether there is a working mesh.
  bool is_valid() const { return status == Working_mesh_status::MADE; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_WORKING_MESH_RESULT_H
