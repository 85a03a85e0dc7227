// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "geodesics_meshes.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Quad_meshing/Geodesics/isolines.h>
#include <CGAL/Quad_meshing/Geodesics/refine_distance_field.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/algorithm.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

using namespace geodesics_meshes;
namespace params = CGAL::parameters;
typedef CGAL::Quad_meshing::Geodesic_distance_result Result;
typedef CGAL::Quad_meshing::Geodesic_distance_status Status;
typedef Mesh::Vertex_index Vertex;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The largest relative error against a known distance.
double largest_error(const Mesh& tm, const Field& field, const std::function<double(Vertex)>& expected)
{
  double worst = 0;
  for(Vertex v : tm.vertices())
  {
    const double d = expected(v), e = field.distance(v);
    worst = (std::max)(worst, d == 0 ? e : std::fabs(e - d) / d);
  }
  return worst;
}

// Without windows, which go through groups of faces then, the distances are the same up to rounding. The field is left
// without windows.
void check_without_windows(const Mesh& tm, Field& field, double tolerance = 1e-12)
{
  std::vector<double> expected;
  for(Vertex v : tm.vertices())
    expected.push_back(field.distance(v));
  assert(field.propagate(params::keep_windows(false)));
  for(Vertex v : tm.vertices())
    assert(field.distance(v) == expected[v] || std::fabs(field.distance(v) - expected[v]) <= tolerance * expected[v]);
}

double windows_per_edge(const Mesh& tm, const Field& field)
{
  return double(field.number_of_windows()) / tm.number_of_edges();
}

// In the plane the distance is that of the plane; rays run through vertices, fronts tie, and no vertex
// is a saddle: windows that continue each other become one.
void test_points_in_the_plane()
{
  std::cout << "points in the plane" << std::endl;
  for(int variant = 0; variant < 4; ++variant)
  {
    Soup soup = variant < 2 ? grid(24, 24) : uneven_square(24, 5);
    if(variant % 2 == 1)
      soup = mapped(soup, rotated);
    const Mesh tm = make_mesh(soup);
    for(int source : { 0, 12, 312, 330 })
    {
      Field field(tm);
      field.add_source(Vertex(source));
      const Result result = field.propagate();
      assert(result && result.number_of_unreached_vertices == 0);
      assert(windows_per_edge(tm, field) < 3);
      const Point_3 p = tm.point(Vertex(source));
      assert(largest_error(tm, field, [&](Vertex v) { return distance(p, tm.point(v)); }) < 1e-12);
      check_without_windows(tm, field);
    }
    // in a face, on an edge, almost on an edge, almost at a vertex, at a vertex
    for(const std::array<double, 3>& w : std::vector<std::array<double, 3>>{ { { 0.2, 0.5, 0.3 } },
                                                                             { { 0.4, 0.6, 0 } },
                                                                             { { 0, 0.5, 0.5 } },
                                                                             { { 0.5, 0.5 - 1e-7, 1e-7 } },
                                                                             { { 1 - 2e-8, 1e-8, 1e-8 } },
                                                                             { { 0, 1, 0 } } })
    {
      const Location source(Mesh::Face_index(501), w);
      Field field(tm);
      field.add_source(source, 0.25);
      const Result result = field.propagate();
      assert(windows_per_edge(tm, field) < 3);
      const Point_3 p = point(tm, source);
      assert(largest_error(tm, field, [&](Vertex v) { return 0.25 + distance(p, tm.point(v)); }) < 1e-12);

      // anywhere else, with gradients and paths
      for(auto f : tm.faces())
      {
        const Location l(f, { { 0.1, 0.25, 0.65 } });
        const Point_3 q = point(tm, l);
        const double d = distance(p, q);
        assert(std::fabs(field.distance(l) - 0.25 - d) < 1e-12);
        assert((field.gradient(l) - Field::Vector_3((q.x() - p.x()) / d, (q.y() - p.y()) / d, (q.z() - p.z()) / d))
                 .squared_length() < 1e-12);
        std::vector<Location> path;
        assert(field.shortest_path(l, std::back_inserter(path)) == 0);
        assert(std::fabs(length(tm, path) - d) < 1e-12);
        assert(distance(point(tm, path.front()), q) < 1e-12 && distance(point(tm, path.back()), p) < 1e-12);
      }
      check_without_windows(tm, field);
    }
  }
}

// Triangles of aspect ratio up to a million.
void test_stretched_plane()
{
  std::cout << "stretched planes" << std::endl;
  for(bool is_rotated : { false, true })
  {
    for(double stretch : { 1e2, 1e4, 1e6 })
    {
      Soup soup = grid(30, 30, stretch, 1);
      const std::vector<Point_3> flat = soup.points;
      if(is_rotated)
        soup = mapped(soup, rotated);
      const Mesh tm = make_mesh(soup);
      for(int source : { 0, 16, 480 })
      {
        Field field(tm);
        field.add_source(Vertex(source));
        assert(field.propagate().number_of_unreached_vertices == 0);
        assert(largest_error(tm, field, [&](Vertex v) { return distance(flat[source], flat[v]); }) < 1e-8);
        check_without_windows(tm, field, 1e-8);
      }
    }
  }
}

