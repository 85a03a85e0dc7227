// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Convex constraints: the convex methods against a brute force over all integers.

#include "mixed_integer_checks.h"
#include "test_cases.h"

// The test checks itself by assertions.
#ifdef NDEBUG
#undef NDEBUG
#endif

#include <CGAL/Quad_meshing/Mixed_integer/find_feasible_point.h>

#include <CGAL/Random.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

const Method methods[] = { Method::BRANCH_AND_BOUND, Method::BRANCH_AND_CUT, Method::CUTTING_PLANES,
                           Method::OUTER_APPROXIMATION };

Eigen::SparseMatrix<double> diagonal(const std::vector<double>& d)
{
  Eigen::SparseMatrix<double> D(static_cast<int>(d.size()), static_cast<int>(d.size()));
  for(int i = 0; i < D.rows(); ++i)
    if(d[i] != 0.)
      D.insert(i, i) = d[i];
  return D;
}

double largest_violation(const Problem& problem, const Eigen::VectorXd& x)
{
  double largest = 0.;
  for(const Problem::Convex_constraint& c : problem.convex_constraints())
  {
    Eigen::VectorXd values(c.variables.size()), gradient(c.variables.size());
    for(int i = 0; i < values.size(); ++i)
      values[i] = x[c.variables[i]];
    largest = (std::max)(largest, c.function(values, gradient));
  }
  return largest;
}

Solution solve(const Problem& problem, Method method)
{
  return QM::solve_mixed_integer(problem, params::rounding_method(method));
}

// The point of a disk that is nearest to a point outside, and the best integers in it.
void disk()
{
  for(bool are_integers : { false, true })
    for(Method method : methods)
    {
      Problem problem(2);
      problem.add_squared_residual({ { 0, 1. } }, 6.);
      problem.add_squared_residual({ { 1, 1. } }, 8.);
      problem.set_integer(0, are_integers);
      problem.set_integer(1, are_integers);
      problem.add_quadratic_constraint(diagonal({ 2., 2. }), {}, 20.); // x^2 + y^2 <= 20
      const Solution s = solve(problem, method);
      assert(s.status == Status::OPTIMAL && s.lower_bound <= s.energy);
      if(are_integers) // (2, 4) is on the circle, at 16 + 16; (3, 3) is at 9 + 25
        assert(s.x[0] == 2. && s.x[1] == 4. && is_close(s.energy, 32.));
      else
        assert(is_close(s.energy, std::pow(10. - std::sqrt(20.), 2)) && is_close(s.x[0], 0.6 * std::sqrt(20.), 1e-3));
    }
}

// Linear energies, which only the convex constraint keeps from falling for ever.
void linear_energy()
{
  for(Method method : methods)
  {
    Problem problem(2);
    problem.set_energy(Eigen::SparseMatrix<double>(2, 2), vector({ 1., 2. })); // maximize x + 2y
    problem.set_integer(0);
    problem.add_quadratic_constraint(diagonal({ 2., 2. }), {}, 10.);
    // x = 1, y = 3 gives 7; x = 2, y = sqrt 6 gives 6.9
    const Solution s = solve(problem, method);
    assert(s.status == Status::OPTIMAL && s.x[0] == 1. && is_close(s.energy, -7.));
  }
}

// Functors: exp(x) + exp(-y) <= 10 with a slope that overflows far away, and log-sum-exp.
void functors()
{
  for(Method method : methods)
  {
    Problem problem(2);
    problem.set_energy(Eigen::SparseMatrix<double>(2, 2), vector({ 1., -0.01 }));
    problem.set_integer(0);
    problem.add_convex_constraint({ 0, 1 },
                                  [](const Eigen::VectorXd& x, Eigen::VectorXd& gradient)
                                  {
                                    gradient.resize(2);
                                    gradient << std::exp(x[0]), -std::exp(-x[1]);
                                    return std::exp(x[0]) + std::exp(-x[1]) - 10.;
                                  });
    // maximize x - 0.01 y: x = 2, exp(-y) = 10 - e^2
    const Solution s = solve(problem, method);
    assert(s.status == Status::OPTIMAL && s.x[0] == 2.);
    assert(is_close(s.energy, -2. - 0.01 * std::log(10. - std::exp(2.))));
  }
}

