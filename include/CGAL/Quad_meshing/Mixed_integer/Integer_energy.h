// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTEGER_ENERGY_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTEGER_ENERGY_H

#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>

#include <CGAL/assertions.h>

#include <Eigen/Cholesky>

#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief A quadratic energy \f$ \frac12 x^T A x - x^T b \f$ seen as an energy of its integer variables \f$ y \f$ alone, the
real ones always being the best for them.

With the Schur complement \f$ S = A_{II} - A_{IR} A_{RR}^{-1} A_{RI} \f$ this energy is
\f[ E(y) = \tfrac12 y^T S y - y^T c + k = \tfrac12 (y-y^*)^T S (y-y^*) + E(y^*). \f]
One sparse factorization, of \f$ A_{RR} \f$, serves to compute \f$ S \f$ and then the real variables for any integers, so these
can be chosen and revised as often as needed, each time by a small dense problem (see `problem()`). `solve_mixed_integer()` works
that way by itself; this class is for those who want to add constraints between one solution and the next.

\tparam LinearSolver `Sparse_cholesky` or a class like it
*/
template <typename LinearSolver = Sparse_cholesky>
class Integer_energy
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;

  /// factorizes the part of `A` that belongs to the real variables. This is enough for `complete()`, `integers_of()` and `energy()`.
  /// \return whether the energy is strictly convex in the real variables.
  /// \pre `A` is symmetric and stored in full.
  bool factorize(const Matrix& A, const Eigen::VectorXd& b, const std::vector<bool>& is_integer)
  {
    CGAL_precondition(A.rows() == A.cols() && A.rows() == b.size());
    CGAL_precondition(A.rows() == static_cast<int>(is_integer.size()));
    m_A = A;
    m_b = b;
    m_integers.clear();
    m_reals.clear();
    for(std::size_t i = 0; i < is_integer.size(); ++i)
      (is_integer[i] ? m_integers : m_reals).push_back(static_cast<int>(i));
    m_coupling = internal::submatrix(m_A, m_reals, m_integers);
    m_rhs_of_reals = internal::subvector(m_b, m_reals);
    m_factorizations = 0;
    return internal::factorize_with_shift(m_solver, internal::submatrix(m_A, m_reals, m_reals), m_factorizations);
  }

  /// factorizes and computes the energy over the integers.
  /// \return whether the energy is strictly convex in the real variables and convex in all.
  /// \pre `A` is symmetric and stored in full.
  bool compute(const Matrix& A, const Eigen::VectorXd& b, const std::vector<bool>& is_integer)
  {
    if(!factorize(A, b, is_integer))
      return false;
    m_S = Eigen::MatrixXd(internal::submatrix(m_A, m_integers, m_integers)) - m_solver.product_with_inverse(m_coupling);
    m_S = Eigen::MatrixXd(0.5 * (m_S + m_S.transpose()));
    const Eigen::VectorXd x0 = m_solver.solve(m_rhs_of_reals);
    m_c = internal::subvector(m_b, m_integers) - m_coupling.transpose() * x0;
    m_constant = -0.5 * m_rhs_of_reals.dot(x0);
    if(!invert_or_shift())
      return false;
    m_target = m_c;
    if(m_target.size() > 0)
    {
      m_target = m_cholesky.solve(m_c);
      // One step of iterative refinement: targets that are integers should look like integers.
      m_target += m_cholesky.solve(Eigen::VectorXd(m_c - m_S * m_target));
    }
    m_relaxed_energy = energy(complete(m_target));
    return true;
  }

  /// returns the indices of the integer variables, ascending: `y[k]` is the variable `integers()[k]`.
  const std::vector<int>& integers() const { return m_integers; }
  /// returns the indices of the real variables, ascending.
  const std::vector<int>& reals() const { return m_reals; }
  /// returns the number of integers.
  int size() const { return static_cast<int>(m_integers.size()); }

  /// returns \f$ S \f$. Directions without energy have got a little.
  const Eigen::MatrixXd& matrix() const { return m_S; }
  /// returns the Cholesky factorization of \f$ S \f$.
  const Eigen::LLT<Eigen::MatrixXd>& cholesky() const { return m_cholesky; }
  /// returns \f$ c \f$.
  const Eigen::VectorXd& linear_term() const { return m_c; }
  /// returns \f$ y^* \f$, the minimum without integer conditions.
  const Eigen::VectorXd& target() const { return m_target; }
  /// returns the energy at the minimum without integer conditions.
  double relaxed_energy() const { return m_relaxed_energy; }

  /// returns what `y` costs over the relaxed energy.
  double cost(const Eigen::VectorXd& y) const
  {
    const Eigen::VectorXd d = y - m_target;
    return 0.5 * d.dot(m_S * d);
  }

  /// returns the problem over the integers alone, whose energies are those of the whole.
  Mixed_integer_problem problem() const
  {
    Mixed_integer_problem result(size());
    result.set_energy(m_S.sparseView(), m_c, m_constant);
    for(int i = 0; i < size(); ++i)
      result.set_integer(i);
    return result;
  }

  /// returns all variables, the real ones best for the integers `y`.
  Eigen::VectorXd complete(const Eigen::VectorXd& y) const
  {
    CGAL_precondition(y.size() == size());
    Eigen::VectorXd x(m_b.size());
    for(std::size_t i = 0; i < m_integers.size(); ++i)
      x[m_integers[i]] = y[i];
    const Eigen::VectorXd r = m_solver.solve(Eigen::VectorXd(m_rhs_of_reals - m_coupling * y));
    for(std::size_t i = 0; i < m_reals.size(); ++i)
      x[m_reals[i]] = r[i];
    return x;
  }

  /// returns the integer variables of an assignment of all variables.
  Eigen::VectorXd integers_of(const Eigen::VectorXd& x) const { return internal::subvector(x, m_integers); }

  /// returns the energy of an assignment of all variables.
  double energy(const Eigen::VectorXd& x) const { return x.dot(0.5 * (m_A * x) - m_b); }

  /// returns how many sparse factorizations the last computation took: one, unless the energy was singular.
  int number_of_factorizations() const { return m_factorizations; }

private:
  // The integers may leave directions without energy; they get a little.
  bool invert_or_shift()
  {
    if(m_S.size() == 0)
      return true;
    m_cholesky.compute(m_S);
    const double largest = m_S.diagonal().cwiseAbs().maxCoeff();
    for(double relative_shift : { 1e-14, 1e-12, 1e-10, 1e-8 })
    {
      if(is_definite())
        return true;
      m_S.diagonal().array() += relative_shift * (largest > 0. ? largest : 1.);
      m_cholesky.compute(m_S);
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

  Matrix m_A, m_coupling; // the coupling is A_RI
  Eigen::VectorXd m_b, m_rhs_of_reals;
  std::vector<int> m_integers, m_reals;
  LinearSolver m_solver;
  int m_factorizations = 0;
  Eigen::MatrixXd m_S;
  Eigen::LLT<Eigen::MatrixXd> m_cholesky;
  Eigen::VectorXd m_c, m_target;
  double m_constant = 0.;
  double m_relaxed_energy = 0.;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTEGER_ENERGY_H
