// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_STRAIGHTEN_CREASES_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_STRAIGHTEN_CREASES_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Takes creases that run to and fro along the sides of slivers straight on.
//
// A sliver on a crease, its tip laid back onto the surface, has two sharp sides of which one leads on and the other one
// back; the crease then comes by a third time. No quads can follow that. The third side of the sliver leads straight
// on: it is sharp instead of the two, if the crease turns by less on the whole. The tip of a face that is really as
// pointed as that stays, for its crease turns by as much without it.
class Crease_straightening
{
public:
  Crease_straightening(const Indexed_triangle_mesh& mesh, std::vector<char>& is_sharp)
    : m_mesh(mesh), m_is_sharp(is_sharp), m_degree(mesh.number_of_vertices(), 0), m_on_border(m_degree.size(), false)
  {
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      for(int v : { source(m_mesh.halfedge_of_edge[e]), target(m_mesh.halfedge_of_edge[e]) })
      {
        m_degree[v] += m_is_sharp[e];
        m_on_border[v] = m_on_border[v] || m_mesh.is_border_edge(e);
      }
  }

  // Returns the number of slivers. Each takes one sharp edge away, so this ends.
  std::size_t run()
  {
    std::size_t changed = 0;
    for(std::size_t before = 1; changed != before;)
    {
      before = changed;
      for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
        if(doubles_back(h))
        {
          replace(h);
          ++changed;
        }
    }
    return changed;
  }

private:
  const Indexed_triangle_mesh& m_mesh;
  std::vector<char>& m_is_sharp; // per edge
  std::vector<int> m_degree;     // per vertex: its sharp edges
  std::vector<bool> m_on_border; // per vertex

  int source(int h) const { return m_mesh.source(h); }
  int target(int h) const { return m_mesh.target(h); }

  // Whether h and the halfedge after it are sharp, the third one is not, and the crease turns by less along it.
  bool doubles_back(int h) const
  {
    const int g = Indexed_triangle_mesh::next(h), third = Indexed_triangle_mesh::prev(h);
    if(!is_sharp(h) || !is_sharp(g) || is_sharp(third) || m_mesh.opposite[third] == -1)
      return false;
    const int tip = target(h);
    if(m_degree[tip] != 2 || m_on_border[tip])
      return false;
    const int a = source(h), c = target(g);
    const double least_gain = CGAL_PI / 2; // at a tip without a fold there is none, at a fold a half turn or more
    const double at_tip = turn(a, tip, c);
    const double before = at_tip + turn_at_end(a, tip, h) + turn_at_end(c, tip, g);
    const double after = turn_at_end(a, c, h) + turn_at_end(c, a, g);
    return before - after > least_gain;
  }

  bool is_sharp(int h) const { return m_is_sharp[m_mesh.edge_of[h]]; }

  // The angle by which a path turns at q on its way from p to r.
  double turn(int p, int q, int r) const
  {
    const auto a = m_mesh.points[q] - m_mesh.points[p], b = m_mesh.points[r] - m_mesh.points[q];
    return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
  }

  // The angle by which the crease turns at v between its other sharp edge than that of h and the way to w; 0 if it does
  // not go on there as a single chain.
  double turn_at_end(int v, int w, int h) const
  {
    if(m_degree[v] != 2)
      return 0;
    double result = 0;
    for_each_corner_of_vertex(m_mesh, v,
                              [&](int g)
                              {
                                for(int k : { g, Indexed_triangle_mesh::prev(g) })
                                  if(is_sharp(k) && m_mesh.edge_of[k] != m_mesh.edge_of[h])
                                    result = turn(source(k) == v ? target(k) : source(k), v, w);
                              });
    return result;
  }

  void replace(int h)
  {
    const int g = Indexed_triangle_mesh::next(h), third = Indexed_triangle_mesh::prev(h);
    m_is_sharp[m_mesh.edge_of[h]] = m_is_sharp[m_mesh.edge_of[g]] = false;
    m_is_sharp[m_mesh.edge_of[third]] = true;
    m_degree[target(h)] = 0; // its ends lose one sharp edge and gain one
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_STRAIGHTEN_CREASES_H
