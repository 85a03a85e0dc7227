// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Cross fields without constraints on a mesh and its decimations to 200, 1000 and 2000 triangles: the numbers of
// integers and reals, then time and energy of every method (the shape of Table 5.1 of Bommes 2012), and the energy and time of
// the default method relative to greedy and naive rounding.
//
//   bench_fields [mesh, default meshes/elephant.off of CGAL's data] [most triangles for naive rounding, default 2000]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;
namespace SMS = CGAL::Surface_mesh_simplification;

QM::Cross_field_result compute(Mesh& tm, QM::Cross_field_method method)
{
  auto angle = tm.add_property_map<Mesh::Face_index, double>("f:angle").first;
  auto period_jump = tm.add_property_map<Mesh::Edge_index, int>("e:period_jump").first;
  auto index = tm.add_property_map<Mesh::Vertex_index, int>("v:index").first;
  return QM::smooth_cross_field(tm, angle, period_jump, index, CGAL::parameters::cross_field_method(method));
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const std::size_t naive_limit = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 2000;
  Mesh input;
  if(!CGAL::IO::read_polygon_mesh(filename, input) || !CGAL::is_triangle_mesh(input))
  {
    std::fprintf(stderr, "bench_fields: cannot read a triangle mesh from %s\n", filename.c_str());
    return 2;
  }

  std::vector<Mesh> meshes;
  for(std::size_t triangles : { 200, 1000, 2000 })
  {
    if(triangles >= input.number_of_faces())
      continue;
    Mesh tm = input;
    // An inner edge collapse removes three edges and two faces.
    SMS::edge_collapse(tm, SMS::Count_stop_predicate<Mesh>(triangles * 3 / 2));
    tm.collect_garbage();
    meshes.push_back(tm);
  }
  meshes.push_back(input);

  std::printf("%9s %8s %8s | %15s %5s | %15s %5s | %15s %5s | %15s %5s | %8s %8s %8s\n", "triangles", "integers", "reals",
              "polished s / E", "sing", "greedy s / E", "sing", "direct s / E", "sing", "naive s / E", "sing",
              "E/greedy", "E/naive", "t/greedy");
  bool valid = true;
  for(Mesh& tm : meshes)
  {
    const QM::Cross_field_result polished = compute(tm, QM::Cross_field_method::POLISHED);
    const QM::Cross_field_result greedy = compute(tm, QM::Cross_field_method::GREEDY);
    const QM::Cross_field_result direct = compute(tm, QM::Cross_field_method::DIRECT);
    valid = valid && polished.is_valid() && greedy.is_valid() && direct.is_valid();
    std::printf("%9d %8d %8d | %7.3f/%7.3f %5d | %7.3f/%7.3f %5d | %7.3f/%7.3f %5d | ",
                static_cast<int>(tm.number_of_faces()), polished.integers,
                static_cast<int>(tm.number_of_faces()) - polished.constrained_faces, polished.seconds, polished.energy,
                polished.singularities, greedy.seconds, greedy.energy, greedy.singularities, direct.seconds, direct.energy,
                direct.singularities);
    if(tm.number_of_faces() <= naive_limit)
    {
      const QM::Cross_field_result naive = compute(tm, QM::Cross_field_method::NAIVE);
      std::printf("%7.3f/%7.3f %5d | %8.4f %8.4f", naive.seconds, naive.energy, naive.singularities,
                  polished.energy / greedy.energy, polished.energy / naive.energy);
    }
    else
      std::printf("%15s %5s | %8.4f %8s", "-", "-", polished.energy / greedy.energy, "-");
    std::printf(" %8.4f\n", polished.seconds / greedy.seconds);
  }
  return valid ? 0 : 1;
}
