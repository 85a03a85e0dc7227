// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "extraction_meshes.h"
#include "quad_mesh_checks.h"
#include "stage_checks.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>
#include <CGAL/Quad_meshing/Extraction/transfer_feature_edges.h>
#include <CGAL/Quad_meshing/internal/surface_topology.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

using namespace extraction_meshes;
using quad_mesh_checks::figures;
using quad_mesh_checks::Mesh_figures;

typedef CGAL::Quad_meshing::Quad_extraction_result Result;
typedef CGAL::Quad_meshing::Quad_extraction_status Status;
typedef std::pair<Mesh::Face_index, std::array<double, 3>> Location;
typedef Mesh::Property_map<Mesh::Vertex_index, Location> Location_map;

namespace params = CGAL::parameters;

// Locations lie in their faces, their images are grid points, and they give the points of the quad mesh.
void check_locations(const Mapped_mesh& m, const Mesh& qm, const Location_map& locations)
{
  for(auto v : qm.vertices())
  {
    const Location l = locations[v];
    auto h = m.mesh.halfedge(l.first);
    double x = 0, y = 0;
    CGAL::Vector_3<Kernel> p(0, 0, 0);
    for(int i = 0; i < 3; ++i)
    {
      assert(l.second[i] >= 0 && l.second[i] <= 1);
      const auto before = m.mesh.prev(h);
      x += l.second[i] * m.uv[before].x();
      y += l.second[i] * m.uv[before].y();
      p = p + l.second[i] * (m.mesh.point(m.mesh.source(h)) - CGAL::ORIGIN);
      h = m.mesh.next(h);
    }
    assert(std::fabs(x - std::round(x)) < 1e-9 && std::fabs(y - std::round(y)) < 1e-9);
    assert(CGAL::squared_distance(CGAL::ORIGIN + p, qm.point(v)) < 1e-20);
  }
}

// The valences that remain of a coarse mesh in a finer one.
std::map<int, std::size_t> irregular(const std::map<int, std::size_t>& valences, int regular)
{
  std::map<int, std::size_t> r = valences;
  r.erase(regular);
  return r;
}

// An exact map gives the quad mesh it was made from.
void check_exact(const Coarse_mesh& coarse, const Options& o, bool simple = true)
{
  const Mapped_mesh m = triangulated(coarse, o);
  const Mesh_figures tf = figures(m.mesh);
  assert(m.complete && tf.consistent && tf.vertex_manifold);

  Mesh qm;
  Location_map locations = qm.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
  const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm, params::face_location_map(locations));
  const Mesh_figures qf = figures(qm);

  if(r.status != (simple ? Status::VALID : Status::NOT_SIMPLE))
    std::cerr << r.message << " k=" << o.k << " seed=" << o.seed << std::endl;
  assert(r.status == (simple ? Status::VALID : Status::NOT_SIMPLE));
  assert(qf.is_valid());
  assert(qf.is_simple() == simple);
  assert(qf.same_topology(tf));
  assert(qf.faces == coarse.quads.size() * o.k * o.k);
  assert(qf.index_sum() == 4 * qf.euler());
  assert(r.quads == qf.faces && r.vertices == qf.vertices && r.other_faces == 0);
  assert(r.irregular_vertices == qf.irregular_vertices());
  std::size_t irregular_on_border = 0;
  for(const auto& v : irregular(qf.border_valences, 3))
    irregular_on_border += v.second;
  assert(r.irregular_border_vertices == irregular_on_border);
  assert(r.same_topology && r.is_usable() == simple);
  assert(r.edges_cut_by_border == 0 && r.uncovered_area == 0 && r.cells_with_holes == 0 && r.removed_edges == 0 &&
         r.split_vertices == 0);
  check_locations(m, qm, locations);

  // The irregular vertices are those of the coarse mesh.
  Options coarsest = o;
  coarsest.k = 1;
  coarsest.denominator = 8;
  Mesh cm;
  const Mapped_mesh mc = triangulated(coarse, coarsest);
  CGAL::Quad_meshing::extract_quad_mesh(mc.mesh, mc.uv, cm);
  const Mesh_figures cf = figures(cm);
  assert(cf.faces == coarse.quads.size());
  assert(irregular(cf.inner_valences, 4) == irregular(qf.inner_valences, 4));
  assert(irregular(cf.border_valences, 3) == irregular(qf.border_valences, 3));

  // Other charts, same mesh.
  Mapped_mesh other(m);
  shuffle_charts(other, o.seed + 17);
  Mesh qo;
  CGAL::Quad_meshing::extract_quad_mesh(other.mesh, other.uv, qo);
  assert(qo.number_of_vertices() == qm.number_of_vertices() && qo.number_of_edges() == qm.number_of_edges());
  auto sorted = [](const Mesh& mesh)
  {
    std::vector<Point_3> p;
    for(auto v : mesh.vertices())
      p.push_back(Point_3(std::round(1e6 * mesh.point(v).x()), std::round(1e6 * mesh.point(v).y()),
                          std::round(1e6 * mesh.point(v).z())));
    std::sort(p.begin(), p.end());
    return p;
  };
  assert(sorted(qo) == sorted(qm));
}

