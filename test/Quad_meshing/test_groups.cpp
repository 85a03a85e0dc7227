// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Groups, materials, texture coordinates, normals and colors: read, made borders of quads, carried over, written.

#include "quad_mesh_checks.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/IO/Attributes_on_mesh.h>
#include <CGAL/Quad_meshing/IO/find_attribute_borders.h>
#include <CGAL/Quad_meshing/IO/read_mesh_attributes.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/IO/write_obj.h>
#include <CGAL/Quad_meshing/Quad_mesh/transfer_values.h>
#include <CGAL/Quad_meshing/quadrangulate.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;
namespace QM = CGAL::Quad_meshing;
namespace params = CGAL::parameters;
typedef Mesh::Face_index Face;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Edge_index Edge;

namespace {

void write(const std::string& name, const std::string& text) { std::ofstream(name) << text; }

// All that OBJ can say, with the slips that files have.
void test_reading()
{
  write("groups.obj", "mtllib a b.mtl\n"
                      "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 0.5 0.5 0.5\n"
                      "vt 0 0\nvt 1 0 0\nvt 1\nvn 0 0 1\n"
                      "f 1 2 3\n"
                      "o thing # a comment\n"
                      "g left arm\nusemtl Box#1\n"
                      "f 1/1/1 3/-1/-1 4//1\n"
                      "g\n"
                      "f 4/2 3 1\n");
  QM::Mesh_attributes a;
  const QM::Mesh_reading_result r = QM::read_mesh_attributes("groups.obj", a);
  std::cout << r.message << std::endl;
  assert(r.is_valid() && r.faces.file_size() == 3 && r.vertices.file_size() == 4);
  assert(a.material_libraries == std::vector<std::string>(1, "a b.mtl"));
  assert(a.groups.names == (std::vector<std::string>{ "left arm", "" }));
  assert(a.groups.of_face == (std::vector<int>{ QM::Face_names::none, 0, 1 }));
  assert(a.materials.names == std::vector<std::string>(1, "Box#1"));
  assert(a.materials.of_face == (std::vector<int>{ QM::Face_names::none, 0, 0 }));
  assert(a.objects.names == std::vector<std::string>(1, "thing"));
  assert(a.first_corner == (std::vector<std::size_t>{ 0, 3, 6, 9 }) && a.corner_vertex[4] == 2);
  assert(a.corner_texture == (std::vector<int>{ -1, -1, -1, 0, 2, -1, 1, -1, -1 }));
  assert(a.corner_normal == (std::vector<int>{ -1, -1, -1, 0, 0, 0, -1, -1, -1 }));
  assert(a.texture_coordinates[2][0] == 1 && a.texture_coordinates[2][1] == 0 && a.normals[0][2] == 1);
  assert(a.colors.size() == 4 && a.colors[1][1] == 1 && a.colors[3][0] == 0.5);
  // The mesh itself is read as ever.
  Mesh tm;
  assert(QM::read_triangle_mesh("groups.obj", tm).is_valid());

  write("groups.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
                      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                      "0 0 0 255 0 51 9\n1 0 0 0 0 0 9\n0 1 0 0 255 0 9\n3 0 1 2\n");
  assert(QM::read_mesh_attributes("groups.ply", a).is_valid());
  assert(a.colors.size() == 3 && a.colors[0][0] == 1 && std::abs(a.colors[0][2] - 0.2) < 1e-12 && a.groups.is_empty());

  // What cannot be read leaves them as they were.
  write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/x 2 3\n");
  const QM::Mesh_reading_result bad = QM::read_mesh_attributes("bad.obj", a);
  std::cout << bad.message << std::endl;
  assert(!bad.is_valid() && bad.message.find("Line 4") != std::string::npos && a.colors.size() == 3);
}

typedef QM::Obj_content<Mesh> Content;

void write_mesh(const std::string& name, const Mesh& m, const Content& content)
{
  std::ofstream out(name);
  out << std::setprecision(17);
  assert(QM::write_obj(out, m, content));
}

struct Read_mesh
{
  Mesh mesh;
  QM::Mesh_reading_result reading;
  QM::Mesh_attributes attributes;

