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
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Takes windows from one edge of a face to the two others; where an edge is open, on to the edges behind it. What depends
// on the faces alone is made once for all windows of the edge, and on each edge they arrive in their order.
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
    m_corners.clear();
    m_number_of_exits = 0;
    m_corners.push_back(Corner{ Vector{ apex.x, apex.y }, Vector{ l, FT(0) }, Vector{ apex.back, apex.y }, Vector{ -apex.x, -apex.y },
                                h, true, 0, 0, -1 });
    for(std::size_t k = 0; k < windows.size(); ++k)
      divide(0, windows[k], Part{ static_cast<int>(k), false, false, windows[k].b0, windows[k].b1 });
    for(int i = 0; i < m_number_of_exits; ++i)
      if(mesh.length_of(m_exits[i].halfedge) > FT(0))
        leave(m_exits[i], windows.data());
  }

  // Receives a window that comes through the face of the halfedge, in the frame of the halfedge: on it, or behind it if it is open.
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
  struct Vector { FT x, y; };

  // A part of a window, on its way to an exit.
  struct Part
  {
    int window;
    bool begins_at_corner, ends_at_corner;      // whether its rays at the right, at the left end lead to the end of the exit
    FT b0, b1;
  };

  // An edge at which windows arrive.
  struct Exit
  {
    int halfedge;
    bool is_last;                // whether it ends at p
    Vector begin, side;          // from where, and how far it runs
    std::vector<Part> parts;
  };

  // The apex of a face, and what is behind the two sides of the face: another corner, ~i for the i-th exit, or 0 if
  // nothing has been there yet.
  struct Corner
  {
    Vector place;
    Vector begin;                // where the right side begins
    Vector right_side, left_side;
    int halfedge;                // through which its face is entered
    bool is_last;                // whether its face contains p
    int right, left;
    int entry;                   // the exit that is the edge by which its face is entered, -1 if nobody asks
  };

  int behind_right_side(int corner)
  {
    if(m_corners[corner].right == 0)
    {
      const Corner c = m_corners[corner];
      const int n = behind_side(Mesh::next(c.halfedge), c.begin, c.right_side, false);
      m_corners[corner].right = n;
    }
    return m_corners[corner].right;
  }

  int behind_left_side(int corner)
  {
    if(m_corners[corner].left == 0)
    {
      const Corner c = m_corners[corner];
      const int n = behind_side(Mesh::prev(c.halfedge), c.place, c.left_side, c.is_last);
      m_corners[corner].left = n;
    }
    return m_corners[corner].left;
  }

  int behind_side(int h, const Vector& begin, const Vector& side, bool is_last)
  {
    const int o = m_front.behind(h);
    if(o == -1)
      return ~add_exit(h, begin, side, is_last);
    const int entry = Front::asks_at_open_edges ? add_exit(h, begin, side, is_last) : -1;
    const Mesh& mesh = m_front.mesh();
    const typename Mesh::Apex& a = mesh.apex[o];
    const FT inverse = FT(1) / mesh.length_of(h), ux = side.x * inverse, uy = side.y * inverse;
    // the way from `begin` to the apex behind; o runs backwards
    const Vector right{ a.y * uy - a.back * ux, -a.y * ux - a.back * uy };
    m_corners.push_back(Corner{ Vector{ begin.x + right.x, begin.y + right.y }, begin, right,
                                Vector{ side.x - right.x, side.y - right.y }, o, is_last, 0, 0, entry });
    return static_cast<int>(m_corners.size()) - 1;
  }

  int add_exit(int h, const Vector& begin, const Vector& side, bool is_last)
  {
    if(static_cast<int>(m_exits.size()) == m_number_of_exits)
      m_exits.emplace_back();
    Exit& e = m_exits[m_number_of_exits];
    e.halfedge = h;
    e.is_last = is_last;
    e.begin = begin;
    e.side = side;
    e.parts.clear();
    return m_number_of_exits++;
  }

  // Divides a part of a window, which is to pass a corner, or to leave if `node` is an exit.
  void divide(int node, const W& w, Part part)
  {
    while(node >= 0)
    {
      if(Front::asks_at_open_edges && m_corners[node].entry != -1)
        m_exits[m_corners[node].entry].parts.push_back(part);
      const Vector c = m_corners[node].place;
      // The ray to the corner crosses h at origin + across / depth. Where that is far enough from the ends of the part, rounding does not matter.
      const FT origin = w.linear ? FT(0) : w.x;
      const FT across = w.linear ? FT(c.x * w.y - c.y * w.x) : FT((c.x - w.x) * w.y), depth = w.linear ? w.y : FT(c.y + w.y);
      if(! (c.y < FT(0)) && absolute(w.linear ? c.x : w.x) < m_far)
      {
        const FT doubtful = m_doubtful * depth, from_b0 = across - (part.b0 - origin) * depth, to_b1 = (part.b1 - origin) * depth - across;
        if(from_b0 > doubtful)
        {
          if(to_b1 > doubtful)
          {
            reach_corner(m_corners[node], w);
            pass_on_both_sides(node, w, part, FT(origin + across / depth));
            continue;
          }
          if(to_b1 < -doubtful)
          {
            part.begins_at_corner = false;
            node = behind_left_side(node);
            continue;
          }
        }
        else if(from_b0 < -doubtful)
        {
          part.ends_at_corner = false;
          node = behind_right_side(node);
          continue;
        }
      }
      pass_nearby(node, w, part);
    }
    m_exits[~node].parts.push_back(part);
  }

  // Sends the part on the left of the ray to the corner, which crosses h at t, on. What is on the right remains.
  BOOST_FORCEINLINE void pass_on_both_sides(int& node, const W& w, Part& part, const FT& t)
  {
    Part left = part;
    left.b1 = t;
    left.begins_at_corner = true;
    divide(behind_left_side(node), w, left);
    part.b0 = t;
    part.ends_at_corner = true;
    node = behind_right_side(node);
  }

  // The same for a corner that may lie on the ray through an end of the part: predicates decide.
  BOOST_NOINLINE void pass_nearby(int& node, const W& w, Part& part)
  {
    const Vector c = m_corners[node].place;
    if(c.y < FT(0))
    {
      // The corner lies behind h, so it is beyond an end, and all rays of the part are on one side of it.
      const bool goes_left = Predicates::is_right_of_ray(w, c.x, c.y, FT((part.b0 + part.b1) / FT(2)));
      (goes_left ? part.begins_at_corner : part.ends_at_corner) = false;
      node = goes_left ? behind_left_side(node) : behind_right_side(node);
      return;
    }
    const auto is_right_of = [&](const FT& b, const FT& slack) { return Predicates::is_right_of(w, c.x, c.y, b, slack); };
    const auto is_left_of = [&](const FT& b, const FT& slack) { return Predicates::is_left_of(w, c.x, c.y, b, slack); };
    // the ends of the window may miss the corner by a gap
    const FT gap0 = part.b0 == w.b0 ? w.largest_gap(w.b0, m_length) : FT(0), gap1 = part.b1 == w.b1 ? w.largest_gap(w.b1, m_length) : FT(0);
    if(! is_left_of(part.b0, FT(-gap0)) && ! is_right_of(part.b1, gap1))
      reach_corner(m_corners[node], w);
    if(! is_left_of(part.b1, FT(-m_place)))
    {
      part.begins_at_corner = ! is_right_of(part.b1, m_place);
      node = behind_left_side(node);
    }
    else if(is_right_of(part.b0, m_place))
      pass_on_both_sides(node, w, part, (std::min)((std::max)(w.place_of_ray(c.x, c.y), part.b0), part.b1));
    else
    {
      part.ends_at_corner = ! is_left_of(part.b0, FT(-m_place));
      node = behind_right_side(node);
    }
  }

  void reach_corner(const Corner& c, const W& w)
  {
    const Mesh& mesh = m_front.mesh();
    const FT bx = w.linear ? w.x : FT(c.place.x - w.x), by = w.linear ? w.y : FT(c.place.y + w.y);
    const FT d = w.linear ? FT(w.sigma + c.place.x * bx + c.place.y * by) : FT(w.sigma + square_root(bx * bx + by * by));
    // the angle from the left side to the way back, (-bx, -by)
    const int left = Mesh::prev(c.halfedge);
    m_front.reach(mesh.source(left), d, w.origin, w.error, [&]
    {
      return mesh.direction[left] + std::atan2(as_double(FT(c.left_side.y * bx - c.left_side.x * by)),
                                               as_double(FT(-c.left_side.x * bx - c.left_side.y * by)));
    });
  }

  void leave(const Exit& exit, const W* windows)
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
      return exit.is_last ? FT(width * (FT(1) - w.y * b / d)) : FT(width * (((begin.x - b) * w.y - begin.y * rise) / d));
    };
    const Part* part = exit.parts.data();
    int step = 1;
    if(landing.is_canonical)
    {
      part += exit.parts.size() - 1;
      step = -1;
    }
    for(std::size_t n = exit.parts.size(); n > 0; --n, part += step)
    {
      const W& w = windows[part->window];
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
  FT m_length, m_place;              // of the edge that the windows come from
  FT m_doubtful, m_far;              // a ray is clear of a place that is so far away, if its source is not too far for rounding
  std::vector<Corner> m_corners;
  std::vector<Exit> m_exits;
  int m_number_of_exits = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FACE_CROSSING_H
