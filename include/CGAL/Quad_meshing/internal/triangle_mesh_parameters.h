// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_TRIANGLE_MESH_PARAMETERS_H
#define CGAL_QUAD_MESHING_INTERNAL_TRIANGLE_MESH_PARAMETERS_H

#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the functions on triangle meshes read in the same way, for the flat copy of a mesh (`Indexed_triangle_mesh`).

// Whether all faces are triangles; if not, the result says so.
template <typename TriangleMesh, typename Result>
bool has_triangles_only(const TriangleMesh& tm, Result& result)
{
  if(is_triangle_mesh(tm))
    return true;
  result.status = decltype(result.status)::NOT_A_TRIANGLE_MESH;
  result.message = "The mesh has a face that is not a triangle.";
  return false;
}

// `edge_is_constrained_map`, per edge.
template <typename TriangleMesh, typename NamedParameters>
std::vector<char> constrained_edges(const TriangleMesh& tm, const NamedParameters& np)
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  const auto ecm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained),
                                                Static_boolean_property_map<edge_descriptor, false>());
  std::vector<char> is_constrained;
  for_each_edge_of_faces(tm, [&](edge_descriptor e, int) { is_constrained.push_back(get(ecm, e) ? 1 : 0); });
  return is_constrained;
}

// `face_sizing_map`, per face; nothing if there is no such map.
template <typename TriangleMesh, typename NamedParameters>
std::vector<double> face_lengths(const TriangleMesh& tm, std::size_t number_of_faces, const NamedParameters& np)
{
  std::vector<double> lengths;
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::face_sizing_map_t>::value)
  {
    const auto fim = face_numbers(tm, np);
    lengths.resize(number_of_faces);
    for(auto f : faces(tm))
      lengths[get(fim, f)] = to_double(get(parameters::get_parameter(np, internal_np::face_sizing_map), f));
  }
  return lengths;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_TRIANGLE_MESH_PARAMETERS_H