// A polyline across the faces of a plane, made from straight paths, against the distance to its segments.
void test_polylines_in_the_plane()
{
  std::cout << "polylines in the plane" << std::endl;
  const Mesh tm = make_mesh(uneven_square(20, 3));
  CGAL::Random random(7);
  for(int test = 0; test < 8; ++test)
  {
    // the last ones have their corners at vertices: some segments run along edges, one is closed
    std::vector<Location> corners, line;
    for(int i = 0; i < 4; ++i)
    {
      const double a = random.get_double(), b = random.get_double(0, 1 - a);
      const int f = test < 6 ? random.get_int(0, 800) : 40 * (3 + 4 * i) + 12;
      corners.emplace_back(Mesh::Face_index(f), test < 6 ? std::array<double, 3>{ { a, b, 1 - a - b } }
                                                         : std::array<double, 3>{ { 1, 0, 0 } });
    }
    if(test == 7)
      corners[3] = corners[0];
    for(std::size_t i = 1; i < corners.size(); ++i)
    {
      Field leg(tm);
      leg.add_source(corners[i]);
      leg.propagate();
      assert(leg.shortest_path(corners[i - 1], std::back_inserter(line)) == 0);
    }
    Field field(tm);
    assert(field.add_polyline_source(line) == 0);
    const Result result = field.propagate();
    assert(result && result.number_of_unreached_vertices == 0);
    const auto expected = [&](const Point_3& p)
    {
      double d = infinity;
      for(std::size_t i = 1; i < corners.size(); ++i)
        d = (std::min)(d, distance_to_segment(p, point(tm, corners[i - 1]), point(tm, corners[i])));
      return d;
    };
    for(Vertex v : tm.vertices())
      assert(std::fabs(field.distance(v) - expected(tm.point(v))) < 1e-12);
    for(auto f : tm.faces())
    {
      const Location l(f, { { 0.5, 0.2, 0.3 } });
      assert(std::fabs(field.distance(l) - expected(point(tm, l))) < 1e-12);
      std::vector<Location> path;
      assert(field.shortest_path(l, std::back_inserter(path)) == 0);
      assert(std::fabs(length(tm, path) - field.distance(l)) < 1e-11);
      assert(expected(point(tm, path.back())) < 1e-11);
    }
    check_without_windows(tm, field);
    // no face holds two locations far apart
    assert(field.add_polyline_source(std::vector<Location>{ corners[0], corners[1] }) == Field::no_source());
  }
}

// The border of a square: the distance is piecewise linear and has ridges on the diagonals.
void test_border()
{
  std::cout << "border" << std::endl;
  for(int n : { 1, 2, 9, 16 })
  {
    const Mesh tm = make_mesh(n < 16 ? grid(n, n) : uneven_square(n, 1));
    Field field(tm);
    field.add_border_source();
    field.propagate();
    const auto expected = [](const Point_3& p) { return (std::min)({ p.x(), p.y(), 1 - p.x(), 1 - p.y() }); };
    for(Vertex v : tm.vertices())
      assert(std::fabs(field.distance(v) - expected(tm.point(v))) < 1e-14);
    for(auto f : tm.faces())
    {
      const Location l(f, { { 0.3, 0.3, 0.4 } });
      assert(std::fabs(field.distance(l) - expected(point(tm, l))) < 1e-14);
    }
    check_without_windows(tm, field);
  }
}

// Around a hole paths bend at its corners.
void test_hole()
{
  std::cout << "a plane with a hole" << std::endl;
  const int n = 20;
  const Mesh tm = make_mesh(grid_with_hole(n, n, 6, 13, 8, 11));
  const double x0 = 6. / n, x1 = 13. / n, y0 = 8. / n, y1 = 11. / n;
  // whether the segment pq misses the open rectangle
  const auto is_visible = [&](const Point_3& p, const Point_3& q)
  {
    double s = 0, t = 1;
    const auto clip = [&](double a, double d, double low, double high)
    {
      if(d == 0)
      {
        if(a <= low || a >= high)
          t = -1;
        return;
      }
      const double u = (low - a) / d, v = (high - a) / d;
      s = (std::max)(s, (std::min)(u, v));
      t = (std::min)(t, (std::max)(u, v));
    };
    clip(p.x(), q.x() - p.x(), x0, x1);
    clip(p.y(), q.y() - p.y(), y0, y1);
    return t - s < 1e-12;
  };
  for(int source : { 0, 7, 200, 390 })
  {
    std::vector<Point_3> nodes = { tm.point(Vertex(source)), Point_3(x0, y0, 0), Point_3(x1, y0, 0), Point_3(x1, y1, 0),
                                   Point_3(x0, y1, 0) };
    std::vector<double> d(5, infinity);
    d[0] = 0;
    for(int pass = 0; pass < 5; ++pass)
      for(int i = 0; i < 5; ++i)
        for(int j = 0; j < 5; ++j)
          if(is_visible(nodes[i], nodes[j]))
            d[j] = (std::min)(d[j], d[i] + distance(nodes[i], nodes[j]));
    Field field(tm);
    field.add_source(Vertex(source));
    field.propagate();
    assert(largest_error(tm, field,
                         [&](Vertex v)
                         {
                           double best = infinity;
                           for(int i = 0; i < 5; ++i)
                             if(is_visible(nodes[i], tm.point(v)))
                               best = (std::min)(best, d[i] + distance(nodes[i], tm.point(v)));
                           return best;
                         }) < 1e-12);
    check_without_windows(tm, field);
  }
}

// Cones of less and of more than 2 pi, open and closed: refinement does not change the metric.
void test_cones()
{
  std::cout << "cones and saddles" << std::endl;
  for(bool closed : { true, false })
  {
    for(double angle : { 0.4, 0.6, 0.9, 1.3 })
    {
      const int n = 8;
      if(closed && 2 * pi / n > angle && angle == 0.4)
        continue; // flatter than the zigzag can be
      double a = angle;
      if(closed && a < 2 * pi / n)
        a = 2 * pi / n;
      const Soup base = fan(n, a, closed);
      const Mesh tm = make_mesh(subdivided(subdivided(subdivided(base))));
      const double total = closed ? n * a : infinity;
      // the spokes keep the numbers of their ends
      for(int i = 1; i <= n / 2; ++i)
      {
        Field field(tm);
        field.add_source(Vertex(i));
        field.propagate();
        for(std::size_t j = 0; j < base.points.size(); ++j)
        {
          const double expected = j == 0 ? 1 : cone_distance(1, 1, (int(j) - i) * a, total);
          assert(int(j) == i ? field.distance(Vertex(j)) == 0
                             : std::fabs(field.distance(Vertex(j)) - expected) < 1e-12 * expected);
        }
        check_without_windows(tm, field);
      }
    }
  }
  // a cone with the apex above a polygon: total angle below 2 pi
  const int n = 9;
  Soup soup;
  soup.points.emplace_back(0, 0, 1.5);
  for(int i = 0; i < n; ++i)
    soup.points.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
  for(std::size_t i = 0; i < std::size_t(n); ++i)
    soup.triangles.push_back({ { 0, i + 1, (i + 1) % n + 1 } });
  const double r = std::sqrt(1 + 1.5 * 1.5), a = 2 * std::asin(std::sin(pi / n) / r);
  const Mesh tm = make_mesh(subdivided(subdivided(soup)));
  Field field(tm);
  field.add_source(Vertex(1));
  field.propagate();
  for(int j = 2; j <= n; ++j)
    assert(std::fabs(field.distance(Vertex(j)) - cone_distance(r, r, (j - 1) * a, n * a)) < 1e-12);
  check_without_windows(tm, field);
}

