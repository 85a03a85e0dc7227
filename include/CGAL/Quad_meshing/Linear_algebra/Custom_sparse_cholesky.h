// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors
#ifndef CGAL_QUAD_MESHING_LINEAR_ALGEBRA_CUSTOM_SPARSE_CHOLESKY_H
#define CGAL_QUAD_MESHING_LINEAR_ALGEBRA_CUSTOM_SPARSE_CHOLESKY_H

#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A model of `SparseLinearAlgebraWithFactorTraits_d` at work in a `Sparse_cholesky<double>`.
template <typename SolverTraits>
class Custom_cholesky_implementation : public Sparse_cholesky_implementation<double>
{
public:
  std::unique_ptr<Sparse_cholesky_implementation<double>> make_another() const override
  {
    return std::make_unique<Custom_cholesky_implementation>();
  }

  bool analyze(const View& A) override
  {
    m_size = A.rows;
    return true;
  }

  double number_of_entries() const override { return 0.; }

  bool factorize(const View& A) override
  {
    m_matrix = std::make_unique<typename SolverTraits::Matrix>(m_size, m_size);
    for(int j = 0; j < A.columns; ++j)
      for(int p = A.column_begin[j]; p < A.column_begin[j + 1]; ++p)
      {
        const int i = A.row[p];
        if(i < j)
          continue;
        m_matrix->set_coef(i, j, A.value[p], true);
        if(i > j)
          m_matrix->set_coef(j, i, A.value[p], true);
      }
    typename SolverTraits::NT denominator;
    m_traits = std::make_unique<SolverTraits>();
    if(!m_traits->factor(*m_matrix, denominator))
      return false;
    // Not every solver notices that a matrix is singular.
    std::vector<double> x(m_size, 1.);
    solve_in_place(x.data(), 1);
    return std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
  }

  void solve_in_place(double* columns, int number_of_columns) const override
  {
    typename SolverTraits::Vector B(m_size), X(m_size);
    for(int j = 0; j < number_of_columns; ++j, columns += m_size)
    {
      for(int i = 0; i < m_size; ++i)
        B[i] = columns[i];
      m_traits->linear_solver(B, X);
      for(int i = 0; i < m_size; ++i)
        columns[i] = X[i];
    }
  }

  void product_with_inverse(const View& B, double* result) const override
  {
    std::vector<double> x(m_size);
    for(int j = 0; j < B.columns; ++j)
    {
      std::fill(x.begin(), x.end(), 0.);
      for(int p = B.column_begin[j]; p < B.column_begin[j + 1]; ++p)
        x[B.row[p]] = B.value[p];
      solve_in_place(x.data(), 1);
      for(int i = 0; i < B.columns; ++i, ++result)
      {
        *result = 0.;
        for(int p = B.column_begin[i]; p < B.column_begin[i + 1]; ++p)
          *result += B.value[p] * x[B.row[p]];
      }
    }
  }

  std::unique_ptr<Cholesky_factor<double>> factor() const override { return nullptr; }

private:
  std::unique_ptr<typename SolverTraits::Matrix> m_matrix; // the traits keep a pointer to it
  std::unique_ptr<SolverTraits> m_traits;
  int m_size = 0;
};

} // namespace internal

/*!
\ingroup PkgQuadMeshingLinearAlgebraRef

\brief returns a factorization whose work a class of the user does. It knows no matrix yet.

The kernels of this package take it as a model of how they shall solve.

\tparam SolverTraits a model of `SparseLinearAlgebraWithFactorTraits_d` whose solver is made for symmetric positive
definite matrices or for all
*/
template <typename SolverTraits>
Sparse_cholesky<double> custom_sparse_cholesky()
{
  return Sparse_cholesky<double>(std::make_unique<internal::Custom_cholesky_implementation<SolverTraits>>());
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LINEAR_ALGEBRA_CUSTOM_SPARSE_CHOLESKY_H
