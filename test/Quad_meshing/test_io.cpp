// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Reading of meshes, good, damaged and repairable ones, and writing of JSON.

#include <CGAL/Quad_meshing/IO/Flat_json.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>

#include "test_meshes.h"
#include "test_cases.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/boost/graph/IO/STL.h>
#include <CGAL/boost/graph/helpers.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

typedef test_meshes::Mesh Mesh;
typedef test_meshes::Point_3 Point_3;
typedef test_meshes::Soup Soup;
typedef CGAL::Quad_meshing::Mesh_reading_status Status;
typedef CGAL::Quad_meshing::Mesh_reading_result Result;

void write_text(const std::string& filename, const std::string& text)
{
  std::ofstream(filename, std::ios::binary) << text;
}

std::string off_text(const Soup& soup, const std::vector<std::vector<std::size_t> >& more_faces = {})
{
  std::ostringstream os;
  os.precision(17);
  os << "OFF\n" << soup.points.size() << " " << soup.triangles.size() + more_faces.size() << " 0\n";
  for(const Point_3& p : soup.points)
    os << p << "\n";
  for(const auto& t : soup.triangles)
    os << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  for(const auto& f : more_faces)
  {
    os << f.size();
    for(std::size_t v : f)
      os << " " << v;
    os << "\n";
  }
  return os.str();
}

// Reads a text as a file of that name.
Result read_text(const std::string& filename, const std::string& text, Mesh& tm)
{
  write_text(filename, text);
  const Result result = CGAL::Quad_meshing::read_triangle_mesh(filename, tm);
  std::cout << "  " << filename << ": " << result.message;
  for(const std::string& repair : result.repairs)
    std::cout << repair << "; ";
  std::cout << std::endl;
  if(result)
    assert(CGAL::is_triangle_mesh(tm) && CGAL::is_valid_polygon_mesh(tm) && result.message.empty());
  else
    assert(!result.message.empty() && result.message.find('\n') == std::string::npos);
  return result;
}

// The text must be refused, for that reason, in words that hold `word`, and the mesh stay as it was.
void check_refused(const char* filename, const std::string& text, Status status, const char* word)
{
  Mesh tm = test_meshes::make_mesh(test_meshes::cube(1));
  const Result result = read_text(filename, text, tm);
  assert(!result && result.status == status);
  assert(result.message.find(word) != std::string::npos);
  assert(tm.number_of_faces() == 12 && tm.number_of_vertices() == 8);
}

bool mentions(const Result& result, const std::string& word)
{
  for(const std::string& repair : result.repairs)
    if(repair.find(word) != std::string::npos)
      return true;
  return false;
}

std::size_t number_of_borders(const Mesh& tm)
{
  std::vector<Mesh::Halfedge_index> cycles;
  PMP::extract_boundary_cycles(tm, std::back_inserter(cycles));
  return cycles.size();
}

std::size_t number_of_components(Mesh& tm)
{
  auto component = tm.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  return PMP::connected_components(tm, component);
}

bool is_near(double a, double b) { return std::abs(a - b) < 1e-9 * (1 + std::abs(b)); }

