// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LINEAR_ALGEBRA_INTERNAL_SUPERNODAL_FACTOR_H
#define CGAL_QUAD_MESHING_LINEAR_ALGEBRA_INTERNAL_SUPERNODAL_FACTOR_H

#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A view of a Cholesky factor, P A P' = L L*, by supernodes: runs of columns with one pattern, as dense blocks.
//
// Supernode k has the columns super[k], ..., super[k+1]-1. Its rows are rows[row_begin[k]], ...,
// rows[row_begin[k+1]-1], ascending; the first of them are its columns. Its block is stored column by column.
// Row i of L is row permutation[i] of A.
template <typename Number>
struct Supernodal_factor
{
  std::vector<int> permutation, super, row_begin, rows;
  std::vector<std::size_t> block_begin;
  const Number* blocks = nullptr;
  std::vector<Number> storage; // of the blocks, unless they belong to someone else

  int size() const { return static_cast<int>(permutation.size()); }
  int number_of_supernodes() const { return static_cast<int>(super.size()) - 1; }

  // Builds the blocks from L column by column, whose entries of column j are `begin[j]` to `end[j]`, ascending and
  // the diagonal first, and are multiplied with `scale[j]`.
  template <typename Index>
  void assign(int n, const Index* begin, const Index* end, const Index* indices, const Number* values,
              const Number* scale)
  {
    super.assign(1, 0);
    for(int j = 1; j <= n; ++j)
    {
      // Column j goes on with the pattern of column j - 1 without its diagonal.
      const bool continues =
        j < n && end[j - 1] - begin[j - 1] == end[j] - begin[j] + 1 && indices[begin[j - 1] + 1] == j;
      if(!continues)
        super.push_back(j);
    }
    row_begin.assign(1, 0);
    rows.clear();
    block_begin.assign(1, 0);
    for(int k = 0; k + 1 < static_cast<int>(super.size()); ++k)
    {
      const int first = super[k], columns = super[k + 1] - first;
      rows.insert(rows.end(), indices + begin[first], indices + end[first]);
      row_begin.push_back(static_cast<int>(rows.size()));
      block_begin.push_back(block_begin.back() + std::size_t(end[first] - begin[first]) * columns);
    }
    storage.assign(block_begin.back(), Number(0));
    for(int k = 0; k + 1 < static_cast<int>(super.size()); ++k)
    {
      const int first = super[k], height = row_begin[k + 1] - row_begin[k];
      for(int j = first; j < super[k + 1]; ++j)
      {
        Number* const column = storage.data() + block_begin[k] + std::size_t(j - first) * height;
        for(Index p = begin[j]; p < end[j]; ++p)
          column[(j - first) + (p - begin[j])] = values[p] * scale[j];
      }
    }
    blocks = storage.data();
  }

  // The columns one by one.
  Cholesky_factor<Number> columns() const
  {
    Cholesky_factor<Number> result;
    result.permutation = permutation;
    result.column_begin.assign(1, 0);
    for(int k = 0; k < number_of_supernodes(); ++k)
    {
      const int height = row_begin[k + 1] - row_begin[k];
      for(int j = 0; j < super[k + 1] - super[k]; ++j)
      {
        const Number* const column = blocks + block_begin[k] + std::size_t(j) * height;
        result.row.insert(result.row.end(), rows.begin() + row_begin[k] + j, rows.begin() + row_begin[k + 1]);
        result.value.insert(result.value.end(), column + j, column + height);
        result.column_begin.push_back(result.row.size());
      }
    }
    return result;
  }
};

// Computes B* A^-1 B for a sparse B with the factor of A, as Y*Y with Y = L^-1 P B.
//
// Only what B reaches is touched: the supernodes that hold its rows and their ancestors in the elimination tree,
// and in each of them only the columns of B that reach it.
template <typename Number>
class Supernodal_product
{
  typedef Eigen::SparseMatrix<Number> Matrix;
  typedef Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> Dense_matrix;
  typedef Eigen::Map<const Dense_matrix> Block;

public:
  Supernodal_product(const Supernodal_factor<Number>& factor, const Matrix& B) : m_factor(factor), m_B(B) {}

