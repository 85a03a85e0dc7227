// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_BUILD_WORKING_MESH_IMPL_H
#define CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_BUILD_WORKING_MESH_IMPL_H

#include <CGAL/Quad_meshing/Working_mesh/internal/Working_mesh_builder.h>
#include <CGAL/Quad_meshing/Working_mesh/internal/build_working_mesh.h>

#include <CGAL/Real_timer.h>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The faces that are left, and their vertices, numbered in their order.
inline void write_working_triangles(const Working_mesh_builder& builder, Working_triangles& result)
{
  const Editable_triangles& m = builder.triangles;
  result = Working_triangles();
  std::vector<int> number(m.number_of_vertices(), -1);
  for(int v = 0; v < m.number_of_vertices(); ++v)
    if(m.out[v] != -1)
    {
      number[v] = static_cast<int>(result.points.size());
      result.points.push_back(m.points[v]);
      result.input_face.push_back(builder.input_face[v]);
    }
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    if(m.is_removed(f))
      continue;
    const std::array<int, 3>& c = m.corners[f];
    result.triangles.push_back({ { number[c[0]], number[c[1]], number[c[2]] } });
    result.is_feature.push_back({ { 0, 0, 0 } });
    for(int k = 0; k < 3; ++k)
      result.is_feature.back()[k] = m.is_on_curve(3 * f + k) && m.opposite[3 * f + k] != -1;
  }
}

CGAL_QUAD_MESHING_INLINE Working_mesh_result build_working_mesh(Reference_surface& input,
                                                                const std::vector<char>& is_feature,
                                                                double target_edge_length,
                                                                const std::vector<double>& face_length,
                                                                Any_visitor& visitor, Working_triangles& result)
{
  Working_mesh_result r;
  r.input_faces = input.mesh().corners.size();
  if(!(target_edge_length > 0) || !std::isfinite(target_edge_length))
  {
    r.status = Working_mesh_status::INVALID_PARAMETERS;
    r.message = "The target edge length is not a positive number.";
    return r;
  }
  for(double l : face_length)
    if(!(l > 0) || !std::isfinite(l))
    {
      r.status = Working_mesh_status::INVALID_PARAMETERS;
      r.message = "A target edge length of a face is not a positive number.";
      return r;
    }
  const Visited_stage stage(visitor, "working mesh");
  Real_timer timer;
  timer.start();
  Working_mesh_builder builder(input, is_feature, target_edge_length, face_length, visitor);
  if(!builder.run())
  {
    r.status = Working_mesh_status::STOPPED;
    r.message = "The visitor stopped the making of a working mesh.";
    return r;
  }
  write_working_triangles(builder, result);
  const std::size_t input_faces = r.input_faces;
  r = builder.figures;
  r.input_faces = input_faces;
  r.faces = result.triangles.size();
  r.seconds = timer.time();
  r.message = "A working mesh of " + std::to_string(r.faces) + " faces for " + std::to_string(r.input_faces) +
              " faces of the input.";
  return r;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_BUILD_WORKING_MESH_IMPL_H
