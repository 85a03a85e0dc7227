// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_QUALITY_H
#define CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_QUALITY_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>
#include <CGAL/Quad_meshing/internal/quad_mesh_parameters.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief holds the shape measures of the elements of a quad mesh.
 *
 * The normal of a quad is the direction of the cross product of its diagonals. The interior angle
 * at a corner counts as reflex (above 180 degrees), and the *Jacobian* there as negative, if the
 * corner is turned over with respect to that normal. The *scaled Jacobian* of a quad is the smallest
 * of the signed areas of the parallelograms at its four corners when all sides are scaled to unit
 * length: 1 for a rectangle, not positive for a quad that is not strictly convex (Knupp: *Algebraic mesh quality
 * metrics*, SIAM J. Sci. Comput. 23(1), 2001).
 */
struct Quad_mesh_quality
{
  std::size_t number_of_quads = 0;

  /// \name Interior angles, in degrees
  /// @{
  double mean_angle_deviation = 0;    ///< mean of \f$|\alpha-90|\f$ over all corners
  double maximal_angle_deviation = 0; ///< the largest of these
  double minimal_angle = 0;           ///< the smallest angle
  double maximal_angle = 0;           ///< the largest angle
  /// number of corners per ten degrees; the last one counts the reflex angles.
  std::array<std::size_t, 19> angle_histogram = { {} };
  /// @}

  /// \name Edge lengths
  /// @{
  double mean_edge_length = 0;      ///< mean over the edges
  double edge_length_variation = 0; ///< standard deviation over the mean
  double minimal_edge_length = 0;   ///< the shortest edge
  double maximal_edge_length = 0;   ///< the longest edge
  double mean_aspect_ratio = 0;     ///< mean of the longest over the shortest side of a quad
  double maximal_aspect_ratio = 0;  ///< the largest of these, infinity if a side has no length
  /// number of edges per tenth of the mean length; the last one counts those of at least twice the mean.
  std::array<std::size_t, 21> edge_length_histogram = { {} };
  /// @}

  /// \name Scaled Jacobians
  /// @{
  double minimal_scaled_jacobian = 0;       ///< of the worst quad
  double mean_scaled_jacobian = 0;          ///< mean over the quads
  std::size_t number_of_inverted_quads = 0; ///< quads whose scaled Jacobian is not positive
  /// number of quads per tenth; the first one counts the inverted quads.
  std::array<std::size_t, 11> scaled_jacobian_histogram = { {} };
  /// @}

  /// \name Planarity
  /// The gap between the two diagonals of a quad over its mean side.
  /// @{
  double mean_planarity = 0;    ///< mean over the quads, 0 if all are planar
  double maximal_planarity = 0; ///< the largest
  /// @}

  double area = 0; ///< sum of the areas of the quads' projections along their normals
};

namespace internal {

CGAL_QUAD_MESHING_INLINE Quad_mesh_quality quality_of_quad_mesh(const Indexed_quad_mesh& m);

// The quads of smallest scaled Jacobian, at most so many, as (scaled Jacobian, face), the worst one first.
CGAL_QUAD_MESHING_INLINE std::vector<std::pair<double, int>> worst_quads_of(const Indexed_quad_mesh& m,
                                                                            std::size_t number);

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief measures the angles, edge lengths, scaled Jacobians and planarity of a quad mesh.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param qm the mesh
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `qm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, qm)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \pre `CGAL::is_quad_mesh(qm)`
 *
 * \sa `worst_quads()`
 */
template <typename QuadMesh, typename NamedParameters = parameters::Default_named_parameters>
Quad_mesh_quality quad_mesh_quality(const QuadMesh& qm, const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition(is_quad_mesh(qm));
  return internal::quality_of_quad_mesh(internal::make_indexed_quad_mesh(qm, np).mesh);
}

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief lists the quads of smallest scaled Jacobian.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param qm the mesh
 * \param number the number of quads to list; all of them if there are fewer
 * \param np an optional sequence of named parameters, as for `quad_mesh_quality()`
 *
 * \return the quads with their scaled Jacobians, the worst one first
 *
 * \pre `CGAL::is_quad_mesh(qm)`
 */
template <typename QuadMesh, typename NamedParameters = parameters::Default_named_parameters>
std::vector<std::pair<typename boost::graph_traits<QuadMesh>::face_descriptor, double>>
worst_quads(const QuadMesh& qm, std::size_t number, const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition(is_quad_mesh(qm));
  const auto copy = internal::make_indexed_quad_mesh(qm, np);

  std::vector<std::pair<typename boost::graph_traits<QuadMesh>::face_descriptor, double>> worst;
  for(const std::pair<double, int>& quad : internal::worst_quads_of(copy.mesh, number))
    worst.emplace_back(copy.faces[quad.second], quad.first);
  return worst;
}

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Quad_mesh/internal/quad_mesh_quality_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_QUALITY_H
