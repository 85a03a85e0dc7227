// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_RESULT_H
#define CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_RESULT_H

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/// \ingroup PkgQuadMeshingRef
/// \brief How a quadrangulation ended.
enum class Quadrangulation_status
{
  VALID,         ///< a pure quad mesh with the topology of the input
  NOT_VALID,     ///< there is a mesh, but it is not a pure quad mesh with the topology of the input
  FAILED,        ///< there is no mesh
  INVALID_INPUT, ///< the input cannot be used; nothing was done
  STOPPED,       ///< the visitor asked for an early end; there is no mesh
  OUT_OF_TIME,   ///< the time was up before there was a mesh
  REFUSED        ///< a guide asks for what this surface cannot have; nothing was done
};

/// \ingroup PkgQuadMeshingRef
/// \brief returns the name of a status in lower case, for instance `"not_valid"`.
inline const char* status_name(Quadrangulation_status status)
{
  switch(status)
  {
    case Quadrangulation_status::VALID: return "valid";
    case Quadrangulation_status::NOT_VALID: return "not_valid";
    case Quadrangulation_status::FAILED: return "failed";
    case Quadrangulation_status::INVALID_INPUT: return "invalid_input";
    case Quadrangulation_status::STOPPED: return "stopped";
    case Quadrangulation_status::OUT_OF_TIME: return "out_of_time";
    case Quadrangulation_status::REFUSED: return "refused";
  }
  return "";
}

/*!
\ingroup PkgQuadMeshingRef

\brief A component that has no valid quad mesh, and why.
*/
struct Invalid_component
{
  std::size_t face = 0; ///< the first of its faces, in the numbers of the input
  Quadrangulation_status status = Quadrangulation_status::FAILED; ///< how its quadrangulation ended
  std::string message;                                            ///< as a sentence
};

/*!
\ingroup PkgQuadMeshingRef

\brief The answer of `quadrangulate()`: what became of the mesh, and the figures of all stages.

Figures of stages are sums over the components, and those of the attempts that were taken; times are those of all
attempts.
*/
struct Quadrangulation_result
{
  Quadrangulation_status status = Quadrangulation_status::FAILED;
  /// Whether the mesh is valid and nothing of what was asked for was given up: no feature edge, no length and no number
  /// of quads; and no quad is inverted. If not, the message says what.
  bool is_as_requested = false;
  /// What happened, as a sentence.
  std::string message;

  std::size_t input_faces = 0;
  std::size_t components = 0;
  std::size_t failed_components = 0; ///< of which there is no mesh
  /// Those that have no mesh or one that is not valid; the message names the first of them.
  std::vector<Invalid_component> invalid_components;
  /// The wishes of the user (`Quadrangulation_options`, "Guides") that the mesh does not meet, each with what it is
  /// like instead, without a period; the message lists them.
  std::vector<std::string> unmet_guides;
  std::size_t divided_vertices = 0; ///< vertices in which borders touch; each fan of triangles has one of its own

  /// The edge length that was used, in the unit of the points; that of the largest component, if it differs between
  /// them.
  double target_edge_length = 0;
  /// How many components got shorter edges than that, as they had no room for a mesh else.
  std::size_t refined_components = 0;
  std::size_t feature_edges = 0;         ///< sharp edges of the input that were kept
  std::size_t dropped_feature_edges = 0; ///< sharp edges that were taken for noise
  /// The part, from 0 to 1, of the length of the `feature_edges` that was not followed, as no map without fold-overs
  /// could do so.
  double released_feature_share = 0;
  std::size_t prepared_faces = 0; ///< triangles after edges were split

  int singularities = 0; ///< vertices of the field with an index other than zero
  int field_integers = 0;
  double field_energy = 0;
  double field_seconds = 0;

  int parameterization_integers = 0;
  double parameterization_energy = 0;
  double relaxed_parameterization_energy = 0;
  double parameterization_seconds = 0;
  int parameterization_attempts = 0; ///< maps that were computed
  std::size_t flipped_triangles = 0; ///< of the map that was taken

  std::size_t quads = 0;
  std::size_t other_faces = 0;
  std::size_t irregular_vertices = 0;
  double extraction_seconds = 0;

  std::size_t folded_quads = 0; ///< after the smoothing
  double smoothing_seconds = 0;
  /// Components that were asked to be semi-regular, but kept the quads that the optimization of the structure made.
  std::size_t not_semi_regular_components = 0;
  double layout_seconds = 0;    ///< of the quads along the base complex
  double structure_seconds = 0; ///< of the optimization of the structure, its smoothing included

  double total_seconds = 0;

  /// Whether there is a pure quad mesh with the topology of the input.
  bool is_valid() const { return status == Quadrangulation_status::VALID; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_RESULT_H
