// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Layout-guided quad meshing: layouts and their files, drawing them on a surface, the energies of charts, numbers of
// segments, and the quads that come out.

#include "../../examples/Quad_meshing/car_body.h"
#include "layout_meshes.h"
#include "quad_mesh_checks.h"
#include "test_cases.h"
#include "visitor_checks.h"

#include <CGAL/Quad_meshing/Layout/internal/Arc_quantization.h>
#include <CGAL/Quad_meshing/Layout/internal/Chart_isometry.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_embedding.h>
#include <CGAL/Quad_meshing/Layout/internal/Layout_parameterization.h>
#include <CGAL/Quad_meshing/Layout/internal/Patch_untangling.h>
#include <CGAL/Quad_meshing/Layout/internal/Quad_straightening.h>
#include <CGAL/Quad_meshing/Layout/layout_from_quad_mesh.h>
#include <CGAL/Quad_meshing/Layout/quadrangulate_layout.h>
#include <CGAL/Quad_meshing/Layout/surface_layout_files.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>

#include <CGAL/Random.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace TM = test_meshes;
namespace LM = layout_meshes;
namespace params = CGAL::parameters;

typedef TM::Mesh Mesh;
typedef TM::Point_3 Point_3;
typedef QM::Surface_layout Layout;
typedef QM::Layout_quadrangulation_result Result;
typedef QM::Layout_quadrangulation_status Status;
typedef QM::internal::Chart_isometry Isometry;
typedef QM::internal::Quadrilateral_chart Chart;

namespace {

const QM::Layout_chart all_charts[] = { QM::Layout_chart::UNIT, QM::Layout_chart::RECTANGLE,
                                        QM::Layout_chart::QUADRILATERAL };

// A valid quad mesh with the topology of the triangle mesh.
void check_mesh(const Mesh& qm, const Mesh& tm, const Result& result)
{
  if(!result.is_valid())
    std::cerr << result.message << std::endl;
  assert(result.is_valid() && result.folded_patches == 0 && result.inverted_quads == 0);
  const quad_mesh_checks::Mesh_figures q = quad_mesh_checks::figures(qm), t = quad_mesh_checks::figures(tm);
  assert(q.is_valid() && q.same_topology(t) && q.is_simple());
  assert(q.faces == result.quads && q.vertices == result.vertices);
}

// Quads and edges of a mesh without its numbering: sorted points, and for each edge its midpoint.
std::vector<std::array<double, 3>> places(const Mesh& qm)
{
  std::vector<std::array<double, 3>> p;
  for(auto e : qm.edges())
  {
    const Point_3 c = CGAL::midpoint(qm.point(qm.vertex(e, 0)), qm.point(qm.vertex(e, 1)));
    p.push_back({ { c.x(), c.y(), c.z() } });
  }
  return p;
}

// Whether two sets of places are the same but for a distance.
bool same_places(const std::vector<std::array<double, 3>>& a, const std::vector<std::array<double, 3>>& b,
                 double distance)
{
  if(a.size() != b.size())
    return false;
  for(const auto& p : a)
    if(std::none_of(b.begin(), b.end(),
                    [&](const std::array<double, 3>& q)
                    { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= distance; }))
      return false;
  return true;
}

// ---- charts ----

Isometry random_isometry(CGAL::Random& random)
{
  Isometry isometry;
  for(int i = 0; i < 6; ++i)
  {
    std::array<Eigen::Vector2d, 3> st;
    for(Eigen::Vector2d& p : st)
      p = Eigen::Vector2d(random.get_double(), random.get_double());
    isometry.add(random.get_double(0.5, 1), random.get_double(-1, 1), random.get_double(0.5, 1), st);
  }
  return isometry;
}

void derivatives_are_those_of_the_energy()
{
  CGAL::Random random(7);
  const double step = 1e-5;
  for(int run = 0; run < 20; ++run)
  {
    const Isometry isometry = random_isometry(random);
    Isometry::Parameters q;
    for(int k = 0; k < 5; ++k)
      q[k] = random.get_double(0.2, 2);
    Isometry::Parameters gradient, up, down;
    Isometry::Hessian hessian, unused;
    isometry.derivatives(q, gradient, hessian);
    const double scale = 1 + hessian.cwiseAbs().maxCoeff() + gradient.cwiseAbs().maxCoeff();
    for(int k = 0; k < 5; ++k)
    {
      const Isometry::Parameters e = step * Isometry::Parameters::Unit(k);
      assert(std::abs((isometry.energy(q + e) - isometry.energy(q - e)) / (2 * step) - gradient[k]) < 1e-6 * scale);
      isometry.derivatives(q + e, up, unused);
      isometry.derivatives(q - e, down, unused);
      assert(((up - down) / (2 * step) - hessian.col(k)).cwiseAbs().maxCoeff() < 1e-6 * scale);
    }
    // a quartic: the fourth differences are constant, the fifth vanish
    std::vector<double> values;
    for(int i = 0; i < 6; ++i)
      values.push_back(isometry.energy(q * (1 + 0.1 * i)));
    for(int order = 0; order < 5; ++order)
      for(int i = 0; i + 1 < 6 - order; ++i)
        values[i] = values[i + 1] - values[i];
    assert(std::abs(values[0]) < 1e-9 * scale);
  }
}

void bilinear_coordinates_come_back()
{
  CGAL::Random random(3);
  for(int run = 0; run < 2000; ++run)
  {
    Isometry::Parameters q;
    q << random.get_double(0.5, 2), random.get_double(-0.3, 0.3), random.get_double(0.5, 2), random.get_double(0.5, 2),
      random.get_double(0.5, 2);
    const Chart chart = run == 0 ? Chart::rectangle(2, 3) : Chart(q);
    if(!chart.is_convex())
      continue;
    const Eigen::Vector2d st(random.get_double(), random.get_double());
    assert((chart.inverse_bilinear(chart.bilinear(st)) - st).norm() < 1e-8);
    assert((Chart(chart.parameters()).corner[2] - chart.corner[2]).norm() == 0);
  }
}

// The triangles of a quadrilateral's own grid have no energy in that quadrilateral, and it is found from any other one.
void chart_becomes_the_quadrilateral_that_is_mapped()
{
  Isometry::Parameters q;
  q << 2, 0.3, 1.2, 1.7, 1.5;
  const Chart truth(q);
  Isometry isometry;
  const int n = 4;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      const std::array<Eigen::Vector2d, 3> st = { { Eigen::Vector2d(i, j) / n, Eigen::Vector2d(i + 1, j) / n,
                                                    Eigen::Vector2d(i, j + 1) / n } };
      const Eigen::Vector2d a = truth.bilinear(st[1]) - truth.bilinear(st[0]),
                            b = truth.bilinear(st[2]) - truth.bilinear(st[0]);
      isometry.add(a.norm(), a.dot(b) / a.norm(), QM::internal::cross_product_2(a, b) / a.norm(), st);
    }
  assert(isometry.energy(q) < 1e-25);
  const Chart found = QM::internal::optimize_chart(isometry, Chart::rectangle(1, 1), false);
  assert((found.parameters() - q).norm() < 1e-5);
  // a rectangle cannot, and the best one is better than its neighbours
  const Chart rectangle = QM::internal::optimize_chart(isometry, Chart::rectangle(1, 1), true);
  const double w = rectangle.corner[1].x(), h = rectangle.corner[3].y(),
               least = isometry.energy(rectangle.parameters());
  assert(least > 1e-3);
  for(double d : { -1e-3, 1e-3 })
    assert(isometry.energy(Chart::rectangle(w + d, h).parameters()) > least &&
           isometry.energy(Chart::rectangle(w, h + d).parameters()) > least);
  // sides and angles make the quadrilateral that has them
  std::array<double, 4> length, angle;
  for(int k = 0; k < 4; ++k)
  {
    const Eigen::Vector2d next = truth.corner[(k + 1) % 4] - truth.corner[k],
                          before = truth.corner[(k + 3) % 4] - truth.corner[k];
    length[k] = next.norm();
    angle[k] = std::acos(next.dot(before) / (next.norm() * before.norm()));
  }
  assert((Chart::from_sides(length, angle).parameters() - q).norm() < 1e-12);
}

