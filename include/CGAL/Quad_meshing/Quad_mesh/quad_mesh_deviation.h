// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEVIATION_H
#define CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEVIATION_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_reference.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief tells how far a quad mesh is from the surface that it stands for, how much of the
 * features and the boundary of that surface lies on its edges, and how far its edges are from given directions.
 *
 * Distances are relative to the diagonal of the bounding box of the reference.
 *
 * Orientation is that of \cgalCite{Bom12} (2.3): the angle between a quad edge and the direction of the nearest face of
 * the reference that has one, in the plane of that face, up to quarter turns: from 0 to 45 degrees, 22.5 on average for
 * random directions. An edge that is farther from all these faces than the mean quad edge does not count. With the
 * directions of `curvature_directions()`, it tells whether the quads follow the shape.
 */
struct Quad_mesh_deviation
{
  double quads_to_reference_max = 0;     ///< largest distance of a vertex, edge midpoint or centre of a quad
  double quads_to_reference_rms = 0;     ///< root mean square of these distances
  double reference_to_quads_max = 0;     ///< largest distance of a vertex or centroid of the reference
  double reference_to_quads_rms = 0;     ///< root mean square of these distances
  double opposed_quads = 0;              ///< share of the quads whose normal is opposed to the reference
  double feature_length = 0;             ///< length of the feature edges, in mean quad edges
  double features_kept = 1;              ///< share of that length that lies on quad edges
  double boundary_length = 0;            ///< length of the boundary, in mean quad edges
  double boundary_kept = 1;              ///< share of that length that lies on boundary edges of the quads
  std::size_t oriented_edges = 0;        ///< number of quad edges near a face with a direction
  double orientation_deviation_mean = 0; ///< mean angle between these edges and the directions, in degrees
  double orientation_over_15 = 0;        ///< share of these edges with an angle of more than 15 degrees
  std::array<std::size_t, 9>
    orientation_histogram = {}; ///< how many edges have angles of 0 to 5, ..., 40 to 45 degrees
};

namespace internal {

// Both have faces, the reference one of positive area.
CGAL_QUAD_MESHING_INLINE Quad_mesh_deviation deviation_of_quad_mesh(const Indexed_quad_mesh& m,
                                                                    const Indexed_reference& reference);

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief compares a quad mesh with the triangle mesh that it stands for.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam NamedParametersQM a sequence of named parameters
 * \tparam NamedParametersTM a sequence of named parameters
 *
 * \param qm the quad mesh
 * \param tm the triangle mesh
 * \param np_qm an optional sequence of named parameters for `qm`: `vertex_point_map`
 * \param np_tm an optional sequence of named parameters for `tm`: `vertex_point_map`,
 *        `edge_is_constrained_map` that tells the feature edges (by default none), and `face_direction_map` with an
 *        optional vector, in its plane, for each face (by default none)
 *
 * \pre `CGAL::is_quad_mesh(qm)` and `CGAL::is_triangle_mesh(tm)`; both have faces, `tm` one of positive
 *      area; no vertex is non-manifold
 */
template <typename QuadMesh, typename TriangleMesh, typename NamedParametersQM = parameters::Default_named_parameters,
          typename NamedParametersTM = parameters::Default_named_parameters>
Quad_mesh_deviation quad_mesh_deviation(const QuadMesh& qm, const TriangleMesh& tm,
                                        const NamedParametersQM& np_qm = parameters::default_values(),
                                        const NamedParametersTM& np_tm = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename boost::graph_traits<QuadMesh>::edge_descriptor edge_descriptor;

  CGAL_precondition(is_quad_mesh(qm));
  CGAL_precondition(is_triangle_mesh(tm));
  const auto vpm =
    choose_parameter(get_parameter(np_qm, internal_np::vertex_point), get_const_property_map(vertex_point, qm));
  return internal::deviation_of_quad_mesh(
    internal::make_indexed_quad_mesh(qm, vpm, Static_boolean_property_map<edge_descriptor, false>()).mesh,
    internal::make_indexed_reference<internal_np::face_direction_map_t>(tm, np_tm));
}

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Quad_mesh/internal/quad_mesh_deviation_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEVIATION_H
