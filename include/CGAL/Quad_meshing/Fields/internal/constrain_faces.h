// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_CONSTRAIN_FACES_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_CONSTRAIN_FACES_H

#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the default map of directions returns: nothing.
struct No_direction
{
};

template <typename FaceDescriptor>
struct No_face_direction
{
  typedef FaceDescriptor key_type;
  typedef No_direction value_type;
  typedef No_direction reference;
  typedef boost::readable_property_map_tag category;

  friend No_direction get(const No_face_direction&, const key_type&) { return No_direction(); }
};

inline void constrain_face(Field_problem&, int, No_direction, double) {}

// Gives face f a direction, projected to its plane, unless it has one already: a soft one, unless its weight is
// infinite. Directions that are orthogonal to the face, and faces without a normal, are skipped.
template <typename OptionalVector_3>
void constrain_face(Field_problem& problem, int f, const OptionalVector_3& direction, double weight)
{
  if(!direction || problem.constrained[f] || !(weight > 0))
    return;
  const Indexed_triangle_mesh::Vector_3 d(to_double(direction->x()), to_double(direction->y()),
                                          to_double(direction->z()));
  const std::array<int, 3>& c = problem.mesh.corners[f];
  const std::array<Indexed_triangle_mesh::Point_3, 3> p = { { problem.mesh.points[c[0]], problem.mesh.points[c[1]],
                                                              problem.mesh.points[c[2]] } };
  Indexed_triangle_mesh::Vector_3 x, y;
  if(!triangle_axes(p, x, y))
    return;
  // A direction this close to the normal (relative to its length) has no reliable projection.
  const double smallest_projection = 1e-6;
  const double a = d * x, b = d * y;
  if(!(std::hypot(a, b) > smallest_projection * std::sqrt(d.squared_length())))
    return;
  if(std::isinf(weight))
  {
    problem.constrained[f] = 1;
    problem.given_angle[f] = std::atan2(b, a);
    return;
  }
  problem.soft_angle.resize(problem.mesh.number_of_faces(), 0.);
  problem.soft_weight.resize(problem.mesh.number_of_faces(), 0.);
  problem.soft_angle[f] = std::atan2(b, a);
  problem.soft_weight[f] = weight;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_CONSTRAIN_FACES_H
