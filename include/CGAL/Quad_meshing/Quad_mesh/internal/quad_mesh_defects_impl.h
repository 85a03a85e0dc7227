// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_DEFECTS_IMPL_H
#define CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_DEFECTS_IMPL_H

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Quad_mesh_defects defects_of_polygons(const Flat_polygons& polygons)
{
  const std::vector<std::size_t>&first_corner = polygons.first_corner, &vertex_of_corner = polygons.vertex_of_corner;
  const std::size_t n = polygons.number_of_points;
  Quad_mesh_defects d;
  d.invalid_coordinates = polygons.invalid_coordinates;
  d.faces = first_corner.size() - 1;

  // sides as (smaller end, larger end), and whether they run from the smaller to the larger
  struct Side
  {
    std::size_t low, high, face, corner;
    bool is_ascending;
    bool operator<(const Side& s) const
    {
      return low != s.low     ? low < s.low
             : high != s.high ? high < s.high
             : face != s.face ? face < s.face
                              : corner < s.corner;
    }
  };
  std::vector<Side> sides;
  for(std::size_t f = 0; f < d.faces; ++f)
  {
    const std::size_t first = first_corner[f], degree = first_corner[f + 1] - first;
    d.faces_not_quads += degree != 4;
    std::set<std::size_t> distinct;
    bool usable = true;
    for(std::size_t k = 0; k < degree; ++k)
    {
      const std::size_t v = vertex_of_corner[first + k];
      distinct.insert(v);
      if(v >= n)
      {
        ++d.invalid_indices;
        usable = false;
      }
    }
    d.faces_repeating_vertices += distinct.size() < degree;
    for(std::size_t k = 0; usable && k < degree; ++k)
    {
      const std::size_t v = vertex_of_corner[first + k], w = vertex_of_corner[first + (k + 1) % degree];
      sides.push_back(Side{ (std::min)(v, w), (std::max)(v, w), f, first + k, v < w });
    }
  }
  if(d.invalid_indices > 0)
    return d;

  // Corners of one vertex are joined over shared sides: one set of corners per fan.
  Disjoint_sets fans(static_cast<int>(vertex_of_corner.size()));
  std::sort(sides.begin(), sides.end());
  for(std::size_t i = 0, j; i < sides.size(); i = j)
  {
    for(j = i + 1; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high; ++j)
    {
    }
    d.non_manifold_edges += j - i > 2;
    d.inconsistent_edges += j - i == 2 && sides[i].is_ascending == sides[i + 1].is_ascending;
    for(std::size_t k = i + 1; k < j; ++k)
    {
      auto behind = [&](const Side& s)
      { return s.corner + 1 == first_corner[s.face + 1] ? first_corner[s.face] : s.corner + 1; };
      const std::size_t a[2] = { sides[i].corner, behind(sides[i]) }, b[2] = { sides[k].corner, behind(sides[k]) };
      const bool same = sides[i].is_ascending == sides[k].is_ascending;
      for(int e = 0; e < 2; ++e)
        fans.join(static_cast<int>(a[e]), static_cast<int>(b[same ? e : 1 - e]));
    }
  }
  std::vector<std::size_t> number_of_fans(n, 0);
  for(std::size_t c = 0; c < vertex_of_corner.size(); ++c)
    number_of_fans[vertex_of_corner[c]] += fans.smallest(static_cast<int>(c)) == static_cast<int>(c);
  for(std::size_t k : number_of_fans)
  {
    d.isolated_vertices += k == 0;
    d.non_manifold_vertices += k > 1;
  }
  return d;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_DEFECTS_IMPL_H
