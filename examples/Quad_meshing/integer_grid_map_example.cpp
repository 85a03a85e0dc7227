// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Feature edges, a cross field, an integer-grid map and its exact check, stage by stage.

#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Parameterization/integer_grid_map.h>
#include <CGAL/Quad_meshing/Parameterization/is_integer_grid_map.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace QM = CGAL::Quad_meshing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh tm;
  if(!CGAL::IO::read_polygon_mesh(filename, tm) || !CGAL::is_triangle_mesh(tm) || CGAL::is_empty(tm))
  {
    std::cerr << filename << " is no triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }
  const double length = std::sqrt(CGAL::Polygon_mesh_processing::area(tm) / 2000); // about 2000 quads

  auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  auto origin = tm.add_property_map<Mesh::Face_index, int>("f:origin", 0).first;
  for(Mesh::Face_index f : tm.faces())
    origin[f] = static_cast<int>(f);
  QM::detect_feature_edges(tm, 40, length, is_feature);
  QM::split_for_alignment(tm, tm.points(), is_feature, true, origin, 1.5 * length);

  auto angle = tm.add_property_map<Mesh::Face_index, double>("f:angle", 0).first;
  auto period_jump = tm.add_property_map<Mesh::Edge_index, int>("e:period_jump", 0).first;
  auto index = tm.add_property_map<Mesh::Vertex_index, int>("v:index", 0).first;
  const QM::Cross_field_result field = QM::smooth_cross_field(
    tm, angle, period_jump, index, CGAL::parameters::target_edge_length(length).edge_is_constrained_map(is_feature));
  std::cout << field.message << " It has " << field.singularities << " singular vertices." << std::endl;
  if(!field.is_valid())
    return EXIT_FAILURE;

  auto uv = tm.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const QM::Integer_grid_map_result map =
    QM::integer_grid_map(tm, angle, period_jump, index, uv,
                         CGAL::parameters::target_edge_length(length).edge_is_constrained_map(is_feature));
  std::cout << map.message << " Energy " << map.relaxed_energy << " without, " << map.energy << " with " << map.integers
            << " integers." << std::endl;

  const auto report = QM::is_integer_grid_map(tm, uv, CGAL::parameters::edge_is_constrained_map(is_feature));
  std::cout << report.message() << std::endl;
  return report ? EXIT_SUCCESS : EXIT_FAILURE;
}
