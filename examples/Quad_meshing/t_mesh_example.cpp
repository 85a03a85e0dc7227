// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// From a seamless map to quads over its T-mesh, at any density: the field and the map are computed once.
//
//   t_mesh_example [input] [picture.png] [layout.txt]
//
// The layout is the T-mesh in the format that quadrangulate_layout reads.

#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/IO/Scene.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/IO/scene_layers.h>
#include <CGAL/Quad_meshing/IO/write_png_picture.h>
#include <CGAL/Quad_meshing/Layout/layout_from_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/quads_of_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/quantize_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/surface_layout_files.h>
#include <CGAL/Quad_meshing/Parameterization/Seamless_map.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

void draw(const Mesh& tm, const QM::T_mesh& t, const std::string& filename)
{
  QM::Scene scene;
  QM::Scene_layer surface = QM::make_faces_layer(tm, "surface", "T-mesh"), arcs;
  surface.has_sides = false;
  arcs.name = "arcs";
  arcs.kind = QM::Scene_layer_kind::LINES;
  arcs.color = "#802080";
  for(std::size_t a = 0; a < t.arcs.size(); ++a)
  {
    const std::vector<QM::T_mesh::Location> line = t.polyline(static_cast<int>(a));
    for(std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      const std::size_t p = arcs.add_point(t.position(line[i])), q = arcs.add_point(t.position(line[i + 1]));
      arcs.add_element(std::array<std::size_t, 2>{ { p, q } });
    }
  }
  scene.layers = { surface, arcs };
  std::ofstream out(filename, std::ios::binary);
  QM::write_png_picture(out, scene);
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh tm;
  if(!QM::read_triangle_mesh(filename, tm))
    return EXIT_FAILURE;
  const double length = std::sqrt(CGAL::Polygon_mesh_processing::area(tm) / 2000); // about 2000 quads

  // Features, a cross field, and the map along it before integers are chosen.
  auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  auto origin = tm.add_property_map<Mesh::Face_index, int>("f:origin", 0).first;
  QM::detect_feature_edges(tm, 40, length, is_feature);
  QM::split_for_alignment(tm, tm.points(), is_feature, true, origin, 1.5 * length);
  auto angle = tm.add_property_map<Mesh::Face_index, double>("f:angle", 0).first;
  auto period_jump = tm.add_property_map<Mesh::Edge_index, int>("e:period_jump", 0).first;
  auto index = tm.add_property_map<Mesh::Vertex_index, int>("v:index", 0).first;
  auto uv = tm.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto np = CGAL::parameters::target_edge_length(length).edge_is_constrained_map(is_feature);
  if(!QM::smooth_cross_field(tm, angle, period_jump, index, np).is_valid())
    return EXIT_FAILURE;
  CGAL::Real_timer timer;
  timer.start();
  QM::Seamless_map map(tm, angle, period_jump, index, np);
  if(!map.is_solved())
    return EXIT_FAILURE;
  std::cout << "seamless map: " << timer.time() << " s" << std::endl;

  for(double relative_length : { 0.5, 1., 2., 4. })
  {
    // Rounding gives the lengths to begin with; whether its own map is valid does not matter here.
    map.round_without_repair(tm, relative_length, uv);
    timer.reset();
    const QM::T_mesh t = map.t_mesh();
    std::vector<int> lengths;
    const QM::T_mesh_quantization_result r = QM::quantize_t_mesh(t, lengths);
    if(!r.is_valid)
    {
      std::cerr << r.message << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << "edges " << relative_length << " times as long: " << t.patches.size() << " patches, " << r.zero_arcs
              << " of " << t.arcs.size() << " arcs of length 0, " << r.number_of_quads << " quads, energy " << r.energy
              << " (" << r.rounded_energy << " rounded), " << timer.time() << " s" << std::endl;
    Mesh quads;
    auto is_quad_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
    if(!QM::quads_of_t_mesh(t, lengths, tm, quads, is_quad_feature))
      return EXIT_FAILURE;
    if(argc > 2 && relative_length == 1)
      draw(tm, t, argv[2]);
    if(argc > 3 && relative_length == 1)
    {
      std::ofstream out(argv[3]);
      out.precision(17);
      QM::write_surface_layout(out, QM::layout_from_t_mesh(t));
    }
  }
  return EXIT_SUCCESS;
}
