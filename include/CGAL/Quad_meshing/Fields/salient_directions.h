// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors
#ifndef CGAL_QUAD_MESHING_FIELDS_SALIENT_DIRECTIONS_H
#define CGAL_QUAD_MESHING_FIELDS_SALIENT_DIRECTIONS_H

#include <CGAL/Quad_meshing/Fields/Curvature_guide_result.h>
#include <CGAL/Quad_meshing/Fields/internal/curvature_guides.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/triangle_mesh_parameters.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

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
 * intervals the one with the steadiest direction counts. The directions are sparse constraints for
 * `smooth_cross_field()`.
 *
 * The principal directions near flat and umbilic points are noise, and are left out on purpose.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceDirectionMap a model of `WritablePropertyMap` with the face descriptor of `TriangleMesh` as key and an
 *   optional vector, such as `std::optional<Vector_3>`, as value type
 *
 * \param tm the triangle mesh
 * \param target_edge_length the edge length of the quad mesh the directions are for; the largest disks have this radius
 * \param direction gets a unit vector tangent to the surface for every salient face, and an empty value for all others
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{minimum_anisotropy}
 *     \cgalParamDescription{the relative difference of the absolute principal curvatures from which on a disk counts as
 *     parabolic}
 *     \cgalParamType{`double`, from 0 to 1}
 *     \cgalParamDefault{0.8}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{is told about the progress and may stop it, see `Default_visitor`}
 *     \cgalParamType{a class like `Default_visitor`, passed with `std::ref()`}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a 3D point as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return how it ended, and the number of faces that have a direction
 *
 * \sa `smooth_cross_field()`
 */
template <typename TriangleMesh, typename FaceDirectionMap,
          typename NamedParameters = parameters::Default_named_parameters>
Curvature_guide_result salient_directions(const TriangleMesh& tm, double target_edge_length, FaceDirectionMap direction,
                                          const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef typename GetGeomTraits<TriangleMesh, NamedParameters>::type::Vector_3 Vector_3;
  typedef typename boost::property_traits<FaceDirectionMap>::value_type Optional_direction;

  internal::check_parameters<NamedParameters, internal_np::minimum_anisotropy_t, internal_np::visitor_t,
                             internal_np::vertex_point_t, internal_np::vertex_index_t, internal_np::face_index_t,
                             internal_np::geom_traits_t>();
  static_assert(internal::Is_optional_like<Optional_direction>::value,
                "The map of directions must take an optional vector for every face, such as std::optional<Vector_3>.");

  const double minimum_anisotropy = choose_parameter(get_parameter(np, internal_np::minimum_anisotropy), 0.8);

  Curvature_guide_result result;
  if(!internal::has_triangles_only(tm, result))
    return result;
  internal::Named_visitor<NamedParameters> visitor(np);
  std::vector<internal::Indexed_triangle_mesh::Vector_3> directions;
  result = internal::find_salient_directions(internal::make_indexed_triangle_mesh(tm, np), target_edge_length,
                                             minimum_anisotropy, visitor, directions);
  if(!result.is_valid())
    return result;
  const auto fim = internal::face_numbers(tm, np);
  for(auto f : faces(tm))
  {
    const auto& d = directions[get(fim, f)];
    put(direction, f, d == NULL_VECTOR ? Optional_direction() : Optional_direction(Vector_3(d.x(), d.y(), d.z())));
  }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_SALIENT_DIRECTIONS_H