// On a box the shortest way between two points is the straight one in one of its unfoldings.
void test_cube()
{
  std::cout << "cube" << std::endl;
  for(int n : { 1, 2, 5, 8 })
  {
    const Mesh tm = make_mesh(cube(n));
    const auto before = [&](Vertex v, Vertex w) { return tm.point(v) < tm.point(w); };
    const Vertex corner = *std::min_element(tm.vertices().begin(), tm.vertices().end(), before);
    const Vertex opposite = *std::max_element(tm.vertices().begin(), tm.vertices().end(), before);
    const Point_3 p = tm.point(corner), q = tm.point(opposite);
    const double side = q.x() - p.x();
    Field field(tm);
    field.add_source(corner);
    field.propagate();
    assert(std::fabs(field.distance(opposite) - side * std::sqrt(5.)) < 1e-12 * side);
    for(Vertex v : tm.vertices())
    {
      const Vector_3 d = (tm.point(v) - p) / side;
      std::array<double, 3> c = { { d.x(), d.y(), d.z() } };
      std::sort(c.begin(), c.end());
      // on a face at the corner, or on a face opposite to it, at height 1 over one of the two faces below
      const double expected =
        c[0] < 1e-12
          ? std::sqrt(c[1] * c[1] + c[2] * c[2])
          : std::sqrt((std::min)((1 + c[0]) * (1 + c[0]) + c[1] * c[1], (1 + c[1]) * (1 + c[1]) + c[0] * c[0]));
      assert(std::fabs(field.distance(v) - side * expected) < 1e-12 * side);
    }
    check_without_windows(tm, field);
  }
}

// Another implementation, on closed and bordered surfaces of all kinds of regularity.
void test_against_CGAL()
{
  std::cout << "comparison with Surface_mesh_shortest_path" << std::endl;
  typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh> Traits;
  typedef CGAL::Surface_mesh_shortest_path<Traits> Shortest_path;

  std::vector<Soup> soups = { icosphere(3),
                              perturbed(icosphere(3), 0.02, 1),
                              torus(24, 12),
                              perturbed(torus(20, 10), 0.03, 2),
                              l_prism(3),
                              sheared_cube(4),
                              cylinder(16, 8, true),
                              perturbed(grid(14, 14), 0.03, 4),
                              mapped(icosphere(3), [](const Point_3& p) { return Point_3(20 * p.x(), p.y(), p.z()); }),
                              perturbed(grid_with_hole(12, 12, 4, 8, 3, 9), 0.03, 6),
                              square_ring(2) };
  for(const Soup& soup : soups)
  {
    Mesh tm = make_mesh(soup);
    const int n = int(tm.number_of_vertices());
    for(int count : { 1, 3 })
    {
      Field field(tm);
      Shortest_path reference(tm);
      for(int i = 0; i < count; ++i)
      {
        const Vertex v((n / 3 + i * 17) % n);
        assert(field.add_source(v) == std::size_t(i));
        reference.add_source_point(v);
      }
      assert(field.propagate());
      double worst = 0;
      for(Vertex v : tm.vertices())
      {
        const double d = reference.shortest_distance_to_source_points(v).first;
        worst = (std::max)(worst, d == 0 ? field.distance(v) : std::fabs(field.distance(v) - d) / d);
        std::vector<Location> path;
        // two sources may be equally near
        const std::size_t source = field.shortest_path(v, std::back_inserter(path));
        assert(source < std::size_t(count) &&
               distance(point(tm, path.back()), tm.point(Vertex((n / 3 + int(source) * 17) % n))) < 1e-12);
        assert(std::fabs(length(tm, path) - field.distance(v)) <= 1e-10 * field.distance(v));
      }
      assert(worst < 1e-10);
      check_without_windows(tm, field);
    }
  }
}

// The same on real meshes, where CGAL's data folder is installed.
void test_real_meshes()
{
  std::cout << "real meshes" << std::endl;
  typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> Shortest_path;
  int found = 0;
  for(const char* name : { "eight", "pinion", "elephant", "couplingdown", "head", "hand", "knot1", "mushroom", "rotor",
                           "anchor", "cactus", "handle" })
  {
    Mesh tm;
    if(!CGAL::IO::read_polygon_mesh(CGAL::data_file_path(std::string("meshes/") + name + ".off"), tm) ||
       !CGAL::is_triangle_mesh(tm))
      continue;
    ++found;
    const Vertex v(static_cast<Mesh::size_type>(tm.number_of_vertices() / 2));
    Field field(tm);
    field.add_source(v);
    assert(field.propagate());
    Shortest_path reference(tm);
    reference.add_source_point(v);
    for(Vertex w : tm.vertices())
    {
      const double d = reference.shortest_distance_to_source_points(w).first;
      assert(d < 0 ? field.distance(w) == infinity : std::fabs(field.distance(w) - d) <= 1e-10 * d);
    }
    check_without_windows(tm, field);
  }
  std::cout << "  " << found << " found" << std::endl;
}

