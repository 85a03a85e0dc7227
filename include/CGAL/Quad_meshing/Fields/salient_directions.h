// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors
#ifndef CGAL_QUAD_MESHING_FIELDS_SALIENT_DIRECTIONS_H
#define CGAL_QUAD_MESHING_FIELDS_SALIENT_DIRECTIONS_H

#include <CGAL/Quad_meshing/Fields/internal/Shape_operators.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief finds the faces where the surface itself says how quads should be oriented, and that direction.
 *
 * These are the faces in parabolic regions: there one principal curvature is much stronger than the
 * other, so their directions are well defined. A face gets a direction if the shape operators of disks of radius `r`
 * about it are anisotropic and bent for all `r` in an interval of half the target edge length; of several such
 * intervals the one with the steadiest direction counts. The directions are sparse constraints for `smooth_cross_field()`.
 *
 * The principal directions near flat and umbilic points are noise, and are left out on purpose.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceDirectionMap a model of `WritablePropertyMap` with the face descriptor of `TriangleMesh` as key and an optional vector,
 *   such as `boost::optional<Vector_3>`, as value type
 *
 * \param tm the triangle mesh
 * \param target_edge_length the edge length of the quad mesh the directions are for; the largest disks have this radius
 * \param direction gets a unit vector tangent to the surface for every salient face, and an empty value for all others
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{minimum_anisotropy}
 *     \cgalParamDescription{the relative difference of the absolute principal curvatures from which on a disk counts as parabolic}
 *     \cgalParamType{`double`, from 0 to 1}
 *     \cgalParamDefault{0.8}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a 3D point as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the number of faces that have a direction
 *
 * \sa `smooth_cross_field()`
 */
template <typename TriangleMesh, typename FaceDirectionMap, typename NamedParameters = parameters::Default_named_parameters>
int salient_directions(const TriangleMesh& tm, double target_edge_length, FaceDirectionMap direction,
                       const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef typename GetGeomTraits<TriangleMesh, NamedParameters>::type::Vector_3 Vector_3;
  typedef typename boost::property_traits<FaceDirectionMap>::value_type Optional_direction;

  // Radii are sampled this densely; an interval of half the target edge length has five of them.
  const double step = target_edge_length / 8;
  const int half_interval = 2;
  const double minimum_anisotropy = choose_parameter(get_parameter(np, internal_np::minimum_anisotropy), 0.8);

  const auto fim = internal::face_numbers(tm, np);
  const internal::Indexed_triangle_mesh m = internal::make_indexed_triangle_mesh(
    tm, choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tm)),
    internal::vertex_numbers(tm, np), fim);
  for(auto f : faces(tm))
    put(direction, f, Optional_direction());
  if(!(target_edge_length > 0) || m.number_of_faces() == 0)
    return 0;

  // The smallest disks have the mean edge length as radius.
  double edge_length = 0;
  for(int e = 0; e < m.number_of_edges(); ++e)
    edge_length += std::sqrt(m.vector(m.halfedge_of_edge[e]).squared_length());
  edge_length /= m.number_of_edges();
  Bbox_3 box;
  for(const auto& p : m.points)
    box += p.bbox();
  const double radius = std::sqrt(std::pow(box.x_span(), 2) + std::pow(box.y_span(), 2) + std::pow(box.z_span(), 2)) / 2;
  // Flatter than this is flat: a tenth of the curvature of the bounding sphere.
  const double flat = 0.1 / radius;

  std::vector<double> radii(1, edge_length);
  while(radii.back() + step <= target_edge_length || static_cast<int>(radii.size()) < 2 * half_interval + 1)
    radii.push_back(radii.back() + step);

  const double pi = 2 * std::acos(0.);
  auto between_axes = [&](double a, double b) { return std::abs(a - b - pi * std::round((a - b) / pi)); };

  internal::Shape_operators operators(m);
  int count = 0;
  for(auto f : faces(tm))
  {
    internal::Shape_operators::Vector_3 x, y;
    const std::vector<internal::Shape_operator> s = operators(static_cast<int>(get(fim, f)), radii, x, y);
    int best = -1;
    double best_deviation = 0;
    for(int i = half_interval; i + half_interval < static_cast<int>(s.size()); ++i)
    {
      bool valid = true;
      double deviation = 0;
      for(int j = i - half_interval; j <= i + half_interval; ++j)
      {
        valid = valid && s[j].anisotropy() > minimum_anisotropy && std::abs(s[j].mean()) > flat;
        deviation = (std::max)(deviation, between_axes(s[i].angle, s[j].angle));
      }
      if(valid && (best == -1 || deviation < best_deviation))
      {
        best = i;
        best_deviation = deviation;
      }
    }
    if(best == -1)
      continue;
    const auto d = std::cos(s[best].angle) * x + std::sin(s[best].angle) * y;
    put(direction, f, Optional_direction(Vector_3(d.x(), d.y(), d.z())));
    ++count;
  }
  return count;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_SALIENT_DIRECTIONS_H
