// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_QUERIES_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_QUERIES_H

#include <CGAL/Quad_meshing/Geodesics/internal/Field_sources.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_propagation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// How a point of a face is reached: the last straight piece of a shortest path to it, backwards.
template <typename FT>
struct Arrival
{
  enum Kind
  {
    NOWHERE,
    FROM_VERTEX,
    THROUGH_EDGE,
    FROM_ELEMENT
  } kind;
  FT distance;
  int simplex; // vertex, halfedge of the face, or element
  FT x, y;     // where the piece begins, in the frame of the first halfedge of the face
  FT place;    // on the halfedge, if THROUGH_EDGE
  int origin;  // see Window::origin
};

// Evaluates a finished propagation anywhere. The distance in a face is the minimum over the windows
// on its three edges whose source lies beyond the edge, over its corners, and over the source
// elements in it. Every candidate is the length of a path, so no other one can lead too low.
template <typename FT>
class Field_queries
{
public:
  typedef Unfolded_mesh<FT> Mesh;
  typedef Window_propagation<FT> Propagation;
  typedef Field_sources<FT> Sources;
  typedef Surface_point<FT> Point;
  typedef Arrival<FT> A;

  // A step of a path: a point, in a face that contains it.
  struct Step
  {
    int face;
    FT x, y;
  };

  Field_queries(const Mesh& mesh, const Propagation& propagation, const Sources& sources)
    : m_mesh(mesh), m_propagation(propagation), m_sources(sources)
  {
  }

  // How the point (x, y) of a face is reached, not counting corner `no_corner` and windows on halfedge
  // `no_halfedge` of the face (the way by which one came).
  A arrival(int face, const FT& x, const FT& y, int no_corner = -1, int no_halfedge = -1) const
  {
    A best{ A::NOWHERE, Propagation::unreached(), -1, x, y, FT(0), 0 };
    for(int k = 0; k < 3; ++k)
    {
      const int v = m_mesh.corners[face][k];
      if(k == no_corner || !m_propagation.is_reached(v))
        continue;
      const auto c = corner_place(m_mesh, face, k);
      const FT d = m_propagation.label(v).distance + norm(FT(x - c.first), FT(y - c.second));
      if(d < best.distance)
        best = A{ A::FROM_VERTEX, d, v, c.first, c.second, FT(0), v };
    }
    for(int k = 0; k < 3; ++k)
      if(3 * face + k != no_halfedge && (no_corner == -1 || k == (no_corner + 1) % 3))
        try_windows(3 * face + k, x, y, best);
    const auto range = m_sources.elements_in_face(face);
    for(auto it = range.first; it != range.second; ++it)
      try_element(face, it->second, x, y, best);
    return best;
  }

  // How a vertex is reached; `face` is set to a face in which the last piece lies. If `from_origin`, only from the
  // pseudo-source of its label.
  A arrival_at_vertex(int v, int& face, bool from_origin = false) const
  {
    A best{ A::NOWHERE, Propagation::unreached(), -1, FT(0), FT(0), FT(0), 0 };
    std::vector<int> fan;
    faces_of_point(m_mesh, Point{ Point::VERTEX, v, FT(0), FT(0) }, fan);
    for(int f : fan)
    {
      const int k = m_mesh.corners[f][0] == v ? 0 : m_mesh.corners[f][1] == v ? 1 : 2;
      const auto c = corner_place(m_mesh, f, k);
      A a{ A::NOWHERE, Propagation::unreached(), -1, c.first, c.second, FT(0), 0 };
      if(!from_origin)
        a = arrival(f, c.first, c.second, k);
      else
        try_windows(3 * f + (k + 1) % 3, c.first, c.second, a, false, m_propagation.label(v).origin);
      if(a.kind != A::NOWHERE && a.distance < best.distance)
      {
        best = a;
        face = f;
      }
    }
    return best;
  }

  // The source element from which a pseudo-source is reached.
  int element_of_origin(int origin) const
  {
    for(int i = 0; origin >= 0 && i <= m_mesh.number_of_vertices(); ++i)
      origin = m_propagation.label(origin).origin;
    return ~origin;
  }

  // Follows a shortest path from a point back to its source. Returns the element where it ends, or
  // -1 if the point is not reached. The first step is the point itself.
  int trace(int face, FT x, FT y, std::vector<Step>& path) const
  {
    path.push_back(Step{ face, x, y });
    int vertex = -1, from = -1;
    for(int k = 0; k < 3; ++k)
    {
      const auto c = corner_place(m_mesh, face, k);
      if(c.first == x && c.second == y)
        vertex = m_mesh.corners[face][k];
    }
    // a shortest path meets no face twice in more than a point
    for(int i = 0; i <= 2 * m_mesh.number_of_faces() + 2; ++i)
    {
      if(vertex != -1 && m_propagation.label(vertex).origin < 0 && is_source(vertex))
        return ~m_propagation.label(vertex).origin;
      const A a = vertex != -1 ? arrival_at_vertex(vertex, face) : arrival(face, x, y, -1, from);
      if(a.kind == A::NOWHERE)
        return -1;
      path.push_back(Step{ face, a.x, a.y });
      if(a.kind == A::FROM_ELEMENT)
        return a.simplex;
      vertex = a.kind == A::FROM_VERTEX ? a.simplex : -1;
      if(a.kind != A::THROUGH_EDGE)
        continue;

      const int h = a.simplex;
      const FT length = m_mesh.length_of(h), slack = FT(Window_tolerances<FT>::place()) * length;
      if(a.place <= slack)
        vertex = m_mesh.source(h);
      else if(length - a.place <= slack)
        vertex = m_mesh.target(h);
      else
      {
        from = m_mesh.opposite[h];
        face = m_mesh.face(from);
        const auto p = place_in_face(m_mesh, face, Point{ Point::EDGE, h, a.place, FT(0) });
        x = p.first;
        y = p.second;
      }
    }
    return -1;
  }

