// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_EXTRACT_QUADS_IMPL_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_EXTRACT_QUADS_IMPL_H

#include <CGAL/Quad_meshing/Extraction/internal/Quad_extractor.h>
#include <CGAL/Quad_meshing/Extraction/internal/extract_quads.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE bool extract_quads(const Indexed_triangle_mesh& mesh,
                                            const std::vector<std::array<double, 2>>& uv, Any_visitor& visitor,
                                            Extracted_quads& quads, Quad_extraction_result& result,
                                            int unfolding_sweeps)
{
  const Visited_stage stage(visitor, "extraction");
  Stage_progress progress(visitor);
  Grid_map map(mesh);
  map.uv.resize(mesh.number_of_halfedges());
  for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    map.uv[h] = Grid_map::Point_2(uv[h][0], uv[h][1]);
  return Quad_extractor(map, quads, result, progress, unfolding_sweeps).run();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_EXTRACT_QUADS_IMPL_H
