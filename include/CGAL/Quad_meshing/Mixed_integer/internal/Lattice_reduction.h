// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_REDUCTION_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_REDUCTION_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Lattice_enumeration.h>

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Reduces the basis R of a lattice: finds a unimodular U such that the triangular factor of R U has a flat
// diagonal. First LLL (Lenstra, Lenstra, Lovasz 1982), then BKZ (Schnorr, Euchner 1994): the shortest vector of
// every block of consecutive projected vectors is moved to its front.
//
// U is exact: its entries are integers, changed by unimodular steps only, and the reduction stops before they
// outgrow a double. Round-off in R can make a reduction less good but never wrong.
class Lattice_reduction
{
public:
  explicit Lattice_reduction(const Eigen::MatrixXd& R)
    : m_size(static_cast<int>(R.cols()))
    , m_original(R)
    , m_R(R)
    , m_U(Eigen::MatrixXd::Identity(R.cols(), R.cols()))
    , m_is_safe(true)
  {
    make_diagonal_positive();
  }

  // Returns false if told to stop.
  bool run(int block_size, int tours, const std::function<bool()>& go_further)
  {
    lll(0, m_size, go_further);
    refresh();
    lll(0, m_size, go_further);
    for(int tour = 0; tour < tours && m_is_safe; ++tour)
    {
      bool changed = false;
      for(int k = 0; k + 1 < m_size && m_is_safe; ++k)
      {
        changed = improve_block(k, (std::min)(block_size, m_size - k), go_further) || changed;
        if(!go_further())
          return false;
      }
      refresh();
      if(!changed)
        break;
    }
    return true;
  }

  // The triangular factor of the reduced basis, and its coordinates in the given one.
  const Eigen::MatrixXd& factor() const { return m_R; }
  const Eigen::MatrixXd& transformation() const { return m_U; }

  // The coordinates in the reduced basis of the point with coordinates `y` in the given one.
  Eigen::VectorXd coordinates(const Eigen::VectorXd& y) const
  {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(m_original * m_U);
    return qr.solve(Eigen::VectorXd(m_original * y));
  }

private:
  void make_diagonal_positive()
  {
    for(int i = 0; i < m_size; ++i)
      if(m_R(i, i) < 0.)
        m_R.row(i) *= -1.;
  }

  // Computes the factor anew: the rotations of many steps leave round-off.
  void refresh()
  {
    if(m_size == 0)
      return;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(m_original * m_U);
    m_R = qr.matrixQR().triangularView<Eigen::Upper>();
    make_diagonal_positive();
  }

  // b_k += q b_j for j < k, unless the coordinates would outgrow the integers that a double holds.
  void add_multiple(int k, double q, int j)
  {
    const double safe = 1125899906842624.; // 2^50
    if(q == 0.)
      return;
    if(!(m_U.col(k).cwiseAbs().maxCoeff() + std::fabs(q) * m_U.col(j).cwiseAbs().maxCoeff() < safe))
    {
      m_is_safe = false;
      return;
    }
    m_R.col(k).head(j + 1) += q * m_R.col(j).head(j + 1);
    m_U.col(k) += q * m_U.col(j);
  }

  void reduce(int k, int j) { add_multiple(k, -std::floor(m_R(j, k) / m_R(j, j) + 0.5), j); }

  // Rotates rows i and i + 1 so that R_{i+1,i} vanishes and R_ii is positive.
  void rotate(int i)
  {
    const double a = m_R(i, i), b = m_R(i + 1, i);
    const double r = std::hypot(a, b);
    if(r == 0.)
      return;
    const double c = a / r, s = b / r;
    for(int j = i; j < m_size; ++j)
    {
      const double u = m_R(i, j), v = m_R(i + 1, j);
      m_R(i, j) = c * u + s * v;
      m_R(i + 1, j) = c * v - s * u;
    }
    m_R(i + 1, i) = 0.;
  }

  void swap_with_previous(int k)
  {
    m_R.col(k - 1).swap(m_R.col(k));
    m_U.col(k - 1).swap(m_U.col(k));
    rotate(k - 1);
    if(m_R(k, k) < 0.)
      m_R.row(k).tail(m_size - k) *= -1.;
  }

