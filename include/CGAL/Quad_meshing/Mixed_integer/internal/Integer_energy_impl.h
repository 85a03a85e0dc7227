// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_INTEGER_ENERGY_IMPL_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_INTEGER_ENERGY_IMPL_H

#include <CGAL/Quad_meshing/Mixed_integer/Integer_energy.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>

#include <CGAL/assertions.h>

#include <Eigen/Cholesky>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Factorizes a dense matrix; false if a direction has no energy but round-off.
inline bool factorize_dense(const Eigen::MatrixXd& S, Eigen::MatrixXd& factor)
{
  const double relative_pivot = 1e-14; // of the largest one
  const Eigen::LLT<Eigen::MatrixXd> cholesky(S);
  factor = cholesky.matrixLLT();
  if(cholesky.info() != Eigen::Success)
    return false;
  const Eigen::VectorXd d = factor.diagonal();
  return d.allFinite() && d.minCoeff() * d.minCoeff() > relative_pivot * d.maxCoeff() * d.maxCoeff();
}

// Solves for S = L L'.
inline Eigen::VectorXd solve_dense(const Eigen::MatrixXd& factor, Eigen::VectorXd b)
{
  factor.triangularView<Eigen::Lower>().solveInPlace(b);
  factor.triangularView<Eigen::Lower>().adjoint().solveInPlace(b);
  return b;
}

} // namespace internal

CGAL_QUAD_MESHING_INLINE Integer_energy::Integer_energy() = default;

CGAL_QUAD_MESHING_INLINE Integer_energy::Integer_energy(const Sparse_cholesky<double>& linear_solver)
  : m_solver(linear_solver.make_another())
{
}

CGAL_QUAD_MESHING_INLINE bool Integer_energy::factorize(const Matrix& A, const Eigen::VectorXd& b,
                                                        const std::vector<bool>& is_integer)
{
  CGAL_precondition(A.rows() == A.cols() && A.rows() == b.size());
  CGAL_precondition(A.rows() == static_cast<int>(is_integer.size()));
  m_A = A;
  m_b = b;
  m_integers.clear();
  m_reals.clear();
  for(std::size_t i = 0; i < is_integer.size(); ++i)
    (is_integer[i] ? m_integers : m_reals).push_back(static_cast<int>(i));
  m_coupling = internal::submatrix(m_A, m_reals, m_integers);
  m_rhs_of_reals = internal::subvector(m_b, m_reals);
  m_factorizations = 0;
  return internal::factorize_semidefinite(m_solver, internal::submatrix(m_A, m_reals, m_reals), m_factorizations);
}

CGAL_QUAD_MESHING_INLINE bool Integer_energy::reduce(const Matrix& A, const Eigen::VectorXd& b,
                                                     const std::vector<bool>& is_integer)
{
  if(!factorize(A, b, is_integer))
    return false;
  m_solver.product_with_inverse(m_coupling, m_S);
  m_S = Eigen::MatrixXd(internal::submatrix(m_A, m_integers, m_integers)) - m_S;
  m_S = Eigen::MatrixXd(0.5 * (m_S + m_S.transpose()));
  const Eigen::VectorXd x0 = m_solver.solve(m_rhs_of_reals);
  m_c = internal::subvector(m_b, m_integers) - m_coupling.transpose() * x0;
  m_constant = -0.5 * m_rhs_of_reals.dot(x0);
  return true;
}

CGAL_QUAD_MESHING_INLINE bool Integer_energy::compute(const Matrix& A, const Eigen::VectorXd& b,
                                                      const std::vector<bool>& is_integer)
{
  if(!reduce(A, b, is_integer))
    return false;
  if(!invert_or_shift())
    return false;
  m_target = m_c;
  if(m_target.size() > 0)
  {
    m_target = internal::solve_dense(m_factor, m_c);
    // One step of iterative refinement: targets that are integers should look like integers.
    m_target += internal::solve_dense(m_factor, m_c - m_S * m_target);
  }
  m_relaxed_energy = energy(complete(m_target));
  return true;
}

CGAL_QUAD_MESHING_INLINE void Integer_energy::scale(double factor)
{
  for(Eigen::VectorXd* v : { &m_b, &m_rhs_of_reals, &m_c, &m_target })
    *v *= factor;
  for(double* energy : { &m_constant, &m_relaxed_energy })
    *energy *= factor * factor;
}

CGAL_QUAD_MESHING_INLINE double Integer_energy::cost(const Eigen::VectorXd& y) const
{
  const Eigen::VectorXd d = y - m_target;
  return 0.5 * d.dot(m_S * d);
}

CGAL_QUAD_MESHING_INLINE Mixed_integer_problem Integer_energy::problem() const
{
  Mixed_integer_problem result(size());
  Eigen::SparseMatrix<double> S(size(), size());
  S.reserve(Eigen::VectorXi::Constant(size(), size()));
  for(int j = 0; j < size(); ++j)
    for(int i = 0; i < size(); ++i)
      if(m_S(i, j) != 0)
        S.insert(i, j) = m_S(i, j);
  result.set_energy(S, m_c, m_constant);
  for(int i = 0; i < size(); ++i)
    result.set_integer(i);
  return result;
}

CGAL_QUAD_MESHING_INLINE Eigen::VectorXd Integer_energy::complete(const Eigen::VectorXd& y) const
{
  CGAL_precondition(y.size() == size());
  Eigen::VectorXd x(m_b.size());
  for(std::size_t i = 0; i < m_integers.size(); ++i)
    x[m_integers[i]] = y[i];
  const Eigen::VectorXd r = m_solver.solve(Eigen::VectorXd(m_rhs_of_reals - m_coupling * y));
  for(std::size_t i = 0; i < m_reals.size(); ++i)
    x[m_reals[i]] = r[i];
  return x;
}

CGAL_QUAD_MESHING_INLINE Eigen::VectorXd Integer_energy::integers_of(const Eigen::VectorXd& x) const
{
  return internal::subvector(x, m_integers);
}

CGAL_QUAD_MESHING_INLINE double Integer_energy::energy(const Eigen::VectorXd& x) const
{
  return x.dot(0.5 * (m_A * x) - m_b);
}

// The integers may leave directions without energy; they get a little.
CGAL_QUAD_MESHING_INLINE bool Integer_energy::invert_or_shift()
{
  if(m_S.size() == 0)
  {
    m_factor = m_S;
    return true;
  }
  const double largest = m_S.diagonal().cwiseAbs().maxCoeff();
  for(double relative_shift : { 1e-14, 1e-12, 1e-10, 1e-8 })
  {
    if(internal::factorize_dense(m_S, m_factor))
      return true;
    m_S.diagonal().array() += relative_shift * (largest > 0. ? largest : 1.);
  }
  return internal::factorize_dense(m_S, m_factor);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_INTEGER_ENERGY_IMPL_H
