// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_CURVATURE_DIRECTIONS_H
#define CGAL_QUAD_MESHING_FIELDS_CURVATURE_DIRECTIONS_H

#include <CGAL/Quad_meshing/Fields/Curvature_guide_result.h>
#include <CGAL/Quad_meshing/Fields/internal/find_curvature_directions.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/triangle_mesh_parameters.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <boost/property_map/property_map.hpp>

#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief finds the directions in which the surface bends least, and how much they count.
 *
 * Shape operators are averaged over disks about the faces, whose radii are about the target edge length: what is
 * smaller than a quad does not count. A direction is reliable where one principal curvature is much stronger than the
 * other, where the surface is bent at all, and where disks of different radii agree \cgalCite{Bom12} (8.1). On planes
 * and spheres no direction is. Where triangles are much smaller than quads, some of them speak for their neighbors.
 *
 * The weight of a direction is its reliability, from 0 to 1, times the area that it speaks for, in quads. So the sum
 * over all faces does not depend on the triangles. With such weights the directions are soft guides of
 * `smooth_cross_field()`; `salient_directions()` gives hard ones, and fewer.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceDirectionMap a model of `WritablePropertyMap` with the face descriptor of `TriangleMesh` as key and an
 *   optional vector, such as `std::optional<Vector_3>`, as value type
 * \tparam FaceWeightMap a model of `WritablePropertyMap` with the face descriptor as key and `double` as value type
 *
 * \param tm the triangle mesh
 * \param target_edge_length the edge length of the quad mesh that the directions are for
 * \param direction gets a unit vector for some faces, an empty value for all others
 * \param weight gets the weights, 0 where there is no direction
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{feature edges, at which disks end: a crease says nothing of the curvature beside it}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key and `bool` as value type}
 *     \cgalParamDefault{no edge}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_sizing_map}
 *     \cgalParamDescription{the target edge length per face, positive; takes precedence over `target_edge_length`}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the face descriptor as key and `double` as value type}
 *     \cgalParamDefault{`target_edge_length` everywhere}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{minimum_anisotropy}
 *     \cgalParamDescription{the relative difference of the absolute principal curvatures from which on a direction is
 *       reliable: weights are areas then, and nothing lies between reliable directions and none. Besides, the larger
 *       curvature has to be at least a tenth of that of the sphere around the model, and disks have to agree within 10
 *       degrees.}
 *     \cgalParamType{`double`, from 0 to 1}
 *     \cgalParamDefault{reliability rises from an anisotropy of 0.5 to one of 0.9}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{is told about stages and may stop them, see `Default_visitor`; pass it by `std::ref`}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{consecutive numbers of the vertices from 0}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_index_map}
 *     \cgalParamDescription{consecutive numbers of the faces from 0}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return how it ended, and the number of faces that have a direction
 */
template <typename TriangleMesh, typename FaceDirectionMap, typename FaceWeightMap,
          typename NamedParameters = parameters::Default_named_parameters>
Curvature_guide_result curvature_directions(const TriangleMesh& tm, double target_edge_length,
                                            FaceDirectionMap direction, FaceWeightMap weight,
                                            const NamedParameters& np = parameters::default_values())
{
  typedef typename GetGeomTraits<TriangleMesh, NamedParameters>::type::Vector_3 Vector_3;
  typedef typename boost::property_traits<FaceDirectionMap>::value_type Optional_direction;

  internal::check_parameters<NamedParameters, internal_np::edge_is_constrained_t, internal_np::face_sizing_map_t,
                             internal_np::minimum_anisotropy_t, internal_np::visitor_t, internal_np::vertex_point_t,
                             internal_np::vertex_index_t, internal_np::face_index_t>();
  static_assert(internal::Is_optional_like<Optional_direction>::value,
                "The value type of the map of directions must be an optional vector, such as std::optional<Vector_3>.");

  Curvature_guide_result result;
  if(!internal::has_triangles_only(tm, result))
    return result;
  const internal::Indexed_triangle_mesh mesh = internal::make_indexed_triangle_mesh(tm, np);
  internal::Named_visitor<NamedParameters> visitor(np);
  std::vector<internal::Indexed_triangle_mesh::Vector_3> directions;
  std::vector<double> weights;
  std::optional<double> minimum_anisotropy;
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::minimum_anisotropy_t>::value)
    minimum_anisotropy = parameters::get_parameter(np, internal_np::minimum_anisotropy);
  result = internal::find_curvature_directions(
    mesh, target_edge_length, internal::face_lengths(tm, mesh.corners.size(), np), internal::constrained_edges(tm, np),
    minimum_anisotropy, visitor, directions, weights);
  if(!result.is_valid())
    return result;
  const auto fim = internal::face_numbers(tm, np);
  for(auto f : faces(tm))
  {
    const auto i = get(fim, f);
    const auto& d = directions[i];
    put(direction, f, weights[i] > 0 ? Optional_direction(Vector_3(d.x(), d.y(), d.z())) : Optional_direction());
    put(weight, f, weights[i]);
  }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_CURVATURE_DIRECTIONS_H
