// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_SECTOR_POTENTIALS_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_SECTOR_POTENTIALS_H

#include <CGAL/Quad_meshing/Fields/internal/Dual_laplacian.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The projector P of Dual_laplacian, which says what changes of period jumps do to the residuals, as a dense matrix of
// the sectors: half as many as faces, so that all of it is at hand where the mesh is small.
//
// Let a potential have one value per sector, and none where a border without alignment leaves the turning free. Its
// differences across the movable edges, from the sector that gives a quad to the one that takes it, sum up to zero
// around every free face. So the residuals of best angles consist of such differences and of what is orthogonal to all
// of them: the harmonic part, of two dimensions for every handle and one for every further piece of the constraints.
// With d the matrix of differences, G the inverse of the Laplacian d'd, and H an orthonormal basis of the harmonic
//   part, P = d G d' + H H'.
class Sector_potentials
{
public:
  // A movable edge and the rows of its sectors.
  struct Edge
  {
    int edge, giver, taker;
    float self; // P_ee
  };

  // The part of the residuals that is due to changes of jumps.
  struct State
  {
    Eigen::ArrayXf potential; // per row
    Eigen::ArrayXf harmonic;  // per element of the basis
  };

  Sector_potentials(const Field_problem& problem, const Dual_laplacian& laplacian)
    : m_problem(problem), m_laplacian(laplacian)
  {
    const Field_sectors& sectors = problem.sectors;
    m_row.assign(sectors.number_of_sectors(), -1);
    for(int s = 0; s < sectors.number_of_sectors(); ++s)
      if(sectors.closed[s] || sectors.bounded[s])
        m_row[s] = m_size++;
    for(int& r : m_row)
      if(r == -1)
        r = m_size; // the row of zeros
    for(int e = 0; e < problem.mesh.number_of_edges(); ++e)
      if(problem.is_movable(e))
      {
        const int h = problem.mesh.halfedge_of_edge[e];
        m_edges.push_back({ e, m_row[sectors.of_corner[h]], m_row[sectors.of_corner[problem.mesh.next(h)]], 0.f });
      }
    grow_forests();
  }

  // Whether `compute()` takes little time and memory.
  bool is_small() const
  {
    const int most_sectors = 1500, most_harmonic = 32;
    return m_size <= most_sectors && static_cast<int>(m_loops.size()) <= most_harmonic;
  }

  // To be called before everything that follows. Returns false if a factorization fails.
  bool compute()
  {
    if(!compute_inverse())
      return false;
    compute_harmonic_basis();
    for(Edge& e : m_edges)
      e.self = m_inverse(e.giver, e.giver) + m_inverse(e.taker, e.taker) - 2 * m_inverse(e.giver, e.taker);
    for(int i = 0; i < number_of_edges(); ++i)
      m_edges[i].self += m_harmonic.col(i).squaredNorm();
    return true;
  }

  int number_of_rows() const { return m_size; }
  int number_of_edges() const { return static_cast<int>(m_edges.size()); }
  const Edge& edge(int i) const { return m_edges[i]; }
  // The row of a sector; `number_of_rows()` for those that have none.
  int row(int sector) const { return m_row[sector]; }

  State make_state() const { return { Eigen::ArrayXf::Zero(m_size + 1), Eigen::ArrayXf::Zero(m_harmonic.rows()) }; }

  // What the state adds to the residual of an edge.
  float difference(int i, const State& state) const
  {
    const int n = static_cast<int>(state.harmonic.size());
    const float* h = m_harmonic.data() + static_cast<std::size_t>(i) * n;
    float sum = state.potential.data()[m_edges[i].giver] - state.potential.data()[m_edges[i].taker];
    for(int k = 0; k < n; ++k)
      sum += h[k] * state.harmonic.data()[k];
    return sum;
  }

  // Adds `by` times the column of P of an edge.
  void add_column(int i, float by, State& state) const
  {
    state.potential += by * (m_inverse.col(m_edges[i].giver) - m_inverse.col(m_edges[i].taker)).array();
    state.harmonic += by * m_harmonic.col(i).array();
  }

private:
  // A spanning forest of the faces, the given ones taken as one, and one of the sectors that crosses none of its edges.
  // Every edge that is in neither closes a loop of sectors, and the harmonic parts of these loops are a basis. (A set
  // of sectors that only edges of the first forest connected with the rest would have a coboundary in it, and that is a
  // cycle.)
  void grow_forests()
  {
    const int nf = m_problem.mesh.number_of_faces();
    Disjoint_sets faces(nf + 1), sectors(m_size + 1);
    auto face = [&](int f) { return m_problem.constrained[f] ? nf : f; };
    for(int i = 0; i < number_of_edges(); ++i)
    {
      const int e = m_edges[i].edge;
      if(faces.join(face(m_problem.first_face(e)), face(m_problem.second_face(e))))
        continue;
      (sectors.join(m_edges[i].giver, m_edges[i].taker) ? m_sector_forest : m_loops).push_back(i);
    }
    const int of_zeros = sectors.find(m_size);
    for(int r = 0; r < m_size; ++r)
      if(sectors.find(r) == r && r != of_zeros)
        m_anchors.push_back(r); // of a component without a row of zeros
  }

