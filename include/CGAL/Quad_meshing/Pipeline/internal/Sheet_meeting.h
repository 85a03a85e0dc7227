// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SHEET_MEETING_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SHEET_MEETING_H

#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Junction_traces.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Split_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Dual_lines.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Makes the quads of sheets meet vertex to vertex along the curves where the sheets touch.
//
// Each sheet has its own number of quad edges along a curve. Splitting a dual line gives every curve that the line
// crosses more edges. So the numbers are made equal by a problem in integers: how
// often each dual line is split, with as few new quads as possible. Lines that cross the same curves in the same way
// are one variable. Then the vertices along a curve are put to the mean of their places on all sheets.
class Sheet_meeting
{
  typedef Quadrangulation_kernel::Point_3 Point_3;

  // The traces of all sheets along a part of a curve, between places at which all of them have a vertex.
  struct Part
  {
    const Junction_curve* curve;
    std::vector<Junction_trace> traces;
    double begin, end; // lengths along the curve; on a closed curve the end may exceed its length
    bool has_ends;     // whether it begins and ends at a corner or node of the curve
  };

public:
  std::size_t unmet_curves = 0;
  std::size_t split_lines = 0;
  std::unique_ptr<Split_quad_mesh> quads; // the result; null if there are no curves that sheets can meet along
  std::vector<char> is_on_curve;          // per vertex of the result

  // `tolerance`: distance of vertices from the curves that they lie on.
  Sheet_meeting(const Indexed_quad_mesh& from, const std::vector<Junction_curve>& curves, double tolerance)
    : m_from(from), m_tracer(from, tolerance), m_tolerance(tolerance)
  {
    for(const Junction_curve& c : curves)
      find_parts(c);
    if(m_parts.empty())
      return;
    m_splits.assign(static_cast<std::size_t>(from.number_of_halfedges()), 1);
    if(!choose_splits())
    {
      // what has the same number of edges everywhere still meets
      unmet_curves += discard_uneven_parts();
      m_splits.assign(m_splits.size(), 1);
    }
    quads = std::make_unique<Split_quad_mesh>(from, m_splits);
    is_on_curve.assign(quads->mesh.points.size(), 0);
    for(const Part& p : m_parts)
      place_vertices(p);
  }

private:
  void find_parts(const Junction_curve& curve)
  {
    std::vector<Junction_trace> traces = m_tracer(curve);
    if(traces.size() < curve.sheets)
    {
      ++unmet_curves;
      return;
    }
    // corners of the curve that are vertices of all traces
    std::vector<double> breaks;
    for(std::size_t i = 0; i + 1 < curve.points.size(); ++i)
      if(std::all_of(traces.begin(), traces.end(),
                     [&](const Junction_trace& t) { return step_at(curve, t, curve.lengths[i]) != t.size(); }) &&
         (i > 0 ? is_corner(curve, i) : !curve.is_closed || is_corner(curve, i)))
        breaks.push_back(curve.lengths[i]);
    if(breaks.empty())
    {
      start_side_by_side(curve, traces);
      const double begin = traces[0].front().from;
      m_parts.push_back({ &curve, traces, begin, begin + curve.length(), false });
      return;
    }
    if(curve.is_closed)
      for(Junction_trace& t : traces)
        rotate(curve, t, step_at(curve, t, breaks.front()), breaks.front());
    breaks.push_back(curve.is_closed ? breaks.front() + curve.length() : curve.length());
    for(std::size_t b = 0; b + 1 < breaks.size(); ++b)
    {
      Part part = { &curve, {}, breaks[b], breaks[b + 1], true };
      for(const Junction_trace& t : traces)
      {
        const std::size_t first = b == 0 ? 0 : step_at(curve, t, breaks[b]);
        const std::size_t last = b + 2 == breaks.size() ? t.size() : step_at(curve, t, breaks[b + 1]);
        part.traces.emplace_back(t.begin() + first, t.begin() + last);
      }
      m_parts.push_back(part);
    }
  }

