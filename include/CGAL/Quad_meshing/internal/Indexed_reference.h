// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_INDEXED_REFERENCE_H
#define CGAL_QUAD_MESHING_INTERNAL_INDEXED_REFERENCE_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/triangle_mesh_parameters.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Segments by the numbers of their ends.
typedef std::vector<std::array<int, 2>> Curve_segments;

// The triangle mesh that a quad mesh stands for, in flat arrays, with its feature curves and its borders.
struct Indexed_reference
{
  Indexed_triangle_mesh mesh;
  Curve_segments features, borders; // by the points of the mesh; no border belongs to the features
  std::vector<double> length;       // per face: of quad edges there, relative to each other; empty: left as they are
};

// Copies a triangle mesh; reads its named parameters `vertex_point_map` and `edge_is_constrained_map`.
template <typename... AlsoTaken, typename TriangleMesh, typename NamedParameters>
Indexed_reference make_indexed_reference(const TriangleMesh& tm, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;

  check_parameters<NamedParameters, internal_np::vertex_point_t, internal_np::vertex_index_t, internal_np::face_index_t,
                   internal_np::edge_is_constrained_t, AlsoTaken...>();

  const auto vpm =
    choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tm));
  const auto ecm = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                    Static_boolean_property_map<edge_descriptor, false>());
  const auto vim = vertex_numbers(tm, np);
  Indexed_reference reference{ make_indexed_triangle_mesh(tm, vpm, vim, face_numbers(tm, np)), {}, {}, {} };
  for(edge_descriptor e : edges(tm))
  {
    const bool is_on_border = is_border(e, tm);
    if(is_on_border || get(ecm, e))
      (is_on_border ? reference.borders : reference.features)
        .push_back({ { static_cast<int>(get(vim, source(e, tm))), static_cast<int>(get(vim, target(e, tm))) } });
  }
  reference.length = face_lengths(tm, reference.mesh.corners.size(), np);
  return reference;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_INDEXED_REFERENCE_H
