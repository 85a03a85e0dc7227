// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_STATE_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_STATE_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A quad mesh, with what operators have to respect and to carry along.
struct Structure_state
{
  Indexed_quad_mesh mesh;
  std::vector<char> is_fixed;     // per vertex: must not move, nor be merged with a special one
  std::vector<char> has_failed;   // per face: the removal of the helix that begins here failed
  std::vector<int> face_of;       // per face of the mesh before the last operator: its face now, or -1
  std::vector<int> vertex_origin; // per vertex: its number in the input
  std::vector<int> face_origin;   // per face: its number in the input; corners are numbered as there
};

inline Structure_state initial_structure_state(Indexed_quad_mesh mesh, std::vector<char> is_fixed)
{
  Structure_state s;
  s.mesh = std::move(mesh);
  s.is_fixed = std::move(is_fixed);
  s.has_failed.assign(s.mesh.number_of_faces(), 0);
  s.vertex_origin.resize(s.mesh.number_of_vertices());
  std::iota(s.vertex_origin.begin(), s.vertex_origin.end(), 0);
  s.face_origin.resize(s.mesh.number_of_faces());
  std::iota(s.face_origin.begin(), s.face_origin.end(), 0);
  return s;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_STATE_H
