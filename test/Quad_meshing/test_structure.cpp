// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Analysis and smoothing of quad meshes: shape measures with known values, structure against slow and
// direct constructions, smoothing with its guarantees.

#include "structure_meshes.h"
#include "test_cases.h"

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_deviation.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Helix_detection.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace SM = structure_meshes;
typedef SM::Mesh Mesh;
typedef SM::Point_3 Point_3;
typedef QM::internal::Indexed_quad_mesh Flat_mesh;

namespace {

bool is_close(double a, double b, double tolerance = 1e-9) { return std::abs(a - b) <= tolerance; }

Mesh one_quad(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
{
  return SM::make_mesh(SM::Quad_soup{ { a, b, c, d }, { { { 0, 1, 2, 3 } } } });
}

void test_quality()
{
  std::cout << "quality" << std::endl;
  const QM::Quad_mesh_quality square = QM::quad_mesh_quality(SM::make_mesh(SM::grid(3, 2)));
  assert(is_close(square.mean_angle_deviation, 0) && is_close(square.minimal_scaled_jacobian, 1));
  assert(is_close(square.mean_edge_length, 1) && is_close(square.edge_length_variation, 0) && is_close(square.area, 6));

  const double s = 60 * SM::pi / 180;
  const QM::Quad_mesh_quality rhombus =
    QM::quad_mesh_quality(one_quad(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1 + std::cos(s), std::sin(s), 0),
                                   Point_3(std::cos(s), std::sin(s), 0)));
  assert(is_close(rhombus.mean_angle_deviation, 30) && is_close(rhombus.minimal_scaled_jacobian, std::sin(s)));

  const QM::Quad_mesh_quality arrow =
    QM::quad_mesh_quality(one_quad(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.2, 0.2, 0), Point_3(0, 1, 0)));
  assert(arrow.maximal_angle > 180 && arrow.minimal_scaled_jacobian < 0 && arrow.number_of_inverted_quads == 1);

  const double h = 0.4;
  const QM::Quad_mesh_quality bent =
    QM::quad_mesh_quality(one_quad(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, h), Point_3(0, 1, 0)));
  const double side = (2 + 2 * std::sqrt(1 + h * h)) / 4;
  assert(is_close(bent.maximal_planarity, h / std::sqrt(2 * h * h + 4) / side));
  assert(is_close(bent.maximal_aspect_ratio, std::sqrt(1 + h * h)));

  // rigid motion and scale
  SM::Quad_soup soup = SM::sphere(6);
  const QM::Quad_mesh_quality a = QM::quad_mesh_quality(SM::make_mesh(soup));
  for(Point_3& p : soup.points)
    p = Point_3(-3 * p.y() + 5, 3 * p.x() - 1, 3 * p.z());
  const Mesh moved = SM::make_mesh(soup);
  const QM::Quad_mesh_quality b = QM::quad_mesh_quality(moved);
  assert(is_close(a.mean_angle_deviation, b.mean_angle_deviation) &&
         is_close(a.minimal_scaled_jacobian, b.minimal_scaled_jacobian));
  assert(is_close(3 * a.mean_edge_length, b.mean_edge_length) && is_close(9 * a.area, b.area));
  const auto worst = QM::worst_quads(moved, 5);
  assert(worst.size() == 5 && is_close(worst[0].second, b.minimal_scaled_jacobian));
}

