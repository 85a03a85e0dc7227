// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// What the tests of all stages share: visitors that count and stop, and meshes in which two border loops touch.

#ifndef STAGE_CHECKS_H
#define STAGE_CHECKS_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <cassert>
#include <limits>
#include <string>
#include <vector>

namespace stage_checks {

// The progress of a stage that nobody looks at.
struct Silent_progress
{
  CGAL::Quad_meshing::internal::Any_visitor visitor;
  CGAL::Quad_meshing::internal::Stage_progress progress{ visitor };
};

// Says stop at the n-th question, checks that stages are nested and that the progress of each never decreases, and that
// nobody asks again after a stop.
struct Counting_visitor : CGAL::Quad_meshing::Default_visitor
{
  int asked = 0, stop_at;
  int begun = 0;
  std::vector<double> progress_of_stage;

  explicit Counting_visitor(int n = (std::numeric_limits<int>::max)()) : stop_at(n) {}

  void on_stage_begin(const std::string& name)
  {
    assert(!name.empty());
    ++begun;
    progress_of_stage.push_back(0);
  }
  void on_stage_end(const std::string&)
  {
    assert(!progress_of_stage.empty());
    progress_of_stage.pop_back();
  }
  void progress(double p)
  {
    assert(p >= progress_of_stage.back() && p <= 1);
    progress_of_stage.back() = p;
  }
  bool go_further()
  {
    assert(asked < stop_at);
    return ++asked < stop_at;
  }
  bool is_finished() const { return begun > 0 && progress_of_stage.empty(); }
};

// Calls run(visitor) without a stop, and then with stops at several places, where it must return false. How often long
// work asks depends on the clock: a stop that comes later than the last question has no effect, but the first always
// has.
template <typename Run>
void check_stops(const Run& run)
{
  Counting_visitor all;
  assert(run(all) && all.is_finished() && all.asked > 1);
  for(int n = 1; n <= all.asked; n += 1 + all.asked / 20)
  {
    Counting_visitor visitor(n);
    const bool is_done = run(visitor);
    assert(is_done == (visitor.asked < n) && (n > 1 || !is_done));
    assert(visitor.is_finished());
  }
}

// Removes two faces around the first vertex that have no edge in common: two border loops touch there.
template <typename TriangleMesh>
typename boost::graph_traits<TriangleMesh>::vertex_descriptor pinch(TriangleMesh& tm)
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  const auto v = *vertices(tm).begin();
  std::vector<halfedge_descriptor> around;
  for(halfedge_descriptor h : CGAL::halfedges_around_target(v, tm))
    around.push_back(h);
  assert(around.size() >= 4);
  CGAL::Euler::remove_face(around[0], tm);
  CGAL::Euler::remove_face(around[2], tm);
  return v;
}

} // namespace stage_checks

#endif // STAGE_CHECKS_H