  Dense_matrix run()
  {
    find_reach();
    Dense_matrix product = Dense_matrix::Zero(m_B.cols(), m_B.cols());
    for(int k = 0; k < m_factor.number_of_supernodes(); ++k)
      if(!m_columns[k].empty())
        process(k, product);
    product.template triangularView<Eigen::StrictlyUpper>() = product.adjoint();
    return product;
  }

private:
  void find_reach()
  {
    const int n = m_factor.size(), count = m_factor.number_of_supernodes();
    m_supernode_of.resize(n);
    for(int k = 0; k < count; ++k)
      std::fill(m_supernode_of.begin() + m_factor.super[k], m_supernode_of.begin() + m_factor.super[k + 1], k);
    std::vector<int> row_of(n);
    for(int i = 0; i < n; ++i)
      row_of[m_factor.permutation[i]] = i;

    m_columns.assign(count, std::vector<int>());
    for(int j = 0; j < m_B.cols(); ++j)
      for(typename Matrix::InnerIterator it(m_B, j); it; ++it)
      {
        // A column that was here before was at all the ancestors, too.
        int k = m_supernode_of[row_of[it.row()]];
        while(k >= 0 && (m_columns[k].empty() || m_columns[k].back() != j))
        {
          m_columns[k].push_back(j);
          k = parent(k);
        }
      }
    m_values.resize(count);
    for(int k = 0; k < count; ++k)
      m_values[k] = Dense_matrix::Zero(m_columns[k].empty() ? 0 : width(k), m_columns[k].size());
    for(int j = 0; j < m_B.cols(); ++j)
      for(typename Matrix::InnerIterator it(m_B, j); it; ++it)
      {
        const int row = row_of[it.row()], k = m_supernode_of[row];
        m_values[k](row - m_factor.super[k], position(k, j)) = it.value();
      }
  }

  int width(int k) const { return m_factor.super[k + 1] - m_factor.super[k]; }
  int height(int k) const { return m_factor.row_begin[k + 1] - m_factor.row_begin[k]; }

  int parent(int k) const
  {
    return height(k) == width(k) ? -1 : m_supernode_of[m_factor.rows[m_factor.row_begin[k] + width(k)]];
  }

  int position(int k, int column) const
  {
    return static_cast<int>(std::lower_bound(m_columns[k].begin(), m_columns[k].end(), column) - m_columns[k].begin());
  }

  void process(int k, Dense_matrix& product)
  {
    const int w = width(k), h = height(k);
    const std::vector<int>& columns = m_columns[k];
    const int count = static_cast<int>(columns.size());
    const Block block(m_factor.blocks + m_factor.block_begin[k], h, w);
    Dense_matrix& Y = m_values[k];
    block.topRows(w).template triangularView<Eigen::Lower>().solveInPlace(Y);

    m_gram.resize(count, count);
    m_gram.noalias() = Y.adjoint() * Y;
    for(int a = 0; a < count; ++a)
      for(int b = a; b < count; ++b)
        product(columns[b], columns[a]) += m_gram(b, a);

    if(h > w)
    {
      m_update.noalias() = block.bottomRows(h - w) * Y;
      m_positions.resize(count);
      int ancestor = -1;
      for(int i = 0; i < h - w; ++i)
      {
        const int row = m_factor.rows[m_factor.row_begin[k] + w + i];
        if(m_supernode_of[row] != ancestor)
        {
          ancestor = m_supernode_of[row];
          std::size_t p = 0;
          for(int a = 0; a < count; ++a)
          {
            while(m_columns[ancestor][p] != columns[a])
              ++p;
            m_positions[a] = static_cast<int>(p);
          }
        }
        const int target = row - m_factor.super[ancestor];
        for(int a = 0; a < count; ++a)
          m_values[ancestor](target, m_positions[a]) -= m_update(i, a);
      }
    }
    Y.resize(0, 0);
  }

  const Supernodal_factor<Number>& m_factor;
  const Matrix& m_B;
  std::vector<int> m_supernode_of;
  std::vector<std::vector<int>> m_columns; // of B that reach a supernode, ascending
  std::vector<Dense_matrix> m_values;      // the rows of Y of a supernode, for these columns
  Dense_matrix m_gram, m_update;
  std::vector<int> m_positions;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LINEAR_ALGEBRA_INTERNAL_SUPERNODAL_FACTOR_H
