// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_TANGENT_CUTS_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_TANGENT_CUTS_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The tangents of the convex constraints of a problem.
class Tangent_cuts
{
public:
  explicit Tangent_cuts(const Mixed_integer_problem& problem) : m_problem(problem) {}

  // Whether the quadratic constraints are convex; others are taken for it.
  bool are_convex() const
  {
    const double round_off = 1e-10; // of an eigenvalue, relative to the largest
    for(const Mixed_integer_problem::Convex_constraint& c : m_problem.convex_constraints())
    {
      if(c.hessian.size() == 0)
        continue;
      if(!c.hessian.allFinite())
        return false;
      const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(c.hessian, Eigen::EigenvaluesOnly).eigenvalues();
      if(values.minCoeff() < -round_off * values.cwiseAbs().maxCoeff())
        return false;
    }
    return true;
  }

  // Whether `x` meets the constraints, up to the accuracy that is asked of reals.
  bool are_met(const Eigen::VectorXd& x) const
  {
    for(const Mixed_integer_problem::Convex_constraint& c : m_problem.convex_constraints())
      if(!tangent_at(c, values_of(c, x)).is_met())
        return false;
    return true;
  }

  // The largest value of the functions at `x`, at least zero.
  double largest_value(const Eigen::VectorXd& x) const
  {
    double result = 0.;
    for(const Mixed_integer_problem::Convex_constraint& c : m_problem.convex_constraints())
      result = (std::max)(result, tangent_at(c, values_of(c, x)).value);
    return result;
  }

  // A point that meets the constraints: tangents are taken where the segment from there leaves them, if that is better.
  void set_inside(const Eigen::VectorXd& x) { m_inside = x; }

  // Adds tangents of the constraints that `x` violates, beyond the accuracy that is asked of reals, to a problem.
  // Returns whether there is one.
  bool add_violated(const Eigen::VectorXd& x, Mixed_integer_problem& problem)
  {
    // Of the value at x, relative to one and to the terms of the tangent: by how much a tangent is moved outwards.
    const double round_off = 1e-12;
    const double grid = 1. / 65536.; // 2^-16
    bool has_added = false;
    for(const Mixed_integer_problem::Convex_constraint& c : m_problem.convex_constraints())
    {
      const Eigen::VectorXd values = values_of(c, x);
      Tangent best = tangent_at(c, values);
      if(best.is_met())
        continue;
      if(m_inside.size() > 0)
      {
        const Tangent outer = tangent_at(c, where_it_leaves(c, values_of(c, m_inside), values));
        if(!best.is_finite || (outer.is_finite && outer.depth(values) > best.depth(values)))
          best = outer;
      }
      if(!best.is_finite)
      {
        m_are_finite = false;
        continue;
      }
      // Exact arithmetic likes the short numbers of a point nearby, whose tangent is as good if it cuts x off.
      const Tangent nearby = tangent_at(c, (best.point / grid).array().round() * grid);
      if(nearby.is_finite && nearby.depth(values) > 0.5 * best.depth(values))
        best = nearby;
      Cut cut{ {}, best.gradient.dot(best.point) - best.value + round_off * best.size() };
      for(int i = 0; i < best.gradient.size(); ++i)
        if(best.gradient[i] != 0.)
          cut.form.emplace_back(c.variables[i], best.gradient[i]);
      problem.add_inequality_constraint(cut.form, cut.rhs);
      m_cuts.push_back(cut);
      has_added = true;
    }
    return has_added;
  }

  // Adds the tangents from number `first` on to another problem.
  void copy_since(int first, Mixed_integer_problem& problem) const
  {
    for(int i = first; i < count(); ++i)
      problem.add_inequality_constraint(m_cuts[i].form, m_cuts[i].rhs);
  }

  int count() const { return static_cast<int>(m_cuts.size()); }

  // Whether all functions had finite values where they were needed.
  bool are_finite() const { return m_are_finite; }

private:
  typedef Mixed_integer_problem::Linear_constraint Cut;

  static Eigen::VectorXd values_of(const Mixed_integer_problem::Convex_constraint& c, const Eigen::VectorXd& x)
  {
    Eigen::VectorXd values(c.variables.size());
    for(int i = 0; i < values.size(); ++i)
      values[i] = x[c.variables[i]];
    return values;
  }

  struct Tangent
  {
    Eigen::VectorXd point, gradient;
    double value;
    bool is_finite;

    double size() const { return 1. + gradient.cwiseProduct(point).cwiseAbs().sum(); }
    bool is_met() const
    {
      const double tolerance = 1e-7; // of the value, relative to one and to the terms of the tangent
      return is_finite && !(value > tolerance * size());
    }
    // The distance from a point to the half-space of the tangent.
    double depth(const Eigen::VectorXd& x) const
    {
      const double norm = gradient.norm();
      return norm > 0. ? (value + gradient.dot(x - point)) / norm : std::numeric_limits<double>::infinity();
    }
  };

  static Tangent tangent_at(const Mixed_integer_problem::Convex_constraint& c, const Eigen::VectorXd& point)
  {
    Tangent t{ point, Eigen::VectorXd::Zero(point.size()), 0., false };
    t.value = c.function(point, t.gradient);
    t.is_finite = std::isfinite(t.value) && t.gradient.size() == point.size() && t.gradient.allFinite();
    return t;
  }

  // The point next to the boundary, on the outer side, of the segment between a point that meets a constraint and one
  // that does not (Kronqvist, Lundell, Westerlund, The extended supporting hyperplane algorithm, 2016).
  static Eigen::VectorXd where_it_leaves(const Mixed_integer_problem::Convex_constraint& c, Eigen::VectorXd inside,
                                         Eigen::VectorXd outside)
  {
    const int halvings = 40;
    for(int i = 0; i < halvings; ++i)
    {
      const Eigen::VectorXd middle = 0.5 * (inside + outside);
      const Tangent t = tangent_at(c, middle);
      (t.is_finite && t.value <= 0. ? inside : outside) = middle;
    }
    return outside;
  }

  const Mixed_integer_problem& m_problem;
  std::vector<Cut> m_cuts;
  Eigen::VectorXd m_inside;
  bool m_are_finite = true;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_TANGENT_CUTS_H