void test_defects()
{
  std::cout << "defects" << std::endl;
  const SM::Quad_soup cube = SM::cube(3);
  std::vector<std::vector<std::size_t>> faces;
  for(const auto& q : cube.quads)
    faces.emplace_back(q.begin(), q.end());
  assert(QM::find_quad_mesh_defects(cube.points, faces).is_pure_quad_mesh());
  auto with = [&](std::vector<std::size_t> first)
  {
    auto changed = faces;
    changed[0] = std::move(first);
    return QM::find_quad_mesh_defects(cube.points, changed);
  };
  const std::vector<std::size_t> f = faces[0];
  assert(with({ f[0], f[1], f[2] }).faces_not_quads == 1);
  assert(with({ f[3], f[2], f[1], f[0] }).inconsistent_edges == 4);
  assert(with({ f[0], f[1], f[2], f[0] }).faces_repeating_vertices == 1);
  assert(with({ f[0], f[1], f[2], 1000 }).invalid_indices == 1);
  auto twice = faces;
  twice.push_back({ f[1], f[2], f[3], f[0] });
  assert(QM::find_quad_mesh_defects(cube.points, twice).non_manifold_edges == 4);
  std::vector<Point_3> points = cube.points;
  points.push_back(Point_3(0, 0, 0));
  assert(QM::find_quad_mesh_defects(points, faces).isolated_vertices == 1);
  points.back() = Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  assert(QM::find_quad_mesh_defects(points, faces).invalid_coordinates == 1);
  // two squares that touch in a vertex
  const std::vector<std::vector<std::size_t>> pinched = { { 0, 1, 2, 3 }, { 0, 4, 5, 6 } };
  assert(QM::find_quad_mesh_defects(cube.points, pinched).non_manifold_vertices == 1);
  assert(!QM::find_quad_mesh_defects(points, std::vector<std::vector<std::size_t>>()).is_pure_quad_mesh());
}

// The patches by removing regular lines one edge at a time: an edge stays as long as a neighbour on its
// straight line stays, starting from the edges at irregular vertices.
int slow_number_of_patches(const Flat_mesh& m)
{
  const int nh = m.number_of_halfedges();
  auto regular_inside = [&](int v) { return !m.is_border_vertex(v) && m.valence(v) == 4; };
  std::vector<char> marked(nh, 0);
  for(bool changed = true; changed;)
  {
    changed = false;
    for(int h = 0; h < nh; ++h)
    {
      bool mark = m.is_border(h);
      for(int v : { m.source(h), m.target(h) })
        mark = mark || (!regular_inside(v) && !(m.is_border_vertex(v) && m.valence(v) == 3));
      if(!m.is_border(h))
      {
        mark = mark || marked[m.opposite[h]];
        if(regular_inside(m.target(h)))
          mark = mark || marked[m.next(m.opposite[m.next(h)])];
      }
      if(mark && !marked[h])
      {
        marked[h] = 1;
        changed = true;
      }
    }
  }
  std::vector<int> patch(m.number_of_faces(), -1);
  int patches = 0;
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    if(patch[f] != -1)
      continue;
    std::vector<int> todo(1, f);
    patch[f] = patches;
    while(!todo.empty())
    {
      const int g = todo.back();
      todo.pop_back();
      for(int h = 4 * g; h < 4 * g + 4; ++h)
        if(!marked[h] && patch[m.opposite[h] / 4] == -1)
        {
          patch[m.opposite[h] / 4] = patches;
          todo.push_back(m.opposite[h] / 4);
        }
    }
    ++patches;
  }
  return patches;
}

// All first returns of a dual edge beside itself, step by step: (sidesteps, shorter offset).
std::multiset<std::pair<int, int>> slow_relations(const Flat_mesh& m)
{
  std::multiset<std::pair<int, int>> all;
  const QM::internal::Dual_lines lines(m);
  for(int s = 0; s < m.number_of_halfedges(); ++s)
  {
    if(!lines.is_representative(lines.line[s]))
      continue;
    int t = s, steps = 0;
    do
    {
      const int o = m.opposite[m.next(t)];
      t = o == -1 ? -1 : m.next(o);
      ++steps;
    }
    while(t != -1 && t != s && lines.line[t] != lines.line[s]);
    if(t == -1 || t == s)
      continue;
    int ahead = 0, behind = 0;
    for(int x = s; x != t && x != -1 && ahead <= m.number_of_halfedges(); x = m.forward(x))
      ++ahead;
    for(int x = t; x != s && x != -1 && behind <= m.number_of_halfedges(); x = m.forward(x))
      ++behind;
    const bool closed = lines.is_closed[lines.line[s]];
    const bool comes_later = lines.position[t] > lines.position[s];
    all.emplace(steps, closed ? (ahead <= behind ? ahead : -behind) : comes_later ? ahead : -behind);
  }
  return all;
}

