// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_DOMAIN_OPTIMIZATION_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_DOMAIN_OPTIMIZATION_H

#include <CGAL/Quad_meshing/Layout/internal/Chart_isometry.h>
#include <CGAL/Quad_meshing/Layout/internal/Embedded_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_charts.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_parameterization.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Optimizes the charts of all patches (thesis, section 7.2): with all arcs aligned, the chart of each patch by itself
// and the parameterization are computed in turn.
//
// That vertices keep their bilinear coordinates is an approximation, so new charts can be worse than they seem. Then
// they go only a part of the way, and if no part of it lowers the energy, the charts stay: it never rises.
class Domain_optimization
{
public:
  // How often the way of the charts is halved.
  static constexpr int most_halvings = 2;
  // The iteration ends when the energy decreases by a smaller part than this, or lies below `perfect` per area.
  static constexpr double least_decrease = 1e-3, perfect = 1e-14;

  std::vector<double> energies; // per parameterization: sum over all charts, divided by the area

  Domain_optimization(const Embedded_layout& e, Layout_parameterization& parameterization)
    : m_e(e), m_parameterization(parameterization), m_faces(e.number_of_patches())
  {
    for(int f = 0; f < e.mesh().number_of_faces(); ++f)
      m_faces[e.patch[f]].push_back(f);
  }

  // Charts of the kinds of their patches to begin with: unit squares, rectangles as long and wide as the patches, or
  // quadrilaterals with the lengths of their sides and, in proportion, their angles.
  static void start(const Embedded_layout& e, const std::vector<Layout_chart>& kinds, Layout_charts& charts)
  {
    charts.chart.clear();
    for(int p = 0; p < e.number_of_patches(); ++p)
    {
      std::array<double, 4> length, angle;
      for(int k = 0; k < 4; ++k)
      {
        length[k] = charts.side_length(e.layout.patches[p].sides[k]);
        angle[k] = corner_angle(e, Layout_topology::direction(e.layout.patches[p].sides[k].front()));
      }
      Quadrilateral_chart chart =
        kinds[p] == Layout_chart::UNIT
          ? Quadrilateral_chart::rectangle(1, 1)
          : Quadrilateral_chart::rectangle(0.5 * (length[0] + length[2]), 0.5 * (length[1] + length[3]));
      if(kinds[p] == Layout_chart::QUADRILATERAL)
      {
        const Quadrilateral_chart candidate = Quadrilateral_chart::from_sides(length, angle);
        if(candidate.is_convex())
          chart = candidate;
      }
      charts.chart.push_back(chart);
    }
  }

  // The angle of a patch, in degrees, at the corner where a direction begins.
  static double corner_angle(const Embedded_layout& e, int direction)
  {
    const Indexed_triangle_mesh& m = e.mesh();
    double sum = 0;
    for(int h = e.border[direction].front();; h = m.opposite[m.prev(h)])
    {
      sum += approximate_angle(m.vector(h), -m.vector(m.prev(h)));
      if(e.surface.is_on_arc(m.prev(h)))
        return sum;
    }
  }

  // Returns false if a system cannot be solved. The charts are then those of the last one that was.
  bool run(Layout_charts& charts, const std::vector<Layout_chart>& kinds, unsigned int iterations,
           Layout_parameterization::Alignment alignment, Any_visitor& visitor)
  {
    const std::vector<char> all(m_e.number_of_arcs(), 1);
    if(!m_parameterization.solve(charts, all, alignment))
      return false;
    energies.assign(1, energy(charts));
    if(std::all_of(kinds.begin(), kinds.end(), [](Layout_chart k) { return k == Layout_chart::UNIT; }))
      return true;
    for(unsigned int i = 0; i < iterations && visitor.go_further(); ++i)
    {
      const std::vector<Quadrilateral_chart> old = charts.chart;
      const std::vector<Eigen::Vector2d> old_place = m_parameterization.place, old_on_arc = m_parameterization.on_arc;
      std::vector<Quadrilateral_chart> next = old;
      for(int p = 0; p < m_e.number_of_patches(); ++p)
        if(kinds[p] != Layout_chart::UNIT)
          next[p] = optimize_chart(isometry(charts, p), old[p], kinds[p] == Layout_chart::RECTANGLE);
      double part = 1;
      bool is_lower = false;
      for(int h = 0; h <= most_halvings && !is_lower; ++h, part /= 2)
      {
        for(int p = 0; p < m_e.number_of_patches(); ++p)
          charts.chart[p] = Quadrilateral_chart((1 - part) * old[p].parameters() + part * next[p].parameters());
        const bool is_convex = std::all_of(charts.chart.begin(), charts.chart.end(),
                                           [](const Quadrilateral_chart& c) { return c.is_convex(); });
        if(is_convex && m_parameterization.solve(charts, all, alignment))
        {
          const double e = energy(charts);
          is_lower = e < energies.back();
          if(is_lower)
            energies.push_back(e);
        }
      }
      if(!is_lower)
      {
        charts.chart = old;
        m_parameterization.place = old_place;
        m_parameterization.on_arc = old_on_arc;
        return true;
      }
      visitor.progress(double(i + 1) / iterations);
      const double before = energies[energies.size() - 2], now = energies.back();
      if(now < perfect || before - now < least_decrease * before)
        break;
    }
    return true;
  }

  // The energy of the map of a patch as a function of its chart.
  Chart_isometry isometry(const Layout_charts& charts, int patch) const
  {
    const Indexed_triangle_mesh& m = m_e.mesh();
    Chart_isometry result;
    for(int f : m_faces[patch])
    {
      const Indexed_triangle_mesh::Vector_3 a = m.vector(3 * f), b = -m.vector(3 * f + 2);
      const double x1 = std::sqrt(a.squared_length());
      if(!(x1 > 0))
        continue;
      std::array<Eigen::Vector2d, 3> st;
      for(int k = 0; k < 3; ++k)
        st[k] = charts.chart[patch].inverse_bilinear(m_parameterization.place[m_parameterization.copy[3 * f + k]]);
      result.add(x1, (a * b) / x1, std::sqrt(cross_product(a, b).squared_length()) / x1, st);
    }
    return result;
  }

  double energy(const Layout_charts& charts) const
  {
    double sum = 0, area = 0;
    for(int p = 0; p < m_e.number_of_patches(); ++p)
    {
      const Chart_isometry i = isometry(charts, p);
      sum += i.energy(charts.chart[p].parameters());
      area += i.area();
    }
    return area > 0 ? sum / area : 0;
  }

private:
  const Embedded_layout& m_e;
  Layout_parameterization& m_parameterization;
  std::vector<std::vector<int>> m_faces; // per patch
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_DOMAIN_OPTIMIZATION_H
