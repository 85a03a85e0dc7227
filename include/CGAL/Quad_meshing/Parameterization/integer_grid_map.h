// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTEGER_GRID_MAP_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTEGER_GRID_MAP_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Mixed_integer/Rounding_method.h>
#include <CGAL/Quad_meshing/Parameterization/Integer_grid_map_result.h>
#include <CGAL/Quad_meshing/Parameterization/internal/solve_grid_map.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/read_parameter.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief computes an integer-grid map that follows a cross field.

The mesh is cut to disks through all singular vertices, the field is combed over them, and the map is sought whose
gradients are nearest to the combed directions, divided by the target edge length [Bom12, 8.4]. Singular vertices have
to lie on grid points, constrained edges and border edges on grid lines, and the transitions across cuts have to be
grid automorphisms. All these linear conditions are eliminated in integer arithmetic before anything is optimized. Then

- the map without integer conditions is computed and fold-overs are removed from it;
- the integers are rounded with the given method; grid points and lines that meet in the rounded map, but not in the one
  before, are kept apart by further conditions, and the rounding is repeated;
- fold-overs that the integers leave are removed by minimizing the regularized distortion of
  Garanzha et al., "Foldover-free maps in 50 lines of code" (2021), where they are;
- real variables are rounded to multiples of a power of two, so that every condition holds exactly for the numbers
written.

The result is `VALID` if no triangle is folded, by exact predicates; `is_integer_grid_map()` then says yes, too. That is
no guarantee to find such a map: if integers leave no room for one, the result is `FOLDED` and names the faces.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam FaceAngleMap a model of `ReadablePropertyMap` with the faces as keys and `double` as value type
\tparam EdgePeriodJumpMap a model of `ReadablePropertyMap` with the edges as keys and `int` as value type
\tparam VertexSingularityMap a model of `ReadablePropertyMap` with the vertices as keys and `int` as value type
\tparam HalfedgeUVMap a model of `WritablePropertyMap` with the halfedges as keys and a two-dimensional point
        that can be constructed from two `double` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh; a triangle with two constrained edges cannot be mapped without being folded, see
       `split_for_alignment()`
\param angle, period_jump, index the cross field as `smooth_cross_field()` writes it, aligned with the constrained
       edges; see `check_cross_field()` for one that was edited
