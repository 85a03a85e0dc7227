// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_MAP_OPTIMIZATION_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_MAP_OPTIMIZATION_H

#include <CGAL/Quad_meshing/Mixed_integer/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Face_gradients.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Regularized_distortion.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Moves the free variables of a seamless map so that no triangle is folded over, then so that the distortion falls.
//
// The variables are those of `Seamless_coordinates`, so transitions, grid points and grid lines stay what they are, whatever
// the moves. Newton steps with element Hessians made positive semi-definite; epsilon of the regularized
// distortion follows the worst determinant down (Garanzha et al. 2021). The work is restricted to
// rings of vertices around the folded triangles, which are enlarged only where that is not enough.
class Map_optimization
{
public:
  Map_optimization(const Seamless_coordinates& coordinates, const Face_gradients& faces)
    : coordinates(coordinates), mesh(coordinates.charts.mesh), faces(faces)
  {
    double total = 0;
    for(double a : faces.area)
      total += a;
    // Small triangles must not fold either: they weigh at least this share of the mean.
    const double least_relative_weight = 0.05;
    const double least = least_relative_weight * total / (std::max)(1, mesh.number_of_faces());
    weight.resize(faces.area.size());
    for(std::size_t f = 0; f < weight.size(); ++f)
      weight[f] = (std::max)(faces.area[f], least);
  }

  double determinant(int f, const Eigen::VectorXd& x) const
  {
    return faces.jacobian(f, corner_coordinates(coordinates, f, x)).determinant();
  }

  std::vector<int> folded_faces(const Eigen::VectorXd& x, double least_determinant) const
  {
    std::vector<int> folded;
    for(int f = 0; f < mesh.number_of_faces(); ++f)
      if(!(determinant(f, x) > least_determinant))
        folded.push_back(f);
    return folded;
  }

  // Removes fold-overs by moving the variables that `is_fixed` does not hold. Returns the faces
  // that are still folded; `x` is then the best map that was found.
  std::vector<int> untangle(Eigen::VectorXd& x, const std::vector<bool>& is_fixed)
  {
    // a determinant below this share of the ideal one is worth a repair, though not folded
    const double least_determinant = 1e-2;
    for(int rings : { 3, 8, 20 })
    {
      const std::vector<int> bad = folded_faces(x, least_determinant);
      if(bad.empty())
        return bad;
      Eigen::VectorXd y = x;
      restrict_to(vertices_around(bad, rings), is_fixed);
      minimize(y, 40, true);
      if(folded_faces(y, 0).size() <= folded_faces(x, 0).size())
        x = y;
      if(folded_faces(x, 0).empty())
        break;
    }
    return folded_faces(x, 0);
  }

  // Lowers the distortion of a map without fold-overs everywhere.
  void improve(Eigen::VectorXd& x, const std::vector<bool>& is_fixed, int steps)
  {
    restrict_to(std::vector<bool>(mesh.number_of_vertices(), true), is_fixed);
    minimize(x, steps, false);
  }

private:
  const Seamless_coordinates& coordinates;
  const Indexed_triangle_mesh& mesh;
  const Face_gradients& faces;
  std::vector<double> weight;  // per face
  std::vector<int> active;     // faces
  std::vector<int> number;     // per variable: its number among the free ones, -1 if fixed
  std::vector<int> variables;  // the free ones
  Regularized_distortion distortion;

  std::vector<bool> vertices_around(const std::vector<int>& seeds, int rings) const
  {
    std::vector<bool> inside(mesh.number_of_vertices(), false);
    std::vector<int> front, next;
    for(int f : seeds)
      for(int v : mesh.corners[f])
        if(!inside[v])
        {
          inside[v] = true;
          front.push_back(v);
        }
    for(int r = 1; r < rings; ++r)
    {
      next.clear();
      for(int v : front)
      {
        const int start = mesh.halfedge_of_vertex[v];
        int h = start;
        do
        {
          for(int w : { mesh.target(h), mesh.source(Indexed_triangle_mesh::prev(h)) })
            if(!inside[w])
            {
              inside[w] = true;
              next.push_back(w);
            }
          h = mesh.next_around_source(h);
        }
        while(h != -1 && h != start);
      }
      front.swap(next);
    }
    return inside;
  }

