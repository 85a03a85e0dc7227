// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_INTEGER_RELATIONS_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_INTEGER_RELATIONS_H

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A linear form with integer coefficients plus an integer constant; terms sorted by variable.
struct Integer_form
{
  typedef std::pair<int, int> Term; // variable, coefficient

  std::vector<Term> terms;
  int constant = 0;

  static Integer_form variable(int i, int coefficient = 1)
  {
    Integer_form f;
    f.terms.push_back(Term(i, coefficient));
    return f;
  }

  bool is_constant() const { return terms.empty(); }

  void scale(int s)
  {
    if(s == 0)
      terms.clear();
    for(Term& t : terms)
      t.second *= s;
    constant *= s;
  }

  // this += s * other
  void add(const Integer_form& other, int s = 1)
  {
    std::vector<Term> sum;
    sum.reserve(terms.size() + other.terms.size());
    auto a = terms.begin();
    auto b = other.terms.begin();
    while(a != terms.end() || b != other.terms.end())
    {
      if(b == other.terms.end() || (a != terms.end() && a->first < b->first))
        sum.push_back(*a++);
      else if(a == terms.end() || b->first < a->first)
      {
        sum.push_back(Term(b->first, s * b->second));
        ++b;
      }
      else
      {
        if(a->second + s * b->second != 0)
          sum.push_back(Term(a->first, a->second + s * b->second));
        ++a;
        ++b;
      }
    }
    terms.swap(sum);
    constant += s * other.constant;
  }
};

// A point of a chart whose coordinates are such forms.
typedef std::array<Integer_form, 2> Grid_form;

// The point turned counterclockwise about the origin by some quarters.
inline Grid_form rotated(Grid_form a, int quarters)
{
  for(int i = 0; i < (quarters & 3); ++i)
  {
    a[1].scale(-1);
    std::swap(a[0], a[1]); // (u, v) -> (-v, u)
  }
  return a;
}

// Variables under linear equations with integer coefficients.
//
// Each equation that is added removes one variable: it becomes a linear form, with integer
// coefficients again, of the others. Where no coefficient is 1 or -1, unimodular changes of
// variables make one (Euclid's algorithm on the coefficients), so every assignment of integers
// to the variables that remain gives integers everywhere, and all solutions are of this form. All
// arithmetic is on integers: nothing rounds.
class Integer_relations
{
public:
  enum Outcome
  {
    REMOVED_A_VARIABLE,
    REDUNDANT,
    CONTRADICTION
  };

  explicit Integer_relations(int number_of_variables)
    : m_replaced(number_of_variables, false), m_replacement(number_of_variables), m_weight(number_of_variables, 1)
  {
  }

  int number_of_variables() const { return static_cast<int>(m_replaced.size()); }
  bool is_free(int i) const { return !m_replaced[i]; }

  // Rewrites a form in the free variables.
  Integer_form resolved(const Integer_form& form)
  {
    bool done = true;
    for(const Integer_form::Term& t : form.terms)
      if(m_replaced[t.first])
      {
        done = false;
        break;
      }
    if(done)
      return form;
    Integer_form r;
    r.constant = form.constant;
    for(const Integer_form::Term& t : form.terms)
    {
      if(!m_replaced[t.first])
        r.add(Integer_form::variable(t.first), t.second);
      else
      {
        m_replacement[t.first] = resolved(m_replacement[t.first]); // path compression
        r.add(m_replacement[t.first], t.second);
      }
    }
    return r;
  }

  // Adds the equation form = 0. `preference(i)`: the variable with the larger value is removed; among
  // equals the one that stands for fewer others, which keeps chains of replacements short.
  template <typename Preference>
  Outcome add_equation(const Integer_form& form, Preference preference)
  {
    Integer_form f = resolved(form);
    if(f.is_constant())
      return f.constant == 0 ? REDUNDANT : CONTRADICTION;

    int g = 0;
    for(const Integer_form::Term& t : f.terms)
      g = std::gcd(g, t.second);
    if(f.constant % g != 0)
      return CONTRADICTION;
    for(Integer_form::Term& t : f.terms)
      t.second /= g;
    f.constant /= g;

    while(true)
    {
      const Integer_form::Term* pivot = nullptr;
      for(const Integer_form::Term& t : f.terms)
        if(std::abs(t.second) == 1 &&
           (pivot == nullptr || preference(t.first) > preference(pivot->first) ||
            (preference(t.first) == preference(pivot->first) && m_weight[t.first] < m_weight[pivot->first])))
          pivot = &t;
      if(pivot != nullptr)
      {
        const int i = pivot->first, s = pivot->second;
        f.scale(-s);
        f.add(Integer_form::variable(i)); // cancels the pivot's own term: s * s = 1
        replace(i, f);
        return REMOVED_A_VARIABLE;
      }
      reduce_by_smallest_coefficient(f);
    }
  }

private:
  std::vector<bool> m_replaced;
  std::vector<Integer_form> m_replacement;
  std::vector<int> m_weight; // number of variables that were replaced by forms of this one

  void replace(int i, const Integer_form& f)
  {
    m_replaced[i] = true;
    m_replacement[i] = f;
    for(const Integer_form::Term& t : f.terms)
      m_weight[t.first] += m_weight[i];
  }

  // With c the smallest coefficient, at variable k: y = x_k + sum of round(c_i / c) x_i is a new variable
  // that takes the place of x_k and leaves coefficients of at most |c| / 2 elsewhere.
  void reduce_by_smallest_coefficient(Integer_form& f)
  {
    auto smallest = std::min_element(f.terms.begin(), f.terms.end(),
                                     [](const Integer_form::Term& a, const Integer_form::Term& b)
                                     { return std::abs(a.second) < std::abs(b.second); });
    const int k = smallest->first, c = smallest->second;
    const int y = number_of_variables();
    m_replaced.push_back(false);
    m_replacement.emplace_back();
    m_weight.push_back(1);

    Integer_form x_k = Integer_form::variable(y);
    Integer_form reduced;
    reduced.constant = f.constant;
    for(const Integer_form::Term& t : f.terms)
    {
      if(t.first == k)
        continue;
      const int q = (2 * t.second + (t.second > 0 ? std::abs(c) : -std::abs(c))) / (2 * c);
      x_k.add(Integer_form::variable(t.first), -q);
      if(t.second - q * c != 0)
        reduced.add(Integer_form::variable(t.first), t.second - q * c);
    }
    reduced.add(Integer_form::variable(y), c);
    replace(k, x_k);
    f = reduced;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_INTEGER_RELATIONS_H
