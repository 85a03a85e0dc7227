// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_MIXED_INTEGER_PROBLEM_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_MIXED_INTEGER_PROBLEM_H

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingMixedIntegerRef

\brief A convex quadratic energy over real and integer variables, with linear constraints.

The problem reads
\f[ \min_x \; \tfrac12 x^T A x - x^T b + c \quad\mbox{subject to}\quad
    Cx = d,\; Gx \le h,\; g(x) \le 0,\; l \le x \le u,\; x_i \in \mathbb{Z} \mbox{ for } i \in I . \f]
\f$ A \f$ is symmetric positive semidefinite, the functions \f$ g \f$ are convex; the energy must be bounded below where
the constraints hold. The energy is given as a matrix, as a sum of weighted squared residuals, or as both together.

Constraints may be redundant or contradictory: `solve_mixed_integer()` sorts that out and says which.

\sa `solve_mixed_integer()`
*/
class Mixed_integer_problem
{
public:
  /// The non-zero coefficients of a linear form, as pairs of variable and coefficient, in any order.
  /// Several entries of one variable add up.
  typedef std::vector<std::pair<int, double>> Linear_form;

  /// A linear form and the number it is compared with.
  struct Linear_constraint
  {
    Linear_form form;
    double rhs;
  };

  /// A convex function of some variables: takes their values, sets the gradient, or a subgradient, and returns the
  /// value. It is called with real values for integer variables too.
  typedef std::function<double(const Eigen::VectorXd& values, Eigen::VectorXd& gradient)> Convex_function;

  /// The condition that a convex function of these variables is at most zero.
  struct Convex_constraint
  {
    std::vector<int> variables;
    Convex_function function;
    Eigen::MatrixXd hessian; ///< of a quadratic function; empty for others
  };

  /// \name Variables
  /// @{

  /// creates a problem of `n` real variables, zero energy and no constraint.
  explicit Mixed_integer_problem(int n = 0)
    : m_is_integer(n, 0), m_lower(n, -infinity()), m_upper(n, infinity()), m_constant(0.)
  {
    CGAL_precondition(n >= 0);
  }

  /// adds a variable and returns its index; indices are consecutive.
  int add_variable(bool is_integer = false)
  {
    m_is_integer.push_back(is_integer);
    m_lower.push_back(-infinity());
    m_upper.push_back(infinity());
    return number_of_variables() - 1;
  }

  /// makes variable `i` an integer, or a real if `b` is `false`.
  void set_integer(int i, bool b = true)
  {
    CGAL_precondition(is_variable(i));
    m_is_integer[i] = b;
  }

  /// bounds variable `i` from below and above. Only the branch-and-bound family knows bounds.
  void set_bounds(int i, double lower, double upper)
  {
    CGAL_precondition(is_variable(i));
    m_lower[i] = lower;
    m_upper[i] = upper;
  }

  /// returns the number of variables, real and integer.
  int number_of_variables() const { return static_cast<int>(m_is_integer.size()); }
  /// returns the number of integer variables.
  int number_of_integers() const
  {
    int count = 0;
    for(char c : m_is_integer)
      count += (c != 0);
    return count;
  }
  /// returns whether variable `i` is an integer.
  bool is_integer(int i) const { return m_is_integer[i] != 0; }
  /// returns the lower bound of variable `i`, minus infinity if it has none.
  double lower_bound(int i) const { return m_lower[i]; }
  /// returns the upper bound of variable `i`, infinity if it has none.
  double upper_bound(int i) const { return m_upper[i]; }

  /// @}
  /// \name Energy
  /// @{

  /// sets the energy to `1/2 x'Ax - x'b + constant`, dropping squared residuals added before.
  /// \pre `A` is symmetric and stored in full, not only one triangle; it may be smaller than the number
  /// of variables, the missing rows and columns are zero.
  void set_energy(const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& b, double constant = 0)
  {
    CGAL_precondition(A.rows() == A.cols() && A.rows() == b.size());
    CGAL_precondition(A.rows() <= number_of_variables());
    m_base = A;
    m_base_rhs = b;
    m_triplets.clear();
    m_rhs.assign(number_of_variables(), 0.);
    m_constant = constant;
  }

  /// adds `weight * (form - rhs)^2` to the energy.
  /// \pre `weight >= 0`
  void add_squared_residual(const Linear_form& form, double rhs, double weight = 1)
  {
    CGAL_precondition(weight >= 0);
    m_rhs.resize(m_is_integer.size(), 0.);
    for(const std::pair<int, double>& a : form)
    {
      CGAL_precondition(is_variable(a.first));
      for(const std::pair<int, double>& b : form)
        m_triplets.emplace_back(a.first, b.first, 2. * weight * a.second * b.second);
      m_rhs[a.first] += 2. * weight * rhs * a.second;
    }
    m_constant += weight * rhs * rhs;
  }

  /// returns \f$ A \f$, with both triangles.
  Eigen::SparseMatrix<double> matrix() const
  {
    const int n = number_of_variables();
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(m_triplets.begin(), m_triplets.end());
    if(m_base.rows() > 0)
    {
      Eigen::SparseMatrix<double> padded = m_base;
      padded.conservativeResize(n, n);
      if(m_triplets.empty())
        A.swap(padded);
      else
        A = Eigen::SparseMatrix<double>(A + padded);
    }
    A.makeCompressed();
    return A;
  }