// A polyline and ten thousand points on it, on a curved surface: the distance to the curve is never larger, and little
// smaller.
void test_sampled_polyline()
{
  std::cout << "a polyline and points on it" << std::endl;
  const Mesh tm = make_mesh(perturbed(torus(24, 12), 0.02, 8));
  std::vector<Location> line;
  Field leg(tm);
  leg.add_source(Location(Mesh::Face_index(20), { { 0.2, 0.5, 0.3 } }));
  leg.propagate();
  leg.shortest_path(Location(Mesh::Face_index(330), { { 0.1, 0.3, 0.6 } }), std::back_inserter(line));
  assert(line.size() > 5);
  Field curve(tm), points(tm);
  assert(curve.add_polyline_source(line) == 0);
  curve.propagate();
  const double total = length(tm, line), spacing = total / 10000;
  // consecutive points of a path have the face of the second one in common
  std::size_t samples = 0;
  for(std::size_t i = 1; i < line.size(); ++i)
  {
    const auto f = line[i].first;
    const Location from = CGAL::Polygon_mesh_processing::locate_in_face(point(tm, line[i - 1]), f, tm);
    const int n = int(std::sqrt(CGAL::squared_distance(point(tm, line[i - 1]), point(tm, line[i]))) / spacing) + 1;
    for(int k = 0; k <= n; ++k, ++samples)
    {
      const double t = double(k) / n;
      Location l(f, { { 0, 0, 0 } });
      for(int c = 0; c < 3; ++c)
        l.second[c] = (std::max)(0., (1 - t) * from.second[c] + t * line[i].second[c]);
      points.add_source(l);
    }
  }
  assert(samples >= 10000);
  double excess = 0;
  points.propagate();
  for(Vertex v : tm.vertices())
  {
    assert(curve.distance(v) <= points.distance(v) + 1e-9 * total);
    // the foot is at most half a spacing away from a sample, and paths arrive at right angles
    assert(points.distance(v) <= curve.distance(v) + 0.5 * spacing + 1e-9 * total);
    excess += points.distance(v) - curve.distance(v);
  }
  assert(excess < 0.01 * spacing * tm.number_of_vertices());
}

// Windows are kept on some edges only; those of the others are made when one asks for them. The distance that
// they tell on each edge is that of another implementation.
void test_windows_of_all_edges()
{
  std::cout << "windows of all edges" << std::endl;
  typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> Shortest_path;
  for(const Soup& soup : { icosphere(3), perturbed(torus(24, 12), 0.03, 2),
                           perturbed(grid_with_hole(12, 12, 4, 8, 3, 9), 0.03, 6), l_prism(3) })
  {
    const Mesh tm = make_mesh(soup);
    Field field(tm);
    Shortest_path reference(tm);
    const auto add = [&](const Location& l)
    {
      field.add_source(l);
      reference.add_source_point(l.first, l.second);
    };
    add(Location(Mesh::Face_index(7), { { 0.2, 0.5, 0.3 } }));
    add(Location(Mesh::Face_index(60), { { 0.4, 0.1, 0.5 } }));
    add(Location(Mesh::Face_index(90), { { 0, 1, 0 } }));
    const Result result = field.propagate();
    std::size_t n = 0;
    for(auto e : tm.edges())
    {
      std::vector<Field::Window> windows;
      field.windows(e, std::back_inserter(windows));
      n += windows.size();
      const auto h = tm.is_border(tm.halfedge(e)) ? tm.opposite(tm.halfedge(e)) : tm.halfedge(e);
      const double l = distance(tm.point(tm.source(h)), tm.point(tm.target(h)));
      for(std::size_t i = 0; i < windows.size(); ++i)
        assert(windows[i].begin < windows[i].end && windows[i].begin >= (i == 0 ? 0. : windows[i - 1].end - 1e-10 * l));
      Location location(tm.face(h), { { 0, 0, 0 } });
      const int k = h == tm.halfedge(location.first) ? 0 : h == tm.next(tm.halfedge(location.first)) ? 1 : 2;
      for(double part : { 0.05, 0.31, 0.5, 0.77, 0.98 })
      {
        // paths along the edge need no window
        double found =
          (std::min)(field.distance(tm.source(h)) + part * l, field.distance(tm.target(h)) + (1 - part) * l);
        for(const Field::Window& w : windows)
        {
          const double t = w.from == h ? part * l : (1 - part) * l;
          if(w.begin <= t && t <= w.end)
            found = (std::min)(found, w.distance(t));
        }
        location.second[k] = 1 - part;
        location.second[(k + 1) % 3] = part;
        const double d = reference.shortest_distance_to_source_points(location.first, location.second).first;
        // which misses paths along the border to places on it
        for(double ours : { found, field.distance(location) })
          assert(ours < d + 1e-12 * (1 + d) && (tm.is_border(e) || ours > d - 1e-12 * (1 + d)));
      }
    }
    assert(n == field.number_of_windows() && result.number_of_windows < n);
    assert(field.propagate(params::keep_windows(false)) && field.number_of_windows() == 0);
  }
}

// Any number of threads may ask one field: the windows that queries make are the same whoever makes them.
void test_concurrent_queries()
{
  std::cout << "concurrent queries" << std::endl;
  const Mesh tm = make_mesh(perturbed(torus(40, 20), 0.01, 3));
  Field one(tm), shared(tm);
  for(Field* field : { &one, &shared })
  {
    field->add_source(Location(Mesh::Face_index(7), { { 0.2, 0.5, 0.3 } }));
    field->add_source(Vertex(300), 0.1);
    field->propagate();
  }
  const int n = int(tm.number_of_faces());
  const auto ask = [&](const Field& field, int i)
  {
    const Location l(Mesh::Face_index(static_cast<Mesh::size_type>(i)), { { 0.2, 0.35, 0.45 } });
    std::vector<Location> path;
    field.shortest_path(l, std::back_inserter(path));
    return std::make_tuple(field.distance(l), field.nearest_source(l), field.gradient(l), length(tm, path));
  };
  std::vector<decltype(ask(one, 0))> expected;
  for(int i = 0; i < n; ++i)
    expected.push_back(ask(one, i));
  std::atomic<int> differences(0);
  std::vector<std::thread> threads;
  for(int t = 0; t < 4; ++t)
    threads.emplace_back(
      [&, t]
      {
        // some begin with the same groups, some elsewhere
        for(int k = 0; k < n; ++k)
        {
          const int i = (t % 2 == 0 ? k : n - 1 - k + t) % n;
          if(ask(shared, i) != expected[std::size_t(i)])
            ++differences;
        }
      });
  for(std::thread& thread : threads)
    thread.join();
  assert(differences == 0 && shared.number_of_windows() == one.number_of_windows());
}

