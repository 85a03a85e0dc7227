// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The general methods against brute force with an exact solver, where energies are singular, numbers are large, and
// problems are infeasible or unbounded.

#include "mixed_integer_checks.h"
#include "test_cases.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/Random.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_rational Rational;

const Method convex_methods[] = { Method::BRANCH_AND_BOUND, Method::BRANCH_AND_CUT, Method::OUTER_APPROXIMATION };
const Method linear_methods[] = { Method::BRANCH_AND_BOUND, Method::BRANCH_AND_CUT, Method::OUTER_APPROXIMATION,
                                  Method::CUTTING_PLANES };

Eigen::SparseMatrix<double> sparse(const std::vector<std::vector<double>>& rows)
{
  const int n = static_cast<int>(rows.size());
  Eigen::SparseMatrix<double> A(n, n);
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      if(rows[i][j] != 0.)
        A.insert(i, j) = rows[i][j];
  return A;
}

// Whether a point meets all conditions exactly: rows with real variables up to the rounding of these.
bool is_feasible(const Problem& problem, const Eigen::VectorXd& x)
{
  for(int i = 0; i < problem.number_of_variables(); ++i)
  {
    const double allowed = problem.is_integer(i) ? 0. : 1e-9;
    if((problem.is_integer(i) && x[i] != std::floor(x[i])) || !(x[i] >= problem.lower_bound(i) - allowed) ||
       !(x[i] <= problem.upper_bound(i) + allowed))
      return false;
  }
  const auto excess = [&](const Problem::Linear_constraint& c, double& allowed)
  {
    Rational sum = -Rational(c.rhs);
    double size = 1.;
    bool has_integers_only = true;
    for(const std::pair<int, double>& a : c.form)
    {
      sum += Rational(a.second) * Rational(x[a.first]);
      size = (std::max)(size, std::fabs(a.second * x[a.first]));
      has_integers_only = has_integers_only && problem.is_integer(a.first);
    }
    allowed = has_integers_only ? 0. : 1e-8 * size;
    return CGAL::to_double(sum);
  };
  double allowed;
  for(const Problem::Linear_constraint& c : problem.equality_constraints())
    if(!(std::fabs(excess(c, allowed)) <= allowed))
      return false;
  for(const Problem::Linear_constraint& c : problem.inequality_constraints())
    if(!(excess(c, allowed) <= allowed))
      return false;
  return true;
}

// Solves the problem exactly, with the integers at given values or, if there are none, as reals.
struct Exact_answer
{
  bool is_feasible = false, is_unbounded = false;
  double energy = 0.;
};

Exact_answer solve_exactly(const Problem& problem, const std::vector<int>* integers)
{
  typedef CGAL::Quadratic_program<Rational> Program;
  const int n = problem.number_of_variables();
  Program qp(CGAL::SMALLER, false, Rational(0), false, Rational(0));
  const Eigen::SparseMatrix<double> A = problem.matrix();
  const Eigen::VectorXd b = problem.linear_term();
  for(int j = 0; j < n; ++j)
  {
    for(Eigen::SparseMatrix<double>::InnerIterator it(A, j); it; ++it)
      if(it.row() >= j)
        qp.set_d(static_cast<int>(it.row()), j, Rational(it.value()));
    qp.set_c(j, -Rational(b[j]));
  }
  qp.set_c0(Rational(problem.constant()));
  int next = 0;
  for(int i = 0; i < n; ++i)
    if(integers != nullptr && problem.is_integer(i))
    {
      const int value = (*integers)[next++];
      if(value < problem.lower_bound(i) || value > problem.upper_bound(i))
        return Exact_answer();
      qp.set_l(i, true, Rational(value));
      qp.set_u(i, true, Rational(value));
    }
    else
    {
      if(problem.lower_bound(i) > -problem.infinity())
        qp.set_l(i, true, Rational(problem.lower_bound(i)));
      if(problem.upper_bound(i) < problem.infinity())
        qp.set_u(i, true, Rational(problem.upper_bound(i)));
    }
  int row = 0;
  for(const std::vector<Problem::Linear_constraint>* constraints :
      { &problem.equality_constraints(), &problem.inequality_constraints() })
    for(const Problem::Linear_constraint& c : *constraints)
    {
      std::vector<Rational> sum(n, Rational(0));
      for(const std::pair<int, double>& a : c.form)
        sum[a.first] += Rational(a.second);
      for(int i = 0; i < n; ++i)
        qp.set_a(i, row, sum[i]);
      qp.set_b(row, Rational(c.rhs));
      qp.set_r(row, constraints == &problem.equality_constraints() ? CGAL::EQUAL : CGAL::SMALLER);
      ++row;
    }
  const CGAL::Quadratic_program_solution<Rational> s = CGAL::solve_quadratic_program(qp, Rational());
  Exact_answer answer;
  answer.is_feasible = !s.is_infeasible();
  answer.is_unbounded = s.is_unbounded();
  if(answer.is_feasible && !answer.is_unbounded)
    answer.energy = CGAL::to_double(s.objective_value_numerator() / s.objective_value_denominator());
  return answer;
}

