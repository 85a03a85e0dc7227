// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ORIENTATION_ENERGY_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ORIENTATION_ENERGY_H

#include <CGAL/Quad_meshing/Parameterization/internal/Element_sum.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Face_gradients.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <Eigen/SparseCore>

#include <array>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The quadratic orientation energy [Bom12, 8.4] over the independent variables of a seamless map:
// 1/2 x'Ax - x'b + constant = sum over the triangles of
// w area / h^2 (|h grad u - u_T|^2 in the norm (g, 1) + |h grad v - v_T|^2 in the norm (1, g)).
struct Orientation_energy
{
  Eigen::SparseMatrix<double> A;
  Eigen::VectorXd b;
  double constant = 0;

  // `weight` per face: the stiffening weights w; `anisotropy`: g, in (0, 1]. If the visitor of `progress` stops it, the
  // energy is of no use.
  Orientation_energy(const Combed_charts& charts, const Shared_sums& coordinates, const Face_gradients& faces,
                     const std::vector<double>& weight, double anisotropy, Stage_progress* progress = nullptr)
  {
    std::vector<int> number(coordinates.number_of_variables());
    std::iota(number.begin(), number.end(), 0);
    assemble(charts, coordinates, faces, weight, anisotropy, number, coordinates.number_of_variables(),
             Eigen::VectorXd::Zero(coordinates.number_of_variables()), progress);
  }

  // The same over some of the variables only: `number` gives their numbers, from 0 to n - 1, and -1 for the variables
  // that keep their value in `x`.
  Orientation_energy(const Combed_charts& charts, const Shared_sums& coordinates, const Face_gradients& faces,
                     const std::vector<double>& weight, double anisotropy, const std::vector<int>& number, int n,
                     const Eigen::VectorXd& x, Stage_progress* progress = nullptr)
  {
    assemble(charts, coordinates, faces, weight, anisotropy, number, n, x, progress);
  }

private:
  void assemble(const Combed_charts& charts, const Shared_sums& coordinates, const Face_gradients& faces,
                const std::vector<double>& weight, double anisotropy, const std::vector<int>& number, int n,
                const Eigen::VectorXd& x, Stage_progress* progress)
  {
    const int faces_per_report = 0x4000; // each takes about a microsecond
    const int nf = charts.mesh.number_of_faces();
    Element_sum sum(coordinates, number, n, 18 * static_cast<std::size_t>(nf));
    const Eigen::VectorXd fixed = fixed_parts(coordinates, number, x);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(sum.number_of_slots());
    std::vector<int> variables, place(sum.number_of_slots(), -1);
    std::vector<std::array<double, 2>> row; // derivatives along u_T and v_T
    for(int f = 0; f < nf; ++f)
    {
      if(progress != nullptr && f % faces_per_report == 0 && !progress->go_further())
        return;
      for(int c = 0; c < 2; ++c) // the two coordinates do not mix in the energy of a triangle
      {
        variables.clear();
        row.clear();
        std::array<double, 2> target = { { c == 0 ? 1. : 0., c == 1 ? 1. : 0. } };
        for(int k = 0; k < 3; ++k)
          for(const Shared_sums::Term& t : coordinates.terms(charts.wedge_of_corner[3 * f + k], c))
          {
            const int i = sum.slot(t.first);
            if(i != -1 && place[i] == -1)
            {
              place[i] = static_cast<int>(variables.size());
              variables.push_back(i);
              row.push_back({ { 0., 0. } });
            }
            for(int d = 0; d < 2; ++d)
            {
              target[d] -= t.second * faces.gradient[f](k, d) * fixed[t.first];
              if(i != -1)
                row[place[i]][d] += t.second * faces.gradient[f](k, d);
            }
          }
        std::array<double, 2> w;
        for(int d = 0; d < 2; ++d)
        {
          w[d] = weight[f] * faces.area[f] * (c == d ? anisotropy : 1.);
          constant += w[d] * target[d] * target[d];
        }
        for(std::size_t i = 0; i < row.size(); ++i)
        {
          gradient[variables[i]] += 2 * (w[0] * row[i][0] * target[0] + w[1] * row[i][1] * target[1]);
          for(std::size_t j = 0; j < row.size(); ++j)
            sum.add(variables[i], variables[j], 2 * (w[0] * row[i][0] * row[j][0] + w[1] * row[i][1] * row[j][1]));
        }
        for(int i : variables)
          place[i] = -1;
      }
    }
    if(progress != nullptr && !progress->go_further())
      return;
    A = sum.matrix();
    b = sum.vector(gradient);
  }

  // What the fixed variables contribute to the terms of coordinates: variables, then sums.
  static Eigen::VectorXd fixed_parts(const Shared_sums& coordinates, const std::vector<int>& number,
                                     const Eigen::VectorXd& x)
  {
    const int n = coordinates.number_of_variables();
    Eigen::VectorXd result = Eigen::VectorXd::Zero(n + static_cast<int>(coordinates.sums().size()));
    for(int i = 0; i < n; ++i)
      if(number[i] == -1)
        result[i] = x[i];
    for(std::size_t s = 0; s < coordinates.sums().size(); ++s)
      for(const Shared_sums::Term& t : coordinates.sums()[s])
        result[n + static_cast<int>(s)] += t.second * result[t.first];
    return result;
  }

public:
  double value(const Eigen::VectorXd& x) const { return 0.5 * x.dot(A * x) - x.dot(b) + constant; }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_ORIENTATION_ENERGY_H
