// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_STAGE_PROGRESS_H
#define CGAL_QUAD_MESHING_INTERNAL_STAGE_PROGRESS_H

#include <CGAL/Quad_meshing/internal/Any_visitor.h>

#include <string>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Reports the progress of a stage whose parts take a number of steps that is not known beforehand, and asks the visitor
// after each step whether to go on. Once it said no, no more is asked and reported.
class Stage_progress
{
public:
  explicit Stage_progress(Any_visitor& visitor) : m_visitor(visitor) {}

  Stage_progress(const Stage_progress&) = delete;
  Stage_progress& operator=(const Stage_progress&) = delete;

  // For another stage of the same work.
  void restart()
  {
    m_now = m_begin = m_steps = 0;
    m_end = 1;
    m_is_stopped = false;
  }

  // The steps from here on bring the progress from where it is towards `end`, without ever reaching it.
  void begin_part(double end)
  {
    m_begin = m_now;
    m_end = end;
    m_steps = 0;
  }

  // To be called after every step, that is some times in half a second. Returns whether to go on.
  bool go_further()
  {
    const double half_way = 50; // steps
    ++m_steps;
    m_now = m_end - (m_end - m_begin) * half_way / (half_way + m_steps);
    return report();
  }

  // The progress is a known one. Returns whether to go on.
  bool go_further(double completed)
  {
    if(completed > m_now)
      m_now = completed;
    return report();
  }

  // Whether the visitor has said no.
  bool is_stopped() const { return m_is_stopped; }

  // What a function called by a step has found out.
  void stop() { m_is_stopped = true; }

  Any_visitor& visitor() { return m_visitor; }

private:
  Any_visitor& m_visitor;
  double m_now = 0, m_begin = 0, m_end = 1, m_steps = 0;
  bool m_is_stopped = false;

  bool report()
  {
    if(m_is_stopped)
      return false;
    m_visitor.progress(m_now);
    m_is_stopped = !m_visitor.go_further();
    return !m_is_stopped;
  }
};

// Steps so small that only every so many of them are worth a report.
class Small_steps
{
public:
  Small_steps(Stage_progress& progress, int steps_per_report)
    : m_progress(progress), m_steps_per_report(steps_per_report), m_left(steps_per_report)
  {
  }

  bool go_further()
  {
    if(--m_left > 0)
      return !m_progress.is_stopped();
    m_left = m_steps_per_report;
    return m_progress.go_further();
  }

private:
  Stage_progress& m_progress;
  const int m_steps_per_report;
  int m_left;
};

// A visitor of a function that is one step of a stage: whatever it reports moves the progress of the stage.
class Step_visitor
{
public:
  explicit Step_visitor(Stage_progress& progress) : m_progress(progress) {}

  void on_stage_begin(const std::string& /* name */) {}
  void on_stage_end(const std::string& /* name */) {}
  void progress(double /* completed */) {}
  bool go_further() { return m_progress.go_further(); }

private:
  Stage_progress& m_progress;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_STAGE_PROGRESS_H
