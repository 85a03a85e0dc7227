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
#include <CGAL/Quad_meshing/Fields/internal/Sharp_bands.h>
#include <CGAL/Quad_meshing/Fields/internal/bridge_creases.h>
#include <CGAL/Quad_meshing/Fields/internal/find_feature_edges.h>
#include <CGAL/Quad_meshing/Fields/internal/find_sharp_edges.h>
#include <CGAL/Quad_meshing/Fields/internal/merge_narrow_patches.h>
#include <CGAL/Quad_meshing/Fields/internal/straighten_creases.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

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
  {
    Sharp_bands(m, angle_in_degrees, target_edge_length).mark(is_sharp);
    Crease_straightening(m, is_sharp).run();
  }
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
    is_feature[e] = is_sharp[e] && creases.is_kept[i++];
  if(knows_noise)
    bridge_creases(m, angle_in_degrees, target_edge_length, is_feature);
  for(int e = 0; e < m.number_of_edges(); ++e)
  {
    const double length = std::sqrt(m.vector(m.halfedge_of_edge[e]).squared_length());
    if(is_feature[e])
    {
      ++result.number_of_edges;
      result.length += length;
    }
    else if(is_sharp[e] || is_sharp_at_first[e])
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
