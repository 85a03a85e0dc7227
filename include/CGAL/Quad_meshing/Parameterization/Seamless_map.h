// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_SEAMLESS_MAP_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_SEAMLESS_MAP_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Mixed_integer/Rounding_method.h>
#include <CGAL/Quad_meshing/Parameterization/Integer_grid_map_result.h>
#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>
#include <CGAL/Quad_meshing/Parameterization/internal/solve_grid_map.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
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
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief The map along a cross field before integers are chosen, and the integer-grid maps that can be made of it.

All transitions are rotations by multiples of 90 degrees with any translation, and constrained edges lie on lines of one
coordinate. Such a map does not depend on the size of the quads: for quads of twice the length it is half as large. So
it is computed once, and rounded for as many lengths as one likes. `integer_grid_map()` does both.

\sa `integer_grid_map()`
*/
class Seamless_map
{
  typedef Integer_grid_map_status Status;

public:
  /*!
  computes the map.

  The parameters are those of `integer_grid_map()`, and so are the named ones but for `rounding_method`, which `round()`
  takes.
  */
  template <typename TriangleMesh, typename FaceAngleMap, typename EdgePeriodJumpMap, typename VertexSingularityMap,
            typename NamedParameters = parameters::Default_named_parameters>
  Seamless_map(const TriangleMesh& tm, FaceAngleMap angle, EdgePeriodJumpMap period_jump, VertexSingularityMap index,
               const NamedParameters& np = parameters::default_values())
  {
    compute(tm, angle, period_jump, index, np);
  }

  /// returns whether there is a map, folded or not; if not, `result()` says why.
  bool is_solved() const { return m_is_solved; }

  /// returns how the computation ended, and the figures that are known before integers are chosen.
  const Integer_grid_map_result& result() const { return m_result; }

  /// returns the area of the image of the surface, in quads of the target edge length: about as many quads will come of
  /// the map. It can be far from the area of the surface in such quads, where the field bends much.
  double number_of_quads() const { return m_solver->area(); }

  /// returns the mean symmetric Dirichlet energy \f$ (|J|^2 + |J^{-1}|^2) / 4 \f$ over the surface, of the multiple of
  /// the map for which it is least; \f$ J \f$ is the Jacobian in target edge lengths. It is 1 if all quads are squares
  /// of one size, and grows as they are stretched, sheared or of different sizes.
  double distortion() const { return m_solver->distortion(); }

  /*!
  makes an integer-grid map of a multiple of the map, see `integer_grid_map()`.

  \param tm the triangle mesh that the map was computed for
  \param relative_length the length of the quad edges, in target edge lengths; it must be positive
  \param uv receives the map, if the status is `VALID` or `FOLDED`
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `rounding_method` and `visitor`, as
  `integer_grid_map()` takes them

  \pre `is_solved()`
  */
  template <typename TriangleMesh, typename HalfedgeUVMap,
            typename NamedParameters = parameters::Default_named_parameters>
  Integer_grid_map_result round(const TriangleMesh& tm, double relative_length, HalfedgeUVMap uv,
                                const NamedParameters& np = parameters::default_values())
  {
    return round(tm, relative_length, uv, true, np);
  }

  /*!
  makes an integer-grid map as `round()`, but only if it comes at once: if the integers of the least energy put no two
  things onto each other, and the map gets to them without folding. Otherwise the status is `FOLDED`, after little time;
  the T-mesh leads on from there (`t_mesh()`).

  The parameters are those of `round()`.
  */
  template <typename TriangleMesh, typename HalfedgeUVMap,
            typename NamedParameters = parameters::Default_named_parameters>
  Integer_grid_map_result round_without_repair(const TriangleMesh& tm, double relative_length, HalfedgeUVMap uv,
                                               const NamedParameters& np = parameters::default_values())
  {
    return round(tm, relative_length, uv, false, np);
  }

  /*!
  returns the T-mesh of the map, in quad edges of the length that was last rounded for.

  Its rounded lengths are those that the integers chosen by `round()` give, whether or not the integer-grid map is
  valid. There is a T-mesh if the seamless map has no fold-overs and all borders are aligned; else
  `T_mesh::is_valid()` is false and `T_mesh::message` says why.

  \pre `round()` was called
  */
  template <typename NamedParameters = parameters::Default_named_parameters>
  T_mesh t_mesh(const NamedParameters& np = parameters::default_values()) const
  {
    CGAL_precondition(m_is_solved);
    internal::Named_visitor<NamedParameters> visitor(np);
    return m_solver->t_mesh(visitor);
  }

private:
  template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
  Integer_grid_map_result round(const TriangleMesh& tm, double relative_length, HalfedgeUVMap uv, bool repairs,
                                const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    using parameters::get_parameter_reference;

    typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
    typedef typename boost::property_traits<HalfedgeUVMap>::value_type UV_point;
    typedef
      typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Default_visitor>::reference
        Visitor_reference;

    CGAL_precondition(m_is_solved && relative_length > 0);
    Default_visitor default_visitor;
    Visitor_reference visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
    internal::Visitor_adaptor<typename std::remove_reference<Visitor_reference>::type> any_visitor(visitor);

    Real_timer timer;
    timer.start();
    Integer_grid_map_result result = m_result;
    std::vector<std::array<double, 2>> corner;
    result.status = m_solver->round(
      relative_length, choose_parameter(get_parameter(np, internal_np::rounding_method), Rounding_method::GREEDY),
      repairs, any_visitor, corner, result);
    result.seconds = timer.time();
    if(result.status == Status::STOPPED)
    {
      result.message = "The visitor stopped the parameterization.";
      return result;
    }
    const auto fim = internal::face_numbers(tm, np);
    for(auto f : faces(tm))
    {
      halfedge_descriptor h = halfedge(f, tm); // its source is corner 0
      const std::size_t i = get(fim, f);
      for(int k = 1; k <= 3; ++k, h = next(h, tm))
        put(uv, h, UV_point(corner[3 * i + k % 3][0], corner[3 * i + k % 3][1]));
    }
    result.message = result.is_valid() ? "The map is an integer-grid map."
                                       : std::to_string(result.folded_faces.size()) + " of " +
                                           std::to_string(m_solver->mesh().number_of_faces()) +
                                           " triangles of the map are folded over.";
    return result;
  }

