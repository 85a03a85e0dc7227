// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_COPY_CORNERS_H
#define CGAL_QUAD_MESHING_INTERNAL_COPY_CORNERS_H

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The images of all corners of a map that gives at a halfedge the image of its target in the chart of its face: corner
// 3f+k is the source of halfedge 3f+k of an Indexed_triangle_mesh. `FaceIndexMap` is the one that the flat mesh was
// made with.
template <typename TriangleMesh, typename HalfedgeUVMap, typename FaceIndexMap>
std::vector<std::array<double, 2>> copy_corners(const TriangleMesh& tm, HalfedgeUVMap uv, FaceIndexMap fim)
{
  std::vector<std::array<double, 2>> corners(3 * faces(tm).size()); // at least as many as there are
  for(auto f : faces(tm))
  {
    auto h = halfedge(f, tm);
    const std::size_t i = 3 * static_cast<std::size_t>(get(fim, f));
    for(std::size_t k = 1; k <= 3; ++k)
    {
      const auto& p = get(uv, h);
      corners[i + k % 3] = { { CGAL::to_double(p.x()), CGAL::to_double(p.y()) } };
      h = next(h, tm);
    }
  }
  return corners;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_COPY_CORNERS_H
