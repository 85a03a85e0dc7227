// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_TEST_TEST_MESHES_H
#define CGAL_QUAD_MESHING_TEST_TEST_MESHES_H

// Triangle meshes for tests, generated instead of read.
//
// Each generator gives a soup whose counts are stated with it (V vertices, F triangles, b boundary
// loops, g genus); `make_mesh()` turns it into a mesh with the same vertices and faces in the same
// order. Closed shapes have their normals outside, flat ones along +z.
//
//   auto tm = test_meshes::make_mesh(test_meshes::torus(32, 16));
//   auto p = test_meshes::make_mesh<Polyhedron>(test_meshes::cube(4));

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace test_meshes {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef std::array<std::size_t, 3> Triangle;

constexpr double pi = 3.14159265358979323846;

struct Soup
{
  std::vector<Point_3> points;
  std::vector<Triangle> triangles;

  void add_quad(std::size_t a, std::size_t b, std::size_t c, std::size_t d)
  {
    triangles.push_back({ { a, b, c } });
    triangles.push_back({ { a, c, d } });
  }
};

// The soup as a mesh: vertex i is points[i], face i is triangles[i].
template <typename TriangleMesh = Mesh>
TriangleMesh make_mesh(const Soup& soup)
{
  TriangleMesh tm;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, tm);
  return tm;
}

// Every point p replaced by f(p).
inline Soup mapped(Soup soup, const std::function<Point_3(const Point_3&)>& f)
{
  for(Point_3& p : soup.points)
    p = f(p);
  return soup;
}

// Both soups in one, those of the second one last.
inline Soup joined(Soup a, const Soup& b)
{
  const std::size_t n = a.points.size();
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for(const Triangle& t : b.triangles)
    a.triangles.push_back({ { t[0] + n, t[1] + n, t[2] + n } });
  return a;
}

inline Soup translated(const Soup& soup, const Vector_3& v)
{
  return mapped(soup, [&](const Point_3& p) { return p + v; });
}

// Every coordinate moved by up to `amplitude`: a mesh in general position. The same seed gives the same mesh.
inline Soup perturbed(const Soup& soup, double amplitude, unsigned int seed = 0)
{
  CGAL::Random random(seed);
  return mapped(soup,
                [&](const Point_3& p)
                {
                  const double dx = random.get_double(-1., 1.), dy = random.get_double(-1., 1.),
                               dz = random.get_double(-1., 1.);
                  return p + amplitude * Vector_3(dx, dy, dz);
                });
}

// Every triangle split into four at the midpoints of its edges: V + E vertices, 4F triangles.
inline Soup subdivided(Soup soup)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
  auto midpoint = [&](std::size_t a, std::size_t b)
  {
    const auto inserted = midpoints.emplace(std::minmax(a, b), soup.points.size());
    if(inserted.second)
      soup.points.push_back(CGAL::midpoint(soup.points[a], soup.points[b]));
    return inserted.first->second;
  };

  std::vector<Triangle> triangles;
  for(const Triangle& t : soup.triangles)
  {
    const std::size_t a = midpoint(t[1], t[2]), b = midpoint(t[2], t[0]), c = midpoint(t[0], t[1]);
    triangles.insert(triangles.end(), { { { t[0], c, b } }, { { t[1], a, c } }, { { t[2], b, a } }, { { a, b, c } } });
  }
  soup.triangles.swap(triangles);
  return soup;
}

// The rectangle [0,width] x [0,height] in nx x ny cells: V = (nx+1)(ny+1), F = 2 nx ny, b = 1.
// Vertex (i,j) has number j (nx+1) + i.
inline Soup grid(int nx, int ny, double width = 1, double height = 1)
{
  Soup soup;
  for(int j = 0; j <= ny; ++j)
    for(int i = 0; i <= nx; ++i)
      soup.points.emplace_back(width * i / nx, height * j / ny, 0);
  for(int j = 0; j < ny; ++j)
  {
    for(int i = 0; i < nx; ++i)
    {
      const std::size_t v = static_cast<std::size_t>(j) * (nx + 1) + i;
      soup.add_quad(v, v + 1, v + nx + 2, v + nx + 1);
    }
  }
  return soup;
}

// The grid without the cells (i,j), i0 <= i < i1, j0 <= j < j1, which must lie inside:
// V = (nx+1)(ny+1) - (i1-i0-1)(j1-j0-1), F = 2 (nx ny - (i1-i0)(j1-j0)), b = 2.
inline Soup grid_with_hole(int nx, int ny, int i0, int i1, int j0, int j1, double width = 1, double height = 1)
{
  Soup soup;
  std::map<std::pair<int, int>, std::size_t> index;
  for(int j = 0; j <= ny; ++j)
  {
    for(int i = 0; i <= nx; ++i)
    {
      if(i0 < i && i < i1 && j0 < j && j < j1)
        continue;
      index[{ i, j }] = soup.points.size();
      soup.points.emplace_back(width * i / nx, height * j / ny, 0);
    }
  }
  for(int j = 0; j < ny; ++j)
    for(int i = 0; i < nx; ++i)
      if(!(i0 <= i && i < i1 && j0 <= j && j < j1))
        soup.add_quad(index[{ i, j }], index[{ i + 1, j }], index[{ i + 1, j + 1 }], index[{ i, j + 1 }]);
  return soup;
}

