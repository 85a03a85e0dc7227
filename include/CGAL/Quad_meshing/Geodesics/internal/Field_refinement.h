// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_REFINEMENT_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_REFINEMENT_H

#include <CGAL/Quad_meshing/Geodesics/internal/Field_profile.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_queries.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Adaptive refinement of the mesh until the linear interpolation of the distances at its vertices is
// close to the distance along all of its edges (Bommes and Kobbelt 2007).
//
// The field stays as it is: a new vertex lies on an edge or in a face of the input, where the windows
// tell its distance. An edge is split where its error is largest, which puts vertices on the ridges
// of the distance. A triangle with three split edges becomes four; one with two gets a third.
class Field_refinement
{
public:
  typedef Unfolded_mesh<double> Mesh;
  typedef Surface_point<double> Point;
  typedef Simple_cartesian<double>::Point_3 Point_3;
  typedef CGAL::Surface_mesh<Point_3> Refined;
  typedef Refined::Vertex_index Vertex;
  typedef Refined::Halfedge_index Halfedge;
  typedef Refined::Edge_index Edge;
  typedef Refined::Face_index Face;

  Field_refinement(const Mesh& mesh, const Window_propagation<double>& propagation,
                   const Field_sources<double>& sources)
    : m_mesh(mesh), m_queries(mesh, propagation, sources), m_profile(mesh, propagation, sources)
  {
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      add_vertex(m_refined.add_vertex(mesh.points[v]), Point{ Point::VERTEX, v, 0., 0. },
                 propagation.label(v).distance);
    for(const auto& c : mesh.corners)
      m_refined.add_face(Vertex(c[0]), Vertex(c[1]), Vertex(c[2]));
    for(Face f : m_refined.faces())
      m_input_face.push_back(static_cast<int>(f));
  }

  // Refines until every edge is good to `tolerance` or `maximum_faces` are there. Returns the largest error that is
  // left.
  double refine(double tolerance, std::size_t maximum_faces)
  {
    double worst = evaluate(tolerance);
    m_initial_error = worst;
    while(worst > tolerance && m_refined.number_of_faces() < maximum_faces)
    {
      tag_further_edges();
      split_tagged_edges();
      flip_red_edges();
      worst = evaluate(tolerance);
    }
    return worst;
  }

  double initial_error() const { return m_initial_error; }
  const Refined& mesh() const { return m_refined; }
  double distance(Vertex v) const { return m_distance[v]; }
  int input_face(Face f) const { return m_input_face[f]; }

private:
  void add_vertex(Vertex v, const Point& p, double d)
  {
    CGAL_assertion(m_places.size() == static_cast<std::size_t>(v));
    CGAL_USE(v);
    m_places.push_back(p);
    m_distance.push_back(d);
  }

  int face_beside(Edge e) const
  {
    const Halfedge h = m_refined.halfedge(e);
    return m_input_face[m_refined.is_border(h) ? m_refined.face(m_refined.opposite(h)) : m_refined.face(h)];
  }

  bool is_reached(Vertex v) const { return m_distance[v] < Window_propagation<double>::unreached(); }

  // Measures the edges that are new; returns the largest error of all.
  double evaluate(double tolerance)
  {
    m_error.resize(m_refined.number_of_edges(), -1);
    m_split.resize(m_refined.number_of_edges(), 0);
    double worst = 0;
    for(Edge e : m_refined.edges())
    {
      if(m_error[e] < 0)
      {
        const Vertex p = m_refined.vertex(e, 0), q = m_refined.vertex(e, 1);
        const int f = face_beside(e);
        std::pair<double, double> d(0.5, 0.);
        if(is_reached(p) && is_reached(q))
        {
          const auto a = place_in_face(m_mesh, f, m_places[p]), b = place_in_face(m_mesh, f, m_places[q]);
          d = m_profile.largest_deviation(
            f, a, b, m_distance[p], m_distance[q],
            [&](double t) {
              return m_queries.arrival(f, a.first + t * (b.first - a.first), a.second + t * (b.second - a.second))
                .distance;
            });
        }
        m_error[e] = d.second;
        m_split[e] = d.second > tolerance ? split_position(d.first) : 0;
      }
      worst = (std::max)(worst, m_error[e]);
    }
    return worst;
  }

  // Keeps new vertices away from the old ones. What is a little too close is put such that the optimal
  // place becomes the middle of a new edge.
  static double split_position(double t)
  {
    if(t > 0.5)
      return 1 - split_position(1 - t);
    return t < 0.125 ? 0.25 : t < 0.25 ? 2 * t : t;
  }

  // Tags the third edge where two are tagged, and in flat triangles the longest one where another one is. Without that,
  // new vertices can creep up to an edge forever: the edge is good enough, but the edges from its ends to a point close
  // to it are not.
  void tag_further_edges()
  {
    std::vector<Face> stack(m_refined.faces().begin(), m_refined.faces().end());
    while(!stack.empty())
    {
      const Face f = stack.back();
      const Halfedge h = m_refined.halfedge(f);
      stack.pop_back();
      const Halfedge corners[3] = { h, m_refined.next(h), m_refined.prev(h) };
      int tagged = 0;
      for(Halfedge g : corners)
        tagged += m_split[m_refined.edge(g)] > 0;
      if(tagged == 0 || tagged == 3)
        continue;
      const Halfedge longest = *std::max_element(
        corners, corners + 3, [&](Halfedge a, Halfedge b) { return squared_length(a) < squared_length(b); });
      for(Halfedge g : corners)
        if(m_split[m_refined.edge(g)] == 0 && (tagged == 2 || (g == longest && is_flat(f))))
        {
          m_split[m_refined.edge(g)] = 0.5;
          stack.push_back(f);
          if(!m_refined.is_border(m_refined.opposite(g)))
            stack.push_back(m_refined.face(m_refined.opposite(g)));
        }
    }
  }

