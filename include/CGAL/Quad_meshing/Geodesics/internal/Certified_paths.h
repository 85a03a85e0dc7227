// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_PATHS_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_PATHS_H

#include <CGAL/Quad_meshing/Geodesics/internal/Certified_face.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_queries.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_sources.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_propagation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Proves upper bounds of the distances of vertices: the lengths of paths that are there. A path goes from vertex to
// vertex and over edges at given parts of them; whether it is a shortest one does not matter to the proof.
class Certified_paths
{
public:
  typedef Unfolded_mesh<double> Mesh;
  typedef Window_propagation<double> Propagation;
  typedef Field_sources<double> Sources;
  typedef Field_queries<double> Queries;
  typedef Arrival<double> A;
  typedef Window<double> W;

  Certified_paths(const Mesh& mesh, const Propagation& propagation, const Sources& sources)
    : m_mesh(mesh)
    , m_propagation(propagation)
    , m_sources(sources)
    , m_queries(mesh, propagation, sources)
    , m_upper(mesh.number_of_vertices(), infinity())
  {
  }

  // A bound for each vertex, infinity for those that are not reached. `go_on` is asked now and then, with the part that
  // is done.
  template <typename GoOn>
  const std::vector<double>& operator()(const GoOn& go_on)
  {
    // in the order of the distances, so that a path can end at a vertex that has its bound
    std::vector<int> order;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_propagation.is_reached(v))
        order.push_back(v);
    std::sort(order.begin(), order.end(),
              [&](int v, int w)
              {
                const double d = m_propagation.label(v).distance, e = m_propagation.label(w).distance;
                return d != e ? d < e : v < w;
              });
    for(std::size_t i = 0; i < order.size(); ++i)
    {
      if(i % 1024 == 0 && !go_on(static_cast<double>(i) / static_cast<double>(order.size())))
        break;
      const int v = order[i], origin = m_propagation.label(v).origin;
      if(origin < 0 && vertex_of(origin) == v)
        m_upper[v] = m_sources.elements()[~origin].offset;
      else
      {
        double shortest = infinity();
        for(Manner manner : { STRAIGHT, STRAIGHT_TO_ORIGIN, STEP_BY_STEP })
          if(!(shortest <= m_propagation.label(v).distance * (1 + 1e-12)))
            shortest = (std::min)(shortest, length_of_path(v, manner));
        m_upper[v] = shortest;
      }
    }
    return m_upper;
  }