// A flat strip of n squares: V = 2n+2, F = 2n, b = 1; every vertex lies on the boundary.
inline Soup strip(int n) { return grid(n, 1, n, 1); }

// The strip of n squares closed with half a turn: V = 2n, F = 2n. It is a soup only: no orientation
// of its triangles is consistent.
inline Soup moebius_strip(int n)
{
  Soup soup;
  for(int i = 0; i < n; ++i)
  {
    const double s = 2 * pi * i / n;
    for(double w : { -0.3, 0.3 })
      soup.points.emplace_back((1 + w * std::cos(s / 2)) * std::cos(s), (1 + w * std::cos(s / 2)) * std::sin(s),
                               w * std::sin(s / 2));
  }
  for(std::size_t i = 0; i + 1 < static_cast<std::size_t>(n); ++i)
    soup.add_quad(2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
  soup.add_quad(2 * n - 2, 1, 0, 2 * n - 1);
  return soup;
}

// The surface of a set of unit cells of the integer lattice, each of its squares cut into n x n;
// `occupied(i,j,k)` is asked for cells within [0,sx) x [0,sy) x [0,sz). All coordinates are multiples
// of 1/n. Cells that meet must share a square, else the surface is not manifold.
inline Soup voxel_surface(const std::function<bool(int, int, int)>& occupied, int sx, int sy, int sz, int n)
{
  typedef std::array<int, 3> Lattice_point;
  const Lattice_point size = { { sx, sy, sz } };
  auto is_occupied = [&](const Lattice_point& c)
  {
    for(int d = 0; d < 3; ++d)
      if(c[d] < 0 || c[d] >= size[d])
        return false;
    return occupied(c[0], c[1], c[2]);
  };

  Soup soup;
  std::map<Lattice_point, std::size_t> index;
  auto vertex = [&](const Lattice_point& p)
  {
    const auto inserted = index.emplace(p, soup.points.size());
    if(inserted.second)
      soup.points.emplace_back(p[0] / double(n), p[1] / double(n), p[2] / double(n));
    return inserted.first->second;
  };

  for(int k = 0; k < sz; ++k)
  {
    for(int j = 0; j < sy; ++j)
    {
      for(int i = 0; i < sx; ++i)
      {
        const Lattice_point cell = { { i, j, k } };
        if(!is_occupied(cell))
          continue;
        for(int d = 0; d < 3; ++d)
        {
          for(int side = 0; side < 2; ++side)
          {
            Lattice_point neighbor = cell;
            neighbor[d] += side == 0 ? -1 : 1;
            if(is_occupied(neighbor))
              continue;
            // (u, v) turns counterclockwise seen from outside.
            const int u = (d + (side == 1 ? 1 : 2)) % 3, v = (d + (side == 1 ? 2 : 1)) % 3;
            for(int a = 0; a < n; ++a)
            {
              for(int b = 0; b < n; ++b)
              {
                auto corner = [&](int da, int db)
                {
                  Lattice_point p = { { n * i, n * j, n * k } };
                  p[d] += side * n;
                  p[u] += a + da;
                  p[v] += b + db;
                  return vertex(p);
                };
                soup.add_quad(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
              }
            }
          }
        }
      }
    }
  }
  return soup;
}

// The unit cube with n x n squares per side: V = 6n^2+2, F = 12n^2, g = 0.
inline Soup cube(int n)
{
  return voxel_surface([](int, int, int) { return true; }, 1, 1, 1, n);
}

// The cube sheared along x by `shear` times the height: counts of the cube.
inline Soup sheared_cube(int n, double shear = 0.5)
{
  return mapped(cube(n), [&](const Point_3& p) { return Point_3(p.x() + shear * p.z(), p.y(), p.z()); });
}

// Three unit cells that form an L: V = 14n^2+2, F = 28n^2, g = 0.
inline Soup l_prism(int n)
{
  return voxel_surface([](int i, int j, int) { return i == 0 || j == 0; }, 2, 2, 1, n);
}

// A ring of eight cells, square outside and inside: V = 32n^2, F = 64n^2, g = 1.
inline Soup square_ring(int n)
{
  return voxel_surface([](int i, int j, int) { return !(i == 1 && j == 1); }, 3, 3, 1, n);
}

// A plate of 5 x 3 cells with two holes: V = 50n^2+2*(1-2), F = 108n^2 - 8n^2, g = 2.
inline Soup double_ring(int n)
{
  return voxel_surface([](int i, int j, int) { return !(j == 1 && (i == 1 || i == 3)); }, 5, 3, 1, n);
}

// The unit sphere, an icosahedron subdivided `levels` times: V = 10*4^levels+2, F = 20*4^levels, g = 0.
// The twelve vertices of valence 5 come first.
inline Soup icosphere(int levels)
{
  const double t = (1 + std::sqrt(5.)) / 2;
  Soup soup;
  soup.points = { { -1, t, 0 },  { 1, t, 0 },  { -1, -t, 0 }, { 1, -t, 0 }, { 0, -1, t },  { 0, 1, t },
                  { 0, -1, -t }, { 0, 1, -t }, { t, 0, -1 },  { t, 0, 1 },  { -t, 0, -1 }, { -t, 0, 1 } };
  soup.triangles = { { { 0, 11, 5 } }, { { 0, 5, 1 } },  { { 0, 1, 7 } },   { { 0, 7, 10 } }, { { 0, 10, 11 } },
                     { { 1, 5, 9 } },  { { 5, 11, 4 } }, { { 11, 10, 2 } }, { { 10, 7, 6 } }, { { 7, 1, 8 } },
                     { { 3, 9, 4 } },  { { 3, 4, 2 } },  { { 3, 2, 6 } },   { { 3, 6, 8 } },  { { 3, 8, 9 } },
                     { { 4, 9, 5 } },  { { 2, 4, 11 } }, { { 6, 2, 10 } },  { { 8, 6, 7 } },  { { 9, 8, 1 } } };
  auto to_sphere = [](const Point_3& p)
  {
    const Vector_3 v = p - CGAL::ORIGIN;
    return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  };
  soup = mapped(soup, to_sphere);
  for(int i = 0; i < levels; ++i)
    soup = mapped(subdivided(soup), to_sphere);
  return soup;
}

// The torus with n steps around its axis and m around its tube: V = nm, F = 2nm, g = 1.
inline Soup torus(int n, int m, double big_radius = 1, double small_radius = 0.4)
{
  Soup soup;
  for(int i = 0; i < n; ++i)
  {
    for(int j = 0; j < m; ++j)
    {
      const double s = 2 * pi * i / n, t = 2 * pi * j / m, r = big_radius + small_radius * std::cos(t);
      soup.points.emplace_back(r * std::cos(s), r * std::sin(s), small_radius * std::sin(t));
    }
  }
  auto v = [&](int i, int j) { return static_cast<std::size_t>(i % n) * m + j % m; };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j)
      soup.add_quad(v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1));
  return soup;
}