  // The active faces are all that a free variable moves.
  void restrict_to(const std::vector<bool>& inside, const std::vector<bool>& is_fixed)
  {
    number.assign(coordinates.number_of_variables(), -1);
    variables.clear();
    auto for_each_term = [&](int f, auto visit)
    {
      for(int k = 0; k < 3; ++k)
        for(int c = 0; c < 2; ++c)
          for(const auto& t : coordinates.coordinates[coordinates.charts.wedge_of_corner[3 * f + k]][c])
            visit(mesh.corners[f][k], t.first);
    };
    for(int f = 0; f < mesh.number_of_faces(); ++f)
      for_each_term(f, [&](int v, int i)
      {
        if(inside[v] && !is_fixed[i] && number[i] == -1)
        {
          number[i] = static_cast<int>(variables.size());
          variables.push_back(i);
        }
      });
    active.clear();
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      bool moves = false;
      for_each_term(f, [&](int, int i) { moves = moves || number[i] != -1; });
      if(moves)
        active.push_back(f);
    }
  }

  double energy(const Eigen::VectorXd& x) const
  {
    double e = 0;
    for(int f : active)
    {
      e += weight[f] * distortion.value(faces.jacobian(f, corner_coordinates(coordinates, f, x)));
      if(!std::isfinite(e))
        break;
    }
    return e;
  }

  double least_determinant(const Eigen::VectorXd& x) const
  {
    double d = (std::numeric_limits<double>::max)();
    for(int f : active)
      d = (std::min)(d, determinant(f, x));
    return d;
  }

  void assemble(const Eigen::VectorXd& x, Eigen::VectorXd& gradient, Eigen::SparseMatrix<double>& hessian) const
  {
    gradient = Eigen::VectorXd::Zero(variables.size());
    std::vector<Eigen::Triplet<double> > triplets;
    triplets.reserve(36 * active.size());
    std::vector<int> local;
    Eigen::MatrixXd B; // d (J00, J01, J10, J11) / d local variables
    for(int f : active)
    {
      local.clear();
      for(int k = 0; k < 3; ++k)
        for(int c = 0; c < 2; ++c)
          for(const auto& t : coordinates.coordinates[coordinates.charts.wedge_of_corner[3 * f + k]][c])
            if(number[t.first] != -1 && std::find(local.begin(), local.end(), number[t.first]) == local.end())
              local.push_back(number[t.first]);
      B.setZero(4, local.size());
      for(int k = 0; k < 3; ++k)
        for(int c = 0; c < 2; ++c)
          for(const auto& t : coordinates.coordinates[coordinates.charts.wedge_of_corner[3 * f + k]][c])
            if(number[t.first] != -1)
            {
              const auto i = std::find(local.begin(), local.end(), number[t.first]) - local.begin();
              B(2 * c, i) += t.second * faces.gradient[f](k, 0);
              B(2 * c + 1, i) += t.second * faces.gradient[f](k, 1);
            }
      Regularized_distortion::Vector_4 g;
      Regularized_distortion::Matrix_4 H;
      distortion.derivatives(faces.jacobian(f, corner_coordinates(coordinates, f, x)), g, H);
      const Eigen::VectorXd lg = weight[f] * (B.transpose() * g);
      const Eigen::MatrixXd lH = weight[f] * (B.transpose() * H * B);
      for(std::size_t i = 0; i < local.size(); ++i)
      {
        gradient[local[i]] += lg[i];
        for(std::size_t j = 0; j < local.size(); ++j)
          triplets.emplace_back(local[i], local[j], lH(i, j));
      }
    }
    // Keeps the matrix definite where an element Hessian has nothing to say.
    const double relative_regularization = 1e-10;
    double trace = 0;
    for(const auto& t : triplets)
      if(t.row() == t.col())
        trace += t.value();
    const double shift = relative_regularization * trace / (std::max)(std::size_t(1), variables.size());
    for(std::size_t i = 0; i < variables.size(); ++i)
      triplets.emplace_back(static_cast<int>(i), static_cast<int>(i), shift);
    hessian.resize(variables.size(), variables.size());
    hessian.setFromTriplets(triplets.begin(), triplets.end());
  }

  void minimize(Eigen::VectorXd& x, int steps, bool regularize)
  {
    if(variables.empty())
      return;
    Eigen::VectorXd gradient;
    Eigen::SparseMatrix<double> hessian;
    Sparse_cholesky solver;
    bool analyzed = false;
    int steps_since_unfolded = 0;
    for(int step = 0; step < steps; ++step)
    {
      const double d = least_determinant(x);
      distortion.epsilon = regularize && d <= 0 ? std::sqrt(1e-12 + 0.04 * d * d) : 0.;
      if(regularize && d > 0 && ++steps_since_unfolded > 6)
        break;
      assemble(x, gradient, hessian);
      if(!analyzed)
        solver.analyze(hessian);
      analyzed = true;
      if(!solver.factorize(hessian))
        break;
      const Eigen::VectorXd direction = -solver.solve(gradient);
      const double slope = gradient.dot(direction);
      const double before = energy(x);
      const double relative_decrease = 1e-4; // a step that promises less than this share ends the search
      if(!(slope < 0) || (distortion.epsilon == 0 && -slope < relative_decrease * before))
        break;
      bool moved = false;
      Eigen::VectorXd y = x;
      for(double t = 1; t > 1e-6; t *= 0.5)
      {
        for(std::size_t i = 0; i < variables.size(); ++i)
          y[variables[i]] = x[variables[i]] + t * direction[i];
        const double after = energy(y);
        if(after <= before + 1e-4 * t * slope)
        {
          moved = true;
          break;
        }
      }
      if(!moved)
        break;
      x = y;
    }
    distortion.epsilon = 0;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_MAP_OPTIMIZATION_H
