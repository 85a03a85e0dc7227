// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Tests of the room Parameterization: the elimination in integers, the cut graph, the preparation of the mesh,
// integer-grid maps and their exact check.

#undef NDEBUG
#include "stage_checks.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Parameterization/integer_grid_map.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Cut_graph.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Integer_grid_solver.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Integer_relations.h>
#include <CGAL/Quad_meshing/Parameterization/internal/Stiffening.h>
#include <CGAL/Quad_meshing/Parameterization/is_integer_grid_map.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/internal/Regularized_determinant.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace parameters = CGAL::parameters;

typedef test_meshes::Mesh Mesh;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

namespace {

long value_of(const QM::internal::Integer_form& f, const std::vector<long>& x)
{
  long s = f.constant;
  for(const auto& t : f.terms)
    s += t.second * x[t.first];
  return s;
}

// Whatever integers the free variables take, the equations hold. A system made with a solution is not called
// contradictory, and one that is called so has no solution in a small box.
void test_integer_relations()
{
  CGAL::Random random(7);
  const int n = 5;
  int contradictions = 0;
  for(int trial = 0; trial < 2000; ++trial)
  {
    QM::internal::Integer_relations relations(n);
    std::vector<QM::internal::Integer_form> equations;
    std::vector<long> known(n);
    for(long& k : known)
      k = random.get_int(-3, 4);
    const bool solvable = trial % 4 != 0;
    bool contradiction = false;
    for(int e = 0; e < 3; ++e)
    {
      QM::internal::Integer_form f;
      for(int i = 0; i < n; ++i)
        if(random.get_int(0, 2) == 0)
          f.add(QM::internal::Integer_form::variable(i, 1 + random.get_int(0, 6)), random.get_int(0, 2) == 0 ? 1 : -1);
      f.constant = solvable ? static_cast<int>(-value_of(f, known)) : random.get_int(-5, 6);
      equations.push_back(f);
      contradiction = contradiction || relations.add_equation(f, [](int i) { return i % 2; }) ==
                                         QM::internal::Integer_relations::CONTRADICTION;
    }
    if(solvable)
      assert(!contradiction);
    if(contradiction)
    {
      ++contradictions;
      const int box = 4; // no point of a small box may solve what is called contradictory
      std::vector<long> x(n, -box);
      for(int i = 0; i < n;)
      {
        bool solves = true;
        for(const auto& f : equations)
          solves = solves && value_of(f, x) == 0;
        assert(!solves);
        for(i = 0; i < n && ++x[i] > box; ++i)
          x[i] = -box;
      }
      continue;
    }
    std::vector<long> free(relations.number_of_variables());
    for(long& x : free)
      x = random.get_int(-9, 10);
    std::vector<long> x(n);
    for(int i = 0; i < n; ++i)
      x[i] = value_of(relations.resolved(QM::internal::Integer_form::variable(i)), free);
    for(const auto& f : equations)
      assert(value_of(f, x) == 0);
  }
  assert(contradictions > 0);

  // 2x + 4y = 1 has no integer solution, 3x + 5y = 1 has; 2x = 2y leaves one variable
  QM::internal::Integer_relations a(2);
  QM::internal::Integer_form f = QM::internal::Integer_form::variable(0, 2);
  f.add(QM::internal::Integer_form::variable(1, 4));
  f.constant = -1;
  assert(a.add_equation(f, [](int) { return 0; }) == QM::internal::Integer_relations::CONTRADICTION);
  f = QM::internal::Integer_form::variable(0, 3);
  f.add(QM::internal::Integer_form::variable(1, 5));
  f.constant = -1;
  assert(a.add_equation(f, [](int) { return 0; }) == QM::internal::Integer_relations::REMOVED_A_VARIABLE);
  assert(a.add_equation(f, [](int) { return 0; }) == QM::internal::Integer_relations::REDUNDANT);
}

QM::internal::Indexed_triangle_mesh indexed(const Mesh& tm)
{
  return QM::internal::make_indexed_triangle_mesh(tm, tm.points(), get(boost::vertex_index, tm),
                                                  get(boost::face_index, tm));
}

// Opened along the cut, each component is a disk: Euler number 1 and one border loop; singular vertices lie on its
// border.
void test_cut_graph(const Mesh& tm, const std::vector<int>& singular)
{
  const QM::internal::Indexed_triangle_mesh mesh = indexed(tm);
  std::vector<bool> is_singular(mesh.number_of_vertices(), false);
  for(int v : singular)
    is_singular[v] = true;
  const QM::internal::Cut_graph cut(mesh, is_singular);

  std::vector<int> copies(mesh.number_of_vertices(), 0), euler(cut.number_of_components(), 0);
  std::vector<int> component_of_vertex(mesh.number_of_vertices(), -1);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
  {
    ++euler[cut.component_of_face()[f]];
    for(int v : mesh.corners[f])
      component_of_vertex[v] = cut.component_of_face()[f];
  }
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    euler[cut.component_of_face()[mesh.halfedge_of_edge[e] / 3]] -= cut.is_cut()[e] ? 2 : 1;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    if(component_of_vertex[v] == -1)
      continue;
    int cuts = 0;
    bool border = false;
    const int start = mesh.halfedge_of_vertex[v];
    int h = start;
    do
    {
      cuts += cut.is_cut()[mesh.edge_of[h]];
      border = border || mesh.opposite[h] == -1;
      h = mesh.next_around_source(h);
    }
    while(h != -1 && h != start);
    copies[v] = border ? cuts + 1 : (std::max)(cuts, 1);
    euler[component_of_vertex[v]] += copies[v];
    if(is_singular[v])
      assert(cuts > 0 || border);
  }
  for(int e : euler)
    assert(e == 1);
}

void test_preparation()
{
  // A cube with one square per side: every triangle has two or three sharp edges.
  Mesh tm = test_meshes::make_mesh(test_meshes::cube(1));
  auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
  auto origin = tm.add_property_map<Mesh::Face_index, int>("f:o", -1).first;
  std::vector<Kernel::Triangle_3> triangles;
  for(Mesh::Face_index f : tm.faces())
  {
    origin[f] = static_cast<int>(triangles.size());
    const auto h = tm.halfedge(f);
    triangles.emplace_back(tm.point(tm.source(h)), tm.point(tm.target(h)), tm.point(tm.target(tm.next(h))));
  }
  const double area = CGAL::Polygon_mesh_processing::area(tm);
  assert(QM::detect_feature_edges(tm, 40, 0, is_feature).number_of_edges == 12);
  QM::split_for_alignment(tm, tm.points(), is_feature, true, origin, 0.4);

  assert(CGAL::is_triangle_mesh(tm) && CGAL::is_valid_polygon_mesh(tm));
  assert(std::abs(CGAL::Polygon_mesh_processing::area(tm) - area) < 1e-12);
  double feature_length = 0;
  std::vector<bool> on_feature(tm.number_of_vertices(), false);
  for(Mesh::Edge_index e : tm.edges())
  {
    const double l = std::sqrt(CGAL::squared_distance(tm.point(tm.vertex(e, 0)), tm.point(tm.vertex(e, 1))));
    assert(l <= 0.4);
    if(is_feature[e])
    {
      feature_length += l;
      on_feature[tm.vertex(e, 0)] = on_feature[tm.vertex(e, 1)] = true;
    }
  }
  assert(std::abs(feature_length - 12) < 1e-12);
  for(Mesh::Edge_index e : tm.edges())
    assert(is_feature[e] || !(on_feature[tm.vertex(e, 0)] && on_feature[tm.vertex(e, 1)]));
  for(Mesh::Face_index f : tm.faces())
  {
    int features = 0;
    for(auto h : CGAL::halfedges_around_face(tm.halfedge(f), tm))
    {
      features += is_feature[tm.edge(h)];
      assert(CGAL::squared_distance(tm.point(tm.target(h)), triangles[origin[f]]) < 1e-20);
    }
    assert(features <= 1);
  }
}

