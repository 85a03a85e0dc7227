// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Reading of meshes, good, damaged and repairable ones, and writing of JSON.

#include <CGAL/Quad_meshing/IO/Flat_json.h>
#include <CGAL/Quad_meshing/IO/read_polygon_soup.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>

#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/boost/graph/IO/STL.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
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

std::string off_text(const Soup& soup, const std::vector<std::vector<std::size_t>>& more_faces = {})
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

// Messages are sentences in one line, and the numbers of the file fit those of the mesh.
void check_result(const Result& result, const Mesh& tm)
{
  auto is_sentence = [](const std::string& text)
  {
    return !text.empty() && text.back() == '.' && !('a' <= text[0] && text[0] <= 'z') &&
           text.find('\n') == std::string::npos;
  };
  assert(result.is_valid() == result.message.empty());
  if(!result)
  {
    assert(is_sentence(result.message));
    return;
  }
  for(const std::string& repair : result.repairs)
    assert(is_sentence(repair));
  // Vertices that no face names may stay if they are not to be dropped.
  const auto is_isolated = [&](Mesh::Vertex_index v) { return tm.is_isolated(v); };
  const bool has_isolated = std::any_of(tm.vertices().begin(), tm.vertices().end(), is_isolated);
  assert(CGAL::is_triangle_mesh(tm) && (has_isolated || CGAL::is_valid_polygon_mesh(tm)));
  assert(result.vertices.mesh_size() == tm.number_of_vertices() && result.faces.mesh_size() == tm.number_of_faces());
  for(const CGAL::Quad_meshing::File_numbers* numbers : { &result.vertices, &result.faces })
  {
    for(std::size_t i = 0; i < numbers->mesh_size(); ++i)
      assert(numbers->file_number(i) == numbers->none || numbers->file_number(i) < numbers->file_size());
    for(std::size_t n = 0; n < numbers->file_size(); ++n)
      assert(numbers->mesh_number(n) == numbers->none || numbers->mesh_number(n) < numbers->mesh_size());
  }
}

// Reads a text as a file of that name.
Result read_text(const std::string& filename, const std::string& text, Mesh& tm)
{
  write_text(filename, text);
  const Result result = CGAL::Quad_meshing::read_triangle_mesh(filename, tm);
  std::cout << "  " << filename << ": " << result.message;
  for(const std::string& repair : result.repairs)
    std::cout << repair << " ";
  std::cout << std::endl;
  check_result(result, tm);
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

Point_3 centroid(const Mesh& tm, std::size_t f)
{
  const Mesh::Halfedge_index h = tm.halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(f)));
  return CGAL::centroid(tm.point(tm.source(h)), tm.point(tm.target(h)), tm.point(tm.target(tm.next(h))));
}

bool is_near(double a, double b) { return std::abs(a - b) < 1e-9 * (1 + std::abs(b)); }