void test_formats()
{
  std::cout << "the same mesh through all formats" << std::endl;
  const Soup soup = test_meshes::perturbed(test_meshes::torus(12, 7), 0.01);
  const Mesh tm = test_meshes::make_mesh(soup);
  const auto np = CGAL::parameters::stream_precision(17);
  const auto text_np = CGAL::parameters::stream_precision(17).use_binary_mode(false);
  for(const std::string filename : { "torus.off", "torus.OBJ", "torus.ply", "torus_text.ply", "torus.stl", "torus_text.stl" })
  {
    std::ofstream out(filename, std::ios::binary);
    const bool as_text = filename.find("text") != std::string::npos;
    if(filename == "torus.off")
      assert(CGAL::IO::write_OFF(out, tm, np));
    else if(filename == "torus.OBJ")
      assert(CGAL::IO::write_OBJ(out, tm, np));
    else if(filename.find("ply") != std::string::npos)
    {
      if(!as_text)
        CGAL::IO::set_binary_mode(out);
      assert(CGAL::IO::write_PLY(out, tm, as_text ? text_np : np));
    }
    else
    {
      if(!as_text)
        CGAL::IO::set_binary_mode(out);
      assert(CGAL::IO::write_STL(out, tm, np));
    }
    out.close();

    Mesh read;
    const Result result = CGAL::Quad_meshing::read_triangle_mesh(filename, read);
    assert(result && result.repairs.empty() && result.number_of_degenerate_faces == 0);
    assert(CGAL::is_closed(read) && read.number_of_vertices() == 84 && read.number_of_faces() == 168);
    if(filename == "torus.off" || filename == "torus.OBJ" || filename == "torus_text.ply")
    {
      // Same numbers, same order.
      for(Mesh::Vertex_index v : vertices(read))
        assert(read.point(v) == tm.point(v));
      for(Mesh::Face_index f : faces(read))
      {
        const auto triangle = soup.triangles[f.idx()];
        std::vector<std::size_t> corners;
        for(Mesh::Vertex_index v : CGAL::vertices_around_face(halfedge(f, read), read))
          corners.push_back(v.idx());
        std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), triangle[0]), corners.end());
        assert(corners[0] == triangle[0] && corners[1] == triangle[1] && corners[2] == triangle[2]);
      }
    }
    else // floats or another order
      assert(std::abs(PMP::volume(read) - PMP::volume(tm)) < 1e-5);
  }

  CGAL::Polyhedron_3<test_meshes::Kernel> polyhedron;
  assert(CGAL::Quad_meshing::read_triangle_mesh("torus.off", polyhedron));
  assert(polyhedron.size_of_vertices() == 84 && polyhedron.size_of_facets() == 168);

  std::cout << "text in unusual shapes" << std::endl;
  Mesh t;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  assert(read_text("a.off", "# comment\nOFF # more\n\n3 1 0\r\n0 0 0 # first\r\n+1 0 0 0.5 0.5\r\n0 1e0 -0\r\n3 0 1 2 255 0 0\r\n", t));
  assert(t.number_of_faces() == 1 && t.point(Mesh::Vertex_index(1)) == Point_3(1, 0, 0));
  assert(read_text("b.off", "OFF 3 1 0\n" + points + "3 0 1 2", t) && t.number_of_faces() == 1);
  assert(read_text("c.off", "COFF\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n", t));
  assert(read_text("d.off", "4OFF\n3 1 0\n0 0 0 2\n1 0 0 2\n0 1 0 2\n3 0 1 2\n", t));
  assert(t.point(Mesh::Vertex_index(1)) == Point_3(0.5, 0, 0));
  assert(read_text("e.obj", "mtllib x\no thing\nv 0 0 0\nv 1 0 0 1 1 1\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 \\\n 3/1\n", t));
  assert(t.number_of_faces() == 1);
  assert(read_text("f.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 1 1 0\nf 2 4 3", t));
  assert(t.number_of_faces() == 2 && t.number_of_edges() == 5);
}

