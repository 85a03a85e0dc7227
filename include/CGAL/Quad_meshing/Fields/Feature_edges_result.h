// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_RESULT_H
#define CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_RESULT_H

#include <cstddef>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingFieldsRef

\brief The answer of `detect_feature_edges()`.
*/
struct Feature_edges_result
{
  /// The number of edges marked.
  std::size_t number_of_edges = 0;
  /// Their total length.
  double length = 0;
  /// The number of edges with a sharp angle that were not marked.
  std::size_t number_of_dropped_edges = 0;
  /// The total length of those.
  double dropped_length = 0;
  /// The number of pieces that were dropped: whole components of the graph of sharp edges, dangling branches, and sides
  /// of narrow patches.
  std::size_t number_of_dropped_pieces = 0;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_FEATURE_EDGES_RESULT_H
