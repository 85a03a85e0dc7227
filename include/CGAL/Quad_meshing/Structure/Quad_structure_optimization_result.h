// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_QUAD_STRUCTURE_OPTIMIZATION_RESULT_H
#define CGAL_QUAD_MESHING_STRUCTURE_QUAD_STRUCTURE_OPTIMIZATION_RESULT_H

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Smoothing/Quad_mesh_smoothing_result.h>
#include <CGAL/Quad_meshing/Smoothing/Quad_mesh_status.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief is the way in which `optimize_quad_structure()` proceeds.
 */
enum class Structure_method
{
  LAYOUT, ///< looks for a coarse layout of the whole mesh, then multiplies its dual curves
  HELICES ///< removes helices one by one
};

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief tells what `optimize_quad_structure()` did.
 */
struct Quad_structure_optimization_result
{
  Quad_mesh_status status = Quad_mesh_status::SUCCESS; ///< the outcome
  std::string message;                                 ///< the outcome as a sentence
  bool is_time_up = false;                             ///< whether `maximum_running_time` ended the search
  std::size_t operators_applied = 0;                   ///< number of grid-preserving operators applied one by one
  Quad_mesh_structure structure_before;                ///< structure of the input
  Quad_mesh_structure structure_after;                 ///< structure of the output
  /// what the smoothing at the end did. Its input is the mesh after the last operator.
  Quad_mesh_smoothing_result smoothing;

  /// whether the structure has been optimized.
  bool is_valid() const { return status == Quad_mesh_status::SUCCESS; }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_QUAD_STRUCTURE_OPTIMIZATION_RESULT_H
