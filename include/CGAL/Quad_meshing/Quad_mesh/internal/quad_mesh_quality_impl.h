// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_QUALITY_IMPL_H
#define CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_QUALITY_IMPL_H

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_shape.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

inline Quad_shape shape_of_quad(const Indexed_quad_mesh& m, int f)
{
  const std::array<int, 4>& c = m.corners[f];
  return shape_of_quad({ { m.points[c[0]], m.points[c[1]], m.points[c[2]], m.points[c[3]] } });
}

CGAL_QUAD_MESHING_INLINE Quad_mesh_quality quality_of_quad_mesh(const Indexed_quad_mesh& m)
{
  Quad_mesh_quality q;
  const std::size_t n = m.corners.size();
  q.number_of_quads = n;
  if(n == 0)
    return q;

  q.minimal_angle = 360;
  q.minimal_scaled_jacobian = 1;
  std::vector<double> lengths;
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    const Quad_shape s = shape_of_quad(m, f);
    for(int k = 0; k < 4; ++k)
    {
      const double a = s.angle[k], deviation = CGAL::abs(a - 90);
      q.mean_angle_deviation += deviation / (4 * n);
      q.maximal_angle_deviation = (std::max)(q.maximal_angle_deviation, deviation);
      q.minimal_angle = (std::min)(q.minimal_angle, a);
      q.maximal_angle = (std::max)(q.maximal_angle, a);
      ++q.angle_histogram[(std::min)(18, static_cast<int>(a / 10))];
      if(m.edge(4 * f + k) == 4 * f + k)
        lengths.push_back(s.length[k]);
    }
    const double sj = s.minimal_scaled_jacobian();
    q.mean_scaled_jacobian += sj / n;
    q.minimal_scaled_jacobian = (std::min)(q.minimal_scaled_jacobian, sj);
    q.number_of_inverted_quads += !(sj > 0);
    ++q.scaled_jacobian_histogram[sj > 0 ? 1 + (std::min)(9, static_cast<int>(sj * 10)) : 0];
    q.mean_planarity += s.planarity / n;
    q.maximal_planarity = (std::max)(q.maximal_planarity, s.planarity);
    q.mean_aspect_ratio += s.aspect_ratio() / n;
    q.maximal_aspect_ratio = (std::max)(q.maximal_aspect_ratio, s.aspect_ratio());
    q.area += s.area;
  }

  q.mean_edge_length = std::accumulate(lengths.begin(), lengths.end(), 0.) / lengths.size();
  q.minimal_edge_length = *std::min_element(lengths.begin(), lengths.end());
  q.maximal_edge_length = *std::max_element(lengths.begin(), lengths.end());
  double variance = 0;
  for(double l : lengths)
  {
    variance += CGAL::square(l - q.mean_edge_length) / lengths.size();
    if(q.mean_edge_length > 0)
      ++q.edge_length_histogram[static_cast<int>((std::min)(20., 10 * l / q.mean_edge_length))];
  }
  q.edge_length_variation = q.mean_edge_length > 0 ? std::sqrt(variance) / q.mean_edge_length : 0;
  return q;
}

CGAL_QUAD_MESHING_INLINE std::vector<std::pair<double, int>> worst_quads_of(const Indexed_quad_mesh& m,
                                                                            std::size_t number)
{
  std::vector<std::pair<double, int>> order;
  for(int f = 0; f < m.number_of_faces(); ++f)
    order.emplace_back(shape_of_quad(m, f).minimal_scaled_jacobian(), f);
  number = (std::min)(number, order.size());
  std::partial_sort(order.begin(), order.begin() + number, order.end());
  order.resize(number);
  return order;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_QUALITY_IMPL_H
