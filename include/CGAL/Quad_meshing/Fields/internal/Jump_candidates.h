// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_JUMP_CANDIDATES_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_JUMP_CANDIDATES_H

#include <CGAL/Quad_meshing/Fields/internal/Dual_laplacian.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Fields/internal/Sector_quads.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The edges whose period jump may be worth changing, and what a change of one does to the energy and to the
// residuals of the others: a few entries of the projector P of Dual_laplacian. Only edges with a large
// residual can gain: those next to singularities. Candidates stay; new ones are added as the field changes.
class Jump_candidates
{
public:
  // A change gains at most pi |r| - (pi/2)^2 P_ee. In a triangulation P_ee is 1/3 on average (the
  // effective resistance of an edge) and hardly ever below 0.2.
  static constexpr double smallest_residual = 0.15;

  // Up to so many candidates the residuals of all are kept up to date.
  static constexpr int few = 600;

  struct Candidate
  {
    int edge = -1;
    double residual = 0;                        // times the root
    double root = 1;                            // of the weight of the edge
    double self = 1;                            // P_ee
    std::vector<std::pair<int, double>> others; // candidates around and the entries of P, strong ones first
    int strong = 0;                             // the number of strong ones: moves of two pay only with these
  };

  Jump_candidates(const Field_problem& problem, Dual_laplacian& laplacian)
    : m_problem(problem)
    , m_laplacian(laplacian)
    , m_candidate_of_edge(problem.mesh.number_of_edges(), -1)
    , m_mark(problem.mesh.number_of_faces(), 0)
    , m_dense(laplacian.number_of_unknowns(), 0.)
  {
  }

  int size() const { return static_cast<int>(m_candidates.size()); }
  const Candidate& operator[](int i) const { return m_candidates[i]; }

  // Forgets the candidates if they are so many that it takes time to keep their residuals up to date.
  void forget()
  {
    if(size() <= few)
      return;
    for(const Candidate& c : m_candidates)
      m_candidate_of_edge[c.edge] = -1;
    m_candidates.clear();
    m_half_column.clear();
  }

  // Adds the edges that have become candidates, and computes all residuals anew.
  void update(const Cross_field& field, const Sector_quads& quads, Stage_progress& progress)
  {
    const int edges_per_report = 256; // each costs some ten microseconds
    Small_steps steps(progress, edges_per_report);

    const int first_new = size();
    for(int e = 0; e < m_problem.mesh.number_of_edges(); ++e)
      if(m_candidate_of_edge[e] == -1 && m_problem.is_movable(e) &&
         (std::abs(m_problem.residual(e, field)) > smallest_residual || quads.is_costly(e)))
      {
        m_candidate_of_edge[e] = size();
        m_candidates.emplace_back();
        m_candidates.back().edge = e;
        m_candidates.back().root = std::sqrt(m_problem.weight(e));
        m_half_column.push_back(m_laplacian.half_column(e));
        if(!steps.go_further())
          break;
      }
    for(Candidate& c : m_candidates)
      c.residual = c.root * m_problem.residual(c.edge, field);
    for(int i = first_new; i < size() && steps.go_further(); ++i)
      compute_entries(i);
  }

  // How the energy changes if the jump of a candidate does.
  double energy_change(int i, int by) const
  {
    const double step = quarter_turn * m_candidates[i].root;
    return step * (step * m_candidates[i].self + 2 * by * m_candidates[i].residual);
  }

  // Brings the residuals up to date after a change of the jump of a candidate, those of far candidates excepted.
  void change_jump(int i, int by)
  {
    Candidate& c = m_candidates[i];
    const double step = by * quarter_turn * c.root;
    c.residual += step * c.self;
    for(const auto& other : c.others)
      m_candidates[other.first].residual += step * other.second;
  }

  std::vector<double> residuals() const
  {
    std::vector<double> result;
    for(const Candidate& c : m_candidates)
      result.push_back(c.residual);
    return result;
  }
  void set_residuals(const std::vector<double>& residuals)
  {
    for(int i = 0; i < size(); ++i)
      m_candidates[i].residual = residuals[i];
  }

