// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_CURVATURE_DIRECTIONS_IMPL_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_CURVATURE_DIRECTIONS_IMPL_H

#include <CGAL/Quad_meshing/Fields/internal/Shape_operators.h>
#include <CGAL/Quad_meshing/Fields/internal/curvature_guides.h>
#include <CGAL/Quad_meshing/Fields/internal/find_curvature_directions.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Rises from 0 to 1 between two values, without a corner, or jumps if they are one.
inline double smooth_step(double x, double from, double to)
{
  if(from == to)
    return x < to ? 0 : 1;
  const double t = (std::min)(1., (std::max)(0., (x - from) / (to - from)));
  return t * t * (3 - 2 * t);
}

// The directions that the shape operators of disks give, and how far they can be trusted [Bom12, 8.1].
class Curvature_directions
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

public:
  // With a least anisotropy, directions are reliable or not, and nothing between: by the limits of the thesis.
  Curvature_directions(const Indexed_triangle_mesh& m, const std::vector<char>& is_feature,
                       std::optional<double> minimum_anisotropy)
    : m_operators(m, is_feature)
  {
    if(minimum_anisotropy)
      m_limits = { *minimum_anisotropy, *minimum_anisotropy, 0.1, 0.1, CGAL_PI / 18, CGAL_PI / 18 };
    Bbox_3 box;
    for(const auto& p : m.points)
      box += p.bbox();
    m_model_radius = std::sqrt(std::pow(box.x_span(), 2) + std::pow(box.y_span(), 2) + std::pow(box.z_span(), 2)) / 2;
  }

  // Returns the reliability of the direction for quads of some size.
  double operator()(int f, double target_edge_length, Vector_3& direction)
  {
    m_radii.clear();
    for(int i = 0; i < number_of_radii; ++i)
      m_radii.push_back(target_edge_length * (smallest_radius + i * step));
    Vector_3 x, y;
    const std::vector<Shape_operator> s = m_operators(f, m_radii, x, y);
    double best = 0;
    for(int i = 1; i + 1 < static_cast<int>(s.size()); ++i)
    {
      double validity = 1, deviation = 0;
      for(int j = i - 1; j <= i + 1; ++j)
      {
        validity = (std::min)(validity, reliability_of(s[j]));
        deviation = (std::max)(deviation, between_axes(s[i].angle, s[j].angle));
      }
      const double reliability =
        validity * (1 - smooth_step(deviation, m_limits.small_deviation, m_limits.largest_deviation));
      if(reliability > best)
      {
        best = reliability;
        direction = std::cos(s[i].angle) * x + std::sin(s[i].angle) * y;
      }
    }
    return best;
  }

private:
  // The radii of the disks, in target edge lengths: what is smaller than a quad does not count, what is larger lies
  // elsewhere. An interval has three radii, a quarter of an edge length together, as in the thesis.
  static constexpr double smallest_radius = 0.75, step = 0.125;
  static constexpr int number_of_radii = 5;
  // From where to where directions become reliable.
  struct Limits
  {
    // The relative anisotropy from which on a direction counts at all, and from which on fully; the thesis has one
    // limit, 0.8.
    double least_anisotropy = 0.5, full_anisotropy = 0.9;
    // The same for the curvature, in units of that of the sphere around the model; the thesis has one limit, 0.1.
    double least_curvature = 0.05, full_curvature = 0.2;
    // How much directions of an interval may differ to count fully, and at all, in radians: 15 degrees. With one limit,
    // 10 degrees.
    double small_deviation = 0, largest_deviation = CGAL_PI / 12;
  };

  double reliability_of(const Shape_operator& s) const
  {
    return smooth_step(s.anisotropy(), m_limits.least_anisotropy, m_limits.full_anisotropy) *
           smooth_step(std::abs(s.maximum) * m_model_radius, m_limits.least_curvature, m_limits.full_curvature);
  }

  static double between_axes(double a, double b) { return std::abs(a - b - CGAL_PI * std::round((a - b) / CGAL_PI)); }

  Shape_operators m_operators;
  Limits m_limits;
  double m_model_radius;
  std::vector<double> m_radii;
};

CGAL_QUAD_MESHING_INLINE Curvature_guide_result find_curvature_directions(
  const Indexed_triangle_mesh& m, double target_edge_length, const std::vector<double>& face_length,
  const std::vector<char>& is_feature, std::optional<double> minimum_anisotropy, Any_visitor& visitor,
  std::vector<Indexed_triangle_mesh::Vector_3>& direction, std::vector<double>& weight)
{
  auto length = [&](int f) { return face_length.empty() ? target_edge_length : face_length[f]; };
  auto is_length = [](double l) { return l > 0 && std::isfinite(l); };
  if(!std::all_of(face_length.begin(), face_length.end(), is_length) ||
     (face_length.empty() && !is_length(target_edge_length)))
    return invalid_curvature_guide("The target edge length is not a positive number.");
  const Visited_stage stage(visitor, "curvature directions");
  Stage_progress progress(visitor);
  direction.assign(m.number_of_faces(), Indexed_triangle_mesh::Vector_3(0, 0, 0));
  weight.assign(m.number_of_faces(), 0.);

  // Disks of a quad's size change slowly: where the triangles are much smaller, some of them speak for their neighbors.
  // So many per quad are enough for the field.
  const double samples_per_quad = 8;
  double quads = 0; // that the next sample speaks for
  Curvature_directions directions(m, is_feature, minimum_anisotropy);
  Curvature_guide_result result;
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    if(f % disks_per_report == 0 && !progress.go_further(double(f) / m.number_of_faces()))
      return stopped_curvature_guide("curvature directions");
    const double area = std::sqrt(cross_product(m.vector(3 * f), m.vector(3 * f + 1)).squared_length()) / 2;
    quads += area / (length(f) * length(f));
    if(quads * samples_per_quad < 1)
      continue;
    weight[f] = quads * directions(f, length(f), direction[f]);
    result.number_of_faces += weight[f] > 0;
    quads = 0;
  }
  result.message = std::to_string(result.number_of_faces) + " of " + std::to_string(m.number_of_faces()) +
                   " faces have a direction of least curvature.";
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_CURVATURE_DIRECTIONS_IMPL_H
