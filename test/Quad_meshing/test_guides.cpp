// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// What a user has drawn: whether the quad meshes have it, measured on them without the code that made them.

#include "quad_mesh_checks.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/local_feature_size.h>
#include <CGAL/Quad_meshing/Guides/cut_triangles.h>
#include <CGAL/Quad_meshing/Guides/mirror_triangles.h>
#include <CGAL/Quad_meshing/IO/read_number_rows.h>
#include <CGAL/Quad_meshing/IO/read_polylines.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>
#include <CGAL/Quad_meshing/quadrangulate.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

using namespace test_meshes;
namespace QM = CGAL::Quad_meshing;
namespace params = CGAL::parameters;
typedef Mesh::Face_index Face;
typedef Mesh::Vertex_index Vertex;

namespace {

double area_of(const Mesh& m, Face f)
{
  std::vector<Point_3> p;
  for(Vertex v : m.vertices_around_face(m.halfedge(f)))
    p.push_back(m.point(v));
  return std::sqrt(CGAL::cross_product(p[2] - p[0], p[3] - p[1]).squared_length()) / 2;
}

Point_3 center_of(const Mesh& m, Face f)
{
  Vector_3 sum(0, 0, 0);
  for(Vertex v : m.vertices_around_face(m.halfedge(f)))
    sum = sum + (m.point(v) - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum / static_cast<double>(m.degree(f));
}

bool is_valid(const Mesh& qm, const Mesh& tm)
{
  const auto q = quad_mesh_checks::figures(qm);
  return q.is_valid() && q.is_simple() && q.same_topology(quad_mesh_checks::figures(tm));
}

// The mean length of the edges of quads in a part of the surface.
template <typename Inside>
double mean_length(const Mesh& qm, const Inside& inside)
{
  double area = 0;
  int n = 0;
  for(Face f : qm.faces())
    if(inside(center_of(qm, f)))
    {
      area += area_of(qm, f);
      ++n;
    }
  assert(n > 0);
  return std::sqrt(area / n);
}

// Half of a sphere with quads of a third of the length of those of the other half.
void test_painted_sizes()
{
  const Mesh tm = make_mesh(icosphere(5));
  std::map<Face, double> length;
  std::map<Vertex, double> vertex_length;
  for(Face f : tm.faces())
    length[f] = CGAL::centroid(tm.point(tm.source(tm.halfedge(f))), tm.point(tm.target(tm.halfedge(f))),
                               tm.point(tm.target(tm.next(tm.halfedge(f)))))
                      .z() > 0
                  ? 1
                  : 3;
  for(Vertex v : tm.vertices())
    vertex_length[v] = tm.point(v).z() > 0 ? 1 : 3;
  for(int kind = 0; kind < 2; ++kind)
  {
    Mesh qm;
    const auto r =
      kind == 0
        ? QM::quadrangulate(
            tm, qm, params::face_sizing_map(boost::make_assoc_property_map(length)).target_number_of_quads(3000))
        : QM::quadrangulate(
            tm, qm,
            params::vertex_sizing_map(boost::make_assoc_property_map(vertex_length)).target_number_of_quads(3000));
    std::cout << r.message << std::endl;
    assert(r.is_valid() && is_valid(qm, tm));
    assert(std::abs(static_cast<double>(qm.number_of_faces()) / 3000 - 1) < 0.1);
    const double above = mean_length(qm, [](const Point_3& p) { return p.z() > 0.1; });
    const double below = mean_length(qm, [](const Point_3& p) { return p.z() < -0.7; }); // where the slope allows it
    std::cout << "lengths " << above << " and " << below << std::endl;
    assert(below / above > 3 / 1.15 && below / above < 3 * 1.15);
  }
  // With an edge length, lengths are what they are.
  for(auto& l : length)
    l.second *= 0.05;
  Mesh qm;
  const auto r =
    QM::quadrangulate(tm, qm, params::face_sizing_map(boost::make_assoc_property_map(length)).target_edge_length(0.1));
  assert(r.is_valid() && is_valid(qm, tm));
  const double above = mean_length(qm, [](const Point_3& p) { return p.z() > 0.1; });
  assert(above > 0.05 / 1.15 && above < 0.05 * 1.15);
  // Not a number.
  length.begin()->second = std::numeric_limits<double>::quiet_NaN();
  assert(QM::quadrangulate(tm, qm, params::face_sizing_map(boost::make_assoc_property_map(length))).status ==
         QM::Quadrangulation_status::INVALID_INPUT);
}

// Around a point of a cube of twelve triangles a side, lengths that these triangles are much too large for.
void test_discs()
{
  const Mesh tm = make_mesh(cube(1));
  QM::Size_disc disc;
  disc.center = Point_3(0.5, 0.5, 1);
  disc.radius = 0.2;
  disc.length = 0.02;
  Mesh qm;
  const auto r =
    QM::quadrangulate(tm, qm, params::size_discs(std::vector<QM::Size_disc>(1, disc)).target_number_of_quads(2500));
  std::cout << r.message << std::endl;
  assert(r.is_valid() && is_valid(qm, tm));
  assert(std::abs(static_cast<double>(qm.number_of_faces()) / 2500 - 1) < 0.1);
  const double inside =
    mean_length(qm, [&](const Point_3& p) { return CGAL::squared_distance(p, disc.center) < 0.15 * 0.15; });
  const double outside = mean_length(qm, [](const Point_3& p) { return p.z() < 0.2; });
  std::cout << "lengths " << inside << " and " << outside << std::endl;
  assert(inside > 0.02 / 1.2 && inside < 0.02 * 1.2 && outside > 1.5 * inside);
  disc.radius = -1;
  assert(QM::quadrangulate(tm, qm, params::size_discs(std::vector<QM::Size_disc>(1, disc))).status ==
         QM::Quadrangulation_status::INVALID_INPUT);
}

// A torus bends more inside than outside; an ellipsoid's tips are thinner than its middle.
void test_sizing_methods()
{
  {
    const double t = 0.002;
    const Mesh tm = make_mesh(mapped(icosphere(5), [](const Point_3& p) { return Point_3(3 * p.x(), p.y(), p.z()); }));
    Mesh qm;
    const auto r = QM::quadrangulate(tm, qm,
                                     params::sizing_method(QM::Sizing_method::CURVATURE)
                                       .sizing_tolerance(t)
                                       .largest_edge_length(1.)
                                       .smallest_edge_length(0.02));
    std::cout << r.message << std::endl;
    assert(r.is_valid() && is_valid(qm, tm));
    // How far the middles of edges are inside of the ellipsoid.
    int n = 0;
    double sum = 0;
    for(auto e : qm.edges())
    {
      const Point_3 m = CGAL::midpoint(qm.point(qm.vertex(e, 0)), qm.point(qm.vertex(e, 1)));
      const Vector_3 gradient(2 * m.x() / 9, 2 * m.y(), 2 * m.z());
      const double value = 1 - (m.x() * m.x() / 9 + m.y() * m.y() + m.z() * m.z());
      ++n;
      sum += value / std::sqrt(gradient.squared_length());
    }
    std::cout << "edges leave the surface by " << sum / n << " on average" << std::endl;
    assert(sum / n < t && sum / n > t / 4);
  }
  {
    // A dumbbell: the bar is a third as thick as the balls.
    const Mesh tm = make_mesh(mapped(icosphere(6),
                                     [](const Point_3& p)
                                     {
                                       const double x = p.x(), s = 0.3 + 0.7 * std::pow(std::abs(x), 2);
                                       return Point_3(3 * x, s * p.y(), s * p.z());
                                     }));
    auto size = [&](const Mesh& m)
    {
      std::map<Face, double> result;
      assert(QM::local_feature_size(m, boost::make_assoc_property_map(result)).is_valid());
      return result;
    }(tm);
    for(const auto& f : size)
    {
      const auto h = tm.halfedge(f.first);
      if(std::abs(tm.point(tm.source(h)).x()) < 0.1)
        assert(f.second > 0.25 && f.second < 0.4);
    }
    Mesh qm;
    const auto r =
      QM::quadrangulate(tm, qm, params::sizing_method(QM::Sizing_method::FEATURE_SIZE).target_number_of_quads(3000));
    std::cout << r.message << std::endl;
    assert(r.is_valid() && is_valid(qm, tm));
    assert(std::abs(static_cast<double>(qm.number_of_faces()) / 3000 - 1) < 0.1);
    assert(mean_length(qm, [](const Point_3& p) { return std::abs(p.x()) < 0.5; }) <
           0.8 * mean_length(qm, [](const Point_3& p) { return std::abs(p.x()) > 1.8 && std::abs(p.x()) < 2.4; }));
  }
}

// The share of a curve, given by points close together, that lies on edges of quads.
template <typename Points>
double share_on_edges(const Mesh& qm, const Points& points, double largest_distance)
{
  typedef QM::internal::Aabb_segment_primitive<Kernel, std::vector<Kernel::Segment_3>::const_iterator> Primitive;
  std::vector<Kernel::Segment_3> edges;
  for(auto e : qm.edges())
    edges.emplace_back(qm.point(qm.vertex(e, 0)), qm.point(qm.vertex(e, 1)));
  const CGAL::AABB_tree<QM::internal::Aabb_traits<Kernel, Primitive>> tree(edges.cbegin(), edges.cend());
  double on = 0, all = 0;
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const double l = std::sqrt(CGAL::squared_distance(points[i], points[i + 1]));
    all += l;
    const auto nearest = tree.closest_point_and_primitive(CGAL::midpoint(points[i], points[i + 1]));
    const Vector_3 along = points[i + 1] - points[i], edge = nearest.second->to_vector();
    const double cosine = std::abs(along * edge) / std::sqrt(along.squared_length() * edge.squared_length());
    if(CGAL::squared_distance(nearest.first, CGAL::midpoint(points[i], points[i + 1])) <
         largest_distance * largest_distance &&
       cosine > 0.9)
      on += l;
  }
  return on / all;
}

// Curves on a plate: across triangles, closed, and crossing each other.
void test_curves()
{
  const Mesh tm = make_mesh(grid(23, 23));
  std::vector<QM::Guide_curve> curves(3);
  for(int i = 0; i <= 200; ++i)
  {
    const double t = i / 200.;
    curves[0].points.emplace_back(0.1 + 0.8 * t, 0.3 + 0.15 * std::sin(3 * t), 0);
    curves[1].points.emplace_back(0.45 + 0.1 * t, 0.05 + 0.9 * t, 0);
  }
  for(int i = 0; i < 100; ++i)
    curves[2].points.emplace_back(0.5 + 0.2 * std::cos(CGAL_PI * i / 50), 0.68 + 0.2 * std::sin(CGAL_PI * i / 50), 0);
  curves[2].is_closed = true;
  Mesh qm;
  const auto r = QM::quadrangulate(tm, qm, params::feature_curves(curves).target_number_of_quads(900));
  std::cout << r.message << std::endl;
  assert(r.is_valid() && r.unmet_guides.empty() && is_valid(qm, tm));
  for(QM::Guide_curve c : curves)
  {
    if(c.is_closed)
      c.points.push_back(c.points.front());
    const double share = share_on_edges(qm, c.points, 0.1 / 30); // a tenth of an edge: chords of bent curves
    std::cout << share << " of a curve on edges" << std::endl;
    assert(share > 0.99);
  }
  // The crossing is a vertex of the quads.
  double nearest = 1;
  for(Vertex v : qm.vertices())
    nearest =
      (std::min)(nearest, std::abs(qm.point(v).y() - (0.3 + 0.15 * std::sin(3 * (qm.point(v).x() - 0.1) / 0.8))) +
                            std::abs(qm.point(v).x() - 0.45 - (qm.point(v).y() - 0.05) / 9));
  assert(nearest < 1e-3);

  // Curves that are none.
  QM::Guide_curve point;
  point.points.emplace_back(0.5, 0.5, 0);
  const auto none = QM::quadrangulate(
    tm, qm, params::feature_curves(std::vector<QM::Guide_curve>(1, point)).target_number_of_quads(100));
  assert(none.is_valid() && none.unmet_guides.size() == 1 && !none.is_as_requested &&
         none.message.find("curve 1") != std::string::npos);
}

// Triangles that are cut along curves cover the same surface, and keep its sides.
void test_cutting()
{
  const Soup soup = perturbed(icosphere(2), 0.02);
  const Mesh tm = make_mesh(soup);
  QM::internal::Guided_triangles input;
  for(const auto& p : soup.points)
    input.points.push_back(p);
  for(const auto& f : soup.triangles)
    input.triangles.push_back({ { static_cast<int>(f[0]), static_cast<int>(f[1]), static_cast<int>(f[2]) } });
  // Three lines through one triangle, two of which cross, and one along a side.
  std::vector<std::vector<QM::internal::Triangle_place>> curves = {
    { { 0, { { 0.5, 0.5, 0 } } }, { 0, { { 0.2, 0.3, 0.5 } } }, { 0, { { 0, 0.3, 0.7 } } } },
    { { 0, { { 0.6, 0, 0.4 } } }, { 0, { { 0, 0.6, 0.4 } } } },
    { { 0, { { 1, 0, 0 } } }, { 0, { { 0.3, 0.7, 0 } } } }
  };
  const QM::internal::Cut_triangles cut = QM::internal::cut_triangles(input, curves);
  assert(cut.error.empty() && cut.triangles.size() > input.triangles.size());
  double area = 0, area_before = 0, curve_length = 0;
  std::map<std::pair<int, int>, int> sides;
  for(std::size_t i = 0; i < cut.triangles.size(); ++i)
  {
    const auto& t = cut.triangles[i];
    area += std::sqrt(Kernel::Triangle_3(cut.points[t[0]], cut.points[t[1]], cut.points[t[2]]).squared_area());
    for(int k = 0; k < 3; ++k)
    {
      ++sides[{ t[k], t[(k + 1) % 3] }];
      if(cut.is_curve[i][k])
        curve_length += std::sqrt(CGAL::squared_distance(cut.points[t[k]], cut.points[t[(k + 1) % 3]])) / 2;
    }
  }
  for(Face f : tm.faces())
    area_before += CGAL::Polygon_mesh_processing::face_area(f, tm);
  assert(std::abs(area - area_before) < 1e-9 * area_before);
  for(const auto& s : sides) // closed and oriented as before
    assert(s.second == 1 && sides.count({ s.first.second, s.first.first }) == 1);
  double drawn = 0;
  auto at = [&](const QM::internal::Triangle_place& p)
  {
    const auto& t = input.triangles[p.triangle];
    return CGAL::barycenter(input.points[t[0]], p.weight[0], input.points[t[1]], p.weight[1], input.points[t[2]],
                            p.weight[2]);
  };
  for(const auto& c : curves)
    for(std::size_t i = 0; i + 1 < c.size(); ++i)
      drawn += std::sqrt(CGAL::squared_distance(at(c[i]), at(c[i + 1])));
  assert(std::abs(curve_length - drawn) < 1e-3 * drawn);
}

// The mean angle, in degrees, between a line and the quads that it runs over.
template <typename Points>
double deviation_along(const Mesh& qm, const Points& points)
{
  double sum = 0;
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const Point_3 p = CGAL::midpoint(points[i], points[i + 1]);
    Face nearest = *qm.faces().begin();
    for(Face f : qm.faces())
      if(CGAL::squared_distance(center_of(qm, f), p) < CGAL::squared_distance(center_of(qm, nearest), p))
        nearest = f;
    std::vector<Point_3> c;
    for(Vertex v : qm.vertices_around_face(qm.halfedge(nearest)))
      c.push_back(qm.point(v));
    const Vector_3 u = (c[1] - c[0]) + (c[2] - c[3]), v = (c[2] - c[1]) + (c[3] - c[0]),
                   along = points[i + 1] - points[i];
    double best = 90;
    for(const Vector_3& d : { u, v })
      best = (std::min)(
        best, std::acos((std::min)(1., std::abs(d * along) / std::sqrt(d.squared_length() * along.squared_length()))) *
                180 / CGAL_PI);
    sum += best;
  }
  return sum / static_cast<double>(points.size() - 1);
}

