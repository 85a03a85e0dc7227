// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BOUNDED_PROBLEM_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BOUNDED_PROBLEM_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Constraint_row.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Dual_active_set.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Eliminated_constraints.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The inequality constraints and bounds of a problem over its free variables. `kept` lists the free variables that
// are integers or occur in a constraint or bound, ascending: only they matter to a search; all indices below
// are positions in `kept`.
struct Bounded_problem
{
  std::vector<int> kept;
  std::vector<char> is_integer;
  Eigen::MatrixXd G; // G y <= h
  Eigen::VectorXd h;
  Eigen::VectorXd lower, upper;
  bool is_infeasible = false; // a bound or constraint on a constant is violated

  int size() const { return static_cast<int>(kept.size()); }
};

// The inequalities of a problem and bounds that may be tighter than its own. Returns false if a lower bound exceeds an upper one.
inline bool make_constraints(const Bounded_problem& problem, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                             std::vector<Dual_active_set::Constraint>& constraints)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const int n = problem.size();
  for(int i = 0; i < n; ++i)
  {
    if(lower[i] > upper[i])
      return false;
    if(lower[i] > -infinity)
      constraints.push_back(Dual_active_set::Constraint{ Eigen::VectorXd::Unit(n, i), lower[i] });
    if(upper[i] < infinity)
      constraints.push_back(Dual_active_set::Constraint{ -Eigen::VectorXd::Unit(n, i), -upper[i] });
  }
  for(int r = 0; r < problem.G.rows(); ++r)
    constraints.push_back(Dual_active_set::Constraint{ -problem.G.row(r).transpose(), -problem.h[r] });
  return true;
}

// A row over integers whose coefficients are multiples of integers: divided by their greatest common divisor, its right-hand side may be
// rounded down.
inline void tighten(const std::vector<char>& is_integer, Eigen::VectorXd& row, double& rhs)
{
  const double tolerance = 1e-9; // relative to one and to the right-hand side
  Mixed_integer_problem::Linear_form form;
  for(int i = 0; i < row.size(); ++i)
    if(row[i] != 0.)
    {
      if(!is_integer[i])
        return;
      form.emplace_back(i, row[i]);
    }
  const double factor = integral_factor(form);
  if(!(factor > 0.))
    return;
  long long divisor = 0;
  for(const std::pair<int, double>& a : form)
    divisor = std::gcd(divisor, std::llround(a.second * factor));
  for(const std::pair<int, double>& a : form)
    row[a.first] = static_cast<double>(std::llround(a.second * factor) / divisor);
  const double value = rhs * factor / static_cast<double>(divisor);
  rhs = std::floor(value + tolerance * (std::max)(1., std::fabs(value)));
}

inline Bounded_problem make_bounded_problem(const Mixed_integer_problem& problem,
                                            const Eliminated_constraints& constraints)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double tolerance = 1e-9; // of bounds, relative to one and to the bound
  const int m = static_cast<int>(constraints.is_integer.size());
  const Eigen::SparseMatrix<double, Eigen::RowMajor> T = constraints.T;
  typedef Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator Row_iterator;

  std::vector<Eigen::VectorXd> rows;
  std::vector<double> rhs;
  Eigen::VectorXd lower = Eigen::VectorXd::Constant(m, -infinity);
  Eigen::VectorXd upper = Eigen::VectorXd::Constant(m, infinity);

  Bounded_problem result;
  // A row with one variable is a bound.
  const auto add_row = [&](const Eigen::VectorXd& row, double value)
  {
    int count = 0, last = -1;
    for(int i = 0; i < m; ++i)
      if(row[i] != 0.)
      {
        ++count;
        last = i;
      }
    if(count == 0)
      result.is_infeasible = result.is_infeasible || value < -tolerance;
    else if(count == 1 && row[last] > 0.)
      upper[last] = (std::min)(upper[last], value / row[last]);
    else if(count == 1)
      lower[last] = (std::max)(lower[last], value / row[last]);
    else
    {
      rows.push_back(row);
      rhs.push_back(value);
      tighten(constraints.is_integer, rows.back(), rhs.back());
    }
  };
  const auto substitute = [&](const Mixed_integer_problem::Linear_form& form, double& value)
  {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(m);
    for(const std::pair<int, double>& a : form)
    {
      value -= a.second * constraints.t[a.first];
      for(Row_iterator it(T, a.first); it; ++it)
        row[it.col()] += a.second * it.value();
    }
    return row;
  };
  for(int v = 0; v < problem.number_of_variables(); ++v)
    if(problem.lower_bound(v) == infinity || problem.upper_bound(v) == -infinity)
    {
      result.is_infeasible = true;
      return result;
    }
  for(const Mixed_integer_problem::Linear_constraint& c : problem.inequality_constraints())
  {
    double value = c.rhs;
    const Eigen::VectorXd row = substitute(c.form, value);
    add_row(row, value);
  }
  for(int v = 0; v < problem.number_of_variables(); ++v)
  {
    if(problem.upper_bound(v) < infinity)
    {
      double value = problem.upper_bound(v);
      const Eigen::VectorXd row = substitute({ { v, 1. } }, value);
      add_row(row, value);
    }
    if(problem.lower_bound(v) > -infinity)
    {
      double value = -problem.lower_bound(v);
      const Eigen::VectorXd row = substitute({ { v, -1. } }, value);
      add_row(row, value);
    }
  }

  for(int i = 0; i < m; ++i)
  {
    bool occurs = constraints.is_integer[i] || lower[i] > -infinity || upper[i] < infinity;
    for(std::size_t r = 0; r < rows.size() && !occurs; ++r)
      occurs = (rows[r][i] != 0.);
    if(occurs)
      result.kept.push_back(i);
  }
  const int n = result.size();
  result.G.resize(rows.size(), n);
  result.h.resize(rows.size());
  result.lower.resize(n);
  result.upper.resize(n);
  for(int i = 0; i < n; ++i)
  {
    const int v = result.kept[i];
    result.is_integer.push_back(constraints.is_integer[v]);
    result.lower[i] = lower[v];
    result.upper[i] = upper[v];
    if(constraints.is_integer[v])
    {
      result.lower[i] = std::ceil(lower[v] - tolerance * (std::max)(1., std::fabs(lower[v])));
      result.upper[i] = std::floor(upper[v] + tolerance * (std::max)(1., std::fabs(upper[v])));
      if(!(lower[v] > -infinity))
        result.lower[i] = -infinity;
      if(!(upper[v] < infinity))
        result.upper[i] = infinity;
    }
    result.is_infeasible = result.is_infeasible || result.lower[i] > result.upper[i];
    for(std::size_t r = 0; r < rows.size(); ++r)
      result.G(r, i) = rows[r][v];
  }
  for(std::size_t r = 0; r < rows.size(); ++r)
    result.h[r] = rhs[r];
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_BOUNDED_PROBLEM_H
