// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_LAYOUT_QUADRANGULATION_RESULT_H
#define CGAL_QUAD_MESHING_LAYOUT_LAYOUT_QUADRANGULATION_RESULT_H

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief says which arcs of a layout quad edges have to represent.
 */
enum class Arc_alignment
{
  TAGGED,   ///< those with `Surface_layout::Arc::is_aligned`
  FEATURES, ///< these, and those that run along constrained edges of the mesh
  ALL       ///< all of them
};

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief is the outcome of `quadrangulate_layout()`.
 */
enum class Layout_quadrangulation_status
{
  VALID,      ///< there is a quad mesh
  BAD_MESH,   ///< the triangle mesh has no faces, no area, a vertex that is not manifold or not finite
  BAD_LAYOUT, ///< the layout is none of this mesh; the message names what is wrong
  FAILED,     ///< no quad mesh was found
  STOPPED     ///< the visitor asked for an early end
};

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief returns the name of the enumerator in lower case.
 */
inline const char* status_name(Layout_quadrangulation_status status)
{
  switch(status)
  {
    case Layout_quadrangulation_status::VALID: return "valid";
    case Layout_quadrangulation_status::BAD_MESH: return "bad_mesh";
    case Layout_quadrangulation_status::BAD_LAYOUT: return "bad_layout";
    case Layout_quadrangulation_status::FAILED: return "failed";
    case Layout_quadrangulation_status::STOPPED: return "stopped";
  }
  return "unknown";
}

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief tells what `quadrangulate_layout()` did.
 */
struct Layout_quadrangulation_result
{
  Layout_quadrangulation_status status = Layout_quadrangulation_status::FAILED; ///< the outcome
  std::string message;                                                          ///< the outcome as a sentence

  std::size_t nodes = 0;      ///< of the layout
  std::size_t arcs = 0;       ///< of the layout
  std::size_t patches = 0;    ///< of the layout
  std::size_t t_vertices = 0; ///< of the layout
  std::size_t vertices = 0;   ///< of the quad mesh
  std::size_t quads = 0;      ///< of the quad mesh

  /// per computed parameterization, with all arcs aligned: the isometry energy of the triangles, \f$ |J^T J - I|^2 \f$,
  /// averaged over the area. It never rises.
  std::vector<double> energies;
  std::vector<std::size_t> segments;    ///< per arc: the number of quad edges along it
  std::size_t quadrilateral_charts = 0; ///< charts with five degrees of freedom
  std::size_t aligned_arcs = 0;         ///< arcs that had to be aligned, by wish
  std::size_t forced_arcs = 0; ///< arcs that were aligned without being asked for, since the map was folded otherwise
  std::size_t untangled_patches = 0; ///< patches whose map was computed anew, with positive weights
  std::size_t folded_patches = 0;    ///< those of them that remain folded: triangles without area make it possible
  std::size_t inverted_quads = 0;    ///< quads that are inverted on the surface, after others have been straightened
  double feature_length = 0;         ///< the length of all constrained edges of the mesh
  double feature_length_on_arcs = 0; ///< the part of it that arcs run along

  /// whether there is a quad mesh.
  bool is_valid() const { return status == Layout_quadrangulation_status::VALID; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_LAYOUT_QUADRANGULATION_RESULT_H