// A great circle of a sphere that is inclined to everything; soft and hard.
void test_strokes()
{
  const Mesh tm = make_mesh(icosphere(4));
  QM::Guide_stroke stroke;
  for(int i = 0; i <= 60; ++i)
  {
    const double a = 0.3 + 2.2 * i / 60, b = 0.4;
    stroke.points.emplace_back(std::cos(a), std::sin(a) * std::cos(b), std::sin(a) * std::sin(b));
  }
  for(double weight : { QM::Guide_stroke().weight, std::numeric_limits<double>::infinity() })
  {
    stroke.weight = weight;
    Mesh qm;
    const auto r =
      QM::quadrangulate(tm, qm, params::strokes(std::vector<QM::Guide_stroke>(1, stroke)).target_number_of_quads(1500));
    const double d = deviation_along(qm, stroke.points);
    std::cout << r.message << " " << d << " degrees" << std::endl;
    assert(r.is_valid() && r.unmet_guides.empty() && is_valid(qm, tm) && d < 3);
  }
  // A stroke at 45 degrees to the sides of a square that it cannot turn: the answer says so.
  const Mesh plate = make_mesh(grid(4, 40, 0.1, 1));
  QM::Guide_stroke slanted;
  slanted.points = { Point_3(0, 0.45, 0), Point_3(0.1, 0.55, 0) };
  slanted.weight = 1e-3;
  Mesh qm;
  const auto r = QM::quadrangulate(
    plate, qm, params::strokes(std::vector<QM::Guide_stroke>(1, slanted)).target_number_of_quads(160));
  std::cout << r.message << std::endl;
  assert(r.is_valid() && r.unmet_guides.size() == 1 && r.message.find("stroke 1") != std::string::npos);
}

