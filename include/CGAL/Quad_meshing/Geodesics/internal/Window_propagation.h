// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_PROPAGATION_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_PROPAGATION_H

#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_result.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Face_crossing.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Vertex_departure.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Wavefront.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_merging.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Propagates windows over an unfolded mesh (Mitchell, Mount and Papadimitriou 1987; Surazhsky et al.
// 2005; linear windows: Bommes and Kobbelt 2007).
//
// The front advances in steps of about one edge length. Within a step all windows of one edge that
// have come due cross their face together, so that the queue holds edges instead of windows and
// windows may be cut or joined where they lie as long as they wait. The order does not matter for
// the result.
template <typename FT>
class Window_propagation
{
public:
  typedef Unfolded_mesh<FT> Mesh;
  typedef Window<FT> W;
  typedef Window_tolerances<FT> Tol;
  typedef Window_list<FT> List;

  static FT unreached() { return Wavefront<FT>::unreached(); }

  // `allowed_error`: the relative error that merging windows may cause, 0 for the exact field.
  // `keep_windows`: whether the windows of an edge stay when the front has passed it.
  explicit Window_propagation(const Mesh& mesh, double allowed_error = 0, bool keep_windows = true)
    : m_mesh(mesh),
      m_allowed_error(allowed_error),
      m_front(mesh, keep_windows),
      m_cross(m_front),
      m_departure(m_front, m_cross)
  {}

  const List& windows(int edge) const { return m_front.lists()[edge]; }
  const Vertex_label<FT>& label(int v) const { return m_front.label(v); }
  bool is_reached(int v) const { return label(v).distance < unreached(); }

  std::size_t number_of_passed_vertices() const { return m_passed; }

  // Counts what there is.
  void count(Geodesic_distance_result& result) const
  {
    result.number_of_unreached_vertices = 0;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      if(is_reached(v))
        result.maximum_distance = (std::max)(result.maximum_distance, as_double(label(v).distance));
      else
        ++result.number_of_unreached_vertices;
    }
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      result.number_of_windows += windows(e).size;
    result.number_of_propagations = m_propagations;
  }

  // Starts rays in all directions from a vertex.
  void start_at_vertex(int v, const FT& offset, int origin) { m_front.reach(v, offset, origin, 0.f, [] { return 0.; }); }

  // Starts rays in all directions from the place t on halfedge h.
  void start_on_halfedge(int h, const FT& t, const FT& offset, int origin)
  {
    const FT length = m_mesh.length_of(h);
    m_front.reach(m_mesh.source(h), offset + t, origin, 0.f, [&] { return m_mesh.direction[h]; });
    m_front.reach(m_mesh.target(h), offset + (length - t), origin, 0.f, [&] { return m_departure.angle_of_reverse(h); });
    m_front.store(h, W{ FT(0), length, t, FT(0), offset, origin, false, true, false, 0.f });
    m_departure.leave_point(h, t, offset, origin, 0.f);
    if(m_mesh.opposite[h] != -1)
      m_departure.leave_point(m_mesh.opposite[h], FT(length - t), offset, origin, 0.f);
  }

  // Starts rays in all directions from the point (x, y) in the interior of the face of h.
  void start_in_face(int h, FT x, FT y, const FT& offset, int origin)
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

  // Starts a straight front to both sides from the part [t0, t1] of halfedge h.
  void start_along_halfedge(int h, const FT& t0, const FT& t1, const FT& offset, int origin)
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

  // Starts a straight front to both sides from the segment from (ax, ay) to (bx, by) in the face of h.
  void start_along_segment(int h, FT ax, FT ay, FT bx, FT by, const FT& offset, int origin)
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
        if(! (ny < FT(0)))
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

  // Lets the front advance until nothing is left to do or `go_on(front)` says no, which is asked
  // before every step with a distance that everything still to come exceeds. Returns that distance.
  template <typename GoOn>
  double run(GoOn go_on)
  {
    Front_queue& queue = m_front.queue();
    while(queue.advance())
    {
      if(! go_on(queue.front()))
        return queue.front();
      while(queue.step_has_more())
      {
        int e, v;
        while((e = queue.pop_edge()) != -1)
        {
          prefetch(queue.edge_ahead(2), queue.edge_ahead(0));
          propagate_edge(e);
        }
        if((v = queue.pop_vertex()) != -1)
        {
          m_passed += ! label(v).is_passed;
          m_front.label(v).is_passed = true;
          m_departure.leave_vertex(v);
        }
      }
    }
    return std::numeric_limits<double>::infinity();
  }

