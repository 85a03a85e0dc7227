// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_READ_GRID_MAP_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_READ_GRID_MAP_H

#include <CGAL/Quad_meshing/Extraction/internal/Grid_map.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Coordinates up to this size leave 20 bits behind the point. Larger ones say that something is wrong with the map.
const double largest_grid_coordinate = 4294967296.;

// More grid points than this take more than about 3 GB, and are hardly asked for on purpose.
const double largest_number_of_grid_points = 2e7;

// Says what is wrong with the coordinates as such, in a sentence; an empty string if nothing is.
inline std::string defect_of_coordinates(const Grid_map& map)
{
  double points = 0, total_area = 0;
  for(int f = 0; f < map.mesh.number_of_faces(); ++f)
  {
    const Grid_map::Point_2* c = &map.uv[3 * f];
    double x0 = HUGE_VAL, x1 = -HUGE_VAL, y0 = HUGE_VAL, y1 = -HUGE_VAL;
    for(int k = 0; k < 3; ++k)
    {
      if(!std::isfinite(c[k].x()) || !std::isfinite(c[k].y()))
        return "The map has a coordinate that is not a number, in face " + std::to_string(f) + ".";
      if(std::fabs(c[k].x()) > largest_grid_coordinate || std::fabs(c[k].y()) > largest_grid_coordinate)
        return "The map has a coordinate beyond 2^32, in face " + std::to_string(f) + ".";
      x0 = (std::min)(x0, c[k].x());
      x1 = (std::max)(x1, c[k].x());
      y0 = (std::min)(y0, c[k].y());
      y1 = (std::max)(y1, c[k].y());
    }
    // The grid points inside, and the rows that have to be looked at.
    const double area =
      0.5 * std::fabs((c[1].x() - c[0].x()) * (c[2].y() - c[0].y()) - (c[1].y() - c[0].y()) * (c[2].x() - c[0].x()));
    total_area += area;
    points += area + (std::min)(x1 - x0, y1 - y0) + 0.1 * (y1 - y0);
  }
  if(total_area == 0 && map.mesh.number_of_faces() > 0)
    return "No triangle has any area in the map.";
  if(points > largest_number_of_grid_points)
    return "The map covers more than " + std::to_string(static_cast<long long>(largest_number_of_grid_points)) +
           " grid points.";
  return std::string();
}

// Recovers all transitions and returns the halfedges (one per edge) over which none is exact.
inline std::vector<int> make_transitions(Grid_map& map)
{
  const Indexed_triangle_mesh& m = map.mesh;
  std::vector<int> inexact;
  map.transition.assign(m.number_of_halfedges(), Grid_automorphism());
  for(int e = 0; e < m.number_of_edges(); ++e)
  {
    const int h = m.halfedge_of_edge[e], o = m.opposite[h];
    if(o == -1)
      continue;
    Grid_automorphism& t = map.transition[h];
    const Transition_kind kind =
      recover_grid_automorphism(map.uv[h], map.uv[m.next(h)], map.uv[m.next(o)], map.uv[o], t);
    if(kind != Transition_kind::EXACT)
      inexact.push_back(h);
    if(kind == Transition_kind::ZERO_LENGTH || kind == Transition_kind::NOT_INTEGER)
      t = Grid_automorphism(t.r, std::floor(t.tx + 0.5), std::floor(t.ty + 0.5));
    map.transition[o] = t.inverse();
  }
  return inexact;
}

inline void compute_signs(Grid_map& map)
{
  map.sign.resize(map.mesh.number_of_faces());
  for(int f = 0; f < map.mesh.number_of_faces(); ++f)
    map.sign[f] = static_cast<signed char>(map.orientation_of_face(f));
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_READ_GRID_MAP_H
