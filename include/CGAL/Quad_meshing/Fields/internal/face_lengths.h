// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_FACE_LENGTHS_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_FACE_LENGTHS_H

#include <CGAL/Quad_meshing/internal/Distance_front.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

inline double face_area(const Indexed_triangle_mesh& m, int f)
{
  return std::sqrt(cross_product(m.vector(3 * f), m.vector(3 * f + 1)).squared_length()) / 2;
}

// The number of quads that lengths, one per face, stand for.
inline double quads_of_lengths(const Indexed_triangle_mesh& m, const std::vector<double>& length)
{
  double quads = 0;
  for(int f = 0; f < m.number_of_faces(); ++f)
    quads += face_area(m, f) / (length[f] * length[f]);
  return quads;
}

// The one length that stands for as many quads; the first one on a surface without area.
inline double mean_length(const Indexed_triangle_mesh& m, const std::vector<double>& length)
{
  double area = 0;
  for(int f = 0; f < m.number_of_faces(); ++f)
    area += face_area(m, f);
  return area > 0 ? std::sqrt(area / quads_of_lengths(m, length)) : length.empty() ? 0 : length.front();
}

// The length of an edge whose ends lie on an arc and that leaves it by a distance; 0 if that is the radius or more.
inline double chord_length(double radius, double distance)
{
  return distance < radius ? 2 * std::sqrt(2 * radius * distance - distance * distance) : 0;
}

// Reduces lengths that grow faster along the surface than by `slope` per unit of length, from centroid to centroid;
// short lengths first.
inline void limit_gradation(const Indexed_triangle_mesh& m, double slope, std::vector<double>& length)
{
  auto center = [&](int f)
  { return centroid(m.points[m.corners[f][0]], m.points[m.corners[f][1]], m.points[m.corners[f][2]]); };
  Distance_front front(m.number_of_faces());
  for(int f = 0; f < m.number_of_faces(); ++f)
    front.reach(f, length[f]);
  int f;
  for(double d; front.pop(f, d);)
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      if(m.opposite[h] != -1)
      {
        const int g = m.opposite[h] / 3;
        front.reach(g, d + slope * std::sqrt((center(g) - center(f)).squared_length()));
      }
  length = front.distances();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FACE_LENGTHS_H
