// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_REFINE_DISTANCE_FIELD_H
#define CGAL_QUAD_MESHING_GEODESICS_REFINE_DISTANCE_FIELD_H

#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_field.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_refinement.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/copy_face_graph.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingGeodesicsRef
 * \brief holds what `refine_distance_field()` has to say about its result.
 */
struct Distance_refinement_result
{
  /// the largest difference between the distance and its linear interpolation on an edge of the input
  double initial_error = 0;
  /// the same for the refined mesh
  double error = 0;
  /// the number of faces of the refined mesh
  std::size_t number_of_faces = 0;
  /// whether the tolerance is met
  bool is_within_tolerance = false;

  /// returns whether the tolerance is met.
  explicit operator bool() const { return is_within_tolerance; }
};

/*!
 * \ingroup PkgQuadMeshingGeodesicsRef
 *
 * \brief refines a mesh until the linear interpolation of the distance at its vertices is close to the distance on all
 * of its edges.
 *
 * The surface does not change, and the field is not computed again: its windows tell the distance of every new vertex.
 * Edges are split where their error is largest, so that vertices come to lie on the ridges of the distance and few are
 * needed; triangles with three split edges are divided into four similar ones.
 *
 * \tparam TriangleMesh the type of the mesh of the field
 * \tparam RefinedMesh a model of `MutableFaceGraph` with an internal point property
 * \tparam VertexDistanceMap a model of `WritablePropertyMap` with
 * `boost::graph_traits<RefinedMesh>::%vertex_descriptor` as key type and `double` as value type
 *
 * \param field a field after `propagate()`, with its windows kept
 * \param refined the output, to which the refined mesh is added
 * \param distances receives the distances of the vertices of the refined mesh; infinity where no source reaches
 * \param tolerance the largest difference allowed, a length
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{maximum_number_of_faces}
 *     \cgalParamDescription{the refinement ends after the round in which this number is reached, whether the tolerance
 *       is met or not}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{256 times the number of faces of the input}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \pre `tolerance > 0`
 */
template <typename TriangleMesh, typename RefinedMesh, typename VertexDistanceMap,
          typename NamedParameters = parameters::Default_named_parameters>
Distance_refinement_result refine_distance_field(const Geodesic_distance_field<TriangleMesh>& field,
                                                 RefinedMesh& refined, VertexDistanceMap distances, double tolerance,
                                                 const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef internal::Field_refinement Refinement;

  CGAL_precondition(tolerance > 0);
  const std::size_t default_maximum =
    256 * static_cast<std::size_t>(internal::Field_access::mesh(field).number_of_faces());
  const std::size_t maximum_faces =
    choose_parameter(get_parameter(np, internal_np::maximum_number_of_faces), default_maximum);
  Distance_refinement_result result;
  const auto* propagation = internal::Field_access::propagation(field);
  if(propagation == nullptr)
    return result;

  Refinement refinement(internal::Field_access::mesh(field), *propagation, internal::Field_access::sources(field));
  result.error = refinement.refine(tolerance, maximum_faces);
  result.initial_error = refinement.initial_error();
  result.number_of_faces = refinement.mesh().number_of_faces();
  result.is_within_tolerance = result.error <= tolerance;

  typedef typename boost::graph_traits<RefinedMesh>::vertex_descriptor vertex_descriptor;
  const auto write = [&](const std::pair<Refinement::Vertex, vertex_descriptor>& copy)
  {
    const double d = refinement.distance(copy.first);
    put(distances, copy.second,
        d < internal::Window_propagation<double>::unreached() ? d : std::numeric_limits<double>::infinity());
  };
  copy_face_graph(refinement.mesh(), refined,
                  parameters::vertex_to_vertex_output_iterator(boost::make_function_output_iterator(write)));
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_REFINE_DISTANCE_FIELD_H
