// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GUIDES_INTERNAL_CUT_TRIANGLES_IMPL_H
#define CGAL_QUAD_MESHING_GUIDES_INTERNAL_CUT_TRIANGLES_IMPL_H

#include <CGAL/Quad_meshing/Guides/cut_triangles.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Every triangle that a curve touches is triangulated anew, with the parts of curves as constraints.
//
// Weights are multiples of one over a power of two. So a point on a side lies on it exactly, in the triangles on both
// sides of it, and what is nearer to a corner or to another point than that is the same point.
class Triangle_cutter
{
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Guided_triangles::Point_3 Point_3;
  struct Node_number
  {
    int node = -1; // none has been made
  };
  typedef Triangulation_vertex_base_with_info_2<Node_number, Kernel> Vertex_base;
  typedef Triangulation_data_structure_2<Vertex_base, Constrained_triangulation_face_base_2<Kernel>> Data_structure;
  typedef Constrained_Delaunay_triangulation_2<Kernel, Data_structure, Exact_predicates_tag> Triangulation;

  // A part of a side is that long at least, relative to the side: a 16 thousandth, far below a percent of a quad even
  // where a triangle is as long as hundred quads.
  static constexpr int unit = 1 << 14;

  // A point of a curve: a vertex, a point on the side between two vertices, or one inside of a triangle.
  struct Node
  {
    int triangle; // one that it lies in
    std::array<int, 3> weight;
  };

public:
  Triangle_cutter(const Guided_triangles& input) : m_input(input), m_around(input.points.size())
  {
    m_result.points = input.points;
    for(std::size_t f = 0; f < input.triangles.size(); ++f)
      for(int v : input.triangles[f])
        m_around[v].push_back(static_cast<int>(f));
    m_nodes.resize(input.points.size(), { -1, { { 0, 0, 0 } } });
  }

  Cut_triangles run(const std::vector<std::vector<Triangle_place>>& curves)
  {
    for(const std::vector<Triangle_place>& curve : curves)
    {
      int last = -1;
      for(const Triangle_place& place : curve)
      {
        const int node = node_at(place);
        if(last != -1 && node != last && !add_part(last, node))
        {
          m_result.error = "A curve leaves the surface.";
          return m_result;
        }
        last = node;
      }
    }
    for(std::size_t f = 0; f < m_input.triangles.size(); ++f)
      write(static_cast<int>(f));
    return m_result;
  }

private:
  // The weights as whole numbers; the largest is what the others leave.
  static std::array<int, 3> rounded(const std::array<double, 3>& w)
  {
    std::array<int, 3> result;
    const int largest = static_cast<int>(std::max_element(w.begin(), w.end()) - w.begin());
    result[largest] = unit;
    for(int k = 0; k < 3; ++k)
      if(k != largest)
      {
        result[k] = static_cast<int>(std::lround(w[k] * unit));
        result[largest] -= result[k];
      }
    return result;
  }

  int node_at(const Triangle_place& place)
  {
    const std::array<int, 3>& t = m_input.triangles[place.triangle];
    const std::array<int, 3> w = rounded(place.weight);
    for(int k = 0; k < 3; ++k)
      if(w[k] == unit)
        return t[k];
    // Of a side: its vertices, and the weight of the second one; else the triangle and two weights.
    std::tuple<int, int, int, int> key(place.triangle, w[1], w[2], 0);
    for(int k = 0; k < 3; ++k)
      if(w[k] == 0)
      {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        key = t[a] < t[b] ? std::make_tuple(t[a], t[b], w[b], 1) : std::make_tuple(t[b], t[a], w[a], 1);
      }
    const auto found = m_number.emplace(key, static_cast<int>(m_result.points.size()));
    if(!found.second)
      return found.first->second;
    m_nodes.push_back({ place.triangle, w });
    m_result.points.push_back(point(place.triangle, w[0], w[1], w[2]));
    if(std::get<3>(key) == 1)
      m_of_side[std::make_pair(std::get<0>(key), std::get<1>(key))].push_back(found.first->second);
    return found.first->second;
  }

  Point_3 point(int f, double w0, double w1, double w2) const
  {
    const std::array<int, 3>& t = m_input.triangles[f];
    return barycenter(m_input.points[t[0]], w0, m_input.points[t[1]], w1, m_input.points[t[2]], w2);
  }

  bool is_vertex(int node) const { return m_nodes[node].triangle == -1; }

  // The triangles that a node lies in, with those that it lies on the border of.
  std::vector<int> triangles_of(int node) const
  {
    if(is_vertex(node))
      return m_around[node];
    const Node& n = m_nodes[node];
    const std::array<int, 3>& t = m_input.triangles[n.triangle];
    for(int k = 0; k < 3; ++k)
      if(n.weight[k] == 0)
        return common(m_around[t[(k + 1) % 3]], m_around[t[(k + 2) % 3]]);
    return { n.triangle };
  }

