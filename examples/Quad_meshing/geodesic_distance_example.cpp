// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Distances from the sharp edges of a model, and a shortest path back to them.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_field.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Quad_meshing::Geodesic_distance_field<Mesh> Field;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh tm;
  const auto reading = CGAL::Quad_meshing::read_triangle_mesh(filename, tm);
  if(!reading)
  {
    std::cerr << filename << ": " << reading.message << std::endl;
    return EXIT_FAILURE;
  }

  auto is_sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(tm, 40, is_sharp);
  std::vector<Mesh::Edge_index> sharp_edges;
  for(Mesh::Edge_index e : tm.edges())
    if(is_sharp[e])
      sharp_edges.push_back(e);

  Field field(tm);
  field.add_edges_source(sharp_edges);
  const auto result = field.propagate();
  std::cout << result.message << " The point farthest from sharp edges is " << result.maximum_distance << " away."
            << std::endl;
  if(!result)
    return EXIT_FAILURE;

  Mesh::Vertex_index farthest(0);
  for(Mesh::Vertex_index v : tm.vertices())
    if(field.is_reached(v) && field.distance(v) > field.distance(farthest))
      farthest = v;
  std::vector<Field::Face_location> path;
  field.shortest_path(farthest, std::back_inserter(path));
  std::cout << "The way there crosses " << path.size() << " edges and corners." << std::endl;
  return EXIT_SUCCESS;
}
