// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_UNBOUNDED_RAY_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_UNBOUNDED_RAY_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Bounded_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Exact_dual_simplex.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A basis of the directions in which y'Sy does not grow, with rational coordinates: one direction per row, each with
// a one at a coordinate where all others have a zero. Where S holds small fractions up to round-off, so do the
// directions exactly.
class Flat_directions
{
public:
  typedef CGAL::Exact_rational Rational;

  // `scale` is the root of the diagonal, and of what it was before it became round-off.
  Flat_directions(const Eigen::MatrixXd& S, const Eigen::VectorXd& scale)
  {
    const int n = static_cast<int>(S.rows());
    const double flat = 1e-11; // pivots, relative to the diagonal
    // Gauss-Jordan elimination with the largest pivots: [I F; 0 0].
    Eigen::MatrixXd C = scale.cwiseInverse().asDiagonal() * S * scale.cwiseInverse().asDiagonal();
    std::vector<char> is_pivot(n, 0);
    std::vector<int> pivots;
    for(;;)
    {
      int best = -1;
      for(int i = 0; i < n; ++i)
        if(!is_pivot[i] && C(i, i) > flat * n && (best < 0 || C(i, i) > C(best, best)))
          best = i;
      if(best < 0)
        break;
      is_pivot[best] = 1;
      pivots.push_back(best);
      C.row(best) /= C(best, best);
      const Eigen::RowVectorXd row = C.row(best);
      for(int i = 0; i < n; ++i)
        if(i != best)
        {
          const double factor = C(i, best);
          C.row(i) -= factor * row;
        }
    }
    for(int j = 0; j < n; ++j)
      if(!is_pivot[j])
      {
        std::vector<Rational> direction(n, Rational(0));
        direction[j] = Rational(1);
        for(int i : pivots)
          direction[i] = simple_rational(-C(i, j) * scale[j] / scale[i]);
        m_directions.push_back(direction);
        m_free.push_back(j);
      }
  }

  int size() const { return static_cast<int>(m_directions.size()); }
  const std::vector<Rational>& operator[](int k) const { return m_directions[k]; }
  // The coordinate with the one.
  int free_coordinate(int k) const { return m_free[k]; }

private:
  // The fraction with a small denominator that is equal up to round-off, or the number itself.
  static Rational simple_rational(double a)
  {
    const double round_off = 1e-9;
    const int largest_denominator = 1000;
    for(int d = 1; d <= largest_denominator; ++d)
    {
      const double nearest = std::floor(a * d + 0.5);
      if(std::fabs(a * d - nearest) <= round_off * (std::max)(1., std::fabs(a * d)))
        return Rational(nearest) / Rational(d);
    }
    return Rational(a);
  }

  std::vector<std::vector<Rational>> m_directions;
  std::vector<int> m_free;
};

// Whether the linear form -c'y, which is the slope of an energy in its flat directions, falls along a ray of these
// directions that leaves no constraint and no bound: decided by a linear program in exact arithmetic, over the rays
// in a cube.
inline bool has_unbounded_ray(const Bounded_problem& problem, const Eigen::VectorXd& c,
                              const Flat_directions& directions)
{
  typedef CGAL::Exact_rational Rational;
  // A slope that is smaller, relative to the sizes of c and of the direction, is round-off.
  const double round_off = 1e-9;
  const int n = problem.size(), k = directions.size();
  if(k == 0)
    return false;
  std::vector<Rational> objective(k);
  std::vector<Exact_dual_simplex::Bound> lower(k), upper(k);
  for(int d = 0; d < k; ++d)
  {
    double size = 0.;
    for(int i = 0; i < n; ++i)
    {
      objective[d] -= Rational(c[i]) * directions[d][i];
      size = (std::max)(size, std::fabs(c[i] * CGAL::to_double(directions[d][i])));
    }
    if(std::fabs(CGAL::to_double(objective[d])) <= round_off * size)
      objective[d] = Rational(0);
    lower[d].value = Rational(-1);
    upper[d].value = Rational(1);
  }
  Exact_dual_simplex program(objective, lower, upper, std::vector<char>(k, 0));
  const auto along = [&](const std::vector<std::pair<int, Rational>>& form, int sign)
  {
    std::vector<Rational> a(k, Rational(0));
    for(const std::pair<int, Rational>& e : form)
      for(int d = 0; d < k; ++d)
        a[d] += Rational(sign) * e.second * directions[d][e.first];
    return a;
  };
  for(const Bounded_problem::Row& row : problem.rows)
    program.add_constraint(along(row.form, 1), Rational(0), false);
  for(int i = 0; i < n; ++i)
  {
    const std::vector<std::pair<int, Rational>> coordinate(1, std::make_pair(i, Rational(1)));
    if(problem.has_upper(i))
      program.add_constraint(along(coordinate, 1), Rational(0), false);
    if(problem.has_lower(i))
      program.add_constraint(along(coordinate, -1), Rational(0), false);
  }
  return program.solve([] { return true; }) && CGAL::is_negative(program.objective());
}

// Integers that constraints, bounds and energy leave open: those that can be changed by one together with others,
// along a flat direction without a slope, at no cost. They may as well be zero, all of them; a search would run along
// such directions for ever.
inline std::vector<char> idle_integers(const Bounded_problem& problem, const Eigen::VectorXd& c,
                                       const Flat_directions& directions)
{
  typedef CGAL::Exact_rational Rational;
  const double round_off = 1e-9;
  std::vector<char> result(problem.size(), 0);
  for(int d = 0; d < directions.size(); ++d)
  {
    const std::vector<Rational>& r = directions[d];
    bool is_idle = problem.is_integer[directions.free_coordinate(d)] != 0;
    double slope = 0., size = 0.;
    for(int i = 0; i < problem.size() && is_idle; ++i)
      if(!CGAL::is_zero(r[i]))
      {
        is_idle = !problem.has_lower(i) && !problem.has_upper(i) &&
                  (!problem.is_integer[i] || Exact_dual_simplex::is_integer_value(r[i]));
        slope += c[i] * CGAL::to_double(r[i]);
        size += std::fabs(c[i] * CGAL::to_double(r[i]));
      }
    is_idle = is_idle && std::fabs(slope) <= round_off * size;
    for(const Bounded_problem::Row& row : problem.rows)
    {
      Rational sum(0);
      for(const std::pair<int, Rational>& a : row.form)
        sum += a.second * r[a.first];
      is_idle = is_idle && CGAL::is_zero(sum);
    }
    result[directions.free_coordinate(d)] = is_idle;
  }
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_UNBOUNDED_RAY_H
