// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_RESULT_H
#define CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_RESULT_H

#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 * \brief names the ways to find the period jumps of a cross field.
 */
enum class Cross_field_method
{
  /// A search over the period jumps with exact gains that starts from a smooth representation field (the default and
  /// the best).
  POLISHED,
  /// The mixed-integer problem over a forest of dual trees, integers rounded one after the other, nearest first.
  GREEDY,
  /// The same problem, all integers rounded at once.
  DIRECT,
  /// As `GREEDY` with the exact solution of the system after every rounding: a yardstick.
  NAIVE,
  /// The globally smoothest representation field, rounded, without a search: higher energy, more singularities, and
  /// often a less distorted integer-grid map.
  REPRESENTATION,
  /// As `GREEDY`, and then a local search: period jumps are changed, which moves singularities, as long as that lowers
  /// the energy.
  GREEDY_AND_SEARCH
};

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 * \brief says how the computation of a cross field ended.
 */
enum class Cross_field_status
{
  SUCCESS,             ///< the field is there and no sector is empty
  EMPTY_SECTORS,       ///< the field is there, but a face with two constrained edges has no room for a quad
  STOPPED,             ///< the visitor asked for an early end
  NOT_A_TRIANGLE_MESH, ///< a face has not three vertices
  POINT_NOT_FINITE,    ///< a coordinate is not a finite number
  INVALID_LENGTH,      ///< a target edge length is not a positive number
  NON_MANIFOLD_VERTEX, ///< the faces around a vertex form more than one fan; the message says which vertex
  NUMERICAL_FAILURE    ///< a linear system could not be factorized
};

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 * \brief returns the name of a status in lower case, for instance `"empty_sectors"`.
 */
inline const char* status_name(Cross_field_status status)
{
  switch(status)
  {
    case Cross_field_status::SUCCESS: return "success";
    case Cross_field_status::EMPTY_SECTORS: return "empty_sectors";
    case Cross_field_status::STOPPED: return "stopped";
    case Cross_field_status::NOT_A_TRIANGLE_MESH: return "not_a_triangle_mesh";
    case Cross_field_status::POINT_NOT_FINITE: return "point_not_finite";
    case Cross_field_status::INVALID_LENGTH: return "invalid_length";
    case Cross_field_status::NON_MANIFOLD_VERTEX: return "non_manifold_vertex";
    case Cross_field_status::NUMERICAL_FAILURE: return "numerical_failure";
  }
  return "";
}

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 * \brief holds what `smooth_cross_field()` has to say about its result.
 */
struct Cross_field_result
{
  /// how it ended
  Cross_field_status status = Cross_field_status::SUCCESS;
  /// the same as a sentence that names what is at fault
  std::string message;
  /// the sum of squared angle differences across inner edges; for `REPRESENTATION`, and for quads, with surface weights
  double energy = 0;
  /// a proven lower bound of the energy of all cross fields with the same given directions; 0 unless it was asked for
  double lower_bound = 0;
  /// the energy before the search
  double initial_energy = 0;
  /// the number of vertices with an index other than zero, corners of the border included
  int singularities = 0;
  /// the sum of all indices, in quarters
  int index_sum = 0;
  /// the number of period jumps that are free integers: inner edges minus free faces minus edges between given faces
  int integers = 0;
  /// the number of faces whose direction was given
  int constrained_faces = 0;
  /// the number of faces with two constrained edges that are neither parallel nor orthogonal
  int conflicting_faces = 0;
  /// the number of sectors between constrained edges that are left without a quad
  int empty_sectors = 0;
  /// the number of vertices that do not have the index that `prescribed_index_map` gives them
  int unmet_prescriptions = 0;
  /// the wall-clock time in seconds
  double seconds = 0;

  /// returns whether there is a field without empty sectors.
  bool is_valid() const { return status == Cross_field_status::SUCCESS; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_RESULT_H
