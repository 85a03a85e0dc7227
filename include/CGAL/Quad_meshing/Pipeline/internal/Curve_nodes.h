// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_CURVE_NODES_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_CURVE_NODES_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The vertices of curves of the user that the quads must have: ends, crossings and sharp bends.
//
// A bend counts if the curve turns there, and still does so when it is seen from half a quad away: curves along the
// edges of triangles zigzag, and a quad vertex at every tooth leaves no room for quads. Of bends that are closer to
// each other, the one with the largest turn counts.
class Curve_nodes
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_kernel::Vector_3 Vector_3;
  typedef Mesh::Vertex_index Vertex;

public:
  // Returns a mark per vertex; nothing if there are no curves.
  static std::vector<char> find(const Quadrangulation_surface& surface) { return Curve_nodes(surface).nodes(); }

private:
  // In degrees; what turns less, a chain of quad edges rounds off by a hundredth of an edge or two.
  static constexpr double largest_turn = 15;
  // In lengths of quads: how far along the curve a bend is looked at.
  static constexpr double reach = 0.5;

  explicit Curve_nodes(const Quadrangulation_surface& surface)
    : m_surface(surface), m_next(surface.mesh.number_of_vertices())
  {
    const Mesh& m = surface.mesh;
    for(Mesh::Edge_index e : m.edges())
      if(surface.is_kept[e] && !m.is_border(e))
      {
        m_is_empty = false;
        m_next[m.vertex(e, 0)].push_back(m.vertex(e, 1));
        m_next[m.vertex(e, 1)].push_back(m.vertex(e, 0));
      }
  }

  std::vector<char> nodes()
  {
    std::vector<char> is_node;
    if(m_is_empty)
      return is_node;
    const Mesh& m = m_surface.mesh;
    std::vector<double> turn(m.number_of_vertices(), 0.); // of bends, seen from half a quad away
    for(Vertex v : m.vertices())
      if(m_next[v].size() == 2 && angle(m_next[v][0], v, m_next[v][1]) > largest_turn)
        turn[v] = angle(walk(v, 0).back(), v, walk(v, 1).back());
    for(Vertex v : m.vertices())
    {
      bool is_here = !m_next[v].empty() && m_next[v].size() != 2;
      if(turn[v] > largest_turn)
      {
        is_here = true;
        for(int side = 0; side < 2; ++side)
          for(Vertex w : walk(v, side))
            is_here = is_here && (turn[w] < turn[v] || (turn[w] == turn[v] && v < w));
      }
      is_node.push_back(is_here);
    }
    return is_node;
  }

  // The vertices that follow v on one side, up to the first one in reach of no bend, or to the end of the curve.
  std::vector<Vertex> walk(Vertex v, int side) const
  {
    const Mesh& m = m_surface.mesh;
    const Mesh::Halfedge_index h = m.halfedge(v);
    const double limit = reach * m_surface.length[m.face(m.is_border(h) ? m.opposite(h) : h)];
    std::vector<Vertex> result(1, m_next[v][side]);
    Vertex before = v;
    for(double length = distance(v, result.back()); length < limit && m_next[result.back()].size() == 2;)
    {
      const Vertex w = result.back(), next = m_next[w][m_next[w][0] == before ? 1 : 0];
      if(next == v) // a closed curve that is shorter than that
        break;
      length += distance(w, next);
      before = w;
      result.push_back(next);
    }
    return result;
  }

  double distance(Vertex a, Vertex b) const
  {
    return std::sqrt((m_surface.mesh.point(b) - m_surface.mesh.point(a)).squared_length());
  }

  // By how much the way from a to b turns at v, in degrees.
  double angle(Vertex a, Vertex v, Vertex b) const
  {
    const Mesh& m = m_surface.mesh;
    const Vector_3 p = m.point(v) - m.point(a), q = m.point(b) - m.point(v);
    return std::atan2(std::sqrt(cross_product(p, q).squared_length()), p * q) * 180 / CGAL_PI;
  }

  const Quadrangulation_surface& m_surface;
  std::vector<std::vector<Vertex>> m_next; // per vertex: its neighbors on curves
  bool m_is_empty = true;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_CURVE_NODES_H
