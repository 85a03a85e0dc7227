// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_CHART_SAMPLING_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_CHART_SAMPLING_H

#include <CGAL/Quad_meshing/Layout/internal/Arc_quantization.h>
#include <CGAL/Quad_meshing/Layout/internal/Embedded_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_charts.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_parameterization.h>
#include <CGAL/Quad_meshing/Layout/internal/Map_walk.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Makes the quads (thesis, section 7.2, "Meshing"): the samples of an arc divide it evenly in the charts, opposite
// samples of a chart are joined by straight lines, and the crossings of these are mapped to the surface.
class Chart_sampling
{
public:
  Indexed_quad_mesh quads;         // not connected yet
  std::vector<int> patch_of_quad;  // per quad
  std::vector<int> arc_of_edge;    // per halfedge of the quads: the arc that it lies on, -1 inside
  std::vector<int> failed_patches; // those in which a sample was not found on the surface

  Chart_sampling(const Embedded_layout& e, const Layout_charts& charts, const Layout_parameterization& map,
                 const std::vector<char>& is_aligned, const Arc_quantization& numbers)
    : m_e(e), m_charts(charts), m_map(map), m_numbers(numbers), m_walk(e, map, charts)
  {
    for(int v : e.vertex_of_node)
      quads.points.push_back(e.mesh().points[v]);
    for(int a = 0; a < e.number_of_arcs(); ++a)
    {
      m_first.push_back(quads.number_of_vertices());
      const bool is_straight = is_aligned[a] || e.topology.is_border(a);
      for(int i = 1; i < numbers.number[a]; ++i)
        quads.points.push_back(is_straight ? point_on_arc(a, double(i) / numbers.number[a])
                                           : Indexed_quad_mesh::Point_3(0, 0, 0));
      m_is_placed.resize(quads.points.size(), is_straight);
    }
    for(std::size_t n = 0; n < e.vertex_of_node.size(); ++n)
      m_is_placed[n] = 1;
    for(int p = 0; p < e.number_of_patches(); ++p)
      if(!sample(p))
        failed_patches.push_back(p);
  }

private:
  // A sample of a chart.
  struct Sample
  {
    int vertex;
    Eigen::Vector2d place;
    int direction; // of the arc that leads to the next one
  };

  Indexed_quad_mesh::Point_3 point_on_arc(int arc, double s) const
  {
    const std::vector<int>& chain = m_e.chain[arc];
    auto parameter = [&](std::size_t i) {
      return i == 0 ? 0. : i + 1 == chain.size() ? 1. : m_map.on_arc[chain[i]].x();
    };
    std::size_t i = 0;
    while(i + 2 < chain.size() && parameter(i + 1) < s)
      ++i;
    const double from = parameter(i), to = parameter(i + 1);
    const double t = to > from ? (std::min)((std::max)((s - from) / (to - from), 0.), 1.) : 0.5;
    const Indexed_quad_mesh::Point_3 &p = m_e.mesh().points[chain[i]], &q = m_e.mesh().points[chain[i + 1]];
    return p + t * (q - p);
  }

  // The samples of a side in its order, the last one left out.
  std::vector<Sample> side_samples(const std::vector<Surface_layout::Side_arc>& side) const
  {
    std::vector<Sample> samples;
    for(const Surface_layout::Side_arc& s : side)
    {
      const int d = Layout_topology::direction(s), a = static_cast<int>(s.arc), n = m_numbers.number[a];
      for(int i = 0; i < n; ++i)
      {
        const int v = i == 0 ? static_cast<int>(layout_node_of_end(m_e.layout, d))
                             : m_first[a] + (s.is_forward ? i - 1 : n - 1 - i);
        samples.push_back(Sample{ v, m_charts.position(d, double(i) / n), d });
      }
    }
    return samples;
  }

