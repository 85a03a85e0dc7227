// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_QUAD_EXTRACTION_RESULT_H
#define CGAL_QUAD_MESHING_EXTRACTION_QUAD_EXTRACTION_RESULT_H

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingExtractionRef
 *
 * \brief says what became of an extraction.
 */
enum class Quad_extraction_status
{
  VALID,      ///< The map is an integer-grid map, and the mesh is the pure quad mesh it stands for.
  NOT_SIMPLE, ///< As `VALID`, but the mesh is so coarse that two of its edges join the same two vertices or a
              ///  face meets itself: it is correct as a halfedge data structure, but cannot be stored as a list of
              ///  faces.
  REPAIRED,   ///< The map is no integer-grid map. There is a manifold mesh; the other members tell what
              ///  was done and whether faces other than quads or holes remain.
  FAILED,     ///< There is no mesh: the message says why. The output mesh was not touched.
  STOPPED     ///< The visitor asked to stop. The output mesh was not touched.
};

/*!
 * \ingroup PkgQuadMeshingExtractionRef
 *
 * \brief returns the name of a status in lower case, for instance `"not_simple"`.
 */
inline const char* status_name(Quad_extraction_status status)
{
  switch(status)
  {
    case Quad_extraction_status::VALID: return "valid";
    case Quad_extraction_status::NOT_SIMPLE: return "not_simple";
    case Quad_extraction_status::REPAIRED: return "repaired";
    case Quad_extraction_status::FAILED: return "failed";
    case Quad_extraction_status::STOPPED: return "stopped";
  }
  return "";
}

/*!
 * \ingroup PkgQuadMeshingExtractionRef
 *
 * \brief is the answer of `extract_quad_mesh()`.
 *
 * Faces of the triangle mesh are named by their index in the face index map.
 */
struct Quad_extraction_result
{
  /// \name Outcome
  /// @{
  Quad_extraction_status status = Quad_extraction_status::FAILED; ///< how it ended
  std::string message;                                            ///< one sentence for the user
  /// @}

  /// \name The Mesh
  /// @{
  std::size_t vertices = 0;                  ///< of the mesh
  std::size_t quads = 0;                     ///< faces with four corners
  std::size_t other_faces = 0;               ///< faces that are no quads
  std::size_t irregular_vertices = 0;        ///< inner vertices of a valence other than 4
  std::size_t irregular_border_vertices = 0; ///< border vertices of a valence other than 3
  std::size_t multiple_edges = 0;            ///< edges that join the same vertices as an edge before, and loops
  bool same_topology = false;                ///< whether the components have the Euler characteristics and border
                                             ///  loops of those of the input
  /// @}

  /// \name The Map
  /// @{
  std::vector<std::size_t> folded_faces; ///< triangles whose image has negative orientation, and could not be unfolded
  std::vector<std::size_t> degenerate_faces; ///< triangles whose image has no area, and could not be unfolded
  std::size_t unfolded_faces = 0;            ///< triangles whose image became positive when vertices were moved
  std::size_t inexact_transitions =
    0; ///< edges over which no automorphism of the grid maps one chart to the other exactly
  std::size_t inconsistent_transitions = 0;   ///< those of them over which it could not be made exact
  std::size_t singular_vertices_off_grid = 0; ///< counted only if something is wrong; each makes a face that is no quad
  double largest_coordinate_change = 0;       ///< how far a coordinate was moved to make the transitions exact
  /// @}

  /// \name What Was Done
  /// @{
  std::size_t edges_cut_by_border = 0; ///< grid edges that the border cuts; they and the cells beside them are left out
  double uncovered_area = 0;           ///< area of the map outside the quads, in grid cells: zero if all borders
                                       ///  run along isolines
  std::size_t cells_with_holes = 0;    ///< grid cells with a whole border loop inside; they are left out
  std::size_t moved_vertices = 0;      ///< vertices whose image was moved to undo fold-overs
  std::size_t cancelled_crossings = 0; ///< pairs of grid points of opposite orientation that were removed
  std::size_t merged_vertices = 0;     ///< copies of a grid point that became one vertex with others
  std::size_t removed_edges = 0;       ///< grid edges that could not be followed or led to nothing
  std::size_t joined_faces = 0;        ///< pairs of faces with an odd number of sides that were joined
  std::size_t split_faces = 0;         ///< faces of more than four sides that were cut into quads
  std::size_t dropped_faces = 0;       ///< closed faces too degenerate to keep
  std::size_t split_vertices = 0;      ///< grid points that became several vertices, to be manifold
  /// @}

  /// returns whether the map is an integer-grid map and the mesh is what it stands for.
  bool is_valid() const { return status == Quad_extraction_status::VALID; }

  /// returns whether a mesh was made and it is all quads.
  bool is_pure() const { return quads > 0 && other_faces == 0; }

  /// returns whether the mesh is a simple manifold mesh of quads only, with the topology of the input, whatever had to
  /// be done for it.
  bool is_usable() const { return is_pure() && same_topology && multiple_edges == 0; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_QUAD_EXTRACTION_RESULT_H
