// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors
#ifndef CGAL_QUAD_MESHING_FIELDS_SIZING_H
#define CGAL_QUAD_MESHING_FIELDS_SIZING_H

#include <CGAL/Quad_meshing/Fields/Curvature_guide_result.h>
#include <CGAL/Quad_meshing/Fields/internal/curvature_guides.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/triangle_mesh_parameters.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief returns the edge length with which a given number of quads covers a surface.
 *
 * This is the square root of the area per quad, 0 if the mesh has no area.
 *
 * \pre `number_of_quads > 0`
 */
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
double edge_length_for_number_of_quads(const TriangleMesh& tm, double number_of_quads,
                                       const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition(number_of_quads > 0);
  const internal::Indexed_triangle_mesh m = internal::make_indexed_triangle_mesh(tm, np);
  double area = 0;
  for(int f = 0; f < m.number_of_faces(); ++f)
    area += std::sqrt(cross_product(m.vector(3 * f), m.vector(3 * f + 1)).squared_length()) / 2;
  return std::sqrt(area / number_of_quads);
}

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief computes target edge lengths that adapt to the curvature.
 *
 * An edge over an arc of radius `R` leaves the surface by `t` if its length is \f$ 2 \sqrt{2 R t - t^2} \f$. Every face
 * gets this length for the stronger principal curvature and the tolerance `t`, within the given bounds. Then lengths
 * are reduced where they grow too fast: along the surface they grow by at most `sizing_gradation` per unit of length.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceSizingMap a model of `WritablePropertyMap` with the face descriptor of `TriangleMesh` as key and `double`
 *   as value type
 *
 * \param tm the triangle mesh
 * \param tolerance the distance allowed between an edge and the surface
 * \param minimum the smallest edge length
 * \param maximum the largest edge length
 * \param sizing gets the target edge length of every face
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{sizing_gradation}
 *     \cgalParamDescription{the largest slope of the target edge length}
 *     \cgalParamType{`double`, positive}
 *     \cgalParamDefault{0.3}
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
 * \return how it ended: `INVALID_LENGTH` unless `tolerance > 0` and `0 < minimum <= maximum`
 */
template <typename TriangleMesh, typename FaceSizingMap,
          typename NamedParameters = parameters::Default_named_parameters>
Curvature_guide_result curvature_sizing(const TriangleMesh& tm, double tolerance, double minimum, double maximum,
                                        FaceSizingMap sizing, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  internal::check_parameters<NamedParameters, internal_np::sizing_gradation_t, internal_np::visitor_t,
                             internal_np::vertex_point_t, internal_np::vertex_index_t, internal_np::face_index_t>();

  const double gradation = choose_parameter(get_parameter(np, internal_np::sizing_gradation), 0.3);

  Curvature_guide_result result;
  if(!internal::has_triangles_only(tm, result))
    return result;
  internal::Named_visitor<NamedParameters> visitor(np);
  std::vector<double> length;
  result = internal::find_curvature_sizing(internal::make_indexed_triangle_mesh(tm, np), tolerance, minimum, maximum,
                                           gradation, visitor, length);
  if(!result.is_valid())
    return result;
  const auto fim = internal::face_numbers(tm, np);
  for(auto f : faces(tm))
    put(sizing, f, length[get(fim, f)]);
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_SIZING_H
