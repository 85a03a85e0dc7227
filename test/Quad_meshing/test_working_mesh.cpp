// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Working meshes: topology, curves, closeness to the input by independent sampling, shape, and what must not happen.

#include "test_cases.h"
#include "test_meshes.h"
#include "visitor_checks.h"

#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Working_mesh/make_working_mesh.h>
#include <CGAL/Quad_meshing/internal/surface_topology.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>
#include <CGAL/Random.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace TM = test_meshes;
namespace np = CGAL::parameters;

typedef TM::Mesh Mesh;
typedef TM::Point_3 Point_3;
typedef TM::Kernel Kernel;
typedef QM::Working_mesh_status Status;
typedef CGAL::AABB_tree<QM::internal::Aabb_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>> Tree;

namespace {

// A mesh with its features, the working mesh of it, and the way back.
struct Work
{
  Mesh input, mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> input_feature, feature;
  Mesh::Property_map<Mesh::Vertex_index, Mesh::Face_index> place;
  QM::Working_mesh_result result;
  double length;

  Work(const Mesh& tm, double target_edge_length, double sharp_angle = 40) : input(tm), length(target_edge_length)
  {
    input_feature = input.add_property_map<Mesh::Edge_index, bool>("e:input_feature", false).first;
    feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
    place = mesh.add_property_map<Mesh::Vertex_index, Mesh::Face_index>("v:place").first;
    QM::detect_feature_edges(input, sharp_angle, length, input_feature);
    result = QM::make_working_mesh(input, length, mesh, np::edge_is_constrained_map(input_feature),
                                   np::input_face_map(place).edge_is_constrained_map(feature));
  }

  double quads() const { return CGAL::Polygon_mesh_processing::area(input) / (length * length); }
};

double shape_quality(const Mesh& m, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = m.halfedge(f);
  const Point_3 &p = m.point(m.source(h)), &q = m.point(m.target(h)), &r = m.point(m.target(m.next(h)));
  const double lengths = CGAL::squared_distance(p, q) + CGAL::squared_distance(q, r) + CGAL::squared_distance(r, p);
  return 4 * std::sqrt(3.) * std::sqrt(CGAL::squared_area(p, q, r)) / lengths;
}

// The largest distance from random points of one mesh to another one.
double largest_distance(const Mesh& from, const Mesh& to, int samples_per_face)
{
  const Tree tree(faces(to).first, faces(to).second, to);
  CGAL::Random random(1);
  double largest = 0;
  for(Mesh::Face_index f : from.faces())
  {
    const Mesh::Halfedge_index h = from.halfedge(f);
    const Point_3 &p = from.point(from.source(h)), &q = from.point(from.target(h)),
                  &r = from.point(from.target(from.next(h)));
    for(int i = 0; i < samples_per_face; ++i)
    {
      double a = random.get_double(), b = random.get_double();
      if(a + b > 1)
      {
        a = 1 - a;
        b = 1 - b;
      }
      largest = (std::max)(largest, tree.squared_distance(p + a * (q - p) + b * (r - p)));
    }
  }
  return std::sqrt(largest);
}

std::vector<Kernel::Segment_3> curves(const Mesh& m, const Mesh::Property_map<Mesh::Edge_index, bool>& is_feature)
{
  std::vector<Kernel::Segment_3> result;
  for(Mesh::Edge_index e : m.edges())
    if(is_feature[e] || m.is_border(e))
      result.push_back(Kernel::Segment_3(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1))));
  return result;
}

// The points where other than two curve edges meet.
std::set<Point_3> nodes(const Mesh& m, const Mesh::Property_map<Mesh::Edge_index, bool>& is_feature)
{
  std::map<Point_3, int> degree;
  for(const Kernel::Segment_3& s : curves(m, is_feature))
  {
    ++degree[s.source()];
    ++degree[s.target()];
  }
  std::set<Point_3> result;
  for(const auto& d : degree)
    if(d.second != 2)
      result.insert(d.first);
  return result;
}

double largest_distance(const std::vector<Kernel::Segment_3>& from, const std::vector<Kernel::Segment_3>& to)
{
  double largest = 0;
  for(const Kernel::Segment_3& s : from)
    for(const double t : { 0., 0.37, 0.5, 0.81 })
    {
      double least = 1e300;
      for(const Kernel::Segment_3& u : to)
        least = (std::min)(least, CGAL::squared_distance(s.source() + t * (s.target() - s.source()), u));
      largest = (std::max)(largest, least);
    }
  return std::sqrt(largest);
}

