// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_H
#define CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_H

#include <CGAL/Quad_meshing/Fields/Cross_field_result.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Fields/internal/constrain_faces.h>
#include <CGAL/Quad_meshing/Fields/internal/face_lengths.h>
#include <CGAL/Quad_meshing/Fields/internal/solve_field.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/triangle_mesh_parameters.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief computes a smooth cross field that follows given directions.
 *
 * A cross field has four directions in every face, a right angle apart. It is described by the angle
 * of the first one and by one integer per edge, the period jump, that says which direction of the
 * neighbor continues it. With \f$ \kappa_{ij} \f$ the angle between the reference directions of two
 * neighboring faces, the field minimizes
 * \f$ E = \sum (\theta_i + \kappa_{ij} + \frac{\pi}{2} p_{ij} - \theta_j)^2 \f$
 * over all angles and all period jumps, as far as that can be done in little time; the minimum
 * decides where the singularities lie \cgalCite{BZK09}. Both faces at a constrained edge have a direction along it.
 *
 * Between two consecutive constrained edges at a vertex the field turns by a multiple of a right
 * angle, and by at least one: no sector is without a quad, however narrow. The result says so if a sector
 * consists of a single face with two constrained edges and can therefore not be given one.
 *
 * The mesh may be closed or bounded, of any genus and of several components. Faces of zero
 * area are allowed; a vertex around which the faces form several fans, as where two border loops touch, is not: the
 * index of the field at such a vertex has no meaning. The result does not depend on anything but the input.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceAngleMap a model of `WritablePropertyMap` with the face descriptor of `TriangleMesh` as key and `double`
 *   as value type
 * \tparam EdgePeriodJumpMap a model of `WritablePropertyMap` with the edge descriptor as key and `int` as value type
 * \tparam VertexSingularityMap a model of `WritablePropertyMap` with the vertex descriptor as key and `int` as value
 * type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param tm the triangle mesh
 * \param angle gets the angle, in radians and counterclockwise about the normal, from the vector of
 *   `halfedge(f, tm)` to the first direction of the cross of `f`; it lies in \f$ [-\pi/4, \pi/4] \f$
 * \param period_jump gets \f$ p_{ij} \f$ with `i` the face of `halfedge(e, tm)` and `j` the face of
 *   its opposite, for the edge descriptors `e` that `edges(tm)` enumerates (a descriptor made by `edge(h, tm)` may
 *   have the other orientation); 0 for border edges. Direction `a` of the cross of `i` continues as direction `a - p`
 *   in `j`.
 * \param index gets the index of the field at a vertex in quarters. For an inner vertex it is 4 minus
 *   the number of quads around it: 1 for valence 3, -1 for valence 5. For a vertex on the border it
 *   is 2 minus this number. The sum of all indices is four times the Euler number if the field is aligned with the
 *   border.
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{the edges the field is aligned with}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key and `bool` as value type}
 *     \cgalParamDefault{no edge is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{align_boundary}
 *     \cgalParamDescription{whether border edges are constrained}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_direction_map}
 *     \cgalParamDescription{directions the field interpolates. They are projected to the planes of
 *       their faces. Faces next to constrained edges follow the edge.}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the face descriptor as key and
 *       `std::optional<Vector_3>`, `boost::optional<Vector_3>` or a type like them as value type}
 *     \cgalParamDefault{no direction is given}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_direction_weight_map}
 *     \cgalParamDescription{how much the directions count: the weight of the squared deviation, in radians, against the
 *       squared differences across edges. With an infinite weight the direction is hard, with 0 or less it does not
 *       count. `GREEDY`, `DIRECT` and `NAIVE` choose period jumps by the hard directions alone.}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the face descriptor as key and `double` as value type}
 *     \cgalParamDefault{all directions are hard}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_edge_length}
 *     \cgalParamDescription{the edge length of the quad mesh the field is made for. If it is given, inner vertices
 *       get three quads or more, where others can spare one, and opposite singularities closer to each other than half
 *       of it annihilate each other, unless one lies on a constrained edge: no grid with such quads has room for both.
 *       With `Cross_field_method::POLISHED`, and only there, singularities are also kept off places that are closer
 *       than half of it to a constrained edge without being on it, if that costs little energy.}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{only the smoothness counts: singularities may be anywhere and have any index}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_sizing_map}
 *     \cgalParamDescription{the target edge length per face, positive; takes precedence over `target_edge_length`. The
 *       field is then smooth in the metric in which all quads have the same size, the only one in which quads of these
 *       sizes can follow it: it turns, and has singularities, where the sizes change.}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the face descriptor as key and `double` as value type}
 *     \cgalParamDefault{`target_edge_length` everywhere}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{prescribed_index_map}
 *     \cgalParamDescription{the index that the field must have at inner vertices without constrained edges, in
 *       quarters, at most 3; 0 forbids a singularity. `Cross_field_result::unmet_prescriptions` counts those that
 *       could not be met: where the sum of the indices leaves no other vertex to make up for them.}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and `std::optional<int>` or a
 *       type like it as value type}
 *     \cgalParamDefault{none is prescribed}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{cross_field_method}
 *     \cgalParamDescription{how the period jumps are found}
 *     \cgalParamType{`Cross_field_method`}
 *     \cgalParamDefault{`Cross_field_method::POLISHED`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{singularity_cost}
 *     \cgalParamDescription{what every quarter of the index of a singularity costs in units of the energy, besides the
 *       energy: the local search keeps a pair of singularities only if the field is that much better with it, smoother
 *       or nearer to soft directions. A single singularity adds about 0.5 to the energy by itself. For `POLISHED` and
 *       `GREEDY_AND_SEARCH`}
 *     \cgalParamType{`double`, 0 or more}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{rounding_tolerance}
 *     \cgalParamDescription{the accuracy to which the levels of greedy rounding update the field, in units of the
 *       variables; for `GREEDY` and `GREEDY_AND_SEARCH`, like the next three. See `solve_mixed_integer()`.}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`3e-4`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{gauss_seidel_iterations}
 *     \cgalParamDescription{the number of local Gauss-Seidel steps per rounding; 0 switches the level off}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{`20000`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{conjugate_gradient_iterations}
 *     \cgalParamDescription{the number of steps of the conjugate gradient per rounding; 0 switches the level off}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{`10`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{allow_refactorization}
 *     \cgalParamDescription{whether greedy rounding may compute new factorizations}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_bound_rounds}
 *     \cgalParamDescription{the number of rounds of the relaxation that proves a lower bound of the energy, for meshes
 *       of at most a few hundred triangles: six take some seconds with 100 integers, and each step takes time cubic in
 *       them. See `solve_mixed_integer()`.}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{is told about stages and may stop them, see `Default_visitor`}
 *     \cgalParamType{a class like `Default_visitor`, passed with `std::ref()`}
 *     \cgalParamDefault{`Default_visitor`}
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
 * \return the energy and other figures. If its status is not `SUCCESS` it says why; unless it is `EMPTY_SECTORS`,
 * nothing was written to the maps.
 *
 * \sa `cross_field_direction()`
 * \sa `cross_field_indices()`
 */
template <typename TriangleMesh, typename FaceAngleMap, typename EdgePeriodJumpMap, typename VertexSingularityMap,
          typename NamedParameters = parameters::Default_named_parameters>
Cross_field_result smooth_cross_field(const TriangleMesh& tm, FaceAngleMap angle, EdgePeriodJumpMap period_jump,
                                      VertexSingularityMap index,
                                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  typedef
    typename internal_np::Lookup_named_param_def<internal_np::face_direction_map_t, NamedParameters,
                                                 internal::No_face_direction<face_descriptor>>::type Face_direction_map;

  internal::check_parameters<
    NamedParameters, internal_np::edge_is_constrained_t, internal_np::align_boundary_t,
    internal_np::face_direction_map_t, internal_np::face_direction_weight_map_t, internal_np::target_edge_length_t,
    internal_np::cross_field_method_t, internal_np::singularity_cost_t, internal_np::rounding_tolerance_t,
    internal_np::gauss_seidel_iterations_t, internal_np::conjugate_gradient_iterations_t,
    internal_np::allow_refactorization_t, internal_np::number_of_bound_rounds_t, internal_np::face_sizing_map_t,
    internal_np::prescribed_index_map_t, internal_np::visitor_t, internal_np::vertex_point_t,
    internal_np::vertex_index_t, internal_np::face_index_t>();
  constexpr bool has_edge_map =
    internal::map_parameter_is_readable<internal_np::edge_is_constrained_t, NamedParameters, edge_descriptor, bool>();
  static_assert(has_edge_map, "edge_is_constrained_map must give a bool for every edge of the triangle mesh.");
  constexpr bool has_direction_map =
    internal::map_parameter_gives_optionals<internal_np::face_direction_map_t, NamedParameters, face_descriptor>();
  static_assert(has_direction_map,
                "face_direction_map must give an optional vector for every face of the triangle mesh.");

  const Face_direction_map direction = choose_parameter(get_parameter(np, internal_np::face_direction_map),
                                                        internal::No_face_direction<face_descriptor>());

  internal::Field_options options;
  options.method = choose_parameter(get_parameter(np, internal_np::cross_field_method), Cross_field_method::POLISHED);
  options.target_edge_length = to_double(choose_parameter(get_parameter(np, internal_np::target_edge_length), 0.));
  options.number_of_bound_rounds = choose_parameter(get_parameter(np, internal_np::number_of_bound_rounds), 0);
  options.singularity_cost = to_double(choose_parameter(get_parameter(np, internal_np::singularity_cost), 0.));
  options.rounding_tolerance =
    choose_parameter(get_parameter(np, internal_np::rounding_tolerance), options.rounding_tolerance);
  options.gauss_seidel_iterations =
    choose_parameter(get_parameter(np, internal_np::gauss_seidel_iterations), options.gauss_seidel_iterations);
  options.conjugate_gradient_iterations = choose_parameter(
    get_parameter(np, internal_np::conjugate_gradient_iterations), options.conjugate_gradient_iterations);
  options.allow_refactorization =
    choose_parameter(get_parameter(np, internal_np::allow_refactorization), options.allow_refactorization);
  const bool align_boundary = choose_parameter(get_parameter(np, internal_np::align_boundary), true);

  Real_timer timer;
  timer.start();
  Cross_field_result result;
  auto finish = [&](Cross_field_status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    result.seconds = timer.time();
    return result;
  };

  if(!is_triangle_mesh(tm))
    return finish(Cross_field_status::NOT_A_TRIANGLE_MESH, "The mesh has a face that is not a triangle.");

  const auto fim = internal::face_numbers(tm, np);
  const auto vim = internal::vertex_numbers(tm, np);
  const internal::Indexed_triangle_mesh mesh = internal::make_indexed_triangle_mesh(tm, np);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(!internal::is_finite(mesh.points[v]))
      return finish(Cross_field_status::POINT_NOT_FINITE,
                    "Vertex " + std::to_string(v) + " has a coordinate that is not a finite number.");
  if(mesh.non_manifold_vertex != -1)
    return finish(Cross_field_status::NON_MANIFOLD_VERTEX, internal::non_manifold_message(mesh));

  internal::Field_problem problem(mesh);
  const std::vector<char> is_constrained = internal::constrained_edges(tm, np);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    problem.aligned[e] = is_constrained[e] || (align_boundary && mesh.is_border_edge(e));
  problem.constrain_faces_to_aligned_edges();
  for(auto f : faces(tm))
  {
    double weight = (std::numeric_limits<double>::infinity)();
    if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::face_direction_weight_map_t>::value)
      weight = to_double(get(get_parameter(np, internal_np::face_direction_weight_map), f));
    internal::constrain_face(problem, static_cast<int>(get(fim, f)), get(direction, f), weight);
  }
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::face_sizing_map_t>::value)
  {
    const std::vector<double> lengths = internal::face_lengths(tm, mesh.corners.size(), np);
    if(!std::all_of(lengths.begin(), lengths.end(), [](double l) { return l > 0 && std::isfinite(l); }))
      return finish(Cross_field_status::INVALID_LENGTH, "A target edge length is not a positive number.");
    const bool is_constant =
      std::all_of(lengths.begin(), lengths.end(), [&](double l) { return l == lengths.front(); });
    if(!is_constant)
      problem.set_lengths(lengths);
    if(!lengths.empty())
      options.target_edge_length = is_constant ? lengths.front() : internal::mean_length(mesh, lengths);
  }
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::prescribed_index_map_t>::value)
  {
    for(auto v : vertices(tm))
      if(const auto i = get(get_parameter(np, internal_np::prescribed_index_map), v))
      {
        problem.prescribed_quads.resize(mesh.number_of_vertices(), internal::Field_problem::any_quads);
        problem.prescribed_quads[get(vim, v)] = 4 - *i;
      }
  }
  const bool is_for_quads = options.method == Cross_field_method::POLISHED && options.target_edge_length > 0;
  if(is_for_quads || options.method == Cross_field_method::REPRESENTATION)
    problem.set_surface_weights();
  problem.find_components();
  problem.sectors = internal::make_field_sectors(mesh, problem.aligned);

  internal::Cross_field field;
  internal::Named_visitor<NamedParameters> visitor(np);
  const Cross_field_status status = internal::solve_field(problem, options, visitor, field, result);
  if(status != Cross_field_status::SUCCESS && status != Cross_field_status::EMPTY_SECTORS)
    return finish(status, status == Cross_field_status::STOPPED
                            ? "The visitor stopped the computation of the cross field."
                            : "A linear system of the cross field could not be factorized.");

  for(auto f : faces(tm))
    put(angle, f, field.angle[get(fim, f)]);
  for(edge_descriptor ed : edges(tm))
    if(is_border(ed, tm))
      put(period_jump, ed, 0);
  internal::for_each_edge_of_faces(tm,
                                   [&](edge_descriptor ed, int e)
                                   {
                                     if(!mesh.is_border_edge(e))
                                       put(period_jump, ed, field.period_jump[e]);
                                   });
  const std::vector<int> indices = internal::field_indices(problem, field);
  for(auto v : vertices(tm))
  {
    const int i = indices[get(vim, v)];
    put(index, v, i);
    result.singularities += i != 0;
    result.index_sum += i;
    if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::prescribed_index_map_t>::value)
    {
      const auto wish = get(get_parameter(np, internal_np::prescribed_index_map), v);
      result.unmet_prescriptions += wish && *wish != i;
    }
  }
  if(status == Cross_field_status::EMPTY_SECTORS)
    return finish(status, "The cross field was computed, but " + std::to_string(result.empty_sectors) +
                            " sectors between two constrained edges have no room for a quad.");
  if(result.unmet_prescriptions != 0)
    return finish(status, "The cross field was computed, but " + std::to_string(result.unmet_prescriptions) +
                            " vertices do not have the index that is prescribed.");
  return finish(status, "The cross field was computed.");
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_CROSS_FIELD_H
