// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_ACCEPTED_SHAPE_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_ACCEPTED_SHAPE_H

#include <CGAL/Quad_meshing/Smoothing/Quad_mesh_smoothing_result.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The shape of quads that a better structure may cost, measured by that of the input: not more folded and inverted
// quads, and a minimal scaled Jacobian that is not far below.
class Accepted_shape
{
public:
  // Shares of the minimal scaled Jacobian of the input below which a mesh is not accepted, and above which none with
  // better quads is looked for; nor is it above the number that follows.
  static constexpr double least_share = 0.5, good_share = 0.8, good_jacobian = 0.5;

  // Accepts everything.
  Accepted_shape() = default;

  // What is `coarse` may have bad quads, but not more folded and inverted ones.
  Accepted_shape(const Quad_mesh_smoothing_result& input, bool coarse)
    : m_is_limited(true)
    , m_most_folded(input.folded_quads_before)
    , m_most_inverted(input.quality_before.number_of_inverted_quads)
  {
    const double jacobian = input.quality_before.minimal_scaled_jacobian;
    if(jacobian > 0 && !coarse)
      m_least_jacobian = least_share * jacobian;
    m_good_jacobian = (std::min)(good_jacobian, good_share * jacobian);
  }

  bool accepts(const Quad_mesh_smoothing_result& r) const
  {
    return r.status == Quad_mesh_status::SUCCESS &&
           (!m_is_limited ||
            (r.folded_quads_after <= m_most_folded && r.quality_after.number_of_inverted_quads <= m_most_inverted &&
             r.quality_after.minimal_scaled_jacobian >= m_least_jacobian));
  }

  // Of what is accepted.
  bool is_good(const Quad_mesh_smoothing_result& r) const
  {
    return !m_is_limited || r.quality_after.minimal_scaled_jacobian >= m_good_jacobian;
  }

private:
  bool m_is_limited = false;
  std::size_t m_most_folded = 0, m_most_inverted = 0;
  double m_least_jacobian = -1, m_good_jacobian = -1; // a scaled Jacobian is at least -1
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_ACCEPTED_SHAPE_H
