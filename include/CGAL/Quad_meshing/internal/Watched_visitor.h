// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_WATCHED_VISITOR_H
#define CGAL_QUAD_MESHING_INTERNAL_WATCHED_VISITOR_H

#include <CGAL/Quad_meshing/internal/Any_visitor.h>

#include <chrono>
#include <limits>
#include <string>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A visitor with a clock. It remembers that the user has asked for an end, ends the work when its time is up, and lets
// the progress move on a little, wherever it is asked whether to go further, when it has rested for some time.
class Watched_visitor : public Any_visitor
{
  typedef std::chrono::steady_clock Clock;

public:
  // Seconds after which the progress moves by itself, and the part of what is left that it moves by.
  static constexpr double longest_rest = 0.05, part_of_rest = 0.005;

  // `maximum_running_time` is in seconds from now on.
  explicit Watched_visitor(Any_visitor& visitor, double maximum_running_time = std::numeric_limits<double>::infinity())
    : m_visitor(visitor), m_maximum_running_time(maximum_running_time), m_start(Clock::now()), m_last_progress(m_start)
  {
  }

  void on_stage_begin(const std::string& name) override
  {
    m_completed = 0;
    m_last_progress = Clock::now();
    m_visitor.on_stage_begin(name);
  }

  void on_stage_end(const std::string& name) override { m_visitor.on_stage_end(name); }

  // It never goes back; what has moved by itself waits for the work to catch up.
  void progress(double completed) override
  {
    if(!(completed > m_completed))
      return;
    m_completed = completed;
    m_last_progress = Clock::now();
    m_visitor.progress(m_completed);
  }

  bool go_further() override
  {
    if(m_is_stopped || m_is_time_up)
      return false;
    const Clock::time_point now = Clock::now();
    m_is_time_up = seconds(m_start, now) >= m_maximum_running_time;
    m_is_stopped = !m_visitor.go_further();
    if(seconds(m_last_progress, now) > longest_rest)
      progress(m_completed + part_of_rest * (1 - m_completed));
    return !m_is_stopped && !m_is_time_up;
  }

  // Whether the user has asked for an end, and whether the time is up.
  bool is_stopped() const { return m_is_stopped; }
  bool is_time_up() const { return m_is_time_up; }

private:
  static double seconds(Clock::time_point from, Clock::time_point to)
  {
    return std::chrono::duration<double>(to - from).count();
  }

  Any_visitor& m_visitor;
  const double m_maximum_running_time;
  const Clock::time_point m_start;
  Clock::time_point m_last_progress;
  double m_completed = 0;
  bool m_is_stopped = false, m_is_time_up = false;
};

// A visitor for a part of some work: its stages and its progress are not those of the whole.
class Silent_visitor : public Any_visitor
{
public:
  explicit Silent_visitor(Any_visitor& visitor) : m_visitor(visitor) {}

  bool go_further() override { return m_visitor.go_further(); }

private:
  Any_visitor& m_visitor;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_WATCHED_VISITOR_H
