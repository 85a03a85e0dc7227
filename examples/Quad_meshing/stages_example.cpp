// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The stages of quadrangulate(), called one after the other, give the mesh that it makes on the triangles of the input
// (work_on_input). After each stage one can look at what it left behind, and change it.
//
//   stages_example [input] [number of quads] [output.obj]

#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/copy_components.h>
#include <CGAL/Quad_meshing/Pipeline/search_grid_map.h>
#include <CGAL/Quad_meshing/Pipeline/smoothing_directions.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>

#include <CGAL/boost/graph/IO/OBJ.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

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

  // Each component is a mesh of its own, with property maps for what follows.
  const QM::Component_copies components = QM::copy_components(tm);
  for(std::size_t i = 0; i < components.surfaces.size(); ++i)
  {
    QM::Quadrangulation_surface& s = *components.surfaces[i];
    const double length = components.edge_length_in(i, components.edge_length(number_of_quads));

    // The sharp edges, and triangles that can carry a map along them.
    const auto features = QM::detect_feature_edges(s.mesh, 40, length, s.is_feature);
    QM::split_for_alignment(s.mesh, s.mesh.points(), s.is_feature, true, s.origin, 1.5 * length);

    // Directions for the quads, that follow the curvature of the surface.
    auto direction = s.mesh.add_property_map<Mesh::Face_index, std::optional<Vector_3>>("f:direction").first;
    std::vector<double> weights(s.mesh.number_of_faces(), 0);
    const auto weight = boost::make_iterator_property_map(weights.begin(), get(boost::face_index, s.mesh));
    QM::curvature_directions(s.mesh, length, direction, weight, np::edge_is_constrained_map(s.is_feature));
    for(double& w : weights)
      w *= 2; // as much as directions count for quadrangulate()

    // A cross field, a map to the plane along it, and the quads that the integer grid cuts the surface into. Plans say
    // what else is tried where these are not good enough; `cross_field_example`, `integer_grid_map_example` and
    // `extract_example` call the functions for them one by one.
    const auto found =
      QM::search_grid_map(s, direction, weight, { length, components.areas[i] / (length * length), features.length });
    std::cout << found.figures.message << " " << found.figures.singularities << " singularities" << std::endl;
    if(!found.is_valid())
      continue;

    // Features stay where they are while the vertices move on the surface, and edges keep the directions of the field.
    const QM::Smoothing_directions d = QM::smoothing_directions(s, weights);
    const auto faces = get(boost::face_index, s.mesh);
    QM::smooth_quad_mesh(found.quads->mesh, s.mesh,
                         np::smooth_globally(true).edge_is_constrained_map(found.quads->is_feature),
                         np::face_direction_map(boost::make_iterator_property_map(d.direction.begin(), faces))
                           .face_direction_weight_map(boost::make_iterator_property_map(d.weight.begin(), faces))
                           .face_sizing_map(s.length)
                           .edge_is_constrained_map(s.is_feature));
    result += found.quads->mesh;
  }
  std::ofstream out((argc > 3) ? argv[3] : "quads.obj");
  CGAL::IO::write_OBJ(out, result, np::stream_precision(17));
  return EXIT_SUCCESS;
}
