// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_SOURCE_DEPARTURE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_SOURCE_DEPARTURE_H

#include <CGAL/Quad_meshing/Geodesics/internal/Face_crossing.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_sources.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Vertex_departure.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Sends the front on from source elements.
template <typename Front>
class Source_departure
{
public:
  typedef typename Front::FT FT;
  typedef Unfolded_mesh<FT> Mesh;
  typedef Window<FT> W;
  typedef Window_tolerances<FT> Tol;
  typedef Field_sources<FT> Sources;
  typedef Source_element<FT> Element;
  typedef Surface_point<FT> Point;

  Source_departure(Front& front, Face_crossing<Front>& cross, Vertex_departure<Front>& departure)
    : m_front(front), m_cross(cross), m_departure(departure), m_mesh(front.mesh())
  {
  }

  // The i-th element.
  void operator()(const Sources& sources, int i)
  {
    const Element& e = sources.elements()[i];
    const int origin = ~i;
    if(!e.is_segment)
    {
      if(e.from.carrier == Point::VERTEX)
        m_front.reach(e.from.simplex, e.offset, origin, 0.f, [] { return 0.; });
      else if(e.from.carrier == Point::EDGE)
        leave_place(e.from.simplex, e.from.x, e.offset, origin);
      else
        leave_interior(3 * e.from.simplex, e.from.x, e.from.y, e.offset, origin);
    }
    else if(e.halfedge != -1)
    {
      const FT s = Sources::place_on(m_mesh, e.halfedge, e.from), t = Sources::place_on(m_mesh, e.halfedge, e.to);
      leave_edge(e.halfedge, (std::min)(s, t), (std::max)(s, t), e.offset, origin);
    }
    else
    {
      const auto a = place_in_face(m_mesh, e.face, e.from), b = place_in_face(m_mesh, e.face, e.to);
      leave_segment(3 * e.face, a.first, a.second, b.first, b.second, e.offset, origin);
    }
  }

private:
  // Sends rays in all directions from the place t on halfedge h.
  void leave_place(int h, const FT& t, const FT& offset, int origin)
  {
    const FT length = m_mesh.length_of(h);
    m_front.reach(m_mesh.source(h), offset + t, origin, 0.f, [&] { return m_mesh.direction[h]; });
    m_front.reach(m_mesh.target(h), offset + (length - t), origin, 0.f,
                  [&] { return m_departure.angle_of_reverse(h); });
    m_front.store(h, W{ FT(0), length, t, FT(0), offset, origin, false, true, false, 0.f });
    m_departure.leave_point(h, t, offset, origin, 0.f);
    if(m_mesh.opposite[h] != -1)
      m_departure.leave_point(m_mesh.opposite[h], FT(length - t), offset, origin, 0.f);
  }

  // Sends rays in all directions from the point (x, y) in the interior of the face of h.
  void leave_interior(int h, FT x, FT y, const FT& offset, int origin)
  {
    for(int k = 0; k < 3; ++k)
    {
      m_front.reach(m_mesh.source(h), offset + square_root(x * x + y * y), origin, 0.f,
                    [&] { return m_mesh.direction[h] + std::atan2(as_double(y), as_double(x)); });
      m_cross.arrive(h, W{ FT(0), m_mesh.length_of(h), x, y, offset, origin, false, true, true, 0.f });
      to_next_frame(m_mesh, h, x, y);
      h = Mesh::next(h);
    }
  }

  // Sends a straight front to both sides from the part [t0, t1] of halfedge h.
  void leave_edge(int h, const FT& t0, const FT& t1, const FT& offset, int origin)
  {
    W w{ t0, t1, FT(0), FT(1), offset, origin, true, true, false, 0.f };
    m_front.store(h, w);
    m_cross(h, std::vector<W>(1, w));
    if(m_mesh.opposite[h] != -1)
    {
      w.reverse(m_mesh.length_of(h));
      m_cross(m_mesh.opposite[h], std::vector<W>(1, w));
    }
  }

  // Sends a straight front to both sides from the segment from (ax, ay) to (bx, by) in the face of h.
  void leave_segment(int h, FT ax, FT ay, FT bx, FT by, const FT& offset, int origin)
  {
    for(int k = 0; k < 3; ++k)
    {
      const FT length = m_mesh.length_of(h);
      const FT vx = bx - ax, vy = by - ay, norm = square_root(vx * vx + vy * vy);
      const FT ux = vx / norm, uy = vy / norm;
      for(int side = 0; side < 2; ++side)
      {
        const FT nx = side == 0 ? FT(-uy) : uy, ny = side == 0 ? ux : FT(-ux);
        const FT na = nx * ax + ny * ay, ua = ux * ax + uy * ay;
        // the corner at the origin of the frame
        if(-ua >= FT(0) && -ua <= norm && -na >= FT(0))
          m_front.reach(m_mesh.source(h), offset - na, origin, 0.f,
                        [&] { return m_mesh.direction[h] + std::atan2(as_double(FT(-ny)), as_double(FT(-nx))); });
        if(!(ny < FT(0)))
          continue;
        const FT slack = FT(Tol::place()) * length;
        FT t0(0), t1 = length;
        if(clip(ux, FT(-ua), FT(0), t0, t1) && clip(FT(-ux), FT(norm + ua), FT(0), t0, t1) &&
           clip(nx, FT(-na), slack, t0, t1))
          m_cross.arrive(h, W{ t0, t1, nx, FT(-ny), FT(offset - na), origin, true, true, true, 0.f });
      }
      to_next_frame(m_mesh, h, ax, ay);
      to_next_frame(m_mesh, h, bx, by);
      h = Mesh::next(h);
    }
  }

  // Restricts [t0, t1] to where a t + b >= -slack. Returns false if nothing is left.
  static bool clip(const FT& a, const FT& b, const FT& slack, FT& t0, FT& t1)
  {
    if(a == FT(0))
      return b >= -slack;
    const FT t = -(b + slack) / a;
    if(a > FT(0))
    {
      if(t0 < t)
        t0 = t;
    }
    else if(t < t1)
      t1 = t;
    return t0 < t1;
  }

  Front& m_front;
  Face_crossing<Front>& m_cross;
  Vertex_departure<Front>& m_departure;
  const Mesh& m_mesh;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_SOURCE_DEPARTURE_H
