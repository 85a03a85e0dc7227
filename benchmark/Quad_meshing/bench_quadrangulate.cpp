// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The whole line on real meshes, with one sparse Cholesky factorization of the parametrization's system as the
// yardstick, and the shapes of Tables 5.2 and 8.1 of the thesis (Table 5.1 is printed by bench_fields).
//
// bench_quadrangulate [MESH ...]              default: meshes of CGAL's data folder
// bench_quadrangulate --densities [MESH ...]  at three numbers of quads: what is valid, what was given up, how long

#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Integer_grid_solver.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/OBJ.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;
typedef QM::Quadrangulation Quadrangulation;
typedef Quadrangulation::Mesh Mesh;

namespace {

template <typename Work>
double seconds(Work work)
{
  CGAL::Real_timer timer;
  timer.start();
  work();
  return timer.time();
}

// The parametrization's problem as the line poses it, before any separation is demanded.
QM::Mixed_integer_problem parametrization_problem(const QM::Quadrangulation_surface& q, double length)
{
  const QM::internal::Indexed_triangle_mesh mesh = QM::internal::make_indexed_triangle_mesh(
    q.mesh, q.mesh.points(), get(boost::vertex_index, q.mesh), get(boost::face_index, q.mesh));
  std::vector<double> angle, sizing(mesh.number_of_faces(), length);
  std::vector<int> jump, quarters;
  std::vector<bool> aligned;
  for(Mesh::Face_index f : q.mesh.faces())
    angle.push_back(q.angle[f]);
  for(Mesh::Edge_index e : q.mesh.edges())
  {
    jump.push_back(q.period_jump[e]);
    aligned.push_back(q.is_feature[e] || q.mesh.is_border(e));
  }
  for(Mesh::Vertex_index v : q.mesh.vertices())
    quarters.push_back((q.mesh.is_border(v) ? 2 : 4) - q.index[v]);
  QM::internal::Any_visitor visitor;
  QM::internal::Stage_progress progress(visitor);
  const std::vector<bool> is_node(mesh.number_of_vertices(), false);
  const QM::internal::Integer_grid_solver solver(mesh, angle, jump, quarters, aligned, sizing, is_node, 1, progress);
  const QM::internal::Orientation_energy energy(solver.coordinates, solver.faces,
                                                std::vector<double>(mesh.number_of_faces(), 1.), 1.);
  QM::Mixed_integer_problem problem(solver.coordinates.number_of_variables());
  problem.set_energy(energy.A, energy.b, energy.constant);
  for(int i = 0; i < solver.coordinates.number_of_variables(); ++i)
    problem.set_integer(i, solver.coordinates.is_integer[i]);
  return problem;
}

void bench(const std::string& filename)
{
  Mesh tm;
  QM::Quadrangulation_result r;
  std::unique_ptr<Quadrangulation> q;
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "bench_quadrangulate.obj";
  const double total = seconds(
    [&]
    {
      if(!QM::read_triangle_mesh(filename, tm))
        return;
      q = std::make_unique<Quadrangulation>(tm, tm.points());
      r = q->run();
      std::ofstream out(file);
      CGAL::IO::write_OBJ(out, q->quads().mesh, CGAL::parameters::stream_precision(17));
    });
  std::filesystem::remove(file);
  const std::string name = filename.substr(filename.find_last_of('/') + 1);
  if(!q)
  {
    std::printf("%s: cannot be read\n", name.c_str());
    return;
  }
  const QM::Mixed_integer_problem problem = parametrization_problem(q->surface(), r.target_edge_length);
  const Eigen::SparseMatrix<double> A = problem.matrix();
  const double cholesky = seconds(
    [&]
    {
      QM::Sparse_cholesky<double> solver;
      solver.compute(A);
    });
  std::printf("%-18s %-9s %7zu triangles: from file to file %.2f s, one Cholesky factorization %.3f s, ratio %.1f\n",
              name.c_str(), QM::status_name(r.status), r.input_faces, total, cholesky, total / cholesky);
  std::printf("  Table 8.1: field %7zu unknowns %6d integers %6.2f s | map %7d unknowns %4d integers %6.2f s | %d "
              "singularities %zu quads\n",
              r.prepared_faces + r.field_integers, r.field_integers, r.field_seconds, static_cast<int>(A.rows()),
              problem.number_of_integers(), r.parameterization_seconds, r.singularities, r.quads);
  std::printf("  Table 5.2 (seconds relative to one factorization / energy):");
  for(QM::Rounding_method method :
      { QM::Rounding_method::RELAXED, QM::Rounding_method::DIRECT, QM::Rounding_method::NAIVE,
        QM::Rounding_method::GREEDY, QM::Rounding_method::LATTICE })
  {
    QM::Mixed_integer_solution s;
    const double t = seconds([&] { s = QM::solve_mixed_integer(problem, CGAL::parameters::rounding_method(method)); });
    std::printf(" %s %.1f/%.4g", QM::rounding_method_name(method), t / cholesky, s.energy);
  }
  std::printf("\n");
  std::fflush(stdout);
}

// One row for each number of quads: processor time against that of reading the mesh.
void bench_densities(const std::string& filename)
{
  const std::string name = filename.substr(filename.find_last_of('/') + 1);
  Mesh tm;
  CGAL::Timer timer;
  timer.start();
  if(!QM::read_triangle_mesh(filename, tm))
  {
    std::printf("%-18s cannot be read\n", name.c_str());
    return;
  }
  const double reading = timer.time();
  for(double quads : { 1000., 4000., 16000. })
  {
    Quadrangulation q(tm, tm.points());
    q.options.target_number_of_quads = quads;
    timer.reset();
    const QM::Quadrangulation_result r = q.run();
    std::printf("%-18s %6.0f asked %6zu made, %-9s kept %.3f of the sharp length, %4zu sharp edges left out, %3zu "
                "inverted, %d maps, %6.2f s, %6.1f times reading\n",
                name.c_str(), quads, r.quads, QM::status_name(r.status), 1 - r.released_feature_share,
                r.dropped_feature_edges, r.folded_quads, r.parameterization_attempts, timer.time(),
                timer.time() / (std::max)(reading, 1e-3));
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> files(argv + 1, argv + argc);
  const bool only_densities = !files.empty() && files.front() == "--densities";
  if(only_densities)
    files.erase(files.begin());
  if(files.empty())
    for(const char* name : { "fandisk.off", "armadillo.off", "elephant.off", "joint.off", "rotor.off" })
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name));
  for(const std::string& file : files)
    only_densities ? bench_densities(file) : bench(file);
  return EXIT_SUCCESS;
}
