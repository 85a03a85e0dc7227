// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_QUAD_UNTANGLER_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_QUAD_UNTANGLER_H

#include <CGAL/Quad_meshing/Smoothing/internal/Global_quad_smoother.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Makes the scaled Jacobians of a few bad quads positive, whatever the other energies say.
//
// The energies of the corners know the plane of a quad only; where quads are bent over a feature or lie in a narrow
// place, their minimum can have a negative scaled Jacobian. Here every quad pays (t - j)^2 for a minimal scaled
// Jacobian j below t, and one more if j is not positive. Vertices around bad quads try places on their references in
// some directions, at smaller and smaller distances, and take the best one: no derivatives are needed, and the sum
// falls with every move.
class Quad_untangler : public Global_quad_smoother
{
public:
  using Global_quad_smoother::Global_quad_smoother;

  // Where the vertices are now is where `untangle()` can go back to.
  void set_start()
  {
    m_start = m_mesh.points;
    m_start_place = m_place;
  }

  // Works on the quads whose Jacobian is not positive, or that are opposed to the surface, if they are not too many. No
  // round leaves more of them. Where moving vertices does not help, the smoothing has pushed them into each other: a
  // part of the mesh around goes back to the start, and the bad quads that this leaves are worked on again.
  void untangle()
  {
    std::vector<int> bad = folded_quads();
    if(bad.size() > most_bad_quads)
      return;
    bool is_useful = true;
    for(int round = 0; is_useful && round < rounds && !bad.empty() && m_visitor.go_further(); ++round)
      is_useful = change(bad, bad.size(), [&] { lift_around(bad, rings + round); });
    if(m_start.size() == m_mesh.points.size())
      for(int back = 1; back <= most_rings_back && !bad.empty() && m_visitor.go_further(); back *= 2)
        change(bad, bad.size() - 1,
               [&]
               {
                 go_back(vertices_around(bad, back));
                 lift_around(folded_quads(), rings);
               });
  }

  // A vertex that does not move, between two sides along curves of the reference, at which a quad cannot have a
  // positive Jacobian; -1 if there is none for this quad.
  int flat_corner(int f) const
  {
    for(int h = 4 * f; h < 4 * f + 4; ++h)
    {
      const int before = m_mesh.prev(h), v = m_mesh.source(h);
      if(m_kind[v] != fixed || !is_on_curve(h) || !is_on_curve(before))
        continue;
      const Vector_3 a = unit_or_zero(m_mesh.points[m_mesh.target(h)] - m_mesh.points[v]),
                     b = unit_or_zero(m_mesh.points[m_mesh.source(before)] - m_mesh.points[v]);
      if(cross_product(a, b) * m_normal[f] < least_sine)
        return v;
    }
    return -1;
  }

private:
  // The Jacobian from which on a quad pays nothing, and up to which it counts as not positive.
  static constexpr double aim = 0.3, least_positive = 1e-3;
  // Rounds, each with one more ring of quads around the bad ones, that begin with so many, and sweeps in each.
  static constexpr int rounds = 4, rings = 1, sweeps = 30;
  // Rings that go back to the start; more are another mesh.
  static constexpr int most_rings_back = 16;
  // Directions that are tried, and distances: from a part of the sides around the vertex down to a hundred thousandth
  // of them, as quads between two features may be as narrow.
  static constexpr int number_of_directions = 16, number_of_distances = 10;
  static constexpr double longest = 0.4, shorter_by = 0.3;
  // So many quads are not tangled here and there: the mesh has no room, or its layout is wrong.
  static constexpr std::size_t most_bad_quads = 100;
  // Least gain of a move, and the sine of angles between curves that leave no room for a quad: of a tenth of a degree.
  static constexpr double least_gain_of_move = 1e-6, least_sine = 0.002;

  std::vector<Point_3> m_start; // per vertex
  std::vector<int> m_start_place;

