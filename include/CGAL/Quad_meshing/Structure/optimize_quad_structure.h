// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_OPTIMIZE_QUAD_STRUCTURE_H
#define CGAL_QUAD_MESHING_STRUCTURE_OPTIMIZE_QUAD_STRUCTURE_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Smoothing/Smoothing_reference.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/Smoothing/work_on_quad_mesh_copy.h>
#include <CGAL/Quad_meshing/Structure/internal/Accepted_shape.h>
#include <CGAL/Quad_meshing/Structure/internal/Shape_watch.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_methods.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_optimizer.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/internal/write_quad_mesh.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief is the way in which `optimize_quad_structure()` proceeds.
 */
enum class Structure_method
{
  LAYOUT,     ///< looks for a coarse layout of the whole mesh, then multiplies its dual curves
  HELICES     ///< removes helices one by one
};

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief tells what `optimize_quad_structure()` did.
 */
struct Quad_structure_optimization_result
{
  /// outcome of the optimization
  enum Status {
    optimized,            ///< the structure has been optimized
    not_a_quad_mesh,      ///< the mesh has faces that are not quads, or no faces; it has not been touched
    empty_reference,      ///< the reference has no triangle of positive area; the mesh has not been touched
    stopped               ///< the visitor asked for an early end; the mesh is as it was
  };

  Status status = optimized;                ///< the outcome
  std::string message;                      ///< the outcome as a sentence
  std::size_t operators_applied = 0;        ///< number of grid-preserving operators applied one by one
  Quad_mesh_structure structure_before;     ///< structure of the input
  Quad_mesh_structure structure_after;      ///< structure of the output
  /// what the smoothing at the end did. Its input is the mesh after the last operator.
  Quad_mesh_smoothing_result smoothing;
};

namespace internal {

// The method that is asked for, the collapses of section 10.4, and the smoothing.
template <typename Visitor>
Quad_structure_optimization_result
optimize_indexed_quad_structure(Structure_optimizer& optimizer, Smoothing_reference& reference, Structure_method method,
                                const Structure_options& options, Visitor& visitor)
{
  typedef Quad_structure_optimization_result Result;

  Result result;
  result.structure_before = structure_of_quad_mesh(optimizer.state.mesh);
  auto target_reached = [&]
  {
    return (options.target_quads > 0 && optimizer.state.mesh.corners.size() <= options.target_quads)
        || (options.target_patches > 0 && std::size_t(optimizer.score().patches) <= options.target_patches);
  };
  Default_visitor silent;
  // the vertices of a new layout may have to go far
  const bool is_new_layout = method == Structure_method::LAYOUT && result.structure_before.number_of_irregular_vertices > 0;
  auto smooth_with = [&](Structure_state& s, unsigned int sweeps, bool globally)
  {
    return options.smoothing_iterations == 0
      ? Quad_mesh_smoothing_result()
      : smooth_indexed_quad_mesh(s.mesh, reference, s.is_fixed, sweeps, globally, silent);
  };
  auto smooth = [&](Structure_state& s, unsigned int sweeps) { return smooth_with(s, sweeps, false); };
  Accepted_shape accepted;
  if(options.smoothing_iterations > 0)
  {
    Structure_state input = optimizer.state;
    accepted = Accepted_shape(smooth(input, 0), options.merge_singularities || options.collapse_dual_curves);
  }

  visitor.on_stage_begin("structure");
  if(is_new_layout)
    optimize_layout(optimizer, options, accepted,
                    [&](Structure_state& s, unsigned int sweeps) { return smooth_with(s, sweeps, true); }, visitor);
  else
  {
    Shape_watch<decltype(smooth)> watch(optimizer, accepted, smooth, options.smoothing_iterations);
    remove_helices(optimizer, watch, target_reached, visitor);
  }
  if(options.collapse_dual_curves)
  {
    Shape_watch<decltype(smooth)> watch(optimizer, accepted, smooth, options.smoothing_iterations);
    collapse_dual_curves(optimizer, watch, target_reached, visitor);
  }
  visitor.on_stage_end("structure");
  result.operators_applied = optimizer.operators;

  // what has been accepted stays so
  Indexed_quad_mesh& m = optimizer.state.mesh;
  const std::vector<Indexed_quad_mesh::Point_3> points = m.points;
  if(visitor.go_further() && options.smoothing_iterations > 0)
    result.smoothing = smooth_indexed_quad_mesh(m, reference, optimizer.state.is_fixed, options.smoothing_iterations,
                                                is_new_layout, visitor);
  if(options.smoothing_iterations == 0 || !accepted.accepts(result.smoothing))
  {
    m.points = points;
    result.smoothing = Quad_mesh_smoothing_result();
    result.smoothing.quality_before = result.smoothing.quality_after = quality_of_quad_mesh(m);
    result.smoothing.message = "The mesh has not been smoothed.";
  }
  if(!visitor.go_further())
  {
    result.status = Result::stopped;
    result.operators_applied = 0;
    result.structure_after = result.structure_before;
    result.message = "The optimization was stopped; the mesh is as it was.";
    return result;
  }
  result.structure_after = structure_of_quad_mesh(m);
  result.message = "The base complex has " + std::to_string(result.structure_after.number_of_patches) + " patches, "
                 + std::to_string(result.structure_before.number_of_patches) + " before; the number of helices is "
                 + std::to_string(result.structure_after.number_of_helices) + ", "
                 + std::to_string(result.structure_before.number_of_helices) + " before.";
  if(options.target_patches > 0 && result.structure_after.number_of_patches > options.target_patches)
    result.message += " The target of " + std::to_string(options.target_patches) + " patches has not been reached.";
  if(options.target_quads > 1 && result.structure_after.number_of_quads > options.target_quads)
    result.message += " The target of " + std::to_string(options.target_quads) + " quads has not been reached.";
  return result;
}

// Optimizes a flat copy on `make_reference(copy)` and writes it back.
template <typename QuadMesh, typename NamedParameters, typename MakeReference>
Quad_structure_optimization_result
optimize_quad_structure_with(QuadMesh& qm, const NamedParameters& np, const MakeReference& make_reference)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef Quad_structure_optimization_result Result;

