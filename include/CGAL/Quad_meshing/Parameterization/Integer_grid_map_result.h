// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTEGER_GRID_MAP_RESULT_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTEGER_GRID_MAP_RESULT_H

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief says how the computation of an integer-grid map ended.
*/
enum class Integer_grid_map_status
{
  VALID,               ///< the map is an integer-grid map, exactly
  FOLDED,              ///< all transitions, grid points and grid lines are exact, but some triangles are folded over
  EMPTY_MESH,          ///< there are no faces; nothing was written
  NOT_A_TRIANGLE_MESH, ///< a face has not three vertices; nothing was written
  NON_MANIFOLD_VERTEX, ///< the faces around a vertex form more than one fan, the message says which; nothing was
                       ///< written
  VALUE_NOT_FINITE,    ///< a coordinate of a point or an angle of the field is not a finite number; nothing was written
  INVALID_LENGTH,      ///< the target edge length is not a positive number; nothing was written
  NUMERICAL_FAILURE,   ///< the energy could not be factorized; nothing was written
  STOPPED              ///< the visitor asked for an early end; nothing was written
};

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief returns the name of a status in lower case, for instance `"invalid_length"`.
*/
inline const char* status_name(Integer_grid_map_status status)
{
  switch(status)
  {
    case Integer_grid_map_status::VALID: return "valid";
    case Integer_grid_map_status::FOLDED: return "folded";
    case Integer_grid_map_status::EMPTY_MESH: return "empty_mesh";
    case Integer_grid_map_status::NOT_A_TRIANGLE_MESH: return "not_a_triangle_mesh";
    case Integer_grid_map_status::NON_MANIFOLD_VERTEX: return "non_manifold_vertex";
    case Integer_grid_map_status::VALUE_NOT_FINITE: return "value_not_finite";
    case Integer_grid_map_status::INVALID_LENGTH: return "invalid_length";
    case Integer_grid_map_status::NUMERICAL_FAILURE: return "numerical_failure";
    case Integer_grid_map_status::STOPPED: return "stopped";
  }
  return "";
}

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief The answer of `integer_grid_map()`.
*/
struct Integer_grid_map_result
{
  Integer_grid_map_status status = Integer_grid_map_status::NUMERICAL_FAILURE;
  /// The same as a sentence.
  std::string message;
  /// The number of variables after all linear conditions were eliminated.
  int variables = 0;
  /// How many of them are integers.
  int integers = 0;
  /// The orientation energy of the least map without integer conditions, in units of quads.
  double relaxed_energy = 0;
  /// The orientation energy with the integers that were chosen, before fold-overs were removed.
  double energy = 0;
  /// Pairs of grid points and grid lines that lie so near to each other that their order was watched in the rounding.
  int separations = 0;
  /// Such pairs that could not be kept in order.
  int broken_separations = 0;
  /// Faces that are folded or have no area, by their index in the face index map, ascending.
  std::vector<std::size_t> folded_faces;
  /// Those that were folded already in the map without integer conditions: if there are some, the field and the
  /// constrained edges leave no room there, whatever the integers.
  std::vector<std::size_t> folded_before_rounding;
  /// The wall-clock time.
  double seconds = 0;

  /// Whether the map is an integer-grid map.
  bool is_valid() const { return status == Integer_grid_map_status::VALID; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTEGER_GRID_MAP_RESULT_H
