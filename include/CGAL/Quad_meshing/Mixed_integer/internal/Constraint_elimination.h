// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONSTRAINT_ELIMINATION_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONSTRAINT_ELIMINATION_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/Rounding_method.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Constraint_row.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Eliminated_constraints.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Elimination_number.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Solver_options.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Eliminates equality constraints one by one (thesis 5.1.2), the one with the fewest coefficients first.
//
// - A row with a real variable gives up a real variable: of those whose coefficient is at least a tenth of
//   the largest, one with a power of two as coefficient in a row of integers (then dependent values are
//   computed without rounding), then one that occurs in the fewest other rows.
// - A row of integer coefficients over integer variables is divided by their greatest common divisor. If the
//   right-hand side then is no integer the row contradicts the integer conditions. If a coefficient is one
//   its variable goes. Otherwise Euclid's algorithm runs on the coefficients: with the smallest of them, a_k,
//   x_k + sum round(a_j / a_k) x_j is a new integer variable that replaces x_k, which leaves the other
//   coefficients reduced modulo a_k. These unimodular column operations are those of the Hermite normal
//   form, done only as far as this row needs them.
// - A row over integer variables with real coefficients that are no multiple of integers still gives up a
//   variable, whose integer condition then cannot be promised.
//
// Rows of integers stay rows of integers: they are combined by multiplication across.
template <typename NT>
class Constraint_elimination
{
  typedef Elimination_number<NT> Number;
  typedef std::pair<int, NT> Entry;

  typedef Constraint_row<NT> Row;
  typedef Elimination_step<NT> Step;

public:
  Constraint_elimination(const Mixed_integer_problem& problem, const Solver_options& options)
    : m_size(problem.number_of_variables())
    , m_tolerance(options.constraint_tolerance)
    , m_order(options.elimination_order)
    , m_pivot(options.elimination_pivot)
    , m_is_safe(true)
  {
    for(int i = 0; i < m_size; ++i)
      m_is_integer.push_back(problem.is_integer(i));
    m_columns.resize(m_size);
    for(const Mixed_integer_problem::Linear_constraint& c : problem.equality_constraints())
    {
      m_rows.emplace_back(c, m_tolerance, m_is_integer);
      check_size(m_rows.back());
      for(const Entry& entry : m_rows.back().entries)
      {
        CGAL_precondition(entry.first >= 0 && entry.first < m_size);
        m_columns[entry.first].insert(static_cast<int>(m_rows.size()) - 1);
      }
    }
  }

  // Returns false if integer coefficients outgrew the number type.
  bool run(Eliminated_constraints& result)
  {
    for(std::size_t r = 0; r < m_rows.size(); ++r)
      enqueue(static_cast<int>(r));
    while(!m_queue.empty() && m_is_safe)
    {
      const int r = std::get<2>(*m_queue.begin());
      m_queue.erase(m_queue.begin());
      process(r, result);
    }
    if(!m_is_safe)
      return false;
    std::sort(result.redundant.begin(), result.redundant.end());
    std::sort(result.conflicting.begin(), result.conflicting.end());
    return substitute_back(m_steps, m_is_integer, m_size, result);
  }

private:
  bool has_real_variable(const Row& row) const
  {
    for(const Entry& e : row.entries)
      if(!m_is_integer[e.first])
        return true;
    return false;
  }

  // By how much the right-hand side of a row without coefficients may miss zero, or that of one over integers an
  // integer.
  static double tolerance_of(const Row& row) { return row.is_exact ? 0. : row.tolerance; }

  void enqueue(int r) { m_queue.insert(place_of(r)); }

  void dequeue(int r) { m_queue.erase(place_of(r)); }

  std::tuple<int, int, int> place_of(int r) const
  {
    const Row& row = m_rows[r];
    // Rows that may break integer conditions come last, when others may have emptied them.
    const int rank = (row.is_integral || has_real_variable(row)) ? 0 : 1;
    const int length = m_order == Elimination_order::AS_GIVEN ? 0 : static_cast<int>(row.entries.size());
    return std::make_tuple(rank, length, r);
  }

  void close(int r)
  {
    m_rows[r].is_open = false;
    for(const Entry& e : m_rows[r].entries)
      m_columns[e.first].erase(r);
  }