void test_formats()
{
  std::cout << "the same mesh through all formats" << std::endl;
  const Soup soup = test_meshes::perturbed(test_meshes::torus(12, 7), 0.01);
  const Mesh tm = test_meshes::make_mesh(soup);
  const auto np = CGAL::parameters::stream_precision(17);
  const auto text_np = CGAL::parameters::stream_precision(17).use_binary_mode(false);
  for(const std::string filename :
      { "torus.off", "torus.OBJ", "torus.ply", "torus_text.ply", "torus.stl", "torus_text.stl" })
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
  assert(read_text(
    "a.off",
    "# comment\nOFF # more\n\n3 1 0\r\n0 0 0 1 1 # first\r\n+1 0 0 0.5 0.5\r\n0 1e0 -0 0 1\r\n3 0 1 2 255 0 0\r\n", t));
  assert(t.number_of_faces() == 1 && t.point(Mesh::Vertex_index(1)) == Point_3(1, 0, 0));
  assert(read_text("b.off", "OFF 3 1 0\n" + points + "3 0 1 2", t) && t.number_of_faces() == 1);
  assert(read_text("c.off", "COFF\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n", t));
  assert(read_text("d.off", "4OFF\n3 1 0\n0 0 0 2\n1 0 0 2\n0 1 0 2\n3 0 1 2\n", t));
  assert(t.point(Mesh::Vertex_index(1)) == Point_3(0.5, 0, 0));
  assert(read_text("e.obj",
                   "mtllib x\no thing\nv 0 0 0\nv 1 0 0 1 1 1\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 \\\n 3/1\n", t));
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
  check_refused("garbage.stl", "hello world\n", Status::MALFORMED_FILE, "STL");
  check_refused("garbage.obj", "hello world\n", Status::MALFORMED_FILE, "Line 1");
  check_refused("huge.off", "OFF\n999999999999 5 0\n0 0 0\n", Status::MALFORMED_FILE, "999999999999");
  check_refused("negative.off", "OFF\n-4 1 0\n" + square, Status::MALFORMED_FILE, "-4");
  check_refused("huge.ply",
                "ply\nformat ascii 1.0\nelement vertex 999999999999\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n",
                Status::MALFORMED_FILE, "999999999999");
  check_refused("short.ply",
                "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n0 0 0\n",
                Status::MALFORMED_FILE, "");
  check_refused("word.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 x1 0\n0 1 0\n4 0 1 2 3\n", Status::MALFORMED_FILE, "Line 5");
  check_refused("truncated.off", "OFF\n4 2 0\n" + square + "3 0 1 2\n", Status::MALFORMED_FILE, "ends");
  check_refused("truncated_face.off", "OFF\n4 1 0\n" + square + "4 0 1 2\n", Status::MALFORMED_FILE, "Line 7");
  check_refused("cloud.off", "OFF\n4 0 0\n" + square, Status::NO_FACES, "4 vertices");
  check_refused("cloud.obj", "v 0 0 0\nv 1 0 0\n", Status::NO_FACES, "no faces");
  check_refused("points.off", "OFF\n4 1 0\n" + square + "3 0 1 1\n", Status::NO_FACES, "distinct");
  check_refused("more_faces.off", "OFF\n4 1 0\n" + square + "3 0 1 2\n3 0 2 3\n", Status::MALFORMED_FILE, "Line 8");
  check_refused("joined_lines.off", "OFF\n4 1 0\n0 0 0\n1 0 0 1 1 0\n0 1 0\n4 0 1 2 3\n", Status::MALFORMED_FILE,
                "Line 4");
  check_refused("damaged.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nq 1 2 3\n", Status::MALFORMED_FILE, "Line 5");
  check_refused("free_form.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nsurf 0 1 0 1 1\n", Status::MALFORMED_FILE,
                "free-form");
  check_refused("utf16.obj", std::string("\xFF\xFEv\0 \0", 6), Status::MALFORMED_FILE, "UTF-16");
  check_refused("nOFF.off", "nOFF\n4\n1 0 0\n0 0 0 0\n", Status::MALFORMED_FILE, "dimension");
  check_refused("line.off", "OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n", Status::NO_FACES, "area");
  check_refused("index.off", "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 2 4\n", Status::INVALID_INDEX,
                "face 1 names vertex 4");
  check_refused("negative_index.off", "OFF\n4 1 0\n" + square + "3 0 1 -2\n", Status::INVALID_INDEX, "face 0");
  check_refused("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", Status::INVALID_INDEX,
                "Line 4: face 0 names vertex 3");
  check_refused("zero_index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", Status::INVALID_INDEX, "face 0");
  check_refused("far_index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", Status::INVALID_INDEX, "face 0");
  check_refused("nan.off", "OFF\n4 1 0\n0 0 0\n1 0 0\nnan 1 0\n0 1 0\n4 0 1 2 3\n", Status::INVALID_COORDINATE,
                "vertex 2");
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
  assert(result && mentions(result, "36 faces were reversed") && CGAL::is_closed(tm) && is_near(PMP::volume(tm), 1));

  // A strip closed with a full turn is orientable, however its faces are given.
  soup = test_meshes::cylinder(9, 1, false);
  std::swap(soup.triangles[3][0], soup.triangles[3][1]);
  result = read_text("ring.off", off_text(soup), tm);
  assert(result && mentions(result, "1 face was reversed") && number_of_borders(tm) == 2);

  // Polygons, one of them not convex.
  result = read_text("polygons.obj",
                     "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nv 2 -2 0\nv 0 -2 0\n"
                     "f 1 2 3 4 5\nf 2 1 7 6\n",
                     tm);
  assert(result && mentions(result, "2 polygons were triangulated") && tm.number_of_faces() == 5 &&
         is_near(PMP::area(tm), 6.5));

  // Twice the same face, turned or not, and vertices without a face.
  soup = cube;
  soup.points.insert(soup.points.begin(), Point_3(9, 9, 9));
  for(auto& t : soup.triangles)
    for(std::size_t& v : t)
      ++v;
  soup.triangles.push_back(soup.triangles[5]);
  soup.triangles.push_back({ { soup.triangles[7][1], soup.triangles[7][0], soup.triangles[7][2] } });
  result = read_text("twice.off", off_text(soup), tm);
  assert(result && mentions(result, "1 face equal to another one was dropped") &&
         mentions(result, "1 vertex without a face"));
  assert(mentions(result, "1 face that is the other side of another one was dropped") && CGAL::is_closed(tm));
  assert(tm.number_of_faces() == 108 && tm.number_of_vertices() == 56 && is_near(PMP::volume(tm), 1));

  // A small fin: two triangles back to back on an edge of the cube. It leaves no trace. A large one is somebody's flag.
  for(const double size : { 1e-3, 1. })
  {
    soup = cube;
    const std::size_t a = soup.triangles[0][0], b = soup.triangles[0][1], tip = soup.points.size();
    soup.points.push_back(soup.points[a] + size * (Point_3(-1, -1, -1) - soup.points[a]));
    soup.triangles.push_back({ { a, b, tip } });
    soup.triangles.push_back({ { b, a, tip } });
    result = read_text("fin.off", off_text(soup), tm);
    assert(result && mentions(result, "2 faces of fins") == (size < 1));
    assert(number_of_components(tm) == (size < 1 ? 1 : 2) && number_of_borders(tm) == number_of_components(tm) - 1);
    assert(tm.number_of_faces() == (size < 1 ? 108 : 109) && CGAL::is_closed(tm) == (size < 1));
  }

  // Every triangle with vertices of its own, as in STL.
  soup = Soup();
  for(const auto& t : cube.triangles)
  {
    const std::size_t n = soup.points.size();
    for(std::size_t v : t)
      soup.points.push_back(cube.points[v]);
    soup.triangles.push_back({ { n, n + 1, n + 2 } });
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
  assert(result && mentions(result, "4 edges with more than two faces were separated into sheets, which fit together"));
  assert(number_of_components(tm) == 2 && number_of_borders(tm) == 2 && is_near(PMP::area(tm), 2));
  assert(tm.number_of_vertices() == 25 + 10);

  // A wall that stands on one inner edge only: its foot has the same ends in both sheets.
  soup = floor;
  const std::size_t top = soup.points.size();
  soup.points.push_back(floor.points[11] + test_meshes::Vector_3(0, 0, 1));
  soup.triangles.push_back({ { 11, 12, top } });
  result = read_text("post.off", off_text(soup), tm);
  assert(result && number_of_components(tm) == 2 && tm.number_of_faces() == 33);

  // A triangle of zero area in the surface and one on its border.
  result = read_text("needle.off",
                     "OFF\n5 4 0\n0 0 0\n2 0 0\n1 0 0\n1 1 0\n1 -1 0\n"
                     "3 0 2 3\n3 2 1 3\n3 0 1 2\n3 1 0 4\n",
                     tm);
  assert(result && mentions(result, "1 triangle of zero area was removed") && result.number_of_degenerate_faces == 0);
  assert(tm.number_of_faces() == 4 && is_near(PMP::area(tm), 2) && number_of_borders(tm) == 1);
  result = read_text("border_needle.off", "OFF\n4 3 0\n0 0 0\n2 0 0\n1 0 0\n1 1 0\n3 0 2 3\n3 2 1 3\n3 0 1 2\n", tm);
  assert(result && tm.number_of_faces() == 2 && is_near(PMP::area(tm), 1));

  // A face that passes through a vertex twice is two faces.
  result = read_text("pinched.off", "OFF\n5 1 0\n0 0 0\n1 -1 0\n1 1 0\n-1 1 0\n-1 -1 0\n6 0 1 2 0 3 4\n", tm);
  assert(result && tm.number_of_faces() == 2 && is_near(PMP::area(tm), 2));
}

// A file of triangles that share no vertex, as OBJ.
std::string scattered_obj(const Soup& soup)
{
  std::ostringstream os;
  os.precision(17);
  for(const auto& t : soup.triangles)
    for(std::size_t v : t)
      os << "v " << soup.points[v] << "\n";
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
    os << "f " << 3 * f + 1 << " " << 3 * f + 2 << " " << 3 * f + 3 << "\n";
  return os.str();
}

// The same as STL, text or binary.
std::string stl_text(const Soup& soup)
{
  std::ostringstream os;
  os.precision(17);
  os << "solid part\n";
  for(const auto& t : soup.triangles)
  {
    os << "  facet normal 0 0 0\n    outer loop\n";
    for(std::size_t v : t)
      os << "      vertex " << soup.points[v] << "\n";
    os << "    endloop\n  endfacet\n";
  }
  os << "endsolid part\n";
  return os.str();
}

template <typename T>
void append(std::string& bytes, T value, bool is_big_endian = false)
{
  std::string b(sizeof(T), '\0');
  std::memcpy(&b[0], &value, sizeof(T));
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  if((first == 0) != is_big_endian)
    std::reverse(b.begin(), b.end());
  bytes += b;
}

std::string stl_binary(const Soup& soup, const std::string& header = "binary")
{
  std::string bytes = header;
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(soup.triangles.size()));
  for(const auto& t : soup.triangles)
  {
    for(int d = 0; d < 3; ++d)
      append(bytes, 0.f);
    for(std::size_t v : t)
      for(int d = 0; d < 3; ++d)
        append(bytes, static_cast<float>(soup.points[v][d]));
    append(bytes, std::uint16_t(0));
  }
  return bytes;
}

