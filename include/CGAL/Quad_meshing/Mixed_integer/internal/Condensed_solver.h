// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONDENSED_SOLVER_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONDENSED_SOLVER_H

#include <CGAL/Quad_meshing/Mixed_integer/internal/Reduced_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/Three_level_solver.h>

#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A three-level solver in whose system leaves do not occur: integers that the energy couples to at most two other
// variables, as it does the period jumps of a field. As long as a leaf is free it is the best one for its neighbors,
//   z_l = (b_l - a'x) / A_ll,
// and the system of the others is without a a' / A_ll; fixing the leaf adds this to their matrix. That makes systems
// smaller, and local steps larger: neighbors do not wait for the leaf between them.
class Condensed_solver
{
public:
  typedef Three_level_solver Solver;
  typedef Solver::Level Level;

  Condensed_solver(const Sparse_cholesky<double>& linear_solver, const Reduced_problem& problem, double tolerance,
                   int gauss_seidel_iterations, int conjugate_gradient_iterations)
    : m_problem(problem), m_leaf(problem.size(), -1), m_core(problem.size(), -1)
  {
    find_leaves();
    m_solver.reset(new Solver(linear_solver, core_matrix(), core_rhs(), tolerance, gauss_seidel_iterations,
                              conjugate_gradient_iterations));
  }

  bool initialize(int& factorizations) { return m_solver->initialize(factorizations); }

  // The current value of a variable.
  double x(int i) const
  {
    if(m_leaf[i] == -1)
      return m_solver->x()[m_core[i]];
    const Leaf& leaf = m_leaves[m_leaf[i]];
    if(leaf.is_fixed)
      return leaf.value;
    double sum = m_problem.b[i];
    for(int k = 0; k < leaf.degree; ++k)
      sum -= leaf.coefficient[k] * m_solver->x()[leaf.neighbor[k]];
    return sum / leaf.diagonal;
  }

  Eigen::VectorXd all() const
  {
    Eigen::VectorXd z(m_problem.size());
    for(int i = 0; i < z.size(); ++i)
      z[i] = x(i);
    return z;
  }

  bool is_fixed(int i) const { return m_leaf[i] != -1 ? m_leaves[m_leaf[i]].is_fixed : m_solver->is_fixed(m_core[i]); }

  void fix(int i, double value)
  {
    if(m_leaf[i] == -1)
    {
      m_solver->fix(m_core[i], value);
      return;
    }
    Leaf& leaf = m_leaves[m_leaf[i]];
    leaf.is_fixed = true;
    leaf.value = value;
    const double shift = m_problem.b[i] / leaf.diagonal - value;
    for(int k = 0; k < leaf.degree; ++k)
      for(int l = 0; l < leaf.degree; ++l)
        m_solver->add_to_matrix(leaf.neighbor[k], leaf.neighbor[l],
                                leaf.coefficient[k] * leaf.coefficient[l] / leaf.diagonal);
    for(int k = 0; k < leaf.degree; ++k)
      m_solver->add_to_rhs(leaf.neighbor[k], leaf.coefficient[k] * shift);
  }

  Level update(int& factorizations, bool allow_factorization)
  {
    return m_solver->update(factorizations, allow_factorization);
  }
  bool factorize(int& factorizations) { return m_solver->factorize(factorizations); }

  // Calls `visit(i)` for the integers that may have changed since the last call, some of them more than once.
  template <typename Visit>
  void visit_changes(const Visit& visit)
  {
    for(int c : m_solver->changes())
    {
      if(m_is_integer_core[c])
        visit(m_variable[c]);
      for(int k = m_first_leaf[c]; k < m_first_leaf[c + 1]; ++k)
        visit(m_leaves_of_core[k]);
    }
    m_solver->clear_changes();
  }

private:
  struct Leaf
  {
    double diagonal = 0., value = 0.;
    int degree = 0;
    int neighbor[2]; // core variables
    double coefficient[2];
    bool is_fixed = false;
  };

