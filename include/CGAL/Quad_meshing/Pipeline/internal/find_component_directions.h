// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_FIND_COMPONENT_DIRECTIONS_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_FIND_COMPONENT_DIRECTIONS_H

#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Component_request.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Grid_map_search.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Pipeline_visitor.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Working_surface.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The weight, at full alignment, of a squared deviation from a reliable direction of curvature over the area of one
// quad, against a squared difference between two triangles. What a heavier weight adds to the singularities, their
// cost takes away again: at 4000 quads on spot, 12.2 degrees from the directions and 80 irregular vertices with 1 and
// no cost, 12.1 and 76 with 2 and a cost of 0.5, 14.3 and 64 with 3 and a cost of 1.
inline constexpr double weight_of_alignment = 2;

// Where lengths change, the field has to turn with them: directions of the surface count less, the steeper they do.
inline double share_of_alignment(const Quadrangulation_surface& surface, Quadrangulation_mesh::Face_index f)
{
  typedef Quadrangulation_mesh Mesh;
  const double half_slope = 0.05; // of the length, at which they count half
  const Mesh& mesh = surface.mesh;
  auto center = [&](Mesh::Face_index g)
  {
    const Mesh::Halfedge_index h = mesh.halfedge(g);
    return centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
  };
  double slope = 0;
  for(Mesh::Face_index g : mesh.faces_around_face(mesh.halfedge(f)))
    if(g != Mesh::null_face() && center(g) != center(f))
      slope = (std::max)(
        slope, std::abs(surface.length[g] - surface.length[f]) / std::sqrt(squared_distance(center(g), center(f))));
  return 1 / (1 + square(slope / half_slope));
}

// The directions that the field is to follow. Those of the user, per face of the whole input or none, are hard; those
// of the surface are soft. They are of no use if the result is not valid.
inline Curvature_guide_result
find_component_directions(const Quadrangulation_surface& surface, const Working_surface& work,
                          const std::vector<std::optional<Quadrangulation_kernel::Vector_3>>& of_user,
                          const Component_request& request, const Quadrangulation_options& options,
                          Pipeline_visitor& visitor, Grid_map_search::Directions& directions)
{
  typedef Quadrangulation_mesh Mesh;
  const Mesh& mesh = surface.mesh;
  Curvature_guide_result guides;
  directions.direction.resize(mesh.number_of_faces());
  directions.weight.resize(mesh.number_of_faces(), 0.);
  if(options.curvature_alignment > 0)
    guides = curvature_directions(
      mesh, request.length,
      boost::make_iterator_property_map(directions.direction.begin(), get(boost::face_index, mesh)),
      boost::make_iterator_property_map(directions.weight.begin(), get(boost::face_index, mesh)),
      parameters::face_sizing_map(surface.length)
        .edge_is_constrained_map(surface.is_feature)
        .visitor(std::ref(visitor)));
  if(!guides.is_valid())
    return guides;
  for(Mesh::Face_index f : mesh.faces())
  {
    directions.weight[f] *=
      options.curvature_alignment * weight_of_alignment * (request.is_graded ? share_of_alignment(surface, f) : 1);
    if(!of_user.empty() && of_user[work.input_face(f)])
    {
      directions.direction[f] = of_user[work.input_face(f)];
      directions.weight[f] = (std::numeric_limits<double>::infinity)();
    }
  }
  return guides;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_FIND_COMPONENT_DIRECTIONS_H
