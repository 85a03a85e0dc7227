// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_TEST_EXTRACTION_MESHES_H
#define CGAL_QUAD_MESHING_TEST_EXTRACTION_MESHES_H

// Triangle meshes with exact integer-grid maps whose quad mesh is known.
//
// They come from a coarse quad mesh. Each coarse quad is the square [0,k] x [0,k] in its own
// chart, triangulated over random points (the same ones on both sides of an edge), so its k x k grid cells are the
// quads to be found. Then each triangle gets a random chart of its own.

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quad_meshing/internal/Grid_automorphism.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cassert>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace extraction_meshes {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Halfedge_index, Point_2> Uv_map;
typedef CGAL::Quad_meshing::internal::Grid_automorphism Grid_automorphism;

// Quad i has the corners quads[i]; sides that join the same vertices are the same edge if their
// labels are equal, too.
struct Coarse_mesh
{
  std::vector<Point_3> points;
  std::vector<std::array<int, 4>> quads;
  std::vector<std::array<int, 4>> labels;

  void add(int a, int b, int c, int d) { add(a, b, c, d, { { 0, 0, 0, 0 } }); }
  void add(int a, int b, int c, int d, const std::array<int, 4>& l)
  {
    quads.push_back({ { a, b, c, d } });
    labels.push_back(l);
  }
};

struct Options
{
  int k = 1;            // cells along each side of a coarse quad
  int inner_points = 3; // random points inside each coarse quad
  int edge_points = 1;  // random points inside each coarse edge
  int denominator = 8;  // all coordinates are multiples of 1 / denominator
  bool random_charts = true;
  unsigned int seed = 0;
};

struct Mapped_mesh
{
  Mesh mesh;
  Uv_map uv;
  bool complete = true; // all triangles could be added
  Mapped_mesh() : uv(mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first) {}
  Mapped_mesh(const Mapped_mesh& m)
    : mesh(m.mesh), uv(mesh.property_map<Mesh::Halfedge_index, Point_2>("h:uv").first), complete(m.complete)
  {
  }
  Mapped_mesh& operator=(const Mapped_mesh&) = delete;
};

inline Grid_automorphism random_automorphism(std::mt19937& rng)
{
  const int r = static_cast<int>(rng() % 4), x = static_cast<int>(rng() % 41), y = static_cast<int>(rng() % 41);
  return Grid_automorphism(r, x - 20, y - 20);
}

// Gives each face a random chart.
inline void shuffle_charts(Mapped_mesh& m, unsigned int seed)
{
  std::mt19937 rng(seed);
  for(auto f : m.mesh.faces())
  {
    const Grid_automorphism g = random_automorphism(rng);
    for(auto h : CGAL::halfedges_around_face(m.mesh.halfedge(f), m.mesh))
      m.uv[h] = g(m.uv[h]);
  }
}

// Adds a triangle whose corners have the given images.
inline void add_triangle(Mapped_mesh& m, const std::array<Mesh::Vertex_index, 3>& v, const std::array<Point_2, 3>& uv)
{
  // A point that appears twice in one coarse quad may get joined to itself.
  const bool simple = v[0] != v[1] && v[1] != v[2] && v[2] != v[0];
  const Mesh::Face_index f = simple ? m.mesh.add_face(v[0], v[1], v[2]) : Mesh::null_face();
  m.complete &= f != Mesh::null_face();
  if(f == Mesh::null_face())
    return;
  for(auto h : CGAL::halfedges_around_face(m.mesh.halfedge(f), m.mesh))
    for(int i = 0; i < 3; ++i)
      if(m.mesh.target(h) == v[i])
        m.uv[h] = uv[i];
}

inline Mapped_mesh triangulated(const Coarse_mesh& coarse, const Options& o)
{
  typedef CGAL::Triangulation_vertex_base_with_info_2<Mesh::Vertex_index, Kernel> Vb;
  typedef CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb>> Delaunay;

  Mapped_mesh m;
  std::mt19937 rng(o.seed);
  const int n = o.k * o.denominator;
  std::vector<Mesh::Vertex_index> corner;
  for(const Point_3& p : coarse.points)
    corner.push_back(m.mesh.add_vertex(p));

  // The points inside a coarse edge, from its smaller vertex to its larger one.
  typedef std::vector<std::pair<int, Mesh::Vertex_index>> Edge_points;
  std::map<std::tuple<int, int, int>, Edge_points> edge;

  for(std::size_t q = 0; q < coarse.quads.size(); ++q)
  {
    const std::array<int, 4>& c = coarse.quads[q];
    const std::array<Point_2, 4> square = { { Point_2(0, 0), Point_2(o.k, 0), Point_2(o.k, o.k), Point_2(0, o.k) } };
    auto place = [&](int x, int y)
    {
      const double s = static_cast<double>(x) / n, t = static_cast<double>(y) / n;
      auto at = [&](int i) { return coarse.points[c[i]] - CGAL::ORIGIN; };
      return CGAL::ORIGIN + ((1 - t) * ((1 - s) * at(0) + s * at(1)) + t * ((1 - s) * at(3) + s * at(2)));
    };

    Delaunay dt;
    for(int i = 0; i < 4; ++i)
      dt.insert(square[i])->info() = corner[c[i]];
    std::map<Point_2, std::size_t> on_side;
    for(int i = 0; i < 4; ++i)
    {
      const int a = c[i], b = c[(i + 1) % 4];
      const std::tuple<int, int, int> key((std::min)(a, b), (std::max)(a, b), coarse.labels[q][i]);
      const bool is_new = edge.find(key) == edge.end();
      Edge_points& on_edge = edge[key];
      auto on_square = [&](int s)
      {
        const double t = static_cast<double>(a < b ? s : n - s) / o.denominator;
        const Point_2& p = square[i];
        const Point_2& q = square[(i + 1) % 4];
        return Point_2(p.x() + t * CGAL::sign(q.x() - p.x()), p.y() + t * CGAL::sign(q.y() - p.y()));
      };
      if(is_new)
      {
        std::set<int> chosen;
        for(int j = 0; j < 20 * o.edge_points && static_cast<int>(chosen.size()) < (std::min)(o.edge_points, n - 1);
            ++j)
          chosen.insert(1 + static_cast<int>(rng() % (n - 1)));
        for(int s : chosen)
        {
          const Point_2 p = on_square(s);
          on_edge.push_back(std::make_pair(s, m.mesh.add_vertex(place(static_cast<int>(p.x() * o.denominator),
                                                                      static_cast<int>(p.y() * o.denominator)))));
        }
      }
      for(const auto& s : on_edge)
        dt.insert(on_square(s.first))->info() = s.second;
    }
    std::set<std::pair<int, int>> chosen;
    for(int j = 0; j < 20 * o.inner_points && static_cast<int>(chosen.size()) < o.inner_points; ++j)
    {
      const std::pair<int, int> p(1 + rng() % (n - 1), 1 + rng() % (n - 1));
      if(chosen.insert(p).second)
        dt.insert(Point_2(static_cast<double>(p.first) / o.denominator, static_cast<double>(p.second) / o.denominator))
          ->info() = m.mesh.add_vertex(place(p.first, p.second));
    }
    for(auto t = dt.finite_faces_begin(); t != dt.finite_faces_end(); ++t)
      add_triangle(m, { { t->vertex(0)->info(), t->vertex(1)->info(), t->vertex(2)->info() } },
                   { { t->vertex(0)->point(), t->vertex(1)->point(), t->vertex(2)->point() } });
  }
  if(o.random_charts)
    shuffle_charts(m, o.seed + 1);
  return m;
}

// --- Coarse meshes ---

inline Coarse_mesh coarse_cube()
{
  Coarse_mesh c;
  for(int i = 0; i < 8; ++i)
    c.points.push_back(Point_3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
  c.add(0, 2, 3, 1);
  c.add(4, 5, 7, 6);
  c.add(0, 1, 5, 4);
  c.add(2, 6, 7, 3);
  c.add(0, 4, 6, 2);
  c.add(1, 3, 7, 5);
  return c;
}

// The unit squares (i,j) for which `in(i,j)`.
template <typename In>
Coarse_mesh coarse_plane(int nx, int ny, const In& in)
{
  Coarse_mesh c;
  std::map<std::pair<int, int>, int> id;
  auto at = [&](int i, int j)
  {
    const auto it = id.insert(std::make_pair(std::make_pair(i, j), static_cast<int>(c.points.size())));
    if(it.second)
      c.points.push_back(Point_3(i, j, 0));
    return it.first->second;
  };
  for(int j = 0; j < ny; ++j)
    for(int i = 0; i < nx; ++i)
      if(in(i, j))
        c.add(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return c;
}

// The torus of nx x ny squares whose rows are shifted by `shear` squares on the way around.
inline Coarse_mesh coarse_torus(int nx, int ny, int shear)
{
  Coarse_mesh c;
  for(int j = 0; j < ny; ++j)
    for(int i = 0; i < nx; ++i)
    {
      const double s = 2 * CGAL_PI * i / nx, t = 2 * CGAL_PI * j / ny;
      c.points.push_back(Point_3((3 + std::cos(t)) * std::cos(s), (3 + std::cos(t)) * std::sin(s), std::sin(t)));
    }
  auto at = [&](int i, int j) { return j == ny ? (i + shear) % nx : (j % ny) * nx + i % nx; };
  for(int j = 0; j < ny; ++j)
    for(int i = 0; i < nx; ++i)
      c.add(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return c;
}

inline Coarse_mesh coarse_cylinder(int nx, int ny)
{
  Coarse_mesh c;
  for(int j = 0; j <= ny; ++j)
    for(int i = 0; i < nx; ++i)
      c.points.push_back(Point_3(std::cos(2 * CGAL_PI * i / nx), std::sin(2 * CGAL_PI * i / nx), j));
  for(int j = 0; j < ny; ++j)
    for(int i = 0; i < nx; ++i)
      c.add(j * nx + i, j * nx + (i + 1) % nx, (j + 1) * nx + (i + 1) % nx, (j + 1) * nx + i);
  return c;
}

// A disk of `valence` squares around a point.
inline Coarse_mesh coarse_cone(int valence)
{
  Coarse_mesh c;
  c.points.push_back(Point_3(0, 0, 1));
  for(int i = 0; i < valence; ++i)
  {
    const double s = 2 * CGAL_PI * i / valence, t = 2 * CGAL_PI * (i + 0.5) / valence;
    c.points.push_back(Point_3(std::cos(s), std::sin(s), 0));
    c.points.push_back(Point_3(1.4 * std::cos(t), 1.4 * std::sin(t), -1));
  }
  for(int i = 0; i < valence; ++i)
  {
    // With one square its two sides at the border join the same vertices and still differ.
    const int a = 1 + 2 * i, b = 1 + 2 * ((i + 1) % valence);
    c.add(0, a, a + 1, b, { { 0, 0, 1, 0 } });
  }
  return c;
}

// A fan of squares around a border vertex.
inline Coarse_mesh coarse_fan(int squares)
{
  Coarse_mesh c;
  c.points.push_back(Point_3(0, 0, 0));
  for(int i = 0; i <= 2 * squares; ++i)
    c.points.push_back(Point_3(std::cos(0.3 * i), std::sin(0.3 * i), 0.1 * i));
  for(int i = 0; i < squares; ++i)
    c.add(0, 1 + 2 * i, 2 + 2 * i, 3 + 2 * i);
  return c;
}

inline Coarse_mesh joined(Coarse_mesh a, const Coarse_mesh& b)
{
  const int n = static_cast<int>(a.points.size());
  for(const Point_3& p : b.points)
    a.points.push_back(p + Kernel::Vector_3(10, 0, 0));
  for(std::size_t i = 0; i < b.quads.size(); ++i)
    a.add(b.quads[i][0] + n, b.quads[i][1] + n, b.quads[i][2] + n, b.quads[i][3] + n, b.labels[i]);
  return a;
}

} // namespace extraction_meshes

#endif // CGAL_QUAD_MESHING_TEST_EXTRACTION_MESHES_H