void test_exact_maps()
{
  auto full = [](int, int) { return true; };
  auto l_shape = [](int i, int j) { return i == 0 || j == 0; };
  auto annulus = [](int i, int j) { return i != 1 || j != 1; };

  std::vector<Coarse_mesh> shapes;
  shapes.push_back(coarse_cube());
  shapes.push_back(coarse_plane(3, 2, full));
  shapes.push_back(coarse_plane(3, 3, l_shape));
  shapes.push_back(coarse_plane(3, 3, annulus));
  shapes.push_back(coarse_torus(4, 3, 0));
  shapes.push_back(coarse_torus(4, 3, 1));
  shapes.push_back(coarse_torus(5, 3, 2));
  shapes.push_back(coarse_cylinder(4, 2));
  shapes.push_back(joined(coarse_cube(), joined(coarse_torus(3, 4, 1), coarse_fan(2))));
  for(int valence = 3; valence <= 9; ++valence)
    shapes.push_back(coarse_cone(valence));
  for(int squares = 1; squares <= 9; ++squares)
    shapes.push_back(coarse_fan(squares));

  // From triangles with hundreds of grid points to grid cells with dozens of triangles; denominators
  // from 1 (all vertices on grid points) to one that makes coincidences rare.
  struct
  {
    int k, inner, edge, denominator;
  } const densities[] = { { 1, 4, 1, 2 },  { 1, 30, 5, 16 }, { 2, 3, 1, 1 },         { 2, 10, 2, 2 },
                          { 3, 5, 3, 4 },  { 4, 40, 6, 1 },  { 5, 2, 1, 8 },         { 7, 30, 6, 2 },
                          { 20, 3, 1, 1 }, { 30, 4, 2, 64 }, { 3, 100, 12, 1048576 } };
  unsigned int seed = 1;
  for(const Coarse_mesh& c : shapes)
    for(const auto& d : densities)
    {
      Options o;
      o.k = d.k;
      o.inner_points = d.inner;
      o.edge_points = d.edge;
      o.denominator = d.denominator;
      o.seed = ++seed;
      check_exact(c, o);
    }
}

// Cones of one and two quads: the mesh is right as a halfedge data structure.
void test_small_valences()
{
  auto complete = [](const Coarse_mesh& c, int k)
  {
    Options o;
    o.k = k;
    o.inner_points = 200;
    o.edge_points = 8;
    o.denominator = 64;
    while(!triangulated(c, o).complete)
      ++o.seed;
    return triangulated(c, o);
  };
  for(int k : { 1, 2, 3 })
  {
    const Mapped_mesh one = complete(coarse_cone(1), k), two = complete(coarse_cone(2), k);
    Mesh q1, q2;
    const Result r1 = CGAL::Quad_meshing::extract_quad_mesh(one.mesh, one.uv, q1);
    const Result r2 = CGAL::Quad_meshing::extract_quad_mesh(two.mesh, two.uv, q2);
    const Mesh_figures f1 = figures(q1), f2 = figures(q2);
    // The quad at the tip of the first cone meets itself; the two at the tip of the second one share two edges.
    assert(f1.consistent && f1.vertex_manifold && f1.quads == std::size_t(k * k) && f1.faces == f1.quads);
    assert(f1.inner_valences.at(1) == 1 && f1.euler() == 1);
    assert(r1.status == (f1.multiple_edges > 0 ? Status::NOT_SIMPLE : Status::VALID));
    assert(f2.is_valid() && f2.quads == std::size_t(2 * k * k) && f2.inner_valences.at(2) == 1 && f2.euler() == 1);
    assert(r2.status == (f2.multiple_edges > 0 ? Status::NOT_SIMPLE : Status::VALID));
    assert(r1.multiple_edges == f1.multiple_edges && r2.multiple_edges == f2.multiple_edges);
  }
}

