// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Plain mistakes of a caller, one for each value of MISTAKE. None compiles, and each ends in one sentence that says
// why; without a mistake, the file compiles.

#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/optimize_quad_structure.h>
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
#elif MISTAKE == 6 // a parameter that another stage takes
  CGAL::Quad_meshing::optimize_quad_structure(qm, CGAL::parameters::smooth_globally(true));
#elif MISTAKE == 7 // a parameter of the quad mesh for its reference
  CGAL::Quad_meshing::smooth_quad_mesh(qm, tm, CGAL::parameters::smooth_globally(true),
                                       CGAL::parameters::smoothing_iterations(3u));
#else
  static_cast<void>(vertex_map), static_cast<void>(vector_map), static_cast<void>(visitor);
  CGAL::Quad_meshing::quadrangulate(
    tm, qm, CGAL::parameters::target_edge_length(1.).sharpness_angle(30.).align_boundary(false));
#endif
}
