// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_LOCATE_ON_INPUT_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_LOCATE_ON_INPUT_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Triangle_input.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Barycentric weights of a point of the triangle; of the nearest corner if the triangle has no area.
inline std::array<double, 3> triangle_weights(const Quadrangulation_kernel::Point_3& p,
                                              const std::array<Quadrangulation_kernel::Point_3, 3>& t)
{
  const auto n = cross_product(t[1] - t[0], t[2] - t[0]);
  const double area = n * n;
  std::array<double, 3> w = { { 0, 0, 0 } };
  if(!(area > 0))
  {
    int nearest = 0;
    for(int k = 1; k < 3; ++k)
      if(squared_distance(p, t[k]) < squared_distance(p, t[nearest]))
        nearest = k;
    w[nearest] = 1;
    return w;
  }
  double sum = 0;
  for(int k = 0; k < 3; ++k)
  {
    w[k] = (std::max)(0., (cross_product(t[(k + 1) % 3] - p, t[(k + 2) % 3] - p) * n) / area);
    sum += w[k];
  }
  for(double& x : w)
    x /= sum;
  return w;
}

// Where a vertex of the quads lies on the input: the number of its face and the weights of that face's corners.
inline std::pair<std::size_t, std::array<double, 3>>
locate_on_input(const Triangle_input& input, const Quadrangulation_quads& quads, Quadrangulation_mesh::Vertex_index v)
{
  const std::size_t i = quads.input_face[v];
  const std::array<int, 3>& c = input.triangles[i];
  return std::make_pair(
    i, triangle_weights(quads.mesh.point(v), { { input.points[c[0]], input.points[c[1]], input.points[c[2]] } }));
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_LOCATE_ON_INPUT_H
