// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_QUAD_SMOOTHER_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_QUAD_SMOOTHER_H

#include <CGAL/Quad_meshing/Smoothing/internal/Corner_energy.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Quad_mesh_on_reference.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Side_turn_energy.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Smooths a quad mesh on a reference surface, vertex by vertex.
//
// Every corner of a quad pays its energy, which is least for a square corner with the mean area of its neighbourhood,
// see `Corner_energy`.
//
// A vertex takes one Newton step in its tangent plane, or along its curve, against the energy of
// the corners that it is a part of, is projected back, and stays there if that really helps and makes
// the worst quad around it no worse. So a quad that is convex stays so, whatever happens around it.
class Quad_smoother : public Quad_mesh_on_reference
{
public:
  // A vertex rests when its last step was shorter than this, relative to the sides around it.
  static constexpr double resting_step = 0.003;
  // Longest step, relative to the sides around the vertex.
  static constexpr double longest_step = 0.5;
  // Number of quads around a folded one whose vertices take part in unfolding it, and of rounds.
  static constexpr int unfolding_rings = 3, unfolding_rounds = 40;

  using Quad_mesh_on_reference::Quad_mesh_on_reference;

  // Tries to unfold. The best mesh on the way is kept: with the fewest quads that are not convex,
  // and then the fewest folded ones.
  void unfold(std::vector<int> folded)
  {
    auto badness = [&]
    {
      return std::make_pair(std::count_if(m_jacobian.begin(), m_jacobian.end(), [](double j) { return j <= 0; }),
                            folded.size());
    };
    std::vector<Point_3> best_points = m_mesh.points;
    std::vector<int> best_place = m_place;
    std::vector<char> best_is_off = m_is_off;
    auto best = badness();
    for(int round = 0; round < unfolding_rounds && !folded.empty() && m_visitor.go_further(); ++round)
    {
      std::vector<int> region_faces, region_vertices;
      grow(folded, region_faces, region_vertices);
      for(int i = 0; i < static_cast<int>(region_faces.size()) && goes_on(i); ++i)
        m_normal[region_faces[i]] = reference_normal(region_faces[i]);
      for(int i = 0; i < static_cast<int>(region_vertices.size()) && goes_on(i); ++i)
      {
        m_was_unfolded[region_vertices[i]] = 1;
        improve(region_vertices[i], false);
      }
      for(int f : region_faces)
        update_face(f);
      folded = folded_quads();
      if(badness() < best)
      {
        best = badness();
        best_points = m_mesh.points;
        best_place = m_place;
        best_is_off = m_is_off;
      }
    }
    m_mesh.points.swap(best_points);
    m_place.swap(best_place);
    m_is_off.swap(best_is_off);
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      update_face(f);
  }

  void start_sweeps() { m_active.assign(m_mesh.number_of_vertices(), 1); }

  // One sweep over the vertices that do not rest; false if all do.
  bool sweep()
  {
    update_scales();
    bool any = false;
    for(int v = 0; v < m_mesh.number_of_vertices() && goes_on(v); ++v)
    {
      if(m_kind[v] == fixed || !m_active[v])
        continue;
      const double step = improve(v, true);
      m_active[v] = 0;
      if(step * step <= resting_step * resting_step * m_scale[v])
        continue;
      any = true;
      for(int i = m_first[v]; i < m_first[v + 1]; ++i)
        for(int w : m_mesh.corners[m_corner[i] / 4])
          m_active[w] = 1;
    }
    return any;
  }

protected:
  // An orthonormal frame of the directions in which v may go; the second one is zero on a curve.
  std::array<Vector_3, 2> directions(int v) const
  {
    if(m_kind[v] != on_surface)
      return { { (m_kind[v] == on_feature ? m_features : m_borders).direction(m_place[v]), Vector_3(0, 0, 0) } };
    Vector_3 normal(0, 0, 0);
    for(int i = m_first[v]; i < m_first[v + 1]; ++i)
      normal = normal + m_normal[m_corner[i] / 4];
    normal = unit_or_zero(normal);
    if(normal == NULL_VECTOR)
      normal = m_surface.normal(m_place[v]);
    Vector_3 u = CGAL::abs(normal.x()) < 0.6 ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0);
    u = unit_or_zero(u - (u * normal) * normal);
    return { { u, cross_product(normal, u) } };
  }

  // Moves v to a better place, if the step downhill leads to one, and gives the length of the step.
  double improve(int v, bool guarded)
  {
    if(m_kind[v] == fixed)
      return 0;
    const Point_3 p = m_mesh.points[v];

    const std::array<Vector_3, 2> frame = directions(v);
    const Vector_3 &u = frame[0], &w = frame[1];

    // the smallest corner area decides whether, and how much, the energy must be regularized
    double smallest = std::numeric_limits<double>::infinity(), aim_sum = 0;
    for(int i = m_first[v]; i < m_first[v + 1]; ++i)
    {
      aim_sum += m_area[m_corner[i] / 4];
      for(const Corner_energy& t : corners_at(m_corner[i], p))
        smallest = (std::min)(smallest, t.area);
    }
    const double mean_aim = aim_sum / (m_first[v + 1] - m_first[v]);
    const double epsilon =
      smallest > 0
        ? 0
        : std::sqrt(least_epsilon * least_epsilon * mean_aim * mean_aim + epsilon_slope * smallest * smallest);

    Corner_energy_model model(u, w);
    for(int i = m_first[v]; i < m_first[v + 1]; ++i)
      for(const Corner_energy& t : corners_at(m_corner[i], p))
        model.add(t, m_area[m_corner[i] / 4], epsilon);
    if(guarded)
      for_each_wish(v, p,
                    [&](const Vector_3& side, const Vector_3& along, const Vector_3& across, double weight)
                    { model.add_side(side, along, across, weight); });
    Vector_3 step = m_kind[v] == on_surface ? model.step_in_plane() : model.step_along_u();
    const double length = std::sqrt(step.squared_length()), longest = longest_step * std::sqrt(mean_aim);
    if(!(length > 0))
      return 0;
    if(length > longest)
      step = (longest / length) * step;

    double factor = 1;
    for(int trial = 0; trial < 4; ++trial, factor /= 3)
      if(try_move(v, p + factor * step, model.value(), epsilon, guarded))
        return std::sqrt(squared_distance(p, m_mesh.points[v]));

    // a vertex between the two sides of a fold, or of a crease: the middle of its neighbours
    if(!guarded)
    {
      Vector_3 sum(0, 0, 0);
      for(int i = m_first[v]; i < m_first[v + 1]; ++i)
        sum = sum + (m_mesh.points[m_mesh.target(m_corner[i])] - p) +
              (m_mesh.points[m_mesh.source(m_mesh.prev(m_corner[i]))] - p);
      if(try_move(v, p + sum / (2 * (m_first[v + 1] - m_first[v])), model.value(), epsilon, guarded))
        return std::sqrt(squared_distance(p, m_mesh.points[v]));
    }
    return 0;
  }

