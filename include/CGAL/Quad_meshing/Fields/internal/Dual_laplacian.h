// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_DUAL_LAPLACIAN_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_DUAL_LAPLACIAN_H

#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/internal/run_aside.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A sparse vector with ascending indices.
struct Sparse_vector
{
  std::vector<int> index;
  std::vector<double> value;
};

// The angles of a field for given period jumps, and what a change of jumps costs, from one
// factorization.
//
// With B the matrix that takes the angles of the free faces to differences across inner edges, and c
// what the jumps, the frames and the given angles contribute, the residual is r = c + B angle. The
// best angles solve A angle = -B'c with A = B'B, a graph Laplacian of the free faces. Changing the
// jump of edge e by d changes the energy by exactly
//   (pi/2)^2 P_ee + pi d r_e,   P = I - B A^-1 B',
// and the residuals by d pi/2 times the column e of P. With the Cholesky factor A = L L' the entries
// are P_ef = [e = f] - <y_e, y_f>, y_e = L^-1 B'_e, and y_e is sparse: it lives on the paths of
// two faces to the root of the elimination tree. So single entries of P cost microseconds.
//
// An angle that is given softly is an edge to a face that has it: a further row of B, whose jump does not change. If
// edges have weights w, the rows of B and c are multiplied by sqrt(w), and so is all that has an index e: a change of
// the jump by d is one of d sqrt(w), and entries of P belong to residuals times sqrt(w).
class Dual_laplacian
{
public:
  // Not valid if the visitor stops it.
  Dual_laplacian(const Field_problem& problem, Stage_progress& progress) : m_problem(problem)
  {
    m_row.assign(problem.mesh.number_of_faces(), -1);
    int n = 0;
    for(int f = 0; f < problem.mesh.number_of_faces(); ++f)
      if(!problem.constrained[f])
        m_row[f] = n++;

    std::vector<Eigen::Triplet<double>> entries;
    for(int e = 0; e < problem.mesh.number_of_edges(); ++e)
      if(problem.is_inner(e))
      {
        const int i = m_row[problem.first_face(e)], j = m_row[problem.second_face(e)];
        const double weight = problem.weight(e);
        if(i != -1)
          entries.emplace_back(i, i, weight);
        if(j != -1)
          entries.emplace_back(j, j, weight);
        if(i != -1 && j != -1)
        {
          entries.emplace_back(i, j, -weight);
          entries.emplace_back(j, i, -weight);
        }
      }
    // A component in which nothing is given may be turned as a whole. The unit weight that holds one
    // of its angles at zero does not change any residual, since it can be met exactly.
    for(int f : problem.anchor)
      if(f != -1)
        entries.emplace_back(m_row[f], m_row[f], 1.);

    for(std::size_t f = 0; f < problem.soft_weight.size(); ++f)
      if(m_row[f] != -1 && problem.soft_weight[f] > 0)
        entries.emplace_back(m_row[f], m_row[f], problem.soft_weight[f]);

    const auto data = std::make_shared<Factorization>();
    data->matrix.resize(n, n);
    data->matrix.setFromTriplets(entries.begin(), entries.end());
    const bool is_done = run_aside(n, progress, data,
                                   [](Factorization& f)
                                   {
                                     if(f.cholesky.compute(f.matrix))
                                       f.factor = f.cholesky.factor();
                                   });
    m_work.assign(n, 0.);
    if(!is_done || !data->factor)
      return;
    m_cholesky = std::move(data->cholesky);
    m_factor = std::move(data->factor);
    m_row_of_factor.resize(n);
    for(int i = 0; i < n; ++i)
      m_row_of_factor[m_factor->permutation[i]] = i;
  }

  bool is_valid() const { return m_factor != nullptr; }
  int number_of_unknowns() const { return static_cast<int>(m_work.size()); }

