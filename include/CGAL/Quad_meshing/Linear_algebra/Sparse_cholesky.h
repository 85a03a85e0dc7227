// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LINEAR_ALGEBRA_SPARSE_CHOLESKY_H
#define CGAL_QUAD_MESHING_LINEAR_ALGEBRA_SPARSE_CHOLESKY_H

#include <CGAL/Quad_meshing/Linear_algebra/Sparse_matrix_view.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <CGAL/assertions.h>

#include <complex>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingLinearAlgebraRef

\brief The factor \f$ L \f$ of \f$ P A P^T = L L^* \f$ by columns.
*/
template <typename Number>
struct Cholesky_factor
{
  std::vector<int> permutation;          ///< row `i` of the factor is row `permutation[i]` of the matrix
  std::vector<std::size_t> column_begin; ///< the entries of column `j` begin here and end where those of `j + 1` begin
  std::vector<int> row;                  ///< of each entry; in a column they ascend, the diagonal is the first one
  std::vector<Number> value;             ///< of each entry
};

/*!
\ingroup PkgQuadMeshingLinearAlgebraRef

\brief What a `Sparse_cholesky` asks of the one who does its work.
*/
template <typename Number>
class Sparse_cholesky_implementation
{
public:
  typedef Sparse_matrix_view<Number> View;

  virtual ~Sparse_cholesky_implementation() = default;

  /// returns a new object of the same type that knows no matrix.
  virtual std::unique_ptr<Sparse_cholesky_implementation> make_another() const = 0;
  /// learns the pattern of a matrix, and returns whether that was possible.
  virtual bool analyze(const View& A) = 0;
  /// returns the number of entries that the factor will have by the pattern last analyzed, 0 if that is not known.
  virtual double number_of_entries() const = 0;
  /// factorizes a matrix that is not empty and has the pattern last analyzed. Returns whether it is positive definite.
  virtual bool factorize(const View& A) = 0;
  /// solves for each column of a dense matrix, stored column by column, and writes the solutions there.
  virtual void solve_in_place(Number* columns, int number_of_columns) const = 0;
  /// writes \f$ B^* A^{-1} B \f$ to `result`, column by column.
  virtual void product_with_inverse(const View& B, Number* result) const = 0;
  /// returns the factor, or nothing if it cannot be had.
  virtual std::unique_ptr<Cholesky_factor<Number>> factor() const = 0;
};

/*!
\ingroup PkgQuadMeshingLinearAlgebraRef

\brief The sparse Cholesky factorization of a positive definite matrix, symmetric or Hermitian.

This is the one place of the package that chooses the solver: CHOLMOD if `CGAL_QUAD_MESHING_USE_CHOLMOD` is defined,
else Eigen. CHOLMOD runs in one thread, as far as its version allows: its parallel loops cost more than they bring on
the systems of this package, and results should not depend on the machine. Neither library shows in this header.

Matrices are given as a `Sparse_matrix_view` or as an `Eigen::SparseMatrix<Number>`. Only the lower triangle
of the matrix is read. It need not outlive the factorization.

\cgalHeading{Copies}
An object can be moved but not copied.

\tparam Number `double` or `std::complex<double>`

\sa `custom_sparse_cholesky()`
*/
template <typename Number = double>
class Sparse_cholesky
{
public:
  typedef Sparse_matrix_view<Number> View;
  typedef Sparse_cholesky_implementation<Number> Implementation;

  /// factorizes with CHOLMOD or Eigen.
  CGAL_QUAD_MESHING_INLINE Sparse_cholesky();
  /// factorizes with something else.
  explicit Sparse_cholesky(std::unique_ptr<Implementation> implementation) : m_implementation(std::move(implementation))
  {
  }

  /// returns a new object that works in the same way and knows no matrix.
  Sparse_cholesky make_another() const { return Sparse_cholesky(m_implementation->make_another()); }

  /// \name Factorization
  /// @{

  /// computes the fill-reducing order and the pattern of the factor of `A`.
  void analyze(const View& A)
  {
    CGAL_precondition(A.rows == A.columns);
    m_size = A.rows;
    m_is_ok = false;
    // A matrix without entries is singular, and its arrays may not exist.
    m_is_analyzed = m_size == 0 || (A.entries() > 0 && m_implementation->analyze(A));
  }
  /// the same for a sparse matrix of Eigen, or what has its interface.
  template <typename EigenSparseMatrix>
  void analyze(const EigenSparseMatrix& A)
  {
    call_with_view(A, [this](const View& view) { analyze(view); });
  }

  /// returns the number of entries that the factor will have by the pattern last analyzed, 0 if a custom
  /// implementation does not tell.
  double number_of_entries() const { return m_is_analyzed && m_size > 0 ? m_implementation->number_of_entries() : 0.; }

