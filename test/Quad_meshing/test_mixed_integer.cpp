// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Mixed-integer problems against brute force, and methods against each other.

#include "mixed_integer_checks.h"
#include "mixed_integer_grids.h"
#include "test_cases.h"

#include <CGAL/Quad_meshing/Mixed_integer/Integer_energy.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Lattice_bound.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Lattice_enumeration.h>
#include <CGAL/Quad_meshing/Mixed_integer/read_matrix_market.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Random.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

double uniform(CGAL::Random& random, double low, double high) { return random.get_double(low, high); }

// A well-conditioned convex energy of dense squared residuals.
Problem random_problem(CGAL::Random& random, int integers, int reals)
{
  Problem problem;
  const int n = integers + reals;
  for(int i = 0; i < n; ++i)
    problem.add_variable(i < integers);
  for(int i = 0; i < n; ++i)
  {
    Problem::Linear_form form;
    for(int j = 0; j < n; ++j)
      form.emplace_back(j, (i == j ? 1. : 0.) + uniform(random, -0.25, 0.25));
    problem.add_squared_residual(form, uniform(random, -3., 3.), uniform(random, 0.5, 2.));
  }
  return problem;
}

// All integers in a box, in lexicographic order.
void for_each_integer_point(const std::vector<int>& low, const std::vector<int>& high,
                            const std::function<void(const std::vector<int>&)>& visit)
{
  std::vector<int> point = low;
  for(std::size_t i = 0; i < low.size(); ++i)
    if(low[i] > high[i])
      return;
  for(;;)
  {
    visit(point);
    std::size_t i = 0;
    while(i < point.size() && point[i] == high[i])
    {
      point[i] = low[i];
      ++i;
    }
    if(i == point.size())
      return;
    ++point[i];
  }
}

// The least energy over all integer points, infinite if none is feasible. The first variables must be the integers.
// Constraints listed as ignored do not count. `upper` is a known upper bound: only the points that can be better are
// tried, which are |x_i - x*_i| <= sqrt(2 (upper - E*) (A^-1)_ii) around the unconstrained minimum x*.
double brute_force(const Problem& problem, double upper, const std::vector<int>& ignored)
{
  const int n = problem.number_of_variables(), m = problem.number_of_integers(), r = n - m;
  const Eigen::MatrixXd A = problem.matrix();
  const Eigen::VectorXd b = problem.linear_term();
  const Eigen::MatrixXd inverse = A.inverse();
  const Eigen::VectorXd minimum = inverse * b;
  const double least = problem.energy(minimum);
  std::vector<int> low(m), high(m);
  for(int i = 0; i < m; ++i)
  {
    const double reach = std::sqrt(2. * (upper - least + 1e-6) * inverse(i, i));
    low[i] = static_cast<int>(std::ceil((std::max)(minimum[i] - reach, problem.lower_bound(i))));
    high[i] = static_cast<int>(std::floor((std::min)(minimum[i] + reach, problem.upper_bound(i))));
  }

  std::vector<Problem::Linear_constraint> equalities;
  for(std::size_t c = 0; c < problem.equality_constraints().size(); ++c)
    if(std::find(ignored.begin(), ignored.end(), static_cast<int>(c)) == ignored.end())
      equalities.push_back(problem.equality_constraints()[c]);
  const int e = static_cast<int>(equalities.size());
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(e, n);
  Eigen::VectorXd d(e);
  for(int c = 0; c < e; ++c)
  {
    for(const std::pair<int, double>& a : equalities[c].form)
      C(c, a.first) += a.second;
    d[c] = equalities[c].rhs;
  }
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(r + e, r + e);
  kkt.topLeftCorner(r, r) = A.bottomRightCorner(r, r);
  kkt.bottomLeftCorner(e, r) = C.rightCols(r);
  kkt.topRightCorner(r, e) = C.rightCols(r).transpose();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  if(r + e > 0)
    solver.compute(kkt);

  double best = infinity;
  Eigen::VectorXd x(n), rhs(r + e);
  for_each_integer_point(low, high,
                         [&](const std::vector<int>& y)
                         {
                           for(int i = 0; i < m; ++i)
                             x[i] = y[i];
                           if(r + e > 0)
                           {
                             rhs.head(r) = b.tail(r) - A.bottomLeftCorner(r, m) * x.head(m);
                             rhs.tail(e) = d - C.leftCols(m) * x.head(m);
                             if(r > 0)
                               x.tail(r) = solver.solve(rhs).head(r);
                             if(e > 0 && (C * x - d).cwiseAbs().maxCoeff() > 1e-7)
                               return;
                           }
                           for(const Problem::Linear_constraint& c : problem.inequality_constraints())
                           {
                             double value = -c.rhs;
                             for(const std::pair<int, double>& a : c.form)
                               value += a.second * x[a.first];
                             if(value > 1e-7)
                               return;
                           }
                           best = (std::min)(best, 0.5 * x.dot(A * x) - x.dot(b) + problem.constant());
                         });
  return best;
}

// Every condition that the solution claims to meet holds, and its energy is told truthfully.
void check_solution(const Problem& problem, const Solution& s)
{
  assert(s.x.size() == problem.number_of_variables());
  assert(s.all_integers_satisfied);
  for(int i = 0; i < problem.number_of_variables(); ++i)
  {
    if(problem.is_integer(i))
      assert(s.x[i] == std::floor(s.x[i]));
    assert(s.x[i] >= problem.lower_bound(i) - 1e-7 && s.x[i] <= problem.upper_bound(i) + 1e-7);
  }
  for(std::size_t c = 0; c < problem.equality_constraints().size(); ++c)
  {
    const Problem::Linear_constraint& constraint = problem.equality_constraints()[c];
    if(std::find(s.conflicting_constraints.begin(), s.conflicting_constraints.end(), static_cast<int>(c)) !=
       s.conflicting_constraints.end())
      continue;
    double value = 0.;
    bool has_integers_only = true;
    for(const std::pair<int, double>& a : constraint.form)
    {
      value += a.second * s.x[a.first];
      has_integers_only = has_integers_only && problem.is_integer(a.first) && a.second == std::floor(a.second);
    }
    if(has_integers_only)
      assert(value == constraint.rhs);
    else
      assert(std::fabs(value - constraint.rhs) < 1e-6);
  }
  assert(is_close(s.energy, problem.energy(s.x)));
  assert(s.lower_bound <= s.energy + 1e-12 * std::fabs(s.energy));
  if(s.conflicting_constraints.empty())
    assert(s.relaxed_energy <= s.energy + 1e-9 * (1. + std::fabs(s.energy)));
}