  void process(int r, Eliminated_constraints& result)
  {
    if(m_rows[r].entries.empty())
    {
      const Row& row = m_rows[r];
      const double residual = std::fabs(Number::to_double(row.rhs / row.scale));
      (residual <= tolerance_of(row) ? result.redundant : result.conflicting).push_back(r);
      m_rows[r].is_open = false;
      return;
    }
    if(has_real_variable(m_rows[r]))
      eliminate_by_row(r, real_pivot(m_rows[r]));
    else if(!m_rows[r].is_integral)
      eliminate_by_row(r, m_rows[r].largest_entry());
    else
    {
      const NT rounded = Number::nearest_integer(m_rows[r].rhs);
      const double residual = std::fabs(Number::to_double((m_rows[r].rhs - rounded) / m_rows[r].scale));
      if(residual > tolerance_of(m_rows[r]))
      {
        result.conflicting.push_back(r);
        close(r);
        return;
      }
      m_rows[r].rhs = rounded;
      int pivot = unit_pivot(m_rows[r]);
      while(pivot < 0 && m_is_safe)
      {
        reduce_by_smallest(r);
        pivot = unit_pivot(m_rows[r]);
      }
      if(m_is_safe)
        eliminate_by_row(r, pivot);
    }
  }

  int real_pivot(const Row& row) const
  {
    const double threshold = m_pivot == Elimination_pivot::LARGEST_COEFFICIENT ? 1. : 0.1;
    double largest = 0.;
    for(const Entry& e : row.entries)
      if(!m_is_integer[e.first])
        largest = (std::max)(largest, std::fabs(Number::to_double(e.second)));
    int best = -1;
    std::pair<int, std::size_t> best_cost;
    for(std::size_t i = 0; i < row.entries.size(); ++i)
    {
      const Entry& e = row.entries[i];
      const double a = std::fabs(Number::to_double(e.second));
      if(m_is_integer[e.first] || a < threshold * largest)
        continue;
      if(m_pivot == Elimination_pivot::LARGEST_COEFFICIENT)
        return static_cast<int>(i);
      int exponent;
      const bool is_dyadic = row.is_integral && std::frexp(a, &exponent) == 0.5;
      const std::pair<int, std::size_t> cost(is_dyadic ? 0 : 1, m_columns[e.first].size());
      if(best < 0 || cost < best_cost)
      {
        best = static_cast<int>(i);
        best_cost = cost;
      }
    }
    return best;
  }

  int unit_pivot(const Row& row) const
  {
    const bool is_first_best = m_pivot == Elimination_pivot::LARGEST_COEFFICIENT;
    int best = -1;
    for(std::size_t i = 0; i < row.entries.size(); ++i)
      if(Number::abs(row.entries[i].second) == NT(1) &&
         (best < 0 ||
          (!is_first_best && m_columns[row.entries[i].first].size() < m_columns[row.entries[best].first].size())))
        best = static_cast<int>(i);
    return best;
  }

  // One round of Euclid's algorithm on the coefficients of a row over integers.
  void reduce_by_smallest(int r)
  {
    const Row& row = m_rows[r];
    const std::size_t k = row.smallest_entry();

    const int fresh = static_cast<int>(m_is_integer.size());
    m_is_integer.push_back(1);
    m_columns.emplace_back();

    Step step;
    step.variable = row.entries[k].first;
    step.pivot = NT(1);
    step.rhs = NT(0);
    for(std::size_t i = 0; i < row.entries.size(); ++i)
      if(i != k)
      {
        const NT q = Number::nearest_quotient(row.entries[i].second, row.entries[k].second);
        if(!Number::is_zero(q))
          step.others.emplace_back(row.entries[i].first, q);
      }
    step.others.emplace_back(fresh, NT(-1));
    enqueue(r); // for apply() takes the rows it changes out of the queue and puts them back
    apply(step, true, true);
    dequeue(r);
    m_steps.push_back(step);
  }

  void eliminate_by_row(int r, int pivot)
  {
    close(r);
    const Row& row = m_rows[r];
    Step step;
    step.variable = row.entries[pivot].first;
    step.pivot = row.entries[pivot].second;
    step.rhs = row.rhs;
    for(std::size_t i = 0; i < row.entries.size(); ++i)
      if(static_cast<int>(i) != pivot)
        step.others.push_back(row.entries[i]);
    apply(step, row.is_integral, row.is_exact);
    m_steps.push_back(step);
  }

