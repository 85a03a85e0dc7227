// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FACE_CROSSING_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FACE_CROSSING_H

#include <CGAL/Quad_meshing/Geodesics/internal/Number_functions.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_predicates.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Takes windows from one edge of a face to the two others; where an edge is open, on to the edges behind it. All
// windows of the edge go together from corner to corner, so that each face is unfolded once, and on each edge they
// arrive in their order.
//
// The ways through a group of faces divide at its corners and may meet again behind them, in the same face but in
// different frames. There the windows of both go on: the nearer ones are found where they stop.
//
// `Front` receives the windows and the distances of the vertices: `Wavefront`, which asks for the windows at the edges
// where they stop, or `Group_front`, which asks for them at the open edges that they pass.
template <typename Front>
class Face_crossing
{
public:
  typedef typename Front::FT FT;
  typedef Unfolded_mesh<FT> Mesh;
  typedef Window<FT> W;
  typedef Window_tolerances<FT> Tol;
  typedef Window_predicates<FT> Predicates;

  explicit Face_crossing(Front& front) : m_front(front) {}

  // The windows lie on halfedge h, which runs from p to q in the face (p, q, r), in the frame of h and sorted along
  // it, and their sources on the other side.
  void operator()(int h, const std::vector<W>& windows)
  {
    if(windows.empty())
      return;
    const Mesh& mesh = m_front.mesh();
    const typename Mesh::Apex& apex = mesh.apex[h];
    const FT l = mesh.length_of(h);
    m_place = FT(Tol::place()) * l;
    m_doubtful = FT(2) * FT(Tol::wide_gap()) * l;
    m_far = Predicates::far(l);
    m_length = l;
    m_windows = windows.data();
    m_exits.clear();
    m_number_of_parts = 0;
    enter(Mesh::face(h));
    Segment parts = new_segment(windows.size());
    for(const W& w : windows)
      m_parts[parts.end++] = Part{ static_cast<int>(&w - m_windows), false, false, w.b0, w.b1 };
    pass(Corner{ Vector{ apex.x, apex.y }, Vector{ l, FT(0) }, Vector{ apex.back, apex.y }, Vector{ -apex.x, -apex.y },
                 h, true },
         parts);
    for(const Exit& exit : m_exits)
      if(mesh.length_of(exit.halfedge) > FT(0))
        leave(exit);
    go_back();
  }

  // Receives a window that comes through the face of the halfedge, in the frame of the halfedge: on it, or behind it if
  // it is open.
  BOOST_NOINLINE void arrive(int h, W w)
  {
    const int o = m_front.behind(h);
    if(o == -1 || Front::asks_at_open_edges)
      m_front.arrive(h, w);
    if(o != -1)
    {
      w.reverse(m_front.mesh().length_of(h));
      (*this)(o, std::vector<W>(1, w));
    }
  }

private:
  struct Vector
  {
    FT x, y;
  };

  // A part of a window, on its way to an exit.
  struct Part
  {
    int window;
    bool begins_at_corner, ends_at_corner; // whether its rays at the right, at the left end lead to the end of the exit
    FT b0, b1;
  };

  // Parts that go the same way, in `m_parts`.
  struct Segment
  {
    std::size_t begin, end;

    bool is_empty() const { return begin == end; }
  };

  // An edge at which windows arrive.
  struct Exit
  {
    int halfedge;
    bool is_last;       // whether it ends at p
    Vector begin, side; // from where, and how far it runs
    Segment parts;
  };

  // The apex of a face.
  struct Corner
  {
    Vector place;
    Vector begin; // where the right side begins
    Vector right_side, left_side;
    int halfedge; // through which its face is entered
    bool is_last; // whether its face contains p
  };

  // The ray of a window to a corner, which crosses h at origin + across / depth.
  struct Ray
  {
    FT origin, across, depth;

    Ray(const W& w, const Vector& c)
      : origin(w.linear ? FT(0) : w.x)
      , across(w.linear ? FT(c.x * w.y - c.y * w.x) : FT((c.x - w.x) * w.y))
      , depth(w.linear ? w.y : FT(c.y + w.y))
    {
    }

    FT place() const { return origin + across / depth; }

    // How far beyond b that is, times the depth.
    FT beyond(const FT& b) const { return across - (b - origin) * depth; }
  };

  // Room for so many parts, none of them there yet. What it had before in other segments stays until the windows have
  // left.
  Segment new_segment(std::size_t size)
  {
    const std::size_t begin = m_number_of_parts;
    m_number_of_parts += size;
    if(m_parts.size() < m_number_of_parts)
      m_parts.resize(2 * m_number_of_parts);
    return Segment{ begin, begin };
  }