  /// computes the factor of `A`, which must have the pattern last analyzed; analyzes first if nothing was.
  /// \return `is_ok()`
  bool factorize(const View& A)
  {
    if(!m_is_analyzed || A.rows != m_size)
      analyze(A);
    ++m_number_of_factorizations;
    m_is_ok = m_is_analyzed && (m_size == 0 || m_implementation->factorize(A));
    return m_is_ok;
  }
  /// the same for a sparse matrix of Eigen, or what has its interface.
  template <typename EigenSparseMatrix>
  bool factorize(const EigenSparseMatrix& A)
  {
    call_with_view(A, [this](const View& view) { factorize(view); });
    return m_is_ok;
  }

  /// analyzes and factorizes `A`.
  /// \return `is_ok()`
  bool compute(const View& A)
  {
    analyze(A);
    return factorize(A);
  }
  /// the same for a sparse matrix of Eigen, or what has its interface.
  template <typename EigenSparseMatrix>
  bool compute(const EigenSparseMatrix& A)
  {
    call_with_view(A, [this](const View& view) { compute(view); });
    return m_is_ok;
  }

  /// analyzes and factorizes a matrix that may be semidefinite: should it be singular, the smallest of a few
  /// multiples of its largest entry that helps is added to its diagonal. Where a singular system has many solutions
  /// this chooses one of them.
  /// \return `is_ok()`
  CGAL_QUAD_MESHING_INLINE bool compute_semidefinite(const View& A);
  /// the same for a sparse matrix of Eigen, or what has its interface.
  template <typename EigenSparseMatrix>
  bool compute_semidefinite(const EigenSparseMatrix& A)
  {
    call_with_view(A, [this](const View& view) { compute_semidefinite(view); });
    return m_is_ok;
  }

  /// tells whether the last factorization succeeded, that is, whether the matrix was positive definite.
  bool is_ok() const { return m_is_ok; }

  /// returns how many numerical factorizations there were.
  int number_of_factorizations() const { return m_number_of_factorizations; }

  /// returns what `compute_semidefinite()` had to add to the diagonal, 0 if the matrix was definite.
  double shift() const { return m_shift; }

  /// returns the number of rows of the matrix.
  int size() const { return m_size; }

  /// @}
  /// \name Solutions
  /// @{

  /// solves for every column of a dense matrix, stored column by column, and writes the solutions there.
  /// \pre `is_ok()`
  void solve_in_place(Number* columns, int number_of_columns = 1) const
  {
    CGAL_precondition(m_is_ok);
    if(m_size > 0 && number_of_columns > 0)
      m_implementation->solve_in_place(columns, number_of_columns);
  }

  /// solves for a vector or for all the columns of a dense matrix of Eigen, or for a `std::vector<Number>`.
  /// \pre `is_ok()`
  template <typename DenseMatrix>
  DenseMatrix solve(DenseMatrix b) const
  {
    CGAL_precondition(m_size == 0 || b.size() % m_size == 0);
    solve_in_place(b.data(), m_size == 0 ? 0 : static_cast<int>(b.size() / m_size));
    return b;
  }

  /// computes \f$ B^* A^{-1} B \f$ for a sparse `B`, in less time than solving for all its columns: only the parts of
  /// the factor that the columns reach are visited, and no back substitution is made. `result` has as many rows and
  /// columns as `B` has columns, and is stored column by column.
  /// \pre `is_ok()`
  void product_with_inverse(const View& B, Number* result) const
  {
    CGAL_precondition(m_is_ok && B.rows == m_size);
    const std::size_t size = std::size_t(B.columns) * B.columns;
    if(m_size > 0 && B.columns > 0)
      m_implementation->product_with_inverse(B, result);
    else
      for(std::size_t i = 0; i < size; ++i)
        result[i] = Number(0);
  }
  /// the same for matrices of Eigen.
  template <typename EigenSparseMatrix, typename EigenDenseMatrix>
  void product_with_inverse(const EigenSparseMatrix& B, EigenDenseMatrix& result) const
  {
    result.resize(B.cols(), B.cols());
    call_with_view(B, [&](const View& view) { product_with_inverse(view, result.data()); });
  }

  /// returns the factor, or nothing if a custom implementation does not give it.
  /// \pre `is_ok()`
  std::unique_ptr<Cholesky_factor<Number>> factor() const
  {
    CGAL_precondition(m_is_ok);
    return m_size > 0 ? m_implementation->factor() : std::make_unique<Cholesky_factor<Number>>();
  }

  /// @}

private:
  template <typename EigenSparseMatrix, typename Function>
  static void call_with_view(const EigenSparseMatrix& A, const Function& function)
  {
    if(A.isCompressed())
    {
      function(view_of_compressed(A));
      return;
    }
    EigenSparseMatrix compressed(A);
    compressed.makeCompressed();
    function(view_of_compressed(compressed));
  }

  std::unique_ptr<Implementation> m_implementation;
  int m_size = 0;
  int m_number_of_factorizations = 0;
  double m_shift = 0;
  bool m_is_analyzed = false;
  bool m_is_ok = false;
};

#ifdef CGAL_QUAD_MESHING_COMPILED_KERNELS
extern template class Sparse_cholesky<double>;
extern template class Sparse_cholesky<std::complex<double>>;
#endif

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Linear_algebra/internal/Sparse_cholesky_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_LINEAR_ALGEBRA_SPARSE_CHOLESKY_H
