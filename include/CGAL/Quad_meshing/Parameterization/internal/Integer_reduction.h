// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_INTEGER_REDUCTION_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_INTEGER_REDUCTION_H

#include <CGAL/Quad_meshing/Mixed_integer/Sparse_cholesky.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A quadratic energy 1/2 x'Ax - x'b seen as an energy of its integer variables y alone, the real ones being optimal:
// 1/2 y'Sy - y'c + const with the Schur complement S. One sparse factorization serves every choice of the integers, so
// the roundings can be revised as often as needed.
class Integer_reduction
{
public:
  std::vector<int> integers, reals; // variables of x
  Eigen::MatrixXd S;
  Eigen::VectorXd c;

  // Factorizes the part of the real variables; enough for `complete()`. Returns false if it is not definite.
  bool factorize(const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& b, const std::vector<bool>& is_integer)
  {
    matrix = A;
    rhs = b;
    const int n = static_cast<int>(A.rows());
    std::vector<int> number(n);
    integers.clear();
    reals.clear();
    for(int i = 0; i < n; ++i)
    {
      std::vector<int>& list = is_integer[i] ? integers : reals;
      number[i] = static_cast<int>(list.size());
      list.push_back(i);
    }
    const int ni = static_cast<int>(integers.size()), nr = static_cast<int>(reals.size());
    std::vector<Eigen::Triplet<double> > rr, ri;
    rr.reserve(A.nonZeros());
    S.setZero(ni, ni);
    for(int k = 0; k < A.outerSize(); ++k)
      for(Eigen::SparseMatrix<double>::InnerIterator it(A, k); it; ++it)
      {
        const int i = static_cast<int>(it.row()), j = static_cast<int>(it.col());
        if(is_integer[i] && is_integer[j])
          S(number[i], number[j]) = it.value();
        else if(!is_integer[i] && !is_integer[j])
          rr.emplace_back(number[i], number[j], it.value());
        else if(!is_integer[i])
          ri.emplace_back(number[i], number[j], it.value());
      }
    Eigen::SparseMatrix<double> RR(nr, nr);
    RR.setFromTriplets(rr.begin(), rr.end());
    RI.resize(nr, ni);
    RI.setFromTriplets(ri.begin(), ri.end());
    return nr == 0 || solver.compute(RR);
  }

  // Factorizes, then computes S and c. Returns false if the energy is not definite in the real variables.
  bool compute(const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& b, const std::vector<bool>& is_integer)
  {
    if(!factorize(A, b, is_integer))
      return false;
    const int ni = static_cast<int>(integers.size());
    c.resize(ni);
    for(int i = 0; i < ni; ++i)
      c[i] = b[integers[i]];
    if(reals.empty())
      return true;
    c -= RI.transpose() * solver.solve(rhs_of_reals());
    // In blocks of columns: all of them at once are a dense matrix of the size of the mesh times the integers.
    const int block = 64;
    for(int j = 0; j < ni; j += block)
    {
      const int m = (std::min)(block, ni - j);
      S.middleCols(j, m) -= RI.transpose() * solver.solve(Eigen::MatrixXd(RI.middleCols(j, m)));
    }
    S = (0.5 * (S + S.transpose())).eval();
    return true;
  }

  // All variables, the real ones optimal for the given integers.
  Eigen::VectorXd complete(const Eigen::VectorXd& y) const
  {
    Eigen::VectorXd x(integers.size() + reals.size());
    for(std::size_t i = 0; i < integers.size(); ++i)
      x[integers[i]] = y[i];
    if(reals.empty())
      return x;
    const Eigen::VectorXd r = solver.solve(Eigen::VectorXd(rhs_of_reals() - RI * y));
    for(std::size_t i = 0; i < reals.size(); ++i)
      x[reals[i]] = r[i];
    return x;
  }

  // The integer variables of an assignment of all.
  Eigen::VectorXd integers_of(const Eigen::VectorXd& x) const
  {
    Eigen::VectorXd y(integers.size());
    for(std::size_t i = 0; i < integers.size(); ++i)
      y[i] = x[integers[i]];
    return y;
  }

  // The energy, without the constant, of an assignment of all variables.
  double energy(const Eigen::VectorXd& x) const { return 0.5 * x.dot(matrix * x) - x.dot(rhs); }

private:
  Eigen::SparseMatrix<double> matrix, RI;
  Eigen::VectorXd rhs;
  Sparse_cholesky solver;

  Eigen::VectorXd rhs_of_reals() const
  {
    Eigen::VectorXd r(reals.size());
    for(std::size_t i = 0; i < reals.size(); ++i)
      r[i] = rhs[reals[i]];
    return r;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_INTEGER_REDUCTION_H
