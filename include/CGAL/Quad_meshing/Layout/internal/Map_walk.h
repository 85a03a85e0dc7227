// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_MAP_WALK_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_MAP_WALK_H

#include <CGAL/Quad_meshing/Layout/internal/Embedded_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_charts.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_parameterization.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Finds the place on the surface of a point of a chart, by walking along a straight line over the triangles of the map.
//
// An arc that is not aligned is no straight line in the chart, so triangles of a neighbouring patch can cover points of
// the chart: where the walk crosses an arc, it goes on in the other chart by the transition function (7.4).
class Map_walk
{
public:
  // A point counts as inside a triangle if it is outside by no more than this part of the triangle's height.
  static constexpr double tolerance = 1e-9;

  // A place: a face, and the map from the chart in which the walk is asked for to the chart of the face.
  struct Place
  {
    int face = -1;
    Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();
    Eigen::Vector2d point; // in the chart that is asked for

    Eigen::Vector2d there(const Eigen::Vector2d& p) const { return linear * p + shift; }
  };

  Map_walk(const Embedded_layout& e, const Layout_parameterization& parameterization, const Layout_charts& charts)
    : m_e(e), m_map(parameterization), m_frame(2 * e.number_of_arcs()), m_faces(e.number_of_patches())
  {
    for(int d = 0; d < 2 * e.number_of_arcs(); ++d)
      if(e.topology.patch_of_direction[d] != -1)
        m_frame[d] = charts.frame(d);
    for(int f = 0; f < e.mesh().number_of_faces(); ++f)
      m_faces[e.patch[f]].push_back(f);
  }

  // A place in a patch near a point of its chart from where straight lines stay in the chart; its face is -1 if there
  // is none.
  Place start(int patch, const Quadrilateral_chart& chart, const Eigen::Vector2d& p) const
  {
    Place best;
    double best_distance = (std::numeric_limits<double>::infinity)();
    for(int f : m_faces[patch])
    {
      const Eigen::Vector2d c = (corner(3 * f) + corner(3 * f + 1) + corner(3 * f + 2)) / 3;
      const double d = (c - p).squaredNorm();
      if(d < best_distance && contains(chart, c))
      {
        best_distance = d;
        best.face = f;
        best.point = c;
      }
    }
    return best;
  }

  // Moves a place to a point of its chart. False if the walk does not arrive; the place is as it was then.
  bool walk(Place& place, const Eigen::Vector2d& target) const
  {
    const Indexed_triangle_mesh& m = m_e.mesh();
    Place now = place;
    int entry = -1;
    for(int step = 0; step <= m.number_of_faces(); ++step)
    {
      const Eigen::Vector2d q = now.there(target), from = now.there(now.point);
      std::array<Eigen::Vector2d, 3> c;
      for(int k = 0; k < 3; ++k)
        c[k] = corner(3 * now.face + k);
      const double area = cross_product_2(c[1] - c[0], c[2] - c[0]);
      int exit = -1, worst = -1;
      double worst_value = -tolerance * area;
      for(int k = 0; k < 3; ++k)
      {
        const int h = 3 * now.face + k;
        const double o = cross_product_2(c[(k + 1) % 3] - c[k], q - c[k]);
        if(!(o < -tolerance * area) || h == entry)
          continue;
        if(o < worst_value)
        {
          worst = h;
          worst_value = o;
        }
        // the line leaves through the side whose ends lie on both sides of it
        if(cross_product_2(q - from, c[k] - from) <= 0 && cross_product_2(q - from, c[(k + 1) % 3] - from) >= 0)
          exit = h;
      }
      if(worst == -1)
      {
        now.point = target;
        place = now;
        return true;
      }
      if(exit == -1)
        exit = worst;
      const int o = m.opposite[exit];
      if(o == -1)
        return false;
      const int d = m_e.surface.direction[exit];
      if(d != -1)
      {
        const Eigen::Matrix2d back = m_frame[d].matrix().inverse(), forth = m_frame[d ^ 1].matrix();
        now.linear = forth * back * now.linear;
        now.shift = m_frame[d ^ 1].origin + forth * back * (now.shift - m_frame[d].origin);
      }
      now.face = o / 3;
      entry = o;
    }
    return false;
  }

  // The point of the surface at a place.
  Indexed_triangle_mesh::Point_3 point(const Place& place) const
  {
    const Eigen::Vector2d q = place.there(place.point);
    std::array<double, 3> w;
    double sum = 0;
    for(int k = 0; k < 3; ++k)
    {
      const Eigen::Vector2d &a = corner(3 * place.face + (k + 1) % 3), &b = corner(3 * place.face + (k + 2) % 3);
      w[k] = (std::max)(cross_product_2(b - a, q - a), 0.);
      sum += w[k];
    }
    const std::array<int, 3>& c = m_e.mesh().corners[place.face];
    const Indexed_triangle_mesh::Point_3& origin = m_e.mesh().points[c[0]];
    if(!(sum > 0))
      return origin;
    return origin + (w[1] / sum) * (m_e.mesh().points[c[1]] - origin) +
           (w[2] / sum) * (m_e.mesh().points[c[2]] - origin);
  }

private:
  const Eigen::Vector2d& corner(int h) const { return m_map.place[m_map.copy[h]]; }

  static bool contains(const Quadrilateral_chart& chart, const Eigen::Vector2d& p)
  {
    for(int k = 0; k < 4; ++k)
      if(cross_product_2(chart.corner[(k + 1) % 4] - chart.corner[k], p - chart.corner[k]) < 0)
        return false;
    return true;
  }

  const Embedded_layout& m_e;
  const Layout_parameterization& m_map;
  std::vector<Layout_charts::Frame> m_frame; // per direction
  std::vector<std::vector<int>> m_faces;     // per patch
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_MAP_WALK_H
