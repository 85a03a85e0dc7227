// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_INDEXED_QUAD_MESH_H
#define CGAL_QUAD_MESHING_INTERNAL_INDEXED_QUAD_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A pure quad mesh in flat arrays, the working form of the structure algorithms.
//
// Halfedge 4*f+k runs from corner k to corner k+1 of face f, faces are counterclockwise, and
// `opposite` is -1 on the border. The halfedge h also stands for the directed dual edge "in the
// face of h, heading across the edge of h". The side of the face opposite to h is h^2, so the dual
// line goes on with `opposite[h]^2`, and a turn to the left in the face leads to next(h).
struct Indexed_quad_mesh
{
  typedef Simple_cartesian<double>::Point_3 Point_3;
  typedef Simple_cartesian<double>::Vector_3 Vector_3;

  std::vector<Point_3> points;             // per vertex
  std::vector<std::array<int, 4>> corners; // per face: its vertices
  std::vector<int> opposite;               // per halfedge: the opposite one, -1 on the border
  std::vector<char> is_feature;            // per halfedge: its edge is constrained
  std::vector<int> halfedge_of_vertex;     // per vertex: one that leaves it (on the border: the
                                           // one such that turning clockwise leaves the mesh),
                                           // -1 if the vertex is isolated

  int number_of_vertices() const { return static_cast<int>(points.size()); }
  int number_of_faces() const { return static_cast<int>(corners.size()); }
  int number_of_halfedges() const { return static_cast<int>(opposite.size()); }

  static int face(int h) { return h / 4; }
  static int next(int h) { return (h & 3) == 3 ? h - 3 : h + 1; }
  static int prev(int h) { return (h & 3) == 0 ? h + 3 : h - 1; }
  static int across(int h) { return h ^ 2; }

  int source(int h) const { return corners[h / 4][h & 3]; }
  int target(int h) const { return corners[h / 4][(h + 1) & 3]; }
  bool is_border(int h) const { return opposite[h] == -1; }

  // The halfedge that represents the edge of h.
  int edge(int h) const { return std::max(h, opposite[h]); }

  // The directed dual edge that follows h on its dual line, -1 behind the border.
  int forward(int h) const { return opposite[h] == -1 ? -1 : across(opposite[h]); }

  // Turning around the source of h; -1 outside the mesh.
  int next_around_source(int h) const { return opposite[prev(h)]; }
  int previous_around_source(int h) const { return opposite[h] == -1 ? -1 : next(opposite[h]); }

  bool is_border_vertex(int v) const { return halfedge_of_vertex[v] != -1 && opposite[halfedge_of_vertex[v]] == -1; }

  // Number of edges at a vertex, which must be manifold.
  int valence(int v) const
  {
    const int first = halfedge_of_vertex[v];
    if(first == -1)
      return 0;
    int n = 0, h = first;
    do
    {
      ++n;
      h = next_around_source(h);
    }
    while(h != -1 && h != first);
    return h == -1 ? n + 1 : n;
  }

  void find_halfedges_of_vertices()
  {
    halfedge_of_vertex.assign(points.size(), -1);
    for(int h = 0; h < number_of_halfedges(); ++h)
    {
      int& first = halfedge_of_vertex[source(h)];
      if(first == -1 || opposite[h] == -1)
        first = h;
    }
  }

  // Joins the faces by the vertices of their sides. Returns false, leaving the mesh unconnected, if
  // a side occurs twice in the same direction.
  bool connect()
  {
    const int nh = 4 * number_of_faces();
    // sides sorted by their smaller vertex, in buckets
    std::vector<int> first(points.size() + 1, 0), sides(nh);
    auto ends = [&](int h) { return std::minmax({ corners[h / 4][h & 3], corners[h / 4][(h + 1) & 3] }); };
    for(int h = 0; h < nh; ++h)
      ++first[ends(h).first + 1];
    for(std::size_t i = 1; i < first.size(); ++i)
      first[i] += first[i - 1];
    std::vector<int> fill(first.begin(), first.end() - 1);
    for(int h = 0; h < nh; ++h)
      sides[fill[ends(h).first]++] = h;

    opposite.assign(nh, -1);
    for(std::size_t v = 0; v + 1 < first.size(); ++v)
      for(int i = first[v]; i < first[v + 1]; ++i)
        for(int j = i + 1; j < first[v + 1]; ++j)
          if(ends(sides[i]).second == ends(sides[j]).second)
          {
            const int h = sides[i], g = sides[j];
            if(source(h) == source(g) || opposite[h] != -1 || opposite[g] != -1)
            {
              opposite.assign(nh, -1);
              return false;
            }
            opposite[h] = g;
            opposite[g] = h;
          }
    find_halfedges_of_vertices();
    return true;
  }
};