  static std::vector<int> common(const std::vector<int>& a, const std::vector<int>& b)
  {
    std::vector<int> result; // both are in ascending order
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
  }

  // The part of a curve between two nodes, in all triangles that it lies in: two if it runs along a side.
  bool add_part(int a, int b)
  {
    const std::vector<int> faces = common(triangles_of(a), triangles_of(b));
    for(int f : faces)
      m_parts[f].push_back({ { a, b } });
    return !faces.empty();
  }

  // The weights of a node in one of its triangles.
  std::array<int, 3> weights_in(int f, int node) const
  {
    std::array<int, 3> w = { { 0, 0, 0 } };
    const std::array<int, 3>& t = m_input.triangles[f];
    if(is_vertex(node))
      for(int k = 0; k < 3; ++k)
        w[k] = t[k] == node ? unit : 0;
    else
      for(int k = 0; k < 3; ++k)
        for(int j = 0; j < 3; ++j)
          if(t[k] == m_input.triangles[m_nodes[node].triangle][j])
            w[k] = m_nodes[node].weight[j];
    return f == m_nodes[node].triangle ? m_nodes[node].weight : w;
  }

  void write(int f)
  {
    const std::array<int, 3>& t = m_input.triangles[f];
    std::set<int> nodes(t.begin(), t.end());
    for(int k = 0; k < 3; ++k)
    {
      const int a = t[k], b = t[(k + 1) % 3];
      const auto on_side = m_of_side.find(std::make_pair((std::min)(a, b), (std::max)(a, b)));
      if(on_side != m_of_side.end())
        nodes.insert(on_side->second.begin(), on_side->second.end());
    }
    const auto parts = m_parts.find(f);
    if(parts != m_parts.end())
      for(const std::array<int, 2>& part : parts->second)
        nodes.insert(part.begin(), part.end());
    if(parts == m_parts.end() && nodes.size() == 3)
      return add(f, t, { { 0, 1, 2 } }, { { 0, 0, 0 } });

    Triangulation triangulation;
    std::map<int, typename Triangulation::Vertex_handle> handle;
    for(int node : nodes)
    {
      const std::array<int, 3> w = weights_in(f, node);
      handle[node] = triangulation.insert(Kernel::Point_2(w[1], w[2]));
      handle[node]->info().node = node;
    }
    if(parts != m_parts.end())
      for(const std::array<int, 2>& part : parts->second)
        triangulation.insert_constraint(handle[part[0]], handle[part[1]]);
    for(auto v : triangulation.finite_vertex_handles())
      if(v->info().node == -1) // where curves cross
      {
        const double w1 = v->point().x(), w2 = v->point().y();
        v->info().node = static_cast<int>(m_result.points.size());
        m_result.points.push_back(point(f, unit - w1 - w2, w1, w2));
      }
    for(auto g : triangulation.finite_face_handles())
    {
      std::array<int, 3> corners;
      std::array<char, 3> side, is_curve;
      for(int k = 0; k < 3; ++k)
      {
        corners[k] = g->vertex(k)->info().node;
        side[k] = side_of(g->vertex(k)->point(), g->vertex((k + 1) % 3)->point());
        is_curve[k] = g->is_constrained((k + 2) % 3); // the edge opposite to that vertex
      }
      add(f, corners, side, is_curve);
    }
  }

  static char side_of(const Kernel::Point_2& p, const Kernel::Point_2& q)
  {
    if(p.y() == 0 && q.y() == 0)
      return 0;
    if(p.x() + p.y() == unit && q.x() + q.y() == unit)
      return 1;
    return p.x() == 0 && q.x() == 0 ? char(2) : Cut_triangles::inside;
  }

  void add(int f, const std::array<int, 3>& corners, const std::array<char, 3>& side,
           const std::array<char, 3>& is_curve)
  {
    m_result.triangles.push_back(corners);
    m_result.origin.push_back(static_cast<std::size_t>(f));
    m_result.side.push_back(side);
    m_result.is_curve.push_back(is_curve);
  }

  const Guided_triangles& m_input;
  Cut_triangles m_result;
  std::vector<std::vector<int>> m_around; // per vertex: its triangles, in ascending order
  std::vector<Node> m_nodes;              // the first ones are the vertices
  std::map<std::tuple<int, int, int, int>, int> m_number;
  std::map<std::pair<int, int>, std::vector<int>> m_of_side; // the nodes on a side
  std::map<int, std::vector<std::array<int, 2>>> m_parts;    // per triangle: of curves, by their nodes
};

CGAL_QUAD_MESHING_INLINE Cut_triangles cut_triangles(const Guided_triangles& input,
                                                     const std::vector<std::vector<Triangle_place>>& curves)
{
  return Triangle_cutter(input).run(curves);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GUIDES_INTERNAL_CUT_TRIANGLES_IMPL_H
