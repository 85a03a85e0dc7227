// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_COPY_COMPONENTS_H
#define CGAL_QUAD_MESHING_PIPELINE_COPY_COMPONENTS_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Triangle_input.h>
#include <CGAL/Quad_meshing/Pipeline/internal/quad_counts.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingRef

\brief The answer of `copy_components()`.
*/
struct Component_copies
{
  std::vector<std::unique_ptr<Quadrangulation_surface>> surfaces; ///< one per component
  std::vector<double> areas;                                      ///< of the surfaces
  std::size_t divided_vertices = 0; ///< vertices in which borders touch; each fan of triangles has one of its own
  std::string message; ///< what keeps the triangles from being a surface, as a sentence; empty if nothing does

  /// returns whether there is a surface.
  bool is_valid() const { return message.empty(); }

  /// returns the length of the edges of quads of which so many have the area of all components.
  double edge_length(double number_of_quads) const
  {
    return std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.) / number_of_quads);
  }

  /// returns the length of quad edges in component `i` when edges of the given length are asked for: shorter if there
  /// are several components, and this one has no room for two dozens of such quads.
  double edge_length_in(std::size_t i, double length) const
  {
    return internal::edge_length_of_component(areas[i], length, areas.size());
  }
};

namespace internal {

CGAL_QUAD_MESHING_INLINE Component_copies copy_components(const Triangle_input& input);

} // namespace internal

/*!
\ingroup PkgQuadMeshingRef

\brief copies each component of a triangle mesh to a mesh of its own: the first stage of `quadrangulate()`.

Vertices and faces of the copies are numbered by their places in space, along a Z-curve, so that the numbers of the
input do not matter and what lies close together is close in memory. A vertex in which borders touch is divided.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the feature edges}
    \cgalParamType{a model of `ReadablePropertyMap` with the edges of `tm` as keys and `bool` as value type}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tm`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the copies, with the numbers of the input faces and the feature edges; if two vertices are joined by several
edges, a message that names them

\pre `is_triangle_mesh(tm)`
*/
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
Component_copies copy_components(const TriangleMesh& tm, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  static_assert(
    internal::Takes_parameters<NamedParameters, internal_np::edge_is_constrained_t, internal_np::vertex_point_t>::value,
    "copy_components() takes edge_is_constrained_map and vertex_point_map.");
  CGAL_precondition(is_triangle_mesh(tm));

  internal::Triangle_input input = internal::triangle_input(
    tm, choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tm)));
  if constexpr(!is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value)
    input.is_feature = internal::marked_sides(tm, get_parameter(np, internal_np::edge_is_constrained));
  return internal::copy_components(input);
}

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Pipeline/internal/copy_components_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_PIPELINE_COPY_COMPONENTS_H
