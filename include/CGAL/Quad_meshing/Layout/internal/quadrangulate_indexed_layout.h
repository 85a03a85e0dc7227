// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUADRANGULATE_INDEXED_LAYOUT_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUADRANGULATE_INDEXED_LAYOUT_H

#include <CGAL/Quad_meshing/Layout/Layout_quadrangulation_result.h>
#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/Mixed_integer/Rounding_method.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The named parameters of `quadrangulate_layout()`.
struct Layout_options
{
  double edge_length = 0; // 0: from the number of quads
  double number_of_quads = 4000;
  Layout_chart chart = Layout_chart::AUTOMATIC;
  Arc_alignment alignment = Arc_alignment::FEATURES;
  unsigned int iterations = 3;
  bool mean_value_weights = false;
  bool least_squares_alignment = false;
  Rounding_method rounding = Rounding_method::BRANCH_AND_BOUND;
};

// A quad mesh and what it was made of.
struct Layout_quads
{
  Indexed_quad_mesh mesh;
  std::vector<int> patch; // per quad
};

// Makes quads along a layout. `is_feature` tells the constrained edges of the mesh, per halfedge.
CGAL_QUAD_MESHING_INLINE Layout_quadrangulation_result quadrangulate_indexed_layout(
  const Indexed_triangle_mesh& mesh, const std::vector<char>& is_feature, const Surface_layout& layout,
  const Layout_options& options, Any_visitor& visitor, Layout_quads& quads);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Layout/internal/quadrangulate_indexed_layout_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUADRANGULATE_INDEXED_LAYOUT_H