template <typename NamedParameters>
Solution solve_and_check(const Problem& problem, const NamedParameters& np)
{
  const Solution s = QM::solve_mixed_integer(problem, np);
  check_solution(problem, s);
  return s;
}

void add_random_equalities(CGAL::Random& random, Problem& problem, int integers, int reals)
{
  const int count = random.get_int(1, 3);
  // With real coefficients each constraint needs a real variable of its own to leave the integers free.
  const int kind = reals >= count ? random.get_int(0, 5) : (random.get_int(0, 4) + 3) % 5;
  for(int c = 0; c < count; ++c)
  {
    Problem::Linear_form form;
    switch(kind)
    {
      case 0: // small coefficients over integers
        for(int i = 0; i < integers; ++i)
          form.emplace_back(i, random.get_int(-1, 2));
        problem.add_equality_constraint(form, random.get_int(-2, 3));
        break;
      case 1: // no coefficient is the greatest common divisor
        for(int i = 0; i < integers; ++i)
        {
          const int primes[] = { 6, 10, 15, -6, -10, -15 };
          form.emplace_back(i, primes[random.get_int(0, 6)]);
        }
        problem.add_equality_constraint(form, random.get_int(-3, 4));
        break;
      case 2: // real variables take part
        for(int i = 0; i < integers + reals; ++i)
          form.emplace_back(i, uniform(random, -2., 2.));
        problem.add_equality_constraint(form, uniform(random, -2., 2.));
        break;
      case 3: // rational coefficients
        for(int i = 0; i < integers; ++i)
          form.emplace_back(i, random.get_int(-3, 4) / 3.);
        problem.add_equality_constraint(form, random.get_int(-2, 3));
        break;
      default: // a constraint and others that follow from it, or contradict it
      {
        for(int i = 0; i < integers; ++i)
          form.emplace_back(i, random.get_int(-1, 3));
        const int rhs = random.get_int(-2, 3);
        problem.add_equality_constraint(form, rhs);
        Problem::Linear_form twice = form;
        for(std::pair<int, double>& a : twice)
          a.second *= 2.;
        problem.add_equality_constraint(twice, 2. * rhs + (random.get_int(0, 2) ? 0. : 1.));
      }
    }
  }
}

// Methods that promise the optimum find it; the others are feasible and never below.
void test_against_brute_force(CGAL::Random& random)
{
  const int problems = 1000;
  int conflicts = 0, redundancies = 0;
  for(int p = 0; p < problems; ++p)
  {
    const bool has_equalities = p % 2 == 1;
    const int integers = has_equalities ? random.get_int(1, 5) : random.get_int(1, p % 20 == 0 ? 11 : 7);
    const int reals = random.get_int(0, 3);
    Problem problem = random_problem(random, integers, reals);
    if(has_equalities)
      add_random_equalities(random, problem, integers, reals);

    const Solution lattice = QM::solve_mixed_integer(problem, params::rounding_method(QM::Rounding_method::LATTICE));
    conflicts += !lattice.conflicting_constraints.empty();
    redundancies += !lattice.redundant_constraints.empty();
    check_solution(problem, lattice);
    const double best = brute_force(problem, lattice.energy, lattice.conflicting_constraints);
    assert(is_close(lattice.energy, best));

    const QM::Rounding_method exact[] = { QM::Rounding_method::BRANCH_AND_BOUND, QM::Rounding_method::BRANCH_AND_CUT };
    for(QM::Rounding_method method : exact)
    {
      const Solution s = solve_and_check(problem, params::rounding_method(method));
      assert(is_close(s.energy, best));
      assert(s.status == QM::Mixed_integer_status::OPTIMAL ||
             s.status == QM::Mixed_integer_status::CONFLICTING_CONSTRAINTS);
    }
    const Solution greedy = solve_and_check(problem, params::rounding_method(QM::Rounding_method::GREEDY));
    assert(greedy.energy >= best - 1e-6 * (1. + std::fabs(best)));
    assert(greedy.conflicting_constraints == lattice.conflicting_constraints);
    const Solution direct = solve_and_check(problem, params::rounding_method(QM::Rounding_method::DIRECT));
    assert(direct.energy >= best - 1e-6 * (1. + std::fabs(best)));
    assert(is_close(direct.relaxed_energy, greedy.relaxed_energy));
    const Solution naive = solve_and_check(problem, params::rounding_method(QM::Rounding_method::NAIVE));
    assert(is_close(naive.energy, greedy.energy));
  }
  std::cout << "  " << problems << " problems, " << conflicts << " with conflicting, " << redundancies
            << " with redundant constraints" << std::endl;
  assert(conflicts > 20 && redundancies > 20);
}