// Whether the vertices are mirrored onto each other, exactly.
bool is_symmetric(const Mesh& qm, int axis, double center)
{
  std::map<std::array<double, 3>, int> count;
  for(Vertex v : qm.vertices())
    ++count[{ { qm.point(v).x(), qm.point(v).y(), qm.point(v).z() } }];
  for(const auto& p : count)
  {
    std::array<double, 3> q = p.first;
    q[axis] = 2 * center - q[axis];
    const auto found = count.find(q);
    if(found == count.end() || found->second != p.second)
      return false;
  }
  return true;
}

void test_symmetry()
{
  {
    // An ellipsoid whose mesh is not symmetric, in one to three planes.
    const Mesh tm =
      make_mesh(mapped(icosphere(4), [](const Point_3& p) { return Point_3(2 * p.x(), 1.5 * p.y(), p.z()); }));
    std::vector<QM::Symmetry_plane> planes;
    for(int n = 0; n < 3; ++n)
    {
      planes.push_back(QM::Symmetry_plane::with_normal(n == 0, n == 1, n == 2));
      Mesh qm;
      const auto r = QM::quadrangulate(tm, qm, params::symmetry_planes(planes).target_number_of_quads(1000));
      std::cout << r.message << std::endl;
      assert(r.is_valid() && is_valid(qm, tm) && r.quads == qm.number_of_faces());
      for(int c = 0; c <= n; ++c)
        assert(is_symmetric(qm, c, 0));
      assert(std::abs(static_cast<double>(qm.number_of_faces()) / 1000 - 1) < 0.15);
    }
  }
  {
    // A cube: its edges cross the planes. Locations are told on the whole of it.
    const Mesh tm = make_mesh(cube(5));
    const std::vector<QM::Symmetry_plane> planes = { QM::Symmetry_plane::with_normal(1, 0, 0),
                                                     QM::Symmetry_plane::with_normal(0, 1, 0),
                                                     QM::Symmetry_plane::with_equation(0, 0, 2, -1) };
    Mesh qm;
    std::map<Vertex, std::pair<Face, std::array<double, 3>>> location;
    const auto r = QM::quadrangulate(tm, qm,
                                     params::symmetry_planes(planes).target_number_of_quads(600).face_location_map(
                                       boost::make_assoc_property_map(location)));
    std::cout << r.message << std::endl;
    assert(r.is_valid() && is_valid(qm, tm));
    for(int c = 0; c < 3; ++c)
      assert(is_symmetric(qm, c, 0.5));
    for(const auto& l : location)
    {
      std::array<Point_3, 3> t;
      auto h = tm.halfedge(l.second.first);
      for(int k = 0; k < 3; ++k, h = tm.next(h))
        t[k] = tm.point(tm.source(h));
      assert(CGAL::squared_distance(
               CGAL::barycenter(t[0], l.second.second[0], t[1], l.second.second[1], t[2], l.second.second[2]),
               qm.point(l.first)) < 1e-12);
    }
  }
  {
    // The plane of a turned shape is found; without one, the deviation is told.
    const Mesh tm = make_mesh(mapped(icosphere(4),
                                     [](const Point_3& p)
                                     {
                                       // symmetric to x = 0 only, then turned
                                       const double x = p.x(), y = p.y() + 0.4 * p.z() * p.z(),
                                                    z = 1.6 * p.z() + 0.3 * y * y;
                                       return Point_3(0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, z);
                                     }));
    Mesh qm;
    const auto r = QM::quadrangulate(
      tm, qm, params::symmetry_planes(std::vector<QM::Symmetry_plane>(1)).target_number_of_quads(800));
    std::cout << r.message << std::endl;
    assert(r.is_valid() && is_valid(qm, tm));
    const Vector_3 n(0.6, 0.8, 0);
    int mirrored = 0;
    for(Vertex v : qm.vertices())
    {
      const Vector_3 p = qm.point(v) - CGAL::ORIGIN, q = p - 2 * (p * n) * n;
      for(Vertex w : qm.vertices())
        if((qm.point(w) - CGAL::ORIGIN - q).squared_length() < 1e-4)
        {
          ++mirrored;
          break;
        }
    }
    assert(mirrored == static_cast<int>(qm.number_of_vertices()));
    const Mesh crooked = make_mesh(mapped(icosphere(3),
                                          [](const Point_3& p)
                                          {
                                            return Point_3(p.x() + 0.3 * p.y() * p.z() + 0.2 * p.z() * p.z(),
                                                           1.3 * p.y() + 0.3 * p.x() * p.x(), 1.7 * p.z());
                                          }));
    const auto refused = QM::quadrangulate(
      crooked, qm,
      params::symmetry_planes(std::vector<QM::Symmetry_plane>(1, QM::Symmetry_plane::with_normal(1, 0, 0))));
    std::cout << refused.message << std::endl;
    assert(refused.status == QM::Quadrangulation_status::REFUSED &&
           refused.message.find("percent") != std::string::npos);
    const auto slanted =
      QM::quadrangulate(make_mesh(icosphere(3)), qm,
                        params::symmetry_planes(std::vector<QM::Symmetry_plane>{
                          QM::Symmetry_plane::with_normal(1, 0, 0), QM::Symmetry_plane::with_normal(1, 1, 0) }));
    assert(slanted.status == QM::Quadrangulation_status::REFUSED);
  }
}

