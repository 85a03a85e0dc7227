// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_REPRESENTATION_FIELD_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_REPRESENTATION_FIELD_H

#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
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
// the first; the energy, the sum of w |exp(4 i kappa) z_i - z_j|^2 over the edges, is quadratic. Where angles are
// given, their harmonic extension solves one linear system; a component without any takes the eigenvector of the
// smallest eigenvalue, by inverse iteration.
//
// With all weights one, the energy is that of the period jumps [Bom12, 8.2].
//
// The field is a start for a local search, so it need not be exact: it is computed for clusters of
// faces, in each of which it is parallel along a tree (the Galerkin method), and then smoothed on the faces.
class Representation_field
{
public:
  // With at least as many clusters as faces the field is exact.
  Representation_field(const Field_problem& problem, int number_of_clusters, Stage_progress& progress)
    : m_problem(problem)
    , m_mesh(problem.mesh)
    , m_progress(progress)
    , m_cluster_size((std::max)(1, problem.mesh.number_of_faces() / number_of_clusters))
  {
  }

  // Sets the angles of all faces. Returns false if a factorization fails. If the visitor stops it, the angles are of no
  // use.
  bool operator()(std::vector<double>& angle)
  {
    make_clusters();
    if(!solve_on_clusters())
      return false;
    smooth();
    angle.resize(m_mesh.number_of_faces());
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      angle[f] = m_problem.constrained[f] ? m_problem.given_angle[f] : std::arg(m_z[f]) / 4;
    return true;
  }

private:
  typedef std::complex<double> Complex;
  typedef Eigen::Matrix<Complex, Eigen::Dynamic, 1> Vector;

  // exp(4 i kappa) across halfedge h, from its face to the opposite one.
  Complex transport(int h) const
  {
    const int e = m_mesh.edge_of[h];
    const double kappa = m_problem.kappa(e);
    return std::polar(1., m_mesh.halfedge_of_edge[e] == h ? 4 * kappa : -4 * kappa);
  }

  // Grows clusters of free faces in breadth-first order, all of about the same size.
  void make_clusters()
  {
    const int nf = m_mesh.number_of_faces();
    m_cluster.assign(nf, -1);
    m_phase.assign(nf, Complex(1.));
    m_component_of_cluster.clear();
    std::vector<int> queue;
    for(int seed = 0; seed < nf; ++seed)
    {
      if(m_cluster[seed] != -1 || m_problem.constrained[seed])
        continue;
      const int id = static_cast<int>(m_component_of_cluster.size());
      m_component_of_cluster.push_back(m_problem.component[seed]);
      queue.assign(1, seed);
      m_cluster[seed] = id;
      for(std::size_t next = 0; next < queue.size(); ++next)
        for(int h = 3 * queue[next]; h < 3 * queue[next] + 3; ++h)
        {
          const int g = m_mesh.opposite[h] / 3;
          if(m_mesh.opposite[h] == -1 || m_cluster[g] != -1 || m_problem.constrained[g] ||
             static_cast<int>(queue.size()) == m_cluster_size)
            continue;
          m_cluster[g] = id;
          m_phase[g] = transport(h) * m_phase[queue[next]];
          queue.push_back(g);
        }
    }
  }

