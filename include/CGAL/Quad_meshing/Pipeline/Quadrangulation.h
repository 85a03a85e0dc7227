// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_H
#define CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_result.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Triangle_input.h>
#include <CGAL/Quad_meshing/Pipeline/internal/locate_on_input.h>
#include <CGAL/Quad_meshing/Pipeline/internal/run_quadrangulation.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingRef

\brief The way from a triangle mesh to a quad mesh, with everything that the stages leave behind.

`quadrangulate()` is this class in one call. Use the class to look at the stages: the prepared triangles with their
feature edges, the cross field, the integer-grid map. Each component is quadrangulated by itself, and the results are
joined.

\sa `quadrangulate()`
*/
class Quadrangulation
{
public:
  typedef Quadrangulation_kernel Kernel;
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_quads::Location Location;

  /// what is asked for; may be changed between runs
  Quadrangulation_options options;

  /// copies a triangle mesh. The face of number `i` in `faces(tm)` is the origin `i` of the faces that lie
  /// in it.
  ///
  /// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
  /// \tparam VertexPointMap a model of `ReadablePropertyMap` with a 3D point as value type
  /// \pre `is_triangle_mesh(tm)`
  template <typename TriangleMesh, typename VertexPointMap>
  Quadrangulation(const TriangleMesh& tm, VertexPointMap vpm)
    : m_input(internal::triangle_input(tm, vpm))
    , m_surface(std::make_unique<Quadrangulation_surface>())
    , m_quads(std::make_unique<Quadrangulation_quads>())
  {
  }

  /// says which edges of the triangle mesh are feature edges; none are detected then, and none are dropped.
  template <typename TriangleMesh, typename EdgeIsFeatureMap>
  void set_feature_edges(const TriangleMesh& tm, EdgeIsFeatureMap edge_is_feature)
  {
    m_input.is_feature = internal::marked_sides(tm, edge_is_feature);
  }

  /// says which edges of the triangle mesh become chains of quad edges besides the feature edges, which are detected
  /// all the same.
  template <typename TriangleMesh, typename EdgeIsCurveMap>
  void set_curve_edges(const TriangleMesh& tm, EdgeIsCurveMap edge_is_curve)
  {
    m_input.is_curve = internal::marked_sides(tm, edge_is_curve);
  }

  /// gives the field directions in some faces. The value type of the map is an optional vector: `std::optional` or
  /// `boost::optional`.
  template <typename TriangleMesh, typename FaceDirectionMap>
  void set_directions(const TriangleMesh& tm, FaceDirectionMap face_direction)
  {
    internal::set_directions(tm, face_direction, m_input);
  }

  /// gives the length of quad edges per face, in the unit of the points; 0 or less: no wish there.
  template <typename TriangleMesh, typename FaceSizingMap>
  void set_face_lengths(const TriangleMesh& tm, FaceSizingMap face_length)
  {
    internal::set_face_lengths(tm, face_length, m_input);
  }

  /// gives the length of quad edges per vertex, in the unit of the points; 0 or less: no wish in the faces around. In
  /// faces it is linear.
  template <typename TriangleMesh, typename VertexSizingMap>
  void set_vertex_lengths(const TriangleMesh& tm, VertexSizingMap vertex_length)
  {
    internal::set_vertex_lengths(tm, vertex_length, m_input);
  }

  /// runs all the stages, anew if they ran before. If the visitor stops them, what they left behind is empty.
  template <typename Visitor>
  Quadrangulation_result run(Visitor& visitor)
  {
    internal::Visitor_adaptor<Visitor> any_visitor(visitor);
    return internal::run_quadrangulation(m_input, options, any_visitor, m_surface, m_quads);
  }

  /// runs all the stages.
  Quadrangulation_result run()
  {
    Default_visitor visitor;
    return run(visitor);
  }

  /// returns the triangles with field and map, as the last run left them.
  const Quadrangulation_surface& surface() const { return *m_surface; }

  /// returns the quad mesh, as the last run left it.
  const Quadrangulation_quads& quads() const { return *m_quads; }

  /// returns where a vertex of the quad mesh lies on the input: the number of a face, and the weights of its corners.
  std::pair<std::size_t, std::array<double, 3>> location_on_input(Mesh::Vertex_index v) const
  {
    return internal::locate_on_input(m_input, *m_quads, v);
  }

private:
  internal::Triangle_input m_input;
  std::unique_ptr<Quadrangulation_surface> m_surface;
  std::unique_ptr<Quadrangulation_quads> m_quads;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_H