// The index, in quarters, of the vertex nearest to a point.
int index_at(const Mesh& qm, const Point_3& p)
{
  Vertex nearest = *qm.vertices().begin();
  for(Vertex v : qm.vertices())
    if(CGAL::squared_distance(qm.point(v), p) < CGAL::squared_distance(qm.point(nearest), p))
      nearest = v;
  return 4 - static_cast<int>(qm.degree(nearest));
}

QM::Index_guide index_guide(const Point_3& p, int index, double radius = 0)
{
  QM::Index_guide g;
  g.point = p;
  g.index = index;
  g.radius = radius;
  return g;
}

void test_indices()
{
  {
    // Eight vertices of three quads on a sphere, at the corners of a box.
    const Mesh tm = make_mesh(icosphere(4));
    std::vector<QM::Index_guide> guides;
    for(int i = 0; i < 8; ++i)
    {
      const Vector_3 v(i % 2 == 0 ? 0.4 : -0.4, i / 2 % 2 == 0 ? 0.5 : -0.5, i / 4 == 0 ? 0.77 : -0.77);
      guides.push_back(index_guide(CGAL::ORIGIN + v / std::sqrt(v.squared_length()), 1));
    }
    Mesh qm;
    const auto r = QM::quadrangulate(tm, qm, params::index_guides(guides).target_number_of_quads(1500));
    std::cout << r.message << std::endl;
    assert(r.is_valid() && r.unmet_guides.empty() && is_valid(qm, tm));
    for(const QM::Index_guide& g : guides)
      assert(index_at(qm, g.point) == 1);
    assert(quad_mesh_checks::figures(qm).irregular_vertices() == 8);
  }
  {
    // One vertex of three quads and one of five on a torus, and a region without any.
    const Mesh tm = make_mesh(torus(80, 40, 1, 0.4));
    std::vector<QM::Index_guide> guides = { index_guide(Point_3(1.4, 0, 0), 1), index_guide(Point_3(-1.4, 0, 0), -1),
                                            index_guide(Point_3(0, 1.4, 0), 0, 0.5) };
    Mesh qm;
    const auto r = QM::quadrangulate(tm, qm, params::index_guides(guides).target_number_of_quads(2000));
    std::cout << r.message << std::endl;
    assert(r.is_valid() && r.unmet_guides.empty() && is_valid(qm, tm));
    assert(index_at(qm, guides[0].point) == 1 && index_at(qm, guides[1].point) == -1);
    for(Vertex v : qm.vertices())
      if(CGAL::squared_distance(qm.point(v), guides[2].point) < 0.25)
        assert(qm.degree(v) == 4);
  }
  {
    // Nowhere at all, on a torus and on a sphere, where eight quarters are missing.
    auto forbidden = [](const Mesh& tm)
    {
      auto angle = std::vector<double>(tm.number_of_faces());
      auto jump = std::vector<int>(tm.number_of_edges()), index = std::vector<int>(tm.number_of_vertices());
      const std::vector<std::optional<int>> wish(tm.number_of_vertices(), 0);
      auto map = [](auto& v, auto tag, const Mesh& m)
      { return boost::make_iterator_property_map(v.begin(), get(tag, m)); };
      return QM::smooth_cross_field(
        tm, map(angle, boost::face_index, tm), map(jump, boost::edge_index, tm), map(index, boost::vertex_index, tm),
        params::prescribed_index_map(map(wish, boost::vertex_index, tm)).target_edge_length(0.1));
    };
    const QM::Cross_field_result t = forbidden(make_mesh(perturbed(torus(40, 20), 0.02)));
    assert(t.singularities == 0 && t.unmet_prescriptions == 0);
    const QM::Cross_field_result s = forbidden(make_mesh(icosphere(3)));
    assert(s.unmet_prescriptions > 0 && s.index_sum == 8);
  }
  {
    // Two wishes for one place.
    const Mesh tm = make_mesh(icosphere(3));
    Mesh qm;
    const auto r =
      QM::quadrangulate(tm, qm,
                        params::index_guides(std::vector<QM::Index_guide>{ index_guide(Point_3(0, 0, 1), 1),
                                                                           index_guide(Point_3(0, 0, 1), 0) })
                          .target_number_of_quads(400));
    std::cout << r.message << std::endl;
    assert(r.is_valid() && !r.is_as_requested && r.message.find("index 1 and index 2") != std::string::npos);
    assert(
      QM::quadrangulate(tm, qm, params::index_guides(std::vector<QM::Index_guide>(1, index_guide(Point_3(0, 0, 1), 4))))
        .status == QM::Quadrangulation_status::INVALID_INPUT);
  }
}