// Constraints whose solutions are known.
void test_elimination()
{
  {
    // 6a + 10b + 15c = 1: no coefficient divides the others. The nearest solution to (0.1, 0.1, 0) is (1, 1, -1).
    Problem problem(3);
    const double target[] = { 0.1, 0.1, 0. };
    for(int i = 0; i < 3; ++i)
    {
      problem.set_integer(i);
      problem.add_squared_residual({ { i, 1. } }, target[i]);
    }
    problem.add_equality_constraint({ { 0, 6. }, { 1, 10. }, { 2, 15. } }, 1.);
    const Solution s = solve_and_check(problem, params::rounding_method(QM::Rounding_method::LATTICE));
    assert(s.status == QM::Mixed_integer_status::OPTIMAL && s.free_integers == 2);
    assert(s.x[0] == 1. && s.x[1] == 1. && s.x[2] == -1.);
  }
  {
    // Parity: 2a + 4b = 3 has no solution in integers, though it has real ones.
    Problem problem(2);
    for(int i = 0; i < 2; ++i)
    {
      problem.set_integer(i);
      problem.add_squared_residual({ { i, 1. } }, 0.2);
    }
    problem.add_equality_constraint({ { 0, 2. }, { 1, 4. } }, 3.);
    const Solution s = QM::solve_mixed_integer(problem);
    assert(s.status == QM::Mixed_integer_status::CONFLICTING_CONSTRAINTS);
    assert(s.conflicting_constraints == std::vector<int>(1, 0) && s.all_integers_satisfied);
  }
  {
    // Real coefficients over integers alone: a + sqrt(2) b = 1/2 has no solution, and it is said so.
    Problem problem(2);
    for(int i = 0; i < 2; ++i)
    {
      problem.set_integer(i);
      problem.add_squared_residual({ { i, 1. } }, 0.2);
    }
    problem.add_equality_constraint({ { 0, 1. }, { 1, std::sqrt(2.) } }, 0.5);
    const Solution s = QM::solve_mixed_integer(problem);
    assert(s.status == QM::Mixed_integer_status::INFEASIBLE && !s.all_integers_satisfied && !s.is_valid());
  }
  {
    // A chain with large coefficients: exact although products outgrow a double.
    const int n = 12;
    Problem problem(n);
    for(int i = 0; i < n; ++i)
    {
      problem.set_integer(i);
      problem.add_squared_residual({ { i, 1. } }, 0.3 * i);
    }
    for(int i = 0; i + 2 < n; ++i)
      problem.add_equality_constraint({ { i, 30030. }, { i + 1, -46189. + i }, { i + 2, 1001. + 2. * i } }, 0.);
    const Solution s = QM::solve_mixed_integer(problem);
    assert(s.status == QM::Mixed_integer_status::FEASIBLE || s.status == QM::Mixed_integer_status::OPTIMAL);
    check_solution(problem, s);
  }
  {
    // Real variables go first: both integers stay free, and the coefficient 3 that would need a division is not chosen.
    Problem problem(4);
    for(int i = 0; i < 4; ++i)
      problem.add_squared_residual({ { i, 1. } }, 0.4 + i);
    problem.set_integer(0);
    problem.set_integer(1);
    problem.add_equality_constraint({ { 0, 1. }, { 1, 1. }, { 2, 3. }, { 3, 2. } }, 0.);
    const Solution s = solve_and_check(problem, params::rounding_method(QM::Rounding_method::GREEDY));
    assert(s.free_integers == 2 && s.free_variables == 3);
    assert(s.x[0] + s.x[1] + 3. * s.x[2] + 2. * s.x[3] < 1e-14);
  }
}

// Bounds and inequality constraints, all selections and branching rules.
void test_inequalities(CGAL::Random& random)
{
  for(int p = 0; p < 150; ++p)
  {
    const int integers = random.get_int(1, 5), reals = 0;
    Problem problem = random_problem(random, integers, reals);
    for(int i = 0; i < integers; ++i)
      problem.set_bounds(i, -3, 3);
    for(int c = random.get_int(0, 4); c > 0; --c)
    {
      Problem::Linear_form form;
      for(int i = 0; i < integers; ++i)
        form.emplace_back(i, random.get_int(-4, 5));
      problem.add_inequality_constraint(form, random.get_int(-4, 6));
    }
    const double best = brute_force(problem, 1e6, std::vector<int>());
    const QM::Subproblem_selection selections[] = { QM::Subproblem_selection::BEST_BOUND,
                                                    QM::Subproblem_selection::DEPTH_FIRST,
                                                    QM::Subproblem_selection::BEST_ESTIMATE };
    const QM::Branching_rule rules[] = {
      QM::Branching_rule::MINIMUM_INFEASIBILITY, QM::Branching_rule::MAXIMUM_INFEASIBILITY,
      QM::Branching_rule::PSEUDO_COSTS,          QM::Branching_rule::MAXIMUM_THEN_MINIMUM_INFEASIBILITY,
      QM::Branching_rule::MINIMUM_PSEUDO_COSTS,  QM::Branching_rule::MAXIMUM_PSEUDO_COSTS
    };
    for(QM::Subproblem_selection selection : selections)
      for(QM::Branching_rule rule : rules)
        for(int m = 0; m < 2; ++m)
        {
          const Solution s =
            QM::solve_mixed_integer(problem, params::rounding_method(m == 0 ? QM::Rounding_method::BRANCH_AND_BOUND
                                                                            : QM::Rounding_method::BRANCH_AND_CUT)
                                               .subproblem_selection(selection)
                                               .branching_rule(rule));
          if(best == infinity)
          {
            assert(s.status == QM::Mixed_integer_status::INFEASIBLE);
            continue;
          }
          assert(s.status == QM::Mixed_integer_status::OPTIMAL);
          check_solution(problem, s);
          assert(is_close(s.energy, best));
        }
    if(p % 5 == 0 && integers <= 3)
    {
      const Solution s =
        QM::solve_mixed_integer(problem, params::rounding_method(QM::Rounding_method::OUTER_APPROXIMATION));
      assert(best == infinity ? s.status == QM::Mixed_integer_status::INFEASIBLE : is_close(s.energy, best));
    }
  }

  // Real variables with bounds: x real, 0 <= x <= 1/2, y integer, (x - 2)^2 + (y - x - 0.8)^2.
  Problem problem(2);
  problem.set_integer(1);
  problem.set_bounds(0, 0., 0.5);
  problem.add_squared_residual({ { 0, 1. } }, 2.);
  problem.add_squared_residual({ { 1, 1. }, { 0, -1. } }, 0.8);
  for(QM::Rounding_method method : { QM::Rounding_method::BRANCH_AND_BOUND, QM::Rounding_method::BRANCH_AND_CUT,
                                     QM::Rounding_method::OUTER_APPROXIMATION })
  {
    const Solution s = solve_and_check(problem, params::rounding_method(method));
    assert(s.x[1] == 1. && is_close(s.x[0], 0.5) && is_close(s.energy, 2.25 + 0.09));
  }
}

