// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_EXACT_DUAL_SIMPLEX_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_EXACT_DUAL_SIMPLEX_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Elimination_number.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A linear program in exact rationals, solved by the lexicographic dual simplex method on Gomory's column tableau,
// to which constraints and cuts can be added at any time.
//
// The nonbasic variables t_j >= 0 are slacks of constraints. The tableau expresses by them
// - the objective, which is minimized, and the variables x_i, in `m_values`,
// - the slacks of the other, basic constraints, in `m_slacks`,
// each row as first + sum_j row_j t_j. The columns of `m_values` stay lexicographically positive: the tableau is
// dual feasible, and the method finds the lexicographically smallest solution, in finitely many steps.
//
// The method starts from bounds of all variables. Those that stand in for missing ones are called artificial, and so
// are cuts that rest on them: `rests_on_artificial_bounds()` tells whether the last answer would be another one
// without them.
class Exact_dual_simplex
{
public:
  typedef CGAL::Exact_rational Rational;
  typedef Elimination_number<Rational> Number;

  struct Bound
  {
    Rational value;
    bool is_artificial = false;
  };

  // The variables and their bounds; all of them are bounded. `objective` is minimized.
  Exact_dual_simplex(const std::vector<Rational>& objective, const std::vector<Bound>& lower,
                     const std::vector<Bound>& upper, const std::vector<char>& is_integer)
    : m_is_integer(is_integer), m_sign(objective.size(), 1)
  {
    const std::size_t n = objective.size();
    m_values.assign(n + 1, Row(n));
    m_column_is_integer = is_integer;
    m_column_is_cut.assign(n, 0);
    m_column_is_artificial.assign(n, 0);
    for(std::size_t j = 0; j < n; ++j)
    {
      // Each variable starts at the bound that its coefficient prefers: t = x - lower or t = upper - x. Variables
      // that start from above are mirrored in the tableau, which keeps their columns positive.
      const bool from_above = CGAL::is_negative(objective[j]);
      m_sign[j] = from_above ? -1 : 1;
      const Rational& start = from_above ? upper[j].value : lower[j].value;
      m_column_is_artificial[j] = (from_above ? upper[j] : lower[j]).is_artificial;
      m_values[0].first += objective[j] * start;
      m_values[0].row[j] = from_above ? Rational(-objective[j]) : objective[j];
      m_values[j + 1].first = from_above ? Rational(-start) : start;
      m_values[j + 1].row[j] = Rational(1);
    }
    for(std::size_t j = 0; j < n; ++j)
    {
      Slack slack;
      slack.is_integer = is_integer[j];
      slack.row = Row(n);
      slack.row.first = upper[j].value - lower[j].value;
      slack.is_artificial = (m_sign[j] < 0 ? lower[j] : upper[j]).is_artificial;
      slack.row.row[j] = Rational(-1);
      m_slacks.push_back(slack);
    }
  }

  int number_of_variables() const { return static_cast<int>(m_sign.size()); }

  // Adds sum a_i x_i <= b. A slack is an integer if it is one wherever the integer variables are.
  void add_constraint(const std::vector<Rational>& a, const Rational& b, bool has_integer_slack)
  {
    Slack slack;
    slack.is_integer = has_integer_slack;
    slack.row = Row(m_column_is_integer.size());
    slack.row.first = b;
    for(std::size_t i = 0; i < a.size(); ++i)
      if(!CGAL::is_zero(a[i]))
        slack.row.add(m_values[i + 1], m_sign[i] > 0 ? Rational(-a[i]) : a[i]);
    m_slacks.push_back(slack);
  }

  void add_bound(int i, const Rational& value, bool is_upper)
  {
    std::vector<Rational> a(number_of_variables(), Rational(0));
    a[i] = Rational(is_upper ? 1 : -1);
    add_constraint(a, is_upper ? value : Rational(-value), m_is_integer[i]);
  }

