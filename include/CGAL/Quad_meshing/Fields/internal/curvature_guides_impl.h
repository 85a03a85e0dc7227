// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_CURVATURE_GUIDES_IMPL_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_CURVATURE_GUIDES_IMPL_H

#include <CGAL/Quad_meshing/Fields/internal/Shape_operators.h>
#include <CGAL/Quad_meshing/Fields/internal/curvature_guides.h>
#include <CGAL/Quad_meshing/Fields/internal/face_lengths.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

inline double mean_edge_length(const Indexed_triangle_mesh& m)
{
  double sum = 0;
  for(int e = 0; e < m.number_of_edges(); ++e)
    sum += std::sqrt(m.vector(m.halfedge_of_edge[e]).squared_length());
  return m.number_of_edges() == 0 ? 0 : sum / m.number_of_edges();
}

inline Curvature_guide_result stopped_curvature_guide(const char* what)
{
  Curvature_guide_result result;
  result.status = Curvature_guide_status::STOPPED;
  result.message = std::string("The visitor stopped the computation of ") + what + ".";
  return result;
}

inline Curvature_guide_result invalid_curvature_guide(const std::string& message)
{
  Curvature_guide_result result;
  result.status = Curvature_guide_status::INVALID_LENGTH;
  result.message = message;
  return result;
}

// Of the disks about the faces; a disk takes some hundred microseconds.
const int disks_per_report = 64;

CGAL_QUAD_MESHING_INLINE Curvature_guide_result
find_salient_directions(const Indexed_triangle_mesh& m, double target_edge_length, double minimum_anisotropy,
                        Any_visitor& visitor, std::vector<Indexed_triangle_mesh::Vector_3>& direction)
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  // Radii are sampled this densely; an interval of half the target edge length has five of them.
  const double step = target_edge_length / 8;
  const int half_interval = 2;

  if(!(target_edge_length > 0) || !std::isfinite(target_edge_length))
    return invalid_curvature_guide("The target edge length is not a positive number.");
  Curvature_guide_result result;
  direction.assign(m.number_of_faces(), Vector_3(0, 0, 0));
  if(m.number_of_faces() == 0)
  {
    result.message = "The mesh has no faces.";
    return result;
  }
  const Visited_stage stage(visitor, "salient directions");
  Stage_progress progress(visitor);

  Bbox_3 box;
  for(const auto& p : m.points)
    box += p.bbox();
  const double radius =
    std::sqrt(std::pow(box.x_span(), 2) + std::pow(box.y_span(), 2) + std::pow(box.z_span(), 2)) / 2;
  // Flatter than this is flat: a tenth of the curvature of the bounding sphere.
  const double flat = 0.1 / radius;

  // The smallest disks have the mean edge length as radius.
  std::vector<double> radii(1, mean_edge_length(m));
  while(radii.back() + step <= target_edge_length || static_cast<int>(radii.size()) < 2 * half_interval + 1)
    radii.push_back(radii.back() + step);

  auto between_axes = [&](double a, double b) { return std::abs(a - b - CGAL_PI * std::round((a - b) / CGAL_PI)); };

  Shape_operators operators(m);
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    if(f % disks_per_report == 0 && !progress.go_further(double(f) / m.number_of_faces()))
      return stopped_curvature_guide("salient directions");
    Vector_3 x, y;
    const std::vector<Shape_operator> s = operators(f, radii, x, y);
    int best = -1;
    double best_deviation = 0;
    for(int i = half_interval; i + half_interval < static_cast<int>(s.size()); ++i)
    {
      bool valid = true;
      double deviation = 0;
      for(int j = i - half_interval; j <= i + half_interval; ++j)
      {
        valid = valid && s[j].anisotropy() > minimum_anisotropy && std::abs(s[j].mean()) > flat;
        deviation = (std::max)(deviation, between_axes(s[i].angle, s[j].angle));
      }
      if(valid && (best == -1 || deviation < best_deviation))
      {
        best = i;
        best_deviation = deviation;
      }
    }
    if(best == -1)
      continue;
    direction[f] = std::cos(s[best].angle) * x + std::sin(s[best].angle) * y;
    ++result.number_of_faces;
  }
  result.message = std::to_string(result.number_of_faces) + " of " + std::to_string(m.number_of_faces()) +
                   " faces have a salient direction.";
  return result;
}

CGAL_QUAD_MESHING_INLINE bool find_curvature_radii(const Indexed_triangle_mesh& m, const std::vector<char>& is_feature,
                                                   double least_disk, Stage_progress& progress,
                                                   std::vector<double>& radius)
{
  // Curvature is averaged over disks of twice the mean edge length: large enough to level the angles of single edges.
  const std::vector<double> radii(1, (std::max)(2 * mean_edge_length(m), least_disk));
  Shape_operators operators(m, is_feature);
  radius.resize(m.number_of_faces());
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    if(f % disks_per_report == 0 && !progress.go_further(double(f) / m.number_of_faces()))
      return false;
    Indexed_triangle_mesh::Vector_3 x, y;
    const std::vector<Shape_operator> s = operators(f, radii, x, y);
    const double curvature = s.empty() ? 0. : std::abs(s.front().maximum);
    radius[f] = curvature > 0 ? 1 / curvature : flat_radius;
  }
  return true;
}

CGAL_QUAD_MESHING_INLINE Curvature_guide_result find_curvature_sizing(const Indexed_triangle_mesh& m, double tolerance,
                                                                      double minimum, double maximum, double gradation,
                                                                      Any_visitor& visitor, std::vector<double>& length)
{
  if(!(tolerance > 0))
    return invalid_curvature_guide("The tolerance is not a positive number.");
  if(!(minimum > 0) || !(minimum <= maximum))
    return invalid_curvature_guide("The edge lengths do not satisfy 0 < minimum <= maximum.");
  const Visited_stage stage(visitor, "curvature sizing");
  Stage_progress progress(visitor);

  if(!find_curvature_radii(m, std::vector<char>(), 0, progress, length))
    return stopped_curvature_guide("edge lengths");
  for(double& l : length)
    l = (std::min)(maximum, (std::max)(minimum, chord_length(l, tolerance)));
  limit_gradation(m, gradation, length);
  Curvature_guide_result result;
  for(double l : length)
    result.number_of_faces += l < maximum;
  result.message = std::to_string(result.number_of_faces) + " of " + std::to_string(m.number_of_faces()) +
                   " faces have a length below the largest one.";
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_CURVATURE_GUIDES_IMPL_H
