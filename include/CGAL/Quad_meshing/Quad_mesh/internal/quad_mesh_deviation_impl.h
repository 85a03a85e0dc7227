// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_DEVIATION_IMPL_H
#define CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_DEVIATION_IMPL_H

#include <CGAL/Quad_meshing/Quad_mesh/internal/quad_mesh_quality_impl.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_deviation.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_reference.h>
#include <CGAL/Quad_meshing/internal/Quad_shape.h>
#include <CGAL/Quad_meshing/internal/Reference_surface.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The share of the length of some segments that lies on edges of a quad mesh: within a tenth of the
// mean edge length, and along an edge that differs by less than 25 degrees in direction.
inline double share_on_edges(const std::vector<std::array<Shape_point_3, 2>>& segments,
                             const std::vector<std::array<Shape_point_3, 2>>& edges, double mean_edge)
{
  constexpr double tolerance = 0.1, sample_step = 0.1, largest_turn = 25;
  const double reach = tolerance * mean_edge, cosine = std::cos(largest_turn * CGAL_PI / 180);

  // edges cut into pieces, in a grid of cubes with the mean edge as side
  typedef std::array<int, 3> Cell;
  auto cell_of = [&](const Shape_point_3& p)
  {
    return Cell{ { static_cast<int>(std::floor(p.x() / mean_edge)), static_cast<int>(std::floor(p.y() / mean_edge)),
                   static_cast<int>(std::floor(p.z() / mean_edge)) } };
  };
  std::map<Cell, std::vector<int>> grid;
  for(std::size_t e = 0; e < edges.size(); ++e)
  {
    const Shape_vector_3 d = edges[e][1] - edges[e][0];
    const int pieces = 1 + static_cast<int>(2 * std::sqrt(d.squared_length()) / mean_edge);
    for(int i = 0; i <= pieces; ++i)
    {
      std::vector<int>& cell = grid[cell_of(edges[e][0] + (double(i) / pieces) * d)];
      if(cell.empty() || cell.back() != static_cast<int>(e))
        cell.push_back(static_cast<int>(e));
    }
  }
  auto is_on_edge = [&](const Shape_point_3& p, const Shape_vector_3& direction)
  {
    const Cell c = cell_of(p);
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z)
        {
          const auto found = grid.find(Cell{ { c[0] + x, c[1] + y, c[2] + z } });
          if(found == grid.end())
            continue;
          for(int e : found->second)
          {
            const Shape_vector_3 d = edges[e][1] - edges[e][0];
            const double l = d.squared_length();
            const double t = l > 0 ? (std::min)(1., (std::max)(0., ((p - edges[e][0]) * d) / l)) : 0;
            if(squared_distance(p, edges[e][0] + t * d) <= reach * reach &&
               CGAL::abs(d * direction) >= cosine * std::sqrt(l))
              return true;
          }
        }
    return false;
  };

  double sum = 0, kept = 0;
  for(const std::array<Shape_point_3, 2>& s : segments)
  {
    const Shape_vector_3 d = s[1] - s[0];
    const double length = std::sqrt(d.squared_length());
    if(!(length > 0))
      continue;
    const int samples = (std::max)(1, static_cast<int>(std::ceil(length / (sample_step * mean_edge))));
    int on_edge = 0;
    for(int i = 0; i < samples; ++i)
      on_edge += is_on_edge(s[0] + ((i + 0.5) / samples) * d, d / length);
    sum += length;
    kept += length * on_edge / samples;
  }
  return sum > 0 ? kept / sum : 1;
}

// The angles between the edges of a quad mesh and the directions of the reference nearby.
inline void measure_orientation(const Indexed_quad_mesh& m, const Indexed_reference& original, double mean_edge,
                                Quad_mesh_deviation& d)
{
  // The faces that have directions, each by itself: walks do not lead from one to another, the nearest one counts.
  const Indexed_directions& directions = original.directions;
  Indexed_triangle_mesh oriented;
  std::vector<Shape_vector_3> direction;
  for(std::size_t f = 0; f < directions.direction.size(); ++f)
  {
    const std::array<int, 3>& c = original.mesh.corners[f];
    const auto &p = original.mesh.points[c[0]], &q = original.mesh.points[c[1]], &r = original.mesh.points[c[2]];
    const Shape_vector_3 normal = unit_or_zero(cross_product(q - p, r - p));
    const Shape_vector_3 along = unit_or_zero(directions.direction[f] - (directions.direction[f] * normal) * normal);
    if(normal == NULL_VECTOR || along == NULL_VECTOR || !(directions.weight[f] > 0))
      continue;
    const int first = oriented.number_of_vertices();
    oriented.points.insert(oriented.points.end(), { p, q, r });
    oriented.corners.push_back({ { first, first + 1, first + 2 } });
    for(int k = 0; k < 3; ++k)
      oriented.halfedge_of_vertex.push_back(3 * static_cast<int>(direction.size()) + k);
    direction.push_back(along);
  }
  if(direction.empty())
    return;
  oriented.opposite.assign(3 * direction.size(), -1);
  Reference_surface surface(std::move(oriented));

  constexpr double degree = CGAL_PI / 180, over = 15, bin = 5;
  int hint = 0;
  for(int h = 0; h < m.number_of_halfedges(); ++h)
  {
    if(m.edge(h) != h)
      continue;
    const Shape_point_3 &p = m.points[m.source(h)], &q = m.points[m.target(h)];
    const Reference_surface::Location l = surface.locate(midpoint(p, q), hint);
    hint = l.face;
    if(!(squared_distance(l.point, midpoint(p, q)) < mean_edge * mean_edge))
      continue;
    const Shape_vector_3 &along = direction[l.face], across = cross_product(surface.normal(l.face), along);
    const double x = CGAL::abs((q - p) * along), y = CGAL::abs((q - p) * across);
    if(!(x > 0 || y > 0))
      continue;
    const double angle = std::atan2((std::min)(x, y), (std::max)(x, y)) / degree;
    ++d.oriented_edges;
    d.orientation_deviation_mean += angle;
    d.orientation_over_15 += angle > over;
    ++d.orientation_histogram[(std::min)(static_cast<int>(angle / bin), 8)];
  }
  if(d.oriented_edges == 0)
    return;
  d.orientation_deviation_mean /= static_cast<double>(d.oriented_edges);
  d.orientation_over_15 /= static_cast<double>(d.oriented_edges);
}