// ---- drawing ----

// The split surface stays a consistent mesh of the same area.
void splits_keep_the_surface()
{
  for(const TM::Soup& soup : { TM::icosphere(1), TM::grid(3, 2) })
  {
    const Mesh tm = TM::make_mesh(soup);
    const QM::internal::Indexed_triangle_mesh input =
      QM::internal::make_indexed_triangle_mesh(tm, params::default_values());
    QM::internal::Split_surface s(input, std::vector<char>(input.number_of_halfedges(), 0));
    CGAL::Random random(5);
    auto area = [](const QM::internal::Indexed_triangle_mesh& m)
    {
      double sum = 0;
      for(int f = 0; f < m.number_of_faces(); ++f)
        sum += 0.5 * std::sqrt(CGAL::cross_product(m.vector(3 * f), m.vector(3 * f + 1)).squared_length());
      return sum;
    };
    s.draw(0, 6);
    for(int i = 0; i < 300; ++i)
    {
      const int h = random.get_int(0, s.mesh.number_of_halfedges());
      if(i % 3 == 0)
        s.split_face(h / 3, CGAL::centroid(s.mesh.points[s.mesh.source(h)], s.mesh.points[s.mesh.target(h)],
                                           s.mesh.points[s.mesh.source(s.mesh.prev(h))]));
      else
        s.split_edge(h, s.mesh.points[s.mesh.source(h)] + random.get_double(0.3, 0.7) * s.mesh.vector(h));
    }
    const QM::internal::Indexed_triangle_mesh& m = s.mesh;
    double drawn = 0;
    for(int h = 0; h < m.number_of_halfedges(); ++h)
    {
      const int o = m.opposite[h];
      assert(o == -1 || (m.opposite[o] == h && m.source(o) == m.target(h) && m.target(o) == m.source(h)));
      assert(o == -1                ? s.direction[h] == -1 || s.direction[h] == 6
             : s.direction[h] == -1 ? s.direction[o] == -1
                                    : s.direction[o] == (s.direction[h] ^ 1));
      if(s.direction[h] == 6)
        drawn += std::sqrt(m.vector(h).squared_length());
    }
    assert(std::abs(drawn - std::sqrt(input.vector(0).squared_length())) < 1e-12);
    assert(QM::internal::find_non_manifold_vertex(m) == -1);
    for(int v = 0; v < m.number_of_vertices(); ++v)
    {
      assert(m.source(m.halfedge_of_vertex[v]) == v);
      bool on_border = false;
      QM::internal::for_each_corner_of_vertex(
        m, v, [&](int h) { on_border = on_border || m.opposite[h] == -1 || m.opposite[m.prev(h)] == -1; });
      assert(!on_border || m.opposite[m.halfedge_of_vertex[v]] == -1);
    }
    assert(std::abs(area(m) - area(input)) < 1e-12 * area(input));
  }
}

