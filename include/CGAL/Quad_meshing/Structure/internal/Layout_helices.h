// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_HELICES_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_HELICES_H

#include <CGAL/Quad_meshing/Layout/Layout_curves.h>
#include <CGAL/Quad_meshing/Layout/Layout_realization.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_goals.h>
#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Helix_detection.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The helices of a layout. When a curve is replaced by several parallel ones, each of these has its helices; so a curve
// with helices is multiplied less than the others.
class Layout_helices
{
public:
  // `r` is the layout itself, which must live as long as the object; `curves` are those of the same lengths.
  Layout_helices(const Layout_realization& r, const Layout_curves& curves)
    : Layout_helices(r, curves.of_edge, curves.number_of_curves())
  {
  }

  // The same where each curve is replaced by parallel ones: `curve_of_edge` tells it, see
  // `Layout_curves::curves_of_edges()`.
  Layout_helices(const Layout_realization& r, const std::vector<int>& curve_of_edge, int number_of_curves)
    : m_mesh(r.mesh)
    , m_lines(r.mesh)
    , m_relation(side_relations(r.mesh, m_lines))
    , m_curve_of_line(m_lines.number_of_lines(), -1)
    , m_helices(number_of_curves, 0)
  {
    for(std::size_t e = 0; e < curve_of_edge.size(); ++e)
      if(r.side_of_edge[e] != -1)
      {
        const int l = m_lines.line[r.side_of_edge[e]];
        m_curve_of_line[l] = m_curve_of_line[m_lines.reverse[l]] = curve_of_edge[e];
      }
    for(const Helix_record& h : minimal_helices(m_mesh, m_lines, m_relation))
      ++m_helices[m_curve_of_line[h.line]];
  }

  // Per curve.
  const std::vector<int>& of_curves() const { return m_helices; }

  // By how many parallel ones each curve may be replaced so that there are about so many helices.
  std::vector<int> largest_multiplicities(double most_helices) const
  {
    int helices = 0;
    for(int n : m_helices)
      helices += n;
    std::vector<int> largest(m_helices.size(), Layout_curves::any_multiplicity);
    for(std::size_t c = 0; c < m_helices.size(); ++c)
      if(m_helices[c] > 0)
        largest[c] = (std::max)(1, static_cast<int>(most_helices / helices));
    return largest;
  }

  // The number of helices when each curve is replaced by so many parallel ones.
  double number_of_helices(const std::vector<int>& multiplicity) const
  {
    double n = 0;
    for(std::size_t c = 0; c < m_helices.size(); ++c)
      n += double(m_helices[c]) * multiplicity[c];
    return n;
  }

  // The same for those that may cross themselves.
  double number_of_helices_with_crossings(const std::vector<int>& multiplicity) const
  {
    double n = 0;
    for(const Helix_record& h : minimal_helices(m_mesh, m_lines, m_relation, true))
      n += multiplicity[m_curve_of_line[h.line]];
    return n;
  }

private:
  const Indexed_quad_mesh& m_mesh;
  Dual_lines m_lines;
  std::vector<Side_relation> m_relation;
  std::vector<int> m_curve_of_line;
  std::vector<int> m_helices; // per curve
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_LAYOUT_HELICES_H
