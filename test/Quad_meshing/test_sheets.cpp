// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Surfaces with edges of more than two faces: the quads of their sheets meet vertex to vertex.

#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace test_meshes;
namespace QM = CGAL::Quad_meshing;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

typedef std::array<double, 3> Place;
typedef std::array<Place, 2> Place_pair;

Place place(const Point_3& p) { return { { p.x(), p.y(), p.z() } }; }

// The number of faces at each edge, where points with the same coordinates are one.
template <typename AnyMesh>
std::map<Place_pair, std::size_t> faces_at_edges(const AnyMesh& m)
{
  std::map<Place_pair, std::size_t> result;
  for(auto h : m.halfedges())
    if(!m.is_border(h))
    {
      const Place a = place(m.point(m.source(h))), b = place(m.point(m.target(h)));
      ++result[a < b ? Place_pair{ { a, b } } : Place_pair{ { b, a } }];
    }
  return result;
}

// Reads a soup through a file, as a user does, and makes quads of it. All edges with one face must lie where `is_outer`
// says, and where edges of the input have more than two faces, those of the quads have as many.
QM::Quadrangulation_result check(const std::string& name, const Soup& soup, double quads, std::size_t junctions,
                                 const std::function<bool(const Point_3&)>& is_outer)
{
  {
    std::ofstream file(name + ".off");
    file << std::setprecision(17) << "OFF\n" << soup.points.size() << " " << soup.triangles.size() << " 0\n";
    for(const Point_3& p : soup.points)
      file << p << "\n";
    for(const auto& t : soup.triangles)
      file << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  }
  Mesh tm;
  const QM::Mesh_reading_result reading = QM::read_triangle_mesh(name + ".off", tm);
  assert(reading.is_valid() && reading.counts.separated_edges == junctions);
  QM::Quadrangulation q(tm, tm.points());
  q.options.target_number_of_quads = quads;
  q.options.meet_at_junctions = true;
  const QM::Quadrangulation_result r = q.run();
  const auto& qm = q.quads().mesh;
  std::cout << name << ", " << quads << ": " << r.message << " " << qm.number_of_faces() << " quads" << std::endl;
  assert(r.is_valid() && r.unmet_guides.empty() && CGAL::is_quad_mesh(qm) && r.quads == qm.number_of_faces());
  assert(CGAL::is_valid_polygon_mesh(qm) && r.folded_quads <= 1);

  // The length of the edges by their number of faces is that of the triangles.
  std::map<std::size_t, double> of_triangles, of_quads;
  const auto length = [](const Place_pair& e) {
    return std::sqrt(std::pow(e[0][0] - e[1][0], 2) + std::pow(e[0][1] - e[1][1], 2) + std::pow(e[0][2] - e[1][2], 2));
  };
  for(const auto& e : faces_at_edges(tm))
    of_triangles[e.second] += length(e.first);
  for(const auto& e : faces_at_edges(qm))
  {
    of_quads[e.second] += length(e.first);
    if(e.second == 1)
      for(const Place& p : e.first)
        assert(is_outer(Point_3(p[0], p[1], p[2])));
  }
  for(const auto& l : of_triangles)
    if(l.first != 2)
      assert(std::abs(of_quads[l.first] - l.second) < 0.03 * l.second); // chords of round curves are shorter
  for(auto v : qm.vertices())
    assert(q.quads().input_face[v] < tm.number_of_faces());
  return r;
}

bool nowhere(const Point_3&) { return false; }

