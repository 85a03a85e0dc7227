// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_WRITE_QUAD_MESH_H
#define CGAL_QUAD_MESHING_INTERNAL_WRITE_QUAD_MESH_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Gives a mesh the connectivity of flat arrays that came out of its copy by removing faces and
// vertices and joining the remaining sides anew. The vertices and faces that are still there keep
// their descriptors, edges keep theirs where they still have one of their sides. Nothing has to be
// allocated, because there are not more edges than before.
template <typename QuadMesh, typename VertexPointMap, typename EdgeIsConstrainedMap>
void write_quad_mesh(const Indexed_quad_mesh& m, const std::vector<int>& vertex_origin,
                     const std::vector<int>& face_origin, const Indexed_quad_mesh_copy<QuadMesh>& copy, QuadMesh& qm,
                     VertexPointMap vpm, EdgeIsConstrainedMap ecm)
{
  typedef boost::graph_traits<QuadMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;

  const int nh = m.number_of_halfedges();
  const auto is_used = get(CGAL::dynamic_edge_property_t<bool>(), qm);
  std::vector<edge_descriptor> all_edges;
  for(edge_descriptor e : edges(qm))
  {
    put(is_used, e, false);
    all_edges.push_back(e);
  }

  // a halfedge for each side: its own, or that of the side it has met, or any that is left over
  std::vector<halfedge_descriptor> own(nh), chosen(nh);
  std::vector<int> without;
  for(int h = 0; h < nh; ++h)
    own[h] = original_halfedge(4 * face_origin[h / 4] + (h & 3), copy, qm);
  for(int h = 0; h < nh; ++h)
  {
    if(m.edge(h) != h)
      continue;
    const int o = m.opposite[h];
    if(!get(is_used, edge(own[h], qm)))
      chosen[h] = own[h];
    else if(o != -1 && !get(is_used, edge(own[o], qm)))
      chosen[h] = opposite(own[o], qm);
    else
    {
      without.push_back(h);
      continue;
    }
    put(is_used, edge(chosen[h], qm), true);
  }
  std::size_t left_over = 0;
  for(int h : without)
  {
    while(get(is_used, all_edges[left_over]))
      ++left_over;
    chosen[h] = halfedge(all_edges[left_over], qm);
    put(is_used, all_edges[left_over], true);
  }
  for(int h = 0; h < nh; ++h)
    if(m.edge(h) != h)
      chosen[h] = opposite(chosen[m.edge(h)], qm);

  // Connectivity. The halfedge of a border vertex is a border halfedge, as some graphs demand.
  std::vector<int> border_into(m.number_of_vertices(), -1);
  for(int h = 0; h < nh; ++h)
    if(m.is_border(h))
      border_into[m.target(h)] = h;
  auto vertex = [&](int v) { return copy.vertices[vertex_origin[v]]; };
  for(int h = 0; h < nh; ++h)
  {
    const face_descriptor f = copy.faces[face_origin[h / 4]];
    set_face(chosen[h], f, qm);
    if((h & 3) == 0)
      set_halfedge(f, chosen[h], qm);
    set_next(chosen[h], chosen[m.next(h)], qm);
    set_target(chosen[h], vertex(m.target(h)), qm);
    if(!m.is_border_vertex(m.target(h)))
      set_halfedge(vertex(m.target(h)), chosen[h], qm);
    if(m.is_border(h))
    {
      const halfedge_descriptor b = opposite(chosen[h], qm);
      set_face(b, Graph_traits::null_face(), qm);
      set_next(b, opposite(chosen[border_into[m.source(h)]], qm), qm);
      set_target(b, vertex(m.source(h)), qm);
      set_halfedge(vertex(m.source(h)), b, qm);
    }
    if(m.edge(h) == h)
      put(ecm, edge(chosen[h], qm), m.is_feature[h] != 0);
  }

  std::vector<char> keeps_vertex(copy.vertices.size(), 0), keeps_face(copy.faces.size(), 0);
  for(int v = 0; v < m.number_of_vertices(); ++v)
  {
    keeps_vertex[vertex_origin[v]] = 1;
    const Indexed_quad_mesh::Point_3& p = m.points[v];
    if(p != copy.mesh.points[vertex_origin[v]])
      put(vpm, vertex(v), Point(p.x(), p.y(), p.z()));
  }
  for(int f : face_origin)
    keeps_face[f] = 1;
  for(edge_descriptor e : all_edges)
    if(!get(is_used, e))
      remove_edge(e, qm);
  for(std::size_t f = 0; f < keeps_face.size(); ++f)
    if(!keeps_face[f])
      remove_face(copy.faces[f], qm);
  for(std::size_t v = 0; v < keeps_vertex.size(); ++v)
    if(!keeps_vertex[v])
      remove_vertex(copy.vertices[v], qm);
}

// Accepts values and forgets them.
template <typename Key>
struct Ignoring_map
{
  typedef Key key_type;
  typedef bool value_type;
  typedef bool reference;
  typedef boost::read_write_property_map_tag category;

  friend bool get(const Ignoring_map&, const Key&) { return false; }
  friend void put(const Ignoring_map&, const Key&, bool) {}
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_WRITE_QUAD_MESH_H
