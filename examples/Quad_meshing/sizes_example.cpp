// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Makes quad meshes whose edges are shorter where the surface bends, and in the part of the model that is painted.

#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/quadrangulate.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <CGAL/centroid.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;
namespace np = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string input = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh tm, qm;
  const QM::Mesh_reading_result reading = QM::read_triangle_mesh(input, tm);
  if(!reading)
  {
    std::cerr << input << ": " << reading.message << std::endl;
    return EXIT_FAILURE;
  }

  // Edges leave the surface by the same distance everywhere, the one for which the number of quads is right.
  QM::Quadrangulation_result result =
    QM::quadrangulate(tm, qm, np::sizing_method(QM::Sizing_method::CURVATURE).target_number_of_quads(3000));
  std::cout << result.message << std::endl << result.quads << " quads" << std::endl;

  // Half of the model with edges of half the length: lengths count against each other, and fit the number of quads.
  auto length = tm.add_property_map<Mesh::Face_index, double>("f:edge_length", 2).first;
  const Kernel::Point_3 middle = CGAL::centroid(tm.points().begin(), tm.points().end());
  for(Mesh::Face_index f : tm.faces())
    if(tm.point(tm.source(tm.halfedge(f))).x() < middle.x())
      length[f] = 1;
  qm.clear();
  result = QM::quadrangulate(tm, qm, np::face_sizing_map(length).target_number_of_quads(3000));

  std::cout << result.message << std::endl << result.quads << " quads" << std::endl;
  CGAL::IO::write_OFF("sizes.off", qm, np::stream_precision(17));
  return result.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
