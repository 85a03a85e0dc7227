// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_INDEXED_TRIANGLE_MESH_H
#define CGAL_QUAD_MESHING_INTERNAL_INDEXED_TRIANGLE_MESH_H

#include <CGAL/Quad_meshing/internal/element_numbers.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A read-only triangle mesh in flat arrays, the working form of the numerical stages.
//
// Faces, vertices and edges are numbered in the order in which the graph enumerates them.
// Halfedge 3*f+k runs from corner k to corner k+1 of face f, and halfedge 3*f is the image of
// `halfedge(f, tm)`: it is the reference direction of the face. Border halfedges are not stored;
// `opposite` is -1 where a halfedge lies on the border.
struct Indexed_triangle_mesh
{
  typedef Simple_cartesian<double>::Point_3 Point_3;
  typedef Simple_cartesian<double>::Vector_3 Vector_3;

  std::vector<Point_3> points;             // per vertex
  std::vector<std::array<int, 3>> corners; // per face: its vertices
  std::vector<int> opposite;               // per halfedge: the opposite one, -1 on the border
  std::vector<int> edge_of;                // per halfedge: its edge
  std::vector<int> halfedge_of_edge;       // per edge: the image of `halfedge(e, tm)`, or of its
                                           // opposite where that lies on the border
  std::vector<int> halfedge_of_vertex;     // per vertex: one that leaves it (on the border: the
                                           // one such that turning clockwise leaves the mesh),
                                           // -1 if the vertex is isolated
  int non_manifold_vertex = -1;            // one around which the faces form several fans, of which
                                           // `halfedge_of_vertex` knows one; -1 if there is none

  int number_of_vertices() const { return static_cast<int>(points.size()); }
  int number_of_faces() const { return static_cast<int>(corners.size()); }
  int number_of_halfedges() const { return static_cast<int>(opposite.size()); }
  int number_of_edges() const { return static_cast<int>(halfedge_of_edge.size()); }