void test_refused()
{
  std::cout << "input that cannot be used" << std::endl;
  const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  check_refused("empty.off", "", Status::EMPTY_FILE, "empty");
  check_refused("blank.obj", " \n\n", Status::EMPTY_FILE, "empty");
  check_refused("mesh.xyz", "0 0 0\n", Status::UNKNOWN_FORMAT, "xyz");
  check_refused("mesh", "0 0 0\n", Status::UNKNOWN_FORMAT, "format");
  check_refused("garbage.off", "hello world\n", Status::MALFORMED_FILE, "OFF");
  check_refused("garbage.ply", "hello world\n", Status::MALFORMED_FILE, "ply");
  check_refused("garbage.stl", "hello world\n", Status::NO_FACES, "no faces");
  check_refused("garbage.obj", "hello world\n", Status::NO_FACES, "no faces");
  check_refused("huge.off", "OFF\n999999999999 5 0\n0 0 0\n", Status::MALFORMED_FILE, "999999999999");
  check_refused("negative.off", "OFF\n-4 1 0\n" + square, Status::MALFORMED_FILE, "-4");
  check_refused("huge.ply", "ply\nformat ascii 1.0\nelement vertex 999999999999\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n", Status::MALFORMED_FILE, "999999999999");
  check_refused("short.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n0 0 0\n", Status::MALFORMED_FILE, "");
  check_refused("word.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 x1 0\n0 1 0\n4 0 1 2 3\n", Status::MALFORMED_FILE, "line 5");
  check_refused("truncated.off", "OFF\n4 2 0\n" + square + "3 0 1 2\n", Status::MALFORMED_FILE, "ends");
  check_refused("truncated_face.off", "OFF\n4 1 0\n" + square + "4 0 1 2\n", Status::MALFORMED_FILE, "line 7");
  check_refused("cloud.off", "OFF\n4 0 0\n" + square, Status::NO_FACES, "4 vertices");
  check_refused("cloud.obj", "v 0 0 0\nv 1 0 0\n", Status::NO_FACES, "no faces");
  check_refused("points.off", "OFF\n4 1 0\n" + square + "3 0 1 1\n", Status::NO_FACES, "distinct");
  check_refused("line.off", "OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n", Status::NO_FACES, "area");
  check_refused("index.off", "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 2 4\n", Status::INVALID_INDEX, "face 1 names vertex 4");
  check_refused("negative_index.off", "OFF\n4 1 0\n" + square + "3 0 1 -2\n", Status::INVALID_INDEX, "face 0");
  check_refused("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", Status::INVALID_INDEX, "vertex 3");
  check_refused("zero_index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", Status::INVALID_INDEX, "face 0");
  check_refused("far_index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", Status::INVALID_INDEX, "face 0");
  check_refused("nan.off", "OFF\n4 1 0\n0 0 0\n1 0 0\nnan 1 0\n0 1 0\n4 0 1 2 3\n", Status::INVALID_COORDINATE, "vertex 2");
  check_refused("inf.obj", "v 0 0 0\nv 1 0 0\nv 0 -inf 0\nf 1 2 3\n", Status::INVALID_COORDINATE, "vertex 2");
  check_refused("overflow.obj", "v 0 0 0\nv 1e999 0 0\nv 0 1 0\nf 1 2 3\n", Status::INVALID_COORDINATE, "vertex 1");
  check_refused("large.obj", "v 0 0 0\nv 1e200 0 0\nv 0 1 0\nf 1 2 3\n", Status::INVALID_COORDINATE, "large");
  check_refused("moebius.off", off_text(test_meshes::moebius_strip(9)), Status::NOT_ORIENTABLE, "not orientable");

  Mesh tm;
  Result result = CGAL::Quad_meshing::read_triangle_mesh("there_is_no_such_file.off", tm);
  assert(result.status == Status::CANNOT_OPEN && !result.message.empty());
  result = CGAL::Quad_meshing::read_triangle_mesh(".", tm);
  assert(!result);
}

