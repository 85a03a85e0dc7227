// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// A triangle mesh becomes a quad mesh in one call, with a visitor that prints the stages.
//
//   quadrangulate_example [input] [number of quads] [output.obj]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/quadrangulate.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OBJ.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;
namespace np = CGAL::parameters;

struct Stage_printer : QM::Default_visitor
{
  void on_stage_begin(const std::string& name) { std::cout << name << " ..." << std::endl; }
};

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  const double number_of_quads = (argc > 2) ? std::atof(argv[2]) : 2000;
  const std::string output = (argc > 3) ? argv[3] : "quads.obj";

  Mesh tm;
  const QM::Mesh_reading_result reading = QM::read_triangle_mesh(input, tm);
  if(!reading)
  {
    std::cerr << input << ": " << reading.message << std::endl;
    return EXIT_FAILURE;
  }

  Mesh qm;
  Stage_printer printer;
  const QM::Quadrangulation_result result =
    QM::quadrangulate(tm, qm, np::target_number_of_quads(number_of_quads).visitor(std::ref(printer)));

  std::cout << result.message << std::endl
            << result.quads << " quads, " << result.irregular_vertices << " irregular vertices, edge length "
            << result.target_edge_length << std::endl;

  std::ofstream out(output);
  CGAL::IO::write_OBJ(out, qm, np::stream_precision(17));
  return result.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