// Creases that are noise at the scale of the quads are dropped, those of the model stay.
void test_feature_filter()
{
  Mesh tm = test_meshes::make_mesh(test_meshes::cube(10));
  auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
  assert(QM::detect_feature_edges(tm, 40, 0.1, is_feature).number_of_edges == 120);
  assert(QM::detect_feature_edges(tm, 180, 0.1, is_feature).number_of_edges == 0);
  // one vertex pulled out of a side: a spike, whose edges are sharp
  for(Mesh::Vertex_index v : tm.vertices())
    if(CGAL::squared_distance(tm.point(v), Kernel::Point_3(0.5, 0.5, 1)) < 1e-12)
      tm.point(v) = Kernel::Point_3(0.5, 0.5, 1.2);
  const QM::Feature_edges_result r = QM::detect_feature_edges(tm, 40, 0.5, is_feature);
  assert(r.number_of_edges == 120 && r.number_of_dropped_edges > 0 && r.number_of_dropped_pieces > 0);
  assert(std::abs(r.length - 12) < 1e-9);
}

// The edges kept of a mesh made by a generator.
std::size_t kept_edges(const test_meshes::Soup& soup, double length)
{
  Mesh tm = test_meshes::make_mesh(soup);
  auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
  const QM::Feature_edges_result r = QM::detect_feature_edges(tm, 40, length, is_feature);
  std::size_t marked = 0;
  for(Mesh::Edge_index e : tm.edges())
    marked += is_feature[e];
  assert(marked == r.number_of_edges);
  return marked;
}

// Rims of holes and pins are features down to three quads around.
void test_small_rims()
{
  const test_meshes::Soup pin = test_meshes::cylinder(48, 12, true, 0.1, 1); // 0.63 around
  assert(kept_edges(pin, 0.3) == 96);
  assert(kept_edges(pin, 0.5) == 0);
}

// A crease in the middle of a sheet that fades out at both ends, about 2.4 long; its vertices lie alternately beside
// it.
test_meshes::Soup fading_crease(double zigzag)
{
  const test_meshes::Soup sheet = test_meshes::grid(40, 20, 4, 2);
  return test_meshes::mapped(sheet,
                             [zigzag](const Kernel::Point_3& p)
                             {
                               const double side = p.y() - 1, bend = std::sin(CGAL_PI * p.x() / 4);
                               const bool on_crease = std::abs(side) < 0.05;
                               const double off = on_crease ? zigzag * (std::lround(10 * p.x()) % 2 == 0 ? 1 : -1) : 0;
                               return Kernel::Point_3(p.x(), p.y() + off, -std::abs(side) * bend * bend);
                             });
}

// An open crease as straight as a ruler is a feature where it is three quads long; one that runs to and fro is none.
void test_open_creases()
{
  assert(kept_edges(fading_crease(0), 0.5) >= 20);
  assert(kept_edges(fading_crease(0), 1) == 0);
  assert(kept_edges(fading_crease(0.04), 0.5) == 0);
}

// A crease nearly along the x-axis, between a sheet in the plane z = 0 and one in the plane y = 0. The first sheet
// passes by a vertex of the crease at a point that lies beyond it; of the two slivers between, one is folded over, and
// the sharp edges run to and fro.
test_meshes::Soup slivers_on_a_crease()
{
  const std::size_t n = 20, first = 9;
  test_meshes::Soup soup;
  for(std::size_t i = 0; i <= n; ++i)
  {
    const double x = static_cast<double>(i), dent = i == first + 1 ? -0.03 : 0.;
    soup.points.insert(soup.points.end(),
                       { Kernel::Point_3(x, 0, dent), Kernel::Point_3(x, 1, 0), Kernel::Point_3(x, 0, -1) });
  }
  soup.points.emplace_back(first + 1.33, 0.004, -0.03);
  const std::size_t tip = 3 * (n + 1);
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t a = 3 * i, b = 3 * (i + 1);
    soup.add_quad(b, a, a + 2, b + 2);
    if(i != first && i != first + 1)
    {
      soup.add_quad(a, b, b + 1, a + 1);
      continue;
    }
    soup.triangles.push_back({ { a, b, tip } });
    soup.triangles.push_back({ { tip, b + 1, a + 1 } });
    if(i == first)
      soup.triangles.push_back({ { a, tip, a + 1 } });
    else
      soup.triangles.push_back({ { tip, b, b + 1 } });
  }
  return soup;
}

// The crease goes straight on under the slivers.
void test_creases_to_and_fro()
{
  Mesh tm = test_meshes::make_mesh(slivers_on_a_crease());
  auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
  const QM::Feature_edges_result r = QM::detect_feature_edges(tm, 40, 0.5, is_feature);
  assert(r.number_of_edges == 20 && std::abs(r.length - 20) < 0.01);
  for(Mesh::Edge_index e : tm.edges())
  {
    bool on_crease = true;
    for(int i : { 0, 1 })
    {
      const Kernel::Point_3 p = tm.point(tm.vertex(e, i));
      on_crease = on_crease && p.y() == 0 && p.z() > -0.5;
    }
    assert(is_feature[e] == on_crease);
  }
}

// Two creases along a strip that no quad fits into become one; larger ones stay two.
void test_narrow_patches()
{
  const int columns = 21, rows = 40;
  const double chamfer = 0.02;
  const test_meshes::Soup sheet =
    test_meshes::mapped(test_meshes::grid(columns, rows, columns, 4),
                        [&](const Kernel::Point_3& p)
                        {
                          const double i = std::round(p.x());
                          return i <= 10 ? Kernel::Point_3(0.1 * i, p.y(), 0)
                                         : Kernel::Point_3(1 + chamfer, p.y(), chamfer + 0.1 * (i - 11));
                        });
  assert(kept_edges(sheet, 0) == 2 * rows);
  assert(kept_edges(sheet, 0.05) == 2 * rows);
  assert(kept_edges(sheet, 0.3) == rows);
}

// Of the rims of a thin plate both are kept, however close: no chamfer turns by 180 degrees.
void test_thin_plates()
{
  const double thickness = 0.01;
  const test_meshes::Soup plate = test_meshes::mapped(
    test_meshes::cube(8), [&](const Kernel::Point_3& p) { return Kernel::Point_3(p.x(), p.y(), thickness * p.z()); });
  for(double length : { 0.02, 0.1, 0.25 })
    assert(kept_edges(plate, length) == 12 * 8);
}

