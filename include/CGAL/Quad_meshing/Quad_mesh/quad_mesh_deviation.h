// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEVIATION_H
#define CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEVIATION_H

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_shape.h>
#include <CGAL/Quad_meshing/internal/Reference_surface.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief tells how far a quad mesh is from the surface that it stands for, and how much of the
 * features and the boundary of that surface lies on its edges.
 *
 * Distances are relative to the diagonal of the bounding box of the reference.
 */
struct Quad_mesh_deviation
{
  double quads_to_reference_max = 0;    ///< largest distance of a vertex, edge midpoint or centre of a quad
  double quads_to_reference_rms = 0;    ///< root mean square of these distances
  double reference_to_quads_max = 0;    ///< largest distance of a vertex or centroid of the reference
  double reference_to_quads_rms = 0;    ///< root mean square of these distances
  double opposed_quads = 0;             ///< share of the quads whose normal is opposed to the reference
  double feature_length = 0;            ///< length of the feature edges, in mean quad edges
  double features_kept = 1;             ///< share of that length that lies on quad edges
  double boundary_length = 0;           ///< length of the boundary, in mean quad edges
  double boundary_kept = 1;             ///< share of that length that lies on boundary edges of the quads
};

namespace internal {

// The share of the length of some segments that lies on edges of a quad mesh: within a tenth of the
// mean edge length, and along an edge that differs by less than 25 degrees in direction.
inline double share_on_edges(const std::vector<std::array<Shape_point_3, 2> >& segments,
                             const std::vector<std::array<Shape_point_3, 2> >& edges, double mean_edge)
{
  constexpr double tolerance = 0.1, sample_step = 0.1, largest_turn = 25;
  const double reach = tolerance * mean_edge, cosine = std::cos(largest_turn * CGAL_PI / 180);

  // edges cut into pieces, in a grid of cubes with the mean edge as side
  typedef std::array<int, 3> Cell;
  auto cell_of = [&](const Shape_point_3& p)
  {
    return Cell{{ static_cast<int>(std::floor(p.x() / mean_edge)), static_cast<int>(std::floor(p.y() / mean_edge)),
                  static_cast<int>(std::floor(p.z() / mean_edge)) }};
  };
  std::map<Cell, std::vector<int> > grid;
  for(std::size_t e = 0; e < edges.size(); ++e)
  {
    const Shape_vector_3 d = edges[e][1] - edges[e][0];
    const int pieces = 1 + static_cast<int>(2 * std::sqrt(d.squared_length()) / mean_edge);
    for(int i = 0; i <= pieces; ++i)
    {
      std::vector<int>& cell = grid[cell_of(edges[e][0] + (double(i) / pieces) * d)];
      if(cell.empty() || cell.back() != static_cast<int>(e))
        cell.push_back(static_cast<int>(e));
    }
  }
  auto is_on_edge = [&](const Shape_point_3& p, const Shape_vector_3& direction)
  {
    const Cell c = cell_of(p);
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z)
        {
          const auto found = grid.find(Cell{{ c[0] + x, c[1] + y, c[2] + z }});
          if(found == grid.end())
            continue;
          for(int e : found->second)
          {
            const Shape_vector_3 d = edges[e][1] - edges[e][0];
            const double l = d.squared_length();
            const double t = l > 0 ? (std::min)(1., (std::max)(0., ((p - edges[e][0]) * d) / l)) : 0;
            if(squared_distance(p, edges[e][0] + t * d) <= reach * reach
               && CGAL::abs(d * direction) >= cosine * std::sqrt(l))
              return true;
          }
        }
    return false;
  };

