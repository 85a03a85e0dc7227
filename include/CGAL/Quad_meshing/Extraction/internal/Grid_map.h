// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_MAP_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_MAP_H

#include <CGAL/Quad_meshing/internal/Grid_automorphism.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The four directions of the grid are numbered 0 (+x), 1 (+y), 2 (-x), 3 (-y).

// The coordinate of p that grows in direction d. Seen along d, the left side of the line through p
// is where `coordinate(., d + 1)` is larger.
template <typename Point>
inline double coordinate(const Point& p, int d)
{
  switch(d & 3)
  {
    case 0: return p.x();
    case 1: return p.y();
    case 2: return -p.x();
    default: return -p.y();
  }
}

// The point with `coordinate(., d)` equal to `along` and `coordinate(., d + 1)` equal to `left`.
template <typename Point>
inline Point point_from_coordinates(int d, double along, double left)
{
  switch(d & 3)
  {
    case 0: return Point(along, left);
    case 1: return Point(-left, along);
    case 2: return Point(-along, -left);
    default: return Point(left, -along);
  }
}

inline bool is_integer(double x) { return x == std::floor(x); }

inline int sign_of(double x) { return (x > 0) - (x < 0); }

// A map from the faces of a triangle mesh to charts of the integer grid.
//
// Corner 3*f+k is the corner of face f at the source of halfedge 3*f+k; `uv` holds its image in the
// chart of f. `transition[h]` takes the chart of face(h) to that of face(opposite(h)).
struct Grid_map
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_2 Point_2;
  typedef Indexed_triangle_mesh Mesh;

  const Mesh& mesh;
  std::vector<Point_2> uv;
  std::vector<Grid_automorphism> transition;
  std::vector<signed char> sign; // per face: orientation of its image

  explicit Grid_map(const Mesh& m) : mesh(m) {}

  int orientation_of_face(int f) const
  {
    return static_cast<int>(CGAL::orientation(uv[3 * f], uv[3 * f + 1], uv[3 * f + 2]));
  }

  // The heading changes where a line passes from a face to one of the other orientation. Faces without area
  // count as positive.
  bool is_reversed(int f) const { return sign[f] < 0; }

  bool is_integer_corner(int h) const { return is_integer(uv[h].x()) && is_integer(uv[h].y()); }
};

// The first grid direction at or after the vector from `from` to `to`, counterclockwise; -1 for equal points.
// Only signs of differences are used, so the answer is exact.
template <typename Point>
inline int first_direction(const Point& from, const Point& to)
{
  const int sx = (to.x() > from.x()) - (to.x() < from.x());
  const int sy = (to.y() > from.y()) - (to.y() < from.y());
  if(sy > 0)
    return sx > 0 ? 1 : sx < 0 ? 2 : 1;
  if(sy < 0)
    return sx > 0 ? 0 : 3;
  return sx > 0 ? 0 : sx < 0 ? 2 : -1;
}

// Whether the segment points in a grid direction exactly.
template <typename Point>
inline bool is_grid_aligned(const Point& from, const Point& to)
{
  return (from.x() == to.x()) != (from.y() == to.y());
}

// Calls `f(d, s)` for each grid direction d in the sector between the vectors `p -> a`, its right side, and
// `p -> b`, its left side, in the order in which they follow each other counterclockwise on the surface; s is the sign
// of the sector.
//
// The sector is half-open: of its two sides the one that comes first counterclockwise in the *chart* counts. In
// positive sectors this is the right side; a negative sector runs clockwise in its chart, and there it is the left
// side. So directions that a fan runs over forth and back cancel exactly. With `closed` both sides count: for the last
// sector of a border vertex, or the first one if negative.
template <typename Point, typename Function>
inline void for_each_direction_in_sector(const Point& p, const Point& a, const Point& b, int sign, bool closed,
                                         const Function& f)
{
  const int da = first_direction(p, a), db = first_direction(p, b);
  if(da == -1 || db == -1)
    return;
  if(sign >= 0)
  {
    const int n = (db - da) & 3;
    for(int i = 0; i < n; ++i)
      f((da + i) & 3, 1);
    if(closed && is_grid_aligned(p, b))
      f(db, 1);
  }
  else
  {
    if(closed && is_grid_aligned(p, a))
      f(da, -1);
    const int n = (da - db) & 3;
    for(int i = n - 1; i >= 0; --i)
      f((db + i) & 3, -1);
  }
}

// The same for the sector of a vertex between halfedge h and the one before it.
template <typename Function>
inline void for_each_direction_in_sector(const Grid_map& map, int h, const Function& f)
{
  typedef Indexed_triangle_mesh Mesh;
  const int sign = map.sign[h / 3];
  const bool closed = map.mesh.opposite[sign >= 0 ? Mesh::prev(h) : h] == -1;
  for_each_direction_in_sector(map.uv[h], map.uv[Mesh::next(h)], map.uv[Mesh::prev(h)], sign, closed, f);
}

// The number of inner vertices around which the directions do not add up to one turn and which are no grid points. Only
// where all faces around are positive do the directions tell the angle.
inline int number_of_singular_vertices_off_grid(const Grid_map& map)
{
  int n = 0;
  for(int v = 0; v < map.mesh.number_of_vertices(); ++v)
  {
    const int h = map.mesh.halfedge_of_vertex[v];
    if(h == -1 || map.mesh.opposite[h] == -1 || map.is_integer_corner(h))
      continue;
    int quarters = 0;
    bool positive = true;
    for_each_corner_of_vertex(map.mesh, v,
                              [&](int g)
                              {
                                positive &= map.sign[g / 3] > 0;
                                for_each_direction_in_sector(map, g, [&](int, int) { ++quarters; });
                              });
    n += positive && quarters != 4;
  }
  return n;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_MAP_H