// Sources beside each other: offsets, labels, and a curve as the limit of its points.
void test_mixed_sources()
{
  std::cout << "mixed sources" << std::endl;
  const Mesh plane = make_mesh(grid(16, 16));
  Field field(plane);
  const Point_3 p = plane.point(Vertex(20)), q = plane.point(Vertex(250));
  field.add_source(Vertex(20), 0.3);
  field.add_source(Vertex(250), 0.1);
  field.propagate();
  for(Vertex v : plane.vertices())
  {
    const double a = 0.3 + distance(p, plane.point(v)), b = 0.1 + distance(q, plane.point(v));
    assert(std::fabs(field.distance(v) - (std::min)(a, b)) < 1e-13);
    assert(std::fabs(a - b) < 1e-12 || field.nearest_source(v) == (a < b ? 0u : 1u));
  }

  const Mesh tm = make_mesh(perturbed(torus(24, 12), 0.02, 8));
  std::vector<Mesh::Edge_index> ring;
  std::vector<Location> samples;
  for(auto e : tm.edges())
    if(tm.point(tm.vertex(e, 0)).z() * tm.point(tm.vertex(e, 1)).z() < 0)
      ring.push_back(e);
  Field curve(tm), points(tm);
  curve.add_edges_source(ring);
  for(auto e : ring)
  {
    auto h = tm.halfedge(e);
    Location l(tm.face(h), { { 0, 0, 0 } });
    int k = 0;
    for(auto g = tm.halfedge(l.first); g != h; g = tm.next(g))
      ++k;
    for(int i = 0; i <= 20; ++i)
    {
      l.second[k] = 1 - i / 20.;
      l.second[(k + 1) % 3] = i / 20.;
      points.add_source(l);
    }
  }
  curve.propagate();
  points.propagate();
  for(Vertex v : tm.vertices())
  {
    assert(curve.distance(v) <= points.distance(v) + 1e-13);
    assert(points.distance(v) - curve.distance(v) < 0.02);
  }
  check_without_windows(tm, curve);
  check_without_windows(tm, points);
}

void test_reach()
{
  std::cout << "components, limits, targets, visitors, memory" << std::endl;
  Mesh tm = make_mesh(two_components(3, 2));
  const Vertex isolated = tm.add_vertex(Point_3(9, 9, 9));
  Field field(tm);
  assert(field.propagate().status == Status::NO_SOURCE);
  assert(field.distance(Vertex(0)) == infinity && field.nearest_source(Vertex(0)) == Field::no_source());
  field.add_source(Vertex(0));
  Result result = field.propagate();
  assert(result.status == Status::SUCCESS && result.number_of_unreached_vertices > 1);
  assert(field.distance(isolated) == infinity);
  std::size_t unreached = 0;
  for(Vertex v : tm.vertices())
    unreached += field.distance(v) == infinity;
  assert(unreached == result.number_of_unreached_vertices);
  std::vector<Location> path;
  assert(field.shortest_path(isolated, std::back_inserter(path)) == Field::no_source() && path.empty());

  const Mesh torus_mesh = make_mesh(perturbed(torus(40, 20), 0.01, 3));
  Field full(torus_mesh), other(torus_mesh);
  full.add_source(Vertex(5));
  other.add_source(Vertex(5));
  full.propagate();
  result = other.propagate(params::distance_limit(0.8));
  assert(result.status == Status::LIMIT_REACHED && result);
  for(Vertex v : torus_mesh.vertices())
    assert(full.distance(v) > 0.8 || full.distance(v) == other.distance(v));
  const std::vector<Vertex> targets = { Vertex(100), Vertex(300) };
  assert(other.propagate(params::target_vertices(std::cref(targets))).status == Status::LIMIT_REACHED);
  for(Vertex v : targets)
    assert(full.distance(v) == other.distance(v));

  check_without_windows(torus_mesh, full);
  assert(other.propagate(params::keep_windows(false)).number_of_windows < torus_mesh.number_of_edges() / 10);

  // dropped or not, whatever the unit of length is: steps of the front are rounded
  for(int i = 1; i <= 12; ++i)
  {
    const Mesh scaled = make_mesh(mapped(perturbed(torus(20, 10), 0.01, 3), [&](const Point_3& p)
                                         { return Point_3(0.37 * i * p.x(), 0.37 * i * p.y(), 0.37 * i * p.z()); }));
    for(double error : { 0., 1e-3 })
    {
      Field kept(scaled), dropped(scaled);
      for(Field* f : { &kept, &dropped })
        f->add_source(Vertex(5));
      kept.propagate(params::relative_distance_error(error));
      assert(
        dropped.propagate(params::keep_windows(false).relative_distance_error(error)).number_of_unreached_vertices ==
        0);
      for(Vertex v : scaled.vertices())
        assert(std::fabs(kept.distance(v) - dropped.distance(v)) <= (2 * error + 1e-12) * kept.distance(v));
    }
  }

  struct Stopper : CGAL::Quad_meshing::Default_visitor
  {
    int calls = 0;
    double last = 0;
    void progress(double x)
    {
      assert(x >= last && x <= 1);
      last = x;
    }
    bool go_further() { return ++calls < 5; }
  };
  Stopper stopper;
  assert(other.propagate(params::distance_limit(9).visitor(std::ref(stopper))).status == Status::STOPPED);

  Mesh bad = make_mesh(grid(2, 2));
  bad.point(Vertex(3)) = Point_3(std::nan(""), 0, 0);
  Field bad_field(bad);
  assert(bad_field.add_source(Vertex(0)) == Field::no_source());
  assert(bad_field.propagate().status == Status::POINT_NOT_FINITE);
  Mesh quad;
  quad.add_face(quad.add_vertex(Point_3(0, 0, 0)), quad.add_vertex(Point_3(1, 0, 0)), quad.add_vertex(Point_3(1, 1, 0)),
                quad.add_vertex(Point_3(0, 1, 0)));
  assert(Field(quad).propagate().status == Status::NOT_A_TRIANGLE_MESH);
  Mesh empty;
  assert(Field(empty).propagate().status == Status::NO_SOURCE);
}

