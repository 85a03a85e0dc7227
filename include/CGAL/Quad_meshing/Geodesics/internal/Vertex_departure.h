// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_VERTEX_DEPARTURE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_VERTEX_DEPARTURE_H

#include <CGAL/Quad_meshing/Geodesics/internal/Face_crossing.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Wavefront.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Sends the front on from points: from vertices that it has reached, and from places on edges.
template <typename Front>
class Vertex_departure
{
public:
  typedef typename Front::FT FT;
  typedef Unfolded_mesh<FT> Mesh;
  typedef Window<FT> W;

  Vertex_departure(Front& front, Face_crossing<Front>& cross) : m_front(front), m_cross(cross), m_mesh(front.mesh()) {}

  // Goes on from a vertex: along its edges always, which lets no vertex unreached whatever rounding
  // does, and into its faces where paths may bend.
  void leave_vertex(int v)
  {
    const int first = m_mesh.halfedge_of_vertex[v];
    if(first == -1)
      return;
    const Vertex_label<FT> label = m_front.label(v);
    int h = first;
    do
    {
      m_front.reach(m_mesh.target(h), label.distance + m_mesh.length_of(h), v, label.error,
                    [&] { return angle_of_reverse(h); });
      const int p = Mesh::prev(h);
      if(m_mesh.opposite[p] == -1)
        m_front.reach(m_mesh.source(p), label.distance + m_mesh.length_of(p), v, label.error,
                      [&] { return m_mesh.direction[p]; });
      h = m_mesh.next_around_source(h);
    }
    while(h != -1 && h != first);

    for_each_range(v, [&](double from, double to) { leave_into_faces(v, from, to); });
  }

  // The part of it that goes into the face of h, whose source is the vertex.
  void leave_into_face(int h)
  {
    const int v = m_mesh.source(h);
    for_each_range(v, [&](double from, double to) { leave_into_corner(h, v, from, to); });
  }

  // Sends rays from the place t on halfedge h into the face of h.
  void leave_point(int h, const FT& t, const FT& sigma, int origin, float error)
  {
    FT x = t, y(0);
    for(int k = 0; k < 2; ++k)
    {
      to_next_frame(m_mesh, h, x, y);
      h = Mesh::next(h);
      const FT length = m_mesh.length_of(h);
      if(k == 0)
        m_front.reach(m_mesh.target(h), sigma + square_root((x - length) * (x - length) + y * y), origin, error,
                      [&]
                      {
                        return m_mesh.direction[Mesh::next(h)] + m_mesh.corner_angle(Mesh::next(h)) -
                               std::atan2(as_double(y), as_double(FT(length - x)));
                      });
      if(y > FT(0))
        m_cross.arrive(h, W{ FT(0), length, x, y, sigma, origin, false, true, true, error });
      else if(x > FT(0) && x < length && m_mesh.opposite[h] != -1)
        leave_point(m_mesh.opposite[h], FT(length - x), sigma, origin, error);
    }
  }

  // The direction of the way back along h at its target.
  double angle_of_reverse(int h) const
  {
    const int o = m_mesh.opposite[h];
    return o != -1 ? m_mesh.direction[o] : m_mesh.total_angle[m_mesh.target(h)];
  }

private:
  // The end of a range that contains all directions.
  static double everywhere() { return std::numeric_limits<double>::infinity(); }

  // Calls `leave` for the ranges of directions in which paths may go on from v.
  template <typename Leave>
  void for_each_range(int v, const Leave& leave) const
  {
    const Vertex_label<FT>& label = m_front.label(v);
    const double total = m_mesh.total_angle[v];
    if(label.origin < 0 || m_mesh.passage[v] == PASSAGE_EVERYWHERE)
      leave(0., everywhere());
    else if(m_mesh.passage[v] == PASSAGE_IN_SHADOW)
    {
      // Both angles between arrival and departure are at least pi.
      const double pi = std::acos(-1.), margin = Mesh::flat_angle_tolerance(), a = label.angle;
      if(m_mesh.opposite[m_mesh.halfedge_of_vertex[v]] == -1)
      {
        leave(a + pi - margin, total);
        leave(0., a - pi + margin);
      }
      else
      {
        leave(a + pi - margin, a + total - pi + margin);
        leave(a - total + pi - margin, a - pi + margin);
      }
    }
  }

  // Sends rays from v in the directions between the two angles.
  void leave_into_faces(int v, double from, double to)
  {
    if(!(from < to))
      return;
    const int first = m_mesh.halfedge_of_vertex[v];
    int h = first;
    do
    {
      leave_into_corner(h, v, from, to);
      h = m_mesh.next_around_source(h);
    }
    while(h != -1 && h != first);
  }

  // Those that go into the corner at v between h and the next halfedge around v.
  void leave_into_corner(int h, int v, double from, double to)
  {
    const bool whole = to == everywhere();
    const double begin = m_mesh.direction[h], end = whole ? 0. : end_of_corner(h, v);
    if(!whole && !(from < to && begin < to && from < end))
      return;
    const FT d = m_front.label(v).distance;
    const float error = m_front.label(v).error;
    const int n = Mesh::next(h);
    const typename Mesh::Apex& a = m_mesh.apex[n];
    const FT length = m_mesh.length_of(n);
    if(a.y == FT(0))
    {
      if(a.x > FT(0) && a.x < length && m_mesh.opposite[n] != -1)
        leave_point(m_mesh.opposite[n], FT(length - a.x), d, v, error);
      return;
    }
    const FT b0 = !whole && from > begin ? (std::max)(FT(0), hit(a, from - begin)) : FT(0);
    const FT b1 = !whole && to < end ? (std::min)(length, hit(a, to - begin)) : length;
    if(b0 < b1)
      m_cross.arrive(n, W{ b0, b1, a.x, a.y, d, v, false, true, true, error });
  }

  // The direction where the face of h ends at v.
  double end_of_corner(int h, int v) const
  {
    const int next = m_mesh.next_around_source(h);
    return next == -1 || next == m_mesh.halfedge_of_vertex[v] ? m_mesh.total_angle[v] : m_mesh.direction[next];
  }

  // Where the ray from the apex hits the halfedge; `angle` is measured from the way to its source.
  static FT hit(const typename Mesh::Apex& a, double angle)
  {
    const FT c = FT(std::cos(angle)), s = FT(std::sin(angle));
    return a.x + a.y * (a.y * s - a.x * c) / (a.x * s + a.y * c);
  }

  Front& m_front;
  Face_crossing<Front>& m_cross;
  const Mesh& m_mesh;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_VERTEX_DEPARTURE_H
