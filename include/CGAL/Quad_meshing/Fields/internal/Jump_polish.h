// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_JUMP_POLISH_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_JUMP_POLISH_H

#include <CGAL/Quad_meshing/Fields/internal/Dual_laplacian.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Fields/internal/Sector_quads.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Local search over the period jumps: changes one jump, or two at once, as long as that lowers the
// energy plus the cost of the sectors, and never empties a sector.
//
// A change of one jump moves a singularity along an edge, creates a pair of opposite ones or
// annihilates it; two changes move one twice as far or move two that hold each other. With the
// angles eliminated the gain of every move is known exactly from the residuals and a few entries
// of the projector P (see Dual_laplacian), so one factorization serves them all. Only edges with
// a large residual can gain: those next to singularities.
class Jump_polish
{
public:
  Jump_polish(const Field_problem& problem, Dual_laplacian& laplacian)
    : m_problem(problem), m_laplacian(laplacian)
    , m_candidate_of_edge(problem.mesh.number_of_edges(), -1)
    , m_mark(problem.mesh.number_of_faces(), -1)
  {}

  // Polishes the field, whose angles are the best ones for its jumps; so they are again at the end.
  // Returns the energy plus the cost of the sectors. `go_further` is asked between the rounds. What has been computed about
  // candidates serves later calls as well.
  template <typename Go_further>
  double operator()(Cross_field& field, Sector_quads& quads, const Go_further& go_further)
  {
    m_quads = &quads;

    // The residuals of far candidates are only brought up to date between rounds, and every jump is
    // changed at most once per round (what is neglected of P could otherwise make a cycle of changes look
    // like an endless gain), so a round may leave something for the next; a handful is usual.
    const int maximum_rounds = 100;

    double energy = m_problem.energy(field) + m_quads->cost();
    for(int round = 0; round < maximum_rounds && go_further(); ++round)
    {
      find_candidates(field);
      const Cross_field before = field;
      const Sector_quads::State quads_before = m_quads->state();
      if(!improve(field))
        break;
      m_laplacian.solve_angles(field);
      const double new_energy = m_problem.energy(field) + m_quads->cost();
      if(!(new_energy < energy - smallest_gain))
      {
        field = before;
        m_quads->set_state(quads_before);
        break;
      }
      energy = new_energy;
    }
    return energy;
  }

private:
  // One jump to be changed by +1 or -1.
  struct Change { int candidate; int by; };

  struct Candidate
  {
    int edge = -1;
    double residual = 0;
    double self = 1;                              // P_ee
    bool changed = false;                         // in this round
    std::vector<std::pair<int, double> > others;  // candidates around and the entries of P
  };

  // A gain below this is rounding: energies are of the order of one per singularity.
  static constexpr double smallest_gain = 1e-9;

  void find_candidates(const Cross_field& field)
  {
    // A change gains at most pi |r| - (pi/2)^2 P_ee. In a triangulation P_ee is 1/3 on average (the
    // effective resistance of an edge) and hardly ever below 0.2.
    const double smallest_residual = 0.15;

    const int first_new = static_cast<int>(m_candidates.size());
    for(int e = 0; e < m_problem.mesh.number_of_edges(); ++e)
      if(m_candidate_of_edge[e] == -1 && m_problem.is_movable(e) &&
         (std::abs(m_problem.residual(e, field)) > smallest_residual || m_quads->is_costly(e)))
      {
        m_candidate_of_edge[e] = static_cast<int>(m_candidates.size());
        m_candidates.emplace_back();
        m_candidates.back().edge = e;
        m_half_column.push_back(m_laplacian.half_column(e));
      }
    for(Candidate& c : m_candidates)
    {
      c.residual = m_problem.residual(c.edge, field);
      c.changed = false;
    }

    m_dense.resize(m_laplacian.number_of_unknowns(), 0.);
    for(int i = first_new; i < static_cast<int>(m_candidates.size()); ++i)
    {
      const Sparse_vector& y = m_half_column[i];
      double self = 1;
      for(std::size_t p = 0; p < y.index.size(); ++p)
      {
        m_dense[y.index[p]] = y.value[p];
        self -= y.value[p] * y.value[p];
      }
      m_candidates[i].self = self;
      for(int j : candidates_around(i))
      {
        if(j >= i)
          continue;
        double entry = 0;
        const Sparse_vector& z = m_half_column[j];
        for(std::size_t p = 0; p < z.index.size(); ++p)
          entry -= m_dense[z.index[p]] * z.value[p];
        m_candidates[i].others.emplace_back(j, entry);
        m_candidates[j].others.emplace_back(i, entry);
      }
      for(int k : y.index)
        m_dense[k] = 0;
    }
  }