// The best of all integers from -reach to reach.
Exact_answer brute_force(const Problem& problem, int reach)
{
  const Exact_answer relaxed = solve_exactly(problem, nullptr);
  Exact_answer best;
  best.energy = std::numeric_limits<double>::infinity();
  if(!relaxed.is_feasible)
    return best;
  std::vector<int> point(problem.number_of_integers(), -reach);
  for(;;)
  {
    const Exact_answer answer = solve_exactly(problem, &point);
    if(answer.is_feasible)
    {
      best.is_feasible = true;
      best.is_unbounded = relaxed.is_unbounded; // for the data are rational
      if(best.is_unbounded)
        return best;
      best.energy = (std::min)(best.energy, answer.energy);
    }
    std::size_t i = 0;
    while(i < point.size() && point[i] == reach)
      point[i++] = -reach;
    if(i == point.size())
      return best;
    ++point[i];
  }
}

void describe(const Problem& problem)
{
  std::cerr << "A\n" << Eigen::MatrixXd(problem.matrix()) << "\nb " << problem.linear_term().transpose() << std::endl;
  for(int i = 0; i < problem.number_of_variables(); ++i)
    std::cerr << (problem.is_integer(i) ? "integer " : "real ") << problem.lower_bound(i) << " to "
              << problem.upper_bound(i) << std::endl;
  for(const std::vector<Problem::Linear_constraint>* constraints :
      { &problem.equality_constraints(), &problem.inequality_constraints() })
    for(const Problem::Linear_constraint& c : *constraints)
    {
      for(const std::pair<int, double>& a : c.form)
        std::cerr << a.second << " x" << a.first << " ";
      std::cerr << (constraints == &problem.equality_constraints() ? "= " : "<= ") << c.rhs << std::endl;
    }
}

// Whether a solution and the best of the integers within reach of brute force can both be true.
bool is_right(const Problem& problem, const Exact_answer& best, const Solution& s)
{
  const double reach = 4., at_most = best.energy + 1e-6 * (1. + std::fabs(best.energy));
  switch(s.status)
  {
    case Status::OPTIMAL:
      if(best.is_unbounded || !is_feasible(problem, s.x) || !is_close(s.energy, problem.energy(s.x)))
        return false;
      // Points beyond the reach count if they are feasible and better.
      return s.energy <= at_most && (is_close(s.energy, best.energy) || s.x.lpNorm<Eigen::Infinity>() > reach);
    case Status::FEASIBLE:
    case Status::LIMIT_REACHED: return s.lower_bound <= at_most;
    case Status::UNBOUNDED: return best.is_unbounded || !best.is_feasible;
    case Status::INFEASIBLE:
    case Status::CONFLICTING_CONSTRAINTS: return !best.is_feasible;
    default: return false;
  }
}

void check(const Problem& problem, const Exact_answer& best, Method method, const std::string& name)
{
  const Solution s = QM::solve_mixed_integer(
    problem, params::rounding_method(method).maximum_number_of_nodes(20000).maximum_running_time(20.));
  if(is_right(problem, best, s))
    return;
  describe(problem);
  std::cerr << name << ", " << QM::rounding_method_name(method) << ": " << QM::status_name(s.status) << " ("
            << s.message << "), energy " << s.energy << ", bound " << s.lower_bound << " at " << s.x.transpose()
            << "; brute force says " << (best.is_feasible ? "feasible" : "infeasible")
            << (best.is_unbounded ? ", unbounded " : " ") << best.energy << std::endl;
  std::abort();
}