  // Takes parts past a corner, to the exits.
  void pass(const Corner& c, const Segment& parts)
  {
    const std::size_t size = parts.end - parts.begin;
    Segment left = new_segment(size), right = new_segment(size);
    for(std::size_t k = parts.begin; k < parts.end; ++k)
    {
      const Part& part = m_parts[k];
      const W& w = m_windows[part.window];
      const Ray ray(w, c.place);
      // where the ray to the corner is far enough from the ends of the part, rounding does not matter
      const FT doubtful = m_doubtful * ray.depth;
      const std::size_t is_left = ray.beyond(part.b1) > doubtful, is_right = ray.beyond(part.b0) < -doubtful;
      if(BOOST_UNLIKELY(is_left + is_right != 1 || c.place.y < FT(0) || is_far(c, w)))
      {
        pass_nearby(c, w, part, left, right);
        continue;
      }
      // both are written, one of them counts: which way they go is hard to foresee
      Part &to_left = m_parts[left.end], &to_right = m_parts[right.end];
      to_left = part;
      to_right = part;
      to_left.begins_at_corner = false;
      to_right.ends_at_corner = false;
      left.end += is_left;
      right.end += is_right;
    }
    if(!left.is_empty())
      go_through(Mesh::prev(c.halfedge), c.place, c.left_side, c.is_last, left);
    if(!right.is_empty())
      go_through(Mesh::next(c.halfedge), c.begin, c.right_side, false, right);
  }

  // A part with the corner between its rays, or near one of them, or behind h.
  BOOST_NOINLINE void pass_nearby(const Corner& corner, const W& w, const Part& part, Segment& left, Segment& right)
  {
    const Vector c = corner.place;
    if(c.y < FT(0))
    {
      // The corner lies behind h, so it is beyond an end, and all rays of the part are on one side of it.
      if(Predicates::is_right_of_ray(w, c.x, c.y, FT((part.b0 + part.b1) / FT(2))))
        add(left, part).begins_at_corner = false;
      else
        add(right, part).ends_at_corner = false;
      return;
    }
    const Ray ray(w, c);
    const FT doubtful = m_doubtful * ray.depth;
    if(ray.beyond(part.b0) > doubtful && ray.beyond(part.b1) < -doubtful && !is_far(corner, w))
    {
      reach_corner(corner, w);
      pass_on_both_sides(ray.place(), part, left, right);
      return;
    }
    const auto is_right_of = [&](const FT& b, const FT& slack)
    { return Predicates::is_right_of(w, c.x, c.y, b, slack); };
    const auto is_left_of = [&](const FT& b, const FT& slack) { return Predicates::is_left_of(w, c.x, c.y, b, slack); };
    // The ends of the part may miss the corner by rounding: what is beyond them may come another way around a corner
    // before, in other frames.
    const FT gap0 = w.largest_gap(part.b0, m_length), gap1 = w.largest_gap(part.b1, m_length);
    if(!is_left_of(part.b0, FT(-gap0)) && !is_right_of(part.b1, gap1))
      reach_corner(corner, w);
    if(!is_left_of(part.b1, FT(-m_place)))
      add(left, part).begins_at_corner = !is_right_of(part.b1, m_place);
    else if(is_right_of(part.b0, m_place))
      pass_on_both_sides((std::min)((std::max)(w.place_of_ray(c.x, c.y), part.b0), part.b1), part, left, right);
    else
      add(right, part).ends_at_corner = !is_left_of(part.b0, FT(-m_place));
  }

  bool is_far(const Corner& c, const W& w) const { return !(absolute(w.linear ? c.place.x : w.x) < m_far); }

  // Divides a part by the ray to the corner, which crosses h at t.
  void pass_on_both_sides(const FT& t, const Part& part, Segment& left, Segment& right)
  {
    Part& to_left = add(left, part);
    to_left.b1 = t;
    to_left.begins_at_corner = true;
    Part& to_right = add(right, part);
    to_right.b0 = t;
    to_right.ends_at_corner = true;
  }

  Part& add(Segment& segment, const Part& part) { return m_parts[segment.end++] = part; }

