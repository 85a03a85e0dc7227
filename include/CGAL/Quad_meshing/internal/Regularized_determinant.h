// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_REGULARIZED_DETERMINANT_H
#define CGAL_QUAD_MESHING_INTERNAL_REGULARIZED_DETERMINANT_H

#include <cmath>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The positive function chi(D) = (D + sqrt(D^2 + epsilon^2)) / 2 that takes the place of a determinant in the
// denominator of a distortion: finite on folded elements, and the closer to the barrier the smaller epsilon is
// (Garanzha et al., "Foldover-free maps in 50 lines of code", 2021). With epsilon = 0 it is the determinant itself.
struct Regularized_determinant
{
  double epsilon = 0;

  double value(double D) const
  {
    if(epsilon == 0)
      return D;
    const double r = root(D);
    return D > 0 ? 0.5 * (D + r) : 0.5 * epsilon * epsilon / (r - D); // no cancellation
  }

  double derivative(double D) const
  {
    const double r = root(D);
    return r > 0 ? 0.5 * (1 + D / r) : 0.5;
  }

  double second_derivative(double D) const
  {
    const double r = root(D);
    return r > 0 ? 0.5 * epsilon * epsilon / (r * r * r) : 0;
  }

  // Epsilon for the worst determinant of all elements: zero if none is folded.
  static double epsilon_for(double worst)
  {
    const double least_square = 1e-12; // of a map about to unfold; determinants are of the order of one
    const double share = 0.04; // of the square of the worst determinant, as in the listing of Garanzha et al. 2021
    return worst <= 0 ? std::sqrt(least_square + share * worst * worst) : 0.;
  }

private:
  double root(double D) const { return std::sqrt(D * D + epsilon * epsilon); }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_REGULARIZED_DETERMINANT_H
