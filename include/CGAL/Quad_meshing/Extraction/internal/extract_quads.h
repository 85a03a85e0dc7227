// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_EXTRACT_QUADS_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_EXTRACT_QUADS_H

#include <CGAL/Quad_meshing/Extraction/Quad_extraction_result.h>
#include <CGAL/Quad_meshing/Extraction/internal/Grid_graph.h>
#include <CGAL/Quad_meshing/Extraction/internal/Grid_location.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A quad mesh as the faces of a grid graph. Rays that bound a face have a vertex at their start.
struct Extracted_quads
{
  Grid_graph graph;
  std::vector<int> vertex_of_ray;      // -1 at rays without faces
  std::vector<Grid_location> vertices; // where they lie on the triangle mesh
};

// Triangles that are not positive are visited so often to unfold them; chains of them need several visits.
const int default_unfolding_sweeps = 20;

// Extracts the quad mesh of a map and fills in the result. `uv` per halfedge: the image of its source in the chart of
// its face. The vertices of the mesh must be manifold. Returns whether there is a mesh.
CGAL_QUAD_MESHING_INLINE bool extract_quads(const Indexed_triangle_mesh& mesh,
                                            const std::vector<std::array<double, 2>>& uv, Any_visitor& visitor,
                                            Extracted_quads& quads, Quad_extraction_result& result,
                                            int unfolding_sweeps = default_unfolding_sweeps);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Extraction/internal/extract_quads_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_EXTRACT_QUADS_H
