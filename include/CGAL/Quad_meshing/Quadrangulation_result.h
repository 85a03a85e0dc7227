// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUADRANGULATION_RESULT_H
#define CGAL_QUAD_MESHING_QUADRANGULATION_RESULT_H

#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingRef

\brief The answer of `quadrangulate()`: what became of the mesh, and the figures of all stages.
*/
struct Quadrangulation_result
{
  /// How it ended.
  enum Status
  {
    VALID = 0,      ///< a pure quad mesh with the topology of the input
    NOT_VALID,      ///< there is a mesh, but it is not a pure quad mesh with the topology of the input
    FAILED,         ///< there is no mesh
    INVALID_INPUT,  ///< the input cannot be used; nothing was done
    STOPPED         ///< the visitor asked for an early end; there is no mesh
  };

  Status status = FAILED;
  /// What happened, as a sentence.
  std::string message;

  std::size_t input_faces = 0;
  std::size_t components = 0;

  /// The edge length that was used, in the unit of the points.
  double target_edge_length = 0;
  std::size_t feature_edges = 0;            ///< sharp edges of the input that were kept
  std::size_t dropped_feature_edges = 0;    ///< sharp edges that were taken for noise
  /// The part, from 0 to 1, of the length of the `feature_edges` that was not followed, as no map without fold-overs could do so.
  double released_feature_share = 0;
  std::size_t prepared_faces = 0;           ///< triangles after edges were split

  int singularities = 0;                    ///< vertices of the field with an index other than zero
  int field_integers = 0;
  double field_energy = 0;
  double field_seconds = 0;

  int parameterization_integers = 0;
  double parameterization_energy = 0;
  double relaxed_parameterization_energy = 0;
  double parameterization_seconds = 0;
  int parameterization_attempts = 0;        ///< maps that were computed until one had no fold-over
  std::size_t flipped_triangles = 0;        ///< of the map that was taken

  std::size_t quads = 0;
  std::size_t other_faces = 0;
  std::size_t irregular_vertices = 0;
  double extraction_seconds = 0;

  std::size_t folded_quads = 0;             ///< after the smoothing
  double smoothing_seconds = 0;
  double structure_seconds = 0;             ///< of the optimization of the structure, its smoothing included

  double total_seconds = 0;

  /// Whether there is a pure quad mesh with the topology of the input.
  bool is_valid() const { return status == VALID; }
};

/// \ingroup PkgQuadMeshingRef
/// \brief returns the name of a status in lower case, for instance `"not_valid"`.
inline const char* status_name(Quadrangulation_result::Status status)
{
  static const char* const names[] = { "valid", "not_valid", "failed", "invalid_input", "stopped" };
  static_assert(sizeof(names) / sizeof(names[0]) == Quadrangulation_result::STOPPED + 1, "every status needs a name");
  return names[status];
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUADRANGULATION_RESULT_H
