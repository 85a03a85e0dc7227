// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_DIRECTIONS_H
#define CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_DIRECTIONS_H

#include <CGAL/Quad_meshing/Fields/Face_frames.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

template <typename TriangleMesh, typename VertexPointMap>
std::array<Simple_cartesian<double>::Point_3, 3>
points_of_face(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& tm,
               VertexPointMap vpm)
{
  std::array<Simple_cartesian<double>::Point_3, 3> p;
  auto h = halfedge(f, tm);
  for(int k = 0; k < 3; ++k, h = next(h, tm))
  {
    const auto& q = get(vpm, source(h, tm));
    p[k] = Simple_cartesian<double>::Point_3(to_double(q.x()), to_double(q.y()), to_double(q.z()));
  }
  return p;
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief returns a direction of a cross field in a face, as a unit vector.
 *
 * \param f the face
 * \param tm the triangle mesh
 * \param angle the angles of the field as `smooth_cross_field()` computes them
 * \param i which of the four directions, counterclockwise by right angles from the first, number 0
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` and `geom_traits`
 *
 * \return the direction, in the plane of the face; the zero vector if the face has no normal
 */
template <typename TriangleMesh, typename FaceAngleMap, typename NamedParameters = parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
Vector_3
#else
typename GetGeomTraits<TriangleMesh, NamedParameters>::type::Vector_3
#endif
cross_field_direction(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& tm,
                      FaceAngleMap angle, int i = 0, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef typename GetGeomTraits<TriangleMesh, NamedParameters>::type::Vector_3 Vector_3;

  const auto vpm =
    choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tm));
  Simple_cartesian<double>::Vector_3 x, y;
  if(!internal::triangle_axes(internal::points_of_face(f, tm, vpm), x, y))
    return Vector_3(0, 0, 0);
  const double t = get(angle, f) + i * internal::quarter_turn;
  const Simple_cartesian<double>::Vector_3 d = std::cos(t) * x + std::sin(t) * y;
  return Vector_3(d.x(), d.y(), d.z());
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_DIRECTIONS_H
