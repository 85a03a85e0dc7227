// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Makes quads along a layout of six patches: the bounding box of a mesh, its corners moved to the surface.
//
//   layout_example [mesh] [output.off]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/Layout/layout_from_quad_mesh.h>
#include <CGAL/Quad_meshing/Layout/quadrangulate_layout.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/oblong.off");
  Mesh tm;
  const QM::Mesh_reading_result reading = QM::read_triangle_mesh(filename, tm);
  if(!reading)
  {
    std::cerr << filename << ": " << reading.message << std::endl;
    return EXIT_FAILURE;
  }

  // the box as a coarse quad mesh
  const CGAL::Bbox_3 b = CGAL::Polygon_mesh_processing::bbox(tm);
  auto corner = [&](bool x, bool y, bool z)
  { return Point_3(x ? b.xmax() : b.xmin(), y ? b.ymax() : b.ymin(), z ? b.zmax() : b.zmin()); };
  Mesh box;
  CGAL::make_hexahedron(corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1),
                        corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), box);

  QM::Surface_layout layout = QM::layout_from_quad_mesh(box);
  layout.arcs[0].is_aligned = true; // this one shall be a chain of quad edges

  Mesh qm;
  const QM::Layout_quadrangulation_result result = QM::quadrangulate_layout(
    tm, layout, qm, CGAL::parameters::target_number_of_quads(2000).layout_chart(QM::Layout_chart::RECTANGLE));
  std::cout << result.message << "\n";
  if(!result.is_valid())
    return EXIT_FAILURE;
  std::cout << "isometry energy per area: " << result.energies.front() << " at first, " << result.energies.back()
            << " with optimized charts" << std::endl;

  if(argc > 2)
  {
    std::ofstream out(argv[2]);
    if(!out || !CGAL::IO::write_OFF(out, qm))
    {
      std::cerr << argv[2] << ": cannot be written" << std::endl;
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
