// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_GRID_PRESERVING_OPERATORS_H
#define CGAL_QUAD_MESHING_STRUCTURE_GRID_PRESERVING_OPERATORS_H

#include <CGAL/Quad_meshing/Structure/internal/Gp_path.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/Structure/internal/gp_kernels.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/quad_mesh_parameters.h>
#include <CGAL/Quad_meshing/internal/write_quad_mesh.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief is what a step of a grid-preserving operator does to the edge that it crosses. Left and
 * right are those of someone who walks along the path.
 */
enum class Grid_preserving_step_kind
{
  SHIFT_LEFT, ///< the left end of the edge moves on to the next vertex
  COLLAPSE,   ///< both ends of the edge become one vertex
  SHIFT_RIGHT ///< the right end of the edge moves on to the next vertex
};

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief is one step of a grid-preserving operator.
 *
 * \tparam QuadMesh a model of `HalfedgeGraph`
 */
template <typename QuadMesh>
struct Grid_preserving_step
{
  /// the edge that is crossed, on the side that the step comes from: the face of this halfedge is
  /// left. If it is a border halfedge, the step enters the mesh.
  typename boost::graph_traits<QuadMesh>::halfedge_descriptor halfedge;
  /// what is done to the edge.
  Grid_preserving_step_kind kind;
};

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief is a grid-preserving operator: a closed path of steps.
 *
 * A path of shifts to the left goes straight on or turns right into collapses, a path of collapses
 * goes straight on, or turns left into shifts to the left, or right into shifts to the right, and a path of shifts
 * to the right goes straight on or turns left into collapses. A path of collapses may also end at the
 * boundary and begin there. The whole path cuts the surface and glues it together again, one side moved on
 * by one quad. So the result is a pure quad mesh with the same topology and the same valences of the
 * irregular vertices, only with fewer quads (Bommes, Lempfer, Kobbelt: *Global structure optimization of quadrilateral
 * meshes*, Computer Graphics Forum 30(2), 2011).
 */
template <typename QuadMesh>
using Grid_preserving_operator = std::vector<Grid_preserving_step<QuadMesh>>;

namespace internal {

// The flat copy of a mesh with the named parameters that the operators have to respect.
template <typename QuadMesh, typename NamedParameters>
struct Gp_input
{
  typedef typename boost::graph_traits<QuadMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<QuadMesh>::face_descriptor face_descriptor;

  Indexed_quad_mesh_copy<QuadMesh> copy;
  Structure_state state;
  bool merge_singularities;

  Gp_input(const QuadMesh& qm, const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;

    check_parameters<NamedParameters, internal_np::vertex_point_t, internal_np::edge_is_constrained_t,
                     internal_np::vertex_is_constrained_t, internal_np::merge_singularities_t,
                     internal_np::operator_step_cost_t>();

    CGAL_precondition(is_quad_mesh(qm));
    merge_singularities = choose_parameter(get_parameter(np, internal_np::merge_singularities), false);
    copy = make_indexed_quad_mesh(qm, np);
    state = initial_structure_state(copy.mesh, constrained_vertices(copy, np));
  }

  // Indices of halfedges that are not border halfedges.
  std::vector<int> index(const std::vector<halfedge_descriptor>& list, const QuadMesh& qm) const
  {
    const auto fim = get(CGAL::dynamic_face_property_t<int>(), qm);
    for(std::size_t f = 0; f < copy.faces.size(); ++f)
      put(fim, copy.faces[f], static_cast<int>(f));
    std::vector<int> result;
    for(halfedge_descriptor h : list)
    {
      const face_descriptor f = face(h, qm);
      int k = 0;
      for(halfedge_descriptor r = halfedge(f, qm); r != h; r = next(r, qm))
        ++k;
      result.push_back(4 * get(fim, f) + k);
    }
    return result;
  }

  Grid_preserving_operator<QuadMesh> public_path(const Gp_path& path, const QuadMesh& qm) const
  {
    Grid_preserving_operator<QuadMesh> result;
    for(const Gp_step& s : path)
    {
      const halfedge_descriptor h =
        s.out != -1 ? original_halfedge(s.out, copy, qm) : opposite(original_halfedge(s.in, copy, qm), qm);
      result.push_back(Grid_preserving_step<QuadMesh>{ h, static_cast<Grid_preserving_step_kind>(s.kind) });
    }
    return result;
  }

