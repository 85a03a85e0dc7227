// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_ARC_QUANTIZATION_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_ARC_QUANTIZATION_H

#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Chooses how many segments each arc of a layout gets: at least one, equally many on opposite sides of each patch, and
// in the sense of least squares as near as possible to given numbers (thesis, section 7.2, "Meshing").
//
// Arcs that are opposite sides all by themselves have one number, and most layouts leave nothing else. What T-vertices
// leave is a mixed-integer problem, which is solved to its optimum, or to the best that `most_nodes` nodes give.
class Arc_quantization
{
public:
  static constexpr double most_nodes = 5000;
  // Scales that are tried for a number of quads, and the relative deviation from it that is good enough.
  static constexpr int most_scales = 24;
  static constexpr double close_enough = 0.01;

  std::vector<int> number; // per arc
  std::string error;       // why there are no numbers, empty if there are

  explicit Arc_quantization(const Surface_layout& layout) : m_layout(layout)
  {
    Disjoint_sets sets(static_cast<int>(layout.arcs.size()));
    for(const Surface_layout::Patch& p : layout.patches)
      for(int k = 0; k < 2; ++k)
        if(p.sides[k].size() == 1 && p.sides[k + 2].size() == 1)
          sets.join(static_cast<int>(p.sides[k][0].arc), static_cast<int>(p.sides[k + 2][0].arc));
    m_class.resize(layout.arcs.size());
    for(int a = 0; a < static_cast<int>(m_class.size()); ++a)
      m_class[a] = sets.smallest(a) == a ? m_number_of_classes++ : m_class[sets.smallest(a)];
    for(const Surface_layout::Patch& p : layout.patches)
      for(int k = 0; k < 2; ++k)
        if(p.sides[k].size() != 1 || p.sides[k + 2].size() != 1)
        {
          std::vector<int> form(m_number_of_classes, 0);
          for(const Surface_layout::Side_arc& s : p.sides[k])
            ++form[m_class[s.arc]];
          for(const Surface_layout::Side_arc& s : p.sides[k + 2])
            --form[m_class[s.arc]];
          m_forms.emplace_back();
          for(int c = 0; c < m_number_of_classes; ++c)
            if(form[c] != 0)
              m_forms.back().emplace_back(c, form[c]);
          if(m_forms.back().empty())
            m_forms.pop_back();
        }
  }

  // Finds numbers near `wanted`, per arc. With `Rounding_method::DIRECT` they are those of the thesis: the continuous
  // solution, whose free variables are rounded.
  bool solve(const std::vector<double>& wanted, Rounding_method method)
  {
    std::vector<double> sum(m_number_of_classes, 0);
    std::vector<int> count(m_number_of_classes, 0);
    for(std::size_t a = 0; a < wanted.size(); ++a)
    {
      sum[m_class[a]] += wanted[a];
      ++count[m_class[a]];
    }
    std::vector<int> value(m_number_of_classes);
    std::vector<int> variable(m_number_of_classes, -1);
    Mixed_integer_problem problem;
    for(const Mixed_integer_problem::Linear_form& form : m_forms)
      for(const std::pair<int, double>& term : form)
        if(variable[term.first] == -1)
          variable[term.first] = problem.add_variable(true);
    const bool has_bounds = method == Rounding_method::BRANCH_AND_BOUND || method == Rounding_method::BRANCH_AND_CUT;
    for(int c = 0; c < m_number_of_classes; ++c)
      if(variable[c] == -1)
        value[c] = (std::max)(1, static_cast<int>(std::lround(sum[c] / count[c])));
      else
      {
        problem.add_squared_residual({ { variable[c], 1. } }, sum[c] / count[c], count[c]);
        if(has_bounds)
          problem.set_bounds(variable[c], 1, (std::numeric_limits<double>::infinity)());
      }
    if(!m_forms.empty())
    {
      for(const Mixed_integer_problem::Linear_form& form : m_forms)
      {
        Mixed_integer_problem::Linear_form named;
        for(const std::pair<int, double>& term : form)
          named.emplace_back(variable[term.first], term.second);
        problem.add_equality_constraint(named, 0);
      }
      const Mixed_integer_solution solution =
        solve_mixed_integer(problem, parameters::rounding_method(method).maximum_number_of_nodes(most_nodes));
      if(!solution.is_valid())
      {
        error = "There are no numbers of quads along the arcs, at least one each, such that opposite sides of all "
                "patches agree (" +
                std::string(status_name(solution.status)) + ").";
        return false;
      }
      for(int c = 0; c < m_number_of_classes; ++c)
        if(variable[c] != -1)
          value[c] = static_cast<int>(std::lround(solution.x[variable[c]]));
    }
    number.resize(wanted.size());
    for(std::size_t a = 0; a < wanted.size(); ++a)
      number[a] = value[m_class[a]];
    error.clear();
    if(std::any_of(number.begin(), number.end(), [](int n) { return n < 1; }))
      error = "Rounding has left arcs without any quad.";
    return error.empty();
  }

