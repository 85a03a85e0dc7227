// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_DISTANCE_FRONT_H
#define CGAL_QUAD_MESHING_INTERNAL_DISTANCE_FRONT_H

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The front of a search for shortest paths by Dijkstra's algorithm, among things numbered from 0. Of things at the same
// distance the one with the smaller number comes first, so that paths do not depend on the order in which things are
// reached.
//
//   front.reach(start, 0);
//   for(double d; front.pop(i, d);)
//     for(neighbors j of i) front.reach(j, d + length);
class Distance_front
{
public:
  explicit Distance_front(int number_of_things)
    : m_distance(number_of_things, (std::numeric_limits<double>::infinity)())
  {
  }

  // Offers a path of length d to i. Returns whether it is shorter than all before.
  bool reach(int i, double d)
  {
    if(!(d < m_distance[i]))
      return false;
    if(!is_reached(i))
      m_reached.push_back(i);
    m_distance[i] = d;
    m_queue.push(Entry(d, i));
    return true;
  }

  // The nearest thing that was not given before at this distance; false if there is none.
  bool pop(int& i, double& d)
  {
    while(!m_queue.empty())
    {
      d = m_queue.top().first;
      i = m_queue.top().second;
      m_queue.pop();
      if(d <= m_distance[i])
        return true;
    }
    return false;
  }

  // Infinite for what is not reached.
  double distance(int i) const { return m_distance[i]; }
  bool is_reached(int i) const { return m_distance[i] < (std::numeric_limits<double>::infinity)(); }
  const std::vector<double>& distances() const { return m_distance; }

  // Makes the front ready for another search, in time proportional to what was reached.
  void clear()
  {
    for(int i : m_reached)
      m_distance[i] = (std::numeric_limits<double>::infinity)();
    m_reached.clear();
    m_queue = Queue();
  }

private:
  typedef std::pair<double, int> Entry;
  typedef std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Queue;

  std::vector<double> m_distance;
  std::vector<int> m_reached;
  Queue m_queue;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_DISTANCE_FRONT_H
