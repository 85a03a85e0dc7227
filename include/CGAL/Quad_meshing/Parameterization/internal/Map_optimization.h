// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_MAP_OPTIMIZATION_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_MAP_OPTIMIZATION_H

#include <CGAL/Quad_meshing/Linear_algebra/Sparse_cholesky.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Element_sum.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Face_gradients.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Regularized_distortion.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Star_layout.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Vertex_sectors.h>
#include <CGAL/Quad_meshing/internal/Regularized_determinant.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>
#include <CGAL/Quad_meshing/internal/parallel_for.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Moves the free variables of a seamless map so that no triangle is folded over.
//
// The variables are those of `Seamless_coordinates`, so transitions, grid points and grid lines stay what they are,
// whatever the moves. Newton steps with element Hessians made positive semi-definite; epsilon of the regularized
// distortion follows the worst determinant down (Garanzha et al. 2021). The work is restricted to
// rings of vertices around the folded triangles, which are enlarged only where that is not enough.
class Map_optimization
{
public:
  Map_optimization(const Seamless_coordinates& coordinates, const Shared_sums& sums, const Face_gradients& faces,
                   const Vertex_sectors& sectors, Stage_progress& progress)
    : m_coordinates(coordinates)
    , m_sums(sums)
    , m_mesh(coordinates.charts.mesh)
    , m_faces(faces)
    , m_sectors(sectors)
    , m_progress(progress)
  {
    double total = 0;
    for(double a : m_faces.area)
      total += a;
    // Small triangles must not fold either: they weigh at least this share of the mean.
    const double least_relative_weight = 0.05;
    const double least = least_relative_weight * total / (std::max)(1, m_mesh.number_of_faces());
    m_weight.resize(m_faces.area.size());
    for(std::size_t f = 0; f < m_weight.size(); ++f)
      m_weight[f] = (std::max)(m_faces.area[f], least);
  }

  // Operations that the repairs may still spend on assembling and factorizing; the descent ends where none are left. A
  // count and not a time, so that results do not depend on the machine.
  double operations_left = (std::numeric_limits<double>::max)();

  // Does not change results.
  unsigned int number_of_threads = 1;

  // The faces that are folded over, and all the faces of a sector around a vertex whose images wind around it too often
  // or too seldom: there the map is not injective although every triangle may be well oriented.
  std::vector<int> folded_faces(const Eigen::VectorXd& x) const { return faces_below(x, 0); }

  // Removes fold-overs by moving the variables that `is_fixed` does not hold; `x` becomes the best map that was found.
  // Returns whether none is left.
  bool untangle(Eigen::VectorXd& x, const std::vector<bool>& is_fixed, int most_rings = 12, int newton_steps = 60)
  {
    // a determinant below this share of the ideal one is worth a repair, though not folded
    const double least_determinant = 1e-2;
    std::vector<int> bad = faces_below(x, least_determinant);
    if(!m_progress.go_further())
      return false;
    std::size_t folded = folded_faces(x).size();
    for(int rings : { 3, 6, 12 })
    {
      if(!m_progress.go_further())
        return false;
      if(bad.empty())
        return true;
      if(rings > most_rings)
        return false;
      // From where the map is; then from a start that forgets how triangles were folded: no descent gets an image that
      // winds around a vertex the wrong number of times to wind around it once.
      for(bool anew : { false, true })
      {
        if(!m_progress.go_further())
          return false;
        Eigen::VectorXd y = x;
        const std::vector<bool> inside = vertices_around(bad, rings);
        if(anew)
        {
          restrict_to(inside, m_coordinates.is_integer);
          make_harmonic(y, Star_layout(m_coordinates, m_faces, m_sectors, m_number).open(folded_faces(y), y));
        }
        restrict_to(inside, is_fixed);
        minimize(y, newton_steps, true);
        const std::size_t n = folded_faces(y).size();
        if(n < folded)
        {
          x = y;
          folded = n;
        }
        if(folded == 0)
          return true;
      }
      bad = folded_faces(x);
    }
    return false;
  }