// The edges kept of a mesh, if they form one chain from one vertex to another; 0 if not.
std::size_t edges_of_chain(const test_meshes::Soup& soup, double length)
{
  Mesh tm = test_meshes::make_mesh(soup);
  auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
  const std::size_t edges = QM::detect_feature_edges(tm, 40, length, is_feature).number_of_edges;
  std::size_t ends = 0, inner = 0;
  for(Mesh::Vertex_index v : tm.vertices())
  {
    int degree = 0;
    for(auto h : CGAL::halfedges_around_target(v, tm))
      degree += is_feature[tm.edge(h)];
    ends += degree == 1;
    inner += degree == 2;
    if(degree > 2)
      return 0;
  }
  return ends == 2 && inner + 1 == edges ? edges : 0;
}

// A chamfer of two strips, whose three edges share its right angle differently from row to row, is one edge for quads
// that are much larger: on one line all along.
void test_sharp_bands()
{
  const int rows = 40;
  const double chamfer = 0.01;
  const test_meshes::Soup sheet = test_meshes::mapped(
    test_meshes::grid(22, rows, 22, 4),
    [&](const Kernel::Point_3& p)
    {
      const int i = static_cast<int>(std::lround(p.x())), j = static_cast<int>(std::lround(10 * p.y()));
      if(i <= 10)
        return Kernel::Point_3(0.1 * i, p.y(), 0);
      if(i >= 12)
        return Kernel::Point_3(1 + chamfer, p.y(), chamfer + 0.1 * (i - 12));
      // pieces of five rows bend by 15, 45 and 30, by 30, 30 and 30, or by 42, 33 and 15 degrees
      const double slopes[3][2] = { { 15, 60 }, { 30, 60 }, { 42, 75 } };
      const double first = slopes[j / 5 % 3][0] * CGAL_PI / 180, second = slopes[j / 5 % 3][1] * CGAL_PI / 180;
      // where the lines from both outer edges at these slopes meet
      const double l = chamfer * (std::sin(second) - std::cos(second)) / std::sin(second - first);
      return Kernel::Point_3(1 + l * std::cos(first), p.y(), l * std::sin(first));
    });
  assert(edges_of_chain(sheet, 0.3) == static_cast<std::size_t>(rows));
}

// A ridge along the x-axis with slopes that may change with x, blunted along one edge by two triangles of one height.
test_meshes::Soup blunted_ridge(std::size_t edges, const std::function<double(double)>& slope)
{
  const std::size_t blunted = edges / 2;
  const double side = 0.01;
  test_meshes::Soup roof;
  for(std::size_t i = 0; i <= edges; ++i)
    for(double y : { -1., 0., 1. })
      roof.points.emplace_back(double(i), y, -slope(double(i)) * std::abs(y));
  const std::size_t added = roof.points.size();
  for(double y : { -side, side })
    roof.points.emplace_back(blunted + 0.5, y, -slope(blunted + 0.5) * side);
  for(std::size_t i = 0; i < edges; ++i)
  {
    const std::size_t a = 3 * i, b = 3 * (i + 1);
    if(i != blunted)
    {
      roof.add_quad(a, b, b + 1, a + 1);
      roof.add_quad(a + 1, b + 1, b + 2, a + 2);
      continue;
    }
    roof.triangles.push_back({ { a, b, added } });
    roof.triangles.push_back({ { b, b + 1, added } });
    roof.triangles.push_back({ { a + 1, a, added } });
    roof.triangles.push_back({ { a + 1, added, added + 1 } });
    roof.triangles.push_back({ { b + 1, added + 1, added } });
    roof.triangles.push_back({ { b + 2, a + 2, added + 1 } });
    roof.triangles.push_back({ { b + 1, b + 2, added + 1 } });
    roof.triangles.push_back({ { a + 2, a + 1, added + 1 } });
  }
  return roof;
}

// A crease that fades out at both ends, so that one and the same patch lies on both sides of its blunt part: one of the
// two lines stays.
void test_blunt_open_creases()
{
  const std::size_t n = 13;
  const auto slope = [n](double x) { return 1.2 * std::min(1., 0.2 * std::min(x, n - x)); };
  assert(edges_of_chain(blunted_ridge(n, slope), 1) >= 10);
}

// A knife edge that is blunted along one edge stays one crease, while the rims of thin plates stay two.
void test_blunted_knives()
{
  const std::size_t n = 12;
  const auto slope = [](double) { return 5.7; }; // 160 degrees between the sides
  assert(edges_of_chain(blunted_ridge(n, slope), 1) == n + 1);
}

// A ridge that is blunt along one short edge: its two parts are one crease unless the gap is longer than half a quad.
void test_gaps_in_creases()
{
  const int n = 12, left = 6;
  const double gap = 0.1, steep = 0.4, blunt = 0.19; // slopes beside the ridge: 44 and 22 degrees between the sides
  test_meshes::Soup roof;
  for(int i = 0; i <= n; ++i)
  {
    const double x = i <= left ? i : i - 1 + gap;
    for(double y : { -1., 0., 1. })
      roof.points.emplace_back(x, y, -steep * std::abs(y));
  }
  // vertices near the short edge, between the left and the right part
  const double side = 0.05, middle = left + gap / 2; // so far away that the blunt part is no narrow band
  for(double y : { -side, side })
    roof.points.emplace_back(middle, y, -blunt * side);
  const std::size_t added = 3 * (n + 1);
  for(int i = 0; i < n; ++i)
    for(int k : { 0, 1 })
    {
      const std::size_t a = 3 * i + k, b = 3 * (i + 1) + k;
      if(i != left)
      {
        roof.add_quad(a, b, b + 1, a + 1);
        continue;
      }
      const std::size_t c = added + k; // the ring around a new vertex
      for(const auto& e :
          { std::make_pair(a, b), std::make_pair(b, b + 1), std::make_pair(b + 1, a + 1), std::make_pair(a + 1, a) })
        roof.triangles.push_back({ { e.first, e.second, c } });
    }
  for(double length : { 0.5, 1.5 })
    assert(kept_edges(roof, length) == static_cast<std::size_t>(n));
  assert(kept_edges(roof, 0.15) == static_cast<std::size_t>(n - 1));
}

// Where sharp edges meet again before a quad is through, they are no lines for quads to follow.
void test_networks_of_short_chains()
{
  const test_meshes::Soup crumpled = test_meshes::perturbed(test_meshes::grid(20, 20, 2, 2), 0.08);
  assert(kept_edges(crumpled, 0.02) > 400);
  assert(kept_edges(crumpled, 0.15) == 0);
}

struct Mapped
{
  Mesh tm;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;
  Mesh::Property_map<Mesh::Face_index, double> angle;
  Mesh::Property_map<Mesh::Edge_index, int> jump;
  Mesh::Property_map<Mesh::Vertex_index, int> index;
  Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv;
  QM::Integer_grid_map_result result;
};