// Integer and mixed-integer linear programs.
void test_linear_programs(CGAL::Random& random)
{
  int feasible = 0, cuts = 0;
  for(int p = 0; p < 300; ++p)
  {
    const int n = random.get_int(1, 5);
    Problem problem(n);
    Eigen::VectorXd b(n);
    std::vector<int> low(n), high(n);
    for(int i = 0; i < n; ++i)
    {
      b[i] = random.get_int(-5, 6);
      problem.set_integer(i);
      low[i] = random.get_int(-4, 1);
      high[i] = low[i] + random.get_int(1, 7);
      problem.set_bounds(i, low[i], high[i]);
    }
    problem.set_energy(Eigen::SparseMatrix<double>(n, n), b);
    std::vector<std::vector<int>> rows;
    for(int c = random.get_int(1, 4); c > 0; --c)
    {
      rows.emplace_back();
      Problem::Linear_form form;
      for(int i = 0; i < n; ++i)
      {
        rows.back().push_back(random.get_int(-6, 10));
        form.emplace_back(i, rows.back().back());
      }
      rows.back().push_back(random.get_int(-6, 16));
      problem.add_inequality_constraint(form, rows.back().back());
    }
    int best = (std::numeric_limits<int>::max)();
    for_each_integer_point(low, high,
                           [&](const std::vector<int>& y)
                           {
                             for(const std::vector<int>& row : rows)
                             {
                               int value = 0;
                               for(int i = 0; i < n; ++i)
                                 value += row[i] * y[i];
                               if(value > row[n])
                                 return;
                             }
                             int energy = 0;
                             for(int i = 0; i < n; ++i)
                               energy -= static_cast<int>(b[i]) * y[i];
                             best = (std::min)(best, energy);
                           });
    const bool is_feasible = best < (std::numeric_limits<int>::max)();
    feasible += is_feasible;
    for(QM::Rounding_method method : { QM::Rounding_method::CUTTING_PLANES, QM::Rounding_method::BRANCH_AND_CUT,
                                       QM::Rounding_method::BRANCH_AND_BOUND })
    {
      const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method));
      assert(s.status == (is_feasible ? QM::Mixed_integer_status::OPTIMAL : QM::Mixed_integer_status::INFEASIBLE));
      if(!is_feasible)
        continue;
      check_solution(problem, s);
      assert(s.energy == best);
      cuts += s.cuts;
    }
  }
  assert(feasible > 100 && cuts > 100);

  // min -x - y, x integer, y real, 2x + 2y <= 5, x - y <= 1/2, 0 <= x, y <= 4: x = 1, y = 3/2 and others of energy
  // -2.5.
  Problem problem(2);
  problem.set_integer(0);
  problem.set_energy(Eigen::SparseMatrix<double>(2, 2), Eigen::Vector2d(1.5, 1.));
  problem.set_bounds(0, 0, 4);
  problem.set_bounds(1, 0, 4);
  problem.add_inequality_constraint({ { 0, 2. }, { 1, 2. } }, 5.);
  problem.add_inequality_constraint({ { 0, 1. }, { 1, -1. } }, 0.25);
  for(QM::Rounding_method method : { QM::Rounding_method::CUTTING_PLANES, QM::Rounding_method::BRANCH_AND_CUT,
                                     QM::Rounding_method::BRANCH_AND_BOUND })
  {
    const Solution s = solve_and_check(problem, params::rounding_method(method));
    assert(s.x[0] == 1. && is_close(s.x[1], 1.5) && is_close(s.energy, -3.));
  }
}

// A grid of reals with integers along some edges: few integers of global influence.
Problem grid_problem(CGAL::Random& random, int width, int integers)
{
  Problem problem(width * width);
  std::vector<int> jumps;
  for(int k = 0; k < integers; ++k)
    jumps.push_back(problem.add_variable(true));
  for_each_grid_edge(width,
                     [&](int, int, bool, Problem::Linear_form form)
                     {
                       if(random.get_int(0, 4) == 0)
                         form.emplace_back(jumps[random.get_int(0, integers)], random.get_int(0, 2) ? 1. : -1.);
                       problem.add_squared_residual(form, uniform(random, -0.7, 0.7));
                     });
  problem.add_equality_constraint({ { 0, 1. } }, 0.);
  return problem;
}

// The levels and backends of greedy rounding agree with naive rounding.
void test_greedy_levels(CGAL::Random& random)
{
  const Problem problem = grid_problem(random, 14, 60);
  const Solution naive = solve_and_check(problem, params::rounding_method(QM::Rounding_method::NAIVE));
  assert(naive.factorization_roundings == naive.free_integers);

  const Solution dense = solve_and_check(problem, params::rounding_method(QM::Rounding_method::GREEDY));
  assert(dense.dense_roundings == 60 && dense.factorizations == 1);
  assert(is_close(dense.energy, naive.energy));

  const Solution local = solve_and_check(problem, params::rounding_method(QM::Rounding_method::GREEDY)
                                                    .maximum_dense_integers(0)
                                                    .rounding_tolerance(1e-9)
                                                    .simultaneous_rounding(false));
  assert(local.gauss_seidel_roundings > 0 && is_close(local.energy, naive.energy));

  const Solution gradient = solve_and_check(problem, params::rounding_method(QM::Rounding_method::GREEDY)
                                                       .maximum_dense_integers(0)
                                                       .rounding_tolerance(1e-9)
                                                       .simultaneous_rounding(false)
                                                       .gauss_seidel_iterations(0)
                                                       .conjugate_gradient_iterations(1000));
  assert(gradient.conjugate_gradient_roundings > 0 && is_close(gradient.energy, naive.energy));

  const Solution simultaneous =
    solve_and_check(problem, params::rounding_method(QM::Rounding_method::GREEDY).maximum_dense_integers(0));
  assert(simultaneous.simultaneous_roundings > 0);
  assert(simultaneous.energy - naive.relaxed_energy < 1.5 * (naive.energy - naive.relaxed_energy));

  const Solution lattice =
    solve_and_check(problem, params::rounding_method(QM::Rounding_method::LATTICE).maximum_number_of_nodes(3e5));
  assert(lattice.energy <= dense.energy + 1e-9 && lattice.lower_bound >= dense.relaxed_energy - 1e-6);
  const Solution again =
    solve_and_check(problem, params::rounding_method(QM::Rounding_method::LATTICE).maximum_number_of_nodes(3e5));
  assert((lattice.x - again.x).cwiseAbs().maxCoeff() == 0.);
}

typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_symmetric_matrix<double>::EigenType>>
  Other_solver;

// Counts what it is asked for.
struct Counting_solver : Other_solver
{
  static int factorizations, solutions;
  bool factor(const Matrix& A, NT& denominator)
  {
    ++factorizations;
    return Other_solver::factor(A, denominator);
  }
  bool linear_solver(const Vector& b, Vector& x)
  {
    ++solutions;
    return Other_solver::linear_solver(b, x);
  }
};
int Counting_solver::factorizations = 0;
int Counting_solver::solutions = 0;

