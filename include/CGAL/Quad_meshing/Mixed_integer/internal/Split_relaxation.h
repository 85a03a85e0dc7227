// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SPLIT_RELAXATION_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SPLIT_RELAXATION_H

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Slabs of the space of y that no lattice point lies in: the integer a'z = b'y + u + k + 1/2 differs from k + 1/2 by
// at least one half.
struct Splits
{
  Eigen::MatrixXd B;       // a column b per slab
  Eigen::VectorXd offsets; // u per slab

  int size() const { return static_cast<int>(offsets.size()); }
};

// The minimum of |y|^2 over a distribution of points y, such that (b'y + u)^2 is at least 1/4 in the mean for every
// slab. No lattice point can be nearer to the origin than that.
//
// By duality it is the maximum over weights w >= 0 of the least value of
//   |y|^2 - sum w ((b'y + u)^2 - 1/4) = y'Ny - 2 r'y + sum w (1/4 - u^2),   N = I - sum w b b',   r = sum w u b,
// which lies below |y|^2 in all lattice points; so every w for which N is positive definite gives a bound. Newton's
// method follows the central path of this maximum plus mu (log det N + sum log w) to small mu (for such semidefinite
// programs see Vandenberghe and Boyd, Semidefinite programming, SIAM Review 38, 1996; the inequalities are those that
// Buchheim and Wiegele, Semidefinite relaxations for non-convex quadratic mixed-integer programming, 2013, use for
// single variables). The point on the path belongs to the normal distribution with the mean y* = N^-1 r and the
// covariance mu N^-1.
class Split_relaxation
{
public:
  explicit Split_relaxation(const Splits& splits) : m_splits(splits), m_dimension(static_cast<int>(splits.B.rows())) {}

  // Follows the path from the weights, which have to be positive, from where the bound is about `first_accuracy`
  // below the maximum to where it is about `accuracy` below. Returns false if told to stop, or if numbers gave out;
  // the bound holds all the same.
  bool run(const Eigen::VectorXd& start, double first_accuracy, double accuracy,
           const std::function<bool()>& go_further)
  {
    const double mu_factor = 0.25;
    const int maximum_steps = 50; // per point of the path; a handful is usual
    const double centered = 0.1;  // squared Newton decrement over mu
    const double count = m_dimension + m_splits.size(), last_mu = accuracy / count;

    m_weights = start;
    while(!evaluate(m_weights, m_at))
    {
      m_weights *= 0.5;
      if(!(m_weights.minCoeff() > 0)) // coefficients that are not finite
        return false;
    }
    m_mu = (std::max)(first_accuracy / count, last_mu);
    for(;;)
    {
      bool is_centered = false;
      for(int i = 0; i < maximum_steps && !is_centered; ++i)
      {
        if(!go_further())
          return false;
        double decrement = 0;
        if(!newton_step(decrement))
          return false;
        is_centered = decrement < centered * m_mu;
      }
      if(m_mu == last_mu)
        return true;
      m_mu = (std::max)(mu_factor * m_mu, last_mu);
    }
  }

  // No lattice point is nearer than the root of this.
  double bound() const
  {
    // Of sums of numbers whose size the terms of the bound give.
    const double round_off = 1e-10;
    return m_at.bound - round_off * (1 + m_at.magnitude);
  }

  // By how much the mean of (b'y + u)^2 exceeds 1/4 on the central path.
  double slack(int i) const { return m_mu / m_weights[i]; }

  Eigen::VectorXd mean() const { return m_at.mean; }

  // The upper triangular factor of the inverse of the covariance.
  Eigen::MatrixXd precision_factor() const { return Eigen::MatrixXd(m_at.cholesky.matrixU()) / std::sqrt(m_mu); }

private:
  struct Evaluation
  {
    Eigen::LLT<Eigen::MatrixXd> cholesky; // of N
    Eigen::VectorXd mean;
    double bound = 0;
    double magnitude = 0;
    double logarithms = 0; // the sum of all
  };

  // Returns false where N is not positive definite.
  bool evaluate(const Eigen::VectorXd& weights, Evaluation& at) const
  {
    if(!(weights.minCoeff() > 0))
      return false;
    const Eigen::MatrixXd scaled = m_splits.B * weights.cwiseSqrt().asDiagonal();
    Eigen::MatrixXd N = Eigen::MatrixXd::Identity(m_dimension, m_dimension);
    N.selfadjointView<Eigen::Lower>().rankUpdate(scaled, -1.);
    at.cholesky.compute(N);
    if(at.cholesky.info() != Eigen::Success)
      return false;
    const Eigen::VectorXd r = m_splits.B * weights.cwiseProduct(m_splits.offsets);
    at.mean = at.cholesky.solve(r);
    const double fixed = weights.dot((0.25 - m_splits.offsets.array().square()).matrix()), bent = r.dot(at.mean);
    at.bound = fixed - bent;
    at.magnitude = weights.sum() + std::fabs(bent);
    at.logarithms = 2 * at.cholesky.matrixLLT().diagonal().array().log().sum() + weights.array().log().sum();
    return std::isfinite(at.bound) && std::isfinite(at.logarithms);
  }

  bool newton_step(double& decrement)
  {
    const double least_step = 1e-10, sufficient = 0.1, to_boundary = 0.95;
    const int n = m_splits.size();
    const Eigen::MatrixXd half = m_at.cholesky.matrixL().solve(m_splits.B);
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(n, n);
    hessian.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose());
    const Eigen::VectorXd variance = hessian.diagonal();
    const Eigen::VectorXd value = m_splits.B.transpose() * m_at.mean + m_splits.offsets;
    const Eigen::VectorXd gradient =
      0.25 - value.array().square() + m_mu * (m_weights.array().inverse() - variance.array());
    for(int j = 0; j < n; ++j)
      for(int i = j; i < n; ++i)
        hessian(i, j) *= 2 * value[i] * value[j] + m_mu * hessian(i, j);
    hessian.diagonal().array() += m_mu * m_weights.array().square().inverse();
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(hessian);
    if(cholesky.info() != Eigen::Success)
      return false;
    const Eigen::VectorXd step = cholesky.solve(gradient);
    decrement = gradient.dot(step);

    double longest = (std::numeric_limits<double>::max)();
    for(int i = 0; i < n; ++i)
      if(step[i] < 0)
        longest = (std::min)(longest, -to_boundary * m_weights[i] / step[i]);
    const Eigen::VectorXd start = m_weights;
    const double before = objective(m_at);
    double length = (std::min)(1., longest);
    while(!advance(start, length, step, before + sufficient * length * decrement))
      if((length *= 0.5) < least_step)
        return false;
    // Far from the path the steps may point the right way but be much too short.
    while(length >= 1 && 2 * length < longest && advance(start, 2 * length, step, objective(m_at)))
      length *= 2;
    return true;
  }

  // Goes there if the objective is larger than that.
  bool advance(const Eigen::VectorXd& start, double length, const Eigen::VectorXd& step, double least)
  {
    Evaluation next;
    const Eigen::VectorXd weights = start + length * step;
    if(!evaluate(weights, next) || !(objective(next) > least))
      return false;
    m_weights = weights;
    m_at = next;
    return true;
  }

  double objective(const Evaluation& at) const { return at.bound + m_mu * at.logarithms; }

  const Splits& m_splits;
  const int m_dimension;
  double m_mu = 0;
  Eigen::VectorXd m_weights;
  Evaluation m_at;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SPLIT_RELAXATION_H
