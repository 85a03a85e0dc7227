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
#include <CGAL/Quad_meshing/internal/Spatial_numbers.h>
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
//
// The unfolded mesh numbers vertices, faces and edges by where they lie: the front reads what is near it in space,
// which then is near in memory. Many meshes number their elements as if at random.
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
    auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
    const auto vim = vertex_numbers(tm, np);
    const auto fim = face_numbers(tm, np);
    m_number_of_vertex = [vim](vertex_descriptor v) { return static_cast<int>(get(vim, v)); };
    m_number_of_face = [fim](face_descriptor f) { return static_cast<int>(get(fim, f)); };
    Indexed_triangle_mesh mesh;
    if(!read_points(mesh, vpm, vim))
      return Geodesic_distance_status::POINT_NOT_FINITE;
    number_faces(vim, fim);
    if(!read_faces(mesh, vim, fim))
      return Geodesic_distance_status::NOT_A_TRIANGLE_MESH;
    m_unfolded = Unfolded_mesh<FT>(std::move(mesh));
    return Geodesic_distance_status::SUCCESS;
  }

  const TriangleMesh& graph() const { return *m_tm; }
  const Unfolded_mesh<FT>& unfolded() const { return m_unfolded; }

  int vertex_index(vertex_descriptor v) const { return m_vertex_index[m_number_of_vertex(v)]; }
  int face_index(face_descriptor f) const { return m_face_index[m_number_of_face(f)]; }
  face_descriptor face_of_index(int i) const { return m_faces[i]; }

  int halfedge_index(halfedge_descriptor h) const { return halfedge_index(h, m_number_of_face); }

private:
  // Returns false if a coordinate is not finite.
  template <typename VertexPointMap, typename VertexIndexMap>
  bool read_points(Indexed_triangle_mesh& mesh, VertexPointMap vpm, VertexIndexMap vim)
  {
    typedef Indexed_triangle_mesh::Point_3 Point_3;
    const auto range = vertices(*m_tm);
    std::vector<Point_3> points(static_cast<std::size_t>(std::distance(range.begin(), range.end())));
    Bbox_3 box;
    for(vertex_descriptor v : range)
    {
      const auto& p = get(vpm, v);
      const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y()), z = CGAL::to_double(p.z());
      if(!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
        return false;
      points[get(vim, v)] = Point_3(x, y, z);
      box += Bbox_3(x, y, z, x, y, z);
    }
    const Z_curve curve(box, points.size());
    std::vector<int> cells;
    cells.reserve(points.size());
    for(const Point_3& p : points)
      cells.push_back(curve.cell(p));
    m_vertex_index = numbers_in_order(cells, curve.number_of_cells());
    mesh.points.resize(points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      mesh.points[m_vertex_index[i]] = points[i];
    return true;
  }

  // In the order of their first corners.
  template <typename VertexIndexMap, typename FaceIndexMap>
  void number_faces(VertexIndexMap vim, FaceIndexMap fim)
  {
    const auto range = faces(*m_tm);
    std::vector<int> first_corners(static_cast<std::size_t>(std::distance(range.begin(), range.end())));
    for(face_descriptor f : range)
      first_corners[get(fim, f)] = m_vertex_index[get(vim, source(halfedge(f, *m_tm), *m_tm))];
    m_face_index = numbers_in_order(first_corners, m_vertex_index.size());
    m_faces.resize(first_corners.size());
    for(face_descriptor f : range)
      m_faces[m_face_index[get(fim, f)]] = f;
  }

  // The same as `make_indexed_triangle_mesh()`, in one go over the faces. Returns false if one is not a triangle.
  template <typename VertexIndexMap, typename FaceIndexMap>
  bool read_faces(Indexed_triangle_mesh& mesh, VertexIndexMap vim, FaceIndexMap fim) const
  {
    const TriangleMesh& tm = *m_tm;
    const std::size_t n = m_faces.size();
    mesh.corners.resize(n);
    mesh.opposite.assign(3 * n, -1);
    mesh.edge_of.assign(3 * n, -1);
    mesh.halfedge_of_vertex.assign(mesh.points.size(), -1);
    mesh.halfedge_of_edge.reserve(3 * n / 2 + 1);
    for(std::size_t i = 0; i < n; ++i)
    {
      const halfedge_descriptor first = halfedge(m_faces[i], tm);
      halfedge_descriptor h = first;
      for(int k = 0; k < 3; ++k, h = next(h, tm))
      {
        const int v = m_vertex_index[get(vim, source(h, tm))], g = static_cast<int>(3 * i) + k;
        mesh.corners[i][k] = v;
        int& leaving = mesh.halfedge_of_vertex[v];
        const halfedge_descriptor o = opposite(h, tm);
        const bool is_on_border = is_border(o, tm);
        if(leaving == -1 || is_on_border)
          leaving = g;
        if(mesh.edge_of[g] != -1)
          continue; // seen from the other side
        const int e = mesh.number_of_edges();
        mesh.halfedge_of_edge.push_back(g);
        mesh.edge_of[g] = e;
        if(is_on_border)
          continue;
        const int j = halfedge_index(o, [fim](face_descriptor f) { return get(fim, f); });
        mesh.opposite[g] = j;
        mesh.opposite[j] = g;
        mesh.edge_of[j] = e;
      }
      if(h != first)
        return false;
    }
    return true;
  }

  template <typename FaceNumber>
  int halfedge_index(halfedge_descriptor h, const FaceNumber& number_of_face) const
  {
    const face_descriptor f = face(h, *m_tm);
    const halfedge_descriptor first = halfedge(f, *m_tm);
    const int k = h == first ? 0 : h == next(first, *m_tm) ? 1 : 2;
    return 3 * m_face_index[number_of_face(f)] + k;
  }

  const TriangleMesh* m_tm = nullptr;
  Unfolded_mesh<FT> m_unfolded;
  std::function<int(vertex_descriptor)> m_number_of_vertex; // by the index maps
  std::function<int(face_descriptor)> m_number_of_face;
  std::vector<int> m_vertex_index, m_face_index; // per number
  std::vector<face_descriptor> m_faces;          // per index
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_MESH_H