// What has no point: at all, or no integer one; and what is not convex, or has no finite values.
void refusals()
{
  for(Method method : methods)
  {
    Problem empty(2);
    empty.add_squared_residual({ { 0, 1. }, { 1, 1. } }, 1.);
    empty.add_quadratic_constraint(diagonal({ 2., 2. }), { { 0, -6. } }, -8.); // (x - 3)^2 + y^2 <= 1
    empty.add_inequality_constraint({ { 0, 1. } }, 1.5);
    assert(solve(empty, method).status == Status::INFEASIBLE);

    Problem between(2);
    between.add_squared_residual({ { 0, 1. }, { 1, 1. } }, 1.);
    between.set_integer(0);
    between.set_integer(1);
    between.add_quadratic_constraint(diagonal({ 2., 2. }), { { 0, -1. }, { 1, -1. } }, -0.4); // around (1/2, 1/2)
    assert(solve(between, method).status == Status::INFEASIBLE);

    Problem saddle(2);
    saddle.add_quadratic_constraint(diagonal({ 2., -2. }), {}, 1.);
    assert(solve(saddle, method).status == Status::NUMERICAL_FAILURE);

    Problem broken(1);
    broken.add_convex_constraint(
      { 0 }, [](const Eigen::VectorXd&, Eigen::VectorXd&) { return std::numeric_limits<double>::quiet_NaN(); });
    assert(solve(broken, method).status == Status::NUMERICAL_FAILURE);
  }
  Problem disk(1);
  disk.add_quadratic_constraint(diagonal({ 2. }), {}, 1.);
  assert(solve(disk, Method::GREEDY).status == Status::UNSUPPORTED_PROBLEM);
  const Solution by_default = QM::solve_mixed_integer(disk);
  assert(by_default.status == Status::OPTIMAL);
}

struct Ellipsoid
{
  Eigen::MatrixXd H;
  Eigen::VectorXd center;
  double radius; // (x - center)' H (x - center) <= radius
};

// Small random problems over integers in a box, with one or two ellipsoids: all points are tried.
void random_integers()
{
  CGAL::Random random(23);
  const int reach = 3;
  int infeasible = 0, total = 0;
  for(int trial = 0; trial < 80; ++trial)
  {
    const int n = random.get_int(1, 4), count = random.get_int(1, 3);
    Eigen::MatrixXd F(n, n);
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
        F(i, j) = random.get_int(-2, 3);
    const bool is_linear = random.get_int(0, 4) == 0;
    const Eigen::MatrixXd A =
      is_linear ? Eigen::MatrixXd(Eigen::MatrixXd::Zero(n, n)) : Eigen::MatrixXd(F.transpose() * F);
    Eigen::VectorXd b(n);
    for(double& v : b)
      v = random.get_double(-6., 6.);
    Problem problem(n);
    problem.set_energy(A.sparseView(), b);
    for(int i = 0; i < n; ++i)
    {
      problem.set_integer(i);
      problem.set_bounds(i, -reach, reach);
    }
    std::vector<Ellipsoid> ellipsoids(count);
    for(Ellipsoid& e : ellipsoids)
    {
      Eigen::MatrixXd G(n, n);
      e.center.resize(n);
      for(int i = 0; i < n; ++i)
      {
        e.center[i] = random.get_double(-2., 2.);
        for(int j = 0; j < n; ++j)
          G(i, j) = random.get_double(-1., 1.);
      }
      e.H = G.transpose() * G;
      e.radius = random.get_double(0.02, 3.);
      // 1/2 x'(2H)x - 2c'H x <= r - c'Hc
      Problem::Linear_form form;
      const Eigen::VectorXd Hc = e.H * e.center;
      for(int i = 0; i < n; ++i)
        form.emplace_back(i, -2. * Hc[i]);
      problem.add_quadratic_constraint(Eigen::MatrixXd(2. * e.H).sparseView(), form, e.radius - e.center.dot(Hc));
    }
    // All points; no decision is a matter of round-off.
    double best = infinity;
    bool is_clear = true;
    Eigen::VectorXd x = Eigen::VectorXd::Constant(n, -reach);
    for(;;)
    {
      bool is_inside = true;
      for(const Ellipsoid& e : ellipsoids)
      {
        const double value = (x - e.center).dot(e.H * (x - e.center)) - e.radius;
        is_clear = is_clear && std::fabs(value) > 1e-4;
        is_inside = is_inside && value <= 0.;
      }
      if(is_inside)
        best = (std::min)(best, x.dot(0.5 * (A * x) - b));
      int i = 0;
      for(; i < n && x[i] == reach; ++i)
        x[i] = -reach;
      if(i == n)
        break;
      ++x[i];
    }
    if(!is_clear)
      continue;
    ++total;
    infeasible += best == infinity;
    for(Method method : methods)
    {
      const Solution s = solve(problem, method);
      if(best == infinity)
        assert(s.status == Status::INFEASIBLE);
      else
      {
        assert(s.status == Status::OPTIMAL && is_close(s.energy, best) && largest_violation(problem, s.x) <= 1e-5);
        assert(s.lower_bound <= best + 1e-6 * (1. + std::fabs(best)));
      }
    }
  }
  std::cout << total << " problems, " << infeasible << " of them infeasible" << std::endl;
  assert(total > 60 && infeasible > 3 && infeasible < total / 2);
}

