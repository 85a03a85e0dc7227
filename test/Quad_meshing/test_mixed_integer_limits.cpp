// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Stops by the visitor, limits of time, and tolerances of the mixed-integer methods.

#include "mixed_integer_checks.h"
#include "mixed_integer_grids.h"
#include "test_cases.h"

#include <CGAL/Random.h>
#include <CGAL/Timer.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

const Method all_methods[] = { Method::RELAXED,        Method::DIRECT,         Method::NAIVE,
                               Method::GREEDY,         Method::LATTICE,        Method::BRANCH_AND_BOUND,
                               Method::BRANCH_AND_CUT, Method::CUTTING_PLANES, Method::OUTER_APPROXIMATION };

// Strongly coupled integers: no search proves their optimum.
Problem coupled_integers(int integers, double bound)
{
  CGAL::Random random(5);
  Problem problem(integers);
  for(int i = 0; i < integers; ++i)
  {
    problem.set_integer(i);
    if(bound > 0.)
      problem.set_bounds(i, -bound, bound);
    problem.add_squared_residual({ { i, 1. } }, random.get_double(-2., 2.), 0.02);
  }
  for(int k = 0; k < integers; ++k)
  {
    Problem::Linear_form form;
    for(int i = 0; i < 6; ++i)
      form.emplace_back(random.get_int(0, integers), random.get_double(-1., 1.));
    problem.add_squared_residual(form, random.get_double(-2., 2.));
  }
  return problem;
}

// Knapsacks: cutting planes and branchings raise the bound slowly.
Problem knapsacks(int integers)
{
  CGAL::Random random(6);
  Problem problem(integers);
  Eigen::VectorXd b(integers);
  for(int i = 0; i < integers; ++i)
  {
    problem.set_integer(i);
    problem.set_bounds(i, 0., 1.);
    b[i] = random.get_int(500, 1000);
  }
  problem.set_energy(Eigen::SparseMatrix<double>(integers, integers), b);
  for(int c = 0; c < 6; ++c)
  {
    Problem::Linear_form form;
    for(int i = 0; i < integers; ++i)
      form.emplace_back(i, random.get_int(100, 1000));
    problem.add_inequality_constraint(form, 180. * integers);
  }
  return problem;
}

// The shape of a field: integers of local influence.
Problem local_integers(int width)
{
  CGAL::Random random(7);
  Problem problem(width * width);
  for_each_grid_edge(width,
                     [&](int, int j, bool is_down, Problem::Linear_form form)
                     {
                       if(is_down && j > 0)
                         form.emplace_back(problem.add_variable(true), 1.);
                       problem.add_squared_residual(form, random.get_double(-1., 1.));
                     });
  problem.add_squared_residual({ { 0, 1. } }, 0.3);
  return problem;
}

// Stops after so many seconds of processor time, and takes the times between the signs of life.
struct Watch : QM::Default_visitor
{
  CGAL::Timer timer;
  double stop_after, stopped_at = -1., longest_pause = 0., last = 0., completed = 0.;
  int stages = 0;

  explicit Watch(double seconds) : stop_after(seconds) { timer.start(); }

  void on_stage_begin(const std::string&) { ++stages; }
  void on_stage_end(const std::string&) { --stages; }

  void progress(double part)
  {
    assert(part >= completed && part <= 1.);
    if(part > completed)
    {
      longest_pause = (std::max)(longest_pause, timer.time() - last);
      last = timer.time();
    }
    completed = part;
  }

  bool go_further()
  {
    if(timer.time() < stop_after)
      return true;
    if(stopped_at < 0.)
      stopped_at = timer.time();
    return false;
  }
};

// A problem that keeps a method busy for long.
struct Long_work
{
  std::string name;
  Problem problem;
  std::function<Solution(const Problem&, Watch&, double)> solve; // with a limit of seconds
  bool has_early_solution;                                       // whatever the limit
};

