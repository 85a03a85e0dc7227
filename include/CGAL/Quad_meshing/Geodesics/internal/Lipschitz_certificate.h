// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_LIPSCHITZ_CERTIFICATE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_LIPSCHITZ_CERTIFICATE_H

#include <CGAL/Quad_meshing/Geodesics/internal/Certified_distance.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Certified_face.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Edge_distance.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_sources.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Slack_tree.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_propagation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Proves lower bounds of the distances, after the fact and whatever the field is.
//
// Let f be the distance that the field claims on the edges. If f(b) <= f(a) + |ab| for any two points a, b on the edges
// of any face, and f is 0 on the sources, then no path to b is shorter than f(b): its pieces in the faces sum up.
// Rounding leaves f(b) <= f(a) + |ab| + slack. As some shortest path meets no face twice, no distance is smaller than f
// minus the slacks of all faces that the path may meet. These are nearer than its end, and the rest of the path is no
// shorter than the straight line.
//
// For one edge of a face and a window w on it, let F be the distance from the source of w when it is put on the outer
// side of the edge. F(b) is the least of w(a) + |ab| over all a on the line, and the least over the window only if b
// lies between the rays through its ends. If b lies to the right of all rays of one window and to the left of all rays
// of the next one, the way over their common end is longer than F(b) of either. So it is enough to compare F with the
// windows on the two other edges between the rays at the ends, with those of the next window where these turn outwards;
// corners with their opposite edges; and windows with each other where they meet.
class Lipschitz_certificate
{
public:
  typedef Unfolded_mesh<double> Mesh;
  typedef Window_propagation<double> Propagation;
  typedef Field_sources<double> Sources;
  typedef Window<double> W;
  typedef Certified_number Number;

  Lipschitz_certificate(const Mesh& mesh, const Propagation& propagation, const Sources& sources)
    : m_mesh(mesh), m_propagation(propagation), m_sources(sources)
  {
  }

  // A lower bound for each vertex, given upper bounds; infinity for those that are not reached. `go_on` is asked now
  // and then, with the part that is done; if it says no, nothing is proven, and the bounds are minus infinity.
  template <typename GoOn>
  std::vector<double> operator()(const std::vector<double>& upper, const GoOn& go_on)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> lower(upper.size(), -infinity);
    std::vector<Finding> findings;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      if(f % 256 == 0 && !go_on(static_cast<double>(f) / m_mesh.number_of_faces()))
        return lower;
      findings.push_back(examine(f));
    }
    const Slack_tree slacks(std::move(findings));
    double at_sources = 0, nearest_source = infinity;
    for(const Source_element<double>& e : m_sources.elements())
    {
      nearest_source = (std::min)(nearest_source, e.offset);
      if(!e.is_segment && e.from.carrier == Surface_point<double>::VERTEX)
        at_sources =
          (std::max)(at_sources, (Number(m_propagation.label(e.from.simplex).distance) - Number(e.offset)).upper());
    }
    for(std::size_t v = 0; v < upper.size(); ++v)
    {
      if(!m_propagation.is_reached(static_cast<int>(v)))
      {
        lower[v] = infinity;
        continue;
      }
      const double d = m_propagation.label(static_cast<int>(v)).distance;
      // a bound of the loss gives a bound of the distances that the field has on the path, and that a better bound
      double e = above(at_sources + slacks.all());
      for(int i = 0; i < 20; ++i)
      {
        const double smaller = above(at_sources + slacks.sum(m_mesh.points[v], above(upper[v] + e)));
        if(!(smaller < 0.9 * e))
          break;
        // what a smaller loss takes from the length of the path is nothing already
        const bool is_enough = e < 1e-6 * upper[v];
        e = smaller;
        if(is_enough)
          break;
      }
      lower[v] = (std::min)((std::max)(nearest_source, (Number(d) - Number(e)).lower()), upper[v]);
    }
    return lower;
  }

  typedef Slack_tree::Finding Finding;

  Finding examine(int face)
  {
    const Certified_face shape(m_mesh, face);
    Finding finding{ std::numeric_limits<double>::infinity(), 0., Bbox_3() };
    for(int v : m_mesh.corners[face])
      finding.box += m_mesh.points[v].bbox();
    int reached = 0;
    for(int k = 0; k < 3; ++k)
      reached += m_propagation.is_reached(m_mesh.corners[face][k]);
    if(reached < 3)
    {
      // a path from one vertex to the others is there
      if(reached > 0)
      {
        finding.slack = finding.nearest;
        finding.nearest = -finding.nearest;
      }
      return finding;
    }

    double jumps = 0, to_vertex = 0; // along an edge, and from the end of an edge to the vertex
    for(int k = 0; k < 3; ++k)
    {
      m_edges[k].make(m_mesh, m_propagation, m_mesh.edge_of[3 * face + k]);
      finding.nearest = (std::min)(finding.nearest, m_edges[k].minimum());
      jumps = (std::max)(jumps, largest_jump(m_edges[k], shape.length(k)));
      to_vertex = (std::max)(to_vertex, jump_to_vertices(m_edges[k], shape.length(k)));
    }
    m_slack = 0;
    for(int k = 0; k < 3; ++k)
    {
      if(shape.is_point(k))
        continue;
      // the opposite corner
      const double d = m_propagation.label(m_mesh.corners[face][(k + 2) % 3]).distance;
      compare(face, k, shape, Certified_distance(shape.apex(k).first, shape.apex(k).second, d, false), true, 0,
              m_edges[k].length * 2);
      cross(face, k, shape);
    }
    const auto range = m_sources.elements_in_face(face);
    for(auto it = range.first; it != range.second; ++it)
    {
      const Source_element<double>& e = m_sources.elements()[it->second];
      finding.nearest = (std::min)(finding.nearest, e.offset);
      check_source(face, shape, e);
    }
    finding.slack = m_slack + jumps + to_vertex;
    // both are sums of positive numbers with few roundings
    finding.slack *= 1 + 1e-12;
    finding.nearest -= 1e-12 * std::fabs(finding.nearest);
    return finding;
  }

