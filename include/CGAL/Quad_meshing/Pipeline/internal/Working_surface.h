// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_WORKING_SURFACE_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_WORKING_SURFACE_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Pipeline_visitor.h>
#include <CGAL/Quad_meshing/Working_mesh/make_working_mesh.h>
#include <CGAL/Quad_meshing/internal/Reference_surface.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/AABB_tree.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The triangles that the work on one component is done on, and the way back from them to those of the input.
class Working_surface
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_kernel::Point_3 Point_3;
  typedef Quadrangulation_kernel::Segment_3 Segment_3;

public:
  // `surface`, with the features of the input, becomes the triangles to work on.
  Working_surface(std::unique_ptr<Quadrangulation_surface>& surface, bool border_is_curve)
    : m_surface(surface), m_border_is_curve(border_is_curve)
  {
  }

  // Puts a working mesh in the place of the input. Returns a message if the visitor stopped it, nothing else.
  std::string make(double target_edge_length, Pipeline_visitor& visitor)
  {
    // The vertices of quads are moved by the smoothing too.
    const double largest_distance = 0.2; // in target edge lengths
    // What make_working_mesh() promises for curves, twice, as the input is as far from the chords.
    const double largest_curve_error = 0.2;
    m_largest_distance = largest_distance * target_edge_length;
    m_largest_curve_error = largest_curve_error * target_edge_length;
    m_input = std::move(m_surface);
    m_surface = std::make_unique<Quadrangulation_surface>();
    auto place = m_surface->mesh.add_property_map<Mesh::Vertex_index, Mesh::Face_index>("v:place").first;
    const Working_mesh_result result =
      make_working_mesh(m_input->mesh, target_edge_length, m_surface->mesh,
                        parameters::face_sizing_map(m_input->length)
                          .edge_is_constrained_map(m_input->is_feature)
                          .visitor(std::ref(visitor)),
                        parameters::input_face_map(place).edge_is_constrained_map(m_surface->is_feature));
    if(!result.is_valid())
      return result.message;
    m_reference =
      std::make_unique<Reference_surface>(make_indexed_triangle_mesh(m_input->mesh, parameters::default_values()));
    for(Mesh::Face_index f : m_surface->mesh.faces())
    {
      const Mesh::Halfedge_index h = m_surface->mesh.halfedge(f);
      const Mesh& m = m_surface->mesh;
      const Point_3 c = centroid(m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))));
      m_surface->origin[f] = walk(c, place[m.source(h)]).face;
      m_surface->length[f] = m_input->length[Mesh::Face_index(static_cast<Mesh::size_type>(m_surface->origin[f]))];
    }
    m_surface->mesh.remove_property_map(place);
    find_curves();
    return std::string();
  }

  // Whether the work is done on other triangles than those of the input.
  bool is_made() const { return m_input != nullptr; }

  const Quadrangulation_surface& input() const { return is_made() ? *m_input : *m_surface; }

  // How far the triangles of the work and their curves are from those of the input at most; 0 if they are the input.
  double largest_distance() const { return m_largest_distance; }
  double largest_curve_error() const { return m_largest_curve_error; }

  // The number, in the whole input, of a face at or near a face of the working mesh.
  std::size_t input_face(Mesh::Face_index f) const
  {
    const std::size_t i = m_surface->origin[f];
    return is_made() ? m_input->origin[Mesh::Face_index(static_cast<Mesh::size_type>(i))] : i;
  }

  // Puts the vertices of quads, which lie on the working mesh, onto the input: those of features, and of borders that
  // the quads follow, onto curves of it.
  void move_to_input(Quadrangulation_quads& quads) const
  {
    if(!is_made())
      return;
    std::vector<char> is_on_curve(quads.mesh.number_of_vertices(), 0);
    for(Mesh::Edge_index e : quads.mesh.edges())
      if(quads.is_feature[e] || (m_border_is_curve && quads.mesh.is_border(e)))
        for(int k = 0; k < 2; ++k)
          is_on_curve[quads.mesh.vertex(e, k)] = 1;
    for(Mesh::Vertex_index v : quads.mesh.vertices())
    {
      Point_3& p = quads.mesh.point(v);
      if(is_on_curve[v] && m_curves)
      {
        p = m_curves->closest_point(p);
        continue;
      }
      const Reference_surface::Point_3 q = walk(p, hint(quads.location[v].first)).point;
      p = Point_3(q.x(), q.y(), q.z());
    }
  }

  // Writes for all vertices of quads which face of the input they lie in.
  void locate_on_input(Quadrangulation_quads& quads) const
  {
    for(Mesh::Vertex_index v : quads.mesh.vertices())
    {
      const Mesh::Face_index f = quads.location[v].first;
      quads.input_face[v] =
        is_made() ? input_number(walk(quads.mesh.point(v), hint(f)).face) : std::size_t(m_surface->origin[f]);
    }
  }

  // From here on, the faces of the working mesh have faces of the whole input for their origins.
  void number_origins()
  {
    if(!is_made())
      return;
    for(Mesh::Face_index f : m_surface->mesh.faces())
      m_surface->origin[f] = input_face(f);
    m_reference.reset();
    m_curves.reset();
  }

private:
  typedef AABB_tree<Aabb_traits<Quadrangulation_kernel,
                                Aabb_segment_primitive<Quadrangulation_kernel, std::vector<Segment_3>::const_iterator>>>
    Curve_tree;

  int hint(Mesh::Face_index f) const { return static_cast<int>(m_surface->origin[f]); }

  std::size_t input_number(int f) const { return m_input->origin[Mesh::Face_index(static_cast<Mesh::size_type>(f))]; }

  // The place of a point of the working mesh on the input.
  Reference_surface::Location walk(const Point_3& p, int start) const
  {
    return m_reference->follow(Reference_surface::Point_3(p.x(), p.y(), p.z()), start, m_largest_distance);
  }

  void find_curves()
  {
    const Mesh& m = m_input->mesh;
    for(Mesh::Edge_index e : m.edges())
      if(m_input->is_feature[e] || (m_border_is_curve && m.is_border(e)))
        m_segments.push_back(Segment_3(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1))));
    if(!m_segments.empty())
      m_curves = std::make_unique<Curve_tree>(m_segments.cbegin(), m_segments.cend());
  }

  std::unique_ptr<Quadrangulation_surface>& m_surface;
  const bool m_border_is_curve;                     // of the quads, too
  std::unique_ptr<Quadrangulation_surface> m_input; // null while m_surface is the input
  std::unique_ptr<Reference_surface> m_reference;   // the input
  double m_largest_distance = 0;                    // between the working mesh and the input
  double m_largest_curve_error = 0;                 // between their curves
  std::vector<Segment_3> m_segments;                // of the curves of the input
  std::unique_ptr<Curve_tree> m_curves;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_WORKING_SURFACE_H
