// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_REDUCED_PROBLEM_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_REDUCED_PROBLEM_H

#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Eliminated_constraints.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The nearest integer. Halves, up to round-off, go up: equal decisions for whichever solver computed `a`.
inline double nearest_integer(double a)
{
  const double tie = 1e-9;
  return std::floor(a + 0.5 + tie);
}

inline double distance_to_integer(double a) { return std::fabs(a - nearest_integer(a)); }

// The problem without its equality constraints: min 1/2 z'Az - z'b + constant, z_i integer for i in
// `integers`. The other variables are listed in `reals`; both lists ascend.
struct Reduced_problem
{
  Eigen::SparseMatrix<double> A;
  Eigen::VectorXd b;
  double constant = 0.;
  std::vector<int> integers, reals;

  int size() const { return static_cast<int>(b.size()); }
  double energy(const Eigen::VectorXd& z) const { return z.dot(0.5 * (A * z) - b) + constant; }
};

inline Reduced_problem reduce(const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& b, double constant,
                              const Eliminated_constraints& constraints)
{
  Reduced_problem reduced;
  if(constraints.is_identity)
  {
    reduced.A = A;
    reduced.b = b;
    reduced.constant = constant;
  }
  else
  {
    const Eigen::SparseMatrix<double>& T = constraints.T;
    const Eigen::VectorXd& t = constraints.t;
    const Eigen::SparseMatrix<double> transposed = T.transpose();
    const Eigen::SparseMatrix<double> AT = A * T;
    reduced.A = transposed * AT;
    const Eigen::VectorXd At = A * t;
    reduced.b = transposed * (b - At);
    reduced.constant = constant + t.dot(0.5 * At - b);
  }
  reduced.A.makeCompressed();
  for(std::size_t i = 0; i < constraints.is_integer.size(); ++i)
    (constraints.is_integer[i] ? reduced.integers : reduced.reals).push_back(static_cast<int>(i));
  return reduced;
}

// The rows `rows` and columns `columns` of a matrix.
inline Eigen::SparseMatrix<double> submatrix(const Eigen::SparseMatrix<double>& A, const std::vector<int>& rows,
                                             const std::vector<int>& columns)
{
  std::vector<int> position(A.rows(), -1);
  for(std::size_t i = 0; i < rows.size(); ++i)
    position[rows[i]] = static_cast<int>(i);
  Eigen::SparseMatrix<double> result(rows.size(), columns.size());
  if(columns.empty()) // for which `reserve()` leaves a matrix that cannot be compressed
    return result;
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(columns.size());
  for(std::size_t j = 0; j < columns.size(); ++j)
    for(Eigen::SparseMatrix<double>::InnerIterator it(A, columns[j]); it; ++it)
      counts[j] += (position[it.row()] >= 0);
  result.reserve(counts);
  for(std::size_t j = 0; j < columns.size(); ++j)
    for(Eigen::SparseMatrix<double>::InnerIterator it(A, columns[j]); it; ++it)
      if(position[it.row()] >= 0)
        result.insert(position[it.row()], static_cast<int>(j)) = it.value();
  result.makeCompressed();
  return result;
}

inline Eigen::VectorXd subvector(const Eigen::VectorXd& v, const std::vector<int>& indices)
{
  Eigen::VectorXd result(indices.size());
  for(std::size_t i = 0; i < indices.size(); ++i)
    result[i] = v[indices[i]];
  return result;
}

// Factorizes a semidefinite matrix and counts the attempts.
inline bool factorize_semidefinite(Sparse_cholesky<double>& solver, const Eigen::SparseMatrix<double>& A,
                                   int& factorizations)
{
  const int before = solver.number_of_factorizations();
  const bool is_ok = solver.compute_semidefinite(A);
  factorizations += solver.number_of_factorizations() - before;
  return is_ok;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_REDUCED_PROBLEM_H