// Two rooms below a roof: the walls, the inner wall and the ceilings meet along lines that meet in points.
void test_house()
{
  Soup house;
  for(double x : { 0., 3., 8. })
  {
    for(const std::array<double, 2>& c :
        { std::array<double, 2>{ { 0, 0 } }, { { 0, 3 } }, { { 3, 5 } }, { { 6, 0 } }, { { 6, 3 } } })
      house.points.emplace_back(x, c[0], c[1]);
  }
  const auto add = [&](std::initializer_list<std::size_t> c)
  {
    const std::vector<std::size_t> v(c);
    for(std::size_t k = 2; k < v.size(); ++k)
      house.triangles.push_back({ { v[0], v[k - 1], v[k] } });
  };
  for(std::size_t x : { 0u, 5u })
  {
    add({ x + 0, x + 5, x + 6, x + 1 });
    add({ x + 8, x + 3, x + 4, x + 9 });
    add({ x + 0, x + 3, x + 8, x + 5 });
    add({ x + 1, x + 6, x + 9, x + 4 });
    add({ x + 1, x + 6, x + 7, x + 2 });
    add({ x + 9, x + 4, x + 2, x + 7 });
  }
  add({ 0, 3, 4, 1 });
  add({ 5, 8, 9, 6 });
  add({ 10, 13, 14, 11 });
  add({ 1, 2, 4 });
  add({ 11, 12, 14 });
  for(double quads : { 150., 500., 1300. })
    check("house", house, quads, 10, nowhere);
}

// Pages of different widths that share one side: nothing else relates their numbers.
void test_book()
{
  const int n = 7;
  Soup book;
  for(int page = 0; page < 5; ++page)
  {
    const double width = 0.4 + 0.37 * page, angle = 1.3 * page;
    const Soup s = mapped(grid(3, n, width, 2), [&](const Point_3& p)
                          { return Point_3(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()); });
    book = joined(book, s);
  }
  // one vertex per place
  std::map<Place, std::size_t> numbers;
  Soup merged;
  for(const auto& t : book.triangles)
  {
    merged.triangles.push_back(t);
    for(auto& v : merged.triangles.back())
    {
      const Point_3 p = book.points[v];
      const auto added = numbers.emplace(place(p), merged.points.size());
      if(added.second)
        merged.points.push_back(p);
      v = added.first->second;
    }
  }
  for(double quads : { 100., 400. })
    check("book", merged, quads, n,
          [](const Point_3& p) { return p.x() * p.x() + p.y() * p.y() > 1e-9 || p.z() < 1e-9 || p.z() > 2 - 1e-9; });
}

// A tube with a disc inside: the curve is round and closed, without any node.
void test_closed_curve()
{
  const int n = 48, m = 8;
  Soup tube = cylinder(n, m, false, 1, 2);
  std::vector<std::size_t> ring; // of the middle, by angle
  for(std::size_t v = 0; v < tube.points.size(); ++v)
    if(std::abs(tube.points[v].z() - tube.points[0].z() - 1) < 1e-9)
      ring.push_back(v);
  const auto angle = [&](std::size_t v) { return std::atan2(tube.points[v].y(), tube.points[v].x()); };
  std::sort(ring.begin(), ring.end(), [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
  assert(ring.size() == static_cast<std::size_t>(n));
  const std::size_t center = tube.points.size();
  tube.points.emplace_back(0, 0, tube.points[ring[0]].z());
  for(std::size_t k = 0; k < ring.size(); ++k)
    tube.triangles.push_back({ { center, ring[k], ring[(k + 1) % ring.size()] } });
  const double z = tube.points[center].z();
  for(double quads : { 300., 1000. })
    check("tube", tube, quads, static_cast<std::size_t>(n),
          [&](const Point_3& p) { return std::abs(std::abs(p.z() - z) - 1) < 1e-6; });
}

// Without the wish, or without sheets, nothing changes.
void test_only_if_asked()
{
  const Mesh tm = make_mesh<Mesh>(cube(3));
  std::array<std::size_t, 2> number;
  for(std::size_t i = 0; i < 2; ++i)
  {
    QM::Quadrangulation q(tm, tm.points());
    q.options.target_number_of_quads = 200;
    q.options.meet_at_junctions = i == 1;
    assert(q.run().is_as_requested);
    number[i] = q.quads().mesh.number_of_faces();
  }
  assert(number[0] == number[1]);
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "house", test_house },
                     { "book", test_book },
                     { "closed_curve", test_closed_curve },
                     { "only_if_asked", test_only_if_asked } });
}
