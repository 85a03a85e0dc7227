// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_EMBEDDED_LAYOUT_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_EMBEDDED_LAYOUT_H

#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_topology.h>
#include <CGAL/Quad_meshing/Layout/internal/Split_surface.h>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A layout drawn on a surface: all arcs are chains of edges, and each patch is a disc of triangles.
struct Embedded_layout
{
  Surface_layout layout; // with patches
  Layout_topology topology;
  Split_surface surface;
  std::vector<int> vertex_of_node;
  std::vector<std::vector<int>> chain;  // per arc: its vertices, from source to target
  std::vector<std::vector<int>> border; // per direction: the halfedges along it, empty where there is no patch
  std::vector<int> patch;               // per face

  // `is_feature` is per halfedge of the input.
  Embedded_layout(const Indexed_triangle_mesh& input, const std::vector<char>& is_feature, const Surface_layout& l)
    : layout(l), surface(input, is_feature)
  {
  }

  const Indexed_triangle_mesh& mesh() const { return surface.mesh; }
  int number_of_arcs() const { return static_cast<int>(layout.arcs.size()); }
  int number_of_patches() const { return static_cast<int>(layout.patches.size()); }

  double edge_length(int h) const { return std::sqrt(mesh().vector(h).squared_length()); }

  double arc_length(int arc) const
  {
    double sum = 0;
    for(std::size_t i = 0; i + 1 < chain[arc].size(); ++i)
      sum += std::sqrt((mesh().points[chain[arc][i + 1]] - mesh().points[chain[arc][i]]).squared_length());
    return sum;
  }

  // What messages call a place.
  static std::string place_name(const Indexed_triangle_mesh::Point_3& p)
  {
    return "(" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) + ")";
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_EMBEDDED_LAYOUT_H