// PLY with unsigned short indices, a list before the indices and properties behind them.
std::string ply_binary(const Soup& soup, bool is_big_endian)
{
  std::string bytes =
    std::string("ply\nformat ") + (is_big_endian ? "binary_big_endian" : "binary_little_endian") +
    " 1.0\ncomment made by hand\nelement vertex " + std::to_string(soup.points.size()) +
    "\nproperty uchar quality\nproperty double x\nproperty double y\nproperty double z\n"
    "property list uint8 float32 weights\nelement face " +
    std::to_string(soup.triangles.size()) +
    "\nproperty list uint8 double texcoord\nproperty list uint8 uint16 vertex_indices\nproperty int flags\n"
    "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for(const Point_3& p : soup.points)
  {
    append(bytes, std::uint8_t(7));
    for(int d = 0; d < 3; ++d)
      append(bytes, p[d], is_big_endian);
    append(bytes, std::uint8_t(1));
    append(bytes, 0.5f, is_big_endian);
  }
  for(const auto& t : soup.triangles)
  {
    append(bytes, std::uint8_t(2));
    append(bytes, 0.25, is_big_endian);
    append(bytes, 0.75, is_big_endian);
    append(bytes, std::uint8_t(3));
    for(std::size_t v : t)
      append(bytes, static_cast<std::uint16_t>(v), is_big_endian);
    append(bytes, std::int32_t(-1), is_big_endian);
  }
  append(bytes, std::int32_t(0), is_big_endian);
  append(bytes, std::int32_t(1), is_big_endian);
  return bytes;
}

std::string ply_text(const Soup& soup)
{
  std::ostringstream os;
  os.precision(17);
  os << "ply\r\nformat ascii 1.0\r\nobj_info x\r\nelement vertex " << soup.points.size()
     << "\r\nproperty float64 x\r\nproperty float64 y\r\nproperty float64 z\r\nelement face " << soup.triangles.size()
     << "\r\nproperty list char uint vertex_index\r\nend_header\r\n";
  for(const Point_3& p : soup.points)
    os << p << "\r\n";
  for(const auto& t : soup.triangles)
    os << "3 " << t[0] << " " << t[1] << " " << t[2] << "\r\n";
  return os.str();
}

void check_cube(const Result& result, const Mesh& tm, std::size_t vertices, double volume = 1)
{
  assert(result && CGAL::is_closed(tm) && tm.number_of_vertices() == vertices &&
         std::abs(PMP::volume(tm) - volume) < 1e-6);
}

void test_variants()
{
  std::cout << "what formats allow" << std::endl;
  Mesh tm;
  const Soup cube = test_meshes::cube(2);
  const std::string mark = "\xEF\xBB\xBF";
  check_cube(read_text("bom.off", mark + off_text(cube), tm), tm, 26);
  check_cube(read_text("bom.obj", mark + scattered_obj(cube), tm), tm, 26);
  check_cube(read_text("bom.stl", mark + stl_text(cube), tm), tm, 26);
  check_cube(read_text("bom.ply", mark + ply_text(cube), tm), tm, 26);
  check_cube(read_text("little.ply", ply_binary(cube, false), tm), tm, 26);
  check_cube(read_text("big.ply", ply_binary(cube, true), tm), tm, 26);
  check_cube(read_text("binary.stl", stl_binary(cube), tm), tm, 26);
  check_cube(read_text("solid.stl", stl_binary(cube, "solid although binary"), tm), tm, 26);
  std::string upper = stl_text(cube);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  check_cube(read_text("upper.stl", upper, tm), tm, 26);
  check_cube(read_text("two_solids.stl", stl_text(cube) + stl_text(cube), tm), tm, 26);

  // Triangle strips: the second triangle of a strip is turned.
  const std::string strips =
    "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n8 0 1 2 3 -1 2 3 4\n";
  Result result = read_text("strips.ply", strips, tm);
  assert(result && tm.number_of_faces() == 3 && result.counts.reversed_faces == 0 && is_near(PMP::area(tm), 1.5));

  // OFF with prefixes, and in binary form.
  const char* const points[] = { "0 0 0", "1 0 0", "0 1 0" };
  for(const auto& variant :
      { std::make_pair("COFF", " 10 20 30 255"), std::make_pair("NOFF", " 0 0 1"), std::make_pair("STOFF", " 0.5 0.5"),
        std::make_pair("STCNOFF", " 0 0 1 1 1 1 1 0 0"), std::make_pair("off", "") })
  {
    std::string text = std::string(variant.first) + "\n# a comment\n3 1 3\n";
    for(const char* p : points)
      text += std::string("\t") + p + variant.second + " # here too\n\n";
    assert(read_text("variant.off", text + "3 0 1 2 0.1 0.2 0.3\n", tm) && is_near(PMP::area(tm), 0.5));
  }
  std::string binary = "OFF BINARY\n";
  for(int n : { 3, 1, 0 })
    append(binary, std::int32_t(n), true);
  for(float x : { 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f })
    append(binary, x, true);
  for(int n : { 3, 0, 1, 2, 0 })
    append(binary, std::int32_t(n), true);
  assert(read_text("binary.off", binary, tm) && is_near(PMP::area(tm), 0.5));

  // OBJ with tabs, continuation lines, groups, lines and points, and indices of all kinds.
  result = read_text("all.obj",
                     "# x\ng a b\ns off\nusemtl m\nv\t0 0\t0\r\nv 1 0 \\\n 0 0.1 0.2 0.3\nv 0 1 0 1\nvt 0 0\nvn 0 0 1\n"
                     "p 1\nl 1 2\nl 2 3\no second\nf\t1/1/1\t-2//1 3/1 # end\nf 1 3 2/1\n",
                     tm);
  assert(result && tm.number_of_faces() == 1 && mentions(result, "2 line elements were passed over.") &&
         mentions(result, "1 point element"));

  // What is damaged is refused where that shows.
  std::string short_stl = stl_binary(cube);
  short_stl.resize(short_stl.size() - 60);
  check_refused("short.stl", short_stl, Status::MALFORMED_FILE, "46");
  check_refused("no_end.stl", stl_text(cube).substr(0, 300), Status::MALFORMED_FILE, "Line");
  std::string short_ply = ply_binary(cube, false);
  short_ply.resize(short_ply.size() - 20);
  check_refused("short.ply", short_ply, Status::MALFORMED_FILE, "face");
  check_refused("index.ply",
                ply_text(test_meshes::cube(1)).replace(ply_text(test_meshes::cube(1)).rfind("3 "), 3, "3 9"),
                Status::INVALID_INDEX, "vertex 9");
}

