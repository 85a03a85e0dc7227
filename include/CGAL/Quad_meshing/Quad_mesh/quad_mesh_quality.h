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
#include <CGAL/Quad_meshing/internal/Quad_shape.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
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
 * length: 1 for a rectangle, not positive for a quad that is not strictly convex (Knupp: *Algebraic mesh quality metrics*, SIAM J. Sci. Comput. 23(1), 2001).
 */
struct Quad_mesh_quality
{
  std::size_t number_of_quads = 0;

  /// \name Interior angles, in degrees
  /// @{
  double mean_angle_deviation = 0;       ///< mean of \f$|\alpha-90|\f$ over all corners
  double maximal_angle_deviation = 0;    ///< the largest of these
  double minimal_angle = 0;              ///< the smallest angle
  double maximal_angle = 0;              ///< the largest angle
  /// number of corners per ten degrees; the last one counts the reflex angles.
  std::array<std::size_t, 19> angle_histogram = {{}};
  /// @}

  /// \name Edge lengths
  /// @{
  double mean_edge_length = 0;           ///< mean over the edges
  double edge_length_variation = 0;      ///< standard deviation over the mean
  double minimal_edge_length = 0;        ///< the shortest edge
  double maximal_edge_length = 0;        ///< the longest edge
  double mean_aspect_ratio = 0;          ///< mean of the longest over the shortest side of a quad
  double maximal_aspect_ratio = 0;       ///< the largest of these, infinity if a side has no length
  /// number of edges per tenth of the mean length; the last one counts those of at least twice the mean.
  std::array<std::size_t, 21> edge_length_histogram = {{}};
  /// @}

  /// \name Scaled Jacobians
  /// @{
  double minimal_scaled_jacobian = 0;           ///< of the worst quad
  double mean_scaled_jacobian = 0;              ///< mean over the quads
  std::size_t number_of_inverted_quads = 0;     ///< quads whose scaled Jacobian is not positive
  /// number of quads per tenth; the first one counts the inverted quads.
  std::array<std::size_t, 11> scaled_jacobian_histogram = {{}};
  /// @}

  /// \name Planarity
  /// The gap between the two diagonals of a quad over its mean side.
  /// @{
  double mean_planarity = 0;             ///< mean over the quads, 0 if all are planar
  double maximal_planarity = 0;          ///< the largest
  /// @}

  double area = 0;                       ///< sum of the areas of the quads' projections along their normals
};

namespace internal {

inline Quad_shape shape_of_quad(const Indexed_quad_mesh& m, int f)
{
  const std::array<int, 4>& c = m.corners[f];
  return shape_of_quad({{ m.points[c[0]], m.points[c[1]], m.points[c[2]], m.points[c[3]] }});
}

inline Quad_mesh_quality quality_of_quad_mesh(const Indexed_quad_mesh& m)
{
  Quad_mesh_quality q;
  const std::size_t n = m.corners.size();
  q.number_of_quads = n;
  if(n == 0)
    return q;

  q.minimal_angle = 360;
  q.minimal_scaled_jacobian = 1;
  std::vector<double> lengths;
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    const Quad_shape s = shape_of_quad(m, f);
    for(int k = 0; k < 4; ++k)
    {
      const double a = s.angle[k], deviation = CGAL::abs(a - 90);
      q.mean_angle_deviation += deviation / (4 * n);
      q.maximal_angle_deviation = (std::max)(q.maximal_angle_deviation, deviation);
      q.minimal_angle = (std::min)(q.minimal_angle, a);
      q.maximal_angle = (std::max)(q.maximal_angle, a);
      ++q.angle_histogram[(std::min)(18, static_cast<int>(a / 10))];
      if(m.edge(4 * f + k) == 4 * f + k)
        lengths.push_back(s.length[k]);
    }
    const double sj = s.minimal_scaled_jacobian();
    q.mean_scaled_jacobian += sj / n;
    q.minimal_scaled_jacobian = (std::min)(q.minimal_scaled_jacobian, sj);
    q.number_of_inverted_quads += !(sj > 0);
    ++q.scaled_jacobian_histogram[sj > 0 ? 1 + (std::min)(9, static_cast<int>(sj * 10)) : 0];
    q.mean_planarity += s.planarity / n;
    q.maximal_planarity = (std::max)(q.maximal_planarity, s.planarity);
    q.mean_aspect_ratio += s.aspect_ratio() / n;
    q.maximal_aspect_ratio = (std::max)(q.maximal_aspect_ratio, s.aspect_ratio());
    q.area += s.area;
  }

  q.mean_edge_length = std::accumulate(lengths.begin(), lengths.end(), 0.) / lengths.size();
  q.minimal_edge_length = *std::min_element(lengths.begin(), lengths.end());
  q.maximal_edge_length = *std::max_element(lengths.begin(), lengths.end());
  double variance = 0;
  for(double l : lengths)
  {
    variance += CGAL::square(l - q.mean_edge_length) / lengths.size();
    if(q.mean_edge_length > 0)
      ++q.edge_length_histogram[static_cast<int>((std::min)(20., 10 * l / q.mean_edge_length))];
  }
  q.edge_length_variation = q.mean_edge_length > 0 ? std::sqrt(variance) / q.mean_edge_length : 0;
  return q;
}

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
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename boost::graph_traits<QuadMesh>::edge_descriptor edge_descriptor;

  CGAL_precondition(is_quad_mesh(qm));
  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_const_property_map(vertex_point, qm));
  return internal::quality_of_quad_mesh(
    internal::make_indexed_quad_mesh(qm, vpm, Static_boolean_property_map<edge_descriptor, false>()).mesh);
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
std::vector<std::pair<typename boost::graph_traits<QuadMesh>::face_descriptor, double> >
worst_quads(const QuadMesh& qm, std::size_t number, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename boost::graph_traits<QuadMesh>::edge_descriptor edge_descriptor;

  CGAL_precondition(is_quad_mesh(qm));
  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_const_property_map(vertex_point, qm));
  const auto copy =
    internal::make_indexed_quad_mesh(qm, vpm, Static_boolean_property_map<edge_descriptor, false>());

  std::vector<std::pair<double, int> > order;
  for(int f = 0; f < copy.mesh.number_of_faces(); ++f)
    order.emplace_back(internal::shape_of_quad(copy.mesh, f).minimal_scaled_jacobian(), f);
  number = (std::min)(number, order.size());
  std::partial_sort(order.begin(), order.begin() + number, order.end());

  std::vector<std::pair<typename boost::graph_traits<QuadMesh>::face_descriptor, double> > worst;
  for(std::size_t i = 0; i < number; ++i)
    worst.emplace_back(copy.faces[order[i].second], order[i].first);
  return worst;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_QUALITY_H