int sum_of_indices(const Mesh& qm, const Point_3& p, double radius)
{
  int sum = 0;
  for(Vertex v : qm.vertices())
    if(CGAL::squared_distance(qm.point(v), p) <= radius * radius)
      sum += 4 - static_cast<int>(qm.degree(v));
  return sum;
}

// Sums in regions of a closed surface: more and less than there would be, and none at all.
void test_index_sums()
{
  const Mesh ball = make_mesh(icosphere(4)), ring = make_mesh(torus(80, 40, 1, 0.4));
  struct Wish
  {
    const Mesh* mesh;
    Point_3 point;
    double radius;
    int sum;
  };
  for(const Wish& w : { Wish{ &ball, Point_3(0, 0, 1), 0.9, 6 }, Wish{ &ball, Point_3(0, 0, 1), 0.9, 0 },
                        Wish{ &ball, Point_3(0.6, 0, 0.8), 0.7, -1 }, Wish{ &ring, Point_3(1.4, 0, 0), 0.6, 2 },
                        Wish{ &ring, Point_3(1.4, 0, 0), 0.6, -2 } })
  {
    QM::Index_guide g = index_guide(w.point, w.sum, w.radius);
    g.is_sum = true;
    Mesh qm;
    const auto r = QM::quadrangulate(
      *w.mesh, qm, params::index_guides(std::vector<QM::Index_guide>(1, g)).target_number_of_quads(1800));
    std::cout << "sum " << w.sum << ": " << r.message << std::endl;
    assert(r.is_valid() && is_valid(qm, *w.mesh));
    assert(r.unmet_guides.empty() && sum_of_indices(qm, w.point, w.radius) == w.sum);
  }
  // A region that is the whole surface: the sum is known before.
  QM::Index_guide all = index_guide(Point_3(0, 0, 1), 5, 10);
  all.is_sum = true;
  Mesh qm;
  const auto r =
    QM::quadrangulate(ball, qm, params::index_guides(std::vector<QM::Index_guide>(1, all)).target_number_of_quads(500));
  std::cout << r.message << std::endl;
  assert(r.status == QM::Quadrangulation_status::REFUSED && r.message.find("3 are missing") != std::string::npos);
  all.radius = -1;
  assert(QM::quadrangulate(ball, qm, params::index_guides(std::vector<QM::Index_guide>(1, all))).status ==
         QM::Quadrangulation_status::INVALID_INPUT);
}