// Every face twice, once per side: one copy of each stays, oriented.
void test_two_sided()
{
  std::cout << "two-sided models" << std::endl;
  Mesh tm;
  auto both_sides = [](const Soup& soup)
  {
    Soup both = soup;
    for(const auto& t : soup.triangles)
      both.triangles.push_back({ { t[1], t[0], t[2] } });
    return both;
  };
  const Soup cube = test_meshes::cube(2);
  Result result = read_text("cube.off", off_text(both_sides(cube)), tm);
  check_cube(result, tm, 26);
  assert(mentions(result, "48 faces that are the other side of another one were dropped") &&
         result.counts.reversed_faces == 0);
  for(std::size_t n = 0; n < 96; ++n)
    assert(result.faces.mesh_number(n) != result.faces.none &&
           result.faces.mesh_number(n) == result.faces.mesh_number((n + 48) % 96));

  // The same outwards, whichever side comes first, and with vertices of their own for each side, or for each triangle.
  Soup inside_out = cube;
  for(auto& t : inside_out.triangles)
    std::swap(t[0], t[1]);
  check_cube(read_text("inside_out.off", off_text(both_sides(inside_out)), tm), tm, 26);
  result = read_text("own_vertices.off", off_text(test_meshes::joined(cube, inside_out)), tm);
  check_cube(result, tm, 26);
  for(std::size_t n = 0; n < 26; ++n)
    assert(result.vertices.mesh_number(n) == result.vertices.mesh_number(n + 26));
  check_cube(read_text("scattered.obj", scattered_obj(both_sides(cube)), tm), tm, 26);

  const Soup sheet = test_meshes::grid(6, 6);
  result = read_text("sheet.off", off_text(both_sides(sheet)), tm);
  assert(result && tm.number_of_faces() == 72 && number_of_borders(tm) == 1 && is_near(PMP::area(tm), 1));
  Soup turned = sheet;
  for(auto& t : turned.triangles)
    std::swap(t[0], t[1]);
  result = read_text("own_sheet.off", off_text(test_meshes::joined(sheet, turned)), tm);
  assert(result && tm.number_of_faces() == 72 && number_of_borders(tm) == 1 && tm.number_of_vertices() == 49);

  // Quads, whose sides begin at different corners.
  result = read_text("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\nf 2 1 4 3\n", tm);
  assert(result && tm.number_of_faces() == 2 && result.counts.other_sides == 1);

  // A two-sided box with a one-sided square keeps both; a two-sided sheet on a box, and one that closes it, too.
  Soup soup = both_sides(cube);
  soup = test_meshes::joined(soup, test_meshes::translated(test_meshes::grid(1, 1), test_meshes::Vector_3(3, 0, 0)));
  result = read_text("cube_and_square.off", off_text(soup), tm);
  assert(result && tm.number_of_faces() == 50 && number_of_components(tm) == 2 && number_of_borders(tm) == 1);
  soup = cube;
  const Soup lid = both_sides(
    Soup{ { cube.points[soup.triangles[0][0]], cube.points[soup.triangles[0][1]], cube.points[soup.triangles[0][2]] },
          { { { 0, 1, 2 } } } });
  soup.triangles.erase(soup.triangles.begin());
  check_cube(read_text("lid.obj", scattered_obj(test_meshes::joined(soup, lid)), tm), tm, 26);

  // Two boxes that touch in a whole side are two boxes, told apart by their vertices or not.
  for(int n : { 1, 2 })
  {
    const Soup box = test_meshes::cube(n);
    const Soup boxes = test_meshes::joined(box, test_meshes::translated(box, test_meshes::Vector_3(1, 0, 0)));
    for(const bool is_scattered : { false, true })
    {
      result = read_text(is_scattered ? "boxes.obj" : "boxes.stl",
                         is_scattered ? scattered_obj(boxes) : stl_binary(boxes), tm);
      assert(result && CGAL::is_closed(tm) && number_of_components(tm) == 2 && is_near(PMP::volume(tm), 2));
    }
    result = read_text("boxes.off", off_text(boxes), tm);
    assert(result && result.repairs.empty() && CGAL::is_closed(tm) && number_of_components(tm) == 2);
  }
}

void test_merging()
{
  std::cout << "merging of vertices" << std::endl;
  Mesh tm;
  const Soup cube = test_meshes::cube(1);

  // Two boxes that share an edge, each triangle with vertices of its own.
  Result result =
    read_text("edge.obj", scattered_obj(test_meshes::joined(cube, test_meshes::translated(cube, { 1, 1, 0 }))), tm);
  assert(result && CGAL::is_closed(tm) && number_of_components(tm) == 2 && tm.number_of_vertices() == 16 &&
         is_near(PMP::volume(tm), 2));
  assert(result.counts.merged_vertices == 56 && result.counts.separated_edges == 1);

  // Voxels: many such edges and vertices, one solid where they share a side.
  auto is_filled = [](int i, int j, int k) { return (i * 7 + j * 5 + k * 3) % 4 < 2; };
  Soup voxels;
  double volume = 0;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 4; ++j)
      for(int k = 0; k < 4; ++k)
        if(is_filled(i, j, k))
        {
          voxels = test_meshes::joined(voxels, test_meshes::translated(cube, test_meshes::Vector_3(i, j, k)));
          ++volume;
        }
  result = read_text("voxels.obj", scattered_obj(voxels), tm);
  assert(result && CGAL::is_closed(tm) && is_near(PMP::volume(tm), volume) &&
         number_of_components(tm) == static_cast<std::size_t>(volume));

  // Noise where coordinates should be equal, from rounding in double precision up to the accuracy of STL.
  for(const double noise : { 6e-17, 1e-12, 1e-8, 1e-7 })
  {
    Soup loose;
    CGAL::Random random(3);
    for(const auto& t : test_meshes::cube(4).triangles)
    {
      for(std::size_t v : t)
      {
        const Point_3 p = test_meshes::cube(4).points[v];
        loose.points.push_back(Point_3(p.x() + random.uniform_real(-noise, noise),
                                       p.y() + random.uniform_real(-noise, noise),
                                       p.z() + random.uniform_real(-noise, noise)));
      }
      const std::size_t n = loose.points.size();
      loose.triangles.push_back({ { n - 3, n - 2, n - 1 } });
    }
    result = read_text("noisy.off", off_text(loose), tm);
    check_cube(result, tm, 98);
  }

  // Small features stay: a box with a slot as narrow as the noise above, a tiny box, and sheets close to each other.
  const double narrow = 1e-7;
  Soup slot = test_meshes::l_prism(1);
  result = read_text(
    "flat.obj",
    scattered_obj(test_meshes::mapped(slot, [&](const Point_3& p) { return Point_3(p.x(), p.y(), narrow * p.z()); })),
    tm);
  assert(result && CGAL::is_closed(tm) && number_of_components(tm) == 1);
  assert(tm.number_of_vertices() == test_meshes::make_mesh(slot).number_of_vertices());
  const Soup tiny =
    test_meshes::mapped(cube, [](const Point_3& p) { return Point_3(5 + 1e-8 * p.x(), 1e-8 * p.y(), 1e-8 * p.z()); });
  result = read_text("tiny.obj", scattered_obj(test_meshes::joined(cube, tiny)), tm);
  assert(result && CGAL::is_closed(tm) && number_of_components(tm) == 2 && tm.number_of_vertices() == 16 &&
         tm.number_of_faces() == 24);
  const Soup sheet = test_meshes::grid(3, 3);
  result = read_text("sheets.obj",
                     scattered_obj(test_meshes::joined(sheet, test_meshes::translated(sheet, { 0, 0, 1e-5 }))), tm);
  assert(result && number_of_components(tm) == 2 && number_of_borders(tm) == 2);

  // What is closed already is left alone, however near its parts are.
  result =
    read_text("shells.off", off_text(test_meshes::joined(cube, test_meshes::translated(cube, { 1 + 1e-9, 0, 0 }))), tm);
  assert(result && result.repairs.empty() && number_of_components(tm) == 2);

  // A cut closes; that of a Moebius strip stays open, as its surface has one side only otherwise.
  Soup ring = test_meshes::strip(9);
  ring = test_meshes::mapped(ring,
                             [](const Point_3& p)
                             {
                               return p.x() == 9 ? Point_3(1, 0, p.y())
                                                 : Point_3(std::cos(p.x() * 2 * CGAL_PI / 9),
                                                           std::sin(p.x() * 2 * CGAL_PI / 9), p.y());
                             });
  result = read_text("ring.off", off_text(ring), tm);
  assert(result && number_of_borders(tm) == 2 && tm.number_of_vertices() == 18 && result.counts.merged_vertices == 2);
  Soup moebius = test_meshes::strip(9);
  moebius = test_meshes::mapped(moebius,
                                [](const Point_3& p)
                                {
                                  const double a = p.x() * 2 * CGAL_PI / 9, w = p.y() - 0.5;
                                  if(p.x() == 9)
                                    return Point_3(3 - w, 0, 0);
                                  return Point_3((3 + w * std::cos(a / 2)) * std::cos(a),
                                                 (3 + w * std::cos(a / 2)) * std::sin(a), w * std::sin(a / 2));
                                });
  result = read_text("cut_moebius.off", off_text(moebius), tm);
  assert(result && number_of_borders(tm) == 1 && tm.number_of_vertices() == 20);
  check_refused("loose_moebius.obj", scattered_obj(moebius), Status::NOT_ORIENTABLE, "Moebius");

  // A crack that is too wide to close is said: its vertices fit on one side, or on none.
  Soup cracked =
    test_meshes::joined(test_meshes::grid(4, 4), test_meshes::translated(test_meshes::grid(5, 4), { 1 + 1e-4, 0, 0 }));
  result = read_text("cracked.off", off_text(cracked), tm);
  assert(result && number_of_components(tm) == 2 && result.number_of_crack_edges == 8 && mentions(result, "cracks"));
  assert(read_text("grid.off", off_text(test_meshes::grid(4, 4)), tm).number_of_crack_edges == 0);
}

