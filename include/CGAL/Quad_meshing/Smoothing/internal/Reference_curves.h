// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_REFERENCE_CURVES_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_REFERENCE_CURVES_H

#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Polylines along which points slide.
//
// A set of segments falls apart into chains at its corners: where one, three or more segments meet,
// or where two meet at a turn of more than `corner_turn` degrees. A point belongs to one chain and
// moves along it; it stops at the ends.
class Reference_curves
{
public:
  typedef Simple_cartesian<double> Kernel;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;
  typedef Kernel::Segment_3 Segment_3;

  static constexpr double corner_turn = 50;

  struct Location
  {
    int segment;
    Point_3 point;
    bool at_end; // at the end of a chain
  };

  // `points` and `segments` may come from any graph; the order of the segments decides the order
  // of the chains.
  Reference_curves(const std::vector<Point_3>& points, const std::vector<std::array<int, 2>>& segments)
    : m_segments(segments.size())
  {
    std::vector<std::array<int, 2>> at(points.size(), { { -1, -1 } }); // the two segments of a vertex
    std::vector<int> degree(points.size(), 0);
    for(std::size_t s = 0; s < segments.size(); ++s)
      for(int v : segments[s])
      {
        if(degree[v] < 2)
          at[v][degree[v]] = static_cast<int>(s);
        ++degree[v];
      }

    const double cosine = std::cos(corner_turn * CGAL_PI / 180);
    for(std::size_t s = 0; s < segments.size(); ++s)
    {
      m_segments[s].ends = { { points[segments[s][0]], points[segments[s][1]] } };
      for(int k = 0; k < 2; ++k)
      {
        const int v = segments[s][k];
        int& link = m_segments[s].neighbor[k];
        link = -1;
        if(degree[v] != 2)
          continue;
        const int t = at[v][0] == static_cast<int>(s) ? at[v][1] : at[v][0];
        const int w = segments[t][0] == v ? segments[t][1] : segments[t][0];
        const Vector_3 in = points[v] - points[segments[s][1 - k]], out = points[w] - points[v];
        if(in * out >= cosine * std::sqrt(in.squared_length() * out.squared_length()))
          link = t;
      }
    }
  }

  bool empty() const { return m_segments.empty(); }

  Location locate(const Point_3& query)
  {
    if(m_tree == nullptr)
    {
      std::vector<int> all(m_segments.size());
      std::iota(all.begin(), all.end(), 0);
      m_tree.reset(new Tree(all.cbegin(), all.cend(), static_cast<const Reference_curves*>(this)));
      m_tree->build();
    }
    return walk(query, m_tree->closest_point_and_primitive(query).second);
  }

  // The closest point downhill along the chain of a segment.
  Location walk(const Point_3& query, int start) const
  {
    int s = start;
    double t = parameter(query, s), distance = squared_distance(query, at(s, t));
    while(t == 0 || t == 1)
    {
      const int next = m_segments[s].neighbor[t == 1];
      if(next == -1)
        break;
      const double u = parameter(query, next), d = squared_distance(query, at(next, u));
      if(!(d < distance))
        break;
      s = next;
      t = u;
      distance = d;
    }
    return Location{ s, at(s, t), (t == 0 || t == 1) && m_segments[s].neighbor[t == 1] == -1 };
  }

  // Unit direction of a segment.
  Vector_3 direction(int s) const
  {
    const Vector_3 v = m_segments[s].ends[1] - m_segments[s].ends[0];
    const double l = std::sqrt(v.squared_length());
    return l > 0 ? v / l : v;
  }

private:
  struct Chain_segment
  {
    std::array<Point_3, 2> ends;
    std::array<int, 2> neighbor; // the segment behind each end, -1 at the end of the chain
  };

  double parameter(const Point_3& query, int s) const
  {
    const Chain_segment& c = m_segments[s];
    const Vector_3 d = c.ends[1] - c.ends[0];
    const double l = d.squared_length();
    return l > 0 ? (std::min)(1., (std::max)(0., ((query - c.ends[0]) * d) / l)) : 0;
  }

  Point_3 at(int s, double t) const
  {
    const Chain_segment& c = m_segments[s];
    return t == 1 ? c.ends[1] : c.ends[0] + t * (c.ends[1] - c.ends[0]);
  }

  struct Primitive
  {
    typedef int Id;
    typedef Point_3 Point;
    typedef Segment_3 Datum;

    Primitive(std::vector<int>::const_iterator s, const Reference_curves* curves) : segment(*s), curves(curves) {}

    int segment;
    const Reference_curves* curves;

    Id id() const { return segment; }
    Datum datum() const { return Segment_3(curves->m_segments[segment].ends[0], curves->m_segments[segment].ends[1]); }
    Point reference_point() const { return curves->m_segments[segment].ends[0]; }
  };
  typedef AABB_tree<Aabb_traits<Kernel, Primitive>> Tree;

  std::vector<Chain_segment> m_segments;
  std::unique_ptr<Tree> m_tree; // built at the first call of locate()

public:
  // The tree points back to this object.
  Reference_curves(const Reference_curves&) = delete;
  Reference_curves& operator=(const Reference_curves&) = delete;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_REFERENCE_CURVES_H