  static bool is_corner(const Junction_curve& c, std::size_t i)
  {
    const double largest_turn = 15; // degrees, as that of a node of a curve of the user
    const Point_3 &p = c.points[i], &before = c.points[i > 0 ? i - 1 : c.points.size() - 2], &after = c.points[i + 1];
    if(!c.is_closed && i == 0)
      return true;
    const double cosine =
      (p - before) * (after - p) / std::sqrt(squared_distance(p, before) * squared_distance(p, after));
    return cosine < std::cos(largest_turn * CGAL_PI / 180);
  }

  // The number of the step of a trace that begins at a length along the curve, or the number of steps.
  std::size_t step_at(const Junction_curve& curve, const Junction_trace& t, double s) const
  {
    const double period = curve.is_closed ? curve.length() : 4 * curve.length();
    for(std::size_t i = 0; i < t.size(); ++i)
      if(std::abs(std::remainder(t[i].from - s, period)) <= 2 * m_tolerance)
        return i;
    return t.size();
  }

  // Begins a closed trace with another step, at a length along the curve that is nearest to `near`, in some turn.
  static void rotate(const Junction_curve& curve, Junction_trace& t, std::size_t first, double near)
  {
    std::rotate(t.begin(), t.begin() + first, t.end());
    double s = near + std::remainder(t.front().from - near, curve.length());
    for(Trace_step& step : t)
    {
      const double length = step.to - step.from;
      step.from = s;
      s += length;
      step.to = s;
    }
  }

  // Closed traces without a common vertex begin where they are nearest to the beginning of the first one.
  static void start_side_by_side(const Junction_curve& curve, std::vector<Junction_trace>& traces)
  {
    if(!curve.is_closed)
      return;
    const double begin = traces[0].front().from;
    for(Junction_trace& t : traces)
    {
      const auto gap = [&](const Trace_step& s) { return std::abs(std::remainder(s.from - begin, curve.length())); };
      const auto best =
        std::min_element(t.begin(), t.end(), [&](const Trace_step& a, const Trace_step& b) { return gap(a) < gap(b); });
      rotate(curve, t, static_cast<std::size_t>(best - t.begin()), begin);
    }
  }

  // Lines that cross the same traces equally often.
  struct Line_group
  {
    std::vector<int> lines;
    double length = 0; // of all of them, in quads
  };
  typedef std::vector<std::pair<std::size_t, int>> Crossings; // numbers of traces, and how often these are crossed

  bool choose_splits()
  {
    const Dual_lines dual(m_from);
    const auto line = [&](int h) { return (std::min)(dual.line[h], dual.reverse[dual.line[h]]); };
    std::map<int, std::map<std::size_t, int>> crossings; // per line, how often it crosses each trace
    std::size_t number = 0;
    for(const Part& p : m_parts)
      for(const Junction_trace& t : p.traces)
      {
        for(const Trace_step& s : t)
          ++crossings[line(s.halfedge)][number];
        ++number;
      }
    std::map<Crossings, Line_group> groups;
    for(const auto& c : crossings)
    {
      Line_group& g = groups[Crossings(c.second.begin(), c.second.end())];
      g.lines.push_back(c.first);
      g.length += dual.length[c.first];
    }
    Mixed_integer_problem problem;
    std::vector<Mixed_integer_problem::Linear_form> crossed(number);
    for(const auto& g : groups)
    {
      const int x = problem.add_variable(true);
      problem.set_bounds(x, 0, largest_split * static_cast<double>(g.second.lines.size()));
      // The new quads, and as many for each line that is split once more than others of its group.
      const double lines = static_cast<double>(g.second.lines.size()), length = g.second.length / lines;
      problem.add_squared_residual({ { x, 1. } }, -lines / 2, length / lines);
      for(const auto& c : g.first)
        crossed[c.first].emplace_back(x, c.second);
    }
    bool is_even = true;
    number = 0;
    for(const Part& p : m_parts)
    {
      for(std::size_t t = 1; t < p.traces.size(); ++t)
      {
        Mixed_integer_problem::Linear_form form = crossed[number + t];
        for(const auto& c : crossed[number])
          form.emplace_back(c.first, -c.second);
        const double missing = static_cast<double>(p.traces[0].size()) - static_cast<double>(p.traces[t].size());
        is_even = is_even && missing == 0;
        problem.add_equality_constraint(form, missing);
      }
      number += p.traces.size();
    }
    if(is_even)
      return true;
    const Mixed_integer_solution solution = solve_mixed_integer(
      problem,
      parameters::rounding_method(Rounding_method::BRANCH_AND_BOUND).maximum_number_of_nodes(most_subproblems));
    if(solution.status != Mixed_integer_status::OPTIMAL && solution.status != Mixed_integer_status::FEASIBLE)
      return false;
    std::vector<int> parts(static_cast<std::size_t>(dual.number_of_lines()), 1);
    int x = 0;
    for(const auto& g : groups)
      distribute(static_cast<std::size_t>(std::lround(solution.x[x++])), g.second, parts);
    for(int h = 0; h < m_from.number_of_halfedges(); ++h)
      m_splits[h] = parts[line(h)];
    return true;
  }

