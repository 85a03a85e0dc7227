// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CGAL_LINEAR_SOLVER_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CGAL_LINEAR_SOLVER_H

#include <CGAL/Quad_meshing/Mixed_integer/Sparse_cholesky.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <memory>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Gives a model of `SparseLinearAlgebraWithFactorTraits_d` the interface of `Sparse_cholesky`.
template <typename SolverTraits>
class Cgal_linear_solver
{
public:
  bool compute(const Eigen::SparseMatrix<double>& A)
  {
    typedef typename SolverTraits::Matrix Matrix;
    m_size = static_cast<int>(A.rows());
    m_ok = true;
    if(m_size == 0)
      return true;
    m_matrix.reset(new Matrix(m_size, m_size));
    for(int j = 0; j < A.cols(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(A, j); it; ++it)
        m_matrix->set_coef(it.row(), it.col(), it.value(), true);
    typename SolverTraits::NT denominator;
    m_traits.reset(new SolverTraits);
    m_ok = m_traits->factor(*m_matrix, denominator);
    if(m_ok)
      m_ok = solve(Eigen::VectorXd(Eigen::VectorXd::Ones(m_size))).allFinite();
    return m_ok;
  }

  bool factorize(const Eigen::SparseMatrix<double>& A) { return compute(A); }

  bool ok() const { return m_ok; }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const
  {
    if(m_size == 0)
      return b;
    typename SolverTraits::Vector B(m_size), X(m_size);
    for(int i = 0; i < m_size; ++i)
      B[i] = b[i];
    m_traits->linear_solver(B, X);
    Eigen::VectorXd x(m_size);
    for(int i = 0; i < m_size; ++i)
      x[i] = X[i];
    return x;
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const
  {
    Eigen::MatrixXd X(B.rows(), B.cols());
    for(int j = 0; j < B.cols(); ++j)
      X.col(j) = solve(Eigen::VectorXd(B.col(j)));
    return X;
  }

  // B' A^-1 B
  Eigen::MatrixXd product_with_inverse(const Eigen::SparseMatrix<double>& B) const
  {
    const int columns_at_once = 64;
    const Eigen::SparseMatrix<double> transposed = B.transpose();
    Eigen::MatrixXd product(B.cols(), B.cols());
    for(int begin = 0; begin < B.cols(); begin += columns_at_once)
    {
      const int count = (std::min)(columns_at_once, static_cast<int>(B.cols()) - begin);
      product.middleCols(begin, count) = transposed * solve(Eigen::MatrixXd(B.middleCols(begin, count)));
    }
    return product;
  }

private:
  // The traits keep a pointer to the matrix.
  std::unique_ptr<typename SolverTraits::Matrix> m_matrix;
  std::unique_ptr<SolverTraits> m_traits;
  int m_size = 0;
  bool m_ok = false;
};

// The solver that goes with the type of the named parameter `sparse_linear_solver`.
template <typename SolverTraits>
struct Linear_solver_of
{
  typedef Cgal_linear_solver<SolverTraits> type;
};

template <>
struct Linear_solver_of<Sparse_cholesky>
{
  typedef Sparse_cholesky type;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CGAL_LINEAR_SOLVER_H