  template <typename TriangleMesh, typename FaceAngleMap, typename EdgePeriodJumpMap, typename VertexSingularityMap,
            typename NamedParameters>
  void compute(const TriangleMesh& tm, FaceAngleMap angle, EdgePeriodJumpMap period_jump, VertexSingularityMap index,
               const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    using parameters::get_parameter_reference;
    using parameters::is_default_parameter;

    typedef boost::graph_traits<TriangleMesh> Graph_traits;
    typedef typename Graph_traits::edge_descriptor edge_descriptor;
    typedef typename Graph_traits::face_descriptor face_descriptor;
    typedef Integer_grid_map_status Status;
    typedef
      typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Default_visitor>::reference
        Visitor_reference;

    constexpr bool takes_parameters =
      internal::Takes_parameters<NamedParameters, internal_np::target_edge_length_t, internal_np::face_sizing_map_t,
                                 internal_np::edge_is_constrained_t, internal_np::vertex_is_constrained_t,
                                 internal_np::face_direction_weight_map_t, internal_np::align_boundary_t,
                                 internal_np::rounding_method_t, internal_np::anisotropy_weight_t,
                                 internal_np::stiffening_iterations_t, internal_np::number_of_threads_t,
                                 internal_np::visitor_t, internal_np::vertex_point_t, internal_np::vertex_index_t,
                                 internal_np::face_index_t>::value;
    static_assert(takes_parameters, "A seamless map does not take one of the named parameters.");
    constexpr bool has_edge_map =
      internal::map_parameter_is_readable<internal_np::edge_is_constrained_t, NamedParameters, edge_descriptor, bool>();
    static_assert(has_edge_map, "edge_is_constrained_map must give a bool for every edge of the triangle mesh.");
    constexpr bool has_sizing_map =
      internal::map_parameter_is_readable<internal_np::face_sizing_map_t, NamedParameters, face_descriptor, double>();
    static_assert(has_sizing_map, "face_sizing_map must give a number for every face of the triangle mesh.");

    Real_timer timer;
    timer.start();
    auto finished = [&](Status status, const std::string& message)
    {
      m_result.status = status;
      m_result.message = message;
      m_result.seconds = timer.time();
    };

    internal::Grid_map_options options;
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
    internal::Grid_map_problem problem(internal::make_indexed_triangle_mesh(tm, np));
    const internal::Indexed_triangle_mesh& mesh = problem.mesh;
    if(mesh.number_of_faces() == 0)
      return finished(Status::EMPTY_MESH, "The mesh has no faces.");
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(!internal::is_finite(mesh.points[v]))
        return finished(Status::VALUE_NOT_FINITE,
                        "Vertex " + std::to_string(v) + " has a coordinate that is not a finite number.");
    if(mesh.non_manifold_vertex != -1)
      return finished(Status::NON_MANIFOLD_VERTEX, internal::non_manifold_message(mesh));

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
        return finished(Status::VALUE_NOT_FINITE,
                        "The angle of face " + std::to_string(i) + " is not a finite number.");
      if constexpr(is_default_parameter<NamedParameters, internal_np::face_sizing_map_t>::value)
        problem.sizing[i] = length;
      else
        problem.sizing[i] = to_double(get(get_parameter(np, internal_np::face_sizing_map), f));
      if constexpr(!is_default_parameter<NamedParameters, internal_np::face_direction_weight_map_t>::value)
        problem.weight[i] = to_double(get(get_parameter(np, internal_np::face_direction_weight_map), f));
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
      if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value)
        problem.is_node[i] = get(get_parameter(np, internal_np::vertex_is_constrained), v);
      problem.quarters[i] = !on_border ? 4 - get(index, v) : align_boundary ? 2 - get(index, v) : -1;
    }

    internal::Visitor_adaptor<typename std::remove_reference<Visitor_reference>::type> any_visitor(visitor);
    m_solver = std::make_unique<internal::Grid_map_solver>(std::move(problem), options);
    const Status status = m_solver->solve(any_visitor, m_result);
    if(status == Status::STOPPED)
      return finished(status, "The visitor stopped the parameterization.");
    if(status == Status::NUMERICAL_FAILURE)
      return finished(status, "The energy of the parameterization could not be factorized.");
    m_is_solved = true;
    finished(Status::FOLDED, "The map has not been rounded yet.");
  }

  std::unique_ptr<internal::Grid_map_solver> m_solver;
  Integer_grid_map_result m_result;
  bool m_is_solved = false;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_SEAMLESS_MAP_H