// Two integers and a real in a ball: for given integers the best real is known in closed form.
void random_reals()
{
  CGAL::Random random(29);
  const int reach = 4;
  for(int trial = 0; trial < 60; ++trial)
  {
    const double r = random.get_double(0.3, 10.), slope = random.get_double(-3., 3.),
                 target = random.get_double(-4., 4.);
    double a[2], c[3];
    for(double& v : a)
      v = random.get_double(-4., 4.);
    for(double& v : c)
      v = random.get_double(-1., 1.);
    // 1/2 (x - a0)^2 + 1/2 (y - a1)^2 + 1/2 (z - target)^2 + slope x z, convexified by 5 x^2
    Problem problem(3);
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(3, 3);
    A(0, 0) += 10.;
    A(0, 2) = A(2, 0) = slope;
    problem.set_energy(A.sparseView(), vector({ a[0], a[1], target }));
    problem.set_integer(0);
    problem.set_integer(1);
    problem.add_quadratic_constraint(diagonal({ 2., 2., 2. }),
                                     { { 0, -2. * c[0] }, { 1, -2. * c[1] }, { 2, -2. * c[2] } },
                                     r - c[0] * c[0] - c[1] * c[1] - c[2] * c[2]);
    double best = infinity;
    for(int x = -reach; x <= reach; ++x)
      for(int y = -reach; y <= reach; ++y)
      {
        const double rest = r - std::pow(x - c[0], 2) - std::pow(y - c[1], 2);
        if(rest < 0.)
          continue;
        const double half = std::sqrt(rest);
        const double z = (std::max)(c[2] - half, (std::min)(c[2] + half, target - slope * x));
        const Eigen::Vector3d p(x, y, z);
        best = (std::min)(best, p.dot(0.5 * (A * p) - Eigen::Vector3d(a[0], a[1], target)));
      }
    for(Method method : methods)
    {
      const Solution s = solve(problem, method);
      if(best == infinity)
        assert(s.status == Status::INFEASIBLE);
      else
        assert(s.status == Status::OPTIMAL && is_close(s.energy, best) && s.lower_bound <= best + 1e-6);
    }
  }
}