// Field and map of a mesh, prepared; the map must be valid, and the independent check must agree.
Mapped map_of(const test_meshes::Soup& soup, double length, QM::Rounding_method method, const char* what)
{
  Mapped m;
  m.tm = test_meshes::make_mesh(soup);
  m.is_feature = m.tm.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
  m.index = m.tm.add_property_map<Mesh::Vertex_index, int>("v:i", 0).first;
  m.uv = m.tm.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  auto origin = m.tm.add_property_map<Mesh::Face_index, int>("f:o", 0).first;
  m.angle = m.tm.add_property_map<Mesh::Face_index, double>("f:a", 0).first;
  m.jump = m.tm.add_property_map<Mesh::Edge_index, int>("e:p", 0).first;
  QM::detect_feature_edges(m.tm, 40, length, m.is_feature);
  QM::split_for_alignment(m.tm, m.tm.points(), m.is_feature, true, origin, 1.5 * length);
  const QM::Cross_field_result field = QM::smooth_cross_field(
    m.tm, m.angle, m.jump, m.index, parameters::target_edge_length(length).edge_is_constrained_map(m.is_feature));
  assert(field.is_valid());
  m.result = QM::integer_grid_map(
    m.tm, m.angle, m.jump, m.index, m.uv,
    parameters::target_edge_length(length).edge_is_constrained_map(m.is_feature).rounding_method(method));
  std::cout << what << ": " << m.result.message << " " << m.result.integers << " integers, energy "
            << m.result.relaxed_energy << " -> " << m.result.energy << std::endl;
  assert(m.result.is_valid());
  assert(m.result.energy >= m.result.relaxed_energy - 1e-6 * std::abs(m.result.relaxed_energy) - 1e-9);
  const auto report = QM::is_integer_grid_map(m.tm, m.uv, parameters::edge_is_constrained_map(m.is_feature));
  assert(report.is_valid() && report);
  return m;
}

// The number of quads of a map whose border lies on grid lines; the area is an integer up to the rounding of the sum.
double area_of_map(const Mapped& m)
{
  double area = 0;
  for(Mesh::Face_index f : m.tm.faces())
  {
    const auto h = m.tm.halfedge(f);
    area += CGAL::area(m.uv[m.tm.prev(h)], m.uv[h], m.uv[m.tm.next(h)]);
  }
  assert(std::abs(area - std::round(area)) < 1e-6);
  return std::round(area);
}

void test_maps()
{
  // A rectangle of 2 x 1 with quads of length 0.2: the map is the scaling, 50 quads, no distortion at all.
  {
    const Mapped m = map_of(test_meshes::grid(13, 7, 2, 1), 0.2, QM::Rounding_method::GREEDY, "rectangle");
    assert(area_of_map(m) == 50);
    assert(m.result.energy < 1e-12);
    for(Mesh::Vertex_index v : m.tm.vertices())
      if(m.tm.degree(v) == 2)
        assert(m.index[v] == 1); // a corner
  }
  // The unit cube: six squares of 5 x 5.
  assert(area_of_map(map_of(test_meshes::cube(6), 0.2, QM::Rounding_method::GREEDY, "cube")) == 150);
  for(QM::Rounding_method method :
      { QM::Rounding_method::DIRECT, QM::Rounding_method::GREEDY, QM::Rounding_method::LATTICE })
  {
    const double sphere = area_of_map(map_of(test_meshes::icosphere(3), 0.2, method, "sphere"));
    assert(std::abs(sphere / (4 * std::acos(-1.) / 0.04) - 1) < 0.25);
    map_of(test_meshes::torus(40, 20), 0.15, method, "torus");
    map_of(test_meshes::grid_with_hole(12, 12, 4, 8, 4, 8), 0.07, method, "square with a hole");
    map_of(test_meshes::double_ring(3), 0.25, method, "two rings");
  }
  map_of(test_meshes::two_components(5, 3), 0.25, QM::Rounding_method::GREEDY, "two components");
  map_of(test_meshes::l_prism(4), 0.2, QM::Rounding_method::GREEDY, "L");
  map_of(test_meshes::cylinder(24, 8, true), 0.25, QM::Rounding_method::GREEDY, "cylinder with caps");
  map_of(test_meshes::sheared_cube(6), 0.1, QM::Rounding_method::GREEDY, "sheared cube");

  // lattice rounding never ends above greedy rounding
  const test_meshes::Soup ball = test_meshes::perturbed(test_meshes::icosphere(3), 0.05, 3);
  const Mapped greedy = map_of(ball, 0.3, QM::Rounding_method::GREEDY, "rough ball, greedy");
  const Mapped lattice = map_of(ball, 0.3, QM::Rounding_method::LATTICE, "rough ball, lattice");
  if(greedy.result.separations == 0 && lattice.result.separations == 0)
    assert(lattice.result.energy <= greedy.result.energy + 1e-9 * std::abs(greedy.result.energy));
}