  explicit Read_mesh(const std::string& name)
  {
    reading = QM::read_triangle_mesh(name, mesh);
    assert(reading.is_valid() && QM::read_mesh_attributes(name, attributes).is_valid());
  }
};

QM::Attribute_borders borders_of(const Read_mesh& r, std::map<Edge, bool>& is_border)
{
  const QM::Attributes_on_mesh<Mesh> on_mesh(r.mesh, r.reading, r.attributes);
  return QM::find_attribute_borders(r.mesh, on_mesh, boost::make_assoc_property_map(is_border));
}

Point_3 center_of(const Mesh& m, Face f)
{
  Vector_3 sum(0, 0, 0);
  for(Vertex v : m.vertices_around_face(m.halfedge(f)))
    sum = sum + (m.point(v) - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum / static_cast<double>(m.degree(f));
}

// A map of a torus to the unit square with two seams, by the angles of the middle of a face.
std::array<double, 2> torus_texture(const Mesh& m, Halfedge h, double major)
{
  auto angles = [&](const Point_3& p)
  {
    const double r = std::hypot(p.x(), p.y());
    return std::array<double, 2>{ { std::atan2(p.y(), p.x()) / (2 * CGAL_PI),
                                    std::atan2(p.z(), r - major) / (2 * CGAL_PI) } };
  };
  const std::array<double, 2> c = angles(center_of(m, m.face(h)));
  std::array<double, 2> t = angles(m.point(m.target(h)));
  for(int k = 0; k < 2; ++k)
    t[k] += std::round(c[k] - t[k]); // on the side of the face
  return t;
}

// Each kind of border is found where it is, and nowhere else.
void test_borders()
{
  {
    const Mesh tm = make_mesh(torus(40, 20, 1, 0.4));
    Content content;
    content.groups.names = { "upper", "lower" };
    content.groups.number = [&](Face f) { return center_of(tm, f).z() > 0 ? 0 : 1; };
    content.texture = [&](Halfedge h) { return torus_texture(tm, h, 1); };
    write_mesh("torus.obj", tm, content);
    const Read_mesh read("torus.obj");
    std::map<Edge, bool> is_border;
    const QM::Attribute_borders b = borders_of(read, is_border);
    std::cout << b.groups << " " << b.seams << " " << b.edges << std::endl;
    // Two circles of 40 edges between the groups, at z = 0; the inner one is a seam as well, and so is one of 20 edges.
    assert(b.groups == 80 && b.seams == 60 && b.materials == 0 && b.normals == 0 && b.edges == 100);
    for(Edge e : read.mesh.edges())
    {
      const Point_3 &p = read.mesh.point(read.mesh.vertex(e, 0)), &q = read.mesh.point(read.mesh.vertex(e, 1));
      const bool is_flat = std::abs(p.z()) + std::abs(q.z()) < 1e-9;
      const bool is_cut = std::abs(p.y()) + std::abs(q.y()) < 1e-9 && p.x() < 0 && q.x() < 0;
      assert(is_border[e] == (is_flat || is_cut));
    }
  }
  {
    // Normals: split along the equator of a ball; then those of faces, which say nothing.
    const Mesh tm = make_mesh(icosphere(2));
    for(int flat = 0; flat < 2; ++flat)
    {
      std::ofstream out("normals.obj");
      for(Vertex v : tm.vertices())
        out << "v " << tm.point(v) << "\n";
      int n = 0;
      for(Face f : tm.faces())
      {
        std::string line = "f";
        for(Vertex v : tm.vertices_around_face(tm.halfedge(f)))
        {
          const Point_3 c = center_of(tm, f);
          const Vector_3 normal =
            flat ? c - CGAL::ORIGIN : tm.point(v) - CGAL::ORIGIN + Vector_3(0, 0, c.z() > 0 ? 1 : -1);
          out << "vn " << normal << "\n";
          line += " " + std::to_string(int(v) + 1) + "//" + std::to_string(++n);
        }
        out << line << "\n";
      }
      out.close();
      const Read_mesh read("normals.obj");
      std::map<Edge, bool> is_border;
      const QM::Attribute_borders b = borders_of(read, is_border);
      std::cout << b.normals << " of " << read.mesh.number_of_edges() << " edges are split" << std::endl;
      assert(b.has_flat_shading == (flat == 1));
      std::size_t expected = 0;
      for(Edge e : read.mesh.edges())
      {
        const bool is_between = (center_of(read.mesh, read.mesh.face(read.mesh.halfedge(e, 0))).z() > 0) !=
                                (center_of(read.mesh, read.mesh.face(read.mesh.halfedge(e, 1))).z() > 0);
        expected += is_between;
        assert(is_border[e] == (is_between && flat == 0));
      }
      assert(b.edges == (flat ? 0 : expected) && expected > 0);
    }
  }
}

// Linear values are carried exactly, and seams stay where they are.
void test_transfer()
{
  const Mesh tm = make_mesh(torus(60, 30, 1, 0.4));
  std::map<Edge, bool> is_curve;
  auto texture = [&](Halfedge h) { return torus_texture(tm, h, 1); };
  for(Edge e : tm.edges())
  {
    const Halfedge h = tm.halfedge(e), o = tm.opposite(h);
    const auto a = texture(h), b = texture(tm.prev(o));
    is_curve[e] = std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) > 0.5;
  }
  Mesh qm;
  std::map<Vertex, std::pair<Face, std::array<double, 3>>> location;
  const auto r = QM::quadrangulate(tm, qm,
                                   params::edge_is_curve_map(boost::make_assoc_property_map(is_curve))
                                     .target_number_of_quads(1200)
                                     .face_location_map(boost::make_assoc_property_map(location)));
  std::cout << r.message << std::endl;
  assert(r.is_valid() && r.unmet_guides.empty());

  std::map<Vertex, Vector_3> place;
  for(Vertex v : tm.vertices())
    place[v] = tm.point(v) - CGAL::ORIGIN;
  std::map<Vertex, Vector_3> carried;
  QM::transfer_vertex_values(tm, boost::make_assoc_property_map(place), qm, boost::make_assoc_property_map(location),
                             boost::make_assoc_property_map(carried));
  for(Vertex v : qm.vertices())
    assert((CGAL::ORIGIN + carried[v] - qm.point(v)).squared_length() < 1e-18);

  std::map<Halfedge, std::array<double, 2>> of_triangles, of_quads;
  for(Halfedge h : tm.halfedges())
    of_triangles[h] = texture(h);
  QM::transfer_corner_values(tm, boost::make_assoc_property_map(is_curve), boost::make_assoc_property_map(of_triangles),
                             qm, boost::make_assoc_property_map(of_quads));
  assert(of_quads.size() == 4 * qm.number_of_faces());
  double area = 0;
  for(Face f : qm.faces())
  {
    std::array<double, 2> low = { { 9, 9 } }, high = { { -9, -9 } };
    std::vector<std::array<double, 2>> c;
    for(Halfedge h : qm.halfedges_around_face(qm.halfedge(f)))
    {
      c.push_back(of_quads[h]);
      const auto exact = torus_texture(qm, h, 1);
      for(int k = 0; k < 2; ++k)
      {
        low[k] = (std::min)(low[k], c.back()[k]);
        high[k] = (std::max)(high[k], c.back()[k]);
        // the map of the triangles is linear in pieces of a 60th and a 30th of the square
        assert(std::abs(c.back()[k] - exact[k]) < 0.01);
      }
    }
    assert(high[0] - low[0] < 0.1 && high[1] - low[1] < 0.15); // no quad spans a seam
    for(std::size_t k = 0; k < 4; ++k)
      area += (c[k][0] * c[(k + 1) % 4][1] - c[k][1] * c[(k + 1) % 4][0]) / 2;
  }
  std::cout << "area of the texture " << area << std::endl;
  assert(std::abs(area - 1) < 0.01); // the whole square, once
}

double area_of_quad(const Mesh& qm, Face f)
{
  const Halfedge h = qm.halfedge(f);
  const Vector_3 one = qm.point(qm.target(qm.next(h))) - qm.point(qm.source(h));
  const Vector_3 other = qm.point(qm.target(qm.next(qm.next(h)))) - qm.point(qm.target(h));
  return std::sqrt(CGAL::cross_product(one, other).squared_length()) / 2;
}

// Two materials on a ball, divided by a wavy line along triangle edges: quads of both cover what triangles of both do.
void test_materials_reach_quads()
{
  const Mesh tm = make_mesh(icosphere(5));
  auto is_red = [](const Point_3& p) { return p.z() > 0.3 * std::sin(3 * std::atan2(p.y(), p.x())); };
  Content content;
  content.materials.names = { "red", "blue" };
  content.materials.number = [&](Face f) { return is_red(center_of(tm, f)) ? 0 : 1; };
  write_mesh("ball.obj", tm, content);
  const Read_mesh read("ball.obj");
  std::map<Edge, bool> is_border;
  assert(borders_of(read, is_border).materials > 0);
  Mesh qm;
  const auto r = QM::quadrangulate(
    read.mesh, qm, params::edge_is_curve_map(boost::make_assoc_property_map(is_border)).target_number_of_quads(1500));
  std::cout << r.message << std::endl;
  assert(r.is_valid()); // quads go straight where the border zigzags along triangles, which the message may tell
  const QM::Attributes_on_mesh<Mesh> on_mesh(read.mesh, read.reading, read.attributes);
  std::map<Face, int> of_triangles, of_quads;
  for(Face f : read.mesh.faces())
    of_triangles[f] = on_mesh.name(f, read.attributes.materials);
  QM::transfer_face_values(read.mesh, boost::make_assoc_property_map(of_triangles), qm,
                           boost::make_assoc_property_map(of_quads));
  std::array<double, 2> area = { { 0, 0 } }, wanted = { { 0, 0 } };
  for(Face f : qm.faces())
    area[of_quads[f]] += area_of_quad(qm, f);
  for(Face f : read.mesh.faces())
    wanted[of_triangles[f]] += CGAL::Polygon_mesh_processing::face_area(f, read.mesh);
  std::cout << area[0] << " of " << wanted[0] << ", " << area[1] << " of " << wanted[1] << std::endl;
  for(int k = 0; k < 2; ++k)
    assert(std::abs(area[k] / wanted[k] - 1) < 0.02); // quads are chords of the ball
  // The border is one closed line of quad edges.
  std::size_t borders = 0;
  std::map<Vertex, int> degree;
  for(Edge e : qm.edges())
    if(of_quads[qm.face(qm.halfedge(e, 0))] != of_quads[qm.face(qm.halfedge(e, 1))])
    {
      ++borders;
      ++degree[qm.vertex(e, 0)];
      ++degree[qm.vertex(e, 1)];
    }
  for(const auto& d : degree)
    assert(d.second == 2);
  assert(borders > 40 && degree.size() == borders);

  // What is written is read again.
  Content quads;
  quads.materials.names = read.attributes.materials.names;
  quads.materials.number = [&](Face f) { return of_quads[f]; };
  write_mesh("ball_quads.obj", qm, quads);
  QM::Mesh_attributes again;
  assert(QM::read_mesh_attributes("ball_quads.obj", again).is_valid());
  assert(again.first_corner.size() == qm.number_of_faces() + 1);
  std::array<std::size_t, 2> count = { { 0, 0 } };
  for(const auto& f : of_quads)
    ++count[static_cast<std::size_t>(f.second)];
  for(std::size_t k = 0; k < again.materials.names.size(); ++k)
    assert(std::count(again.materials.of_face.begin(), again.materials.of_face.end(), static_cast<int>(k)) ==
           static_cast<std::ptrdiff_t>(count[again.materials.names[k] == "red" ? 0 : 1]));
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "reading", test_reading },
                     { "borders", test_borders },
                     { "transfer", test_transfer },
                     { "materials_reach_quads", test_materials_reach_quads } });
}