// The error of merged windows stays within the bound, and there are fewer of them.
void test_approximation()
{
  std::cout << "approximation" << std::endl;
  for(const Soup& soup : { perturbed(torus(60, 30), 0.01, 3), perturbed(cube(12), 0.01, 4) })
  {
    const Mesh tm = make_mesh(soup);
    std::vector<Mesh::Edge_index> curve;
    for(auto e : tm.edges())
      if((tm.point(tm.vertex(e, 0)).x() - 0.1) * (tm.point(tm.vertex(e, 1)).x() - 0.1) < 0)
        curve.push_back(e);
    for(bool with_curve : { false, true })
    {
      Field exact(tm), fast(tm);
      for(Field* f : { &exact, &fast })
        with_curve ? f->add_edges_source(curve) : f->add_source(Vertex(7));
      exact.propagate();
      for(double error : { 1e-4, 1e-3, 1e-2 })
      {
        fast.propagate(params::relative_distance_error(error));
        assert(fast.number_of_windows() < exact.number_of_windows());
        double worst = 0;
        for(Vertex v : tm.vertices())
          if(exact.distance(v) > 0)
            worst = (std::max)(worst, std::fabs(fast.distance(v) - exact.distance(v)) / exact.distance(v));
        assert(worst <= error);
      }
    }
  }
}

// Refinement does not change the surface, new vertices have exact distances, and few are needed.
void test_refinement()
{
  std::cout << "refinement" << std::endl;
  const Mesh square = make_mesh(uneven_square(14, 3));
  for(bool from_border : { true, false })
  {
    Field field(square);
    const Point_3 p(square.point(Vertex(112)));
    if(from_border)
      field.add_border_source();
    else
      field.add_source(Vertex(112));
    field.propagate();
    const auto expected = [&](const Point_3& q) {
      return from_border ? (std::min)({ q.x(), q.y(), 1 - q.x(), 1 - q.y() }) : distance(p, q);
    };
    Mesh refined;
    auto d = refined.add_property_map<Vertex, double>("v:d", 0).first;
    const double tolerance = from_border ? 4e-4 : 1e-3;
    const auto result = CGAL::Quad_meshing::refine_distance_field(field, refined, d, tolerance);
    assert(result && result.error <= tolerance && result.number_of_faces == refined.number_of_faces());
    assert(!from_border ||
           (result.initial_error > 100 * result.error && result.number_of_faces <= 4 * square.number_of_faces()));
    assert(CGAL::is_triangle_mesh(refined) && refined.is_valid() && CGAL::is_valid_polygon_mesh(refined));
    assert(std::fabs(CGAL::Polygon_mesh_processing::area(refined) - 1) < 1e-12);
    for(Vertex v : refined.vertices())
      assert(std::fabs(d[v] - expected(refined.point(v))) < 1e-12);
    for(auto e : refined.edges())
    {
      const Vertex v = refined.vertex(e, 0), w = refined.vertex(e, 1);
      for(double t : { 0.2, 0.5, 0.7 })
        assert(std::fabs((1 - t) * d[v] + t * d[w] -
                         expected(refined.point(v) + t * (refined.point(w) - refined.point(v)))) < tolerance + 1e-12);
    }
  }

  // a limit on the number of faces, and a component without a source
  const Mesh tm = make_mesh(two_components(3, 2));
  Field field(tm);
  field.add_source(Vertex(0));
  field.propagate();
  Mesh refined;
  auto d = refined.add_property_map<Vertex, double>("v:d", 0).first;
  const auto result = CGAL::Quad_meshing::refine_distance_field(field, refined, d, 1e-9,
                                                                params::maximum_number_of_faces(std::size_t(2000)));
  assert(!result && result.number_of_faces >= 2000 && result.error < result.initial_error);
  assert(std::count(d.begin(), d.end(), infinity) > 0);
}

// The edges above an angle.
std::vector<Mesh::Edge_index> sharp_edges(Mesh& tm, double angle)
{
  std::vector<Mesh::Edge_index> sharp;
  auto is_sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(tm, angle, is_sharp);
  for(auto e : tm.edges())
    if(is_sharp[e])
      sharp.push_back(e);
  return sharp;
}

