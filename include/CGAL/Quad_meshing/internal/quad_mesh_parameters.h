// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_QUAD_MESH_PARAMETERS_H
#define CGAL_QUAD_MESHING_INTERNAL_QUAD_MESH_PARAMETERS_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/write_quad_mesh.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The named parameters of a quad mesh that the functions on quad meshes share: `edge_is_constrained_map` ...
template <typename QuadMesh, typename NamedParameters>
auto edge_constraint_map(const QuadMesh&, const NamedParameters& np)
{
  typedef typename boost::graph_traits<QuadMesh>::edge_descriptor edge_descriptor;
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained),
                                      Ignoring_map<edge_descriptor>());
}

// ... with `vertex_point_map`, which a flat copy is made from ...
template <typename QuadMesh, typename NamedParameters>
Indexed_quad_mesh_copy<QuadMesh> make_indexed_quad_mesh(const QuadMesh& qm, const NamedParameters& np)
{
  return make_indexed_quad_mesh(qm,
                                parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                             get_const_property_map(vertex_point, qm)),
                                edge_constraint_map(qm, np));
}

// ... and `vertex_is_constrained_map`, read for the vertices of a flat copy.
template <typename QuadMesh, typename NamedParameters>
std::vector<char> constrained_vertices(const Indexed_quad_mesh_copy<QuadMesh>& copy, const NamedParameters& np)
{
  typedef typename boost::graph_traits<QuadMesh>::vertex_descriptor vertex_descriptor;
  const auto vcm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_is_constrained),
                                                Static_boolean_property_map<vertex_descriptor, false>());
  std::vector<char> is_constrained;
  for(vertex_descriptor v : copy.vertices)
    is_constrained.push_back(get(vcm, v) ? 1 : 0);
  return is_constrained;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_QUAD_MESH_PARAMETERS_H