// A straight line over a flat mesh is found as one.
void arcs_are_short()
{
  const Mesh tm = TM::make_mesh(TM::perturbed(TM::grid(13, 11, 13, 11), 0.2, 4));
  const QM::internal::Indexed_triangle_mesh input =
    QM::internal::make_indexed_triangle_mesh(tm, params::default_values());
  QM::internal::Split_surface s(input, std::vector<char>(input.number_of_halfedges(), 0));
  QM::internal::Arc_router router(s);
  const int from = 0, into = 14 * 12 - 3;
  router.block(from);
  router.block(into);
  std::vector<QM::internal::Arc_router::Step> path;
  assert(router.find_path(from, into, {}, {}, true, path));
  const double straight = std::sqrt(CGAL::squared_distance(input.points[from], input.points[into]));
  std::cout << "  length over distance " << router.length(path) / straight << std::endl;
  assert(router.length(path) < 1.05 * straight);
  router.draw(path, 0);
  // a curve that would cross it is not drawn, one on the same side is
  const int left = 14 * 11, right = 13;
  router.block(left);
  router.block(right);
  assert(router.find_path(left, right, {}, {}, false, path));
  assert(router.find_path(left, right, {}, {}, true, path) == false ||
         router.length(path) > 1.01 * std::sqrt(CGAL::squared_distance(input.points[left], input.points[right])));
}

// ---- the whole ----

void one_patch_of_a_plane_is_mapped_by_the_identity()
{
  // a plane mesh with straight borders, whose inner vertices have been moved
  const Mesh tm = TM::make_mesh(TM::mapped(
    TM::grid(11, 7, 3, 2),
    [](const Point_3& p)
    {
      const double d = 0.12 * std::sin(TM::pi * p.x() / 3) * std::sin(TM::pi * p.y() / 2);
      return Point_3(p.x() + d * std::sin(7 * p.x() + 3 * p.y()), p.y() + d * std::cos(5 * p.x() * p.y()), 0);
    }));
  for(const QM::Layout_chart chart : { QM::Layout_chart::RECTANGLE, QM::Layout_chart::QUADRILATERAL })
    for(const bool mean_value : { false, true })
      for(const bool least_squares : { false, true })
      {
        Mesh qm;
        const Result result = QM::quadrangulate_layout(tm, LM::rectangle(3, 2), qm,
                                                       params::target_edge_length(0.25)
                                                         .layout_chart(chart)
                                                         .mean_value_weights(mean_value)
                                                         .least_squares_alignment(least_squares));
        check_mesh(qm, tm, result);
        assert(result.quads == 12 * 8);
        assert(result.energies.back() < 1e-20);
        for(auto v : qm.vertices())
          for(double x : { qm.point(v).x() * 4, qm.point(v).y() * 4 })
            assert(std::abs(x - std::round(x)) < 1e-9);
      }
}

void quadrilaterals_flatten_the_sheared_cube()
{
  const Mesh tm = TM::make_mesh(TM::sheared_cube(12));
  double energy[2];
  for(int i = 0; i < 2; ++i)
  {
    Mesh qm;
    const Result result =
      QM::quadrangulate_layout(tm, LM::sheared_cube(), qm,
                               params::target_number_of_quads(600).layout_chart(
                                 i == 0 ? QM::Layout_chart::RECTANGLE : QM::Layout_chart::QUADRILATERAL));
    check_mesh(qm, tm, result);
    assert(result.patches == 6 && result.nodes == 8 && result.arcs == 12);
    energy[i] = result.energies.back();
    if(i == 1)
    {
      // all quads of a face are one parallelogram
      for(auto f : qm.faces())
      {
        const auto h = qm.halfedge(f);
        const auto a = qm.point(qm.target(h)) - qm.point(qm.source(h)),
                   b = qm.point(qm.target(qm.next(qm.next(h)))) - qm.point(qm.source(qm.next(qm.next(h))));
        assert((a + b).squared_length() < 1e-12 * a.squared_length());
      }
      assert(QM::quad_mesh_quality(qm).number_of_inverted_quads == 0);
    }
  }
  std::cout << "  energy with rectangles " << energy[0] << ", with quadrilaterals " << energy[1] << std::endl;
  assert(energy[1] < 1e-6 * energy[0]);
}

void energies_never_rise()
{
  const Mesh tm = TM::make_mesh(TM::mapped(
    TM::icosphere(3), [](const Point_3& p) { return Point_3(2 * p.x() + 0.3 * p.y() * p.y(), p.y(), 0.7 * p.z()); }));
  for(const QM::Layout_chart chart : all_charts)
  {
    Mesh qm;
    const Result result =
      QM::quadrangulate_layout(tm, LM::around(LM::cube_quads(), { { 2, 1, 0.7 } }), qm,
                               params::target_number_of_quads(1500).layout_chart(chart).number_of_iterations(6));
    check_mesh(qm, tm, result);
    assert(chart == QM::Layout_chart::UNIT ? result.energies.size() == 1 : result.energies.size() >= 2);
    std::cout << "  energies";
    for(std::size_t i = 0; i < result.energies.size(); ++i)
    {
      std::cout << " " << result.energies[i];
      assert(i == 0 || result.energies[i] < result.energies[i - 1]);
    }
    std::cout << std::endl;
    assert(std::abs(double(result.quads) - 1500) <= 0.05 * 1500);
  }
}

