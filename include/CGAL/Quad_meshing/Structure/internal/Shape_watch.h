// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_SHAPE_WATCH_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_SHAPE_WATCH_H

#include <CGAL/Quad_meshing/Structure/internal/Accepted_shape.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_optimizer.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>

#include <cstddef>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Smooths a mesh between the operators of a `Structure_optimizer`, which keeps its positions apart, and remembers the
// last mesh whose shape was accepted. `smooth(state, sweeps)` smooths and returns what has been done.
template <typename Smooth>
class Shape_watch
{
public:
  // Sweeps of a smoothing between operators, and how many of these there are before they get rarer, by a factor: the
  // cost must not grow with the number of operators.
  static constexpr unsigned int sweeps_between = 3;
  static constexpr int looks_per_gap = 12, gap_factor = 4;

  Shape_watch(Structure_optimizer& optimizer, const Accepted_shape& accepted, const Smooth& smooth, unsigned int sweeps)
    : m_optimizer(optimizer)
    , m_accepted(accepted)
    , m_smooth(smooth)
    , m_sweeps(sweeps)
    , m_good(optimizer.state)
    , m_operators_of_good(optimizer.operators)
  {
  }

  // To be called after each change of the mesh: false if it is time to look at the shape, and it is not accepted.
  bool accepts_next()
  {
    ++m_changes;
    return ++m_changes_since_look < m_gap || accepts();
  }

  // Whether the shape of the mesh as it is now is accepted.
  bool accepts()
  {
    if(m_changes == 0)
      return true;
    m_changes_since_look = 0;
    if(++m_looks % looks_per_gap == 0)
      m_gap *= gap_factor;
    if(!m_accepted.accepts(m_smooth(m_optimizer.state, sweeps_between)) &&
       !m_accepted.accepts(m_smooth(m_optimizer.state, m_sweeps)))
      return false;
    m_good = m_optimizer.state;
    m_operators_of_good = m_optimizer.operators;
    m_changes = 0;
    return true;
  }

  // Goes back to the last mesh that was accepted. If one change has spoiled it, this has failed; else the next ones
  // are looked at one by one.
  void undo()
  {
    if(m_changes == 1)
      m_good.has_failed = m_optimizer.has_failed_if_undone;
    m_optimizer.set_state(m_good);
    m_optimizer.operators = m_operators_of_good;
    m_changes = m_changes_since_look = m_looks = 0;
    m_gap = 1;
  }

private:
  Structure_optimizer& m_optimizer;
  const Accepted_shape& m_accepted;
  const Smooth& m_smooth;
  unsigned int m_sweeps;
  Structure_state m_good;
  std::size_t m_operators_of_good;
  int m_changes = 0, m_changes_since_look = 0, m_looks = 0, m_gap = 1;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_SHAPE_WATCH_H
