// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PIPELINE_VISITOR_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PIPELINE_VISITOR_H

#include <CGAL/Quad_meshing/internal/Any_visitor.h>

#include <chrono>
#include <mutex>
#include <string>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A visitor with a time limit, that several threads may talk to. It knows who asked for the end.
class Pipeline_visitor : public Any_visitor
{
  typedef std::chrono::steady_clock Clock;

public:
  Pipeline_visitor(Any_visitor& visitor, double seconds) : m_visitor(visitor), m_start(Clock::now()), m_seconds(seconds)
  {
  }

  void on_stage_begin(const std::string& name) override
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_visitor.on_stage_begin(name);
  }

  void on_stage_end(const std::string& name) override
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_visitor.on_stage_end(name);
  }

  void progress(double completed) override
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_visitor.progress(completed);
  }

  bool go_further() override
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_is_stopped = m_is_stopped || !m_visitor.go_further();
    return !m_is_stopped && !(m_is_limited && is_time_up());
  }

  // Whether the visitor asked for the end; it is not asked again then.
  bool is_stopped() const { return m_is_stopped; }

  bool is_time_up() const { return std::chrono::duration<double>(Clock::now() - m_start).count() > m_seconds; }

  // What has to be done to deliver a result is done after the time is up, too.
  void lift_time_limit() { m_is_limited = false; }

private:
  Any_visitor& m_visitor;
  const Clock::time_point m_start;
  const double m_seconds;
  std::mutex m_mutex;
  bool m_is_stopped = false, m_is_limited = true;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PIPELINE_VISITOR_H
