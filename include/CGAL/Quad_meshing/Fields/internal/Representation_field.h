// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_REPRESENTATION_FIELD_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_REPRESENTATION_FIELD_H

#include <CGAL/Quad_meshing/Fields/internal/Dual_laplacian.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Computes the angles of the globally smoothest representation field, after Knoeppel, Crane, Pinkall
// and Schroeder 2013.
//
// A cross is represented by z = exp(4 i angle), which does not know which of its four directions is
// the first; the energy sum |exp(4 i kappa) z_i - z_j|^2 is quadratic. Where angles are given, their
// harmonic extension solves one linear system; a component without any takes the eigenvector of the
// smallest eigenvalue, by inverse iteration. Returns false if a factorization fails.
inline bool representation_field(const Field_problem& problem, const Dual_laplacian& laplacian, std::vector<double>& angle)
{
  typedef std::complex<double> Complex;
  typedef Eigen::SparseMatrix<Complex> Matrix;
  typedef Eigen::Matrix<Complex, Eigen::Dynamic, 1> Vector;

  // Keeps the matrix regular where a field without any turning exists (the eigenvalue is then zero);
  // all weights being one, it is far below every other eigenvalue that matters.
  const double regularization = 1e-8;
  // The convergence is geometric with the ratio of the two smallest eigenvalues.
  const int inverse_iterations = 12;

  const int nf = problem.mesh.number_of_faces();
  const int n = laplacian.number_of_unknowns();
  const std::vector<int>& row = laplacian.rows();
  const auto& order = laplacian.permutation().indices();

  angle.assign(nf, 0.);
  for(int f = 0; f < nf; ++f)
    if(row[f] == -1)
      angle[f] = problem.given_angle[f];
  if(n == 0)
    return true;

  std::vector<Eigen::Triplet<Complex> > entries;
  Vector given = Vector::Zero(n);
  for(int i = 0; i < n; ++i)
    entries.emplace_back(i, i, regularization);
  for(int e = 0; e < problem.mesh.number_of_edges(); ++e)
  {
    if(!problem.is_inner(e))
      continue;
    const int f = problem.first_face(e), g = problem.second_face(e);
    const int i = row[f] == -1 ? -1 : order[row[f]], j = row[g] == -1 ? -1 : order[row[g]];
    const Complex w = std::polar(1., 4 * problem.frames.kappa(e));
    if(i != -1) entries.emplace_back(i, i, 1.);
    if(j != -1) entries.emplace_back(j, j, 1.);
    if(i != -1 && j != -1)
    {
      if(i < j) entries.emplace_back(j, i, -w);
      else      entries.emplace_back(i, j, -std::conj(w));
    }
    else if(i != -1)
      given[i] += std::conj(w) * std::polar(1., 4 * angle[g]);
    else if(j != -1)
      given[j] += w * std::polar(1., 4 * angle[f]);
  }
  Matrix a(n, n);
  a.setFromTriplets(entries.begin(), entries.end());
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int> > cholesky(a);
  if(cholesky.info() != Eigen::Success)
    return false;

  std::vector<char> is_free(problem.anchor.size());
  bool any_free = false;
  for(std::size_t c = 0; c < is_free.size(); ++c)
  {
    is_free[c] = problem.anchor[c] != -1;
    any_free = any_free || is_free[c];
  }

  Vector z = Vector::Ones(n);
  for(int iteration = 0; iteration < (any_free ? inverse_iterations : 1); ++iteration)
  {
    Vector rhs = given;
    for(int f = 0; f < nf; ++f)
      if(row[f] != -1 && is_free[problem.component[f]])
        rhs[order[row[f]]] = z[order[row[f]]];
    z = cholesky.solve(rhs);

    std::vector<double> squared_norm(is_free.size(), 0.);
    for(int f = 0; f < nf; ++f)
      if(row[f] != -1)
        squared_norm[problem.component[f]] += std::norm(z[order[row[f]]]);
    for(int f = 0; f < nf; ++f)
      if(row[f] != -1 && is_free[problem.component[f]])
        z[order[row[f]]] /= std::sqrt(squared_norm[problem.component[f]]);
  }

  for(int f = 0; f < nf; ++f)
    if(row[f] != -1)
      angle[f] = std::arg(z[order[row[f]]]) / 4;
  return true;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_REPRESENTATION_FIELD_H