// As many threads as wanted: the same map, to the last bit.
void test_threads()
{
  Mapped m = map_of(test_meshes::perturbed(test_meshes::double_ring(4), 0.02, 1), 0.2, QM::Rounding_method::GREEDY,
                    "rough rings");
  auto uv = m.tm.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv_3").first;
  QM::integer_grid_map(m.tm, m.angle, m.jump, m.index, uv,
                       parameters::target_edge_length(0.2).edge_is_constrained_map(m.is_feature).number_of_threads(3u));
  for(Mesh::Halfedge_index h : m.tm.halfedges())
    assert(uv[h] == m.uv[h]);

  std::vector<int> calls(5000, 0);
  for(unsigned int threads : { 0u, 1u, 2u, 7u })
  {
    QM::internal::parallel_for(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    QM::internal::parallel_for(0, threads, [&](std::size_t) { assert(false); });
  }
  assert(calls == std::vector<int>(5000, 4));
}

// Each condition is broken alone, and the check names the simplex.
void test_check()
{
  const Mapped good = map_of(test_meshes::cube(6), 0.2, QM::Rounding_method::GREEDY, "cube");
  const auto check = [&](const Mapped& m)
  { return QM::is_integer_grid_map(m.tm, m.uv, parameters::edge_is_constrained_map(m.is_feature)); };
  const Mesh::Face_index f = *good.tm.faces().begin();

  Mapped m = good; // copies of property maps refer to the original mesh: work on the copy's own
  m.uv = m.tm.property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  m.is_feature = m.tm.property_map<Mesh::Edge_index, bool>("e:f").first;
  assert(check(m));
  const Mesh::Halfedge_index h = m.tm.halfedge(f);
  const Kernel::Point_2 p = m.uv[h];

  m.uv[h] = Kernel::Point_2(p.x() + std::ldexp(1., -30), p.y()); // off its neighbours by a hair
  auto report = check(m);
  assert(!report && !report.edges_without_transition.empty());
  for(Mesh::Edge_index e : report.edges_without_transition)
    assert(m.tm.vertex(e, 0) == m.tm.target(h) || m.tm.vertex(e, 1) == m.tm.target(h));

  m.uv[h] = m.uv[m.tm.next(h)]; // no area
  report = check(m);
  assert(report.folded_faces.size() == 1 && report.folded_faces[0] == f);

  m.uv[h] = Kernel::Point_2(std::nan(""), 0);
  report = check(m);
  assert(report.faces_not_finite.size() == 1 && report.faces_not_finite[0] == f);
  m.uv[h] = p;

  for(Mesh::Halfedge_index g :
      m.tm.halfedges()) // everything moved by a half: singular vertices and features leave the grid
    m.uv[g] = m.uv[g] + Kernel::Vector_2(0.5, 0);
  report = check(m);
  assert(report.folded_faces.empty());
  assert(report.vertices_off_grid.size() == 8 && !report.edges_off_grid.empty());
  std::cout << report.message() << std::endl;
}

// Against brute force: where the separations can hold at all within a small box, the search finds integers for which
// they do, at little more than the least energy.
void test_separated_rounding()
{
  CGAL::Random random(3);
  const int n = 4, box = 3, trials = 200;
  int solvable = 0, optimal = 0;
  std::vector<int> number(n);
  for(int i = 0; i < n; ++i)
    number[i] = i;
  for(int trial = 0; trial < trials; ++trial)
  {
    Eigen::MatrixXd R(n, n);
    Eigen::VectorXd c(n);
    for(int i = 0; i < n; ++i)
    {
      c[i] = random.get_double(-3, 3);
      for(int j = 0; j < n; ++j)
        R(i, j) = random.get_double(-1, 1);
    }
    const Eigen::MatrixXd S = R * R.transpose() + Eigen::MatrixXd::Identity(n, n);
    std::vector<QM::internal::Separations::Separation> separations(5);
    for(auto& s : separations)
      for(int k = 0; k < 2; ++k)
      {
        s.wanted[k] = random.get_double(-1, 1);
        s.offset[k] = QM::internal::Integer_form::variable(random.get_int(0, n), 1);
        s.offset[k].add(QM::internal::Integer_form::variable(random.get_int(0, n), 1), -1);
      }
    const auto energy = [&](const Eigen::VectorXd& z)
    {
      const Eigen::VectorXd gradient = 0.5 * S * z - c;
      return z.dot(gradient);
    };
    const auto all_hold = [&](const Eigen::VectorXd& z)
    {
      for(const auto& s : separations)
        if(!s.holds(z))
          return false;
      return true;
    };
    double least = std::numeric_limits<double>::infinity();
    Eigen::VectorXd z(n);
    for(int code = 0; code < std::pow(2 * box + 1, n); ++code)
    {
      for(int i = 0, rest = code; i < n; ++i, rest /= 2 * box + 1)
        z[i] = rest % (2 * box + 1) - box;
      if(all_hold(z))
        least = (std::min)(least, energy(z));
    }
    stage_checks::Silent_progress silent;
    QM::internal::Separated_rounding rounding(S, c, number);
    rounding.add(separations);
    z.setZero();
    const int broken = rounding.improve(z, silent.progress);
    assert((broken == 0) == all_hold(z));
    for(int i = 0; i < n; ++i)
      assert(z[i] == std::round(z[i]));
    if(least == std::numeric_limits<double>::infinity())
      continue;
    ++solvable;
    assert(broken == 0);
    optimal += energy(z) <= least + 1e-9;
  }
  assert(solvable > trials / 4 && optimal > 0.8 * solvable);
}

std::vector<bool> no_nodes(const QM::internal::Indexed_triangle_mesh& mesh)
{
  return std::vector<bool>(mesh.number_of_vertices(), false);
}

std::vector<double> equal_weights(const QM::internal::Indexed_triangle_mesh& mesh)
{
  return std::vector<double>(mesh.number_of_faces(), 1.);
}

// A displacement that folds triangles when it is simply added is made without folding; an impossible one is not made.
void test_carrying()
{
  Mapped m = map_of(test_meshes::icosphere(4), 0.15, QM::Rounding_method::GREEDY, "carried sphere");
  const QM::internal::Indexed_triangle_mesh mesh = indexed(m.tm);
  std::vector<double> angle;
  std::vector<int> jump, quarters;
  for(Mesh::Face_index f : m.tm.faces())
    angle.push_back(m.angle[f]);
  for(Mesh::Edge_index e : m.tm.edges())
    jump.push_back(m.jump[e]);
  for(Mesh::Vertex_index v : m.tm.vertices())
    quarters.push_back(4 - m.index[v]);
  const std::vector<bool> is_aligned(mesh.number_of_edges(), false);
  stage_checks::Silent_progress silent;
  QM::internal::Integer_grid_solver solver(mesh, angle, jump, quarters, is_aligned,
                                           std::vector<double>(mesh.number_of_faces(), 0.15), no_nodes(mesh), 1,
                                           silent.progress);
  assert(solver.solve_seamless(equal_weights(mesh), 1, 5) && solver.number_of_integers() > 0);
  const QM::internal::Vertex_sectors sectors(solver.coordinates, quarters, is_aligned);
  const QM::internal::Shared_sums sums(solver.coordinates);
  QM::internal::Map_optimization optimization(solver.coordinates, sums, solver.faces, sectors, silent.progress);
  assert(optimization.folded_faces(solver.relaxed).empty());

  int folding = 0;
  for(int i = 0; i < solver.coordinates.number_of_variables(); ++i)
    if(solver.coordinates.is_integer[i])
    {
      Eigen::VectorXd displacement = Eigen::VectorXd::Zero(solver.coordinates.number_of_variables());
      displacement[i] = 1;
      folding += !optimization.folded_faces(solver.relaxed + displacement).empty();
      Eigen::VectorXd x = solver.relaxed;
      assert(optimization.carry(x, displacement, solver.coordinates.is_integer));
      assert(optimization.folded_faces(x).empty() && std::abs(x[i] - solver.relaxed[i] - 1) < 1e-9);
      x = solver.relaxed;
      assert(!optimization.carry(x, 1000 * displacement, solver.coordinates.is_integer));
      assert(optimization.folded_faces(x).empty());
    }
  assert(folding > 0);
}

void test_bad_input()
{
  Mesh tm = test_meshes::make_mesh(test_meshes::cube(2));
  auto angle = tm.add_property_map<Mesh::Face_index, double>("f:a", 0).first;
  auto jump = tm.add_property_map<Mesh::Edge_index, int>("e:p", 0).first;
  auto index = tm.add_property_map<Mesh::Vertex_index, int>("v:i", 0).first;
  auto uv = tm.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  typedef QM::Integer_grid_map_status Status;
  for(double length : { 0., -1., std::nan("") })
    assert(QM::integer_grid_map(tm, angle, jump, index, uv, parameters::target_edge_length(length)).status ==
           Status::INVALID_LENGTH);
  angle[Mesh::Face_index(3)] = std::nan("");
  assert(QM::integer_grid_map(tm, angle, jump, index, uv).status == Status::VALUE_NOT_FINITE);
  angle[Mesh::Face_index(3)] = 0;
  tm.point(Mesh::Vertex_index(2)) = Kernel::Point_3(0, std::nan(""), 0);
  const auto r = QM::integer_grid_map(tm, angle, jump, index, uv);
  assert(r.status == Status::VALUE_NOT_FINITE && r.message.find("ertex 2 ") != std::string::npos);
  for(int s = 0; s <= static_cast<int>(Status::STOPPED); ++s)
    assert(*status_name(static_cast<Status>(s)) != 0);
  Mesh empty;
  auto a = empty.add_property_map<Mesh::Face_index, double>("f:a", 0).first;
  auto j = empty.add_property_map<Mesh::Edge_index, int>("e:p", 0).first;
  auto i = empty.add_property_map<Mesh::Vertex_index, int>("v:i", 0).first;
  auto u = empty.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  assert(QM::integer_grid_map(empty, a, j, i, u).status == Status::EMPTY_MESH);
}

// A vertex with two fans of faces is named, and nothing is written; splitting does right.
void test_pinched_vertices()
{
  typedef QM::Integer_grid_map_status Status;
  Mapped m = map_of(test_meshes::icosphere(3), 0.3, QM::Rounding_method::GREEDY, "sphere");
  const auto v = stage_checks::pinch(m.tm);
  const std::vector<Kernel::Point_2> before(m.uv.begin(), m.uv.end());
  const auto r = QM::integer_grid_map(m.tm, m.angle, m.jump, m.index, m.uv, parameters::target_edge_length(0.3));
  assert(r.status == Status::NON_MANIFOLD_VERTEX &&
         r.message.find("vertex " + std::to_string(v) + " ") != std::string::npos);
  assert(before == std::vector<Kernel::Point_2>(m.uv.begin(), m.uv.end()));
  // The map is still right everywhere else, and the check of it looks at every fan.
  assert(QM::is_integer_grid_map(m.tm, m.uv, parameters::align_boundary(false)));
  auto origin = m.tm.add_property_map<Mesh::Face_index, int>("f:o2", 0).first;
  QM::split_for_alignment(m.tm, m.tm.points(), m.is_feature, true, origin, 0.1);
  assert(m.tm.is_valid() && CGAL::is_triangle_mesh(m.tm));
  for(Mesh::Edge_index e : m.tm.edges())
    assert(CGAL::squared_distance(m.tm.point(m.tm.vertex(e, 0)), m.tm.point(m.tm.vertex(e, 1))) < 0.01 + 1e-9);

  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  Polyhedron p = test_meshes::make_mesh<Polyhedron>(test_meshes::icosphere(2));
  stage_checks::pinch(p);
  auto angle = get(CGAL::dynamic_face_property_t<double>(), p);
  auto jump = get(CGAL::dynamic_edge_property_t<int>(), p);
  auto index = get(CGAL::dynamic_vertex_property_t<int>(), p);
  auto uv = get(CGAL::dynamic_halfedge_property_t<Kernel::Point_2>(), p);
  assert(QM::integer_grid_map(p, angle, jump, index, uv).status == Status::NON_MANIFOLD_VERTEX);
}

// The energy of a function of two by two Jacobians, its gradient and its Hessian against central differences.
void test_distortion()
{
  typedef QM::internal::Regularized_distortion Distortion;
  CGAL::Random random(3);
  const double h = 1e-5;
  auto jacobian = [](const Distortion::Vector_4& a)
  {
    Eigen::Matrix2d J;
    J << a[0], a[1], a[2], a[3];
    return J;
  };
  int folded = 0;
  for(int trial = 0; trial < 300; ++trial)
  {
    Distortion d;
    d.epsilon = trial % 3 == 0 ? 0 : random.get_double(0.1, 1);
    d.area_weight = random.get_double(0, 1);
    d.alignment_weight = random.get_double(0, 1);
    Distortion::Vector_4 a;
    for(int i = 0; i < 4; ++i)
      a[i] = (i % 3 == 0) + random.get_double(-1.5, 1.5);
    const double D = jacobian(a).determinant();
    if(d.epsilon == 0 && D < 0.3)
    {
      assert(D > 0 || std::isinf(d.value(jacobian(a))));
      continue;
    }
    folded += D < 0;
    Distortion::Vector_4 g, unused_g;
    Distortion::Matrix_4 H, unused_H, differences;
    d.derivatives(jacobian(a), g, H);
    for(int i = 0; i < 4; ++i)
    {
      Distortion::Vector_4 forth = a, back = a, g_forth, g_back;
      forth[i] += h;
      back[i] -= h;
      const double slope = (d.value(jacobian(forth)) - d.value(jacobian(back))) / (2 * h);
      assert(std::abs(slope - g[i]) < 1e-6 * (1 + g.norm()));
      d.derivatives(jacobian(forth), g_forth, unused_H);
      d.derivatives(jacobian(back), g_back, unused_H);
      differences.col(i) = (g_forth - g_back) / (2 * h);
    }
    // Without the alignment, the Hessian is the true one with its negative eigenvalues set to zero.
    const Distortion::Matrix_4 true_H = differences - d.alignment_weight * Distortion::Matrix_4::Identity();
    const Eigen::SelfAdjointEigenSolver<Distortion::Matrix_4> eigen(0.5 * (true_H + true_H.transpose()));
    const Distortion::Matrix_4 expected =
      eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.).asDiagonal() * eigen.eigenvectors().transpose();
    assert((H - d.alignment_weight * Distortion::Matrix_4::Identity() - expected).norm() < 1e-4 * (1 + true_H.norm()));
  }
  assert(folded > 30);
  // The identity has the least distortion, two: one for the angles and one for the area.
  Distortion d;
  Distortion::Vector_4 g;
  Distortion::Matrix_4 H;
  d.derivatives(Eigen::Matrix2d::Identity(), g, H);
  assert(g.norm() < 1e-12 && std::abs(d.value(Eigen::Matrix2d::Identity()) - 1 - d.area_weight) < 1e-12);

  for(double epsilon : { 0., 0.01, 1. })
  {
    const QM::internal::Regularized_determinant chi{ epsilon };
    for(double D : { -3., -0.2, 0.2, 3. })
    {
      if(epsilon == 0 && D < 0)
        continue;
      assert(chi.value(D) > 0 && std::abs(chi.value(D) - (D + std::sqrt(D * D + epsilon * epsilon)) / 2) < 1e-9);
      const double s = 1e-5 * std::abs(D);
      assert(std::abs((chi.value(D + s) - chi.value(D - s)) / (2 * s) - chi.derivative(D)) < 1e-6);
      assert(std::abs((chi.derivative(D + s) - chi.derivative(D - s)) / (2 * s) - chi.second_derivative(D)) < 1e-4);
    }
    assert(QM::internal::Regularized_determinant::epsilon_for(epsilon) == (epsilon > 0 ? 0 : 1e-6));
    assert(std::abs(QM::internal::Regularized_determinant::epsilon_for(-1 - epsilon) - 0.2 * (1 + epsilon)) < 1e-9);
  }
}

