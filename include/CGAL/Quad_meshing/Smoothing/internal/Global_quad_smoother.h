// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_GLOBAL_QUAD_SMOOTHER_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_GLOBAL_QUAD_SMOOTHER_H

#include <CGAL/Quad_meshing/Smoothing/internal/Quad_smoother.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Rectangle_energy.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Side_turn_energy.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Smooths a quad mesh on a reference surface by moving all vertices at once.
//
// If vertices have to go far together, the number of sweeps that move them one by one grows with the square of the
// distance in quads. A step of Newton's method on the energy of all corners (see `Rectangle_energy`) needs one linear
// system, and takes them as far as the tangent planes are close to the surface.
//
// The vertices of quads that would fold, or become much worse, stay where they are; those of quads that pay much more
// after a step than before it go shorter ways next time, as the system gets a larger diagonal there.
class Global_quad_smoother : public Quad_smoother
{
public:
  // A quad may not become worse than this, if it was better, and not worse at all if it was worse. Where so few quads
  // are below `guarded_jacobian` at first, that is the limit.
  static constexpr double least_jacobian = 0.5, few_bad_quads = 0.001;
  // Longest step at first, relative to the sides around the vertex, and its factor after a step that was of no use.
  static constexpr double longest_first_step = 2, shorter = 0.5;
  // How many useless steps in a row end the smoothing, and the part of the energy that a useful step saves.
  static constexpr int most_useless_steps = 3;
  static constexpr double least_gain = 0.01;
  // Sweeps over the bad quads in the end.
  static constexpr int mending_sweeps = 20;

  using Quad_smoother::Quad_smoother;

  // Moves all vertices that may move; false if it is not worth while to go on.
  bool step()
  {
    if(m_limit < 0)
    {
      const double bad =
        std::count_if(m_jacobian.begin(), m_jacobian.end(), [](double j) { return j < guarded_jacobian; });
      m_limit = bad <= few_bad_quads * m_mesh.number_of_faces() ? guarded_jacobian : least_jacobian;
    }
    update_scales();
    number_unknowns();
    if(m_number_of_unknowns == 0)
      return false;
    set_up();
    Eigen::VectorXd x;
    if(!m_visitor.go_further() || !solve(x))
      return false;

    std::vector<Vector_3> direction(m_mesh.number_of_vertices(), Vector_3(0, 0, 0));
    double longest = 0;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_unknown[v][0] != -1)
      {
        for(int i = 0; i < 2; ++i)
          if(m_unknown[v][i] != -1)
            direction[v] = direction[v] + x[m_unknown[v][i]] * m_frame[v][i];
        longest = (std::max)(longest, direction[v].squared_length() / m_scale[v]);
      }
    longest = std::sqrt(longest);
    if(!(longest > 0 && longest < std::numeric_limits<double>::infinity()))
      return false;
    return move_all(direction, (std::min)(1., m_longest_step / longest));
  }

  // Moves the vertices of bad quads one by one.
  void mend()
  {
    std::vector<char> is_bad;
    bool any = true;
    for(int sweep = 0; any && sweep < mending_sweeps; ++sweep)
    {
      update_scales();
      is_bad.assign(m_mesh.number_of_vertices(), 0);
      for(int f = 0; f < m_mesh.number_of_faces(); ++f)
        if(m_jacobian[f] < guarded_jacobian)
          for(int v : m_mesh.corners[f])
            is_bad[v] = 1;
      any = false;
      for(int v = 0; v < m_mesh.number_of_vertices() && goes_on(v); ++v)
        if(is_bad[v])
          any = mend(v) || any;
    }
  }

