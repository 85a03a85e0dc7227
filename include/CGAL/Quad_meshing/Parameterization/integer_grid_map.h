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
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/Mixed_integer/Rounding_method.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Integer_grid_solver.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief The answer of `integer_grid_map()`.
*/
struct Integer_grid_map_result
{
  /// How it ended.
  enum Status
  {
    VALID = 0,          ///< the map is an integer-grid map, exactly
    FOLDED,             ///< all transitions, grid points and grid lines are exact, but some triangles are folded over
    EMPTY_MESH,         ///< there are no faces; nothing was written
    INVALID_LENGTH,     ///< the target edge length is not a positive number; nothing was written
    NUMERICAL_FAILURE,  ///< the energy could not be factorized; nothing was written
    STOPPED             ///< the visitor asked for an early end; nothing was written
  };

  Status status = NUMERICAL_FAILURE;
  /// The same as a sentence.
  std::string message;
  /// The number of variables after all linear conditions were eliminated.
  int variables = 0;
  /// How many of them are integers.
  int integers = 0;
  /// The orientation energy of the least map without integer conditions, in units of quads.
  double relaxed_energy = 0;
  /// The orientation energy with the integers that were chosen, before fold-overs were removed.
  double energy = 0;
  /// Pairs of grid points and grid lines that lie so near to each other that their order was watched in the rounding.
  int separations = 0;
  /// Such pairs that could not be kept in order.
  int broken_separations = 0;
  /// Faces that are folded or have no area, by their index in the face index map, ascending.
  std::vector<std::size_t> folded_faces;
  /// Those that were folded already in the map without integer conditions: if there are some, the field and the constrained edges
  /// leave no room there, whatever the integers.
  std::vector<std::size_t> folded_before_rounding;
  /// The wall-clock time.
  double seconds = 0;

  /// Whether the map is an integer-grid map.
  bool is_valid() const { return status == VALID; }
};

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief computes an integer-grid map that follows a cross field.

The mesh is cut to disks through all singular vertices, the field is combed over them, and the map is sought whose
gradients are nearest to the combed directions, divided by the target edge length (thesis, Section 8.4). Singular vertices have to
lie on grid points, constrained edges and border edges on grid lines, and the transitions across cuts have to be
grid automorphisms. All these linear conditions are eliminated in integer arithmetic before anything is optimized. Then

- the map without integer conditions is computed and fold-overs are removed from it;
- the integers are rounded with the given method; grid points and lines that meet in the rounded map, but not in the one before,
  are kept apart by further conditions, and the rounding is repeated;
- fold-overs that the integers leave are removed by minimizing the regularized distortion of
  Garanzha et al., "Foldover-free maps in 50 lines of code" (2021), where they are;
- real variables are rounded to multiples of a power of two, so that every condition holds exactly for the numbers written.

The result is `VALID` if no triangle is folded, by exact predicates; `is_integer_grid_map()` then says yes, too. That is no
guarantee to find such a map: if integers leave no room for one, the result is `FOLDED` and names the faces.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam FaceAngleMap a model of `ReadablePropertyMap` with the faces as keys and `double` as value type
\tparam EdgePeriodJumpMap a model of `ReadablePropertyMap` with the edges as keys and `int` as value type
\tparam VertexSingularityMap a model of `ReadablePropertyMap` with the vertices as keys and `int` as value type
\tparam HalfedgeUVMap a model of `WritablePropertyMap` with the halfedges as keys and a two-dimensional point
        that can be constructed from two `double` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh; a triangle with two constrained edges cannot be mapped without being folded, see `split_for_alignment()`
