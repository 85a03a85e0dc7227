// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_SOLVE_FIELD_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_SOLVE_FIELD_H

#include <CGAL/Quad_meshing/Fields/Cross_field_result.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

struct Field_options
{
  Cross_field_method method = Cross_field_method::POLISHED;
  double target_edge_length = 0; // 0: none
  double singularity_cost = 0;   // see `smooth_cross_field()`
  int number_of_bound_rounds = 0;
  // Of greedy rounding, with the defaults of `solve_mixed_integer()`.
  double rounding_tolerance = 3e-4;
  int gauss_seidel_iterations = 20000;
  int conjugate_gradient_iterations = 10;
  bool allow_refactorization = true;
};

// Computes a smooth cross field [Bom12, 8.2] and fills in the figures of the result.
CGAL_QUAD_MESHING_INLINE Cross_field_status solve_field(const Field_problem& problem, const Field_options& options,
                                                        Any_visitor& visitor, Cross_field& field,
                                                        Cross_field_result& result);

// The index of every vertex in quarters: 4, or 2 on the border, minus the quads of its whole fan.
CGAL_QUAD_MESHING_INLINE std::vector<int> field_indices(const Field_problem& problem, const Cross_field& field);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Fields/internal/solve_field_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_SOLVE_FIELD_H