  // Eliminates the variable of a step from all open rows.
  void apply(const Step& step, bool is_integral, bool is_exact)
  {
    const std::vector<int> rows(m_columns[step.variable].begin(), m_columns[step.variable].end());
    for(int i : rows)
    {
      dequeue(i);
      combine(i, step, is_integral, is_exact);
      enqueue(i);
    }
    m_columns[step.variable].clear();
  }

  // row := factor * row - multiple * step
  void combine(int i, const Step& step, bool is_step_integral, bool is_step_exact)
  {
    // Coefficients of real rows that cancel leave noise of this size, relative to a row's largest.
    const double noise = 1e-12;
    Row& row = m_rows[i];
    NT a(0);
    for(const Entry& e : row.entries)
      if(e.first == step.variable)
        a = e.second;

    const bool stays_integral = row.is_integral && is_step_integral;
    NT factor(1), multiple = a / step.pivot;
    if(stays_integral)
    {
      const NT g = Number::gcd(a, step.pivot);
      factor = step.pivot / g;
      multiple = a / g;
      if(factor < NT(0))
      {
        factor = -factor;
        multiple = -multiple;
      }
    }
    row.is_integral = stays_integral;
    row.is_exact = row.is_exact && stays_integral && is_step_exact;

    std::vector<Entry> merged;
    merged.reserve(row.entries.size() + step.others.size());
    typename std::vector<Entry>::const_iterator p = row.entries.begin(), q = step.others.begin();
    while(p != row.entries.end() || q != step.others.end())
    {
      if(q == step.others.end() || (p != row.entries.end() && p->first < q->first))
      {
        if(p->first != step.variable)
          merged.emplace_back(p->first, factor * p->second);
        ++p;
      }
      else if(p == row.entries.end() || q->first < p->first)
      {
        merged.emplace_back(q->first, -(multiple * q->second));
        m_columns[q->first].insert(i);
        ++q;
      }
      else
      {
        const NT minuend = factor * p->second, subtrahend = multiple * q->second;
        const NT value = minuend - subtrahend;
        const bool vanishes = stays_integral
                                ? Number::is_zero(value)
                                : std::fabs(Number::to_double(value)) <= noise * std::fabs(Number::to_double(minuend));
        if(vanishes)
          m_columns[q->first].erase(i);
        else
          merged.emplace_back(p->first, value);
        ++p;
        ++q;
      }
    }
    row.entries.swap(merged);
    row.rhs = factor * row.rhs - multiple * step.rhs;
    row.scale = factor * row.scale;
    if(stays_integral)
      row.divide_by_gcd();
    else
      drop_if_negligible(i);
    check_size(row);
  }

  // Rows of integers must not outgrow the number type.
  void check_size(const Row& row)
  {
    if(!row.is_integral)
      return;
    for(const Entry& e : row.entries)
      m_is_safe = m_is_safe && Number::is_safe(e.second);
    m_is_safe = m_is_safe && (Number::is_safe(row.rhs) || has_real_variable(row));
  }

  // A row of reals that is empty up to the tolerance depends on the others.
  void drop_if_negligible(int i)
  {
    Row& row = m_rows[i];
    for(const Entry& e : row.entries)
      if(std::fabs(Number::to_double(e.second)) > m_tolerance)
        return;
    for(const Entry& e : row.entries)
      m_columns[e.first].erase(i);
    row.entries.clear();
  }

  int m_size;
  double m_tolerance;
  Elimination_order m_order;
  Elimination_pivot m_pivot;
  bool m_is_safe;
  std::vector<char> m_is_integer; // originals, then the variables Euclid's algorithm made
  std::vector<Row> m_rows;
  std::vector<std::set<int>> m_columns;        // open rows in which a variable occurs
  std::set<std::tuple<int, int, int>> m_queue; // (rank, number of entries, row)
  std::vector<Step> m_steps;
};

// Eliminates in doubles and, should integers outgrow them or someone need exact numbers, in exact rationals.
inline Eliminated_constraints eliminate_constraints(const Mixed_integer_problem& problem, const Solver_options& options,
                                                    bool must_be_exact)
{
  Eliminated_constraints result;
  if(must_be_exact)
  {
    Constraint_elimination<CGAL::Exact_rational>(problem, options).run(result);
    return result;
  }
  Constraint_elimination<double> fast(problem, options);
  if(fast.run(result))
    return result;
  result = Eliminated_constraints();
  Constraint_elimination<CGAL::Exact_rational>(problem, options).run(result);
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONSTRAINT_ELIMINATION_H