  static int face(int h) { return h / 3; }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int prev(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

  int source(int h) const { return corners[h / 3][h % 3]; }
  int target(int h) const { return corners[h / 3][(h % 3 + 1) % 3]; }
  bool is_border_edge(int e) const { return opposite[halfedge_of_edge[e]] == -1; }

  // The next halfedge counterclockwise around the source of h; -1 behind the last face of a border vertex.
  int next_around_source(int h) const { return opposite[prev(h)]; }

  // The next halfedge clockwise around the source of h; -1 before the first face of a border vertex.
  int previous_around_source(int h) const { return opposite[h] == -1 ? -1 : next(opposite[h]); }

  Vector_3 vector(int h) const { return points[target(h)] - points[source(h)]; }
};

// Calls f(h) for the halfedges that leave a vertex, one per corner, counterclockwise.
template <typename Function>
void for_each_corner_of_vertex(const Indexed_triangle_mesh& m, int v, const Function& f)
{
  const int start = m.halfedge_of_vertex[v];
  if(start == -1)
    return;
  int h = start;
  do
  {
    f(h);
    h = m.next_around_source(h);
  }
  while(h != -1 && h != start);
}

inline bool is_finite(const Indexed_triangle_mesh::Point_3& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

// The first vertex around which the faces form more than one fan, -1 if there is none: where two border loops touch,
// for instance.
inline int find_non_manifold_vertex(const Indexed_triangle_mesh& m)
{
  std::vector<int> corners(m.number_of_vertices(), 0);
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    ++corners[m.source(h)];
  for(int v = 0; v < m.number_of_vertices(); ++v)
  {
    for_each_corner_of_vertex(m, v, [&](int) { --corners[v]; });
    if(corners[v] != 0)
      return v;
  }
  return -1;
}

// What the result of a stage says about it.
inline std::string non_manifold_message(const Indexed_triangle_mesh& m)
{
  return "The faces around vertex " + std::to_string(m.non_manifold_vertex) + " form more than one fan.";
}

// Numbers a vertex for each fan of faces, so that all vertices are manifold: one fan keeps the vertex, the others get
// new ones, behind all others.
inline void split_non_manifold_vertices(Indexed_triangle_mesh& m)
{
  if(m.non_manifold_vertex == -1)
    return;
  std::vector<bool> has_fan(m.number_of_vertices(), false), seen(m.number_of_halfedges(), false);
  for(int seed = 0; seed < m.number_of_halfedges(); ++seed)
  {
    if(seen[seed])
      continue;
    int first = seed; // the clockwise end of the fan, any of its halfedges if it is closed
    while(m.opposite[first] != -1)
    {
      first = m.previous_around_source(first);
      if(first == seed)
        break;
    }
    int v = m.source(seed);
    if(has_fan[v])
    {
      v = m.number_of_vertices();
      m.points.push_back(m.points[m.source(seed)]);
      m.halfedge_of_vertex.push_back(first);
      has_fan.push_back(true);
    }
    has_fan[v] = true;
    m.halfedge_of_vertex[v] = first;
    int h = first;
    do
    {
      seen[h] = true;
      m.corners[h / 3][h % 3] = v;
      h = m.next_around_source(h);
    }
    while(h != -1 && h != first);
  }
  m.non_manifold_vertex = -1;
}

// Copies a triangle mesh into flat arrays.
//
// `VertexIndexMap` and `FaceIndexMap` give consecutive numbers from 0, as `vertex_numbers()` and `face_numbers()` make
// them. `non_manifold_vertex` tells whether vertices are manifold.
template <typename TriangleMesh, typename VertexPointMap, typename VertexIndexMap, typename FaceIndexMap>
Indexed_triangle_mesh make_indexed_triangle_mesh(const TriangleMesh& tm, VertexPointMap vpm, VertexIndexMap vim,
                                                 FaceIndexMap fim)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

  Indexed_triangle_mesh m;

  m.points.resize(vertices(tm).size());
  std::size_t nv = 0;
  for(auto v : vertices(tm))
  {
    const auto& p = get(vpm, v);
    m.points[get(vim, v)] = Indexed_triangle_mesh::Point_3(to_double(p.x()), to_double(p.y()), to_double(p.z()));
    ++nv;
  }
  m.points.resize(nv);

  m.corners.resize(faces(tm).size());
  std::size_t nf = 0;
  for(auto f : faces(tm))
  {
    const halfedge_descriptor h = halfedge(f, tm);
    m.corners[get(fim, f)] = { { static_cast<int>(get(vim, source(h, tm))), static_cast<int>(get(vim, target(h, tm))),
                                 static_cast<int>(get(vim, target(next(h, tm), tm))) } };
    ++nf;
  }
  m.corners.resize(nf);

  auto index = [&](halfedge_descriptor h) -> int
  {
    if(is_border(h, tm))
      return -1;
    const halfedge_descriptor r = halfedge(face(h, tm), tm);
    const int k = (h == r) ? 0 : (h == next(r, tm)) ? 1 : 2;
    return 3 * static_cast<int>(get(fim, face(h, tm))) + k;
  };

  m.opposite.assign(3 * nf, -1);
  m.edge_of.assign(3 * nf, -1);
  for_each_edge_of_faces(tm,
                         [&](auto e, int id)
                         {
                           const int h = index(halfedge(e, tm)), o = index(opposite(halfedge(e, tm), tm));
                           m.halfedge_of_edge.push_back(h != -1 ? h : o);
                           if(h != -1)
                           {
                             m.opposite[h] = o;
                             m.edge_of[h] = id;
                           }
                           if(o != -1)
                           {
                             m.opposite[o] = h;
                             m.edge_of[o] = id;
                           }
                         });

  m.halfedge_of_vertex.assign(nv, -1);
  for(int h = 0; h < m.number_of_halfedges(); ++h)
  {
    int& first = m.halfedge_of_vertex[m.source(h)];
    if(first == -1 || m.opposite[h] == -1)
      first = h;
  }
  m.non_manifold_vertex = find_non_manifold_vertex(m);
  return m;
}

// The same with the points and numbers that the named parameters give, or those of the mesh.
template <typename TriangleMesh, typename NamedParameters>
Indexed_triangle_mesh make_indexed_triangle_mesh(const TriangleMesh& tm, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  return make_indexed_triangle_mesh(
    tm, choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tm)),
    vertex_numbers(tm, np), face_numbers(tm, np));
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_INDEXED_TRIANGLE_MESH_H
