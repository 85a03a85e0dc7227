// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_TOPOLOGY_FIGURES_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_TOPOLOGY_FIGURES_H

#include <CGAL/Quad_meshing/Extraction/internal/Grid_graph.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What decides whether two oriented surfaces are the same up to the distribution of handles and borders over the components.
struct Topology_figures
{
  std::ptrdiff_t euler_characteristic = 0;
  std::size_t components = 0;
  std::size_t border_loops = 0;

  bool operator==(const Topology_figures& t) const
  {
    return euler_characteristic == t.euler_characteristic && components == t.components && border_loops == t.border_loops;
  }
};

// Counts the components of n things of which some pairs are joined.
class Component_counter
{
  std::vector<int> m_parent;
  std::size_t m_components;

  int root(int i)
  {
    while(m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

public:
  explicit Component_counter(int n) : m_parent(n), m_components(n)
  {
    for(int i = 0; i < n; ++i)
      m_parent[i] = i;
  }

  void join(int i, int j)
  {
    const int a = root(i), b = root(j);
    m_parent[a] = b;
    m_components -= a != b;
  }

  std::size_t components() const { return m_components; }
};

// The number of cycles that `next` makes of the border halfedges among 0 to n - 1.
template <typename IsBorder, typename Next>
std::size_t count_border_loops(int n, const IsBorder& is_border, const Next& next)
{
  std::vector<char> seen(n, false);
  std::size_t loops = 0;
  for(int h = 0; h < n; ++h)
  {
    if(seen[h] || !is_border(h))
      continue;
    ++loops;
    for(int g = h; !seen[g]; g = next(g))
      seen[g] = true;
  }
  return loops;
}

inline Topology_figures topology_figures(const Indexed_triangle_mesh& m)
{
  Topology_figures t;
  for(int h : m.halfedge_of_vertex)
    t.euler_characteristic += h != -1;
  t.euler_characteristic += m.number_of_faces() - m.number_of_edges();

  Component_counter counter(m.number_of_faces());
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(m.opposite[h] > h)
      counter.join(h / 3, m.opposite[h] / 3);
  t.components = counter.components();

  t.border_loops = count_border_loops(m.number_of_halfedges(),
    [&](int h) { return m.opposite[h] == -1; },
    [&](int h)
    {
      h = m.next(h);
      while(m.opposite[h] != -1)
        h = m.next(m.opposite[h]);
      return h;
    });
  return t;
}

// The same of the faces of the graph, with vertices as `make_vertices()` makes them.
inline Topology_figures topology_figures(const Grid_graph& g, std::size_t number_of_vertices)
{
  Topology_figures t;
  t.euler_characteristic = static_cast<std::ptrdiff_t>(number_of_vertices) + g.number_of_faces();

  Component_counter counter(g.number_of_faces());
  for(int r = 0; r < g.number_of_rays(); ++r)
  {
    const int o = g.opposite[r];
    if(o < r || (g.face[r] < 0 && g.face[o] < 0))
      continue;
    --t.euler_characteristic;
    if(g.face[r] >= 0 && g.face[o] >= 0)
      counter.join(g.face[r], g.face[o]);
  }
  t.components = counter.components();

  t.border_loops = count_border_loops(g.number_of_rays(),
    [&](int r) { return g.opposite[r] >= 0 && g.face[r] < 0 && g.face[g.opposite[r]] >= 0; },
    [&](int r) { return g.next_on_border(r); });
  return t;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_TOPOLOGY_FIGURES_H