// First corners, numbers and directions of arcs, and numbers of patches change nothing but the numbers of the result.
void results_do_not_depend_on_numbers()
{
  const Mesh tm = TM::make_mesh(TM::mapped(
    TM::icosphere(3), [](const Point_3& p) { return Point_3(1.5 * p.x(), p.y() + 0.2 * p.x() * p.x(), 0.8 * p.z()); }));
  const Layout layout = LM::around(LM::cube_quads(), { { 1.5, 1, 0.8 } });
  Layout other = layout;
  std::reverse(other.patches.begin(), other.patches.end());
  for(std::size_t p = 0; p < other.patches.size(); ++p)
    std::rotate(other.patches[p].sides.begin(), other.patches[p].sides.begin() + p % 4, other.patches[p].sides.end());
  const std::size_t n = other.arcs.size();
  std::reverse(other.arcs.begin(), other.arcs.end());
  for(std::size_t a = 0; a < n; a += 2)
    std::swap(other.arcs[a].source, other.arcs[a].target);
  for(Layout::Patch& p : other.patches)
    for(auto& side : p.sides)
      for(Layout::Side_arc& s : side)
      {
        s.arc = n - 1 - s.arc;
        s.is_forward = s.arc % 2 == 0 ? !s.is_forward : s.is_forward;
      }
  for(const QM::Layout_chart chart : { QM::Layout_chart::RECTANGLE, QM::Layout_chart::QUADRILATERAL })
  {
    Mesh a, b;
    const auto np = params::target_number_of_quads(300).layout_chart(chart).arc_alignment(QM::Arc_alignment::ALL);
    const Result ra = QM::quadrangulate_layout(tm, layout, a, np), rb = QM::quadrangulate_layout(tm, other, b, np);
    check_mesh(a, tm, ra);
    check_mesh(b, tm, rb);
    std::cout << "  energies " << ra.energies.back() << " " << rb.energies.back() << std::endl;
    assert(std::abs(ra.energies.back() - rb.energies.back()) < 1e-6 * ra.energies.back() + 1e-9);
    assert(same_places(places(a), places(b), 1e-3));
  }
}

void t_vertices_lie_on_samples()
{
  const Mesh tm = TM::make_mesh(TM::grid(24, 16, 3, 2));
  Mesh qm;
  auto is_aligned = qm.add_property_map<Mesh::Edge_index, bool>("e:is_aligned", false).first;
  auto patch = qm.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 99).first;
  const Layout layout = LM::t_layout();
  const Result result = QM::quadrangulate_layout(tm, layout, qm, params::target_edge_length(0.125),
                                                 params::edge_is_constrained_map(is_aligned).face_patch_map(patch));
  check_mesh(qm, tm, result);
  assert(result.t_vertices == 1 && result.patches == 3);
  for(const Layout::Patch& p : layout.patches)
    for(int k = 0; k < 2; ++k)
    {
      std::size_t sum[2] = { 0, 0 };
      for(int s = 0; s < 2; ++s)
        for(const Layout::Side_arc& a : p.sides[k + 2 * s])
          sum[s] += result.segments[a.arc];
      assert(sum[0] == sum[1] && sum[0] > 0);
    }
  // border edges are aligned, the inner arcs are not
  for(auto e : qm.edges())
    assert(is_aligned[e] == qm.is_border(e));
  std::vector<std::size_t> quads_of_patch(3, 0);
  for(auto f : qm.faces())
    ++quads_of_patch.at(patch[f]);
  for(std::size_t n : quads_of_patch)
    assert(n > 0);

  // an aligned arc becomes a chain of edges
  Layout aligned = layout;
  for(Layout::Arc& a : aligned.arcs)
    a.is_aligned = true;
  Mesh second;
  auto is_aligned_2 = second.add_property_map<Mesh::Edge_index, bool>("e:is_aligned", false).first;
  check_mesh(second, tm,
             QM::quadrangulate_layout(tm, aligned, second, params::target_edge_length(0.125),
                                      params::edge_is_constrained_map(is_aligned_2)));
  double length = 0;
  for(auto e : second.edges())
    if(is_aligned_2[e] && !second.is_border(e))
      length += std::sqrt(CGAL::squared_distance(second.point(second.vertex(e, 0)), second.point(second.vertex(e, 1))));
  // the arcs from (1, 0) to (1, 2) and from (1, 1.2) to (3, 0.8)
  assert(length > 2 + std::hypot(2, 0.4) - 1e-12 && length < 1.01 * (2 + std::hypot(2, 0.4)));
}

// Arcs that are loops, patches that meet themselves, any genus.
void a_torus_of_one_patch()
{
  const Mesh tm = TM::make_mesh(TM::torus(40, 16));
  Mesh qm;
  const Result result = QM::quadrangulate_layout(tm, LM::torus(1, 0.4), qm, params::target_number_of_quads(400));
  check_mesh(qm, tm, result);
  assert(result.patches == 1 && result.nodes == 1 && result.arcs == 2);
  assert(quad_mesh_checks::figures(qm).irregular_vertices() == 0);
}

void a_cylinder_with_two_borders()
{
  const Mesh tm = TM::make_mesh(TM::cylinder(30, 12, false));
  Mesh qm;
  const Result result = QM::quadrangulate_layout(tm, LM::cylinder(3, 1, 2), qm, params::target_number_of_quads(600));
  check_mesh(qm, tm, result);
  for(auto v : qm.vertices())
    if(qm.is_border(v))
      assert(qm.point(v).z() < 1e-9 || qm.point(v).z() > 2 - 1e-9);
}

