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

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Changes integers so that all separations hold, at little energy 1/2 z'Sz - z'c.
//
// A separation is a linear inequality on the integers. Local search over steps of one integer, and of two that the energy
// couples strongly, on the energy plus the weighted violations; in a local minimum with violations their weights grow
// (Morris, "The breakout method for escaping from local minima", 1993). Deterministic.
class Separated_rounding
{
public:
  // `number` gives the integer that a variable is, -1 for a real one.
  Separated_rounding(const Eigen::MatrixXd& S, const Eigen::VectorXd& c, const std::vector<int>& number)
    : S(S), c(c), number(number), inequalities_of(S.rows())
  {
    step_weight = S.rows() > 0 ? S.diagonal().mean() : 0;
    find_partners();
  }

  // Adds the separations from the first one that is not known yet.
  void add(const std::vector<Separations::Separation>& separations)
  {
    for(std::size_t i = inequalities.size(); i < separations.size(); ++i)
    {
      const Separations::Separation& separation = separations[i];
      const double scale = (std::max)(separation.offset[0].terms.empty() ? 0 : std::abs(separation.wanted[0]),
                                      separation.offset[1].terms.empty() ? 0 : std::abs(separation.wanted[1]));
      std::map<int, double> terms;
      for(int k = 0; k < 2 && scale > 0; ++k)
        for(const Integer_form::Term& t : separation.offset[k].terms)
          terms[number[t.first]] += t.second * separation.wanted[k] / scale;
      Inequality inequality;
      inequality.terms.assign(terms.begin(), terms.end());
      inequality.weight = step_weight;
      for(const auto& t : terms)
        inequalities_of[t.first].emplace_back(static_cast<int>(inequalities.size()), t.second);
      inequalities.push_back(inequality);
    }
  }

  // Returns the number of separations that do not hold.
  int improve(Eigen::VectorXd& z)
  {
    gradient = S * z - c;
    for(Inequality& i : inequalities)
    {
      i.value = 0;
      for(const auto& t : i.terms)
        i.value += t.second * z[t.first];
    }
    Eigen::VectorXd best = z;
    int fewest = violated();
    // Steps without fewer violations. However few integers there are, weights have to grow a number of times to change anything.
    const int most_idle_steps = 300 + static_cast<int>(inequalities.size() + inequalities_of.size());
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
    const double least_gain = 1e-9 * step_weight; // less is a rounding error of the gradient
    while(patience-- > 0)
    {
      const Move move = best_move();
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
      for(Inequality& i : inequalities)
        if(violation(i.value) > 0)
          i.weight += step_weight;
    }
    keep_if_best();
    z = best;
    return fewest;
  }

private:
  struct Inequality // value > 0
  {
    std::vector<std::pair<int, double> > terms;
    double value = 0, weight = 0;
  };

  struct Move
  {
    int integer[2] = { -1, -1 };
    int direction[2] = { 0, 0 };
    double gain = 0;
  };

  const Eigen::MatrixXd& S;
  const Eigen::VectorXd& c;
  const std::vector<int>& number;
  std::vector<Inequality> inequalities;
  std::vector<std::vector<std::pair<int, double> > > inequalities_of; // per integer: their numbers and its coefficients
  std::vector<std::vector<int> > partners;        // per integer: the later ones that it is coupled with
  Eigen::VectorXd gradient;
  double step_weight = 0; // what one step of one integer costs on average

  static double violation(double value)
  {
    const double smallest = 1e-9; // rounding errors of sums of products of integers with doubles
    return value > smallest ? 0 : 1 - value;
  }

  int violated() const
  {
    return static_cast<int>(std::count_if(inequalities.begin(), inequalities.end(),
                                          [](const Inequality& i) { return violation(i.value) > 0; }));
  }

  void find_partners()
  {
    const std::size_t most_partners = 12;
    const int n = static_cast<int>(S.rows());
    partners.resize(n);
    for(int i = 0; i < n; ++i)
    {
      std::vector<std::pair<double, int> > coupling;
      for(int j = 0; j < n; ++j)
        if(j != i)
          coupling.emplace_back(-S(i, j) * S(i, j) / S(j, j), j);
      const std::size_t m = (std::min)(most_partners, coupling.size());
      std::partial_sort(coupling.begin(), coupling.begin() + m, coupling.end());
      for(std::size_t k = 0; k < m; ++k)
        partners[i].push_back(coupling[k].second);
    }
  }

  Move best_move()
  {
    Move best;
    const int n = static_cast<int>(S.rows());
    relief.assign(n, 0.);
    for(const Inequality& inequality : inequalities)
      for(const auto& t : inequality.terms)
        relief[t.first] += inequality.weight * violation(inequality.value);
    for(int i = 0; i < n; ++i)
      for(int d : { -1, 1 })
      {
        const double energy = d * gradient[i] + 0.5 * S(i, i);
        consider(best, i, d, -1, 0, energy);
        for(int j : partners[i])
          for(int e : { -1, 1 })
            consider(best, i, d, j, e, energy + e * gradient[j] + 0.5 * S(j, j) + d * e * S(i, j));
      }
    return best;
  }

  void consider(Move& best, int i, int d, int j, int e, double energy)
  {
    double gain = -energy;
    if(gain + relief[i] + (j == -1 ? 0 : relief[j]) <= best.gain)
      return;
    touched.clear();
    touch(i, d);
    if(j != -1)
      touch(j, e);
    for(int k : touched)
    {
      Inequality& inequality = inequalities[k];
      gain += inequality.weight * (violation(inequality.value) - violation(inequality.value + change[k]));
      change[k] = 0;
      is_touched[k] = false;
    }
    if(gain > best.gain)
    {
      best.integer[0] = i;
      best.direction[0] = d;
      best.integer[1] = j;
      best.direction[1] = e;
      best.gain = gain;
    }
  }

  std::vector<double> relief;  // per integer: the weighted violations that its steps can end at most
  std::vector<int> touched;    // inequalities
  std::vector<double> change;  // per inequality, zero between two moves
  std::vector<bool> is_touched; // per inequality

  void touch(int i, int direction)
  {
    change.resize(inequalities.size(), 0.);
    is_touched.resize(inequalities.size(), false);
    for(const auto& k : inequalities_of[i])
    {
      if(!is_touched[k.first])
      {
        is_touched[k.first] = true;
        touched.push_back(k.first);
      }
      change[k.first] += direction * k.second;
    }
  }

  void apply(int i, int direction, Eigen::VectorXd& z)
  {
    z[i] += direction;
    gradient += direction * S.col(i);
    for(const auto& k : inequalities_of[i])
      inequalities[k.first].value += direction * k.second;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEPARATED_ROUNDING_H
