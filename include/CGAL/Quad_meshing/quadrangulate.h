// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUADRANGULATE_H
#define CGAL_QUAD_MESHING_QUADRANGULATE_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/read_parameter.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingRef

\brief makes a pure quad mesh out of a triangle mesh.

Sharp edges are detected, a smooth cross field is computed that follows them and the border, an integer-grid map that
follows the field, and the quad mesh that is the image of the integer grid; then its vertices are smoothed on
the surface. Sharp edges and the border become chains of quad edges.

The result is `VALID` only if the mesh consists of quads, is a manifold by construction of the halfedge data structure,
and has the components, Euler numbers and border loops of the input. If not, the result says why, and the best mesh that
could be made, if there is one, is delivered all the same.

Where no integers come at once that the map can follow, the quads are made along the T-mesh of the map, which never
fails (`quantize_t_mesh()`). If the map is folded over before there are integers, other fields are tried; where sharp
edges leave no room for any, those nearby are released: the quads need not follow them there. The message says what part
of their length that is. Edges that `edge_is_constrained_map` marks are never released. `default_grid_map_plans()` lists
all that is tried.

Each component is quadrangulated by itself. If some have no valid mesh, `qm` holds all others, and the message names
those by their faces. A vertex in which borders touch is divided: each fan of triangles gets one of its own.