// Cracks with vertices on one side only: the edges of the other side are split at them.
void test_border_junctions()
{
  std::cout << "vertices on border edges" << std::endl;
  Mesh tm;
  // Two squares side by side, less than the tolerance apart, with 4 and 8 edges where they meet.
  auto squares = [](int left, int right)
  {
    return test_meshes::joined(test_meshes::grid(3, left),
                               test_meshes::translated(test_meshes::grid(2, right), { 1 + 1e-7, 0, 0 }));
  };
  Result result = read_text("squares.off", off_text(squares(4, 8)), tm);
  assert(result && number_of_components(tm) == 1 && number_of_borders(tm) == 1 && result.number_of_crack_edges == 0);
  assert(result.counts.split_border_edges == 4 && mentions(result, "split"));
  assert(tm.number_of_faces() == 2 * 12 + 2 * 16 + 4 && tm.number_of_vertices() == 4 * 5 + 3 * 9 - 5);
  for(std::size_t f = 0; f < result.faces.mesh_size(); ++f)
    assert(result.faces.file_number(f) < 2 * 12 + 2 * 16 &&
           (result.faces.file_number(f) < 2 * 12) == (centroid(tm, f).x() < 1));
  assert(std::abs(PMP::area(tm) - 2) < 1e-6);

  // Vertices of both sides lie on edges of the other one.
  result = read_text("squares.off", off_text(squares(4, 6)), tm);
  assert(result && number_of_components(tm) == 1 && number_of_borders(tm) == 1);
  assert(result.counts.split_border_edges == 4 + 2 && tm.number_of_faces() == 2 * 12 + 2 * 12 + 4 + 2);

  // Wider than the tolerance, or without the repair, the crack stays.
  CGAL::Quad_meshing::Mesh_repairs repairs;
  repairs.merging_distance = 1e-9;
  for(const CGAL::Quad_meshing::Mesh_repairs& r : { repairs, CGAL::Quad_meshing::Mesh_repairs(false) })
  {
    result = CGAL::Quad_meshing::read_triangle_mesh("squares.off", tm, CGAL::parameters::repair(r));
    assert(result && number_of_components(tm) == 2 && result.counts.split_border_edges == 0);
    assert(result.number_of_crack_edges > 0);
  }

  // A corner that touches an edge of another surface joins nothing.
  Soup touching = test_meshes::grid(2, 2);
  touching.points.insert(touching.points.end(), { Point_3(1, 0.3, 0), Point_3(2, 0, 0), Point_3(2, 1, 0) });
  touching.triangles.push_back({ { 9, 10, 11 } });
  result = read_text("touching.off", off_text(touching), tm);
  assert(result && result.counts.split_border_edges == 0 && tm.number_of_faces() == 9 && result.repairs.empty());

  // A box with a lid of its own, that is finer.
  Soup box = test_meshes::cube(2);
  auto is_lid = [&](const auto& t)
  { return box.points[t[0]].z() == 1 && box.points[t[1]].z() == 1 && box.points[t[2]].z() == 1; };
  box.triangles.erase(std::remove_if(box.triangles.begin(), box.triangles.end(), is_lid), box.triangles.end());
  box = test_meshes::joined(box, test_meshes::translated(test_meshes::grid(6, 6), { 0, 0, 1 }));
  for(const char* name : { "box.off", "box.stl" })
  {
    result = read_text(name, name[4] == 'o' ? off_text(box) : stl_text(box), tm);
    assert(result && CGAL::is_closed(tm) && number_of_components(tm) == 1 && is_near(PMP::volume(tm), 1));
    assert(result.counts.split_border_edges == 8 && tm.number_of_faces() == 40 + 72 + 16);
  }
}

