// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The cost of the analysis, the smoothing, the optimization and the grid-preserving operators, beside what it costs to
// copy the mesh into flat arrays; coarse layouts beside the removal of helices. Every random operator is checked: a
// pure quad mesh of the same topology with the same number of irregular vertices of each valence.
//
//   bench_structure [number of random operators, default 90000] [seed, default 1]

#include "structure_meshes.h"

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/grid_preserving_operators.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_execution.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_search.h>
#include <CGAL/Quad_meshing/Structure/optimize_quad_structure.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>
#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>

#include <cstdio>
#include <cstdlib>

namespace QM = CGAL::Quad_meshing;
namespace SM = structure_meshes;
typedef QM::internal::Indexed_quad_mesh Flat_mesh;

namespace {

double seconds(CGAL::Real_timer& timer)
{
  const double t = timer.time();
  timer.reset();
  return t;
}

void analysis_and_smoothing()
{
  std::printf("%10s | %10s %10s %10s | %10s %18s\n", "quads", "copy s", "analysis s", "smooth s", "x copy",
              "analysis s/100k");
  for(int n : { 26, 82, 129 })
  {
    SM::Mesh qm = SM::make_mesh(SM::sphere(n));
    CGAL::Real_timer timer;
    timer.start();
    const Flat_mesh m = QM::internal::make_indexed_quad_mesh(qm).mesh;
    const double copy = seconds(timer);
    QM::internal::structure_of_quad_mesh(m);
    const double analysis = seconds(timer);
    QM::smooth_quad_mesh(qm);
    const double smoothing = seconds(timer);
    std::printf("%10d | %10.4f %10.4f %10.4f | %10.1f %18.4f\n", m.number_of_faces(), copy, analysis, smoothing,
                analysis / copy, analysis * 1e5 / m.number_of_faces());
  }
}

// Vertex by vertex, and all vertices at once.
void smoothing()
{
  std::printf("\n%10s | %10s | %10s %10s %10s | %10s %10s %10s\n", "quads", "degrees", "sweeps", "degrees", "s",
              "steps", "degrees", "s");
  for(int n : { 13, 26, 52, 82 })
  {
    const SM::Mesh input = SM::make_mesh(SM::sphere(n));
    std::printf("%10zu | %10.2f", std::size_t(input.number_of_faces()),
                QM::quad_mesh_quality(input).mean_angle_deviation);
    for(bool globally : { false, true })
    {
      SM::Mesh qm = input;
      CGAL::Real_timer timer;
      timer.start();
      const auto r = QM::smooth_quad_mesh(qm, CGAL::parameters::smooth_globally(globally));
      std::printf(" | %10u %10.2f %10.3f", r.iterations, r.quality_after.mean_angle_deviation, timer.time());
    }
    std::printf("\n");
  }
}

// A sphere of 144 patches, each cut into k x k quads, after random operators.
SM::Mesh twisted_sphere(int k, int operators, unsigned int seed)
{
  const SM::Quad_soup base = SM::sphere(2);
  std::vector<std::array<std::size_t, 3>> triangles;
  for(const auto& q : base.quads)
  {
    triangles.push_back({ { q[0], q[1], q[2] } });
    triangles.push_back({ { q[0], q[2], q[3] } });
  }
  SM::Quad_soup soup = SM::refined(SM::split_triangles(base.points, triangles), k);
  Flat_mesh m = QM::internal::make_indexed_quad_mesh(SM::make_mesh(soup)).mesh;
  CGAL::Random random(seed);
  for(int i = 0; i < operators; ++i)
  {
    const QM::internal::Quad_vertex_rules rules = QM::internal::make_quad_vertex_rules(m, false);
    QM::internal::Gp_search search(m, rules);
    const QM::internal::Gp_path path = search.close({ 3 * random.get_int(0, m.number_of_halfedges()) });
    if(path.empty())
      continue;
    const Flat_mesh result = QM::internal::Gp_execution(m, path).execute(rules.is_special);
    if(QM::internal::is_valid_quad_mesh(result))
      m = result;
  }
  soup.points = m.points;
  soup.quads.clear();
  for(const std::array<int, 4>& c : m.corners)
    soup.quads.push_back({ { std::size_t(c[0]), std::size_t(c[1]), std::size_t(c[2]), std::size_t(c[3]) } });
  for(SM::Point_3& p : soup.points)
    p = CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length());
  return SM::make_mesh(soup);
}

