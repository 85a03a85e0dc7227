// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_TEST_FIELDS_CHECKS_H
#define CGAL_QUAD_MESHING_TEST_FIELDS_CHECKS_H

// Checks of cross fields that share no code with the package: everything is measured from the points,
// by unfolding pairs of triangles into the plane.

#include "test_meshes.h"

#include <CGAL/Quad_meshing/Fields/cross_field.h>

#include <CGAL/Surface_mesh.h>

#include <cassert>
#include <cmath>
#include <vector>

namespace fields_checks {

typedef test_meshes::Mesh Mesh;
typedef Mesh::Face_index Face;
typedef Mesh::Edge_index Edge;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Vertex_index Vertex;

// A mesh with all that a cross field needs.
struct Field
{
  Mesh tm;
  Mesh::Property_map<Face, double> angle;
  Mesh::Property_map<Edge, int> jump;
  Mesh::Property_map<Vertex, int> index;
  Mesh::Property_map<Edge, bool> feature;

  explicit Field(const test_meshes::Soup& soup) : tm(test_meshes::make_mesh(soup))
  {
    angle = tm.add_property_map<Face, double>("f:angle", 0.).first;
    jump = tm.add_property_map<Edge, int>("e:jump", 0).first;
    index = tm.add_property_map<Vertex, int>("v:index", 0).first;
    feature = tm.add_property_map<Edge, bool>("e:feature", false).first;
  }
};

inline double reduced(double a, double period) { return a - period * std::round(a / period); }

// The interior angle at the source of h.
inline double corner(const Mesh& tm, Halfedge h)
{
  const auto& p = tm.point(tm.source(h));
  const auto a = tm.point(tm.target(h)) - p, b = tm.point(tm.source(tm.prev(h))) - p;
  return std::acos(std::max(-1., std::min(1., (a * b) / std::sqrt(a.squared_length() * b.squared_length()))));
}

// The angle of the vector of h in the frame of its face: the turns on the way from the reference halfedge.
inline double in_frame(const Mesh& tm, Halfedge h)
{
  double a = 0;
  for(Halfedge g = tm.halfedge(tm.face(h)); g != h; g = tm.next(g))
    a += test_meshes::pi - corner(tm, tm.next(g));
  return a;
}

// The angle difference across an edge, from the face of h to the opposite one, up to whole turns of
// the frames (which the period jump has to match).
inline double difference(const Field& f, Halfedge h)
{
  const Halfedge o = f.tm.opposite(h);
  double kappa = reduced(in_frame(f.tm, o) + test_meshes::pi - in_frame(f.tm, h), 2 * test_meshes::pi);
  if(kappa < -test_meshes::pi + 1e-8)
    kappa += 2 * test_meshes::pi;
  return f.angle[f.tm.face(h)] + kappa + test_meshes::pi / 2 * f.jump[f.tm.edge(h)] - f.angle[f.tm.face(o)];
}

// The weight of an edge on the surface: its length over the distance of the centroids beside it, one between
// equilateral triangles.
inline double surface_weight(const Field& f, Edge e)
{
  const double greatest = 10, least = 0.1;
  double areas = 0; // twice
  for(Halfedge h : { f.tm.halfedge(e), f.tm.opposite(f.tm.halfedge(e)) })
  {
    const auto& p = f.tm.point(f.tm.source(h));
    areas += std::sqrt(
      CGAL::cross_product(f.tm.point(f.tm.target(h)) - p, f.tm.point(f.tm.source(f.tm.prev(h))) - p).squared_length());
  }
  const auto v = f.tm.point(f.tm.vertex(e, 0)) - f.tm.point(f.tm.vertex(e, 1));
  const double weight = std::sqrt(3.) * v.squared_length() / areas;
  return !(weight < greatest) ? greatest : std::max(least, weight);
}

inline double energy(const Field& f, bool has_surface_weights = false)
{
  double sum = 0;
  for(Edge e : f.tm.edges())
    if(!f.tm.is_border(e))
      sum += (has_surface_weights ? surface_weight(f, e) : 1) * std::pow(difference(f, f.tm.halfedge(e)), 2);
  return sum;
}

// The right angles between the sides of the fan that starts at h (and goes all around unless the
// border ends it), as seen from the field.
inline double quads_of_fan(const Field& f, Halfedge first)
{
  double turn = 0;
  Halfedge h = first;
  do
  {
    turn += corner(f.tm, h);
    const Halfedge crossed = f.tm.prev(h);
    h = f.tm.opposite(crossed);
    if(f.tm.is_border(h))
      break;
    // Edges know only one of their two orientations by themselves.
    const Halfedge stored(2 * (static_cast<Mesh::size_type>(crossed) / 2));
    turn += crossed == stored ? difference(f, stored) : -difference(f, stored);
  }
  while(h != first);
  return turn / (test_meshes::pi / 2);
}

inline int euler_number(const Mesh& tm)
{
  return static_cast<int>(tm.number_of_vertices()) - static_cast<int>(tm.number_of_edges()) +
         static_cast<int>(tm.number_of_faces());
}

// Everything that holds for the result on any mesh without faces of zero area, if borders are aligned.
inline void check(const Field& f, const CGAL::Quad_meshing::Cross_field_result& result)
{
  assert(result.is_valid());
  // Fields for quads have surface weights, and so has that of REPRESENTATION.
  const double tolerance = 1e-6 * (1 + result.energy);
  assert(std::abs(energy(f) - result.energy) < tolerance || std::abs(energy(f, true) - result.energy) < tolerance);

  int sum = 0, singularities = 0;
  for(Vertex v : f.tm.vertices())
  {
    sum += f.index[v];
    singularities += f.index[v] != 0;
    Halfedge h = f.tm.opposite(f.tm.halfedge(v)); // leaves v
    const bool border = f.tm.is_border(v);
    if(border)
    {
      // The fan starts behind the border: turn clockwise as far as possible.
      if(f.tm.is_border(h))
        h = f.tm.next(f.tm.opposite(h));
      while(!f.tm.is_border(f.tm.opposite(h)))
        h = f.tm.next(f.tm.opposite(h));
    }
    assert(std::abs(quads_of_fan(f, h) - ((border ? 2 : 4) - f.index[v])) < 1e-5);
  }
  assert(sum == 4 * euler_number(f.tm));
  assert(sum == result.index_sum);
  assert(singularities == result.singularities);

  for(Edge e : f.tm.edges())
    if(f.feature[e] || f.tm.is_border(e))
      for(Halfedge h : { f.tm.halfedge(e), f.tm.opposite(f.tm.halfedge(e)) })
        if(!f.tm.is_border(h))
          assert(std::abs(reduced(f.angle[f.tm.face(h)] - in_frame(f.tm, h), test_meshes::pi / 2)) < 1e-6);
}

// The number of vertices with a given index.
inline int count(const Field& f, int index)
{
  int n = 0;
  for(Vertex v : f.tm.vertices())
    n += f.index[v] == index;
  return n;
}

} // namespace fields_checks

#endif // CGAL_QUAD_MESHING_TEST_FIELDS_CHECKS_H
