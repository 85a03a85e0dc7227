// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERS_H
#define CGAL_QUAD_MESHING_PARAMETERS_H

// The named parameters of the package, in one list: one line each, `tag type, tag, name`.
//
// CGAL offers no extension point for the parameters of other packages (a chain of CGAL's own
// parameters only knows CGAL's names), so the chain of this package starts with one of the
// names below and carries a link type of its own; from there on CGAL's names and ours can follow
// in any order: `parameters::target_edge_length(0.1).vertex_point_map(vpm).align_boundary(true)`.

// clang-format off

// What they mean. The functions document which of them they take and may have other defaults.
//
// Size and alignment of the quads
//   target_edge_length              double        length of a quad edge, in the unit of the points; default: from the
//                                                 number of quads in quadrangulate(), mean edge length in
//                                                 integer_grid_map()
//   target_number_of_quads          number        about how many quads there should be; 4000
//   align_boundary                  bool          whether the border becomes chains of quad edges; true
//   face_direction_map              property map  face -> optional vector that the cross field follows; none
//   face_direction_weight_map       property map  face -> weight of that vector, infinite: hard; all hard
//   curvature_alignment             double        how much quads follow the directions of least curvature, 0 to 1; 1
//   singularity_cost                double        what an irregular vertex must save to be worth while, in units of
//                                                 the energy of cross fields; 0, in quadrangulate() 0.6
//   work_on_input                   bool          whether field and map are made on the triangles of the input instead
//                                                 of a working mesh; false
//   face_sizing_map                 property map  face -> target edge length, before target_edge_length; constant
//   vertex_sizing_map               property map  vertex -> target edge length; constant
//   sizing_method                   Sizing_method  what lengths adapt to where none is given; CONSTANT
//   sizing_tolerance                double        distance allowed between quads and the surface, for lengths that
//                                                 adapt to the curvature; chosen for the number of quads
//   smallest_edge_length            double        bound of the lengths; a quarter of the constant length
//   largest_edge_length             double        bound of the lengths; four times the constant length
//   size_discs                      range         of Size_disc: lengths around points; none
//   sizing_gradation                double        largest slope of the target edge length; 0.3
//   minimum_anisotropy              double        relative difference of the absolute principal curvatures, 0 to 1,
//                                                 from which on a disk counts as parabolic; 0.8
//
// Guides
//   feature_curves                  range         of Guide_curve: polylines that become chains of quad edges; none
//   edge_is_curve_map               property map  edge -> bool: edges that become chains of quad edges besides the
//                                                 sharp ones that are detected; none
//   strokes                         range         of Guide_stroke: polylines that quads follow in direction; none
//   symmetry_planes                 range         of Symmetry_plane: planes that the quad mesh is symmetric to; none
//   symmetry_tolerance              double        largest distance of a mirrored vertex from the surface, over the
//                                                 diagonal of the bounding box; 0.01
//   index_guides                    range         of Index_guide: where irregular vertices must be or must not be; none
//   prescribed_index_map            property map  vertex -> optional index of the cross field there; none
//
// Cross fields and integer-grid maps
//   cross_field_method              Cross_field_method  how period jumps are found; POLISHED
//   anisotropy_weight               double        weight of the length of quads against their direction, in (0, 1]; 1
//   stiffening_iterations           unsigned int  how often the energy may be weighted anew where triangles are
//                                                 distorted, as long as there are folded ones; 5
//   number_of_threads               unsigned int  how many threads may work at the same time, results do not depend on
//                                                 it; 1
//   input_face_map                  property map  receives working vertex -> a face of the input near it; none
//   face_location_map               property map  receives quad vertex -> its place on the input mesh; none
//
// Mixed-integer problems
//   rounding_method                 Rounding_method  how integer conditions are met; GREEDY, BRANCH_AND_BOUND
//                                                 where there are inequalities
//   elimination_order               Elimination_order  which equality constraint is eliminated next;
//                                                 FEWEST_COEFFICIENTS
//   elimination_pivot               Elimination_pivot  which of its variables goes with it; FEWEST_CONSTRAINTS
//   constraint_tolerance            double        relative size of what counts as zero when constraints depend on each
//                                                 other; 1e-6
//   rounding_tolerance              double        accuracy of the iterative levels of greedy rounding, in units of the
//                                                 variables; 3e-4
//   gauss_seidel_iterations         int           local steps per rounding, 0 switches the level off; 20000
//   conjugate_gradient_iterations   int           steps per rounding, 0 switches the level off; 10
//   allow_refactorization           bool          whether greedy rounding may factorize anew between its
//                                                 roundings; true
//   simultaneous_rounding           bool          whether greedy rounding takes several integers at once while their
//                                                 deviations sum up to less than one half; true
//   maximum_dense_integers          int           up to so many integers a dense complement over them is used; 1000
//   number_of_bound_rounds          int           rounds of the relaxation that raises a lower bound; 0
//   maximum_number_of_nodes         double        nodes of a search after which the best solution so far is taken; 1e8
//   relative_gap_tolerance          double        relative gap of energy and bound at which a search ends; 1e-9
//   subproblem_selection            Subproblem_selection  order of the subproblems of branch-and-bound; BEST_BOUND
//   branching_rule                  Branching_rule  variable that branch-and-bound splits; PSEUDO_COSTS
//
// Reading
//   repair                          bool or Mesh_repairs  the repairs that read_triangle_mesh() may make; true: all
//
// Geodesic distances
//   distance_limit                  double        distances beyond it need not be right; infinity
//   target_vertices                 range, by std::cref  the computation ends when their distances are known; all
//   relative_distance_error         double        part of a distance by which it may be wrong; 0
//   keep_windows                    bool          false saves memory and leaves distances at vertices only; true
//
// Structure of quad meshes
//   optimize_structure              bool          whether quadrangulate() makes the base complex coarser; false
//   semi_regular                    bool          whether quadrangulate() makes the mesh anew on the input along its
//                                                 base complex, after the optimization of the structure; false
//   structure_method                Structure_method  how the structure is optimized; LAYOUT
//   merge_singularities             bool          whether irregular vertices may be merged with each other and moved
//                                                 onto constrained edges; false
//   collapse_dual_curves            bool          whether dual curves are collapsed in the end where they can be; false
//   target_number_of_patches        std::size_t   the optimization ends when there are no more patches; 0: no target
//   smoothing_iterations            unsigned int  steps or sweeps of the smoothing in the end, 0 smooths nothing; 20
//   smooth_globally                 bool          whether smooth_quad_mesh() moves all vertices at once, where they
//                                                 have to go far; false
//   operator_step_cost              function object  positive cost of a step of an operator; 1 for every step
//
// Layouts
//   layout_chart                    Layout_chart  the kind of all charts of a layout; AUTOMATIC: what its patches say
//   arc_alignment                   Arc_alignment  the arcs of a layout that quad edges represent; FEATURES
//   mean_value_weights              bool          whether a layout is parameterized with mean value weights instead of
//                                                 discrete harmonic ones; false
//   least_squares_alignment         bool          whether all equations at aligned arcs hold in the sense of least
//                                                 squares instead of those along the arcs exactly; false