// The flat arrays of a mapped mesh for the inner classes.
struct Solver_of
{
  QM::internal::Indexed_triangle_mesh mesh;
  std::vector<double> angle;
  std::vector<int> jump, quarters;
  std::vector<bool> is_aligned;
  stage_checks::Silent_progress silent;
  std::unique_ptr<QM::internal::Integer_grid_solver> solver;

  Solver_of(const Mapped& m, double length) : mesh(indexed(m.tm))
  {
    for(Mesh::Face_index f : m.tm.faces())
      angle.push_back(m.angle[f]);
    for(Mesh::Edge_index e : m.tm.edges())
    {
      jump.push_back(m.jump[e]);
      is_aligned.push_back(m.is_feature[e] || m.tm.is_border(e));
    }
    for(Mesh::Vertex_index v : m.tm.vertices())
      quarters.push_back((m.tm.is_border(v) ? 2 : 4) - m.index[v]);
    solver.reset(new QM::internal::Integer_grid_solver(mesh, angle, jump, quarters, is_aligned,
                                                       std::vector<double>(mesh.number_of_faces(), length),
                                                       no_nodes(mesh), 1, silent.progress));
  }
};

// The orientation energy as [Bom12, 8.4] defines it, over the faces, against the quadratic form.
void test_orientation_energy()
{
  CGAL::Random random(11);
  for(const test_meshes::Soup& soup : { test_meshes::icosphere(2), test_meshes::cube(3) })
  {
    const double length = 0.4;
    const Mapped m = map_of(soup, length, QM::Rounding_method::GREEDY, "energy");
    const Solver_of s(m, length);
    const auto& coordinates = s.solver->coordinates;
    const QM::internal::Shared_sums sums(coordinates);
    std::cout << sums.sums().size() << " shared sums" << std::endl;
    std::vector<double> weight(s.mesh.number_of_faces());
    for(double& w : weight)
      w = random.get_double(0.5, 3);
    for(double g : { 1., 0.3 })
    {
      const QM::internal::Orientation_energy energy(coordinates.charts, sums, s.solver->faces, weight, g);
      const auto by_definition = [&](const Eigen::VectorXd& x)
      {
        double sum = 0;
        for(int f = 0; f < s.mesh.number_of_faces(); ++f)
        {
          // The gradients of u and v in the plane of the triangle, and the directions of the combed field there.
          const auto a = s.mesh.vector(3 * f), b = -s.mesh.vector(3 * f + 2);
          const double l = std::sqrt(a * a), bx = a * b / l, by = std::sqrt(b * b - bx * bx), area = l * by / 2;
          const auto corner = [&](int k, int c)
          { return coordinates.value(coordinates.charts.wedge_of_corner[3 * f + k], c, x); };
          const auto& u = coordinates.charts.u_direction[f];
          for(int c = 0; c < 2; ++c)
          {
            const double gx = (corner(1, c) - corner(0, c)) / l, gy = (corner(2, c) - corner(0, c) - gx * bx) / by;
            const double along_u = length * (gx * u[0] + gy * u[1]), along_v = length * (-gx * u[1] + gy * u[0]);
            const double off_u = along_u - (c == 0), off_v = along_v - (c == 1);
            sum += weight[f] * area / (length * length) *
                   ((c == 0 ? g : 1) * off_u * off_u + (c == 1 ? g : 1) * off_v * off_v);
          }
        }
        return sum;
      };
      Eigen::VectorXd x(coordinates.number_of_variables());
      for(int i = 0; i < x.size(); ++i)
        x[i] = random.get_double(-3, 3);
      const double value = by_definition(x);
      assert(std::abs(energy.value(x) - value) < 1e-9 * value);
      const Eigen::VectorXd gradient = energy.A * x - energy.b;
      for(int k = 0; k < 20; ++k)
      {
        const int i = random.get_int(0, static_cast<int>(x.size()));
        Eigen::VectorXd forth = x, back = x;
        forth[i] += 0.5;
        back[i] -= 0.5; // central differences of a quadratic function are exact
        assert(std::abs(by_definition(forth) - by_definition(back) - gradient[i]) < 1e-7 * (1 + gradient.norm()));
        assert(std::abs(by_definition(forth) + by_definition(back) - 2 * value - energy.A.coeff(i, i) / 4) <
               1e-7 * value);
      }
      // Some variables kept: the rest of the same function.
      std::vector<int> number(x.size(), -1), free;
      for(int i = 0; i < x.size(); i += 3)
      {
        number[i] = static_cast<int>(free.size());
        free.push_back(i);
      }
      const QM::internal::Orientation_energy part(coordinates.charts, sums, s.solver->faces, weight, g, number,
                                                  static_cast<int>(free.size()), x);
      Eigen::VectorXd y(free.size());
      for(int k = 0; k < y.size(); ++k)
        y[k] = x[free[k]] = random.get_double(-3, 3);
      assert(std::abs(part.value(y) - by_definition(x)) < 1e-9 * (1 + part.value(y)));
    }
  }
}

