// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_MEAN_SLAB_RELAXATION_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_MEAN_SLAB_RELAXATION_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Dual_lattice.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Slabs without lattice points, with weights, that bound the squared distance of targets from a lattice well in the
// mean over all targets.
//
// A slab k <= a'z <= k + 1 for the dual vector a has the bound of `Split_relaxation`: with b = R^-T a, weights w and
// the places u of a target in its slabs, -1/2 <= u <= 1/2,
//   1/4 sum w - u'Qu,   Q = (W^-1 - B'B)^-1.
// Over targets that are spread evenly, places in slabs of different directions do not correlate and have the variance
// 1/12 (they are characters of a torus), so the mean of the bound is f(w) = 1/4 sum w - 1/12 tr Q, a concave function.
// Newton's method maximizes f(w) + mu sum log w. Slabs come in rounds: first those of a reduced basis of the dual, then
// the sums and differences that promise the largest gain.
class Mean_slab_relaxation
{
public:
  // R is upper triangular, best from a reduced basis.
  Mean_slab_relaxation(const Eigen::MatrixXd& R, int rounds) : m_R(R), m_size(static_cast<int>(R.rows()))
  {
    const double first_weight = 0.2; // relative to that for which one slab alone would have no minimum
    m_normals = reduced_dual_basis(R);
    for(int i = 0; i < m_size; ++i)
      m_known.insert(key(m_normals.col(i)));
    m_B = dual(m_normals);
    m_weights = first_weight * m_B.colwise().squaredNorm().transpose().cwiseInverse();
    maximize();
    for(int round = 0; round < rounds && add_slabs(); ++round)
      maximize();
  }

  const Eigen::MatrixXd& normals() const { return m_normals; } // a column a per slab
  const Eigen::MatrixXd& B() const { return m_B; }             // a column b per slab
  const Eigen::VectorXd& weights() const { return m_weights; }

  // Multiplications and additions so far, about.
  double operations() const { return m_operations; }

private:
  Eigen::MatrixXd dual(const Eigen::MatrixXd& normals) const
  {
    return m_R.transpose().triangularView<Eigen::Lower>().solve(normals);
  }

  static std::vector<double> key(Eigen::VectorXd a)
  {
    choose_sign(a);
    return std::vector<double>(a.data(), a.data() + a.size());
  }

  // Returns false where Q is not positive definite.
  bool evaluate(const Eigen::VectorXd& weights, double mu, double& value, Eigen::MatrixXd& Q)
  {
    const int n = static_cast<int>(weights.size());
    if(!(weights.minCoeff() > 0))
      return false;
    m_operations += 2. * n * n * n;
    const Eigen::VectorXd root = weights.cwiseSqrt();
    const Eigen::MatrixXd scaled = -(root.asDiagonal() * m_gram * root.asDiagonal());
    const Eigen::LLT<Eigen::MatrixXd> cholesky(scaled + Eigen::MatrixXd::Identity(n, n));
    if(cholesky.info() != Eigen::Success)
      return false;
    Q = root.asDiagonal() * cholesky.solve(Eigen::MatrixXd::Identity(n, n)) * root.asDiagonal();
    value = 0.25 * weights.sum() - Q.trace() / 12 + mu * weights.array().log().sum();
    return std::isfinite(value);
  }

  void maximize()
  {
    const double first_part = 0.1, last_part = 0.01; // of the maximum, by which the result falls short of it
    const double mu_factor = 0.1, centered = 0.1, to_boundary = 0.95, least_step = 1e-8;
    const int maximum_steps = 30;
    const int n = static_cast<int>(m_weights.size());
    m_gram = m_B.transpose() * m_B;
    double value = 0;
    Eigen::MatrixXd Q;
    while(!evaluate(m_weights, 0., value, Q))
    {
      m_weights *= 0.5;
      if(!(m_weights.minCoeff() > 0)) // coefficients that are not finite
        return;
    }
    const double scale = 0.25 * m_weights.sum() / n;
    double mu = first_part * scale;
    evaluate(m_weights, mu, value, Q);
    for(int i = 0; i < maximum_steps; ++i)
    {
      const Eigen::MatrixXd square = Q * Q;
      const Eigen::VectorXd inverse = m_weights.cwiseInverse(), inverse_square = inverse.array().square();
      const Eigen::VectorXd diagonal = square.diagonal();
      const Eigen::VectorXd gradient =
        (0.25 - diagonal.array() * inverse_square.array() / 12 + mu * inverse.array()).matrix();
      Eigen::MatrixXd hessian = Q.cwiseProduct(square) / 6;
      hessian = inverse_square.asDiagonal() * hessian * inverse_square.asDiagonal();
      hessian.diagonal().array() += inverse_square.array() * (mu - diagonal.array() * inverse.array() / 6);
      m_operations += 1.5 * n * n * n;
      const Eigen::LLT<Eigen::MatrixXd> cholesky(hessian);
      if(cholesky.info() != Eigen::Success)
        return;
      const Eigen::VectorXd step = cholesky.solve(gradient);
      double length = 1.;
      for(int j = 0; j < n; ++j)
        if(step[j] < 0)
          length = (std::min)(length, -to_boundary * m_weights[j] / step[j]);
      Eigen::VectorXd next;
      Eigen::MatrixXd next_Q;
      double next_value = 0;
      for(;; length *= 0.5)
      {
        if(length < least_step)
          return;
        next = m_weights + length * step;
        if(evaluate(next, mu, next_value, next_Q) && next_value > value)
          break;
      }
      m_weights = next;
      Q.swap(next_Q);
      value = next_value;
      if(gradient.dot(step) < centered * mu * n)
      {
        if(mu <= last_part * scale)
          return;
        const double next_mu = (std::max)(mu_factor * mu, last_part * scale);
        value += (next_mu - mu) * m_weights.array().log().sum();
        mu = next_mu;
      }
    }
  }