private:
  static double infinity() { return std::numeric_limits<double>::infinity(); }
  static constexpr double rounding() { return 0x1p-48; }

  // A vertex, or if that is -1 the place at a part of a halfedge.
  struct Place
  {
    int vertex, halfedge;
    double part;
  };

  // The vertex of a pseudo-source, -1 if it is none.
  int vertex_of(int origin) const
  {
    if(origin >= 0)
      return origin;
    const Source_element<double>& e = m_sources.elements()[~origin];
    return !e.is_segment && e.from.carrier == Surface_point<double>::VERTEX ? e.from.simplex : -1;
  }

  // How windows are followed: straight to their pseudo-sources, beginning with the nearest one or, as rounding may
  // prefer another one that the vertex hardly misses, with the one that has reached the vertex; or by asking the field
  // again in each face.
  enum Manner
  {
    STRAIGHT,
    STRAIGHT_TO_ORIGIN,
    STEP_BY_STEP
  };

  // An upper bound of the length of a path from a vertex to a source or to a vertex with a bound.
  double length_of_path(int v, Manner manner) const
  {
    double sum = 0;
    int face = 0, from = 0;
    Place here{ v, 0, 0. };
    // as many steps as a shortest path can have
    for(int i = 0; i <= 2 * m_mesh.number_of_faces() + 2; ++i)
    {
      if(here.vertex != -1 && m_upper[here.vertex] < infinity())
        return added(sum, m_upper[here.vertex]);
      A a = A();
      if(here.vertex != -1)
        a = m_queries.arrival_at_vertex(here.vertex, face, manner == STRAIGHT_TO_ORIGIN);
      else
      {
        const Surface_point<double> point{ Surface_point<double>::EDGE, from, here.part * m_mesh.length_of(from), 0. };
        const auto p = place_in_face(m_mesh, face, point);
        a = m_queries.arrival(face, p.first, p.second, -1, from);
      }
      if(a.kind == A::NOWHERE)
        return infinity();
      if(a.kind == A::FROM_ELEMENT)
        return added(sum, way_to_element(face, here, m_sources.elements()[a.simplex], a));
      if(a.kind == A::FROM_VERTEX)
      {
        const Place next{ a.simplex, 0, 0. };
        sum = added(sum, way(face, here, next));
        here = next;
        continue;
      }
      Place next = on_edge(a.simplex, a.place);
      sum = added(sum, way(face, here, next));
      if(next.vertex == -1 && manner != STEP_BY_STEP)
        sum = added(sum, go_straight(a, next));
      here = next;
      if(here.vertex == -1)
      {
        from = m_mesh.opposite[here.halfedge];
        here = Place{ -1, from, 1 - here.part };
        face = m_mesh.face(from);
      }
    }
    return infinity();
  }

  Place on_edge(int h, double t) const
  {
    const double length = m_mesh.length_of(h), slack = Window_tolerances<double>::place() * length;
    if(t <= slack || length - t <= slack)
      return Place{ t <= slack ? m_mesh.source(h) : m_mesh.target(h), 0, 0. };
    return Place{ -1, h, t / length };
  }

  // From the place `here` straight on to the pseudo-source of the window by which one came to it, from face to face.
  // Stops at the pseudo-source, or where it cannot go on, at the last place before.
  double go_straight(const A& a, Place& here) const
  {
    const int goal = vertex_of(a.origin);
    W w = W();
    if(goal == -1 || !find_window(a, w))
      return 0;
    double sum = 0, x = w.x, y = w.y;
    int h = here.halfedge;
    for(int i = 0; i <= m_mesh.number_of_faces(); ++i)
    {
      // into the next face, seen from its own halfedge
      const int o = m_mesh.opposite[h];
      const double l = m_mesh.length_of(o), t = (1 - here.part) * l;
      x = l - x;
      const typename Mesh::Apex& apex = m_mesh.apex[o];
      const Place start{ -1, o, 1 - here.part };
      if(m_mesh.target(Mesh::next(o)) == goal)
      {
        const double near = 1e-6 * (l + apex.y);
        if(std::fabs(x - apex.x) + std::fabs(y - apex.y) <= near)
        {
          here = Place{ goal, 0, 0. };
          return added(sum, way(m_mesh.face(o), start, here));
        }
      }
      // left or right of the opposite corner, and which part of the edge
      const double dx = x - t, dy = y, side = dx * apex.y - dy * (apex.x - t);
      double s;
      int exit;
      if(side > 0)
      {
        exit = Mesh::next(o);
        s = dy * (l - t) / (dx * apex.y - dy * apex.back);
        to_next_frame(m_mesh, o, x, y);
      }
      else
      {
        exit = Mesh::prev(o);
        s = 1 - dy * t / (dy * apex.x - dx * apex.y);
        to_next_frame(m_mesh, o, x, y);
        to_next_frame(m_mesh, Mesh::next(o), x, y);
      }
      y = -y;
      if(!(y > 0) || !(s > 0 && s < 1) || m_mesh.length_of(exit) == 0 || m_mesh.opposite[exit] == -1)
        return sum;
      here = Place{ -1, exit, s };
      sum = added(sum, way(m_mesh.face(o), start, here));
      h = exit;
    }
    return sum;
  }

  // The window through which a point is reached, in the frame of the halfedge.
  bool find_window(const A& a, W& found) const
  {
    const int h = a.simplex;
    const bool is_canonical = m_mesh.is_canonical(h);
    double nearest = infinity();
    for(W w : m_propagation.windows(m_mesh.edge_of[h]))
    {
      if(w.origin != a.origin || w.linear || w.from_left == is_canonical || !(w.y > 0))
        continue;
      if(!is_canonical)
        w.reverse(m_mesh.length_of(h));
      const double miss = (std::max)({ 0., w.b0 - a.place, a.place - w.b1 });
      if(miss < nearest)
      {
        nearest = miss;
        found = w;
      }
    }
    return nearest < infinity();
  }

  // Upper bounds of a sum and of the distance of two places of a face.
  static double added(double a, double b) { return (a + b) * (1 + rounding()); }

  double way(int face, const Place& a, const Place& b) const
  {
    const auto d = place(face, a) - place(face, b);
    return (std::sqrt(d * d) + rounding() * (m_mesh.length_of(3 * face) + m_mesh.length_of(3 * face + 1) +
                                             m_mesh.length_of(3 * face + 2))) *
           (1 + rounding());
  }

  // The vector from the first corner of the face.
  Mesh::Vector_3 place(int face, const Place& p) const
  {
    const auto& origin = m_mesh.points[m_mesh.corners[face][0]];
    if(p.vertex != -1)
      return m_mesh.points[p.vertex] - origin;
    return (m_mesh.points[m_mesh.source(p.halfedge)] - origin) + p.part * m_mesh.vector(p.halfedge);
  }

  double way_to_element(int face, const Place& here, const Source_element<double>& e, const A& a) const
  {
    typedef Certified_number Number;
    typedef Surface_point<double> Point;
    const Certified_face shape(m_mesh, face);
    if(shape.is_point(0))
      return infinity();
    const Certified_face::Place p =
      here.vertex != -1 ? certified_place(m_mesh, face, shape, Point{ Point::VERTEX, here.vertex, 0., 0. })
                        : shape.along(here.halfedge % 3, here.part);
    Certified_face::Place q = certified_place(m_mesh, face, shape, e.from);
    if(e.is_segment)
    {
      // any part of it will do
      const Certified_face::Place r = certified_place(m_mesh, face, shape, e.to);
      const Number vx = r.first - q.first, vy = r.second - q.second;
      const double square = (vx * vx + vy * vy).high();
      const double s = ((a.x - q.first.high()) * vx.high() + (a.y - q.second.high()) * vy.high()) / square;
      const Number part((std::min)((std::max)(s, 0.), 1.));
      q = Certified_face::Place(q.first + part * vx, q.second + part * vy);
    }
    const Number dx = p.first - q.first, dy = p.second - q.second;
    return (Number(e.offset) + sqrt(dx * dx + dy * dy)).upper();
  }

  const Mesh& m_mesh;
  const Propagation& m_propagation;
  const Sources& m_sources;
  Queries m_queries;
  std::vector<double> m_upper;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_PATHS_H