  void find_leaves()
  {
    const Eigen::SparseMatrix<double>& A = m_problem.A;
    for(int i : m_problem.integers)
    {
      Leaf leaf;
      int degree = 0;
      for(Eigen::SparseMatrix<double>::InnerIterator it(A, i); it; ++it)
        if(it.row() == i)
          leaf.diagonal = it.value();
        else if(it.value() != 0.)
        {
          if(degree < 2)
          {
            leaf.neighbor[degree] = static_cast<int>(it.row());
            leaf.coefficient[degree] = it.value();
          }
          degree += (m_leaf[it.row()] != -1 ? 3 : 1); // leaves do not touch
        }
      if(degree > 2 || !(leaf.diagonal > 0.))
        continue;
      leaf.degree = degree;
      m_leaf[i] = static_cast<int>(m_leaves.size());
      m_leaves.push_back(leaf);
    }
    std::vector<char> is_integer(m_problem.size(), 0);
    for(int i : m_problem.integers)
      is_integer[i] = 1;
    for(int i = 0; i < m_problem.size(); ++i)
      if(m_leaf[i] == -1)
      {
        m_core[i] = static_cast<int>(m_variable.size());
        m_variable.push_back(i);
        m_is_integer_core.push_back(is_integer[i]);
      }
    m_first_leaf.assign(m_variable.size() + 1, 0);
    for(Leaf& leaf : m_leaves)
      for(int k = 0; k < leaf.degree; ++k)
      {
        leaf.neighbor[k] = m_core[leaf.neighbor[k]];
        ++m_first_leaf[leaf.neighbor[k] + 1];
      }
    for(std::size_t c = 1; c < m_first_leaf.size(); ++c)
      m_first_leaf[c] += m_first_leaf[c - 1];
    m_leaves_of_core.resize(m_first_leaf.back());
    std::vector<int> next(m_first_leaf.begin(), m_first_leaf.end() - 1);
    for(int i = 0; i < m_problem.size(); ++i)
      if(m_leaf[i] != -1)
        for(int k = 0; k < m_leaves[m_leaf[i]].degree; ++k)
          m_leaves_of_core[next[m_leaves[m_leaf[i]].neighbor[k]]++] = i;
  }

  // Has a place for every entry that fixing leaves adds to.
  Eigen::SparseMatrix<double> core_matrix() const
  {
    const int n = static_cast<int>(m_variable.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(m_problem.A.nonZeros());
    for(int c = 0; c < n; ++c)
      for(Eigen::SparseMatrix<double>::InnerIterator it(m_problem.A, m_variable[c]); it; ++it)
        if(m_core[it.row()] != -1)
          entries.emplace_back(m_core[it.row()], c, it.value());
    for(const Leaf& leaf : m_leaves)
      for(int k = 0; k < leaf.degree; ++k)
        for(int l = 0; l < leaf.degree; ++l)
          entries.emplace_back(leaf.neighbor[k], leaf.neighbor[l],
                               -leaf.coefficient[k] * leaf.coefficient[l] / leaf.diagonal);
    Eigen::SparseMatrix<double> K(n, n);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
  }

  Eigen::VectorXd core_rhs() const
  {
    Eigen::VectorXd rhs = subvector(m_problem.b, m_variable);
    for(int i : m_problem.integers)
      if(m_leaf[i] != -1)
      {
        const Leaf& leaf = m_leaves[m_leaf[i]];
        for(int k = 0; k < leaf.degree; ++k)
          rhs[leaf.neighbor[k]] -= leaf.coefficient[k] * m_problem.b[i] / leaf.diagonal;
      }
    return rhs;
  }

  const Reduced_problem& m_problem;
  std::vector<int> m_leaf, m_core; // per variable: its number among the leaves, or among the others
  std::vector<Leaf> m_leaves;
  std::vector<int> m_variable; // per core variable
  std::vector<char> m_is_integer_core;
  std::vector<int> m_first_leaf, m_leaves_of_core; // the leaves next to each core variable, as variables
  std::unique_ptr<Solver> m_solver;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_CONDENSED_SOLVER_H