private:
  // Restricts [t0, t1] to where a t + b >= -slack. Returns false if nothing is left.
  static bool clip(const FT& a, const FT& b, const FT& slack, FT& t0, FT& t1)
  {
    if(a == FT(0))
      return b >= -slack;
    const FT t = -(b + slack) / a;
    if(a > FT(0)) { if(t0 < t) t0 = t; }
    else if(t < t1) t1 = t;
    return t0 < t1;
  }

  // Fetches what the next edges need into the cache: of the first edge where its windows are, of the second one, for
  // which that is known already, the windows and the face before them.
  void prefetch(int edge, int sooner) const
  {
#ifdef __GNUC__
    if(edge != -1)
    {
      __builtin_prefetch(&m_front.lists()[edge]);
      __builtin_prefetch(&m_mesh.halfedge_of_edge[edge]);
      __builtin_prefetch(&m_mesh.length[edge]);
    }
    if(sooner != -1)
    {
      const List& list = m_front.lists()[sooner];
      const int h = m_mesh.halfedge_of_edge[sooner];
      for(int k = 0; k < list.size && k < 4; ++k)
        __builtin_prefetch(list.first + k);
      __builtin_prefetch(&m_mesh.apex[h]);
      __builtin_prefetch(&m_mesh.opposite[h]);
      __builtin_prefetch(&m_mesh.edge_of[h]);
      __builtin_prefetch(&m_mesh.corners[m_mesh.face(h)]);
    }
#else
    (void)edge;
    (void)sooner;
#endif
  }

  // Takes all windows of an edge that have come due through the faces before them.
  void propagate_edge(int e)
  {
    collect_due_windows(e);
    m_propagations += m_to_left.size() + m_to_right.size();
    const int c = m_mesh.halfedge_of_edge[e], o = m_mesh.opposite[c];
    m_cross(c, m_to_left);
    if(o != -1)
    {
      std::reverse(m_to_right.begin(), m_to_right.end());
      for(W& w : m_to_right)
        w.reverse(m_mesh.length[e]);
      m_cross(o, m_to_right);
    }
  }

  // Copies the windows of an edge that have come due, and sees to it that the others wait.
  void collect_due_windows(int e)
  {
    Front_queue& queue = m_front.queue();
    List& list = m_front.lists()[e];
    if(m_allowed_error > 0)
      merge_pending(list);
    m_to_left.clear();
    m_to_right.clear();
    double later = std::numeric_limits<double>::infinity();
    for(W& w : list)
      if(w.pending)
      {
        const double key = Wavefront<FT>::key(w.minimum());
        if(queue.is_now(key))
        {
          w.pending = false;
          (w.from_left ? m_to_right : m_to_left).push_back(w);
        }
        else
          later = (std::min)(later, key);
      }
    if(later < std::numeric_limits<double>::infinity())
      queue.push_edge(e, later);
    else if(m_front.keeps_windows())
      m_front.lists().shrink(list);
    else
    {
      const double latest = m_front.latest(e);
      if(queue.front() >= latest)
        m_front.lists().clear(list);
      else
        queue.push_edge(e, latest < as_double(unreached()) / 4 ? (std::max)(latest + queue.step(), queue.next_key()) : queue.next_key());
    }
  }

  void merge_pending(List& list)
  {
    int n = 0;
    W merged;
    for(const W& w : list)
    {
      if(n > 0 && list[n - 1].pending && w.pending && merge_windows(list[n - 1], w, m_allowed_error, merged))
        list[n - 1] = merged;
      else
        list[n++] = w;
    }
    m_front.lists().splice(list, n, list.size - n, 0);
  }

  const Mesh& m_mesh;
  double m_allowed_error;
  Wavefront<FT> m_front;
  Face_crossing<FT> m_cross;
  Vertex_departure<FT> m_departure;
  std::vector<W> m_to_left, m_to_right;        // the windows that cross now, by the face that they cross
  std::size_t m_propagations = 0, m_passed = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_PROPAGATION_H
