// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_LENGTH_FIELD_H
#define CGAL_QUAD_MESHING_FIELDS_LENGTH_FIELD_H

#include <CGAL/Quad_meshing/Fields/Sizing_method.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Lengths of quad edges on a triangle mesh that adapt to it, and to wishes, up to factors that are chosen last: what
// several components have in common.
class Length_field
{
public:
  struct Options
  {
    Sizing_method method = Sizing_method::CONSTANT;
    double constant = 1;              // the length where there is nothing to adapt to
    double tolerance = 0;             // the distance of edges from the surface, for CURVATURE; 0: left to the factor
    double smallest = 0, largest = 0; // bounds; 0: of lengths that adapt, a quarter and four times the constant one
    double gradation = 0.3;
  };

  // `wish`: the length per face; 0 where there is none.
  Length_field(Indexed_triangle_mesh mesh, std::vector<double> wish, const Options& options)
    : m_mesh(std::move(mesh)), m_wish(std::move(wish)), m_options(options)
  {
  }

  // Measures what lengths adapt to; `is_feature` per edge. Returns false if the visitor stops it.
  CGAL_QUAD_MESHING_INLINE bool measure(const std::vector<char>& is_feature, Any_visitor& visitor);

  // The lengths per face: those that are wished for times one factor, the others times another one, within the bounds
  // and with the slope of the options.
  CGAL_QUAD_MESHING_INLINE std::vector<double> lengths(double factor_of_wishes, double factor_of_others) const;

  // The number of quads that lengths stand for.
  CGAL_QUAD_MESHING_INLINE double number_of_quads(const std::vector<double>& lengths) const;

private:
  CGAL_QUAD_MESHING_INLINE double adapted(int f, double factor) const;

  Indexed_triangle_mesh m_mesh;
  std::vector<double> m_wish;
  Options m_options;
  std::vector<double> m_size; // per face: what its length adapts to; empty if it is constant
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Fields/internal/Length_field_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_FIELDS_LENGTH_FIELD_H