// The exact values of issue-sized examples with a flat direction.
void singular_energies()
{
  const auto flat = [](bool is_second_integer)
  {
    Problem problem(2);
    problem.set_integer(0);
    problem.set_integer(1, is_second_integer);
    problem.set_energy(sparse({ { 1., 0. }, { 0., 0. } }), vector({ 0.7, -1. }));
    return problem;
  };
  for(Method method : convex_methods)
  {
    Problem a = flat(true);
    a.set_bounds(1, 0.3, a.infinity());
    Solution s = QM::solve_mixed_integer(a, params::rounding_method(method));
    assert(s.status == Status::OPTIMAL && s.x[0] == 1. && s.x[1] == 1. && is_close(s.energy, 0.8));

    Problem b = flat(true);
    b.add_inequality_constraint({ { 0, -1. }, { 1, -1. } }, -2.);
    s = QM::solve_mixed_integer(b, params::rounding_method(method));
    assert(s.status == Status::OPTIMAL && is_close(s.energy, 0.6));

    Problem c = flat(false);
    c.set_bounds(1, 0.3, c.infinity());
    s = QM::solve_mixed_integer(c, params::rounding_method(method));
    assert(s.status == Status::OPTIMAL && std::fabs(s.energy - 0.1) < 1e-9 && std::fabs(s.x[1] - 0.3) < 1e-9);

    // Without the bound the energy falls for ever, unless there is no point at all.
    Problem d = flat(true);
    d.add_inequality_constraint({ { 0, 1. }, { 1, 1. } }, 2.);
    assert(QM::solve_mixed_integer(d, params::rounding_method(method)).status == Status::UNBOUNDED);
    d.set_bounds(0, 0.2, 0.8);
    assert(QM::solve_mixed_integer(d, params::rounding_method(method)).status == Status::INFEASIBLE);

    // Integers that can be changed together at no cost.
    Problem e(3);
    for(int i = 0; i < 3; ++i)
      e.set_integer(i);
    e.add_squared_residual({ { 0, 1. }, { 1, -1. } }, 0.4);
    e.add_squared_residual({ { 1, 1. }, { 2, -1. } }, 2.3);
    s = QM::solve_mixed_integer(e, params::rounding_method(method).maximum_number_of_nodes(1000));
    assert(s.status == Status::OPTIMAL && is_close(s.energy, 0.16 + 0.09));
  }
}

void far_optima()
{
  for(Method method : linear_methods)
    for(double far_away : { 2e6, 1e12, 4e15 })
    {
      Problem problem(1);
      problem.set_integer(0);
      problem.set_energy(Eigen::SparseMatrix<double>(1, 1), vector({ -1. }));
      problem.set_bounds(0, far_away, problem.infinity());
      const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method));
      assert(s.status == Status::OPTIMAL && s.x[0] == far_away);
      problem.set_bounds(0, -problem.infinity(), far_away);
      assert(QM::solve_mixed_integer(problem, params::rounding_method(method)).status == Status::UNBOUNDED);

      // A cone whose tip is far away.
      Problem cone(2);
      cone.set_integer(0);
      cone.set_energy(Eigen::SparseMatrix<double>(2, 2), vector({ 0., -1. }));
      cone.add_inequality_constraint({ { 0, 1. }, { 1, -2. } }, -far_away);
      cone.add_inequality_constraint({ { 0, -1. }, { 1, -2. } }, far_away);
      const Solution t = QM::solve_mixed_integer(cone, params::rounding_method(method));
      assert(t.status == Status::OPTIMAL && t.x[0] == -far_away && std::fabs(t.x[1]) < 1e-9);
    }
}

void large_coefficients()
{
  {
    // 1000001 x + y = 3000005 with x = 3 and y = 2.
    Problem problem(2);
    for(int i = 0; i < 2; ++i)
    {
      problem.set_integer(i);
      problem.add_squared_residual({ { i, 1. } }, 2.4 + 0.1 * i);
    }
    problem.add_equality_constraint({ { 0, 1000001. }, { 1, 1. } }, 3000005.);
    for(Method method : { Method::DIRECT, Method::NAIVE, Method::GREEDY, Method::LATTICE, Method::BRANCH_AND_BOUND,
                          Method::BRANCH_AND_CUT })
    {
      const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method));
      assert(s.is_valid() && is_feasible(problem, s.x));
      if(method >= Method::LATTICE)
        assert(s.status == Status::OPTIMAL && s.x[0] == 3. && s.x[1] == 2.);
    }
  }
  // The parity of a row does not get lost in the size of its numbers.
  for(double large : { 1e6, 1e9, 1e12, 4e15 })
  {
    Problem problem(2);
    for(int i = 0; i < 2; ++i)
    {
      problem.set_integer(i);
      problem.add_squared_residual({ { i, 1. } }, 0.2);
    }
    problem.add_equality_constraint({ { 0, 2. }, { 1, 4. } }, large + 1.);
    assert(QM::solve_mixed_integer(problem).status == Status::CONFLICTING_CONSTRAINTS);
    problem = Problem(2);
    for(int i = 0; i < 2; ++i)
    {
      problem.set_integer(i);
      problem.add_squared_residual({ { i, 1. } }, 0.2);
    }
    problem.add_equality_constraint({ { 0, large }, { 1, large + 1. } }, 3. * large + 1.);
    for(Method method : { Method::GREEDY, Method::LATTICE, Method::BRANCH_AND_BOUND, Method::BRANCH_AND_CUT })
    {
      const Solution s = QM::solve_mixed_integer(problem, params::rounding_method(method));
      assert(s.is_valid() && is_feasible(problem, s.x));
    }
  }
  // Inequalities over integers hold exactly, those with real variables up to the last bits.
  CGAL::Random random(3);
  for(int trial = 0; trial < 60; ++trial)
  {
    Problem problem(4);
    const bool has_real = trial % 2 == 1;
    for(int i = 0; i < 4; ++i)
    {
      problem.set_integer(i, !(has_real && i == 3));
      problem.set_bounds(i, -50., 50.);
      problem.add_squared_residual({ { i, 1. } }, random.get_double(-9., 9.));
    }
    for(int c = 0; c < 2; ++c)
    {
      Problem::Linear_form form;
      for(int i = 0; i < 4; ++i)
        form.emplace_back(i, random.get_int(-100000000, 100000000));
      problem.add_inequality_constraint(form, random.get_int(-100000000, 100000000));
    }
    for(Method method : { Method::BRANCH_AND_BOUND, Method::BRANCH_AND_CUT })
    {
      const Solution s =
        QM::solve_mixed_integer(problem, params::rounding_method(method).maximum_number_of_nodes(3000));
      assert(s.status != Status::NUMERICAL_FAILURE);
      if(s.is_valid())
        assert(is_feasible(problem, s.x));
    }
  }
}

