// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors
#ifndef CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_SECTORS_H
#define CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_SECTORS_H

#include <CGAL/Quad_meshing/Fields/Face_frames.h>
#include <CGAL/Quad_meshing/Fields/Field_sectors.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief tells how many quads a cross field puts between two halfedges at a vertex.
 *
 * The object copies the field when it is constructed, in linear time; a query takes time
 * proportional to the number of faces in the sector.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 */
template <typename TriangleMesh>
class Cross_field_sectors
{
public:
  /// the type of halfedges
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;

  /*!
   * copies a cross field.
   *
   * \param tm the triangle mesh; it must stay as it is as long as the object is used
   * \param angle the angles of the field as `smooth_cross_field()` computes them
   * \param period_jump the period jumps of the field
   * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`
   */
  template <typename FaceAngleMap, typename EdgePeriodJumpMap,
            typename NamedParameters = parameters::Default_named_parameters>
  Cross_field_sectors(const TriangleMesh& tm, FaceAngleMap angle, EdgePeriodJumpMap period_jump,
                      const NamedParameters& np = parameters::default_values())
    : m_graph(tm)
    , m_face_index(get(dynamic_face_property_t<int>(), tm))
    , m_mesh(make_mesh(np))
    , m_frames(m_mesh)
    , m_residual(m_mesh.number_of_edges(), 0.)
  {
    std::vector<double> angles;
    for(auto f : faces(tm))
      angles.push_back(get(angle, f));
    internal::for_each_edge_of_faces(tm,
                                     [&](auto ed, int e)
                                     {
                                       if(m_mesh.is_border_edge(e))
                                         return;
                                       const int h = m_mesh.halfedge_of_edge[e];
                                       m_residual[e] = angles[h / 3] + m_frames.kappa(e) +
                                                       internal::quarter_turn * get(period_jump, ed) -
                                                       angles[m_mesh.opposite[h] / 3];
                                     });
  }

  /*!
   * returns the number of right angles by which the second halfedge is turned against the first one,
   * counterclockwise and as seen from the field. It is an integer up to rounding if the field is aligned
   * with both halfedges; otherwise the nearest integer is returned.
   *
   * \param first the halfedge the sector begins with; it leaves the vertex and is no border halfedge
   * \param last the halfedge the sector ends with, counterclockwise; it leaves the same vertex and may be
   *   a border halfedge. If it is the same as `first`, the sector is the whole fan.
   */
  int number_of_quads(halfedge_descriptor first, halfedge_descriptor last) const
  {
    CGAL_precondition(source(first, m_graph) == source(last, m_graph) && !is_border(first, m_graph));
    return static_cast<int>(std::lround(internal::quads_between(
      m_mesh, m_frames, [&](int e) { return m_residual[e]; }, index(first), index(last))));
  }

private:
  template <typename NamedParameters>
  internal::Indexed_triangle_mesh make_mesh(const NamedParameters& np) const
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;

    int n = 0;
    for(auto f : faces(m_graph))
      put(m_face_index, f, n++);
    return internal::make_indexed_triangle_mesh(
      m_graph,
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, m_graph)),
      internal::vertex_numbers(m_graph, np), m_face_index);
  }

  int index(halfedge_descriptor h) const
  {
    if(is_border(h, m_graph))
      return -1;
    const halfedge_descriptor r = halfedge(face(h, m_graph), m_graph);
    return 3 * get(m_face_index, face(h, m_graph)) + (h == r ? 0 : h == next(r, m_graph) ? 1 : 2);
  }

  const TriangleMesh& m_graph;
  typename boost::property_map<TriangleMesh, dynamic_face_property_t<int>>::const_type m_face_index;
  internal::Indexed_triangle_mesh m_mesh;
  internal::Face_frames m_frames;
  std::vector<double> m_residual; // per edge
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_SECTORS_H
