// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_OPEN_EDGES_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_OPEN_EDGES_H

#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Chooses edges that windows pass without being kept there, long ones first. The faces that open edges join form groups without
// cycles, so that each group can be unfolded into the plane.
template <typename FT>
class Open_edges
{
public:
  typedef Unfolded_mesh<FT> Mesh;

  explicit Open_edges(const Mesh& mesh)
    : m_mesh(mesh), m_group(mesh.number_of_faces(), -1), m_behind(mesh.number_of_halfedges(), -1)
  {
    for(int pass = 0; pass < 2; ++pass)
      for(int f = 0; f < mesh.number_of_faces(); ++f)
        open_sides(f, pass == 0);
  }

  std::vector<int> take() { return std::move(m_behind); }

private:
  // The work per window grows with the group: that many faces serve best.
  static int largest_group() { return 16; }

  // Faces that are flatter than this part of their longest side stay alone: their corners are not unfolded far from their frame.
  static FT flatness() { return FT(1e-3); }

  bool is_flat(int longest) const { return ! (m_mesh.apex[longest].y > flatness() * m_mesh.length_of(longest)); }

  int longest_side(int f) const
  {
    int best = 3 * f;
    for(int h = 3 * f + 1; h < 3 * f + 3; ++h)
      if(m_mesh.length_of(best) < m_mesh.length_of(h))
        best = h;
    return best;
  }

  void open_sides(int f, bool only_where_longest)
  {
    const int h = longest_side(f);
    if(is_flat(h))
      return;
    if(only_where_longest)
    {
      const int o = m_mesh.opposite[h];
      if(h < o && longest_side(o / 3) == o)
        open(h);
      return;
    }
    const int n = Mesh::next(h), p = Mesh::prev(h);
    const bool n_first = m_mesh.length_of(p) < m_mesh.length_of(n);
    open(h);
    open(n_first ? n : p);
    open(n_first ? p : n);
  }

  void open(int h)
  {
    const int o = m_mesh.opposite[h];
    if(o == -1)
      return;
    const int a = group(h / 3), b = group(o / 3);
    if(a == b || m_group[a] + m_group[b] < -largest_group() || is_flat(longest_side(o / 3)))
      return;
    m_group[a] += m_group[b];
    m_group[b] = a;
    m_behind[h] = o;
    m_behind[o] = h;
  }

  // Of a face; union-find, where the first face of a group holds its size, negative.
  int group(int f)
  {
    while(m_group[f] >= 0)
    {
      if(m_group[m_group[f]] >= 0)
        m_group[f] = m_group[m_group[f]];
      f = m_group[f];
    }
    return f;
  }

  const Mesh& m_mesh;
  std::vector<int> m_group;
  std::vector<int> m_behind;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_OPEN_EDGES_H
