// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_LOCAL_FEATURE_SIZE_H
#define CGAL_QUAD_MESHING_FIELDS_LOCAL_FEATURE_SIZE_H

#include <CGAL/Quad_meshing/Fields/Curvature_guide_result.h>
#include <CGAL/Quad_meshing/Fields/internal/find_feature_sizes.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/triangle_mesh_parameters.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <string>
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
  internal::check_parameters<NamedParameters, internal_np::visitor_t, internal_np::vertex_point_t,
                             internal_np::vertex_index_t, internal_np::face_index_t>();

  Curvature_guide_result result;
  if(!internal::has_triangles_only(tm, result))
    return result;
  internal::Named_visitor<NamedParameters> visitor(np);
  std::vector<double> sizes;
  {
    const internal::Visited_stage stage(visitor, "local feature size");
    internal::Stage_progress progress(visitor);
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
