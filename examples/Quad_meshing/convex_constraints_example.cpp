// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Integers in a disk, under a convex curve: the nearest such point to one outside, by three methods.

#include <CGAL/Quad_meshing/Mixed_integer/find_feasible_point.h>
#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace QM = CGAL::Quad_meshing;

int main()
{
  QM::Mixed_integer_problem problem(3);
  problem.add_squared_residual({ { 0, 1. } }, 6.2);
  problem.add_squared_residual({ { 1, 1. } }, 4.7);
  problem.add_squared_residual({ { 2, 1. } }, 3.);
  problem.set_integer(0);
  problem.set_integer(1);

  // x^2 + y^2 + z^2 <= 30, as 1/2 x'Qx <= 30
  Eigen::SparseMatrix<double> Q(3, 3);
  Q.setIdentity();
  problem.add_quadratic_constraint(2. * Q, {}, 30.);

  // exp(y / 2) + z <= 6: a function with its gradient
  problem.add_convex_constraint({ 1, 2 },
                                [](const Eigen::VectorXd& x, Eigen::VectorXd& gradient)
                                {
                                  const double e = std::exp(x[0] / 2);
                                  gradient[0] = e / 2;
                                  gradient[1] = 1.;
                                  return e + x[1] - 6.;
                                });

  // First: is there a point at all, with integers taken for reals?
  const QM::Feasible_point point = QM::find_feasible_point(problem);
  if(!point.is_valid())
  {
    std::cerr << point.message << " It is exceeded by " << point.violation << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "feasible: " << point.x.transpose() << std::endl;

  for(QM::Rounding_method method : { QM::Rounding_method::OUTER_APPROXIMATION, QM::Rounding_method::CUTTING_PLANES,
                                     QM::Rounding_method::BRANCH_AND_BOUND })
  {
    const QM::Mixed_integer_solution solution =
      QM::solve_mixed_integer(problem, CGAL::parameters::rounding_method(method));
    if(!solution.is_valid())
    {
      std::cerr << solution.message << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << QM::rounding_method_name(method) << ": " << solution.x.transpose() << ", energy " << solution.energy
              << ", at least " << solution.lower_bound << ", " << solution.cuts << " tangents. " << solution.message
              << std::endl;
  }
  return EXIT_SUCCESS;
}
