// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DENSE_GREEDY_ROUNDING_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DENSE_GREEDY_ROUNDING_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Search_limits.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Greedy rounding (thesis 5.2.2) of y in E(y) = 1/2 (y - y*)' S (y - y*): the same roundings as with a new
// solution of the whole system after each one. With C = S^-1, fixing y_j at k moves the minimizer of the
// others by C_ij / C_jj (k - y_j), and takes C_ij C_jl / C_jj from C_il: quadratic time per rounding. These products
// are taken from C many at once, as memory is slower than the processor; what is due is kept in `due`, C - due due'.
// `factor` is the lower triangular factor of S. When the limits end it the rest is rounded at once.
inline Eigen::VectorXd dense_greedy_rounding(const Eigen::MatrixXd& factor, const Eigen::VectorXd& target,
                                             Search_limits& limits)
{
  // Estimates that differ by less than this are tied; the lowest index wins.
  const double tie = 1e-7;
  const int m = static_cast<int>(target.size());
  if(m == 0)
    return target;
  Eigen::MatrixXd C = Eigen::MatrixXd::Identity(m, m);
  factor.triangularView<Eigen::Lower>().solveInPlace(C);
  factor.triangularView<Eigen::Lower>().adjoint().solveInPlace(C);
  Eigen::VectorXd y = target;
  const int columns_at_once = 32; // a few cache lines of each row
  Eigen::MatrixXd due(m, columns_at_once);
  int number_due = 0;
  // The open variables are kept in front, in C and here: C shrinks as roundings go on.
  std::vector<int> open(m);
  for(int i = 0; i < m; ++i)
    open[i] = i;

  int count = m;
  for(; count > 0 && limits.go_further(); --count)
  {
    double least = 1.;
    for(int p = 0; p < count; ++p)
      least = (std::min)(least, distance_to_integer(y[open[p]]));
    int best = -1;
    for(int p = 0; p < count; ++p)
      if(distance_to_integer(y[open[p]]) <= least + tie && (best < 0 || open[p] < open[best]))
        best = p;

    const int last = count - 1;
    std::swap(open[best], open[last]);
    C.row(best).head(count).swap(C.row(last).head(count));
    C.col(best).head(count).swap(C.col(last).head(count));
    due.row(best).swap(due.row(last));

    const int j = open[last];
    const double rounded = nearest_integer(y[j]);
    Eigen::VectorXd c = C.col(last).head(count);
    c.noalias() -= due.topLeftCorner(count, number_due) * due.row(last).head(number_due).transpose();
    const double step = (rounded - y[j]) / c[last];
    for(int p = 0; p < last; ++p)
      y[open[p]] += step * c[p];
    due.col(number_due++).head(count) = c / std::sqrt(c[last]);
    if(number_due == columns_at_once)
    {
      C.topLeftCorner(last, last).noalias() -= due.topRows(last) * due.topRows(last).transpose();
      number_due = 0;
    }
    y[j] = rounded;
  }
  for(int p = 0; p < count; ++p)
    y[open[p]] = nearest_integer(y[open[p]]);
  return y;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_DENSE_GREEDY_ROUNDING_H
