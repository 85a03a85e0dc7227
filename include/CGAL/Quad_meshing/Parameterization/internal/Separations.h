// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEPARATIONS_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEPARATIONS_H

#include <CGAL/Quad_meshing/Parameterization/internal/Integer_relations.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Which grid points and grid lines of a seamless map lie so near to each other that rounding may put them onto
// each other, or change their order, and what to demand of the integers so that it does not.
//
// The map must have no fold-overs (it need not be rounded). From every vertex that has to become a grid point the
// faces within a small box are unfolded into its chart; other such vertices and aligned edges met there give
// separations. From every aligned edge a ray runs into the surface at a right angle; the first aligned edge that it
// meets gives one more. Aligned edges end the search: what lies behind is kept apart through them.
class Separations
{
public:
  // An offset between two things whose value, in a map that is valid, must not vanish or turn round.
  struct Separation
  {
    std::array<Integer_form, 2> offset; // an empty form: this coordinate does not count
    std::array<double, 2> wanted;       // its value in the reference map

    template <typename Vector>
    bool holds(const Vector& x) const
    {
      double s = 0;
      for(int c = 0; c < 2; ++c)
        s += wanted[c] * evaluate(offset[c], x);
      return s > 0;
    }

    // The coordinate that is to be kept at a distance, and the sign of that distance.
    int dominant() const
    {
      if(offset[0].terms.empty())
        return 1;
      if(offset[1].terms.empty())
        return 0;
      return std::abs(wanted[0]) >= std::abs(wanted[1]) ? 0 : 1;
    }
  };

  template <typename Vector>
  static double evaluate(const Integer_form& f, const Vector& x)
  {
    double s = f.constant;
    for(const Integer_form::Term& t : f.terms)
      s += t.second * x[t.first];
    return s;
  }

  std::vector<Separation> list;

  // `reference` is the map in which all things lie in the right order. The list is not complete if the visitor stops
  // the search.
  Separations(const Seamless_coordinates& coordinates, const std::vector<bool>& is_grid_point,
              const std::vector<bool>& is_aligned, const Eigen::VectorXd& reference, Stage_progress& progress)
    : m_coordinates(coordinates)
    , m_charts(coordinates.charts)
    , m_mesh(coordinates.charts.mesh)
    , m_is_grid_point(is_grid_point)
    , m_is_aligned(is_aligned)
    , m_reference(reference)
    , m_progress(progress)
  {
    // Rounding moves a difference of two coordinates by about half a unit, seldom by more than one.
    discover(reference, 1.5);
  }

  // Adds what lies nearer to each other than a number of grid units in another map. Around singular vertices the same
  // faces are met in more than one position, of which the first counts: the smaller the reach, the fewer are missed.
  void discover(const Eigen::VectorXd& map, double farthest)
  {
    const int searches_per_report = 32; // each takes up to a millisecond
    Small_steps steps(m_progress, searches_per_report);

    m_x = map;
    m_reach = farthest;
    m_reached_from.assign(m_mesh.number_of_faces(), -1);
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      if(!m_is_grid_point[v] || m_mesh.halfedge_of_vertex[v] == -1)
        continue;
      look_around(v);
      if(!steps.go_further())
        return;
    }
    for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if(m_is_aligned[m_mesh.edge_of[h]])
      {
        look_across(h);
        if(!steps.go_further())
          return;
      }
  }

