// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_TEST_QUAD_MESH_CHECKS_H
#define CGAL_QUAD_MESHING_TEST_QUAD_MESH_CHECKS_H

// What the tests ask of a mesh, quad or triangle, written against the graph interface alone and
// independent of the code under test.

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace quad_mesh_checks {

struct Mesh_figures
{
  std::size_t vertices = 0, edges = 0, faces = 0;
  std::size_t quads = 0;
  std::size_t components = 0; // of faces, joined over edges
  std::size_t border_loops = 0;
  std::size_t isolated_vertices = 0;
  std::size_t multiple_edges = 0;             // edges that join two vertices already joined, or a vertex to itself
  bool consistent = true;                     // next/opposite/target/face pointers agree, faces and fans are cycles
  bool vertex_manifold = true;                // the faces around each vertex form one fan
  std::map<int, std::size_t> inner_valences;  // valence -> number of inner vertices
  std::map<int, std::size_t> border_valences; // valence (edges) -> number of border vertices

  long euler() const { return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(faces); }
  bool is_pure_quad_mesh() const { return faces > 0 && quads == faces; }
  bool is_simple() const { return multiple_edges == 0; }

  // A manifold mesh of quads only, and nothing besides.
  bool is_valid() const { return consistent && vertex_manifold && isolated_vertices == 0 && is_pure_quad_mesh(); }

  std::size_t irregular_vertices() const
  {
    std::size_t n = 0;
    for(const auto& v : inner_valences)
      if(v.first != 4)
        n += v.second;
    return n;
  }

  // Sum of (4 - valence) over inner vertices and of (3 - valence) over border vertices: 4 times the Euler number in a
  // pure quad mesh.
  long index_sum() const
  {
    long s = 0;
    for(const auto& v : inner_valences)
      s += (4 - v.first) * static_cast<long>(v.second);
    for(const auto& v : border_valences)
      s += (3 - v.first) * static_cast<long>(v.second);
    return s;
  }

  bool same_topology(const Mesh_figures& m) const
  {
    return euler() == m.euler() && components == m.components && border_loops == m.border_loops;
  }
};

template <typename Mesh>
Mesh_figures figures(const Mesh& mesh)
{
  typedef boost::graph_traits<Mesh> Traits;
  typedef typename Traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Traits::vertex_descriptor vertex_descriptor;
  typedef typename Traits::face_descriptor face_descriptor;

  Mesh_figures r;
  const auto null_face = Traits::null_face();
  std::map<vertex_descriptor, std::size_t> degree; // halfedges that point to the vertex
  std::set<std::pair<vertex_descriptor, vertex_descriptor>> joined;
  std::set<halfedge_descriptor> border;
  std::size_t halfedges_of_mesh = 0;

  for(auto v : vertices(mesh))
  {
    ++r.vertices;
    degree[v] = 0;
  }
  for(auto e : edges(mesh))
  {
    ++r.edges;
    const halfedge_descriptor pair[2] = { halfedge(e, mesh), opposite(halfedge(e, mesh), mesh) };
    const vertex_descriptor s = source(pair[0], mesh), t = target(pair[0], mesh);
    if(s == t || !joined.insert(std::make_pair((std::min)(s, t), (std::max)(s, t))).second)
      ++r.multiple_edges;
    if(face(pair[0], mesh) == null_face && face(pair[1], mesh) == null_face)
      r.consistent = false;
    for(halfedge_descriptor h : pair)
    {
      ++halfedges_of_mesh;
      ++degree[target(h, mesh)];
      if(face(h, mesh) == null_face)
        border.insert(h);
      if(opposite(opposite(h, mesh), mesh) != h || prev(next(h, mesh), mesh) != h || next(prev(h, mesh), mesh) != h ||
         face(next(h, mesh), mesh) != face(h, mesh) || source(next(h, mesh), mesh) != target(h, mesh))
        r.consistent = false;
    }
  }
  if(!r.consistent)
    return r;

  std::map<face_descriptor, face_descriptor> parent;
  for(auto f : faces(mesh))
  {
    parent[f] = f;
    ++r.faces;
    std::size_t n = 0;
    const halfedge_descriptor start = halfedge(f, mesh);
    halfedge_descriptor h = start;
    do
    {
      if(face(h, mesh) != f)
        r.consistent = false;
      h = next(h, mesh);
      ++n;
    }
    while(h != start && n <= halfedges_of_mesh);
    if(n == 4)
      ++r.quads;
  }

  auto root = [&](face_descriptor f)
  {
    while(parent[f] != f)
      f = parent[f] = parent[parent[f]];
    return f;
  };
  r.components = r.faces;
  for(auto e : edges(mesh))
  {
    const face_descriptor f = face(halfedge(e, mesh), mesh), g = face(opposite(halfedge(e, mesh), mesh), mesh);
    if(f == null_face || g == null_face || root(f) == root(g))
      continue;
    parent[root(f)] = root(g);
    --r.components;
  }

  for(auto v : vertices(mesh))
  {
    const halfedge_descriptor start = halfedge(v, mesh);
    if(degree[v] == 0)
    {
      ++r.isolated_vertices;
      continue;
    }
    std::size_t n = 0, borders = 0;
    halfedge_descriptor h = start;
    if(target(h, mesh) != v)
      r.consistent = false;
    do
    {
      borders += face(h, mesh) == null_face;
      h = opposite(next(h, mesh), mesh);
      ++n;
    }
    while(h != start && n <= degree[v]);
    // One fan: turning around v meets all its edges, and the border at most once.
    if(n != degree[v] || borders > 1)
      r.vertex_manifold = false;
    ++(borders == 0 ? r.inner_valences : r.border_valences)[static_cast<int>(degree[v])];
    // CGAL wants the border halfedge to be found from the vertex.
    if(borders == 1 && face(start, mesh) != null_face)
    {
      bool found = false;
      for(auto g : CGAL::halfedges_around_target(v, mesh))
        found |= CGAL::is_border(g, mesh);
      if(!found)
        r.consistent = false;
    }
  }

  while(!border.empty())
  {
    ++r.border_loops;
    halfedge_descriptor h = *border.begin();
    while(border.erase(h) == 1)
      h = next(h, mesh);
  }
  return r;
}

// Whether two surface meshes have the same points and faces, in the same order.
template <typename SurfaceMesh>
bool are_equal(const SurfaceMesh& a, const SurfaceMesh& b)
{
  // The vertices of a face, from the one with the smallest number on.
  const auto corners = [](const SurfaceMesh& mesh, typename SurfaceMesh::Face_index f)
  {
    std::vector<typename SurfaceMesh::Vertex_index> result;
    for(typename SurfaceMesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      result.push_back(v);
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
  };
  if(a.number_of_vertices() != b.number_of_vertices() || a.number_of_faces() != b.number_of_faces())
    return false;
  for(typename SurfaceMesh::Vertex_index v : a.vertices())
    if(a.point(v) != b.point(v))
      return false;
  for(typename SurfaceMesh::Face_index f : a.faces())
    if(corners(a, f) != corners(b, f))
      return false;
  return true;
}

} // namespace quad_mesh_checks

#endif // CGAL_QUAD_MESHING_TEST_QUAD_MESH_CHECKS_H