  /// returns \f$ b \f$.
  Eigen::VectorXd linear_term() const
  {
    Eigen::VectorXd b = Eigen::VectorXd::Zero(number_of_variables());
    for(std::size_t i = 0; i < m_rhs.size(); ++i)
      b[i] = m_rhs[i];
    b.head(m_base_rhs.size()) += m_base_rhs;
    return b;
  }

  /// returns the constant \f$ c \f$ of the energy.
  double constant() const { return m_constant; }

  /// returns the energy at `x`.
  double energy(const Eigen::VectorXd& x) const
  {
    CGAL_precondition(x.size() == number_of_variables());
    return x.dot(0.5 * (matrix() * x) - linear_term()) + m_constant;
  }

  /// @}
  /// \name Constraints
  /// @{

  /// demands `form = rhs`.
  /// \pre the variables of the form exist
  void add_equality_constraint(const Linear_form& form, double rhs)
  {
    CGAL_precondition(is_form(form));
    m_equalities.push_back(Linear_constraint{ form, rhs });
  }

  /// demands `form <= rhs`. Only the branch-and-bound family knows inequality constraints.
  /// \pre the variables of the form exist
  void add_inequality_constraint(const Linear_form& form, double rhs)
  {
    CGAL_precondition(is_form(form));
    m_inequalities.push_back(Linear_constraint{ form, rhs });
  }

  /// demands `1/2 x'Qx + form <= rhs`. Only the branch-and-bound family knows such constraints.
  /// \pre `Q` is symmetric, stored in full and positive semidefinite; it may be smaller than the number of variables.
  void add_quadratic_constraint(const Eigen::SparseMatrix<double>& Q, const Linear_form& form, double rhs)
  {
    CGAL_precondition(Q.rows() == Q.cols() && Q.rows() <= number_of_variables());
    CGAL_precondition(is_form(form));
    std::map<int, int> position;
    for(const std::pair<int, double>& a : form)
      position[a.first] = 0;
    for(int j = 0; j < Q.cols(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(Q, j); it; ++it)
        position[static_cast<int>(it.row())] = position[j] = 0;
    Convex_constraint constraint;
    for(std::pair<const int, int>& p : position)
    {
      p.second = static_cast<int>(constraint.variables.size());
      constraint.variables.push_back(p.first);
    }
    const int n = static_cast<int>(constraint.variables.size());
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd a = Eigen::VectorXd::Zero(n);
    for(int j = 0; j < Q.cols(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(Q, j); it; ++it)
        H(position[static_cast<int>(it.row())], position[j]) = it.value();
    for(const std::pair<int, double>& c : form)
      a[position[c.first]] += c.second;
    constraint.hessian = H;
    constraint.function = [H, a, rhs](const Eigen::VectorXd& x, Eigen::VectorXd& gradient)
    {
      const Eigen::VectorXd Hx = H * x;
      gradient = Hx + a;
      return x.dot(0.5 * Hx + a) - rhs;
    };
    m_convex.push_back(constraint);
  }

  /// demands `g <= 0` for a convex function `g` of some variables. Only the branch-and-bound family knows such
  /// constraints, and takes the word of the caller that the function is convex.
  /// \pre the variables exist and differ from each other
  void add_convex_constraint(const std::vector<int>& variables, const Convex_function& g)
  {
    CGAL_precondition(std::all_of(variables.begin(), variables.end(), [&](int v) { return is_variable(v); }));
    m_convex.push_back(Convex_constraint{ variables, g, Eigen::MatrixXd() });
  }

  /// removes the convex constraints.
  void clear_convex_constraints() { m_convex.clear(); }

  /// returns the convex constraints, in the order in which they were added.
  const std::vector<Convex_constraint>& convex_constraints() const { return m_convex; }
  /// returns the constraints `form = rhs`, in the order in which they were added.
  const std::vector<Linear_constraint>& equality_constraints() const { return m_equalities; }
  /// returns the constraints `form <= rhs`, in the order in which they were added.
  const std::vector<Linear_constraint>& inequality_constraints() const { return m_inequalities; }

  /// tells whether there is an inequality constraint, a convex constraint or a bound.
  bool has_inequalities() const
  {
    if(!m_inequalities.empty() || !m_convex.empty())
      return true;
    for(int i = 0; i < number_of_variables(); ++i)
      if(m_lower[i] > -infinity() || m_upper[i] < infinity())
        return true;
    return false;
  }

  /// @}

  /// the bound of an unbounded variable.
  static double infinity() { return std::numeric_limits<double>::infinity(); }

private:
  bool is_variable(int i) const { return i >= 0 && i < number_of_variables(); }
  bool is_form(const Linear_form& form) const
  {
    for(const std::pair<int, double>& a : form)
      if(!is_variable(a.first))
        return false;
    return true;
  }

  std::vector<char> m_is_integer;
  std::vector<double> m_lower, m_upper;

  // The energy is the sum of a matrix given as a whole and of squared residuals.
  Eigen::SparseMatrix<double> m_base;
  Eigen::VectorXd m_base_rhs;
  std::vector<Eigen::Triplet<double>> m_triplets;
  std::vector<double> m_rhs;
  double m_constant;

  std::vector<Linear_constraint> m_equalities, m_inequalities;
  std::vector<Convex_constraint> m_convex;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_MIXED_INTEGER_PROBLEM_H