  // Restores optimality. Returns false if no point meets the constraints, or if told to stop.
  template <typename Go_further>
  bool solve(const Go_further& go_further)
  {
    m_rests_on_artificial_bounds = false;
    for(;;)
    {
      if(!go_further())
      {
        m_rests_on_artificial_bounds = true;
        return false;
      }
      std::size_t leaving = m_slacks.size();
      for(std::size_t r = 0; r < m_slacks.size(); ++r)
        if(CGAL::is_negative(m_slacks[r].row.first) &&
           (leaving == m_slacks.size() || m_slacks[r].row.first < m_slacks[leaving].row.first))
          leaving = r;
      if(leaving == m_slacks.size())
      {
        // The reduced costs prove the optimum.
        m_rests_on_artificial_bounds = uses_artificial_columns(m_values[0].row);
        return true;
      }
      int entering = -1;
      for(std::size_t j = 0; j < m_column_is_integer.size(); ++j)
        if(CGAL::is_positive(m_slacks[leaving].row.row[j]) &&
           (entering < 0 || is_smaller_column(static_cast<int>(j), entering, m_slacks[leaving].row.row)))
          entering = static_cast<int>(j);
      if(entering < 0)
      {
        // The row proves that there is no point.
        m_rests_on_artificial_bounds =
          m_slacks[leaving].is_artificial || uses_artificial_columns(m_slacks[leaving].row.row);
        return false;
      }
      pivot(leaving, entering);
    }
  }

  // Whether the last answer may be another one without the artificial bounds, or is none, as it was told to stop.
  bool rests_on_artificial_bounds() const { return m_rests_on_artificial_bounds; }

  const Rational& objective() const { return m_values[0].first; }
  Rational value(int i) const { return m_sign[i] > 0 ? m_values[i + 1].first : Rational(-m_values[i + 1].first); }

  // Adds the cut of the first integer variable that has no integer value, or of the objective if it must be an
  // integer: Gomory's fractional cut, whose slack is an integer, if all nonbasic variables are integers, else the
  // mixed-integer Gomory cut. Returns false if there is none to add.
  bool add_first_cut(bool has_integer_objective)
  {
    if(has_integer_objective && !is_integer_value(m_values[0].first) && all_columns_are_integers())
    {
      add_cut(m_values[0]);
      return true;
    }
    for(std::size_t i = 0; i < m_is_integer.size(); ++i)
      if(m_is_integer[i] && !is_integer_value(m_values[i + 1].first))
      {
        add_cut(m_values[i + 1]);
        return true;
      }
    return false;
  }

  // Adds the cuts of all integer variables that have no integer value; returns how many.
  int add_all_cuts()
  {
    int count = 0;
    for(std::size_t i = 0; i < m_is_integer.size(); ++i)
      if(m_is_integer[i] && !is_integer_value(m_values[i + 1].first))
      {
        add_cut(m_values[i + 1]);
        ++count;
      }
    return count;
  }

  // Forgets the cuts that do not hold the solution in its place.
  void drop_loose_cuts()
  {
    m_slacks.erase(std::remove_if(m_slacks.begin(), m_slacks.end(), [](const Slack& s) { return s.is_cut; }),
                   m_slacks.end());
  }

  static bool is_integer_value(const Rational& a) { return Rational(Number::floor(a)) == a; }
  static Rational fraction(const Rational& a) { return a - Rational(Number::floor(a)); }

private:
  struct Row
  {
    Rational first;
    std::vector<Rational> row;

    explicit Row(std::size_t n = 0) : first(0), row(n, Rational(0)) {}

    void add(const Row& other, const Rational& factor)
    {
      first += factor * other.first;
      for(std::size_t j = 0; j < row.size(); ++j)
        if(!CGAL::is_zero(other.row[j]))
          row[j] += factor * other.row[j];
    }
  };

  struct Slack
  {
    Row row;
    bool is_integer = false;
    bool is_cut = false;
    bool is_artificial = false;
  };

  bool uses_artificial_columns(const std::vector<Rational>& row) const
  {
    for(std::size_t j = 0; j < row.size(); ++j)
      if(m_column_is_artificial[j] && !CGAL::is_zero(row[j]))
        return true;
    return false;
  }

  bool all_columns_are_integers() const
  {
    return std::find(m_column_is_integer.begin(), m_column_is_integer.end(), 0) == m_column_is_integer.end();
  }

