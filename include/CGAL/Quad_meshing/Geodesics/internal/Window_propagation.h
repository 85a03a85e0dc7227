// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_PROPAGATION_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_PROPAGATION_H

#include <CGAL/Quad_meshing/Geodesics/internal/Front_queue.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_envelope.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_merging.h>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The nearest known way to a vertex.
template <typename FT>
struct Vertex_label
{
  FT distance;
  double angle;            // the direction of arrival, see Unfolded_mesh::direction
  int origin;              // the pseudo-source that reaches the vertex, see Window::origin
  float error;             // see Window::error
  bool is_passed;          // whether the front has passed it
};

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
  typedef std::vector<W> List;

  static FT unreached() { return FT(1e300); }

  // `allowed_error`: the relative error that merging windows may cause, 0 for the exact field.
  // `keep_windows`: whether the windows of an edge stay when the front has passed it.
  explicit Window_propagation(const Mesh& mesh, double allowed_error = 0, bool keep_windows = true)
    : m_mesh(mesh),
      m_allowed_error(allowed_error),
      m_keep_windows(keep_windows),
      m_lists(mesh.number_of_edges()),
      m_labels(mesh.number_of_vertices(), Vertex_label<FT>{ unreached(), 0., 0, 0.f, false }),
      m_queue(mesh.number_of_edges(), mesh.number_of_vertices(), step_length(mesh))
  {}

  const List& windows(int edge) const { return m_lists[edge]; }
  const Vertex_label<FT>& label(int v) const { return m_labels[v]; }
  bool is_reached(int v) const { return m_labels[v].distance < unreached(); }

  std::size_t number_of_propagations() const { return m_propagations; }
  std::size_t number_of_passed_vertices() const { return m_passed; }

  // Starts rays in all directions from a vertex.
  void start_at_vertex(int v, const FT& offset, int origin) { reach(v, offset, origin, 0.f, 0.); }

  // Starts rays in all directions from the place t on halfedge h.
  void start_on_halfedge(int h, const FT& t, const FT& offset, int origin)
  {
    const FT length = m_mesh.length_of(h);
    reach(m_mesh.source(h), offset + t, origin, 0.f, m_mesh.direction[h]);
    reach(m_mesh.target(h), offset + (length - t), origin, 0.f, angle_of_reverse(h));
    W w = circular(t, FT(0), offset, origin);
    w.b1 = length;
    store(h, w, false);
    leave_point(h, t, offset, origin, 0.f);
    if(m_mesh.opposite[h] != -1)
      leave_point(m_mesh.opposite[h], FT(length - t), offset, origin, 0.f);
  }

  // Starts rays in all directions from the point (x, y) in the interior of the face of h.
  void start_in_face(int h, FT x, FT y, const FT& offset, int origin)
  {
    for(int k = 0; k < 3; ++k)
    {
      reach(m_mesh.source(h), offset + square_root(x * x + y * y), origin, 0.f,
            m_mesh.direction[h] + std::atan2(as_double(y), as_double(x)));
      W w = circular(x, y, offset, origin);
      w.b1 = m_mesh.length_of(h);
      send(h, w);
      to_next_frame(h, x, y);
      h = Mesh::next(h);
    }
  }

  // Starts a straight front to both sides from the part [t0, t1] of halfedge h.
  void start_along_halfedge(int h, const FT& t0, const FT& t1, const FT& offset, int origin)
  {
    W w{ t0, t1, FT(0), FT(1), offset, origin, 0.f, 0.f, true, true, false };
    store(h, w, false);
    if(m_mesh.opposite[h] != -1)
    {
      w.reverse(m_mesh.length_of(h));
      cross(m_mesh.opposite[h], w);
      w.reverse(m_mesh.length_of(h));
    }
    w.from_left = false;
    cross(h, w);
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
          reach(m_mesh.source(h), offset - na, origin, 0.f,
                m_mesh.direction[h] + std::atan2(as_double(FT(-ny)), as_double(FT(-nx))));
        if(! (ny < FT(0)))
          continue;
        const FT slack = FT(Tol::place()) * length;
        FT t0(0), t1 = length;
        if(clip(ux, FT(-ua), FT(0), t0, t1) && clip(FT(-ux), FT(norm + ua), FT(0), t0, t1) &&
           clip(nx, FT(-na), slack, t0, t1))
          send(h, W{ t0, t1, nx, FT(-ny), FT(offset - na), origin, 0.f, 0.f, true, true, true });
      }
      to_next_frame(h, ax, ay);
      to_next_frame(h, bx, by);
      h = Mesh::next(h);
    }
  }

  // Lets the front advance until nothing is left to do or `go_on(front)` says no, which is asked
  // before every step with a distance that everything still to come exceeds. Returns that distance.
  template <typename GoOn>
  double run(GoOn go_on)
  {
    while(m_queue.advance())
    {
      if(! go_on(m_queue.front()))
        return m_queue.front();
      while(m_queue.step_has_more())
      {
        int e, v;
        while((e = m_queue.pop_edge()) != -1)
          propagate_edge(e);
        if((v = m_queue.pop_vertex()) != -1)
          leave_vertex(v);
      }
    }
    return std::numeric_limits<double>::infinity();
  }

