// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_SURFACE_LAYOUT_H
#define CGAL_QUAD_MESHING_LAYOUT_SURFACE_LAYOUT_H

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief is the shape of the charts onto which the patches of a layout are mapped.
 */
enum class Layout_chart
{
  AUTOMATIC,    ///< a quadrilateral if at least half the length of the border of the patch is sharp or border of the
                ///< mesh, a rectangle otherwise
  UNIT,         ///< the unit square
  RECTANGLE,    ///< a rectangle: two degrees of freedom
  QUADRILATERAL ///< any convex quadrilateral: five degrees of freedom
};

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief is a partition of a surface into patches with four corners, to be drawn on a triangle mesh.
 *
 * The nodes of a layout are places on the surface, its arcs are paths between nodes. Each patch has four sides, and a
 * side is a chain of one or more arcs. A node between two arcs of a side is a T-vertex of the patch. An arc that
 * belongs to one patch only lies on the border of the mesh.
 *
 * The type holds what its user says; whether it is a layout of a given mesh is found out by `quadrangulate_layout()`.
 */
struct Surface_layout
{
  /// the number of what does not exist.
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// is a place on the surface.
  struct Place
  {
    std::array<double, 3> point = { { 0, 0, 0 } }; ///< the point of the surface nearest to this one is meant
    std::size_t vertex = none; ///< unless a vertex is named here, by its number in the order of the mesh
  };

  /// is a path on the surface between two nodes.
  struct Arc
  {
    std::size_t source = none; ///< the node where it begins
    std::size_t target = none; ///< the node where it ends
    std::vector<Place> way;    ///< places that it passes through, in this order; between them it is as short as the
                               ///< arcs drawn before it allow
    bool is_aligned = false;   ///< whether it must be represented by edges of the quad mesh
    double edge_length = 0;    ///< target length of the quad edges along it; 0: the one of all arcs
  };

  /// is an arc as a part of a side.
  struct Side_arc
  {
    std::size_t arc = none; ///< its number
    bool is_forward = true; ///< whether the side runs along it from its source to its target
  };

  /// is a patch. Its sides run counterclockwise around it, each from one corner to the next one.
  struct Patch
  {
    std::array<std::vector<Side_arc>, 4> sides;   ///< the arcs of its sides
    Layout_chart chart = Layout_chart::AUTOMATIC; ///< the shape of its chart
  };

  std::vector<Place> nodes;   ///< the nodes
  std::vector<Arc> arcs;      ///< the arcs
  std::vector<Patch> patches; ///< the patches. If there are none, the arcs tell them: each region that they cut out of
                              ///< the surface is one, and the four nodes with the smallest inner angles are its corners
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_SURFACE_LAYOUT_H
