// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SEARCH_LIMITS_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SEARCH_LIMITS_H

#include <CGAL/Quad_meshing/internal/Any_visitor.h>

#include <algorithm>
#include <chrono>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Asks the visitor and the clock whether a search may go on. It can be asked in inner loops: it looks at the clock
// only, unless some time has passed. Once it says no it stays with it.
class Search_limits
{
public:
  Search_limits(Any_visitor& visitor, double maximum_running_time)
    : m_visitor(visitor), m_maximum_seconds(maximum_running_time), m_begin(std::chrono::steady_clock::now())
  {
  }

  bool go_further()
  {
    const double interval = 0.02; // seconds
    if(m_is_stopped || m_is_out_of_time)
      return false;
    const double now = seconds();
    m_is_out_of_time = now >= m_maximum_seconds;
    if(now >= m_next_question)
    {
      m_next_question = now + interval;
      m_visitor.progress(completed(now));
      m_is_stopped = !m_visitor.go_further();
    }
    return !m_is_stopped && !m_is_out_of_time;
  }

  // Tells which part of the work is done, where that is known.
  void set_completed(double part) { m_completed = (std::max)(m_completed, part); }

  bool is_stopped() const { return m_is_stopped; } // by the visitor
  bool is_out_of_time() const { return m_is_out_of_time; }

  double seconds_left() const { return (std::max)(0., m_maximum_seconds - seconds()); }

  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count(); }

private:
  // Nobody knows how long a search takes: the part of so many seconds that have passed, on a scale without an end.
  double completed(double now)
  {
    const double half_time = 10.;
    m_completed = (std::max)(m_completed, now / (now + half_time));
    return m_completed;
  }

  Any_visitor& m_visitor;
  const double m_maximum_seconds;
  const std::chrono::steady_clock::time_point m_begin;
  double m_next_question = 0.;
  double m_completed = 0.;
  bool m_is_stopped = false, m_is_out_of_time = false;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SEARCH_LIMITS_H
