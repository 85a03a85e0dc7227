// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_H
#define CGAL_QUAD_MESHING_H

/// \file CGAL/Quad_meshing.h
/// Convenience header file that includes all public headers of the package.

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Extraction/Quad_extraction_result.h>
#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>
#include <CGAL/Quad_meshing/Extraction/transfer_feature_edges.h>
#include <CGAL/Quad_meshing/Fields/Cross_field_report.h>
#include <CGAL/Quad_meshing/Fields/Cross_field_result.h>
#include <CGAL/Quad_meshing/Fields/Cross_field_sectors.h>
#include <CGAL/Quad_meshing/Fields/Curvature_guide_result.h>
#include <CGAL/Quad_meshing/Fields/Face_frames.h>
#include <CGAL/Quad_meshing/Fields/Feature_edges_result.h>
#include <CGAL/Quad_meshing/Fields/Field_sectors.h>
#include <CGAL/Quad_meshing/Fields/Length_field.h>
#include <CGAL/Quad_meshing/Fields/Sizing_method.h>
#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/cross_field_directions.h>
#include <CGAL/Quad_meshing/Fields/cross_field_indices.h>
#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Fields/local_feature_size.h>
#include <CGAL/Quad_meshing/Fields/salient_directions.h>
#include <CGAL/Quad_meshing/Fields/sizing.h>
#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_field.h>
#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_result.h>
#include <CGAL/Quad_meshing/Geodesics/certify_distances.h>
#include <CGAL/Quad_meshing/Geodesics/isolines.h>
#include <CGAL/Quad_meshing/Geodesics/refine_distance_field.h>
#include <CGAL/Quad_meshing/Guides/Guide_connection.h>
#include <CGAL/Quad_meshing/Guides/Guide_curve.h>
#include <CGAL/Quad_meshing/Guides/Index_guide.h>
#include <CGAL/Quad_meshing/Guides/Polyline_tracer.h>
#include <CGAL/Quad_meshing/Guides/Size_disc.h>
#include <CGAL/Quad_meshing/Guides/Symmetry_plane.h>
#include <CGAL/Quad_meshing/Guides/cut_triangles.h>
#include <CGAL/Quad_meshing/Guides/mirror_triangles.h>
#include <CGAL/Quad_meshing/IO/Attributes_on_mesh.h>
#include <CGAL/Quad_meshing/IO/Flat_json.h>
#include <CGAL/Quad_meshing/IO/Guide_reading_result.h>
#include <CGAL/Quad_meshing/IO/Mesh_attributes.h>
#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>
#include <CGAL/Quad_meshing/IO/Scene.h>
#include <CGAL/Quad_meshing/IO/Scene_writing_result.h>
#include <CGAL/Quad_meshing/IO/find_attribute_borders.h>
#include <CGAL/Quad_meshing/IO/read_mesh_attributes.h>
#include <CGAL/Quad_meshing/IO/read_number_rows.h>
#include <CGAL/Quad_meshing/IO/read_polygon_soup.h>
#include <CGAL/Quad_meshing/IO/read_polylines.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/IO/rosy_field.h>
#include <CGAL/Quad_meshing/IO/scene_layers.h>
#include <CGAL/Quad_meshing/IO/write_grouped_obj.h>
#include <CGAL/Quad_meshing/IO/write_html_page.h>
#include <CGAL/Quad_meshing/IO/write_obj.h>
#include <CGAL/Quad_meshing/IO/write_png_picture.h>
#include <CGAL/Quad_meshing/IO/write_vtk.h>
#include <CGAL/Quad_meshing/Layout/Arc_subdivision.h>
#include <CGAL/Quad_meshing/Layout/Feature_bends.h>
#include <CGAL/Quad_meshing/Layout/Layout_curves.h>
#include <CGAL/Quad_meshing/Layout/Layout_distortion.h>
#include <CGAL/Quad_meshing/Layout/Layout_quadrangulation_result.h>
#include <CGAL/Quad_meshing/Layout/Layout_quantization.h>
#include <CGAL/Quad_meshing/Layout/Layout_realization.h>
#include <CGAL/Quad_meshing/Layout/Layout_weights.h>
#include <CGAL/Quad_meshing/Layout/Motorcycle_complex.h>
#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/Layout/layout_from_quad_mesh.h>
#include <CGAL/Quad_meshing/Layout/layout_from_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/quadrangulate_layout.h>
#include <CGAL/Quad_meshing/Layout/quads_of_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/quantize_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/surface_layout_files.h>
#include <CGAL/Quad_meshing/Linear_algebra/Custom_sparse_cholesky.h>
#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Linear_algebra/Sparse_matrix_view.h>
#include <CGAL/Quad_meshing/Mixed_integer/Feasible_point.h>
#include <CGAL/Quad_meshing/Mixed_integer/Integer_energy.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_problem.h>
#include <CGAL/Quad_meshing/Mixed_integer/Mixed_integer_solution.h>
#include <CGAL/Quad_meshing/Mixed_integer/Rounding_method.h>
#include <CGAL/Quad_meshing/Mixed_integer/find_feasible_point.h>
#include <CGAL/Quad_meshing/Mixed_integer/read_matrix_market.h>
#include <CGAL/Quad_meshing/Mixed_integer/read_mps.h>
#include <CGAL/Quad_meshing/Mixed_integer/solve_mixed_integer.h>
#include <CGAL/Quad_meshing/Parameterization/Integer_grid_map_result.h>
#include <CGAL/Quad_meshing/Parameterization/Seamless_map.h>
#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>
#include <CGAL/Quad_meshing/Parameterization/integer_grid_map.h>
#include <CGAL/Quad_meshing/Parameterization/is_integer_grid_map.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/Grid_map_plan.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_result.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/copy_components.h>
#include <CGAL/Quad_meshing/Pipeline/quadrangulation_layers.h>
#include <CGAL/Quad_meshing/Pipeline/search_grid_map.h>
#include <CGAL/Quad_meshing/Pipeline/smoothing_directions.h>
#include <CGAL/Quad_meshing/Quad_mesh/patch_coordinates.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_deviation.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Quad_mesh/transfer_values.h>
#include <CGAL/Quad_meshing/Smoothing/Quad_mesh_smoothing_result.h>
#include <CGAL/Quad_meshing/Smoothing/Quad_mesh_status.h>
#include <CGAL/Quad_meshing/Smoothing/Smoothing_reference.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/Smoothing/work_on_quad_mesh_copy.h>
#include <CGAL/Quad_meshing/Structure/Quad_structure_optimization_result.h>
#include <CGAL/Quad_meshing/Structure/grid_preserving_operators.h>
#include <CGAL/Quad_meshing/Structure/optimize_quad_structure.h>
#include <CGAL/Quad_meshing/Working_mesh/Working_mesh_result.h>
#include <CGAL/Quad_meshing/Working_mesh/make_working_mesh.h>
#include <CGAL/Quad_meshing/parameters.h>
#include <CGAL/Quad_meshing/quadrangulate.h>

#endif // CGAL_QUAD_MESHING_H