  // Sets the angles of all faces to the best ones for the period jumps of the field. Of the directions that are given
  // softly, each face keeps the one that it has been nearest to.
  void solve_angles(Cross_field& field) const
  {
    const int n = number_of_unknowns();
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n);
    for(std::size_t f = 0; f < m_problem.soft_weight.size(); ++f)
      if(m_row[f] != -1 && m_problem.soft_weight[f] > 0)
        rhs[m_row[f]] = m_problem.soft_weight[f] * m_problem.nearest_soft_angle(static_cast<int>(f), field.angle[f]);
    for(std::size_t f = 0; f < m_row.size(); ++f)
      field.angle[f] = m_row[f] == -1 ? m_problem.given_angle[f] : 0.;
    for(int e = 0; e < m_problem.mesh.number_of_edges(); ++e)
      if(m_problem.is_inner(e))
      {
        const double c = m_problem.weight(e) * m_problem.residual(e, field);
        const int i = m_row[m_problem.first_face(e)], j = m_row[m_problem.second_face(e)];
        if(i != -1)
          rhs[i] -= c;
        if(j != -1)
          rhs[j] += c;
      }
    if(n == 0)
      return;
    m_cholesky.solve_in_place(rhs.data());
    for(std::size_t f = 0; f < m_row.size(); ++f)
      if(m_row[f] != -1)
        field.angle[f] = rhs[m_row[f]];
  }

  // Projects a vector with one entry per edge: P times it.
  void project(Eigen::VectorXd& x) const
  {
    const int n = number_of_unknowns();
    if(n == 0)
      return;
    auto for_each_free_side = [&](const auto& side)
    {
      for(int e = 0; e < m_problem.mesh.number_of_edges(); ++e)
        if(m_problem.is_inner(e))
        {
          const int i = m_row[m_problem.first_face(e)], j = m_row[m_problem.second_face(e)];
          if(i != -1)
            side(e, i, std::sqrt(m_problem.weight(e)));
          if(j != -1)
            side(e, j, -std::sqrt(m_problem.weight(e)));
        }
    };
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(n);
    for_each_free_side([&](int e, int row, double factor) { sums[row] += factor * x[e]; });
    m_cholesky.solve_in_place(sums.data());
    for_each_free_side([&](int e, int row, double factor) { x[e] -= factor * sums[row]; });
  }

  // The vector y_e.
  Sparse_vector half_column(int e)
  {
    // The vector decays like the field of a dipole on its way up the tree; what is dropped changes the
    // entries of P, which are at most one, by a few times its size.
    const double negligible = 2e-4;

    const Cholesky_factor<double>& l = *m_factor;
    Sparse_vector y;
    int i = m_row[m_problem.first_face(e)], j = m_row[m_problem.second_face(e)];
    if(i == j) // only if both are -1
      return y;
    const double root = std::sqrt(m_problem.weight(e));
    if(i != -1)
    {
      i = m_row_of_factor[i];
      m_work[i] += root;
    }
    if(j != -1)
    {
      j = m_row_of_factor[j];
      m_work[j] -= root;
    }

    // Follows the two paths upwards in ascending order of columns until they join and end.
    while(i != -1 || j != -1)
    {
      const int column = (j == -1 || (i != -1 && i < j)) ? i : j;
      const std::size_t begin = l.column_begin[column], end = l.column_begin[column + 1];
      const double x = m_work[column] / l.value[begin];
      m_work[column] = 0.;
      if(std::abs(x) > negligible)
      {
        y.index.push_back(column);
        y.value.push_back(x);
        for(std::size_t p = begin + 1; p < end; ++p)
          m_work[l.row[p]] -= x * l.value[p];
      }
      const int parent = begin + 1 < end ? l.row[begin + 1] : -1;
      if(i == column)
        i = parent;
      if(j == column)
        j = parent;
    }
    return y;
  }

private:
  struct Factorization
  {
    Eigen::SparseMatrix<double> matrix;
    Sparse_cholesky<double> cholesky;
    std::unique_ptr<Cholesky_factor<double>> factor;
  };

  const Field_problem& m_problem;
  std::vector<int> m_row; // per face: its row in A, -1 if its angle is given
  Sparse_cholesky<double> m_cholesky;
  std::unique_ptr<Cholesky_factor<double>> m_factor;
  std::vector<int> m_row_of_factor; // per row of A
  std::vector<double> m_work;       // zero between calls
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_DUAL_LAPLACIAN_H
