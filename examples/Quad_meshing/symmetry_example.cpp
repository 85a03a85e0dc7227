// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Makes a quad mesh that is symmetric to the best plane of symmetry of the model.

#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/quadrangulate.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;
namespace np = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/pinion.off");
  Mesh tm, qm;
  const QM::Mesh_reading_result reading = QM::read_triangle_mesh(input, tm);
  if(!reading)
  {
    std::cerr << input << ": " << reading.message << std::endl;
    return EXIT_FAILURE;
  }

  // A plane of which nothing is known is looked for. The model may differ from its mirror image by five percent of its
  // diagonal; beyond that it is refused.
  const QM::Quadrangulation_result result = QM::quadrangulate(
    tm, qm,
    np::symmetry_planes(std::vector<QM::Symmetry_plane>(1)).symmetry_tolerance(0.05).target_number_of_quads(3000));

  std::cout << result.message << std::endl << result.quads << " quads" << std::endl;
  CGAL::IO::write_OFF("symmetry.off", qm, np::stream_precision(17));
  return result.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
