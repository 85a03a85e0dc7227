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
#include <CGAL/Quad_meshing/Fields/Sizing_method.h>
#include <CGAL/Quad_meshing/Guides/Guide_connection.h>
#include <CGAL/Quad_meshing/Guides/Guide_curve.h>
#include <CGAL/Quad_meshing/Guides/Index_guide.h>
#include <CGAL/Quad_meshing/Guides/Size_disc.h>
#include <CGAL/Quad_meshing/Guides/Symmetry_plane.h>
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
  /// \name Sizes
  /// Where the user gives no length for a place, what it adapts to, its bounds, and how fast it may change. If there
  /// are places without a given length, their lengths are scaled until the number of quads is right; else those that
  /// are given are.
  /// @{
  Sizing_method sizing_method = Sizing_method::CONSTANT; ///< where no length is given
  /// The distance allowed between quads and the surface with `Sizing_method::CURVATURE`, in the unit of the points; it
  /// takes precedence over the number of quads. 0: it is chosen for the number of quads.
  double sizing_tolerance = 0;
  double smallest_edge_length = 0;   ///< 0: a quarter of the constant length, and no bound for lengths that are given
  double largest_edge_length = 0;    ///< 0: four times the constant length, and no bound for lengths that are given
  double sizing_gradation = 0.3;     ///< the largest slope of the length along the surface
  std::vector<Size_disc> size_discs; ///< lengths around points
  /// @}

  /// \name Guides
  /// What the user has drawn.
  /// @{
  std::vector<Guide_curve> feature_curves;     ///< become chains of quad edges, besides the feature edges
  std::vector<Guide_stroke> strokes;           ///< the quads follow their direction
  std::vector<Index_guide> index_guides;       ///< where irregular vertices must be or must not be
  std::vector<Guide_connection> connections;   ///< vertices that straight chains of quad edges join
  std::vector<Symmetry_plane> symmetry_planes; ///< orthogonal to each other; the quad mesh is symmetric to them
  /// The largest distance of a vertex, mirrored in a plane of symmetry, from the surface, over the diagonal of the
  /// bounding box: surfaces that differ more from their mirror images are refused.
  double symmetry_tolerance = 0.01;
  /// @}

  /// Whether the quads of sheets meet vertex to vertex where the sheets touch: along edges of the input that have the
  /// same ends in space, as `read_triangle_mesh()` leaves them where more than two faces met at an edge. They become
  /// chains of quad edges, and where the sheets have different numbers of quads there, rows of quads are split. It is
  /// said where sheets cannot meet. Borders have to be aligned.
  bool meet_at_junctions = false;

  double sharpness_angle = 40; ///< in degrees, for the detection of feature edges
  bool align_boundary = true;  ///< whether borders become chains of quad edges
  /// How the singularities of the field are found.
  Cross_field_method cross_field_method = Cross_field_method::POLISHED;
  double rounding_tolerance = 3e-4;    ///< of fields by greedy rounding, as the next three: see `smooth_cross_field()`
  int gauss_seidel_iterations = 20000; ///< local steps per rounding; 0: none
  int conjugate_gradient_iterations = 10; ///< per rounding; 0: none
  bool allow_refactorization = true;      ///< whether there may be new factorizations
  /// How much the quads follow the directions in which the surface bends least (`curvature_directions()`), from 0 to 1.
  double curvature_alignment = 1;
  double singularity_cost = 0.6; ///< what an irregular vertex must save, see `quadrangulate()`
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