  // Makes a change if it leaves at most so many bad quads, which `bad` then holds; returns whether it does.
  template <typename Change>
  bool change(std::vector<int>& bad, std::size_t most, const Change& make)
  {
    const std::vector<Point_3> points = m_mesh.points;
    const std::vector<int> place = m_place;
    make();
    const std::vector<int> left = folded_quads();
    if(left.size() <= most)
    {
      bad = left;
      return true;
    }
    m_mesh.points = points;
    m_place = place;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      update_face(f);
    return false;
  }

  void lift_around(const std::vector<int>& bad, int number_of_rings)
  {
    update_scales();
    const std::vector<int> vertices = vertices_around(bad, number_of_rings);
    bool any = true;
    for(int sweep = 0; any && sweep < sweeps; ++sweep)
    {
      any = false;
      for(int v : vertices)
        any = (m_visitor.go_further() && lift(v)) || any;
    }
  }

  void go_back(const std::vector<int>& vertices)
  {
    for(int v : vertices)
      if(m_start_place[v] != -1)
      {
        m_place[v] = m_start_place[v];
        move(v, m_start[v]);
      }
  }

  bool is_on_curve(int h) const { return m_mesh.is_border(h) || m_mesh.is_feature[h]; }

  std::vector<int> vertices_around(const std::vector<int>& faces, int number_of_rings) const
  {
    std::vector<char> is_in(m_mesh.number_of_vertices(), 0);
    std::vector<int> result;
    auto add = [&](int f)
    {
      for(int v : m_mesh.corners[f])
        if(!is_in[v])
        {
          is_in[v] = 1;
          result.push_back(v);
        }
    };
    for(int f : faces)
      add(f);
    for(int ring = 0; ring < number_of_rings; ++ring)
      for(std::size_t i = 0, end = result.size(); i < end; ++i)
        for(int j = m_first[result[i]]; j < m_first[result[i] + 1]; ++j)
          add(m_corner[j] / 4);
    return result;
  }

  // What the quads around v pay if it is at p.
  double price(int v, const Point_3& p) const
  {
    double sum = 0;
    for(int i = m_first[v]; i < m_first[v + 1]; ++i)
    {
      const int h = m_corner[i];
      const std::array<int, 4>& c = m_mesh.corners[h / 4];
      Vector_3 normal;
      const double j = minimal_scaled_jacobian(p, m_mesh.points[c[(h + 1) & 3]], m_mesh.points[c[(h + 2) & 3]],
                                               m_mesh.points[c[(h + 3) & 3]], normal);
      sum += (j < aim ? (aim - j) * (aim - j) : 0) + (j < least_positive ? 1 : 0);
    }
    return sum;
  }

  int opposed_around(int v)
  {
    int n = 0;
    for(int i = m_first[v]; i < m_first[v + 1]; ++i)
      n += is_opposed(m_corner[i] / 4);
    return n;
  }

  // Moves v to the best place that is tried; whether there is one.
  bool lift(int v)
  {
    if(m_kind[v] == fixed || !(m_scale[v] > 0) || m_place[v] == -1)
      return false;
    const Point_3 start = m_mesh.points[v];
    const double before = price(v, start);
    if(before == 0)
      return false;
    const int start_place = m_place[v], opposed_before = opposed_around(v);
    const std::array<Vector_3, 2> frame = directions(v);
    const int n = m_kind[v] == on_surface ? number_of_directions : 2;
    std::vector<std::pair<double, Nearest>> places;
    double distance = longest * std::sqrt(m_scale[v]);
    for(int k = 0; k < number_of_distances; ++k, distance *= shorter_by)
      for(int i = 0; i < n; ++i)
      {
        const double angle = 2 * CGAL_PI * i / n;
        const Nearest q =
          walk_on_reference(v, start + distance * (std::cos(angle) * frame[0] + std::sin(angle) * frame[1]));
        const double after = price(v, q.point);
        if(after < before - least_gain_of_move)
          places.push_back({ after, q });
      }
    std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for(const auto& p : places)
    {
      m_place[v] = p.second.place;
      move(v, p.second.point);
      if(opposed_around(v) <= opposed_before)
      {
        m_is_off[v] = 0;
        return true;
      }
    }
    m_place[v] = start_place;
    move(v, start);
    return false;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_QUAD_UNTANGLER_H
