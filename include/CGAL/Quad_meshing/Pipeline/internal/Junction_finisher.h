// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_JUNCTION_FINISHER_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_JUNCTION_FINISHER_H

#include <CGAL/Quad_meshing/Pipeline/internal/Sheet_meeting.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Polygon_mesh_processing/locate.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Puts the quads of a run onto each other where sheets touch: splits dual lines, moves vertices, and smooths around
// them.
class Junction_finisher
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_kernel::Point_3 Point_3;
  typedef std::vector<Quadrangulation_kernel::Triangle_3> Triangles;
  typedef AABB_tree<
    Aabb_traits<Quadrangulation_kernel, AABB_triangle_primitive<Quadrangulation_kernel, Triangles::iterator>>>
    Input_tree;

public:
  std::string unmet; // a sentence without period; empty if all sheets meet

  // `length` is that of quad edges.
  Junction_finisher(const Triangle_input& input, const Junctions& junctions, const Quadrangulation_surface& surface,
                    double length, unsigned int smoothing_iterations, std::unique_ptr<Quadrangulation_quads>& quads)
  {
    const double tolerance = 1e-3 * length; // of vertices on curves, onto which they were put
    const Indexed_quad_mesh before =
      make_indexed_quad_mesh(quads->mesh, get(vertex_point, quads->mesh), quads->is_feature).mesh;
    const Sheet_meeting meeting(before, junctions.curves, tolerance);
    if(meeting.unmet_curves > 0)
      unmet = "the quads of sheets do not meet at " + std::to_string(meeting.unmet_curves) + " of the " +
              std::to_string(junctions.curves.size()) + " curves where these touch";
    if(!meeting.quads)
      return;
    m_quads = std::make_unique<Quadrangulation_quads>();
    copy(meeting.quads->mesh);
    // Vertices around those that are new or were moved make room.
    std::vector<char> is_moved = meeting.is_on_curve;
    for(std::size_t v = before.points.size(); v < is_moved.size(); ++v)
      is_moved[v] = 1;
    project(input, before.points.size(), meeting.is_on_curve);
    if(smoothing_iterations > 0)
      smooth(surface, meeting.quads->mesh, is_moved, smoothing_iterations);
    project(input, before.points.size(), meeting.is_on_curve);
    locate(surface);
    quads = std::move(m_quads);
  }

private:
  void copy(const Indexed_quad_mesh& m)
  {
    Mesh& mesh = m_quads->mesh;
    const auto vertex = [](int v) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(v)); };
    for(const Indexed_quad_mesh::Point_3& p : m.points)
      mesh.add_vertex(Point_3(p.x(), p.y(), p.z()));
    for(const std::array<int, 4>& c : m.corners)
      mesh.add_face(vertex(c[0]), vertex(c[1]), vertex(c[2]), vertex(c[3]));
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      if(m.is_feature[h])
        m_quads->is_feature[mesh.edge(mesh.halfedge(vertex(m.source(h)), vertex(m.target(h))))] = true;
  }

  // Puts new vertices, but those on the curves, onto the input.
  void project(const Triangle_input& input, std::size_t first, const std::vector<char>& is_on_curve)
  {
    if(!m_tree)
    {
      for(const std::array<int, 3>& t : input.triangles)
        m_triangles.emplace_back(input.points[t[0]], input.points[t[1]], input.points[t[2]]);
      m_triangles.erase(
        std::remove_if(m_triangles.begin(), m_triangles.end(), [](const auto& t) { return t.is_degenerate(); }),
        m_triangles.end());
      m_tree = std::make_unique<Input_tree>(m_triangles.begin(), m_triangles.end());
    }
    for(Mesh::Vertex_index v : m_quads->mesh.vertices())
      if((std::size_t(v) >= first || is_free(v)) && !is_on_curve[v])
        m_quads->mesh.point(v) = m_tree->closest_point(m_quads->mesh.point(v));
  }

  bool is_free(Mesh::Vertex_index v) const { return !m_is_fixed.empty() && !m_is_fixed[v]; }

  void smooth(const Quadrangulation_surface& surface, const Indexed_quad_mesh& m, const std::vector<char>& is_moved,
              unsigned int iterations)
  {
    const int rings = 3;
    m_is_fixed.assign(m.points.size(), 1);
    for(std::size_t v = 0; v < is_moved.size(); ++v)
      m_is_fixed[v] = !is_moved[v];
    for(int ring = 0; ring < rings; ++ring)
    {
      const std::vector<char> last = m_is_fixed;
      for(const std::array<int, 4>& c : m.corners)
        if(std::any_of(c.begin(), c.end(), [&](int v) { return !last[v]; }))
          for(int v : c)
            m_is_fixed[v] = 0;
    }
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      if(m.is_feature[h] || m.is_border(h))
        m_is_fixed[m.source(h)] = m_is_fixed[m.target(h)] = 1;
    smooth_quad_mesh(m_quads->mesh, surface.mesh,
                     parameters::smoothing_iterations(iterations)
                       .vertex_is_constrained_map(boost::make_iterator_property_map(
                         m_is_fixed.begin(), get(boost::vertex_index, m_quads->mesh))));
  }

  void locate(const Quadrangulation_surface& surface)
  {
    typedef AABB_face_graph_triangle_primitive<Mesh> Primitive;
    const AABB_tree<Aabb_traits<Quadrangulation_kernel, Primitive>> tree(faces(surface.mesh).first,
                                                                         faces(surface.mesh).second, surface.mesh);
    for(Mesh::Vertex_index v : m_quads->mesh.vertices())
    {
      m_quads->location[v] = Polygon_mesh_processing::locate_with_AABB_tree(m_quads->mesh.point(v), tree, surface.mesh);
      m_quads->input_face[v] = surface.origin[m_quads->location[v].first];
    }
  }

  std::unique_ptr<Quadrangulation_quads> m_quads;
  std::vector<char> m_is_fixed; // per vertex, in the smoothing
  Triangles m_triangles;
  std::unique_ptr<Input_tree> m_tree;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_JUNCTION_FINISHER_H
