// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_INDICES_H
#define CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_INDICES_H

#include <CGAL/Quad_meshing/Fields/Cross_field_report.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Fields/internal/inspect_field.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

// Inspects a field. `visit_index(v, i)` is told the index of every vertex, and returns the one that the map holds.
template <typename TriangleMesh, typename FaceAngleMap, typename EdgePeriodJumpMap, typename VisitIndex,
          typename NamedParameters>
Cross_field_report<TriangleMesh> report_on_cross_field(const TriangleMesh& tm, FaceAngleMap angle,
                                                       EdgePeriodJumpMap period_jump, const VisitIndex& visit_index,
                                                       const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef Cross_field_report_status Status;

  check_parameters<NamedParameters, internal_np::edge_is_constrained_t, internal_np::align_boundary_t,
                   internal_np::vertex_point_t, internal_np::vertex_index_t, internal_np::face_index_t>();
  constexpr bool has_edge_map =
    map_parameter_is_readable<internal_np::edge_is_constrained_t, NamedParameters, edge_descriptor, bool>();
  static_assert(has_edge_map, "edge_is_constrained_map must give a bool for every edge of the triangle mesh.");

  const bool align_boundary = choose_parameter(get_parameter(np, internal_np::align_boundary), true);
  const auto constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                            Static_boolean_property_map<edge_descriptor, false>());

  Cross_field_report<TriangleMesh> report;
  auto add = [&](Status status, const std::string& message)
  {
    if(report.status == Status::CONSISTENT)
      report.status = status;
    report.message += (report.message.empty() ? "" : " ") + message;
  };
  auto count = [&](std::size_t n, Status status, const char* one, const char* many)
  {
    if(n > 0)
      add(status, n == 1 ? "One " + std::string(one) : std::to_string(n) + " " + many);
  };

  if(!is_triangle_mesh(tm))
  {
    add(Status::NOT_A_TRIANGLE_MESH, "The mesh has a face that is not a triangle.");
    return report;
  }
  const Indexed_triangle_mesh mesh = make_indexed_triangle_mesh(tm, np);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(!is_finite(mesh.points[v]))
    {
      add(Status::POINT_NOT_FINITE, "Vertex " + std::to_string(v) + " has a coordinate that is not a finite number.");
      return report;
    }
  if(mesh.non_manifold_vertex != -1)
  {
    add(Status::NON_MANIFOLD_VERTEX, non_manifold_message(mesh));
    return report;
  }

  const auto fim = face_numbers(tm, np);
  const auto vim = vertex_numbers(tm, np);
  Field_problem problem(mesh);
  Cross_field field;
  field.angle.resize(mesh.number_of_faces());
  field.period_jump.assign(mesh.number_of_edges(), 0);
  for(auto f : faces(tm))
    field.angle[get(fim, f)] = get(angle, f);
  std::vector<edge_descriptor> edge_of_number;
  for_each_edge_of_faces(tm,
                         [&](edge_descriptor ed, int e)
                         {
                           edge_of_number.push_back(ed);
                           problem.aligned[e] = get(constrained, ed) || (align_boundary && mesh.is_border_edge(e));
                           if(!mesh.is_border_edge(e))
                             field.period_jump[e] = get(period_jump, ed);
                         });
  problem.sectors = make_field_sectors(mesh, problem.aligned);
  const Field_defects defects = inspect_field(problem, field);

  if(!defects.faces_not_finite.empty())
  {
    std::vector<bool> is_listed(mesh.number_of_faces(), false);
    for(int f : defects.faces_not_finite)
      is_listed[f] = true;
    for(auto f : faces(tm))
      if(is_listed[get(fim, f)])
        report.faces_not_finite.push_back(f);
    count(report.faces_not_finite.size(), Status::ANGLE_NOT_FINITE, "face has an angle that is not a finite number.",
          "faces have an angle that is not a finite number.");
    return report;
  }
  for(int e : defects.misaligned_edges)
    report.misaligned_edges.push_back(edge_of_number[e]);
  for(int e : defects.edges_with_wrong_jump)
    report.edges_with_wrong_jump.push_back(edge_of_number[e]);
  std::vector<bool> lacks_quads(mesh.number_of_vertices(), false);
  for(int v : defects.vertices_without_quads)
    lacks_quads[v] = true;
  for(auto v : vertices(tm))
  {
    const int i = defects.indices[get(vim, v)], found = visit_index(v, i);
    report.index_sum += found;
    if(found != i)
      report.vertices_with_wrong_index.push_back(v);
    if(lacks_quads[get(vim, v)])
      report.vertices_without_quads.push_back(v);
  }
  report.expected_index_sum = defects.expected_index_sum;

  count(report.misaligned_edges.size(), Status::MISALIGNED_EDGE,
        "constrained edge is not followed by the cross of a face at it.",
        "constrained edges are not followed by the cross of a face at them.");
  count(report.edges_with_wrong_jump.size(), Status::WRONG_JUMP,
        "constrained edge has a period jump that turns the direction along it.",
        "constrained edges have a period jump that turns the direction along them.");
  count(report.vertices_with_wrong_index.size(), Status::WRONG_INDEX,
        "vertex has an index that is not that of the field.", "vertices have an index that is not that of the field.");
  if(!report.vertices_with_wrong_index.empty() && align_boundary && report.index_sum != report.expected_index_sum)
    add(Status::WRONG_INDEX, "The indices sum up to " + std::to_string(report.index_sum) + " and not to " +
                               std::to_string(report.expected_index_sum) + ", four times the Euler number.");
  count(report.vertices_without_quads.size(), Status::EMPTY_SECTOR, "vertex has a sector without a quad.",
        "vertices have a sector without a quad.");
  if(report.is_valid())
    report.message = "The cross field is consistent.";
  return report;
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief computes the singularity indices of a cross field from its angles and period jumps, and tells what is wrong
 * with it.
 *
 * This is what has to be done after a cross field was edited by hand, or read from a file, before it is given to
 * `integer_grid_map()`: turning a cross by a right angle, or changing a period jump, moves quads from one vertex to
 * another. The sum of all indices of a field that follows the border is four times the Euler number, whatever its
 * period jumps are.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceAngleMap a model of `ReadablePropertyMap` with the face descriptor as key and `double` as value type
 * \tparam EdgePeriodJumpMap a model of `ReadablePropertyMap` with the edge descriptor as key and `int` as value type
 * \tparam VertexSingularityMap a model of `WritablePropertyMap` with the vertex descriptor as key and `int` as value
 * type
 *
 * \param tm the triangle mesh
 * \param angle, period_jump the field as `smooth_cross_field()` describes it
 * \param index gets the index of every vertex in quarters; nothing is written if the mesh is of no use or an angle is
 * not finite
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{the edges that the field has to be aligned with}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key and `bool` as value type}
 *     \cgalParamDefault{no edge is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{align_boundary}
 *     \cgalParamDescription{whether border edges are constrained}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a 3D point as value type}
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
 * \return what is wrong with the field; a face with two constrained edges that are neither parallel nor orthogonal
 *   counts as not following one of them
 *
 * \sa `check_cross_field()`
 */