// A convex polygon, triangulated over random points, under an affine map; the border does not run along isolines.
// The result has exactly the grid cells that lie inside.
void test_unaligned_borders()
{
  typedef CGAL::Delaunay_triangulation_2<Kernel> Delaunay;
  std::mt19937 rng(7);
  for(int run = 0; run < 60; ++run)
  {
    // Determinant at least 1/4, entries multiples of 1/8.
    const double a = (rng() % 33) / 8. - 2, b = (rng() % 33) / 8. - 2, c = (rng() % 33) / 8. - 2,
                 d = (rng() % 33) / 8. - 2;
    if(a * d - b * c < 0.25)
      continue;
    auto map = [&](const Point_2& p) { return Point_2(a * p.x() + b * p.y() + 0.5, c * p.x() + d * p.y() - 0.25); };
    std::vector<Point_2> border = { Point_2(0, 0), Point_2(5, -1), Point_2(7, 3), Point_2(4, 6), Point_2(-1, 4) };
    Delaunay dt(border.begin(), border.end());
    for(int i = 0; i < (run % 5) * 20; ++i)
    {
      const Point_2 p(rng() % 64 / 8., rng() % 64 / 8.);
      bool inside = true;
      for(std::size_t j = 0; j < border.size(); ++j)
        inside &= CGAL::left_turn(border[j], border[(j + 1) % border.size()], p);
      if(inside)
        dt.insert(p);
    }
    Mapped_mesh m;
    std::map<Point_2, Mesh::Vertex_index> id;
    for(auto v = dt.finite_vertices_begin(); v != dt.finite_vertices_end(); ++v)
      id[v->point()] = m.mesh.add_vertex(Point_3(v->point().x(), v->point().y(), 0));
    for(auto f = dt.finite_faces_begin(); f != dt.finite_faces_end(); ++f)
      add_triangle(m, { { id[f->vertex(0)->point()], id[f->vertex(1)->point()], id[f->vertex(2)->point()] } },
                   { { map(f->vertex(0)->point()), map(f->vertex(1)->point()), map(f->vertex(2)->point()) } });
    shuffle_charts(m, run);

    std::size_t expected = 0;
    for(int x = -60; x < 60; ++x)
      for(int y = -60; y < 60; ++y)
      {
        bool inside = true;
        for(int i = 0; i < 4; ++i)
          for(std::size_t j = 0; j < border.size(); ++j)
            inside &= !CGAL::right_turn(map(border[j]), map(border[(j + 1) % border.size()]),
                                        Point_2(x + (i & 1), y + (i >> 1)));
        expected += inside;
      }
    Mesh qm;
    const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm);
    const Mesh_figures f = figures(qm);
    assert(qm.number_of_faces() == expected);
    assert(r.status == (expected > 0 ? Status::VALID : Status::FAILED));
    if(expected > 0)
      assert(f.is_valid() && r.edges_cut_by_border > 0 && r.uncovered_area > 0);
  }
}

// A hole inside one cell leaves that cell out, wherever the grid lines run.
void test_cells_with_holes()
{
  std::size_t dropped = 0;
  for(unsigned int seed = 0; seed < 40; ++seed)
  {
    Options o;
    o.k = 3;
    o.inner_points = 400;
    o.edge_points = 20;
    o.denominator = seed % 2 == 0 ? 16 : 64;
    o.seed = seed;
    Mapped_mesh m = triangulated(coarse_cube(), o);
    // Remove the triangles around two inner vertices.
    std::mt19937 rng(seed);
    for(int i = 0; i < 2; ++i)
    {
      const Mesh::Vertex_index v(8 + rng() % (m.mesh.number_of_vertices() - 8));
      if(!m.mesh.is_removed(v) && !m.mesh.is_border(v))
        CGAL::Euler::make_hole(CGAL::Euler::remove_center_vertex(m.mesh.halfedge(v), m.mesh), m.mesh);
    }
    m.mesh.collect_garbage();
    const Mesh_figures tf = figures(m.mesh);
    Mesh qm;
    const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm);
    const Mesh_figures f = figures(qm);
    assert(r.status == Status::VALID && f.is_valid() && tf.border_loops > 0);
    // Every hole takes at least one cell away, and two holes may grow together.
    assert(r.same_topology == f.same_topology(tf));
    assert(f.faces < 54 && f.border_loops > 0 && f.border_loops <= tf.border_loops);
    dropped += r.cells_with_holes;
  }
  assert(dropped > 10);
}