  bool solve_on_clusters()
  {
    // Keeps the matrix regular where a field without any turning exists (the eigenvalue is then
    // zero); all weights being about one, it is far below every other eigenvalue that matters.
    const double regularization = 1e-8;
    // The convergence is geometric with the ratio of the two smallest eigenvalues.
    const int inverse_iterations = 12;

    const int n = static_cast<int>(m_component_of_cluster.size());
    std::vector<Eigen::Triplet<Complex>> entries;
    Vector given = Vector::Zero(n);
    for(int i = 0; i < n; ++i)
      entries.emplace_back(i, i, regularization);
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
    {
      if(!m_problem.is_inner(e))
        continue;
      const int f = m_problem.first_face(e), g = m_problem.second_face(e);
      const int i = m_cluster[f], j = m_cluster[g];
      const Complex w = transport(m_mesh.halfedge_of_edge[e]) * m_phase[f], v = m_phase[g];
      const double weight = m_problem.weight(e);
      if(i == j)
      {
        if(i != -1)
          entries.emplace_back(i, i, weight * std::norm(w - v));
        continue;
      }
      if(i != -1)
        entries.emplace_back(i, i, weight);
      if(j != -1)
        entries.emplace_back(j, j, weight);
      if(i != -1 && j != -1)
      {
        if(i < j)
          entries.emplace_back(j, i, -weight * std::conj(v) * w);
        else
          entries.emplace_back(i, j, -weight * std::conj(w) * v);
      }
      else if(i != -1)
        given[i] += weight * std::conj(w) * std::polar(1., 4 * m_problem.given_angle[g]);
      else
        given[j] += weight * std::conj(v) * w * std::polar(1., 4 * m_problem.given_angle[f]);
    }
    for(std::size_t f = 0; f < m_problem.soft_weight.size(); ++f)
      if(m_cluster[f] != -1 && m_problem.soft_weight[f] > 0)
      {
        entries.emplace_back(m_cluster[f], m_cluster[f], m_problem.soft_weight[f]);
        given[m_cluster[f]] +=
          m_problem.soft_weight[f] * std::conj(m_phase[f]) * std::polar(1., 4 * m_problem.soft_angle[f]);
      }
    Eigen::SparseMatrix<Complex> a(n, n);
    a.setFromTriplets(entries.begin(), entries.end());
    Sparse_cholesky<Complex> cholesky;
    if(!cholesky.compute(a))
      return false;

    std::vector<char> is_free(m_problem.anchor.size());
    bool any_free = false;
    for(std::size_t c = 0; c < is_free.size(); ++c)
    {
      is_free[c] = m_problem.anchor[c] != -1;
      any_free = any_free || is_free[c];
    }

    Vector z = Vector::Ones(n);
    for(int iteration = 0; n > 0 && iteration < (any_free ? inverse_iterations : 1); ++iteration)
    {
      if(!m_progress.go_further())
        break;
      Vector rhs = given;
      for(int i = 0; i < n; ++i)
        if(is_free[m_component_of_cluster[i]])
          rhs[i] = z[i];
      z = cholesky.solve(rhs);

      std::vector<double> squared_norm(is_free.size(), 0.);
      for(int i = 0; i < n; ++i)
        squared_norm[m_component_of_cluster[i]] += std::norm(z[i]);
      for(int i = 0; i < n; ++i)
        if(is_free[m_component_of_cluster[i]])
          z[i] /= std::sqrt(squared_norm[m_component_of_cluster[i]]);
    }

    m_z.resize(m_mesh.number_of_faces());
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      m_z[f] = m_problem.constrained[f] ? std::polar(1., 4 * m_problem.given_angle[f]) : m_phase[f] * z[m_cluster[f]];
    return true;
  }

  // Gauss-Seidel sweeps in alternating order, enough to level the steps between clusters.
  void smooth()
  {
    const int nf = m_mesh.number_of_faces();
    if(m_cluster_size == 1)
      return;
    const int sweeps = 20;
    std::vector<Complex> across(m_mesh.number_of_edges()); // weighted
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      across[e] = m_problem.weight(e) * transport(m_mesh.halfedge_of_edge[e]);
    for(int sweep = 0; sweep < sweeps && m_progress.go_further(); ++sweep)
      for(int i = 0; i < nf; ++i)
      {
        const int f = sweep % 2 == 0 ? i : nf - 1 - i;
        if(m_problem.constrained[f])
          continue;
        Complex sum = 0.;
        double degree = 0;
        if(!m_problem.soft_weight.empty() && m_problem.soft_weight[f] > 0)
        {
          degree = m_problem.soft_weight[f];
          sum = degree * std::polar(1., 4 * m_problem.soft_angle[f]);
        }
        for(int h = 3 * f; h < 3 * f + 3; ++h)
        {
          if(m_mesh.opposite[h] == -1)
            continue;
          const int e = m_mesh.edge_of[h];
          const Complex& w = across[e];
          sum += (m_mesh.halfedge_of_edge[e] == h ? std::conj(w) : w) * m_z[m_mesh.opposite[h] / 3];
          degree += m_problem.weight(e);
        }
        if(degree > 0)
          m_z[f] = sum / degree;
      }
  }

  const Field_problem& m_problem;
  const Indexed_triangle_mesh& m_mesh;
  Stage_progress& m_progress;
  const int m_cluster_size;
  std::vector<int> m_cluster;   // per face, -1 if its angle is given
  std::vector<Complex> m_phase; // per face: z = phase * z of the cluster
  std::vector<int> m_component_of_cluster;
  std::vector<Complex> m_z; // per face
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_REPRESENTATION_FIELD_H
