// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CHECK_GRID_MAP_IMPL_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CHECK_GRID_MAP_IMPL_H

#include <CGAL/Quad_meshing/Parameterization/internal/check_grid_map.h>
#include <CGAL/Quad_meshing/internal/Grid_automorphism.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Grid_map_defects check_grid_map(const Indexed_triangle_mesh& m,
                                                         const std::vector<std::array<double, 2>>& uv,
                                                         const std::vector<bool>& is_aligned)
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_2 Point_2;

  Grid_map_defects defects;
  for(int f = 0; f < m.number_of_faces(); ++f)
    if(!std::all_of(&uv[3 * f], &uv[3 * f] + 3,
                    [](const auto& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); }))
      defects.faces_not_finite.push_back(f);
  if(!defects.faces_not_finite.empty())
    return defects; // no other question makes sense

  auto image = [&](int h) { return Point_2(uv[h][0], uv[h][1]); }; // of the source
  auto is_integer = [](double a) { return a == std::floor(a); };
  std::vector<bool> is_folded(m.number_of_faces());
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    is_folded[f] = orientation(image(3 * f), image(3 * f + 1), image(3 * f + 2)) != LEFT_TURN;
    if(is_folded[f])
      defects.folded_faces.push_back(f);
  }

  for(int e = 0; e < m.number_of_edges(); ++e)
  {
    const int h = m.halfedge_of_edge[e], o = m.opposite[h];
    const Point_2 a = image(h), b = image(m.next(h));
    Grid_automorphism g;
    if(o != -1 && recover_grid_automorphism(a, b, image(m.next(o)), image(o), g) != Transition_kind::EXACT)
      defects.edges_without_transition.push_back(e);
    if(is_aligned[e] && !(a.x() == b.x() && is_integer(a.x())) && !(a.y() == b.y() && is_integer(a.y())))
      defects.edges_off_grid.push_back(e);
  }

  std::vector<bool> seen(m.number_of_halfedges(), false);
  for(int start = 0; start < m.number_of_halfedges(); ++start)
  {
    if(seen[start])
      continue;
    // A grid direction d leaves the vertex in the corner between a and b, counted with the side of a, if a x d >= 0 < d
    // x b.
    int directions = 0;
    bool on_grid = true, folded = false;
    int h = start;
    do
    {
      seen[h] = true;
      const Point_2 p = image(h), q = image(m.next(h)), r = image(m.prev(h));
      on_grid = on_grid && is_integer(p.x()) && is_integer(p.y());
      folded = folded || is_folded[h / 3];
      const double ax = q.x() - p.x(), ay = q.y() - p.y(), bx = r.x() - p.x(), by = r.y() - p.y();
      // cross products with (1,0), (0,1), (-1,0), (0,-1); differences of doubles have the right sign
      directions += (-ay >= 0 && by > 0) + (ax >= 0 && -bx > 0) + (ay >= 0 && -by > 0) + (-ax >= 0 && bx > 0);
      h = m.next_around_source(h);
    }
    while(h != -1 && h != start);
    if(h == start && !folded && directions != 4 && !on_grid)
      defects.vertices_off_grid.push_back(m.source(start));
  }
  std::sort(defects.vertices_off_grid.begin(), defects.vertices_off_grid.end());
  defects.vertices_off_grid.erase(std::unique(defects.vertices_off_grid.begin(), defects.vertices_off_grid.end()),
                                  defects.vertices_off_grid.end());
  return defects;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CHECK_GRID_MAP_IMPL_H