// Moved vertices that leave all triangles positive change nothing but places.
void test_perturbation()
{
  std::mt19937 rng(3);
  Options o;
  o.k = 6;
  o.inner_points = 60;
  o.edge_points = 5;
  o.denominator = 4;
  o.random_charts = false;
  Mapped_mesh m = triangulated(coarse_plane(2, 2, [](int, int) { return true; }), o);
  // One chart for all, by the places of the vertices.
  for(auto h : m.mesh.halfedges())
    m.uv[h] = Point_2(o.k * m.mesh.point(m.mesh.target(h)).x(), o.k * m.mesh.point(m.mesh.target(h)).y());
  std::size_t moved = 0;
  for(int round = 0; round < 3; ++round)
    for(auto v : m.mesh.vertices())
    {
      if(m.mesh.is_border(v))
        continue;
      const Point_2 old = m.uv[m.mesh.halfedge(v)];
      const Point_2 p(old.x() + int(rng() % 33 - 16) / 64., old.y() + int(rng() % 33 - 16) / 64.);
      bool fine = true;
      for(auto h : CGAL::halfedges_around_target(v, m.mesh))
        fine &= CGAL::left_turn(p, m.uv[m.mesh.next(h)], m.uv[m.mesh.next(m.mesh.next(h))]);
      if(!fine)
        continue;
      ++moved;
      for(auto h : CGAL::halfedges_around_target(v, m.mesh))
        m.uv[h] = p;
    }
  assert(moved > 50);
  shuffle_charts(m, 4);
  Mesh qm;
  const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm);
  assert(r.status == Status::VALID && figures(qm).is_valid() && r.quads == 144 && r.uncovered_area == 0);
}

// Noise of the size of a text file with six digits is removed.
void test_inexact_maps()
{
  std::mt19937 rng(5);
  for(const Coarse_mesh& c : { coarse_cube(), coarse_cone(5), coarse_cone(8), coarse_torus(4, 3, 1),
                               coarse_plane(3, 2, [](int, int) { return true; }) })
    for(int k : { 1, 4, 9 })
    {
      Options o;
      o.k = k;
      o.inner_points = 20;
      o.edge_points = 3;
      Mapped_mesh m = triangulated(c, o);
      Mesh exact, noisy;
      assert(CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, exact).status == Status::VALID);
      for(auto h : m.mesh.halfedges())
        if(!m.mesh.is_border(h))
          m.uv[h] =
            Point_2(m.uv[h].x() + 1e-6 * (rng() % 1001 - 500.) / 500, m.uv[h].y() + 1e-6 * (rng() % 1001 - 500.) / 500);
      const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, noisy);
      assert(r.status == Status::VALID && r.inexact_transitions > 0 && r.inconsistent_transitions == 0);
      assert(r.largest_coordinate_change > 0 && r.largest_coordinate_change < 1e-5);
      assert(figures(noisy).is_valid() && noisy.number_of_faces() == exact.number_of_faces());
      assert(figures(noisy).same_topology(figures(m.mesh)));
    }
}

// Extraction in which fold-overs are not undone in the map, so that all is left to the graph of the grid lines.
Result extract_without_unfolding(const Mapped_mesh& m, Mesh& qm)
{
  namespace internal = CGAL::Quad_meshing::internal;
  const internal::Indexed_triangle_mesh mesh = internal::make_indexed_triangle_mesh(
    m.mesh, m.mesh.points(), get(boost::vertex_index, m.mesh), get(boost::face_index, m.mesh));
  internal::Any_visitor visitor;
  internal::Extracted_quads quads;
  Result r;
  if(internal::extract_quads(mesh, internal::copy_corners(m.mesh, m.uv, get(boost::face_index, m.mesh)), visitor, quads,
                             r, 0))
    internal::write_grid_graph(quads.graph, quads.vertex_of_ray, quads.vertices.size(), qm,
                               [&](std::size_t i)
                               {
                                 const auto p = internal::position(mesh, quads.vertices[i]);
                                 return qm.add_vertex(Point_3(p.x(), p.y(), p.z()));
                               });
  return r;
}

// Fold-overs made by moving vertices of a regular region across their links, by up to the size of a cell.
void test_fold_overs()
{
  std::mt19937 rng(11);
  for(int denominator : { 64, 4, 1 })
    for(bool unfold : { true, false })
    {
      std::size_t pure = 0, folded = 0;
      const int runs = 100;
      for(int run = 0; run < runs; ++run)
      {
        Options o;
        o.k = 1 + run % 5;
        o.inner_points = 30;
        o.edge_points = 3;
        o.denominator = 64;
        o.seed = run;
        o.random_charts = false;
        if(denominator < 64)
          o.k = 4 + run % 4, o.denominator = denominator;
        Mapped_mesh m = triangulated(coarse_torus(4, 4, 0), o);
        const int n = 1 + run % 3, size = denominator;
        for(int i = 0; i < n; ++i)
        {
          const Mesh::Vertex_index v(16 + rng() % (m.mesh.number_of_vertices() - 16));
          auto jump = [&]() { return (static_cast<int>(rng() % (2 * size + 1)) - size) / static_cast<double>(size); };
          const double dx = jump(), dy = jump();
          for(auto h : CGAL::halfedges_around_target(v, m.mesh))
            m.uv[h] = Point_2(m.uv[h].x() + dx, m.uv[h].y() + dy);
        }
        shuffle_charts(m, run);
        Mesh qm;
        const Result r =
          unfold ? CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm) : extract_without_unfolding(m, qm);
        const Mesh_figures f = figures(qm);
        assert(r.status == Status::VALID || r.status == Status::REPAIRED);
        assert(f.consistent && f.vertex_manifold && f.isolated_vertices == 0);
        assert(r.quads == f.quads && r.other_faces == f.faces - f.quads);
        assert(r.same_topology == f.same_topology(figures(m.mesh)));
        if(r.status == Status::VALID)
          assert(f.is_valid() && f.same_topology(figures(m.mesh)) && f.faces == std::size_t(16 * o.k * o.k));
        folded += r.status != Status::VALID;
        pure += f.is_valid() && f.same_topology(figures(m.mesh)) && f.faces == std::size_t(16 * o.k * o.k);
      }
      std::cout << "fold-overs, multiples of 1/" << denominator << (unfold ? "" : ", graph alone") << ": " << folded
                << " of " << runs << " folded, " << pure << " without trace" << std::endl;
      assert(folded > runs / 2 && pure >= runs - runs / 50);
    }
}