  bool compute_inverse()
  {
    m_inverse.setZero(m_size + 1, m_size + 1);
    if(m_size == 0)
      return true;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * m_edges.size() + m_anchors.size());
    for(const Edge& e : m_edges)
    {
      if(e.giver == e.taker)
        continue;
      if(e.giver != m_size)
        entries.emplace_back(e.giver, e.giver, 1.);
      if(e.taker != m_size)
        entries.emplace_back(e.taker, e.taker, 1.);
      if(e.giver != m_size && e.taker != m_size)
        entries.emplace_back((std::max)(e.giver, e.taker), (std::min)(e.giver, e.taker), -1.);
    }
    // Only differences of potentials count.
    for(int r : m_anchors)
      entries.emplace_back(r, r, 1.);
    Eigen::SparseMatrix<double> a(m_size, m_size);
    a.setFromTriplets(entries.begin(), entries.end());
    Sparse_cholesky<double> cholesky;
    if(!cholesky.compute(a))
      return false;
    const std::unique_ptr<Cholesky_factor<double>> l = cholesky.factor();

    // Rows are numbered as in the factorization L L' from here on.
    std::vector<int> number(m_size);
    for(int i = 0; i < m_size; ++i)
      number[l->permutation[i]] = i;
    auto renumber = [&](int& r) { r = r == m_size ? r : number[r]; };
    for(int& r : m_row)
      renumber(r);
    for(Edge& e : m_edges)
    {
      renumber(e.giver);
      renumber(e.taker);
    }

    // With M = L scaled to a unit diagonal, and D that diagonal squared, G M = M'^-1 D^-1 is upper triangular with the
    // diagonal of D^-1, so the columns of G follow from each other, last one first: a few additions of vectors each, as
    // L is sparse.
    for(int j = m_size - 1; j >= 0; --j)
    {
      const int below = m_size - 1 - j;
      const std::size_t begin = l->column_begin[j], end = l->column_begin[j + 1];
      const double d = l->value[begin];
      auto column = m_inverse.col(j).segment(j + 1, below);
      double diagonal = 1 / (d * d);
      for(std::size_t p = begin + 1; p < end; ++p)
        column -= static_cast<float>(l->value[p] / d) * m_inverse.col(l->row[p]).segment(j + 1, below);
      for(std::size_t p = begin + 1; p < end; ++p)
        diagonal -= l->value[p] / d * m_inverse(l->row[p], j);
      m_inverse(j, j) = static_cast<float>(diagonal);
      m_inverse.row(j).segment(j + 1, below) = column;
    }
    return true;
  }

  void compute_harmonic_basis()
  {
    const int m = number_of_edges(), n = static_cast<int>(m_loops.size());
    m_harmonic.resize(n, m);
    if(n == 0)
      return;

    // The forest of sectors, hung up at its roots.
    std::vector<std::vector<int>> around(m_size + 1);
    for(int i : m_sector_forest)
    {
      around[m_edges[i].giver].push_back(i);
      around[m_edges[i].taker].push_back(i);
    }
    std::vector<int> edge_up(m_size + 1, -1), depth(m_size + 1, -1), queue;
    auto above = [&](int r)
    {
      const Edge& e = m_edges[edge_up[r]];
      return e.giver == r ? e.taker : e.giver;
    };
    for(int root = 0; root <= m_size; ++root)
    {
      if(depth[root] != -1)
        continue;
      depth[root] = 0;
      queue.assign(1, root);
      while(!queue.empty())
      {
        const int r = queue.back();
        queue.pop_back();
        for(int i : around[r])
        {
          const int s = m_edges[i].giver == r ? m_edges[i].taker : m_edges[i].giver;
          if(depth[s] != -1)
            continue;
          depth[s] = depth[r] + 1;
          edge_up[s] = i;
          queue.push_back(s);
        }
      }
    }

    Eigen::MatrixXd basis(m, n);
    Eigen::VectorXd loop(m_problem.mesh.number_of_edges());
    for(int k = 0; k < n; ++k)
    {
      // Across the edge that closes the loop, and back from its taker to its giver along the forest.
      loop.setZero();
      loop[m_edges[m_loops[k]].edge] = 1;
      int r = m_edges[m_loops[k]].taker, s = m_edges[m_loops[k]].giver;
      while(r != s)
      {
        int& lower = depth[r] >= depth[s] ? r : s;
        const Edge& e = m_edges[edge_up[lower]];
        loop[e.edge] += (e.giver == lower) == (&lower == &r) ? 1 : -1;
        lower = above(lower);
      }
      m_laplacian.project(loop);
      for(int i = 0; i < m; ++i)
        basis(i, k) = loop[m_edges[i].edge];
      for(int pass = 0; pass < 2; ++pass) // one alone leaves rounding errors
        for(int j = 0; j < k; ++j)
          basis.col(k) -= basis.col(j).dot(basis.col(k)) * basis.col(j);
      basis.col(k).normalize();
    }
    m_harmonic = basis.transpose().cast<float>();
  }

  const Field_problem& m_problem;
  const Dual_laplacian& m_laplacian;
  int m_size = 0;
  std::vector<int> m_row; // per sector
  std::vector<Edge> m_edges;
  std::vector<int> m_sector_forest; // edges of the forest of sectors
  std::vector<int> m_loops;         // edges that close the loops
  std::vector<int> m_anchors;       // rows
  Eigen::MatrixXf m_inverse;        // G, with a row and a column of zeros at its end
  Eigen::MatrixXf m_harmonic;       // H
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_SECTOR_POTENTIALS_H
