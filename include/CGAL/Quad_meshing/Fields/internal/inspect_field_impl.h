// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_INSPECT_FIELD_IMPL_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_INSPECT_FIELD_IMPL_H

#include <CGAL/Quad_meshing/Fields/internal/inspect_field.h>
#include <CGAL/Quad_meshing/Fields/internal/solve_field.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Field_defects inspect_field(const Field_problem& problem, const Cross_field& field)
{
  // In radians: what is left of an angle that was written with five digits.
  const double alignment_tolerance = 1e-4;

  const Indexed_triangle_mesh& m = problem.mesh;
  Field_defects defects;
  for(int f = 0; f < m.number_of_faces(); ++f)
    if(!std::isfinite(field.angle[f]))
      defects.faces_not_finite.push_back(f);
  if(!defects.faces_not_finite.empty())
    return defects;

  for(int e = 0; e < m.number_of_edges(); ++e)
  {
    if(!problem.aligned[e])
      continue;
    const int h = m.halfedge_of_edge[e], o = m.opposite[h];
    bool is_followed = true;
    for(int g : { h, o })
      if(g != -1)
      {
        const double turns = (field.angle[g / 3] - problem.frames.direction(g)) / quarter_turn;
        is_followed = is_followed && std::abs(turns - std::round(turns)) * quarter_turn < alignment_tolerance;
      }
    if(!is_followed)
      defects.misaligned_edges.push_back(e);
    else if(o != -1 && std::lround(problem.turn(e, field) / quarter_turn) != 0)
      defects.edges_with_wrong_jump.push_back(e);
  }

  const std::vector<int> quads = quads_of_sectors(m, problem.frames, problem.aligned, problem.sectors,
                                                  [&](int e) { return problem.turn(e, field); });
  for(int s = 0; s < problem.sectors.number_of_sectors(); ++s)
    if((problem.sectors.closed[s] || problem.sectors.bounded[s]) && quads[s] < 1)
      defects.vertices_without_quads.push_back(problem.sectors.vertex[s]);
  std::sort(defects.vertices_without_quads.begin(), defects.vertices_without_quads.end());
  defects.vertices_without_quads.erase(
    std::unique(defects.vertices_without_quads.begin(), defects.vertices_without_quads.end()),
    defects.vertices_without_quads.end());

  defects.indices = field_indices(problem, field);
  for(int i : defects.indices)
    defects.index_sum += i;
  int euler_number = m.number_of_faces() - m.number_of_edges();
  for(int h : m.halfedge_of_vertex)
    euler_number += h != -1;
  defects.expected_index_sum = 4 * euler_number;
  return defects;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_INSPECT_FIELD_IMPL_H