#include <CGAL/Named_function_parameters.h>

#define CGAL_QUAD_MESHING_NAMED_PARAMETERS                                                          \
  CGAL_add_named_parameter(target_edge_length_t, target_edge_length, target_edge_length)            \
  CGAL_add_named_parameter(target_number_of_quads_t, target_number_of_quads, target_number_of_quads) \
  CGAL_add_named_parameter(optimize_structure_t, optimize_structure, optimize_structure)            \
  CGAL_add_named_parameter(semi_regular_t, semi_regular, semi_regular)                              \
  CGAL_add_named_parameter(number_of_threads_t, number_of_threads, number_of_threads)               \
  CGAL_add_named_parameter(align_boundary_t, align_boundary, align_boundary)                        \
  CGAL_add_named_parameter(rounding_method_t, rounding_method, rounding_method)                     \
  CGAL_add_named_parameter(elimination_order_t, elimination_order, elimination_order)               \
  CGAL_add_named_parameter(elimination_pivot_t, elimination_pivot, elimination_pivot)               \
  CGAL_add_named_parameter(constraint_tolerance_t, constraint_tolerance, constraint_tolerance)      \
  CGAL_add_named_parameter(rounding_tolerance_t, rounding_tolerance, rounding_tolerance)            \
  CGAL_add_named_parameter(gauss_seidel_iterations_t, gauss_seidel_iterations, gauss_seidel_iterations)\
  CGAL_add_named_parameter(conjugate_gradient_iterations_t, conjugate_gradient_iterations,          \
                           conjugate_gradient_iterations)                                           \
  CGAL_add_named_parameter(allow_refactorization_t, allow_refactorization, allow_refactorization)   \
  CGAL_add_named_parameter(simultaneous_rounding_t, simultaneous_rounding, simultaneous_rounding)   \
  CGAL_add_named_parameter(maximum_dense_integers_t, maximum_dense_integers, maximum_dense_integers)\
  CGAL_add_named_parameter(number_of_bound_rounds_t, number_of_bound_rounds, number_of_bound_rounds)\
  CGAL_add_named_parameter(maximum_number_of_nodes_t, maximum_number_of_nodes, maximum_number_of_nodes)\
  CGAL_add_named_parameter(relative_gap_tolerance_t, relative_gap_tolerance, relative_gap_tolerance)\
  CGAL_add_named_parameter(subproblem_selection_t, subproblem_selection, subproblem_selection)      \
  CGAL_add_named_parameter(branching_rule_t, branching_rule, branching_rule)                        \
  CGAL_add_named_parameter(cross_field_method_t, cross_field_method, cross_field_method)            \
  CGAL_add_named_parameter(repair_t, repair, repair)                                                \
  CGAL_add_named_parameter(distance_limit_t, distance_limit, distance_limit)                        \
  CGAL_add_named_parameter(target_vertices_t, target_vertices, target_vertices)                     \
  CGAL_add_named_parameter(relative_distance_error_t, relative_distance_error, relative_distance_error)\
  CGAL_add_named_parameter(keep_windows_t, keep_windows, keep_windows)                              \
  CGAL_add_named_parameter(face_direction_map_t, face_direction_map, face_direction_map)            \
  CGAL_add_named_parameter(face_direction_weight_map_t, face_direction_weight_map, face_direction_weight_map)\
  CGAL_add_named_parameter(curvature_alignment_t, curvature_alignment, curvature_alignment)         \
  CGAL_add_named_parameter(singularity_cost_t, singularity_cost, singularity_cost)                  \
  CGAL_add_named_parameter(work_on_input_t, work_on_input, work_on_input)                           \
  CGAL_add_named_parameter(input_face_map_t, input_face_map, input_face_map)                        \
  CGAL_add_named_parameter(minimum_anisotropy_t, minimum_anisotropy, minimum_anisotropy)            \
  CGAL_add_named_parameter(sizing_gradation_t, sizing_gradation, sizing_gradation)                  \
  CGAL_add_named_parameter(face_sizing_map_t, face_sizing_map, face_sizing_map)                     \
  CGAL_add_named_parameter(vertex_sizing_map_t, vertex_sizing_map, vertex_sizing_map)               \
  CGAL_add_named_parameter(sizing_method_t, sizing_method, sizing_method)                           \
  CGAL_add_named_parameter(sizing_tolerance_t, sizing_tolerance, sizing_tolerance)                  \
  CGAL_add_named_parameter(smallest_edge_length_t, smallest_edge_length, smallest_edge_length)      \
  CGAL_add_named_parameter(largest_edge_length_t, largest_edge_length, largest_edge_length)         \
  CGAL_add_named_parameter(size_discs_t, size_discs, size_discs)                                    \
  CGAL_add_named_parameter(feature_curves_t, feature_curves, feature_curves)                        \
  CGAL_add_named_parameter(edge_is_curve_map_t, edge_is_curve_map, edge_is_curve_map)               \
  CGAL_add_named_parameter(strokes_t, strokes, strokes)                                             \
  CGAL_add_named_parameter(symmetry_planes_t, symmetry_planes, symmetry_planes)                     \
  CGAL_add_named_parameter(symmetry_tolerance_t, symmetry_tolerance, symmetry_tolerance)            \
  CGAL_add_named_parameter(index_guides_t, index_guides, index_guides)                              \
  CGAL_add_named_parameter(prescribed_index_map_t, prescribed_index_map, prescribed_index_map)      \
  CGAL_add_named_parameter(face_location_map_t, face_location_map, face_location_map)               \
  CGAL_add_named_parameter(stiffening_iterations_t, stiffening_iterations, stiffening_iterations)   \
  CGAL_add_named_parameter(structure_method_t, structure_method, structure_method)                  \
  CGAL_add_named_parameter(merge_singularities_t, merge_singularities, merge_singularities)         \
  CGAL_add_named_parameter(collapse_dual_curves_t, collapse_dual_curves, collapse_dual_curves)      \
  CGAL_add_named_parameter(target_number_of_patches_t, target_number_of_patches, target_number_of_patches) \
  CGAL_add_named_parameter(smoothing_iterations_t, smoothing_iterations, smoothing_iterations)      \
  CGAL_add_named_parameter(smooth_globally_t, smooth_globally, smooth_globally)                     \
  CGAL_add_named_parameter(operator_step_cost_t, operator_step_cost, operator_step_cost)            \
  CGAL_add_named_parameter(layout_chart_t, layout_chart, layout_chart)                              \
  CGAL_add_named_parameter(arc_alignment_t, arc_alignment, arc_alignment)                           \
  CGAL_add_named_parameter(mean_value_weights_t, mean_value_weights, mean_value_weights)            \
  CGAL_add_named_parameter(least_squares_alignment_t, least_squares_alignment, least_squares_alignment)\
  CGAL_add_named_parameter(anisotropy_weight_t, anisotropy_weight, anisotropy_weight)

