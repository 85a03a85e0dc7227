// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEPARATED_ROUNDING_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEPARATED_ROUNDING_H

#include <CGAL/Quad_meshing/Parameterization/internal/Separations.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Changes integers so that all separations hold, at little energy 1/2 z'Sz - z'c.
//
// A separation is a linear inequality on the integers. Local search over steps of one integer, and of two that the
// energy couples strongly, on the energy plus the weighted violations; in a local minimum with violations their weights
// grow (Morris, "The breakout method for escaping from local minima", 1993). Deterministic.
class Separated_rounding
{
public:
  // `number` gives the integer that a variable is, -1 for a real one.
  Separated_rounding(const Eigen::MatrixXd& S, const Eigen::VectorXd& c, const std::vector<int>& number)
    : m_S(S), m_c(c), m_number(number), m_inequalities_of(S.rows())
  {
    m_step_weight = m_S.rows() > 0 ? m_S.diagonal().mean() : 0;
    find_partners();
  }

  // Adds the separations from the first one that is not known yet.
  void add(const std::vector<Separations::Separation>& separations)
  {
    for(std::size_t i = m_inequalities.size(); i < separations.size(); ++i)
    {
      const Separations::Separation& separation = separations[i];
      const double scale = (std::max)(separation.offset[0].terms.empty() ? 0 : std::abs(separation.wanted[0]),
                                      separation.offset[1].terms.empty() ? 0 : std::abs(separation.wanted[1]));
      std::map<int, double> terms;
      for(int k = 0; k < 2 && scale > 0; ++k)
        for(const Integer_form::Term& t : separation.offset[k].terms)
          terms[m_number[t.first]] += t.second * separation.wanted[k] / scale;
      Inequality inequality;
      inequality.terms.assign(terms.begin(), terms.end());
      inequality.weight = m_step_weight;
      for(const auto& t : terms)
        m_inequalities_of[t.first].emplace_back(static_cast<int>(m_inequalities.size()), t.second);
      m_inequalities.push_back(inequality);
    }
    find_shared_inequalities();
  }

  // Returns the number of separations that do not hold.
  int improve(Eigen::VectorXd& z, Stage_progress& progress)
  {
    m_gradient = m_S * z - m_c;
    m_relief.assign(m_S.rows(), 0.);
    m_step_gain.assign(m_S.rows(), { { 0., 0. } });
    for(Inequality& i : m_inequalities)
    {
      i.value = 0;
      for(const auto& t : i.terms)
        i.value += t.second * z[t.first];
      count(i, 1);
    }
    Eigen::VectorXd best = z;
    int fewest = violated();
    // Steps without fewer violations. However few integers there are, weights have to grow a number of times to change
    // anything.
    const int most_idle_steps = 300 + static_cast<int>(m_inequalities.size() + m_inequalities_of.size());
    int patience = most_idle_steps;
    const auto keep_if_best = [&]()
    {
      const int n = violated();
      if(n < fewest)
        patience = most_idle_steps;
      if(n <= fewest)
      {
        fewest = n;
        best = z;
      }
    };
    const double least_gain = 1e-9 * m_step_weight; // less is a rounding error of the gradient
    const int moves_per_report = 16;
    Small_steps steps(progress, moves_per_report);
    while(patience-- > 0 && m_shared_left > 0 && steps.go_further())
    {
      Move move = best_step();
      if(move.gain <= least_gain)
        move = best_pair_of_steps();
      if(move.gain > least_gain)
      {
        for(int k = 0; k < 2; ++k)
          if(move.integer[k] != -1)
            apply(move.integer[k], move.direction[k], z);
        continue;
      }
      keep_if_best();
      if(fewest == 0)
        break;
      for(Inequality& i : m_inequalities)
        if(violation(i.value) > 0)
        {
          count(i, -1);
          i.weight += m_step_weight;
          count(i, 1);
        }
    }
    keep_if_best();
    z = best;
    return fewest;
  }

private:
  struct Inequality // value > 0
  {
    std::vector<std::pair<int, double>> terms;
    double value = 0, weight = 0;
  };

  struct Shared
  {
    int inequality;
    double coefficient[2]; // of the two integers of a step
  };

  struct Move
  {
    int integer[2] = { -1, -1 };
    int direction[2] = { 0, 0 };
    double gain = 0;
  };

  const Eigen::MatrixXd& m_S;
  const Eigen::VectorXd& m_c;
  const std::vector<int>& m_number;
  std::vector<Inequality> m_inequalities;
  std::vector<std::vector<std::pair<int, double>>> m_inequalities_of; // per integer: their numbers and its coefficients
  std::vector<std::vector<int>> m_partners; // per integer: others that it is coupled with, each pair once
  Eigen::VectorXd m_gradient;
  std::vector<double> m_relief; // per integer: the weighted violations that its steps can end at most
  std::vector<std::array<double, 2>>
    m_step_gain; // per integer, down and up: by how much a step lessens the weighted violations
  std::vector<std::vector<std::vector<Shared>>> m_shared; // per integer and partner
  double m_shared_left = 4e9; // terms of these lists that may still be visited: a bound on the work
  double m_step_weight = 0;   // what one step of one integer costs on average

