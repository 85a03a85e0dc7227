// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_THREE_LEVEL_SOLVER_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_THREE_LEVEL_SOLVER_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Keeps the minimizer of 1/2 x'Ax - x'b up to date while variables are fixed one after the other
// (thesis 5.2.2). Fixed variables are skipped, their values enter the residuals.
//
// Three levels, each taken when the one before has not converged:
// 1. Gauss-Seidel steps on a queue of the variables next to a change,
// 2. conjugate gradient, preconditioned by the last factor restricted to the variables still free,
// 3. a new factor, with identity rows and columns for fixed variables: the pattern is analyzed once.
//
// The tolerance of levels 1 and 2 is a length in units of the variables: the change that the next step,
// of Gauss-Seidel or of the preconditioner, would still make.
class Three_level_solver
{
public:
  enum Level
  {
    GAUSS_SEIDEL = 1,
    CONJUGATE_GRADIENT = 2,
    FACTORIZATION = 3,
    FAILED = 4
  };

  // `linear_solver` shows how to solve.
  Three_level_solver(const Sparse_cholesky<double>& linear_solver, const Eigen::SparseMatrix<double>& A,
                     const Eigen::VectorXd& b, double tolerance, int gauss_seidel_iterations,
                     int conjugate_gradient_iterations)
    : m_A(A)
    , m_b(b)
    , m_diagonal(A.diagonal())
    , m_factor(linear_solver.make_another())
    , m_is_fixed(b.size(), 0)
    , m_is_queued(b.size(), 0)
    , m_is_changed(b.size(), 0)
    , m_tolerance(tolerance)
    , m_gauss_seidel_iterations(gauss_seidel_iterations)
    , m_conjugate_gradient_iterations(conjugate_gradient_iterations)
  {
  }

  // Computes the minimizer with nothing fixed.
  bool initialize(int& factorizations)
  {
    if(!factorize_semidefinite(m_factor, m_A, factorizations))
      return false;
    m_x = m_factor.solve(m_b);
    return true;
  }

  const Eigen::VectorXd& x() const { return m_x; }
  bool is_fixed(int i) const { return m_is_fixed[i] != 0; }

  // The variables whose values changed since `clear_changes()`.
  const std::vector<int>& changes() const { return m_changes; }
  void clear_changes()
  {
    for(int i : m_changes)
      m_is_changed[i] = 0;
    m_changes.clear();
  }

  // Fixes a variable; `update()` brings the others up to date.
  void fix(int i, double value)
  {
    m_is_fixed[i] = 1;
    if(m_x[i] == value)
      return;
    m_x[i] = value;
    m_allowed_steps += m_gauss_seidel_iterations;
    enqueue_neighbors(i);
  }

  // Changes an entry of A, which must be in its pattern, or of b; `update()` brings the variables up to date.
  void add_to_matrix(int i, int j, double value)
  {
    m_A.coeffRef(i, j) += value;
    if(i == j)
      m_diagonal[i] += value;
  }
  void add_to_rhs(int i, double value)
  {
    m_b[i] += value;
    m_allowed_steps += m_gauss_seidel_iterations;
    enqueue(i);
  }

  // Fixes a variable and brings all others up to date, as exactly as a new factor would: steps along the columns of the
  // inverse of the last factor, each made to leave alone what was fixed since then. Returns false if it cannot be done.
  bool fix_exactly(int i, double value, int& factorizations)
  {
    // Every step costs as much as so many earlier ones; beyond this number a new factor is cheaper.
    const std::size_t maximum_columns = 64;
    if(m_columns.size() == maximum_columns && !factorize(factorizations))
      return false;
    Eigen::VectorXd w = m_factor.solve(Eigen::VectorXd(Eigen::VectorXd::Unit(m_x.size(), i)));
    for(const std::pair<int, Eigen::VectorXd>& c : m_columns)
    {
      w -= (w[c.first] / c.second[c.first]) * c.second;
      w[c.first] = 0.; // without round-off
    }
    if(!(w[i] > 0.))
      return false;
    m_x += ((value - m_x[i]) / w[i]) * w;
    m_x[i] = value;
    m_is_fixed[i] = 1;
    m_columns.emplace_back(i, std::move(w));
    return true;
  }

  // Returns the level that converged, or did last if there may be no factorization.
  Level update(int& factorizations, bool allow_factorization)
  {
    if(gauss_seidel())
      return GAUSS_SEIDEL;
    clear_queue();
    mark_all_changed();
    if(conjugate_gradient() || !allow_factorization)
      return CONJUGATE_GRADIENT;
    return factorize(factorizations) ? FACTORIZATION : FAILED;
  }