  double sum = 0, kept = 0;
  for(const std::array<Shape_point_3, 2>& s : segments)
  {
    const Shape_vector_3 d = s[1] - s[0];
    const double length = std::sqrt(d.squared_length());
    if(!(length > 0))
      continue;
    const int samples = (std::max)(1, static_cast<int>(std::ceil(length / (sample_step * mean_edge))));
    int on_edge = 0;
    for(int i = 0; i < samples; ++i)
      on_edge += is_on_edge(s[0] + ((i + 0.5) / samples) * d, d / length);
    sum += length;
    kept += length * on_edge / samples;
  }
  return sum > 0 ? kept / sum : 1;
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief compares a quad mesh with the triangle mesh that it stands for.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam NamedParametersQM a sequence of named parameters
 * \tparam NamedParametersTM a sequence of named parameters
 *
 * \param qm the quad mesh
 * \param tm the triangle mesh
 * \param np_qm an optional sequence of named parameters for `qm`: `vertex_point_map`
 * \param np_tm an optional sequence of named parameters for `tm`: `vertex_point_map`, and
 *        `edge_is_constrained_map` that tells the feature edges (by default none)
 *
 * \pre `CGAL::is_quad_mesh(qm)` and `CGAL::is_triangle_mesh(tm)`; both have faces, `tm` one of positive
 *      area; no vertex is non-manifold
 */
template <typename QuadMesh, typename TriangleMesh,
          typename NamedParametersQM = parameters::Default_named_parameters,
          typename NamedParametersTM = parameters::Default_named_parameters>
Quad_mesh_deviation
quad_mesh_deviation(const QuadMesh& qm, const TriangleMesh& tm,
                    const NamedParametersQM& np_qm = parameters::default_values(),
                    const NamedParametersTM& np_tm = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef internal::Shape_point_3 Point_3;
  typedef internal::Shape_vector_3 Vector_3;
  typedef typename boost::graph_traits<QuadMesh>::edge_descriptor Quad_edge;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor Triangle_edge;

  CGAL_precondition(is_quad_mesh(qm));
  CGAL_precondition(is_triangle_mesh(tm));
  const auto quad_vpm = choose_parameter(get_parameter(np_qm, internal_np::vertex_point),
                                         get_const_property_map(vertex_point, qm));
  const auto vpm = choose_parameter(get_parameter(np_tm, internal_np::vertex_point),
                                    get_const_property_map(vertex_point, tm));
  const auto ecm = choose_parameter(get_parameter(np_tm, internal_np::edge_is_constrained),
                                    Static_boolean_property_map<Triangle_edge, false>());

  const internal::Indexed_quad_mesh m =
    internal::make_indexed_quad_mesh(qm, quad_vpm, Static_boolean_property_map<Quad_edge, false>()).mesh;
  const auto vim = get(CGAL::dynamic_vertex_property_t<int>(), tm);
  const auto fim = get(CGAL::dynamic_face_property_t<int>(), tm);
  int i = 0;
  for(auto v : vertices(tm))
    put(vim, v, i++);
  i = 0;
  for(auto f : faces(tm))
    put(fim, f, i++);
  const internal::Indexed_triangle_mesh t = internal::make_indexed_triangle_mesh(tm, vpm, vim, fim);
  internal::Reference_surface reference(t), quads(internal::triangulated_quad_mesh(m));

  Quad_mesh_deviation d;
  Bbox_3 box;
  for(const std::array<int, 3>& c : t.corners)
    for(int v : c)
      box += t.points[v].bbox();
  const double diagonal = std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
  const double mean_edge = internal::quality_of_quad_mesh(m).mean_edge_length;

  std::size_t samples = 0;
  int hint = -1;
  auto measure = [&](internal::Reference_surface& surface, const Point_3& p, double& largest, double& sum)
  {
    const internal::Reference_surface::Location l = surface.locate(p, hint);
    hint = l.face;
    const double distance = squared_distance(p, l.point);
    largest = (std::max)(largest, std::sqrt(distance) / diagonal);
    sum += distance;
    ++samples;
  };
  double sum = 0;
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    Vector_3 middle(0, 0, 0);
    for(int h = 4 * f; h < 4 * f + 4; ++h)
    {
      const Point_3 &p = m.points[m.source(h)], &q = m.points[m.target(h)];
      measure(reference, p, d.quads_to_reference_max, sum);
      if(m.edge(h) == h)
        measure(reference, midpoint(p, q), d.quads_to_reference_max, sum);
      middle = middle + (p - ORIGIN) / 4;
    }
    measure(reference, ORIGIN + middle, d.quads_to_reference_max, sum);
    const internal::Quad_shape shape = internal::shape_of_quad(m, f);
    d.opposed_quads += shape.normal * reference.normal(hint) < 0 ? 1. / m.number_of_faces() : 0;
  }
  d.quads_to_reference_rms = std::sqrt(sum / samples) / diagonal;

  sum = 0;
  samples = 0;
  hint = -1;
  for(int f = 0; f < t.number_of_faces(); ++f)
  {
    const std::array<int, 3>& c = t.corners[f];
    measure(quads, centroid(t.points[c[0]], t.points[c[1]], t.points[c[2]]), d.reference_to_quads_max, sum);
    for(int v : c)
      if(t.halfedge_of_vertex[v] / 3 == f)
        measure(quads, t.points[v], d.reference_to_quads_max, sum);
  }
  d.reference_to_quads_rms = std::sqrt(sum / samples) / diagonal;

  typedef std::array<Point_3, 2> Segment;
  std::vector<Segment> features, boundary, edges_of_quads, boundary_of_quads;
  for(auto e : edges(tm))
    if(is_border(e, tm) || get(ecm, e))
    {
      const Segment s{{ t.points[get(vim, source(e, tm))], t.points[get(vim, target(e, tm))] }};
      (is_border(e, tm) ? boundary : features).push_back(s);
      (is_border(e, tm) ? d.boundary_length : d.feature_length) += std::sqrt(squared_distance(s[0], s[1])) / mean_edge;
    }
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(m.edge(h) == h)
    {
      const Segment s{{ m.points[m.source(h)], m.points[m.target(h)] }};
      edges_of_quads.push_back(s);
      if(m.is_border(h))
        boundary_of_quads.push_back(s);
    }
  d.features_kept = internal::share_on_edges(features, edges_of_quads, mean_edge);
  d.boundary_kept = internal::share_on_edges(boundary, boundary_of_quads, mean_edge);
  return d;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEVIATION_H