  // Takes the slabs out that have next to no weight, and adds half as many as there are integers. The derivative of the
  // mean bound by the weight of a new slab is 1/6 - 1/12 |W B' N^-1 b|^2, with N = I - B W B'; over the length of b its
  // square tells how much there is to gain. Returns false if there is nothing.
  bool add_slabs()
  {
    const double least_derivative = 0.01, least_weight = 1e-3; // the weight relative to 1 / |b|^2
    struct Candidate
    {
      int i, j, sign;
      double gain;
    };
    const int n = static_cast<int>(m_weights.size());
    const Eigen::MatrixXd N =
      Eigen::MatrixXd::Identity(m_size, m_size) - m_B * m_weights.asDiagonal() * m_B.transpose();
    const Eigen::LLT<Eigen::MatrixXd> cholesky(N);
    if(cholesky.info() != Eigen::Success)
      return false;
    const Eigen::MatrixXd half = m_weights.asDiagonal() * (m_B.transpose() * cholesky.solve(m_B));
    const Eigen::MatrixXd form = half.transpose() * half;
    m_operations += 2. * n * n * n + 2. * n * n * m_size;
    std::vector<Candidate> candidates;
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < i; ++j)
        for(int sign : { -1, 1 })
        {
          const double derivative = (2. - (form(i, i) + form(j, j) + 2 * sign * form(i, j))) / 12;
          const double length = m_gram(i, i) + m_gram(j, j) + 2 * sign * m_gram(i, j);
          if(derivative > least_derivative)
            candidates.push_back({ i, j, sign, derivative * derivative / length });
        }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b)
              { return std::tie(b.gain, a.i, a.j, a.sign) < std::tie(a.gain, b.i, b.j, b.sign); });

    std::vector<Eigen::VectorXd> added;
    const std::size_t most = static_cast<std::size_t>((m_size + 1) / 2);
    for(const Candidate& c : candidates)
    {
      if(added.size() == most)
        break;
      const Eigen::VectorXd a = m_normals.col(c.i) + c.sign * m_normals.col(c.j);
      if(!a.isZero(0.) && m_known.insert(key(a)).second)
        added.push_back(a);
    }
    if(added.empty())
      return false;
    std::vector<int> kept;
    for(int i = 0; i < n; ++i)
      if(m_weights[i] * m_gram(i, i) > least_weight)
        kept.push_back(i);
    const double kept_part = 0.9, new_weight = 0.01; // the second relative to 1 / |b|^2
    Eigen::MatrixXd normals(m_size, kept.size() + added.size());
    Eigen::VectorXd weights(normals.cols());
    for(std::size_t i = 0; i < kept.size(); ++i)
    {
      normals.col(i) = m_normals.col(kept[i]);
      weights[i] = kept_part * m_weights[kept[i]];
    }
    for(std::size_t i = 0; i < added.size(); ++i)
      normals.col(kept.size() + i) = added[i];
    m_normals.swap(normals);
    m_B = dual(m_normals);
    weights.tail(added.size()) =
      new_weight * m_B.rightCols(added.size()).colwise().squaredNorm().transpose().cwiseInverse();
    m_weights = weights;
    return true;
  }

  const Eigen::MatrixXd m_R;
  const int m_size;
  Eigen::MatrixXd m_normals, m_B, m_gram; // the Gram matrix is B'B
  Eigen::VectorXd m_weights;
  std::set<std::vector<double>> m_known; // the normals that are or were slabs
  double m_operations = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_MEAN_SLAB_RELAXATION_H
