// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SPARSE_ROUNDING_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SPARSE_ROUNDING_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_solution.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Condensed_solver.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Search_limits.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Three_level_solver.h>

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Direct rounding (thesis 5.2.1): two systems.
inline bool direct_rounding(const Sparse_cholesky<double>& linear_solver, const Reduced_problem& problem,
                            Eigen::VectorXd& z, Mixed_integer_solution& solution)
{
  Three_level_solver solver(linear_solver, problem.A, problem.b, 0., 0, 0);
  if(!solver.initialize(solution.factorizations))
    return false;
  solution.relaxed_energy = problem.energy(solver.x());
  for(int i : problem.integers)
    solver.fix(i, nearest_integer(solver.x()[i]));
  if(!problem.integers.empty() && !solver.factorize(solution.factorizations))
    return false;
  z = solver.x();
  return true;
}

// Greedy rounding, one integer after the other, with the exact solution in between. When time is over the rest is
// rounded at once.
inline bool naive_rounding(const Sparse_cholesky<double>& linear_solver, const Reduced_problem& problem,
                           Eigen::VectorXd& z, Mixed_integer_solution& solution, Search_limits& limits)
{
  const double tie = 1e-7;
  Three_level_solver solver(linear_solver, problem.A, problem.b, 0., 0, 0);
  if(!solver.initialize(solution.factorizations))
    return false;
  solution.relaxed_energy = problem.energy(solver.x());
  std::vector<int> open = problem.integers;
  while(!open.empty())
  {
    double least = 1.;
    for(int i : open)
      least = (std::min)(least, distance_to_integer(solver.x()[i]));
    const std::vector<int>::iterator best =
      std::find_if(open.begin(), open.end(), [&](int i) { return distance_to_integer(solver.x()[i]) <= least + tie; });
    if(!solver.fix_exactly(*best, nearest_integer(solver.x()[*best]), solution.factorizations))
      return false;
    open.erase(best);
    ++solution.factorization_roundings;
    limits.set_completed(1. - double(open.size()) / problem.integers.size());
    if(!limits.go_further())
      break;
  }
  if(limits.is_stopped())
    return false;
  for(int i : open)
    solver.fix(i, nearest_integer(solver.x()[i]));
  if(!problem.integers.empty() && !solver.factorize(solution.factorizations))
    return false;
  z = solver.x();
  return true;
}

// Iterative greedy rounding (thesis 5.2.2) with the three-level solver and simultaneous rounding.
//
// Simultaneous rounding: if rounding one variable by d moves no other by more than d, the estimates of a
// set of variables still round to the same integers after all of them but one were rounded as long as the
// deviations sum up to less than one half.
inline bool sparse_greedy_rounding(const Sparse_cholesky<double>& linear_solver, const Reduced_problem& problem,
                                   Eigen::VectorXd& z, Mixed_integer_solution& solution, const Solver_options& options,
                                   Search_limits& limits)
{
  typedef Condensed_solver Solver;
  typedef Three_level_solver Levels;
  // Local updates leave smooth errors below their tolerance. They add up; a new factorization after this
  // fraction of all roundings takes them away. It also is the better preconditioner from then on.
  const double refresh_fraction = 0.1;

  Solver solver(linear_solver, problem, options.rounding_tolerance, options.gauss_seidel_iterations,
                options.conjugate_gradient_iterations);
  if(!solver.initialize(solution.factorizations))
    return false;
  solution.relaxed_energy = problem.energy(solver.all());

  // Candidates by deviation, then index. Entries are stale if the deviation has changed since.
  typedef std::pair<double, int> Candidate;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> candidates;
  std::vector<double> deviation(problem.size(), -1.);
  const auto push = [&](int i)
  {
    // Deviations are compared on a grid, for ties to be decided by index whatever the linear solver.
    const double grid = 1e-7;
    deviation[i] = std::floor(distance_to_integer(solver.x(i)) / grid) * grid;
    candidates.push(Candidate(deviation[i], i));
  };
  for(int i : problem.integers)
    push(i);

  const int m = static_cast<int>(problem.integers.size());
  const int refresh_interval = (std::max)(1, static_cast<int>(refresh_fraction * m));
  int since_refresh = 0, rounded = 0;
  while(rounded < m)
  {
    double sum = 0.;
    int batch = 0;
    while(!candidates.empty())
    {
      const Candidate c = candidates.top();
      if(solver.is_fixed(c.second) || c.first != deviation[c.second])
      {
        candidates.pop();
        continue;
      }
      if(batch > 0 && (!options.simultaneous_rounding || sum + c.first >= 0.5))
        break;
      candidates.pop();
      solver.fix(c.second, nearest_integer(solver.x(c.second)));
      sum += c.first;
      ++batch;
    }
    rounded += batch;
    solution.simultaneous_roundings += batch - 1;
    since_refresh += batch;

    Solver::Level level;
    if(options.allow_refactorization && since_refresh >= refresh_interval && rounded < m)
    {
      level = solver.factorize(solution.factorizations) ? Levels::FACTORIZATION : Levels::FAILED;
      since_refresh = 0;
    }
    else
      level = solver.update(solution.factorizations, options.allow_refactorization);
    switch(level)
    {
      case Levels::GAUSS_SEIDEL: ++solution.gauss_seidel_roundings; break;
      case Levels::CONJUGATE_GRADIENT: ++solution.conjugate_gradient_roundings; break;
      case Levels::FACTORIZATION: ++solution.factorization_roundings; break;
      default: return false;
    }
    if(level != Levels::GAUSS_SEIDEL)
      since_refresh = 0;
    solver.visit_changes(
      [&](int i)
      {
        if(!solver.is_fixed(i))
          push(i);
      });
    limits.set_completed(double(rounded) / m);
    if(!limits.go_further())
      break;
  }
  if(limits.is_stopped())
    return false;
  for(int i : problem.integers)
    if(!solver.is_fixed(i))
      solver.fix(i, nearest_integer(solver.x(i)));
  if(!solver.factorize(solution.factorizations))
    return false;
  z = solver.all();
  return true;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SPARSE_ROUNDING_H