// All methods use the solver of the user, and no other one, with the same result.
void test_other_linear_solver(CGAL::Random& random)
{
  const Problem problem = grid_problem(random, 8, 5);
  for(QM::Rounding_method method :
      { QM::Rounding_method::RELAXED, QM::Rounding_method::DIRECT, QM::Rounding_method::NAIVE,
        QM::Rounding_method::GREEDY, QM::Rounding_method::LATTICE, QM::Rounding_method::BRANCH_AND_BOUND,
        QM::Rounding_method::BRANCH_AND_CUT })
    for(int dense : { 0, 1000 })
    {
      Counting_solver::factorizations = Counting_solver::solutions = 0;
      const Solution own = QM::solve_mixed_integer(
        problem,
        params::rounding_method(method).maximum_dense_integers(dense).rounding_tolerance(1e-9).simultaneous_rounding(
          false));
      assert(Counting_solver::factorizations == 0);
      const Solution other = QM::solve_mixed_integer(problem, params::rounding_method(method)
                                                                .maximum_dense_integers(dense)
                                                                .rounding_tolerance(1e-9)
                                                                .simultaneous_rounding(false)
                                                                .sparse_linear_solver(Counting_solver()));
      assert(own.status == other.status && is_close(own.energy, other.energy) &&
             is_close(own.relaxed_energy, other.relaxed_energy));
      assert(Counting_solver::factorizations == other.factorizations && other.factorizations > 0 &&
             Counting_solver::solutions > 0);
    }
}

// The shape of a field: integers with two neighbors each, which are condensed, and some with more.
void test_leaves(CGAL::Random& random)
{
  const int width = 7;
  for(int trial = 0; trial < 5; ++trial)
  {
    Problem problem(width * width);
    for_each_grid_edge(width,
                       [&](int, int j, bool is_down, Problem::Linear_form form)
                       {
                         if(is_down && j > 0)
                           form.emplace_back(problem.add_variable(true), uniform(random, 0.5, 2.));
                         problem.add_squared_residual(form, uniform(random, -1., 1.));
                       });
    problem.add_squared_residual({ { 0, 1. } }, 0.3);
    problem.add_squared_residual({ { problem.add_variable(true), 1. } }, 0.4); // without neighbors
    if(trial > 2)
      problem.set_integer(3 * width + 3); // itself next to leaves
    const Solution naive = solve_and_check(problem, params::rounding_method(QM::Rounding_method::NAIVE));
    const Solution dense = solve_and_check(problem, params::rounding_method(QM::Rounding_method::GREEDY));
    assert(is_close(naive.energy, dense.energy) && (naive.x - dense.x).cwiseAbs().maxCoeff() < 1e-6);
    const Solution levels = solve_and_check(problem, params::rounding_method(QM::Rounding_method::GREEDY)
                                                       .maximum_dense_integers(0)
                                                       .rounding_tolerance(1e-11)
                                                       .simultaneous_rounding(false)
                                                       .gauss_seidel_iterations(10000000));
    assert(is_close(naive.energy, levels.energy) && is_close(naive.relaxed_energy, levels.relaxed_energy));
    assert(levels.gauss_seidel_roundings > 0);
    const Solution coarse =
      solve_and_check(problem, params::rounding_method(QM::Rounding_method::GREEDY).maximum_dense_integers(0));
    assert(coarse.energy < 1.5 * naive.energy);
  }

  // Nothing but leaves.
  Problem leaves(3);
  for(int i = 0; i < 3; ++i)
  {
    leaves.set_integer(i);
    leaves.add_squared_residual({ { i, 2. } }, 1.4 + i);
  }
  const Solution rounded =
    solve_and_check(leaves, params::rounding_method(QM::Rounding_method::GREEDY).maximum_dense_integers(0));
  assert(rounded.x[0] == 1. && rounded.x[1] == 1. && rounded.x[2] == 2.);
}

// Independent components add up, and many integers are decoded in blocks.
void test_lattice_of_many_integers(CGAL::Random& random)
{
  const Problem part = grid_problem(random, 10, 30);
  const Solution one = solve_and_check(part, params::rounding_method(QM::Rounding_method::LATTICE));
  const Eigen::SparseMatrix<double> A = part.matrix();
  const int n = part.number_of_variables(), copies = 3;
  std::vector<Eigen::Triplet<double>> triplets;
  Eigen::VectorXd b(copies * n);
  Problem whole(copies * n);
  for(int c = 0; c < copies; ++c)
  {
    for(int j = 0; j < n; ++j)
    {
      for(Eigen::SparseMatrix<double>::InnerIterator it(A, j); it; ++it)
        triplets.emplace_back(c * n + static_cast<int>(it.row()), c * n + j, it.value());
      whole.set_integer(c * n + j, part.is_integer(j));
    }
    b.segment(c * n, n) = part.linear_term();
  }
  Eigen::SparseMatrix<double> all(copies * n, copies * n);
  all.setFromTriplets(triplets.begin(), triplets.end());
  whole.set_energy(all, b, copies * part.constant());
  for(int c = 0; c < copies; ++c)
    whole.add_equality_constraint({ { c * n, 1. } }, 0.);
  const Solution three =
    solve_and_check(whole, params::rounding_method(QM::Rounding_method::LATTICE).maximum_number_of_nodes(9e7));
  assert(one.status == QM::Mixed_integer_status::OPTIMAL && three.status == QM::Mixed_integer_status::OPTIMAL);
  assert(is_close(three.energy, copies * one.energy));

  // Residuals of a few integers each: strongly coupled, too many for a proof or even to be decoded as a whole.
  for(int integers : { 220, 440 })
  {
    Problem large(integers);
    for(int i = 0; i < integers; ++i)
    {
      large.set_integer(i);
      large.add_squared_residual({ { i, 1. } }, uniform(random, -2., 2.), 0.02);
    }
    for(int k = 0; k < integers; ++k)
    {
      Problem::Linear_form form;
      for(int i = 0; i < 6; ++i)
        form.emplace_back(random.get_int(0, integers), uniform(random, -1., 1.));
      large.add_squared_residual(form, uniform(random, -2., 2.));
    }
    const Solution greedy = solve_and_check(large, params::rounding_method(QM::Rounding_method::GREEDY));
    const Solution lattice =
      solve_and_check(large, params::rounding_method(QM::Rounding_method::LATTICE).maximum_number_of_nodes(1e6));
    assert(lattice.energy < greedy.energy);
    assert(lattice.lower_bound >= lattice.relaxed_energy && lattice.lower_bound <= lattice.energy);
  }
}

