// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_SIZES_IMPL_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_SIZES_IMPL_H

#include <CGAL/Quad_meshing/Fields/internal/find_feature_sizes.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/number_type_config.h>
#include <CGAL/property_map.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Balls that touch the surface at a sample and are empty of all others, by shrinking [Ma, Bae, Choi 2012]: as long as
// there is a sample inside of the ball, the next one touches that sample too.
class Medial_balls
{
  typedef Indexed_triangle_mesh::Point_3 Point_3;
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;
  typedef std::pair<Point_3, int> Sample;
  typedef Search_traits_adapter<Sample, First_of_pair_property_map<Sample>, Search_traits_3<Simple_cartesian<double>>>
    Traits;
  typedef Orthogonal_k_neighbor_search<Traits> Search;

public:
  explicit Medial_balls(const Indexed_triangle_mesh& m)
  {
    Bbox_3 box;
    for(const Point_3& p : m.points)
      box += p.bbox();
    m_largest = std::sqrt(std::pow(box.x_span(), 2) + std::pow(box.y_span(), 2) + std::pow(box.z_span(), 2)) / 2;
    for(int f = 0; f < m.number_of_faces(); ++f)
    {
      const Vector_3 n = cross_product(m.vector(3 * f), m.vector(3 * f + 1));
      const double length = std::sqrt(n.squared_length());
      m_normal.push_back(length > 0 ? n / length : Vector_3(0, 0, 0));
      m_point.push_back(centroid(m.points[m.corners[f][0]], m.points[m.corners[f][1]], m.points[m.corners[f][2]]));
      if(length > 0)
        m_tree.insert(Sample(m_point[f], f));
    }
    m_tree.build();
  }

  // The radius of the smaller of the balls on both sides of a face, at most that of the ball around the model.
  double radius(int f) const { return (std::min)(radius(f, m_normal[f]), radius(f, -m_normal[f])); }

private:
  // Neighbors that the center sees nearer to each other than this, in radians, are one place of a rough surface: 20
  // degrees.
  static constexpr double least_angle = 20 * CGAL_PI / 180;
  // Steps of the shrinking; a handful is usual.
  static constexpr int most_steps = 30;
  // A ball of which this part of the radius is empty is empty.
  static constexpr double emptiness = 1 - 1e-6;

  double radius(int f, const Vector_3& n) const
  {
    const Point_3& p = m_point[f];
    double r = m_largest;
    if(n == NULL_VECTOR)
      return r;
    for(int step = 0; step < most_steps; ++step)
    {
      const Point_3 center = p - r * n;
      const Search search(m_tree, center, 1);
      const Point_3 q = search.begin()->first.first;
      const Vector_3 d = p - q;
      if(std::sqrt(squared_distance(q, center)) >= emptiness * r || !(d * n > 0))
        break;
      const double next = d.squared_length() / (2 * (d * n));
      const Vector_3 to_p = next * n, to_q = to_p - d; // from the center of the next ball
      if(std::atan2(std::sqrt(cross_product(to_p, to_q).squared_length()), to_p * to_q) < least_angle)
        break;
      r = next;
    }
    return r;
  }

  double m_largest;
  std::vector<Point_3> m_point;   // per face
  std::vector<Vector_3> m_normal; // per face, zero where it has no area
  typename Search::Tree m_tree;
};

CGAL_QUAD_MESHING_INLINE bool find_feature_sizes(const Indexed_triangle_mesh& m, Stage_progress& progress,
                                                 std::vector<double>& size)
{
  const int faces_per_report = 256; // some ten milliseconds
  size.clear();
  const Medial_balls balls(m);
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    if(f % faces_per_report == 0 && !progress.go_further(double(f) / m.number_of_faces()))
      return false;
    size.push_back(balls.radius(f));
  }
  return true;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_FEATURE_SIZES_IMPL_H