void test_repaired()
{
  std::cout << "input that can be repaired" << std::endl;
  Mesh tm;
  Result result;
  const Soup cube = test_meshes::cube(3);

  // Orientation: a third of the faces turned, the whole stays outside out.
  Soup soup = cube;
  for(std::size_t f = 0; f < soup.triangles.size(); f += 3)
    std::swap(soup.triangles[f][0], soup.triangles[f][1]);
  result = read_text("turned.off", off_text(soup), tm);
  assert(result && mentions(result, "36 faces reversed") && CGAL::is_closed(tm) && is_near(PMP::volume(tm), 1));

  // A strip closed with a full turn is orientable, however its faces are given.
  soup = test_meshes::cylinder(9, 1, false);
  std::swap(soup.triangles[3][0], soup.triangles[3][1]);
  result = read_text("ring.off", off_text(soup), tm);
  assert(result && mentions(result, "1 face reversed") && number_of_borders(tm) == 2);

  // Polygons, one of them not convex.
  result = read_text("polygons.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nv 2 -2 0\nv 0 -2 0\n"
                     "f 1 2 3 4 5\nf 2 1 7 6\n", tm);
  assert(result && mentions(result, "2 polygons triangulated") && tm.number_of_faces() == 5 && is_near(PMP::area(tm), 6.5));

  // Twice the same face, turned or not, and vertices without a face.
  soup = cube;
  soup.points.insert(soup.points.begin(), Point_3(9, 9, 9));
  for(auto& t : soup.triangles)
    for(std::size_t& v : t)
      ++v;
  soup.triangles.push_back(soup.triangles[5]);
  soup.triangles.push_back({{ soup.triangles[7][1], soup.triangles[7][0], soup.triangles[7][2] }});
  result = read_text("twice.off", off_text(soup), tm);
  assert(result && mentions(result, "2 faces") && mentions(result, "1 vertex without a face") && CGAL::is_closed(tm));
  assert(tm.number_of_faces() == 108 && tm.number_of_vertices() == 56 && is_near(PMP::volume(tm), 1));

  // A fin: two triangles back to back on an edge of the cube. It leaves no trace.
  soup = cube;
  const std::size_t a = soup.triangles[0][0], b = soup.triangles[0][1], tip = soup.points.size();
  soup.points.push_back(Point_3(-1, -1, -1));
  soup.triangles.push_back({{ a, b, tip }});
  soup.triangles.push_back({{ b, a, tip }});
  result = read_text("fin.off", off_text(soup), tm);
  assert(result && mentions(result, "2 faces of fins") && CGAL::is_closed(tm) && tm.number_of_vertices() == 56);

  // Every triangle with vertices of its own, as in STL.
  soup = Soup();
  for(const auto& t : cube.triangles)
  {
    const std::size_t n = soup.points.size();
    for(std::size_t v : t)
      soup.points.push_back(cube.points[v]);
    soup.triangles.push_back({{ n, n + 1, n + 2 }});
  }
  result = read_text("scattered.off", off_text(soup), tm);
  assert(result && mentions(result, "merged") && CGAL::is_closed(tm) && tm.number_of_vertices() == 56);

  // Two cubes that touch at a corner, an edge, a vertex of a square: the solids stay what they are.
  const Soup unit = test_meshes::cube(1);
  for(const auto& shift : { test_meshes::Vector_3(1, 1, 1), test_meshes::Vector_3(1, 1, 0) })
  {
    Soup both = test_meshes::joined(unit, test_meshes::translated(unit, shift));
    // Give coincident vertices one number.
    for(std::size_t v = 8; v < 16; ++v)
      for(std::size_t w = 0; w < 8; ++w)
        if(both.points[v] == both.points[w])
          for(auto& t : both.triangles)
            std::replace(t.begin(), t.end(), v, w);
    result = read_text("touching.off", off_text(both), tm);
    assert(result && mentions(result, "split") && mentions(result, "sheets") == (shift.z() == 0));
    assert(CGAL::is_closed(tm) && tm.number_of_vertices() == 16 && number_of_components(tm) == 2);
    assert(is_near(PMP::volume(tm), 2));

    // The repaired mesh, which has vertices at the same place, is read as it is.
    {
      std::ofstream out("touching_again.off");
      assert(CGAL::IO::write_OFF(out, tm, CGAL::parameters::stream_precision(17)));
    }
    Mesh again;
    result = CGAL::Quad_meshing::read_triangle_mesh("touching_again.off", again);
    assert(result && result.repairs.empty() && again.number_of_vertices() == 16 && CGAL::is_closed(again));
  }

  // A wall on a floor: three sheets at each edge of its foot. The floor stays whole.
  soup = test_meshes::grid(4, 4);
  const Soup floor = soup;
  for(std::size_t i = 0; i < 5; ++i)
    soup.points.push_back(floor.points[10 + i] + test_meshes::Vector_3(0, 0, 1));
  for(std::size_t i = 0; i < 4; ++i)
    soup.add_quad(10 + i, 11 + i, 26 + i, 25 + i);
  result = read_text("wall.off", off_text(soup), tm);
  assert(result && mentions(result, "4 edges with more than two faces"));
  assert(number_of_components(tm) == 2 && number_of_borders(tm) == 2 && is_near(PMP::area(tm), 2));
  assert(tm.number_of_vertices() == 25 + 10);

  // A wall that stands on one inner edge only: its foot has the same ends in both sheets.
  soup = floor;
  const std::size_t top = soup.points.size();
  soup.points.push_back(floor.points[11] + test_meshes::Vector_3(0, 0, 1));
  soup.triangles.push_back({{ 11, 12, top }});
  result = read_text("post.off", off_text(soup), tm);
  assert(result && number_of_components(tm) == 2 && tm.number_of_faces() == 33);

  // A triangle of zero area in the surface and one on its border.
  result = read_text("needle.off", "OFF\n5 4 0\n0 0 0\n2 0 0\n1 0 0\n1 1 0\n1 -1 0\n"
                     "3 0 2 3\n3 2 1 3\n3 0 1 2\n3 1 0 4\n", tm);
  assert(result && mentions(result, "zero area flipped") && result.number_of_degenerate_faces == 0);
  assert(tm.number_of_faces() == 4 && is_near(PMP::area(tm), 2) && number_of_borders(tm) == 1);
  result = read_text("border_needle.off", "OFF\n4 3 0\n0 0 0\n2 0 0\n1 0 0\n1 1 0\n3 0 2 3\n3 2 1 3\n3 0 1 2\n", tm);
  assert(result && tm.number_of_faces() == 2 && is_near(PMP::area(tm), 1));

  // A face that passes through a vertex twice is two faces.
  result = read_text("pinched.off", "OFF\n5 1 0\n0 0 0\n1 -1 0\n1 1 0\n-1 1 0\n-1 -1 0\n6 0 1 2 0 3 4\n", tm);
  assert(result && tm.number_of_faces() == 2 && is_near(PMP::area(tm), 2));
}