// With few nodes the bound must not exceed the optimum. Bases that are almost orthogonal have larger trees than the
// Gaussian heuristic says.
void test_lattice_bounds(CGAL::Random& random)
{
  for(double coupling : { 0., 0.05, 0.3 })
    for(int trial = 0; trial < 5; ++trial)
    {
      const int integers = 24;
      Problem problem(integers);
      for(int i = 0; i < integers; ++i)
      {
        problem.set_integer(i);
        problem.add_squared_residual({ { i, 1. } }, uniform(random, -2., 2.), uniform(random, 0.1, 3.));
        for(int j = 0; j < i; ++j)
          if(coupling > 0)
            problem.add_squared_residual({ { i, 1. }, { j, uniform(random, -1., 1.) } }, 0.,
                                         coupling * random.get_double());
      }
      const Solution optimum =
        solve_and_check(problem, params::rounding_method(QM::Rounding_method::LATTICE).maximum_number_of_nodes(1e9));
      assert(optimum.status == QM::Mixed_integer_status::OPTIMAL);
      for(double nodes : { 0., 100., 2e4, 1e5 })
      {
        const Solution s = solve_and_check(
          problem, params::rounding_method(QM::Rounding_method::LATTICE).maximum_number_of_nodes(nodes));
        assert(s.energy >= optimum.energy - 1e-9 && s.lower_bound <= optimum.energy + 1e-9);
        assert(s.status != QM::Mixed_integer_status::OPTIMAL || is_close(s.energy, optimum.energy));
      }
    }
}

// A lattice with a triangular factor and a point to find neighbors of.
struct Lattice
{
  Eigen::MatrixXd R;
  Eigen::VectorXd target;

  Lattice(CGAL::Random& random, int size, double coupling) : R(Eigen::MatrixXd::Zero(size, size)), target(size)
  {
    for(int i = 0; i < size; ++i)
    {
      R(i, i) = uniform(random, 0.5, 2.);
      for(int j = i + 1; j < size; ++j)
        R(i, j) = coupling * uniform(random, -1., 1.);
      target[i] = uniform(random, -3., 3.);
    }
  }

  double squared_distance() const
  {
    double radius = std::numeric_limits<double>::infinity();
    QM::internal::Lattice_enumeration(R, target).run(radius, 1e8, []() { return true; });
    return radius;
  }

  double bound(double known, int rounds) const
  {
    return QM::internal::Lattice_bound(R, target, known).run(rounds, []() { return true; });
  }
};

// The bound by relaxation lies below the nearest lattice point and not far below, whatever the scale, even if only a
// farther point is known.
void test_relaxed_bounds(CGAL::Random& random)
{
  double product = 1;
  int trials = 0;
  for(int size : { 1, 2, 3, 5, 8, 20 })
    for(double coupling : { 0., 0.5, 2. })
      for(int trial = 0; trial < 8; ++trial, ++trials)
      {
        Lattice lattice(random, size, coupling);
        const double truth = lattice.squared_distance(), bound = lattice.bound(truth, 8);
        assert(bound <= truth * (1 + 1e-12) && bound > 0.5 * truth);
        assert(lattice.bound(3 * truth, 8) <= truth * (1 + 1e-12));
        product *= std::pow(bound / truth, 1. / 144);
        lattice.R *= 1e-5;
        assert(is_close(1e10 * lattice.bound(1e-10 * truth, 8), bound));
      }
  std::cout << "  " << trials << " lattices, mean ratio to the truth " << product << std::endl;
  assert(trials == 144 && product > 0.95);

  // In the middle between the points of the lattice of integers; no enumeration could prove that.
  const int size = 90;
  Lattice cubic(random, size, 0.);
  cubic.R.setIdentity();
  cubic.target.setConstant(0.5);
  const double bound = cubic.bound(size * 0.25, 1);
  assert(bound > 0.998 * size * 0.25 && bound <= size * 0.25);
  assert(cubic.bound(size * 0.25, 0) == 0);

  // Few nodes leave a gap that the relaxation narrows.
  const Problem problem = grid_problem(random, 20, 100);
  const auto few_nodes = params::rounding_method(QM::Rounding_method::LATTICE).maximum_number_of_nodes(2e4);
  const Solution s = solve_and_check(problem, few_nodes),
                 t = solve_and_check(problem, few_nodes.number_of_bound_rounds(6));
  const Solution best = solve_and_check(problem, params::rounding_method(QM::Rounding_method::LATTICE));
  std::cout << "  relaxed " << s.relaxed_energy << ", enumeration " << s.lower_bound << ", relaxation " << t.lower_bound
            << ", best known " << best.energy << std::endl;
  assert(s.status == QM::Mixed_integer_status::FEASIBLE && t.energy == s.energy && t.lower_bound <= best.energy);
  assert(best.energy - t.lower_bound < 0.4 * (best.energy - s.lower_bound));
}

// The energy over the integers is the energy of the whole with the best real variables.
void test_integer_energy(CGAL::Random& random)
{
  for(int trial = 0; trial < 20; ++trial)
  {
    const Problem problem = random_problem(random, random.get_int(0, 6), random.get_int(0, 6));
    const int n = problem.number_of_variables();
    std::vector<bool> is_integer;
    for(int i = 0; i < n; ++i)
      is_integer.push_back(problem.is_integer(i));
    const Eigen::SparseMatrix<double> A = problem.matrix();
    const Eigen::VectorXd b = problem.linear_term();
    QM::Integer_energy energy, factorized;
    assert(energy.compute(A, b, is_integer) && factorized.factorize(A, b, is_integer));
    assert(energy.size() == problem.number_of_integers());
    assert(energy.integers().size() + energy.reals().size() == is_integer.size());

    Eigen::VectorXd y(energy.size());
    for(int i = 0; i < energy.size(); ++i)
    {
      assert(is_integer[energy.integers()[i]]);
      y[i] = random.get_int(-3, 4);
    }
    const Eigen::VectorXd x = energy.complete(y);
    assert((x - factorized.complete(y)).norm() < 1e-9 && (energy.integers_of(x) - y).norm() == 0.);
    const Eigen::VectorXd gradient = A * x - b;
    for(int i : energy.reals())
      assert(std::fabs(gradient[i]) < 1e-6 * (1. + b.norm() + y.norm()));
    const double whole = problem.energy(x) - problem.constant();
    assert(is_close(energy.energy(x), whole));
    assert(is_close(energy.relaxed_energy() + energy.cost(y), whole));
    assert(is_close(energy.problem().energy(y), whole));
    const Solution reduced =
      QM::solve_mixed_integer(energy.problem(), params::rounding_method(QM::Rounding_method::LATTICE));
    const Solution solution = QM::solve_mixed_integer(problem, params::rounding_method(QM::Rounding_method::LATTICE));
    assert(is_close(reduced.energy + problem.constant(), solution.energy));
    assert(is_close(reduced.relaxed_energy + problem.constant(), solution.relaxed_energy));
  }
}

