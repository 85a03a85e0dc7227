// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Quads along a layout with T-vertices that was made by hand: the body of a car, with its tagged arcs on quad edges and
// without. Writes the mesh and the layout, for quadrangulate_layout, and both results, where names are given.
//
//   car_layout_example [mesh.off] [layout.txt] [aligned.off] [free.off]

#include "car_body.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quad_meshing/Layout/quadrangulate_layout.h>
#include <CGAL/Quad_meshing/Layout/surface_layout_files.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace QM = CGAL::Quad_meshing;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const Mesh body = car_body::make<Mesh>(2);
  QM::Surface_layout layout;
  std::istringstream text(car_body::layout());
  if(!QM::read_surface_layout(text, layout).is_valid())
    return EXIT_FAILURE;
  if(argc > 1)
    CGAL::IO::write_OFF(argv[1], body);
  if(argc > 2)
    std::ofstream(argv[2]) << car_body::layout();

  for(bool is_aligned : { true, false })
  {
    if(!is_aligned)
      for(QM::Surface_layout::Arc& a : layout.arcs)
        a.is_aligned = false;
    Mesh quads;
    const QM::Layout_quadrangulation_result result = QM::quadrangulate_layout(
      body, layout, quads, CGAL::parameters::target_number_of_quads(2000.).arc_alignment(QM::Arc_alignment::TAGGED));
    std::cout << result.message << " " << result.t_vertices << " T-vertices, " << result.aligned_arcs
              << " aligned arcs, mean deviation from right angles " << QM::quad_mesh_quality(quads).mean_angle_deviation
              << " degrees." << std::endl;
    if(!result.is_valid())
      return EXIT_FAILURE;
    if(argc > (is_aligned ? 3 : 4))
      CGAL::IO::write_OFF(argv[is_aligned ? 3 : 4], quads);
  }
  return EXIT_SUCCESS;
}