// Triangles of zero area go before sheets are separated.
void test_flat_triangles()
{
  std::cout << "triangles of zero area" << std::endl;
  Mesh tm;
  // A box, one of whose edges carries a fan of flat triangles in each of several ways.
  for(const double height : { 0., 1e-17 })
  {
    std::ostringstream os;
    os.precision(17);
    // vertices 0..7 of the box, 8, 9, 10 on the edge from 0 to 1
    os << "OFF\n11 18 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n0 0 4\n4 0 4\n4 4 4\n0 4 4\n1 0 0\n2 " << height << " 0\n3 0 0\n"
       << "3 0 3 2\n3 0 2 1\n3 4 5 6\n3 4 6 7\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n"
       // the front, with the vertices in the edge, and the bottom, without: the triangles between them are flat
       << "3 0 8 4\n3 8 9 4\n3 9 10 4\n3 10 5 4\n3 10 1 5\n3 0 9 8\n3 0 1 9\n3 9 1 10\n";
    const Result result = read_text("box.off", os.str(), tm);
    assert(result && CGAL::is_closed(tm) && number_of_components(tm) == 1 && result.counts.flattened_faces == 3);
    assert(tm.number_of_vertices() == 11 && tm.number_of_faces() == 18 && is_near(PMP::volume(tm), 64));
    assert(result.number_of_degenerate_faces == 0);
  }

  // As STL has them: collinear vertices, rounded to single precision, in a plate whose bottom does not use them.
  const int n = 12;
  Soup plate;
  auto add = [&](double x, double y, double z)
  {
    plate.points.push_back(Point_3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)));
    return plate.points.size() - 1;
  };
  auto on_edge = [&](int i) { return std::array<double, 2>{ { 10 + 7.3 * i / n, 20 + 3.1 * i / n } }; };
  std::vector<std::size_t> edge;
  for(int i = 0; i <= n; ++i)
    edge.push_back(add(on_edge(i)[0], on_edge(i)[1], 0));
  const std::size_t top = add(12, 30, 5), bottom = add(12, 30, -5);
  for(int i = 0; i < n; ++i)
    plate.triangles.push_back({ { edge[static_cast<std::size_t>(i)], edge[static_cast<std::size_t>(i) + 1], top } });
  for(int i = 1; i < n; ++i)
    plate.triangles.push_back(
      { { edge[0], edge[static_cast<std::size_t>(i) + 1], edge[static_cast<std::size_t>(i)] } });
  plate.triangles.push_back({ { edge[n], edge[0], bottom } });
  plate.triangles.push_back({ { edge[0], top, bottom } });
  plate.triangles.push_back({ { top, edge[n], bottom } });
  const Result result = read_text("wedge.stl", stl_binary(plate), tm);
  assert(result && CGAL::is_closed(tm) && number_of_components(tm) == 1 && result.number_of_degenerate_faces == 0);
  assert(result.counts.flattened_faces == n - 1 && tm.number_of_vertices() == static_cast<std::size_t>(n) + 3);

  // A fine mesh far from the origin is not taken for one of flat triangles.
  const Soup fine = test_meshes::mapped(
    test_meshes::cube(4), [](const Point_3& p) { return Point_3(1000 + p.x() / 256, p.y() / 256, p.z() / 256); });
  assert(read_text("fine.stl", stl_binary(fine), tm).counts.flattened_faces == 0 && tm.number_of_faces() == 192);
}

// A house with an inner wall: three sheets, and the roof in the plane of the wall's top.
void test_sheets()
{
  std::cout << "sheets that meet" << std::endl;
  Mesh tm;
  const std::string house =
    "OFF\n12 20 0\n0 0 0\n3 0 0\n8 0 0\n0 6 0\n3 6 0\n8 6 0\n0 0 3\n3 0 3\n8 0 3\n0 6 3\n3 6 3\n8 6 3\n"
    "3 0 3 4\n3 0 4 1\n3 1 4 5\n3 1 5 2\n3 6 7 10\n3 6 10 9\n3 7 8 11\n3 7 11 10\n3 0 1 7\n3 0 7 6\n3 1 2 8\n3 1 8 7\n"
    "3 3 10 4\n3 3 9 10\n3 4 11 5\n3 4 10 11\n3 0 6 9\n3 0 9 3\n3 2 5 11\n3 2 11 8\n";
  std::string with_wall = house;
  with_wall.replace(with_wall.find("12 20"), 5, "12 22");
  Result result = read_text("house.off", with_wall + "3 1 7 10\n3 1 10 4\n", tm);
  assert(result && number_of_components(tm) == 2 && number_of_borders(tm) == 1 && is_near(PMP::area(tm), 180 + 18));
  assert(mentions(result, "4 edges with more than two faces were separated into sheets, which fit together once they "
                          "are meshed only if they are made to."));
  // The vertices of the wall's sheet are those of the file too.
  std::size_t split = 0;
  for(std::size_t v = 0; v < 16; ++v)
    split += result.vertices.file_number(v) != v;
  assert(tm.number_of_vertices() == 16 && split == 4);

  // Two edges with the same two ends get a vertex in between.
  Soup post = test_meshes::grid(4, 4);
  const std::size_t top = post.points.size();
  post.points.push_back(post.points[11] + test_meshes::Vector_3(0, 0, 1));
  post.points.push_back(post.points[11] + test_meshes::Vector_3(0, 0, -1));
  post.triangles.push_back({ { 11, 12, top } });
  post.triangles.push_back({ { 12, 11, top + 1 } });
  result = read_text("posts.off", off_text(post), tm);
  assert(result && tm.number_of_faces() >= 34 && is_near(PMP::area(tm), 1 + 0.25));
}

// Numbers of vertices and faces in results are those of the file.
void test_numbers()
{
  std::cout << "numbers of the file" << std::endl;
  Mesh tm;
  Result result =
    read_text("unused.off", "OFF\n5 2 0\n100 100 100\n0 0 0\n1 -3 0\n2 0 0\n1 3 0\n3 1 2 3\n3 1 3 4\n", tm);
  assert(result && result.vertices.mesh_number(0) == result.vertices.none && result.vertices.file_size() == 5);
  for(std::size_t v = 1; v < 5; ++v)
    assert(result.vertices.mesh_number(v) == v - 1 && result.vertices.file_number(v - 1) == v);
  assert(tm.point(Mesh::Vertex_index(2)) == Point_3(2, 0, 0) && result.faces.is_identity());

  // Points of the mesh are those of the file, in any mixture of repairs.
  CGAL::Random random(5);
  Soup soup;
  for(int i = 0; i < 3; ++i)
    soup =
      test_meshes::joined(soup, test_meshes::translated(test_meshes::cube(2), test_meshes::Vector_3(i % 2, i / 2, 0)));
  for(int i = 0; i < 20; ++i)
  {
    soup.points.push_back(Point_3(random.uniform_real(2., 3.), 5, 5));
    auto t = soup.triangles[static_cast<std::size_t>(random.get_int(0, static_cast<int>(soup.triangles.size())))];
    if(i % 2 == 0)
      std::swap(t[0], t[1]);
    soup.triangles.push_back(t);
  }
  std::reverse(soup.triangles.begin(), soup.triangles.end());
  result = read_text("mixed.off", off_text(soup), tm);
  assert(result && result.counts.unused_vertices == 20);
  for(Mesh::Vertex_index v : tm.vertices())
    assert(tm.point(v) == soup.points[result.vertices.file_number(v)]);
  for(std::size_t n = 0; n < soup.points.size(); ++n)
    assert((result.vertices.mesh_number(n) == result.vertices.none) == (soup.points[n].y() == 5));
  for(Mesh::Face_index f : tm.faces())
  {
    std::vector<Point_3> corners, expected;
    for(Mesh::Vertex_index v : CGAL::vertices_around_face(tm.halfedge(f), tm))
      corners.push_back(tm.point(v));
    for(std::size_t v : soup.triangles[result.faces.file_number(f)])
      expected.push_back(soup.points[v]);
    assert(std::is_permutation(corners.begin(), corners.end(), expected.begin(), expected.end()));
  }

  // Halfedges are those that CGAL gives when it adds the faces one after the other.
  for(const Soup& s : { test_meshes::torus(7, 5), test_meshes::grid_with_hole(5, 5, 1, 3, 2, 4), test_meshes::cube(3) })
  {
    const Mesh expected = test_meshes::make_mesh(s);
    assert(read_text("numbers.off", off_text(s), tm) && tm.number_of_halfedges() == expected.number_of_halfedges());
    for(Mesh::Halfedge_index h : tm.halfedges())
      assert(tm.target(h) == expected.target(h) && tm.next(h) == expected.next(h) && tm.face(h) == expected.face(h));
    for(Mesh::Vertex_index v : tm.vertices())
      assert(tm.halfedge(v) == expected.halfedge(v));
    for(Mesh::Face_index f : tm.faces())
      assert(tm.halfedge(f) == expected.halfedge(f));
  }
}