// What holds for all working meshes.
void check(const std::string& name, const Work& w, double most_triangles_per_quad)
{
  std::cout << "  " << name << ": " << w.result.message << " " << w.mesh.number_of_faces() / w.quads()
            << " for a quad, " << w.result.seconds << " s" << std::endl;
  assert(w.result.is_valid() && w.result.status == Status::MADE);
  assert(w.result.input_faces == w.input.number_of_faces() && w.result.faces == w.mesh.number_of_faces());
  assert(CGAL::is_valid_polygon_mesh(w.mesh) && CGAL::is_triangle_mesh(w.mesh));
  assert(QM::internal::surface_topology(w.mesh) == QM::internal::surface_topology(w.input));
  assert(w.mesh.number_of_faces() <= most_triangles_per_quad * w.quads());

  const double there = largest_distance(w.mesh, w.input, 6);
  const double back = largest_distance(w.input, w.mesh, w.input.number_of_faces() > 20000 ? 1 : 20);
  std::cout << "    distances " << there / w.length << ", " << back / w.length << " of the length" << std::endl;
  assert(there < 0.15 * w.length && back < 0.15 * w.length);

  const auto input_curves = curves(w.input, w.input_feature), work_curves = curves(w.mesh, w.feature);
  assert(input_curves.empty() == work_curves.empty());
  if(!input_curves.empty())
  {
    assert(largest_distance(input_curves, work_curves) < 0.15 * w.length);
    assert(largest_distance(work_curves, input_curves) < 0.15 * w.length);
  }
  assert(nodes(w.mesh, w.feature) == nodes(w.input, w.input_feature));

  for(Mesh::Vertex_index v : w.mesh.vertices())
  {
    const Mesh::Halfedge_index h = w.input.halfedge(w.place[v]);
    const Kernel::Triangle_3 t(w.input.point(w.input.source(h)), w.input.point(w.input.target(h)),
                               w.input.point(w.input.target(w.input.next(h))));
    assert(CGAL::squared_distance(w.mesh.point(v), t) < 0.15 * 0.15 * w.length * w.length);
  }
}

Mesh data_mesh(const std::string& name)
{
  Mesh m;
  if(!CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), m))
    std::cout << "  NOTICE: " << name << " is not there" << std::endl;
  return m;
}

void test_fine_surfaces()
{
  check("sphere", Work(TM::make_mesh(TM::icosphere(6)), 0.15), 30);
  check("torus", Work(TM::make_mesh(TM::torus(300, 150)), 0.1), 30);
  check("cube", Work(TM::make_mesh(TM::cube(60)), 0.1), 30);
  check("sheared cube", Work(TM::make_mesh(TM::sheared_cube(50)), 0.1), 30);
  check("open cylinder", Work(TM::make_mesh(TM::cylinder(300, 200, false)), 0.15), 30);
  check("rough sphere", Work(TM::make_mesh(TM::perturbed(TM::icosphere(5), 0.002)), 0.15, 180), 60);
  for(const char* name : { "bunny00.off", "elephant.off", "fandisk.off", "joint.off" })
  {
    const Mesh m = data_mesh(name);
    if(!m.is_empty())
      check(name, Work(m, std::sqrt(CGAL::Polygon_mesh_processing::area(m) / 1000)), 60);
  }
}

// Coarse meshes get triangles that quads can bend on; no triangle is longer than 1.5 edges.
void test_coarse_surfaces()
{
  for(const TM::Soup& soup : { TM::cube(1), TM::icosphere(0), TM::l_prism(1), TM::cylinder(64, 1, true) })
  {
    const Work w(TM::make_mesh(soup), 0.1);
    check("coarse", w, 30);
    std::size_t bad = 0;
    for(Mesh::Edge_index e : w.mesh.edges())
      assert(CGAL::squared_distance(w.mesh.point(w.mesh.vertex(e, 0)), w.mesh.point(w.mesh.vertex(e, 1))) <
             1.501 * 1.501 * 0.01);
    for(Mesh::Face_index f : w.mesh.faces())
      bad += shape_quality(w.mesh, f) < 0.3;
    std::cout << "    " << bad << " bad triangles" << std::endl;
    assert(bad <= w.mesh.number_of_faces() / 50);
  }
}