// Triangles after flips of random edges, none of which makes an edge twice: a surface of the same topology.
std::vector<std::array<std::size_t, 3>> with_random_flips(std::vector<std::array<std::size_t, 3>> triangles, int flips,
                                                          unsigned int seed)
{
  CGAL::Random random(seed);
  auto has_edge = [&](std::size_t a, std::size_t b)
  {
    for(const auto& t : triangles)
      if(std::find(t.begin(), t.end(), a) != t.end() && std::find(t.begin(), t.end(), b) != t.end())
        return true;
    return false;
  };
  while(flips > 0)
  {
    auto& t = triangles[random.get_int(0, int(triangles.size()))];
    std::rotate(t.begin(), t.begin() + random.get_int(0, 3), t.end());
    for(auto& other : triangles)
      for(int k = 0; k < 3; ++k)
        if(other[k] == t[1] && other[(k + 1) % 3] == t[0] && !has_edge(t[2], other[(k + 2) % 3]))
        {
          const std::size_t a = t[0], b = t[1], c = t[2], d = other[(k + 2) % 3];
          t = { { c, a, d } };
          other = { { c, d, b } };
          --flips;
          k = 3;
        }
  }
  return triangles;
}

void test_structure()
{
  std::cout << "structure" << std::endl;
  auto structure = [](const SM::Quad_soup& s) { return QM::quad_mesh_structure(SM::make_mesh(s)); };
  const QM::Quad_mesh_structure cube = structure(SM::cube(4));
  assert(cube.number_of_patches == 6 && cube.number_of_nodes == 8 && cube.number_of_arcs == 12);
  assert(cube.number_of_dual_curves == 12 && cube.number_of_closed_dual_curves == 12 &&
         cube.number_of_parallel_classes == 3);
  assert(cube.number_of_irregular_vertices == 8 && cube.inner_valences.at(3) == 8 && cube.sum_of_indices == 8);
  assert(cube.number_of_helices == 0 && cube.classification() == QM::Quad_mesh_class::SEMI_REGULAR);
  assert(structure(SM::cube(1)).classification() == QM::Quad_mesh_class::UNSTRUCTURED);

  const QM::Quad_mesh_structure grid = structure(SM::grid(5, 3));
  assert(grid.number_of_patches == 1 && grid.number_of_nodes == 4 && grid.number_of_boundary_loops == 1);
  assert(grid.number_of_dual_curves == 8 && grid.number_of_closed_dual_curves == 0);
  assert(grid.classification() == QM::Quad_mesh_class::REGULAR && grid.sum_of_indices == 4);

  // helices of pitch h, right- and left-handed
  for(int shift : { 1, -1, 2, 3 })
  {
    const Mesh helix = SM::make_mesh(SM::rolled(10, 7, shift, false));
    const auto helices = QM::minimal_q_helices(helix);
    assert(helices.size() == std::size_t(std::abs(shift)));
    int length = 0;
    for(const auto& h : helices)
    {
      assert(h.pitch == shift && h.turn_length == 10);
      assert(is_close(h.winding_number(), h.length / 10.));
      length += h.length;
    }
    assert(length == 70);
  }
  assert(structure(SM::rolled(10, 7, 0, false)).number_of_helices == 0);
  const auto torus = structure(SM::rolled(8, 5, 1, true));
  assert(torus.number_of_helices == 1 && torus.number_of_irregular_vertices == 0 && torus.euler_characteristic == 0);
  assert(torus.number_of_dual_curves == 9 && torus.number_of_patches == 1);

  // fast and slow, primal and dual
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  const SM::Quad_soup base = SM::cube(2);
  points = base.points;
  for(const auto& q : base.quads)
  {
    triangles.push_back({ { q[0], q[1], q[2] } });
    triangles.push_back({ { q[0], q[2], q[3] } });
  }
  const SM::Quad_soup irregular = SM::split_triangles(points, triangles);
  const SM::Quad_soup random_base = SM::split_triangles(points, with_random_flips(triangles, 60, 4));
  SM::Quad_soup open = SM::refined(irregular, 3);
  open.quads.resize(open.quads.size() * 2 / 3);
  std::vector<std::size_t> number(open.points.size(), std::size_t(-1));
  SM::Quad_soup used;
  for(auto& q : open.quads)
  {
    for(std::size_t& v : q)
    {
      if(number[v] == std::size_t(-1))
      {
        number[v] = used.points.size();
        used.points.push_back(open.points[v]);
      }
      v = number[v];
    }
    used.quads.push_back(q);
  }
  std::vector<SM::Quad_soup> soups = { irregular,
                                       SM::refined(irregular, 4),
                                       random_base,
                                       SM::refined(random_base, 3),
                                       SM::cube(5),
                                       SM::rolled(9, 6, 2, true),
                                       SM::rolled(9, 6, -1, false),
                                       SM::grid(4, 4) };
  if(QM::find_quad_mesh_defects(used.points, used.quads).is_pure_quad_mesh())
    soups.push_back(used);
  for(const SM::Quad_soup& soup : soups)
  {
    const Flat_mesh m = QM::internal::make_indexed_quad_mesh(SM::make_mesh(soup)).mesh;
    const QM::Quad_mesh_structure s = QM::internal::structure_of_quad_mesh(m);
    assert(int(s.number_of_patches) == slow_number_of_patches(m));
    if(s.number_of_patches_not_rectangular == 0)
      assert(s.number_of_patches == s.number_of_representative_crossings);
    assert(s.sum_of_indices == 4 * s.euler_characteristic);
    std::multiset<std::pair<int, int>> fast;
    const QM::internal::Dual_lines lines(m);
    for(const QM::internal::Side_relation& r : QM::internal::side_relations(m, lines))
      if(r.target != -1)
        fast.emplace(r.sidesteps, r.offset);
    assert(fast == slow_relations(m));

    // no turn of a helix crosses itself
    const Mesh mesh = SM::make_mesh(soup);
    const auto helices = QM::minimal_q_helices(mesh);
    assert(helices.size() == s.number_of_helices && s.number_of_helices <= s.number_of_helices_with_crossings);
    for(const auto& h : helices)
    {
      std::set<Mesh::Face_index> passed;
      Mesh::Halfedge_index x = h.first;
      for(int i = 0; i < h.turn_length; ++i)
      {
        assert(passed.insert(mesh.face(x)).second);
        x = mesh.next(mesh.next(mesh.opposite(x)));
      }
    }
  }

  // refinement changes nothing but the sizes: each quad of an irregular base is a patch
  assert(structure(SM::refined(random_base, 3)).number_of_patches == structure(random_base).number_of_patches);
  assert(structure(SM::refined(random_base, 3)).number_of_parallel_classes ==
         structure(random_base).number_of_parallel_classes);
  assert(structure(SM::refined(irregular, 3)).number_of_patches == irregular.quads.size());
  assert(structure(SM::refined(irregular, 3)).number_of_parallel_classes ==
         structure(irregular).number_of_parallel_classes);

  // the maps
  Mesh qm = SM::make_mesh(SM::cube(4));
  auto separatrix = qm.add_property_map<Mesh::Edge_index, bool>("e:s", false).first;
  auto patch = qm.add_property_map<Mesh::Face_index, int>("f:p", -1).first;
  assert(QM::base_complex(qm, separatrix, patch) == 6);
  std::size_t marked = 0;
  for(auto e : qm.edges())
    marked += separatrix[e];
  assert(marked == 48);
}

