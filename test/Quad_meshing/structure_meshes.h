// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_TEST_STRUCTURE_MESHES_H
#define CGAL_QUAD_MESHING_TEST_STRUCTURE_MESHES_H

// Quad meshes for tests of the structure algorithms. Every face is counterclockwise seen from
// outside.

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace structure_meshes {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

constexpr double pi = 3.14159265358979323846;

struct Quad_soup
{
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 4>> quads;
};

template <typename QuadMesh = Mesh>
QuadMesh make_mesh(const Quad_soup& soup)
{
  QuadMesh qm;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.quads, qm);
  return qm;
}

// n x m unit squares in the plane.
inline Quad_soup grid(int n, int m)
{
  Quad_soup s;
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i <= n; ++i)
      s.points.emplace_back(i, j, 0);
  auto id = [&](int i, int j) { return std::size_t(j * (n + 1) + i); };
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i)
      s.quads.push_back({ { id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1) } });
  return s;
}

// The boundary of the cube [-1,1]^3 with n x n quads per side: 8 vertices of valence 3, 6 patches.
inline Quad_soup cube(int n)
{
  Quad_soup s;
  std::map<std::array<int, 3>, std::size_t> ids;
  auto id = [&](const std::array<int, 3>& p)
  {
    const auto found = ids.emplace(p, s.points.size());
    if(found.second)
      s.points.emplace_back(2. * p[0] / n - 1, 2. * p[1] / n - 1, 2. * p[2] / n - 1);
    return found.first->second;
  };
  for(int axis = 0; axis < 3; ++axis)
    for(int side : { 0, n })
      for(int i = 0; i < n; ++i)
        for(int j = 0; j < n; ++j)
        {
          std::array<std::size_t, 4> q;
          const int corner[4][2] = { { i, j }, { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 } };
          for(int k = 0; k < 4; ++k)
          {
            std::array<int, 3> p;
            p[axis] = side;
            p[(axis + 1) % 3] = corner[k][0];
            p[(axis + 2) % 3] = corner[k][1];
            q[side == 0 ? 3 - k : k] = id(p);
          }
          s.quads.push_back(q);
        }
  return s;
}

inline Quad_soup sphere(int n)
{
  Quad_soup s = cube(n);
  for(Point_3& p : s.points)
    p = CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length());
  return s;
}

// n quads around and m along, glued to a cylinder with a shift along the axis, and the ends glued too if
// `closed`: a torus. With a shift of h, the curves around are helices of pitch h.
inline Quad_soup rolled(int n, int m, int shift, bool closed)
{
  Quad_soup s;
  std::map<std::pair<int, int>, std::size_t> ids;
  auto id = [&](int i, int j)
  {
    if(i == n)
    {
      i = 0;
      j += shift;
    }
    if(closed)
      j = ((j % m) + m) % m;
    const auto found = ids.emplace(std::make_pair(i, j), s.points.size());
    if(found.second)
    {
      const double u = 2 * pi * i / n, w = j + double(shift) * i / n;
      if(closed)
      {
        const double r = 3 - std::cos(2 * pi * w / m);
        s.points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(2 * pi * w / m));
      }
      else
        s.points.emplace_back(std::cos(u), std::sin(u), w * 2 * pi / n);
    }
    return found.first->second;
  };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j)
      s.quads.push_back({ { id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1) } });
  return s;
}

// Every quad cut into k x k.
inline Quad_soup refined(const Quad_soup& coarse, int k)
{
  Quad_soup s;
  typedef std::vector<std::pair<std::size_t, int>> Key; // corners with their weights
  std::map<Key, std::size_t> ids;
  for(const std::array<std::size_t, 4>& q : coarse.quads)
  {
    auto id = [&](int i, int j)
    {
      const int weight[4] = { (k - i) * (k - j), i * (k - j), i * j, (k - i) * j };
      Key key;
      Vector_3 sum(0, 0, 0);
      for(int c = 0; c < 4; ++c)
        if(weight[c] > 0)
        {
          key.emplace_back(q[c], weight[c]);
          sum = sum + (double(weight[c]) / (k * k)) * (coarse.points[q[c]] - CGAL::ORIGIN);
        }
      std::sort(key.begin(), key.end());
      const auto found = ids.emplace(key, s.points.size());
      if(found.second)
        s.points.push_back(CGAL::ORIGIN + sum);
      return found.first->second;
    };
    for(int i = 0; i < k; ++i)
      for(int j = 0; j < k; ++j)
        s.quads.push_back({ { id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1) } });
  }
  return s;
}

// Every triangle cut into three quads: a base complex without any regularity.
template <typename Triangles>
Quad_soup split_triangles(const std::vector<Point_3>& points, const Triangles& triangles)
{
  Quad_soup s;
  s.points = points;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  auto middle = [&](std::size_t a, std::size_t b)
  {
    const auto found = middles.emplace(std::minmax(a, b), s.points.size());
    if(found.second)
      s.points.push_back(CGAL::midpoint(points[a], points[b]));
    return found.first->second;
  };
  for(const auto& t : triangles)
  {
    const std::size_t a = t[0], b = t[1], c = t[2];
    const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a), center = s.points.size();
    s.points.push_back(CGAL::centroid(points[a], points[b], points[c]));
    s.quads.push_back({ { a, ab, center, ca } });
    s.quads.push_back({ { b, bc, center, ab } });
    s.quads.push_back({ { c, ca, center, bc } });
  }
  return s;
}

// Both triangles of each quad.
inline Mesh triangulated(const Quad_soup& quads)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  for(const std::array<std::size_t, 4>& q : quads.quads)
  {
    triangles.push_back({ { q[0], q[1], q[2] } });
    triangles.push_back({ { q[0], q[2], q[3] } });
  }
  Mesh tm;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(quads.points, triangles, tm);
  return tm;
}

} // namespace structure_meshes

#endif // CGAL_QUAD_MESHING_TEST_STRUCTURE_MESHES_H
