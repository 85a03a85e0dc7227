// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_INTEGER_SCHUR_COMPLEMENT_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_INTEGER_SCHUR_COMPLEMENT_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>

#include <Eigen/Cholesky>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The energy over the integers y alone, with the best real variables for each y:
//
//   E(y) = 1/2 (y - y*)' S (y - y*) + relaxed_energy,   S = A_II - A_IR A_RR^-1 A_RI.
//
// One sparse factorization, of A_RR, serves to compute S and then the real variables of any y.
template <typename LinearSolver>
class Integer_schur_complement
{
public:
  // Returns false if the energy is not strictly convex in the real variables.
  bool compute(const Reduced_problem& problem, LinearSolver& solver, int& factorizations)
  {
    m_problem = &problem;
    m_solver = &solver;
    const std::vector<int>& I = problem.integers;
    const std::vector<int>& R = problem.reals;
    m_coupling = submatrix(problem.A, R, I);
    if(!factorize_with_shift(solver, submatrix(problem.A, R, R), factorizations))
      return false;

    const Eigen::SparseMatrix<double> transposed = m_coupling.transpose();
    m_schur = Eigen::MatrixXd(submatrix(problem.A, I, I)) - solver.product_with_inverse(m_coupling);
    m_schur = Eigen::MatrixXd(0.5 * (m_schur + m_schur.transpose()));

    m_real_rhs = subvector(problem.b, R);
    const Eigen::VectorXd x0 = solver.solve(m_real_rhs);
    const Eigen::VectorXd rhs = subvector(problem.b, I) - transposed * x0;
    if(!invert_or_shift())
      return false;
    m_target = rhs;
    if(m_target.size() > 0)
    {
      m_target = m_cholesky.solve(rhs);
      // One step of iterative refinement: targets that are integers should look like integers.
      m_target += m_cholesky.solve(Eigen::VectorXd(rhs - m_schur * m_target));
    }
    m_relaxed_energy = problem.energy(complete(m_target));
    return true;
  }

  int size() const { return static_cast<int>(m_target.size()); }
  const Eigen::MatrixXd& matrix() const { return m_schur; }
  const Eigen::LLT<Eigen::MatrixXd>& cholesky() const { return m_cholesky; }
  const Eigen::VectorXd& target() const { return m_target; }
  double relaxed_energy() const { return m_relaxed_energy; }

  // What y costs over the relaxed energy.
  double cost(const Eigen::VectorXd& y) const
  {
    const Eigen::VectorXd d = y - m_target;
    return 0.5 * d.dot(m_schur * d);
  }

  // All variables, the real ones best for the integers y.
  Eigen::VectorXd complete(const Eigen::VectorXd& y) const
  {
    const std::vector<int>& I = m_problem->integers;
    const std::vector<int>& R = m_problem->reals;
    const Eigen::VectorXd x = m_solver->solve(Eigen::VectorXd(m_real_rhs - m_coupling * y));
    Eigen::VectorXd z(m_problem->size());
    for(std::size_t i = 0; i < I.size(); ++i)
      z[I[i]] = y[i];
    for(std::size_t i = 0; i < R.size(); ++i)
      z[R[i]] = x[i];
    return z;
  }

private:
  // The integers may leave directions without energy; they get a little.
  bool invert_or_shift()
  {
    if(m_schur.size() == 0)
      return true;
    m_cholesky.compute(m_schur);
    const double largest = m_schur.diagonal().cwiseAbs().maxCoeff();
    for(double relative_shift : { 1e-14, 1e-12, 1e-10, 1e-8 })
    {
      if(is_definite())
        return true;
      m_schur.diagonal().array() += relative_shift * (largest > 0. ? largest : 1.);
      m_cholesky.compute(m_schur);
    }
    return is_definite();
  }

  bool is_definite() const
  {
    // Below this ratio of pivots a direction has no energy but round-off.
    const double relative_pivot = 1e-14;
    if(m_cholesky.info() != Eigen::Success)
      return false;
    const Eigen::VectorXd d = m_cholesky.matrixLLT().diagonal();
    return d.allFinite() && d.minCoeff() * d.minCoeff() > relative_pivot * d.maxCoeff() * d.maxCoeff();
  }

  const Reduced_problem* m_problem = nullptr;
  LinearSolver* m_solver = nullptr;
  Eigen::SparseMatrix<double> m_coupling; // A_RI
  Eigen::MatrixXd m_schur;
  Eigen::LLT<Eigen::MatrixXd> m_cholesky;
  Eigen::VectorXd m_real_rhs, m_target;
  double m_relaxed_energy = 0.;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_INTEGER_SCHUR_COMPLEMENT_H
