// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_LAYOUT_DISTORTION_H
#define CGAL_QUAD_MESHING_LAYOUT_LAYOUT_DISTORTION_H

#include <CGAL/Quad_meshing/Layout/Motorcycle_complex.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// How much the quads of a mesh must be sheared and stretched at least for the arcs of its motorcycle complex to get
// other lengths.
//
// The new mesh is a map of the old one to other integer coordinates in each rectangle. One such map takes each arc
// linearly to its new length and interpolates in between; all others differ from it by displacements that rotate with
// the coordinates from rectangle to rectangle and vanish at the irregular vertices. The displacements that leave the
// least distortion solve a linear system whose right side is linear in the lengths. So the least distortion is a
// quadratic form of the lengths, which is set up once; then a layout takes no more than a product with a matrix.
//
// A map with the Jacobian ((a, b), (c, d)) is conformal if a = d and b = -c, and then the corners of the quads stay
// right.
class Layout_distortion
{
public:
  // What is added to the diagonal, relative to a weight: a component without irregular vertices may move as a whole.
  static constexpr double regularization = 1e-8;

  // `mesh` and `complex` are needed during the construction only. If the visitor asks for an end, the object is of no
  // use.
  CGAL_QUAD_MESHING_INLINE
  Layout_distortion(const Indexed_quad_mesh& mesh, const Motorcycle_complex& complex, const Quad_vertex_rules& rules,
                    const std::vector<char>& is_fixed, Any_visitor& visitor);
  CGAL_QUAD_MESHING_INLINE Layout_distortion(Layout_distortion&& other);
  CGAL_QUAD_MESHING_INLINE ~Layout_distortion();

  // The least mean squared distortion of the corners, when the arcs get these lengths, at the scale at which it is
  // least.
  CGAL_QUAD_MESHING_INLINE double operator()(const std::vector<int>& length) const;

  // The prices of making arcs longer: the derivative of the distortion, without what the equal lengths of opposite
  // sides leave open, relative to its mean absolute value.
  CGAL_QUAD_MESHING_INLINE std::vector<double> prices(const std::vector<int>& length) const;

private:
  struct Form;
  std::unique_ptr<Form> m_form;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Layout/internal/Layout_distortion_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_LAYOUT_LAYOUT_DISTORTION_H
