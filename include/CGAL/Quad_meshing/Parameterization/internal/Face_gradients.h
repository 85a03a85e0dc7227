// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_FACE_GRADIENTS_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_FACE_GRADIENTS_H

#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the energies need to know of the triangles: row k of `gradient[f]` is the gradient of the hat function of
// corner k in the frame of the combed field, in units of the target edge length of the face. The Jacobian of a map
// is the sum over the corners of (coordinates of the corner) x (row), and the identity is the ideal. `area[f]` is in
// units of the squared target edge length: the number of quads that the triangle should take.
struct Face_gradients
{
  typedef Eigen::Matrix<double, 3, 2> Gradient;

  std::vector<Gradient> gradient;
  std::vector<double> area;

  Face_gradients(const Combed_charts& charts, const std::vector<double>& sizing)
    : gradient(charts.mesh.number_of_faces()), area(charts.mesh.number_of_faces())
  {
    const Indexed_triangle_mesh& mesh = charts.mesh;
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      // The triangle in its own frame, in which it is flat by construction.
      const auto a = mesh.vector(3 * f), b = -mesh.vector(3 * f + 2);
      const double l = std::sqrt(a * a);
      double x = l > 0 ? (a * b) / l : 0;
      double y = l > 0 ? std::sqrt(CGAL::cross_product(a, b).squared_length()) / l : 0;
      // Needles have gradients of any size; a height below this share of the longest edge counts as this share,
      // so that one triangle of noise does not dominate the energy.
      const double least_relative_height = 1e-4;
      const double longest = std::sqrt((std::max)({ a * a, b * b, (b - a) * (b - a) }));
      y = (std::max)(y, least_relative_height * longest * longest / (std::max)(l, least_relative_height * longest));
      const double l1 = (std::max)(l, least_relative_height * longest);
      const double h = sizing[f], two_area = l1 * y;
      const Eigen::Vector2d p[3] = { { 0, 0 }, { l1, 0 }, { x, y } };
      const Eigen::Vector2d u(charts.u_direction[f][0], charts.u_direction[f][1]), v(-u.y(), u.x());
      area[f] = two_area / 2 / (h * h);
      for(int k = 0; k < 3; ++k)
      {
        const Eigen::Vector2d opposite = p[(k + 2) % 3] - p[(k + 1) % 3];
        const Eigen::Vector2d g = Eigen::Vector2d(-opposite.y(), opposite.x()) * (h / two_area);
        gradient[f](k, 0) = g.dot(u);
        gradient[f](k, 1) = g.dot(v);
      }
    }
  }

  // For target edge lengths divided by a factor.
  void scale(double factor)
  {
    for(Gradient& g : gradient)
      g /= factor;
    for(double& a : area)
      a *= factor * factor;
  }

  // The Jacobian of triangle f, given the coordinates of its corners as the columns.
  Eigen::Matrix2d jacobian(int f, const Eigen::Matrix<double, 2, 3>& corners) const { return corners * gradient[f]; }
};

// The coordinates of the corners of face f as columns.
template <typename Vector>
Eigen::Matrix<double, 2, 3> corner_coordinates(const Seamless_coordinates& coordinates, int f, const Vector& x)
{
  Eigen::Matrix<double, 2, 3> p;
  for(int k = 0; k < 3; ++k)
    for(int c = 0; c < 2; ++c)
      p(c, k) = coordinates.value(coordinates.charts.wedge_of_corner[3 * f + k], c, x);
  return p;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_FACE_GRADIENTS_H