// Small problems of every kind. Integers have bounds in most of them, for brute force to end.
Problem random_problem(CGAL::Random& random, bool is_linear)
{
  const int integers = random.get_int(0, 4), reals = random.get_int(integers == 0 ? 1 : 0, 3);
  const int n = integers + reals;
  Problem problem(n);
  for(int i = 0; i < integers; ++i)
    problem.set_integer(i);
  Eigen::VectorXd b(n);
  for(int i = 0; i < n; ++i)
    b[i] = random.get_int(0, 3) == 0 ? 0. : random.get_int(-8, 9) / 4.;
  // A few residuals leave flat directions.
  Problem energy(n);
  const int residuals = is_linear ? 0 : random.get_int(0, n + 1);
  for(int k = 0; k < residuals; ++k)
  {
    Problem::Linear_form form;
    for(int i = 0; i < n; ++i)
      form.emplace_back(i, random.get_int(-2, 3));
    energy.add_squared_residual(form, random.get_int(-6, 7) / 4., 0.5);
  }
  problem.set_energy(energy.matrix(), energy.linear_term() + b);
  const bool is_binary = random.get_int(0, 5) == 0;
  for(int i = 0; i < n; ++i)
  {
    const int kind = random.get_int(0, 8);
    const double low = is_binary && i < integers ? 0. : random.get_int(-9, 2) / 4.,
                 high = is_binary && i < integers ? 1. : low + random.get_int(0, 12) / 4.;
    if(kind < 5 || is_binary)
      problem.set_bounds(i, low, high);
    else if(kind == 5)
      problem.set_bounds(i, low, problem.infinity());
    else if(kind == 6)
      problem.set_bounds(i, -problem.infinity(), high);
  }
  const auto random_form = [&]()
  {
    Problem::Linear_form form;
    for(int i = 0; i < n; ++i)
      if(random.get_int(0, 3) > 0)
        form.emplace_back(i, random.get_int(-3, 4));
    return form;
  };
  for(int c = random.get_int(0, 4); c > 0; --c)
    problem.add_inequality_constraint(random_form(), random.get_int(-4, 8) / (random.get_int(0, 2) ? 1. : 2.));
  if(random.get_int(0, 3) == 0)
    problem.add_equality_constraint(random_form(), random.get_int(-3, 4));
  return problem;
}

void fuzz(bool is_linear, int problems, int seed)
{
  CGAL::Random random(seed);
  int infeasible = 0, unbounded = 0;
  for(int p = 0; p < problems; ++p)
  {
    const Problem problem = random_problem(random, is_linear);
    const Exact_answer best = brute_force(problem, 4);
    infeasible += !best.is_feasible;
    unbounded += best.is_unbounded;
    const std::string name = "problem " + std::to_string(p) + " of seed " + std::to_string(seed);
    for(Method method : convex_methods)
      check(problem, best, method, name);
    if(is_linear)
      check(problem, best, Method::CUTTING_PLANES, name);
  }
  std::cout << "  " << problems << " problems, " << infeasible << " infeasible, " << unbounded << " unbounded"
            << std::endl;
  assert(infeasible > problems / 50 && unbounded > problems / 50);
}

int number_of_problems()
{
  const char* const text = std::getenv("QUAD_MESHING_FUZZ_PROBLEMS");
  return text != nullptr ? std::atoi(text) : 400;
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   {
                     { "singular_energies", singular_energies },
                     { "far_optima", far_optima },
                     { "large_coefficients", large_coefficients },
                     { "fuzz_quadratic", [] { fuzz(false, number_of_problems(), 1); } },
                     { "fuzz_linear", [] { fuzz(true, number_of_problems(), 2); } },
                   });
}
