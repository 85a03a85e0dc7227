// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_ATTRIBUTES_ON_MESH_H
#define CGAL_QUAD_MESHING_IO_ATTRIBUTES_ON_MESH_H

#include <CGAL/Quad_meshing/IO/Mesh_attributes.h>
#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingIORef

\brief The attributes of a file, seen from the triangle mesh that was read from it.

Vertices may have been merged or split on the way, polygons triangulated: corners of triangles are found in their
polygons by their vertices. What repairs have inserted has no attributes.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`

\sa `read_triangle_mesh()`
\sa `read_mesh_attributes()`
*/
template <typename TriangleMesh>
class Attributes_on_mesh
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

public:
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  /// numbers the elements of a mesh. `tm`, `reading` and `attributes` must stay as they are while this is in use.
  ///
  /// \param tm the mesh
  /// \param reading what `read_triangle_mesh()` has returned for it
  /// \param attributes what `read_mesh_attributes()` has read from the same file
  Attributes_on_mesh(const TriangleMesh& tm, const Mesh_reading_result& reading, const Mesh_attributes& attributes)
    : m_tm(tm), m_reading(reading), m_attributes(attributes)
  {
    std::size_t i = 0;
    for(vertex_descriptor v : vertices(tm))
      m_vertex_number.emplace(v, i++);
    i = 0;
    for(face_descriptor f : faces(tm))
      m_face_number.emplace(f, i++);
  }

  /// returns all that the file says.
  const Mesh_attributes& attributes() const { return m_attributes; }

  /// returns the polygon of the file that a face lies in; `File_numbers::none` if there is none.
  std::size_t polygon(face_descriptor f) const { return m_reading.faces.file_number(m_face_number.at(f)); }

  /// returns the number of the name of a face among `names`, one of the members of `Mesh_attributes`.
  int name(face_descriptor f, const Face_names& names) const
  {
    const std::size_t p = polygon(f);
    return p < names.of_face.size() ? names.of_face[p] : Face_names::none;
  }

  /// returns the texture coordinates at the target of a halfedge in its face, if there are any.
  std::optional<std::array<double, 2>> texture(halfedge_descriptor h) const
  {
    return value(h, m_attributes.corner_texture, m_attributes.texture_coordinates);
  }

  /// returns the normal at the target of a halfedge in its face, if there is one.
  std::optional<std::array<double, 3>> normal(halfedge_descriptor h) const
  {
    return value(h, m_attributes.corner_normal, m_attributes.normals);
  }

  /// returns the color of a vertex, if there is one.
  std::optional<std::array<double, 3>> color(vertex_descriptor v) const
  {
    const std::size_t n = m_reading.vertices.file_number(m_vertex_number.at(v));
    if(n >= m_attributes.colors.size())
      return std::nullopt;
    return m_attributes.colors[n];
  }

private:
  template <typename Values>
  std::optional<typename Values::value_type> value(halfedge_descriptor h, const std::vector<int>& numbers,
                                                   const Values& values) const
  {
    const std::size_t c = corner(h);
    if(c >= numbers.size() || numbers[c] < 0 || static_cast<std::size_t>(numbers[c]) >= values.size())
      return std::nullopt;
    return values[static_cast<std::size_t>(numbers[c])];
  }

  // The corner of the file at the target of a halfedge; none if there is none.
  std::size_t corner(halfedge_descriptor h) const
  {
    const std::size_t p = polygon(face(h, m_tm));
    if(p == File_numbers::none || p + 1 >= m_attributes.first_corner.size())
      return File_numbers::none;
    const std::size_t v = m_vertex_number.at(target(h, m_tm)), n = m_reading.vertices.file_number(v);
    for(std::size_t c = m_attributes.first_corner[p]; c < m_attributes.first_corner[p + 1]; ++c)
      if(m_attributes.corner_vertex[c] == n)
        return c;
    for(std::size_t c = m_attributes.first_corner[p]; c < m_attributes.first_corner[p + 1]; ++c) // of a merged vertex
      if(m_reading.vertices.mesh_number(m_attributes.corner_vertex[c]) == v)
        return c;
    return File_numbers::none;
  }

  const TriangleMesh& m_tm;
  const Mesh_reading_result& m_reading;
  const Mesh_attributes& m_attributes;
  std::unordered_map<vertex_descriptor, std::size_t> m_vertex_number;
  std::unordered_map<face_descriptor, std::size_t> m_face_number;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_ATTRIBUTES_ON_MESH_H