private:
  // The faces around the given ones, and the vertices of these faces.
  void grow(const std::vector<int>& seeds, std::vector<int>& region_faces, std::vector<int>& region_vertices) const
  {
    std::vector<char> has_face(m_mesh.number_of_faces(), 0), has_vertex(m_mesh.number_of_vertices(), 0);
    region_faces = seeds;
    for(int f : seeds)
      has_face[f] = 1;
    for(std::size_t i = 0, end = region_faces.size(), ring = 0; ring <= unfolding_rings;
        ++ring, end = region_faces.size())
      for(; i < end; ++i)
        for(int v : m_mesh.corners[region_faces[i]])
        {
          if(has_vertex[v])
            continue;
          has_vertex[v] = 1;
          region_vertices.push_back(v);
          for(int j = m_first[v]; j < m_first[v + 1]; ++j)
            if(!has_face[m_corner[j] / 4])
            {
              has_face[m_corner[j] / 4] = 1;
              region_faces.push_back(m_corner[j] / 4);
            }
        }
    std::sort(region_faces.begin(), region_faces.end());
    std::sort(region_vertices.begin(), region_vertices.end());
  }

  // The three corners that move with the source of h.
  std::array<Corner_energy, 3> corners_at(int h, const Point_3& p) const
  {
    const std::array<int, 4>& c = m_mesh.corners[h / 4];
    return Corner_energy::around(p, m_mesh.points[c[(h + 1) & 3]], m_mesh.points[c[(h + 2) & 3]],
                                 m_mesh.points[c[(h + 3) & 3]], m_normal[h / 4]);
  }

  // The energy at p of all corners that move with v; infinite if one folds that may not (epsilon 0). What is
  // unfolded has no directions.
  double energy(int v, const Point_3& p, double epsilon, bool guarded) const
  {
    double sum = 0;
    for(int i = m_first[v]; i < m_first[v + 1]; ++i)
      for(const Corner_energy& t : corners_at(m_corner[i], p))
      {
        if(epsilon == 0 && t.area <= 0)
          return std::numeric_limits<double>::infinity();
        sum += t.value(m_area[m_corner[i] / 4], epsilon);
      }
    if(guarded)
      for_each_wish(v, p,
                    [&](const Vector_3& side, const Vector_3& along, const Vector_3& across, double weight)
                    { sum += weight * Side_turn_energy(side * along, side * across).value(); });
    return sum;
  }

  // Calls f(side, unit direction wanted, direction across it, weight) for the sides that move with v, once for each
  // quad.
  template <typename Function>
  void for_each_wish(int v, const Point_3& p, const Function& f) const
  {
    if(m_wish.empty())
      return;
    for(int i = m_first[v]; i < m_first[v + 1]; ++i)
    {
      const int h = m_corner[i];
      const Wanted_directions::Wish& wish = m_wish[h / 4];
      if(!(wish.weight > 0))
        continue;
      const Vector_3 across = cross_product(m_normal[h / 4], wish.direction);
      for(int w : { m_mesh.target(h), m_mesh.source(m_mesh.prev(h)) })
        f(m_mesh.points[w] - p, wish.direction, across, wish.weight);
    }
  }

  // Moves v to the place on its reference that is closest to a point, if its energy falls below
  // `value` there.
  bool try_move(int v, const Point_3& p, double value, double epsilon, bool guarded)
  {
    const Nearest nearest = walk_on_reference(v, p);
    if(!(energy(v, nearest.point, epsilon, guarded) < value) ||
       (guarded && !is_safe(v, nearest.point, guarded_jacobian)))
      return false;
    m_place[v] = nearest.place;
    m_is_off[v] = 0;
    if(guarded)
      move(v, nearest.point);
    else
      m_mesh.points[v] = nearest.point;
    return true;
  }

  // Regularization of folded corners: a part of the area aimed at, and of the largest fold.
  static constexpr double least_epsilon = 1e-3, epsilon_slope = 0.04;

  std::vector<char> m_active; // per vertex: takes part in the next sweep
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_QUAD_SMOOTHER_H
