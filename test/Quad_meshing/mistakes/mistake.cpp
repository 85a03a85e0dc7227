// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Plain mistakes of a caller, one for each value of MISTAKE. None compiles, and each ends in one sentence that says
// why; without a mistake, the file compiles.

#include <CGAL/Quad_meshing/quadrangulate.h>

#include <functional>

typedef CGAL::Quad_meshing::Quadrangulation_mesh Mesh;

struct Incomplete_visitor
{
  void progress(double) {}
};

void quadrangulate(
  const Mesh& tm, Mesh& qm, Mesh::Property_map<Mesh::Vertex_index, bool> vertex_map,
  Mesh::Property_map<Mesh::Face_index, CGAL::Quad_meshing::Quadrangulation_kernel::Vector_3> vector_map,
  Incomplete_visitor& visitor)
{
#if MISTAKE == 1 // a parameter that the function does not take
  CGAL::Quad_meshing::quadrangulate(tm, qm, CGAL::parameters::target_edge_length(1.).minimum_anisotropy(0.5));
#elif MISTAKE == 2 // a parameter of CGAL that it does not take
  CGAL::Quad_meshing::quadrangulate(tm, qm, CGAL::parameters::number_of_relaxation_steps(3u));
#elif MISTAKE == 3 // a map of vertices instead of edges
  CGAL::Quad_meshing::quadrangulate(tm, qm, CGAL::parameters::edge_is_constrained_map(vertex_map));
#elif MISTAKE == 4 // vectors instead of optional vectors
  CGAL::Quad_meshing::quadrangulate(tm, qm, CGAL::parameters::face_direction_map(vector_map));
#elif MISTAKE == 5 // a visitor without most of its functions
  CGAL::Quad_meshing::quadrangulate(tm, qm, CGAL::parameters::visitor(std::ref(visitor)));
#else
  static_cast<void>(vertex_map), static_cast<void>(vector_map), static_cast<void>(visitor);
  CGAL::Quad_meshing::quadrangulate(
    tm, qm, CGAL::parameters::target_edge_length(1.).sharpness_angle(30.).align_boundary(false));
#endif
}
