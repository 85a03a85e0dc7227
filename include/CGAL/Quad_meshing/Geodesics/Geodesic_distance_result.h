// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_GEODESIC_DISTANCE_RESULT_H
#define CGAL_QUAD_MESHING_GEODESICS_GEODESIC_DISTANCE_RESULT_H

#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingGeodesicsRef
 * \brief says how the computation of a distance field ended.
 */
enum class Geodesic_distance_status
{
  SUCCESS,             ///< every vertex that a source can reach has its distance
  LIMIT_REACHED,       ///< the distance limit was reached, or all target vertices were: what is nearer has its distance
  STOPPED,             ///< the visitor asked for an early end
  NO_SOURCE,           ///< there is no source
  NOT_A_TRIANGLE_MESH, ///< a face has not three vertices
  POINT_NOT_FINITE     ///< a coordinate is not a finite number
};

/// \ingroup PkgQuadMeshingGeodesicsRef
/// \brief returns a sentence that describes a status.
inline std::string get_message(Geodesic_distance_status status)
{
  switch(status)
  {
    case Geodesic_distance_status::SUCCESS: return "The distances were computed.";
    case Geodesic_distance_status::LIMIT_REACHED: return "The distances were computed up to the limit.";
    case Geodesic_distance_status::STOPPED: return "The visitor stopped the computation of the distances.";
    case Geodesic_distance_status::NO_SOURCE: return "There is no source to measure distances from.";
    case Geodesic_distance_status::NOT_A_TRIANGLE_MESH: return "The mesh has a face that is not a triangle.";
    case Geodesic_distance_status::POINT_NOT_FINITE: return "A vertex has a coordinate that is not a finite number.";
  }
  return std::string();
}

/*!
 * \ingroup PkgQuadMeshingGeodesicsRef
 * \brief holds what `Geodesic_distance_field::propagate()` has to say about its result.
 */
struct Geodesic_distance_result
{
  /// how it ended
  Geodesic_distance_status status = Geodesic_distance_status::SUCCESS;
  /// the same as a sentence
  std::string message;
  /// the number of windows that are kept at the end, on the edges between groups of faces;
  /// `Geodesic_distance_field::number_of_windows()` tells that of all edges
  std::size_t number_of_windows = 0;
  /// the number of times a window crossed a face
  std::size_t number_of_propagations = 0;
  /// the number of vertices that have no distance
  std::size_t number_of_unreached_vertices = 0;
  /// the largest distance of a vertex
  double maximum_distance = 0;
  /// the wall-clock time in seconds
  double seconds = 0;

  /// returns whether all distances that were asked for are there.
  explicit operator bool() const
  {
    return status == Geodesic_distance_status::SUCCESS || status == Geodesic_distance_status::LIMIT_REACHED;
  }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_GEODESIC_DISTANCE_RESULT_H
