// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTEGER_ENERGY_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTEGER_ENERGY_H

#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief A quadratic energy \f$ \frac12 x^T A x - x^T b \f$ seen as an energy of its integer variables \f$ y \f$ alone,
the real ones always being the best for them.

With the Schur complement \f$ S = A_{II} - A_{IR} A_{RR}^{-1} A_{RI} \f$ this energy is
\f[ E(y) = \tfrac12 y^T S y - y^T c + k = \tfrac12 (y-y^*)^T S (y-y^*) + E(y^*). \f]
One sparse factorization, of \f$ A_{RR} \f$, serves to compute \f$ S \f$ and then the real variables for any integers,
so these can be chosen and revised as often as needed, each time by a small dense problem (see `problem()`).
`solve_mixed_integer()` works that way by itself; this class is for those who want to add constraints between one
solution and the next.

\sa `Sparse_cholesky`
*/
class Integer_energy
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;

  /// factorizes with CHOLMOD or Eigen.
  CGAL_QUAD_MESHING_INLINE Integer_energy();
  /// factorizes in the way of another factorization.
  CGAL_QUAD_MESHING_INLINE explicit Integer_energy(const Sparse_cholesky<double>& linear_solver);

  /// factorizes the part of `A` that belongs to the real variables. This is enough for `complete()`, `integers_of()`
  /// and `energy()`.
  /// \return whether the energy is convex in the real variables.
  /// \pre `A` is symmetric and stored in full.
  CGAL_QUAD_MESHING_INLINE bool factorize(const Matrix& A, const Eigen::VectorXd& b,
                                          const std::vector<bool>& is_integer);

  /// factorizes and computes \f$ S \f$ and \f$ c \f$, but no minimum; directions without energy keep none.
  /// \return whether the energy is convex in the real variables.
  /// \pre `A` is symmetric and stored in full.
  CGAL_QUAD_MESHING_INLINE bool reduce(const Matrix& A, const Eigen::VectorXd& b, const std::vector<bool>& is_integer);

  /// factorizes and computes the energy over the integers.
  /// \return whether the energy is convex in the real variables and in all.
  /// \pre `A` is symmetric and stored in full.
  CGAL_QUAD_MESHING_INLINE bool compute(const Matrix& A, const Eigen::VectorXd& b, const std::vector<bool>& is_integer);

  /// returns the indices of the integer variables, ascending: `y[k]` is the variable `integers()[k]`.
  const std::vector<int>& integers() const { return m_integers; }
  /// returns the indices of the real variables, ascending.
  const std::vector<int>& reals() const { return m_reals; }
  /// returns the number of integers.
  int size() const { return static_cast<int>(m_integers.size()); }

  /// returns \f$ S \f$. Directions without energy have got a little.
  const Eigen::MatrixXd& matrix() const { return m_S; }
  /// returns the lower triangular factor of \f$ S \f$; what lies above the diagonal means nothing.
  const Eigen::MatrixXd& factor() const { return m_factor; }
  /// returns \f$ c \f$.
  const Eigen::VectorXd& linear_term() const { return m_c; }
  /// returns the constant \f$ k \f$.
  double constant() const { return m_constant; }
  /// returns \f$ y^* \f$, the minimum without integer conditions.
  const Eigen::VectorXd& target() const { return m_target; }
  /// returns the energy at the minimum without integer conditions.
  double relaxed_energy() const { return m_relaxed_energy; }

  /// returns what `y` costs over the relaxed energy.
  CGAL_QUAD_MESHING_INLINE double cost(const Eigen::VectorXd& y) const;

  /// returns the problem over the integers alone, whose energies are those of the whole.
  CGAL_QUAD_MESHING_INLINE Mixed_integer_problem problem() const;

  /// returns all variables, the real ones best for the integers `y`.
  CGAL_QUAD_MESHING_INLINE Eigen::VectorXd complete(const Eigen::VectorXd& y) const;

  /// returns the integer variables of an assignment of all variables.
  CGAL_QUAD_MESHING_INLINE Eigen::VectorXd integers_of(const Eigen::VectorXd& x) const;

  /// returns the energy of an assignment of all variables.
  CGAL_QUAD_MESHING_INLINE double energy(const Eigen::VectorXd& x) const;

  /// turns the energy into that of the multiples of all variables by a positive factor, with its least value at that
  /// multiple of the former one: \f$ b \f$ is multiplied by the factor. Nothing is factorized.
  CGAL_QUAD_MESHING_INLINE void scale(double factor);

  /// returns how many sparse factorizations the last computation took: one, unless the energy was singular.
  int number_of_factorizations() const { return m_factorizations; }

private:
  CGAL_QUAD_MESHING_INLINE bool invert_or_shift();

  Matrix m_A, m_coupling; // the coupling is A_RI
  Eigen::VectorXd m_b, m_rhs_of_reals;
  std::vector<int> m_integers, m_reals;
  Sparse_cholesky<double> m_solver;
  int m_factorizations = 0;
  Eigen::MatrixXd m_S, m_factor;
  Eigen::VectorXd m_c, m_target;
  double m_constant = 0.;
  double m_relaxed_energy = 0.;
};

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Mixed_integer/internal/Integer_energy_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTEGER_ENERGY_H
