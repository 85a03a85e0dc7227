// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_JUNCTIONS_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_JUNCTIONS_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Triangle_input.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A curve along which sheets of a surface touch, from one node to the next or closed: a polyline with the length up to
// each of its points. A closed one has its first point at the end, too.
struct Junction_curve
{
  typedef Quadrangulation_kernel::Point_3 Point_3;

  std::vector<Point_3> points;
  std::vector<double> lengths; // per point; the last one is that of the curve
  bool is_closed = false;
  std::size_t sheets = 2; // how many edges of the mesh lie at each of its edges, at least

  double length() const { return lengths.back(); }

  // The point at a length along the curve.
  Point_3 point(double s) const
  {
    const std::size_t i = (std::min)(
      static_cast<std::size_t>(std::upper_bound(lengths.begin() + 1, lengths.end() - 1, s) - lengths.begin()),
      points.size() - 1);
    const double part = lengths[i] - lengths[i - 1];
    const double w = part > 0 ? (std::min)(1., (std::max)(0., (s - lengths[i - 1]) / part)) : 0;
    return w == 1 ? points[i] : points[i - 1] + w * (points[i] - points[i - 1]);
  }
};

// The edges of the input that lie at the same place as others, end by end: there sheets touch that a file had joined
// at edges with more than two faces. They become curves between nodes, where their number is not two.
class Junctions
{
  typedef Quadrangulation_kernel::Point_3 Point_3;
  typedef std::array<int, 2> Place_pair; // numbers of places, the smaller one first

public:
  std::vector<Junction_curve> curves;

  Junctions() = default;

  explicit Junctions(const Triangle_input& input)
  {
    find_places(input);
    find_edges(input);
    trace_curves();
  }

  // Marks the sides of triangles at these edges as curves, but for those at the border, which are followed anyway.
  void mark_sides(Triangle_input& input) const
  {
    if(curves.empty())
      return;
    input.is_curve.resize(input.triangles.size(), { { 0, 0, 0 } });
    std::set<std::pair<int, int>> sides;
    for(const std::array<int, 3>& t : input.triangles)
      for(int k = 0; k < 3; ++k)
        sides.emplace(t[k], t[(k + 1) % 3]);
    for(std::size_t f = 0; f < input.triangles.size(); ++f)
      for(int k = 0; k < 3; ++k)
      {
        const int a = input.triangles[f][k], b = input.triangles[f][(k + 1) % 3];
        if(m_edges.count(pair_of(m_place[a], m_place[b])) != 0 && sides.count({ b, a }) != 0)
          input.is_curve[f][k] = 1;
      }
  }

private:
  static Place_pair pair_of(int a, int b) { return { { (std::min)(a, b), (std::max)(a, b) } }; }

  // Points with the same coordinates are one place.
  void find_places(const Triangle_input& input)
  {
    std::map<std::array<double, 3>, int> numbers;
    for(const Point_3& p : input.points)
    {
      const auto n =
        numbers.emplace(std::array<double, 3>{ { p.x(), p.y(), p.z() } }, static_cast<int>(m_points.size()));
      if(n.second)
        m_points.push_back(p);
      m_place.push_back(n.first->second);
    }
  }

  // Places that more than one edge of the mesh joins.
  void find_edges(const Triangle_input& input)
  {
    if(m_points.size() == input.points.size())
      return; // no two vertices are at one place
    std::map<Place_pair, std::set<Place_pair>> edges;
    for(const std::array<int, 3>& t : input.triangles)
      for(int k = 0; k < 3; ++k)
        edges[pair_of(m_place[t[k]], m_place[t[(k + 1) % 3]])].insert(pair_of(t[k], t[(k + 1) % 3]));
    for(const auto& e : edges)
      if(e.second.size() > 1 && e.first[0] != e.first[1])
        m_edges.emplace(e.first, e.second.size());
  }

  void trace_curves()
  {
    std::map<int, std::vector<int>> next;
    for(const auto& e : m_edges)
    {
      next[e.first[0]].push_back(e.first[1]);
      next[e.first[1]].push_back(e.first[0]);
    }
    std::set<Place_pair> done;
    for(const bool is_closed : { false, true })
      for(const auto& n : next)
        if(is_closed || n.second.size() != 2)
          for(int to : n.second)
            if(done.count(pair_of(n.first, to)) == 0)
              trace(n.first, to, is_closed, next, done);
  }

  void trace(int from, int to, bool is_closed, const std::map<int, std::vector<int>>& next, std::set<Place_pair>& done)
  {
    Junction_curve curve;
    curve.is_closed = is_closed;
    curve.points.push_back(m_points[from]);
    curve.lengths.push_back(0);
    curve.sheets = m_edges.at(pair_of(from, to));
    for(const int first = from;;)
    {
      done.insert(pair_of(from, to));
      curve.sheets = (std::min)(curve.sheets, m_edges.at(pair_of(from, to)));
      const Point_3& p = m_points[to];
      curve.lengths.push_back(curve.lengths.back() + std::sqrt(squared_distance(curve.points.back(), p)));
      curve.points.push_back(p);
      const std::vector<int>& behind = next.at(to);
      if(behind.size() != 2 || to == first)
        break;
      const int before = from;
      from = to;
      to = behind[behind[0] == before ? 1 : 0];
    }
    curves.push_back(curve);
  }

  std::vector<Point_3> m_points;             // per place
  std::vector<int> m_place;                  // per vertex of the input
  std::map<Place_pair, std::size_t> m_edges; // those at which sheets touch, with their number of edges of the mesh
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_JUNCTIONS_H
