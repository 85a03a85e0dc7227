// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Grid-preserving operators: after every operator the mesh is a pure quad mesh of the same topology with the same
// irregular vertices, by checks that know nothing of the operators.

#include "quad_mesh_checks.h"
#include "structure_meshes.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Structure/grid_preserving_operators.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_execution.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_search.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>

#include <cassert>
#include <functional>
#include <iostream>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace SM = structure_meshes;
typedef SM::Mesh Mesh;
typedef CGAL::Polyhedron_3<SM::Kernel> Polyhedron;
typedef QM::internal::Indexed_quad_mesh Flat_mesh;
typedef QM::Grid_preserving_step_kind Kind;

namespace {

struct Figures
{
  std::map<int, std::size_t> inner, border;
  int euler = 0;
  std::size_t loops = 0;

  bool operator==(const Figures& f) const
  {
    return inner == f.inner && border == f.border && euler == f.euler && loops == f.loops;
  }
};

// From the list of polygons alone.
Figures figures_of(const Flat_mesh& m)
{
  Figures r;
  const std::size_t nv = m.points.size();
  std::map<std::pair<int, int>, int> faces_at;
  for(const std::array<int, 4>& c : m.corners)
    for(int k = 0; k < 4; ++k)
      ++faces_at[std::minmax(c[k], c[(k + 1) % 4])];
  std::vector<int> valence(nv, 0);
  std::vector<std::vector<int>> along_border(nv);
  for(const auto& e : faces_at)
  {
    const int a = e.first.first, b = e.first.second;
    ++valence[a];
    ++valence[b];
    if(e.second == 1)
    {
      along_border[a].push_back(b);
      along_border[b].push_back(a);
    }
  }
  for(std::size_t v = 0; v < nv; ++v)
  {
    const bool border = !along_border[v].empty();
    if(valence[v] != (border ? 3 : 4))
      ++(border ? r.border : r.inner)[valence[v]];
  }
  r.euler = int(nv) - int(faces_at.size()) + int(m.corners.size());
  std::vector<char> seen(nv, 0);
  for(std::size_t v = 0; v < nv; ++v)
    if(!along_border[v].empty() && !seen[v])
    {
      ++r.loops;
      std::vector<int> todo(1, int(v));
      while(!todo.empty())
      {
        const int w = todo.back();
        todo.pop_back();
        if(seen[w])
          continue;
        seen[w] = 1;
        todo.insert(todo.end(), along_border[w].begin(), along_border[w].end());
      }
    }
  return r;
}

Flat_mesh flat(const SM::Quad_soup& soup) { return QM::internal::make_indexed_quad_mesh(SM::make_mesh(soup)).mesh; }

bool is_sound(const Flat_mesh& m)
{
  const QM::Quad_mesh_defects d = QM::find_quad_mesh_defects(m.points, m.corners);
  return d.is_pure_quad_mesh() && d.isolated_vertices == 0;
}

// Random operators on one mesh, which starts anew when it has become small.
int random_operators(const char* name, const SM::Quad_soup& soup, int wanted, unsigned int seed)
{
  const Flat_mesh input = flat(soup);
  const Figures expected = figures_of(input);
  CGAL::Random random(seed);
  Flat_mesh m = input;
  int done = 0, failures = 0;
  long crossings = 0;
  while(done < wanted && failures < wanted)
  {
    const QM::internal::Quad_vertex_rules rules = QM::internal::make_quad_vertex_rules(m, false);
    QM::internal::Gp_search search(m, rules);
    QM::internal::Gp_path path;
    for(int attempt = 0; attempt < 10 && path.empty(); ++attempt)
      path = search.close({ 3 * random.get_int(0, m.number_of_halfedges()) + random.get_int(0, 3) });
    QM::internal::Gp_execution execution(m, path);
    if(path.empty())
    {
      ++failures;
      m = input;
      continue;
    }
    std::map<int, int> visits;
    for(const QM::internal::Gp_step& s : path)
      if(s.in != -1 && ++visits[s.in / 4] == 2)
        ++crossings;
    const Flat_mesh result = execution.execute(std::vector<char>(m.number_of_vertices(), 0));
    if(!QM::internal::is_valid_quad_mesh(result))
    {
      // two edges would have the same ends: not executed
      ++failures;
      continue;
    }
    assert(is_sound(result));
    assert(figures_of(result) == expected);
    ++done;
    m = result.number_of_faces() * 3 < input.number_of_faces() ? input : result;
  }
  std::cout << "  " << name << ": " << done << " operators, " << crossings << " faces passed twice, " << failures
            << " failures" << std::endl;
  return done;
}

void test_random_operators()
{
  std::cout << "random operators" << std::endl;
  const test_meshes::Soup ball = test_meshes::icosphere(1);
  std::vector<SM::Point_3> points;
  for(const auto& p : ball.points)
    points.emplace_back(p.x(), p.y(), p.z());
  int done = 0;
  done += random_operators("sphere, 32 x 3 patches refined",
                           SM::refined(SM::split_triangles(points, ball.triangles), 2), 1500, 1);
  done += random_operators("cube", SM::cube(8), 4000, 2);
  done += random_operators("torus with a helix", SM::rolled(16, 12, 2, true), 3000, 3);
  done += random_operators("cylinder with a helix", SM::rolled(16, 12, 1, false), 3000, 4);
  done += random_operators("rectangle", SM::grid(12, 9), 3000, 5);
  assert(done > 12000);
}

// The same operators through the graph interface, on two kinds of graphs.
template <typename QuadMesh>
void test_graph_interface(const char* name)
{
  std::cout << "operators on " << name << std::endl;
  typedef typename boost::graph_traits<QuadMesh>::halfedge_descriptor halfedge_descriptor;
  QuadMesh qm = SM::make_mesh<QuadMesh>(SM::refined(SM::cube(2), 3));
  const QM::Quad_mesh_structure before = QM::quad_mesh_structure(qm);
  CGAL::Random random(7);
  int done = 0;
  for(int i = 0; i < 40; ++i)
  {
    std::vector<halfedge_descriptor> all;
    for(halfedge_descriptor h : halfedges(qm))
      all.push_back(h);
    const auto op =
      QM::find_grid_preserving_operator(qm, all[random.get_int(0, int(all.size()))], Kind(random.get_int(0, 3)));
    if(op.empty() || !QM::apply_grid_preserving_operator(qm, op))
      continue;
    ++done;
    assert(CGAL::is_valid_polygon_mesh(qm) && CGAL::is_quad_mesh(qm));
    const QM::Quad_mesh_structure s = QM::quad_mesh_structure(qm);
    assert(s.inner_valences == before.inner_valences && s.euler_characteristic == 2);
    assert(quad_mesh_checks::figures(qm).consistent && quad_mesh_checks::figures(qm).vertex_manifold);
  }
  assert(done > 5);
}

void test_constraints()
{
  std::cout << "constraints" << std::endl;
  // the twelve edges of a cube are features: they stay, with their corners where they are
  Mesh qm = SM::make_mesh(SM::cube(6));
  auto feature = qm.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  auto on_cube_edge = [&](Mesh::Edge_index e)
  {
    int fixed = 0;
    const SM::Point_3 &p = qm.point(qm.vertex(e, 0)), &q = qm.point(qm.vertex(e, 1));
    for(int k = 0; k < 3; ++k)
      fixed += std::abs(p[k]) == 1 && p[k] == q[k];
    return fixed == 2;
  };
  auto marked = [&]
  {
    std::size_t n = 0;
    for(auto e : qm.edges())
      n += feature[e];
    return n;
  };
  for(auto e : qm.edges())
    feature[e] = on_cube_edge(e);
  assert(marked() == 12 * 6);
  CGAL::Random random(11);
  int done = 0;
  for(int i = 0; i < 60; ++i)
  {
    std::vector<Mesh::Halfedge_index> all(qm.halfedges().begin(), qm.halfedges().end());
    const auto np = CGAL::parameters::edge_is_constrained_map(feature);
    const Mesh::Halfedge_index h = all[random.get_int(0, int(all.size()))];
    const Kind kind = Kind(random.get_int(0, 3));
    const auto op = QM::find_grid_preserving_operator(qm, h, kind, np);
    if(feature[qm.edge(h)] && kind != Kind::COLLAPSE)
      assert(op.empty());
    for(const auto& step : op)
      assert(step.kind == Kind::COLLAPSE || !feature[qm.edge(step.halfedge)]);
    if(op.empty() || !QM::apply_grid_preserving_operator(qm, op, np))
      continue;
    ++done;
    for(auto e : qm.edges())
      assert(feature[e] == on_cube_edge(e));
    std::size_t corners = 0;
    for(auto v : qm.vertices())
      corners += std::abs(qm.point(v).x()) == 1 && std::abs(qm.point(v).y()) == 1 && std::abs(qm.point(v).z()) == 1;
    assert(corners == 8);
  }
  assert(done > 3);

  // a cost that forbids a step keeps it away
  Mesh sphere = SM::make_mesh(SM::cube(5));
  const Mesh::Halfedge_index start = *sphere.halfedges().begin();
  const auto cheap = QM::find_grid_preserving_operator(sphere, start, Kind::COLLAPSE);
  assert(!cheap.empty());
  const Mesh::Edge_index avoided = sphere.edge(cheap[cheap.size() / 2].halfedge);
  auto cost = [&](const QM::Grid_preserving_step<Mesh>& s) { return sphere.edge(s.halfedge) == avoided ? 1e6 : 1.; };
  const auto detour = QM::find_grid_preserving_operator(
    sphere, start, Kind::COLLAPSE,
    CGAL::parameters::operator_step_cost(std::function<double(const QM::Grid_preserving_step<Mesh>&)>(cost)));
  for(const auto& s : detour)
    assert(sphere.edge(s.halfedge) != avoided);

  // what is not an operator is refused, and nothing happens
  QM::Grid_preserving_operator<Mesh> broken = cheap;
  broken.pop_back();
  assert(!QM::apply_grid_preserving_operator(sphere, broken) && sphere.number_of_faces() == 150);
}

void test_dual_curve_operators()
{
  std::cout << "collapse and flip of dual curves" << std::endl;
  Mesh cube = SM::make_mesh(SM::cube(4));
  const auto collapse = QM::dual_curve_operator(cube, *cube.halfedges().begin(), Kind::COLLAPSE);
  assert(collapse.size() == 16);
  assert(QM::apply_grid_preserving_operator(cube, collapse) && cube.number_of_faces() == 96 - 16);
  assert(QM::quad_mesh_structure(cube).number_of_patches == 6);

  // the flip of a ring of a torus makes the curves that cross it one helix, and back
  Mesh torus = SM::make_mesh(SM::rolled(9, 7, 0, true));
  Mesh::Halfedge_index h = *torus.halfedges().begin();
  while(QM::dual_curve_operator(torus, h, Kind::COLLAPSE).size() != 7)
    ++h;
  const auto left = QM::dual_curve_operator(torus, h, Kind::SHIFT_LEFT);
  assert(left.size() == 7 && QM::apply_grid_preserving_operator(torus, left));
  assert(torus.number_of_faces() == 63);
  const auto helices = QM::minimal_q_helices(torus);
  assert(helices.size() == 1 && std::abs(helices[0].pitch) == 1 && helices[0].turn_length == 9 &&
         helices[0].length == 63);
  Mesh::Halfedge_index g = *torus.halfedges().begin();
  while(QM::dual_curve_operator(torus, g, Kind::COLLAPSE).size() != 7)
    ++g;
  bool unwound = false;
  for(Kind kind : { Kind::SHIFT_LEFT, Kind::SHIFT_RIGHT })
  {
    Mesh copy = torus;
    const auto flip = QM::dual_curve_operator(copy, g, kind);
    unwound = unwound || (QM::apply_grid_preserving_operator(copy, flip) && QM::minimal_q_helices(copy).empty());
  }
  assert(unwound);
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "random_operators", test_random_operators },
                     { "surface_mesh", [] { test_graph_interface<Mesh>("Surface_mesh"); } },
                     { "polyhedron", [] { test_graph_interface<Polyhedron>("Polyhedron_3"); } },
                     { "constraints", test_constraints },
                     { "dual_curve_operators", test_dual_curve_operators } });
}