// Every repair can be switched off; then a file is read as it is or refused.
void test_switches()
{
  std::cout << "switches of repairs" << std::endl;
  typedef CGAL::Quad_meshing::Mesh_repairs Repairs;
  namespace params = CGAL::parameters;
  Mesh tm;
  const Soup cube = test_meshes::cube(2);
  auto read = [&](const std::string& text, const Repairs& repairs)
  {
    write_text("switch.off", text);
    const Result result = CGAL::Quad_meshing::read_triangle_mesh("switch.off", tm, params::repair(repairs));
    check_result(result, tm);
    return result;
  };
  auto without = [](bool Repairs::*repair)
  {
    Repairs repairs;
    repairs.*repair = false;
    return repairs;
  };

  Soup soup = cube;
  soup.points.insert(soup.points.begin(), Point_3(9, 9, 9));
  for(auto& t : soup.triangles)
    for(std::size_t& v : t)
      ++v;
  Result result = read(off_text(soup), false);
  assert(result && result.repairs.empty() && tm.number_of_vertices() == 27 && result.vertices.is_identity());
  write_text("switch.off", off_text(soup));
  assert(CGAL::Quad_meshing::read_triangle_mesh("switch.off", tm, params::repair(false)) &&
         tm.number_of_vertices() == 27);
  assert(read(off_text(soup), without(&Repairs::drop_unused_vertices)) && tm.number_of_vertices() == 27);
  assert(read(off_text(soup), true) && tm.number_of_vertices() == 26);

  soup = test_meshes::joined(test_meshes::grid(1, 1), test_meshes::translated(test_meshes::grid(1, 1), { 1, 0, 0 }));
  assert(read(off_text(soup), without(&Repairs::merge_vertices)) && number_of_components(tm) == 2);
  assert(read(off_text(soup), true) && number_of_components(tm) == 1);
  soup.points[4] = soup.points[4] + test_meshes::Vector_3(1e-4, 0, 0);
  soup.points[6] = soup.points[6] + test_meshes::Vector_3(1e-4, 0, 0);
  Repairs coarse;
  coarse.merging_distance = 1e-3;
  assert(read(off_text(soup), true) && number_of_components(tm) == 2);
  assert(read(off_text(soup), coarse) && number_of_components(tm) == 1);

  soup = cube;
  soup.triangles.push_back(soup.triangles[5]);
  assert(read(off_text(soup), false).status == Status::NEEDS_REPAIR);
  result = read(off_text(cube, { { 0, 1, 1 } }), without(&Repairs::drop_copies));
  assert(result.status == Status::NEEDS_REPAIR &&
         result.message.find("1 face with fewer than three") != std::string::npos);

  const std::string needle = "OFF\n5 4 0\n0 0 0\n2 0 0\n1 0 0\n1 1 0\n1 -1 0\n3 0 2 3\n3 2 1 3\n3 0 1 2\n3 1 0 4\n";
  result = read(needle, without(&Repairs::flatten_faces));
  assert(result && result.number_of_degenerate_faces == 1 && mentions(result, "1 triangle of zero area is left."));
  assert(tm.number_of_faces() == 4 && result.faces.is_identity());

  soup = cube;
  std::swap(soup.triangles[3][0], soup.triangles[3][1]);
  result = read(off_text(soup), without(&Repairs::orient_faces));
  assert(result.status == Status::NEEDS_REPAIR && result.message.find("1 face would") != std::string::npos);

  soup = test_meshes::grid(2, 2);
  soup.points.push_back(Point_3(0.5, 0.5, 1));
  soup.triangles.push_back({ { 4, 5, 9 } });
  result = read(off_text(soup), without(&Repairs::separate_sheets));
  assert(result.status == Status::NEEDS_REPAIR && result.message == "There is 1 edge with more than two faces.");
  result = read("OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n", false);
  assert(result.status == Status::NEEDS_REPAIR &&
         result.message == "There is 1 vertex at which the surface touches itself.");
}

// Polygons of all shapes.
void test_polygons()
{
  std::cout << "polygons" << std::endl;
  Mesh tm;
  // A comb: many reflex corners, in a tilted plane, in both directions.
  std::vector<Point_3> comb = { Point_3(0, 0, 0), Point_3(20, 0, 0) };
  for(int i = 20; i-- > 0;)
  {
    comb.push_back(Point_3(i + 1, 5, 0));
    comb.push_back(Point_3(i + 0.5, i % 3 + 1, 0));
  }
  comb.push_back(Point_3(0, 5, 0));
  double area = 0;
  for(std::size_t i = 0; i < comb.size(); ++i)
  {
    const Point_3 &p = comb[i], &q = comb[(i + 1) % comb.size()];
    area += 0.5 * (p.x() * q.y() - p.y() * q.x());
  }
  for(const bool is_reversed : { false, true })
  {
    std::ostringstream os;
    os.precision(17);
    std::string face = "f";
    for(std::size_t i = 0; i < comb.size(); ++i)
    {
      const Point_3& p = comb[is_reversed ? comb.size() - 1 - i : i];
      os << "v " << p.x() << " " << p.y() << " " << 2 * p.x() - p.y() << "\n";
      face += " " + std::to_string(i + 1);
    }
    const Result result = read_text("comb.obj", os.str() + face + "\n", tm);
    assert(result && tm.number_of_faces() == comb.size() - 2 && is_near(PMP::area(tm), area * std::sqrt(6.)));
  }

  // A square with a square hole, reached over a slit.
  const std::string hole = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n";
  Result result = read_text("hole.obj", hole + "f 1 2 3 4 1 5 6 7 8 5\n", tm);
  assert(result && number_of_borders(tm) == 2 && tm.number_of_vertices() == 8 && tm.number_of_faces() == 8 &&
         is_near(PMP::area(tm), 8));

  // Two quads on the same four vertices, as a pillow: their diagonals must differ, or one edge gets a vertex.
  result =
    read_text("pillow.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 2 3 4\nf 1 4 5\nf 4 3 5\nf 3 2 5\nf 2 1 5\n", tm);
  assert(result && CGAL::is_closed(tm) && is_near(std::abs(PMP::volume(tm)), 1. / 3));
}