  // Adds a displacement of all variables to a map without fold-overs, in steps of which none folds a triangle. After
  // each, the triangles that stopped it get room by moving the variables around them that `is_fixed` does not hold. As
  // no triangle is ever folded over, no image can come to wind around a vertex a wrong number of times.
  // Returns whether the whole displacement was made; `x` is free of fold-overs in any case.
  bool carry(Eigen::VectorXd& x, const Eigen::VectorXd& displacement, const std::vector<bool>& is_fixed)
  {
    const double safe_share = 0.8;
    const int newton_steps = 10;
    // Enough progress in so many steps, or more variables must give way.
    const double least_progress = 0.05, least_relative_progress = 0.25;
    const int patience = 8;
    double remaining = 1, remaining_before = 1;
    std::vector<double> room(m_mesh.number_of_faces());
    int rings = 3;
    const double least_remaining = 1e-6; // where this is too much, faces collapse at the end of the displacement
    for(int steps = 0; rings <= 12 && remaining > least_remaining && m_progress.go_further(); ++steps)
    {
      if(steps > 0 && steps % patience == 0)
      {
        if(remaining_before - remaining < (std::min)(least_progress, least_relative_progress * remaining_before))
          rings *= 2;
        remaining_before = remaining;
      }
      double least_room = (std::numeric_limits<double>::max)();
      for(int f = 0; f < m_mesh.number_of_faces(); ++f)
        least_room = (std::min)(least_room, room[f] = room_of(f, x, displacement));
      if(least_room > remaining)
      {
        x += remaining * displacement;
        return true;
      }
      const double step = safe_share * least_room;
      x += step * displacement;
      remaining -= step;
      std::vector<int> narrow;
      for(int f = 0; f < m_mesh.number_of_faces(); ++f)
        if(room[f] < (std::min)(remaining, 4 * least_room))
          narrow.push_back(f);
      restrict_to(vertices_around(narrow, rings), is_fixed);
      minimize(x, newton_steps, false);
    }
    return false;
  }

private:
  const Seamless_coordinates& m_coordinates;
  const Shared_sums& m_sums; // the same
  const Indexed_triangle_mesh& m_mesh;
  const Face_gradients& m_faces;
  const Vertex_sectors& m_sectors;
  Stage_progress& m_progress;
  std::vector<double> m_weight; // per face
  std::vector<int> m_active;    // faces
  std::vector<int> m_number;    // per variable: its number among the free ones, -1 if fixed
  std::vector<int> m_variables; // the free ones
  Regularized_distortion m_distortion;

  double determinant(int f, const Eigen::VectorXd& x) const
  {
    return m_faces.jacobian(f, corner_coordinates(m_coordinates, f, x)).determinant();
  }

  // The multiple of a displacement at which a face collapses: the least positive root of its determinant.
  double room_of(int f, const Eigen::VectorXd& x, const Eigen::VectorXd& displacement) const
  {
    const Eigen::Matrix2d J = m_faces.jacobian(f, corner_coordinates(m_coordinates, f, x));
    const Eigen::Matrix2d D = m_faces.jacobian(f, corner_coordinates(m_coordinates, f, displacement));
    const double a = D.determinant(), c = J.determinant();
    const double b = J(0, 0) * D(1, 1) + J(1, 1) * D(0, 0) - J(0, 1) * D(1, 0) - J(1, 0) * D(0, 1);
    const double never = (std::numeric_limits<double>::max)();
    // a t^2 + b t + c with c > 0, its roots in the form that does not cancel
    const double discriminant = b * b - 4 * a * c;
    if(discriminant < 0)
      return never;
    const double q = -0.5 * (b + (b > 0 ? std::sqrt(discriminant) : -std::sqrt(discriminant)));
    const double first = q != 0 ? c / q : never, second = a != 0 ? q / a : never;
    double least = never;
    for(double t : { first, second })
      if(t > 0)
        least = (std::min)(least, t);
    return least;
  }

