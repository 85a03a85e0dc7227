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

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Edges that windows pass without being listed there, long ones first. The faces that open edges join form groups without
// cycles, so that each group can be unfolded into the plane.
template <typename FT>
class Open_edges
{
public:
  typedef Unfolded_mesh<FT> Mesh;

  // None are open unless `has_groups`.
  Open_edges(const Mesh& mesh, bool has_groups)
    : m_behind(mesh.number_of_halfedges(), -1)
  {
    if(has_groups)
      Choice(mesh, m_behind).open();
  }

  // The halfedge on the other side of an open edge, -1 if the edge is not open.
  int behind(int h) const { return m_behind[h]; }

  // The faces of the group of a face, in increasing order.
  std::vector<int> group(int f) const
  {
    std::vector<int> faces(1, f);
    std::vector<int> from(1, -1);        // by which halfedge each is entered
    for(std::size_t i = 0; i < faces.size(); ++i)
      for(int h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h)
        if(m_behind[h] != -1 && h != from[i])
        {
          faces.push_back(Mesh::face(m_behind[h]));
          from.push_back(m_behind[h]);
        }
    std::sort(faces.begin(), faces.end());
    return faces;
  }

private:
  class Choice
  {
  public:
    Choice(const Mesh& mesh, std::vector<int>& behind)
      : m_mesh(mesh), m_behind(behind), m_group(mesh.number_of_faces(), -1), m_longest(mesh.number_of_faces())
    {}

    void open()
    {
      for(int f = 0; f < m_mesh.number_of_faces(); ++f)
        examine(f);
      for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      {
        const int h = m_longest[f], o = m_mesh.opposite[h];
        if(h < o && m_longest[Mesh::face(o)] == o)
          open(h);
      }
      for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      {
        const int h = m_longest[f], n = Mesh::next(h), p = Mesh::prev(h);
        const typename Mesh::Apex& a = m_mesh.apex[h];
        const bool n_first = a.x + a.back < FT(0);
        open(h);
        open(n_first ? n : p);
        open(n_first ? p : n);
      }
    }

  private:
    // The work per window grows with the group: that many faces serve best.
    static int largest_group() { return 32; }

    // Faces that are flatter than this part of their longest side stay alone: their corners are not unfolded far from their frame.
    static FT flatness() { return FT(1e-3); }

    // Finds the longest side from the frame of the first one: the lengths of edges lie all over the memory.
    int longest_side(int f) const
    {
      const typename Mesh::Apex& a = m_mesh.apex[3 * f];
      const FT l = a.x - a.back, y2 = a.y * a.y, first = l * l, second = a.back * a.back + y2, third = a.x * a.x + y2;
      return 3 * f + (first < second ? (second < third ? 2 : 1) : first < third ? 2 : 0);
    }

    // Paths from a vertex that lies on the opposite edge pass it at once: so faces beside one of no area stay alone too, and
    // windows from vertices enter groups at their edges or begin in them.
    void examine(int f)
    {
      const int h = longest_side(f);
      m_longest[f] = h;
      const typename Mesh::Apex& a = m_mesh.apex[h];
      const FT height = a.y;
      if(height > flatness() * (a.x - a.back))
        return;
      m_group[f] = alone();
      for(int g = 3 * f; g < 3 * f + 3; ++g)
        if(height == FT(0) && m_mesh.opposite[g] != -1)
          m_group[Mesh::face(m_mesh.opposite[g])] = alone();
    }

    void open(int h)
    {
      const int o = m_mesh.opposite[h];
      if(o == -1)
        return;
      int a = representative(Mesh::face(h)), b = representative(Mesh::face(o));
      if(a == b || m_group[a] + m_group[b] < -largest_group())
        return;
      if(m_group[a] > m_group[b])
        std::swap(a, b);
      m_group[a] += m_group[b];
      m_group[b] = a;
      m_behind[h] = o;
      m_behind[o] = h;
    }

    int representative(int f)
    {
      int g = f;
      while(m_group[g] >= 0)
        g = m_group[g];
      // short ways for later: each face on the way leads there at once
      while(m_group[f] >= 0)
        f = std::exchange(m_group[f], g);
      return g;
    }

    // Counts as a group to which nothing can be joined.
    static int alone() { return -largest_group(); }

    const Mesh& m_mesh;
    std::vector<int>& m_behind;
    std::vector<int> m_group;               // per face: minus the size of its group at the representative of the group, a face nearer to that elsewhere
    std::vector<int> m_longest;             // per face: its longest side
  };

  std::vector<int> m_behind;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_OPEN_EDGES_H