// Random wishes, on surfaces of genus 0 and 1: each is met, or the answer names it; if all indices are prescribed and
// do not sum up to what the surface needs, there is no mesh, and the answer says how much is missing.
void test_random_indices()
{
  std::mt19937 random(7);
  auto number = [&](double low, double high)
  { return low + (high - low) * static_cast<double>(random() % 100000) / 100000; };
  int refused = 0, met = 0, unmet = 0;
  for(int trial = 0; trial < 12; ++trial)
  {
    const bool is_ball = trial % 2 == 0, are_all_prescribed = trial % 3 == 0;
    const Mesh tm =
      is_ball
        ? make_mesh(mapped(icosphere(4), [](const Point_3& p) { return Point_3(1.5 * p.x(), p.y(), 0.8 * p.z()); }))
        : make_mesh(torus(80, 40, 1, 0.4));
    std::vector<QM::Index_guide> guides;
    int sum = 0, irregular = 0;
    const std::size_t wanted = 1 + random() % 6;
    while(guides.size() < wanted)
    {
      const Vertex v(static_cast<Mesh::size_type>(random() % tm.number_of_vertices()));
      const bool is_near =
        std::any_of(guides.begin(), guides.end(),
                    [&](const QM::Index_guide& g) { return CGAL::squared_distance(g.point, tm.point(v)) < 0.36; });
      if(is_near)
        continue;
      const int index = std::array<int, 4>{ { 1, 1, -1, 0 } }[random() % 4];
      guides.push_back(index_guide(tm.point(v), index, index == 0 ? number(0.1, 0.3) : 0.));
      guides.back().name = "wish " + std::to_string(guides.size());
      sum += index;
      irregular += index != 0;
    }
    if(are_all_prescribed)
      guides.push_back(index_guide(guides.front().point, 0, std::numeric_limits<double>::infinity()));
    Mesh qm;
    const auto r = QM::quadrangulate(tm, qm, params::index_guides(guides).target_number_of_quads(2000));
    std::cout << (is_ball ? "ball, " : "ring, ") << wanted << (are_all_prescribed ? " alone: " : ": ") << r.message
              << std::endl;
    const int needed = is_ball ? 8 : 0;
    if(are_all_prescribed && sum != needed)
    {
      ++refused;
      assert(r.status == QM::Quadrangulation_status::REFUSED);
      assert(r.message.find(std::to_string(std::abs(needed - sum)) +
                            (needed > sum ? " are missing" : " are too many")) != std::string::npos);
      continue;
    }
    if(are_all_prescribed && !is_ball && irregular == 2) // of index 1 and -1: there is no such mesh of a torus
    {
      ++refused;
      assert(r.status == QM::Quadrangulation_status::REFUSED && r.message.find("torus") != std::string::npos);
      continue;
    }
    assert(r.is_valid() && is_valid(qm, tm));
    for(std::size_t i = 0; i < wanted; ++i)
    {
      const QM::Index_guide& g = guides[i];
      bool is_met = index_at(qm, g.point) == g.index;
      if(g.index == 0)
      {
        is_met = true;
        for(Vertex v : qm.vertices())
          is_met = is_met && (qm.degree(v) == 4 || CGAL::squared_distance(qm.point(v), g.point) >= g.radius * g.radius);
      }
      const std::string name = "wish " + std::to_string(i + 1);
      const bool is_named =
        std::any_of(r.unmet_guides.begin(), r.unmet_guides.end(),
                    [&](const std::string& s) { return (s + " ").find(name + " ") != std::string::npos; });
      assert(is_met != is_named);
      ++(is_met ? met : unmet);
    }
  }
  std::cout << met << " met, " << unmet << " told, " << refused << " refused" << std::endl;
  assert(refused > 0 && met > 8 * unmet);
}

