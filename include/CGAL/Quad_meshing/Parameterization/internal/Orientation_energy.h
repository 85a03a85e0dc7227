// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ORIENTATION_ENERGY_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ORIENTATION_ENERGY_H

#include <CGAL/Quad_meshing/Parameterization/internal/Face_gradients.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>

#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The quadratic orientation energy of the thesis, Section 8.4, over the independent variables of a seamless map:
// 1/2 x'Ax - x'b + constant = sum over the triangles of
// w area / h^2 (|h grad u - u_T|^2 in the norm (g, 1) + |h grad v - v_T|^2 in the norm (1, g)).
struct Orientation_energy
{
  Eigen::SparseMatrix<double> A;
  Eigen::VectorXd b;
  double constant = 0;

  // `weight` per face: the stiffening weights w; `anisotropy`: g, in (0, 1].
  Orientation_energy(const Seamless_coordinates& coordinates, const Face_gradients& faces,
                     const std::vector<double>& weight, double anisotropy)
    : A(coordinates.number_of_variables(), coordinates.number_of_variables()),
      b(Eigen::VectorXd::Zero(coordinates.number_of_variables()))
  {
    const Combed_charts& charts = coordinates.charts;
    const int nf = charts.mesh.number_of_faces();
    std::vector<Eigen::Triplet<double> > triplets;
    triplets.reserve(18 * static_cast<std::size_t>(nf));
    std::vector<int> variables;
    std::vector<double> row;
    for(int f = 0; f < nf; ++f)
      for(int c = 0; c < 2; ++c) // u and v do not mix inside a triangle, unless they share a variable
      {
        variables.clear();
        for(int k = 0; k < 3; ++k)
          for(const Seamless_coordinates::Term& t : coordinates.coordinates[charts.wedge_of_corner[3 * f + k]][c])
            if(std::find(variables.begin(), variables.end(), t.first) == variables.end())
              variables.push_back(t.first);
        for(int d = 0; d < 2; ++d) // derivative along u_T and v_T
        {
          const double w = weight[f] * faces.area[f] * (c == d ? anisotropy : 1.);
          const double target = c == d ? 1. : 0.;
          row.assign(variables.size(), 0.);
          for(int k = 0; k < 3; ++k)
            for(const Seamless_coordinates::Term& t : coordinates.coordinates[charts.wedge_of_corner[3 * f + k]][c])
            {
              const std::size_t i = std::find(variables.begin(), variables.end(), t.first) - variables.begin();
              row[i] += t.second * faces.gradient[f](k, d);
            }
          for(std::size_t i = 0; i < row.size(); ++i)
          {
            b[variables[i]] += 2 * w * row[i] * target;
            for(std::size_t j = 0; j < row.size(); ++j)
              triplets.emplace_back(variables[i], variables[j], 2 * w * row[i] * row[j]);
          }
          constant += w * target * target;
        }
      }
    A.setFromTriplets(triplets.begin(), triplets.end());
  }

  double value(const Eigen::VectorXd& x) const { return 0.5 * x.dot(A * x) - x.dot(b) + constant; }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ORIENTATION_ENERGY_H