// clang-format on

namespace CGAL {
namespace internal_np {

#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  enum X                                                                                                               \
  {                                                                                                                    \
    Y                                                                                                                  \
  };
CGAL_QUAD_MESHING_NAMED_PARAMETERS
#undef CGAL_add_named_parameter

// One link of a chain that started with a parameter of this package.
template <typename T, typename Tag, typename Base>
struct Quad_meshing_np_link : Named_params_impl<T, Tag, Base>
{
  typedef Named_params_impl<T, Tag, Base> base;

  Quad_meshing_np_link(const T& v) : base(v) {}

  template <typename B>
  Quad_meshing_np_link(const T& v, const B& b) : base(v, b)
  {
  }
};

typedef Quad_meshing_np_link<bool, all_default_t, No_property> Quad_meshing_np_root;

} // namespace internal_np

template <typename T, typename Tag, typename T2, typename Tag2, typename B2>
struct Named_function_parameters<T, Tag, internal_np::Quad_meshing_np_link<T2, Tag2, B2>>
  : internal_np::Named_params_impl<T, Tag, internal_np::Quad_meshing_np_link<T2, Tag2, B2>>
{
  typedef internal_np::Quad_meshing_np_link<T2, Tag2, B2> Base;
  typedef internal_np::Named_params_impl<T, Tag, Base> base;
  typedef internal_np::Quad_meshing_np_link<T, Tag, Base> link;

  // CGAL 6 recognizes a pack of parameters by this type.
  typedef int CGAL_Named_function_parameters_class;

  Named_function_parameters(const T& v, const Base& b) : base(v, b) {}

#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Named_function_parameters<K, internal_np::X, link> Z(const K& k) const                                               \
  {                                                                                                                    \
    return Named_function_parameters<K, internal_np::X, link>(k, link(this->v, static_cast<const Base&>(*this)));      \
  }
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z)
#include <CGAL/STL_Extension/internal/parameters_interface.h>
  CGAL_QUAD_MESHING_NAMED_PARAMETERS
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_extra_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
};

namespace parameters {

#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Named_function_parameters<K, internal_np::X, internal_np::Quad_meshing_np_root> Z(const K& k)                        \
  {                                                                                                                    \
    return Named_function_parameters<K, internal_np::X, internal_np::Quad_meshing_np_root>(                            \
      k, internal_np::Quad_meshing_np_root(true));                                                                     \
  }
CGAL_QUAD_MESHING_NAMED_PARAMETERS
#undef CGAL_add_named_parameter

} // namespace parameters
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERS_H
