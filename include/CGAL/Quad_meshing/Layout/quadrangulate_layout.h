// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_QUADRANGULATE_LAYOUT_H
#define CGAL_QUAD_MESHING_LAYOUT_QUADRANGULATE_LAYOUT_H

#include <CGAL/Quad_meshing/Layout/Layout_quadrangulation_result.h>
#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/quadrangulate_indexed_layout.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/quad_mesh_parameters.h>
#include <CGAL/Quad_meshing/internal/read_parameter.h>
#include <CGAL/Quad_meshing/internal/triangle_mesh_parameters.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

// The constrained edges of a triangle mesh, per halfedge of its flat copy.
template <typename TriangleMesh, typename NamedParameters>
std::vector<char> constrained_halfedges(const Indexed_triangle_mesh& mesh, const TriangleMesh& tm,
                                        const NamedParameters& np)
{
  const std::vector<char> edge_is_constrained = constrained_edges(tm, np);
  std::vector<char> is_constrained(mesh.number_of_halfedges(), 0);
  for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    is_constrained[h] = edge_is_constrained[mesh.edge_of[h]];
  return is_constrained;
}

// Adds the quads of a manifold mesh in flat arrays to a graph, with their points and feature edges.
template <typename QuadMesh, typename VertexPointMap, typename EdgeIsConstrainedMap, typename NewFace>
void add_quads(const Indexed_quad_mesh& m, QuadMesh& qm, VertexPointMap vpm, EdgeIsConstrainedMap ecm,
               const NewFace& new_face)
{
  typedef typename boost::graph_traits<QuadMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;

  std::vector<vertex_descriptor> vertex;
  for(const Indexed_quad_mesh::Point_3& p : m.points)
  {
    vertex.push_back(add_vertex(qm));
    put(vpm, vertex.back(), Point(p.x(), p.y(), p.z()));
  }
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    const std::array<int, 4>& c = m.corners[f];
    const std::array<vertex_descriptor, 4> corners = { { vertex[c[0]], vertex[c[1]], vertex[c[2]], vertex[c[3]] } };
    new_face(Euler::add_face(corners, qm), f);
  }
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(m.edge(h) == h)
      put(ecm, edge(halfedge(vertex[m.source(h)], vertex[m.target(h)], qm).first, qm), m.is_feature[h] != 0);
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief makes a quad mesh of a triangle mesh along a layout of four-sided patches.
 *
 * The layout says what the quad mesh looks like in the large: all its irregular vertices are nodes of the layout or
 * T-vertices. The method is that of chapter 7 of Bommes: *Quadrilateral surface mesh generation for animation and
 * simulation* (2012), see also Bommes, Vossemer, Kobbelt: *Quadrangular parameterization for reverse engineering*
 * (2010):
 *
 *  - The layout is drawn on the surface: nodes become vertices, arcs short paths that do not cross each other.
 *  - Each patch is mapped to a chart, a square, a rectangle or a convex quadrilateral. Where patches meet, their maps
 *    are related by affine transition functions, so the map is smooth across all arcs that are not aligned. The shape
 *    of each chart is chosen such that the map comes as near to an isometry as possible.
 *  - Each arc is divided into segments, equally many on opposite sides of a patch, the samples of the charts are
 *    joined, and their crossings are mapped to the surface.
 *
 * Where the map is folded, further arcs are aligned, and a patch that remains folded is mapped by itself with positive
 * weights, which cannot fold it.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam QuadMesh a model of `MutableFaceGraph`
 * \tparam NamedParametersTM a sequence of named parameters
 * \tparam NamedParametersQM a sequence of named parameters
 *
 * \param tm the triangle mesh, of any genus, closed or with border
 * \param layout the layout
 * \param qm the quad mesh: quads are added to what it contains. It stays as it is if there are none.
 * \param np_tm an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{target_edge_length}
 *     \cgalParamDescription{length of the quad edges, in the unit of the points; an arc may have its own}
 *     \cgalParamType{double}
 *     \cgalParamDefault{from the number of quads}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_number_of_quads}
 *     \cgalParamDescription{how many quads there should be, as near as the patches allow it}
 *     \cgalParamType{a number type}
 *     \cgalParamDefault{`4000`, unless there is a target edge length}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{layout_chart}
 *     \cgalParamDescription{the shape of all charts; with `Layout_chart::AUTOMATIC` what each patch says}
 *     \cgalParamType{`Layout_chart`}
 *     \cgalParamDefault{`Layout_chart::AUTOMATIC`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{how often the charts are optimized and the map is computed anew}
 *     \cgalParamType{unsigned int}
 *     \cgalParamDefault{`3`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{arc_alignment}
 *     \cgalParamDescription{the arcs that quad edges have to represent; those on the border always are}
 *     \cgalParamType{`Arc_alignment`}
 *     \cgalParamDefault{`Arc_alignment::FEATURES`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map that tells the feature edges of `tm`. Arcs along them are aligned, and
 *       patches between them get quadrilateral charts.}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{no edge is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{mean_value_weights}
 *     \cgalParamDescription{whether vertices are mean values of their neighbours with mean value weights instead of
 *       discrete harmonic ones}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{least_squares_alignment}
 *     \cgalParamDescription{A vertex on an aligned arc has two equations but one unknown. With `true` both hold in the
 *       sense of least squares, and all others exactly; with `false` the one along the arc holds exactly, which takes
 *       a system of half the size.}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{rounding_method}
 *     \cgalParamDescription{how the numbers of segments are found where T-vertices make them depend on each other:
 *       `Rounding_method::DIRECT` rounds free variables, which may leave an arc without segments, and then there is
 *       no mesh}
 *     \cgalParamType{`Rounding_method`}
 *     \cgalParamDefault{`Rounding_method::BRANCH_AND_BOUND`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor with the interface of `Default_visitor`, passed as `std::ref(visitor)`}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \param np_qm an optional sequence of named parameters for `qm`: `vertex_point_map`; `edge_is_constrained_map`, a
 *        writable map that receives whether an edge lies on an aligned arc; `face_patch_map`, a writable map that
 *        receives the number of the patch of each quad, a `std::size_t`
 *
 * \return what was done
 *
 * \pre `CGAL::is_triangle_mesh(tm)`
 */
template <typename TriangleMesh, typename QuadMesh, typename NamedParametersTM = parameters::Default_named_parameters,
          typename NamedParametersQM = parameters::Default_named_parameters>
Layout_quadrangulation_result quadrangulate_layout(const TriangleMesh& tm, const Surface_layout& layout, QuadMesh& qm,
                                                   const NamedParametersTM& np_tm = parameters::default_values(),
                                                   const NamedParametersQM& np_qm = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  typedef typename boost::graph_traits<QuadMesh>::face_descriptor face_descriptor;

  internal::check_parameters<
    NamedParametersTM, internal_np::target_edge_length_t, internal_np::target_number_of_quads_t,
    internal_np::layout_chart_t, internal_np::number_of_iterations_t, internal_np::arc_alignment_t,
    internal_np::edge_is_constrained_t, internal_np::mean_value_weights_t, internal_np::least_squares_alignment_t,
    internal_np::rounding_method_t, internal_np::vertex_point_t, internal_np::vertex_index_t, internal_np::face_index_t,
    internal_np::visitor_t>();
  internal::check_parameters<NamedParametersQM, internal_np::vertex_point_t, internal_np::edge_is_constrained_t,
                             internal_np::face_patch_t>();
  CGAL_precondition(is_triangle_mesh(tm));

  internal::Layout_options options;
  internal::read_parameter(np_tm, internal_np::target_edge_length, options.edge_length);
  internal::read_parameter(np_tm, internal_np::target_number_of_quads, options.number_of_quads);
  internal::read_parameter(np_tm, internal_np::layout_chart, options.chart);
  internal::read_parameter(np_tm, internal_np::number_of_iterations, options.iterations);
  internal::read_parameter(np_tm, internal_np::arc_alignment, options.alignment);
  internal::read_parameter(np_tm, internal_np::mean_value_weights, options.mean_value_weights);
  internal::read_parameter(np_tm, internal_np::least_squares_alignment, options.least_squares_alignment);
  internal::read_parameter(np_tm, internal_np::rounding_method, options.rounding);

  internal::Named_visitor<NamedParametersTM> visitor(np_tm);

  const internal::Indexed_triangle_mesh mesh = internal::make_indexed_triangle_mesh(tm, np_tm);
  internal::Layout_quads quads;
  const Layout_quadrangulation_result result = internal::quadrangulate_indexed_layout(
    mesh, internal::constrained_halfedges(mesh, tm, np_tm), layout, options, visitor, quads);
  if(result.is_valid())
  {
    auto vpm = choose_parameter(get_parameter(np_qm, internal_np::vertex_point), get_property_map(vertex_point, qm));
    auto patch_map = get_parameter(np_qm, internal_np::face_patch);
    internal::add_quads(quads.mesh, qm, vpm, internal::edge_constraint_map(qm, np_qm),
                        [&](face_descriptor f, int i)
                        {
                          if constexpr(!is_default_parameter<NamedParametersQM, internal_np::face_patch_t>::value)
                            put(patch_map, f, static_cast<std::size_t>(quads.patch[i]));
                          else
                          {
                            CGAL_USE(f);
                            CGAL_USE(i);
                            CGAL_USE(patch_map);
                          }
                        });
  }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_QUADRANGULATE_LAYOUT_H
