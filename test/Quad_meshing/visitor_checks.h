// A visitor with a stopwatch, for tests that stop a call or watch its progress.

#ifndef VISITOR_CHECKS_H
#define VISITOR_CHECKS_H

#include <CGAL/Quad_meshing/Default_visitor.h>

#include <algorithm>
#include <ctime>
#include <iostream>
#include <string>

namespace visitor_checks {

// Seconds of processor time after which a call must have asked the visitor again, and the progress must have moved.
constexpr double longest_gap = 0.5;

// Says stop after some seconds of processor time, and measures the longest time between two calls of go_further(), and
// between two moves of the progress within a stage.
class Stopwatch_visitor : public CGAL::Quad_meshing::Default_visitor
{
public:
  explicit Stopwatch_visitor(double seconds_until_stop)
    : m_seconds_until_stop(seconds_until_stop), m_start(now()), m_last_question(m_start), m_last_progress(m_start)
  {
  }

  void on_stage_begin(const std::string&)
  {
    m_last_progress = now();
    m_completed = -1;
  }

  void on_stage_end(const std::string&) { rest(); }

  void progress(double completed)
  {
    if(completed > m_completed)
      rest();
    m_is_monotone = m_is_monotone && completed >= m_completed && completed <= 1;
    m_completed = completed;
  }

  bool go_further()
  {
    const double t = now();
    m_longest_gap = (std::max)(m_longest_gap, t - m_last_question);
    m_last_question = t;
    m_has_stopped = m_has_stopped || t - m_start >= m_seconds_until_stop;
    return !m_has_stopped;
  }

  bool has_stopped() const { return m_has_stopped; }
  bool is_monotone() const { return m_is_monotone; }

  // To be asked when the call has ended: what has gone by since the last question counts, too.
  double longest_gap() const { return (std::max)(m_longest_gap, now() - m_last_question); }
  double longest_rest_of_progress() const { return m_longest_rest; }

  void report() const
  {
    std::cout << "    ended after " << now() - m_start << " s, longest gap " << longest_gap() << " s, of the progress "
              << m_longest_rest << " s" << std::endl;
  }

private:
  static double now() { return double(std::clock()) / CLOCKS_PER_SEC; }

  void rest()
  {
    const double t = now();
    m_longest_rest = (std::max)(m_longest_rest, t - m_last_progress);
    m_last_progress = t;
  }

  const double m_seconds_until_stop, m_start;
  double m_last_question, m_last_progress;
  double m_longest_gap = 0, m_longest_rest = 0, m_completed = -1;
  bool m_has_stopped = false, m_is_monotone = true;
};

} // namespace visitor_checks

#endif // VISITOR_CHECKS_H