private:
  // The weight of areas against shapes where lengths are asked for: as much as it takes that they do not level out.
  static constexpr double weight_of_lengths = 0.5;

  // Shorter sides, relative to the root of the area aimed at, are not turned faster.
  static constexpr double least_side = Rectangle_energy::least_length;

  // The same where one length is asked for everywhere: as little as it takes that areas stay within 4 : 1 on a capsule
  // of 4000 quads (3.8), for it bends corners: at 4000 quads, bunny has 3.9 degrees without lengths, 4.2 with them
  // and 4.5 with a weight of 0.1.
  static constexpr double weight_of_one_length = 0.07;

  static double area_weight_for(const std::vector<double>& length)
  {
    if(length.empty())
      return Rectangle_energy::area_weight;
    const auto extremes = std::minmax_element(length.begin(), length.end());
    return *extremes.first == *extremes.second ? weight_of_one_length : weight_of_lengths;
  }

  typedef Eigen::SparseMatrix<double> Matrix;
  typedef Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>> Preconditioner;

  // Of the linear systems: relative size of the residual, and number of steps.
  static constexpr double accuracy = 0.01;
  static constexpr int most_solver_steps = 1000;
  // What the diagonal gets at least, and at first where a step was too long, relative to the energy of an edge; and by
  // which factors it grows and falls.
  static constexpr double least_damping = 1e-6, first_damping = 0.3, more_damping = 10, less_damping = 0.3;
  // A step was too long if a quad pays more than this part more, and at least so much for each corner.
  static constexpr double tolerated_growth = 0.2, tolerated_rise = 0.02;

  // Moves one vertex, unless this turns a quad over; whether it has gone far enough to go on.
  bool mend(int v)
  {
    const Point_3 p = m_mesh.points[v];
    const int place = m_place[v];
    auto opposed_around = [&]
    {
      int number = 0;
      for(int i = m_first[v]; i < m_first[v + 1]; ++i)
        number += is_opposed(m_corner[i] / 4);
      return number;
    };
    const int opposed_before = opposed_around();
    const double length = improve(v, true);
    if(length > 0 && opposed_around() > opposed_before)
    {
      m_place[v] = place;
      move(v, p);
      return false;
    }
    return length * length > resting_step * resting_step * m_scale[v];
  }

  void number_unknowns()
  {
    m_frame.resize(m_mesh.number_of_vertices());
    m_unknown.assign(m_mesh.number_of_vertices(), { { -1, -1 } });
    m_damping.resize(m_mesh.number_of_vertices(), 0);
    m_number_of_unknowns = 0;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      if(m_kind[v] == fixed || m_is_off[v] || !(m_scale[v] > 0))
        continue;
      m_frame[v] = directions(v);
      m_unknown[v][0] = m_number_of_unknowns++;
      if(m_kind[v] == on_surface)
        m_unknown[v][1] = m_number_of_unknowns++;
    }
  }

  // The gradient of the energy and its matrix of second derivatives.
  void set_up()
  {
    typedef Eigen::Matrix<double, 8, 1> Vector_8;
    typedef Eigen::Matrix<double, 8, 8> Matrix_8;
    m_gradient = Eigen::VectorXd::Zero(m_number_of_unknowns);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * m_mesh.number_of_faces() + m_number_of_unknowns);
    for(int f = 0; f < m_mesh.number_of_faces() && goes_on(f); ++f)
    {
      const std::array<int, 4>& c = m_mesh.corners[f];
      const Vector_3 x = unit_or_zero(m_mesh.points[c[2]] - m_mesh.points[c[0]]), y = cross_product(m_normal[f], x);
      // the ways of each vertex in the plane of the quad
      std::array<Eigen::Matrix2d, 4> ways;
      for(int k = 0; k < 4; ++k)
        for(int i = 0; i < 2; ++i)
        {
          ways[k](0, i) = m_unknown[c[k]][i] == -1 ? 0 : m_frame[c[k]][i] * x;
          ways[k](1, i) = m_unknown[c[k]][i] == -1 ? 0 : m_frame[c[k]][i] * y;
        }
      Vector_8 gradient = Vector_8::Zero();
      Matrix_8 matrix = Matrix_8::Zero();
      for(int k = 0; k < 4; ++k)
      {
        const int next = (k + 1) & 3, prev = (k + 3) & 3;
        const Vector_3 a = m_mesh.points[c[next]] - m_mesh.points[c[k]],
                       b = m_mesh.points[c[prev]] - m_mesh.points[c[k]];
        Rectangle_energy::Sides slope;
        Eigen::Matrix4d curvature;
        Rectangle_energy::derivatives(Rectangle_energy::Sides(a * x, a * y, b * x, b * y), m_area[f], slope, curvature,
                                      m_area_weight);
        Eigen::Matrix<double, 4, 8> sides = Eigen::Matrix<double, 4, 8>::Zero();
        sides.block<2, 2>(0, 2 * next) = ways[next];
        sides.block<2, 2>(2, 2 * prev) = ways[prev];
        sides.block<2, 2>(0, 2 * k) = sides.block<2, 2>(2, 2 * k) = -ways[k];
        gradient += sides.transpose() * slope;
        matrix += sides.transpose() * curvature * sides;
        if(m_wish.empty() || !(m_wish[f].weight > 0))
          continue;
        const Wanted_directions::Wish& wish = m_wish[f];
        const Eigen::Vector2d d(wish.direction * x, wish.direction * y), side(a * x, a * y);
        const double square = (std::max)(side.squaredNorm(), least_side * least_side * m_area[f]);
        const Side_turn_energy e(side.dot(d), d[0] * side[1] - d[1] * side[0]);
        const Vector_8 turn = sides.topRows<2>().transpose() * Eigen::Vector2d(-side[1], side[0]) / square;
        gradient += wish.weight * e.slope() * turn;
        matrix += wish.weight * e.curvature() * turn * turn.transpose();
      }
      for(int r = 0; r < 8; ++r)
      {
        const int u = m_unknown[c[r / 2]][r % 2];
        if(u == -1)
          continue;
        m_gradient[u] += gradient[r];
        for(int s = 0; s < 8; ++s)
        {
          const int w = m_unknown[c[s / 2]][s % 2];
          if(w != -1 && w <= u)
            entries.emplace_back(u, w, matrix(r, s));
        }
      }
    }
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      for(int u : m_unknown[v])
        if(u != -1)
          entries.emplace_back(u, u, (least_damping + m_damping[v]) / m_scale[v]);
    m_matrix.resize(m_number_of_unknowns, m_number_of_unknowns);
    m_matrix.setFromTriplets(entries.begin(), entries.end());
  }

  // Newton's step by conjugate gradients, preconditioned by an incomplete factorization. Not
  // `Eigen::ConjugateGradient`, which cannot be interrupted; the steps are the same. False if there is no
  // factorization, or the visitor asks for an end.
  bool solve(Eigen::VectorXd& x) const
  {
    const Preconditioner preconditioner(m_matrix);
    if(preconditioner.info() != Eigen::Success)
      return false;
    const auto matrix = m_matrix.selfadjointView<Eigen::Lower>();
    x = Eigen::VectorXd::Zero(m_number_of_unknowns);
    Eigen::VectorXd residual = -m_gradient;
    const double norm = residual.squaredNorm();
    const double threshold = (std::max)(accuracy * accuracy * norm, (std::numeric_limits<double>::min)());
    if(norm < threshold)
      return true;
    Eigen::VectorXd direction = preconditioner.solve(residual), product(m_number_of_unknowns), z(m_number_of_unknowns);
    double now = residual.dot(direction);
    for(int i = 0; i < most_solver_steps; ++i)
    {
      if(!m_visitor.go_further())
        return false;
      product.noalias() = matrix * direction;
      const double length = now / direction.dot(product);
      x += length * direction;
      residual -= length * product;
      if(residual.squaredNorm() < threshold)
        return true;
      z = preconditioner.solve(residual);
      const double before = now;
      now = residual.dot(z);
      direction = z + (now / before) * direction;
    }
    return true;
  }

  // Goes a part of the way; nothing has moved if that does not lessen the energy.
  bool move_all(const std::vector<Vector_3>& direction, double part)
  {
    const int nv = m_mesh.number_of_vertices(), nf = m_mesh.number_of_faces();
    m_points_before = m_mesh.points;
    m_place_before = m_place;
    m_normal_before = m_normal;
    m_jacobian_before = m_jacobian;
    m_was_opposed.resize(nf);
    std::vector<double> energy_before(nf);
    double before = 0, after = 0;
    for(int f = 0; f < nf && goes_on(f); ++f)
    {
      m_was_opposed[f] = is_opposed(f);
      before += energy_before[f] = energy_of_quad(f);
    }
    for(int v = 0; v < nv && goes_on(v); ++v)
      if(m_unknown[v][0] != -1)
      {
        const Nearest nearest = walk_on_reference(v, m_mesh.points[v] + part * direction[v]);
        m_mesh.points[v] = nearest.point;
        m_place[v] = nearest.place;
      }
    std::vector<char> was_too_long = put_back();
    for(int f = 0; f < nf; ++f)
    {
      const double energy = energy_of_quad(f);
      after += energy;
      if(energy - energy_before[f] >
         tolerated_growth * (energy_before[f] - 4 * Rectangle_energy::least_with(m_area_weight)) + 4 * tolerated_rise)
        for(int v : m_mesh.corners[f])
          was_too_long[v] = 1;
    }
    for(int v = 0; v < nv; ++v)
      m_damping[v] =
        was_too_long[v] ? (std::max)(first_damping, more_damping * m_damping[v]) : less_damping * m_damping[v];

    if(after < before)
    {
      m_useless_steps = 0;
      return before - after > least_gain * (before - 4 * Rectangle_energy::least_with(m_area_weight) * nf);
    }
    m_mesh.points = m_points_before;
    m_place = m_place_before;
    m_normal = m_normal_before;
    m_jacobian = m_jacobian_before;
    m_longest_step *= shorter;
    return ++m_useless_steps < most_useless_steps;
  }

  // Puts the vertices of quads that must not be as they are now back to where they were, as long as there are any;
  // which ones.
  std::vector<char> put_back()
  {
    std::vector<char> is_back(m_mesh.number_of_vertices(), 0);
    std::vector<int> faces(m_mesh.number_of_faces()), around;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      faces[f] = f;
    for(; !faces.empty(); faces.swap(around))
    {
      around.clear();
      for(int i = 0; i < static_cast<int>(faces.size()) && goes_on(i); ++i)
      {
        const int f = faces[i];
        update_face(f);
        if(is_allowed(f))
          continue;
        for(int v : m_mesh.corners[f])
          if(m_unknown[v][0] != -1 && !is_back[v])
          {
            is_back[v] = 1;
            m_mesh.points[v] = m_points_before[v];
            m_place[v] = m_place_before[v];
            for(int j = m_first[v]; j < m_first[v + 1]; ++j)
              around.push_back(m_corner[j] / 4);
          }
      }
    }
    return is_back;
  }

  bool is_allowed(int f)
  {
    return m_jacobian[f] >= (std::min)(m_limit, m_jacobian_before[f]) &&
           (m_jacobian_before[f] <= 0 || m_normal[f] * m_normal_before[f] > 0) && (m_was_opposed[f] || !is_opposed(f));
  }

  double energy_of_quad(int f) const
  {
    const std::array<int, 4>& c = m_mesh.corners[f];
    double sum = 0;
    for(int k = 0; k < 4; ++k)
      sum += Rectangle_energy::value(m_mesh.points[c[(k + 1) & 3]] - m_mesh.points[c[k]],
                                     m_mesh.points[c[(k + 3) & 3]] - m_mesh.points[c[k]], m_normal[f], m_area[f],
                                     m_area_weight);
    if(m_wish.empty() || !(m_wish[f].weight > 0))
      return sum;
    const Vector_3 &d = m_wish[f].direction, across = cross_product(m_normal[f], d);
    for(int k = 0; k < 4; ++k)
    {
      const Vector_3 side = m_mesh.points[c[(k + 1) & 3]] - m_mesh.points[c[k]];
      sum += m_wish[f].weight * Side_turn_energy(side * d, side * across).value();
    }
    return sum;
  }

  std::vector<std::array<Vector_3, 2>> m_frame; // per vertex: the directions in which it may go
  std::vector<std::array<int, 2>> m_unknown;    // per vertex: how far along these, -1 where it may not
  int m_number_of_unknowns = 0;
  Eigen::VectorXd m_gradient;
  Matrix m_matrix;               // its lower triangle
  std::vector<double> m_damping; // per vertex
  const double m_area_weight = area_weight_for(m_length);
  double m_limit = -1; // for Jacobians, set in the first step
  double m_longest_step = longest_first_step;
  int m_useless_steps = 0;

  std::vector<Point_3> m_points_before; // the mesh before a step
  std::vector<int> m_place_before;
  std::vector<Vector_3> m_normal_before;
  std::vector<double> m_jacobian_before;
  std::vector<char> m_was_opposed;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_GLOBAL_QUAD_SMOOTHER_H
