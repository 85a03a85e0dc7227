// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SOLVE_GRID_MAP_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SOLVE_GRID_MAP_H

#include <CGAL/Quad_meshing/Mixed_integer/Rounding_method.h>
#include <CGAL/Quad_meshing/Parameterization/Integer_grid_map_result.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A cross field and what a map that follows it has to respect, in flat arrays.
struct Grid_map_problem
{
  const Indexed_triangle_mesh& mesh;
  std::vector<double> angle;    // per face
  std::vector<int> period_jump; // per edge, oriented as its halfedge
  std::vector<int> quarters;    // per vertex: the right angles around it in the map, -1 where any number will do
  std::vector<bool> is_aligned; // per edge: it has to lie on a grid line
  std::vector<double> sizing;   // per face: the target edge length

  explicit Grid_map_problem(const Indexed_triangle_mesh& m)
    : mesh(m)
    , angle(m.number_of_faces())
    , period_jump(m.number_of_edges())
    , quarters(m.number_of_vertices())
    , is_aligned(m.number_of_edges())
    , sizing(m.number_of_faces())
  {
  }
};

struct Grid_map_options
{
  Rounding_method rounding_method = Rounding_method::GREEDY;
  double anisotropy_weight = 1;
  unsigned int stiffening_iterations = 5;
  unsigned int number_of_threads = 1;
};

// Computes an integer-grid map [Bom12, 8.4] and fills in the figures of the result. `uv` gets the image of the source
// of every halfedge in the chart of its face, if the status is VALID or FOLDED.
CGAL_QUAD_MESHING_INLINE Integer_grid_map_status solve_grid_map(const Grid_map_problem& problem,
                                                                const Grid_map_options& options, Any_visitor& visitor,
                                                                std::vector<std::array<double, 2>>& uv,
                                                                Integer_grid_map_result& result);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Parameterization/internal/solve_grid_map_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SOLVE_GRID_MAP_H
