// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FACE_CROSSING_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FACE_CROSSING_H

#include <CGAL/Quad_meshing/Geodesics/internal/Wavefront.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Takes windows from one edge of a face to the two others. What depends on the face alone is made once for all
// windows of the edge, and on both edges they arrive in their order.
template <typename FT>
class Face_crossing
{
public:
  typedef Unfolded_mesh<FT> Mesh;
  typedef Window<FT> W;
  typedef Window_tolerances<FT> Tol;

  explicit Face_crossing(Wavefront<FT>& front) : m_front(front) {}

  // The windows lie on halfedge h, which runs from p to q in the face (p, q, r), in the frame of h and sorted along
  // it, and their sources on the other side.
  void operator()(int h, const std::vector<W>& windows)
  {
    if(windows.empty())
      return;
    const Mesh& mesh = m_front.mesh();
    const typename Mesh::Apex& apex = mesh.apex[h];
    const FT l = mesh.length_of(h), place = FT(Tol::place()) * l, rx = apex.x, ry = apex.y, back = apex.back;
    const int right = Mesh::next(h), left = Mesh::prev(h), n = static_cast<int>(windows.size());

    // where the rays to r cross h
    if(m_rays_to_apex.size() < windows.size())
      m_rays_to_apex.resize(2 * windows.size());
    for(int k = 0; k < n; ++k)
    {
      const W& w = windows[k];
      const FT t = w.linear ? FT(rx - ry * w.x / w.y) : FT(w.x + (rx - w.x) * w.y / (ry + w.y));
      m_rays_to_apex[k] = t;
      if((t >= w.b0 || w.closes_gap(w.b0 - t, w.b0, l)) && (t <= w.b1 || w.closes_gap(t - w.b1, w.b1, l)))
        reach_apex(h, w);
    }

    if(mesh.length_of(right) > FT(0))
    {
      Exit exit(m_front, right, back, ry);
      const FT& width = exit.landing.length;
      // the ray through a place b of h meets qr at this part of the way from q
      const auto part = [&](const W& w, const FT& b) { return w.y * (l - b) / ((w.linear ? w.x : FT(b - w.x)) * ry - w.y * back); };
      for(int i = 0; i < n; ++i)
      {
        const int k = exit.landing.is_canonical ? n - 1 - i : i;
        const W& w = windows[k];
        const FT& t = m_rays_to_apex[k];
        if(! (t < w.b1 - place))
          continue;
        const FT begin = width * part(w, w.b1), end = t > w.b0 - place ? width : FT(width * part(w, w.b0));
        exit.arrive(m_front, w, begin, end, w.linear ? l : FT(w.x - l), w.linear ? FT(0) : w.y);
      }
    }
    if(mesh.length_of(left) > FT(0))
    {
      Exit exit(m_front, left, FT(-rx), FT(-ry));
      const FT& width = exit.landing.length;
      // the ray through a place b of h meets rp at this part of the way from p
      const auto part = [&](const W& w, const FT& b) { return w.y * b / (w.y * rx - (w.linear ? w.x : FT(b - w.x)) * ry); };
      for(int i = 0; i < n; ++i)
      {
        const int k = exit.landing.is_canonical ? n - 1 - i : i;
        const W& w = windows[k];
        const FT& t = m_rays_to_apex[k];
        if(! (t > w.b0 + place))
          continue;
        const FT begin = t < w.b1 + place ? FT(0) : FT(width * (FT(1) - part(w, w.b1))), end = width * (FT(1) - part(w, w.b0));
        exit.arrive(m_front, w, begin, end, w.linear ? rx : FT(w.x - rx), w.linear ? ry : FT(w.y + ry));
      }
    }
  }

private:
  // One of the two other edges.
  struct Exit
  {
    typename Wavefront<FT>::Landing landing;
    FT ux, uy;         // its direction in the frame of h

    Exit(const Wavefront<FT>& front, int h, const FT& vx, const FT& vy)
      : landing(front.landing(h))
    {
      const FT inverse = FT(1) / landing.length;
      ux = vx * inverse;
      uy = vy * inverse;
    }

    // From `w` on h comes the window [b0, b1] of this edge. With the origin o of its frame, (dx, dy) is o itself for a
    // linear window; for a circular one dx is the x-coordinate of the source minus that of o, -dy the same for y.
    BOOST_FORCEINLINE void arrive(Wavefront<FT>& front, const W& w, const FT& b0, const FT& b1, const FT& dx, const FT& dy)
    {
      if(w.linear)
        front.arrive(landing, W{ b0, b1, FT(w.x * ux + w.y * uy), FT(w.x * uy - w.y * ux),
                                 FT(w.sigma + w.x * dx + w.y * dy), w.origin, true, true, true, w.error });
      else
        front.arrive(landing, W{ b0, b1, FT(dx * ux - dy * uy), FT(-dx * uy - dy * ux),
                                 w.sigma, w.origin, false, true, true, w.error });
    }
  };

  void reach_apex(int h, const W& w)
  {
    const Mesh& mesh = m_front.mesh();
    const int left = Mesh::prev(h);
    const FT &rx = mesh.apex[h].x, &ry = mesh.apex[h].y;
    const FT bx = w.linear ? w.x : FT(rx - w.x), by = w.linear ? w.y : FT(ry + w.y);
    const FT d = w.linear ? FT(w.sigma + rx * bx + ry * by) : FT(w.sigma + square_root(bx * bx + by * by));
    // the angle from the way to p, (-rx, -ry), to the way back, (-bx, -by)
    m_front.reach(mesh.source(left), d, w.origin, w.error, [&]
    {
      return mesh.direction[left] + std::atan2(as_double(FT(rx * by - ry * bx)), as_double(FT(rx * bx + ry * by)));
    });
  }

  Wavefront<FT>& m_front;
  std::vector<FT> m_rays_to_apex;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FACE_CROSSING_H
