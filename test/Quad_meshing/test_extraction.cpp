// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "extraction_meshes.h"
#include "quad_mesh_checks.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>

#include <cassert>
#include <cmath>
#include <iostream>
#include <map>
#include <utility>
#include <vector>

using namespace extraction_meshes;
using quad_mesh_checks::Mesh_figures;
using quad_mesh_checks::figures;

typedef CGAL::Quad_meshing::Quad_extraction_result Result;
typedef CGAL::Quad_meshing::Quad_extraction_status Status;
typedef std::pair<Mesh::Face_index, std::array<double, 3> > Location;
typedef Mesh::Property_map<Mesh::Vertex_index, Location> Location_map;

namespace params = CGAL::parameters;

// Locations lie in their faces, their images are grid points, and they give the points of the quad mesh.
void check_locations(const Mapped_mesh& m, const Mesh& qm, const Location_map& locations)
{
  for(auto v : qm.vertices())
  {
    const Location l = locations[v];
    auto h = m.mesh.halfedge(l.first);
    double x = 0, y = 0;
    CGAL::Vector_3<Kernel> p(0, 0, 0);
    for(int i = 0; i < 3; ++i)
    {
      assert(l.second[i] >= 0 && l.second[i] <= 1);
      const auto before = m.mesh.prev(h);
      x += l.second[i] * m.uv[before].x();
      y += l.second[i] * m.uv[before].y();
      p = p + l.second[i] * (m.mesh.point(m.mesh.source(h)) - CGAL::ORIGIN);
      h = m.mesh.next(h);
    }
    assert(std::fabs(x - std::round(x)) < 1e-9 && std::fabs(y - std::round(y)) < 1e-9);
    assert(CGAL::squared_distance(CGAL::ORIGIN + p, qm.point(v)) < 1e-20);
  }
}

// The valences that remain of a coarse mesh in a finer one.
std::map<int, std::size_t> irregular(const std::map<int, std::size_t>& valences, int regular)
{
  std::map<int, std::size_t> r = valences;
  r.erase(regular);
  return r;
}

// An exact map gives the quad mesh it was made from.
void check_exact(const Coarse_mesh& coarse, const Options& o, bool simple = true)
{
  const Mapped_mesh m = triangulated(coarse, o);
  const Mesh_figures tf = figures(m.mesh);
  assert(tf.consistent && tf.vertex_manifold);

  Mesh qm;
  Location_map locations = qm.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
  const Result r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm, params::face_location_map(locations));
  const Mesh_figures qf = figures(qm);

  if(r.status != (simple ? Status::VALID : Status::NOT_SIMPLE))
    std::cerr << r.message << " k=" << o.k << " seed=" << o.seed << std::endl;
  assert(r.status == (simple ? Status::VALID : Status::NOT_SIMPLE));
  assert(qf.is_valid());
  assert(qf.is_simple() == simple);
  assert(qf.same_topology(tf));
  assert(qf.faces == coarse.quads.size() * o.k * o.k);
  assert(qf.index_sum() == 4 * qf.euler());
  assert(r.quads == qf.faces && r.vertices == qf.vertices && r.other_faces == 0);
  assert(r.irregular_vertices == qf.irregular_vertices());
  assert(r.edges_cut_by_border == 0 && r.uncovered_area == 0 && r.holes_closed == 0 && r.removed_edges == 0 && r.split_vertices == 0);
  check_locations(m, qm, locations);

  // The irregular vertices are those of the coarse mesh.
  Options coarsest = o;
  coarsest.k = 1;
  coarsest.denominator = 8;
  Mesh cm;
  const Mapped_mesh mc = triangulated(coarse, coarsest);
  CGAL::Quad_meshing::extract_quad_mesh(mc.mesh, mc.uv, cm);
  const Mesh_figures cf = figures(cm);
  assert(cf.faces == coarse.quads.size());
  assert(irregular(cf.inner_valences, 4) == irregular(qf.inner_valences, 4));
  assert(irregular(cf.border_valences, 3) == irregular(qf.border_valences, 3));

  // Other charts, same mesh.
  Mapped_mesh other(m);
  shuffle_charts(other, o.seed + 17);
  Mesh qo;
  CGAL::Quad_meshing::extract_quad_mesh(other.mesh, other.uv, qo);
  assert(qo.number_of_vertices() == qm.number_of_vertices() && qo.number_of_edges() == qm.number_of_edges());
  auto sorted = [](const Mesh& mesh)
  {
    std::vector<Point_3> p;
    for(auto v : mesh.vertices())
      p.push_back(Point_3(std::round(1e6 * mesh.point(v).x()), std::round(1e6 * mesh.point(v).y()), std::round(1e6 * mesh.point(v).z())));
    std::sort(p.begin(), p.end());
    return p;
  };
  assert(sorted(qo) == sorted(qm));
}

void test_exact_maps()
{
  auto full = [](int, int) { return true; };
  auto l_shape = [](int i, int j) { return i == 0 || j == 0; };
  auto annulus = [](int i, int j) { return i != 1 || j != 1; };

  std::vector<Coarse_mesh> shapes;
  shapes.push_back(coarse_cube());
  shapes.push_back(coarse_plane(3, 2, full));
  shapes.push_back(coarse_plane(3, 3, l_shape));
  shapes.push_back(coarse_plane(3, 3, annulus));
  shapes.push_back(coarse_torus(4, 3, 0));
  shapes.push_back(coarse_torus(4, 3, 1));
  shapes.push_back(coarse_torus(5, 3, 2));
  shapes.push_back(coarse_cylinder(4, 2));
  shapes.push_back(joined(coarse_cube(), joined(coarse_torus(3, 4, 1), coarse_fan(2))));
  for(int valence = 3; valence <= 9; ++valence)
    shapes.push_back(coarse_cone(valence));
  for(int squares = 1; squares <= 9; ++squares)
    shapes.push_back(coarse_fan(squares));

  // From triangles with hundreds of grid points to grid cells with dozens of triangles; denominators
  // from 1 (all vertices on grid points) to one that makes coincidences rare.
  struct { int k, inner, edge, denominator; } const densities[] = {
    { 1, 4, 1, 2 }, { 1, 30, 5, 16 }, { 2, 3, 1, 1 }, { 2, 10, 2, 2 }, { 3, 5, 3, 4 }, { 4, 40, 6, 1 }, { 5, 2, 1, 8 },
    { 7, 30, 6, 2 }, { 20, 3, 1, 1 }, { 30, 4, 2, 64 }, { 3, 100, 12, 1048576 } };
  unsigned int seed = 1;
  for(const Coarse_mesh& c : shapes)
    for(const auto& d : densities)
    {
      Options o;
      o.k = d.k; o.inner_points = d.inner; o.edge_points = d.edge; o.denominator = d.denominator; o.seed = ++seed;
      check_exact(c, o);
    }
}

int main()
{
  test_exact_maps();
  std::cout << "test_extraction: done" << std::endl;
  return 0;
}
