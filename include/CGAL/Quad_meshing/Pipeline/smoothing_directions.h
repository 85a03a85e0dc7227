// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_SMOOTHING_DIRECTIONS_H
#define CGAL_QUAD_MESHING_PIPELINE_SMOOTHING_DIRECTIONS_H

#include <CGAL/Quad_meshing/Fields/cross_field_directions.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingRef

\brief What `quadrangulate()` tells its smoothing about directions.
*/
struct Smoothing_directions
{
  std::vector<std::optional<Quadrangulation_kernel::Vector_3>> direction; ///< per face: for `face_direction_map`
  std::vector<double> weight; ///< per face: for `face_direction_weight_map` of `smooth_quad_mesh()`
};

/*!
\ingroup PkgQuadMeshingRef

\brief returns the directions of a cross field, and how much each of them counts for the smoothing of the quads.

A direction counts a little everywhere, and more where a reliable direction of the surface made the field what it is.

\param surface the triangles with the cross field
\param weight per face: the weight that its soft direction had in the energy of the field, see `smooth_cross_field()`;
       it may be infinite
\param importance per face: how much it counts for the map, 1 or more; empty: one everywhere
*/
inline Smoothing_directions smoothing_directions(const Quadrangulation_surface& surface,
                                                 const std::vector<double>& weight,
                                                 const std::vector<double>& importance = {})
{
  // Weight one makes a deviation from a direction as bad as one from a right angle. Everywhere, what a reliable
  // direction of curvature adds, and a unit of importance near strokes. On a rocker arm at 4000 quads, edges are 7.1
  // degrees from the directions of curvature before the smoothing, 8.2 after it without any weights and 7.1 with these;
  // corners deviate by 1.8 and 2.0 degrees from right angles. Weights three times as large come to 6.5 and 2.5. Along a
  // stroke across it, quads are 4.7 degrees off before the smoothing, and with these weights 3.5 after it.
  const double weight_of_field = 0.1, weight_of_reliable_directions = 1, weight_of_importance = 4;

  typedef Quadrangulation_mesh Mesh;
  const Mesh& mesh = surface.mesh;
  Smoothing_directions result;
  std::vector<double> quads; // per face: its area
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    quads.push_back(std::sqrt(squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                           mesh.point(mesh.target(mesh.next(h))))) /
                    square(surface.length[f]));
  }
  for(Mesh::Face_index f : mesh.faces())
  {
    // Where triangles are small, some speak for their neighbors.
    double sum = weight[f], area = quads[f];
    for(Mesh::Face_index g : mesh.faces_around_face(mesh.halfedge(f)))
      if(g != Mesh::null_face())
      {
        sum += weight[g];
        area += quads[g];
      }
    const double reliability = area > 0 ? (std::min)(1., sum / area) : 0;
    result.weight.push_back(weight_of_field + weight_of_reliable_directions * reliability +
                            weight_of_importance * (importance.empty() ? 0 : importance[f] - 1));
    result.direction.push_back(cross_field_direction(f, mesh, surface.angle));
  }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_SMOOTHING_DIRECTIONS_H