  // Whether column j divided by d_j is lexicographically smaller than column k divided by d_k.
  bool is_smaller_column(int j, int k, const std::vector<Rational>& d) const
  {
    for(const Row& row : m_values)
    {
      const Rational a = row.row[j] * d[k], b = row.row[k] * d[j];
      if(a < b)
        return true;
      if(b < a)
        return false;
    }
    return false;
  }

  // The slack of row r becomes nonbasic in place of column j.
  void pivot(std::size_t r, int j)
  {
    const Rational pivot = m_slacks[r].row.row[j];
    // t_j as a row over the new nonbasic variables.
    Row entering(m_column_is_integer.size());
    entering.first = -m_slacks[r].row.first / pivot;
    for(std::size_t l = 0; l < entering.row.size(); ++l)
      if(!CGAL::is_zero(m_slacks[r].row.row[l]))
        entering.row[l] = -m_slacks[r].row.row[l] / pivot;
    entering.row[j] = Rational(1) / pivot;

    const auto substitute = [&](Row& row)
    {
      const Rational a = row.row[j];
      if(CGAL::is_zero(a))
        return;
      row.row[j] = Rational(0);
      row.add(entering, a);
    };
    for(Row& row : m_values)
      substitute(row);
    for(std::size_t i = 0; i < m_slacks.size(); ++i)
      if(i != r)
        substitute(m_slacks[i].row);
    m_slacks[r].row = entering;
    const bool was_integer = m_slacks[r].is_integer, was_cut = m_slacks[r].is_cut;
    const bool was_artificial = m_slacks[r].is_artificial;
    m_slacks[r].is_artificial = m_column_is_artificial[j] != 0;
    m_column_is_artificial[j] = was_artificial;
    m_slacks[r].is_integer = m_column_is_integer[j] != 0;
    m_slacks[r].is_cut = m_column_is_cut[j] != 0;
    m_column_is_integer[j] = was_integer;
    m_column_is_cut[j] = was_cut;
  }

  // From x = first + sum row_j t_j with x an integer: with a_j = row_j and f = fraction of -first (the sign that makes
  // the fractional cut lift x, whose column entry is not negative, to the next integer at least),
  //   fractional:     sum fraction(a_j) t_j >= f;
  //   mixed-integer:  the coefficient of an integer t_j is the smaller of fraction(a_j) and, from rounding a_j up,
  //                   f (1 - fraction(a_j)) / (1 - f); that of a real t_j is a_j or f / (1 - f) (-a_j).
  // The numbers of mixed-integer cuts are rounded, for rationals to stay short: as t_j >= 0, coefficients may go up
  // and the right-hand side may go down.
  void add_cut(const Row& source)
  {
    const bool is_fractional = all_columns_are_integers();
    const Rational f = fraction(-source.first);
    Slack cut;
    cut.is_cut = true;
    cut.is_integer = is_fractional;
    cut.row = Row(source.row.size());
    const Rational grid(65536);
    cut.row.first = is_fractional ? Rational(-f) : Rational(-Rational(Number::floor(f * grid)) / grid);
    for(std::size_t j = 0; j < source.row.size(); ++j)
    {
      const Rational& a = source.row[j];
      Rational c;
      if(m_column_is_integer[j])
      {
        const Rational g = fraction(a);
        c = (is_fractional || g <= f) ? g : Rational(f * (Rational(1) - g) / (Rational(1) - f));
      }
      else
        c = CGAL::is_negative(a) ? Rational(f / (Rational(1) - f) * (-a)) : a;
      cut.row.row[j] = is_fractional ? c : Rational(-Rational(Number::floor(-c * grid)) / grid);
    }
    cut.is_artificial = uses_artificial_columns(source.row);
    m_slacks.push_back(cut);
  }

  std::vector<char> m_is_integer; // of the variables
  std::vector<int> m_sign;        // -1 for variables stored as their opposites
  std::vector<Row> m_values;
  std::vector<Slack> m_slacks;
  std::vector<char> m_column_is_integer, m_column_is_cut, m_column_is_artificial;
  bool m_rests_on_artificial_bounds = false;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_EXACT_DUAL_SIMPLEX_H
