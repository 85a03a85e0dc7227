// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_TRIANGLE_PATCH_H
#define CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_TRIANGLE_PATCH_H

#include <CGAL/Quad_meshing/Working_mesh/internal/Editable_triangles.h>
#include <CGAL/Quad_meshing/internal/closest_in_triangle.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What a face of a working mesh knows of the input that it stands for.
struct Input_of_face
{
  Editable_triangles::Vector_3 area_vector; // the sum of those of the input's triangles
  double error = 0;                         // how far the input is from the face at most
};

// The triangles that an edit of a working mesh takes away, those that it puts in their place, and whether the new ones
// stand for the input as well as is asked for.
class Triangle_patch
{
public:
  typedef Editable_triangles::Point_3 Point_3;
  typedef Editable_triangles::Vector_3 Vector_3;
  typedef std::array<Point_3, 3> Triangle;

  // What new triangles must keep to, unless the old ones did not either.
  struct Limits
  {
    double error = 0;                 // a length
    double quality = 0.35;            // see quality(): a triangle of 60 degrees and two sides of ratio 1 : 4 has 0.40,
                                      // a rectangular one of ratio 1 : 5 has 0.33
    double cosine = std::sqrt(3) / 2; // of the angle to the mean normal of the input: 30 degrees
  };

  // 1 for an equilateral triangle, 0 for one without area [Bank and Smith 1997].
  static double quality(const Triangle& t)
  {
    const Vector_3 a = t[1] - t[0], b = t[2] - t[0], c = t[2] - t[1];
    const double lengths = a * a + b * b + c * c;
    return lengths > 0 ? 2 * std::sqrt(3 * cross_product(a, b).squared_length()) / lengths : 0;
  }

  void clear()
  {
    m_old_error = 0;
    m_old_quality = 1;
    m_old_input = Vector_3(0, 0, 0);
    m_old.clear();
    m_new.clear();
  }

  void remove(const Triangle& t, const Input_of_face& input)
  {
    m_old_error = (std::max)(m_old_error, input.error);
    m_old_quality = (std::min)(m_old_quality, quality(t));
    m_old.push_back(area_vector(t));
    m_old_input = m_old_input + input.area_vector;
  }

  void add(const Triangle& t) { m_new.push_back(t); }

  // Distributes what the old triangles stood for among the new ones, by their areas, and judges them. `p` is the point
  // of the old ones that is farthest from the new ones.
  bool is_acceptable(const Point_3& p, const Limits& limits)
  {
    // The errors of one edit after the other lie on both sides of the surface: their squares add up.
    const double error = std::hypot(m_old_error, distance(p));
    if(!(error <= (std::max)(limits.error, m_old_error)))
      return false;
    m_new_quality = 1;
    double total = 0;
    m_areas.clear();
    for(const Triangle& t : m_new)
    {
      m_new_quality = (std::min)(m_new_quality, quality(t));
      m_areas.push_back(std::sqrt(area_vector(t).squared_length()));
      total += m_areas.back();
    }
    if(m_new_quality < (std::min)(limits.quality, m_old_quality) || !(total > 0))
      return false;
    double least_cosine = limits.cosine;
    for(const Vector_3& a : m_old)
      least_cosine = (std::min)(least_cosine, cosine(a, m_old_input));
    m_inputs.clear();
    for(std::size_t i = 0; i < m_new.size(); ++i)
    {
      m_inputs.push_back({ (m_areas[i] / total) * m_old_input, error });
      if(cosine(area_vector(m_new[i]), m_old_input) < least_cosine)
        return false;
    }
    return true;
  }

  // Of the new triangles, in the order in which they were added.
  const std::vector<Input_of_face>& inputs() const { return m_inputs; }
  double old_quality() const { return m_old_quality; }
  double new_quality() const { return m_new_quality; }

private:
  static Vector_3 area_vector(const Triangle& t) { return cross_product(t[1] - t[0], t[2] - t[0]); }

  static double cosine(const Vector_3& a, const Vector_3& b)
  {
    const double lengths = std::sqrt(a.squared_length() * b.squared_length());
    return lengths > 0 ? a * b / lengths : -1;
  }

  double distance(const Point_3& p) const
  {
    double least = (std::numeric_limits<double>::infinity)();
    for(const Triangle& t : m_new)
    {
      Point_3 q;
      closest_in_triangle(p, t[0], t[1], t[2], q);
      least = (std::min)(least, squared_distance(p, q));
    }
    return std::sqrt(least);
  }

  double m_old_error = 0, m_old_quality = 1, m_new_quality = 1;
  Vector_3 m_old_input;
  std::vector<Vector_3> m_old; // area vectors
  std::vector<Triangle> m_new;
  std::vector<double> m_areas;
  std::vector<Input_of_face> m_inputs;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_TRIANGLE_PATCH_H
