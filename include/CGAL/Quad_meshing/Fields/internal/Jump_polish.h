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
#include <CGAL/Quad_meshing/Fields/internal/Jump_candidates.h>
#include <CGAL/Quad_meshing/Fields/internal/Sector_quads.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
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
// of the projector P, so one factorization serves them all, and after a move only the candidates around it
// have to be looked at again.
class Jump_polish
{
public:
  Jump_polish(const Field_problem& problem, Dual_laplacian& laplacian, Stage_progress& progress)
    : m_problem(problem), m_laplacian(laplacian), m_progress(progress), m_candidates(problem, laplacian)
  {
  }

  // Moves downhill until no move gains. The angles of the field are the best ones for its jumps, and so they are again
  // at the end. Returns the energy plus the cost of the sectors. If the visitor stops it, the field is of no use.
  double operator()(Cross_field& field, Sector_quads& quads)
  {
    begin(field, quads);
    enqueue_all();
    descend(field);
    settle(field);
    return m_total;
  }

  // Leaves the local minimum: annihilates a pair of opposite singularities, goes downhill from there, and takes that
  // back if it does not end lower; first all with their nearest partners, then with the second nearest, and so on, at
  // most `trials` times.
  double annihilate(Cross_field& field, Sector_quads& quads, int trials)
  {
    const int most_partners = 3;

    m_candidates.forget(); // those that the way here has left behind
    begin(field, quads);
    for(int partner = 0; partner < most_partners; ++partner)
      for(int s = 0; s < m_problem.sectors.number_of_sectors(); ++s)
      {
        if(m_quads->state()[s] == 4 || !m_problem.sectors.closed[s])
          continue;
        if(!m_progress.go_further())
          return m_total;
        const Path path = path_to_opposite(s, partner);
        if(path.empty())
          continue;
        if(trials-- <= 0)
          return m_total;
        try_path(path, field);
      }
    return m_total;
  }

private:
  // One jump to be changed by +1 or -1.
  struct Change
  {
    int candidate = -1, by = 0;
  };
  struct Move
  {
    Change first, second;
    double change = 0;
  };
  typedef std::vector<std::pair<int, int>> Path; // edges and the changes of their jumps

  // A gain below this may be due to what is neglected of P. Energies are of the order of one half per singularity.
  static constexpr double smallest_gain = 1e-3;

  void begin(const Cross_field& field, Sector_quads& quads)
  {
    m_quads = &quads;
    m_total = m_problem.energy(field) + quads.cost();
    save(field);
    update_candidates(field);
  }

  void update_candidates(const Cross_field& field)
  {
    m_candidates.update(field, *m_quads, m_progress);
    m_is_queued.assign(m_candidates.size(), 0);
  }

  void enqueue_all()
  {
    for(int i = 0; i < m_candidates.size(); ++i)
      enqueue(i);
  }

  void save(const Cross_field& field)
  {
    m_saved = field;
    m_saved_quads = m_quads->state();
  }

  // Goes downhill with all angles computed anew, until no move gains, and keeps the result if it is the lowest so far;
  // else the field becomes again what it was when it was lowest.
  void settle(Cross_field& field)
  {
    // The residuals of far candidates are only brought up to date between rounds, so a round may leave
    // something for the next; a handful is usual.
    const int maximum_rounds = 100;

    double last = std::numeric_limits<double>::infinity();
    bool is_saved = false;
    for(int round = 0; round < maximum_rounds; ++round)
    {
      m_laplacian.solve_angles(field);
      const double total = m_problem.energy(field) + m_quads->cost();
      is_saved = total < m_total - smallest_gain;
      if(is_saved)
      {
        m_total = total;
        save(field);
      }
      if(!(total < last - smallest_gain) || !m_progress.go_further())
        break;
      last = total;
      update_candidates(field);
      m_log.clear();
      enqueue_all();
      descend(field);
      if(m_log.empty())
        break;
      is_saved = false;
    }
    if(!is_saved)
    {
      field = m_saved;
      m_quads->set_state(m_saved_quads);
    }
    update_candidates(field);
  }

  void enqueue(int i)
  {
    if(!m_is_queued[i] && is_promising(i))
    {
      m_is_queued[i] = 1;
      m_queue.push_back(i);
    }
  }

  bool is_promising(int i) const
  {
    return std::abs(m_candidates[i].residual) > Jump_candidates::smallest_residual * m_candidates[i].root ||
           m_quads->is_costly(m_candidates[i].edge);
  }

  // Applies the best move of every queued candidate. Returns the change of energy and cost.
  double descend(Cross_field& field)
  {
    // What is neglected of P could make a cycle of moves look like an endless gain.
    std::size_t steps = 4 * static_cast<std::size_t>(m_candidates.size());

    const int moves_per_report = 256; // each costs some ten microseconds
    Small_steps report(m_progress, moves_per_report);

    double total = 0;
    for(; !m_queue.empty(); m_queue.pop_front())
    {
      if(!report.go_further())
        steps = 0;
      const int i = m_queue.front();
      m_is_queued[i] = 0;
      if(steps == 0)
        continue;
      const Move move = best_move(i);
      if(move.first.candidate == -1)
        continue;
      --steps;
      total += move.change;
      apply(move.first, field);
      if(move.second.candidate != -1)
        apply(move.second, field);
      enqueue(i);
    }
    return total;
  }

