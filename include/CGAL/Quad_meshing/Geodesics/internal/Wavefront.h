// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WAVEFRONT_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WAVEFRONT_H

#include <CGAL/Quad_meshing/Geodesics/internal/Front_queue.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Open_edges.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_envelope.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_landing.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_lists.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_predicates.h>

#include <boost/config.hpp>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The nearest known way to a vertex.
template <typename FT>
struct Vertex_label
{
  FT distance;
  double angle; // the direction of arrival, see Unfolded_mesh::direction; only where Unfolded_mesh::passage asks for it
  float error;  // see Window::error
  int origin : 31;    // the pseudo-source that reaches the vertex, see Window::origin
  bool is_passed : 1; // whether the front has passed it
};

// What the front knows: the windows of the edges, the labels of the vertices and the queue of what is still to
// advance. Everything that moves the front ends here, with a distance that arrives at a vertex or a window at an edge.
template <typename Number>
class Wavefront
{
public:
  typedef Number FT;
  typedef Unfolded_mesh<FT> Mesh;
  typedef Window<FT> W;
  typedef Window_list<FT> List;

  static constexpr bool asks_at_open_edges = false; // see Face_crossing

  static FT unreached() { return FT(1e300); }

  Wavefront(const Mesh& mesh, bool keep_windows, int faces_of_group)
    : m_mesh(mesh)
    , m_keep_windows(keep_windows)
    , m_open_edges(mesh, faces_of_group)
    , m_lists(mesh.number_of_edges())
    , m_labels(mesh.number_of_vertices(), Vertex_label<FT>{ unreached(), 0., 0.f, 0, false })
    , m_queue(mesh.number_of_edges(), mesh.number_of_vertices(), step_length(mesh))
  {
  }

  const Mesh& mesh() const { return m_mesh; }
  bool keeps_windows() const { return m_keep_windows; }
  Window_lists<FT>& lists() { return m_lists; }
  const Window_lists<FT>& lists() const { return m_lists; }
  Vertex_label<FT>& label(int v) { return m_labels[v]; }
  const Vertex_label<FT>& label(int v) const { return m_labels[v]; }
  Front_queue& queue() { return m_queue; }

  const Open_edges<FT>& open_edges() const { return m_open_edges; }

  // The halfedge by which windows go on that leave their face through h without being listed there, -1 if they are.
  int behind(int h) const { return m_open_edges.behind(h); }

  // Receives a distance at a vertex. `angle()` is its direction of arrival.
  template <typename Angle>
  void reach(int v, const FT& d, int origin, float error, const Angle& angle)
  {
    Vertex_label<FT>& label = m_labels[v];
    if(!Window_predicates<FT>::is_shorter(d, label.distance))
      return;
    label.distance = d;
    label.origin = origin;
    label.error = error;
    if(m_mesh.passage[v] == PASSAGE_IN_SHADOW)
      label.angle = angle();
    m_queue.push_vertex(v, as_double(d));
  }

  struct Landing : Window_landing<FT>
  {
    bool is_due; // in this step already
    FT nearest;  // the smallest distance of what has arrived, if the edge is not due

    Landing(const Window_landing<FT>& base, bool is_due)
      : Window_landing<FT>(base), is_due(is_due), nearest(unreached())
    {
    }
  };

  Landing landing(int h) const
  {
    const int e = m_mesh.edge_of[h];
    const FT &length = m_mesh.length_of(h), &at_source = m_labels[m_mesh.source(h)].distance,
             &at_target = m_labels[m_mesh.target(h)].distance;
    return Landing(
      Window_landing<FT>{ e, m_mesh.is_canonical(h), latest(at_source, at_target, length) <= m_queue.front(), length,
                          at_source, at_target, m_lists[e].size },
      m_queue.is_due(e));
  }

  // Receives a window that comes through the face of the halfedge, in the frame of the halfedge.
  BOOST_FORCEINLINE void arrive(Landing& at, W w)
  {
    if(!at.admits(w))
      return;
    const auto inserted = m_envelope.insert(m_lists, m_lists[at.edge], at.hint, w, at.length);
    if(inserted != Window_envelope<FT>::NOTHING && !at.is_due)
      at.nearest =
        (std::min)(at.nearest, inserted == Window_envelope<FT>::ALL ? w.minimum() : m_envelope.nearest_part());
  }

  // To be called when all have arrived.
  void finish(const Landing& at)
  {
    if(at.nearest < unreached())
      m_queue.push_edge(at.edge, key(at.nearest));
  }

  // The same for single windows.
  BOOST_NOINLINE void arrive(int h, const W& w)
  {
    if(m_mesh.length_of(h) == FT(0))
      return;
    Landing at = landing(h);
    if(at.is_closed)
      return;
    arrive(at, w);
    finish(at);
  }

  // Puts a window on an edge from which it does not go on, in the frame of h.
  void store(int h, W w)
  {
    if(behind(h) != -1)
      return;
    const int e = m_mesh.edge_of[h];
    if(!m_mesh.is_canonical(h))
      w.reverse(m_mesh.length[e]);
    int hint = 0;
    m_envelope.insert(m_lists, m_lists[e], hint, w, m_mesh.length[e]);
  }

  // No point of an edge is farther than this: one goes there over the nearer end.
  double latest(int e) const
  {
    const int h = m_mesh.halfedge_of_edge[e];
    return latest(m_labels[m_mesh.source(h)].distance, m_labels[m_mesh.target(h)].distance, m_mesh.length[e]);
  }

  // When to go on with what begins at this distance: the margin covers rounding and window ends that move a little.
  static double key(const FT& distance)
  {
    const double d = as_double(distance);
    return d - 1e-6 * std::abs(d);
  }

private:
  static double latest(const FT& at_source, const FT& at_target, const FT& length)
  {
    return as_double(FT((at_source + at_target + length) / FT(2)));
  }

  static double step_length(const Mesh& mesh)
  {
    double sum = 0;
    for(const FT& l : mesh.length)
      sum += as_double(l);
    return mesh.length.empty() || !(sum > 0) ? 1. : sum / static_cast<double>(mesh.length.size());
  }

  const Mesh& m_mesh;
  bool m_keep_windows;
  Open_edges<FT> m_open_edges;
  Window_lists<FT> m_lists;
  std::vector<Vertex_label<FT>> m_labels;
  Front_queue m_queue;
  Window_envelope<FT> m_envelope;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WAVEFRONT_H
