// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_INSPECT_FIELD_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_INSPECT_FIELD_H

#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What does not fit together in a cross field, by numbers of simplices, ascending.
struct Field_defects
{
  std::vector<int> faces_not_finite;
  std::vector<int> misaligned_edges;       // aligned edges that the cross of a face at them does not follow
  std::vector<int> edges_with_wrong_jump;  // aligned edges across which the jump turns the direction along the edge
  std::vector<int> vertices_without_quads; // vertices with a sector of no quad, or less
  std::vector<int> indices;                // per vertex, in quarters
  int index_sum = 0;
  int expected_index_sum = 0; // if the border is aligned
};

// `problem` needs its aligned edges and its sectors. If an angle is not finite nothing else is looked at.
CGAL_QUAD_MESHING_INLINE Field_defects inspect_field(const Field_problem& problem, const Cross_field& field);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Fields/internal/inspect_field_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_INSPECT_FIELD_H