  // Computes the minimizer under the conditions fixed so far, with a new factor.
  bool factorize(int& factorizations)
  {
    clear_queue();
    m_columns.clear();
    mark_all_changed();
    Eigen::SparseMatrix<double> fixed = m_A;
    Eigen::VectorXd rhs = m_b;
    for(int j = 0; j < fixed.cols(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(fixed, j); it; ++it)
      {
        const int i = static_cast<int>(it.row());
        if(i == j && m_is_fixed[i])
          it.valueRef() = 1.;
        else if(m_is_fixed[i] || m_is_fixed[j])
        {
          if(!m_is_fixed[i])
            rhs[i] -= it.value() * m_x[j];
          it.valueRef() = 0.;
        }
      }
    for(int i = 0; i < rhs.size(); ++i)
      if(m_is_fixed[i])
        rhs[i] = m_x[i];
    ++factorizations;
    if(!m_factor.factorize(fixed) && !factorize_semidefinite(m_factor, fixed, factorizations))
      return false;
    const Eigen::VectorXd x = m_factor.solve(rhs);
    for(int i = 0; i < rhs.size(); ++i)
      if(!m_is_fixed[i])
        m_x[i] = x[i];
    return true;
  }

private:
  void mark_changed(int i)
  {
    if(!m_is_changed[i])
    {
      m_is_changed[i] = 1;
      m_changes.push_back(i);
    }
  }

  void mark_all_changed()
  {
    for(int i = 0; i < m_x.size(); ++i)
      mark_changed(i);
  }

  void enqueue(int i)
  {
    if(!m_is_fixed[i] && !m_is_queued[i])
    {
      m_is_queued[i] = 1;
      m_queue.push_back(i);
    }
  }

  void enqueue_neighbors(int i)
  {
    for(Eigen::SparseMatrix<double>::InnerIterator it(m_A, i); it; ++it)
      enqueue(static_cast<int>(it.row()));
  }

  void clear_queue()
  {
    for(; m_head < m_queue.size(); ++m_head)
      m_is_queued[m_queue[m_head]] = 0;
    m_queue.clear();
    m_head = 0;
    m_allowed_steps = 0;
  }

  double residual(int i) const
  {
    double r = m_b[i];
    for(Eigen::SparseMatrix<double>::InnerIterator it(m_A, i); it; ++it)
      r -= it.value() * m_x[it.row()];
    return r;
  }

  bool gauss_seidel()
  {
    for(; m_head < m_queue.size(); --m_allowed_steps)
    {
      if(m_allowed_steps <= 0)
        return false;
      const int i = m_queue[m_head++];
      m_is_queued[i] = 0;
      if(m_is_fixed[i] || !(m_diagonal[i] > 0.))
        continue;
      const double step = residual(i) / m_diagonal[i];
      if(std::fabs(step) <= m_tolerance)
        continue;
      m_x[i] += step;
      mark_changed(i);
      enqueue_neighbors(i);
    }
    clear_queue();
    return true;
  }

  void restrict_to_free(Eigen::VectorXd& v) const
  {
    for(int i = 0; i < v.size(); ++i)
      if(m_is_fixed[i])
        v[i] = 0.;
  }

  bool conjugate_gradient()
  {
    if(m_conjugate_gradient_iterations <= 0)
      return false;
    Eigen::VectorXd r = m_b - m_A * m_x;
    restrict_to_free(r);
    Eigen::VectorXd p, Ap;
    double rho = 0.;
    for(int iteration = 0;; ++iteration)
    {
      Eigen::VectorXd z = m_factor.solve(r);
      restrict_to_free(z);
      if(z.size() == 0 || z.cwiseAbs().maxCoeff() <= m_tolerance)
        return true;
      if(iteration >= m_conjugate_gradient_iterations)
        return false;
      const double next_rho = r.dot(z);
      if(!(next_rho > 0.))
        return false;
      if(iteration == 0)
        p = z;
      else
        p = z + (next_rho / rho) * p;
      rho = next_rho;
      Ap.noalias() = m_A * p;
      restrict_to_free(Ap);
      const double curvature = p.dot(Ap);
      if(!(curvature > 0.))
        return false;
      m_x += (rho / curvature) * p;
      r -= (rho / curvature) * Ap;
    }
  }

  Eigen::SparseMatrix<double> m_A;
  Eigen::VectorXd m_b, m_diagonal;
  Sparse_cholesky<double> m_factor;
  Eigen::VectorXd m_x;
  // the variables fixed exactly since the last factor, and their steps
  std::vector<std::pair<int, Eigen::VectorXd>> m_columns;
  std::vector<char> m_is_fixed, m_is_queued, m_is_changed;
  std::vector<int> m_queue, m_changes;
  std::size_t m_head = 0;
  double m_allowed_steps = 0.; // of Gauss-Seidel, until the next level takes over
  double m_tolerance;
  int m_gauss_seidel_iterations, m_conjugate_gradient_iterations;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_THREE_LEVEL_SOLVER_H
