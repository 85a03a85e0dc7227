// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_JUMP_ANNEALING_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_JUMP_ANNEALING_H

#include <CGAL/Quad_meshing/Fields/internal/Dual_laplacian.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Fields/internal/Sector_potentials.h>
#include <CGAL/Quad_meshing/Fields/internal/Sector_quads.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Simulated annealing of the period jumps of small meshes, which ends in one of the lowest minima.
//
// From the potentials of the sectors the gain of every change of a jump is known after a few operations, and a change
// that is made costs two additions of vectors. So the temperature may fall again and again from where singularities
// only just move freely; what ends lower than everything before is where the next fall starts. No sector is ever
// emptied.
class Jump_annealing
{
public:
  Jump_annealing(const Field_problem& problem, const Dual_laplacian& laplacian)
    : m_problem(problem), m_laplacian(laplacian), m_potentials(problem, laplacian)
  {
  }

  // Whether the mesh is small enough.
  bool is_affordable() const { return m_potentials.is_small(); }

  // The angles of the field are the best ones for its jumps, and so they are again at the end. Returns false
  // if something could not be factorized; the field is then as before.
  bool operator()(Cross_field& field, Sector_quads& quads, Stage_progress& progress)
  {
    // Later ones hardly ever gain. On small meshes they take about as long as all the rest; on larger ones, where the
    // time of each grows with the square of the size, fewer are worth it.
    const int fewest = 6, rows_per_fall = 16, most_rows_times_falls = 16000;
    const int rows = m_potentials.number_of_rows();
    const int falls = (std::max)(fewest, (std::min)(rows / rows_per_fall, most_rows_times_falls / (rows + 1)));

    if(!m_potentials.compute())
      return false;
    begin(field, quads);
    for(int fall = 0; fall <= falls && progress.go_further(); ++fall)
    {
      m_now = m_best;
      if(fall > 0) // first the minimum next to the start
        cool_down(progress);
      descend();
      m_now.energy = energy();
      if(m_now.energy < m_best.energy - smallest_gain)
        m_best = m_now;
    }
    for(int i = 0; i < m_potentials.number_of_edges(); ++i)
      if(m_best.change[i] != 0)
      {
        const int e = m_potentials.edge(i).edge;
        field.period_jump[e] += m_best.change[i];
        quads.change_jump(e, m_best.change[i]);
      }
    m_laplacian.solve_angles(field);
    return true;
  }

private:
  struct State
  {
    Sector_potentials::State potentials;
    std::vector<int> change; // per edge of the potentials, of its jump
    std::vector<int> quads;  // per row of the potentials
    double energy = 0;
  };

  struct Edge
  {
    float offset; // the residual at the start
    float limit;  // of residuals, from where a change of the jump gains
  };

  static constexpr double smallest_gain = 1e-4;

  void begin(const Cross_field& field, const Sector_quads& quads)
  {
    // The P_ee of an edge on whose jump nothing depends, as it is in no cycle of faces, is zero up to rounding.
    const float no_effect = 1e-3f;

    const int m = m_potentials.number_of_edges();
    m_best.potentials = m_potentials.make_state();
    m_best.change.assign(m, 0);
    m_best.quads.assign(m_potentials.number_of_rows() + 1, 0);
    for(int s = 0; s < m_problem.sectors.number_of_sectors(); ++s)
      m_best.quads[m_potentials.row(s)] = quads.state()[s];
    m_best.quads.back() = (std::numeric_limits<int>::max)() / 2; // where a border is free
    m_edges.resize(m);
    for(int i = 0; i < m; ++i)
    {
      const Sector_potentials::Edge& e = m_potentials.edge(i);
      m_edges[i].offset = static_cast<float>(m_problem.residual(e.edge, field));
      m_edges[i].limit =
        e.self > no_effect ? static_cast<float>(quarter_turn / 2) * e.self : (std::numeric_limits<float>::max)();
    }
    m_now = m_best;
    m_best.energy = energy();

    for(std::size_t k = 0; k < m_deviates.size(); ++k)
      m_deviates[k] = -std::log((k + 0.5f) / m_deviates.size());
  }

  float residual(int i) const { return m_edges[i].offset + m_potentials.difference(i, m_now.potentials); }

  // Of the movable edges; that of the others does not change.
  double energy() const
  {
    double sum = 0;
    for(int i = 0; i < m_potentials.number_of_edges(); ++i)
      sum += residual(i) * residual(i);
    return sum;
  }

  // The energy decreases by this times the distance of a residual from the limit, if the jump takes one step to bring
  // the residual down.
  static constexpr float gain_of_excess = static_cast<float>(2 * quarter_turn);

  // Metropolis sweeps over all movable edges at falling temperatures.
  void cool_down(Stage_progress& progress)
  {
    const int sweeps = 25;
    // In units of the energy. A singularity costs about one half.
    const float hottest = 0.08f, coldest = 0.01f;

    const float factor = std::pow(coldest / hottest, 1.f / sweeps);
    float temperature = hottest;
    for(int sweep = 0; sweep < sweeps && progress.go_further(); ++sweep, temperature *= factor)
    {
      const float unit = temperature / gain_of_excess, hopeless = -unit * m_deviates[0];
      for(int i = 0; i < m_potentials.number_of_edges(); ++i)
      {
        const float r = residual(i), excess = std::abs(r) - m_edges[i].limit;
        if(excess > hopeless && (excess > 0 || -excess < unit * m_deviates[m_random() % m_deviates.size()]))
          change(i, r > 0 ? -1 : 1);
      }
    }
  }

  void descend()
  {
    const float least = static_cast<float>(smallest_gain) / gain_of_excess;
    const int maximum_passes = 1000; // against circles due to rounding; a handful is usual
    bool has_changed = true;
    for(int pass = 0; has_changed && pass < maximum_passes; ++pass)
    {
      has_changed = false;
      for(int i = 0; i < m_potentials.number_of_edges(); ++i)
      {
        const float r = residual(i);
        if(std::abs(r) - m_edges[i].limit > least && change(i, r > 0 ? -1 : 1))
          has_changed = true;
      }
    }
  }

  // Changes a jump, unless that would empty a sector.
  bool change(int i, int by)
  {
    const Sector_potentials::Edge& e = m_potentials.edge(i);
    if(m_now.quads[by > 0 ? e.giver : e.taker] < 2)
      return false;
    m_now.quads[e.giver] -= by;
    m_now.quads[e.taker] += by;
    m_now.change[i] += by;
    m_potentials.add_column(i, static_cast<float>(by * quarter_turn), m_now.potentials);
    return true;
  }

  const Field_problem& m_problem;
  const Dual_laplacian& m_laplacian;
  Sector_potentials m_potentials;
  State m_now, m_best;
  std::vector<Edge> m_edges;         // those of the potentials
  std::array<float, 256> m_deviates; // of the exponential distribution, descending
  std::mt19937 m_random;             // of the same numbers everywhere
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_JUMP_ANNEALING_H
