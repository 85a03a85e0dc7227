// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_EDGES_IMPL_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_EDGES_IMPL_H

#include <CGAL/Quad_meshing/Fields/internal/Crease_graph.h>
#include <CGAL/Quad_meshing/Fields/internal/find_feature_edges.h>
#include <CGAL/Quad_meshing/Fields/internal/merge_narrow_patches.h>
#include <CGAL/Quad_meshing/Fields/internal/straighten_creases.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The inner edges at which the normals of the two faces differ by at least an angle below 180 degrees. Faces are
// compared by the signs and squares of products of their area vectors, as
// `Polygon_mesh_processing::detect_sharp_edges()` does: no square root rounds, and at a face without area every edge is
// sharp for angles of up to 90 degrees.
inline std::vector<char> find_sharp_edges(const Indexed_triangle_mesh& m, double angle_in_degrees)
{
  const double cosine = std::cos(angle_in_degrees * CGAL_PI / 180), squared_cosine = cosine * cosine;
  std::vector<char> is_sharp(m.number_of_edges(), false);
  for(int e = 0; e < m.number_of_edges(); ++e)
  {
    const int h = m.halfedge_of_edge[e], o = m.opposite[h];
    if(o == -1)
      continue;
    const Indexed_triangle_mesh::Point_3& p = m.points[m.source(h)];
    const auto along = m.points[m.target(h)] - p;
    const auto n1 = cross_product(along, m.points[m.source(m.prev(h))] - p);
    const auto n2 = cross_product(along, p - m.points[m.source(m.prev(o))]);
    const double product = n1 * n2;
    const double bound = squared_cosine * n1.squared_length() * n2.squared_length();
    if(angle_in_degrees == 0)
      is_sharp[e] = true;
    else if(cosine < 0)
      is_sharp[e] = product < 0 && product * product >= bound;
    else
      is_sharp[e] = product < 0 || product * product <= bound;
  }
  return is_sharp;
}

CGAL_QUAD_MESHING_INLINE Feature_edges_result find_feature_edges(const Indexed_triangle_mesh& m,
                                                                 double angle_in_degrees, double target_edge_length,
                                                                 std::vector<char>& is_feature)
{
  Feature_edges_result result;
  is_feature.assign(m.number_of_edges(), false);
  if(angle_in_degrees >= 180)
    return result;

  // Half a quad of a grid of twice the density: nothing can be followed on both sides there.
  const double least_width = target_edge_length / 4;
  std::vector<char> is_sharp = find_sharp_edges(m, angle_in_degrees);
  const std::vector<char> is_sharp_at_first = is_sharp;
  // Before, so that a sliver does not part two patches; after, for what is left of narrow patches may run to and fro.
  const bool knows_noise = target_edge_length > 0;
  if(knows_noise)
    Crease_straightening(m, is_sharp).run();
  result.number_of_dropped_pieces = merge_narrow_patches(m, least_width, is_sharp);
  if(knows_noise)
    Crease_straightening(m, is_sharp).run();
  std::vector<int> sharp_edges; // in the order of the graph
  for(int e = 0; e < m.number_of_edges(); ++e)
    if(is_sharp[e] || is_sharp_at_first[e])
      sharp_edges.push_back(e);

  Crease_graph creases(m.points);
  for(int e = 0; e < m.number_of_edges(); ++e)
  {
    const int h = m.halfedge_of_edge[e];
    if(m.is_border_edge(e))
      creases.is_held[m.source(h)] = creases.is_held[m.target(h)] = true;
    else if(is_sharp[e])
      creases.add_edge(m.source(h), m.target(h));
  }
  result.number_of_dropped_pieces += creases.drop_noise(target_edge_length);
  int i = 0; // in the graph
  for(int e : sharp_edges)
  {
    const double length = std::sqrt(m.vector(m.halfedge_of_edge[e]).squared_length());
    if(is_sharp[e] && creases.is_kept[i++])
    {
      is_feature[e] = true;
      ++result.number_of_edges;
      result.length += length;
    }
    else
    {
      ++result.number_of_dropped_edges;
      result.dropped_length += length;
    }
  }
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_EDGES_IMPL_H
