// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_OPTIONS_H
#define CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_OPTIONS_H

#include <CGAL/Quad_meshing/Fields/Cross_field_result.h>
#include <CGAL/Quad_meshing/Mixed_integer/Rounding_method.h>
#include <CGAL/Quad_meshing/Pipeline/Grid_map_plan.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingRef

\brief What a quadrangulation is asked for. The named parameters of `quadrangulate()` have the same names and defaults.
*/
struct Quadrangulation_options
{
  double target_edge_length = 0;        ///< in the unit of the points; 0: from `target_number_of_quads` and the area
  double target_number_of_quads = 4000; ///< counts only where `target_edge_length` is 0
  double sharpness_angle = 40;          ///< in degrees, for the detection of feature edges
  bool align_boundary = true;           ///< whether borders become chains of quad edges
  /// How the singularities of the field are found.
  Cross_field_method cross_field_method = Cross_field_method::POLISHED;
  double rounding_tolerance = 3e-4;    ///< of fields by greedy rounding, as the next three: see `smooth_cross_field()`
  int gauss_seidel_iterations = 20000; ///< local steps per rounding; 0: none
  int conjugate_gradient_iterations = 10; ///< per rounding; 0: none
  bool allow_refactorization = true;      ///< whether there may be new factorizations
  /// How much the quads follow the directions in which the surface bends least (`curvature_directions()`), from 0 to 1.
  double curvature_alignment = 1;
  /// Whether field and map are made on the triangles of the input instead of a working mesh (`make_working_mesh()`).
  bool work_on_input = false;
  Rounding_method rounding_method = Rounding_method::GREEDY; ///< how the integers of the map are chosen
  double anisotropy_weight = 1;                              ///< the weight of lengths against directions, in (0, 1]
  bool optimize_structure = false; ///< whether `optimize_quad_structure()` makes the base complex coarser
  bool semi_regular = false; ///< whether the structure is optimized, and the quads made anew along the base complex
  unsigned int smoothing_iterations = 20; ///< largest number of steps of the final smoothing; 0 smooths nothing
  unsigned int number_of_threads = 1;     ///< that may work at the same time; the result does not depend on it
  unsigned int random_seed = 0;           ///< of the plan "other length"
  /// In seconds of wall-clock time. The best mesh that was found until then is the result, if there is one.
  double maximum_running_time = (std::numeric_limits<double>::infinity)();
  /// What is tried, in this order, until a map is without fold-overs and the mesh as asked for.
  std::vector<Grid_map_plan_rule> plans = default_grid_map_plans();

  /// \name Names of Elements
  /// What messages call the face or the vertex of a number of the input, which counts from 0 in the order of the
  /// iterators. A program that has read the input from a file gives the numbers of the file here (`File_numbers`).
  /// @{
  std::function<std::string(std::size_t)> face_name;   ///< empty: `face 7`
  std::function<std::string(std::size_t)> vertex_name; ///< empty: `vertex 7`
  /// @}
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_QUADRANGULATION_OPTIONS_H