void test_special_cases()
{
  // No variable at all.
  assert(QM::solve_mixed_integer(Problem()).status == QM::Mixed_integer_status::OPTIMAL);

  // No integer.
  Problem real(2);
  real.add_squared_residual({ { 0, 1. }, { 1, 1. } }, 3.);
  real.add_squared_residual({ { 0, 1. }, { 1, -1. } }, 1.);
  for(QM::Rounding_method method :
      { QM::Rounding_method::RELAXED, QM::Rounding_method::DIRECT, QM::Rounding_method::NAIVE,
        QM::Rounding_method::GREEDY, QM::Rounding_method::LATTICE, QM::Rounding_method::BRANCH_AND_BOUND,
        QM::Rounding_method::BRANCH_AND_CUT, QM::Rounding_method::OUTER_APPROXIMATION })
  {
    const Solution s = QM::solve_mixed_integer(real, params::rounding_method(method));
    assert(s.status == QM::Mixed_integer_status::OPTIMAL && is_close(s.x[0], 2.) && is_close(s.x[1], 1.));
  }

  // Energies without a unique minimum get one of them; concave ones are refused.
  Problem flat(2);
  flat.set_integer(1);
  flat.add_squared_residual({ { 0, 1. }, { 1, -1. } }, 0.5);
  const Solution s = QM::solve_mixed_integer(flat);
  check_solution(flat, s);
  assert(std::fabs(s.energy) < 1e-6);
  Eigen::SparseMatrix<double> negative(2, 2);
  negative.insert(0, 0) = -1.;
  negative.insert(1, 1) = 1.;
  Problem concave(2);
  concave.set_energy(negative, Eigen::Vector2d(0., 0.));
  for(QM::Rounding_method method : { QM::Rounding_method::RELAXED, QM::Rounding_method::DIRECT,
                                     QM::Rounding_method::GREEDY, QM::Rounding_method::LATTICE })
    assert(QM::solve_mixed_integer(concave, params::rounding_method(method)).status ==
           QM::Mixed_integer_status::NUMERICAL_FAILURE);

  Problem nan(1);
  nan.add_squared_residual({ { 0, std::numeric_limits<double>::quiet_NaN() } }, 0.);
  assert(QM::solve_mixed_integer(nan).status == QM::Mixed_integer_status::NUMERICAL_FAILURE);

  // What a method cannot treat is said so.
  Problem bounded(1);
  bounded.set_integer(0);
  bounded.set_bounds(0, 0, 1);
  bounded.add_squared_residual({ { 0, 1. } }, 2.6);
  assert(QM::solve_mixed_integer(bounded, params::rounding_method(QM::Rounding_method::GREEDY)).status ==
         QM::Mixed_integer_status::UNSUPPORTED_PROBLEM);
  assert(QM::solve_mixed_integer(bounded, params::rounding_method(QM::Rounding_method::CUTTING_PLANES)).status ==
         QM::Mixed_integer_status::UNSUPPORTED_PROBLEM);
  assert(QM::solve_mixed_integer(bounded).x[0] == 1.);

  // An unbounded linear program.
  Problem unbounded(1);
  unbounded.set_integer(0);
  unbounded.set_energy(Eigen::SparseMatrix<double>(1, 1), Eigen::VectorXd::Ones(1));
  assert(QM::solve_mixed_integer(unbounded, params::rounding_method(QM::Rounding_method::BRANCH_AND_CUT)).status ==
         QM::Mixed_integer_status::UNBOUNDED);
}

const QM::Rounding_method all_methods[] = {
  QM::Rounding_method::RELAXED,        QM::Rounding_method::DIRECT,         QM::Rounding_method::NAIVE,
  QM::Rounding_method::GREEDY,         QM::Rounding_method::LATTICE,        QM::Rounding_method::BRANCH_AND_BOUND,
  QM::Rounding_method::BRANCH_AND_CUT, QM::Rounding_method::CUTTING_PLANES, QM::Rounding_method::OUTER_APPROXIMATION
};

Eigen::SparseMatrix<double> sparse(const Eigen::MatrixXd& A) { return A.sparseView(); }

// Problems without curvature, in all or in some directions, with and without a minimum.
void test_flat_problems()
{
  for(QM::Rounding_method method : all_methods)
  {
    Problem zero(3);
    zero.set_integer(0);
    for(const Solution& s :
        { QM::solve_mixed_integer(zero, params::rounding_method(method)),
          QM::solve_mixed_integer(zero, params::rounding_method(method).maximum_dense_integers(0)),
          QM::solve_mixed_integer(zero, params::rounding_method(method).sparse_linear_solver(Other_solver())) })
      assert(s.status == QM::Mixed_integer_status::OPTIMAL && s.energy == 0. && s.x.size() == 3);

    Problem steep(2);
    steep.set_integer(0);
    steep.set_energy(Eigen::SparseMatrix<double>(2, 2), Eigen::Vector2d(0., -1.));
    assert(QM::solve_mixed_integer(steep, params::rounding_method(method)).status ==
           QM::Mixed_integer_status::UNBOUNDED);

    if(method == QM::Rounding_method::CUTTING_PLANES)
      continue;
    for(int integers : { 0, 1, 2 })
    {
      Problem valley(2);
      for(int i = 0; i < integers; ++i)
        valley.set_integer(i);
      valley.set_energy(sparse((Eigen::Matrix2d() << 1, -1, -1, 1).finished()), Eigen::Vector2d(1., 1.));
      assert(QM::solve_mixed_integer(valley, params::rounding_method(method)).status ==
             QM::Mixed_integer_status::UNBOUNDED);
      // A constraint closes it.
      valley.add_equality_constraint({ { 0, 1. }, { 1, 1. } }, 4.);
      const Solution s = QM::solve_mixed_integer(valley, params::rounding_method(method));
      assert(s.status == QM::Mixed_integer_status::OPTIMAL && is_close(s.x[0], 2.) && is_close(s.x[1], 2.));
    }
    // A minimum far away is one.
    Problem far(2);
    far.set_integer(0);
    far.set_energy(sparse(Eigen::Matrix2d::Identity()), Eigen::Vector2d(1e9 + 0.25, 3e9));
    const Solution s = QM::solve_mixed_integer(far, params::rounding_method(method));
    assert(s.is_valid() && std::fabs(s.x[0] - 1e9) < 0.3 && is_close(s.x[1], 3e9));
  }
}