// The number of edges of the straight chain from the vertex nearest to p to that nearest to q; 0 if there is none.
int straight_chain(const Mesh& qm, const Point_3& p, const Point_3& q)
{
  auto nearest = [&](const Point_3& x)
  {
    return *std::min_element(qm.vertices().begin(), qm.vertices().end(),
                             [&](Vertex a, Vertex b) {
                               return CGAL::squared_distance(qm.point(a), x) < CGAL::squared_distance(qm.point(b), x);
                             });
  };
  const Vertex from = nearest(p), to = nearest(q);
  for(Mesh::Halfedge_index in : qm.halfedges_around_target(qm.halfedge(from)))
  {
    Mesh::Halfedge_index h = qm.opposite(in);
    int steps = 1;
    // the edge that leaves a vertex of four quads opposite to the one that came
    for(; qm.target(h) != to && qm.degree(qm.target(h)) == 4 && steps < 1000; ++steps)
      h = qm.next(qm.opposite(qm.next(h)));
    if(qm.target(h) == to)
      return steps;
  }
  return 0;
}

// Pairs of placed irregular vertices, joined by separatrices; a vertex and the border of a square.
void test_connections()
{
  {
    const Mesh tm =
      make_mesh(mapped(icosphere(4), [](const Point_3& p) { return Point_3(1.4 * p.x(), p.y(), p.z()); }));
    std::vector<QM::Index_guide> guides;
    for(int i = 0; i < 8; ++i)
    {
      const Vector_3 v(i % 2 == 0 ? 0.55 : -0.6, i / 2 % 2 == 0 ? 0.5 : -0.45, i / 4 == 0 ? 0.77 : -0.7);
      const Vector_3 u = v / std::sqrt(v.squared_length());
      guides.push_back(index_guide(Point_3(1.4 * u.x(), u.y(), u.z()), 1));
    }
    QM::Quadrangulation q(tm, tm.points());
    q.options.index_guides = guides;
    q.options.target_number_of_quads = 1500;
    for(const auto& pair : { std::make_pair(0, 1), std::make_pair(2, 6), std::make_pair(5, 7) })
    {
      QM::Guide_connection c;
      c.from = guides[std::size_t(pair.first)].point;
      c.to = guides[std::size_t(pair.second)].point;
      q.options.connections.push_back(c);
    }
    const auto r = q.run();
    std::cout << r.message << std::endl;
    assert(r.is_valid() && r.unmet_guides.empty() && is_valid(q.quads().mesh, tm));
    for(const QM::Guide_connection& c : q.options.connections)
    {
      const int n = straight_chain(q.quads().mesh, c.from, c.to);
      std::cout << "a chain of " << n << " edges" << std::endl;
      assert(n > 3 && index_at(q.quads().mesh, c.from) == 1 && index_at(q.quads().mesh, c.to) == 1);
    }
  }
  {
    // Without a vertex to be joined with: a point of its own is a vertex as well, and the border is met.
    const Mesh tm = make_mesh(grid(20, 20));
    QM::Quadrangulation q(tm, tm.points());
    q.options.target_number_of_quads = 200;
    q.options.connections.resize(1);
    q.options.connections[0].from = Point_3(0.53, 0.52, 0);
    q.options.connections[0].to = Point_3(0.53, 0, 0);
    const auto r = q.run();
    std::cout << r.message << std::endl;
    assert(r.is_valid() && r.unmet_guides.empty() &&
           straight_chain(q.quads().mesh, q.options.connections[0].from, q.options.connections[0].to) > 3);
    // Both ends at one place; a coordinate that is none.
    q.options.connections[0].to = q.options.connections[0].from;
    const auto none = q.run();
    assert(none.is_valid() && none.unmet_guides.size() == 1 && none.message.find("connection 1") != std::string::npos);
    q.options.connections[0].to = Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
    assert(q.run().status == QM::Quadrangulation_status::INVALID_INPUT);
  }
}

