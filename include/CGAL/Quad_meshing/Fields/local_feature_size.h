// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_LOCAL_FEATURE_SIZE_H
#define CGAL_QUAD_MESHING_FIELDS_LOCAL_FEATURE_SIZE_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Fields/Curvature_guide_result.h>
#include <CGAL/Quad_meshing/Fields/internal/find_feature_sizes.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>

#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief computes how far every face is from the medial axis of the shape.
 *
 * The local feature size is the radius of the smaller of the two balls, inside and outside, that touch the surface at
 * the face and contain no other part of it: half the thickness of a plate, the radius of a tube, half the width of a
 * groove. It is found by shrinking balls against the centroids of all faces. Balls that a bump of the surface would
 * stop, seen from their center within 20 degrees of the face, are not shrunk further, so noise does not count, and a
 * sharp edge counts no nearer than the triangles beside it.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceSizingMap a model of `WritablePropertyMap` with the face descriptor of `TriangleMesh` as key and `double`
 *   as value type
 *
 * \param tm the triangle mesh
 * \param size gets the local feature size of every face, in the unit of the points, at most half the diagonal of the
 *   bounding box
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
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
 * \return how it ended
 */
template <typename TriangleMesh, typename FaceSizingMap,
          typename NamedParameters = parameters::Default_named_parameters>
Curvature_guide_result local_feature_size(const TriangleMesh& tm, FaceSizingMap size,
                                          const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter_reference;

  typedef
    typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Default_visitor>::reference
      Visitor_reference;

  constexpr bool takes_parameters =
    internal::Takes_parameters<NamedParameters, internal_np::visitor_t, internal_np::vertex_point_t,
                               internal_np::vertex_index_t, internal_np::face_index_t>::value;
  static_assert(takes_parameters, "local_feature_size() does not take one of the named parameters.");

  Default_visitor default_visitor;
  Visitor_reference visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  Curvature_guide_result result;
  if(!is_triangle_mesh(tm))
  {
    result.status = Curvature_guide_status::NOT_A_TRIANGLE_MESH;
    result.message = "The mesh has a face that is not a triangle.";
    return result;
  }
  internal::Visitor_adaptor<typename std::remove_reference<Visitor_reference>::type> any_visitor(visitor);
  std::vector<double> sizes;
  {
    const internal::Visited_stage stage(any_visitor, "local feature size");
    internal::Stage_progress progress(any_visitor);
    if(!internal::find_feature_sizes(internal::make_indexed_triangle_mesh(tm, np), progress, sizes))
    {
      result.status = Curvature_guide_status::STOPPED;
      result.message = "The visitor stopped the computation of local feature sizes.";
      return result;
    }
  }
  const auto fim = internal::face_numbers(tm, np);
  for(auto f : faces(tm))
    put(size, f, sizes[get(fim, f)]);
  result.number_of_faces = static_cast<int>(sizes.size());
  result.message = "All " + std::to_string(sizes.size()) + " faces have a local feature size.";
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_LOCAL_FEATURE_SIZE_H
