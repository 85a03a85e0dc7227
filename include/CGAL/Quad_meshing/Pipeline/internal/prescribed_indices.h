// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PRESCRIBED_INDICES_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PRESCRIBED_INDICES_H

#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Component_request.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Grid_map_search.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Pipeline_visitor.h>

#include <CGAL/boost/graph/properties.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The indices of the field that the search begins with, per vertex; none if there is no field.
inline std::vector<int> indices_of_field(const Quadrangulation_surface& surface,
                                         const Grid_map_search::Directions& directions,
                                         const std::vector<std::optional<int>>& prescribed, double target_edge_length,
                                         const Quadrangulation_options& options, Pipeline_visitor& visitor)
{
  typedef Quadrangulation_mesh Mesh;
  const Mesh& mesh = surface.mesh;
  std::vector<double> angle(mesh.number_of_faces());
  std::vector<int> jump(mesh.number_of_edges()), index(mesh.number_of_vertices());
  std::vector<char> is_feature;
  for(Mesh::Edge_index e : mesh.edges())
    is_feature.push_back(surface.is_feature[e]);
  is_feature = directions.constrained(is_feature);
  auto of_edges = [&](auto& values)
  { return boost::make_iterator_property_map(values.begin(), get(boost::edge_index, mesh)); };
  auto of_faces = [&](auto& values)
  { return boost::make_iterator_property_map(values.begin(), get(boost::face_index, mesh)); };
  auto of_vertices = [&](auto& values)
  { return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, mesh)); };
  const Cross_field_result r = smooth_cross_field(mesh, of_faces(angle), of_edges(jump), of_vertices(index),
                                                  parameters::target_edge_length(target_edge_length)
                                                    .edge_is_constrained_map(of_edges(is_feature))
                                                    .align_boundary(options.align_boundary)
                                                    .cross_field_method(options.cross_field_method)
                                                    .singularity_cost(options.singularity_cost)
                                                    .face_direction_map(of_faces(directions.direction))
                                                    .face_direction_weight_map(of_faces(directions.weight))
                                                    .face_sizing_map(surface.length)
                                                    .prescribed_index_map(of_vertices(prescribed))
                                                    .visitor(std::ref(visitor)));
  if(!r.is_valid() && r.status != Cross_field_status::EMPTY_SECTORS)
    index.clear();
  return index;
}

// Irregular vertices where none but those of guides were wanted, as a wish that is not met; empty: there are none.
inline std::string report_other_irregular_vertices(const Quadrangulation_surface& surface,
                                                   const std::vector<Component_wishes::Index_wish>& wishes,
                                                   const std::vector<std::optional<int>>& prescribed)
{
  typedef Quadrangulation_mesh Mesh;
  for(const Component_wishes::Index_wish& w : wishes)
    if(!w.guide->is_sum && std::isinf(w.guide->radius))
    {
      std::size_t others = 0;
      for(Mesh::Vertex_index v : surface.mesh.vertices())
        others += prescribed[v] && *prescribed[v] == 0 && surface.index[v] != 0;
      return others == 0 ? std::string()
                         : std::to_string(others) + " irregular vertices are besides those that " + w.name + " allows";
    }
  return std::string();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PRESCRIBED_INDICES_H
