// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors
#ifndef CGAL_QUAD_MESHING_LINEAR_ALGEBRA_INTERNAL_SPARSE_CHOLESKY_IMPL_H
#define CGAL_QUAD_MESHING_LINEAR_ALGEBRA_INTERNAL_SPARSE_CHOLESKY_IMPL_H

#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Linear_algebra/internal/Supernodal_factor.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#ifdef CGAL_QUAD_MESHING_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#ifdef _OPENMP
#include <omp.h>
#endif
#endif

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Keeps the parallel loops of CHOLMOD 3, whose number of threads is fixed when it is compiled, serial.
struct Single_thread_scope
{
#if defined(CGAL_QUAD_MESHING_USE_CHOLMOD) && defined(_OPENMP)
  Single_thread_scope() : levels(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  ~Single_thread_scope() { omp_set_max_active_levels(levels); }
  int levels;
#else
  Single_thread_scope() {}
  ~Single_thread_scope() {}
#endif
};

template <typename Number>
Eigen::Map<const Eigen::SparseMatrix<Number>> map_of(const Sparse_matrix_view<Number>& A)
{
  return { A.rows, A.columns, A.entries(), A.column_begin, A.row, A.value };
}

// CHOLMOD or Eigen at work in a `Sparse_cholesky`.
template <typename Number>
class Default_cholesky_implementation : public Sparse_cholesky_implementation<Number>
{
  typedef Sparse_cholesky_implementation<Number> Base;
  typedef Eigen::SparseMatrix<Number> Matrix;
  typedef Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> Dense_matrix;

public:
  typedef typename Base::View View;

  std::unique_ptr<Base> make_another() const override { return std::make_unique<Default_cholesky_implementation>(); }

  bool analyze(const View& A) override
  {
    m_size = A.rows;
    m_solver = std::make_unique<Solver>();
#ifdef CGAL_QUAD_MESHING_USE_CHOLMOD
    m_solver->cholmod().print = 0;
    m_solver->cholmod().final_ll = 1; // LDL' would go on with negative pivots
#if CHOLMOD_MAIN_VERSION >= 4
    m_solver->cholmod().nthreads_max = 1;
#endif
#endif
    m_solver->analyzePattern(Matrix(map_of(A)));
    return m_solver->info() == Eigen::Success;
  }

  double number_of_entries() const override { return m_solver->number_of_entries(); }

  bool factorize(const View& A) override
  {
    const Single_thread_scope single_thread;
    m_solver->factorize(Matrix(map_of(A)));
    return m_solver->info() == Eigen::Success && has_positive_pivots();
  }

  void solve_in_place(Number* columns, int number_of_columns) const override
  {
    const Single_thread_scope single_thread;
    Eigen::Map<Dense_matrix> x(columns, m_size, number_of_columns);
    const Dense_matrix b = x;
    x = m_solver->solve(b);
  }

  void product_with_inverse(const View& B, Number* result) const override
  {
    Supernodal_factor<Number> factor;
    view_factor(factor);
    const Matrix copy = map_of(B);
    Eigen::Map<Dense_matrix>(result, B.columns, B.columns) = Supernodal_product<Number>(factor, copy).run();
  }

  std::unique_ptr<Cholesky_factor<Number>> factor() const override
  {
    Supernodal_factor<Number> blocks;
    view_factor(blocks);
    return std::make_unique<Cholesky_factor<Number>>(blocks.columns());
  }

private:
#ifdef CGAL_QUAD_MESHING_USE_CHOLMOD
  // Gives access to the factor.
  struct Solver : Eigen::CholmodDecomposition<Matrix, Eigen::Lower>
  {
    const cholmod_factor& factor() const { return *this->m_cholmodFactor; }
    double number_of_entries() { return this->cholmod().lnz; }
  };

