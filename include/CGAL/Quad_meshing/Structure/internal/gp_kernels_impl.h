// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_KERNELS_IMPL_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_KERNELS_IMPL_H

#include <CGAL/Quad_meshing/Structure/internal/Gp_operators.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_search.h>
#include <CGAL/Quad_meshing/Structure/internal/gp_kernels.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Whether the steps follow each other as the state machine demands.
inline bool is_closed_gp_path(const Indexed_quad_mesh& m, const Gp_path& path)
{
  for(std::size_t i = 0; i < path.size(); ++i)
  {
    const Gp_step &s = path[i], &t = path[i + 1 < path.size() ? i + 1 : 0];
    if((s.in == -1 || s.out == -1) && s.kind != gp_collapse)
      return false;
    bool follows = s.in == -1 && t.out == -1;
    if(s.in != -1)
      for_each_next_gp_state(s, [&](int state) { follows = follows || (t.out != -1 && state == 3 * t.out + t.kind); });
    if(!follows || (t.out != -1 && t.in != m.opposite[t.out]))
      return false;
  }
  return !path.empty();
}

// Edges that are constrained are not shifted.
inline bool shifts_no_feature(const Indexed_quad_mesh& m, const Gp_path& path)
{
  for(const Gp_step& s : path)
    if(s.kind != gp_collapse && m.is_feature[s.edge()])
      return false;
  return true;
}

CGAL_QUAD_MESHING_INLINE Gp_path find_gp_operator(const Structure_state& state, bool merge_singularities,
                                                  int first_step, const std::function<double(const Gp_step&)>& cost)
{
  const Quad_vertex_rules rules = vertex_rules(state, merge_singularities);
  Gp_search search(state.mesh, rules);
  std::function<double(int)> cost_of_state;
  if(cost)
    cost_of_state = [&](int s) { return cost(gp_step(state.mesh, s)); };
  return search.close({ first_step }, cost_of_state);
}

CGAL_QUAD_MESHING_INLINE Gp_path dual_curve_gp_operator(const Structure_state& state, bool merge_singularities, int h,
                                                        Gp_kind kind)
{
  const Gp_path path = straight_path(state.mesh, h, kind);
  const Quad_vertex_rules rules = vertex_rules(state, merge_singularities);
  Gp_legality legality(state.mesh, rules);
  const bool is_allowed =
    is_closed_gp_path(state.mesh, path) && shifts_no_feature(state.mesh, path) && !legality.check(path);
  return is_allowed ? path : Gp_path();
}

CGAL_QUAD_MESHING_INLINE bool apply_gp_operator(const Structure_state& state, bool merge_singularities,
                                                const Gp_path& path, Structure_state& result)
{
  if(!is_closed_gp_path(state.mesh, path) || !shifts_no_feature(state.mesh, path))
    return false;
  const Quad_vertex_rules rules = vertex_rules(state, merge_singularities);
  Gp_legality legality(state.mesh, rules);
  return !legality.check(path) && execute_operator(state, path, rules, result);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_KERNELS_IMPL_H