  // The unit vector in space of a direction in a face, zero if it has none.
  Indexed_triangle_mesh::Vector_3 direction(int face, const FT& dx, const FT& dy) const
  {
    typedef Indexed_triangle_mesh::Vector_3 Vector_3;
    const double x = as_double(dx), y = as_double(dy), n = std::sqrt(x * x + y * y);
    if(n == 0 || m_mesh.length_of(3 * face) == FT(0))
      return Vector_3(0, 0, 0);
    const Vector_3 u = m_mesh.vector(3 * face) / as_double(m_mesh.length_of(3 * face));
    Vector_3 w = -m_mesh.vector(3 * face + 2);
    w = w - (w * u) * u;
    const double l = std::sqrt(w * w);
    return l == 0 ? Vector_3(0, 0, 0) : Vector_3(x / n * u + y / n * (w / l));
  }

  std::array<double, 3> barycentric(int face, const FT& x, const FT& y) const
  {
    const double l = as_double(m_mesh.length_of(3 * face)), rx = as_double(m_mesh.apex[3 * face].x),
                 ry = as_double(m_mesh.apex[3 * face].y), px = as_double(x), py = as_double(y);
    double w2 = ry > 0 ? py / ry : (px > l && rx > l) ? (px - l) / (rx - l) : (px < 0 && rx < 0) ? px / rx : 0;
    w2 = (std::min)((std::max)(w2, 0.), 1.);
    double w1 = l > 0 ? (px - w2 * rx) / l : 0;
    w1 = (std::min)((std::max)(w1, 0.), 1 - w2);
    return { { (std::max)(0., 1 - w1 - w2), w1, w2 } };
  }

private:
  static FT norm(const FT& x, const FT& y) { return square_root(x * x + y * y); }

  bool is_source(int v) const
  {
    const Source_element<FT>& e = m_sources.elements()[~m_propagation.label(v).origin];
    return !e.is_segment && e.from.carrier == Point::VERTEX && e.from.simplex == v;
  }

  // Compares the windows on a halfedge with the best way so far, all of them or those from one pseudo-source.
  void try_windows(int h, const FT& x0, const FT& y0, A& best, bool all = true, int origin = 0) const
  {
    const FT length = m_mesh.length_of(h);
    if(length == FT(0) || m_mesh.opposite[h] == -1)
      return;
    // into the frame of h
    const int face = m_mesh.face(h);
    const auto p = corner_place(m_mesh, face, h % 3), q = corner_place(m_mesh, face, (h + 1) % 3);
    const FT ux = (q.first - p.first) / length, uy = (q.second - p.second) / length;
    const FT dx = x0 - p.first, dy = y0 - p.second;
    const FT x = dx * ux + dy * uy;
    FT y = dy * ux - dx * uy;
    if(y < FT(0))
      y = FT(0);

    const bool canonical = m_mesh.is_canonical(h);
    for(const Window<FT>& window : m_propagation.windows(m_mesh.edge_of[h]))
    {
      if(window.from_left == canonical || (!all && window.origin != origin))
        continue;
      Window<FT> w = window;
      if(!canonical)
        w.reverse(length);
      // where the straight way to the source leaves, or the nearest place of the window
      FT t = x;
      if(w.linear)
        t = w.y > FT(0) ? FT(x - y * w.x / w.y) : w.b0;
      else if(y + w.y > FT(0))
        t = w.x + (x - w.x) * w.y / (y + w.y);
      if(t < w.b0)
        t = w.b0;
      if(w.b1 < t)
        t = w.b1;
      const FT d = w.distance(t) + norm(FT(x - t), y);
      if(d < best.distance)
        best = A{ A::THROUGH_EDGE, d, h, FT(p.first + t * ux), FT(p.second + t * uy), t, w.origin };
    }
  }

  void try_element(int face, int i, const FT& x, const FT& y, A& best) const
  {
    const Source_element<FT>& e = m_sources.elements()[i];
    auto foot = place_in_face(m_mesh, face, e.from);
    if(e.is_segment)
    {
      const auto to = place_in_face(m_mesh, face, e.to);
      const FT vx = to.first - foot.first, vy = to.second - foot.second;
      FT s = ((x - foot.first) * vx + (y - foot.second) * vy) / (vx * vx + vy * vy);
      if(s < FT(0))
        s = FT(0);
      if(FT(1) < s)
        s = FT(1);
      foot.first = foot.first + s * vx;
      foot.second = foot.second + s * vy;
    }
    const FT d = e.offset + norm(FT(x - foot.first), FT(y - foot.second));
    if(d < best.distance)
      best = A{ A::FROM_ELEMENT, d, i, foot.first, foot.second, FT(0), ~i };
  }

  const Mesh& m_mesh;
  const Propagation& m_propagation;
  const Sources& m_sources;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_QUERIES_H
