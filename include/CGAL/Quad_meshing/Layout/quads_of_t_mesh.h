// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_QUADS_OF_T_MESH_H
#define CGAL_QUAD_MESHING_LAYOUT_QUADS_OF_T_MESH_H

#include <CGAL/Quad_meshing/Layout/internal/T_mesh_placement.h>
#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingLayoutRef

\brief The quads that a T-mesh with integer lengths stands for.
*/
struct T_mesh_quads
{
  std::vector<T_mesh::Location> vertices;               ///< their places on the triangle mesh
  std::vector<std::array<std::size_t, 4>> quads;        ///< their vertices, counterclockwise
  std::vector<std::array<std::size_t, 2>> aligned_edges; ///< those along features and borders: their vertices
};

/*!
\ingroup PkgQuadMeshingLayoutRef

\brief makes the quads of a T-mesh: in each patch a grid, whose lines are straight in the map from side to side.

Where arcs have length 0, vertices of the T-mesh come together: critical nodes stay where they are, features take what
lies beside them, and other vertices meet in the middle. So quads can be badly shaped there, or folded over; their
vertices have to be moved (`smooth_quad_mesh()`).

\param t the T-mesh
\param lengths the lengths of its arcs, as `quantize_t_mesh()` chooses them

\pre `t` is valid, and the lengths are of `quantize_t_mesh()` for it
*/
inline T_mesh_quads quads_of_t_mesh(const T_mesh& t, const std::vector<int>& lengths)
{
  internal::T_mesh_placement placement(t, lengths);
  T_mesh_quads result;
  result.vertices = placement.locations();
  for(const internal::T_mesh_grid::Quad& q : placement.grid().quads)
  {
    result.quads.emplace_back();
    for(int k = 0; k < 4; ++k)
      result.quads.back()[k] = placement.vertex(q.points[k]);
  }
  for(const auto& e : placement.grid().aligned_edges)
    result.aligned_edges.push_back({ { placement.vertex(e[0]), placement.vertex(e[1]) } });
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_QUADS_OF_T_MESH_H
