// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_JUNCTION_TRACES_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_JUNCTION_TRACES_H

#include <CGAL/Quad_meshing/Pipeline/internal/Junctions.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A step of a chain of quad edges along a curve: a halfedge, and the lengths along the curve at its ends.
struct Trace_step
{
  int halfedge;
  bool is_forward; // along the curve
  double from, to; // from < to; on a closed curve `to` may exceed its length
};

typedef std::vector<Trace_step> Junction_trace;

// The chains of quad edges, features and borders, that run along a curve from end to end, one for each time that the
// surface passes it.
class Junction_tracer
{
  typedef Quadrangulation_kernel::Point_3 Point_3;
  typedef Quadrangulation_kernel::Segment_3 Segment_3;

  const Indexed_quad_mesh& m_quads;
  const double m_tolerance; // distance of vertices from the curve that they lie on

public:
  Junction_tracer(const Indexed_quad_mesh& quads, double tolerance) : m_quads(quads), m_tolerance(tolerance) {}

  std::vector<Junction_trace> operator()(const Junction_curve& curve) const
  {
    std::vector<Trace_step> steps;
    for(int h = 0; h < m_quads.number_of_halfedges(); ++h)
      if(m_quads.edge(h) == h && (m_quads.is_feature[h] || m_quads.is_border(h)))
        add_step(curve, h, steps);
    std::sort(steps.begin(), steps.end(),
              [](const Trace_step& a, const Trace_step& b)
              { return std::make_pair(a.from, a.halfedge) < std::make_pair(b.from, b.halfedge); });
    std::vector<Junction_trace> traces;
    std::vector<char> is_used(steps.size(), 0);
    for(std::size_t i = 0; i < steps.size(); ++i)
      if(!is_used[i] && (curve.is_closed || steps[i].from <= m_tolerance))
      {
        const Junction_trace trace = follow(curve, steps, i, is_used);
        if(!trace.empty())
          traces.push_back(trace);
      }
    return traces;
  }

  int source(const Trace_step& s) const
  {
    return s.is_forward ? m_quads.source(s.halfedge) : m_quads.target(s.halfedge);
  }
  int target(const Trace_step& s) const
  {
    return s.is_forward ? m_quads.target(s.halfedge) : m_quads.source(s.halfedge);
  }

private:
  static Point_3 point(const Indexed_quad_mesh::Point_3& p) { return Point_3(p.x(), p.y(), p.z()); }

  // The lengths along the curve at which it passes a point. Beside a corner, the segment counts that the point lies on.
  std::vector<double> places(const Junction_curve& curve, const Point_3& p) const
  {
    const double equally_near = 0.01 * m_tolerance;
    std::vector<std::pair<double, double>> found; // distance, length along the curve
    double nearest = m_tolerance;
    for(std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    {
      const Point_3 &a = curve.points[i], &b = curve.points[i + 1];
      const double distance = std::sqrt(squared_distance(Segment_3(a, b), p));
      if(distance > m_tolerance)
        continue;
      nearest = (std::min)(nearest, distance);
      const double along = (p - a) * (b - a) / ((b - a) * (b - a));
      found.emplace_back(
        distance, curve.lengths[i] + (std::min)(1., (std::max)(0., along)) * (curve.lengths[i + 1] - curve.lengths[i]));
    }
    std::vector<double> result;
    for(const auto& f : found)
      if(f.first <= nearest + equally_near)
        result.push_back(f.second);
    return result;
  }

  // An edge belongs to the curve if its ends lie on it, about as far from each other along the curve as through space:
  // a chord of the curve, but not one that leaves out most of it.
  void add_step(const Junction_curve& curve, int h, std::vector<Trace_step>& steps) const
  {
    const double longest_way = 1.6; // over the chord: half a circle
    const Point_3 p = point(m_quads.points[m_quads.source(h)]), q = point(m_quads.points[m_quads.target(h)]);
    const double chord = std::sqrt(squared_distance(p, q));
    const std::vector<double> from = places(curve, p), to = places(curve, q);
    Trace_step best = { h, true, 0, 0 };
    double shortest = longest_way * chord + m_tolerance;
    for(double s : from)
      for(double t : to)
        for(const double turn : { 0., curve.length() })
        {
          if(turn > 0 && !curve.is_closed)
            continue;
          const double low = (std::min)(s, t), high = (std::max)(s, t);
          const double way = turn > 0 ? low + turn - high : high - low;
          if(!(way < shortest) || !(way > 0))
            continue;
          shortest = way;
          best = turn > 0 ? Trace_step{ h, high == s, high, low + turn } : Trace_step{ h, low == s, low, high };
        }
    if(best.to > best.from)
      steps.push_back(best);
  }

  // Goes on from vertex to vertex, to the end of the curve or once around. Marks the steps that it takes if it gets
  // there.
  Junction_trace follow(const Junction_curve& curve, const std::vector<Trace_step>& steps, std::size_t i,
                        std::vector<char>& is_used) const
  {
    const double end = curve.is_closed ? steps[i].from + curve.length() : curve.length();
    const int first = source(steps[i]);
    std::vector<std::size_t> taken(1, i);
    std::vector<char> is_taken = is_used;
    is_taken[i] = 1;
    double s = steps[i].to;
    while(s < end - 2 * m_tolerance)
    {
      const int v = target(steps[taken.back()]);
      std::size_t next = steps.size();
      double gap = 0; // by rounding
      for(std::size_t j = 0; j < steps.size() && next == steps.size(); ++j)
      {
        gap = std::remainder(steps[j].from - s, curve.is_closed ? curve.length() : 4 * end);
        if(!is_taken[j] && source(steps[j]) == v && std::abs(gap) <= 2 * m_tolerance)
          next = j;
      }
      if(next == steps.size())
        return Junction_trace();
      taken.push_back(next);
      is_taken[next] = 1;
      s += gap + steps[next].to - steps[next].from;
    }
    if(curve.is_closed && target(steps[taken.back()]) != first)
      return Junction_trace();
    is_used = is_taken;
    Junction_trace trace;
    for(std::size_t k : taken)
      trace.push_back(steps[k]);
    return trace;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_JUNCTION_TRACES_H