std::vector<Long_work> long_works()
{
  const double infinite = 1e15;
  const auto with = [=](Method method)
  {
    return [=](const Problem& problem, Watch& watch, double seconds)
    {
      return QM::solve_mixed_integer(
        problem,
        params::rounding_method(method).maximum_number_of_nodes(infinite).maximum_running_time(seconds).visitor(
          std::ref(watch)));
    };
  };
  std::vector<Long_work> works;
  works.push_back({ "lattice", coupled_integers(150, 0.), with(Method::LATTICE), true });
  works.push_back({ "branch-and-bound", coupled_integers(60, 0.), with(Method::BRANCH_AND_BOUND), true });
  works.push_back({ "branch-and-bound with bounds", coupled_integers(60, 3.), with(Method::BRANCH_AND_BOUND), false });
  works.push_back({ "branch-and-cut", coupled_integers(25, 0.), with(Method::BRANCH_AND_CUT), true });
  works.push_back({ "outer approximation", coupled_integers(12, 2.), with(Method::OUTER_APPROXIMATION), false });
  works.push_back({ "linear branch-and-cut", knapsacks(40), with(Method::BRANCH_AND_CUT), false });
  works.push_back({ "cutting planes", knapsacks(30), with(Method::CUTTING_PLANES), false });
  works.push_back({ "naive", local_integers(75), with(Method::NAIVE), true });
  works.push_back({ "greedy", local_integers(75),
                    [](const Problem& problem, Watch& watch, double seconds)
                    {
                      return QM::solve_mixed_integer(problem, params::rounding_method(Method::GREEDY)
                                                                .rounding_tolerance(1e-12)
                                                                .simultaneous_rounding(false)
                                                                .maximum_running_time(seconds)
                                                                .visitor(std::ref(watch)));
                    },
                    true });
  works.push_back({ "relaxation", coupled_integers(120, 0.),
                    [](const Problem& problem, Watch& watch, double seconds)
                    {
                      return QM::solve_mixed_integer(problem, params::rounding_method(Method::LATTICE)
                                                                .maximum_number_of_nodes(1e4)
                                                                .number_of_bound_rounds(1000)
                                                                .maximum_running_time(seconds)
                                                                .visitor(std::ref(watch)));
                    },
                    true });
  return works;
}

void stop_at_once()
{
  Problem problem = local_integers(6);
  for(Method method : all_methods)
  {
    if(method == Method::CUTTING_PLANES)
      problem = knapsacks(6);
    Watch watch(0.);
    const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method).visitor(std::ref(watch)));
    assert(watch.stages == 0);
    // What needs no search may be done before anybody asks.
    assert((s.status == Status::STOPPED && s.x.size() == 0 && !s.is_valid() && !s.message.empty()) ||
           method == Method::RELAXED || method == Method::DIRECT);
    if(method == Method::CUTTING_PLANES)
      problem = local_integers(3);
  }
}

void stop_later()
{
  const double soon = 0.5; // seconds of processor time
  for(const Long_work& work : long_works())
  {
    Watch watch(0.6);
    const Solution s = work.solve(work.problem, watch, 1e9);
    const double delay = watch.timer.time() - watch.stopped_at;
    std::cout << "  " << work.name << ": ends after " << delay << " s, longest pause " << watch.longest_pause << " s"
              << std::endl;
    assert(s.status == Status::STOPPED && s.x.size() == 0 && watch.stages == 0);
    assert(watch.stopped_at > 0. && delay < soon && watch.longest_pause < soon);
  }
}

void running_time()
{
  for(const Long_work& work : long_works())
    for(double limit : { 0., 0.3 })
    {
      Watch watch(1e9);
      const Solution s = work.solve(work.problem, watch, limit);
      std::cout << "  " << work.name << ", " << limit << " s: " << QM::status_name(s.status) << ", " << s.message
                << std::endl;
      assert(s.status == Status::FEASIBLE || s.status == Status::LIMIT_REACHED);
      assert(s.message.find("time limit") != std::string::npos);
      assert(s.status == Status::FEASIBLE || !work.has_early_solution);
      if(s.status == Status::FEASIBLE)
      {
        assert(s.all_integers_satisfied && s.x.size() == work.problem.number_of_variables());
        assert(std::fabs(s.energy - work.problem.energy(s.x)) < 1e-6 * (1. + std::fabs(s.energy)));
        assert(s.lower_bound <= s.energy);
      }
    }
}

// Equations that depend on each other up to a tolerance.
void constraint_tolerance()
{
  Problem problem(2);
  for(int i = 0; i < 2; ++i)
    problem.add_squared_residual({ { i, 1. } }, 0.2);
  problem.add_equality_constraint({ { 0, 1.25 }, { 1, 3.1 } }, 1.);
  problem.add_equality_constraint({ { 0, 1.25 }, { 1, 3.1 } }, 1. + 1e-4);
  assert(QM::solve_mixed_integer(problem).status == Status::CONFLICTING_CONSTRAINTS);
  const Solution loose = QM::solve_mixed_integer(problem, params::constraint_tolerance(1e-3));
  assert(loose.is_valid() && loose.redundant_constraints == std::vector<int>(1, 1) &&
         loose.conflicting_constraints.empty());

  // Coefficients that cancel up to 1e-5 make a constraint a dependent one, or a very sensitive one.
  problem = Problem(2);
  for(int i = 0; i < 2; ++i)
    problem.add_squared_residual({ { i, 1. } }, 0.2);
  problem.add_equality_constraint({ { 0, 1.25 }, { 1, 3.1 } }, 1.);
  problem.add_equality_constraint({ { 0, 1.25 }, { 1, 3.1 + 1e-5 } }, 1.);
  assert(QM::solve_mixed_integer(problem).redundant_constraints.empty());
  assert(std::fabs(QM::solve_mixed_integer(problem).x[1]) < 1e-6);
  assert(QM::solve_mixed_integer(problem, params::constraint_tolerance(1e-4)).redundant_constraints ==
         std::vector<int>(1, 1));
}