// Curves as sources have ridges everywhere, beside edges and along them: no edge is split forever.
void test_refinement_with_curves()
{
  std::cout << "refinement with curves as sources" << std::endl;
  std::vector<Mesh> meshes = { make_mesh(perturbed(l_prism(4), 0.02, 5)), make_mesh(perturbed(cube(5), 0.02, 2)) };
  Mesh fandisk;
  if(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/fandisk.off"), fandisk))
    meshes.push_back(fandisk);
  else
    std::cout << "  without fandisk.off" << std::endl;
  for(Mesh& tm : meshes)
  {
    Field field(tm);
    field.add_edges_source(sharp_edges(tm, 40));
    const double maximum = field.propagate().maximum_distance;
    for(double part : { 4e-3, 1e-3 })
    {
      Mesh refined;
      auto d = refined.add_property_map<Vertex, double>("v:d", 0).first;
      const auto result = CGAL::Quad_meshing::refine_distance_field(field, refined, d, part * maximum);
      assert(result && result.error <= part * maximum && result.number_of_faces < 40 * tm.number_of_faces());
      assert(CGAL::is_valid_polygon_mesh(refined));
    }
  }
}

// Isolines lie at their value, have it on the proper side, and end on the border or nowhere.
void test_isolines()
{
  std::cout << "isolines" << std::endl;
  // circles around a point of the plane, cut off by the border; the vertices that have the value itself make no trouble
  Mesh tm = make_mesh(grid(20, 20));
  const Point_3 center = tm.point(Vertex(198));
  Field field(tm);
  field.add_source(Vertex(198));
  field.propagate();
  Mesh refined;
  auto d = refined.add_property_map<Vertex, double>("v:d", 0).first;
  assert(CGAL::Quad_meshing::refine_distance_field(field, refined, d, 1e-4));
  const double to_border = (std::min)({ center.x(), center.y(), 1 - center.x(), 1 - center.y() });
  double last_length = 0;
  for(double value : { 0.05, 0.1, 0.15, 0.99 * to_border })
  {
    std::vector<std::vector<Point_3>> lines;
    CGAL::Quad_meshing::trace_isolines(refined, d, value, std::back_inserter(lines));
    assert(lines.size() == 1 && lines[0].front() == lines[0].back());
    double length = 0;
    for(std::size_t i = 1; i < lines[0].size(); ++i)
    {
      const Point_3 &p = lines[0][i - 1], &q = lines[0][i];
      assert(std::fabs(distance(q, center) - value) < 2e-4);
      // the center is on the right
      assert(p == q || CGAL::cross_product(q - p, center - p).z() < 0);
      length += distance(p, q);
    }
    assert(std::fabs(length - 2 * pi * value) < 0.01 * value && length > last_length);
    last_length = length;
  }
  std::vector<std::vector<Point_3>> lines;
  CGAL::Quad_meshing::trace_isolines(refined, d, 1.05 * to_border, std::back_inserter(lines));
  for(const auto& line : lines)
    for(const Point_3& p : { line.front(), line.back() })
      assert(p.x() == 0 || p.y() == 0 || p.x() == 1 || p.y() == 1);
  assert(!lines.empty());

  // a height on a torus: one circle, then two, then one; nothing at infinity
  Mesh donut = make_mesh(perturbed(torus(40, 20), 0.001, 2));
  auto height = donut.add_property_map<Vertex, double>("v:height", 0).first;
  double low = infinity, high = -infinity;
  for(Vertex v : donut.vertices())
  {
    height[v] = donut.point(v).x();
    low = (std::min)(low, height[v]);
    high = (std::max)(high, height[v]);
  }
  const auto count = [&](double value)
  {
    lines.clear();
    CGAL::Quad_meshing::trace_isolines(donut, height, value, std::back_inserter(lines));
    for(const auto& line : lines)
    {
      assert(line.size() > 3 && line.front() == line.back());
      for(const Point_3& p : line)
        assert(std::fabs(p.x() - value) < 1e-12);
    }
    return lines.size();
  };
  assert(count(0.95 * high + 0.05 * low) == 1 && count(0.5 * (high + low)) == 2 &&
         count(0.95 * low + 0.05 * high) == 1);
  assert(count(high + 1) == 0);
  for(Vertex v : donut.vertices())
    height[v] = infinity;
  assert(count(0) == 0);
}

// Zero-area faces, doubled points and needles do not change the metric.
void test_degenerate_faces()
{
  std::cout << "degenerate faces" << std::endl;
  // every edge of a grid's diagonal direction gets a vertex in the middle of it twice: two faces of zero area per
  // square
  const int n = 8;
  for(int kind = 0; kind < 3; ++kind)
  {
    Soup soup = grid(n, n);
    const std::size_t squares = soup.triangles.size() / 2;
    for(std::size_t s = 0; s < squares; ++s)
    {
      const Triangle a = soup.triangles[2 * s], b = soup.triangles[2 * s + 1]; // (p, q, r) and (p, r, t)
      const std::size_t m = soup.points.size();
      const Point_3 p = soup.points[a[0]], r = soup.points[a[2]];
      if(kind == 0)
      {
        // two points on the diagonal, the second one only on one side of it: the face (m, m+1, r) has no area
        soup.points.push_back(p + 0.25 * (r - p));
        soup.points.push_back(p + 0.5 * (r - p));
        soup.triangles[2 * s] = { { a[0], a[1], m } };
        soup.triangles.push_back({ { m, a[1], a[2] } });
        soup.triangles.push_back({ { m, a[2], m + 1 } });
        soup.triangles[2 * s + 1] = { { m, m + 1, b[2] } };
        soup.triangles.push_back({ { m + 1, b[1], b[2] } });
        soup.triangles.push_back({ { b[0], m, b[2] } });
      }
      else
      {
        // a doubled point (or nearly) in the middle
        soup.points.push_back(p + 0.5 * (r - p));
        soup.points.push_back(p + 0.5 * (r - p) + (kind == 1 ? 0. : 1e-9) * Vector_3(-1, 1, 0));
        soup.triangles[2 * s] = { { a[0], a[1], m } };
        soup.triangles.push_back({ { m, a[1], a[2] } });
        soup.triangles.push_back({ { m, a[2], m + 1 } });
        soup.triangles.push_back({ { a[0], m, m + 1 } });
        soup.triangles[2 * s + 1] = { { a[0], m + 1, b[2] } };
        soup.triangles.push_back({ { m + 1, b[1], b[2] } });
      }
    }
    const Mesh tm = make_mesh(soup);
    for(int source : { 0, 40, int(tm.number_of_vertices()) - 1 })
    {
      Field field(tm);
      field.add_source(Vertex(source));
      assert(field.propagate().number_of_unreached_vertices == 0);
      const Point_3 p = tm.point(Vertex(source));
      for(Vertex v : tm.vertices())
        assert(std::fabs(field.distance(v) - distance(p, tm.point(v))) < 1e-12);
      check_without_windows(tm, field, 1e-11);
    }
  }
}

// The same algorithm with fifty digits tells the rounding errors of double; with known distances it shows that it has
// the digits.
void test_more_digits()
{
  std::cout << "fifty digits, and all of them" << std::endl;
  typedef boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                        boost::multiprecision::et_off>
    Number;
  for(const Soup& soup : { perturbed(torus(12, 8), 0.03, 2), icosphere(2), cylinder(8, 4, false), grid(6, 6) })
  {
    const Mesh tm = make_mesh(soup);
    CGAL::Quad_meshing::Geodesic_distance_field<Mesh, Number> precise(tm);
    Field field(tm);
    precise.add_source(Vertex(0));
    field.add_source(Vertex(0));
    assert(precise.propagate() && field.propagate());
    for(Vertex v : tm.vertices())
      assert(std::fabs(precise.distance(v) - field.distance(v)) < 1e-14);
  }
  const Mesh tm = make_mesh(cube(3));
  CGAL::Quad_meshing::Geodesic_distance_field<Mesh, Number> precise(tm);
  const auto before = [&](Vertex v, Vertex w) { return tm.point(v) < tm.point(w); };
  const Vertex p = *std::min_element(tm.vertices().begin(), tm.vertices().end(), before);
  const Vertex q = *std::max_element(tm.vertices().begin(), tm.vertices().end(), before);
  precise.add_source(p);
  precise.propagate();
  const Number side = Number(tm.point(q).x()) - Number(tm.point(p).x());
  assert(abs(precise.distance_value(q) - side * sqrt(Number(5))) < Number(1e-15));

  // exact roots, on a mesh that is small enough for them
  const Mesh square = make_mesh(grid(2, 2));
  CGAL::Quad_meshing::Geodesic_distance_field<Mesh, CORE::Expr> exact(square);
  exact.add_source(Vertex(0));
  assert(exact.propagate());
  const Point_3 o = square.point(Vertex(0));
  for(Vertex v : square.vertices())
  {
    const CORE::Expr x = CORE::Expr(square.point(v).x()) - CORE::Expr(o.x()),
                     y = CORE::Expr(square.point(v).y()) - CORE::Expr(o.y());
    assert(exact.distance_value(v) == sqrt(x * x + y * y));
  }
}

// The same mesh with its vertices and triangles in another order. Vertex i becomes vertex number[i].
Soup shuffled(const Soup& soup, std::vector<std::size_t>& number)
{
  CGAL::Random random(7);
  number.resize(soup.points.size());
  std::iota(number.begin(), number.end(), std::size_t(0));
  CGAL::cpp98::random_shuffle(number.begin(), number.end(), random);
  Soup other = soup;
  for(std::size_t i = 0; i < number.size(); ++i)
    other.points[number[i]] = soup.points[i];
  CGAL::cpp98::random_shuffle(other.triangles.begin(), other.triangles.end(), random);
  for(auto& t : other.triangles)
  {
    for(std::size_t& v : t)
      v = number[v];
    std::rotate(t.begin(), t.begin() + random.get_int(0, 3), t.end());
  }
  return other;
}

// How many faces windows cross at a time depends on the number of sources, and how the elements are numbered inside on
// their places: neither changes a distance, at vertices or in faces. On the needles straight lines wind around the
// tips, through the same faces again and again.
void test_groups()
{
  std::cout << "groups of faces" << std::endl;
  const auto needle = [](const Point_3& p) { return Point_3(0.05 * p.x(), 0.05 * p.y(), p.z()); };
  for(const Soup& soup :
      { perturbed(torus(24, 16), 0.02, 3), perturbed(cube(5), 0.03, 1), uneven_square(16, 2), cube(1), icosphere(0),
        mapped(icosphere(3), needle), mapped(perturbed(icosphere(2), 0.05, 4), needle), cone(24, 12, 0.05, 1) })
  {
    std::vector<std::size_t> number;
    const Mesh tm = make_mesh(soup), other = make_mesh(shuffled(soup, number));
    for(std::size_t i : { std::size_t(0), soup.points.size() / 2, soup.points.size() - 1 })
    {
      const Vertex source(static_cast<Mesh::size_type>(i));
      Field field(tm), with_copies(tm), in_other_order(other);
      field.add_source(source);
      for(int k = 0; k < 9; ++k)
        with_copies.add_source(source);
      in_other_order.add_source(Vertex(static_cast<Mesh::size_type>(number[i])));
      assert(field.propagate() && with_copies.propagate() && in_other_order.propagate());
      const auto are_equal = [](double a, double b) { return std::fabs(a - b) <= 1e-12 * a; };
      for(Vertex v : tm.vertices())
      {
        assert(are_equal(field.distance(v), with_copies.distance(v)));
        assert(are_equal(field.distance(v), in_other_order.distance(Vertex(static_cast<Mesh::size_type>(number[v])))));
      }
      for(auto f : tm.faces())
      {
        const Location l(f, { { 0.2, 0.3, 0.5 } });
        assert(are_equal(field.distance(l), with_copies.distance(l)));
      }
    }
  }
}

void test_other_graphs()
{
  std::cout << "Polyhedron_3" << std::endl;
  typedef CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> Polyhedron;
  const Mesh tm = make_mesh(perturbed(torus(12, 8), 0.02, 3));
  Polyhedron p;
  CGAL::copy_face_graph(tm, p);
  Field field(tm);
  CGAL::Quad_meshing::Geodesic_distance_field<Polyhedron> other(p);
  const auto same = [&](Vertex w)
  {
    return *std::find_if(vertices(p).begin(), vertices(p).end(),
                         [&](const auto& v) { return v->point() == tm.point(w); });
  };
  field.add_source(Vertex(0));
  other.add_source(same(Vertex(0)));
  field.propagate();
  other.propagate();
  for(Vertex w : tm.vertices())
    assert(std::fabs(field.distance(w) - other.distance(same(w))) < 1e-13);
}

// The numbering of a mesh from which faces were removed has gaps.
void test_gaps()
{
  std::cout << "gaps" << std::endl;
  Mesh whole = make_mesh(perturbed(torus(12, 8), 0.02, 3));
  Mesh tm = make_mesh(joined(icosphere(1), perturbed(torus(12, 8), 0.02, 3)));
  const std::size_t removed = tm.number_of_faces() - whole.number_of_faces();
  for(std::size_t f = 0; f < removed; ++f)
    CGAL::Euler::remove_face(tm.halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(f))), tm);
  assert(tm.has_garbage());
  Field field(whole), other(tm);
  field.add_source(*whole.vertices().begin());
  other.add_source(*tm.vertices().begin());
  field.propagate();
  other.propagate();
  auto v = tm.vertices().begin();
  for(Vertex w : whole.vertices())
    assert(whole.point(w) == tm.point(*v) && field.distance(w) == other.distance(*v++));
  auto isolines = [](Mesh& tm, const Field& field)
  {
    auto distance = tm.add_property_map<Vertex, double>("v:distance").first;
    for(Vertex w : tm.vertices())
      distance[w] = field.distance(w);
    std::vector<std::vector<Point_3>> lines;
    CGAL::Quad_meshing::trace_isolines(tm, distance, 0.5, std::back_inserter(lines));
    return lines;
  };
  assert(!isolines(whole, field).empty() && isolines(whole, field) == isolines(tm, other));
}

int main()
{
  test_points_in_the_plane();
  test_stretched_plane();
  test_polylines_in_the_plane();
  test_border();
  test_hole();
  test_cones();
  test_cube();
  test_against_CGAL();
  test_real_meshes();
  test_sampled_polyline();
  test_windows_of_all_edges();
  test_concurrent_queries();
  test_mixed_sources();
  test_reach();
  test_approximation();
  test_refinement();
  test_refinement_with_curves();
  test_isolines();
  test_degenerate_faces();
  test_more_digits();
  test_groups();
  test_other_graphs();
  test_gaps();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