typedef std::function<bool(int, int, int)> Occupied;
typedef std::array<std::vector<int>, 3> Slabs;

// A polycube, mapped so that slab i of cells across axis a is sizes[a][i] grid cells thick. A slab of thickness 0 puts
// singular vertices on one point: the mesh is that of the polycube without the slab.
Mapped_mesh polycube(const Occupied& occupied, const Slabs& sizes, int n, unsigned int seed)
{
  auto count = [&](int a) { return static_cast<int>(sizes[a].size()); };
  const test_meshes::Soup soup = test_meshes::voxel_surface(occupied, count(0), count(1), count(2), n);
  Mapped_mesh m;
  std::vector<Mesh::Vertex_index> v;
  for(const auto& p : soup.points)
    v.push_back(m.mesh.add_vertex(Point_3(p.x(), p.y(), p.z())));
  for(const auto& t : soup.triangles)
  {
    const Point_3 p[3] = { m.mesh.point(v[t[0]]), m.mesh.point(v[t[1]]), m.mesh.point(v[t[2]]) };
    const CGAL::Vector_3<Kernel> normal = CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
    int axis = 0;
    while(normal[axis] == 0)
      ++axis;
    auto image = [&](int i, int a)
    {
      double c = p[i][a], sum = 0;
      for(int s : sizes[a])
      {
        sum += s * (std::min)((std::max)(c, 0.), 1.);
        c -= 1;
      }
      return sum;
    };
    std::array<Point_2, 3> uv;
    for(int i = 0; i < 3; ++i)
    {
      const double x = image(i, (axis + 1) % 3), y = image(i, (axis + 2) % 3);
      uv[i] = normal[axis] > 0 ? Point_2(x, y) : Point_2(y, x);
    }
    add_triangle(m, { { v[t[0]], v[t[1]], v[t[2]] } }, uv);
  }
  shuffle_charts(m, seed);
  return m;
}

// Singular vertices stay where they are. (One of valence 8, around which the charts do not turn in sum, may be hidden
// by the fold.)
void test_fold_overs_at_singular_vertices()
{
  std::mt19937 rng(17);
  for(int valence : { 3, 5, 8 })
    for(int run = 0; run < 20; ++run)
    {
      Options o;
      o.k = 3;
      o.inner_points = 12;
      o.edge_points = 2;
      o.denominator = 16;
      o.seed = run;
      o.random_charts = false;
      Mapped_mesh m = triangulated(coarse_cone(valence), o);
      // Neighbors of the center inside a coarse quad, which have one chart, jump over it.
      std::size_t moved = 0;
      for(auto h : CGAL::halfedges_around_source(Mesh::Vertex_index(0), m.mesh))
      {
        const Mesh::Vertex_index v = m.mesh.target(h);
        bool one_chart = !m.mesh.is_border(v);
        for(auto g : CGAL::halfedges_around_target(v, m.mesh))
          one_chart &= !m.mesh.is_border(g) && m.uv[g] == m.uv[m.mesh.halfedge(v)];
        if(!one_chart || rng() % 3 != 0)
          continue;
        for(auto g : CGAL::halfedges_around_target(v, m.mesh))
          m.uv[g] = Point_2(-0.25, -0.125);
        ++moved;
      }
      shuffle_charts(m, run);
      Mesh qm;
      const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm);
      const Mesh_figures f = figures(qm);
      assert(f.consistent && f.vertex_manifold);
      assert(r.status == (moved == 0 ? Status::VALID : Status::REPAIRED));
      if(valence == 8 && moved > 0)
        continue;
      assert(r.singular_vertices_off_grid == 0);
      assert(r.is_usable() && f.is_valid() && f.faces == std::size_t(9 * valence) && f.inner_valences.at(valence) == 1);
    }
}