// The copy of a pure quad mesh in flat arrays, and where its vertices and faces come from.
template <typename QuadMesh>
struct Indexed_quad_mesh_copy
{
  Indexed_quad_mesh mesh;
  std::vector<typename boost::graph_traits<QuadMesh>::vertex_descriptor> vertices;
  std::vector<typename boost::graph_traits<QuadMesh>::face_descriptor> faces;
};

// The halfedge of the graph that a flat copy of it calls h.
template <typename QuadMesh>
typename boost::graph_traits<QuadMesh>::halfedge_descriptor
original_halfedge(int h, const Indexed_quad_mesh_copy<QuadMesh>& copy, const QuadMesh& qm)
{
  typename boost::graph_traits<QuadMesh>::halfedge_descriptor original = halfedge(copy.faces[h / 4], qm);
  for(int k = 0; k < (h & 3); ++k)
    original = next(original, qm);
  return original;
}

// Copies a pure quad mesh, vertices and faces in the order in which the graph enumerates them. Corner
// 0 of a face is the source of `halfedge(f, qm)`.
template <typename QuadMesh, typename VertexPointMap, typename EdgeIsConstrainedMap>
Indexed_quad_mesh_copy<QuadMesh> make_indexed_quad_mesh(const QuadMesh& qm, VertexPointMap vpm,
                                                        EdgeIsConstrainedMap ecm)
{
  typedef typename boost::graph_traits<QuadMesh>::halfedge_descriptor halfedge_descriptor;

  Indexed_quad_mesh_copy<QuadMesh> copy;
  Indexed_quad_mesh& m = copy.mesh;

  // the index maps of a mesh that has garbage are not consecutive
  const auto vim = get(CGAL::dynamic_vertex_property_t<int>(), qm);
  const auto him = get(CGAL::dynamic_halfedge_property_t<int>(), qm);
  for(auto v : vertices(qm))
  {
    const auto& p = get(vpm, v);
    put(vim, v, static_cast<int>(m.points.size()));
    m.points.push_back(Indexed_quad_mesh::Point_3(to_double(p.x()), to_double(p.y()), to_double(p.z())));
    copy.vertices.push_back(v);
  }
  for(auto h : halfedges(qm))
    put(him, h, -1);
  for(auto f : faces(qm))
  {
    std::array<int, 4> c;
    halfedge_descriptor h = halfedge(f, qm);
    for(int k = 0; k < 4; ++k, h = next(h, qm))
    {
      c[k] = get(vim, source(h, qm));
      put(him, h, 4 * m.number_of_faces() + k);
    }
    m.corners.push_back(c);
    copy.faces.push_back(f);
  }

  m.opposite.assign(4 * m.corners.size(), -1);
  m.is_feature.assign(4 * m.corners.size(), 0);
  for(auto e : edges(qm))
  {
    const int h = get(him, halfedge(e, qm)), o = get(him, opposite(halfedge(e, qm), qm));
    const char feature = get(ecm, e) ? 1 : 0;
    if(h != -1)
    {
      m.opposite[h] = o;
      m.is_feature[h] = feature;
    }
    if(o != -1)
    {
      m.opposite[o] = h;
      m.is_feature[o] = feature;
    }
  }
  m.find_halfedges_of_vertices();
  return copy;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_INDEXED_QUAD_MESH_H
