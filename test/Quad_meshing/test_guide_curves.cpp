// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Random curves on several models: quad edges lie along them; twenty curves that cross each other leave a valid mesh.

#include "quad_mesh_checks.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/Guides/Polyline_tracer.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>
#include <CGAL/Quad_meshing/quadrangulate.h>

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace test_meshes;
namespace QM = CGAL::Quad_meshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;
typedef Mesh::Vertex_index Vertex;

namespace {

// Curves between random vertices that are a tenth to two fifths of the diagonal apart.
std::vector<QM::Guide_curve> random_curves(const Mesh& tm, std::size_t number, unsigned int seed)
{
  std::mt19937 random(seed);
  const CGAL::Bbox_3 box = PMP::bbox(tm);
  const double diagonal = std::sqrt(std::pow(box.x_span(), 2) + std::pow(box.y_span(), 2) + std::pow(box.z_span(), 2));
  std::vector<QM::Guide_curve> curves;
  while(curves.size() < number)
  {
    auto point = [&] { return tm.point(Vertex(static_cast<Mesh::size_type>(random() % tm.number_of_vertices()))); };
    const Point_3 p = point(), q = point();
    const double d = std::sqrt(CGAL::squared_distance(p, q));
    if(d < 0.1 * diagonal || d > 0.4 * diagonal)
      continue;
    QM::Guide_curve c;
    c.points = { p, q };
    curves.push_back(c);
  }
  return curves;
}

// The share of a curve, traced on the surface, that is nearer to an edge of quads than a tenth of a length: chords of
// bent curves leave them.
double share_on_edges(const Mesh& tm, const Mesh& qm, const QM::Guide_curve& curve)
{
  typedef CGAL::AABB_segment_primitive<Kernel, std::vector<Kernel::Segment_3>::const_iterator> Primitive;
  std::vector<Kernel::Segment_3> edges;
  for(auto e : qm.edges())
    edges.emplace_back(qm.point(qm.vertex(e, 0)), qm.point(qm.vertex(e, 1)));
  const CGAL::AABB_tree<QM::internal::Aabb_traits<Kernel, Primitive>> tree(edges.cbegin(), edges.cend());
  typedef QM::Polyline_tracer<Mesh, Mesh::Property_map<Vertex, Point_3>> Tracer;
  Tracer tracer(tm, tm.points());
  std::vector<Tracer::Face_location> path;
  assert(tracer.trace(curve.points, false, path));
  double on = 0, all = 0;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Point_3 p = tracer.point(path[i]), q = tracer.point(path[i + 1]);
    const Vector_3 along = q - p;
    const int parts = 1 + static_cast<int>(std::sqrt(along.squared_length()) * 200);
    for(int k = 0; k < parts; ++k)
    {
      const Point_3 m = p + ((k + 0.5) / parts) * along;
      const double l = std::sqrt(along.squared_length()) / parts;
      const auto nearest = tree.closest_point_and_primitive(m);
      const Vector_3 edge = nearest.second->to_vector();
      const double cosine = std::abs(along * edge) / std::sqrt(along.squared_length() * edge.squared_length());
      all += l;
      if(CGAL::squared_distance(nearest.first, m) < 0.01 * edge.squared_length() && cosine > 0.9)
        on += l;
    }
  }
  return on / all;
}

struct Model
{
  std::string name;
  Mesh mesh;
};

// Three that are made here, and three of CGAL's, if they are there.
std::vector<Model> models()
{
  std::vector<Model> result;
  result.push_back({ "torus", make_mesh(torus(80, 40, 1, 0.4)) });
  result.push_back({ "bumpy ball", make_mesh(mapped(icosphere(5),
                                                    [](const Point_3& p)
                                                    {
                                                      const double r =
                                                        1 + 0.15 * std::sin(4 * p.x()) * std::cos(5 * p.y());
                                                      return Point_3(r * p.x(), r * p.y(), r * p.z());
                                                    })) });
  result.push_back({ "box", make_mesh(cube(12)) });
  for(const std::string name : { "elephant", "homer", "eight" })
  {
    Model m;
    m.name = name;
    const std::string filename = CGAL::data_file_path("meshes/" + name + ".off");
    if(std::ifstream(filename) && CGAL::IO::read_polygon_mesh(filename, m.mesh))
      result.push_back(m);
    else
      std::cout << name << " is not there and is skipped" << std::endl;
  }
  return result;
}

bool is_valid(const Mesh& qm, const Mesh& tm)
{
  const auto q = quad_mesh_checks::figures(qm);
  return q.is_valid() && q.is_simple() && q.same_topology(quad_mesh_checks::figures(tm));
}

void test_random_curves()
{
  for(const Model& m : models())
  {
    const std::vector<QM::Guide_curve> curves = random_curves(m.mesh, 3, 11);
    Mesh qm;
    const auto r = QM::quadrangulate(m.mesh, qm, params::feature_curves(curves).target_number_of_quads(3000));
    std::cout << m.name << ": " << r.message << " " << r.total_seconds << " s" << std::endl;
    assert(r.is_valid() && is_valid(qm, m.mesh));
    for(std::size_t i = 0; i < curves.size(); ++i)
    {
      const double share = share_on_edges(m.mesh, qm, curves[i]);
      std::cout << "  " << share << " on edges" << std::endl;
      const std::string name = "curve " + std::to_string(i + 1) + " ";
      if(r.message.find(name) == std::string::npos)
        assert(share > 0.96);
    }
    assert(r.unmet_guides.size() <= 1);
  }
}

void test_crossing_curves()
{
  for(const Model& m : models())
    if(m.name == "bumpy ball" || m.name == "torus")
    {
      Mesh qm;
      const auto r = QM::quadrangulate(
        m.mesh, qm, params::feature_curves(random_curves(m.mesh, 20, 5)).target_number_of_quads(3000));
      std::cout << m.name << ": " << r.message << " " << r.total_seconds << " s" << std::endl;
      assert(r.is_valid() && is_valid(qm, m.mesh));
      // what was given up is told, curve by curve
      assert(r.unmet_guides.size() < 20 && r.is_as_requested == r.unmet_guides.empty());
    }
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "random_curves", test_random_curves }, { "crossing_curves", test_crossing_curves } });
}