\param uv receives the map: for each halfedge that is no border halfedge, the image of its target in the chart of its
face
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length of a quad edge, in the unit of the points}
    \cgalParamType{`double`}
    \cgalParamDefault{the mean edge length of `tm`}
  \cgalParamNEnd
  \cgalParamNBegin{face_sizing_map}
    \cgalParamDescription{the target edge length per face; takes precedence over `target_edge_length`}
    \cgalParamType{a model of `ReadablePropertyMap` with the faces as keys and `double` as value type}
    \cgalParamDefault{constant}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that have to lie on grid lines}
    \cgalParamType{a model of `ReadablePropertyMap` with the edges as keys and `bool` as value type}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
  \cgalParamNBegin{align_boundary}
    \cgalParamDescription{whether border edges have to lie on grid lines; the field must be aligned likewise}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{rounding_method}
    \cgalParamDescription{how integers are chosen}
    \cgalParamType{`Rounding_method`}
    \cgalParamDefault{`Rounding_method::GREEDY`}
  \cgalParamNEnd
  \cgalParamNBegin{anisotropy_weight}
    \cgalParamDescription{the weight of the length of quads against their direction, in (0, 1] [Bom12, 8.4, "Anisotropic
    norm"]}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{stiffening_iterations}
    \cgalParamDescription{the largest number of times that the energy is weighted anew where triangles are distorted
                          [Bom12, 8.4, "Local stiffening"], as long as there are folded ones}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{5}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_threads}
    \cgalParamDescription{how many threads may work at the same time; the result does not depend on it}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told about the stages and may stop them, see `Default_visitor`; pass it by `std::ref`}
    \cgalParamDefault{`Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the figures and, if there are any, the folded faces
*/
template <typename TriangleMesh, typename FaceAngleMap, typename EdgePeriodJumpMap, typename VertexSingularityMap,
          typename HalfedgeUVMap, typename NamedParameters = parameters::Default_named_parameters>
Integer_grid_map_result integer_grid_map(const TriangleMesh& tm, FaceAngleMap angle, EdgePeriodJumpMap period_jump,
                                         VertexSingularityMap index, HalfedgeUVMap uv,
                                         const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  using parameters::is_default_parameter;

  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef Integer_grid_map_status Status;
  typedef
    typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Default_visitor>::reference
      Visitor_reference;

  constexpr bool takes_parameters = internal::Takes_parameters<
    NamedParameters, internal_np::target_edge_length_t, internal_np::face_sizing_map_t,
    internal_np::edge_is_constrained_t, internal_np::align_boundary_t, internal_np::rounding_method_t,
    internal_np::anisotropy_weight_t, internal_np::stiffening_iterations_t, internal_np::number_of_threads_t,
    internal_np::visitor_t, internal_np::vertex_point_t, internal_np::vertex_index_t, internal_np::face_index_t>::value;
  static_assert(takes_parameters, "integer_grid_map() does not take one of the named parameters.");
  constexpr bool has_edge_map =
    internal::map_parameter_is_readable<internal_np::edge_is_constrained_t, NamedParameters, edge_descriptor, bool>();
  static_assert(has_edge_map, "edge_is_constrained_map must give a bool for every edge of the triangle mesh.");
  constexpr bool has_sizing_map =
    internal::map_parameter_is_readable<internal_np::face_sizing_map_t, NamedParameters, face_descriptor, double>();
  static_assert(has_sizing_map, "face_sizing_map must give a number for every face of the triangle mesh.");

  Real_timer timer;
  timer.start();
  Integer_grid_map_result result;
  auto finished = [&](Status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    result.seconds = timer.time();
    return result;
  };

  internal::Grid_map_options options;
  internal::read_parameter(np, internal_np::rounding_method, options.rounding_method);
  internal::read_parameter(np, internal_np::anisotropy_weight, options.anisotropy_weight);
  internal::read_parameter(np, internal_np::number_of_threads, options.number_of_threads);
  internal::read_parameter(np, internal_np::stiffening_iterations, options.stiffening_iterations);
  const bool align_boundary = choose_parameter(get_parameter(np, internal_np::align_boundary), true);
  auto is_constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                         Static_boolean_property_map<edge_descriptor, false>());
  const auto vim = internal::vertex_numbers(tm, np);
  const auto fim = internal::face_numbers(tm, np);
  Default_visitor default_visitor;
  Visitor_reference visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);

  if(!is_triangle_mesh(tm))
    return finished(Status::NOT_A_TRIANGLE_MESH, "The mesh has a face that is not a triangle.");
  const internal::Indexed_triangle_mesh mesh = internal::make_indexed_triangle_mesh(tm, np);
  if(mesh.number_of_faces() == 0)
    return finished(Status::EMPTY_MESH, "The mesh has no faces.");
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(!internal::is_finite(mesh.points[v]))
      return finished(Status::VALUE_NOT_FINITE,
                      "Vertex " + std::to_string(v) + " has a coordinate that is not a finite number.");
  if(mesh.non_manifold_vertex != -1)
    return finished(Status::NON_MANIFOLD_VERTEX, internal::non_manifold_message(mesh));

  internal::Grid_map_problem problem(mesh);
  std::vector<halfedge_descriptor> first_halfedge(mesh.number_of_faces());
  double length = 0;
  if(is_default_parameter<NamedParameters, internal_np::target_edge_length_t>::value)
  {
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      length += std::sqrt(mesh.vector(mesh.halfedge_of_edge[e]).squared_length()) / mesh.number_of_edges();
  }
  else
    length = choose_parameter(get_parameter(np, internal_np::target_edge_length), 0.);
  for(face_descriptor f : faces(tm))
  {
    const std::size_t i = get(fim, f);
    problem.angle[i] = get(angle, f);
    if(!std::isfinite(problem.angle[i]))
      return finished(Status::VALUE_NOT_FINITE, "The angle of face " + std::to_string(i) + " is not a finite number.");
    first_halfedge[i] = halfedge(f, tm);
    if constexpr(is_default_parameter<NamedParameters, internal_np::face_sizing_map_t>::value)
      problem.sizing[i] = length;
    else
      problem.sizing[i] = to_double(get(get_parameter(np, internal_np::face_sizing_map), f));
    if(!(problem.sizing[i] > 0) || !std::isfinite(problem.sizing[i]))
      return finished(Status::INVALID_LENGTH, "The target edge length is not a positive number.");
  }
  internal::for_each_edge_of_faces(tm,
                                   [&](edge_descriptor e, int i)
                                   {
                                     problem.period_jump[i] = get(period_jump, e);
                                     problem.is_aligned[i] =
                                       get(is_constrained, e) || (align_boundary && mesh.is_border_edge(i));
                                   });
  for(auto v : vertices(tm))
  {
    const int i = static_cast<int>(get(vim, v)), h = mesh.halfedge_of_vertex[i];
    const bool on_border = h != -1 && mesh.opposite[h] == -1;
    problem.quarters[i] = !on_border ? 4 - get(index, v) : align_boundary ? 2 - get(index, v) : -1;
  }

  internal::Visitor_adaptor<typename std::remove_reference<Visitor_reference>::type> any_visitor(visitor);
  std::vector<std::array<double, 2>> corner;
  const Status status = internal::solve_grid_map(problem, options, any_visitor, corner, result);
  if(status == Status::STOPPED)
    return finished(status, "The visitor stopped the parameterization.");
  if(status == Status::NUMERICAL_FAILURE)
    return finished(status, "The energy of the parameterization could not be factorized.");

  typedef typename boost::property_traits<HalfedgeUVMap>::value_type UV_point;
  for(int f = 0; f < mesh.number_of_faces(); ++f)
  {
    halfedge_descriptor h = first_halfedge[f]; // its source is corner 0
    for(int k = 1; k <= 3; ++k, h = next(h, tm))
      put(uv, h, UV_point(corner[3 * f + k % 3][0], corner[3 * f + k % 3][1]));
  }
  if(status == Status::VALID)
    return finished(status, "The map is an integer-grid map.");
  return finished(status, std::to_string(result.folded_faces.size()) + " of " + std::to_string(mesh.number_of_faces()) +
                            " triangles of the map are folded over.");
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTEGER_GRID_MAP_H