private:
  // The chart of a face seen from a starting chart: p -> R90^rotation p + shift.
  struct Frame
  {
    int face;
    int rotation;
    Grid_form shift;
  };

  const Seamless_coordinates& m_coordinates;
  const Combed_charts& m_charts;
  const Indexed_triangle_mesh& m_mesh;
  const std::vector<bool> m_is_grid_point;
  const std::vector<bool>& m_is_aligned;
  const Eigen::VectorXd m_reference;
  Stage_progress& m_progress;
  Eigen::VectorXd m_x;
  std::vector<int> m_reached_from; // per face

  double m_reach = 0; // in grid units

  Grid_form corner_form(int corner) const
  {
    Grid_form p;
    for(int c = 0; c < 2; ++c)
    {
      for(const auto& t : m_coordinates.coordinates[m_charts.wedge_of_corner[corner]][c])
        p[c].terms.push_back(Integer_form::Term(t.first, static_cast<int>(t.second)));
      std::sort(p[c].terms.begin(), p[c].terms.end());
    }
    return p;
  }

  Grid_form seen(const Frame& frame, int corner) const
  {
    Grid_form p = rotated(corner_form(corner), frame.rotation);
    for(int c = 0; c < 2; ++c)
      p[c].add(frame.shift[c]);
    return p;
  }

  std::array<double, 2> position(const Grid_form& p) const { return { { evaluate(p[0], m_x), evaluate(p[1], m_x) } }; }

  Frame frame_beyond(const Frame& frame, int h) const
  {
    const int o = m_mesh.opposite[h];
    Frame beyond = frame;
    beyond.face = o / 3;
    if(m_charts.path_crossed(h) == 0)
      return beyond;
    beyond.rotation -= m_charts.quarters_across(h);
    const Grid_form p = seen(frame, h);
    const Grid_form q = rotated(corner_form(Indexed_triangle_mesh::next(o)), beyond.rotation);
    for(int c = 0; c < 2; ++c)
    {
      beyond.shift[c] = p[c];
      beyond.shift[c].add(q[c], -1);
    }
    return beyond;
  }

  Frame frame_at(int corner) const
  {
    Frame frame;
    frame.face = corner / 3;
    frame.rotation = 0;
    frame.shift = corner_form(corner);
    for(Integer_form& f : frame.shift)
      f.scale(-1);
    return frame;
  }

  void add(const Grid_form& offset, int coordinates_that_count)
  {
    Separation s;
    for(int c = 0; c < 2; ++c)
    {
      s.wanted[c] = evaluate(offset[c], m_reference);
      if((coordinates_that_count >> c) & 1)
        s.offset[c] = offset[c];
    }
    for(const Separation& known : list)
      if(known.offset[0].terms == s.offset[0].terms && known.offset[1].terms == s.offset[1].terms)
        return;
    if(!s.offset[0].terms.empty() || !s.offset[1].terms.empty())
      list.push_back(s);
  }

  void look_around(int v)
  {
    std::queue<Frame> front;
    for_each_corner_of_vertex(m_mesh, v,
                              [&](int h)
                              {
                                m_reached_from[h / 3] = v;
                                front.push(frame_at(h));
                              });

    while(!front.empty())
    {
      const Frame frame = front.front();
      front.pop();
      Grid_form p[3];
      std::array<double, 2> q[3];
      for(int k = 0; k < 3; ++k)
      {
        p[k] = seen(frame, 3 * frame.face + k);
        q[k] = position(p[k]);
        const int w = m_mesh.corners[frame.face][k];
        if(w != v && m_is_grid_point[w] && std::abs(q[k][0]) < m_reach && std::abs(q[k][1]) < m_reach)
          add(p[k], 3);
      }
      for(int k = 0; k < 3; ++k)
      {
        const int g = 3 * frame.face + k, l = (k + 1) % 3;
        if(m_is_aligned[m_mesh.edge_of[g]])
        {
          const int c = (m_coordinates.constant_coordinate(g) + frame.rotation) & 1; // the constant one, seen from v
          const double a = q[k][1 - c], b = q[l][1 - c];
          if((std::min)(a, b) < 0 && (std::max)(a, b) > 0 && std::abs(q[k][c]) < m_reach)
            add(p[k], 1 << c);
          continue;
        }
        if(m_mesh.opposite[g] == -1 || m_reached_from[m_mesh.opposite[g] / 3] == v)
          continue;
        bool outside = false; // the edge lies on one far side of the box
        for(int c = 0; c < 2; ++c)
          outside = outside || (std::min)(q[k][c], q[l][c]) > m_reach || (std::max)(q[k][c], q[l][c]) < -m_reach;
        if(outside)
          continue;
        m_reached_from[m_mesh.opposite[g] / 3] = v;
        front.push(frame_beyond(frame, g));
      }
    }
  }

  // A ray from the middle of an aligned halfedge into its face, at a right angle.
  void look_across(int h)
  {
    Frame frame = frame_at(h);
    const int along = 1 - m_coordinates.constant_coordinate(h), away = 1 - along;
    const double middle = 0.5 * position(seen(frame, Indexed_triangle_mesh::next(h)))[along];
    int entry = h;
    for(int steps = 0; steps < m_mesh.number_of_faces(); ++steps)
    {
      const int g = Indexed_triangle_mesh::next(entry), tip = Indexed_triangle_mesh::next(g);
      const double tip_along = position(seen(frame, tip))[along];
      const double start_along = position(seen(frame, entry))[along], end_along = position(seen(frame, g))[along];
      // the ray leaves through g (from the end of the entry edge to the tip) or through the edge after it
      const bool through_g =
        (tip_along - middle) * (end_along - middle) < 0 || ((tip_along - middle) == 0 && start_along < end_along);
      const int exit = through_g ? g : tip;
      const Grid_form p = seen(frame, exit);
      const std::array<double, 2> q = position(p), r = position(seen(frame, Indexed_triangle_mesh::next(exit)));
      if(m_is_aligned[m_mesh.edge_of[exit]])
      {
        const int c = (m_coordinates.constant_coordinate(exit) + frame.rotation) & 1;
        if(c == away && std::abs(q[away]) < m_reach)
          add(p, 1 << away);
        return;
      }
      if(m_mesh.opposite[exit] == -1 || (std::min)(std::abs(q[away]), std::abs(r[away])) > m_reach)
        return;
      frame = frame_beyond(frame, exit);
      entry = m_mesh.opposite[exit];
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEPARATIONS_H