  Move best_move(int i)
  {
    Move best;
    best.change = -smallest_gain;
    const Jump_candidates::Candidate& c = m_candidates[i];
    const bool is_costly = m_quads->is_costly(c.edge);
    for(int by : { -1, 1 })
    {
      const double alone = m_candidates.energy_change(i, by);
      if(alone < best.change || is_costly)
      {
        const double change = alone + m_quads->cost_change(c.edge, by);
        if(change < best.change)
        {
          best.first = { i, by };
          best.second = Change();
          best.change = change;
        }
      }
      for(int k = 0; k < c.strong; ++k)
      {
        const std::pair<int, double>& other = c.others[k];
        const int j = other.first;
        const Jump_candidates::Candidate& d = m_candidates[j];
        const bool may_pay = is_costly || m_quads->is_costly(d.edge);
        const double step = quarter_turn * c.root, step2 = quarter_turn * d.root;
        // If the second change does not gain alone, only what couples both can pay for the first.
        if(2 * step * step2 * std::abs(other.second) < alone && !may_pay)
          continue;
        const double both = alone + step2 * step2 * d.self;
        const double slope = 2 * step2 * (d.residual + step * by * other.second);
        const int by2 = slope > 0 ? -1 : 1; // the better one
        const double energy = both + slope * by2;
        if(energy >= best.change && !may_pay)
          continue;
        for(int b : { by2, -by2 })
        {
          const double change = both + slope * b + m_quads->cost_change(c.edge, by, d.edge, b);
          if(change < best.change)
          {
            best.first = { i, by };
            best.second = { j, b };
            best.change = change;
          }
          if(!may_pay)
            break;
        }
      }
    }
    return best;
  }

  // The path that annihilates the singularity of a closed sector and the one that is nearest, second nearest ... of the
  // opposite ones; empty if there is none within reach.
  Path path_to_opposite(int from, int partner)
  {
    const std::size_t most_sectors = 10000; // that are searched

    const Indexed_triangle_mesh& m = m_problem.mesh;
    const Field_sectors& sectors = m_problem.sectors;
    const Sector_quads::State& quads = m_quads->state();
    const int gain = quads[from] < 4 ? 1 : -1; // of quads there
    ++m_visit;
    m_visited.resize(sectors.number_of_sectors(), 0);
    m_via.resize(sectors.number_of_sectors(), -1);
    m_visited[from] = m_visit;
    std::vector<int> queue(1, from);
    for(std::size_t next = 0; next < (std::min)(queue.size(), most_sectors); ++next)
    {
      const int s = queue[next];
      if((quads[s] - 4) * gain > 0 && partner-- == 0)
      {
        Path path;
        for(int t = s; t != from; t = sectors.of_corner[m_via[t]])
        {
          // A quad moves to the source of the halfedge, or away.
          const int e = m.edge_of[m_via[t]];
          path.emplace_back(e, m.halfedge_of_edge[e] == m_via[t] ? -gain : gain);
        }
        return path;
      }
      const int first = sectors.first_corner[s];
      int h = first;
      do
      {
        const int t = sectors.of_corner[m.next(h)];
        if(sectors.closed[t] && m_visited[t] != m_visit)
        {
          m_visited[t] = m_visit;
          m_via[t] = h;
          queue.push_back(t);
        }
        h = m.next_around_source(h);
      }
      while(h != first);
    }
    return Path();
  }

  // Annihilates the singularities at the ends of a path, and keeps what follows if it ends lower.
  void try_path(const Path& path, Cross_field& field)
  {
    // A change of a residual that may make a move gain, and an increase of the energy that the search with all angles
    // and candidates computed anew may still make up for.
    const double noticeable = 0.01, hopeful = 0.3;

    const std::vector<double> residuals = m_candidates.residuals();
    m_log.clear();
    double change = m_candidates.change_path(path, field) - m_quads->cost();
    for(const std::pair<int, int>& step : path)
      change_jump(step.first, step.second, field);
    change += m_quads->cost();
    for(int i = 0; i < m_candidates.size(); ++i)
      if(std::abs(m_candidates[i].residual - residuals[i]) > noticeable)
        enqueue(i);
    change += descend(field);
    if(change < hopeful)
      return settle(field);

    for(std::size_t k = m_log.size(); k-- > 0;)
      change_jump(m_candidates[m_log[k].candidate].edge, -m_log[k].by, field);
    for(const std::pair<int, int>& step : path)
      change_jump(step.first, -step.second, field);
    m_candidates.set_residuals(residuals);
  }

  void apply(const Change& a, Cross_field& field)
  {
    const Jump_candidates::Candidate& c = m_candidates[a.candidate];
    change_jump(c.edge, a.by, field);
    m_candidates.change_jump(a.candidate, a.by);
    m_log.push_back(a);
    for(int k = 0; k < c.strong; ++k)
      enqueue(c.others[k].first);
  }

  void change_jump(int e, int by, Cross_field& field)
  {
    field.period_jump[e] += by;
    m_quads->change_jump(e, by);
  }

  const Field_problem& m_problem;
  Dual_laplacian& m_laplacian;
  Stage_progress& m_progress;
  Jump_candidates m_candidates;

  // Of the running call: the quads, the best field with exact angles, and its energy plus the cost of its sectors.
  Sector_quads* m_quads = nullptr;
  Cross_field m_saved;
  Sector_quads::State m_saved_quads;
  double m_total = 0;

  std::vector<Change> m_log;     // of this round
  std::deque<int> m_queue;       // candidates to be looked at
  std::vector<char> m_is_queued; // per candidate

  // Per sector, of the breadth-first searches: the last one that came, and the halfedge by which it came.
  std::vector<int> m_visited, m_via;
  int m_visit = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_JUMP_POLISH_H
