// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_ELIMINATED_CONSTRAINTS_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_ELIMINATED_CONSTRAINTS_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Elimination_number.h>

#include <Eigen/SparseCore>

#include <algorithm>
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

  // The rows of T and the entries of t without rounding, if the elimination was exact.
  typedef std::vector<std::pair<int, CGAL::Exact_rational>> Exact_row;
  std::vector<Exact_row> exact_T;
  std::vector<CGAL::Exact_rational> exact_t;
};

inline void store_exactly(double, const std::vector<std::pair<int, double>>&, Eliminated_constraints&) {}
inline void store_exactly(const CGAL::Exact_rational& offset, const Eliminated_constraints::Exact_row& row,
                          Eliminated_constraints& result)
{
  result.exact_T.push_back(row);
  result.exact_t.push_back(offset);
}

// x_variable = (rhs - sum of the other entries) / pivot
template <typename NT>
struct Elimination_step
{
  typedef std::pair<int, NT> Entry;

  int variable;
  std::vector<Entry> others;
  NT pivot, rhs;
};

// Expresses the first `size` variables by the free ones, last step first. Returns false if an integer coefficient
// outgrew the number type.
template <typename NT>
bool substitute_back(const std::vector<Elimination_step<NT>>& steps, const std::vector<char>& is_integer, int size,
                     Eliminated_constraints& result)
{
  typedef Elimination_number<NT> Number;
  typedef typename Elimination_step<NT>::Entry Entry;

  const int total = static_cast<int>(is_integer.size());
  std::vector<int> step_of(total, -1), column(total, -1);
  for(std::size_t s = 0; s < steps.size(); ++s)
    step_of[steps[s].variable] = static_cast<int>(s);
  result.is_identity = steps.empty();
  result.is_integer.clear();
  for(int v = 0; v < total; ++v)
    if(step_of[v] < 0)
    {
      column[v] = static_cast<int>(result.is_integer.size());
      result.is_integer.push_back(is_integer[v]);
    }
  const int m = static_cast<int>(result.is_integer.size());

  std::vector<std::vector<Entry>> expression(steps.size());
  std::vector<NT> offset(steps.size(), NT(0));
  std::vector<NT> accumulator(m, NT(0));
  std::vector<char> is_touched(m, 0);
  std::vector<int> touched;
  for(int s = static_cast<int>(steps.size()) - 1; s >= 0; --s)
  {
    const Elimination_step<NT>& step = steps[s];
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
    if(is_integer[step.variable] && !Number::is_safe(offset[s]))
      return false;
    std::sort(touched.begin(), touched.end());
    for(int c : touched)
    {
      if(!Number::is_zero(accumulator[c]))
      {
        expression[s].emplace_back(c, accumulator[c] / step.pivot);
        if(is_integer[step.variable] && !Number::is_safe(expression[s].back().second))
          return false;
      }
      accumulator[c] = NT(0);
      is_touched[c] = 0;
    }
    touched.clear();
  }

  std::vector<Eigen::Triplet<double>> triplets;
  result.t = Eigen::VectorXd::Zero(size);
  for(int v = 0; v < size; ++v)
  {
    const int s = step_of[v];
    if(s < 0)
    {
      triplets.emplace_back(v, column[v], 1.);
      store_exactly(NT(0), std::vector<Entry>(1, Entry(column[v], NT(1))), result);
      continue;
    }
    result.t[v] = Number::to_double(offset[s]);
    store_exactly(offset[s], expression[s], result);
    for(const Entry& e : expression[s])
      triplets.emplace_back(v, e.first, Number::to_double(e.second));
  }
  result.T.resize(size, m);
  result.T.setFromTriplets(triplets.begin(), triplets.end());
  return true;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_ELIMINATED_CONSTRAINTS_H
