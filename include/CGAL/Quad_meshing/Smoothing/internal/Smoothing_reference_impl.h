// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_SMOOTHING_REFERENCE_IMPL_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_SMOOTHING_REFERENCE_IMPL_H

#include <CGAL/Quad_meshing/Smoothing/Smoothing_reference.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Reference_curves.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Wanted_directions.h>
#include <CGAL/Quad_meshing/internal/Reference_surface.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

struct Smoothing_reference::Data
{
  Reference_curves features;
  Reference_curves borders;
  Reference_surface surface;
  std::vector<double> length;                    // see `Indexed_reference`
  std::unique_ptr<Wanted_directions> directions; // null: there are none

  Data(const Indexed_quad_mesh& qm, Indexed_reference tm)
    : features(tm.features.empty() ? Reference_curves(qm.points, edges_of(qm, false))
                                   : Reference_curves(tm.mesh.points, tm.features))
    , borders(tm.borders.empty() ? Reference_curves(qm.points, edges_of(qm, true))
                                 : Reference_curves(tm.mesh.points, tm.borders))
    , surface(std::move(tm.mesh))
    , length(std::move(tm.length))
  {
    if(!tm.directions.direction.empty())
      directions = std::make_unique<Wanted_directions>(std::move(tm.directions), surface);
  }

private:
  static Curve_segments edges_of(const Indexed_quad_mesh& m, bool border)
  {
    Curve_segments segments;
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      if(border ? m.is_border(h) : m.is_feature[h] && !m.is_border(h) && m.edge(h) == h)
        segments.push_back({ { m.source(h), m.target(h) } });
    return segments;
  }
};

CGAL_QUAD_MESHING_INLINE Smoothing_reference::Smoothing_reference(const Indexed_quad_mesh& qm, Indexed_reference tm)
  : m_data(new Data(qm, std::move(tm)))
{
}

CGAL_QUAD_MESHING_INLINE Smoothing_reference::Smoothing_reference(const Indexed_quad_mesh& qm)
  : Smoothing_reference(qm, Indexed_reference{ triangulated_quad_mesh(qm), {}, {}, {}, {} })
{
}

CGAL_QUAD_MESHING_INLINE Smoothing_reference::Smoothing_reference(Smoothing_reference&& other) = default;

CGAL_QUAD_MESHING_INLINE Smoothing_reference::~Smoothing_reference() = default;

CGAL_QUAD_MESHING_INLINE bool Smoothing_reference::is_empty() const { return m_data->surface.empty(); }

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_SMOOTHING_REFERENCE_IMPL_H