  // Splits lines of a group so many times in all, at equal intervals.
  void distribute(std::size_t splits, const Line_group& group, std::vector<int>& parts)
  {
    const std::size_t n = group.lines.size();
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t more = (i + 1) * splits / n - i * splits / n;
      parts[group.lines[i]] += static_cast<int>(more);
      split_lines += more > 0;
    }
  }

  std::size_t discard_uneven_parts()
  {
    std::set<const Junction_curve*> uneven;
    for(const Part& p : m_parts)
      for(const Junction_trace& t : p.traces)
        if(t.size() != p.traces[0].size())
          uneven.insert(p.curve);
    m_parts.erase(
      std::remove_if(m_parts.begin(), m_parts.end(), [&](const Part& p) { return uneven.count(p.curve) != 0; }),
      m_parts.end());
    return uneven.size();
  }

  void place_vertices(const Part& part)
  {
    std::vector<std::vector<int>> vertices;
    std::vector<double> sums; // of the lengths along the curve
    for(const Junction_trace& t : part.traces)
    {
      vertices.emplace_back(1, m_tracer.source(t.front()));
      std::vector<double> lengths(1, t.front().from);
      for(const Trace_step& s : t)
        for(int k = 1, n = m_splits[s.halfedge]; k <= n; ++k)
        {
          vertices.back().push_back(quads->vertex(s.halfedge, s.is_forward ? k : n - k));
          lengths.push_back(s.from + (s.to - s.from) * k / n);
        }
      sums.resize(lengths.size(), 0.);
      for(std::size_t i = 0; i < lengths.size(); ++i)
        sums[i] += lengths[i];
    }
    for(std::size_t i = 0; i < sums.size(); ++i)
    {
      double s = sums[i] / static_cast<double>(part.traces.size());
      if(part.has_ends && i == 0)
        s = part.begin;
      else if(part.has_ends && i + 1 == sums.size())
        s = part.end;
      if(part.curve->is_closed)
        s = s - std::floor(s / part.curve->length()) * part.curve->length();
      const Point_3 p = part.curve->point(s);
      for(const std::vector<int>& v : vertices)
      {
        quads->mesh.points[v[i]] = Indexed_quad_mesh::Point_3(p.x(), p.y(), p.z());
        is_on_curve[v[i]] = 1;
      }
    }
  }

  // A line is split into so many more at most: what needs more has quads of very different sizes beside each other.
  static constexpr double largest_split = 8;
  static constexpr double most_subproblems = 20000; // some seconds

  const Indexed_quad_mesh& m_from;
  const Junction_tracer m_tracer;
  const double m_tolerance;
  std::vector<Part> m_parts;
  std::vector<int> m_splits; // per halfedge: into how many parts it is split
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SHEET_MEETING_H