void test_collapsed_arcs()
{
  auto bump = [](int x, int y, int z) { return z == 0 || (x == 1 && y == 1); };
  auto box = [](int, int, int) { return true; };
  auto steps = [](int x, int, int z) { return z <= x; };
  struct
  {
    Occupied occupied;
    Slabs sizes;
    std::size_t quads, irregular;
  } const cases[] = {
    { box, { { { 3 }, { 2 }, { 1 } } }, 22, 8 },
    { bump, { { { 1, 2, 1 }, { 2, 2, 1 }, { 2, 1 } } }, 4 * 5 * 2 + 2 * 2 * 9 + 8, 16 },
    { box, { { { 3 }, { 2 }, { 0 } } }, 12, 4 },
    { bump, { { { 1, 2, 1 }, { 2, 2, 1 }, { 2, 0 } } }, 4 * 5 * 2 + 2 * 2 * 9, 8 },
    { bump, { { { 1, 0, 1 }, { 2, 2, 1 }, { 2, 1 } } }, 2 * 5 * 2 + 2 * 2 * 7 + 4, 12 },
    { steps, { { { 2, 2, 2 }, { 2 }, { 1, 0, 1 } } }, 48, 12 },
  };
  for(const auto& c : cases)
    for(int n : { 4, 3, 2, 1 })
    {
      const Mapped_mesh m = polycube(c.occupied, c.sizes, n, n);
      Mesh qm;
      const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm);
      const Mesh_figures f = figures(qm);
      const bool is_collapsed = r.status != Status::VALID;
      assert(f.is_valid() && f.euler() == 2 && f.components == 1);
      assert(f.faces == c.quads && f.irregular_vertices() == c.irregular);
      assert(is_collapsed == (c.sizes[0][c.sizes[0].size() / 2] == 0 || c.sizes[2][c.sizes[2].size() / 2] == 0));
    }
}

// Nothing that can be in the map makes the extraction crash, hang, or write something that is not a manifold mesh.
void test_garbage()
{
  std::mt19937 rng(13);
  auto check = [&](const Mapped_mesh& m, const char* what)
  {
    Mesh qm;
    const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm);
    const Mesh_figures f = figures(qm);
    assert(f.consistent && f.vertex_manifold && f.isolated_vertices == 0);
    assert(!r.message.empty());
    assert((r.status == Status::FAILED) == (f.faces == 0));
    assert(r.status != Status::VALID || (f.is_valid() && f.is_simple()));
    assert(r.same_topology == (f.faces > 0 && f.same_topology(figures(m.mesh))));
    if(std::getenv("QUAD_MESHING_TEST_VERBOSE") != nullptr)
      std::cout << what << ": " << r.message << std::endl;
    return r.status;
  };
  Options o;
  o.inner_points = 40;
  o.edge_points = 4;
  o.denominator = 32;
  const Mapped_mesh sphere = triangulated(coarse_cube(), o), disk = triangulated(coarse_fan(3), o);
  for(const Mapped_mesh* base : { &sphere, &disk })
  {
    Mapped_mesh m(*base);
    for(auto h : m.mesh.halfedges())
      m.uv[h] = Point_2(0, 0);
    assert(check(m, "all zero") == Status::FAILED);
    for(auto h : m.mesh.halfedges())
      m.uv[h] = Point_2(rng() % 1000 / 100., rng() % 1000 / 100.);
    assert(check(m, "random") != Status::VALID);
    for(auto h : m.mesh.halfedges())
      m.uv[h] = Point_2(int(rng() % 5), int(rng() % 5));
    assert(check(m, "random integers") != Status::VALID);
    for(auto h : m.mesh.halfedges())
      m.uv[h] = Point_2(1e300 * (rng() % 3), 1e-300);
    assert(check(m, "huge") == Status::FAILED);
    for(auto h : m.mesh.halfedges())
      m.uv[h] = Point_2(1e9 * (rng() % 3), 1e9 * (rng() % 3));
    assert(check(m, "too many") == Status::FAILED);
    for(auto v : m.mesh.vertices())
    {
      const Point_2 p(rng() % 640 / 64., rng() % 640 / 64.);
      for(auto h : CGAL::halfedges_around_target(v, m.mesh))
        m.uv[h] = p;
    }
    assert(check(m, "random per vertex") != Status::VALID);
    for(auto v : m.mesh.vertices())
    {
      const Point_2 p(int(rng() % 4), int(rng() % 4));
      for(auto h : CGAL::halfedges_around_target(v, m.mesh))
        m.uv[h] = p;
    }
    assert(check(m, "random integers per vertex") != Status::VALID);
    Mapped_mesh x(*base);
    x.uv[*x.mesh.halfedges_begin()] = Point_2(std::nan(""), 0);
    for(auto h : x.mesh.halfedges())
      if(!x.mesh.is_border(h))
      {
        x.uv[h] = Point_2(0, std::nan(""));
        break;
      }
    assert(check(x, "NaN") == Status::FAILED);
    // Mirrored: every triangle is negative.
    Mapped_mesh y(*base);
    for(auto h : y.mesh.halfedges())
      y.uv[h] = Point_2(-y.uv[h].x(), y.uv[h].y());
    assert(check(y, "mirrored") != Status::VALID);
    // Scaled by a half: singular vertices off the grid.
    Mapped_mesh z(*base);
    for(auto h : z.mesh.halfedges())
      z.uv[h] = Point_2(z.uv[h].x() * 2.5, z.uv[h].y() * 2.5);
    check(z, "scaled by 2.5");
    for(int i = 0; i < 20; ++i)
    {
      Mapped_mesh w(*base);
      for(auto h : w.mesh.halfedges())
        if(rng() % 10 == 0)
          w.uv[h] = Point_2(w.uv[h].x() + int(rng() % 3) - 1, w.uv[h].y() + int(rng() % 65 - 32) / 32.);
      check(w, "a tenth of the corners moved");
    }
  }

  // A singular vertex in the middle of a cell: the map is consistent, but the grid lines around the vertex bound a
  // triangle.
  Options o2;
  o2.k = 2;
  o2.inner_points = 40;
  o2.edge_points = 4;
  o2.denominator = 32;
  o2.random_charts = false;
  Mapped_mesh half = triangulated(coarse_cone(3), o2);
  for(auto h : half.mesh.halfedges())
    half.uv[h] = Point_2(half.uv[h].x() + 0.5, half.uv[h].y() + 0.5);
  Mesh qm;
  const Result r = CGAL::Quad_meshing::extract_quad_mesh(half.mesh, half.uv, qm);
  assert(r.status == Status::REPAIRED && r.singular_vertices_off_grid == 1 && r.other_faces == 1);
  assert(r.quads == 3 * 2 && r.same_topology && !r.is_usable());

  Mapped_mesh empty;
  assert(check(empty, "empty") == Status::FAILED);
}