// Random displacements of the vertices, those on the boundary excepted.
SM::Quad_soup displaced(SM::Quad_soup soup, double amount, unsigned int seed)
{
  const Mesh qm = SM::make_mesh(soup);
  const double length = amount * QM::quad_mesh_quality(qm).mean_edge_length;
  CGAL::Random random(seed);
  for(auto v : qm.vertices())
  {
    SM::Vector_3 d(random.get_double(-length, length), random.get_double(-length, length),
                   random.get_double(-length, length));
    if(!qm.is_border(v))
      soup.points[v] = soup.points[v] + d;
  }
  return soup;
}

// The twelve edges of a cube keep their vertices, which slide; fixed vertices do not move.
void test_features_under_smoothing(bool globally)
{
  const SM::Quad_soup cube_soup = SM::cube(6);
  Mesh reference = SM::triangulated(SM::cube(3)), cube = SM::make_mesh(cube_soup);
  auto on_cube_edge = [](const Mesh& m, Mesh::Edge_index e)
  {
    int fixed = 0;
    const Point_3 &p = m.point(m.vertex(e, 0)), &q = m.point(m.vertex(e, 1));
    for(int k = 0; k < 3; ++k)
      fixed += std::abs(p[k]) == 1 && p[k] == q[k];
    return fixed == 2;
  };
  auto feature = cube.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
  auto reference_feature = reference.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
  auto is_fixed = cube.add_property_map<Mesh::Vertex_index, bool>("v:f", false).first;
  for(auto e : cube.edges())
    feature[e] = on_cube_edge(cube, e);
  for(auto e : reference.edges())
    reference_feature[e] = on_cube_edge(reference, e);
  // slide the vertices of the cube's edges and shake the others
  CGAL::Random random(9);
  for(auto v : cube.vertices())
  {
    double c[3];
    for(int k = 0; k < 3; ++k)
    {
      c[k] = cube_soup.points[v][k];
      if(std::abs(c[k]) < 1)
        c[k] += random.get_double(-0.1, 0.1);
    }
    cube.point(v) = Point_3(c[0], c[1], c[2]);
  }
  const Mesh::Vertex_index anchored(3);
  is_fixed[anchored] = true;
  const Point_3 anchor = cube.point(anchored);
  const QM::Quad_mesh_smoothing_result s = QM::smooth_quad_mesh(
    cube, reference,
    CGAL::parameters::smooth_globally(globally).edge_is_constrained_map(feature).vertex_is_constrained_map(is_fixed),
    CGAL::parameters::edge_is_constrained_map(reference_feature));
  assert(s.folded_quads_after == 0 && cube.point(anchored) == anchor);
  assert(s.quality_after.mean_angle_deviation < 0.5 * s.quality_before.mean_angle_deviation);
  for(auto v : cube.vertices())
    for(int k = 0; k < 3; ++k)
      if(std::abs(cube_soup.points[v][k]) == 1)
        assert(is_close(cube.point(v)[k], cube_soup.points[v][k], 1e-9));
  assert(is_close(QM::quad_mesh_deviation(cube, reference, CGAL::parameters::default_values(),
                                          CGAL::parameters::edge_is_constrained_map(reference_feature))
                    .features_kept,
                  1));
}