// Sharp edges that arcs run along become chains of quad edges without a tag.
void features_are_kept()
{
  const Mesh soup = TM::make_mesh(TM::cube(9));
  Mesh tm = soup;
  auto is_sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  std::size_t sharp = 0;
  for(auto e : tm.edges())
  {
    const auto h = tm.halfedge(e);
    const auto n = [&](Mesh::Halfedge_index g)
    { return CGAL::normal(tm.point(tm.source(g)), tm.point(tm.target(g)), tm.point(tm.target(tm.next(g)))); };
    is_sharp[e] = CGAL::approximate_angle(n(h), n(tm.opposite(h))) > 40;
    sharp += is_sharp[e];
  }
  assert(sharp == 12 * 9);
  Mesh qm;
  auto is_aligned = qm.add_property_map<Mesh::Edge_index, bool>("e:is_aligned", false).first;
  const Result result =
    QM::quadrangulate_layout(tm, LM::cube(), qm, params::target_number_of_quads(150).edge_is_constrained_map(is_sharp),
                             params::edge_is_constrained_map(is_aligned));
  check_mesh(qm, tm, result);
  assert(result.aligned_arcs == 12 && result.quadrilateral_charts == 6);
  assert(std::abs(result.feature_length - 12) < 1e-12 && std::abs(result.feature_length_on_arcs - 12) < 1e-9);
  std::size_t aligned = 0;
  for(auto e : qm.edges())
    aligned += is_aligned[e];
  assert(aligned == 12 * 5 && result.quads == 150);
}

// Even where the map has been spoiled, positive weights bring the triangles of a patch back.
void untangling_leaves_no_fold()
{
  const Mesh tm = TM::make_mesh(TM::perturbed(TM::icosphere(3), 0.03, 11));
  const QM::internal::Indexed_triangle_mesh input =
    QM::internal::make_indexed_triangle_mesh(tm, params::default_values());
  QM::internal::Embedded_layout e(input, std::vector<char>(input.number_of_halfedges(), 0),
                                  LM::around(LM::cube_quads(), { { 1, 1, 1 } }));
  QM::internal::Any_visitor visitor;
  QM::internal::Layout_embedding embedding(e);
  assert(embedding.run(input, visitor).empty());
  QM::internal::Layout_charts charts(e);
  charts.chart.assign(6, Chart::rectangle(1, 1));
  QM::internal::Layout_parameterization map(e, false);
  assert(map.solve(charts, std::vector<char>(12, 1), QM::internal::Layout_parameterization::Alignment::TANGENTIAL));
  QM::internal::Patch_untangling untangling(e, map);
  CGAL::Random random(1);
  for(std::size_t c = 0; c < map.copies.size(); ++c)
    if(map.copies[c].direction == -1)
      map.place[c] = Eigen::Vector2d(random.get_double(), random.get_double());
  // and an arc in disorder
  assert(e.chain[0].size() > 4);
  std::swap(map.on_arc[e.chain[0][1]], map.on_arc[e.chain[0][3]]);
  assert(untangling.folded_patches().size() == 6);
  assert(untangling.order_arc(0, charts));
  assert(!untangling.order_arc(0, charts));
  for(int p = 0; p < 6; ++p)
  {
    assert(untangling.untangle(p));
    assert(!untangling.has_fold(p));
  }
}

// A vertex that lies beyond its neighbours inverts quads. It comes back, and nothing far from it moves; what may not
// move stays inverted and is counted.
void inverted_quads_become_straight()
{
  const int n = 12;
  const structure_meshes::Quad_soup soup = structure_meshes::grid(n, n);
  QM::internal::Indexed_quad_mesh quads;
  quads.points.assign(soup.points.begin(), soup.points.end());
  for(const auto& q : soup.quads)
    quads.corners.push_back(
      { { static_cast<int>(q[0]), static_cast<int>(q[1]), static_cast<int>(q[2]), static_cast<int>(q[3]) } });
  quads.is_feature.assign(4 * quads.corners.size(), 0);
  assert(quads.connect());
  const int inner = 5 * (n + 1) + 5, far_away = n + 2;
  quads.points[inner] = QM::internal::Indexed_quad_mesh::Point_3(7.6, 5.2, 0);
  const std::vector<QM::internal::Indexed_quad_mesh::Point_3> before = quads.points;
  const QM::internal::Indexed_reference reference{ QM::internal::make_indexed_triangle_mesh(
                                                     TM::make_mesh(TM::grid(n, n, n, n)), params::default_values()),
                                                   {},
                                                   {},
                                                   {},
                                                   {} };
  QM::internal::Any_visitor visitor;

  const std::vector<char> all(quads.points.size(), 1);
  assert(QM::internal::Quad_straightening(quads, all, reference).run(visitor) > 0 && quads.points == before);

  std::vector<char> border(quads.points.size(), 0);
  for(int v = 0; v < quads.number_of_vertices(); ++v)
    border[v] = quads.is_border_vertex(v);
  assert(QM::internal::Quad_straightening(quads, border, reference).run(visitor) == 0);
  assert(quads.points[inner] != before[inner] && quads.points[far_away] == before[far_away]);
  for(const std::array<int, 4>& c : quads.corners)
  {
    QM::internal::Shape_vector_3 normal;
    assert(QM::internal::minimal_scaled_jacobian(quads.points[c[0]], quads.points[c[1]], quads.points[c[2]],
                                                 quads.points[c[3]], normal) > 0);
  }
}

// ---- numbers of segments ----

void numbers_are_the_best_ones()
{
  const Layout layout = LM::t_layout();
  CGAL::Random random(9);
  for(int run = 0; run < 20; ++run)
  {
    std::vector<double> wanted;
    for(std::size_t a = 0; a < layout.arcs.size(); ++a)
      wanted.push_back(random.get_double(0.2, 4));
    QM::internal::Arc_quantization numbers(layout);
    assert(numbers.solve(wanted, QM::Rounding_method::BRANCH_AND_BOUND));
    auto cost = [&](const std::vector<int>& n)
    {
      double sum = 0;
      for(std::size_t a = 0; a < n.size(); ++a)
        sum += (n[a] - wanted[a]) * (n[a] - wanted[a]);
      return sum;
    };
    // the layout has four free numbers: the width of the left patch, that of the right ones, and their two heights
    double least = (std::numeric_limits<double>::infinity)();
    for(int w = 1; w < 8; ++w)
      for(int r = 1; r < 8; ++r)
        for(int low = 1; low < 8; ++low)
          for(int high = 1; high < 8; ++high)
            least = (std::min)(least, cost(LM::t_layout_numbers(w, r, low, high)));
    assert(std::abs(cost(numbers.number) - least) < 1e-9);
    // rounded free variables are never better
    QM::internal::Arc_quantization rounded(layout);
    if(rounded.solve(wanted, QM::Rounding_method::DIRECT))
      assert(cost(rounded.number) >= least - 1e-9);
  }
}

