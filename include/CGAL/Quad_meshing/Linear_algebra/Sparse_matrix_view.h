// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LINEAR_ALGEBRA_SPARSE_MATRIX_VIEW_H
#define CGAL_QUAD_MESHING_LINEAR_ALGEBRA_SPARSE_MATRIX_VIEW_H

#include <type_traits>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingLinearAlgebraRef

\brief The arrays of a sparse matrix in compressed columns, which belong to someone else.

The entries of column `j` are numbered from `column_begin[j]` to `column_begin[j + 1]`, with ascending rows.

\tparam Number `double` or `std::complex<double>`
*/
template <typename Number>
struct Sparse_matrix_view
{
  int rows = 0, columns = 0;
  const int* column_begin = nullptr; ///< `columns + 1` numbers
  const int* row = nullptr;          ///< of each entry
  const Number* value = nullptr;     ///< of each entry

  /// returns the number of entries.
  int entries() const { return columns == 0 ? 0 : column_begin[columns]; }
};

/*!
\ingroup PkgQuadMeshingLinearAlgebraRef

\brief views a matrix with the interface of `Eigen::SparseMatrix`, without a need for Eigen's headers.

\pre the matrix is stored by columns and compressed
*/
template <typename EigenSparseMatrix>
Sparse_matrix_view<typename EigenSparseMatrix::Scalar> view_of_compressed(const EigenSparseMatrix& matrix)
{
  static_assert(!EigenSparseMatrix::IsRowMajor, "The matrix must be stored by columns.");
  static_assert(std::is_same<typename EigenSparseMatrix::StorageIndex, int>::value, "Indices must be of type int.");
  Sparse_matrix_view<typename EigenSparseMatrix::Scalar> view;
  view.rows = static_cast<int>(matrix.rows());
  view.columns = static_cast<int>(matrix.cols());
  view.column_begin = matrix.outerIndexPtr();
  view.row = matrix.innerIndexPtr();
  view.value = matrix.valuePtr();
  return view;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LINEAR_ALGEBRA_SPARSE_MATRIX_VIEW_H