// Orientation of quads on a cylinder whose edges are turned against its rulings by a known angle.
void test_orientation()
{
  std::cout << "orientation" << std::endl;
  const double pi = std::acos(-1.);
  const int n = 40, m = 20;
  typedef std::optional<SM::Kernel::Vector_3> Optional_direction;
  for(double degrees : { 0., 3., 17., 44. })
  {
    // A square grid wound around a cylinder of large radius: the faces are nearly flat.
    SM::Quad_soup soup = SM::grid(n, m);
    const double radius = 1000, a = degrees * pi / 180;
    for(Point_3& p : soup.points)
    {
      const double x = std::cos(a) * p.x() - std::sin(a) * p.y(), y = std::sin(a) * p.x() + std::cos(a) * p.y();
      p = Point_3(radius * std::sin(x / radius), y, radius * std::cos(x / radius));
    }
    const Mesh qm = SM::make_mesh(soup), tm = SM::triangulated(soup);
    // Rulings and circles in turn, on a part of the faces: edges nearby count alike.
    std::vector<Optional_direction> direction;
    for(Mesh::Face_index f : tm.faces())
    {
      const Point_3& p = tm.point(tm.target(tm.halfedge(f)));
      direction.emplace_back();
      if(std::size_t(f) % 3 == 0)
        direction.back() = SM::Kernel::Vector_3(0, 1, 0);
      else if(std::size_t(f) % 3 == 1)
        direction.back() = SM::Kernel::Vector_3(p.z(), 0, -p.x());
    }
    auto deviation = [&]
    {
      return QM::quad_mesh_deviation(qm, tm, CGAL::parameters::default_values(),
                                     CGAL::parameters::face_direction_map(boost::make_iterator_property_map(
                                       direction.begin(), get(boost::face_index, tm))));
    };
    const QM::Quad_mesh_deviation d = deviation();
    std::cout << "  turned by " << degrees << ": mean " << d.orientation_deviation_mean << " of " << d.oriented_edges
              << " edges" << std::endl;
    assert(d.oriented_edges == qm.number_of_edges());
    assert(std::abs(d.orientation_deviation_mean - degrees) < 0.1);
    assert(d.orientation_over_15 == (degrees > 15 ? 1 : 0));
    assert(std::accumulate(d.orientation_histogram.begin(), d.orientation_histogram.end(), std::size_t(0)) ==
           d.oriented_edges);
    if(degrees > 0)
      assert(d.orientation_histogram[static_cast<std::size_t>(degrees / 5)] == d.oriented_edges);

    // Far from all directions, edges do not count; without any, none does.
    for(Mesh::Face_index f : tm.faces())
      if(std::size_t(f) > 0)
        direction[f] = Optional_direction();
    direction[0] = SM::Kernel::Vector_3(0, 1, 0);
    assert(deviation().oriented_edges > 2 && deviation().oriented_edges < 20);
    direction[0] = Optional_direction();
    assert(deviation().oriented_edges == 0 && deviation().orientation_deviation_mean == 0);
  }
}

