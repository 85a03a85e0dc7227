// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_HARMONIC_WEIGHTS_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_HARMONIC_WEIGHTS_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The weights of the neighbours of a vertex, in parts that each triangle contributes: discrete harmonic ones, (7.2), or
// mean value coordinates (Floater: Mean value coordinates, Computer Aided Geometric Design 20(1), 2003), which are
// positive.
class Harmonic_weights
{
public:
  // Bounds on what a triangle contributes, for triangles without area and edges without length: relative to the weight
  // of an angle of 45 degrees, and to the mean edge length.
  static constexpr double largest_cotangent = 1e4, least_length = 1e-6;

  Harmonic_weights(const Indexed_triangle_mesh& m, bool mean_value)
    : m_to_target(m.number_of_halfedges()), m_to_previous(m.number_of_halfedges())
  {
    double mean = 0;
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      mean += std::sqrt(m.vector(h).squared_length()) / m.number_of_halfedges();
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      if(mean_value)
      {
        const Indexed_triangle_mesh::Vector_3 a = m.vector(h), b = -m.vector(m.prev(h));
        const double least = least_length * mean;
        const double la = (std::max)(std::sqrt(a.squared_length()), least),
                     lb = (std::max)(std::sqrt(b.squared_length()), least);
        // tan(x/2) = sin(x) / (1 + cos(x))
        const double sine = std::sqrt(cross_product(a, b).squared_length()), cosine = a * b;
        const double half = (std::max)(sine / (std::max)(la * lb + cosine, least_length * la * lb), least_length);
        m_to_target[h] = half * mean / la;
        m_to_previous[h] = half * mean / lb;
      }
      else
      {
        m_to_target[h] = 0.5 * cotangent(m, m.prev(h));
        m_to_previous[h] = 0.5 * cotangent(m, m.next(h));
      }
  }

  // What the triangle of h adds to the weight of the target of h, for the source of h; and to that of its third corner.
  double to_target(int h) const { return m_to_target[h]; }
  double to_previous(int h) const { return m_to_previous[h]; }

private:
  // Of the angle at the source of h.
  static double cotangent(const Indexed_triangle_mesh& m, int h)
  {
    const Indexed_triangle_mesh::Vector_3 a = m.vector(h), b = -m.vector(m.prev(h));
    const double sine = std::sqrt(cross_product(a, b).squared_length()), cosine = a * b;
    if(!(std::abs(cosine) < largest_cotangent * sine))
      return cosine > 0 ? largest_cotangent : cosine < 0 ? -largest_cotangent : 0;
    return cosine / sine;
  }

  std::vector<double> m_to_target, m_to_previous; // per halfedge
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_HARMONIC_WEIGHTS_H
