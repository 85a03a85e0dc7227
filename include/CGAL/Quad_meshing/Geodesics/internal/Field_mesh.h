// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_MESH_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_MESH_H

#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_result.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The mesh of a distance field: the graph that the user knows, its unfolded form, and the numbers that lead from one to
// the other.
template <typename TriangleMesh, typename FT>
class Field_mesh
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

public:
  template <typename NamedParameters>
  Geodesic_distance_status read(const TriangleMesh& tm, const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;

    m_tm = &tm;
    auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
    const auto vim = vertex_numbers(tm, np);
    const auto fim = face_numbers(tm, np);
    Indexed_triangle_mesh mesh;
    if(! read_points(mesh, vpm, vim))
      return Geodesic_distance_status::POINT_NOT_FINITE;
    if(! read_faces(mesh, vim, fim))
      return Geodesic_distance_status::NOT_A_TRIANGLE_MESH;
    m_unfolded = Unfolded_mesh<FT>(std::move(mesh));
    m_vertex_index = [vim](vertex_descriptor v) { return static_cast<int>(get(vim, v)); };
    m_face_index = [fim](face_descriptor f) { return static_cast<int>(get(fim, f)); };
    return Geodesic_distance_status::SUCCESS;
  }

  const TriangleMesh& graph() const { return *m_tm; }
  const Unfolded_mesh<FT>& unfolded() const { return m_unfolded; }

  int vertex_index(vertex_descriptor v) const { return m_vertex_index(v); }
  int face_index(face_descriptor f) const { return m_face_index(f); }
  face_descriptor face_of_index(int i) const { return m_faces[i]; }

  int halfedge_index(halfedge_descriptor h) const { return halfedge_number(h, m_face_index); }

private:
  // Returns false if a coordinate is not finite.
  template <typename VertexPointMap, typename VertexIndexMap>
  bool read_points(Indexed_triangle_mesh& mesh, VertexPointMap vpm, VertexIndexMap vim) const
  {
    const auto range = vertices(*m_tm);
    mesh.points.resize(static_cast<std::size_t>(std::distance(range.begin(), range.end())));
    for(vertex_descriptor v : range)
    {
      const auto& p = get(vpm, v);
      const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y()), z = CGAL::to_double(p.z());
      if(! std::isfinite(x) || ! std::isfinite(y) || ! std::isfinite(z))
        return false;
      mesh.points[get(vim, v)] = Indexed_triangle_mesh::Point_3(x, y, z);
    }
    return true;
  }

  // The same as `make_indexed_triangle_mesh()`, in one go over the faces. Returns false if one is not a triangle.
  template <typename VertexIndexMap, typename FaceIndexMap>
  bool read_faces(Indexed_triangle_mesh& mesh, VertexIndexMap vim, FaceIndexMap fim)
  {
    const TriangleMesh& tm = *m_tm;
    const auto range = faces(tm);
    const std::size_t n = static_cast<std::size_t>(std::distance(range.begin(), range.end()));
    m_faces.resize(n);
    mesh.corners.resize(n);
    mesh.opposite.assign(3 * n, -1);
    mesh.edge_of.assign(3 * n, -1);
    mesh.halfedge_of_vertex.assign(mesh.points.size(), -1);
    mesh.halfedge_of_edge.reserve(3 * n / 2 + 1);
    for(face_descriptor f : range)
    {
      const int i = static_cast<int>(get(fim, f));
      m_faces[i] = f;
      const halfedge_descriptor first = halfedge(f, tm);
      halfedge_descriptor h = first;
      for(int k = 0; k < 3; ++k, h = next(h, tm))
      {
        const int v = static_cast<int>(get(vim, source(h, tm)));
        mesh.corners[i][k] = v;
        int& leaving = mesh.halfedge_of_vertex[v];
        const halfedge_descriptor o = opposite(h, tm);
        const bool is_on_border = is_border(o, tm);
        if(leaving == -1 || is_on_border)
          leaving = 3 * i + k;
        if(mesh.edge_of[3 * i + k] != -1)
          continue;        // seen from the other side
        const int e = mesh.number_of_edges();
        mesh.halfedge_of_edge.push_back(3 * i + k);
        mesh.edge_of[3 * i + k] = e;
        if(is_on_border)
          continue;
        const int j = halfedge_number(o, [fim](face_descriptor g) { return static_cast<int>(get(fim, g)); });
        mesh.opposite[3 * i + k] = j;
        mesh.opposite[j] = 3 * i + k;
        mesh.edge_of[j] = e;
      }
      if(h != first)
        return false;
    }
    return true;
  }

  template <typename FaceNumber>
  int halfedge_number(halfedge_descriptor h, const FaceNumber& face_number) const
  {
    const face_descriptor f = face(h, *m_tm);
    const halfedge_descriptor first = halfedge(f, *m_tm);
    const int k = h == first ? 0 : h == next(first, *m_tm) ? 1 : 2;
    return 3 * face_number(f) + k;
  }

  const TriangleMesh* m_tm = nullptr;
  Unfolded_mesh<FT> m_unfolded;
  std::vector<face_descriptor> m_faces;
  std::function<int(vertex_descriptor)> m_vertex_index;
  std::function<int(face_descriptor)> m_face_index;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_MESH_H
