// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The cost of layout-guided quad meshing, three iterations of the charts included, beside one factorization of its own
// system: an ellipsoid of so many triangles, and a layout of six times n x n patches around it. Processor times.
//
//   bench_layout [number of triangles, default 100000]

#include "layout_meshes.h"

#include <CGAL/Quad_meshing/Layout/internal/Layout_charts.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_embedding.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_parameterization.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_regions.h>
#include <CGAL/Quad_meshing/Layout/quadrangulate_layout.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Timer.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace LM = layout_meshes;
namespace SM = structure_meshes;

namespace {

const std::array<double, 3> axes = { { 1, 1.5, 2 } };

SM::Mesh ellipsoid(int triangles)
{
  SM::Quad_soup quads = SM::sphere(static_cast<int>(std::ceil(std::sqrt(triangles / 12.))));
  for(SM::Point_3& p : quads.points)
    p = SM::Point_3(axes[0] * p.x(), axes[1] * p.y(), axes[2] * p.z());
  SM::Mesh mesh = SM::make_mesh(quads);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

// Processor time of one factorization of the system whose solution is the map, with all arcs aligned.
double seconds_of_factorization(const SM::Mesh& mesh, const LM::Layout& layout)
{
  namespace QI = QM::internal;
  const auto np = CGAL::parameters::default_values();
  const QI::Indexed_triangle_mesh input = QI::make_indexed_triangle_mesh(mesh, np);
  QI::Embedded_layout e(input, std::vector<char>(3 * input.corners.size(), 0), layout);
  QI::Named_visitor<CGAL::parameters::Default_named_parameters> visitor(np);
  const std::string error = QI::Layout_embedding(e).run(input, visitor);
  if(!error.empty() || !QI::find_regions(e).empty())
    return 0;
  QI::Layout_charts charts(e);
  for(const auto& p : e.layout.patches)
    charts.chart.push_back(
      QI::Quadrilateral_chart::rectangle(charts.side_length(p.sides[0]), charts.side_length(p.sides[1])));
  QI::Layout_parameterization map(e, false);
  return map.solve(charts, std::vector<char>(e.layout.arcs.size(), 1),
                   QI::Layout_parameterization::Alignment::TANGENTIAL)
           ? map.factorization_seconds / map.factorizations
           : 0;
}

} // namespace

int main(int argc, char* argv[])
{
  const SM::Mesh mesh = ellipsoid(argc > 1 ? std::atoi(argv[1]) : 100000);
  std::printf("%10s %8s | %10s %10s %8s | %12s %14s\n", "triangles", "patches", "iterations", "quads", "degrees",
              "seconds", "factorizations");
  for(int n : { 1, 3, 6 })
  {
    const LM::Layout layout = LM::around(SM::cube(n), axes);
    SM::Mesh quads;
    CGAL::Timer timer;
    timer.start();
    const QM::Layout_quadrangulation_result r = QM::quadrangulate_layout(
      mesh, layout, quads, CGAL::parameters::target_number_of_quads(4000.).number_of_iterations(3));
    const double seconds = timer.time();
    if(!r.is_valid())
    {
      std::cerr << r.message << std::endl;
      return EXIT_FAILURE;
    }
    const double one = seconds_of_factorization(mesh, layout);
    std::printf("%10zu %8zu | %10zu %10zu %8.2f | %12.2f %14.1f\n", std::size_t(mesh.number_of_faces()), r.patches,
                r.energies.size() - 1, r.quads, QM::quad_mesh_quality(quads).mean_angle_deviation, seconds,
                seconds / one);
  }
  return EXIT_SUCCESS;
}
