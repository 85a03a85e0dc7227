// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_SIDE_TURN_ENERGY_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_SIDE_TURN_ENERGY_H

#include <algorithm>
#include <cmath>
#include <complex>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// One side of a quad as a function of its angle psi to a wanted direction.
//
// It pays (1 - cos(4 psi)) / 16: about psi^2/2 for small angles, nothing for multiples of a right angle, and at most
// 1/8, so that quads which cannot follow the direction, near irregular vertices, do not spoil their neighbors. With
// weight one, a degree between a side and its direction costs as much as one between two sides does.
class Side_turn_energy
{
public:
  // The coordinates of the side along the direction and across it.
  Side_turn_energy(double along, double across)
  {
    const std::complex<double> z(along, across);
    const double square = std::norm(z);
    m_fourth = square > 0 ? z * z * z * z / (square * square) : 1;
  }

  double value() const { return (1 - m_fourth.real()) / 16; }

  // The derivative for psi, and the second one where it is positive.
  double slope() const { return m_fourth.imag() / 4; }
  double curvature() const { return (std::max)(m_fourth.real(), 0.); }

private:
  std::complex<double> m_fourth; // exp(4 i psi)
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_SIDE_TURN_ENERGY_H