private:
  // A ray into the face from the end of a window on one of its edges: the direction, in the frame of the halfedge, and
  // how far the end is from both ends of the edge. Each number has a rounding error of a few units.
  struct Ray
  {
    double dx, dy, to_source, to_target;
  };

  Ray ray(const W& w, double b, bool is_canonical, double length) const
  {
    const double dx = w.linear ? w.x : b - w.x, rest = length - b;
    return is_canonical ? Ray{ dx, w.y, b, rest } : Ray{ -dx, w.y, rest, b };
  }

  // A part of an edge, measured from one of its ends.
  struct Part
  {
    double from, to;
    static Part none() { return Part{ std::numeric_limits<double>::infinity(), 0. }; }
    bool is_empty() const { return !(from <= to); }
    friend Part hull(const Part& a, const Part& b)
    {
      return Part{ (std::min)(a.from, b.from), (std::max)(a.to, b.to) };
    }
    friend Part common(const Part& a, const Part& b)
    {
      return Part{ (std::max)(a.from, b.from), (std::min)(a.to, b.to) };
    }
  };

  // A ray leaves an edge at the distance `far` from an end, where another edge begins in the direction (cosine, sine).
  // The places of that edge beyond the ray, seen from the end, and those before it are at a distance of at least and at
  // most far dy / (dx sine - dy cosine), if that is positive. What is not clear for rounding errors counts as both.
  struct Division
  {
    Part before, beyond;
  };

  static Division divide(double dx, double dy, double far, double length, double cosine, double sine)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    const double a = dy * far, a_error = rounding() * dy * length;
    const double b = dx * sine - dy * cosine, b_error = rounding() * (std::fabs(dx * sine) + std::fabs(dy * cosine));
    Division d{ Part{ 0., infinity }, Part{ 0., infinity } };
    if(b > b_error)
      d.before.to = (a + a_error) / (b - b_error) * (1 + rounding());
    if(b + b_error > 0)
      d.beyond.from = (std::max)(0., (a - a_error) / (b + b_error) * (1 - rounding()));
    else if(a > a_error)
      d.beyond = Part::none();
    else if(b < -b_error)
      d.beyond.to = (a_error - a) / (-b - b_error) * (1 + rounding());
    return d;
  }

  // Compares the windows of halfedge k with those of the two other edges.
  void cross(int face, int k, const Certified_face& shape)
  {
    const Edge_distance& edge = m_edges[k];
    const bool is_canonical = m_mesh.is_canonical(3 * face + k);
    const int n = static_cast<int>(edge.pieces.size()), next = (k + 1) % 3, prev = (k + 2) % 3;
    const double infinity = std::numeric_limits<double>::infinity(), l = edge.length;
    const double ux = shape.to_next(k).first.high(), uy = shape.to_next(k).second.high();
    const double vx = shape.to_apex(k).first.high(), vy = shape.to_apex(k).second.high();
    const auto divide_next = [&](const Ray& r) { return divide(r.dx, r.dy, r.to_target, l, ux, uy); };
    const auto divide_prev = [&](const Ray& r) { return divide(-r.dx, r.dy, r.to_source, l, -vx, vy); };

    for(int i = 0; i < n; ++i)
    {
      const W& w = edge.pieces[i];
      Certified_distance f(w);
      if(w.linear)
        m_slack = (std::max)(m_slack, (f.x * f.x + f.y * f.y - Number(1)).upper() * longest(shape));
      // the parts of the next and of the previous edge, from their common ends with this one
      Part on_next{ 0., infinity }, on_prev{ 0., infinity };
      if(w.y > 0)
      {
        const int right = is_canonical ? i + 1 : i - 1;
        const double left_end = is_canonical ? w.b0 : w.b1, right_end = is_canonical ? w.b1 : w.b0;
        const Ray left_ray = ray(w, left_end, is_canonical, l), right_ray = ray(w, right_end, is_canonical, l);
        Part next_part = divide_next(right_ray).beyond, prev_part = divide_prev(right_ray).before;
        if(right >= 0 && right < n && edge.pieces[right].y > 0)
        {
          const Ray r = ray(edge.pieces[right], right_end, is_canonical, l);
          if(turns_outwards(right_ray, r))
          {
            cross_from(face, k, shape, right_end, Certified_distance(w)(Number(right_end)));
            cross_from(face, k, shape, right_end, Certified_distance(edge.pieces[right])(Number(right_end)));
          }
          else
          {
            next_part = hull(next_part, divide_next(r).beyond);
            prev_part = hull(prev_part, divide_prev(r).before);
          }
        }
        on_next = common(divide_next(left_ray).before, next_part);
        on_prev = common(divide_prev(left_ray).beyond, prev_part);
      }
      else if(!w.linear)
      {
        // all ways from here lead over one place
        const double root = (std::min)((std::max)(w.x, w.b0), w.b1);
        f.sigma = f.sigma + abs(Number::difference(root, w.x));
        f.x = Number(root);
      }
      if(!is_canonical)
        f.reverse(shape.length(k));
      if(!shape.is_point(next) && !on_next.is_empty())
        compare(face, next, shape, moved_to_target(f, shape.length(k), shape.to_next(k)), true, on_next.from,
                on_next.to);
      if(!shape.is_point(prev) && !on_prev.is_empty())
        compare(face, prev, shape, turned(f, shape.to_apex(k)), false, on_prev.from, on_prev.to);
    }
  }

  // Whether the ray of the next window turns away from that of the one before. Below this angle, the way over the
  // common end is longer than what either window says there by less than the rounding of doubles: half the square of
  // the angle.
  static bool turns_outwards(const Ray& before, const Ray& next)
  {
    constexpr double smallest_turn = 1e-8; // radians
    const double sine = next.dx * before.dy - before.dx * next.dy;
    return sine > smallest_turn * std::sqrt((before.dx * before.dx + before.dy * before.dy) *
                                            (next.dx * next.dx + next.dy * next.dy));
  }

  // Compares the ways from a place of halfedge k, which has the distance d, with the windows of the two other edges.
  void cross_from(int face, int k, const Certified_face& shape, double place, const Number& d)
  {
    const int next = (k + 1) % 3, prev = (k + 2) % 3;
    const double infinity = std::numeric_limits<double>::infinity();
    Certified_distance f(Number(place), Number(), d, false);
    if(!m_mesh.is_canonical(3 * face + k))
      f.reverse(shape.length(k));
    if(!shape.is_point(next))
      compare(face, next, shape, moved_to_target(f, shape.length(k), shape.to_next(k)), true, 0, infinity);
    if(!shape.is_point(prev))
      compare(face, prev, shape, turned(f, shape.to_apex(k)), false, 0, infinity);
  }

  // A distance on the line y = 0 whose source is on the side of negative y, on the line in direction u through the
  // origin.
  static Certified_distance turned(const Certified_distance& f, const Certified_face::Place& u)
  {
    if(f.is_linear)
      return Certified_distance(f.x * u.first + f.y * u.second, Number(), f.sigma, true);
    return Certified_distance(f.x * u.first - f.y * u.second, abs(f.y * u.first + f.x * u.second), f.sigma, false);
  }

  static Certified_distance moved_to_target(Certified_distance f, const Number& length, const Certified_face::Place& u)
  {
    if(f.is_linear)
      f.sigma = f.sigma + f.x * length;
    else
      f.x = f.x - length;
    return turned(f, u);
  }

  // Compares the windows of halfedge k with f on [from, to], measured from its source or its target.
  void compare(int face, int k, const Certified_face& shape, Certified_distance f, bool from_source, double from,
               double to)
  {
    const Edge_distance& edge = m_edges[k];
    const double end = edge.length * (1 + rounding());
    to = (std::min)(to, end);
    if(from_source != m_mesh.is_canonical(3 * face + k))
    {
      f.reverse(shape.length(k));
      const double first = edge.length - to, last = edge.length - from, margin = rounding() * edge.length;
      from = (std::max)(0., first - margin);
      to = (std::min)(end, last + margin);
    }
    for(std::size_t i = 0; i < edge.pieces.size() && edge.pieces[i].b0 <= to; ++i)
    {
      const W& w = edge.pieces[i];
      const double w_end = i + 1 < edge.pieces.size() ? w.b1 : end;
      if(w_end >= from)
        m_slack = Distance_excess::bound(w, f, (std::max)(from, w.b0), (std::min)(to, w_end), m_slack);
    }
  }

  // The most that one loses by going along an edge over the ends of its windows, one way or the other.
  static double largest_jump(const Edge_distance& edge, const Number& length)
  {
    double up = 0, down = 0, worst = 0;
    const auto add = [&](const Number& jump)
    {
      up = (std::max)(0., up + jump.upper());
      down = (std::max)(0., down - jump.lower());
      worst = (std::max)({ worst, up, down });
    };
    Number before(edge.at_source);
    for(std::size_t i = 0; i < edge.pieces.size(); ++i)
    {
      const W& w = edge.pieces[i];
      const Certified_distance f(w);
      add(f(Number(w.b0)) - before);
      before = f(i + 1 < edge.pieces.size() ? Number(w.b1) : length);
    }
    add(Number(edge.at_target) - before);
    return worst;
  }

  // The most that the distance of a vertex exceeds that at the end of an edge.
  static double jump_to_vertices(const Edge_distance& edge, const Number& length)
  {
    if(edge.pieces.empty())
      return 0;
    const Number at_source = Certified_distance(edge.pieces.front())(Number(0)),
                 at_target = Certified_distance(edge.pieces.back())(length);
    return (std::max)(
      { 0., (Number(edge.at_source) - at_source).upper(), (Number(edge.at_target) - at_target).upper() });
  }

  static double longest(const Certified_face& shape)
  {
    return (std::max)({ shape.length(0).upper(), shape.length(1).upper(), shape.length(2).upper() });
  }

  // Compares the windows of the edges with a source in the face or on its edges.
  void check_source(int face, const Certified_face& shape, const Source_element<double>& e)
  {
    typedef Surface_point<double> Point;
    const double infinity = std::numeric_limits<double>::infinity();
    const int on = e.is_segment ? e.halfedge : e.from.carrier == Point::EDGE ? e.from.simplex : -1;
    if(on != -1)
    {
      // f itself on the edge
      int k = 0;
      while(m_mesh.edge_of[3 * face + k] != m_mesh.edge_of[on])
        ++k;
      const double s = Sources::place_on(m_mesh, on, e.from), t = Sources::place_on(m_mesh, on, e.to);
      const bool along = on == 3 * face + k;
      if(e.is_segment)
        compare(face, k, shape, Certified_distance(Number(), Number(), e.offset, true), along, (std::min)(s, t),
                (std::max)(s, t));
      else
        compare(face, k, shape, Certified_distance(s, Number(), e.offset, false), along, 0, infinity);
      return;
    }
    if(shape.is_point(0) || shape.is_point(1) || shape.is_point(2))
    {
      m_slack = infinity;
      return;
    }
    const Certified_face::Place p = certified_place(m_mesh, face, shape, e.from),
                                q = certified_place(m_mesh, face, shape, e.to);
    for(int k = 0; k < 3; ++k)
    {
      const Certified_face::Place a = in_frame(shape, k, p), b = in_frame(shape, k, q);
      compare(face, k, shape, Certified_distance(a.first, a.second, e.offset, false), true, 0, infinity);
      if(!e.is_segment)
        continue;
      compare(face, k, shape, Certified_distance(b.first, b.second, e.offset, false), true, 0, infinity);
      compare_strip(face, k, shape, a, b, e.offset);
    }
  }

  // Compares with the distance from the segment ab where its foot is on the segment.
  void compare_strip(int face, int k, const Certified_face& shape, const Certified_face::Place& a,
                     const Certified_face::Place& b, double offset)
  {
    const Number vx = b.first - a.first, vy = b.second - a.second, norm = sqrt(vx * vx + vy * vy);
    // the foot of the place t
    const double slope = vx.high(), at_0 = -(vx * a.first + vy * a.second).high(), square = (norm * norm).high();
    const double margin = rounding() * (square + std::fabs(slope) * m_edges[k].length + std::fabs(at_0));
    double from = 0, to = m_edges[k].length * (1 + rounding());
    if(slope > 0)
    {
      from = (std::max)(from, (-margin - at_0) / slope);
      to = (std::min)(to, (square + margin - at_0) / slope);
    }
    else if(slope < 0)
    {
      from = (std::max)(from, (square + margin - at_0) / slope);
      to = (std::min)(to, (-margin - at_0) / slope);
    }
    else if(at_0 < -margin || at_0 > square + margin)
      return;
    if(!(from <= to))
      return;
    // the distance from the line; the segment is all on one side of the edge
    Certified_distance f(-vy / norm, Number(), (vy * a.first - vx * a.second) / norm, true);
    if(f((from + to) / 2).high() < 0)
      f = Certified_distance(-f.x, Number(), -f.sigma, true);
    f.sigma = f.sigma + Number(offset);
    compare(face, k, shape, f, true, from, to);
  }

  static Certified_face::Place in_frame(const Certified_face& shape, int k, const Certified_face::Place& p)
  {
    const Certified_face::Place a = shape.corner(k), b = shape.corner((k + 1) % 3);
    const Number ux = (b.first - a.first) / shape.length(k), uy = (b.second - a.second) / shape.length(k);
    const Number dx = p.first - a.first, dy = p.second - a.second;
    return Certified_face::Place(dx * ux + dy * uy, dy * ux - dx * uy);
  }

  static constexpr double rounding() { return 0x1p-48; }
  static double above(double x) { return x + rounding() * std::fabs(x); }

  const Mesh& m_mesh;
  const Propagation& m_propagation;
  const Sources& m_sources;
  std::array<Edge_distance, 3> m_edges;
  double m_slack = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_LIPSCHITZ_CERTIFICATE_H
