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
#include <CGAL/Quad_meshing/Structure/internal/Smoothing_reference.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_optimizer.h>
#include <CGAL/Quad_meshing/Structure/internal/write_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Structure/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

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
  std::size_t operators_applied = 0;        ///< number of grid-preserving operators
  Quad_mesh_structure structure_before;     ///< structure of the input
  Quad_mesh_structure structure_after;      ///< structure of the output
  /// what the smoothing at the end did. Its input is the mesh after the last operator.
  Quad_mesh_smoothing_result smoothing;
};

namespace internal {

struct Structure_options
{
  bool merge_singularities = false;
  bool collapse_dual_curves = false;
  std::size_t target_quads = 0;
  std::size_t target_patches = 0;
  unsigned int smoothing_iterations = 20;
};

// The greedy algorithm of section 10.3, then the collapses of section 10.4.
template <typename Visitor>
Quad_structure_optimization_result
optimize_indexed_quad_structure(Structure_optimizer& optimizer, Smoothing_reference& reference,
                                const Structure_options& options, Visitor& visitor)
{
  typedef Quad_structure_optimization_result Result;
  // Sweeps of smoothing between operators, which keep the positions apart, and how many of them there
  // are at most: the cost must not grow with the number of operators.
  constexpr unsigned int sweeps_between = 3;
  constexpr std::size_t smoothings_between = 12;

  Result result;
  result.structure_before = structure_of_quad_mesh(optimizer.state.mesh);
  const double helices = (std::max)(1., double(optimizer.score().helices));
  Default_visitor silent;
  std::size_t smoothed_at = 0, gap = 1, smoothings = 0;
  auto target_reached = [&]
  {
    return (options.target_quads > 0 && optimizer.state.mesh.corners.size() <= options.target_quads)
        || (options.target_patches > 0 && std::size_t(optimizer.score().patches) <= options.target_patches);
  };
  auto after_operator = [&]
  {
    if(options.smoothing_iterations == 0 || optimizer.operators < smoothed_at + gap)
      return;
    smooth_indexed_quad_mesh(optimizer.state.mesh, reference, optimizer.state.is_fixed, sweeps_between, silent);
    smoothed_at = optimizer.operators;
    if(++smoothings % smoothings_between == 0)
      gap *= 4;
  };
  auto go_further = [&] { return visitor.go_further(); };

  visitor.on_stage_begin("structure");
  // Helices that could not be removed at first get a second chance after others have gone.
  bool gained = true;
  while(gained && !target_reached() && visitor.go_further())
  {
    gained = false;
    while(!target_reached() && optimizer.remove_next_helix(go_further))
    {
      gained = true;
      after_operator();
      visitor.progress((std::max)(0., (std::min)(1., 1 - optimizer.score().helices / helices)));
    }
    gained = optimizer.forget_failures() && gained;
  }
  while(options.collapse_dual_curves && !target_reached() && visitor.go_further()
        && optimizer.collapse_next_dual_curve())
    after_operator();
  visitor.on_stage_end("structure");

  result.operators_applied = optimizer.operators;
  if(visitor.go_further() && options.smoothing_iterations > 0)
    result.smoothing = smooth_indexed_quad_mesh(optimizer.state.mesh, reference, optimizer.state.is_fixed,
                                                options.smoothing_iterations, visitor);
  else
    result.smoothing.quality_before = result.smoothing.quality_after = quality_of_quad_mesh(optimizer.state.mesh);
  if(!visitor.go_further())
  {
    result.status = Result::stopped;
    result.operators_applied = 0;
    result.structure_after = result.structure_before;
    result.message = "The optimization was stopped; the mesh is as it was.";
    return result;
  }
  result.structure_after = structure_of_quad_mesh(optimizer.state.mesh);
  result.message = "The base complex has " + std::to_string(result.structure_after.number_of_patches) + " patches, "
                 + std::to_string(result.structure_before.number_of_patches) + " before; "
                 + std::to_string(result.structure_after.number_of_helices) + " helices are left of "
                 + std::to_string(result.structure_before.number_of_helices) + ".";
  return result;
}

// Reads the named parameters of the quad mesh and optimizes it on `make_reference(copy)`.
template <typename QuadMesh, typename NamedParameters, typename MakeReference>
Quad_structure_optimization_result
optimize_quad_structure_with(QuadMesh& qm, const NamedParameters& np, const MakeReference& make_reference)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  typedef boost::graph_traits<QuadMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef Quad_structure_optimization_result Result;

  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(vertex_point, qm));
  auto ecm = choose_parameter(get_parameter(np, internal_np::edge_is_constrained), Ignoring_map<edge_descriptor>());
  const auto vcm = choose_parameter(get_parameter(np, internal_np::vertex_is_constrained),
                                    Static_boolean_property_map<vertex_descriptor, false>());
  Default_visitor default_visitor;
  auto&& visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  Structure_options options;
  options.merge_singularities = choose_parameter(get_parameter(np, internal_np::merge_singularities), false);
  options.collapse_dual_curves = choose_parameter(get_parameter(np, internal_np::collapse_dual_curves), false);
  options.target_quads = choose_parameter(get_parameter(np, internal_np::target_number_of_quads), 0);
  options.target_patches = choose_parameter(get_parameter(np, internal_np::target_number_of_patches), 0);
  options.smoothing_iterations = choose_parameter(get_parameter(np, internal_np::smoothing_iterations), 20);

  Result result;
  if(!is_quad_mesh(qm) || faces(qm).begin() == faces(qm).end())
  {
    result.status = Result::not_a_quad_mesh;
    result.message = "The mesh has faces that are not quads, or no faces.";
    return result;
  }
  const Indexed_quad_mesh_copy<QuadMesh> copy = make_indexed_quad_mesh(qm, vpm, ecm);
  std::vector<char> is_fixed;
  for(vertex_descriptor v : copy.vertices)
    is_fixed.push_back(get(vcm, v) ? 1 : 0);
  Smoothing_reference reference = make_reference(copy.mesh);
  if(reference.surface.empty())
  {
    result.status = Result::empty_reference;
    result.message = "The reference surface has no triangle of positive area.";
    return result;
  }

  Structure_optimizer optimizer(copy.mesh, is_fixed, options.merge_singularities);
  result = optimize_indexed_quad_structure(optimizer, reference, options, visitor);
  if(result.status == Result::optimized)
    write_quad_mesh(optimizer.state.mesh, optimizer.state.vertex_origin, optimizer.state.face_origin, copy, qm, vpm, ecm);
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief makes the base complex of a quad mesh coarser, without changing its topology and its
 * irregular vertices, by removing helices with grid-preserving operators.
 *
 * The helix with the largest winding number that can be removed with a gain is removed first. A
 * helix is tried in several of its columns and in both directions, one operator for each unit of its pitch. The
 * operators do not destroy closed dual curves, do not wind up helices of more than two turns, and
 * leave constrained edges, the boundary and the irregular vertices as they are. A step is kept if the
 * base complex has become smaller, or has the same size and fewer helices; so the result is
 * never worse than the input. Each operator removes quads; at least 40 percent of them remain. The positions are smoothed on the reference in between and at the end
 * (see `smooth_quad_mesh()`).
 *
 * \tparam QuadMesh a model of `MutableFaceGraph` and `FaceListGraph`
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam NamedParametersQM a sequence of named parameters
 * \tparam NamedParametersTM a sequence of named parameters
 *
 * \param qm the quad mesh. The vertices and faces that remain keep their descriptors.
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
 *     \cgalParamDescription{the optimization ends when there are no more quads than this}
 *     \cgalParamType{std::size_t}
 *     \cgalParamDefault{`0`: no target}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_number_of_patches}
 *     \cgalParamDescription{the optimization ends when the base complex has no more patches than this}
 *     \cgalParamType{std::size_t}
 *     \cgalParamDefault{`0`: no target}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{smoothing_iterations}
 *     \cgalParamDescription{number of sweeps of the smoothing at the end; with 0, nothing is smoothed at all}
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
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;

  CGAL_precondition(is_triangle_mesh(tm));
  const auto vpm = choose_parameter(get_parameter(np_tm, internal_np::vertex_point),
                                    get_const_property_map(vertex_point, tm));
  const auto ecm = choose_parameter(get_parameter(np_tm, internal_np::edge_is_constrained),
                                    Static_boolean_property_map<edge_descriptor, false>());
  return internal::optimize_quad_structure_with(qm, np_qm, [&](const internal::Indexed_quad_mesh& m)
  {
    return internal::make_smoothing_reference(m, tm, vpm, ecm);
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
