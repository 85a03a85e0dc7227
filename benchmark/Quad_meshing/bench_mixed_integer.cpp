// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Rounding methods beside one sparse Cholesky factorization of the same matrix and beside naive rounding, which
// factorizes once per integer.
//
//   bench_mixed_integer [NAME ...]
//
// Problems are read from NAME.A.mtx, NAME.b.mtx (Matrix Market) and NAME.I.txt (indices of integers, from 0). Without
// arguments two families are made: maps, a few integers of global influence, and fields, many of local influence.

#include <CGAL/Quad_meshing/Mixed_integer/read_matrix_market.h>
#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>

#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace params = CGAL::parameters;

typedef QM::Mixed_integer_problem Problem;
typedef QM::Mixed_integer_solution Solution;

// A grid of reals; differences across random edges contain integers, one for each of some vertical cuts.
Problem make_map(int width, int integers)
{
  CGAL::Random random(1);
  Problem problem(width * width);
  for(int k = 0; k < integers; ++k)
    problem.add_variable(true);
  const auto index = [width](int i, int j) { return i * width + j; };
  for(int i = 0; i < width; ++i)
    for(int j = 0; j < width; ++j)
      for(int d = 0; d < 2; ++d)
      {
        const int i2 = i + (d == 0), j2 = j + (d == 1);
        if(i2 == width || j2 == width)
          continue;
        Problem::Linear_form form = { { index(i2, j2), 1. }, { index(i, j), -1. } };
        // Cut k crosses the edges of a row segment.
        const int cut = (i * integers) / width;
        if(d == 0 && i % ((std::max)(1, width / integers)) == 0 && j < width / 2)
          form.emplace_back(width * width + cut, 1.);
        problem.add_squared_residual(form, random.get_double(-0.6, 0.7));
      }
  problem.add_equality_constraint({ { 0, 1. } }, 0.);
  return problem;
}

// Angles at the nodes of a grid, period jumps on the edges that are not in a spanning tree.
Problem make_field(int width)
{
  CGAL::Random random(2);
  const double quarter = 1.57079632679489661923;
  Problem problem(width * width);
  const auto index = [width](int i, int j) { return i * width + j; };
  for(int i = 0; i < width; ++i)
    for(int j = 0; j < width; ++j)
      for(int d = 0; d < 2; ++d)
      {
        const int i2 = i + (d == 0), j2 = j + (d == 1);
        if(i2 == width || j2 == width)
          continue;
        Problem::Linear_form form = { { index(i2, j2), 1. }, { index(i, j), -1. } };
        const bool is_tree_edge = d == 1 || j == 0;
        if(!is_tree_edge)
          form.emplace_back(problem.add_variable(true), quarter);
        problem.add_squared_residual(form, random.get_double(-0.25, 0.25));
      }
  problem.add_equality_constraint({ { 0, 1. } }, 0.);
  return problem;
}

bool read_problem(const std::string& name, Problem& problem)
{
  std::ifstream a(name + ".A.mtx"), b(name + ".b.mtx"), integers(name + ".I.txt");
  Eigen::SparseMatrix<double> A, rhs;
  std::string message;
  if(!a || !b || !integers || !QM::read_matrix_market(a, A, message) || !QM::read_matrix_market(b, rhs, message))
    return false;
  problem = Problem(static_cast<int>(A.rows()));
  problem.set_energy(A, Eigen::VectorXd(Eigen::MatrixXd(rhs).col(0)));
  for(int i; integers >> i;)
    problem.set_integer(i);
  return true;
}

// Stops naive rounding after some steps, to tell the time of the rest from them.
struct Step_limit : QM::Default_visitor
{
  int steps = 0, maximum;
  explicit Step_limit(int m) : maximum(m) {}
  bool go_further() { return ++steps < maximum; }
};

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
  const int naive_steps = 400;
  CGAL::Real_timer timer;
  Eigen::SparseMatrix<double> A = problem.matrix();
  for(int i = 0; i < A.cols(); ++i)
    A.coeffRef(i, i) *= 1. + 1e-9; // fields and maps alone are fixed up to a constant
  QM::Sparse_cholesky cholesky;
  timer.start();
  cholesky.compute(A);
  timer.stop();
  const double factorization = timer.time();

  std::printf("%s: %d variables, %d integers; one factorization %.4g s\n", name.c_str(), problem.number_of_variables(),
              problem.number_of_integers(), factorization);
  std::printf("  %-22s %12s %11s %14s %14s\n", "method", "time", "/ factor.", "cost", "lower bound");
  print("direct", QM::solve_mixed_integer(problem, params::rounding_method(QM::DIRECT_ROUNDING)), factorization);

  if(problem.number_of_integers() <= naive_steps)
    print("naive", QM::solve_mixed_integer(problem, params::rounding_method(QM::NAIVE_ROUNDING)), factorization);
  else
  {
    Step_limit limit(naive_steps / 10);
    const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(QM::NAIVE_ROUNDING)
      .visitor(std::ref(limit)));
    const double seconds = s.seconds / (naive_steps / 10) * problem.number_of_integers();
    std::printf("  %-22s %10.4g s %9.1f x   (from %d steps)\n", "naive", seconds, seconds / factorization, naive_steps / 10);
  }
  print("greedy", QM::solve_mixed_integer(problem, params::rounding_method(QM::GREEDY_ROUNDING)), factorization);
  print("greedy, three levels", QM::solve_mixed_integer(problem, params::rounding_method(QM::GREEDY_ROUNDING)
    .maximum_dense_integers(0)), factorization);
  print("  tolerance 1e-3", QM::solve_mixed_integer(problem, params::rounding_method(QM::GREEDY_ROUNDING)
    .maximum_dense_integers(0).rounding_tolerance(1e-3)), factorization);
  if(problem.number_of_integers() <= 1000)
    for(double nodes : { 1e6, 3e7, 1e9 })
    {
      const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(QM::LATTICE_ROUNDING)
        .maximum_number_of_nodes(nodes).maximum_running_time(20.));
      const std::string title = "lattice, " + std::to_string(static_cast<long>(nodes / 1e6)) + "e6 nodes";
      print(title.c_str(), s, factorization);
      if(s.status == Solution::OPTIMAL)
        break;
    }
  std::printf("\n");
}

int main(int argc, char* argv[])
{
  for(int i = 1; i < argc; ++i)
  {
    Problem problem;
    if(!read_problem(argv[i], problem))
    {
      std::fprintf(stderr, "bench_mixed_integer: %s: the files of the problem cannot be read\n", argv[i]);
      return 2;
    }
    run(argv[i], problem);
  }
  if(argc == 1)
  {
    run("map 100 x 100", make_map(100, 50));
    run("map 200 x 200", make_map(200, 100));
    run("field 40 x 40", make_field(40));
    run("field 140 x 140", make_field(140));
  }
  return EXIT_SUCCESS;
}
