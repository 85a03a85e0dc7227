// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_OPTIMIZE_QUAD_STRUCTURE_H
#define CGAL_QUAD_MESHING_STRUCTURE_OPTIMIZE_QUAD_STRUCTURE_H

#include <CGAL/Quad_meshing/Smoothing/Smoothing_reference.h>
#include <CGAL/Quad_meshing/Smoothing/work_on_quad_mesh_copy.h>
#include <CGAL/Quad_meshing/Structure/Quad_structure_optimization_result.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/Structure/internal/optimize_indexed_quad_structure.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_reference.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/read_parameter.h>
#include <CGAL/Quad_meshing/internal/write_quad_mesh.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

// Optimizes a flat copy on `make_reference(copy)` and writes it back. `options` are those where nothing is named.
template <typename QuadMesh, typename NamedParameters, typename MakeReference>
Quad_structure_optimization_result optimize_quad_structure_with(QuadMesh& qm, const NamedParameters& np,
                                                                const MakeReference& make_reference,
                                                                Structure_options options = Structure_options())
{
  typedef Quad_structure_optimization_result Result;

  check_parameters<NamedParameters, internal_np::vertex_point_t, internal_np::edge_is_constrained_t,
                   internal_np::vertex_is_constrained_t, internal_np::structure_method_t,
                   internal_np::merge_singularities_t, internal_np::collapse_dual_curves_t,
                   internal_np::target_number_of_quads_t, internal_np::target_number_of_patches_t,
                   internal_np::number_of_iterations_t, internal_np::smoothing_iterations_t,
                   internal_np::maximum_running_time_t, internal_np::visitor_t>();

  read_parameter(np, internal_np::structure_method, options.method);
  read_parameter(np, internal_np::merge_singularities, options.merge_singularities);
  read_parameter(np, internal_np::collapse_dual_curves, options.collapse_dual_curves);
  read_parameter(np, internal_np::target_number_of_quads, options.target_quads);
  read_parameter(np, internal_np::target_number_of_patches, options.target_patches);
  read_parameter(np, internal_np::number_of_iterations, options.layouts);
  read_parameter(np, internal_np::smoothing_iterations, options.smoothing_iterations);
  read_parameter(np, internal_np::maximum_running_time, options.maximum_running_time);

  return work_on_quad_mesh_copy<Result>(qm, np, make_reference,
                                        [&](const auto& copy, const std::vector<char>& is_fixed,
                                            Smoothing_reference& reference, Any_visitor& visitor, auto vpm, auto ecm)
                                        {
                                          if(copy.mesh.number_of_faces() == 0)
                                          {
                                            Result result;
                                            result.status = Quad_mesh_status::NOT_A_QUAD_MESH;
                                            result.message = "The mesh has no faces.";
                                            return result;
                                          }
                                          Structure_state s = initial_structure_state(copy.mesh, is_fixed);
                                          const Result result =
                                            optimize_indexed_quad_structure(s, reference, options, visitor);
                                          if(result.status == Quad_mesh_status::SUCCESS)
                                            write_quad_mesh(s.mesh, s.vertex_origin, s.face_origin, copy, qm, vpm, ecm);
                                          return result;
                                        });
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief makes the base complex of a quad mesh coarser, without changing its topology and its
 * irregular vertices.
 *
 * By default a coarse layout is searched. The straight lines from the irregular vertices, each of them up to where it
 * meets another one, cut the mesh into few rectangles; integer lengths are chosen for their sides such that sides
 * vanish, which makes lines from different irregular vertices meet (Lyon, Campen, Kobbelt: *Quad layouts via
 * constrained T-mesh quantization*, Computer Graphics Forum 40(2), 2021). Then each dual curve of the layout is
 * replaced by several parallel ones, so that there are about as many quads as before, or fewer if that gives fewer
 * helices. The layout is chosen by its number of helices, by its number of patches, by how many quads there are and by
 * how much they have to be sheared and stretched. A layout on which the smoothing leaves bad quads, or that has more
 * than four helices and more than the input, is given up for another one; if there is none without, the input stays.
 *
 * With `Structure_method::HELICES`, helices are removed by grid-preserving operators: the helix with the largest
 * winding number that can be removed with a gain first, in several of its columns and in both directions, one operator
 * for each unit of its pitch (Bommes, Lempfer, Kobbelt: *Global structure optimization of quadrilateral meshes*,
 * Computer Graphics Forum 30(2), 2011). The operators do not destroy closed dual curves and do not wind up helices of
 * more than two turns. A step is kept if there are fewer helices then, and not more in either way of counting (with and
 * without those that cross themselves), or as many and a smaller base complex. Each operator removes quads; at least 40
 * percent of them remain. A mesh without irregular vertices is always treated in this way.
 *
 * In both, constrained edges, the boundary and the irregular vertices are kept, and the positions are smoothed on the
 * reference (see `smooth_quad_mesh()`). The result does not have more inverted or folded quads than the input, and its
 * minimal scaled Jacobian is at least half as large, unless nothing is smoothed. With `merge_singularities` or
 * `collapse_dual_curves` this does not hold for the Jacobian.
 *
 * \tparam QuadMesh a model of `MutableFaceGraph` and `FaceListGraph`
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam NamedParametersQM a sequence of named parameters
 * \tparam NamedParametersTM a sequence of named parameters
 *
 * \param qm the quad mesh. There are not more vertices, edges and faces afterwards than before, and those that remain
 * have descriptors of the input: the irregular and the constrained vertices their own.
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
 *     \cgalParamDescription{a property map that tells the feature edges of `qm`, and after the call those of the
 *       result}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{no edge is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{a property map that tells the vertices of `qm` that must neither move nor be merged}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{no vertex is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{structure_method}
 *     \cgalParamDescription{how the structure is optimized}
 *     \cgalParamType{Structure_method}
 *     \cgalParamDefault{`Structure_method::LAYOUT`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{merge_singularities}
 *     \cgalParamDescription{whether irregular vertices may be merged with each other, and moved onto constrained edges}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{collapse_dual_curves}
 *     \cgalParamDescription{whether, at the end, all dual curves are collapsed that can be, the shortest first. The
 *       result is very coarse: as a base mesh, or until a target is reached. If the base complex is coarser on the way
 *       than at the end, the mesh on the way is the result.}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_number_of_quads}
 *     \cgalParamDescription{the result has no more quads than this, if that is possible. The dual curves of a layout
 *       are
 *                           multiplied up to this number, which is at most that of the input; with 1 they are not
 *                           multiplied at
 *                           all, and the layout itself is the result. The removal of helices, and the collapse of dual
 *                           curves,
 *                           end when there are no more quads than this.}
 *     \cgalParamType{std::size_t}
 *     \cgalParamDefault{`0`: no target. A layout gets as many quads as the input has.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_number_of_patches}
 *     \cgalParamDescription{the optimization ends when the base complex has no more patches than this. A layout is made
 *       as
 *                           coarse as that and no coarser, if possible.}
 *     \cgalParamType{std::size_t}
 *     \cgalParamDefault{`0`: no target. A layout gets at most 20 quads for each irregular vertex, and a quarter of the
 *       quads
 *                       of the input, before its dual curves are multiplied.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the number of layouts that are tried at random in one round. There are up to four rounds,
 *       as long as
 *                           the goals of the manual are not reached. More of them take more time and find better
 *                           layouts.}
 *     \cgalParamType{unsigned int}
 *     \cgalParamDefault{`10000`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{smoothing_iterations}
 *     \cgalParamDescription{number of sweeps of the smoothing at the end, or of its steps that move all vertices of a
 *       new layout
 *                           at once; with 0, nothing is smoothed at all}
 *     \cgalParamType{unsigned int}
 *     \cgalParamDefault{`20`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_running_time}
 *     \cgalParamDescription{the search ends after this time, in seconds, with the best mesh that has been found until
 *       then; it is
 *                           not smoothed once more at the end. The result says so.}
 *     \cgalParamType{double}
 *     \cgalParamDefault{no limit}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor with the interface of `Default_visitor`, passed as `std::ref(visitor)`}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \param np_tm an optional sequence of named parameters for `tm`: `vertex_point_map`, `edge_is_constrained_map` that
 *        tells the feature edges, and `face_direction_map` with `face_direction_weight_map`, the directions that the
 *        sides of quads should have, as for `smooth_quad_mesh()`
 *
 * \return what was done
 *
 * \pre `CGAL::is_triangle_mesh(tm)`, and no vertex of `tm` or `qm` is non-manifold
 */
template <typename QuadMesh, typename TriangleMesh, typename NamedParametersQM = parameters::Default_named_parameters,
          typename NamedParametersTM = parameters::Default_named_parameters>
Quad_structure_optimization_result
optimize_quad_structure(QuadMesh& qm, const TriangleMesh& tm,
                        const NamedParametersQM& np_qm = parameters::default_values(),
                        const NamedParametersTM& np_tm = parameters::default_values())
{
  CGAL_precondition(is_triangle_mesh(tm));
  return internal::optimize_quad_structure_with(
    qm, np_qm,
    [&](const internal::Indexed_quad_mesh& m)
    {
      return internal::Smoothing_reference(
        m,
        internal::make_indexed_reference<internal_np::face_direction_map_t, internal_np::face_direction_weight_map_t>(
          tm, np_tm));
    });
}

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief the same with the surface of the quad mesh itself, its quads cut into two triangles each, as the
 * reference.
 */
template <typename QuadMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Quad_structure_optimization_result optimize_quad_structure(QuadMesh& qm,
                                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::optimize_quad_structure_with(
    qm, np, [](const internal::Indexed_quad_mesh& m) { return internal::Smoothing_reference(m); });
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_OPTIMIZE_QUAD_STRUCTURE_H
