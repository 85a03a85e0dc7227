// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Rounding methods beside one sparse Cholesky factorization of the same matrix and beside naive rounding, which
// solves the system anew after each rounding. Seconds are processor time.
//
//   bench_mixed_integer [--naive N] [--sizes] [--orders] [--greedy] [NAME or MESH ...]
//
// A MESH (.off, .obj, .ply) gives the problems of Tables 5.1 and 5.2 of Bommes 2012, made of it and its decimations:
// cross fields without constraints at 200, 1000, 2000 triangles and all, and maps at 1000 and 4000 quads; the figures
// of the thesis, for other decimations of a rocker arm with constraints, stand below. Naive rounding is left out
// beyond N integers (default 2000). With --sizes it gives the times of Tables 5.3 and 5.4 instead, at 10000, 50000
// and 200000 triangles.
//
// With --orders it prints what the order of elimination does to the map of a MESH whose transitions and alignment are
// left to the solver as equality constraints, the fill-in experiment of 5.3. With --greedy it prints the time of greedy
// rounding relative to the faster of naive rounding and the three levels, on fields.
//
// A NAME stands for the files NAME.A.mtx, NAME.b.mtx (Matrix Market) and NAME.I.txt (indices of integers, from 0).
// Without arguments two families of problems are made: maps, a few integers of global influence, and fields, many of
// local influence.

#include "mixed_integer_problems.h"

#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>

#include <CGAL/Random.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
using namespace mixed_integer_problems;

typedef QM::Mixed_integer_solution Solution;

// Solves a problem; `seconds` of the solution are processor time, which says more than the clock on a busy machine.
template <typename NamedParameters>
Solution solve(const Problem& problem, const NamedParameters& np)
{
  CGAL::Timer timer;
  timer.start();
  Solution solution = QM::solve_mixed_integer(problem, np);
  solution.seconds = timer.time();
  return solution;
}

double factorization_seconds(const Problem& problem)
{
  Eigen::SparseMatrix<double> A = problem.matrix();
  for(int i = 0; i < A.cols(); ++i)
    A.coeffRef(i, i) *= 1. + 1e-9; // fields and maps alone are fixed up to a constant
  QM::Sparse_cholesky<double> cholesky;
  CGAL::Timer timer;
  timer.start();
  cholesky.compute(A);
  return timer.time();
}

// Of the relaxation that raises lower bounds. With more integers it takes long.
const int bound_rounds = 8, most_relaxed_integers = 250;

void print(const char* name, const Solution& s, double factorization)
{
  std::printf("  %-22s %10.4g s %9.1f x %14.6f %14.6f", name, s.seconds, s.seconds / factorization,
              s.energy - s.relaxed_energy, s.lower_bound - s.relaxed_energy);
  std::printf("   %s", QM::status_name(s.status));
  if(s.gauss_seidel_roundings + s.conjugate_gradient_roundings > 0)
    std::printf(", steps by level %d %d %d", s.gauss_seidel_roundings, s.conjugate_gradient_roundings,
                s.factorization_roundings);
  if(s.nodes > 0)
    std::printf(", %.3g nodes", s.nodes);
  std::printf("\n");
  std::fflush(stdout);
}

void run(const std::string& name, const Problem& problem)
{
  const double naive_seconds = 20.; // after which the time of the rest is told from that of the roundings before
  const double factorization = factorization_seconds(problem);
  std::printf("%s: %d variables, %d integers; one factorization %.4g s\n", name.c_str(), problem.number_of_variables(),
              problem.number_of_integers(), factorization);
  std::printf("  %-22s %12s %11s %14s %14s\n", "method", "time", "/ factor.", "cost", "lower bound");
  print("direct", solve(problem, params::rounding_method(QM::Rounding_method::DIRECT)), factorization);

  const Solution naive =
    solve(problem, params::rounding_method(QM::Rounding_method::NAIVE).maximum_running_time(naive_seconds));
  if(naive.factorization_roundings == naive.free_integers)
    print("naive", naive, factorization);
  else
  {
    const double seconds = naive.seconds / naive.factorization_roundings * naive.free_integers;
    std::printf("  %-22s %10.4g s %9.1f x   (from %d roundings)\n", "naive", seconds, seconds / factorization,
                naive.factorization_roundings);
  }
  print("greedy", solve(problem, params::rounding_method(QM::Rounding_method::GREEDY)), factorization);
  print("greedy, three levels",
        solve(problem, params::rounding_method(QM::Rounding_method::GREEDY).maximum_dense_integers(0)), factorization);
  print("  tolerance 1e-3",
        solve(problem,
              params::rounding_method(QM::Rounding_method::GREEDY).maximum_dense_integers(0).rounding_tolerance(1e-3)),
        factorization);
  if(problem.number_of_integers() <= 1000)
  {
    print(
      "lattice within 1 s",
      solve(
        problem,
        params::rounding_method(QM::Rounding_method::LATTICE).maximum_number_of_nodes(1e8).maximum_running_time(1.)),
      factorization);
    for(double nodes : { 1e6, 3e7, 1e9 })
    {
      const Solution s = solve(
        problem,
        params::rounding_method(QM::Rounding_method::LATTICE).maximum_number_of_nodes(nodes).maximum_running_time(20.));
      const std::string title = "lattice, " + std::to_string(static_cast<long>(nodes / 1e6)) + "e6 nodes";
      print(title.c_str(), s, factorization);
      if(s.status == QM::Mixed_integer_status::OPTIMAL)
        break;
    }
    if(problem.number_of_integers() <= most_relaxed_integers)
      print("  and relaxation",
            solve(problem, params::rounding_method(QM::Rounding_method::LATTICE).number_of_bound_rounds(bound_rounds)),
            factorization);
  }
  std::printf("\n");
}

