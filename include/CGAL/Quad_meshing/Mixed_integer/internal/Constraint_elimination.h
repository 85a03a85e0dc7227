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
#include <CGAL/Quad_meshing/Mixed_integer/internal/Elimination_number.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// All points that meet the equality constraints: x = T z + t with free variables z.
struct Eliminated_constraints
{
  Eigen::SparseMatrix<double> T;
  Eigen::VectorXd t;
  std::vector<char> is_integer; // per free variable
  std::vector<int> redundant, conflicting;
  bool is_identity = true; // T is the identity and t is zero
};

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

  struct Row
  {
    std::vector<Entry> entries; // ascending variables
    NT rhs;
    NT scale;           // the row is the original one, modulo others, times this
    double tolerance;   // for the right-hand side, in units of the original row
    bool is_integral;
    bool is_open;
  };

  // x_variable = (rhs - sum of the other entries) / pivot
  struct Step
  {
    int variable;
    std::vector<Entry> others;
    NT pivot, rhs;
  };

public:
  Constraint_elimination(const Mixed_integer_problem& problem, double tolerance)
    : m_size(problem.number_of_variables()), m_tolerance(tolerance), m_is_safe(true)
  {
    for(int i = 0; i < m_size; ++i)
      m_is_integer.push_back(problem.is_integer(i));
    m_columns.resize(m_size);
    for(const Mixed_integer_problem::Linear_constraint& c : problem.equality_constraints())
      add_row(c);
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
    return substitute_back(result);
  }