  std::vector<int> faces_below(const Eigen::VectorXd& x, double least_determinant) const
  {
    std::vector<double> angle(m_sectors.list.size(), 0.);
    std::vector<bool> is_bad(m_mesh.number_of_faces(), false);
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      const Eigen::Matrix<double, 2, 3> p = corner_coordinates(m_coordinates, f, x);
      is_bad[f] = !(m_faces.jacobian(f, p).determinant() > least_determinant);
      for(int k = 0; k < 3; ++k)
        if(m_sectors.sector_of_corner[3 * f + k] != -1)
          angle[m_sectors.sector_of_corner[3 * f + k]] += angle_of_image(p, k);
    }
    for(std::size_t i = 0; i < angle.size(); ++i)
      if(std::lround(angle[i] / Vertex_sectors::right_angle) != m_sectors.list[i].quarters)
        for(int h : m_sectors.list[i].halfedges)
          is_bad[h / 3] = true;
    std::vector<int> result;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      if(is_bad[f])
        result.push_back(f);
    return result;
  }

  // The signed angle of corner k of a triangle in the plane.
  static double angle_of_image(const Eigen::Matrix<double, 2, 3>& p, int k)
  {
    const Eigen::Vector2d a = p.col((k + 1) % 3) - p.col(k), b = p.col((k + 2) % 3) - p.col(k);
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }

  // Puts the free variables that have no place yet where the sum of the squared edge lengths of the images is least
  // (Tutte's weights).
  void make_harmonic(Eigen::VectorXd& x, const std::vector<bool>& is_placed)
  {
    for(std::size_t i = 0; i < is_placed.size(); ++i)
      if(is_placed[i])
        m_number[i] = -1;
    m_variables.erase(std::remove_if(m_variables.begin(), m_variables.end(), [&](int i) { return is_placed[i]; }),
                      m_variables.end());
    for(std::size_t i = 0; i < m_variables.size(); ++i)
      m_number[m_variables[i]] = static_cast<int>(i);

    if(m_variables.empty())
      return;
    std::vector<Eigen::Triplet<double>> triplets;
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(m_variables.size());
    std::vector<std::pair<int, double>> row;
    for(int f : m_active)
      for(int k = 0; k < 3; ++k)
        for(int c = 0; c < 2; ++c)
        {
          row.clear();
          double constant = 0;
          for(int end = 0; end < 2; ++end)
            for(const auto& t :
                m_coordinates.coordinates[m_coordinates.charts.wedge_of_corner[3 * f + (k + end) % 3]][c])
            {
              const double w = end == 0 ? t.second : -t.second;
              if(m_number[t.first] == -1)
                constant += w * x[t.first];
              else
                row.emplace_back(m_number[t.first], w);
            }
          for(const auto& a : row)
          {
            rhs[a.first] -= a.second * constant;
            for(const auto& b : row)
              triplets.emplace_back(a.first, b.first, a.second * b.second);
          }
        }
    Eigen::SparseMatrix<double> A(m_variables.size(), m_variables.size());
    A.setFromTriplets(triplets.begin(), triplets.end());
    Sparse_cholesky<double> solver;
    if(!solver.compute(A))
      return; // a region without a fixed border: leave it where it is
    const Eigen::VectorXd y = solver.solve(rhs);
    for(std::size_t i = 0; i < m_variables.size(); ++i)
      x[m_variables[i]] = y[i];
  }

  std::vector<bool> vertices_around(const std::vector<int>& seeds, int rings) const
  {
    std::vector<bool> inside(m_mesh.number_of_vertices(), false);
    std::vector<int> front, next;
    for(int f : seeds)
      for(int v : m_mesh.corners[f])
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
        for_each_corner_of_vertex(m_mesh, v,
                                  [&](int h)
                                  {
                                    for(int w : { m_mesh.target(h), m_mesh.source(Indexed_triangle_mesh::prev(h)) })
                                      if(!inside[w])
                                      {
                                        inside[w] = true;
                                        next.push_back(w);
                                      }
                                  });
      }
      front.swap(next);
    }
    return inside;
  }

  // The active faces are all that a free variable moves.
  void restrict_to(const std::vector<bool>& inside, const std::vector<bool>& is_fixed)
  {
    m_number.assign(m_coordinates.number_of_variables(), -1);
    m_variables.clear();
    auto for_each_term = [&](int f, auto visit)
    {
      for(int k = 0; k < 3; ++k)
        for(int c = 0; c < 2; ++c)
          for(const auto& t : m_coordinates.coordinates[m_coordinates.charts.wedge_of_corner[3 * f + k]][c])
            visit(m_mesh.corners[f][k], t.first);
    };
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      for_each_term(f,
                    [&](int v, int i)
                    {
                      if(inside[v] && !is_fixed[i] && m_number[i] == -1)
                      {
                        m_number[i] = static_cast<int>(m_variables.size());
                        m_variables.push_back(i);
                      }
                    });
    m_active.clear();
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      bool moves = false;
      for_each_term(f, [&](int, int i) { moves = moves || m_number[i] != -1; });
      if(moves)
        m_active.push_back(f);
    }
  }

  double energy(const Eigen::VectorXd& x) const
  {
    std::vector<double> of_face(m_active.size());
    parallel_for(m_active.size(), number_of_threads,
                 [&](std::size_t i)
                 {
                   const int f = m_active[i];
                   of_face[i] =
                     m_weight[f] * m_distortion.value(m_faces.jacobian(f, corner_coordinates(m_coordinates, f, x)));
                 });
    return std::accumulate(of_face.begin(), of_face.end(), 0.);
  }

  double least_determinant(const Eigen::VectorXd& x) const
  {
    double d = (std::numeric_limits<double>::max)();
    for(int f : m_active)
      d = (std::min)(d, determinant(f, x));
    return d;
  }

  void assemble(const Eigen::VectorXd& x, Eigen::VectorXd& gradient, Eigen::SparseMatrix<double>& hessian)
  {
    Element_sum sum(m_sums, m_number, static_cast<int>(m_variables.size()), 36 * m_active.size());
    Eigen::VectorXd of_slots = Eigen::VectorXd::Zero(sum.number_of_slots());
    double trace = 0, additions = 0;
    std::vector<int> local, place(sum.number_of_slots(), -1);
    Eigen::MatrixXd B, HB, lH; // B: d (J00, J01, J10, J11) / d local variables
    struct Derivatives
    {
      Regularized_distortion::Vector_4 g;
      Regularized_distortion::Matrix_4 H;
    };
    std::vector<Derivatives, Eigen::aligned_allocator<Derivatives>> derivatives(m_active.size());
    parallel_for(m_active.size(), number_of_threads,
                 [&](std::size_t i)
                 {
                   const Eigen::Matrix2d J =
                     m_faces.jacobian(m_active[i], corner_coordinates(m_coordinates, m_active[i], x));
                   m_distortion.derivatives(J, derivatives[i].g, derivatives[i].H);
                 });
    for(std::size_t a = 0; a < m_active.size(); ++a)
    {
      const int f = m_active[a];
      local.clear();
      for(int k = 0; k < 3; ++k)
        for(int c = 0; c < 2; ++c)
          for(const Shared_sums::Term& t : m_sums.terms(m_coordinates.charts.wedge_of_corner[3 * f + k], c))
            if(const int i = sum.slot(t.first); i != -1 && place[i] == -1)
            {
              place[i] = static_cast<int>(local.size());
              local.push_back(i);
            }
      B.setZero(4, local.size());
      for(int k = 0; k < 3; ++k)
        for(int c = 0; c < 2; ++c)
          for(const Shared_sums::Term& t : m_sums.terms(m_coordinates.charts.wedge_of_corner[3 * f + k], c))
            if(const int i = sum.slot(t.first); i != -1)
            {
              B(2 * c, place[i]) += t.second * m_faces.gradient[f](k, 0);
              B(2 * c + 1, place[i]) += t.second * m_faces.gradient[f](k, 1);
            }
      HB.noalias() = m_weight[f] * derivatives[a].H * B;
      lH.noalias() = B.transpose() * HB;
      additions += double(local.size()) * local.size();
      for(std::size_t i = 0; i < local.size(); ++i)
      {
        of_slots[local[i]] += m_weight[f] * B.col(i).dot(derivatives[a].g);
        for(std::size_t j = 0; j < local.size(); ++j)
          sum.add(local[i], local[j], lH(i, j));
        trace += lH(i, i);
        place[local[i]] = -1;
      }
    }
    // The eigenvalues of the Hessian of each face, a dense part of the integers, and nested dissection of a plane for
    // the rest.
    const double per_face = 2000, per_addition = 10, per_variable = 10;
    const auto integers =
      std::count_if(m_variables.begin(), m_variables.end(), [this](int i) { return m_coordinates.is_integer[i]; });
    operations_left -= per_face * static_cast<double>(m_active.size()) + per_addition * additions +
                       std::pow(integers, 3) / 3 + per_variable * std::pow(m_variables.size(), 1.5);
    gradient = sum.vector(of_slots);
    // Keeps the matrix definite where an element Hessian has nothing to say.
    const double relative_regularization = 1e-10;
    hessian = sum.matrix(relative_regularization * trace / (std::max)(std::size_t(1), m_variables.size()));
  }

  void minimize(Eigen::VectorXd& x, int steps, bool regularize)
  {
    if(m_variables.empty())
      return;
    Eigen::VectorXd gradient;
    Eigen::SparseMatrix<double> hessian;
    Sparse_cholesky<double> solver;
    bool analyzed = false;
    int steps_since_unfolded = 0;
    double worst_before = -(std::numeric_limits<double>::max)();
    for(int step = 0; step < steps && operations_left > 0 && m_progress.go_further(); ++step)
    {
      const double d = least_determinant(x);
      // The worst triangle must get better from time to time, or there is no room for it.
      const int patience = 12;
      const double least_progress = 0.9;
      if(regularize && step % patience == 0)
      {
        if(step > 0 && d <= 0 && d < least_progress * worst_before)
          break;
        worst_before = d;
      }
      m_distortion.epsilon = regularize ? Regularized_determinant::epsilon_for(d) : 0.;
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
      if(!(slope < 0) || (m_distortion.epsilon == 0 && -slope < relative_decrease * before))
        break;
      bool moved = false;
      Eigen::VectorXd y = x;
      for(double t = 1; t > 1e-6; t *= 0.5)
      {
        for(std::size_t i = 0; i < m_variables.size(); ++i)
          y[m_variables[i]] = x[m_variables[i]] + t * direction[i];
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
    m_distortion.epsilon = 0;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_MAP_OPTIMIZATION_H