\param angle, period_jump, index the cross field as `smooth_cross_field()` writes it, aligned with the constrained edges
\param uv receives the map: for each halfedge that is no border halfedge, the image of its target in the chart of its face
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
    \cgalParamDescription{the weight of the length of quads against their direction, in (0, 1] (thesis, "Anisotropic norm")}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{stiffening_iterations}
    \cgalParamDescription{the largest number of times that the energy is weighted anew where triangles are distorted
                          (thesis, "Local stiffening"), as long as there are folded ones}
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
Integer_grid_map_result
integer_grid_map(const TriangleMesh& tm, FaceAngleMap angle, EdgePeriodJumpMap period_jump, VertexSingularityMap index,
                 HalfedgeUVMap uv, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  using parameters::is_default_parameter;

  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef Integer_grid_map_result Result;

  CGAL_precondition(is_triangle_mesh(tm));

  Real_timer timer;
  timer.start();
  Result result;
  auto finished = [&](typename Result::Status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    result.seconds = timer.time();
    return result;
  };

  const bool align_boundary = choose_parameter(get_parameter(np, internal_np::align_boundary), true);
  const Rounding_method method =
      choose_parameter(get_parameter(np, internal_np::rounding_method), Rounding_method::GREEDY);
  const double anisotropy = choose_parameter(get_parameter(np, internal_np::anisotropy_weight), 1.);
  const unsigned int threads = choose_parameter(get_parameter(np, internal_np::number_of_threads), 1u);
  const unsigned int stiffening = choose_parameter(get_parameter(np, internal_np::stiffening_iterations), 5u);
  auto is_constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                         Static_boolean_property_map<edge_descriptor, false>());
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tm));
  auto vim = internal::vertex_numbers(tm, np);
  auto fim = internal::face_numbers(tm, np);
  Default_visitor default_visitor;
  auto&& visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);

  const internal::Indexed_triangle_mesh mesh = internal::make_indexed_triangle_mesh(tm, vpm, vim, fim);
  if(mesh.number_of_faces() == 0)
    return finished(Result::EMPTY_MESH, "The mesh has no faces.");

  std::vector<double> face_angle(mesh.number_of_faces()), sizing(mesh.number_of_faces());
  std::vector<int> edge_jump(mesh.number_of_edges());
  std::vector<int> quarters(mesh.number_of_vertices());
  std::vector<bool> is_aligned(mesh.number_of_edges());
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
    face_angle[i] = get(angle, f);
    first_halfedge[i] = halfedge(f, tm);
    if constexpr(is_default_parameter<NamedParameters, internal_np::face_sizing_map_t>::value)
      sizing[i] = length;
    else
      sizing[i] = to_double(get(get_parameter(np, internal_np::face_sizing_map), f));
    if(!(sizing[i] > 0) || !std::isfinite(sizing[i]))
      return finished(Result::INVALID_LENGTH, "The target edge length is not a positive number.");
  }
  int e_index = 0;
  for(edge_descriptor e : edges(tm))
  {
    if(is_border(halfedge(e, tm), tm) && is_border(opposite(halfedge(e, tm), tm), tm))
      continue; // as make_indexed_triangle_mesh() numbers edges
    edge_jump[e_index] = get(period_jump, e);
    is_aligned[e_index] = get(is_constrained, e) || (align_boundary && is_border(e, tm));
    ++e_index;
  }
  for(auto v : vertices(tm))
  {
    const bool on_border = static_cast<bool>(is_border(v, tm));
    quarters[get(vim, v)] = !on_border ? 4 - get(index, v) : align_boundary ? 2 - get(index, v) : -1;
  }

  visitor.on_stage_begin("parameterization");
  auto stopped = [&]()
  {
    if(visitor.go_further())
      return false;
    visitor.on_stage_end("parameterization");
    finished(Result::STOPPED, "The visitor stopped the parameterization.");
    return true;
  };

  internal::Integer_grid_solver solver(mesh, face_angle, edge_jump, quarters, is_aligned, sizing, threads);
  result.variables = solver.coordinates.number_of_variables();
  result.integers = solver.number_of_integers();
  if(stopped())
    return result;
  if(!solver.solve_seamless(anisotropy, stiffening))
  {
    visitor.on_stage_end("parameterization");
    return finished(Result::NUMERICAL_FAILURE, "The energy of the parameterization could not be factorized.");
  }
  visitor.progress(0.5);
  if(stopped())
    return result;
  solver.round(method, is_aligned);
  visitor.progress(0.7);
  if(stopped())
    return result;
  solver.remove_fold_overs(stiffening, anisotropy);
  solver.make_exact();
  visitor.progress(1);
  visitor.on_stage_end("parameterization");

  result.relaxed_energy = solver.relaxed_energy;
  result.energy = solver.rounded_energy;
  result.separations = solver.number_of_separations;
  result.broken_separations = solver.number_of_broken_separations;
  for(int f : solver.folded_faces())
    result.folded_faces.push_back(f);
  result.folded_before_rounding.assign(solver.folded_before_rounding.begin(), solver.folded_before_rounding.end());

  typedef typename boost::property_traits<HalfedgeUVMap>::value_type UV_point;
  for(int f = 0; f < mesh.number_of_faces(); ++f)
  {
    halfedge_descriptor h = first_halfedge[f]; // its source is corner 0
    for(int k = 1; k <= 3; ++k, h = next(h, tm))
    {
      const auto p = solver.corner(f, k % 3);
      put(uv, h, UV_point(p.x(), p.y()));
    }
  }
  if(result.folded_faces.empty())
    return finished(Result::VALID, "The map is an integer-grid map.");
  return finished(Result::FOLDED, std::to_string(result.folded_faces.size()) + " of " +
                                  std::to_string(mesh.number_of_faces()) + " triangles of the map are folded over.");
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTEGER_GRID_MAP_H
