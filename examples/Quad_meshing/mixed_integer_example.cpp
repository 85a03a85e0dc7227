// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Snaps a chain of marks to a ruler: neighbouring marks should keep the distances measured between them, every third
// mark must lie on an integer, and the last one exactly ten units behind the first.

#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>

#include <cstdlib>
#include <iostream>

namespace QM = CGAL::Quad_meshing;

int main()
{
  const double measured[] = { 1.3, 0.6, 1.8, 0.7, 1.1, 1.9, 0.2, 1.6, 1.2 };
  const int n = 10;

  QM::Mixed_integer_problem problem(n);
  for(int i = 0; i + 1 < n; ++i)
    problem.add_squared_residual({ { i + 1, 1. }, { i, -1. } }, measured[i]);
  for(int i = 0; i < n; i += 3)
    problem.set_integer(i);
  problem.add_equality_constraint({ { 0, 1. } }, 0.);
  problem.add_equality_constraint({ { n - 1, 1. }, { 0, -1. } }, 10.);

  for(QM::Rounding_method method :
      { QM::Rounding_method::DIRECT, QM::Rounding_method::GREEDY, QM::Rounding_method::LATTICE })
  {
    const QM::Mixed_integer_solution solution =
      QM::solve_mixed_integer(problem, CGAL::parameters::rounding_method(method));
    if(!solution.is_valid())
    {
      std::cerr << solution.message << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << QM::rounding_method_name(method) << ": energy " << solution.energy << ", at least "
              << solution.lower_bound << ". " << solution.message << "\n  marks: " << solution.x.transpose()
              << std::endl;
  }
  return EXIT_SUCCESS;
}
