// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_STIFFENING_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_STIFFENING_H

#include <CGAL/Quad_meshing/Parameterization/internal/Face_gradients.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The weights of local stiffening [Bom12, 8.4]: they grow where the distortion of a triangle differs from that
// of its neighbours, so that local peaks are flattened and the unavoidable global stretch is left alone.
class Stiffening
{
public:
  std::vector<double> weight; // per face, one to begin with

  Stiffening(const Seamless_coordinates& coordinates, const Face_gradients& faces)
    : weight(faces.area.size(), 1.), m_coordinates(coordinates), m_faces(faces)
  {
  }

  void update_weights(const Eigen::VectorXd& x)
  {
    const double factor = 1, largest_update = 5;
    const int smoothing_steps = 2;
    const int nf = static_cast<int>(weight.size());
    std::vector<double> distortion(nf);
    for(int f = 0; f < nf; ++f)
      distortion[f] = distortion_of(m_faces.jacobian(f, corner_coordinates(m_coordinates, f, x)));
    for(int f = 0; f < nf; ++f)
      weight[f] += (std::min)(factor * std::abs(mean_of_neighbours(distortion, f) - distortion[f]), largest_update);
    for(int i = 0; i < smoothing_steps; ++i)
    {
      std::vector<double> smooth(nf);
      for(int f = 0; f < nf; ++f)
        smooth[f] = 0.5 * (weight[f] + mean_of_neighbours(weight, f));
      weight.swap(smooth);
    }
  }

private:
  const Seamless_coordinates& m_coordinates;
  const Face_gradients& m_faces;

  // |t s1 - 1| + |t s2 - 1| with the singular values s1 >= s2 and the orientation t = 1 or -1.
  static double distortion_of(const Eigen::Matrix2d& J)
  {
    const double n = J.squaredNorm(), d = J.determinant();
    const double sum = std::sqrt((std::max)(0., n + 2 * std::abs(d)));
    const double difference = std::sqrt((std::max)(0., n - 2 * std::abs(d)));
    const double t = d >= 0 ? 1 : -1;
    return std::abs(t * (sum + difference) / 2 - 1) + std::abs(t * (sum - difference) / 2 - 1);
  }

  double mean_of_neighbours(const std::vector<double>& values, int f) const
  {
    double sum = 0;
    int n = 0;
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      if(m_coordinates.charts.mesh.opposite[h] != -1)
      {
        sum += values[m_coordinates.charts.mesh.opposite[h] / 3];
        ++n;
      }
    return n > 0 ? sum / n : values[f];
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_STIFFENING_H