  // The candidates within a few faces of candidate i; what a change does to residuals further away
  // decays with the square of the distance.
  std::vector<int> candidates_around(int i)
  {
    const int steps = 10;
    const Indexed_triangle_mesh& m = m_problem.mesh;
    std::vector<int> result, front, next_front;
    for(int f : { m_problem.first_face(m_candidates[i].edge), m_problem.second_face(m_candidates[i].edge) })
    {
      m_mark[f] = i;
      front.push_back(f);
    }
    for(int step = 0; step < steps && !front.empty(); ++step)
    {
      next_front.clear();
      for(int f : front)
        for(int h = 3 * f; h < 3 * f + 3; ++h)
        {
          const int c = m_candidate_of_edge[m.edge_of[h]];
          if(c != -1 && c != i)
            result.push_back(c);
          const int o = m.opposite[h];
          if(o != -1 && m_mark[o / 3] != i)
          {
            m_mark[o / 3] = i;
            next_front.push_back(o / 3);
          }
        }
      front.swap(next_front);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // How the energy changes, without the cost of sectors.
  double energy_change(const Change& a) const
  {
    const Candidate& c = m_candidates[a.candidate];
    return quarter_turn * (quarter_turn * c.self + 2 * a.by * c.residual);
  }

  // Changes jumps, best gains first, until neither one change nor a pair gains. Returns whether any
  // did.
  bool improve(Cross_field& field)
  {
    bool any = false;
    for(;;)
    {
      if(change_singles(field) || change_pairs(field))
        any = true;
      else
        return any;
    }
  }

  bool change_singles(Cross_field& field)
  {
    std::vector<std::pair<double, Change> > moves;
    for(int i = 0; i < static_cast<int>(m_candidates.size()); ++i)
      for(int by : { -1, 1 })
      {
        const Change a = { i, by };
        const double gain = -single_change(a);
        if(gain > smallest_gain)
          moves.emplace_back(gain, a);
      }
    sort_moves(moves);
    bool any = false;
    for(const auto& move : moves)
    {
      if(single_change(move.second) < -smallest_gain)
      {
        apply(move.second, field);
        any = true;
      }
    }
    return any;
  }

  bool change_pairs(Cross_field& field)
  {
    typedef std::pair<Change, Change> Pair;
    std::vector<std::pair<double, std::pair<Pair, double> > > moves;
    for(int i = 0; i < static_cast<int>(m_candidates.size()); ++i)
      for(const auto& other : m_candidates[i].others)
      {
        if(other.first < i)
          continue;
        for(int bi : { -1, 1 })
          for(int bj : { -1, 1 })
          {
            const Pair p = { { i, bi }, { other.first, bj } };
            const double gain = -pair_change(p, other.second);
            if(gain > smallest_gain)
              moves.emplace_back(gain, std::make_pair(p, other.second));
          }
      }
    sort_moves(moves);
    bool any = false;
    for(const auto& move : moves)
    {
      const Pair& p = move.second.first;
      if(pair_change(p, move.second.second) < -smallest_gain)
      {
        apply(p.first, field);
        apply(p.second, field);
        any = true;
      }
    }
    return any;
  }

  // Where nothing costs yet, only the energy can gain.
  double single_change(const Change& a)
  {
    const int e = m_candidates[a.candidate].edge;
    if(m_candidates[a.candidate].changed)
      return 0;
    const double change = energy_change(a);
    return (change < 0 || m_quads->is_costly(e)) ? change + m_quads->cost_change(e, a.by) : change;
  }

  double pair_change(const std::pair<Change, Change>& p, double entry)
  {
    const int e = m_candidates[p.first.candidate].edge, e2 = m_candidates[p.second.candidate].edge;
    if(m_candidates[p.first.candidate].changed || m_candidates[p.second.candidate].changed)
      return 0;
    const double change = energy_change(p.first) + energy_change(p.second)
                        + 2 * quarter_turn * quarter_turn * entry * p.first.by * p.second.by;
    return (change < 0 || m_quads->is_costly(e) || m_quads->is_costly(e2))
         ? change + m_quads->cost_change(e, p.first.by, e2, p.second.by) : change;
  }

  // Largest gain first, ties in the order of the candidates.
  template <typename Move>
  static void sort_moves(std::vector<std::pair<double, Move> >& moves)
  {
    std::stable_sort(moves.begin(), moves.end(),
                     [](const std::pair<double, Move>& a, const std::pair<double, Move>& b) { return a.first > b.first; });
  }

  void apply(const Change& a, Cross_field& field)
  {
    Candidate& c = m_candidates[a.candidate];
    c.changed = true;
    field.period_jump[c.edge] += a.by;
    m_quads->change_jump(c.edge, a.by);
    c.residual += quarter_turn * a.by * c.self;
    for(const auto& other : c.others)
      m_candidates[other.first].residual += quarter_turn * a.by * other.second;
  }

  const Field_problem& m_problem;
  Dual_laplacian& m_laplacian;
  Sector_quads* m_quads = nullptr;          // of the running call
  std::vector<Candidate> m_candidates;
  std::vector<Sparse_vector> m_half_column; // per candidate
  std::vector<int> m_candidate_of_edge;
  std::vector<int> m_mark;                  // per face: the last candidate that visited it
  std::vector<double> m_dense;              // zero between uses
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_JUMP_POLISH_H