void test_interface()
{
  Options o;
  o.k = 4;
  const Mapped_mesh m = triangulated(coarse_cube(), o);
  stage_checks::check_stops(
    [&](stage_checks::Counting_visitor& visitor)
    {
      Mesh qm;
      const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm, params::visitor(std::ref(visitor)));
      assert(r.is_valid() || r.status == Status::STOPPED);
      assert(qm.is_empty() == (r.status == Status::STOPPED));
      return r.is_valid();
    });

  // Into a polyhedron, and from one; the second copy is added to the first.
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  Polyhedron p;
  assert(CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, p).status == Status::VALID);
  assert(p.is_valid() && p.is_closed() && p.size_of_facets() == 96 && figures(p).is_valid());
  CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, p);
  assert(p.is_valid() && figures(p).components == 2 && figures(p).is_valid());

  typedef boost::graph_traits<Polyhedron>::halfedge_descriptor Polyhedron_halfedge;
  Polyhedron tp;
  std::vector<std::pair<Mesh::Halfedge_index, Polyhedron_halfedge>> pairs;
  CGAL::copy_face_graph(m.mesh, tp, params::halfedge_to_halfedge_output_iterator(std::back_inserter(pairs)));
  std::map<Polyhedron_halfedge, Point_2> uv;
  for(const auto& h : pairs)
    uv[h.second] = m.uv[h.first];
  Mesh qm;
  assert(CGAL::Quad_meshing::extract_quad_mesh(tp, boost::make_assoc_property_map(uv), qm).status == Status::VALID);
  assert(qm.number_of_faces() == 96 && qm.is_valid());
}

