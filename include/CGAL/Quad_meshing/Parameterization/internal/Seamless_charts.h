// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEAMLESS_CHARTS_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEAMLESS_CHARTS_H

#include <CGAL/Quad_meshing/internal/Grid_automorphism.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

typedef std::array<double, 2> Chart_point;

// Headings are the directions of the axes, counterclockwise: 0 to 3 for u, v, -u, -v. The coordinate of a point along
// one of them:
inline double along(const Chart_point& p, int heading) { return (heading & 2) != 0 ? -p[heading & 1] : p[heading & 1]; }

// How far q is ahead of p.
inline double distance_along(const Chart_point& p, const Chart_point& q, int heading)
{
  return along(q, heading) - along(p, heading);
}

inline Chart_point moved(Chart_point p, int heading, double distance)
{
  p[heading & 1] += (heading & 2) != 0 ? -distance : distance;
  return p;
}

// The images of all triangles under a seamless map.
struct Seamless_charts
{
  typedef Indexed_triangle_mesh Mesh;

  Mesh mesh;
  std::vector<Chart_point> corner; // per halfedge: its source in the chart of its face
  std::vector<signed char> turn;   // per halfedge: quarters from the chart of its face to the one beyond it
  std::vector<bool> is_aligned;    // per edge: it lies on a line of one coordinate

  // A point of the chart of the face of h, in the chart beyond h.
  Chart_point across(int h, const Chart_point& p) const
  {
    const Chart_point &from = corner[h], &to = corner[Mesh::next(mesh.opposite[h])];
    double x = p[0] - from[0], y = p[1] - from[1];
    Grid_automorphism::rotate(turn[h], x, y);
    return { { x + to[0], y + to[1] } };
  }

  int heading_across(int h, int heading) const { return (heading + turn[h]) & 3; }

  // The heading of the image of a halfedge, -1 if it is not parallel to an axis.
  int heading_of(int h) const
  {
    const Chart_point &a = corner[h], &b = corner[Mesh::next(h)];
    for(int d = 0; d < 4; ++d)
      if(distance_along(a, b, d) > 0 && distance_along(a, b, (d + 1) & 3) == 0)
        return d;
    return -1;
  }

  // Whether a heading lies in the corner at the source of h: from h on, inclusively, and up to the edge before it.
  bool is_in_corner(int h, int heading) const
  {
    const Chart_point &p = corner[h], &right = corner[Mesh::next(h)], &left = corner[Mesh::prev(h)];
    const int l = (heading + 1) & 3;
    const double r = distance_along(p, right, l);
    return (r < 0 || (r == 0 && distance_along(p, right, heading) > 0)) && distance_along(p, left, l) > 0;
  }

  // Calls f(h, heading) for every heading at a vertex, counterclockwise; h is the corner that it lies in.
  template <typename Function>
  void for_each_heading(int v, const Function& f) const
  {
    for_each_corner_of_vertex(mesh, v,
                              [&](int h)
                              {
                                // two follow each other in a corner of more than a right angle
                                for(int d = 0; d < 4; ++d)
                                  if(is_in_corner(h, d) && !is_in_corner(h, (d + 3) & 3))
                                  {
                                    f(h, d);
                                    if(is_in_corner(h, (d + 1) & 3))
                                      f(h, (d + 1) & 3);
                                  }
                              });
  }

  // The weights of the corners of a face at a point of its chart.
  std::array<double, 3> weights(int face, const Chart_point& p) const
  {
    std::array<double, 3> w;
    double sum = 0;
    for(int k = 0; k < 3; ++k)
    {
      w[k] = (std::max)(0., double_area(corner[3 * face + (k + 1) % 3], corner[3 * face + (k + 2) % 3], p));
      sum += w[k];
    }
    for(double& x : w)
      x = sum > 0 ? x / sum : 1. / 3; // in a triangle thinner than rounding errors any point is as good
    return w;
  }

  static double double_area(const Chart_point& a, const Chart_point& b, const Chart_point& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_SEAMLESS_CHARTS_H
