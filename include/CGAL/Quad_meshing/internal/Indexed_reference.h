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

// Directions that the edges of quads should have, up to quarter turns.
struct Indexed_directions
{
  Indexed_triangle_mesh mesh; // whose faces they are of; without faces: the reference itself
  std::vector<Indexed_triangle_mesh::Vector_3> direction; // per face: in its plane; zero: none. Empty: none at all
  std::vector<double> weight;                             // per face: see `Side_turn_energy`
};

// The triangle mesh that a quad mesh stands for, in flat arrays, with its feature curves and its borders.
struct Indexed_reference
{
  Indexed_triangle_mesh mesh;
  Curve_segments features, borders; // by the points of the mesh; no border belongs to the features
  std::vector<double> length;       // per face: of quad edges there, relative to each other; empty: left as they are
  Indexed_directions directions;    // of quad edges
};

// Reads `face_direction_map` and `face_direction_weight_map`, 1 if it is not given.
template <typename TriangleMesh, typename NamedParameters>
void read_directions(const TriangleMesh& tm, const NamedParameters& np, Indexed_directions& d)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto direction = get_parameter(np, internal_np::face_direction_map);
  const auto weight =
    choose_parameter(get_parameter(np, internal_np::face_direction_weight_map),
                     Constant_property_map<typename boost::graph_traits<TriangleMesh>::face_descriptor, double>(1));
  const auto fim = face_numbers(tm, np);
  d.direction.assign(num_faces(tm), Indexed_triangle_mesh::Vector_3(0, 0, 0));
  d.weight.assign(num_faces(tm), 0);
  for(auto f : faces(tm))
  {
    const auto i = get(fim, f);
    const auto& v = get(direction, f);
    if(!v)
      continue;
    d.direction[i] = Indexed_triangle_mesh::Vector_3(to_double(v->x()), to_double(v->y()), to_double(v->z()));
    d.weight[i] = to_double(get(weight, f));
  }
}

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
  Indexed_reference reference{ make_indexed_triangle_mesh(tm, vpm, vim, face_numbers(tm, np)), {}, {}, {}, {} };
  for(edge_descriptor e : edges(tm))
  {
    const bool is_on_border = is_border(e, tm);
    if(is_on_border || get(ecm, e))
      (is_on_border ? reference.borders : reference.features)
        .push_back({ { static_cast<int>(get(vim, source(e, tm))), static_cast<int>(get(vim, target(e, tm))) } });
  }
  reference.length = face_lengths(tm, reference.mesh.corners.size(), np);
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::face_direction_map_t>::value)
    read_directions(tm, np, reference.directions);
  return reference;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_INDEXED_REFERENCE_H
