// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUADRANGULATE_INDEXED_LAYOUT_IMPL_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUADRANGULATE_INDEXED_LAYOUT_IMPL_H

#include <CGAL/Quad_meshing/Layout/internal/Layout_quadrangulator.h>
#include <CGAL/Quad_meshing/Layout/internal/quadrangulate_indexed_layout.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Layout_quadrangulation_result quadrangulate_indexed_layout(
  const Indexed_triangle_mesh& mesh, const std::vector<char>& is_feature, const Surface_layout& layout,
  const Layout_options& options, Any_visitor& visitor, Layout_quads& quads)
{
  Layout_quadrangulator quadrangulator(mesh, is_feature, layout, options, visitor);
  quadrangulator.run();
  if(quadrangulator.result.is_valid())
    quads = std::move(quadrangulator.quads);
  return quadrangulator.result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUADRANGULATE_INDEXED_LAYOUT_IMPL_H
