// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FRONT_QUEUE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FRONT_QUEUE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The agenda of a front that moves over edges and vertices: a queue of buckets, each for one step of
// the distance. Within a step edges come before vertices, in the order of their arrival.
//
// An edge or vertex that is pushed again for an earlier step leaves a stale entry behind, which is
// skipped; pushing it for a later one does nothing, as it is looked at before.
class Front_queue
{
public:
  Front_queue(std::size_t edges, std::size_t vertices, double step)
    : m_step(step), m_edge_step(edges, none()), m_vertex_step(vertices, none())
  {
  }

  void push_edge(int e, double key) { push(e, key, m_edge_step, &Bucket::edges); }
  void push_vertex(int v, double key) { push(v, key, m_vertex_step, &Bucket::vertices); }

  // Whether an edge is due in this step already.
  bool is_due(int e) const { return m_edge_step[e] <= m_current; }

  // Goes to the next step that has something to do. Returns false if there is none.
  bool advance()
  {
    while(m_current < m_buckets.size())
    {
      if(!step_has_more())
      {
        m_buckets[m_current] = Bucket();
        ++m_current;
        m_edges_done = m_vertices_done = 0;
      }
      else
        return true;
    }
    return false;
  }

  bool step_has_more() const
  {
    return m_edges_done < m_buckets[m_current].edges.size() || m_vertices_done < m_buckets[m_current].vertices.size();
  }

  // Everything still to come lies between these.
  double front() const { return m_current == 0 ? -std::numeric_limits<double>::infinity() : m_current * m_step; }
  double step() const { return m_step; }

  // Whether a key belongs to this step. Rounding has one opinion about that everywhere: a key that does not is due
  // later.
  bool is_now(double key) const { return step_of(key) <= m_current; }

  // A key that belongs to a later step.
  double next_key() const { return (m_current + 1.5) * m_step; }

  // The next edge of this step, or -1.
  int pop_edge() { return pop(m_buckets[m_current].edges, m_edges_done, m_edge_step); }

  // The edge that comes n entries after the next one, or -1. It need not come if it was pushed for an earlier step.
  int edge_ahead(std::size_t n) const
  {
    const std::vector<int>& edges = m_buckets[m_current].edges;
    return m_edges_done + n < edges.size() ? edges[m_edges_done + n] : -1;
  }

  // The next vertex of this step, or -1.
  int pop_vertex() { return pop(m_buckets[m_current].vertices, m_vertices_done, m_vertex_step); }

private:
  struct Bucket
  {
    std::vector<int> edges, vertices;
  };

  static unsigned none() { return (std::numeric_limits<unsigned>::max)(); }

  // What is due later than so many steps is looked at then.
  static double look_ahead() { return 1 << 20; }

  unsigned step_of(double key) const
  {
    const double s = key / m_step, current = static_cast<double>(m_current);
    return static_cast<unsigned>((std::min)((std::max)(s, current), current + look_ahead()));
  }

  void push(int i, double key, std::vector<unsigned>& scheduled, std::vector<int> Bucket::*entries)
  {
    const unsigned s = step_of(key);
    if(scheduled[i] <= s)
      return;
    scheduled[i] = s;
    if(m_buckets.size() <= s)
      m_buckets.resize(s + 1);
    (m_buckets[s].*entries).push_back(i);
  }

  int pop(const std::vector<int>& entries, std::size_t& done, std::vector<unsigned>& scheduled)
  {
    while(done < entries.size())
    {
      const int i = entries[done++];
      if(scheduled[i] == m_current)
      {
        scheduled[i] = none();
        return i;
      }
    }
    return -1;
  }

  double m_step;
  std::size_t m_current = 0;
  std::size_t m_edges_done = 0, m_vertices_done = 0;
  std::vector<Bucket> m_buckets;
  std::vector<unsigned> m_edge_step, m_vertex_step;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FRONT_QUEUE_H
