// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_SPARSE_CHOLESKY_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_SPARSE_CHOLESKY_H

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

private:
#ifdef CGAL_QUAD_MESHING_USE_CHOLMOD
  typedef Eigen::CholmodDecomposition<Matrix, Eigen::Lower> Solver;

  // LL' fails by itself on a matrix that is not positive definite.
  bool has_positive_pivots() const { return true; }
#else
  typedef Eigen::SimplicialLDLT<Matrix, Eigen::Lower> Solver;

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