// A mesh in which two border loops touch gives what it gives when the vertex is split before.
void test_pinched_vertices()
{
  Options o;
  o.k = 6;
  o.inner_points = 60;
  o.edge_points = 3;
  const Mapped_mesh whole = triangulated(coarse_cube(), o);
  int pinched = 0, on_grid = 0;
  for(Mesh::Vertex_index v : whole.mesh.vertices())
  {
    Mapped_mesh m = whole;
    m.uv = m.mesh.property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
    const auto around = std::vector<Mesh::Halfedge_index>(m.mesh.halfedges_around_target(m.mesh.halfedge(v)).begin(),
                                                          m.mesh.halfedges_around_target(m.mesh.halfedge(v)).end());
    if(around.size() < 4)
      continue;
    const Point_2 image = m.uv[around[0]];
    CGAL::Euler::remove_face(around[0], m.mesh);
    CGAL::Euler::remove_face(around[2], m.mesh);
    Mesh qm, split_qm;
    const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm);
    CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices(m.mesh);
    const Result split = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, split_qm);
    assert(r.status == split.status && r.quads == split.quads && r.vertices == split.vertices);
    assert(r.same_topology == split.same_topology && r.message == split.message);
    assert(figures(qm).is_valid() && r.quads >= 6 * 36 - 10 && r.quads < 6 * 36);
    ++pinched;
    on_grid += image.x() == std::floor(image.x()) && image.y() == std::floor(image.y());
    if(pinched > 60 && on_grid > 0)
      break;
  }
  assert(pinched > 20 && on_grid > 0);
}

// Feature edges come through from the triangle mesh to the quad mesh: those of a cube are its twelve edges.
void test_feature_edges()
{
  for(int k : { 1, 3, 5 })
  {
    Options o;
    o.k = k;
    o.inner_points = 30;
    o.edge_points = 4;
    Mapped_mesh m = triangulated(coarse_cube(), o);
    auto is_feature = m.mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
    CGAL::Polygon_mesh_processing::detect_sharp_edges(m.mesh, 60, is_feature);
    Mesh qm;
    Location_map location = qm.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
    assert(CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm, params::face_location_map(location)).is_valid());
    auto is_quad_feature = qm.add_property_map<Mesh::Edge_index, bool>("e:feature", true).first;
    assert(CGAL::Quad_meshing::transfer_feature_edges(m.mesh, is_feature, qm, location, is_quad_feature) ==
           std::size_t(12 * k));
    auto is_sharp = qm.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
    CGAL::Polygon_mesh_processing::detect_sharp_edges(qm, 60, is_sharp);
    for(Mesh::Edge_index e : qm.edges())
      assert(is_quad_feature[e] == is_sharp[e]);
    for(Mesh::Edge_index e : m.mesh.edges())
      is_feature[e] = false;
    assert(CGAL::Quad_meshing::transfer_feature_edges(m.mesh, is_feature, qm, location, is_quad_feature) == 0);
    for(Mesh::Edge_index e : qm.edges())
      assert(!is_quad_feature[e]);
  }
}

// Two surfaces are told apart by each of what counts, and by the components that have it.
void test_topology()
{
  using CGAL::Quad_meshing::internal::surface_topology;
  const auto of = [](const test_meshes::Soup& s) { return surface_topology(test_meshes::make_mesh(s)); };
  const auto sphere = of(test_meshes::icosphere(1)), torus = of(test_meshes::torus(8, 6)),
             disk = of(test_meshes::grid(3, 3));
  assert(sphere.size() == 1 && sphere[0].euler_number == 2 && sphere[0].border_loops == 0);
  assert(torus.size() == 1 && torus[0].euler_number == 0 && torus[0].border_loops == 0);
  assert(disk.size() == 1 && disk[0].euler_number == 1 && disk[0].border_loops == 1);
  const auto ring = of(test_meshes::cylinder(8, 3, false));
  assert(ring[0].euler_number == 0 && ring[0].border_loops == 2);
  // The same sums, distributed over the components in another way.
  const auto far_off = [](const test_meshes::Soup& s)
  { return test_meshes::translated(s, test_meshes::Vector_3(9, 0, 0)); };
  const auto a = of(test_meshes::joined(test_meshes::icosphere(1), far_off(test_meshes::double_ring(1))));
  const auto b = of(test_meshes::joined(test_meshes::torus(8, 6), far_off(test_meshes::torus(8, 6))));
  assert(a.size() == 2 && b.size() == 2 &&
         a[0].euler_number + a[1].euler_number == b[0].euler_number + b[1].euler_number && a != b);
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "exact_maps", test_exact_maps },
                     { "small_valences", test_small_valences },
                     { "unaligned_borders", test_unaligned_borders },
                     { "cells_with_holes", test_cells_with_holes },
                     { "perturbation", test_perturbation },
                     { "inexact_maps", test_inexact_maps },
                     { "fold_overs", test_fold_overs },
                     { "fold_overs_at_singular_vertices", test_fold_overs_at_singular_vertices },
                     { "collapsed_arcs", test_collapsed_arcs },
                     { "garbage", test_garbage },
                     { "interface", test_interface },
                     { "pinched_vertices", test_pinched_vertices },
                     { "feature_edges", test_feature_edges },
                     { "topology", test_topology } });
}