void print_cell(const Solution& s)
{
  std::printf(" | %8.3f/%8.3f", s.seconds, s.energy);
  std::fflush(stdout);
}

// The three levels of greedy rounding are for integers of local influence.
void print_row(const std::string& name, const Problem& problem, int naive_limit, bool has_levels)
{
  const int integers = problem.number_of_integers();
  std::printf("%-20s %6d %6d", name.c_str(), integers, problem.number_of_variables() - integers);
  print_cell(solve(problem, params::rounding_method(QM::Rounding_method::DIRECT)));
  const Solution greedy = solve(problem, params::rounding_method(QM::Rounding_method::GREEDY));
  print_cell(greedy);
  if(has_levels)
    print_cell(
      solve(problem,
            params::rounding_method(QM::Rounding_method::GREEDY).maximum_dense_integers(0).rounding_tolerance(1e-3)));
  else
    std::printf(" | %17s", "-");
  if(integers <= naive_limit)
    print_cell(solve(problem, params::rounding_method(QM::Rounding_method::NAIVE)));
  else
    std::printf(" | %17s", "-");
  if(integers <= 1000)
  {
    const double factorization = factorization_seconds(problem);
    const Solution s = solve(problem, params::rounding_method(QM::Rounding_method::LATTICE));
    print_cell(s);
    std::printf(" %9.3f %6.2f %% %-8s %8.4f %8.1f", s.lower_bound, 100. * (s.energy - s.lower_bound) / s.energy,
                QM::status_name(s.status), s.energy / greedy.energy, s.seconds / factorization);
    if(s.status != QM::Mixed_integer_status::OPTIMAL && integers <= most_relaxed_integers)
    {
      const Solution t =
        solve(problem, params::rounding_method(QM::Rounding_method::LATTICE).number_of_bound_rounds(bound_rounds));
      std::printf(" | %9.3f %6.2f %% %8.3f", t.lower_bound, 100. * (t.energy - t.lower_bound) / t.energy, t.seconds);
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

void print_header(const char* title)
{
  std::printf("%s\n%-20s %6s %6s | %17s | %17s | %17s | %17s | %17s %9s %8s %-8s %8s %8s | %9s %8s %8s\n", title, "",
              "discr.", "cont.", "direct s / E", "greedy s / E", "tol. 1e-3 s / E", "naive s / E", "lattice s / E",
              "bound", "gap", "", "E/greedy", "t/factor", "relaxed", "gap", "seconds");
}

void print_tables(const std::string& name, const Mesh& tm, int naive_limit)
{
  std::printf("%s\n", name.c_str());
  print_header("Table 5.1: orientation fields");
  for(std::size_t triangles :
      { std::size_t(200), std::size_t(1000), std::size_t(2000), std::size_t(tm.number_of_faces()) })
    if(triangles <= tm.number_of_faces())
    {
      const Mesh small = resized(tm, triangles);
      print_row(std::to_string(small.number_of_faces()) + " triangles", field_problem(small), naive_limit, true);
    }
  print_header("Table 5.2: parametrizations");
  for(int quads : { 1000, 4000 })
    print_row(std::to_string(quads) + " quads", map_problem(tm, quads), naive_limit, false);
  std::printf("\n");
}

// What the thesis has measured on a rocker arm, on a computer of 2012.
void print_thesis()
{
  std::printf("Thesis, Table 5.1, fields          discr.  cont. |    direct s / E |    greedy s / E |     naive s / E "
              "| branch and cut, 900 s\n"
              "  200 triangles                       111    153 |    0.002/  10.4 |    0.006/   8.6 |    0.010/   8.6 "
              "|   8.6, not proven\n"
              "  1000 triangles                      515    841 |    0.007/  21.5 |    0.026/  14.1 |    0.238/  13.8 "
              "|  13.7, not proven\n"
              "  2000 triangles                      910   1414 |    0.014/  30.9 |    0.036/  21.9 |    0.640/  21.6 "
              "|  21.3, not proven\n"
              "  20000 triangles                   10119  17759 |    0.160/  58.7 |    0.480/  33.9 |  124    /  33.7 "
              "|  40.5, not proven\n"
              "Thesis, Table 5.2, maps\n"
              "  200 triangles                        62    138 |    0.007/ 262   |    0.014/ 251   |    0.032/ 252   "
              "| 245, not proven\n"
              "  1000 triangles                       60    940 |    0.013/ 173   |    0.041/ 164   |    0.127/ 163   "
              "| 161, not proven\n"
              "  2000 triangles                       60   1940 |    0.021/ 254   |    0.068/ 232   |    0.258/ 232   "
              "| 230, not proven\n"
              "  20000 triangles                      56  19944 |    0.221/ 323   |    0.653/ 258   |    4.3  / 256   "
              "| 255, not proven\n");
}

void print_sizes(const std::string& name, const Mesh& tm)
{
  std::printf("%s\nTables 5.3 and 5.4: seconds, and in brackets relative to one factorization\n", name.c_str());
  std::printf("%9s | %18s %18s %10s %18s | %18s %18s\n", "triangles", "field, greedy", "tolerance 1e-3", "E/E",
              "field, polished", "map, greedy", "map, lattice");
  for(std::size_t triangles : { 10000, 50000, 200000 })
  {
    Mesh sized = resized(tm, triangles);
    const Problem field = field_problem(sized);
    const double field_factorization = factorization_seconds(field);
    const Solution greedy = solve(field, params::rounding_method(QM::Rounding_method::GREEDY));
    const Solution coarse = solve(field, params::rounding_method(QM::Rounding_method::GREEDY).rounding_tolerance(1e-3));
    auto angle = sized.add_property_map<Mesh::Face_index, double>("f:polished", 0.).first;
    auto jump = sized.add_property_map<Mesh::Edge_index, int>("e:polished", 0).first;
    auto index = sized.add_property_map<Mesh::Vertex_index, int>("v:polished", 0).first;
    CGAL::Timer timer;
    timer.start();
    QM::smooth_cross_field(sized, angle, jump, index);
    const double polished_seconds = timer.time();
    const Problem map = map_problem(sized, 4000);
    const double map_factorization = factorization_seconds(map);
    const Solution map_greedy = solve(map, params::rounding_method(QM::Rounding_method::GREEDY));
    const Solution map_lattice = solve(map, params::rounding_method(QM::Rounding_method::LATTICE));
    const auto cell = [](double seconds, double factorization)
    { std::printf(" %8.3f (%7.1f)", seconds, seconds / factorization); };
    std::printf("%9d |", static_cast<int>(sized.number_of_faces()));
    cell(greedy.seconds, field_factorization);
    cell(coarse.seconds, field_factorization);
    std::printf(" %10.4f", coarse.energy / greedy.energy);
    cell(polished_seconds, field_factorization);
    std::printf(" |");
    cell(map_greedy.seconds, map_factorization);
    cell(map_lattice.seconds, map_factorization);
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("Thesis: fields of an armadillo 0.3 (10k), 1.2 (50k), 6.3 s (200k), of a cube 0.11, 0.5, 2.8 s; maps "
              "1.3, 5.3, 21.4 s and 0.15, 0.9, 6.7 s\n\n");
}

// What the order of elimination does to the matrix ([Bom12, 5.3], the fill-in experiment).
void print_orders_header()
{
  std::printf(
    "Order of elimination: entries of the matrix, and seconds of greedy rounding; of the variables of a constraint "
    "goes\nthe one in the fewest other constraints, or the first with the largest coefficient\n");
  std::printf("%9s %12s %9s %-20s | %12s %10s | %12s %10s | %12s %10s\n", "variables", "constraints", "integers",
              "variable", "fewest first", "seconds", "as given", "seconds", "shuffled", "seconds");
}

// The constraints of a map come in chains along cuts and features, which is an order of its own.
Problem shuffled(const Problem& problem)
{
  Problem result(problem.number_of_variables());
  result.set_energy(problem.matrix(), problem.linear_term(), problem.constant());
  for(int i = 0; i < problem.number_of_variables(); ++i)
    result.set_integer(i, problem.is_integer(i));
  std::vector<Problem::Linear_constraint> constraints = problem.equality_constraints();
  CGAL::Random random(1);
  for(int i = static_cast<int>(constraints.size()) - 1; i > 0; --i)
    std::swap(constraints[i], constraints[random.get_int(0, i + 1)]);
  for(const Problem::Linear_constraint& c : constraints)
    result.add_equality_constraint(c.form, c.rhs);
  return result;
}

void print_orders(const Problem& problem)
{
  const Problem other_order = shuffled(problem);
  for(QM::Elimination_pivot pivot :
      { QM::Elimination_pivot::FEWEST_CONSTRAINTS, QM::Elimination_pivot::LARGEST_COEFFICIENT })
  {
    std::printf("%9d %12d %9d %-20s", problem.number_of_variables(),
                static_cast<int>(problem.equality_constraints().size()), problem.number_of_integers(),
                pivot == QM::Elimination_pivot::FEWEST_CONSTRAINTS ? "fewest constraints" : "largest coefficient");
    const auto print = [pivot](const Problem& given, QM::Elimination_order order)
    {
      const Solution s = solve(
        given, params::rounding_method(QM::Rounding_method::GREEDY).elimination_order(order).elimination_pivot(pivot));
      std::printf(" | %12.0f %10.3f", s.matrix_entries, s.seconds);
      std::fflush(stdout);
    };
    print(problem, QM::Elimination_order::FEWEST_COEFFICIENTS);
    print(problem, QM::Elimination_order::AS_GIVEN);
    print(other_order, QM::Elimination_order::AS_GIVEN);
    std::printf("\n");
  }
}

void print_elimination_orders()
{
  print_orders_header();
  for(int width : { 30, 60, 120 })
    print_orders(make_constrained_map(width));
  std::printf("\n");
}

// The choice between dense updates, naive rounding and the three levels: the best of a few runs of each.
void print_greedy_ratios()
{
  const int runs = 5;
  std::printf("Greedy rounding: seconds, and relative to the faster of naive rounding and three levels\n");
  std::printf("%9s %10s %10s %10s %8s\n", "integers", "greedy", "naive", "levels", "ratio");
  for(int width : { 16, 23, 32 })
  {
    const Problem problem = make_field(width);
    double seconds[3] = { 1e9, 1e9, 1e9 };
    int integers = 0;
    for(int run = 0; run < runs; ++run)
      for(int m = 0; m < 3; ++m)
      {
        const Solution s =
          m == 1
            ? solve(problem, params::rounding_method(QM::Rounding_method::NAIVE))
            : solve(problem,
                    params::rounding_method(QM::Rounding_method::GREEDY).maximum_dense_integers(m == 0 ? 1000 : 0));
        seconds[m] = (std::min)(seconds[m], s.seconds);
        integers = s.free_integers;
      }
    std::printf("%9d %10.4f %10.4f %10.4f %8.2f\n", integers, seconds[0], seconds[1], seconds[2],
                seconds[0] / (std::min)(seconds[1], seconds[2]));
    std::fflush(stdout);
  }
  std::printf("\n");
}

bool is_mesh_name(const std::string& name)
{
  const std::size_t dot = name.rfind('.');
  const std::string extension = dot == std::string::npos ? std::string() : name.substr(dot);
  return extension == ".off" || extension == ".obj" || extension == ".ply";
}

int main(int argc, char* argv[])
{
  int naive_limit = 2000;
  bool has_sizes = false, has_orders = false, is_default = true, has_tables = false;
  for(int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    if(name == "--naive" && i + 1 < argc)
    {
      naive_limit = std::atoi(argv[++i]);
      continue;
    }
    if(name == "--sizes")
    {
      has_sizes = true;
      continue;
    }
    if(name == "--orders")
    {
      has_orders = true;
      print_orders_header();
      continue;
    }
    is_default = false;
    if(name == "--greedy")
    {
      print_greedy_ratios();
      continue;
    }
    if(is_mesh_name(name))
    {
      Mesh tm;
      if(!CGAL::IO::read_polygon_mesh(name, tm) || !CGAL::is_triangle_mesh(tm))
      {
        std::fprintf(stderr, "bench_mixed_integer: %s: no triangle mesh can be read\n", name.c_str());
        return 2;
      }
      if(has_orders)
      {
        print_orders(map_problem(tm, 4000, true));
        continue;
      }
      if(has_sizes)
        print_sizes(name, tm);
      else
        print_tables(name, tm, naive_limit);
      has_tables = has_tables || !has_sizes;
      continue;
    }
    Problem problem;
    if(!read_problem(name, problem))
    {
      std::fprintf(stderr, "bench_mixed_integer: %s: the files of the problem cannot be read\n", name.c_str());
      return 2;
    }
    run(name, problem);
  }
  if(has_tables)
    print_thesis();
  if(is_default)
  {
    print_greedy_ratios();
    print_elimination_orders();
    run("map 100 x 100", make_map(100, 50));
    run("map 200 x 200", make_map(200, 100));
    run("field 40 x 40", make_field(40));
    run("field 140 x 140", make_field(140));
  }
  return EXIT_SUCCESS;
}
