// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The named parameters of the package: in chains with each other and with CGAL's, in every order,
// each value arrives, in our functions and in CGAL's.

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/parameters.h>

#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cassert>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <type_traits>

namespace np = CGAL::parameters;
namespace internal_np = CGAL::internal_np;

typedef test_meshes::Mesh Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, test_meshes::Point_3> Vertex_point_map;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Edge_bool_map;

struct Counting_visitor : CGAL::Quad_meshing::Default_visitor
{
  int stages = 0;
  void on_stage_begin(const std::string&) { ++stages; }

  // A visitor is never copied.
  Counting_visitor() = default;
  Counting_visitor(const Counting_visitor&) = delete;
};

// What a function of the package finds in its parameters.
struct Values
{
  double edge_length = -1, boundary_area = -1;
  bool align = true;
  unsigned int iterations = 0;
  std::size_t constrained = 0;
};

template <typename NamedParameters = np::Default_named_parameters>
Values read(const Mesh& tm, const NamedParameters& parameters = np::default_values())
{
  using np::choose_parameter;
  using np::get_parameter;
  using np::get_parameter_reference;
  typedef CGAL::Static_boolean_property_map<Mesh::Edge_index, false> No_edge;
  typedef
    typename internal_np::Lookup_named_param_def<internal_np::edge_is_constrained_t, NamedParameters, No_edge>::type
      Edge_map;

  Values values;
  values.edge_length = choose_parameter(get_parameter(parameters, internal_np::target_edge_length), -1.);
  values.align = choose_parameter(get_parameter(parameters, internal_np::align_boundary), true);
  values.iterations = choose_parameter(get_parameter(parameters, internal_np::number_of_iterations), 0u);

  const auto vpm = choose_parameter(get_parameter(parameters, internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tm));
  values.boundary_area = CGAL::Polygon_mesh_processing::area(tm, np::vertex_point_map(vpm));

  const Edge_map edge_map = choose_parameter<Edge_map>(get_parameter(parameters, internal_np::edge_is_constrained));
  for(Mesh::Edge_index e : edges(tm))
    values.constrained += get(edge_map, e);

  CGAL::Quad_meshing::Default_visitor default_visitor;
  typedef
    typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters,
                                                 CGAL::Quad_meshing::Default_visitor>::reference Visitor_reference;
  Visitor_reference visitor =
    choose_parameter(get_parameter_reference(parameters, internal_np::visitor), default_visitor);
  visitor.on_stage_begin("reading");
  return values;
}

// A function in the older style of CGAL, overloaded on the class template of its parameters.
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
double read_overloaded(const CGAL_NP_CLASS& parameters)
{
  return np::choose_parameter(np::get_parameter(parameters, internal_np::target_edge_length), -1.);
}

int main()
{
  Mesh tm = test_meshes::make_mesh(test_meshes::cube(2));

  // The same mesh, three times as large, by another point map.
  Vertex_point_map large = tm.add_property_map<Mesh::Vertex_index, test_meshes::Point_3>("v:large").first;
  for(Mesh::Vertex_index v : vertices(tm))
    large[v] = CGAL::ORIGIN + 3. * (tm.point(v) - CGAL::ORIGIN);
  Edge_bool_map sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  sharp[*edges(tm).begin()] = true;

  std::cout << "defaults" << std::endl;
  Values v = read(tm);
  assert(v.edge_length == -1 && v.align && v.iterations == 0 && v.constrained == 0 && v.boundary_area == 6);

  std::cout << "one parameter of the package" << std::endl;
  v = read(tm, np::target_edge_length(0.25));
  assert(v.edge_length == 0.25 && v.align && v.boundary_area == 6);

  std::cout << "chains in every order" << std::endl;
  Counting_visitor visitor;
  auto check = [&](const Values& w)
  { assert(w.edge_length == 0.5 && !w.align && w.iterations == 7u && w.boundary_area == 54 && w.constrained == 1); };
  check(read(tm, np::target_edge_length(0.5)
                   .align_boundary(false)
                   .number_of_iterations(7u)
                   .vertex_point_map(large)
                   .edge_is_constrained_map(sharp)
                   .visitor(std::ref(visitor))));
  check(read(tm, np::target_edge_length(0.5)
                   .vertex_point_map(large)
                   .align_boundary(false)
                   .edge_is_constrained_map(sharp)
                   .visitor(std::ref(visitor))
                   .number_of_iterations(7u)));
  check(read(tm, np::align_boundary(false)
                   .visitor(std::ref(visitor))
                   .edge_is_constrained_map(sharp)
                   .vertex_point_map(large)
                   .number_of_iterations(7u)
                   .target_edge_length(0.5)));
  check(read(tm, np::align_boundary(false)
                   .number_of_iterations(7u)
                   .target_edge_length(0.5)
                   .visitor(std::ref(visitor))
                   .vertex_point_map(large)
                   .edge_is_constrained_map(sharp)));
  assert(visitor.stages == 4);

  std::cout << "chains of the names of CGAL alone" << std::endl;
  v = read(tm, np::vertex_point_map(large).number_of_iterations(7u));
  assert(v.boundary_area == 54 && v.iterations == 7u && v.edge_length == -1);

  std::cout << "functions overloaded on CGAL_NP_CLASS" << std::endl;
  assert(read_overloaded(np::default_values()) == -1);
  assert(read_overloaded(np::target_edge_length(0.5)) == 0.5);
  assert(read_overloaded(np::align_boundary(true).vertex_point_map(large).target_edge_length(0.5)) == 0.5);

  std::cout << "functions of CGAL" << std::endl;
  namespace PMP = CGAL::Polygon_mesh_processing;
  assert(PMP::area(tm, np::target_edge_length(0.5).vertex_point_map(large)) == 54);
  assert(PMP::area(tm, np::align_boundary(false).vertex_point_map(large).target_edge_length(0.5)) == 54);
  assert(PMP::area(tm, np::target_edge_length(0.5)) == 6);
  assert(PMP::edge_length(halfedge(*edges(tm).begin(), tm), tm, np::target_edge_length(1.).vertex_point_map(large)) ==
         3 * PMP::edge_length(halfedge(*edges(tm).begin(), tm), tm));

  std::cout << "every parameter of the package, as a function and as a member" << std::endl;
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  {                                                                                                                    \
    const auto first = np::Z(17).verbose(true);                                                                        \
    assert(np::get_parameter(first, internal_np::Y) == 17);                                                            \
    assert(np::get_parameter(first, internal_np::verbose));                                                            \
    const auto second = np::target_edge_length(1.5).verbose(true).Z(18);                                               \
    assert(np::get_parameter(second, internal_np::Y) == 18);                                                           \
    assert(np::get_parameter(second, internal_np::verbose));                                                           \
    typedef typename std::decay<decltype(first)>::type First;                                                          \
    static_assert(!np::is_default_parameter<First, internal_np::X>::value, "the parameter is there");                  \
    static_assert(np::is_default_parameter<First, internal_np::random_seed_t>::value, "this one is not");              \
  }
  CGAL_QUAD_MESHING_NAMED_PARAMETERS
#undef CGAL_add_named_parameter

  return EXIT_SUCCESS;
}
