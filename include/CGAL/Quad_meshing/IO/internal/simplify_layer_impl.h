// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SIMPLIFY_LAYER_IMPL_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SIMPLIFY_LAYER_IMPL_H

#include <CGAL/Quad_meshing/IO/scene_layers.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Ends the collapses when so many edges are left: the predicate of CGAL for this has other names in other versions.
struct Few_edges_are_left
{
  std::size_t most_edges;

  template <typename FT, typename Profile>
  bool operator()(const FT&, const Profile&, std::size_t, std::size_t current) const
  {
    return current <= most_edges;
  }
};

CGAL_QUAD_MESHING_INLINE void simplify_layer(Scene_layer& layer, std::size_t most_triangles)
{
  namespace PMP = Polygon_mesh_processing;
  namespace SMS = Surface_mesh_simplification;
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;
  typedef Surface_mesh<Point_3> Mesh;

  std::vector<Point_3> points;
  for(const std::array<double, 3>& p : layer.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> triangles;
  for(std::size_t i = 0; i < layer.size(); ++i)
    triangles.emplace_back(layer.corners.begin() + layer.first_corner[i],
                           layer.corners.begin() + layer.first_corner[i + 1]);
  if(!PMP::is_polygon_soup_a_polygon_mesh(triangles))
    return;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  // A closed surface has three edges for two triangles. Short edges go first: this is quick, and what is left is even.
  SMS::edge_collapse(
    mesh, Few_edges_are_left{ most_triangles * 3 / 2 },
    parameters::get_cost(SMS::Edge_length_cost<Mesh>()).get_placement(SMS::Midpoint_placement<Mesh>()));
  mesh.collect_garbage();
  Scene_layer simplified = make_faces_layer(mesh, layer.name, layer.group);
  layer.points = simplified.points;
  layer.corners = simplified.corners;
  layer.first_corner = simplified.first_corner;
  layer.numbers.clear();
  layer.grid.clear();
  layer.colored_by = -1;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SIMPLIFY_LAYER_IMPL_H