// The named parameters that shape the energy, where the answer is known.
void test_parameters()
{
  // Five and a half quads do not fit: five or six rows, an error of a eleventh of their height, in length only.
  Mapped m = map_of(test_meshes::grid(20, 11, 2, 1.1), 0.2, QM::Rounding_method::GREEDY, "rectangle that does not fit");
  const auto solve = [&](const auto& np) { return QM::integer_grid_map(m.tm, m.angle, m.jump, m.index, m.uv, np); };
  for(double g : { 1., 0.5, 0.01 })
  {
    const auto r = solve(parameters::target_edge_length(0.2).anisotropy_weight(g));
    assert(r.is_valid() && std::abs(r.energy - g * 55. / 121) < 1e-9 && std::abs(r.relaxed_energy) < 1e-9);
  }
  // The map of lengths counts, and not the length.
  auto sizing = m.tm.add_property_map<Mesh::Face_index, double>("f:s", 0.1).first;
  assert(solve(parameters::target_edge_length(0.2).face_sizing_map(sizing)).is_valid() && area_of_map(m) == 220);
  assert(solve(parameters::target_edge_length(0.1)).is_valid() && area_of_map(m) == 220);
  for(Mesh::Face_index f : m.tm.faces()) // one half of the rectangle with quads of half the width
    if(CGAL::centroid(m.tm.point(m.tm.source(m.tm.halfedge(f))), m.tm.point(m.tm.target(m.tm.halfedge(f))),
                      m.tm.point(m.tm.target(m.tm.next(m.tm.halfedge(f)))))
         .x() < 1)
      sizing[f] = 0.2;
  assert(solve(parameters::face_sizing_map(sizing)).is_valid() && area_of_map(m) > 80 && area_of_map(m) < 200);
  double left = 0, right = 0;
  for(Mesh::Face_index f : m.tm.faces())
  {
    const auto h = m.tm.halfedge(f);
    (sizing[f] == 0.2 ? left : right) += CGAL::area(m.uv[m.tm.prev(h)], m.uv[h], m.uv[m.tm.next(h)]);
  }
  assert(right > 1.3 * left);
  sizing[Mesh::Face_index(5)] = 0;
  assert(solve(parameters::face_sizing_map(sizing)).status == QM::Integer_grid_map_status::INVALID_LENGTH);
}