// All rules of branching, and all orders of subproblems, end at the same optimum.
void rules()
{
  Problem problem(4);
  for(int i = 0; i < 4; ++i)
  {
    problem.set_integer(i);
    problem.add_squared_residual({ { i, 1. }, { (i + 1) % 4, 0.4 } }, 2.3 + i);
  }
  problem.add_quadratic_constraint(diagonal({ 2., 2., 4., 2. }), {}, 17.5);
  double best = infinity;
  for(int code = 0; code < 10000; ++code)
  {
    Eigen::VectorXd x =
      vector({ double(code % 10), double(code / 10 % 10), double(code / 100 % 10), double(code / 1000) });
    x.array() -= 5.;
    if(x[0] * x[0] + x[1] * x[1] + 2. * x[2] * x[2] + x[3] * x[3] <= 17.5)
      best = (std::min)(best, problem.energy(x));
  }
  for(QM::Branching_rule rule :
      { QM::Branching_rule::MINIMUM_INFEASIBILITY, QM::Branching_rule::MAXIMUM_INFEASIBILITY,
        QM::Branching_rule::PSEUDO_COSTS, QM::Branching_rule::MAXIMUM_THEN_MINIMUM_INFEASIBILITY,
        QM::Branching_rule::MINIMUM_PSEUDO_COSTS, QM::Branching_rule::MAXIMUM_PSEUDO_COSTS })
    for(QM::Subproblem_selection selection :
        { QM::Subproblem_selection::BEST_BOUND, QM::Subproblem_selection::DEPTH_FIRST,
          QM::Subproblem_selection::BEST_ESTIMATE })
    {
      const Solution s = QM::solve_mixed_integer(
        problem,
        params::rounding_method(Method::BRANCH_AND_BOUND).branching_rule(rule).subproblem_selection(selection));
      assert(s.status == Status::OPTIMAL && is_close(s.energy, best));
    }
}

// x^2 + y^2 + ... <= r^2 around a center.
void add_ball(Problem& problem, const std::vector<double>& center, double squared_radius)
{
  Problem::Linear_form form;
  double square = 0.;
  for(std::size_t i = 0; i < center.size(); ++i)
  {
    form.emplace_back(static_cast<int>(i), -2. * center[i]);
    square += center[i] * center[i];
  }
  problem.add_quadratic_constraint(diagonal(std::vector<double>(center.size(), 2.)), form, squared_radius - square);
}

// The feasibility problem where the smallest excess can be computed by hand: between half-spaces, disks and integers.
void feasible_points()
{
  Problem slab(2);
  slab.add_inequality_constraint({ { 0, 1. }, { 1, 1. } }, 1.);
  slab.add_inequality_constraint({ { 0, -1. }, { 1, -1. } }, -3.);
  const QM::Feasible_point between = QM::find_feasible_point(slab);
  assert(between.status == Status::INFEASIBLE && !between.message.empty() && !between.is_valid());
  assert(is_close(between.violation, 1.) && is_close(between.lower_bound, 1.) && is_close(between.x.sum(), 2.));

  slab.add_equality_constraint({ { 0, 1. } }, 7.);
  slab.set_bounds(1, 2., 9.);
  const QM::Feasible_point bounded = QM::find_feasible_point(slab); // x = 7, y >= 2: by 8 over the first
  assert(bounded.status == Status::INFEASIBLE && bounded.x[0] == 7. && is_close(bounded.x[1], 2.));
  assert(is_close(bounded.violation, 8.) && is_close(bounded.lower_bound, 8.));
  slab.add_equality_constraint({ { 1, 1. } }, 1.);
  const QM::Feasible_point none = QM::find_feasible_point(slab);
  assert(none.status == Status::INFEASIBLE && none.x.size() == 0);

  for(double distance : { 1.9, 4. })
  {
    Problem disks(2);
    add_ball(disks, { 0., 0. }, 1.);
    add_ball(disks, { distance, 0. }, 1.);
    const QM::Feasible_point p = QM::find_feasible_point(disks);
    assert(p.is_valid() == (distance < 2.));
    if(p.is_valid())
      assert(largest_violation(disks, p.x) <= 1e-6 && p.lower_bound == 0.);
    else // in the middle
      assert(p.status == Status::INFEASIBLE && is_close(p.violation, 3.) && is_close(p.lower_bound, 3.) &&
             is_close(p.x[0], 2., 1e-3) && p.lower_bound <= p.violation && p.cuts > 0);
  }

  Problem gap(2);
  gap.set_integer(0);
  gap.set_integer(1);
  add_ball(gap, { 0.5, 0.5 }, 0.3);
  assert(QM::find_feasible_point(gap).is_valid()); // integers are reals
  for(Method method : methods)
  {
    const QM::Feasible_point p = QM::find_feasible_point(gap, params::rounding_method(method));
    assert(p.status == Status::INFEASIBLE && is_close(p.violation, 0.2) && is_close(p.lower_bound, 0.2));
    assert(p.x[0] == std::floor(p.x[0]) && p.x[1] == std::floor(p.x[1]));
  }
  add_ball(gap, { 0.6, 0.5 }, 0.7);
  assert(QM::find_feasible_point(gap, params::rounding_method(Method::BRANCH_AND_BOUND)).status == Status::INFEASIBLE);

  assert(QM::find_feasible_point(gap, params::rounding_method(Method::GREEDY)).status == Status::UNSUPPORTED_PROBLEM);
  Problem saddle(2);
  saddle.add_quadratic_constraint(diagonal({ 2., -2. }), {}, -1.);
  assert(QM::find_feasible_point(saddle).status == Status::NUMERICAL_FAILURE);
  assert(QM::find_feasible_point(Problem(3)).is_valid()); // no constraint at all
}

