// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Makes a quad mesh with a chain of edges along a curve, quads that follow a stroke, and a vertex of three quads.

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
  const std::string input = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh tm, qm;
  const QM::Mesh_reading_result reading = QM::read_triangle_mesh(input, tm);
  if(!reading)
  {
    std::cerr << input << ": " << reading.message << std::endl;
    return EXIT_FAILURE;
  }

  // A curve over the model, from the vertex with the smallest x to the one with the largest, and a stroke from the
  // smallest z to the largest; both are shortest paths on the surface.
  std::vector<Kernel::Point_3> end(6, tm.point(*tm.vertices().begin()));
  for(Mesh::Vertex_index v : tm.vertices())
    for(int c = 0; c < 3; ++c)
    {
      const Kernel::Point_3& p = tm.point(v);
      if(p[c] < end[2 * c][c])
        end[2 * c] = p;
      if(p[c] > end[2 * c + 1][c])
        end[2 * c + 1] = p;
    }
  QM::Guide_curve curve;
  curve.points = { end[0], end[1] };
  QM::Guide_stroke stroke;
  stroke.points = { end[4], end[5] };
  QM::Index_guide vertex;
  vertex.point = CGAL::centroid(end[0], end[2], end[4]);
  vertex.index = 1;

  const QM::Quadrangulation_result result = QM::quadrangulate(tm, qm,
                                                              np::feature_curves(std::vector<QM::Guide_curve>(1, curve))
                                                                .strokes(std::vector<QM::Guide_stroke>(1, stroke))
                                                                .index_guides(std::vector<QM::Index_guide>(1, vertex))
                                                                .target_number_of_quads(3000));
  for(const std::string& unmet : result.unmet_guides)
    std::cout << "not met: " << unmet << std::endl;

  std::cout << result.message << std::endl << result.quads << " quads" << std::endl;
  CGAL::IO::write_OFF("guides.off", qm, np::stream_precision(17));
  return result.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
