// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PREPARE_COMPONENT_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PREPARE_COMPONENT_H

#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Component_request.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Pipeline_visitor.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Working_surface.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Marks the feature edges of a component: those of the user, or else detected ones and the curves of the user. Returns
// the length of those that may be released.
inline double find_component_features(Quadrangulation_surface& surface, const Component_request& request,
                                      const Quadrangulation_options& options, Quadrangulation_result& result)
{
  typedef Quadrangulation_mesh Mesh;
  const Mesh& mesh = surface.mesh;
  if(request.has_features)
  {
    for(Mesh::Edge_index e : mesh.edges())
      result.feature_edges += surface.is_feature[e];
    return 0;
  }
  const Feature_edges_result features =
    detect_feature_edges(mesh, options.sharpness_angle, request.length, surface.is_feature);
  result.feature_edges = features.number_of_edges;
  result.dropped_feature_edges = features.number_of_dropped_edges;
  double releasable_length = features.length;
  // Curves of the user besides.
  for(Mesh::Edge_index e : mesh.edges())
    if(surface.is_kept[e])
    {
      if(surface.is_feature[e])
        releasable_length -= std::sqrt(squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
      surface.is_feature[e] = true;
    }
  return releasable_length;
}

// What a face inherits when it is split.
struct Inherited_values
{
  typedef Quadrangulation_mesh::Face_index key_type;
  typedef std::pair<std::size_t, double> value_type;
  typedef value_type reference;
  typedef boost::read_write_property_map_tag category;

  Quadrangulation_surface* surface;

  friend value_type get(const Inherited_values& m, Quadrangulation_mesh::Face_index f)
  {
    return value_type(m.surface->origin[f], m.surface->length[f]);
  }
  friend void put(const Inherited_values& m, Quadrangulation_mesh::Face_index f, const value_type& value)
  {
    m.surface->origin[f] = value.first;
    m.surface->length[f] = value.second;
  }
};

// Makes triangles of a component, whose features are marked, that a map can be made on: a working mesh in its place,
// unless the options want the input, in which long edges, and those that ask too much of a triangle, are split. Returns
// a message if the visitor stopped it, nothing else.
inline std::string prepare_component(std::unique_ptr<Quadrangulation_surface>& surface, Working_surface& work,
                                     const Component_request& request, const Quadrangulation_options& options,
                                     Pipeline_visitor& visitor)
{
  typedef Quadrangulation_mesh Mesh;
  const Kept_features kept(*surface);
  if(!options.work_on_input)
  {
    const std::string stopped = work.make(request.length, visitor);
    if(!stopped.empty())
      return stopped;
  }
  // In target edge lengths. A map is linear on a triangle; a few triangles per quad let it bend.
  const double longest_edge = 1.5;
  double shortest_length = request.length;
  if(request.is_graded)
    for(Mesh::Face_index f : surface->mesh.faces())
      shortest_length = (std::min)(shortest_length, surface->length[f]);
  // A working mesh has no edge that is longer for its place.
  split_for_alignment(surface->mesh, surface->mesh.points(), surface->is_feature, options.align_boundary,
                      Inherited_values{ surface.get() },
                      request.is_graded && !options.work_on_input ? 0 : longest_edge * shortest_length);
  const double rounding = 1e-6; // in target edge lengths
  kept.mark(*surface, (std::max)(work.largest_curve_error(), rounding * request.length));
  return std::string();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PREPARE_COMPONENT_H