// Twelve equal arcs in three classes: from scale to scale all numbers of segments change at once, but the number of
// quads comes as near to a target as one segment more or less allows.
void numbers_of_quads_are_met()
{
  const Layout cube = LM::cube();
  for(double target = 100; target < 1000; target += 37)
  {
    QM::internal::Arc_quantization numbers(cube);
    assert(numbers.solve_for_quads(std::vector<double>(cube.arcs.size(), 7.3), target,
                                   QM::Rounding_method::BRANCH_AND_BOUND));
    double nearest = (std::numeric_limits<double>::infinity)();
    for(int n = 1; n < 20; ++n)
      for(const int quads : { 6 * n * n, 2 * (n * n + 2 * n * (n + 1)), 2 * ((n + 1) * (n + 1) + 2 * n * (n + 1)) })
        nearest = (std::min)(nearest, std::abs(std::log(quads / target)));
    const double defect = std::abs(std::log(numbers.number_of_quads() / target));
    assert(defect <= (std::max)(nearest + 1e-12, QM::internal::Arc_quantization::close_enough));
    for(const auto& patch : cube.patches)
      for(int k = 0; k < 2; ++k)
        assert(numbers.side_number(patch.sides[k]) == numbers.side_number(patch.sides[k + 2]));
  }
}

void numbers_that_cannot_be_are_refused()
{
  // a patch whose bottom is an arc, and whose top is the same arc and another one
  Layout layout = LM::rectangle(1, 1);
  layout.arcs.push_back(layout.arcs[0]);
  layout.patches[0].sides[2] = { Layout::Side_arc{ 0, false }, Layout::Side_arc{ 4, false } };
  QM::internal::Arc_quantization numbers(layout);
  assert(!numbers.solve(std::vector<double>(5, 3.), QM::Rounding_method::BRANCH_AND_BOUND));
  assert(!numbers.error.empty());
}

// ---- what is no layout ----

void errors_name_what_is_wrong()
{
  const Mesh tm = TM::make_mesh(TM::icosphere(2));
  const Layout good = LM::around(LM::cube_quads(), { { 1, 1, 1 } });
  auto message = [&](const std::function<void(Layout&)>& spoil, const std::string& part)
  {
    Layout layout = good;
    spoil(layout);
    Mesh qm;
    const Result result = QM::quadrangulate_layout(tm, layout, qm, params::target_number_of_quads(100));
    std::cout << "  " << result.message << std::endl;
    assert(result.status == Status::BAD_LAYOUT && qm.number_of_faces() == 0);
    assert(result.message.find(part) != std::string::npos);
  };
  message([](Layout& l) { l = Layout(); }, "no nodes");
  message([](Layout& l) { l.patches[2].sides[1].clear(); }, "patch 2 has no arc: a corner is missing");
  message([](Layout& l) { l.arcs[3].source = 99; }, "Arc 3 names a node");
  message([](Layout& l) { l.patches[1].sides[0][0].arc = 99; }, "Patch 1 names an arc");
  message([](Layout& l) { l.patches[4].sides[0][0].is_forward ^= true; }, "In patch 4");
  message([](Layout& l) { l.nodes[5].vertex = 100000; }, "Node 5 names a vertex");
  message([](Layout& l) { l.nodes[5].point[1] = std::nan(""); }, "Node 5");
  message([](Layout& l) { l.nodes[5] = l.nodes[2]; }, "Nodes 2 and 5 lie at the same vertex");
  message([](Layout& l) { l.patches.pop_back(); }, "does not lie on the border");
  message([](Layout& l) { l.patches.push_back(l.patches.back()); }, "lie on the same side of arc");
  message(
    [](Layout& l)
    {
      for(Layout::Patch& p : l.patches)
      {
        std::reverse(p.sides.begin(), p.sides.end());
        for(auto& side : p.sides)
          side[0].is_forward ^= true;
      }
    },
    "cannot be drawn");
  // two arcs whose ways cross
  const Mesh flat = TM::make_mesh(TM::grid(8, 8));
  Layout crossing = LM::rectangle(1, 1);
  crossing.patches.clear();
  crossing.arcs[0].target = 2;
  crossing.arcs[1] = crossing.arcs[0];
  crossing.arcs[1].source = 1;
  crossing.arcs[1].target = 3;
  Mesh qm;
  const Result result = QM::quadrangulate_layout(flat, crossing, qm);
  std::cout << "  " << result.message << std::endl;
  assert(result.status == Status::BAD_LAYOUT && result.message.find("crossing arc 0") != std::string::npos);
}

void bad_meshes_are_refused()
{
  Mesh qm;
  assert(QM::quadrangulate_layout(Mesh(), LM::rectangle(1, 1), qm).status == Status::BAD_MESH);
  Mesh tm = TM::make_mesh(TM::grid(2, 2));
  tm.point(*tm.vertices().begin()) = Point_3(std::nan(""), 0, 0);
  assert(QM::quadrangulate_layout(tm, LM::rectangle(1, 1), qm).status == Status::BAD_MESH);
  const Mesh good = TM::make_mesh(TM::grid(2, 2));
  assert(QM::quadrangulate_layout(good, LM::rectangle(1, 1), qm, params::target_edge_length(-1)).status ==
         Status::FAILED);
  assert(qm.number_of_faces() == 0);
}