  const Structure_method method =
    choose_parameter(get_parameter(np, internal_np::structure_method), Structure_method::LAYOUT);
  Structure_options options;
  options.merge_singularities = choose_parameter(get_parameter(np, internal_np::merge_singularities), false);
  options.collapse_dual_curves = choose_parameter(get_parameter(np, internal_np::collapse_dual_curves), false);
  options.target_quads = choose_parameter(get_parameter(np, internal_np::target_number_of_quads), 0);
  options.target_patches = choose_parameter(get_parameter(np, internal_np::target_number_of_patches), 0);
  options.layouts = choose_parameter(get_parameter(np, internal_np::number_of_iterations), 10000);
  options.smoothing_iterations = choose_parameter(get_parameter(np, internal_np::smoothing_iterations), 20);

  return work_on_quad_mesh_copy<Result>(qm, np, make_reference,
    [&](const auto& copy, const std::vector<char>& is_fixed, Smoothing_reference& reference, auto& visitor, auto vpm, auto ecm)
    {
      if(copy.mesh.number_of_faces() == 0)
      {
        Result result;
        result.status = Result::not_a_quad_mesh;
        result.message = "The mesh has no faces.";
        return result;
      }
      Structure_optimizer optimizer(copy.mesh, is_fixed, options.merge_singularities);
      const Result result = optimize_indexed_quad_structure(optimizer, reference, method, options, visitor);
      const Structure_state& s = optimizer.state;
      if(result.status == Result::optimized)
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
 * By default a coarse layout is searched. The straight lines from the irregular vertices, each of them up to where it meets
 * another one, cut the mesh into few rectangles; integer lengths are chosen for their sides such that sides vanish, which makes
 * lines from different irregular vertices meet (Lyon, Campen, Kobbelt: *Quad layouts via constrained T-mesh quantization*,
 * Computer Graphics Forum 40(2), 2021). Then each dual curve of the layout is replaced by several parallel ones, so that there
 * are about as many quads as before, or fewer if that gives fewer helices. The layout is chosen by its number of
 * helices, by its number of patches, by how many quads there are and by how much they have to be sheared and stretched. A layout
 * on which the smoothing leaves bad quads is given up for another one; if there is none with good quads, the input stays.
 *
 * With `Structure_method::HELICES`, helices are removed by grid-preserving operators: the helix with the largest winding
 * number that can be removed with a gain first, in several of its columns and in both directions, one operator for each unit of
 * its pitch (Bommes, Lempfer, Kobbelt: *Global structure optimization of quadrilateral meshes*, Computer Graphics Forum 30(2),
 * 2011). The operators do not destroy closed dual curves and do not wind up helices of more than two turns. A step is kept if
 * there are fewer helices then, and not more in either way of counting (with and without those that cross themselves), or as many and
 * a smaller base complex. Each operator removes quads; at least 40
 * percent of them remain. A mesh without irregular vertices is always treated in this way.
 *
 * In both, constrained edges, the boundary and the irregular vertices are kept, and the positions are smoothed on the
 * reference (see `smooth_quad_mesh()`). The result does not have more inverted or folded quads than the input, and its minimal
 * scaled Jacobian is at least half as large, unless nothing is smoothed. With `merge_singularities` or `collapse_dual_curves` this
 * does not hold for the Jacobian.
 *
 * \tparam QuadMesh a model of `MutableFaceGraph` and `FaceListGraph`
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam NamedParametersQM a sequence of named parameters
 * \tparam NamedParametersTM a sequence of named parameters
 *
 * \param qm the quad mesh. There are not more vertices, edges and faces afterwards than before, and those that remain have
 *        descriptors of the input: the irregular and the constrained vertices their own.
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
 *     \cgalParamDescription{a property map that tells the feature edges of `qm`, and after the call those of the result}
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
 *     \cgalParamDescription{whether, at the end, all dual curves are collapsed that can be, the shortest first. The result
 *                           is very coarse: as a base mesh, or until a target is reached.}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_number_of_quads}
 *     \cgalParamDescription{the result has no more quads than this, if that is possible. The dual curves of a layout are
 *                           multiplied up to this number, which is at most that of the input; with 1 they are not multiplied at
 *                           all, and the layout itself is the result. The removal of helices, and the collapse of dual curves,
 *                           end when there are no more quads than this.}
 *     \cgalParamType{std::size_t}
 *     \cgalParamDefault{`0`: no target. A layout gets as many quads as the input has.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_number_of_patches}
 *     \cgalParamDescription{the optimization ends when the base complex has no more patches than this. A layout is made as
 *                           coarse as that and no coarser, if possible.}
 *     \cgalParamType{std::size_t}
 *     \cgalParamDefault{`0`: no target. A layout gets at most 20 quads for each irregular vertex, and a quarter of the quads
 *                       of the input, before its dual curves are multiplied.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the number of layouts that are tried at random in one round. There are up to four rounds, as long as
 *                           the goals of the manual are not reached. More of them take more time and find better layouts.}
 *     \cgalParamType{unsigned int}
 *     \cgalParamDefault{`10000`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{smoothing_iterations}
 *     \cgalParamDescription{number of sweeps of the smoothing at the end, or of its steps that move all vertices of a new layout
 *                           at once; with 0, nothing is smoothed at all}
 *     \cgalParamType{unsigned int}
 *     \cgalParamDefault{`20`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor with the interface of `Default_visitor`, passed as `std::ref(visitor)`}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \param np_tm an optional sequence of named parameters for `tm`: `vertex_point_map`, and
 *        `edge_is_constrained_map` that tells the feature edges, as for `smooth_quad_mesh()`
 *
 * \return what was done
 *
 * \pre `CGAL::is_triangle_mesh(tm)`, and no vertex of `tm` or `qm` is non-manifold
 */
template <typename QuadMesh, typename TriangleMesh,
          typename NamedParametersQM = parameters::Default_named_parameters,
          typename NamedParametersTM = parameters::Default_named_parameters>
Quad_structure_optimization_result
optimize_quad_structure(QuadMesh& qm, const TriangleMesh& tm,
                        const NamedParametersQM& np_qm = parameters::default_values(),
                        const NamedParametersTM& np_tm = parameters::default_values())
{
  CGAL_precondition(is_triangle_mesh(tm));
  return internal::optimize_quad_structure_with(qm, np_qm, [&](const internal::Indexed_quad_mesh& m)
  {
    return internal::smoothing_reference(m, tm, np_tm);
  });
}

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief the same with the surface of the quad mesh itself, its quads cut into two triangles each, as the
 * reference.
 */
template <typename QuadMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Quad_structure_optimization_result
optimize_quad_structure(QuadMesh& qm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::optimize_quad_structure_with(qm, np, [](const internal::Indexed_quad_mesh& m)
  {
    return internal::Smoothing_reference(m);
  });
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_OPTIMIZE_QUAD_STRUCTURE_H
