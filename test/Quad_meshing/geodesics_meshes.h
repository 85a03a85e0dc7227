// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_TEST_GEODESICS_MESHES_H
#define CGAL_QUAD_MESHING_TEST_GEODESICS_MESHES_H

// Meshes on which geodesic distances are known, and small tools for them.

#include "test_meshes.h"

#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_field.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace geodesics_meshes {

using namespace test_meshes;

typedef CGAL::Quad_meshing::Geodesic_distance_field<Mesh> Field;
typedef Field::Face_location Location;

// The point of a location.
inline Point_3 point(const Mesh& tm, const Location& l)
{
  Vector_3 p(0, 0, 0);
  auto h = tm.halfedge(l.first);
  for(int k = 0; k < 3; ++k, h = tm.next(h))
    p = p + l.second[k] * (tm.point(tm.source(h)) - CGAL::ORIGIN);
  return CGAL::ORIGIN + p;
}

inline double length(const Mesh& tm, const std::vector<Location>& path)
{
  double sum = 0;
  for(std::size_t i = 1; i < path.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(point(tm, path[i - 1]), point(tm, path[i])));
  return sum;
}

inline double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

inline double distance_to_segment(const Point_3& p, const Point_3& a, const Point_3& b)
{
  const double s = (std::min)((std::max)(((p - a) * (b - a)) / CGAL::squared_distance(a, b), 0.), 1.);
  return distance(p, a + s * (b - a));
}

// A rotation of space that leaves no coordinate plane in place.
inline Point_3 rotated(const Point_3& p)
{
  const double c = std::cos(0.3), s = std::sin(0.3), d = std::cos(0.7), t = std::sin(0.7);
  const double x = c * p.x() - s * p.y(), y = s * p.x() + c * p.y();
  return Point_3(x, d * y - t * p.z(), t * y + d * p.z());
}

// A square of n x n cells in the plane whose inner vertices are moved a little.
inline Soup uneven_square(int n, unsigned int seed)
{
  CGAL::Random random(seed);
  return mapped(grid(n, n),
                [&](const Point_3& p)
                {
                  const bool is_inside = p.x() > 0 && p.x() < 1 && p.y() > 0 && p.y() < 1;
                  const double size = is_inside ? 0.25 / n : 0, dx = random.get_double(-1., 1.),
                               dy = random.get_double(-1., 1.);
                  return Point_3(p.x() + size * dx, p.y() + size * dy, 0);
                });
}

// A fan of n triangles around vertex 0, each with the angle `angle` at the apex, refined `levels` times, with sides of
// length 1 at the apex: vertex i + 1 lies in direction i * angle. Its shape in space does not matter to distances; a
// total angle above 2 pi is reached by a zigzag. The border is open or closed. n must be even.
inline Soup fan(int n, double angle, bool closed)
{
  // Spokes alternate between two heights z and -z on a cone around the z-axis with azimuth steps of phi.
  const double phi = (closed ? 2 * pi : (std::min)(1.5 * pi, n * angle)) / n;
  double low = 0, high = pi / 2;
  // cos(angle) = cos^2(e) cos(phi) - sin^2(e) with elevation e falls with e
  for(int i = 0; i < 200; ++i)
  {
    const double e = (low + high) / 2;
    (std::cos(e) * std::cos(e) * std::cos(phi) - std::sin(e) * std::sin(e) > std::cos(angle) ? low : high) = e;
  }
  Soup soup;
  soup.points.emplace_back(0, 0, 0);
  const int spokes = closed ? n : n + 1;
  for(int i = 0; i < spokes; ++i)
    soup.points.emplace_back(std::cos(low) * std::cos(i * phi), std::cos(low) * std::sin(i * phi),
                             i % 2 == 0 ? std::sin(low) : -std::sin(low));
  for(std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
    soup.triangles.push_back({ { 0, i + 1, (i + 1) % spokes + 1 } });
  return soup;
}

// The distance of two points at radii r and s on a cone of total angle `total` whose directions differ by `angle`.
inline double cone_distance(double r, double s, double angle, double total)
{
  angle = std::fmod(std::fabs(angle), total);
  angle = (std::min)(angle, total - angle);
  return angle >= pi ? r + s : std::sqrt((std::max)(0., r * r + s * s - 2 * r * s * std::cos(angle)));
}

} // namespace geodesics_meshes

#endif // CGAL_QUAD_MESHING_TEST_GEODESICS_MESHES_H