  // Brings the residuals up to date for changes of the jumps along a path of edges, none twice, and returns how the
  // energy changes. All angles must be the best ones for the field.
  double change_path(const std::vector<std::pair<int, int>>& path, const Cross_field& field)
  {
    double change = 0;
    std::vector<int> edges, rows;
    for(const std::pair<int, int>& step : path)
    {
      const int e = step.first;
      edges.push_back(e);
      change += m_problem.weight(e) * quarter_turn * (quarter_turn + 2 * step.second * m_problem.residual(e, field));
    }
    for(const std::pair<int, int>& step : path)
    {
      const int c = m_candidate_of_edge[step.first];
      const double by = step.second * std::sqrt(m_problem.weight(step.first));
      const Sparse_vector y = c == -1 ? m_laplacian.half_column(step.first) : m_half_column[c];
      for(std::size_t p = 0; p < y.index.size(); ++p)
        m_dense[y.index[p]] += by * y.value[p];
      rows.insert(rows.end(), y.index.begin(), y.index.end());
      if(c != -1)
        m_candidates[c].residual += quarter_turn * by;
    }
    for(int c : candidates_around(edges))
      m_candidates[c].residual -= quarter_turn * product(m_half_column[c]);
    for(int k : rows)
    {
      change -= quarter_turn * quarter_turn * m_dense[k] * m_dense[k];
      m_dense[k] = 0;
    }
    return change;
  }

private:
  // The entries of P of candidate i and all before it that are near.
  void compute_entries(int i)
  {
    const Sparse_vector& y = m_half_column[i];
    double self = 1;
    for(std::size_t p = 0; p < y.index.size(); ++p)
    {
      m_dense[y.index[p]] = y.value[p];
      self -= y.value[p] * y.value[p];
    }
    m_candidates[i].self = self;
    for(int j : candidates_around({ m_candidates[i].edge }))
    {
      if(j >= i)
        continue;
      const double entry = -product(m_half_column[j]);
      add_entry(i, j, entry);
      add_entry(j, i, entry);
    }
    for(int k : y.index)
      m_dense[k] = 0;
  }

  void add_entry(int i, int j, double entry)
  {
    // The greatest part of the energy of a move of two that may be due to the second one helping the first.
    const double strong_entry = 0.01;

    Candidate& c = m_candidates[i];
    c.others.emplace_back(j, entry);
    if(std::abs(entry) > strong_entry)
      std::swap(c.others[c.strong++], c.others.back());
  }

  // With m_dense.
  double product(const Sparse_vector& v) const
  {
    double sum = 0;
    for(std::size_t p = 0; p < v.index.size(); ++p)
      sum += m_dense[v.index[p]] * v.value[p];
    return sum;
  }

  // The candidates within some faces of the edges, or all if they are few; what a change does to residuals further away
  // decays with the square of the distance.
  std::vector<int> candidates_around(const std::vector<int>& edges)
  {
    const int steps = 20;
    const Indexed_triangle_mesh& m = m_problem.mesh;
    std::vector<int> result, front, next_front;
    if(size() <= few)
    {
      result.resize(size());
      std::iota(result.begin(), result.end(), 0);
      return result;
    }
    ++m_visit;
    for(int e : edges)
      for(int f : { m_problem.first_face(e), m_problem.second_face(e) })
        if(m_mark[f] != m_visit)
        {
          m_mark[f] = m_visit;
          front.push_back(f);
        }
    for(int step = 0; step < steps && !front.empty(); ++step)
    {
      next_front.clear();
      for(int f : front)
        for(int h = 3 * f; h < 3 * f + 3; ++h)
        {
          const int c = m_candidate_of_edge[m.edge_of[h]];
          if(c != -1)
            result.push_back(c);
          const int o = m.opposite[h];
          if(o != -1 && m_mark[o / 3] != m_visit)
          {
            m_mark[o / 3] = m_visit;
            next_front.push_back(o / 3);
          }
        }
      front.swap(next_front);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const Field_problem& m_problem;
  Dual_laplacian& m_laplacian;
  std::vector<Candidate> m_candidates;
  std::vector<Sparse_vector> m_half_column; // per candidate
  std::vector<int> m_candidate_of_edge;
  std::vector<int> m_mark; // per face: the last visit
  int m_visit = 0;
  std::vector<double> m_dense; // zero between uses
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_JUMP_CANDIDATES_H
