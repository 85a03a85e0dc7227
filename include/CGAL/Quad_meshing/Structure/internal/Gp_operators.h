// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_OPERATORS_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_OPERATORS_H

#include <CGAL/Quad_meshing/Structure/internal/Gp_execution.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_path.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The same operation on every edge that the dual curve of h crosses; for shifts it must be closed.
inline Gp_path straight_path(const Indexed_quad_mesh& m, int h, Gp_kind kind)
{
  Gp_path path;
  int first = h;
  for(int b = m.opposite[m.across(first)]; b != -1 && b != h; b = m.opposite[m.across(first)])
    first = b;
  if(m.opposite[m.across(first)] == -1)
    path.push_back(Gp_step{ -1, m.across(first), kind });
  for(int s = first;;)
  {
    path.push_back(Gp_step{ s, m.opposite[s], kind });
    s = m.forward(s);
    if(s == -1 || s == first)
      return path;
  }
}

// The collapse of the whole dual curve of a dual edge.
inline Gp_path collapse_path(const Indexed_quad_mesh& m, int h) { return straight_path(m, h, gp_collapse); }

inline Quad_vertex_rules vertex_rules(const Structure_state& s, bool merge_singularities)
{
  Quad_vertex_rules rules = make_quad_vertex_rules(s.mesh, merge_singularities);
  for(std::size_t v = 0; v < s.is_fixed.size(); ++v)
    if(s.is_fixed[v])
      rules.is_special[v] = 1;
  return rules;
}

// Executes a legal path; false if the result is not a mesh that can be represented, because edges
// would share both ends.
inline bool execute_operator(const Structure_state& s, const Gp_path& path, const Quad_vertex_rules& rules,
                             Structure_state& result)
{
  const int nv = s.mesh.number_of_vertices();
  std::vector<char> weight(nv);
  for(int v = 0; v < nv; ++v)
    weight[v] = s.is_fixed[v]                               ? 4
                : rules.on_feature[v] || rules.on_border[v] ? 2 + rules.is_special[v]
                                                            : rules.is_irregular[v];
  Gp_execution execution(s.mesh, path);
  result.mesh = execution.execute(weight);
  if(result.mesh.number_of_faces() == 0 || !is_valid_quad_mesh(result.mesh))
    return false;
  result.is_fixed.assign(result.mesh.number_of_vertices(), 0);
  for(int v = 0; v < nv; ++v)
    if(s.is_fixed[v])
      result.is_fixed[execution.vertex_of[v]] = 1;
  result.vertex_origin.clear();
  for(int v : execution.vertex_from)
    result.vertex_origin.push_back(s.vertex_origin[v]);
  result.has_failed.clear();
  result.face_origin.clear();
  for(int f = 0; f < s.mesh.number_of_faces(); ++f)
    if(execution.face_of[f] != -1)
    {
      result.has_failed.push_back(s.has_failed[f]);
      result.face_origin.push_back(s.face_origin[f]);
    }
  result.face_of = std::move(execution.face_of);
  return true;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_OPERATORS_H