// All of them at once, and twice the same.
void test_together()
{
  const Mesh tm = make_mesh(mapped(icosphere(4), [](const Point_3& p) { return Point_3(2 * p.x(), p.y(), p.z()); }));
  std::vector<QM::Guide_curve> curves(1);
  std::vector<QM::Guide_stroke> strokes(1);
  for(int i = 0; i <= 40; ++i)
  {
    const double a = 0.2 + 1.2 * i / 40;
    curves[0].points.emplace_back(2 * std::cos(a), std::sin(a), 0.);
    strokes[0].points.emplace_back(2 * std::cos(a), 0.6 * std::sin(a), 0.8 * std::sin(a));
  }
  Mesh first;
  for(int run = 0; run < 2; ++run)
  {
    Mesh qm;
    const auto r =
      QM::quadrangulate(tm, qm,
                        params::feature_curves(curves)
                          .strokes(strokes)
                          .symmetry_planes(std::vector<QM::Symmetry_plane>(1, QM::Symmetry_plane::with_normal(0, 0, 1)))
                          .sizing_method(QM::Sizing_method::CURVATURE)
                          .target_number_of_quads(1200));
    std::cout << r.message << std::endl;
    assert(r.is_valid() && is_valid(qm, tm) && is_symmetric(qm, 2, 0));
    if(run == 0)
      first = qm;
    assert(first.number_of_vertices() == qm.number_of_vertices());
    for(Vertex v : qm.vertices())
      assert(first.point(v) == qm.point(v));
  }
}

void write(const std::string& name, const std::string& text) { std::ofstream(name) << text; }

void test_reading()
{
  std::vector<QM::File_polyline> lines;
  write("guides.txt", "# drawn by hand\n0 0 0\n1 0 0 # a point\n1 1 0\n0 0 0\n\n2 0 0\n3 1e-3 0\n");
  assert(QM::read_polylines("guides.txt", lines).is_valid() && lines.size() == 2);
  assert(lines[0].is_closed && lines[0].points.size() == 3 && lines[0].line == 2);
  assert(!lines[1].is_closed && lines[1].points[1][1] == 1e-3 && lines[1].line == 7);
  write("guides.obj", "v 0 0 0\nv 1 0 0\nvt 0 0\nv 1 1 0\nf 1 2 3\nl 1 2 -1\nl 3 1\n");
  assert(QM::read_polylines("guides.obj", lines).is_valid() && lines.size() == 2 && lines[0].points.size() == 3);
  const std::vector<std::pair<std::string, std::string>> bad = { { "0 0\n", "Line 1" },
                                                                 { "0 0 0\n1 1 x\n", "Line 2" },
                                                                 { "0 0 0\n\n1 2 3 4\n", "Line 3" },
                                                                 { "0 nan 0\n", "Line 1" },
                                                                 { "# nothing\n", "no polyline" } };
  for(const auto& b : bad)
  {
    write("guides.txt", b.first);
    const auto r = QM::read_polylines("guides.txt", lines);
    assert(!r.is_valid() && r.message.find(b.second) != std::string::npos);
  }
  write("guides.obj", "v 0 0 0\nl 1 2\n");
  assert(QM::read_polylines("guides.obj", lines).message.find("Line 2") != std::string::npos);
  assert(!QM::read_polylines("there_is_no_such_file", lines).is_valid());
  std::vector<QM::Number_row> rows;
  write("guides.txt", "1 2 3\n\n# 7\n4 # 5\n");
  assert(QM::read_number_rows("guides.txt", rows).is_valid() && rows.size() == 2 && rows[0].numbers.size() == 3 &&
         rows[1].line == 4 && rows[1].numbers == std::vector<double>(1, 4));
  write("guides.txt", "1 2 3\ninf\n");
  assert(QM::read_number_rows("guides.txt", rows).message.find("Line 2") != std::string::npos);
  write("guides.txt", "\n");
  assert(!QM::read_number_rows("guides.txt", rows).is_valid());
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "painted_sizes", test_painted_sizes },
                     { "discs", test_discs },
                     { "sizing_methods", test_sizing_methods },
                     { "cutting", test_cutting },
                     { "curves", test_curves },
                     { "strokes", test_strokes },
                     { "symmetry", test_symmetry },
                     { "indices", test_indices },
                     { "index_sums", test_index_sums },
                     { "random_indices", test_random_indices },
                     { "connections", test_connections },
                     { "together", test_together },
                     { "reading", test_reading } });
}