// Fans of needles in plane faces, as CAD programs export them.
void test_slivers()
{
  const Mesh m = TM::make_mesh(TM::cylinder(2000, 1, true, 1, 1));
  const Work w(m, 0.1);
  check("needles", w, 30);
  std::size_t bad = 0;
  for(Mesh::Face_index f : w.mesh.faces())
    bad += shape_quality(w.mesh, f) < 0.3;
  std::cout << "    " << bad << " of " << w.mesh.number_of_faces() << " bad triangles" << std::endl;
  assert(bad <= w.mesh.number_of_faces() / 50);
}

// Nothing jumps from one side of a plate to the other, though these are a thousand times nearer than a quad is long.
void test_thin_plate()
{
  const double thickness = 1e-4;
  const Mesh m =
    TM::make_mesh(TM::mapped(TM::cube(40), [&](const Point_3& p) { return Point_3(p.x(), p.y(), thickness * p.z()); }));
  const Work w(m, 0.1);
  assert(w.result.is_valid());
  assert(QM::internal::surface_topology(w.mesh) == QM::internal::surface_topology(w.input));
  for(Mesh::Face_index f : w.mesh.faces())
  {
    const Kernel::Vector_3 n = CGAL::Polygon_mesh_processing::compute_face_normal(f, w.mesh);
    double least = 1, most = 0;
    bool is_at_rim = false; // a narrow side belongs to the top or the bottom
    for(Mesh::Vertex_index v : w.mesh.vertices_around_face(w.mesh.halfedge(f)))
    {
      const Point_3& p = w.mesh.point(v);
      least = (std::min)(least, p.z() / thickness);
      most = (std::max)(most, p.z() / thickness);
      is_at_rim = is_at_rim || (std::min)({ p.x(), p.y(), 1 - p.x(), 1 - p.y() }) < 1e-9;
    }
    if(!is_at_rim)
      assert(most - least < 1e-9 && (n.z() > 0) == (least > 0.5));
  }
  const double volume = CGAL::Polygon_mesh_processing::volume(w.mesh);
  std::cout << "  volume " << volume / thickness << std::endl;
  assert(std::abs(volume / thickness - 1) < 0.15); // at the rim, where the sides end, the plate may get thinner
}

// Two spheres of nearly the same radius keep their radii.
void test_nested_shells()
{
  const double gap = 1e-3;
  TM::Soup inner =
    TM::mapped(TM::icosphere(5), [&](const Point_3& p) { return CGAL::ORIGIN + (1 - gap) * (p - CGAL::ORIGIN); });
  const Work w(TM::make_mesh(TM::joined(TM::icosphere(5), inner)), 0.2);
  assert(w.result.is_valid());
  std::size_t outside = 0, inside = 0;
  for(Mesh::Face_index f : w.mesh.faces())
  {
    std::size_t out = 0;
    for(Mesh::Vertex_index v : w.mesh.vertices_around_face(w.mesh.halfedge(f)))
      out += (w.mesh.point(v) - CGAL::ORIGIN).squared_length() > (1 - gap / 2) * (1 - gap / 2);
    assert(out == 0 || out == 3);
    (out == 3 ? outside : inside) += 1;
  }
  assert(outside > 100 && inside > 100);
}

void test_determinism()
{
  const Mesh m = TM::make_mesh(TM::perturbed(TM::torus(120, 60), 0.001));
  const Work a(m, 0.1), b(m, 0.1);
  assert(a.mesh.number_of_vertices() == b.mesh.number_of_vertices());
  assert(a.mesh.number_of_faces() == b.mesh.number_of_faces());
  for(Mesh::Vertex_index v : a.mesh.vertices())
    assert(a.mesh.point(v) == b.mesh.point(v) && a.place[v] == b.place[v]);
}

// A mesh that is as it should be stays as it is.
void test_good_mesh_stays()
{
  const Mesh m = TM::make_mesh(TM::icosphere(3));
  const Work w(m, 0.3);
  assert(w.mesh.number_of_faces() == m.number_of_faces());
  assert(w.result.collapsed_edges == 0 && w.result.split_edges == 0);
}

