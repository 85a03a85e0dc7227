// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SPLIT_QUAD_MESH_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SPLIT_QUAD_MESH_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A quad mesh whose dual lines are split into several parallel ones: each edge into as many parts as are asked
// for, each quad into a grid. Vertices of the mesh keep their numbers; new ones lie on straight edges, or bilinearly
// in quads.
class Split_quad_mesh
{
  typedef Indexed_quad_mesh::Point_3 Point_3;

  const Indexed_quad_mesh& m_from;
  const std::vector<int>& m_parts;
  std::vector<int> m_first; // per halfedge that stands for its edge: the first new vertex on it

public:
  Indexed_quad_mesh mesh;

  // `parts`: of each halfedge, at least 1; the same for opposite halfedges and for opposite sides of a quad.
  Split_quad_mesh(const Indexed_quad_mesh& from, const std::vector<int>& parts) : m_from(from), m_parts(parts)
  {
    mesh.points = from.points;
    m_first.assign(static_cast<std::size_t>(from.number_of_halfedges()), -1);
    for(int h = 0; h < from.number_of_halfedges(); ++h)
      if(from.edge(h) == h)
      {
        m_first[h] = mesh.number_of_vertices();
        for(int k = 1; k < parts[h]; ++k)
          mesh.points.push_back(
            between(from.points[from.source(h)], from.points[from.target(h)], double(k) / parts[h]));
      }
    std::vector<char> sides;
    for(int f = 0; f < from.number_of_faces(); ++f)
      split_face(f, sides);
    mesh.connect();
    mesh.is_feature = sides;
  }

  // The vertex after `k` of the parts of a halfedge, from its source on.
  int vertex(int h, int k) const
  {
    const int n = m_parts[h], e = m_from.edge(h);
    if(k == 0)
      return m_from.source(h);
    if(k == n)
      return m_from.target(h);
    return m_first[e] + (e == h ? k : n - k) - 1;
  }

private:
  static Point_3 between(const Point_3& p, const Point_3& q, double w) { return p + w * (q - p); }

  // The grid of a face: i runs along its side 0, j along its side 1.
  void split_face(int f, std::vector<char>& sides)
  {
    const int h = 4 * f, a = m_parts[h], b = m_parts[h + 1];
    const std::array<int, 4>& c = m_from.corners[f];
    const int inner = mesh.number_of_vertices();
    for(int j = 1; j < b; ++j)
      for(int i = 1; i < a; ++i)
        mesh.points.push_back(between(between(m_from.points[c[0]], m_from.points[c[1]], double(i) / a),
                                      between(m_from.points[c[3]], m_from.points[c[2]], double(i) / a), double(j) / b));
    const auto grid = [&](int i, int j)
    {
      if(j == 0)
        return vertex(h, i);
      if(i == a)
        return vertex(h + 1, j);
      if(j == b)
        return vertex(h + 2, a - i);
      if(i == 0)
        return vertex(h + 3, b - j);
      return inner + (j - 1) * (a - 1) + i - 1;
    };
    for(int j = 0; j < b; ++j)
      for(int i = 0; i < a; ++i)
      {
        mesh.corners.push_back({ { grid(i, j), grid(i + 1, j), grid(i + 1, j + 1), grid(i, j + 1) } });
        sides.push_back(j == 0 && m_from.is_feature[h]);
        sides.push_back(i + 1 == a && m_from.is_feature[h + 1]);
        sides.push_back(j + 1 == b && m_from.is_feature[h + 2]);
        sides.push_back(i == 0 && m_from.is_feature[h + 3]);
      }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SPLIT_QUAD_MESH_H