  bool sample(int p)
  {
    const Surface_layout::Patch& patch = m_e.layout.patches[p];
    std::array<std::vector<Sample>, 4> sides;
    for(int k = 0; k < 4; ++k)
      sides[k] = side_samples(patch.sides[k]);
    for(int k = 0; k < 4; ++k) // the corner behind the side
      sides[k].push_back(sides[(k + 1) % 4].front());
    const int w = static_cast<int>(sides[0].size()) - 1, h = static_cast<int>(sides[1].size()) - 1;

    bool is_good = true;
    Map_walk::Place place;
    auto locate = [&](const Eigen::Vector2d& q, Indexed_quad_mesh::Point_3& point)
    {
      if(place.face == -1)
        place = m_walk.start(p, m_charts.chart[p], q);
      if(place.face == -1 || !m_walk.walk(place, q))
      {
        // from a triangle nearby once more
        Map_walk::Place other = m_walk.start(p, m_charts.chart[p], q);
        if(other.face == -1 || !m_walk.walk(other, q))
        {
          is_good = false;
          return;
        }
        place = other;
      }
      point = m_walk.point(place);
    };
    for(int k = 0; k < 4; ++k)
      for(std::size_t i = 0; i + 1 < sides[k].size(); ++i)
        if(!m_is_placed[sides[k][i].vertex])
        {
          locate(sides[k][i].place, quads.points[sides[k][i].vertex]);
          m_is_placed[sides[k][i].vertex] = 1;
        }

    // vertex (i, j), column i and row j
    std::vector<int> vertex((w + 1) * (h + 1));
    auto at = [&](int i, int j) -> int& { return vertex[j * (w + 1) + i]; };
    for(int i = 0; i <= w; ++i)
    {
      at(i, 0) = sides[0][i].vertex;
      at(i, h) = sides[2][w - i].vertex;
    }
    for(int j = 0; j <= h; ++j)
    {
      at(w, j) = sides[1][j].vertex;
      at(0, j) = sides[3][h - j].vertex;
    }
    for(int j = 1; j < h; ++j)
      for(int k = 1; k < w; ++k)
      {
        const int i = j % 2 == 1 ? k : w - k; // back and forth, so that the walks are short
        at(i, j) = quads.number_of_vertices();
        quads.points.emplace_back(0, 0, 0);
        locate(crossing(sides[0][i].place, sides[2][w - i].place, sides[3][h - j].place, sides[1][j].place),
               quads.points.back());
      }
    m_is_placed.resize(quads.points.size(), 1);

    for(int j = 0; j < h; ++j)
      for(int i = 0; i < w; ++i)
      {
        quads.corners.push_back({ { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) } });
        patch_of_quad.push_back(p);
        arc_of_edge.push_back(j == 0 ? sides[0][i].direction / 2 : -1);
        arc_of_edge.push_back(i + 1 == w ? sides[1][j].direction / 2 : -1);
        arc_of_edge.push_back(j + 1 == h ? sides[2][w - 1 - i].direction / 2 : -1);
        arc_of_edge.push_back(i == 0 ? sides[3][h - 1 - j].direction / 2 : -1);
      }
    quads.is_feature.resize(arc_of_edge.size(), 0);
    return is_good;
  }

  // Where the lines p0 p1 and q0 q1 cross.
  static Eigen::Vector2d crossing(const Eigen::Vector2d& p0, const Eigen::Vector2d& p1, const Eigen::Vector2d& q0,
                                  const Eigen::Vector2d& q1)
  {
    const double denominator = cross_product_2(p1 - p0, q1 - q0);
    const double t = denominator != 0 ? cross_product_2(q0 - p0, q1 - q0) / denominator : 0.5;
    return p0 + t * (p1 - p0);
  }

  const Embedded_layout& m_e;
  const Layout_charts& m_charts;
  const Layout_parameterization& m_map;
  const Arc_quantization& m_numbers;
  const Map_walk m_walk;
  std::vector<int> m_first;      // per arc: its first inner sample
  std::vector<char> m_is_placed; // per vertex
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_CHART_SAMPLING_H