// Inequalities over integers whose coefficients are fractions, and bounds that make no sense.
void test_fractional_inequalities()
{
  for(QM::Rounding_method method : { QM::Rounding_method::BRANCH_AND_BOUND, QM::Rounding_method::BRANCH_AND_CUT,
                                     QM::Rounding_method::CUTTING_PLANES, QM::Rounding_method::OUTER_APPROXIMATION })
  {
    Problem problem(2);
    problem.set_integer(0);
    problem.set_integer(1);
    problem.set_energy(Eigen::SparseMatrix<double>(2, 2), Eigen::Vector2d(5.5, 4.1));
    problem.add_inequality_constraint({ { 0, 0.6 }, { 1, 0.4 } }, 2.4);
    problem.add_inequality_constraint({ { 0, 0.1 }, { 1, 0.2 } }, 0.65);
    problem.set_bounds(0, 0., Problem::infinity());
    problem.set_bounds(1, 0., Problem::infinity());
    const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method).maximum_number_of_nodes(1000));
    assert(s.status == QM::Mixed_integer_status::OPTIMAL && s.x[0] == 4. && s.x[1] == 0. && is_close(s.energy, -22.));

    // An even number between 0.5 and 1.5, on an unbounded strip.
    Problem strip(2);
    strip.set_integer(0);
    strip.set_integer(1);
    strip.set_energy(Eigen::SparseMatrix<double>(2, 2), Eigen::Vector2d(1., -1.));
    strip.add_inequality_constraint({ { 0, 2. }, { 1, -2. } }, 1.5);
    strip.add_inequality_constraint({ { 0, -2. }, { 1, 2. } }, -0.5);
    strip.set_bounds(0, 0., Problem::infinity());
    assert(QM::solve_mixed_integer(strip, params::rounding_method(method)).status ==
           QM::Mixed_integer_status::INFEASIBLE);

    Problem senseless(1);
    senseless.set_integer(0);
    senseless.set_bounds(0, Problem::infinity(), Problem::infinity());
    assert(QM::solve_mixed_integer(senseless, params::rounding_method(method)).status ==
           QM::Mixed_integer_status::INFEASIBLE);
    senseless.set_bounds(0, 0., std::numeric_limits<double>::quiet_NaN());
    assert(QM::solve_mixed_integer(senseless, params::rounding_method(method)).status ==
           QM::Mixed_integer_status::NUMERICAL_FAILURE);
  }
}

void test_matrix_market()
{
  const auto read = [](const std::string& text, Eigen::SparseMatrix<double>& matrix)
  {
    std::istringstream in(text);
    std::string message;
    const bool ok = QM::read_matrix_market(in, matrix, message);
    assert(ok == message.empty());
    return ok;
  };
  Eigen::SparseMatrix<double> M;
  assert(read("%%MatrixMarket matrix coordinate real symmetric\n% c\n2 2 2\n1 1 4\n2 1 -1e0\n", M));
  assert(M.coeff(0, 0) == 4. && M.coeff(0, 1) == -1. && M.coeff(1, 0) == -1. && M.coeff(1, 1) == 0.);
  assert(read("%%MatrixMarket matrix array real general\n2 1\n3\n5\n", M));
  assert(M.rows() == 2 && M.cols() == 1 && M.coeff(0, 0) == 3. && M.coeff(1, 0) == 5.);
  for(const char* text : { "", "garbage", "%%MatrixMarket matrix coordinate complex general\n1 1 0\n",
                           "%%MatrixMarket matrix coordinate real general\n2 2\n",
                           "%%MatrixMarket matrix coordinate real general\n2 2 1\n3 1 1\n",
                           "%%MatrixMarket matrix coordinate real general\n2 2 2\n1 1 1\n",
                           "%%MatrixMarket matrix coordinate real general\n1 1 1\n1 1 nan\n",
                           "%%MatrixMarket matrix coordinate real symmetric\n1 2 0\n" })
  {
    assert(!read(text, M));
    assert(M.rows() == 2); // as it was
  }
}

// Every case has the same random numbers, whichever cases are run.
template <typename Test>
Test_case with_random_numbers(const char* name, const Test& test)
{
  return { name, [test]()
           {
             CGAL::Random random(7);
             test(random);
           } };
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   {
                     { "elimination", test_elimination },
                     { "matrix_market", test_matrix_market },
                     { "special_cases", test_special_cases },
                     { "flat_problems", test_flat_problems },
                     { "fractional_inequalities", test_fractional_inequalities },
                     with_random_numbers("against_brute_force", test_against_brute_force),
                     with_random_numbers("linear_programs", test_linear_programs),
                     with_random_numbers("inequalities", test_inequalities),
                     with_random_numbers("greedy_levels", test_greedy_levels),
                     with_random_numbers("leaves", test_leaves),
                     with_random_numbers("lattice_of_many_integers", test_lattice_of_many_integers),
                     with_random_numbers("lattice_bounds", test_lattice_bounds),
                     with_random_numbers("relaxed_bounds", test_relaxed_bounds),
                     with_random_numbers("integer_energy", test_integer_energy),
                     with_random_numbers("other_linear_solver", test_other_linear_solver),
                   });
}
