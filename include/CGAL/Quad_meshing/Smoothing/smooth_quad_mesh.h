// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_SMOOTH_QUAD_MESH_H
#define CGAL_QUAD_MESHING_SMOOTHING_SMOOTH_QUAD_MESH_H

#include <CGAL/Quad_meshing/Smoothing/Quad_mesh_smoothing_result.h>
#include <CGAL/Quad_meshing/Smoothing/Smoothing_reference.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/Smoothing/work_on_quad_mesh_copy.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_reference.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/read_parameter.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

// Smooths on `make_reference(flat copy)` and writes the points back.
template <typename QuadMesh, typename NamedParameters, typename MakeReference>
Quad_mesh_smoothing_result smooth_quad_mesh_with(QuadMesh& qm, const NamedParameters& np,
                                                 const MakeReference& make_reference)
{
  typedef typename GetVertexPointMap<QuadMesh, NamedParameters>::type Vertex_point_map;
  typedef typename boost::property_traits<Vertex_point_map>::value_type Point;

  check_parameters<NamedParameters, internal_np::vertex_point_t, internal_np::edge_is_constrained_t,
                   internal_np::vertex_is_constrained_t, internal_np::smoothing_iterations_t,
                   internal_np::smooth_globally_t, internal_np::visitor_t>();

  Smoothing_options options;
  read_parameter(np, internal_np::smoothing_iterations, options.iterations);
  read_parameter(np, internal_np::smooth_globally, options.globally);
  return work_on_quad_mesh_copy<Quad_mesh_smoothing_result>(
    qm, np, make_reference,
    [&](auto& copy, const std::vector<char>& is_fixed, Smoothing_reference& reference, Any_visitor& visitor, auto vpm,
        auto)
    {
      const std::vector<Indexed_quad_mesh::Point_3> before = copy.mesh.points;
      const Quad_mesh_smoothing_result result =
        smooth_indexed_quad_mesh(copy.mesh, reference, is_fixed, options, visitor);
      for(std::size_t i = 0; i < copy.vertices.size(); ++i)
      {
        const Indexed_quad_mesh::Point_3& p = copy.mesh.points[i];
        if(p != before[i])
          put(vpm, copy.vertices[i], Point(p.x(), p.y(), p.z()));
      }
      return result;
    });
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief smooths a quad mesh on a reference surface, so that its quads become more like squares and
 * their sizes more even.
 *
 * Only positions change. Each vertex moves within its realm: a vertex on no constrained edge on the
 * reference surface, a vertex between two constrained edges along the feature curves of the
 * reference, a vertex between two boundary edges along its boundary. All other vertices on
 * constrained edges stay where they are: those where one, three or more constrained or boundary
 * edges meet, those at a corner of the curve (where the reference curve turns by more than 50
 * degrees or branches), and those that the user fixes.
 *
 * The energy of each corner is the ratio of the squared lengths of its sides to its area, least for
 * a square corner, with a smaller part that asks for the mean area of the neighbourhood; it is
 * minimized vertex by vertex. A quad that is strictly convex stays so and is not turned over, because
 * steps that would do so are not taken. If the input has folded quads, these and their neighbourhood
 * are first unfolded with the energy of Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov: *Foldover-free maps in
 * 50 lines of code*, ACM TOG 40(4), 2021. That needs no valid start and mostly succeeds, but is not guaranteed to.
 *
 * Where directions are given, each side of a quad pays for its angle to the direction at the middle of the quad, up to
 * quarter turns, and at most as much as for an angle of 45 degrees: quads keep the orientation of a cross field.
 *
 * Vertex by vertex, a mesh gets well shaped where it has to move by a few quads. With `smooth_globally`, all vertices
 * are moved at once by steps of Newton's method, as long as they help: they can go all over the surface. Corners are to
 * be right angles first then, and quads may become rectangles. Quads with scaled Jacobians below 0.5 do not become
 * worse, better ones not worse than that, and the worst ones are improved in the end.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam NamedParametersQM a sequence of named parameters
 * \tparam NamedParametersTM a sequence of named parameters
 *
 * \param qm the quad mesh to smooth
 * \param tm the reference surface, a triangle mesh
 * \param np_qm an optional sequence of named parameters for `qm` among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `qm`}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, qm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map that tells the feature edges of `qm`. The boundary needs not be marked.}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a constant map: no edge is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{a property map that tells the vertices of `qm` that must not move}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a constant map: no vertex is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{smoothing_iterations}
 *     \cgalParamDescription{the largest number of sweeps and steps; the smoothing ends sooner when all vertices rest}
 *     \cgalParamType{unsigned int}
 *     \cgalParamDefault{`20`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{smooth_globally}
 *     \cgalParamDescription{whether all vertices are moved at once: if they have to go far}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor with the interface of `Default_visitor`, passed as `std::ref(visitor)`}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \param np_tm an optional sequence of named parameters for `tm` among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map that tells the feature edges of `tm`, along which the
 *                           vertices of constrained edges of `qm` slide}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{a constant map: no edge is constrained. The vertices of constrained edges of
 *                       `qm` then slide along the polylines that these edges form in the input.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_sizing_map}
 *     \cgalParamDescription{the length of quad edges per face of `tm`, positive, in any unit: quads aim at areas in
 *       proportion to its squares; with little weight if it is constant, for equal areas bend corners}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type}
 *     \cgalParamDefault{quads aim at the areas of their neighbors}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_direction_map}
 *     \cgalParamDescription{for some faces of `tm`, a direction in their plane that the sides of quads there should
 *       have, up to quarter turns}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an optional vector, such as
 *                    `std::optional<Vector_3>`, as value type}
 *     \cgalParamDefault{quads may turn as they like}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_direction_weight_map}
 *     \cgalParamDescription{how much that direction counts: with 1, a deviation of a side costs as much as the same
 *       deviation of an angle from a right angle}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type}
 *     \cgalParamDefault{`1`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return what was done, with the measures before and after
 *
 * \pre `CGAL::is_triangle_mesh(tm)`, and no vertex of `tm` or `qm` is non-manifold
 */
template <typename QuadMesh, typename TriangleMesh, typename NamedParametersQM = parameters::Default_named_parameters,
          typename NamedParametersTM = parameters::Default_named_parameters>
Quad_mesh_smoothing_result smooth_quad_mesh(QuadMesh& qm, const TriangleMesh& tm,
                                            const NamedParametersQM& np_qm = parameters::default_values(),
                                            const NamedParametersTM& np_tm = parameters::default_values())
{
  CGAL_precondition(is_triangle_mesh(tm));
  return internal::smooth_quad_mesh_with(
    qm, np_qm,
    [&](const internal::Indexed_quad_mesh& m)
    {
      return internal::Smoothing_reference(
        m, internal::make_indexed_reference<internal_np::face_sizing_map_t, internal_np::face_direction_map_t,
                                            internal_np::face_direction_weight_map_t>(tm, np_tm));
    });
}

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief smooths a quad mesh on the surface that its quads, cut into two triangles each, form in the
 * input.
 *
 * Otherwise as above.
 */
template <typename QuadMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Quad_mesh_smoothing_result smooth_quad_mesh(QuadMesh& qm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::smooth_quad_mesh_with(
    qm, np, [](const internal::Indexed_quad_mesh& m) { return internal::Smoothing_reference(m); });
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_SMOOTH_QUAD_MESH_H