  // LLL on the vectors begin, ..., end - 1, projected off those before. A vector is reduced by its predecessor
  // before the test, by the others only once its place is found.
  void lll(int begin, int end, const std::function<bool()>& go_further)
  {
    const double delta = 0.999;
    int k = begin + 1;
    while(k < end && m_is_safe && go_further())
    {
      reduce(k, k - 1);
      const double previous = m_R(k - 1, k - 1) * m_R(k - 1, k - 1);
      const double projected = m_R(k, k) * m_R(k, k) + m_R(k - 1, k) * m_R(k - 1, k);
      if(delta * previous > projected)
      {
        swap_with_previous(k);
        k = (std::max)(k - 1, begin + 1);
        continue;
      }
      for(int j = k - 2; j >= 0 && m_is_safe; --j)
        reduce(k, j);
      ++k;
    }
  }

  // Moves the shortest vector of the projected block k, ..., k + size - 1 to its front.
  bool improve_block(int k, int size, const std::function<bool()>& go_further)
  {
    const double delta = 0.99, maximum_nodes = 2e5;
    if(size < 2)
      return false;
    std::vector<double> v;
    double squared_length = delta * m_R(k, k) * m_R(k, k);
    if(!shortest_vector(k, size, squared_length, v, maximum_nodes, go_further))
      return false;

    // Euclid's algorithm on the coefficients, from the back: each step keeps sum v_i b_i, and in the end the
    // vector is, up to its sign, the front one of the block.
    for(int i = size - 1; i > 0 && m_is_safe; --i)
    {
      while(v[i] != 0. && m_is_safe)
      {
        // v_{i-1} b_{i-1} + v_i b_i = (v_{i-1} - q v_i) b_{i-1} + v_i (b_i + q b_{i-1})
        const double q = std::floor(v[i - 1] / v[i] + 0.5);
        add_multiple(k + i, q, k + i - 1);
        v[i - 1] -= q * v[i];
        std::swap(v[i - 1], v[i]);
        swap_with_previous(k + i);
      }
    }
    lll(k > 0 ? k - 1 : 0, (std::min)(k + size, m_size), go_further);
    for(int i = k; i < m_size && m_is_safe; ++i)
      for(int j = i - 1; j >= 0 && m_is_safe; --j)
        reduce(i, j);
    return true;
  }

  // Enumerates around the origin, which itself is excluded by looking only at vectors whose last non-zero
  // coefficient is positive: by the lattice point itself and not its opposite.
  bool shortest_vector(int k, int size, double& squared_length, std::vector<double>& v, double maximum_nodes,
                       const std::function<bool()>& go_further) const
  {
    bool found = false;
    double nodes = 0.;
    // The last non-zero coefficient is at position `last` and equals `a`; the rest is a closest-vector problem.
    for(int last = 1; last < size; ++last)
    {
      for(double a = 1.;; a += 1.)
      {
        const double fixed = a * a * m_R(k + last, k + last) * m_R(k + last, k + last);
        if(fixed >= squared_length || nodes >= maximum_nodes)
          break;
        const Eigen::MatrixXd front = m_R.block(k, k, last, last);
        const Eigen::VectorXd center =
          front.triangularView<Eigen::Upper>().solve(Eigen::VectorXd(-a * m_R.col(k + last).segment(k, last)));
        Lattice_enumeration enumeration(front, center);
        double radius = squared_length - fixed;
        enumeration.run(radius, maximum_nodes - nodes, go_further);
        nodes += enumeration.nodes();
        if(enumeration.found())
        {
          found = true;
          squared_length = fixed + radius;
          v.assign(size, 0.);
          for(int i = 0; i < last; ++i)
            v[i] = enumeration.best()[i];
          v[last] = a;
        }
      }
    }
    return found;
  }

  int m_size;
  Eigen::MatrixXd m_original;
  Eigen::MatrixXd m_R;
  Eigen::MatrixXd m_U;
  bool m_is_safe;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_LATTICE_REDUCTION_H