// The cylinder about the z axis with n steps around and m along it.
// Open: V = n(m+1), F = 2nm, b = 2. With caps, fans about their centers: V = n(m+1)+2, F = 2nm+2n, closed.
inline Soup cylinder(int n, int m, bool caps, double radius = 1, double height = 2)
{
  Soup soup;
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i < n; ++i)
      soup.points.emplace_back(radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), height * j / m);
  auto v = [&](int i, int j) { return static_cast<std::size_t>(j) * n + i % n; };
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i)
      soup.add_quad(v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1));
  if(caps)
  {
    const std::size_t bottom = soup.points.size(), top = bottom + 1;
    soup.points.emplace_back(0, 0, 0);
    soup.points.emplace_back(0, 0, height);
    for(int i = 0; i < n; ++i)
    {
      soup.triangles.push_back({ { bottom, v(i + 1, 0), v(i, 0) } });
      soup.triangles.push_back({ { top, v(i, m), v(i + 1, m) } });
    }
  }
  return soup;
}

// The cone about the z axis with its apex (vertex 0) above and its base open, n steps around and m
// along: V = nm+1, F = n(2m-1), b = 1.
inline Soup cone(int n, int m, double radius = 1, double height = 1)
{
  Soup soup;
  soup.points.emplace_back(0, 0, height);
  for(int j = 1; j <= m; ++j)
    for(int i = 0; i < n; ++i)
      soup.points.emplace_back(radius * j / m * std::cos(2 * pi * i / n), radius * j / m * std::sin(2 * pi * i / n),
                               height * (m - j) / m);
  auto v = [&](int i, int j) { return 1 + static_cast<std::size_t>(j - 1) * n + i % n; };
  for(int i = 0; i < n; ++i)
    soup.triangles.push_back({ { 0, v(i, 1), v(i + 1, 1) } });
  for(int j = 1; j < m; ++j)
    for(int i = 0; i < n; ++i)
      soup.add_quad(v(i, j), v(i, j + 1), v(i + 1, j + 1), v(i + 1, j));
  return soup;
}

// A cube beside a sphere: two closed components, the cube first.
inline Soup two_components(int n, int levels)
{
  return joined(cube(n), translated(icosphere(levels), Vector_3(3, 0, 0)));
}

} // namespace test_meshes

#endif // CGAL_QUAD_MESHING_TEST_TEST_MESHES_H
