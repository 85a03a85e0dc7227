// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// How far the edges of quads are from the principal directions of the surface, where these are reliable [Bom12, 2.3],
// and what that costs: with the directions of the surface and without them, before the smoothing and after it.
//
// bench_orientation [--quads N] [MESH ...]     default: 4000 quads, meshes of CGAL's data folder

#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_deviation.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;
typedef QM::Quadrangulation Quadrangulation;
typedef Quadrangulation::Mesh Mesh;
typedef std::vector<std::optional<Quadrangulation::Kernel::Vector_3>> Directions;

namespace {

Directions principal_directions(const Mesh& tm, double edge_length)
{
  const double least_anisotropy = 0.8; // of the thesis, 8.1
  Directions direction(tm.number_of_faces());
  std::vector<double> weight(tm.number_of_faces());
  const auto index = get(boost::face_index, tm);
  QM::curvature_directions(tm, edge_length, boost::make_iterator_property_map(direction.begin(), index),
                           boost::make_iterator_property_map(weight.begin(), index),
                           CGAL::parameters::minimum_anisotropy(least_anisotropy));
  return direction;
}

void print_row(const std::string& name, const Mesh& tm, double quads, double alignment, unsigned int smoothing)
{
  Quadrangulation q(tm, tm.points());
  q.options.target_number_of_quads = quads;
  q.options.curvature_alignment = alignment;
  q.options.smoothing_iterations = smoothing;
  const QM::Quadrangulation_result r = q.run();
  std::printf("%-18s %9g %9u %-9s %6zu %9zu", name.c_str(), alignment, smoothing, QM::status_name(r.status), r.quads,
              r.irregular_vertices);
  if(r.is_valid())
  {
    const QM::Quad_mesh_quality quality = QM::quad_mesh_quality(q.quads().mesh);
    const Directions direction = principal_directions(tm, quality.mean_edge_length);
    const QM::Quad_mesh_deviation d =
      QM::quad_mesh_deviation(q.quads().mesh, tm, CGAL::parameters::default_values(),
                              CGAL::parameters::face_direction_map(
                                boost::make_iterator_property_map(direction.begin(), get(boost::face_index, tm))));
    std::printf(" %11.2f %8.3f %7zu %9.2f %8.3f", d.orientation_deviation_mean, d.orientation_over_15, d.oriented_edges,
                quality.mean_angle_deviation, quality.minimal_scaled_jacobian);
  }
  std::printf(" %7.2f\n", r.total_seconds);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> files(argv + 1, argv + argc);
  double quads = 4000;
  if(files.size() > 1 && files[0] == "--quads")
  {
    quads = std::atof(files[1].c_str());
    files.erase(files.begin(), files.begin() + 2);
  }
  if(!(quads > 0))
  {
    std::fprintf(stderr, "bench_orientation: the number of quads is not positive\n");
    return EXIT_FAILURE;
  }
  if(files.empty())
    for(const char* name : { "fandisk.off", "armadillo.off", "elephant.off", "joint.off", "rotor.off" })
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name));
  const unsigned int smoothing = QM::Quadrangulation_options().smoothing_iterations;
  std::printf("%-18s %9s %9s %-9s %6s %9s %11s %8s %7s %9s %8s %7s\n", "mesh", "alignment", "smoothing", "status",
              "quads", "irregular", "orientation", "over 15", "edges", "corners", "jacobian", "seconds");
  for(const std::string& file : files)
  {
    Mesh tm;
    const std::string name = file.substr(file.find_last_of('/') + 1);
    if(!QM::read_triangle_mesh(file, tm))
    {
      std::printf("%s: cannot be read\n", name.c_str());
      continue;
    }
    for(double alignment : { 0., 1. })
      for(unsigned int steps : { 0u, smoothing })
        print_row(name, tm, quads, alignment, steps);
  }
  return EXIT_SUCCESS;
}