// A hole that is small beside a quad stays round: its border may not turn by more than 25 degrees at a vertex, however
// near to it a coarser one would be.
void test_small_hole()
{
  const double radius = 0.2, largest_turn = 25.001 * CGAL_PI / 180;
  const Mesh m = TM::make_mesh(TM::mapped(TM::cylinder(72, 40, false, 1, 1),
                                          [&](const Point_3& p)
                                          {
                                            const double r = radius + 4 * p.z();
                                            return Point_3(r * p.x(), r * p.y(), 0);
                                          }));
  const Work w(m, 1);
  std::size_t vertices = 0;
  for(Mesh::Halfedge_index h : w.mesh.halfedges())
  {
    const Point_3& p = w.mesh.point(w.mesh.target(h));
    if(!w.mesh.is_border(h) || (p - CGAL::ORIGIN).squared_length() > 4 * radius * radius)
      continue;
    ++vertices;
    const Kernel::Vector_3 in = p - w.mesh.point(w.mesh.source(h)),
                           out = w.mesh.point(w.mesh.target(w.mesh.next(h))) - p;
    assert(std::acos(in * out / std::sqrt(in.squared_length() * out.squared_length())) < largest_turn);
  }
  std::cout << "    " << vertices << " vertices around the hole" << std::endl;
  assert(vertices >= 15 && vertices < 72);
}

// Flat surfaces are cut along the shorter diagonals: few edges are not locally Delaunay in the end.
void test_flat_surface()
{
  const Mesh m = TM::make_mesh(
    TM::mapped(TM::grid(40, 40, 4, 4), [](const Point_3& p) { return Point_3(p.x() + 1.5 * p.y(), p.y(), 0); }));
  const Work w(m, 0.3);
  std::size_t inner = 0, bad = 0;
  for(Mesh::Edge_index e : w.mesh.edges())
  {
    if(w.mesh.is_border(e))
      continue;
    double angles = 0;
    for(Mesh::Halfedge_index h : { w.mesh.halfedge(e), w.mesh.opposite(w.mesh.halfedge(e)) })
    {
      const Point_3& apex = w.mesh.point(w.mesh.target(w.mesh.next(h)));
      const Kernel::Vector_3 a = w.mesh.point(w.mesh.source(h)) - apex, b = w.mesh.point(w.mesh.target(h)) - apex;
      angles += std::acos(a * b / std::sqrt(a.squared_length() * b.squared_length()));
    }
    ++inner;
    bad += angles > CGAL_PI + 1e-6;
  }
  std::cout << "    " << bad << " of " << inner << " edges are not locally Delaunay" << std::endl;
  assert(w.result.flipped_edges > 0 && bad < inner / 50);
}

void test_bad_input_and_stop()
{
  Mesh quad;
  std::vector<Mesh::Vertex_index> v;
  for(const Point_3& p : { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0) })
    v.push_back(quad.add_vertex(p));
  quad.add_face(v);
  Mesh out;
  assert(QM::make_working_mesh(quad, 0.1, out).status == Status::NOT_A_TRIANGLE_MESH);
  const Mesh sphere = TM::make_mesh(TM::icosphere(7));
  for(double length : { 0., -1., std::nan(""), 1. / 0. })
  {
    const QM::Working_mesh_result r = QM::make_working_mesh(sphere, length, out);
    assert(r.status == Status::INVALID_PARAMETERS && !r.message.empty());
  }
  visitor_checks::Stopwatch_visitor visitor(0.05);
  const QM::Working_mesh_result r = QM::make_working_mesh(sphere, 0.05, out, np::visitor(std::ref(visitor)));
  assert(r.status == Status::STOPPED && visitor.is_monotone());
  assert(visitor.longest_gap() < visitor_checks::longest_gap);
  assert(out.is_empty());
  assert(std::string(QM::status_name(r.status)) == "stopped");
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "fine_surfaces", test_fine_surfaces },
                     { "coarse_surfaces", test_coarse_surfaces },
                     { "slivers", test_slivers },
                     { "thin_plate", test_thin_plate },
                     { "nested_shells", test_nested_shells },
                     { "determinism", test_determinism },
                     { "good_mesh_stays", test_good_mesh_stays },
                     { "small_hole", test_small_hole },
                     { "flat_surface", test_flat_surface },
                     { "bad_input_and_stop", test_bad_input_and_stop } });
}
