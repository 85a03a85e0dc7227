// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_SMOOTHING_REFERENCE_H
#define CGAL_QUAD_MESHING_SMOOTHING_SMOOTHING_REFERENCE_H

#include <CGAL/Quad_meshing/Smoothing/internal/Reference_curves.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Reference_surface.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

typedef std::vector<std::array<int, 2> > Curve_segments;

// What the vertices of a quad mesh move on: a surface, the curves of its features, its borders.
struct Smoothing_reference
{
  Reference_curves features;
  Reference_curves borders;
  Reference_surface surface;

  // The segments index the points of the triangle mesh. Where there are none of a kind, those of the
  // quad mesh as it is now are taken.
  Smoothing_reference(const Indexed_quad_mesh& qm, Indexed_triangle_mesh tm,
                      const Curve_segments& feature_segments, const Curve_segments& border_segments)
    : features(feature_segments.empty() ? Reference_curves(qm.points, edges_of(qm, false))
                                        : Reference_curves(tm.points, feature_segments)),
      borders(border_segments.empty() ? Reference_curves(qm.points, edges_of(qm, true))
                                      : Reference_curves(tm.points, border_segments)),
      surface(std::move(tm))
  {}

  // The surface of the quad mesh itself.
  explicit Smoothing_reference(const Indexed_quad_mesh& qm)
    : Smoothing_reference(qm, triangulated_quad_mesh(qm), {}, {})
  {}

private:
  static Curve_segments edges_of(const Indexed_quad_mesh& m, bool border)
  {
    Curve_segments segments;
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      if(border ? m.is_border(h) : m.is_feature[h] && !m.is_border(h) && m.edge(h) == h)
        segments.push_back({{ m.source(h), m.target(h) }});
    return segments;
  }
};

// The reference that a triangle mesh with feature edges is for a quad mesh.
template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsConstrainedMap>
Smoothing_reference make_smoothing_reference(const Indexed_quad_mesh& qm, const TriangleMesh& tm,
                                             VertexPointMap vpm, EdgeIsConstrainedMap ecm)
{
  // the index maps of a mesh that has garbage are not consecutive
  const auto vim = get(CGAL::dynamic_vertex_property_t<int>(), tm);
  const auto fim = get(CGAL::dynamic_face_property_t<int>(), tm);
  int i = 0;
  for(auto v : vertices(tm))
    put(vim, v, i++);
  i = 0;
  for(auto f : faces(tm))
    put(fim, f, i++);

  Curve_segments feature_segments, border_segments;
  for(auto e : edges(tm))
    if(is_border(e, tm))
      border_segments.push_back({{ get(vim, source(e, tm)), get(vim, target(e, tm)) }});
    else if(get(ecm, e))
      feature_segments.push_back({{ get(vim, source(e, tm)), get(vim, target(e, tm)) }});
  return Smoothing_reference(qm, make_indexed_triangle_mesh(tm, vpm, vim, fim), feature_segments, border_segments);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_SMOOTHING_REFERENCE_H