CGAL_QUAD_MESHING_INLINE Quad_mesh_deviation deviation_of_quad_mesh(const Indexed_quad_mesh& m,
                                                                    const Indexed_reference& original)
{
  typedef Shape_point_3 Point_3;
  typedef Shape_vector_3 Vector_3;
  const Indexed_triangle_mesh& t = original.mesh;
  Reference_surface reference(t), quads(triangulated_quad_mesh(m));

  Quad_mesh_deviation d;
  Bbox_3 box;
  for(const std::array<int, 3>& c : t.corners)
    for(int v : c)
      box += t.points[v].bbox();
  const double diagonal =
    std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
  const double mean_edge = quality_of_quad_mesh(m).mean_edge_length;

  std::size_t samples = 0;
  int hint = -1;
  auto measure = [&](Reference_surface& surface, const Point_3& p, double& largest, double& sum)
  {
    const Reference_surface::Location l = surface.locate(p, hint);
    hint = l.face;
    const double distance = squared_distance(p, l.point);
    largest = (std::max)(largest, std::sqrt(distance) / diagonal);
    sum += distance;
    ++samples;
  };
  double sum = 0;
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    Vector_3 middle(0, 0, 0);
    for(int h = 4 * f; h < 4 * f + 4; ++h)
    {
      const Point_3 &p = m.points[m.source(h)], &q = m.points[m.target(h)];
      measure(reference, p, d.quads_to_reference_max, sum);
      if(m.edge(h) == h)
        measure(reference, midpoint(p, q), d.quads_to_reference_max, sum);
      middle = middle + (p - ORIGIN) / 4;
    }
    measure(reference, ORIGIN + middle, d.quads_to_reference_max, sum);
    const Quad_shape shape = shape_of_quad(m, f);
    d.opposed_quads += shape.normal * reference.normal(hint) < 0 ? 1. / m.number_of_faces() : 0;
  }
  d.quads_to_reference_rms = std::sqrt(sum / samples) / diagonal;

  sum = 0;
  samples = 0;
  hint = -1;
  for(int f = 0; f < t.number_of_faces(); ++f)
  {
    const std::array<int, 3>& c = t.corners[f];
    measure(quads, centroid(t.points[c[0]], t.points[c[1]], t.points[c[2]]), d.reference_to_quads_max, sum);
    for(int v : c)
      if(t.halfedge_of_vertex[v] / 3 == f)
        measure(quads, t.points[v], d.reference_to_quads_max, sum);
  }
  d.reference_to_quads_rms = std::sqrt(sum / samples) / diagonal;

  typedef std::array<Point_3, 2> Segment;
  std::vector<Segment> features, boundary, edges_of_quads, boundary_of_quads;
  auto add = [&](const Curve_segments& curves, std::vector<Segment>& segments, double& length)
  {
    for(const std::array<int, 2>& s : curves)
    {
      segments.push_back({ { t.points[s[0]], t.points[s[1]] } });
      length += std::sqrt(squared_distance(t.points[s[0]], t.points[s[1]])) / mean_edge;
    }
  };
  add(original.features, features, d.feature_length);
  add(original.borders, boundary, d.boundary_length);
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(m.edge(h) == h)
    {
      const Segment s{ { m.points[m.source(h)], m.points[m.target(h)] } };
      edges_of_quads.push_back(s);
      if(m.is_border(h))
        boundary_of_quads.push_back(s);
    }
  d.features_kept = share_on_edges(features, edges_of_quads, mean_edge);
  d.boundary_kept = share_on_edges(boundary, boundary_of_quads, mean_edge);
  measure_orientation(m, original, mean_edge, d);
  return d;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_DEVIATION_IMPL_H