void optimization()
{
  std::printf("\n%8s | %8s %8s %8s | %8s %8s %8s %8s %8s\n", "method", "quads", "patches", "helices", "quads",
              "patches", "helices", "least SJ", "s");
  for(int k : { 5, 10, 16 })
    for(QM::Structure_method method : { QM::Structure_method::LAYOUT, QM::Structure_method::HELICES })
    {
      const bool layout = method == QM::Structure_method::LAYOUT;
      if(!layout && k > 5)
        continue;
      SM::Mesh qm = twisted_sphere(k, 25, 1);
      CGAL::Real_timer timer;
      timer.start();
      const auto r = QM::optimize_quad_structure(qm, CGAL::parameters::structure_method(method));
      std::printf("%8s | %8zu %8zu %8zu | %8zu %8zu %8zu %8.2f %8.2f\n", layout ? "layout" : "helices",
                  r.structure_before.number_of_quads, r.structure_before.number_of_patches,
                  r.structure_before.number_of_helices, r.structure_after.number_of_quads,
                  r.structure_after.number_of_patches, r.structure_after.number_of_helices,
                  r.smoothing.quality_after.minimal_scaled_jacobian, timer.time());
    }
}

bool random_operators(int wanted, unsigned int seed)
{
  const std::vector<SM::Quad_soup> soups = { SM::cube(8), SM::rolled(16, 12, 2, true), SM::rolled(16, 12, 1, false),
                                             SM::grid(12, 9), SM::refined(SM::cube(2), 3) };
  CGAL::Random random(seed);
  CGAL::Real_timer timer;
  timer.start();
  int done = 0, not_representable = 0, violations = 0;
  long steps = 0;
  for(std::size_t k = 0; k < soups.size(); ++k)
  {
    const Flat_mesh input = QM::internal::make_indexed_quad_mesh(SM::make_mesh(soups[k])).mesh;
    const QM::Quad_mesh_structure before = QM::internal::structure_of_quad_mesh(input);
    Flat_mesh m = input;
    const int end = static_cast<int>(wanted * (k + 1) / soups.size());
    while(done < end)
    {
      const QM::internal::Quad_vertex_rules rules = QM::internal::make_quad_vertex_rules(m, false);
      QM::internal::Gp_search search(m, rules);
      QM::internal::Gp_path path;
      for(int attempt = 0; attempt < 10 && path.empty(); ++attempt)
        path = search.close({ 3 * random.get_int(0, m.number_of_halfedges()) + random.get_int(0, 3) });
      if(path.empty())
      {
        m = input;
        continue;
      }
      QM::internal::Gp_execution execution(m, path);
      Flat_mesh result = execution.execute(std::vector<char>(m.number_of_vertices(), 0));
      ++done;
      steps += static_cast<long>(path.size());
      if(!QM::internal::is_valid_quad_mesh(result))
      {
        ++not_representable;
        m = input;
        continue;
      }
      const QM::Quad_mesh_structure after = QM::internal::structure_of_quad_mesh(result);
      violations += after.inner_valences != before.inner_valences ||
                    after.boundary_valences != before.boundary_valences ||
                    after.euler_characteristic != before.euler_characteristic ||
                    after.number_of_boundary_loops != before.number_of_boundary_loops;
      m = result.number_of_faces() * 3 < input.number_of_faces() ? input : std::move(result);
    }
  }
  std::printf("\n%d operators, %.1f steps each, %.3f ms each with search and checks\n", done, double(steps) / done,
              1000 * timer.time() / done);
  std::printf("results with double edges, not executed: %d; violations: %d\n", not_representable, violations);
  return violations == 0;
}

} // namespace

int main(int argc, char* argv[])
{
  const int operators = argc > 1 ? std::atoi(argv[1]) : 90000;
  if(operators < 1)
  {
    std::fprintf(stderr, "bench_structure: the number of operators must be at least 1\n");
    return 2;
  }
  analysis_and_smoothing();
  smoothing();
  optimization();
  return random_operators(operators, argc > 2 ? std::atoi(argv[2]) : 1) ? 0 : 1;
}