The result depends on nothing but the surface and the parameters: not on the numbers of vertices and faces.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam QuadMesh a model of `MutableFaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh: any manifold with or without border, with any number of components
\param qm receives the quad mesh, besides what it holds already; another object than `tm`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{target_number_of_quads}
    \cgalParamDescription{about how many quads the mesh should have}
    \cgalParamType{`double`}
    \cgalParamDefault{4000}
  \cgalParamNEnd
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length of a quad edge in the unit of the points; takes precedence over the number of
      quads}
    \cgalParamType{`double`}
    \cgalParamDefault{the square root of the area over the number of quads}
  \cgalParamNEnd
  \cgalParamNBegin{sharpness_angle}
    \cgalParamDescription{the angle between normals, in degrees, from which on an edge is sharp; see
      `detect_feature_edges()` for the sharp
                          edges that are taken for noise}
    \cgalParamType{`double`}
    \cgalParamDefault{40}
    \cgalParamExtra{180 and more: there are no features}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges; if it is given, none are detected and none are dropped}
    \cgalParamType{a model of `ReadablePropertyMap` with the edges of `tm` as keys and `bool` as value type}
    \cgalParamDefault{they are detected}
  \cgalParamNEnd
  \cgalParamNBegin{align_boundary}
    \cgalParamDescription{whether the border becomes chains of quad edges}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{face_direction_map}
    \cgalParamDescription{directions that the quad edges should have}
    \cgalParamType{a model of `ReadablePropertyMap` with the faces of `tm` as keys and `std::optional<Vector_3>`, or an
      optional vector of another library, as value type}
    \cgalParamDefault{no direction is given}
  \cgalParamNEnd
  \cgalParamNBegin{curvature_alignment}
    \cgalParamDescription{how much the quads follow the directions in which the surface bends least, where these are
      reliable
                          (`curvature_directions()`)}
    \cgalParamType{`double`, from 0, not at all, to 1}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{singularity_cost}
    \cgalParamDescription{what an irregular vertex must save to be worth while: fewer of them with more. In the units of
      the energy of the cross field (`smooth_cross_field()`), in which, at full alignment, 10 quads that are 10 degrees
      off reliable directions of least curvature cost 0.6}
    \cgalParamType{`double`, 0 or more}
    \cgalParamDefault{0.6}
  \cgalParamNEnd
  \cgalParamNBegin{face_sizing_map}
    \cgalParamDescription{the length of quad edges per face, in the unit of the points; 0 or less: no wish there. If
      there are faces
      without a wish, their lengths are chosen so that the number of quads is right; else all lengths are multiplied by
      one factor for that, unless `target_edge_length` is given}
    \cgalParamType{a model of `ReadablePropertyMap` with the faces of `tm` as keys and `double` as value type}
    \cgalParamDefault{no wish}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_sizing_map}
    \cgalParamDescription{the same per vertex; linear in faces. Where both maps have a wish, the shorter length counts}
    \cgalParamType{a model of `ReadablePropertyMap` with the vertices of `tm` as keys and `double` as value type}
    \cgalParamDefault{no wish}
  \cgalParamNEnd
  \cgalParamNBegin{size_discs}
    \cgalParamDescription{lengths around points}
    \cgalParamType{a range of `Size_disc`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_method}
    \cgalParamDescription{what lengths adapt to where there is no wish}
    \cgalParamType{`Sizing_method`}
    \cgalParamDefault{`Sizing_method::CONSTANT`}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_tolerance}
    \cgalParamDescription{the distance allowed between quads and the surface with `Sizing_method::CURVATURE`, in the
      unit of the
      points; it takes precedence over the number of quads}
    \cgalParamType{`double`}
    \cgalParamDefault{the one for which the number of quads is right}
  \cgalParamNEnd
  \cgalParamNBegin{smallest_edge_length}
    \cgalParamDescription{the smallest length of quad edges}
    \cgalParamType{`double`}
    \cgalParamDefault{a quarter of the constant length for lengths that adapt, none for those that are given}
  \cgalParamNEnd
  \cgalParamNBegin{largest_edge_length}
    \cgalParamDescription{the largest length of quad edges}
    \cgalParamType{`double`}
    \cgalParamDefault{four times the constant length for lengths that adapt, none for those that are given}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_gradation}
    \cgalParamDescription{the largest slope of the length along the surface}
    \cgalParamType{`double`}
    \cgalParamDefault{0.3}
  \cgalParamNEnd
  \cgalParamNBegin{feature_curves}
    \cgalParamDescription{curves that become chains of quad edges, besides the feature edges; the surface is cut
      along them}
    \cgalParamType{a range of `Guide_curve`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_curve_map}
    \cgalParamDescription{edges of `tm` that become chains of quad edges, besides the feature edges, which are detected
      all the same: the borders of groups of faces, for instance}
    \cgalParamType{a model of `ReadablePropertyMap` with the edges of `tm` as keys and `bool` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{strokes}
    \cgalParamDescription{curves whose direction the quads follow}
    \cgalParamType{a range of `Guide_stroke`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{index_guides}
    \cgalParamDescription{where irregular vertices must be, or must not be}
    \cgalParamType{a range of `Index_guide`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{symmetry_planes}
    \cgalParamDescription{planes, orthogonal to each other, that the quad mesh is to be symmetric to: it is mirrored.
      A surface that is
      not symmetric itself within `symmetry_tolerance` is refused}
    \cgalParamType{a range of `Symmetry_plane`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{symmetry_tolerance}
    \cgalParamDescription{the largest distance of a mirrored vertex from the surface, over the diagonal of the
      bounding box}
    \cgalParamType{`double`}
    \cgalParamDefault{0.01}
  \cgalParamNEnd
  \cgalParamNBegin{work_on_input}
    \cgalParamDescription{whether field and map are made on the triangles of the input instead of those of a working
mesh
      (`make_working_mesh()`), which is as fine as the quads need it}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{cross_field_method}
    \cgalParamDescription{how the singularities of the cross field are found}
    \cgalParamType{`Cross_field_method`}
    \cgalParamDefault{`Cross_field_method::POLISHED`}
    \cgalParamExtra{if the map for `POLISHED` is folded over, the one for `REPRESENTATION` is tried as well, and the
      other way round}
  \cgalParamNEnd
  \cgalParamNBegin{rounding_method}
    \cgalParamDescription{how the integers of the map are chosen}
    \cgalParamType{`Rounding_method`}
    \cgalParamDefault{`Rounding_method::GREEDY`}
  \cgalParamNEnd
  \cgalParamNBegin{rounding_tolerance}
    \cgalParamDescription{the accuracy to which greedy rounding of a field updates it, see `smooth_cross_field()`}
    \cgalParamType{`double`}
    \cgalParamDefault{`3e-4`}
  \cgalParamNEnd
  \cgalParamNBegin{gauss_seidel_iterations}
    \cgalParamDescription{the local steps per rounding of a field; 0 for none}
    \cgalParamType{`int`}
    \cgalParamDefault{`20000`}
  \cgalParamNEnd
  \cgalParamNBegin{conjugate_gradient_iterations}
    \cgalParamDescription{the steps of the conjugate gradient per rounding of a field; 0 for none}
    \cgalParamType{`int`}
    \cgalParamDefault{`10`}
  \cgalParamNEnd
  \cgalParamNBegin{allow_refactorization}
    \cgalParamDescription{whether greedy rounding of a field may compute new factorizations}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{anisotropy_weight}
    \cgalParamDescription{the weight of the length of quads against their direction, in (0, 1]}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{smoothing_iterations}
    \cgalParamDescription{the largest number of steps of the final smoothing, in which all vertices move at once
                          (`smooth_globally` of `smooth_quad_mesh()`), or of that of `optimize_structure`; 0 smooths
                          nothing}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{20}
  \cgalParamNEnd
  \cgalParamNBegin{optimize_structure}
    \cgalParamDescription{whether `optimize_quad_structure()` makes the base complex coarser: fewer patches with the
      same irregular
                          vertices}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{semi_regular}
    \cgalParamDescription{whether the structure is optimized, and the quads are then made anew on the input along the
                          base complex (`quadrangulate_layout()`): few patches, each of them a smooth grid}
    \cgalParamType{bool}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_threads}
    \cgalParamDescription{how many threads may work at the same time; the result does not depend on it}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the edge lengths that are tried when the map for the given one is not valid}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{the time in seconds after which the best mesh so far is the result, if there is one; the
      message says so}
    \cgalParamType{`double`}
    \cgalParamDefault{no limit}
    \cgalParamExtra{with a limit, the result may depend on the speed of the machine}
  \cgalParamNEnd
  \cgalParamNBegin{face_location_map}
    \cgalParamDescription{receives for every vertex of `qm` where it lies on `tm`}
    \cgalParamType{a model of `WritablePropertyMap` with the vertices of `qm` as keys and
                   `Polygon_mesh_processing::Face_location<TriangleMesh, double>` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told about the stages and may stop them, see `Default_visitor`; pass it by `std::ref`}
    \cgalParamDefault{`Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tm`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the figures of all stages; `is_valid()` says whether `qm` is what was asked for

\pre `is_triangle_mesh(tm)`

\sa `Quadrangulation`
*/
template <typename TriangleMesh, typename QuadMesh, typename NamedParameters = parameters::Default_named_parameters>
Quadrangulation_result quadrangulate(const TriangleMesh& tm, QuadMesh& qm,
                                     const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  using parameters::is_default_parameter;

  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<QuadMesh>::vertex_descriptor quad_vertex_descriptor;

  constexpr bool takes_parameters = internal::Takes_parameters<
    NamedParameters, internal_np::target_number_of_quads_t, internal_np::target_edge_length_t,
    internal_np::sharpness_angle_t, internal_np::edge_is_constrained_t, internal_np::align_boundary_t,
    internal_np::face_direction_map_t, internal_np::face_sizing_map_t, internal_np::vertex_sizing_map_t,
    internal_np::size_discs_t, internal_np::sizing_method_t, internal_np::sizing_tolerance_t,
    internal_np::smallest_edge_length_t, internal_np::largest_edge_length_t, internal_np::sizing_gradation_t,
    internal_np::feature_curves_t, internal_np::edge_is_curve_map_t, internal_np::strokes_t,
    internal_np::index_guides_t, internal_np::symmetry_planes_t, internal_np::symmetry_tolerance_t,
    internal_np::curvature_alignment_t, internal_np::singularity_cost_t, internal_np::work_on_input_t,
    internal_np::cross_field_method_t, internal_np::rounding_tolerance_t, internal_np::gauss_seidel_iterations_t,
    internal_np::conjugate_gradient_iterations_t, internal_np::allow_refactorization_t, internal_np::rounding_method_t,
    internal_np::anisotropy_weight_t, internal_np::smoothing_iterations_t, internal_np::optimize_structure_t,
    internal_np::semi_regular_t, internal_np::number_of_threads_t, internal_np::random_seed_t,
    internal_np::maximum_running_time_t, internal_np::face_location_map_t, internal_np::visitor_t,
    internal_np::vertex_point_t>::value;
  constexpr bool has_edge_map =
    internal::map_parameter_is_readable<internal_np::edge_is_constrained_t, NamedParameters, edge_descriptor, bool>() &&
    internal::map_parameter_is_readable<internal_np::edge_is_curve_map_t, NamedParameters, edge_descriptor, bool>();
  constexpr bool has_sizing_maps =
    internal::map_parameter_is_readable<internal_np::face_sizing_map_t, NamedParameters, face_descriptor, double>() &&
    internal::map_parameter_is_readable<internal_np::vertex_sizing_map_t, NamedParameters, vertex_descriptor, double>();
  constexpr bool has_direction_map =
    internal::map_parameter_gives_optionals<internal_np::face_direction_map_t, NamedParameters, face_descriptor>();
  static_assert(has_edge_map,
                "edge_is_constrained_map and edge_is_curve_map must give a bool for every edge of the triangle mesh.");
  static_assert(has_sizing_maps,
                "face_sizing_map and vertex_sizing_map must give a number for every face or vertex of the mesh.");
  static_assert(has_direction_map,
                "face_direction_map must give an optional vector for every face of the triangle mesh.");

  Quadrangulation_result result;
  if constexpr(takes_parameters && has_edge_map && has_direction_map && has_sizing_maps)
  {
    CGAL_precondition(is_triangle_mesh(tm));

    if constexpr(std::is_same<TriangleMesh, QuadMesh>::value)
      if(&tm == &qm)
      {
        result.status = Quadrangulation_status::INVALID_INPUT;
        result.message = "The triangle mesh and the quad mesh are the same object.";
        return result;
      }

    auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tm));
    Default_visitor default_visitor;
    auto&& visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);

    Quadrangulation q(tm, vpm);
    if constexpr(!is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value)
      q.set_feature_edges(tm, get_parameter(np, internal_np::edge_is_constrained));
    if constexpr(!is_default_parameter<NamedParameters, internal_np::edge_is_curve_map_t>::value)
      q.set_curve_edges(tm, get_parameter(np, internal_np::edge_is_curve_map));
    if constexpr(!is_default_parameter<NamedParameters, internal_np::face_direction_map_t>::value)
      q.set_directions(tm, get_parameter(np, internal_np::face_direction_map));
    if constexpr(!is_default_parameter<NamedParameters, internal_np::face_sizing_map_t>::value)
      q.set_face_lengths(tm, get_parameter(np, internal_np::face_sizing_map));
    if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_sizing_map_t>::value)
      q.set_vertex_lengths(tm, get_parameter(np, internal_np::vertex_sizing_map));
    Quadrangulation_options& o = q.options;
    internal::read_range(np, internal_np::size_discs, o.size_discs);
    internal::read_range(np, internal_np::feature_curves, o.feature_curves);
    internal::read_range(np, internal_np::strokes, o.strokes);
    internal::read_range(np, internal_np::index_guides, o.index_guides);
    internal::read_range(np, internal_np::symmetry_planes, o.symmetry_planes);
    internal::read_parameter(np, internal_np::symmetry_tolerance, o.symmetry_tolerance);
    internal::read_parameter(np, internal_np::sizing_method, o.sizing_method);
    internal::read_parameter(np, internal_np::sizing_tolerance, o.sizing_tolerance);
    internal::read_parameter(np, internal_np::smallest_edge_length, o.smallest_edge_length);
    internal::read_parameter(np, internal_np::largest_edge_length, o.largest_edge_length);
    internal::read_parameter(np, internal_np::sizing_gradation, o.sizing_gradation);
    internal::read_parameter(np, internal_np::target_edge_length, o.target_edge_length);
    internal::read_parameter(np, internal_np::target_number_of_quads, o.target_number_of_quads);
    internal::read_parameter(np, internal_np::sharpness_angle, o.sharpness_angle);
    internal::read_parameter(np, internal_np::align_boundary, o.align_boundary);
    internal::read_parameter(np, internal_np::cross_field_method, o.cross_field_method);
    internal::read_parameter(np, internal_np::curvature_alignment, o.curvature_alignment);
    internal::read_parameter(np, internal_np::singularity_cost, o.singularity_cost);
    internal::read_parameter(np, internal_np::work_on_input, o.work_on_input);
    internal::read_parameter(np, internal_np::rounding_method, o.rounding_method);
    internal::read_parameter(np, internal_np::anisotropy_weight, o.anisotropy_weight);
    internal::read_parameter(np, internal_np::optimize_structure, o.optimize_structure);
    internal::read_parameter(np, internal_np::semi_regular, o.semi_regular);
    internal::read_parameter(np, internal_np::number_of_threads, o.number_of_threads);
    internal::read_parameter(np, internal_np::random_seed, o.random_seed);
    internal::read_parameter(np, internal_np::smoothing_iterations, o.smoothing_iterations);
    internal::read_parameter(np, internal_np::maximum_running_time, o.maximum_running_time);
    internal::read_parameter(np, internal_np::rounding_tolerance, o.rounding_tolerance);
    internal::read_parameter(np, internal_np::gauss_seidel_iterations, o.gauss_seidel_iterations);
    internal::read_parameter(np, internal_np::conjugate_gradient_iterations, o.conjugate_gradient_iterations);
    internal::read_parameter(np, internal_np::allow_refactorization, o.allow_refactorization);
    result = q.run(visitor);

    std::vector<std::pair<Quadrangulation::Mesh::Vertex_index, quad_vertex_descriptor>> copies;
    copy_face_graph(q.quads().mesh, qm, parameters::vertex_to_vertex_output_iterator(std::back_inserter(copies)));
    if constexpr(!is_default_parameter<NamedParameters, internal_np::face_location_map_t>::value)
    {
      auto locations = get_parameter(np, internal_np::face_location_map);
      const std::vector<face_descriptor> input_faces(faces(tm).begin(), faces(tm).end());
      for(const auto& c : copies)
      {
        const auto location = q.location_on_input(c.first);
        put(locations, c.second, std::make_pair(input_faces[location.first], location.second));
      }
    }
  }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUADRANGULATE_H
