// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The sparse Cholesky factorization against products with the matrix and dense solutions, real and complex, with the
// default solver and with one of the user.

#include <CGAL/Quad_meshing/Linear_algebra/Custom_sparse_cholesky.h>
#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>

#include "test_cases.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Random.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cassert>
#include <complex>
#include <memory>
#include <vector>

namespace QM = CGAL::Quad_meshing;

typedef std::complex<double> Complex;
typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_symmetric_matrix<double>::EigenType>>
  User_solver;

CGAL::Random& random_numbers()
{
  static CGAL::Random random(7);
  return random;
}

void set_random(double& v) { v = random_numbers().get_double(-1., 1.); }
void set_random(Complex& v)
{
  double re, im;
  set_random(re);
  set_random(im);
  v = Complex(re, im);
}

double conjugate(double v) { return v; }
Complex conjugate(const Complex& v) { return std::conj(v); }

// A Hermitian matrix with a dominant diagonal.
template <typename Number>
Eigen::SparseMatrix<Number> definite_matrix(int n)
{
  std::vector<Eigen::Triplet<Number>> triplets;
  for(int i = 0; i < n; ++i)
    triplets.emplace_back(i, i, Number(20.));
  for(int k = 0; k < 4 * n; ++k)
  {
    const int i = random_numbers().get_int(0, n), j = random_numbers().get_int(0, n);
    Number v;
    set_random(v);
    if(i != j)
    {
      triplets.emplace_back(i, j, v);
      triplets.emplace_back(j, i, conjugate(v));
    }
  }
  Eigen::SparseMatrix<Number> A(n, n);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

template <typename Number>
Eigen::SparseMatrix<Number> sparse_columns(int n, int m)
{
  std::vector<Eigen::Triplet<Number>> triplets;
  for(int k = 0; k < 20; ++k)
  {
    Number v;
    set_random(v);
    triplets.emplace_back(random_numbers().get_int(0, n), random_numbers().get_int(0, m), v);
  }
  Eigen::SparseMatrix<Number> B(n, m);
  B.setFromTriplets(triplets.begin(), triplets.end());
  return B;
}

template <typename Number>
void check_factorization(QM::Sparse_cholesky<Number> solver, bool has_factor)
{
  typedef Eigen::SparseMatrix<Number> Matrix;
  typedef Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> Dense_matrix;
  const int n = 200, m = 15;
  Matrix A = definite_matrix<Number>(n);
  const Matrix B = sparse_columns<Number>(n, m);

  solver.analyze(A);
  const double entries = solver.number_of_entries();
  assert(solver.compute(A) && solver.is_ok() && solver.size() == n && solver.number_of_factorizations() == 1);
  const Dense_matrix X = solver.solve(Dense_matrix(B));
  assert((A * X - Dense_matrix(B)).cwiseAbs().maxCoeff() < 1e-12);
  Dense_matrix product;
  solver.product_with_inverse(B, product);
  assert((product - B.adjoint() * X).cwiseAbs().maxCoeff() < 1e-12);
  std::vector<Number> x(n, Number(1));
  x = solver.solve(x);
  assert((A * Eigen::Map<Dense_matrix>(x.data(), n, 1) - Dense_matrix::Ones(n, 1)).cwiseAbs().maxCoeff() < 1e-12);

  // P A P' = L L*
  const std::unique_ptr<QM::Cholesky_factor<Number>> factor = solver.factor();
  assert((factor != nullptr) == has_factor);
  if(factor)
  {
    assert(entries >= n && entries <= factor->value.size());
    Dense_matrix L = Dense_matrix::Zero(n, n), permuted(n, n);
    for(int j = 0; j < n; ++j)
    {
      assert(factor->row[factor->column_begin[j]] == j);
      for(std::size_t p = factor->column_begin[j]; p < factor->column_begin[j + 1]; ++p)
      {
        assert(p == factor->column_begin[j] || factor->row[p - 1] < factor->row[p]);
        L(factor->row[p], j) = factor->value[p];
      }
    }
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
        permuted(i, j) = A.coeff(factor->permutation[i], factor->permutation[j]);
    assert((L * L.adjoint() - permuted).cwiseAbs().maxCoeff() < 1e-12);
  }

  // Only the lower triangle is read; the pattern may be used again; the matrix may be uncompressed.
  Matrix lower = A.template triangularView<Eigen::Lower>();
  lower *= 2.;
  QM::Sparse_cholesky<Number> half = solver.make_another();
  half.analyze(lower);
  assert(half.factorize(lower));
  assert((2. * half.solve(Dense_matrix(B)) - X).cwiseAbs().maxCoeff() < 1e-12);
  lower.uncompress();
  lower *= 0.5;
  assert(half.factorize(lower) && half.number_of_factorizations() == 2);
  assert((half.solve(Dense_matrix(B)) - X).cwiseAbs().maxCoeff() < 1e-12);

  // An empty matrix is definite, a zero is not.
  assert(solver.make_another().compute(Matrix(0, 0)));
  assert(!solver.make_another().compute(Matrix(3, 3)));
}

void real_numbers() { check_factorization(QM::Sparse_cholesky<double>(), true); }
void complex_numbers() { check_factorization(QM::Sparse_cholesky<Complex>(), true); }
void custom_solver() { check_factorization(QM::custom_sparse_cholesky<User_solver>(), false); }

void indefinite_matrices()
{
  Eigen::SparseMatrix<double> A = definite_matrix<double>(50);
  A.coeffRef(3, 3) = -1.;
  QM::Sparse_cholesky<double> solver;
  assert(!solver.compute(A) && !solver.is_ok());
  assert(!solver.compute_semidefinite(A));
}

// The Laplacian of a path with its constant null vector: any of its solutions will do.
void semidefinite_matrices()
{
  const int n = 30;
  std::vector<Eigen::Triplet<double>> triplets;
  for(int i = 0; i + 1 < n; ++i)
  {
    triplets.emplace_back(i, i, 1.);
    triplets.emplace_back(i + 1, i + 1, 1.);
    triplets.emplace_back(i, i + 1, -1.);
    triplets.emplace_back(i + 1, i, -1.);
  }
  Eigen::SparseMatrix<double> A(n, n);
  A.setFromTriplets(triplets.begin(), triplets.end());
  Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1., 1.);
  QM::Sparse_cholesky<double> solver;
  assert(solver.compute_semidefinite(A));
  assert(solver.shift() >= 0. && solver.shift() <= 1e-8 * 2.);
  assert((A * solver.solve(b) - b).cwiseAbs().maxCoeff() < 1e-4);
  assert(solver.compute_semidefinite(Eigen::SparseMatrix<double>(4, 4)) && solver.shift() > 0.);
  const Eigen::SparseMatrix<double> definite = definite_matrix<double>(20);
  assert(solver.compute_semidefinite(definite) && solver.shift() == 0.);
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   {
                     { "real_numbers", real_numbers },
                     { "complex_numbers", complex_numbers },
                     { "custom_solver", custom_solver },
                     { "indefinite_matrices", indefinite_matrices },
                     { "semidefinite_matrices", semidefinite_matrices },
                   });
}
