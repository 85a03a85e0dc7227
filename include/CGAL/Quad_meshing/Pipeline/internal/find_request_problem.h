// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_FIND_REQUEST_PROBLEM_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_FIND_REQUEST_PROBLEM_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Element_names.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Placed_guides.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Triangle_input.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What makes a request impossible before any surface is looked at, each function a sentence, or nothing.

inline bool is_finite_point(const Quadrangulation_kernel::Point_3& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

inline std::string problem_of_options(const Quadrangulation_options& options)
{
  if(options.target_edge_length < 0 || !std::isfinite(options.target_edge_length))
    return "The target edge length is not a positive number.";
  if(options.target_edge_length == 0 &&
     !(options.target_number_of_quads > 0 && std::isfinite(options.target_number_of_quads)))
    return "The target number of quads is not a positive number.";
  if(!(options.anisotropy_weight > 0 && options.anisotropy_weight <= 1))
    return "The anisotropy weight does not lie between 0, exclusive, and 1.";
  if(!(options.curvature_alignment >= 0 && options.curvature_alignment <= 1))
    return "The curvature alignment does not lie between 0 and 1.";
  if(!(options.singularity_cost >= 0 && std::isfinite(options.singularity_cost)))
    return "The cost of a singularity is negative or not a number.";
  if(options.number_of_threads == 0)
    return "The number of threads is zero.";
  if(!(options.maximum_running_time > 0))
    return "The maximum running time is not a positive number.";
  return std::string();
}

inline std::string problem_of_guides(const Triangle_input& input, const Quadrangulation_options& o,
                                     const Element_names& names)
{
  auto is_length = [](double x) { return x >= 0 && std::isfinite(x); };
  if(!is_length(o.smallest_edge_length) || !is_length(o.largest_edge_length) || !is_length(o.sizing_tolerance))
    return "A bound of the edge lengths is negative or not a number.";
  if(o.largest_edge_length > 0 && o.smallest_edge_length > o.largest_edge_length)
    return "The smallest edge length is larger than the largest one.";
  if(!(o.sizing_gradation > 0))
    return "The gradation of the edge lengths is not a positive number.";
  for(std::size_t i = 0; i < o.size_discs.size(); ++i)
  {
    const Size_disc& d = o.size_discs[i];
    if(!(d.radius > 0 && is_length(d.radius)) || !(d.length > 0 && is_length(d.length)) || !is_finite_point(d.center))
      return "The radius or the length of " + guide_name(d, "disc", i) + " is not a positive number.";
  }
  for(std::size_t i = 0; i < o.strokes.size(); ++i)
    if(!(o.strokes[i].weight > 0))
      return "The weight of " + guide_name(o.strokes[i], "stroke", i) + " is not a positive number.";
  for(std::size_t i = 0; i < o.index_guides.size(); ++i)
  {
    const Index_guide& g = o.index_guides[i];
    const std::string name = guide_name(g, "index", i);
    if(!is_finite_point(g.point) || !(g.radius >= 0))
      return "A number of " + name + " is negative or not finite.";
    if(g.is_sum)
    {
      if(!(g.radius > 0) || !is_length(g.radius))
        return "The radius of " + name + " is not a positive number.";
      continue;
    }
    const int largest_index = 3; // a vertex has one quad at least
    if(g.index > largest_index)
      return "The index of " + name + " is larger than 3.";
    if(g.radius > 0 && g.index != 0)
      return "Only an index of 0 has a radius, which " + name + " has as well.";
  }
  for(std::size_t i = 0; i < o.connections.size(); ++i)
    if(!is_finite_point(o.connections[i].from) || !is_finite_point(o.connections[i].to))
      return "A coordinate of " + guide_name(o.connections[i], "connection", i) + " is not a finite number.";
  for(std::size_t f = 0; f < input.face_lengths.size(); ++f)
    if(!std::isfinite(input.face_lengths[f]))
      return "The edge length of " + names.face(f) + " is not a finite number.";
  for(std::size_t v = 0; v < input.vertex_lengths.size(); ++v)
    if(!std::isfinite(input.vertex_lengths[v]))
      return "The edge length of " + names.vertex(v) + " is not a finite number.";
  return std::string();
}

inline std::string problem_of_points(const Triangle_input& input, const Element_names& names)
{
  if(input.triangles.empty())
    return "The mesh has no faces.";
  for(std::size_t i = 0; i < input.points.size(); ++i)
    for(int c = 0; c < 3; ++c)
      if(!std::isfinite(input.points[i][c]))
        return "The coordinates of " + names.vertex(i) + " are not all finite numbers.";
  return std::string();
}

inline std::string find_request_problem(const Triangle_input& input, const Quadrangulation_options& options,
                                        const Element_names& names)
{
  std::string problem = problem_of_options(options);
  if(problem.empty())
    problem = problem_of_guides(input, options, names);
  return problem.empty() ? problem_of_points(input, names) : problem;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_FIND_REQUEST_PROBLEM_H