  static double violation(double value)
  {
    const double smallest = 1e-9; // rounding errors of sums of products of integers with doubles
    return value > smallest ? 0 : 1 - value;
  }

  int violated() const
  {
    return static_cast<int>(std::count_if(m_inequalities.begin(), m_inequalities.end(),
                                          [](const Inequality& i) { return violation(i.value) > 0; }));
  }

  void find_partners()
  {
    const std::size_t most_partners = 12;
    const int n = static_cast<int>(m_S.rows());
    m_partners.resize(n);
    for(int i = 0; i < n; ++i)
    {
      std::vector<std::pair<double, int>> coupling;
      for(int j = 0; j < n; ++j)
        if(j != i)
          coupling.emplace_back(-m_S(i, j) * m_S(i, j) / m_S(j, j), j);
      const std::size_t m = (std::min)(most_partners, coupling.size());
      std::partial_sort(coupling.begin(), coupling.begin() + m, coupling.end());
      for(std::size_t k = 0; k < m; ++k)
      {
        const int j = coupling[k].second;
        if(j > i || std::find(m_partners[j].begin(), m_partners[j].end(), i) == m_partners[j].end())
          m_partners[i].push_back(j);
      }
    }
  }

  // Adds the share of an inequality to what steps gain, or takes it away, with sign -1, before the inequality changes.
  void count(const Inequality& inequality, double sign)
  {
    const double now = sign * inequality.weight * violation(inequality.value);
    for(const auto& t : inequality.terms)
    {
      m_relief[t.first] += now;
      for(int d : { 0, 1 })
        m_step_gain[t.first][d] +=
          now - sign * inequality.weight * violation(inequality.value + (d == 0 ? -t.second : t.second));
    }
  }

  // The inequalities that a step of two integers changes by both: only there it gains something else than the two steps
  // do.
  void find_shared_inequalities()
  {
    m_shared.resize(m_partners.size());
    for(std::size_t i = 0; i < m_partners.size(); ++i)
    {
      m_shared[i].resize(m_partners[i].size());
      for(std::size_t k = 0; k < m_partners[i].size(); ++k)
      {
        m_shared[i][k].clear();
        const auto& a = m_inequalities_of[i];
        const auto& b = m_inequalities_of[m_partners[i][k]];
        for(std::size_t p = 0, q = 0; p < a.size() && q < b.size();)
          if(a[p].first < b[q].first)
            ++p;
          else if(b[q].first < a[p].first)
            ++q;
          else
          {
            m_shared[i][k].push_back(Shared{ a[p].first, { a[p].second, b[q].second } });
            ++p;
            ++q;
          }
      }
    }
  }

  Move best_step() const
  {
    Move best;
    for(int i = 0; i < static_cast<int>(m_S.rows()); ++i)
      for(int d : { -1, 1 })
        offer(best, i, d, -1, 0, gain_of_step(i, d) - d * m_gradient[i] - 0.5 * m_S(i, i));
    return best;
  }

  Move best_pair_of_steps()
  {
    Move best;
    for(int i = 0; i < static_cast<int>(m_S.rows()); ++i)
      for(std::size_t k = 0; k < m_partners[i].size(); ++k)
      {
        const int j = m_partners[i][k];
        for(int d : { -1, 1 })
          for(int e : { -1, 1 })
          {
            const double energy =
              d * m_gradient[i] + 0.5 * m_S(i, i) + e * m_gradient[j] + 0.5 * m_S(j, j) + d * e * m_S(i, j);
            if(m_relief[i] + m_relief[j] - energy <= best.gain)
              continue;
            offer(best, i, d, j, e,
                  gain_of_step(i, d) + gain_of_step(j, e) + gain_of_both(m_shared[i][k], d, e) - energy);
            m_shared_left -= static_cast<double>(m_shared[i][k].size());
          }
      }
    return best;
  }

  double gain_of_step(int i, int direction) const { return m_step_gain[i][direction > 0]; }

  // What two steps gain together beyond what each of them gains alone.
  double gain_of_both(const std::vector<Shared>& list, int d, int e) const
  {
    double gain = 0;
    for(const Shared& s : list)
    {
      const Inequality& inequality = m_inequalities[s.inequality];
      const double v = inequality.value, a = d * s.coefficient[0], b = e * s.coefficient[1];
      gain += inequality.weight * (violation(v + a) + violation(v + b) - violation(v) - violation(v + a + b));
    }
    return gain;
  }

  static void offer(Move& best, int i, int d, int j, int e, double gain)
  {
    if(gain <= best.gain)
      return;
    best.integer[0] = i;
    best.direction[0] = d;
    best.integer[1] = j;
    best.direction[1] = e;
    best.gain = gain;
  }

  void apply(int i, int direction, Eigen::VectorXd& z)
  {
    z[i] += direction;
    m_gradient += direction * m_S.col(i);
    for(const auto& k : m_inequalities_of[i])
    {
      count(m_inequalities[k.first], -1);
      m_inequalities[k.first].value += direction * k.second;
      count(m_inequalities[k.first], 1);
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEPARATED_ROUNDING_H
