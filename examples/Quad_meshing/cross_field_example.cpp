// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Computes the smoothest cross field that follows the sharp edges and the salient directions of a mesh, and
// prints its singularities.
//
//   cross_field_example [mesh] [number of quads the field is for, default 4000]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/cross_field_directions.h>
#include <CGAL/Quad_meshing/Fields/salient_directions.h>
#include <CGAL/Quad_meshing/Fields/sizing.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;
namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  const double quads = (argc > 2) ? std::atof(argv[2]) : 4000;
  Mesh tm;
  if(!CGAL::IO::read_polygon_mesh(filename, tm) || !(quads > 0))
  {
    std::cerr << "cross_field_example: cannot read " << filename << " or the number of quads is not positive"
              << std::endl;
    return 2;
  }

  auto angle = tm.add_property_map<Mesh::Face_index, double>("f:angle").first;
  auto period_jump = tm.add_property_map<Mesh::Edge_index, int>("e:period_jump").first;
  auto index = tm.add_property_map<Mesh::Vertex_index, int>("v:index").first;
  auto sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  auto direction = tm.add_property_map<Mesh::Face_index, std::optional<Kernel::Vector_3>>("f:direction").first;

  const double length = QM::edge_length_for_number_of_quads(tm, quads);
  CGAL::Polygon_mesh_processing::detect_sharp_edges(tm, 40, sharp);
  const int salient = QM::salient_directions(tm, length, direction).number_of_faces;

  const QM::Cross_field_result result = QM::smooth_cross_field(
    tm, angle, period_jump, index,
    params::target_edge_length(length).face_direction_map(direction).edge_is_constrained_map(sharp));
  std::cout << result.message << "\n"
            << salient << " faces with salient directions, energy " << result.energy << ", " << result.seconds << " s"
            << std::endl;

  std::map<int, int> count;
  for(Mesh::Vertex_index v : tm.vertices())
    if(index[v] != 0)
      ++count[index[v]];
  for(const std::pair<const int, int>& c : count)
    std::cout << c.second << " vertices of index " << c.first << " quarters" << std::endl;

  const Mesh::Face_index f = *tm.faces_begin();
  std::cout << "The cross of the first face points to " << QM::cross_field_direction(f, tm, angle) << " and "
            << QM::cross_field_direction(f, tm, angle, 1) << std::endl;
  return result.is_valid() ? 0 : 1;
}
