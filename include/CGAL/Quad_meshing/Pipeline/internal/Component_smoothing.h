// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_SMOOTHING_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_SMOOTHING_H

#include <CGAL/Quad_meshing/Pipeline/internal/Grid_map_search.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Pipeline_visitor.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Working_surface.h>
#include <CGAL/Quad_meshing/Pipeline/smoothing_directions.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_reference.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The smoothing of the quads of one component on its input: what stays where it is, and the directions that sides keep.
class Component_smoothing
{
  typedef Quadrangulation_mesh Mesh;

public:
  Component_smoothing(const std::unique_ptr<Quadrangulation_surface>& surface, const Working_surface& work,
                      const Quadrangulation_options& options, Pipeline_visitor& visitor)
    : m_surface(surface), m_work(work), m_options(options), m_visitor(visitor)
  {
  }

  // Irregular vertices that the user has placed, and nodes of curves, stay where they are.
  void fix_vertices(const Quadrangulation_quads& quads, const Grid_map_search::Directions& d)
  {
    m_fixed.assign(quads.mesh.number_of_vertices(), 0);
    for(Mesh::Vertex_index v : m_surface->mesh.vertices())
    {
      const bool is_placed = !d.index.empty() && d.index[v] && *d.index[v] != 0 && m_surface->index[v] == *d.index[v];
      if(!is_placed && (d.is_node.empty() || !d.is_node[v]))
        continue;
      const auto is_nearer = [&](Mesh::Vertex_index a, Mesh::Vertex_index b)
      {
        return squared_distance(quads.mesh.point(a), m_surface->mesh.point(v)) <
               squared_distance(quads.mesh.point(b), m_surface->mesh.point(v));
      };
      m_fixed[*std::min_element(quads.mesh.vertices().begin(), quads.mesh.vertices().end(), is_nearer)] = 1;
    }
  }

  // Every vertex may move.
  void fix_nothing(const Quadrangulation_quads& quads) { m_fixed.assign(quads.mesh.number_of_vertices(), 0); }

  // What the smoothing is told: the directions of the field, and how much they count.
  void keep_directions(const Grid_map_search::Directions& d)
  {
    const Smoothing_directions directions = smoothing_directions(*m_surface, d.weight, d.importance);
    m_smoothed_directions = Indexed_directions();
    if(m_work.is_made())
      m_smoothed_directions.mesh = make_indexed_triangle_mesh(m_surface->mesh, parameters::default_values());
    m_smoothed_directions.weight = directions.weight;
    for(const auto& v : directions.direction)
      m_smoothed_directions.direction.push_back(Indexed_triangle_mesh::Vector_3(v->x(), v->y(), v->z()));
  }

  // The input, with these directions.
  template <typename NamedParameters>
  Indexed_reference reference(const NamedParameters& np) const
  {
    Indexed_reference reference = make_indexed_reference<internal_np::face_sizing_map_t>(m_work.input().mesh, np);
    reference.directions = m_smoothed_directions;
    return reference;
  }

  // The vertices stay on their curves, and the fixed ones where they are.
  Quad_mesh_smoothing_result operator()(Quadrangulation_quads& quads) const
  {
    const auto of_quads = parameters::smooth_globally(true)
                            .edge_is_constrained_map(quads.is_feature)
                            .vertex_is_constrained_map(
                              boost::make_iterator_property_map(m_fixed.begin(), get(boost::vertex_index, quads.mesh)))
                            .smoothing_iterations(m_options.smoothing_iterations)
                            .visitor(std::ref(m_visitor));
    const Quadrangulation_surface& input = m_work.input();
    return smooth_quad_mesh_with(
      quads.mesh, of_quads,
      [&](const Indexed_quad_mesh& m)
      {
        return Smoothing_reference(
          m, reference(parameters::face_sizing_map(input.length).edge_is_constrained_map(input.is_feature)));
      });
  }

  static std::string message_of_flat_corners(const Quadrangulation_mesh& quads, const std::vector<std::size_t>& corners)
  {
    std::ostringstream message;
    message << "features meet at an angle of 0 or 180 degrees and leave a quad no room at "
            << (corners.size() == 1 ? "the corner " : std::to_string(corners.size()) + " corners, the first one ")
            << quads.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(corners.front())));
    return message.str();
  }

private:
  const std::unique_ptr<Quadrangulation_surface>& m_surface; // that is worked on
  const Working_surface& m_work;
  const Quadrangulation_options& m_options;
  Pipeline_visitor& m_visitor;
  std::vector<char> m_fixed;                // per vertex of the quads: it stays where it is
  Indexed_directions m_smoothed_directions; // of the field, and how much they count
};

// Vertices that have moved, or that the extraction did not make, lie at the nearest place of the triangles of the
// mesh.
inline void locate_vertices(const Quadrangulation_mesh& mesh, Quadrangulation_quads& quads)
{
  typedef AABB_face_graph_triangle_primitive<Quadrangulation_mesh> Primitive;
  typedef AABB_tree<Aabb_traits<Quadrangulation_kernel, Primitive>> Tree;
  const Tree tree(faces(mesh).first, faces(mesh).second, mesh);
  for(Quadrangulation_mesh::Vertex_index v : quads.mesh.vertices())
    quads.location[v] = Polygon_mesh_processing::locate_with_AABB_tree(quads.mesh.point(v), tree, mesh);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_SMOOTHING_H
