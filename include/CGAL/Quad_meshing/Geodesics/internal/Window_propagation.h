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
#include <CGAL/Quad_meshing/Geodesics/internal/Field_sources.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Open_windows.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Source_departure.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Vertex_departure.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Wavefront.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_merging.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
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
  typedef Field_sources<FT> Sources;

  static FT unreached() { return Wavefront<FT>::unreached(); }

  // `allowed_error`: the relative error that merging windows may cause, 0 for the exact field.
  // `keep_windows`: whether the windows of an edge stay when the front has passed it.
  // The sources must stay as they are.
  Window_propagation(const Mesh& mesh, const Sources& sources, double allowed_error, bool keep_windows)
    : m_mesh(mesh)
    , m_allowed_error(allowed_error)
    , m_front(mesh, keep_windows, faces_of_group(sources, allowed_error))
    , m_cross(m_front)
    , m_departure(m_front, m_cross)
  {
    Source_departure<Wavefront<FT>> start(m_front, m_cross, m_departure);
    for(int i = 0; i < static_cast<int>(sources.elements().size()); ++i)
      start(sources, i);
    if(keep_windows)
      m_open_windows.reset(new Open_windows<FT>(m_front, sources, allowed_error));
  }

  // The windows of an edge after the propagation, if they are kept.
  List windows(int edge) const { return is_open(edge) ? (*m_open_windows)(edge) : m_front.lists()[edge]; }
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
    result.number_of_windows = m_front.lists().size();
    result.number_of_propagations = m_propagations;
  }

  // The number of windows on all edges, if they are kept.
  std::size_t number_of_windows() const { return m_front.lists().size() + m_open_windows->count(); }

  // Lets the front advance until nothing is left to do or `go_on(front)` says no, which is asked
  // before every step with a distance that everything still to come exceeds. Returns that distance.
  template <typename GoOn>
  double run(GoOn go_on)
  {
    Front_queue& queue = m_front.queue();
    while(queue.advance())
    {
      if(!go_on(queue.front()))
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
          m_passed += !label(v).is_passed;
          m_front.label(v).is_passed = true;
          m_departure.leave_vertex(v);
        }
      }
    }
    return std::numeric_limits<double>::infinity();
  }

private:
  // Narrow windows cross large groups fast, wide ones spread over them from every edge: that many faces serve best.
  // Windows are narrow if they are many, in exact fields of a few points. Exact types pay for longer expressions behind
  // a group by orders of magnitude, and have none.
  static int faces_of_group(const Sources& sources, double allowed_error)
  {
    const std::size_t few = 8;
    if(std::numeric_limits<FT>::digits10 == 0)
      return 1;
    return allowed_error == 0 && sources.elements().size() <= few ? 40 : 16;
  }

  bool is_open(int edge) const { return m_front.behind(m_mesh.halfedge_of_edge[edge]) != -1; }

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
      merge_neighbours(m_front.lists(), list, m_allowed_error);
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
        queue.push_edge(e, latest < as_double(unreached()) / 4 ? (std::max)(latest + queue.step(), queue.next_key())
                                                               : queue.next_key());
    }
  }

  const Mesh& m_mesh;
  double m_allowed_error;
  Wavefront<FT> m_front;
  Face_crossing<Wavefront<FT>> m_cross;
  Vertex_departure<Wavefront<FT>> m_departure;
  std::unique_ptr<Open_windows<FT>> m_open_windows;
  std::vector<W> m_to_left, m_to_right; // the windows that cross now, by the face that they cross
  std::size_t m_propagations = 0, m_passed = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_PROPAGATION_H
