// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_FEATURE_BENDS_H
#define CGAL_QUAD_MESHING_LAYOUT_FEATURE_BENDS_H

#include <CGAL/Quad_meshing/Layout/Motorcycle_complex.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// How much the features and borders of a quad mesh bend along the arcs of its motorcycle complex. A chord of a circular
// arc is away from it by an eighth of the product of its length and its turn; k chords by that over k squared.
class Feature_bends
{
public:
  Feature_bends(const Indexed_quad_mesh& m, const Motorcycle_complex& complex) : m_arcs(complex.arcs.size())
  {
    auto side = [&](int h) { return m.points[m.target(h)] - m.points[m.source(h)]; };
    double mean = 0;
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      mean += std::sqrt(side(h).squared_length()) / m.number_of_halfedges();
    for(std::size_t a = 0; a < m_arcs.size() && mean > 0; ++a)
    {
      const Motorcycle_complex::Arc& arc = complex.arcs[a];
      if(!arc.is_feature && !arc.is_border)
        continue;
      std::vector<double>&length = m_arcs[a].length, &turn = m_arcs[a].turn;
      length.assign(1, 0.);
      turn.assign(1, 0.);
      for(std::size_t i = 0; i < arc.halfedges.size(); ++i)
      {
        const Indexed_quad_mesh::Vector_3 u = side(arc.halfedges[i]);
        length.push_back(length.back() + std::sqrt(u.squared_length()) / mean);
        double angle = 0;
        if(i + 1 < arc.halfedges.size())
        {
          const Indexed_quad_mesh::Vector_3 w = side(arc.halfedges[i + 1]), n = cross_product(u, w);
          angle = std::atan2(std::sqrt(n.squared_length()), u * w);
        }
        turn.push_back(turn.back() + angle);
      }
    }
  }

  bool is_straight(std::size_t arc) const { return m_arcs[arc].length.empty(); }

  // Length, in mean edges of the mesh, of a part of an arc, and its product with the turn. Places are counted in edges.
  double length(std::size_t arc, double from, double to) const
  {
    return at(m_arcs[arc].length, to) - at(m_arcs[arc].length, from);
  }

  double bend(std::size_t arc, double from, double to) const
  {
    return length(arc, from, to) * (turn(arc, to) - turn(arc, from));
  }

private:
  struct Sums
  {
    // up to each vertex of the arc; `turn` with the one at that vertex. Empty for arcs that need not be followed.
    std::vector<double> length, turn;
  };

  static double at(const std::vector<double>& sums, double place)
  {
    const std::size_t i = static_cast<std::size_t>(place);
    return i + 1 < sums.size() ? sums[i] + (place - i) * (sums[i + 1] - sums[i]) : sums.back();
  }

  // A turn belongs half to what ends there.
  double turn(std::size_t arc, double place) const
  {
    const std::vector<double>& sums = m_arcs[arc].turn;
    const std::size_t i = static_cast<std::size_t>(place);
    return place > i || i == 0 ? sums[i] : (sums[i - 1] + sums[i]) / 2;
  }

  std::vector<Sums> m_arcs;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_FEATURE_BENDS_H
