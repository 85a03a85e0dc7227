// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_EDITABLE_TRIANGLES_H
#define CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_EDITABLE_TRIANGLES_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A triangle mesh in flat arrays whose edges can be collapsed, flipped and split.
//
// Halfedge 3 f + k runs from corner k of face f to the next corner; there are no border halfedges. Removed faces and
// vertices keep their numbers until the end.
class Editable_triangles
{
public:
  typedef Indexed_triangle_mesh::Point_3 Point_3;
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  std::vector<Point_3> points;             // per vertex
  std::vector<std::array<int, 3>> corners; // per face; the first is -1 if the face was removed
  std::vector<int> opposite;               // per halfedge, -1 on the border
  std::vector<int> out;                    // per vertex: a halfedge that leaves it, -1 if there is none
  // Per halfedge, the same on both sides: on a curve (a feature or a border) how far the curve of the input is from the
  // edge at most; less than 0 elsewhere.
  std::vector<double> curve_error;

  // Curves have an error of 0.
  Editable_triangles(const Indexed_triangle_mesh& m, const std::vector<char>& edge_is_on_curve)
    : points(m.points)
    , corners(m.corners)
    , opposite(m.opposite)
    , out(m.halfedge_of_vertex)
    , curve_error(m.number_of_halfedges())
  {
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      curve_error[h] = edge_is_on_curve[m.edge_of[h]] || opposite[h] == -1 ? 0. : -1.;
  }

  int number_of_vertices() const { return static_cast<int>(points.size()); }
  int number_of_faces() const { return static_cast<int>(corners.size()); }
  int number_of_halfedges() const { return static_cast<int>(opposite.size()); }

  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int prev(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

  bool is_removed(int f) const { return corners[f][0] == -1; }
  int source(int h) const { return corners[h / 3][h % 3]; }
  int target(int h) const { return corners[h / 3][next(h) % 3]; }
  int apex(int h) const { return corners[h / 3][prev(h) % 3]; }
  bool is_on_curve(int h) const { return curve_error[h] >= 0; }
  Vector_3 vector(int h) const { return points[target(h)] - points[source(h)]; }
  double length(int h) const { return std::sqrt(vector(h).squared_length()); }

  // Twice the area, along the normal.
  Vector_3 area_vector(int f) const
  {
    const std::array<int, 3>& c = corners[f];
    return cross_product(points[c[1]] - points[c[0]], points[c[2]] - points[c[0]]);
  }

  // The halfedges that leave a vertex, one per face around it, counterclockwise; at the border from its clockwise end.
  void leaving(int v, std::vector<int>& halfedges) const
  {
    halfedges.clear();
    int first = out[v];
    if(first == -1)
      return;
    for(int h = first; opposite[h] != -1;)
    {
      h = next(opposite[h]);
      if(h == out[v])
        break;
      first = h;
    }
    if(opposite[first] != -1)
      first = out[v];
    int h = first;
    do
    {
      halfedges.push_back(h);
      h = opposite[prev(h)];
    }
    while(h != -1 && h != first);
  }

  int other_end(int h, int v) const { return source(h) == v ? target(h) : source(h); }

  // The edges of curves at a vertex, each by a halfedge of it.
  void curves_at(int v, std::vector<int>& curves)
  {
    leaving(v, m_leaving);
    curves.clear();
    for(int h : m_leaving)
      if(is_on_curve(h))
        curves.push_back(h);
    if(const int last = prev(m_leaving.back()); opposite[last] == -1)
      curves.push_back(last);
  }

  // Moves v, one end of the edge of a halfedge, into the other end; removes the faces on both sides. The caller has
  // checked that the surface stays one.
  void collapse(int h, int v)
  {
    const int w = source(h) == v ? target(h) : source(h), o = opposite[h];
    leaving(v, m_leaving);
    for(int g : m_leaving)
      corners[g / 3][g % 3] = w;
    close(h);
    if(o != -1)
      close(o);
    out[v] = -1;
  }

  // Puts the other diagonal into the two faces of an inner edge.
  void flip(int h)
  {
    const int o = opposite[h], f = h / 3, g = o / 3;
    const int a = source(h), b = target(h), c = apex(h), d = apex(o);
    // The sides of the two faces from a counterclockwise around: a-d, d-b, b-c, c-a.
    const int old_side[4] = { next(o), prev(o), next(h), prev(h) };
    int across[4];
    double error[4];
    for(int i = 0; i < 4; ++i)
    {
      across[i] = opposite[old_side[i]];
      error[i] = curve_error[old_side[i]];
    }
    corners[f] = { { a, d, c } };
    corners[g] = { { d, b, c } };
    join(3 * f + 1, 3 * g + 2, -1);
    const int new_side[4] = { 3 * f, 3 * g, 3 * g + 1, 3 * f + 2 };
    for(int i = 0; i < 4; ++i)
      join(new_side[i], across[i], error[i]);
    out[a] = 3 * f;
    out[d] = 3 * g;
    out[b] = 3 * g + 1;
    out[c] = 3 * f + 2;
  }

  // Puts a vertex onto an edge and joins it to the corners opposite to the edge; returns the vertex.
  int split(int h, const Point_3& p)
  {
    const int o = opposite[h], m = number_of_vertices(), a = source(h), b = target(h);
    const double error = curve_error[h];
    points.push_back(p);
    out.push_back(-1);
    // The half of h at its source stays h; likewise for o. `second` are the other halves.
    int second[2] = { -1, -1 };
    const int side[2] = { h, o };
    for(int i = 0; i < 2; ++i)
    {
      if(side[i] == -1)
        continue;
      const int s = side[i], f = s / 3, t = target(s), c = apex(s), n = number_of_faces();
      const int across = opposite[next(s)];
      const double side_error = curve_error[next(s)];
      corners[f][next(s) % 3] = m;
      corners.push_back({ { m, t, c } });
      opposite.resize(3 * corners.size());
      curve_error.resize(3 * corners.size());
      join(3 * n + 1, across, side_error);
      join(next(s), 3 * n + 2, -1);
      second[i] = 3 * n;
      out[m] = 3 * n;
      out[t] = 3 * n + 1;
      out[c] = 3 * n + 2;
    }
    join(h, second[1], error);
    join(second[0], o, error);
    out[a] = h;
    if(o != -1)
      out[b] = o;
    return m;
  }

private:
  // Makes two halfedges the sides of one edge; one may be -1.
  void join(int h, int o, double error)
  {
    if(h != -1)
    {
      opposite[h] = o;
      curve_error[h] = error;
    }
    if(o != -1)
    {
      opposite[o] = h;
      curve_error[o] = error;
    }
  }

  // Removes a face of which side h has become a point, and joins what lies behind its two other sides.
  void close(int h)
  {
    const int w = target(h), c = apex(h);
    const int p = opposite[next(h)], q = opposite[prev(h)]; // c to w, and w to c
    const double error = (std::max)(curve_error[next(h)], curve_error[prev(h)]);
    join(p, q, error);
    out[w] = q != -1 ? q : next(p);
    out[c] = p != -1 ? p : next(q);
    corners[h / 3][0] = -1;
  }

  std::vector<int> m_leaving;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_WORKING_MESH_INTERNAL_EDITABLE_TRIANGLES_H
