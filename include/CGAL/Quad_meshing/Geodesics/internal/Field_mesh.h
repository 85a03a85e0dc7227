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
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <cmath>
#include <cstddef>
#include <functional>
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
    for(vertex_descriptor v : vertices(tm))
    {
      const auto& p = get(vpm, v);
      if(! std::isfinite(CGAL::to_double(p.x())) || ! std::isfinite(CGAL::to_double(p.y())) || ! std::isfinite(CGAL::to_double(p.z())))
        return Geodesic_distance_status::POINT_NOT_FINITE;
    }
    if(! is_triangle_mesh(tm))
      return Geodesic_distance_status::NOT_A_TRIANGLE_MESH;

    unfold(vpm, vertex_numbers(tm, np), face_numbers(tm, np));
    return Geodesic_distance_status::SUCCESS;
  }

  const TriangleMesh& graph() const { return *m_tm; }
  const Unfolded_mesh<FT>& unfolded() const { return m_unfolded; }

  int vertex_index(vertex_descriptor v) const { return m_vertex_index(v); }
  int face_index(face_descriptor f) const { return m_face_index(f); }
  face_descriptor face_of_index(int i) const { return m_faces[i]; }

  int halfedge_index(halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, *m_tm);
    const halfedge_descriptor first = halfedge(f, *m_tm);
    const int k = h == first ? 0 : h == next(first, *m_tm) ? 1 : 2;
    return 3 * m_face_index(f) + k;
  }

private:
  template <typename VertexPointMap, typename VertexIndexMap, typename FaceIndexMap>
  void unfold(VertexPointMap vpm, VertexIndexMap vim, FaceIndexMap fim)
  {
    m_unfolded = Unfolded_mesh<FT>(make_indexed_triangle_mesh(*m_tm, vpm, vim, fim));
    m_faces.resize(m_unfolded.number_of_faces());
    for(face_descriptor f : faces(*m_tm))
      m_faces[get(fim, f)] = f;
    m_vertex_index = [vim](vertex_descriptor v) { return static_cast<int>(get(vim, v)); };
    m_face_index = [fim](face_descriptor f) { return static_cast<int>(get(fim, f)); };
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
