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
#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A cross field and what a map that follows it has to respect, in flat arrays.
struct Grid_map_problem
{
  Indexed_triangle_mesh mesh;
  std::vector<double> angle;    // per face
  std::vector<int> period_jump; // per edge, oriented as its halfedge
  std::vector<int> quarters;    // per vertex: the right angles around it in the map, -1 where any number will do
  std::vector<bool> is_aligned; // per edge: it has to lie on a grid line
  std::vector<double> sizing;   // per face: the target edge length
  std::vector<double> weight;   // per face: of its part of the energy
  std::vector<bool> is_node;    // per vertex: it has to lie on a grid point, singular or not

  explicit Grid_map_problem(Indexed_triangle_mesh m)
    : mesh(std::move(m))
    , angle(mesh.number_of_faces())
    , period_jump(mesh.number_of_edges())
    , quarters(mesh.number_of_vertices())
    , is_aligned(mesh.number_of_edges())
    , sizing(mesh.number_of_faces())
    , weight(mesh.number_of_faces(), 1.)
    , is_node(mesh.number_of_vertices(), false)
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

// The seamless map along a field [Bom12, 8.4], and integer-grid maps made of it.
class Grid_map_solver
{
public:
  CGAL_QUAD_MESHING_INLINE Grid_map_solver(Grid_map_problem problem, const Grid_map_options& options);
  CGAL_QUAD_MESHING_INLINE Grid_map_solver(Grid_map_solver&& other);
  CGAL_QUAD_MESHING_INLINE ~Grid_map_solver();

  // Computes the seamless map and fills in the figures of the result. Returns VALID if there is one.
  CGAL_QUAD_MESHING_INLINE Integer_grid_map_status solve(Any_visitor& visitor, Integer_grid_map_result& result);

  // The area of the image of the seamless map for the lengths that the problem asks for.
  CGAL_QUAD_MESHING_INLINE double area() const;

  // How far the seamless map is from a similarity, see `Seamless_map::distortion()`.
  CGAL_QUAD_MESHING_INLINE double distortion() const;

  // Rounds a multiple of the seamless map, for these multiples of the lengths, and fills in the figures of the result.
  // Without repairs, it gives up where the integers of the least energy put two things onto each other.
  // `uv` gets the image of the source of every halfedge in the chart of its face, if the status is VALID or FOLDED.
  CGAL_QUAD_MESHING_INLINE Integer_grid_map_status round(double relative_length, Rounding_method method, bool repairs,
                                                         Any_visitor& visitor, std::vector<std::array<double, 2>>& uv,
                                                         Integer_grid_map_result& result);

  // The T-mesh of the seamless map, with the integers of the last rounding. Before there was one, there is no T-mesh.
  CGAL_QUAD_MESHING_INLINE T_mesh t_mesh(Any_visitor& visitor) const;

  CGAL_QUAD_MESHING_INLINE const Indexed_triangle_mesh& mesh() const;

private:
  struct Data; // known where maps are computed
  std::unique_ptr<Data> m_data;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Parameterization/internal/solve_grid_map_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SOLVE_GRID_MAP_H
