// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_SPARSE_CHOLESKY_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_SPARSE_CHOLESKY_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Supernodal_factor.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#ifdef CGAL_QUAD_MESHING_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#ifdef _OPENMP
#include <omp.h>
#endif
#endif

#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief The sparse Cholesky factorization of a symmetric positive definite matrix.

This is the one place of the package that chooses the solver: CHOLMOD if
`CGAL_QUAD_MESHING_USE_CHOLMOD` is defined, else `Eigen::SimplicialLDLT`. CHOLMOD runs in one thread, as
far as its version allows: its parallel loops cost more than they bring on the systems of this package,
and results should not depend on the machine.

Only the lower triangle of the matrix is read. The matrix need not outlive the factorization.

\cgalHeading{Copies}
An object can be moved but not copied.
*/
class Sparse_cholesky
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;

  Sparse_cholesky() : m_size(0), m_analyzed(false), m_ok(false) {}

  /// computes the fill-reducing order and the pattern of the factor of `A`.
  void analyze(const Matrix& A)
  {
    CGAL_precondition(A.rows() == A.cols());
    m_size = static_cast<int>(A.rows());
    m_ok = false;
    m_analyzed = true;
    if(m_size == 0)
      return;
    m_solver.reset(new Solver);
#ifdef CGAL_QUAD_MESHING_USE_CHOLMOD
    m_solver->cholmod().print = 0;
    m_solver->cholmod().final_ll = 1; // LDL' would go on with negative pivots
#if CHOLMOD_MAIN_VERSION >= 4
    m_solver->cholmod().nthreads_max = 1;
#endif
#endif
    m_analyzed = A.nonZeros() > 0; // an empty matrix is singular, and its arrays may not exist
    if(!m_analyzed)
      return;
    m_solver->analyzePattern(A);
    m_analyzed = (m_solver->info() == Eigen::Success);
  }

  /// computes the factor of `A`, which must have the pattern last analyzed; analyzes first if nothing was.
  /// \return `ok()`
  bool factorize(const Matrix& A)
  {
    if(!m_analyzed || A.rows() != m_size)
      analyze(A);
    if(m_size == 0)
      return m_ok = true;
    if(!m_analyzed)
      return m_ok = false;
    const Single_thread_scope single_thread;
    m_solver->factorize(A);
    m_ok = (m_solver->info() == Eigen::Success) && has_positive_pivots();
    return m_ok;
  }

  /// analyzes and factorizes `A`.
  /// \return `ok()`
  bool compute(const Matrix& A)
  {
    analyze(A);
    return factorize(A);
  }

  /// tells whether the last factorization succeeded, that is, whether the matrix was positive definite.
  bool ok() const { return m_ok; }

  /// returns the number of rows of the matrix.
  int size() const { return m_size; }

  /// solves for one right-hand side.
  /// \pre `ok()`
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const
  {
    CGAL_precondition(m_ok && b.size() == m_size);
    if(m_size == 0)
      return b;
    const Single_thread_scope single_thread;
    return m_solver->solve(b);
  }

  /// solves for all the columns of a dense matrix.
  /// \pre `ok()`
  Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const
  {
    CGAL_precondition(m_ok && B.rows() == m_size);
    if(m_size == 0 || B.cols() == 0)
      return B;
    const Single_thread_scope single_thread;
    return m_solver->solve(B);
  }

  /// returns \f$ B^T A^{-1} B \f$ for a sparse `B`, in less time than solving for all its columns:
  /// only the parts of the factor that the columns reach are visited, and no back substitution is made.
  /// \pre `ok()`
  Eigen::MatrixXd product_with_inverse(const Matrix& B) const
  {
    CGAL_precondition(m_ok && B.rows() == m_size);
    if(m_size == 0 || B.cols() == 0)
      return Eigen::MatrixXd::Zero(B.cols(), B.cols());
    internal::Supernodal_factor factor;
    view_factor(factor);
    return internal::Supernodal_product(factor, B).run();
  }

private:
#ifdef CGAL_QUAD_MESHING_USE_CHOLMOD
  // Gives access to the factor.
  struct Solver : Eigen::CholmodDecomposition<Matrix, Eigen::Lower>
  {
    const cholmod_factor& factor() const { return *this->m_cholmodFactor; }
  };

  void view_factor(internal::Supernodal_factor& view) const
  {
    const cholmod_factor& L = m_solver->factor();
    const int* const permutation = static_cast<const int*>(L.Perm);
    view.permutation.assign(permutation, permutation + L.n);
    const double* const x = static_cast<const double*>(L.x);
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
    const std::vector<double> ones(L.n, 1.);
    view.assign(m_size, begin, end.data(), static_cast<const int*>(L.i), x, ones.data());
  }

  // LL' fails by itself on a matrix that is not positive definite.
  bool has_positive_pivots() const { return true; }
#else
  typedef Eigen::SimplicialLDLT<Matrix, Eigen::Lower> Solver;

  void view_factor(internal::Supernodal_factor& view) const
  {
    // Eigen stores L without its unit diagonal, and the permutation that takes a row of A to one of L.
    const Eigen::SparseMatrix<double>& strict = m_solver->matrixL().nestedExpression();
    const Eigen::VectorXd scale = m_solver->vectorD().cwiseSqrt();
    const Eigen::VectorXi to_factor = m_solver->permutationP().indices();
    std::vector<int> begin(1, 0), indices;
    std::vector<double> values;
    begin.reserve(m_size + 1);
    indices.reserve(strict.nonZeros() + m_size);
    values.reserve(strict.nonZeros() + m_size);
    for(int j = 0; j < m_size; ++j)
    {
      indices.push_back(j);
      values.push_back(1.);
      for(Matrix::InnerIterator it(strict, j); it; ++it)
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
    const Eigen::VectorXd d = m_solver->vectorD();
    return d.allFinite() && d.minCoeff() > 0.;
  }
#endif

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

  std::unique_ptr<Solver> m_solver;
  int m_size;
  bool m_analyzed;
  bool m_ok;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_SPARSE_CHOLESKY_H