// A hundred files with a damaged byte for each of many small files: they are refused or read as some mesh, quickly.
void test_fuzz()
{
  std::cout << "damaged files" << std::endl;
  const Soup cube = test_meshes::cube(1), grid = test_meshes::grid(2, 2);
  const std::string head = "# comment\nmtllib x.mtl\n";
  const std::vector<std::pair<std::string, std::string>> files = {
    { "a.off", off_text(cube) },
    { "b.off", off_text(grid, { { 0, 1, 4, 3 } }) },
    { "c.off", "COFF\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n" },
    { "d.off", "4OFF\n3 1 0\n0 0 0 2\n1 0 0 2\n0 1 0 2\n3 0 1 2\n" },
    { "e.off", "OFF # comment\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2 255 0 0\r\n" },
    { "f.off", std::string("OFF BINARY\n\0\0\0\3\0\0\0\1\0\0\0\0", 23) + std::string(36, '\1') +
                 std::string("\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0\0", 20) },
    { "g.obj", scattered_obj(cube) },
    { "h.obj", head + "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf -4 -3 \\\n -2\nl 1 2\n" },
    { "i.obj", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1\n" },
    { "j.obj", scattered_obj(grid) },
    { "k.ply", ply_binary(cube, false) },
    { "l.ply", ply_binary(cube, true) },
    { "m.ply", ply_text(cube) },
    { "n.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
               "z\nelement tristrips 1\n"
               "property list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n5 0 1 2 3 -1\n" },
    { "o.ply", ply_binary(grid, false) },
    { "p.ply", ply_text(grid) },
    { "q.stl", stl_text(cube) },
    { "r.stl", stl_binary(cube) },
    { "s.stl", stl_binary(grid, "solid") },
    { "t.stl", stl_text(grid) }
  };
  CGAL::Random random(11);
  std::size_t refused = 0, number = 0;
  CGAL::Timer timer;
  timer.start();
  for(const auto& file : files)
    for(int i = 0; i < 100; ++i, ++number)
    {
      std::string bytes = file.second;
      const std::size_t place = static_cast<std::size_t>(random.get_int(0, static_cast<int>(bytes.size())));
      switch(i % 4)
      {
        case 0: bytes[place] = static_cast<char>(random.get_int(0, 256)); break;
        case 1: bytes.erase(place, 1); break;
        case 2: bytes.insert(place, 1, static_cast<char>(random.get_int(0, 256))); break;
        default: bytes.resize(place); break;
      }
      write_text("damaged_" + file.first, bytes);
      Mesh tm;
      const double before = timer.time();
      const Result result = CGAL::Quad_meshing::read_triangle_mesh("damaged_" + file.first, tm);
      assert(timer.time() - before < 1);
      check_result(result, tm);
      refused += !result;
      // Of a file that ends early nothing is lost in silence, but for what lies behind the last face.
      if(i % 4 == 3 && result && file.first.find(".obj") == std::string::npos)
      {
        write_text("whole_" + file.first, file.second);
        Mesh whole;
        assert(CGAL::Quad_meshing::read_triangle_mesh("whole_" + file.first, whole));
        assert(tm.number_of_faces() == whole.number_of_faces());
      }
    }
  std::cout << "  " << refused << " of " << number << " refused, " << timer.time() << " s" << std::endl;
  assert(2 * refused > number);
}

// Large elements take no time that grows with their square.
void test_large_elements()
{
  std::cout << "many faces at an edge, many corners at a place" << std::endl;
  Mesh tm;
  CGAL::Timer timer;
  timer.start();
  const int n = 30000;
  std::ostringstream book, face;
  book << "v 0 0 0\nv 0 0 1\n";
  for(int i = 0; i < n; ++i)
    book << "v " << std::cos(0.01 + i * 1e-4) << " " << std::sin(0.01 + i * 1e-4) << " 0.5\n";
  for(int i = 0; i < n; ++i)
    book << "f 1 2 " << i + 3 << "\n";
  assert(read_text("book.obj", book.str(), tm) && tm.number_of_faces() >= static_cast<std::size_t>(n));
  face << "v 0 0 0\nv 1 0 0\nv 1 1 0\nf";
  for(int i = 0; i < n; ++i)
    face << " 1 1 2 1 2 2";
  Result result = read_text("repeated.obj", face.str() + " 3\nf 1 2 3\n", tm);
  assert(result && tm.number_of_faces() == 1 && is_near(PMP::area(tm), 0.5));
  std::cout << "  " << timer.time() << " s" << std::endl;
  assert(timer.time() < 10);
}

// Names of statuses are those of their enumerators.
void test_status_names()
{
  assert(status_name(Status::SUCCESS) == std::string("success") &&
         status_name(Status::NEEDS_REPAIR) == std::string("needs_repair"));
  assert(status_name(Status::CANNOT_OPEN) == std::string("cannot_open") &&
         status_name(Status::NOT_ORIENTABLE) == std::string("not_orientable"));
}

void test_soup()
{
  std::cout << "a soup as it is in the file" << std::endl;
  write_text("soup.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n3 0 1 2\n4 0 1 1 2\n");
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  assert(CGAL::Quad_meshing::read_polygon_soup("soup.off", points, polygons));
  assert(points.size() == 4 && polygons.size() == 3 && polygons[2] == std::vector<std::size_t>({ 0, 1, 1, 2 }));
  std::vector<std::array<double, 3>> coordinates;
  std::vector<std::vector<std::size_t>> same_polygons;
  assert(CGAL::Quad_meshing::read_polygon_soup("soup.off", coordinates, same_polygons) && same_polygons == polygons);
  assert(coordinates.size() == 4 && coordinates[3][2] == 5);
  write_text("index_3.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
  assert(CGAL::Quad_meshing::read_polygon_soup("index_3.off", points, polygons).status == Status::INVALID_INDEX);
  assert(points.size() == 4 && polygons.size() == 3);
}

void test_json()
{
  std::cout << "JSON" << std::endl;
  typedef std::numeric_limits<double> Limits;
  CGAL::Quad_meshing::Flat_json json;
  auto text = [&]()
  {
    std::ostringstream os;
    json.write(os);
    return os.str();
  };
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
  for(double x :
      { 0., 1. / 3, -1e300 / 3, 1e-300 / 7, Limits::min(), Limits::max(), Limits::epsilon(), 123456789., 4000. })
    assert(std::strtod(CGAL::Quad_meshing::internal::json_number(x).c_str(), nullptr) == x);
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "formats", test_formats },
                     { "refused", test_refused },
                     { "repaired", test_repaired },
                     { "variants", test_variants },
                     { "two_sided", test_two_sided },
                     { "merging", test_merging },
                     { "border_junctions", test_border_junctions },
                     { "flat_triangles", test_flat_triangles },
                     { "sheets", test_sheets },
                     { "numbers", test_numbers },
                     { "switches", test_switches },
                     { "polygons", test_polygons },
                     { "fuzz", test_fuzz },
                     { "large_elements", test_large_elements },
                     { "status_names", test_status_names },
                     { "soup", test_soup },
                     { "json", test_json } });
}
