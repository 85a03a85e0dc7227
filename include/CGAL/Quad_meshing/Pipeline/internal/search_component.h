// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SEARCH_COMPONENT_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SEARCH_COMPONENT_H

#include <CGAL/Quad_meshing/Pipeline/internal/Grid_map_search.h>

#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

template <typename Range, typename T, typename Map>
void assign_in_order(const Range& range, const std::vector<T>& values, Map map)
{
  std::size_t i = 0;
  for(auto x : range)
    map[x] = values[i++];
}

// Field, map and figures of an attempt.
inline void take_attempt(const Grid_map_attempt& attempt, const Grid_map_search::Options& options,
                         Quadrangulation_surface& surface, Quadrangulation_result& result)
{
  const Field_attempt& field = *attempt.field;
  assign_in_order(surface.mesh.edges(), field.is_feature, surface.is_feature);
  assign_in_order(surface.mesh.faces(), field.angle, surface.angle);
  assign_in_order(surface.mesh.edges(), field.period_jump, surface.period_jump);
  assign_in_order(surface.mesh.vertices(), field.index, surface.index);
  assign_in_order(surface.mesh.halfedges(), attempt.uv, surface.uv);
  if(attempt.t_mesh)
    surface.t_meshes.push_back(attempt.t_mesh);
  result.released_feature_share = options.releasable_length > 0 ? field.released_length / options.releasable_length : 0;
  result.singularities = field.singularities;
  result.field_integers = field.integers;
  result.field_energy = field.energy;
  result.target_edge_length = attempt.length() * options.length;
  result.parameterization_integers = attempt.integers;
  result.parameterization_energy = attempt.energy;
  result.relaxed_parameterization_energy = attempt.relaxed_energy;
  result.flipped_triangles = attempt.folded.size();
  result.quads = attempt.quads->mesh.number_of_faces() - attempt.other_faces;
  result.other_faces = attempt.other_faces;
  result.irregular_vertices = attempt.irregular_vertices;
  result.message = attempt.message;
  result.status = attempt.is_simple ? Quadrangulation_status::VALID : Quadrangulation_status::NOT_VALID;
}

// Makes quads of prepared triangles by the plans of the options. Returns null if there are none; the result says why.
inline std::shared_ptr<Quadrangulation_quads>
search_component(Quadrangulation_surface& surface, const Grid_map_search::Directions& directions,
                 const Grid_map_search::Options& options, Pipeline_visitor& visitor, Quadrangulation_result& result)
{
  Grid_map_search search(surface, directions, options, visitor);
  const std::shared_ptr<const Grid_map_attempt> attempt = search.run();
  result.field_seconds += search.figures.field_seconds;
  result.parameterization_seconds = search.figures.parameterization_seconds;
  result.parameterization_attempts = search.figures.parameterization_attempts;
  result.extraction_seconds = search.figures.extraction_seconds;
  if(attempt)
  {
    take_attempt(*attempt, options, surface, result);
    return attempt->quads;
  }
  result.singularities = search.figures.singularities;
  result.released_feature_share = search.figures.released_feature_share;
  result.status = search.status;
  result.message = search.message;
  return nullptr;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SEARCH_COMPONENT_H