  // Takes parts through a side of a face: out, or past the next corner if the side is open.
  void go_through(int h, const Vector& begin, const Vector& side, bool is_last, const Segment& parts)
  {
    const int o = m_front.behind(h);
    if(o == -1 || Front::asks_at_open_edges)
      m_exits.push_back(Exit{ h, is_last, begin, side, parts });
    if(o == -1 || is_on_way(Mesh::face(o)))
      return;
    const Mesh& mesh = m_front.mesh();
    const typename Mesh::Apex& a = mesh.apex[o];
    const FT inverse = FT(1) / mesh.length_of(h), ux = side.x * inverse, uy = side.y * inverse;
    // the way from `begin` to the apex behind; o runs backwards
    const Vector right{ a.y * uy - a.back * ux, -a.y * ux - a.back * uy };
    enter(Mesh::face(o));
    pass(Corner{ Vector{ begin.x + right.x, begin.y + right.y }, begin, right,
                 Vector{ side.x - right.x, side.y - right.y }, o, is_last },
         parts);
    go_back();
  }

  // Whether parts have come through a face already: a shortest path goes through each face once.
  bool is_on_way(int face) const
  {
    return BOOST_UNLIKELY(m_marks[slot(face)] != 0) && std::find(m_way.begin(), m_way.end(), face) != m_way.end();
  }

  static std::size_t slot(int face) { return static_cast<std::size_t>(face) % 256; }

  void enter(int face)
  {
    m_way.push_back(face);
    ++m_marks[slot(face)];
  }

  void go_back()
  {
    --m_marks[slot(m_way.back())];
    m_way.pop_back();
  }

  void reach_corner(const Corner& c, const W& w)
  {
    const Mesh& mesh = m_front.mesh();
    const FT bx = w.linear ? w.x : FT(c.place.x - w.x), by = w.linear ? w.y : FT(c.place.y + w.y);
    const FT d =
      w.linear ? FT(w.sigma + c.place.x * bx + c.place.y * by) : FT(w.sigma + square_root(bx * bx + by * by));
    // the angle from the left side to the way back, (-bx, -by)
    const int left = Mesh::prev(c.halfedge);
    m_front.reach(mesh.source(left), d, w.origin, w.error,
                  [&]
                  {
                    return mesh.direction[left] + std::atan2(as_double(FT(c.left_side.y * bx - c.left_side.x * by)),
                                                             as_double(FT(-c.left_side.x * bx - c.left_side.y * by)));
                  });
  }

  void leave(const Exit& exit)
  {
    typename Front::Landing landing = m_front.landing(exit.halfedge);
    if(landing.is_closed)
      return;
    const Vector begin = exit.begin, side = exit.side;
    const FT width = landing.length, inverse = FT(1) / width, ux = side.x * inverse, uy = side.y * inverse;
    // where the ray through a place b of h meets the exit; the formula for the last one is exact at p
    const auto hit = [&](const W& w, const FT& b)
    {
      const FT rise = w.linear ? w.x : FT(b - w.x), d = rise * side.y - w.y * side.x;
      return exit.is_last ? FT(width * (FT(1) - w.y * b / d))
                          : FT(width * (((begin.x - b) * w.y - begin.y * rise) / d));
    };
    const Part* part = &m_parts[landing.is_canonical ? exit.parts.end - 1 : exit.parts.begin];
    const int step = landing.is_canonical ? -1 : 1;
    for(std::size_t n = exit.parts.end - exit.parts.begin; n > 0; --n, part += step)
    {
      const W& w = m_windows[part->window];
      const FT b0 = part->begins_at_corner ? FT(0) : hit(w, part->b1);
      const FT b1 = part->ends_at_corner ? width : hit(w, part->b0);
      W arriving{ b0, b1, w.x, w.y, w.sigma, w.origin, w.linear, true, true, w.error };
      if(w.linear)
      {
        arriving.x = w.x * ux + w.y * uy;
        arriving.y = w.x * uy - w.y * ux;
        arriving.sigma = w.sigma + w.x * begin.x + w.y * begin.y;
      }
      else
      {
        const FT dx = w.x - begin.x, dy = w.y + begin.y;
        arriving.x = dx * ux - dy * uy;
        arriving.y = -dx * uy - dy * ux;
      }
      m_front.arrive(landing, arriving);
    }
    m_front.finish(landing);
  }

  Front& m_front;
  FT m_length, m_place; // of the edge that the windows come from
  FT m_doubtful, m_far; // a ray is clear of a place that is so far away, if its source is not too far for rounding
  const W* m_windows = nullptr;
  std::vector<Part> m_parts;
  std::size_t m_number_of_parts = 0;
  std::vector<Exit> m_exits;
  std::vector<int> m_way;                   // the faces that the parts have come through
  std::array<unsigned char, 256> m_marks{}; // how many of them there are of each number modulo 256: none for most
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FACE_CROSSING_H
