// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The stages of quadrangulate(), called one after the other, give the same mesh wherever its first plan is good enough;
// other plans call them again for another length or field. After each stage one can look at what it left behind, and
// change it.
//
//   stages_example [input] [number of quads] [output.obj]

#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>
#include <CGAL/Quad_meshing/Extraction/transfer_feature_edges.h>
#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/Parameterization/integer_grid_map.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/copy_components.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/IO/OBJ.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>

namespace QM = CGAL::Quad_meshing;
namespace np = CGAL::parameters;

typedef QM::Quadrangulation_mesh Mesh;
typedef QM::Quadrangulation_kernel::Vector_3 Vector_3;

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  const double number_of_quads = (argc > 2) ? std::atof(argv[2]) : 2000;
  Mesh tm, result;
  if(!QM::read_triangle_mesh(input, tm))
    return EXIT_FAILURE;
  const double length = std::sqrt(CGAL::Polygon_mesh_processing::area(tm) / number_of_quads);

  // Each component is a mesh of its own, with property maps for what follows.
  for(const auto& surface : QM::copy_components(tm).surfaces)
  {
    QM::Quadrangulation_surface& s = *surface;

    // The sharp edges, and triangles that can carry a map along them.
    QM::detect_feature_edges(s.mesh, 40, length, s.is_feature);
    QM::split_for_alignment(s.mesh, s.mesh.points(), s.is_feature, true, s.origin, 1.5 * length);

    // Directions for the quads, that follow the sharp edges and the curvature of the surface, ...
    auto direction = s.mesh.add_property_map<Mesh::Face_index, std::optional<Vector_3>>("f:direction").first;
    auto weight = s.mesh.add_property_map<Mesh::Face_index, double>("f:weight", 0).first;
    QM::curvature_directions(s.mesh, length, direction, weight, np::edge_is_constrained_map(s.is_feature));
    const auto field = QM::smooth_cross_field(s.mesh, s.angle, s.period_jump, s.index,
                                              np::target_edge_length(length)
                                                .edge_is_constrained_map(s.is_feature)
                                                .face_direction_map(direction)
                                                .face_direction_weight_map(weight));
    std::cout << field.message << " " << field.singularities << " singularities" << std::endl;

    // ... a map to the plane along them, ...
    const auto map = QM::integer_grid_map(s.mesh, s.angle, s.period_jump, s.index, s.uv,
                                          np::target_edge_length(length).edge_is_constrained_map(s.is_feature));
    std::cout << map.message << std::endl;

    // ... and the quads that the integer grid cuts the surface into.
    QM::Quadrangulation_quads q;
    const auto quads = QM::extract_quad_mesh(s.mesh, s.uv, q.mesh, np::face_location_map(q.location));
    std::cout << quads.message << " " << quads.quads << " quads" << std::endl;

    // Features stay where they are while the vertices move on the surface.
    QM::transfer_feature_edges(s.mesh, s.is_feature, q.mesh, q.location, q.is_feature);
    QM::smooth_quad_mesh(q.mesh, s.mesh, np::smooth_globally(true).edge_is_constrained_map(q.is_feature),
                         np::edge_is_constrained_map(s.is_feature));
    result += q.mesh;
  }
  std::ofstream out((argc > 3) ? argv[3] : "quads.obj");
  CGAL::IO::write_OBJ(out, result, np::stream_precision(17));
  return EXIT_SUCCESS;
}