void test_soup()
{
  std::cout << "a soup as it is in the file" << std::endl;
  write_text("soup.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n3 0 1 2\n4 0 1 1 2\n");
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
  assert(CGAL::Quad_meshing::read_polygon_soup("soup.off", points, polygons));
  assert(points.size() == 4 && polygons.size() == 3 && polygons[2] == std::vector<std::size_t>({ 0, 1, 1, 2 }));
  assert(CGAL::Quad_meshing::read_polygon_soup("index.off", points, polygons).status == Status::INVALID_INDEX);
  assert(points.size() == 4 && polygons.size() == 3);
}

void test_json()
{
  std::cout << "JSON" << std::endl;
  typedef std::numeric_limits<double> Limits;
  CGAL::Quad_meshing::Flat_json json;
  auto text = [&]() { std::ostringstream os; json.write(os); return os.str(); };
  assert(text() == "{}\n");

  json.set("valid", true);
  json.set("faces", std::size_t(12));
  json.set("index", -3);
  json.set("length", 0.1);
  json.set("nan", Limits::quiet_NaN());
  json.set("infinite", -Limits::infinity());
  json.set("text", "a \"b\" \\ \n\t\r\x01 \xC3\xA4 \xFF \xC0\xAF \xED\xA0\x80 \xE2\x82");
  json.set("faces", 13); // replaces the value, keeps the place
  assert(json.size() == 7);
  assert(text() == "{\n  \"valid\": true,\n  \"faces\": 13,\n  \"index\": -3,\n  \"length\": 0.1,\n  \"nan\": null,\n"
                   "  \"infinite\": null,\n  \"text\": \"a \\\"b\\\" \\\\ \\n\\t\\r\\u0001 \xC3\xA4 \xEF\xBF\xBD "
                   "\xEF\xBF\xBD\xEF\xBF\xBD \xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD \xEF\xBF\xBD\xEF\xBF\xBD\"\n}\n");

  // Numbers read back as they were.
  for(double x : { 0., 1. / 3, -1e300 / 3, 1e-300 / 7, Limits::min(), Limits::max(), Limits::epsilon(), 123456789., 4000. })
    assert(std::strtod(CGAL::Quad_meshing::internal::json_number(x).c_str(), nullptr) == x);
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv, {
    { "formats", test_formats },
    { "refused", test_refused },
    { "repaired", test_repaired },
    { "soup", test_soup },
    { "json", test_json }
  });
}
