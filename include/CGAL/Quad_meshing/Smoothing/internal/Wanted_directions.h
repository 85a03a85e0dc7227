// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_WANTED_DIRECTIONS_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_WANTED_DIRECTIONS_H

#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Indexed_reference.h>
#include <CGAL/Quad_meshing/internal/Quad_shape.h>
#include <CGAL/Quad_meshing/internal/Reference_surface.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Which directions the edges of quads should have, and how much that counts: on the reference, or on triangles that lie
// near it and are as fine as the field is that the directions come from.
class Wanted_directions
{
  typedef Indexed_quad_mesh::Point_3 Point_3;
  typedef Indexed_quad_mesh::Vector_3 Vector_3;

public:
  Wanted_directions(Indexed_directions directions, Reference_surface& reference)
    : m_own(directions.mesh.number_of_faces() > 0 ? new Reference_surface(std::move(directions.mesh)) : nullptr)
    , m_surface(m_own ? *m_own : reference)
    , m_direction(std::move(directions.direction))
    , m_weight(std::move(directions.weight))
  {
  }

  struct Wish
  {
    Vector_3 direction; // unit, orthogonal to the normal that is asked for
    double weight;
  };

  // The place of a point: the nearest one, or the one downhill from a place nearby.
  int locate(const Point_3& p, int hint) const { return m_surface.locate(p, hint).face; }
  int walk(const Point_3& p, int start) const { return m_surface.walk(p, start).face; }

  // What is wanted of a quad with this normal. On the other side of a thin part nothing is.
  Wish at(int place, const Vector_3& normal) const
  {
    const Wish nothing{ Vector_3(0, 0, 0), 0 };
    if(!(m_surface.normal(place) * normal > least_cosine))
      return nothing;
    const Vector_3& d = m_direction[place];
    const Wish wish{ unit_or_zero(d - (d * normal) * normal), m_weight[place] };
    return wish.direction == NULL_VECTOR ? nothing : wish;
  }

private:
  static constexpr double least_cosine = 0.5; // of the angle between a quad and the triangle below it

  std::unique_ptr<Reference_surface> m_own;
  Reference_surface& m_surface;
  const std::vector<Vector_3> m_direction; // per face
  const std::vector<double> m_weight;      // per face
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_WANTED_DIRECTIONS_H
