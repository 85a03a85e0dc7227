// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_STRUCTURE_IMPL_H
#define CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_STRUCTURE_IMPL_H

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/internal/Base_complex_arrays.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>
#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Helix_detection.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Quad_mesh_structure structure_of_quad_mesh(const Indexed_quad_mesh& m)
{
  Quad_mesh_structure s;
  const int nh = m.number_of_halfedges();
  s.number_of_quads = m.corners.size();
  Disjoint_sets components(m.number_of_vertices()), loops(m.number_of_vertices());
  for(int h = 0; h < nh; ++h)
  {
    s.number_of_edges += m.edge(h) == h;
    components.join(m.source(h), m.target(h));
    if(m.is_border(h))
      loops.join(m.source(h), m.target(h));
  }
  for(int v = 0; v < m.number_of_vertices(); ++v)
  {
    const int valence = m.valence(v);
    if(valence == 0)
      continue;
    ++s.number_of_vertices;
    s.number_of_components += components.smallest(v) == v;
    const bool on_border = m.is_border_vertex(v);
    s.number_of_boundary_loops += on_border && loops.smallest(v) == v;
    const int index = (on_border ? 3 : 4) - valence;
    s.sum_of_indices += index;
    if(index != 0)
    {
      ++s.number_of_irregular_vertices;
      ++(on_border ? s.boundary_valences : s.inner_valences)[valence];
    }
  }
  s.euler_characteristic =
    static_cast<int>(s.number_of_vertices) - static_cast<int>(s.number_of_edges) + static_cast<int>(s.number_of_quads);

  const Dual_lines lines(m);
  std::vector<char> crosses_itself(lines.number_of_lines(), 0);
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    const int a = lines.line[4 * f], b = lines.line[4 * f + 1];
    if(a == b || a == lines.reverse[b])
    {
      ++s.number_of_self_intersections;
      crosses_itself[(std::min)(a, lines.reverse[a])] = 1;
    }
  }
  for(int l = 0; l < lines.number_of_lines(); ++l)
    if(lines.is_representative(l))
    {
      ++s.number_of_dual_curves;
      s.number_of_closed_dual_curves += lines.is_closed[l];
      s.number_of_self_intersecting_dual_curves += crosses_itself[l];
      s.longest_dual_curve = (std::max)(s.longest_dual_curve, std::size_t(lines.length[l]));
    }
  const Parallel_classes classes = make_parallel_classes(m, lines);
  s.number_of_parallel_classes = classes.number_of_classes;
  s.number_of_representative_crossings = number_of_representative_crossings(m, lines, classes);

  const Base_complex_arrays bc = make_base_complex(m);
  s.number_of_patches = bc.number_of_patches;
  s.number_of_nodes = bc.number_of_nodes;
  s.number_of_arcs = bc.number_of_arcs;
  for(int corners : bc.corners_of_patch)
    s.number_of_patches_not_rectangular += corners != 4;

  const std::vector<Side_relation> relation = side_relations(m, lines);
  const std::vector<Helix_record> helices = minimal_helices(m, lines, relation);
  s.number_of_helices = helices.size();
  s.number_of_helices_with_crossings = minimal_helices(m, lines, relation, true).size();
  for(const Helix_record& h : helices)
  {
    s.smallest_pitch = s.smallest_pitch == 0 ? std::abs(h.pitch) : (std::min)(s.smallest_pitch, std::abs(h.pitch));
    s.largest_winding_number = (std::max)(s.largest_winding_number, double(h.length) / h.turn_length);
  }
  return s;
}

CGAL_QUAD_MESHING_INLINE Base_complex_of_quad_mesh base_complex_of_quad_mesh(const Indexed_quad_mesh& m)
{
  const Base_complex_arrays bc = make_base_complex(m);
  return Base_complex_of_quad_mesh{ bc.is_separatrix, bc.patch, bc.number_of_patches };
}

CGAL_QUAD_MESHING_INLINE std::vector<Helix_of_quad_mesh> helices_of_quad_mesh(const Indexed_quad_mesh& m)
{
  const Dual_lines lines(m);
  std::vector<Helix_of_quad_mesh> helices;
  for(const Helix_record& r : minimal_helices(m, lines, side_relations(m, lines)))
  {
    int h = lines.first[r.line];
    for(int p = 0; p < r.start; ++p)
      h = m.forward(h);
    helices.push_back(Helix_of_quad_mesh{ h, r.pitch, r.turn_length, r.length });
  }
  auto winding_number = [](const Helix_of_quad_mesh& h) { return double(h.length) / h.turn_length; };
  std::stable_sort(helices.begin(), helices.end(),
                   [&](const Helix_of_quad_mesh& a, const Helix_of_quad_mesh& b)
                   { return winding_number(a) > winding_number(b); });
  return helices;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUAD_MESH_INTERNAL_QUAD_MESH_STRUCTURE_IMPL_H
