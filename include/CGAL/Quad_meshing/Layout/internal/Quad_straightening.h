// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUAD_STRAIGHTENING_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUAD_STRAIGHTENING_H

#include <CGAL/Quad_meshing/Smoothing/Smoothing_reference.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_reference.h>
#include <CGAL/Quad_meshing/internal/Quad_shape.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Straightens quads that are inverted on the surface.
//
// A map without folds does not exclude them: a quad has four points only, and where it is long, the surface bends and
// the map shears, their chords cross. The vertices near such quads move on the surface, all others stay. Where that
// does not suffice, more of them move, in the end all.
class Quad_straightening
{
public:
  // Rings of quads around an inverted one whose vertices move at first, and the factor from one attempt to the next.
  static constexpr int first_rings = 2, factor = 3;
  static constexpr int attempts = 3;
  static constexpr unsigned int sweeps = 20;

  // `may_not_move` is per vertex. The feature edges of the quads must lie on those of the reference, or on its border.
  Quad_straightening(Indexed_quad_mesh& quads, const std::vector<char>& may_not_move,
                     const Indexed_reference& reference)
    : m_quads(quads), m_may_not_move(may_not_move), m_reference(reference)
  {
  }

  // Returns how many quads are inverted in the end. Their number does not rise.
  std::size_t run(Any_visitor& visitor)
  {
    std::vector<int> inverted = inverted_quads();
    for(int i = 0, rings = first_rings; i < attempts && !inverted.empty() && visitor.go_further(); ++i, rings *= factor)
    {
      const std::vector<Indexed_quad_mesh::Point_3> before = m_quads.points;
      Smoothing_reference reference(m_quads, m_reference);
      smooth_indexed_quad_mesh(m_quads, reference, fixed_vertices(inverted, i + 1 == attempts ? -1 : rings),
                               Smoothing_options{ sweeps, i + 1 == attempts }, visitor);
      std::vector<int> now = inverted_quads();
      if(now.size() > inverted.size())
        m_quads.points = before;
      else
        inverted = std::move(now);
    }
    return inverted.size();
  }

private:
  std::vector<int> inverted_quads() const
  {
    std::vector<int> list;
    for(int f = 0; f < m_quads.number_of_faces(); ++f)
    {
      const std::array<int, 4>& c = m_quads.corners[f];
      Shape_vector_3 normal;
      if(!(minimal_scaled_jacobian(m_quads.points[c[0]], m_quads.points[c[1]], m_quads.points[c[2]],
                                   m_quads.points[c[3]], normal) > 0))
        list.push_back(f);
    }
    return list;
  }

  // All but those within so many rings around some quads; with -1 rings, only those that may not move.
  std::vector<char> fixed_vertices(const std::vector<int>& around, int rings) const
  {
    if(rings == -1)
      return m_may_not_move;
    std::vector<char> is_near(m_quads.number_of_vertices(), 0);
    for(int f : around)
      for(int v : m_quads.corners[f])
        is_near[v] = 1;
    for(int r = 0; r < rings; ++r)
    {
      const std::vector<char> before = is_near;
      for(const std::array<int, 4>& c : m_quads.corners)
        if(before[c[0]] || before[c[1]] || before[c[2]] || before[c[3]])
          for(int v : c)
            is_near[v] = 1;
    }
    std::vector<char> is_fixed = m_may_not_move;
    for(std::size_t v = 0; v < is_fixed.size(); ++v)
      is_fixed[v] = is_fixed[v] || !is_near[v];
    return is_fixed;
  }

  Indexed_quad_mesh& m_quads;
  const std::vector<char>& m_may_not_move;
  const Indexed_reference& m_reference;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_QUAD_STRAIGHTENING_H