private:
  void add_row(const Mixed_integer_problem::Linear_constraint& constraint)
  {
    std::vector<std::pair<int, double> > form = constraint.form;
    std::sort(form.begin(), form.end(),
              [](const std::pair<int, double>& a, const std::pair<int, double>& b) { return a.first < b.first; });
    std::vector<std::pair<int, double> > sum;
    for(const std::pair<int, double>& a : form)
    {
      CGAL_precondition(a.first >= 0 && a.first < m_size);
      if(!sum.empty() && sum.back().first == a.first)
        sum.back().second += a.second;
      else
        sum.push_back(a);
    }

    double largest = 0.;
    for(const std::pair<int, double>& a : sum)
      largest = (std::max)(largest, std::fabs(a.second));
    const double factor = integral_factor(sum);

    Row row;
    row.is_integral = factor > 0.;
    row.is_open = true;
    // Rows of reals are brought to a largest coefficient of one, to have a meaning for tolerances.
    const double scale = row.is_integral ? factor : (largest > 0. ? 1. / largest : 1.);
    row.scale = NT(scale);
    row.rhs = NT(constraint.rhs) * NT(scale);
    row.tolerance = m_tolerance * (std::max)({1., largest, std::fabs(constraint.rhs)});
    const int r = static_cast<int>(m_rows.size());
    for(const std::pair<int, double>& a : sum)
    {
      if(a.second == 0.)
        continue;
      NT value = NT(a.second) * NT(scale);
      if(row.is_integral)
        value = Number::nearest_integer(value);
      row.entries.emplace_back(a.first, value);
      m_columns[a.first].insert(r);
    }
    m_rows.push_back(row);
    if(row.is_integral)
      divide_by_gcd(m_rows.back());
  }

  // Returns a factor that makes all coefficients integers of moderate size, 0 if none was found.
  static double integral_factor(const std::vector<std::pair<int, double> >& form)
  {
    const double relative_error = 1e-12;
    const int max_denominator = 1000;
    double smallest = 0., largest = 0.;
    for(const std::pair<int, double>& a : form)
      if(a.second != 0.)
      {
        smallest = (smallest == 0.) ? std::fabs(a.second) : (std::min)(smallest, std::fabs(a.second));
        largest = (std::max)(largest, std::fabs(a.second));
      }
    if(smallest == 0.)
      return 1.;
    // Powers of two first: they scale without rounding.
    for(double factor = 1.; factor <= 1048576.; factor *= 2.)
    {
      bool ok = largest * factor < 1e6;
      for(const std::pair<int, double>& a : form)
        ok = ok && std::floor(a.second * factor) == a.second * factor;
      if(ok)
        return factor;
    }
    for(int d = 1; d <= max_denominator; ++d)
    {
      const double factor = d / smallest;
      bool ok = largest * factor < 1e6;
      for(const std::pair<int, double>& a : form)
      {
        const double v = a.second * factor;
        ok = ok && std::fabs(v - std::floor(v + 0.5)) <= relative_error * (std::max)(1., std::fabs(v));
      }
      if(ok)
        return factor;
    }
    return 0.;
  }

  void divide_by_gcd(Row& row)
  {
    NT g(0);
    for(const Entry& e : row.entries)
      g = Number::gcd(g, e.second);
    if(Number::is_zero(g) || g == NT(1))
      return;
    for(Entry& e : row.entries)
      e.second = e.second / g;
    row.rhs = row.rhs / g;
    row.scale = row.scale / g;
  }

  bool has_real_variable(const Row& row) const
  {
    for(const Entry& e : row.entries)
      if(!m_is_integer[e.first])
        return true;
    return false;
  }

  void enqueue(int r)
  {
    const Row& row = m_rows[r];
    // Rows that may break integer conditions come last, when others may have emptied them.
    const int rank = (row.is_integral || has_real_variable(row)) ? 0 : 1;
    m_queue.insert(std::make_tuple(rank, static_cast<int>(row.entries.size()), r));
  }

  void dequeue(int r)
  {
    const Row& row = m_rows[r];
    const int rank = (row.is_integral || has_real_variable(row)) ? 0 : 1;
    m_queue.erase(std::make_tuple(rank, static_cast<int>(row.entries.size()), r));
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
      (residual <= row.tolerance ? result.redundant : result.conflicting).push_back(r);
      m_rows[r].is_open = false;
      return;
    }
    if(has_real_variable(m_rows[r]))
      eliminate_by_row(r, real_pivot(m_rows[r]));
    else if(!m_rows[r].is_integral)
      eliminate_by_row(r, largest_entry(m_rows[r]));
    else
    {
      const NT rounded = Number::nearest_integer(m_rows[r].rhs);
      const double residual = std::fabs(Number::to_double((m_rows[r].rhs - rounded) / m_rows[r].scale));
      if(residual > m_rows[r].tolerance)
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
    const double threshold = 0.1;
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

  int largest_entry(const Row& row) const
  {
    int best = 0;
    for(std::size_t i = 1; i < row.entries.size(); ++i)
      if(Number::abs(row.entries[i].second) > Number::abs(row.entries[best].second))
        best = static_cast<int>(i);
    return best;
  }

  int unit_pivot(const Row& row) const
  {
    int best = -1;
    for(std::size_t i = 0; i < row.entries.size(); ++i)
      if(Number::abs(row.entries[i].second) == NT(1) &&
         (best < 0 || m_columns[row.entries[i].first].size() < m_columns[row.entries[best].first].size()))
        best = static_cast<int>(i);
    return best;
  }

  // One round of Euclid's algorithm on the coefficients of a row over integers.
  void reduce_by_smallest(int r)
  {
    const Row& row = m_rows[r];
    std::size_t k = 0;
    for(std::size_t i = 1; i < row.entries.size(); ++i)
      if(Number::abs(row.entries[i].second) < Number::abs(row.entries[k].second))
        k = i;

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
    apply(step, true);
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
    apply(step, row.is_integral);
    m_steps.push_back(step);
  }

  // Eliminates the variable of a step from all open rows.
  void apply(const Step& step, bool is_integral)
  {
    const std::vector<int> rows(m_columns[step.variable].begin(), m_columns[step.variable].end());
    for(int i : rows)
    {
      dequeue(i);
      combine(i, step, is_integral);
      enqueue(i);
    }
    m_columns[step.variable].clear();
  }

  // row := factor * row - multiple * step
  void combine(int i, const Step& step, bool is_step_integral)
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
      divide_by_gcd(row);
    else
      drop_if_negligible(i);
    if(row.is_integral)
      for(const Entry& e : row.entries)
        m_is_safe = m_is_safe && Number::is_safe(e.second);
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

  // Expresses every variable by the free ones, last step first.
  bool substitute_back(Eliminated_constraints& result)
  {
    const int total = static_cast<int>(m_is_integer.size());
    std::vector<int> step_of(total, -1), column(total, -1);
    for(std::size_t s = 0; s < m_steps.size(); ++s)
      step_of[m_steps[s].variable] = static_cast<int>(s);
    result.is_identity = m_steps.empty();
    result.is_integer.clear();
    for(int v = 0; v < total; ++v)
      if(step_of[v] < 0)
      {
        column[v] = static_cast<int>(result.is_integer.size());
        result.is_integer.push_back(m_is_integer[v]);
      }
    const int m = static_cast<int>(result.is_integer.size());

    std::vector<std::vector<Entry> > expression(m_steps.size());
    std::vector<NT> offset(m_steps.size(), NT(0));
    std::vector<NT> accumulator(m, NT(0));
    std::vector<char> is_touched(m, 0);
    std::vector<int> touched;
    for(int s = static_cast<int>(m_steps.size()) - 1; s >= 0; --s)
    {
      const Step& step = m_steps[s];
      NT constant = step.rhs;
      const auto add = [&](int c, const NT& a)
      {
        if(!is_touched[c])
        {
          is_touched[c] = 1;
          touched.push_back(c);
        }
        accumulator[c] -= a;
      };
      for(const Entry& e : step.others)
      {
        const int t = step_of[e.first];
        if(t < 0)
        {
          add(column[e.first], e.second);
          continue;
        }
        constant -= e.second * offset[t];
        for(const Entry& f : expression[t])
          add(f.first, e.second * f.second);
      }
      offset[s] = constant / step.pivot;
      std::sort(touched.begin(), touched.end());
      for(int c : touched)
      {
        if(!Number::is_zero(accumulator[c]))
        {
          expression[s].emplace_back(c, accumulator[c] / step.pivot);
          if(m_is_integer[step.variable] && !Number::is_safe(expression[s].back().second))
            return false;
        }
        accumulator[c] = NT(0);
        is_touched[c] = 0;
      }
      touched.clear();
    }

    std::vector<Eigen::Triplet<double> > triplets;
    result.t = Eigen::VectorXd::Zero(m_size);
    for(int v = 0; v < m_size; ++v)
    {
      const int s = step_of[v];
      if(s < 0)
      {
        triplets.emplace_back(v, column[v], 1.);
        continue;
      }
      result.t[v] = Number::to_double(offset[s]);
      for(const Entry& e : expression[s])
        triplets.emplace_back(v, e.first, Number::to_double(e.second));
    }
    result.T.resize(m_size, m);
    result.T.setFromTriplets(triplets.begin(), triplets.end());
    return true;
  }

  int m_size;
  double m_tolerance;
  bool m_is_safe;
  std::vector<char> m_is_integer;        // originals, then the variables Euclid's algorithm made
  std::vector<Row> m_rows;
  std::vector<std::set<int> > m_columns; // open rows in which a variable occurs
  std::set<std::tuple<int, int, int> > m_queue; // (rank, number of entries, row)
  std::vector<Step> m_steps;
};

// Eliminates in doubles and, should integers outgrow them, once more in exact rationals.
inline Eliminated_constraints eliminate_constraints(const Mixed_integer_problem& problem, double tolerance)
{
  Eliminated_constraints result;
  Constraint_elimination<double> fast(problem, tolerance);
  if(fast.run(result))
    return result;
  result = Eliminated_constraints();
  Constraint_elimination<CGAL::Exact_rational> exact(problem, tolerance);
  exact.run(result);
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONSTRAINT_ELIMINATION_H
