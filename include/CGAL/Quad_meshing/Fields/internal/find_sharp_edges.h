// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_SHARP_EDGES_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_SHARP_EDGES_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The inner edges at which the normals of the two faces differ by at least an angle below 180 degrees. Faces are
// compared by the signs and squares of products of their area vectors, as
// `Polygon_mesh_processing::detect_sharp_edges()` does: no square root rounds, and at a face without area every edge is
// sharp for angles of up to 90 degrees.
inline std::vector<char> find_sharp_edges(const Indexed_triangle_mesh& m, double angle_in_degrees)
{
  const double cosine = std::cos(angle_in_degrees * CGAL_PI / 180), squared_cosine = cosine * cosine;
  std::vector<char> is_sharp(m.number_of_edges(), false);
  for(int e = 0; e < m.number_of_edges(); ++e)
  {
    const int h = m.halfedge_of_edge[e], o = m.opposite[h];
    if(o == -1)
      continue;
    const Indexed_triangle_mesh::Point_3& p = m.points[m.source(h)];
    const auto along = m.points[m.target(h)] - p;
    const auto n1 = cross_product(along, m.points[m.source(m.prev(h))] - p);
    const auto n2 = cross_product(along, p - m.points[m.source(m.prev(o))]);
    const double product = n1 * n2;
    const double bound = squared_cosine * n1.squared_length() * n2.squared_length();
    if(angle_in_degrees == 0)
      is_sharp[e] = true;
    else if(cosine < 0)
      is_sharp[e] = product < 0 && product * product >= bound;
    else
      is_sharp[e] = product < 0 || product * product <= bound;
  }
  return is_sharp;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_FIND_SHARP_EDGES_H