  double squared_length(Halfedge h) const
  {
    return squared_distance(m_refined.point(m_refined.source(h)), m_refined.point(m_refined.target(h)));
  }

  // Whether the height over the longest edge, as a part of that edge, is a 16th of what it is in the input.
  bool is_flat(Face f) const
  {
    const Halfedge h = m_refined.halfedge(f);
    const auto& c = m_mesh.corners[m_input_face[f]];
    const double now = squared_height(m_refined.point(m_refined.source(h)), m_refined.point(m_refined.target(h)),
                                      m_refined.point(m_refined.target(m_refined.next(h))));
    return 256 * now < squared_height(m_mesh.points[c[0]], m_mesh.points[c[1]], m_mesh.points[c[2]]);
  }

  // The square of the height over the longest edge, as a part of that edge.
  static double squared_height(const Point_3& p, const Point_3& q, const Point_3& r)
  {
    const double longest = (std::max)({ squared_distance(p, q), squared_distance(q, r), squared_distance(r, p) });
    return longest > 0 ? cross_product(q - p, r - p).squared_length() / (longest * longest) : 0;
  }

  // The point at fraction t of the way from the first to the second vertex of an edge.
  Point between(Edge e, double t) const
  {
    const Point &p = m_places[m_refined.vertex(e, 0)], &q = m_places[m_refined.vertex(e, 1)];
    const int f = face_beside(e);
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      if(Field_sources<double>::lies_on(m_mesh, h, p) && Field_sources<double>::lies_on(m_mesh, h, q))
      {
        const double a = Field_sources<double>::place_on(m_mesh, h, p),
                     b = Field_sources<double>::place_on(m_mesh, h, q);
        return Point{ Point::EDGE, h, a + t * (b - a), 0. };
      }
    const auto a = place_in_face(m_mesh, f, p), b = place_in_face(m_mesh, f, q);
    return Point{ Point::FACE, f, a.first + t * (b.first - a.first), a.second + t * (b.second - a.second) };
  }

  void split_tagged_edges()
  {
    std::vector<Edge> tagged;
    for(Edge e : m_refined.edges())
      if(m_split[e] > 0)
        tagged.push_back(e);
    m_is_red.assign(m_refined.number_of_edges(), false);
    for(Edge e : tagged)
    {
      const double t = m_split[e];
      const Point p = between(e, t);
      const int f = face_beside(e);
      const auto place = place_in_face(m_mesh, f, p);
      const Point_3 a = m_refined.point(m_refined.vertex(e, 0)), b = m_refined.point(m_refined.vertex(e, 1));
      const double d = m_queries.arrival(f, place.first, place.second).distance;

      const Halfedge h = m_refined.halfedge(e);
      const Halfedge g = Euler::split_edge(h, m_refined); // ends at the new vertex, then comes h
      const Vertex v = m_refined.target(g);
      m_refined.point(v) = a + t * (b - a);
      add_vertex(v, p, d);
      forget(e);
      forget(m_refined.edge(g));
      if(!m_refined.is_border(g))
        split_face(g);
      if(!m_refined.is_border(m_refined.opposite(h)))
        split_face(m_refined.opposite(h));
    }
  }

  // Connects the target of h with the corner after the next one.
  void split_face(Halfedge h)
  {
    const int input_face = m_input_face[m_refined.face(h)];
    const Halfedge n = Euler::split_face(h, m_refined.next(m_refined.next(h)), m_refined);
    m_input_face.resize(m_refined.number_of_faces(), input_face);
    const Edge e = m_refined.edge(n);
    forget(e);
    m_is_red[e] = true;
  }

  // An edge must be measured again.
  void forget(Edge e)
  {
    const std::size_t n = (std::max)(m_error.size(), static_cast<std::size_t>(e) + 1);
    m_error.resize(n, -1);
    m_split.resize(n, 0);
    m_is_red.resize(n, false);
    m_error[e] = -1;
    m_split[e] = 0;
  }

  int number_of_red_edges(Face f) const
  {
    int n = 0;
    for(Halfedge h : m_refined.halfedges_around_face(m_refined.halfedge(f)))
      n += m_is_red[m_refined.edge(h)];
    return n;
  }

  // The four triangles of a triangle with three split edges share a vertex; one flip makes them similar to it.
  void flip_red_edges()
  {
    std::vector<Edge> flips;
    for(Edge e : m_refined.edges())
    {
      const Halfedge h = m_refined.halfedge(e);
      if(m_is_red[e] && number_of_red_edges(m_refined.face(h)) == 2 &&
         number_of_red_edges(m_refined.face(m_refined.opposite(h))) == 2)
        flips.push_back(e);
    }
    for(Edge e : flips)
    {
      Euler::flip_edge(m_refined.halfedge(e), m_refined);
      forget(e);
    }
  }

  const Mesh& m_mesh;
  Field_queries<double> m_queries;
  Field_profile m_profile;
  Refined m_refined;
  double m_initial_error = 0;
  std::vector<Point> m_places;    // per vertex: its place on the input
  std::vector<double> m_distance; // per vertex
  std::vector<int> m_input_face;  // per face
  std::vector<double> m_error;    // per edge: the interpolation error, negative if unknown
  std::vector<double> m_split;    // per edge: where to split it, 0 if it stays
  std::vector<bool> m_is_red;     // per edge: whether it was made inside a triangle in this round
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_REFINEMENT_H
