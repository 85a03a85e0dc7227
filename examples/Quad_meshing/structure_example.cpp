// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Makes a torus whose rings are one helix, finds the helix, unwinds it by flipping the edges along one
// dual curve, and smooths the result.
//
//   structure_example [quads around, default 24] [output.off]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/grid_preserving_operators.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;

int main(int argc, char* argv[])
{
  const int n = argc > 1 ? std::atoi(argv[1]) : 24, m = 10;
  if(n < 4 || n > 10000)
  {
    std::cerr << "structure_example: the number of quads around must be from 4 to 10000" << std::endl;
    return 2;
  }

  // n x m quads; behind the last column the rows go on one row higher
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 4>> quads;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j)
    {
      const double u = 2 * CGAL_PI * i / n, v = 2 * CGAL_PI * (j + double(i) / n) / m, r = 2 + std::cos(v);
      points.emplace_back(r * std::cos(u), r * std::sin(u), -std::sin(v));
      const auto id = [&](int a, int b) { return std::size_t((a % n) * m + (b + (a == n ? 1 : 0)) % m); };
      quads.push_back({ { id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1) } });
    }
  Mesh qm;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, quads, qm);

  for(const auto& h : QM::minimal_q_helices(qm))
    std::cout << "helix: pitch " << h.pitch << ", turn length " << h.turn_length << ", " << h.winding_number()
              << " turns\n";

  for(Mesh::Halfedge_index h : qm.halfedges())
  {
    const auto flip = QM::dual_curve_operator(qm, h, QM::Grid_preserving_step_kind::SHIFT_LEFT);
    Mesh flipped = qm;
    if(flip.size() == std::size_t(m) && QM::apply_grid_preserving_operator(flipped, flip) &&
       QM::minimal_q_helices(flipped).empty())
    {
      qm = flipped;
      break;
    }
  }
  const QM::Quad_mesh_smoothing_result smoothing = QM::smooth_quad_mesh(qm);
  std::cout << "after the flip: " << QM::quad_mesh_structure(qm).number_of_helices << " helices, "
            << smoothing.quality_after.mean_angle_deviation << " degrees mean deviation from right angles\n";

  if(argc > 2)
  {
    std::ofstream out(argv[2]);
    if(!out || !CGAL::IO::write_OFF(out, qm))
    {
      std::cerr << "structure_example: " << argv[2] << " cannot be written" << std::endl;
      return 2;
    }
  }
  return smoothing.folded_quads_after == 0 ? 0 : 1;
}
