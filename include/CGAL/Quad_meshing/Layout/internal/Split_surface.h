// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_SPLIT_SURFACE_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_SPLIT_SURFACE_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A triangle mesh whose edges and faces can be split, and on whose edges arcs are drawn. Parts of feature edges are
// feature edges.
//
// Every vertex lies on the input surface, every face in one of its faces. The edge arrays of the mesh are not kept up.
struct Split_surface
{
  typedef Indexed_triangle_mesh::Point_3 Point_3;

  Indexed_triangle_mesh mesh;
  std::vector<int> origin;      // per face: the face of the input that it lies in
  std::vector<int> direction;   // per halfedge: the direction of the arc along it (see Layout_topology), -1 without one
  std::vector<char> is_feature; // per halfedge

  Split_surface(const Indexed_triangle_mesh& input, const std::vector<char>& feature_halfedges)
    : mesh(input)
    , origin(input.number_of_faces())
    , direction(input.number_of_halfedges(), -1)
    , is_feature(feature_halfedges)
  {
    for(int f = 0; f < input.number_of_faces(); ++f)
      origin[f] = f;
  }

  bool is_on_arc(int h) const { return direction[h] != -1; }

  // Marks the edge of a halfedge as part of an arc.
  void draw(int h, int d)
  {
    direction[h] = d;
    if(mesh.opposite[h] != -1)
      direction[mesh.opposite[h]] = d ^ 1;
  }

  // Puts a new vertex on the edge of h = (a, b). Then h = (a, new), and two edges lead from the new vertex to the
  // corners opposite to the edge. Returns the new vertex. `renamed(from, to)` is told that a halfedge that keeps its
  // place has another number now.
  template <typename Renamed>
  int split_edge(int h, const Point_3& p, const Renamed& renamed)
  {
    const int v = add_vertex(p);
    const int o = mesh.opposite[h];
    const int f = split_half(h, v, renamed);
    // the new faces hold the halves (v, b) and (v, a)
    mesh.halfedge_of_vertex[v] = 3 * f;
    copy_marks(h, 3 * f);
    if(o != -1)
    {
      const int g = split_half(o, v, renamed);
      copy_marks(o, 3 * g);
      join(h, 3 * g);
      join(3 * f, o);
    }
    else
      mesh.opposite[3 * f] = -1;
    return v;
  }

  int split_edge(int h, const Point_3& p)
  {
    return split_edge(h, p, [](int, int) {});
  }

  // Puts a new vertex into a face. Returns it.
  int split_face(int f, const Point_3& p)
  {
    const int v = add_vertex(p);
    const std::array<int, 3> c = mesh.corners[f];
    const int f1 = add_face(c[1], c[2], v, origin[f]), f2 = add_face(c[2], c[0], v, origin[f]);
    move(3 * f + 1, 3 * f1);
    move(3 * f + 2, 3 * f2);
    mesh.corners[f][2] = v;
    clear_marks(3 * f + 1);
    clear_marks(3 * f + 2);
    join(3 * f + 1, 3 * f1 + 2);
    join(3 * f1 + 1, 3 * f2 + 2);
    join(3 * f2 + 1, 3 * f + 2);
    mesh.halfedge_of_vertex[v] = 3 * f + 2;
    return v;
  }

private:
  int add_vertex(const Point_3& p)
  {
    mesh.points.push_back(p);
    mesh.halfedge_of_vertex.push_back(-1);
    return mesh.number_of_vertices() - 1;
  }

  int add_face(int a, int b, int c, int origin_face)
  {
    mesh.corners.push_back({ { a, b, c } });
    mesh.opposite.insert(mesh.opposite.end(), 3, -1);
    direction.insert(direction.end(), 3, -1);
    is_feature.insert(is_feature.end(), 3, 0);
    origin.push_back(origin_face);
    return mesh.number_of_faces() - 1;
  }

  void copy_marks(int from, int to)
  {
    direction[to] = direction[from];
    is_feature[to] = is_feature[from];
  }

  void clear_marks(int h)
  {
    direction[h] = -1;
    is_feature[h] = 0;
  }

  void join(int g, int h)
  {
    mesh.opposite[g] = h;
    mesh.opposite[h] = g;
  }

  // The halfedge `from` gets the number `to`; its vertices are there already.
  void move(int from, int to)
  {
    const int o = mesh.opposite[from];
    mesh.opposite[to] = o;
    if(o != -1)
      mesh.opposite[o] = to;
    copy_marks(from, to);
    if(mesh.halfedge_of_vertex[mesh.source(to)] == from)
      mesh.halfedge_of_vertex[mesh.source(to)] = to;
  }

  // Cuts the face (a, b, c) of h = (a, b) into (a, v, c) and a new one, (v, b, c), which is returned.
  template <typename Renamed>
  int split_half(int h, int v, const Renamed& renamed)
  {
    const int n = mesh.next(h);
    const int f = add_face(v, mesh.target(h), mesh.target(n), origin[h / 3]);
    move(n, 3 * f + 1);
    renamed(n, 3 * f + 1);
    mesh.corners[h / 3][(h % 3 + 1) % 3] = v;
    clear_marks(n);
    join(n, 3 * f + 2);
    return f;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_SPLIT_SURFACE_H
