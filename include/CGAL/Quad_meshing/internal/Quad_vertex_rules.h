// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_QUAD_VERTEX_RULES_H
#define CGAL_QUAD_MESHING_INTERNAL_QUAD_VERTEX_RULES_H

#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The properties of vertices that must not be merged with each other.
struct Quad_vertex_rules
{
  std::vector<char> is_special;   // irregular, or a corner of the features: no two become one
  std::vector<char> is_irregular; // these do not move onto a feature or the border
  std::vector<char> on_feature;   // two features do not become one ...
  std::vector<char> on_border;    // ... nor do two borders
};

inline Quad_vertex_rules make_quad_vertex_rules(const Indexed_quad_mesh& m, bool merge_singularities)
{
  Quad_vertex_rules r;
  const int nv = m.number_of_vertices();
  r.is_special.assign(nv, 0);
  r.is_irregular.assign(nv, 0);
  r.on_feature.assign(nv, 0);
  r.on_border.assign(nv, 0);
  std::vector<int> feature_degree(nv, 0);
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(m.edge(h) == h)
      for(int v : { m.source(h), m.target(h) })
      {
        feature_degree[v] += m.is_feature[h] && !m.is_border(h);
        r.on_border[v] |= m.is_border(h);
      }
  for(int v = 0; v < nv; ++v)
  {
    r.on_feature[v] = feature_degree[v] > 0;
    // where features end, branch or meet the border
    const bool is_corner = feature_degree[v] > 0 && (feature_degree[v] != 2 || r.on_border[v]);
    const bool irregular = is_irregular(m, v);
    r.is_irregular[v] = irregular && !merge_singularities;
    r.is_special[v] = is_corner || (irregular && (!merge_singularities || r.on_border[v]));
  }
  return r;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_QUAD_VERTEX_RULES_H
