// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The body of a car, and a layout for it that was made by hand.

#ifndef CGAL_QUAD_MESHING_EXAMPLES_CAR_BODY_H
#define CGAL_QUAD_MESHING_EXAMPLES_CAR_BODY_H

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace car_body {

// Length along x, height of the waist along y, above which the sides lean inwards, and half the width, along z.
const double length = 4, waist = 0.6, half_width = 0.8;

// The height of the outline: hood, windshield, roof, rear window and trunk. Its bends lie at multiples of 0.1.
inline double height(double x)
{
  const std::array<std::array<double, 2>, 6> outline = {
    { { { 0, 0.5 } }, { { 1.2, 0.6 } }, { { 1.9, 1 } }, { { 2.9, 1 } }, { { 3.4, 0.6 } }, { { length, 0.55 } } }
  };
  std::size_t i = 1;
  while(i + 1 < outline.size() && x > outline[i][0])
    ++i;
  const double t = (x - outline[i - 1][0]) / (outline[i][0] - outline[i - 1][0]);
  return outline[i - 1][1] + t * (outline[i][1] - outline[i - 1][1]);
}

// From the box [0, 1]^3: its top becomes the outline, arched across the car; the windows lean inwards.
template <typename Point_3>
Point_3 on_body(double s, double t, double u)
{
  const double x = length * s, across = 2 * t - 1, up = u * height(x),
               lean = (std::max)(0., (up - waist) / (1 - waist));
  return Point_3(x, up + 0.05 * u * (1 - across * across), -half_width * across * (1 - 0.25 * lean * lean));
}

// A closed triangle mesh with 2240 n^2 triangles.
template <typename Mesh>
Mesh make(int n)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef
    typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type Point_3;
  const std::array<int, 3> size = { { 40 * n, 8 * n, 5 * n } };
  Mesh mesh;
  std::map<std::array<int, 3>, vertex_descriptor> vertices;
  auto vertex = [&](const std::array<int, 3>& i)
  {
    const auto found = vertices.find(i);
    if(found != vertices.end())
      return found->second;
    const vertex_descriptor v = add_vertex(mesh);
    put(get(CGAL::vertex_point, mesh), v,
        on_body<Point_3>(double(i[0]) / size[0], double(i[1]) / size[1], double(i[2]) / size[2]));
    return vertices[i] = v;
  };
  for(int axis = 0; axis < 3; ++axis)
    for(int side : { 0, size[axis] })
      for(int i = 0; i < size[(axis + 1) % 3]; ++i)
        for(int j = 0; j < size[(axis + 2) % 3]; ++j)
        {
          std::array<vertex_descriptor, 4> quad;
          const int corner[4][2] = { { i, j }, { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 } };
          for(int k = 0; k < 4; ++k)
          {
            std::array<int, 3> p;
            p[axis] = side;
            p[(axis + 1) % 3] = corner[k][0];
            p[(axis + 2) % 3] = corner[k][1];
            quad[side == 0 ? 3 - k : k] = vertex(p);
          }
          CGAL::Euler::add_face(quad, mesh);
        }
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

// The layout, in the format of `quadrangulate_layout`. Each side of the car has a fender, a door, another fender and a
// window. The doors end between the ends of the window, so there are six T-vertices on each side: two where the window
// begins and ends above the fenders, two where the doors end below the window, and two below them, at the underbody.
inline const char* layout()
{
  return R"(quad_layout 1
# the left side, z = 0.8 below the waist: bumper, hood, windshield, roof
node 0 0 0.8
node 0 0.5 0.8
node 1.2 0.6 0.8
node 1.9 1 0.6
node 2.9 1 0.6
node 3.4 0.6 0.8
node 4 0.55 0.8
node 4 0 0.8
# the ends of the door, below and at the waist
node 1.5 0 0.8
node 1.6 0.6 0.8
node 2.8 0 0.8
node 2.9 0.6 0.8
# the right side
node 0 0 -0.8
node 0 0.5 -0.8
node 1.2 0.6 -0.8
node 1.9 1 -0.6
node 2.9 1 -0.6
node 3.4 0.6 -0.8
node 4 0.55 -0.8
node 4 0 -0.8
node 1.5 0 -0.8
node 1.6 0.6 -0.8
node 2.8 0 -0.8
node 2.9 0.6 -0.8
# left: 0-2 along the underbody, 3-9 front, hood, windshield, roof, rear window, trunk and rear
arc 0 8 aligned
arc 8 10 aligned
arc 10 7 aligned
arc 0 1 aligned
arc 1 2 aligned
arc 2 3 aligned
arc 3 4 aligned
arc 4 5 aligned
arc 5 6 aligned
arc 6 7 aligned
# 10-12 the waist, 13 and 14 the ends of the door
arc 2 9
arc 9 11
arc 11 5
arc 8 9 aligned
arc 10 11 aligned
# right, in the same order
arc 12 20 aligned
arc 20 22 aligned
arc 22 19 aligned
arc 12 13 aligned
arc 13 14 aligned
arc 14 15 aligned
arc 15 16 aligned
arc 16 17 aligned
arc 17 18 aligned
arc 18 19 aligned
arc 14 21
arc 21 23
arc 23 17
arc 20 21 aligned
arc 22 23 aligned
# 30-37 across: underbody in front, hood in front, windshield below and above, rear window above and below, trunk, rear
arc 0 12 aligned
arc 1 13 aligned
arc 2 14 aligned
arc 3 15 aligned
arc 4 16 aligned
arc 5 17 aligned
arc 6 18 aligned
arc 7 19 aligned
# underbody, front, rear
patch +30 / +15 +16 +17 / -37 / -2 -1 -0
patch +3 / +31 / -18 / -30
patch +37 / -24 / -36 / +9
# hood, windshield, roof, rear window, trunk
patch +4 / +32 / -19 / -31
patch +5 / +33 / -20 / -32
patch +6 / +34 / -21 / -33
patch +7 / +35 / -22 / -34
patch +8 / +36 / -23 / -35
# left: fender, door, fender, window
patch +0 / +13 / -10 -4 / -3
patch +1 / +14 / -11 / -13
patch +2 / -9 / -8 -12 / -14
patch +10 +11 +12 / -7 / -6 / -5
# right
patch +18 / +19 +25 / -28 / -15
patch +28 / +26 / -29 / -16
patch +29 / +27 +23 / +24 / -17
patch +20 / +21 / +22 / -27 -26 -25
)";
}

} // namespace car_body

#endif // CGAL_QUAD_MESHING_EXAMPLES_CAR_BODY_H