  Gp_path flat_path(const Grid_preserving_operator<QuadMesh>& op, const QuadMesh& qm) const
  {
    std::vector<halfedge_descriptor> inner;
    for(const Grid_preserving_step<QuadMesh>& s : op)
      inner.push_back(is_border(s.halfedge, qm) ? opposite(s.halfedge, qm) : s.halfedge);
    const std::vector<int> indices = index(inner, qm);
    Gp_path path;
    for(std::size_t i = 0; i < op.size(); ++i)
      path.push_back(is_border(op[i].halfedge, qm)
                       ? Gp_step{ -1, indices[i], static_cast<Gp_kind>(op[i].kind) }
                       : Gp_step{ indices[i], copy.mesh.opposite[indices[i]], static_cast<Gp_kind>(op[i].kind) });
    return path;
  }
};

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief searches a grid-preserving operator that begins with a given step and has few steps, or a
 * small cost.
 *
 * The search is a shortest path search in the graph of all steps. A path that cannot be executed,
 * because it passes a face twice in ways that exclude each other or merges vertices that must stay
 * apart, is repaired by removing what is in conflict and searching again from there. So the operator
 * is not always the shortest one, and an operator may be missed.
 *
 * By default no two irregular vertices are merged, no irregular vertex is moved onto a constrained
 * edge or the boundary, and no two boundaries or constrained polylines are merged. Constrained and
 * boundary edges are not shifted.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param qm the mesh
 * \param h the edge of the first step, on the side that it comes from; not a border halfedge
 * \param kind what the first step does
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map that tells the edges that must stay}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{no edge is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{a property map that tells vertices of which no two may become one}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{no vertex is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{merge_singularities}
 *     \cgalParamDescription{whether inner irregular vertices may be merged with each other, and moved
 *                           onto constrained edges}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{operator_step_cost}
 *     \cgalParamDescription{the positive cost of a step; the operator is searched for a small sum of costs.
 *                           A step of infinite cost is never taken.}
 *     \cgalParamType{a function object with `double operator()(const Grid_preserving_step<QuadMesh>&)`}
 *     \cgalParamDefault{every step costs 1}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the operator, empty if none was found
 *
 * \pre `CGAL::is_quad_mesh(qm)`, and no vertex of `qm` is non-manifold
 */
template <typename QuadMesh, typename NamedParameters = parameters::Default_named_parameters>
Grid_preserving_operator<QuadMesh>
find_grid_preserving_operator(const QuadMesh& qm, typename boost::graph_traits<QuadMesh>::halfedge_descriptor h,
                              Grid_preserving_step_kind kind, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef Grid_preserving_step<QuadMesh> Step;
  typedef std::function<double(const Step&)> Step_cost;

  CGAL_precondition(!is_border(h, qm));
  const internal::Gp_input<QuadMesh, NamedParameters> input(qm, np);
  std::function<double(const internal::Gp_step&)> cost;
  const Step_cost step_cost = choose_parameter(get_parameter(np, internal_np::operator_step_cost), Step_cost());
  if(step_cost)
    cost = [&](const internal::Gp_step& s)
    { return step_cost(input.public_path(internal::Gp_path(1, s), qm).front()); };
  const int first = 3 * input.index({ h }, qm).front() + static_cast<int>(kind);
  return input.public_path(internal::find_gp_operator(input.state, input.merge_singularities, first, cost), qm);
}

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief returns the operator that does the same to all edges that the dual curve through a halfedge
 * crosses: the collapse of the whole dual curve (*poly-chord collapse*) or the flip of all its edges.
 *
 * \param qm the mesh
 * \param h a halfedge whose edge the dual curve crosses, not a border halfedge
 * \param kind what is done
 * \param np an optional sequence of named parameters, as for `find_grid_preserving_operator()` but
 *        for the cost
 *
 * \return the operator, empty if it cannot be executed under the constraints
 *
 * \pre `CGAL::is_quad_mesh(qm)`, and no vertex of `qm` is non-manifold
 */
template <typename QuadMesh, typename NamedParameters = parameters::Default_named_parameters>
Grid_preserving_operator<QuadMesh>
dual_curve_operator(const QuadMesh& qm, typename boost::graph_traits<QuadMesh>::halfedge_descriptor h,
                    Grid_preserving_step_kind kind, const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition(!is_border(h, qm));
  const internal::Gp_input<QuadMesh, NamedParameters> input(qm, np);
  return input.public_path(
    internal::dual_curve_gp_operator(input.state, input.merge_singularities, input.index({ h }, qm).front(),
                                     static_cast<internal::Gp_kind>(kind)),
    qm);
}

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief executes a grid-preserving operator.
 *
 * The vertices and faces that remain keep their descriptors. Where vertices become one, the
 * constrained or boundary ones among them, else the irregular one, else their mean give the position.
 *
 * \tparam QuadMesh a model of `MutableFaceGraph` and `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param qm the mesh
 * \param op the operator
 * \param np an optional sequence of named parameters, as for `find_grid_preserving_operator()` but for
 *        the cost. `vertex_point_map` must be writable. If `edge_is_constrained_map` is given, it must
 *        be writable too, and marks the constrained edges of the result.
 *
 * \return whether `op` was executed. If it is not a closed path, not allowed by the constraints, or its result
 *         could not be represented because two edges would have the same ends, `qm` remains as it is.
 *
 * \pre `CGAL::is_quad_mesh(qm)`, and no vertex of `qm` is non-manifold
 */
template <typename QuadMesh, typename NamedParameters = parameters::Default_named_parameters>
bool apply_grid_preserving_operator(QuadMesh& qm, const Grid_preserving_operator<QuadMesh>& op,
                                    const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const internal::Gp_input<QuadMesh, NamedParameters> input(qm, np);
  internal::Structure_state result;
  if(!internal::apply_gp_operator(input.state, input.merge_singularities, input.flat_path(op, qm), result))
    return false;

  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(vertex_point, qm));
  internal::write_quad_mesh(result.mesh, result.vertex_origin, result.face_origin, input.copy, qm, vpm,
                            internal::edge_constraint_map(qm, np));
  return true;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_GRID_PRESERVING_OPERATORS_H
