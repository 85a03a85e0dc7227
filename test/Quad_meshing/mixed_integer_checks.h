// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_TEST_MIXED_INTEGER_CHECKS_H
#define CGAL_QUAD_MESHING_TEST_MIXED_INTEGER_CHECKS_H

#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <vector>

// The names that all tests of mixed-integer problems use.

namespace QM = CGAL::Quad_meshing;
namespace params = CGAL::parameters;

typedef QM::Mixed_integer_problem Problem;
typedef QM::Mixed_integer_solution Solution;
typedef QM::Mixed_integer_status Status;
typedef QM::Rounding_method Method;

const double infinity = std::numeric_limits<double>::infinity();

inline bool is_close(double a, double b, double tolerance = 1e-6)
{
  return std::fabs(a - b) <= tolerance * (1. + std::fabs(a) + std::fabs(b));
}

inline Eigen::VectorXd vector(const std::vector<double>& v)
{
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<int>(v.size()));
}

#endif // CGAL_QUAD_MESHING_TEST_MIXED_INTEGER_CHECKS_H
