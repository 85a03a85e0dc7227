// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_SOLVE_FIELD_IMPL_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_SOLVE_FIELD_IMPL_H

#include <CGAL/Quad_meshing/Fields/internal/Field_solver.h>
#include <CGAL/Quad_meshing/Fields/internal/solve_field.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Cross_field_status solve_field(const Field_problem& problem, const Field_options& options,
                                                        Any_visitor& visitor, Cross_field& field,
                                                        Cross_field_result& result)
{
  const Visited_stage stage(visitor, "cross field");
  Stage_progress progress(visitor);
  const double factorized = 0.1;
  progress.begin_part(factorized);
  if(!progress.go_further())
    return Cross_field_status::STOPPED;
  return Field_solver(problem, options, progress)(field, result);
}

CGAL_QUAD_MESHING_INLINE std::vector<int> field_indices(const Field_problem& problem, const Cross_field& field)
{
  const Indexed_triangle_mesh& m = problem.mesh;
  const std::vector<char> undivided(m.number_of_edges(), 0);
  const Field_sectors fans = make_field_sectors(m, undivided);
  const std::vector<int> quads =
    quads_of_sectors(m, problem.frames, undivided, fans, [&](int e) { return problem.turn(e, field); });
  std::vector<int> index(m.number_of_vertices(), 0);
  for(int i = 0; i < fans.number_of_sectors(); ++i)
    index[fans.vertex[i]] += (fans.closed[i] ? 4 : 2) - quads[i];
  return index;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_SOLVE_FIELD_IMPL_H