  void view_factor(Supernodal_factor<Number>& view) const
  {
    const cholmod_factor& L = m_solver->factor();
    const int* const permutation = static_cast<const int*>(L.Perm);
    view.permutation.assign(permutation, permutation + L.n);
    const Number* const x = static_cast<const Number*>(L.x);
    if(L.is_super)
    {
      const int* const super = static_cast<const int*>(L.super);
      const int* const pi = static_cast<const int*>(L.pi);
      const int* const px = static_cast<const int*>(L.px);
      const int* const s = static_cast<const int*>(L.s);
      view.super.assign(super, super + L.nsuper + 1);
      view.row_begin.assign(pi, pi + L.nsuper + 1);
      view.block_begin.assign(px, px + L.nsuper + 1);
      view.rows.assign(s, s + pi[L.nsuper]);
      view.blocks = x;
      return;
    }
    const int* const begin = static_cast<const int*>(L.p);
    const int* const count = static_cast<const int*>(L.nz);
    std::vector<int> end(L.n);
    for(std::size_t j = 0; j < L.n; ++j)
      end[j] = begin[j] + count[j];
    const std::vector<Number> ones(L.n, Number(1));
    view.assign(m_size, begin, end.data(), static_cast<const int*>(L.i), x, ones.data());
  }

  // LL' fails by itself on a matrix that is not positive definite.
  bool has_positive_pivots() const { return true; }
#else
  struct Solver : Eigen::SimplicialLDLT<Matrix, Eigen::Lower>
  {
    double number_of_entries() const
    {
      // The analysis makes room for the factor without its diagonal.
      return double(this->m_matrix.cols()) + this->m_matrix.outerIndexPtr()[this->m_matrix.cols()];
    }
  };

  void view_factor(Supernodal_factor<Number>& view) const
  {
    // Eigen stores L without its unit diagonal, and the permutation that takes a row of A to one of L.
    const Matrix& strict = m_solver->matrixL().nestedExpression();
    const Eigen::Matrix<Number, Eigen::Dynamic, 1> scale = m_solver->vectorD().cwiseSqrt();
    const Eigen::VectorXi to_factor = m_solver->permutationP().indices();
    std::vector<int> begin(1, 0), indices;
    std::vector<Number> values;
    begin.reserve(m_size + 1);
    indices.reserve(strict.nonZeros() + m_size);
    values.reserve(strict.nonZeros() + m_size);
    for(int j = 0; j < m_size; ++j)
    {
      indices.push_back(j);
      values.push_back(Number(1));
      for(typename Matrix::InnerIterator it(strict, j); it; ++it)
        if(it.row() > j)
        {
          indices.push_back(static_cast<int>(it.row()));
          values.push_back(it.value());
        }
      begin.push_back(static_cast<int>(indices.size()));
    }
    view.permutation.resize(m_size);
    for(int i = 0; i < m_size; ++i)
      view.permutation[to_factor.size() > 0 ? to_factor[i] : i] = i;
    view.assign(m_size, begin.data(), begin.data() + 1, indices.data(), values.data(), scale.data());
  }

  bool has_positive_pivots() const
  {
    const Eigen::VectorXd d = m_solver->vectorD().real();
    return d.allFinite() && d.minCoeff() > 0.;
  }
#endif

  std::unique_ptr<Solver> m_solver;
  int m_size = 0;
};

} // namespace internal

template <typename Number>
CGAL_QUAD_MESHING_INLINE Sparse_cholesky<Number>::Sparse_cholesky()
  : m_implementation(std::make_unique<internal::Default_cholesky_implementation<Number>>())
{
}

template <typename Number>
CGAL_QUAD_MESHING_INLINE bool Sparse_cholesky<Number>::compute_semidefinite(const View& A)
{
  // Relative to the largest diagonal entry: from what round-off leaves of a zero to what an accurate solution still
  // bears.
  const double relative_shifts[] = { 1e-12, 1e-10, 1e-8 };

  m_shift = 0;
  if(compute(A))
    return true;
  Eigen::SparseMatrix<Number> identity(A.rows, A.rows), matrix(A.rows, A.rows);
  identity.setIdentity();
  if(A.entries() > 0)
    matrix = internal::map_of(A);
  double largest = 0.;
  for(int i = 0; i < A.rows; ++i)
    largest = (std::max)(largest, std::abs(matrix.coeff(i, i)));
  if(!(largest > 0.))
    largest = 1.;
  for(double relative_shift : relative_shifts)
  {
    m_shift = relative_shift * largest;
    if(compute(Eigen::SparseMatrix<Number>(matrix + Number(m_shift) * identity)))
      return true;
  }
  return false;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LINEAR_ALGEBRA_INTERNAL_SPARSE_CHOLESKY_IMPL_H