void relative_gap_tolerance()
{
  for(Method method : { Method::BRANCH_AND_BOUND, Method::BRANCH_AND_CUT })
  {
    const Problem problem = coupled_integers(20, 3.);
    const Solution best = QM::solve_mixed_integer(problem, params::rounding_method(method));
    assert(best.status == Status::OPTIMAL && best.gap == 0.);
    const double gap = 0.5;
    const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method).relative_gap_tolerance(gap));
    std::cout << "  nodes " << best.nodes << " and " << s.nodes << ", gap " << s.gap << std::endl;
    assert(s.is_valid() && s.nodes < best.nodes && s.gap <= gap && s.gap > 0.);
    assert(s.lower_bound <= best.energy + 1e-9 && s.energy >= best.energy - 1e-9);
    assert(s.energy - best.energy <= gap * std::fabs(s.energy) + 1e-9);
  }
}

// The order of elimination, and the choice of the variables that go, change the matrix that is left, and nothing else.
void elimination_order()
{
  CGAL::Random random(8);
  const int n = 240;
  Problem problem(n);
  for(int i = 0; i < n; ++i)
    problem.add_squared_residual({ { i, 1. }, { (i + 1) % n, -0.5 } }, 0.3 * (i % 5));
  for(int length : { 8, 2 })
    for(int c = 0; c < 30; ++c)
    {
      Problem::Linear_form form;
      const int begin = random.get_int(0, n - 12);
      for(int k = 0; k < length; ++k)
        form.emplace_back(begin + random.get_int(0, 12), random.get_double(0.5, 1.));
      problem.add_equality_constraint(form, random.get_double(-1., 1.));
    }
  const Solution best = QM::solve_mixed_integer(problem, params::rounding_method(Method::RELAXED));
  const Solution given = QM::solve_mixed_integer(
    problem, params::rounding_method(Method::RELAXED).elimination_order(QM::Elimination_order::AS_GIVEN));
  const Solution largest = QM::solve_mixed_integer(
    problem, params::rounding_method(Method::RELAXED).elimination_pivot(QM::Elimination_pivot::LARGEST_COEFFICIENT));
  std::cout << "  entries " << best.matrix_entries << ", " << given.matrix_entries << " and " << largest.matrix_entries
            << std::endl;
  assert(largest.status == Status::OPTIMAL && (best.x - largest.x).lpNorm<Eigen::Infinity>() < 1e-6);
  assert(largest.matrix_entries > 0. && largest.matrix_entries != best.matrix_entries);
  assert(best.status == Status::OPTIMAL && given.status == Status::OPTIMAL);
  assert((best.x - given.x).lpNorm<Eigen::Infinity>() < 1e-6);
  assert(best.matrix_entries > 0. && given.matrix_entries > 0. && best.matrix_entries != given.matrix_entries);
}

// Without new factorizations there are two: the first and the last one.
void allow_refactorization()
{
  const Problem problem = local_integers(20);
  const auto levels = params::rounding_method(Method::GREEDY)
                        .maximum_dense_integers(0)
                        .gauss_seidel_iterations(10)
                        .conjugate_gradient_iterations(1);
  const Solution with = QM::solve_mixed_integer(problem, levels);
  const Solution without = QM::solve_mixed_integer(problem, levels.allow_refactorization(false));
  std::cout << "  " << with.factorizations << " and " << without.factorizations << " factorizations, energies "
            << with.energy << " and " << without.energy << std::endl;
  assert(with.is_valid() && with.factorizations > 2 && with.factorization_roundings > 0);
  assert(without.is_valid() && without.factorizations == 2 && without.factorization_roundings == 0);
  const Solution direct = QM::solve_mixed_integer(problem, params::rounding_method(Method::DIRECT));
  assert(without.energy < direct.energy);
}

// Naive rounding takes over where it costs less than dense updates, with the same result.
void choice_of_greedy()
{
  const Problem many = local_integers(28), few = coupled_integers(250, 0.);
  const Solution local = QM::solve_mixed_integer(many, params::rounding_method(Method::GREEDY));
  assert(local.dense_roundings == 0 && local.factorization_roundings == many.number_of_integers());
  const Solution naive = QM::solve_mixed_integer(many, params::rounding_method(Method::NAIVE));
  assert(local.energy == naive.energy);
  const Solution dense = QM::solve_mixed_integer(few, params::rounding_method(Method::GREEDY));
  assert(dense.dense_roundings == 250);
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   {
                     { "stop_at_once", stop_at_once },
                     { "stop_later", stop_later },
                     { "running_time", running_time },
                     { "constraint_tolerance", constraint_tolerance },
                     { "relative_gap_tolerance", relative_gap_tolerance },
                     { "elimination_order", elimination_order },
                     { "allow_refactorization", allow_refactorization },
                     { "choice_of_greedy", choice_of_greedy },
                   });
}