void test_smoothing()
{
  std::cout << "smoothing" << std::endl;
  // every amount of noise on a sphere comes out as a good mesh on the sphere
  const Mesh sphere = SM::triangulated(SM::sphere(24));
  for(double amount : { 0.2, 0.5, 0.8 })
  {
    Mesh qm = SM::make_mesh(displaced(SM::sphere(12), amount, 3));
    const QM::Quad_mesh_smoothing_result r = QM::smooth_quad_mesh(qm, sphere);
    assert(r.status == QM::Quad_mesh_status::SUCCESS && r.folded_quads_after == 0);
    assert(r.quality_after.minimal_scaled_jacobian > 0.5);
    assert(r.quality_after.mean_angle_deviation < 8 &&
           r.quality_after.mean_angle_deviation < r.quality_before.mean_angle_deviation);
    for(auto v : qm.vertices())
      assert(std::abs(std::sqrt((qm.point(v) - CGAL::ORIGIN).squared_length()) - 1) < 0.01);
    const QM::Quad_mesh_deviation d = QM::quad_mesh_deviation(qm, sphere);
    assert(d.quads_to_reference_max < 0.02 && d.opposed_quads == 0);
  }

  // whatever goes in without an inverted quad comes out without one
  for(unsigned int seed = 0; seed < 12; ++seed)
  {
    Mesh qm = SM::make_mesh(
      displaced(seed % 2 == 0 ? SM::sphere(8) : SM::rolled(16, 10, 1, true), 0.05 * (1 + seed % 6), seed));
    const bool valid = QM::quad_mesh_quality(qm).number_of_inverted_quads == 0;
    const QM::Quad_mesh_smoothing_result r = QM::smooth_quad_mesh(qm, CGAL::parameters::smooth_globally(seed % 4 < 2));
    if(valid)
      assert(r.quality_after.number_of_inverted_quads == 0);
    assert(is_close(QM::quad_mesh_quality(qm).minimal_scaled_jacobian, r.quality_after.minimal_scaled_jacobian));
  }

  // the boundary of a rectangle is kept, its corners stay, and the squares come back
  const SM::Quad_soup square = SM::grid(9, 6);
  const Mesh plane = SM::triangulated(square);
  Mesh qm = SM::make_mesh(displaced(square, 0.6, 5));
  const QM::Quad_mesh_smoothing_result r =
    QM::smooth_quad_mesh(qm, plane, CGAL::parameters::smoothing_iterations(200u));
  assert(r.folded_quads_after == 0 && r.quality_after.mean_angle_deviation < 0.5);
  for(auto v : qm.vertices())
  {
    const Point_3 &p = qm.point(v), &q = square.points[v];
    assert(is_close(p.z(), 0, 1e-12));
    if(q.x() == 0 || q.x() == 9)
      assert(p.x() == q.x());
    if(q.y() == 0 || q.y() == 6)
      assert(p.y() == q.y());
  }

  // whatever is smoothed, features are kept
  test_features_under_smoothing(false);
  test_features_under_smoothing(true);

  // the same on another graph; same input, same output
  typedef CGAL::Polyhedron_3<SM::Kernel> Polyhedron;
  Polyhedron p1 = SM::make_mesh<Polyhedron>(displaced(SM::sphere(6), 0.3, 1)), p2 = p1;
  QM::smooth_quad_mesh(p1, sphere);
  QM::smooth_quad_mesh(p2, sphere);
  assert(std::equal(p1.points_begin(), p1.points_end(), p2.points_begin()));

  // answers to bad input, and stopping
  Mesh triangles = SM::triangulated(SM::cube(1)), cube = SM::make_mesh(SM::cube(6)), empty;
  assert(QM::smooth_quad_mesh(triangles).status == QM::Quad_mesh_status::NOT_A_QUAD_MESH);
  assert(QM::smooth_quad_mesh(cube, empty).status == QM::Quad_mesh_status::EMPTY_REFERENCE);
  assert(QM::smooth_quad_mesh(empty).status == QM::Quad_mesh_status::SUCCESS);
  struct Stop : QM::Default_visitor
  {
    bool go_further() { return false; }
  } stop;
  Mesh shaken = SM::make_mesh(displaced(SM::sphere(6), 0.3, 1)), copy = shaken;
  assert(QM::smooth_quad_mesh(copy, sphere, CGAL::parameters::visitor(std::ref(stop))).status ==
         QM::Quad_mesh_status::STOPPED);
  for(auto v : copy.vertices())
    assert(copy.point(v) == shaken.point(v));
}