template <typename TriangleMesh, typename FaceAngleMap, typename EdgePeriodJumpMap, typename VertexSingularityMap,
          typename NamedParameters = parameters::Default_named_parameters>
Cross_field_report<TriangleMesh> cross_field_indices(const TriangleMesh& tm, FaceAngleMap angle,
                                                     EdgePeriodJumpMap period_jump, VertexSingularityMap index,
                                                     const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  return internal::report_on_cross_field(
    tm, angle, period_jump,
    [&](vertex_descriptor v, int i)
    {
      put(index, v, i);
      return i;
    },
    np);
}

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief tells whether a cross field is consistent: its crosses follow the constrained edges, its period jumps continue
 * the directions along them, its indices are those of its angles and period jumps, and no sector is without a quad.
 *
 * The parameters are those of `cross_field_indices()`; `index` is read, not written.
 *
 * \tparam VertexSingularityMap a model of `ReadablePropertyMap` with the vertex descriptor as key and `int` as value
 * type
 *
 * \sa `cross_field_indices()`
 */
template <typename TriangleMesh, typename FaceAngleMap, typename EdgePeriodJumpMap, typename VertexSingularityMap,
          typename NamedParameters = parameters::Default_named_parameters>
Cross_field_report<TriangleMesh> check_cross_field(const TriangleMesh& tm, FaceAngleMap angle,
                                                   EdgePeriodJumpMap period_jump, VertexSingularityMap index,
                                                   const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  return internal::report_on_cross_field(
    tm, angle, period_jump, [&](vertex_descriptor v, int) { return get(index, v); }, np);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_INDICES_H