// ---- files ----

void layouts_come_back_from_files()
{
  Layout layout = LM::t_layout();
  layout.arcs[1].is_aligned = true;
  layout.arcs[2].edge_length = 0.125;
  layout.arcs[0].way.push_back(LM::place(0.5, 0, 0));
  layout.arcs[0].way.push_back(Layout::Place());
  layout.arcs[0].way.back().vertex = 7;
  layout.patches[1].chart = QM::Layout_chart::UNIT;
  std::stringstream text;
  text.precision(17);
  QM::write_surface_layout(text, layout);
  Layout read;
  assert(QM::read_surface_layout(text, read).is_valid());
  std::stringstream again;
  again.precision(17);
  QM::write_surface_layout(again, read);
  assert(again.str() == text.str());
  assert(read.arcs[0].way[1].vertex == 7 && read.arcs[1].is_aligned && read.patches[1].chart == QM::Layout_chart::UNIT);

  auto refuses = [](const std::string& text, const std::string& part)
  {
    std::istringstream in(text);
    Layout layout;
    layout.nodes.resize(3);
    const QM::Layout_reading_result result = QM::read_surface_layout(in, layout);
    std::cout << "  " << result.message << std::endl;
    assert(result.status == QM::Layout_reading_status::MALFORMED && layout.nodes.size() == 3);
    assert(result.message.find(part) != std::string::npos);
  };
  const std::string nodes = "quad_layout 1\nnode 0 0 0\nnode vertex 4 # a comment\n";
  refuses("", "quad_layout 1");
  refuses("quad_layout 2\n", "Line 1");
  refuses(nodes + "node 1 2\n", "Line 4");
  refuses(nodes + "node 1 2 nan\n", "finite");
  refuses(nodes + "node vertex -1\n", "vertex");
  refuses(nodes + "arc 0 2\n", "names a node");
  refuses(nodes + "arc 0 1 bent\n", "bent");
  refuses(nodes + "arc 0 1 length 0\n", "positive");
  refuses(nodes + "arc 0 1\n\npatch +0 / +0 / +0\n", "Line 6: a patch has four sides");
  refuses(nodes + "arc 0 1\npatch +0 / +1 / +0 / +0\n", "names an arc");
  refuses(nodes + "arc 0 1\npatch 0 / +0 / +0 / +0\n", "direction");
  refuses(nodes + "arc 0 1\npatch +0 / +0 / +0 / +0 chart round\n", "round");
  refuses(nodes + "knot 0 1\n", "knot");
}