// Where vertices have to go far, along the surface and its border.
void test_global_smoothing()
{
  std::cout << "global smoothing" << std::endl;
  const auto globally = CGAL::parameters::smooth_globally(true);
  // a square whose middle has been pushed to a side: no other mesh of it has better quads than the grid
  auto pushed = [](SM::Quad_soup soup, int n)
  {
    for(Point_3& p : soup.points)
      p = Point_3(p.x() + 5 * std::sin(SM::pi * p.x() / n) * std::sin(SM::pi * p.y() / n),
                  p.y() - 5 * std::sin(SM::pi * p.x() / n) * std::sin(2 * SM::pi * p.y() / n), 0);
    return soup;
  };
  const SM::Quad_soup square = SM::grid(40, 40);
  const Mesh plane = SM::triangulated(square);
  Mesh one_by_one = SM::make_mesh(pushed(square, 40)), all_at_once = one_by_one;
  assert(QM::smooth_quad_mesh(one_by_one, plane).quality_after.mean_angle_deviation > 4);
  assert(QM::smooth_quad_mesh(all_at_once, plane, globally).quality_after.mean_angle_deviation < 0.1);
  for(auto v : all_at_once.vertices())
  {
    const Point_3 &p = all_at_once.point(v), &q = square.points[v];
    assert(is_close(p.x(), q.x(), 0.1) && is_close(p.y(), q.y(), 0.1) && is_close(p.z(), 0, 1e-12));
    if(q.x() == 0 || q.x() == 40)
      assert(p.x() == q.x());
    if(q.y() == 0 || q.y() == 40)
      assert(p.y() == q.y());
  }

  // A smaller square pushed as far: quads get worse where a step goes too far, and these steps are damped. Without the
  // damping, the mean deviation is 3.7 degrees, with it 0.7.
  const SM::Quad_soup small_square = SM::grid(24, 24);
  Mesh small = SM::make_mesh(pushed(small_square, 24));
  assert(QM::smooth_quad_mesh(small, SM::triangulated(small_square), globally).quality_after.mean_angle_deviation <
         1.5);

  // a cylinder whose ends are twisted by half a turn against each other: they have to go back along the border
  SM::Quad_soup cylinder = SM::rolled(32, 40, 0, false);
  for(Point_3& p : cylinder.points)
  {
    const double angle = SM::pi * p.z() / (40 * 2 * SM::pi / 32);
    p = Point_3(std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y(),
                p.z());
  }
  const Mesh round = SM::triangulated(SM::rolled(64, 80, 0, false));
  one_by_one = SM::make_mesh(cylinder);
  all_at_once = one_by_one;
  assert(QM::smooth_quad_mesh(one_by_one, round).quality_after.mean_angle_deviation > 15);
  const QM::Quad_mesh_smoothing_result r = QM::smooth_quad_mesh(all_at_once, round, globally);
  assert(r.folded_quads_after == 0 && r.quality_after.mean_angle_deviation < 0.5 &&
         r.quality_after.minimal_scaled_jacobian > 0.95);
  for(auto v : all_at_once.vertices())
    if(all_at_once.is_border(v))
      assert(is_close(all_at_once.point(v).z(), cylinder.points[v].z()));
  assert(is_close(QM::quad_mesh_deviation(all_at_once, round).boundary_kept, 1));

  // same input, same output
  Mesh again = SM::make_mesh(cylinder);
  QM::smooth_quad_mesh(again, round, globally);
  assert(std::equal(again.points().begin(), again.points().end(), all_at_once.points().begin()));
}