// Weights of local stiffening stay what they are where nothing is distorted, grow around what is, and make it better.
void test_stiffening()
{
  const double length = 0.25;
  const Mapped m = map_of(test_meshes::grid(12, 12), length, QM::Rounding_method::GREEDY, "square");
  Solver_of s(m, length);
  assert(s.solver->solve_seamless(equal_weights(s.solver->mesh), 1, 0));
  const auto& coordinates = s.solver->coordinates;
  QM::internal::Stiffening flat(coordinates, s.solver->faces);
  flat.update_weights(s.solver->relaxed);
  for(double w : flat.weight)
    assert(std::abs(w - 1) < 1e-6);
  // One inner vertex moved, a little and so far that triangles fold over: the formula of [Bom12, 8.4], with two steps
  // of smoothing, by singular values.
  int moved = -1;
  for(int i = 0; i < coordinates.number_of_variables() && moved == -1; ++i)
    if(!coordinates.is_integer[i])
      moved = i;
  for(double step : { 0.2, 2. })
  {
    Eigen::VectorXd x = s.solver->relaxed;
    x[moved] += step;
    QM::internal::Stiffening stiffening(coordinates, s.solver->faces);
    stiffening.update_weights(x);
    const int n = s.mesh.number_of_faces();
    const auto mean_of_neighbors = [&](const std::vector<double>& values, int f)
    {
      double sum = 0;
      int neighbors = 0;
      for(int h = 3 * f; h < 3 * f + 3; ++h)
        if(s.mesh.opposite[h] != -1)
        {
          sum += values[s.mesh.opposite[h] / 3];
          ++neighbors;
        }
      return sum / neighbors;
    };
    std::vector<double> distortion(n), weight(n, 1);
    int folded = 0;
    for(int f = 0; f < n; ++f)
    {
      const Eigen::Matrix2d J = s.solver->faces.jacobian(f, QM::internal::corner_coordinates(coordinates, f, x));
      const Eigen::Vector2d singular = Eigen::JacobiSVD<Eigen::Matrix2d>(J).singularValues();
      const double orientation = J.determinant() >= 0 ? 1 : -1;
      folded += orientation < 0;
      distortion[f] = std::abs(orientation * singular[0] - 1) + std::abs(orientation * singular[1] - 1);
    }
    assert((folded > 0) == (step > 1));
    for(int f = 0; f < n; ++f)
      weight[f] += (std::min)(std::abs(mean_of_neighbors(distortion, f) - distortion[f]), 5.);
    for(int k = 0; k < 2; ++k)
    {
      std::vector<double> smooth(n);
      for(int f = 0; f < n; ++f)
        smooth[f] = (weight[f] + mean_of_neighbors(weight, f)) / 2;
      weight.swap(smooth);
    }
    for(int f = 0; f < n; ++f)
      assert(std::abs(stiffening.weight[f] - weight[f]) < 1e-5 * weight[f]);
    assert(*std::max_element(weight.begin(), weight.end()) > 1.05);
  }
}

// Without a length, the feature edges are the sharp edges that CGAL finds, the border apart.
void test_sharp_edges()
{
  for(const test_meshes::Soup& soup : { test_meshes::perturbed(test_meshes::icosphere(2), 0.15, 4),
                                        test_meshes::perturbed(test_meshes::cylinder(12, 6, false), 0.3, 5) })
    for(double degrees : { 5., 20., 45., 60., 89., 91., 120., 150., 180. })
    {
      Mesh tm = test_meshes::make_mesh(soup);
      auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:f", true).first;
      auto is_sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:s", false).first;
      const auto r = QM::detect_feature_edges(tm, degrees, 0, is_feature);
      CGAL::Polygon_mesh_processing::detect_sharp_edges(tm, degrees, is_sharp);
      std::size_t n = 0;
      for(Mesh::Edge_index e : tm.edges())
      {
        assert(is_feature[e] == (is_sharp[e] && !tm.is_border(e)));
        n += is_feature[e];
      }
      assert(n == r.number_of_edges && r.number_of_dropped_edges == 0);
      assert(n > 0 || degrees > 90);
    }
}

// What lies within one and a half units of something else is watched, and nothing further away: the long sides of a
// strip of 1.2 quads, but not of 1.8.
void test_separations()
{
  const double length = 0.2;
  for(double height : { 0.24, 0.36 })
  {
    const Mapped m = map_of(test_meshes::grid(20, 3, 2, height), length, QM::Rounding_method::GREEDY, "strip");
    Solver_of s(m, length);
    assert(s.solver->solve_seamless(equal_weights(s.solver->mesh), 1, 0));
    const QM::internal::Separations separations(s.solver->coordinates, s.solver->grid_points(), s.is_aligned,
                                                s.solver->relaxed, s.silent.progress);
    assert(separations.list.empty() == (height > 1.5 * length));
    for(const auto& separation : separations.list)
    {
      assert(separation.holds(s.solver->relaxed) && !separation.holds(-s.solver->relaxed));
      assert(std::abs(std::abs(separation.wanted[separation.dominant()]) - height / length) < 1e-6);
    }
  }
}

// Wherever the visitor says stop, the call ends and the map is not written.
void test_stops()
{
  // A surface on which fold-overs have to be removed, so that all parts of the work take steps.
  Mapped m =
    map_of(test_meshes::perturbed(test_meshes::double_ring(4), 0.03, 5), 0.3, QM::Rounding_method::GREEDY, "rings");
  stage_checks::check_stops(
    [&](stage_checks::Counting_visitor& visitor)
    {
      for(Mesh::Halfedge_index h : m.tm.halfedges())
        m.uv[h] = Kernel::Point_2(17, 17);
      const auto r = QM::integer_grid_map(
        m.tm, m.angle, m.jump, m.index, m.uv,
        parameters::target_edge_length(0.3).edge_is_constrained_map(m.is_feature).visitor(std::ref(visitor)));
      assert(r.is_valid() || r.status == QM::Integer_grid_map_status::STOPPED);
      for(Mesh::Halfedge_index h : m.tm.halfedges())
        assert(r.is_valid() || m.uv[h] == Kernel::Point_2(17, 17));
      return r.is_valid();
    });
}

void test_cut_graphs()
{
  test_cut_graph(test_meshes::make_mesh(test_meshes::icosphere(2)), { 0, 5, 7, 100 });
  test_cut_graph(test_meshes::make_mesh(test_meshes::torus(20, 10)), {});
  test_cut_graph(test_meshes::make_mesh(test_meshes::torus(20, 10)), { 3, 77 });
  test_cut_graph(test_meshes::make_mesh(test_meshes::double_ring(2)), { 1, 2, 3 });
  test_cut_graph(test_meshes::make_mesh(test_meshes::grid_with_hole(8, 8, 3, 5, 3, 5)), { 11 });
  test_cut_graph(test_meshes::make_mesh(test_meshes::cylinder(12, 5, false)), { 30 });
  test_cut_graph(test_meshes::make_mesh(test_meshes::two_components(3, 2)), { 0, 20, 60, 150 });
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "integer_relations", test_integer_relations },
                     { "cut_graphs", test_cut_graphs },
                     { "preparation", test_preparation },
                     { "feature_filter", test_feature_filter },
                     { "creases_to_and_fro", test_creases_to_and_fro },
                     { "small_rims", test_small_rims },
                     { "open_creases", test_open_creases },
                     { "thin_plates", test_thin_plates },
                     { "sharp_bands", test_sharp_bands },
                     { "blunt_open_creases", test_blunt_open_creases },
                     { "blunted_knives", test_blunted_knives },
                     { "gaps_in_creases", test_gaps_in_creases },
                     { "narrow_patches", test_narrow_patches },
                     { "networks_of_short_chains", test_networks_of_short_chains },
                     { "maps", test_maps },
                     { "check", test_check },
                     { "separated_rounding", test_separated_rounding },
                     { "carrying", test_carrying },
                     { "threads", test_threads },
                     { "bad_input", test_bad_input },
                     { "pinched_vertices", test_pinched_vertices },
                     { "distortion", test_distortion },
                     { "orientation_energy", test_orientation_energy },
                     { "parameters", test_parameters },
                     { "stiffening", test_stiffening },
                     { "sharp_edges", test_sharp_edges },
                     { "separations", test_separations },
                     { "stops", test_stops } });
}