// Drawn curves, without patches: their arrangement is the layout, and the border of the mesh belongs to it.
void curves_are_a_layout()
{
  std::istringstream in("v -0.2 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0.5 0\nv 0.4 0.55 0\nv 1 0.4 0\nv 0.4 0 0\n"
                        "l 5 6 7\nl 8 6\nl 1 2 3 4 1\n");
  Layout layout;
  assert(QM::read_layout_curves(in, layout).is_valid());
  assert(layout.patches.empty());
  // the closed curve does not share the vertices 5, 7 and 8: it is an arc of its own, and crosses the others' ends
  assert(layout.nodes.size() == 5 && layout.arcs.size() == 4);
  std::istringstream second("v 0 0.5 0\nv 0.4 0.55 0\nv 1 0.4 0\nv 0.4 0 0\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                            "l 1 2 3\nl 4 2\nl 8 7\nl 5 4 6\n");
  Layout drawn;
  assert(QM::read_layout_curves(second, drawn).is_valid());
  const Mesh tm = TM::make_mesh(TM::grid(9, 9));
  Mesh qm;
  const Result result = QM::quadrangulate_layout(tm, drawn, qm, params::target_number_of_quads(200));
  check_mesh(qm, tm, result);
  // two patches below the curve, and one above it, with a T-vertex where the other curve ends
  assert(result.patches == 3 && result.t_vertices == 1 && result.arcs == 6 + 4);
}

// The base complex of a quad mesh is its layout, whatever the number of quads, and gives it back.
void base_complexes_are_layouts()
{
  const LM::Quad_soup soup = structure_meshes::sphere(4);
  const structure_meshes::Mesh sphere = structure_meshes::make_mesh(soup);
  const Layout layout = QM::layout_from_base_complex(sphere);
  assert(layout.nodes.size() == 8 && layout.arcs.size() == 12 && layout.patches.size() == 6);
  for(const Layout::Arc& a : layout.arcs)
    assert(a.way.size() == 3 && !a.is_aligned);
  const Mesh tm = TM::make_mesh(TM::icosphere(3));
  Mesh qm;
  const Result result = QM::quadrangulate_layout(tm, layout, qm, params::target_number_of_quads(600));
  check_mesh(qm, tm, result);
  assert(quad_mesh_checks::figures(qm).irregular_vertices() == 8);
  assert(QM::quad_mesh_structure(qm).number_of_patches == 6);

  // a feature that ends inside, and one that bends: both go straight on
  structure_meshes::Mesh plate = structure_meshes::make_mesh(structure_meshes::grid(6, 5));
  auto is_feature = plate.add_property_map<structure_meshes::Mesh::Edge_index, bool>("e:is_feature", false).first;
  auto mark = [&](int i, int j, int k, int l)
  {
    is_feature[plate.edge(plate.halfedge(structure_meshes::Mesh::Vertex_index(j * 7 + i),
                                         structure_meshes::Mesh::Vertex_index(l * 7 + k)))] = true;
  };
  mark(0, 2, 1, 2);
  mark(1, 2, 2, 2);
  mark(4, 5, 4, 4);
  mark(4, 4, 5, 4);
  const Layout cut = QM::layout_from_base_complex(plate, params::edge_is_constrained_map(is_feature));
  // the first one runs on up to a line of the second one, which goes on to the border in both directions
  std::size_t aligned = 0, t_vertices = 0;
  for(const Layout::Arc& a : cut.arcs)
    aligned += a.is_aligned;
  for(const Layout::Patch& p : cut.patches)
    for(const auto& side : p.sides)
      t_vertices += side.size() - 1;
  assert(aligned == 3 && cut.patches.size() == 4);
  const Mesh flat = TM::make_mesh(TM::grid(12, 10, 6, 5));
  Mesh quads;
  const Result on_plate = QM::quadrangulate_layout(flat, cut, quads, params::target_edge_length(0.5));
  check_mesh(quads, flat, on_plate);
  assert(on_plate.patches == cut.patches.size() && on_plate.t_vertices == t_vertices && on_plate.quads == 120);
  // a torus without irregular vertices has no base complex
  assert(
    QM::layout_from_base_complex(structure_meshes::make_mesh(structure_meshes::rolled(8, 6, 0, true))).patches.empty());
}

// A layout with T-vertices that was made by hand, as it is in a file: its tagged arcs are chains of quad edges, along
// the sharp edges and across smooth parts, at any density.
void a_car_gets_its_layout()
{
  const Mesh tm = car_body::make<Mesh>(1);
  Layout layout;
  std::istringstream text(car_body::layout());
  assert(QM::read_surface_layout(text, layout).is_valid());
  for(double quads : { 600., 2000. })
  {
    Mesh qm;
    auto is_aligned = qm.add_property_map<Mesh::Edge_index, bool>("e:is_aligned", false).first;
    const Result result = QM::quadrangulate_layout(
      tm, layout, qm, params::target_number_of_quads(quads).arc_alignment(QM::Arc_alignment::TAGGED),
      params::edge_is_constrained_map(is_aligned));
    std::cout << "  " << result.message << std::endl;
    check_mesh(qm, tm, result);
    assert(result.t_vertices == 12 && result.patches == 16 && result.aligned_arcs == 32);
    assert(std::abs(result.quads - quads) < 0.05 * quads);
    // every tagged arc has as many edges as segments; others may be aligned because of folds
    std::size_t tagged = 0;
    for(std::size_t a = 0; a < layout.arcs.size(); ++a)
      tagged += layout.arcs[a].is_aligned ? result.segments[a] : 0;
    std::size_t edges = 0;
    for(auto e : qm.edges())
      edges += is_aligned[e];
    assert(result.forced_arcs == 0 ? edges == tagged : edges >= tagged);
    // the upper edge of a window lies where it was drawn, from one node to the other
    double roof = 0;
    for(auto e : qm.edges())
    {
      const Point_3 &p = qm.point(qm.vertex(e, 0)), &q = qm.point(qm.vertex(e, 1));
      if(is_aligned[e] && p.z() > 0.5 && q.z() > 0.5 && std::abs(p.y() - 1) < 1e-9 && std::abs(q.y() - 1) < 1e-9)
        roof += std::sqrt(CGAL::squared_distance(p, q));
    }
    assert(std::abs(roof - 1) < 1e-9);
  }
}

void a_visitor_can_stop()
{
  const Mesh tm = TM::make_mesh(TM::icosphere(3));
  struct Stopper : QM::Default_visitor
  {
    int left;
    bool go_further() { return --left > 0; }
  };
  bool has_stopped = false, has_ended = false;
  for(int n = 1; n < 200 && !has_ended; n = 2 * n)
  {
    Stopper visitor;
    visitor.left = n;
    Mesh qm;
    const Result result = QM::quadrangulate_layout(tm, LM::around(LM::cube_quads(), { { 1, 1, 1 } }), qm,
                                                   params::target_number_of_quads(200).visitor(std::ref(visitor)));
    has_stopped = has_stopped || result.status == Status::STOPPED;
    has_ended = result.is_valid();
    assert(result.is_valid() || (result.status == Status::STOPPED && qm.number_of_faces() == 0));
  }
  assert(has_stopped && has_ended);
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "derivatives", derivatives_are_those_of_the_energy },
                     { "bilinear", bilinear_coordinates_come_back },
                     { "chart", chart_becomes_the_quadrilateral_that_is_mapped },
                     { "splits", splits_keep_the_surface },
                     { "arcs", arcs_are_short },
                     { "identity", one_patch_of_a_plane_is_mapped_by_the_identity },
                     { "sheared_cube", quadrilaterals_flatten_the_sheared_cube },
                     { "energies", energies_never_rise },
                     { "numbering", results_do_not_depend_on_numbers },
                     { "t_vertices", t_vertices_lie_on_samples },
                     { "torus", a_torus_of_one_patch },
                     { "cylinder", a_cylinder_with_two_borders },
                     { "features", features_are_kept },
                     { "untangling", untangling_leaves_no_fold },
                     { "straightening", inverted_quads_become_straight },
                     { "numbers", numbers_are_the_best_ones },
                     { "numbers_of_quads", numbers_of_quads_are_met },
                     { "impossible_numbers", numbers_that_cannot_be_are_refused },
                     { "errors", errors_name_what_is_wrong },
                     { "bad_meshes", bad_meshes_are_refused },
                     { "files", layouts_come_back_from_files },
                     { "curves", curves_are_a_layout },
                     { "base_complex", base_complexes_are_layouts },
                     { "car", a_car_gets_its_layout },
                     { "visitor", a_visitor_can_stop } });
}