// A helix is minimal if no turn of one with a smaller pitch lies on its path: against all pairs of turns.
void test_minimal_helices()
{
  using QM::internal::Helix_record;
  CGAL::Random random(3);
  int dropped = 0, kept = 0;
  for(int trial = 0; trial < 2000; ++trial)
  {
    const bool closed = trial % 2 == 0;
    const int n = random.get_int(8, 30);
    std::vector<Helix_record> helices(random.get_int(1, 7));
    for(Helix_record& h : helices)
    {
      h.line = 0;
      h.pitch = random.get_bool() ? random.get_int(1, 5) : -random.get_int(1, 5);
      h.turn_length = random.get_int(1, n / 2);
      h.number_of_relations = random.get_int(1, n / 2);
      h.start = random.get_int(0, closed ? n : n - h.turn_length - h.number_of_relations + 1);
      h.length = h.number_of_relations - 1 + h.turn_length;
      h.is_whole_line = closed && random.get_int(0, 8) == 0;
    }
    auto has_turn_on_path_of = [&](const Helix_record& a, const Helix_record& b)
    {
      if(a.is_whole_line)
        return true;
      for(int i = b.start; i < b.start + b.number_of_relations; ++i)
        for(int at = closed ? i % n : i; at <= i + n; at += n)
          if(at >= a.start && at + b.turn_length <= a.start + a.length)
            return true;
      return false;
    };
    std::multiset<std::pair<int, int>> expected, found; // pitch and start
    for(const Helix_record& a : helices)
    {
      bool is_minimal = true;
      for(const Helix_record& b : helices)
        is_minimal = is_minimal && !(std::abs(b.pitch) < std::abs(a.pitch) && has_turn_on_path_of(a, b));
      if(is_minimal)
        expected.emplace(a.pitch, a.start);
      ++(is_minimal ? kept : dropped);
    }
    QM::internal::keep_minimal_helices(helices, n, closed);
    for(const Helix_record& h : helices)
      found.emplace(h.pitch, h.start);
    assert(found == expected);
  }
  assert(kept > 1000 && dropped > 1000);
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "quality", test_quality },
                     { "defects", test_defects },
                     { "structure", test_structure },
                     { "minimal_helices", test_minimal_helices },
                     { "orientation", test_orientation },
                     { "smoothing", test_smoothing },
                     { "global_smoothing", test_global_smoothing } });
}