  // The same with all wanted numbers multiplied such that the number of quads is near a target. In a layout of few
  // classes that number jumps from scale to scale; then single classes are changed, too.
  bool solve_for_quads(const std::vector<double>& wanted, double target, Rounding_method method)
  {
    std::vector<int> best;
    double low = 0, high = 0, best_defect = 0, best_scale = 1, scale = 1;
    for(int i = 0; i < most_scales; ++i)
    {
      std::vector<double> scaled = wanted;
      for(double& w : scaled)
        w *= scale;
      if(!solve(scaled, method))
        return false;
      const double quads = number_of_quads();
      const double defect = std::abs(std::log(quads / target));
      if(best.empty() || defect < best_defect)
      {
        best = number;
        best_defect = defect;
        best_scale = scale;
      }
      if(defect < close_enough)
        break;
      (quads < target ? low : high) = scale;
      // towards the target as if the number of quads grew with the square of the scale, then by halving
      scale = low > 0 && high > 0 ? std::sqrt(low * high)
                                  : scale * std::sqrt(target / quads) * (quads < target ? 1.05 : 0.95);
    }
    number = best;
    std::vector<double> scaled = wanted;
    for(double& w : scaled)
      w *= best_scale;
    approach(target, scaled);
    return true;
  }

  double number_of_quads() const
  {
    double quads = 0;
    for(const Surface_layout::Patch& p : m_layout.patches)
      quads += double(side_number(p.sides[0])) * side_number(p.sides[1]);
    return quads;
  }

  int side_number(const std::vector<Surface_layout::Side_arc>& side) const
  {
    int n = 0;
    for(const Surface_layout::Side_arc& s : side)
      n += number[s.arc];
    return n;
  }

private:
  double defect_of(double target) const { return std::abs(std::log(number_of_quads() / target)); }

  // Changes the numbers of single classes by one as long as that brings the number of quads nearer to a target: the
  // change that departs least from the wanted numbers for what it brings comes first. Classes that T-vertices tie to
  // others stay.
  void approach(double target, const std::vector<double>& wanted)
  {
    std::vector<std::vector<int>> arcs(m_number_of_classes);
    for(std::size_t a = 0; a < number.size(); ++a)
      arcs[m_class[a]].push_back(static_cast<int>(a));
    for(const Mixed_integer_problem::Linear_form& form : m_forms)
      for(const std::pair<int, double>& term : form)
        arcs[term.first].clear();
    auto change = [&](int c, int by)
    {
      for(int a : arcs[c])
        number[a] += by;
    };
    // squared logarithms of what there is over what is wanted
    auto departure = [&](int c)
    {
      double sum = 0;
      for(int a : arcs[c])
        sum += square(std::log(number[a] / (std::max)(1., wanted[a])));
      return sum;
    };
    for(double defect = defect_of(target); defect >= close_enough;)
    {
      int best = -1, best_by = 0;
      double least_price = 0, best_defect = 0;
      for(int c = 0; c < m_number_of_classes; ++c)
        for(int by : { 1, -1 })
        {
          if(arcs[c].empty() || number[arcs[c].front()] + by < 1)
            continue;
          const double before = departure(c);
          change(c, by);
          const double d = defect_of(target);
          if(d < defect)
          {
            const double price = (departure(c) - before) / (defect - d);
            if(best == -1 || price < least_price)
            {
              best = c;
              best_by = by;
              least_price = price;
              best_defect = d;
            }
          }
          change(c, -by);
        }
      if(best == -1)
        return;
      change(best, best_by);
      defect = best_defect;
    }
  }

  const Surface_layout& m_layout;
  std::vector<int> m_class; // per arc
  int m_number_of_classes = 0;
  std::vector<Mixed_integer_problem::Linear_form> m_forms; // over classes: they must vanish
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_ARC_QUANTIZATION_H