// The smallest excess over all integers of a box.
void random_feasible_points()
{
  CGAL::Random random(31);
  int feasible = 0;
  const int problems = 60;
  for(int p = 0; p < problems; ++p)
  {
    const int n = random.get_int(1, 4), size = 4;
    Problem problem(n);
    for(int i = 0; i < n; ++i)
    {
      problem.set_integer(i);
      problem.set_bounds(i, 0., size - 1.);
    }
    for(int c = random.get_int(2, 5); c > 0; --c)
    {
      Problem::Linear_form form;
      for(int i = 0; i < n; ++i)
        form.emplace_back(i, random.get_int(-5, 6));
      problem.add_inequality_constraint(form, random.get_int(-7, 5));
    }
    if(p % 3 == 0)
      add_ball(problem, std::vector<double>(n, random.get_double(0., 3.)), random.get_double(0.2, 4.));
    double least = infinity;
    for(int code = 0; code < std::pow(size, n); ++code)
    {
      Eigen::VectorXd x(n);
      for(int i = 0, rest = code; i < n; ++i, rest /= size)
        x[i] = rest % size;
      double excess = largest_violation(problem, x);
      for(const Problem::Linear_constraint& c : problem.inequality_constraints())
      {
        double sum = -c.rhs;
        for(const auto& a : c.form)
          sum += a.second * x[a.first];
        excess = (std::max)(excess, sum);
      }
      least = (std::min)(least, excess);
    }
    const QM::Feasible_point relaxed = QM::find_feasible_point(problem);
    const QM::Feasible_point point =
      QM::find_feasible_point(problem, params::rounding_method(methods[p % 2])); // bound, cut
    feasible += least <= 0.;
    assert(point.status == (least <= 0. ? Status::FEASIBLE : Status::INFEASIBLE));
    assert(std::fabs(point.violation - (std::max)(least, 0.)) <= 1e-5 * (1. + point.violation));
    assert(point.lower_bound <= point.violation && point.violation - point.lower_bound <= 1e-5 * (1. + least));
    assert(relaxed.lower_bound <= (std::max)(least, 0.) + 1e-9 && (relaxed.is_valid() || least > 0.));
  }
  std::cout << "  " << problems << " problems, " << feasible << " of them feasible" << std::endl;
  assert(feasible > problems / 5 && feasible < problems * 4 / 5);
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   {
                     { "disk", disk },
                     { "linear_energy", linear_energy },
                     { "functors", functors },
                     { "refusals", refusals },
                     { "random_integers", random_integers },
                     { "random_reals", random_reals },
                     { "rules", rules },
                     { "feasible_points", feasible_points },
                     { "random_feasible_points", random_feasible_points },
                   });
}