private:
  static double step_length(const Mesh& mesh)
  {
    double sum = 0;
    for(const FT& l : mesh.length)
      sum += as_double(l);
    return mesh.length.empty() || ! (sum > 0) ? 1. : sum / static_cast<double>(mesh.length.size());
  }

  static W circular(const FT& x, const FT& y, const FT& sigma, int origin)
  {
    return W{ FT(0), FT(0), x, y, sigma, origin, 0.f, 0.f, false, true, true };
  }

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

  // Changes from the frame of h to the frame of next(h).
  void to_next_frame(int h, FT& x, FT& y) const
  {
    const FT l = m_mesh.length_of(h), n = m_mesh.length_of(Mesh::next(h));
    const FT vx = m_mesh.apex[h].back, vy = m_mesh.apex[h].y, dx = x - l;
    x = (dx * vx + y * vy) / n;
    y = (y * vx - dx * vy) / n;
  }

  // The direction of the way back along h at its target.
  double angle_of_reverse(int h) const
  {
    const int o = m_mesh.opposite[h];
    return o != -1 ? m_mesh.direction[o] : m_mesh.total_angle[m_mesh.target(h)];
  }

  // ---- reaching vertices ----

  void reach(int v, const FT& d, int origin, float error, double angle)
  {
    Vertex_label<FT>& label = m_labels[v];
    if(! (d < label.distance - FT(Tol::tie()) * label.distance))
      return;
    label.distance = d;
    label.origin = origin;
    label.angle = angle;
    label.error = error;
    m_queue.push_vertex(v, as_double(d));
  }

  // Goes on from a vertex: along its edges always, which lets no vertex unreached whatever rounding
  // does, and into its faces where paths may bend.
  void leave_vertex(int v)
  {
    if(! m_labels[v].is_passed)
    {
      m_labels[v].is_passed = true;
      ++m_passed;
    }
    const int first = m_mesh.halfedge_of_vertex[v];
    if(first == -1)
      return;
    const FT d = m_labels[v].distance;
    const float error = m_labels[v].error;
    int h = first;
    do
    {
      reach(m_mesh.target(h), d + m_mesh.length_of(h), v, error, angle_of_reverse(h));
      const int p = Mesh::prev(h);
      if(m_mesh.opposite[p] == -1)
        reach(m_mesh.source(p), d + m_mesh.length_of(p), v, error, m_mesh.direction[p]);
      h = m_mesh.next_around_source(h);
    }
    while(h != -1 && h != first);

    if(m_labels[v].origin < 0 || m_mesh.passage[v] == PASSAGE_EVERYWHERE)
      leave_into_faces(v, 0., m_mesh.total_angle[v]);
    else if(m_mesh.passage[v] == PASSAGE_IN_SHADOW)
    {
      // Both angles between arrival and departure are at least pi.
      const double pi = std::acos(-1.), margin = Mesh::flat_angle_tolerance();
      const double total = m_mesh.total_angle[v], a = m_labels[v].angle;
      if(m_mesh.opposite[first] == -1 || h == -1)
      {
        leave_into_faces(v, a + pi - margin, total);
        leave_into_faces(v, 0., a - pi + margin);
      }
      else
      {
        leave_into_faces(v, a + pi - margin, a + total - pi + margin);
        leave_into_faces(v, a - total + pi - margin, a - pi + margin);
      }
    }
  }

  // Sends rays from v in the directions between the two angles.
  void leave_into_faces(int v, double from, double to)
  {
    if(! (from < to))
      return;
    const bool whole = from == 0. && to == m_mesh.total_angle[v];
    const int first = m_mesh.halfedge_of_vertex[v];
    const FT d = m_labels[v].distance;
    int h = first;
    do
    {
      const double begin = m_mesh.direction[h], corner = m_mesh.corner_angle(h);
      if(whole || (begin < to && begin + corner > from))
      {
        const int n = Mesh::next(h);
        const typename Mesh::Apex a = m_mesh.apex[n];
        W w = circular(a.x, a.y, d, v);
        w.b1 = m_mesh.length_of(n);
        w.error = m_labels[v].error;
        if(w.y == FT(0))
        {
          if(w.x > FT(0) && w.x < w.b1 && m_mesh.opposite[n] != -1)
            leave_point(m_mesh.opposite[n], FT(w.b1 - w.x), d, v, m_labels[v].error);
        }
        else
        {
          if(! whole && from > begin)
            w.b0 = (std::max)(FT(0), hit(a, from - begin));
          if(! whole && to < begin + corner)
            w.b1 = (std::min)(w.b1, hit(a, to - begin));
          if(w.b0 < w.b1)
            send(n, w);
        }
      }
      h = m_mesh.next_around_source(h);
    }
    while(h != -1 && h != first);
  }

  // Where the ray from the apex hits the halfedge; `angle` is measured from the way to its source.
  static FT hit(const typename Mesh::Apex& a, double angle)
  {
    const FT c = FT(std::cos(angle)), s = FT(std::sin(angle));
    return a.x + a.y * (a.y * s - a.x * c) / (a.x * s + a.y * c);
  }

  // Sends rays from the place t on halfedge h into the face of h.
  void leave_point(int h, const FT& t, const FT& sigma, int origin, float error)
  {
    FT x = t, y(0);
    for(int k = 0; k < 2; ++k)
    {
      to_next_frame(h, x, y);
      h = Mesh::next(h);
      const FT length = m_mesh.length_of(h);
      if(k == 0)
        reach(m_mesh.target(h), sigma + square_root((x - length) * (x - length) + y * y), origin, error,
              m_mesh.direction[Mesh::next(h)] + m_mesh.corner_angle(Mesh::next(h)) -
              std::atan2(as_double(y), as_double(FT(length - x))));
      if(y > FT(0))
      {
        W w = circular(x, y, sigma, origin);
        w.b1 = length;
        w.error = error;
        send(h, w);
      }
      else if(x > FT(0) && x < length && m_mesh.opposite[h] != -1)
        leave_point(m_mesh.opposite[h], FT(length - x), sigma, origin, error);
    }
  }

  // ---- crossing faces ----

  void propagate_edge(int e)
  {
    List& list = m_lists[e];
    if(m_allowed_error > 0)
      merge_pending(list);
    m_due.clear();
    float later = std::numeric_limits<float>::infinity();
    for(W& w : list)
      if(w.pending)
      {
        if(w.key < m_queue.step_end())
        {
          w.pending = false;
          m_due.push_back(w);
        }
        else
          later = (std::min)(later, w.key);
      }
    if(later < std::numeric_limits<float>::infinity())
      m_queue.push_edge(e, later);
    else if(! m_keep_windows)
    {
      if(m_queue.front() >= latest(e))
        List().swap(list);
      else
        m_queue.push_edge(e, latest(e) < unreached() / 4 ? latest(e) + m_queue.step() : m_queue.step_end());
    }

    const int c = m_mesh.halfedge_of_edge[e], o = m_mesh.opposite[c];
    for(W& w : m_due)
    {
      if(! w.from_left)
        cross(c, w);
      else if(o != -1)
      {
        w.reverse(m_mesh.length[e]);
        cross(o, w);
      }
    }
  }

  // No point of an edge is farther than this: one goes there over the nearer end.
  double latest(int e) const
  {
    const int h = m_mesh.halfedge_of_edge[e];
    return as_double(FT((m_labels[m_mesh.source(h)].distance + m_labels[m_mesh.target(h)].distance + m_mesh.length[e]) / FT(2)));
  }

  void merge_pending(List& list) const
  {
    std::size_t n = 0;
    W merged;
    for(std::size_t k = 0; k < list.size(); ++k)
    {
      if(n > 0 && list[n - 1].pending && list[k].pending && merge_windows(list[n - 1], list[k], m_allowed_error, merged))
        list[n - 1] = merged;
      else if(n++ != k)
        list[n - 1] = list[k];
    }
    list.resize(n);
  }

  // Takes a window on h, given in the frame of h with its source on the other side, through the face of h.
  void cross(int h, const W& w)
  {
    if(! (w.y > FT(0)))
      return;
    ++m_propagations;
    const FT l = m_mesh.length_of(h);
    const FT rx = m_mesh.apex[h].x, ry = m_mesh.apex[h].y, back = m_mesh.apex[h].back;
    const int right = Mesh::next(h), left = Mesh::prev(h);

    // the ray to the third vertex crosses h at t
    const FT t = w.linear ? FT(rx - ry * w.x / w.y) : FT(w.x + (rx - w.x) * w.y / (ry + w.y));
    const FT place = FT(Tol::place()) * l;
    if((t >= w.b0 || w.closes_gap(w.b0 - t, w.b0, l)) && (t <= w.b1 || w.closes_gap(t - w.b1, w.b1, l)))
    {
      const FT bx = w.linear ? w.x : FT(rx - w.x), by = w.linear ? w.y : FT(ry + w.y);
      const FT d = w.linear ? FT(w.sigma + rx * bx + ry * by) : FT(w.sigma + square_root(bx * bx + by * by));
      Vertex_label<FT>& label = m_labels[m_mesh.target(right)];
      if(d < label.distance)
      {
        // the angle from the way to p, (-rx, -ry), to the way back, (-bx, -by)
        const double angle = std::atan2(as_double(FT(rx * by - ry * bx)), as_double(FT(rx * bx + ry * by)));
        reach(m_mesh.target(right), d, w.origin, w.error, m_mesh.direction[left] + angle);
      }
    }

    if(t < w.b1 - place)
    {
      const FT n = m_mesh.length_of(right), inverse = m_mesh.inverse_length[m_mesh.edge_of[right]];
      W v = w;
      v.from_left = true;
      v.pending = true;
      v.b0 = n * right_fraction(w, w.b1, l, back, ry);
      v.b1 = t > w.b0 - place ? n : FT(n * right_fraction(w, w.b0, l, back, ry));
      const FT ux = back * inverse, uy = ry * inverse;
      if(w.linear)
      {
        v.sigma = w.sigma + w.x * l;
        v.x = w.x * ux + w.y * uy;
        v.y = w.x * uy - w.y * ux;
      }
      else
      {
        v.x = (w.x - l) * ux - w.y * uy;
        v.y = -(w.x - l) * uy - w.y * ux;
      }
      send(right, v);
    }
    if(t > w.b0 + place)
    {
      const FT n = m_mesh.length_of(left), inverse = m_mesh.inverse_length[m_mesh.edge_of[left]];
      W v = w;
      v.from_left = true;
      v.pending = true;
      v.b0 = t < w.b1 + place ? FT(0) : FT(n * (FT(1) - left_fraction(w, w.b1, rx, ry)));
      v.b1 = n * (FT(1) - left_fraction(w, w.b0, rx, ry));
      const FT ux = -rx * inverse, uy = -ry * inverse;
      if(w.linear)
      {
        v.sigma = w.sigma + w.x * rx + w.y * ry;
        v.x = w.x * ux + w.y * uy;
        v.y = w.x * uy - w.y * ux;
      }
      else
      {
        v.x = (w.x - rx) * ux - (w.y + ry) * uy;
        v.y = -(w.x - rx) * uy - (w.y + ry) * ux;
      }
      send(left, v);
    }
  }

  // The ray of w through the place b meets the line from q to r at this fraction of the way from q.
  static FT right_fraction(const W& w, const FT& b, const FT& l, const FT& back, const FT& ry)
  {
    const FT dx = w.linear ? w.x : FT(b - w.x);
    return w.y * (l - b) / (dx * ry - w.y * back);
  }

  // The ray of w through the place b meets the line from p to r at this fraction of the way from p.
  static FT left_fraction(const W& w, const FT& b, const FT& rx, const FT& ry)
  {
    const FT dx = w.linear ? w.x : FT(b - w.x);
    return w.y * b / (w.y * rx - dx * ry);
  }

  // ---- arriving on edges ----

  // Brings a window, in the frame of h and coming from the face of h, to its edge.
  void send(int h, W& w)
  {
    const FT l = m_mesh.length_of(h);
    if(! (w.y > FT(0)) || l == FT(0))
      return;
    if(w.b0 < FT(0)) w.b0 = FT(0);
    if(l < w.b1) w.b1 = l;
    if(! (w.b0 < w.b1))
      return;

    // Xin and Wang 2009: rays that are longer than the way over an end of the edge lead nowhere.
    const FT d0 = w.distance(w.b0), d1 = w.distance(w.b1);
    const FT margin = FT(1) - Tol::filter();
    if(m_labels[m_mesh.source(h)].distance + w.b1 < d1 * margin ||
       m_labels[m_mesh.target(h)].distance + (l - w.b0) < d0 * margin)
      return;
    if(! m_keep_windows && latest(m_mesh.edge_of[h]) <= m_queue.front())
      return;
    w.key = W::key_of(w.linear ? (std::min)(d0, d1) : w.x <= w.b0 ? d0 : w.x >= w.b1 ? d1 : FT(w.sigma + w.y));
    store(h, w, true);
  }
  void send(int h, W&& w) { W v = w; send(h, v); }

  void store(int h, const W& w, bool pending)
  {
    const int e = m_mesh.edge_of[h];
    W v = w;
    v.pending = pending;
    if(! m_mesh.is_canonical(h))
      v.reverse(m_mesh.length[e]);
    float key;
    if(m_envelope.insert(m_lists[e], v, m_mesh.length[e], key) && pending)
      m_queue.push_edge(e, key);
  }

  const Mesh& m_mesh;
  double m_allowed_error;
  bool m_keep_windows;
  std::vector<List> m_lists;
  std::vector<Vertex_label<FT> > m_labels;
  Front_queue m_queue;
  Window_envelope<FT> m_envelope;
  std::vector<W> m_due;
  std::size_t m_propagations = 0, m_passed = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_PROPAGATION_H
