// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Tests of quadrangulate(): the whole line on generated meshes and, where CGAL's data are there, on a real one.

#undef NDEBUG
#include "quad_mesh_checks.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>
#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Parameterization/integer_grid_map.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Surface_components.h>
#include <CGAL/Quad_meshing/Pipeline/internal/release_features.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/quadrangulate.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/algorithm.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace parameters = CGAL::parameters;

typedef test_meshes::Mesh Mesh;
typedef test_meshes::Kernel Kernel;
typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
typedef QM::Quadrangulation_result Result;
typedef QM::Quadrangulation_status Status;

namespace {

// Runs the line and checks what must hold of every valid result with the tests' own means.
template <typename TriangleMesh>
Mesh quads_of(const TriangleMesh& tm, double quads, const char* what, double tolerance = 0.25)
{
  Mesh qm;
  const Result r = QM::quadrangulate(tm, qm, parameters::target_number_of_quads(quads));
  std::cout << what << ": " << r.message << " " << r.quads << " quads, " << r.irregular_vertices
            << " irregular vertices, " << r.folded_quads << " folded" << std::endl;
  assert(r.is_valid());
  const auto before = quad_mesh_checks::figures(tm), after = quad_mesh_checks::figures(qm);
  assert(after.is_valid() && after.is_simple());
  assert(after.same_topology(before));
  assert(after.index_sum() == 4 * before.euler());
  std::size_t irregular = after.irregular_vertices(); // inside; on the border three edges are regular
  for(const auto& v : after.border_valences)
    irregular += v.first != 3 ? v.second : 0;
  assert(after.quads == r.quads && irregular == r.irregular_vertices);
  assert(std::abs(r.quads / quads - 1) < tolerance);
  assert(r.flipped_triangles == 0 && r.input_faces == before.faces);
  return qm;
}

double length_on_lines(const Mesh& qm, const std::function<bool(const Kernel::Point_3&)>& on_line)
{
  double length = 0;
  for(Mesh::Edge_index e : qm.edges())
  {
    const auto p = qm.point(qm.vertex(e, 0)), q = qm.point(qm.vertex(e, 1));
    if(on_line(p) && on_line(q) && on_line(CGAL::midpoint(p, q)))
      length += std::sqrt(CGAL::squared_distance(p, q));
  }
  return length;
}

// The twelve edges of the unit cube are chains of quad edges.
void test_features()
{
  const Mesh qm = quads_of(test_meshes::make_mesh(test_meshes::cube(7)), 600, "cube", 0.01);
  auto extreme = [](double x) { return std::abs(x) < 1e-9 || std::abs(x - 1) < 1e-9; };
  auto on_edge = [&](const Kernel::Point_3& p) { return extreme(p.x()) + extreme(p.y()) + extreme(p.z()) >= 2; };
  assert(std::abs(length_on_lines(qm, on_edge) - 12) < 1e-9);
}

void test_border()
{
  const Mesh qm =
    quads_of(test_meshes::make_mesh(test_meshes::grid_with_hole(14, 14, 5, 9, 5, 9)), 500, "square with a hole");
  double length = 0;
  for(Mesh::Edge_index e : qm.edges())
    if(qm.is_border(e))
      length += std::sqrt(CGAL::squared_distance(qm.point(qm.vertex(e, 0)), qm.point(qm.vertex(e, 1))));
  assert(std::abs(length - (4 + 4 * 4. / 14)) < 1e-9);
}

// Places on the input reproduce the points, with and without smoothing.
void test_locations()
{
  const Mesh tm = test_meshes::make_mesh(test_meshes::icosphere(3));
  for(unsigned int steps : { 0u, 10u })
  {
    Mesh qm;
    auto location =
      qm.add_property_map<Mesh::Vertex_index, std::pair<Mesh::Face_index, std::array<double, 3>>>("v:l").first;
    const Result r = QM::quadrangulate(
      tm, qm, parameters::target_number_of_quads(300.).smoothing_iterations(steps).face_location_map(location));
    assert(r.is_valid());
    for(Mesh::Vertex_index v : qm.vertices())
    {
      const auto p = CGAL::Polygon_mesh_processing::construct_point(location[v], tm);
      assert(CGAL::squared_distance(p, qm.point(v)) < 1e-12);
    }
  }
}

// The numbering of the input, its scale and the graph type must not change what comes out; neither may a second run.
void test_invariance()
{
  const test_meshes::Soup soup = test_meshes::perturbed(test_meshes::icosphere(3), 0.02, 1);
  const Mesh a = quads_of(test_meshes::make_mesh(soup), 400, "ball");
  const Mesh b = quads_of(test_meshes::make_mesh(soup), 400, "ball again");
  assert(a.number_of_faces() == b.number_of_faces());
  for(Mesh::Vertex_index v : a.vertices())
    assert(a.point(v) == b.point(v));
  const Mesh large = quads_of(
    test_meshes::make_mesh(test_meshes::mapped(
      soup, [](const Kernel::Point_3& p) { return Kernel::Point_3(1024 * p.x(), 1024 * p.y(), 1024 * p.z()); })),
    400, "large ball");
  assert(large.number_of_faces() == a.number_of_faces());
  quads_of(test_meshes::make_mesh<Polyhedron>(soup), 400, "polyhedron");
}

void test_directions_and_features_of_the_user()
{
  Mesh tm = test_meshes::make_mesh(test_meshes::grid(20, 20));
  auto direction = tm.add_property_map<Mesh::Face_index, boost::optional<Kernel::Vector_3>>("f:d").first;
  for(Mesh::Face_index f : tm.faces())
    direction[f] = Kernel::Vector_3(1, 1, 0);
  Mesh qm;
  const Result r = QM::quadrangulate(
    tm, qm,
    parameters::target_number_of_quads(400.).align_boundary(false).face_direction_map(direction).smoothing_iterations(
      0u));
  std::cout << "diagonal directions: " << r.message << std::endl;
  for(Mesh::Edge_index e : qm.edges())
  {
    const auto d = qm.point(qm.vertex(e, 1)) - qm.point(qm.vertex(e, 0));
    assert(std::abs(std::abs(d.x()) - std::abs(d.y())) < 1e-6);
  }

  // the edges in the middle of a flat square, marked by the user
  auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
  auto in_middle = [](const Kernel::Point_3& p) { return std::abs(p.x() - 0.5) < 1e-9; };
  for(Mesh::Edge_index e : tm.edges())
    is_feature[e] = in_middle(tm.point(tm.vertex(e, 0))) && in_middle(tm.point(tm.vertex(e, 1)));
  Mesh split;
  assert(QM::quadrangulate(tm, split, parameters::target_number_of_quads(121.).edge_is_constrained_map(is_feature))
           .is_valid());
  assert(std::abs(length_on_lines(split, in_middle) - 1) < 1e-9);
}

// Fewer patches, the same irregular vertices, and all vertices on the input as ever.
void test_optimized_structure()
{
  const Mesh tm = test_meshes::make_mesh(test_meshes::perturbed(test_meshes::icosphere(3), 0.02, 1));
  const auto np = parameters::target_number_of_quads(500.);
  Mesh plain, coarse;
  auto location =
    coarse.add_property_map<Mesh::Vertex_index, std::pair<Mesh::Face_index, std::array<double, 3>>>("v:l").first;
  assert(QM::quadrangulate(tm, plain, np).is_valid());
  const Result r = QM::quadrangulate(tm, coarse, np.optimize_structure(true).face_location_map(location));
  std::cout << "optimized structure: " << r.message << " " << r.quads << " quads" << std::endl;
  assert(r.is_valid() && r.structure_seconds > 0 && r.folded_quads == 0);
  const auto before = quad_mesh_checks::figures(plain), after = quad_mesh_checks::figures(coarse);
  assert(after.is_valid() && after.same_topology(before) && after.quads == r.quads);
  assert(after.irregular_vertices() == before.irregular_vertices() &&
         r.irregular_vertices == after.irregular_vertices());
  const std::size_t patches = QM::quad_mesh_structure(plain).number_of_patches;
  assert(QM::quad_mesh_structure(coarse).number_of_patches < patches);
  for(Mesh::Vertex_index v : coarse.vertices())
    assert(CGAL::squared_distance(CGAL::Polygon_mesh_processing::construct_point(location[v], tm), coarse.point(v)) <
           1e-12);
}

// Quads made anew along the base complex: as many patches as the optimized structure has, features kept.
void test_semi_regular()
{
  for(const test_meshes::Soup& soup :
      { test_meshes::l_prism(6), test_meshes::perturbed(test_meshes::icosphere(3), 0.02, 1) })
  {
    const Mesh tm = test_meshes::make_mesh(soup);
    const auto np = parameters::target_number_of_quads(600.);
    Mesh optimized, regular;
    const Result before = QM::quadrangulate(tm, optimized, np.optimize_structure(true));
    const Result r = QM::quadrangulate(tm, regular, np.semi_regular(true));
    std::cout << "semi-regular: " << r.message << " " << r.quads << " quads" << std::endl;
    assert(before.is_valid() && r.is_valid() && r.layout_seconds > 0 && before.layout_seconds == 0);
    const auto figures = quad_mesh_checks::figures(regular);
    assert(figures.is_valid() && figures.same_topology(quad_mesh_checks::figures(optimized)));
    assert(figures.quads == r.quads && figures.irregular_vertices() == r.irregular_vertices);
    assert(figures.irregular_vertices() == quad_mesh_checks::figures(optimized).irregular_vertices());
    assert(r.folded_quads <= before.folded_quads);
    // few patches, each of whole quads
    assert(r.not_semi_regular_components == 0 && std::abs(double(r.quads) - 600) <= 0.08 * 600);
  }
}

// Of a crease across a square, the edges with an end within the radius of the face are released, and no others.
void test_release_near_a_face()
{
  Mesh tm = test_meshes::make_mesh(test_meshes::grid(10, 10));
  auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:f", false).first;
  auto is_kept = tm.add_property_map<Mesh::Edge_index, bool>("e:k", false).first;
  auto on_crease = [&](Mesh::Vertex_index v) { return std::abs(tm.point(v).x() - 0.5) < 1e-9; };
  for(Mesh::Edge_index e : tm.edges())
    is_feature[e] = on_crease(tm.vertex(e, 0)) && on_crease(tm.vertex(e, 1));
  std::vector<Mesh::Face_index> seed; // one in the corner at the lower end of the crease
  for(Mesh::Face_index f : tm.faces())
  {
    const auto h = tm.halfedge(f);
    const auto c = CGAL::centroid(tm.point(tm.source(h)), tm.point(tm.target(h)), tm.point(tm.target(tm.next(h))));
    if(seed.empty() && c.x() > 0.5 && c.x() < 0.6 && c.y() < 0.1)
      seed.push_back(f);
  }
  const double none = QM::internal::release_features(tm, std::vector<Mesh::Face_index>(), 10., is_kept, is_feature);
  assert(none == 0);
  const double released = QM::internal::release_features(tm, seed, 0.25, is_kept, is_feature);
  double left = 0;
  for(Mesh::Edge_index e : tm.edges())
    left += is_feature[e] ? 0.1 : 0;
  assert(std::abs(released + left - 1) < 1e-9 && released > 0.25 && released < 0.45);
  for(Mesh::Edge_index e : tm.edges())
    if(on_crease(tm.vertex(e, 0)) && on_crease(tm.vertex(e, 1)))
      assert(is_feature[e] == (CGAL::midpoint(tm.point(tm.vertex(e, 0)), tm.point(tm.vertex(e, 1))).y() > released));
}

// At the corners of 45 degrees of this tetrahedron no map can follow all creases without fold-overs: they are released
// there. Creases that the user has marked are not, and the answer says what became of the mesh.
void test_released_features()
{
  test_meshes::Soup tetrahedron;
  tetrahedron.points = { Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0),
                         Kernel::Point_3(0, 0, 1) };
  tetrahedron.triangles = { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 0, 3, 2 } }, { { 1, 2, 3 } } };
  const Mesh tm = test_meshes::make_mesh(tetrahedron);
  const auto np = parameters::target_number_of_quads(4000.);
  Mesh qm;
  const Result r = QM::quadrangulate(tm, qm, np);
  std::cout << "tetrahedron: " << r.message << std::endl;
  if(r.is_valid())
    assert(quad_mesh_checks::figures(qm).is_valid() && quad_mesh_checks::figures(qm).is_simple());
  assert(r.released_feature_share >= 0 && r.released_feature_share <= 1);
  Mesh marked;
  auto is_feature = CGAL::Constant_property_map<Mesh::Edge_index, bool>(true);
  const Result kept = QM::quadrangulate(tm, marked, np.edge_is_constrained_map(is_feature));
  assert(kept.released_feature_share == 0);
  if(kept.is_valid())
    assert(quad_mesh_checks::figures(marked).is_valid() && quad_mesh_checks::figures(marked).is_simple());
}

struct Stops_at_once : QM::Default_visitor
{
  bool go_further() { return false; }
};

struct Counts_stages : QM::Default_visitor
{
  int begun = 0, ended = 0;
  void on_stage_begin(const std::string&) { ++begun; }
  void on_stage_end(const std::string&) { ++ended; }
};

// The stages on a mesh that has gaps in its numbering, for faces were removed, give what they give without the gaps.
void test_gaps()
{
  struct Line
  {
    int singularities = 0;
    double energy = 0;
    std::size_t quads = 0;
  };
  auto run = [](Mesh& tm)
  {
    auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
    auto angle = tm.add_property_map<Mesh::Face_index, double>("f:angle", 0).first;
    auto jump = tm.add_property_map<Mesh::Edge_index, int>("e:jump", 0).first;
    auto index = tm.add_property_map<Mesh::Vertex_index, int>("v:index", 0).first;
    auto uv = tm.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    assert(QM::detect_feature_edges(tm, 40, 0.3, is_feature).number_of_edges == 0);
    const auto field = QM::smooth_cross_field(tm, angle, jump, index, parameters::target_edge_length(0.15));
    const auto map = QM::integer_grid_map(tm, angle, jump, index, uv, parameters::target_edge_length(0.15));
    assert(field.is_valid() && map.is_valid());
    Mesh qm;
    Line line;
    line.singularities = field.singularities;
    line.energy = map.energy;
    line.quads = QM::extract_quad_mesh(tm, uv, qm).quads;
    return line;
  };
  const test_meshes::Soup torus = test_meshes::torus(40, 20);
  Mesh whole = test_meshes::make_mesh(torus);
  Mesh with_gaps = test_meshes::make_mesh(test_meshes::joined(test_meshes::icosphere(1), torus));
  const std::size_t removed = with_gaps.number_of_faces() - whole.number_of_faces();
  for(std::size_t f = 0; f < removed; ++f)
    CGAL::Euler::remove_face(with_gaps.halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(f))), with_gaps);
  assert(with_gaps.has_garbage() && with_gaps.number_of_vertices() == whole.number_of_vertices());
  const Line a = run(whole), b = run(with_gaps);
  assert(a.quads > 100 && a.quads == b.quads && a.singularities == b.singularities && a.energy == b.energy);
}

// A tube with two quads around it would have two edges between the same vertices: it gets three, at the length that was
// asked for.
void test_grid_too_coarse()
{
  const Mesh tm = test_meshes::make_mesh(test_meshes::cylinder(40, 40, false, 1, 10));
  for(double quads_around : { 1.9, 2.4 })
  {
    const double length = 2 * CGAL_PI / quads_around;
    Mesh qm;
    const Result r = QM::quadrangulate(tm, qm, parameters::target_edge_length(length));
    std::cout << "tube: " << r.message << std::endl;
    assert(r.is_valid() && r.quads == qm.number_of_faces() && r.quads % 3 == 0);
    assert(r.flipped_triangles == 0 && r.parameterization_attempts == 1 && r.target_edge_length == length);
  }
}

// Where all edges of a fine mesh must be followed there is no field for so few quads. That is said at once.
void test_too_many_singularities()
{
  Mesh tm = test_meshes::make_mesh(test_meshes::icosphere(4)), qm;
  const auto is_feature = tm.add_property_map<Mesh::Edge_index, bool>("e:all", true).first;
  const Result r = QM::quadrangulate(tm, qm, parameters::edge_is_constrained_map(is_feature));
  std::cout << "all edges: " << r.message << std::endl;
  assert(r.status == Status::FAILED && qm.is_empty() && r.singularities > 1200 && r.parameterization_attempts == 0);
  assert(r.released_feature_share == 0 && r.message.find("singularities") != std::string::npos);
}

// A surface that is all noise at the scale of the quads gets a mesh all the same: pairs of singularities nearer to each
// other than a quad annihilate each other.
void test_noise()
{
  const Mesh tm = test_meshes::make_mesh(test_meshes::perturbed(test_meshes::icosphere(4), 0.1));
  for(double angle : { 40., 180. })
  {
    Mesh qm;
    const Result r = QM::quadrangulate(tm, qm, parameters::sharpness_angle(angle));
    std::cout << "noise: " << r.message << std::endl;
    assert(r.is_valid() && r.singularities < 1200);
  }
}

void test_topologies()
{
  quads_of(test_meshes::make_mesh(test_meshes::torus(40, 20)), 600, "torus");
  quads_of(test_meshes::make_mesh(test_meshes::double_ring(3)), 800, "two rings");
  quads_of(test_meshes::make_mesh(test_meshes::two_components(5, 3)), 700, "two components");
  quads_of(test_meshes::make_mesh(test_meshes::cylinder(24, 8, false)), 400, "open cylinder");
}

// A second run starts anew, also with other options.
void test_second_run()
{
  const Mesh tm = test_meshes::make_mesh(test_meshes::cube(5));
  QM::Quadrangulation q(tm, tm.points());
  q.options.target_number_of_quads = 300;
  const Result first = q.run();
  const Mesh quads = q.quads().mesh;
  const Result second = q.run();
  assert(first.is_valid() && second.is_valid() && first.quads == second.quads);
  assert(quad_mesh_checks::are_equal(quads, q.quads().mesh));
  q.options.target_number_of_quads = 600;
  assert(q.run().is_valid() && q.quads().mesh.number_of_faces() > 450);
  QM::Quadrangulation fresh(tm, tm.points());
  fresh.options.target_number_of_quads = 600;
  assert(fresh.run().is_valid() && quad_mesh_checks::are_equal(fresh.quads().mesh, q.quads().mesh));
}

// Numbers of vertices and faces, and which corner of a face comes first, have no influence: not on one bit.
void test_renumbering()
{
  CGAL::Random random(1);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(const test_meshes::Soup& soup : { test_meshes::perturbed(test_meshes::icosphere(3), 0.02, 1),
                                        test_meshes::l_prism(4), test_meshes::grid_with_hole(9, 9, 3, 5, 3, 6) })
  {
    test_meshes::Soup other;
    std::vector<std::size_t> order(soup.points.size());
    std::iota(order.begin(), order.end(), 0);
    CGAL::cpp98::random_shuffle(order.begin(), order.end(), random);
    other.points.resize(soup.points.size());
    for(std::size_t i = 0; i < order.size(); ++i)
      other.points[order[i]] = soup.points[i];
    other.triangles = soup.triangles;
    CGAL::cpp98::random_shuffle(other.triangles.begin(), other.triangles.end(), random);
    for(auto& t : other.triangles)
    {
      for(auto& v : t)
        v = order[v];
      std::rotate(t.begin(), t.begin() + random.get_int(0, 3), t.end());
    }
    const Mesh a = quads_of(test_meshes::make_mesh(soup), 500, "numbered"),
               b = quads_of(test_meshes::make_mesh(other), 500, "renumbered");
    assert(quad_mesh_checks::are_equal(a, b));
  }
}

// The steps of the smoothing count with and without the optimization of the structure.
void test_smoothing_iterations()
{
  const Mesh tm = test_meshes::make_mesh(test_meshes::perturbed(test_meshes::icosphere(3), 0.02, 1));
  for(bool optimized : { false, true })
  {
    Mesh raw, smooth, default_steps;
    const auto np = parameters::target_number_of_quads(400.).optimize_structure(optimized);
    assert(QM::quadrangulate(tm, raw, np.smoothing_iterations(0u)).is_valid());
    assert(QM::quadrangulate(tm, smooth, np.smoothing_iterations(20u)).is_valid());
    assert(QM::quadrangulate(tm, default_steps, np).is_valid());
    assert(!quad_mesh_checks::are_equal(raw, smooth) && quad_mesh_checks::are_equal(smooth, default_steps));
  }
}

// Two holes that share a vertex: CGAL's meshes carry that, and each hole gets a vertex of its own in the quad mesh.
void test_borders_that_touch()
{
  Mesh tm = test_meshes::make_mesh(test_meshes::icosphere(3));
  const Mesh::Vertex_index v(7);
  std::vector<Mesh::Face_index> fan;
  for(Mesh::Face_index f : CGAL::faces_around_target(tm.halfedge(v), tm))
    fan.push_back(f);
  CGAL::Euler::remove_face(tm.halfedge(fan[0]), tm);
  CGAL::Euler::remove_face(tm.halfedge(fan[fan.size() / 2]), tm);
  Mesh qm;
  const Result r = QM::quadrangulate(tm, qm, parameters::target_number_of_quads(600.));
  std::cout << "holes that touch: " << r.message << std::endl;
  assert(r.is_valid() && r.divided_vertices == 1 && r.message.find("divided") != std::string::npos);
  const auto figures = quad_mesh_checks::figures(qm);
  // The two holes are one now, and what is left is a disk.
  assert(figures.is_valid() && figures.border_loops == 1 && figures.euler() == 1);
  Polyhedron polyhedron;
  CGAL::copy_face_graph(tm, polyhedron);
  Mesh of_polyhedron;
  assert(QM::quadrangulate(polyhedron, of_polyhedron, parameters::target_number_of_quads(600.)).is_valid());
  assert(quad_mesh_checks::are_equal(qm, of_polyhedron));
}

// A graph may join two vertices by two edges; triangles given by their corners say no more which sides belong together.
void test_double_edges()
{
  QM::internal::Triangle_input input;
  for(int i = 0; i < 6; ++i)
    input.points.emplace_back(i, i * i, i * i * i);
  input.triangles = { { { 4, 1, 0 } }, { { 1, 4, 2 } }, { { 4, 1, 3 } }, { { 1, 4, 5 } } };
  QM::Quadrangulation_options options;
  options.vertex_name = [](std::size_t i) { return "corner " + std::string(1, static_cast<char>('a' + i)); };
  const std::string named = QM::internal::Surface_components(input, QM::internal::Element_names(options)).error;
  const std::string error = QM::internal::Surface_components(input).error;
  std::cout << error << " " << named << std::endl;
  assert(named.find("corner b") != std::string::npos && named.find("corner e") != std::string::npos);
  assert(error.find("1") != std::string::npos && error.find("4") != std::string::npos);
  input.triangles = { { { 4, 1, 0 } }, { { 4, 1, 3 } } };
  assert(QM::internal::Surface_components(input).error.find("orientation") != std::string::npos);
  input.triangles = { { { 4, 4, 0 } } };
  assert(!QM::internal::Surface_components(input).error.empty());
  input.triangles = { { { 4, 1, 0 } }, { { 1, 4, 2 } } };
  assert(QM::internal::Surface_components(input).error.empty());
}

// Each component is on its own: one without a mesh does not cost the others theirs, and the message names it.
void test_components()
{
  const test_meshes::Soup fixed = test_meshes::icosphere(4); // all its edges must be followed
  const test_meshes::Soup ball = test_meshes::translated(test_meshes::icosphere(3), Kernel::Vector_3(5, 0, 0));
  const Mesh alone = test_meshes::make_mesh(ball);
  Mesh two_balls = test_meshes::make_mesh(test_meshes::joined(fixed, ball));
  const auto is_fixed = two_balls.add_property_map<Mesh::Edge_index, bool>("e:fixed", false).first;
  for(Mesh::Edge_index e : two_balls.edges())
    is_fixed[e] = two_balls.point(two_balls.vertex(e, 0)).x() < 2;
  for(unsigned int threads : { 1u, 3u })
  {
    Mesh qm;
    const Result r = QM::quadrangulate(
      two_balls, qm,
      parameters::target_number_of_quads(4000.).number_of_threads(threads).edge_is_constrained_map(is_fixed));
    std::cout << "fixed edges and a ball: " << r.message << std::endl;
    assert(r.status == Status::NOT_VALID && r.components == 2 && r.failed_components == 1);
    assert(r.message.find("that of face 0") != std::string::npos);
    assert(r.invalid_components.size() == 1 && r.invalid_components[0].face == 0);
    assert(r.invalid_components[0].status == Status::FAILED);
    assert(r.message.find("singularities") != std::string::npos &&
           r.invalid_components[0].message.find("singularities") != std::string::npos);
    const auto figures = quad_mesh_checks::figures(qm);
    assert(figures.is_valid() && figures.components == 1 && figures.euler() == 2);
  }

  // A ball and, far away, one of a tenth of its size, too small for such quads: it gets smaller ones.
  const test_meshes::Soup small = test_meshes::mapped(
    ball, [](const Kernel::Point_3& p) { return Kernel::Point_3(10 + p.x() / 30, p.y() / 30, p.z() / 30); });
  Mesh one, two, alone_quads;
  auto location =
    two.add_property_map<Mesh::Vertex_index, std::pair<Mesh::Face_index, std::array<double, 3>>>("v:l").first;
  const Mesh both = test_meshes::make_mesh(test_meshes::joined(ball, small));
  const Result r1 = QM::quadrangulate(both, one, parameters::target_edge_length(0.2));
  const Result r2 =
    QM::quadrangulate(both, two, parameters::target_edge_length(0.2).number_of_threads(2u).face_location_map(location));
  std::cout << "two balls: " << r1.message << std::endl;
  assert(r1.is_valid() && r1.components == 2 && r1.refined_components == 1 &&
         r1.message.find("smaller quads") != std::string::npos);
  assert(r2.is_valid() && quad_mesh_checks::are_equal(one, two));
  assert(QM::quadrangulate(alone, alone_quads, parameters::target_edge_length(0.2)).is_valid());
  const std::size_t first =
    one.point(*one.vertices().begin()).x() < 8 ? 0 : one.number_of_vertices() - alone_quads.number_of_vertices();
  for(Mesh::Vertex_index v : alone_quads.vertices()) // the large one is what it is alone
    assert(one.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v + first))) == alone_quads.point(v));
  for(Mesh::Vertex_index v : two.vertices())
    assert(CGAL::squared_distance(CGAL::Polygon_mesh_processing::construct_point(location[v], both), two.point(v)) <
           1e-12);
}

// Stops when it is asked for the n-th time.
struct Stops_after : QM::Default_visitor
{
  int left;
  explicit Stops_after(int n) : left(n) {}
  bool go_further() { return left-- > 0; }
};

// Wherever the visitor stops the work, nothing is left behind.
void test_stops()
{
  const Mesh tm = test_meshes::make_mesh(test_meshes::perturbed(test_meshes::icosphere(3), 0.02, 1));
  int asked = 0;
  for(int n = 0;; n += 1 + n / 3)
  {
    Mesh qm;
    Stops_after stops(n);
    const Result r = QM::quadrangulate(tm, qm, parameters::target_number_of_quads(300.).visitor(std::ref(stops)));
    if(r.is_valid())
      break;
    assert(r.status == Status::STOPPED && qm.number_of_vertices() == 0 && !r.message.empty());
    ++asked;
  }
  assert(asked > 3);
}

void test_time_limit()
{
  const Mesh tm = test_meshes::make_mesh(test_meshes::icosphere(4));
  Mesh none, some;
  const Result r = QM::quadrangulate(tm, none, parameters::target_number_of_quads(4000.).maximum_running_time(1e-9));
  std::cout << "no time: " << r.message << std::endl;
  assert(r.status == Status::OUT_OF_TIME && none.number_of_faces() == 0);
  assert(QM::quadrangulate(tm, some, parameters::target_number_of_quads(400.).maximum_running_time(1000.)).is_valid());
  assert(QM::quadrangulate(tm, some, parameters::maximum_running_time(0.)).status == Status::INVALID_INPUT);
}

void test_bad_input_and_stops()
{
  Mesh empty, qm;
  assert(QM::quadrangulate(empty, qm).status == Status::INVALID_INPUT);
  Mesh tm = test_meshes::make_mesh(test_meshes::cube(3));
  for(double length : { -1., 100., 1e-9, std::nan("") })
    assert(QM::quadrangulate(tm, qm, parameters::target_edge_length(length)).status == Status::INVALID_INPUT);
  assert(QM::quadrangulate(tm, qm, parameters::target_number_of_quads(0.)).status == Status::INVALID_INPUT);
  Stops_at_once stops;
  assert(QM::quadrangulate(tm, qm, parameters::target_number_of_quads(100.).visitor(std::ref(stops))).status ==
         Status::STOPPED);
  assert(qm.number_of_faces() == 0);
  Counts_stages counts;
  assert(QM::quadrangulate(tm, qm, parameters::target_number_of_quads(100.).visitor(std::ref(counts))).is_valid());
  assert(counts.begun >= 3 && counts.begun == counts.ended);
  Mesh nan = tm;
  nan.point(*nan.vertices().begin()) = Kernel::Point_3(std::nan(""), 0, 0);
  Mesh none;
  assert(QM::quadrangulate(nan, none).status == Status::INVALID_INPUT && none.number_of_faces() == 0);
  Mesh same = tm;
  assert(QM::quadrangulate(same, same).status == Status::INVALID_INPUT &&
         same.number_of_faces() == tm.number_of_faces());
  const Result many = QM::quadrangulate(tm, qm, parameters::target_number_of_quads(1e9));
  assert(many.status == Status::INVALID_INPUT && many.message.find("quads are asked for") != std::string::npos);
}

// Parts with irregular vertices nearer to features than a quad: the first map does, rounded once more if the number of
// quads is far off, and nothing is given up.
void test_real_meshes()
{
  for(const std::string name : { "fandisk", "couplingdown" })
  {
    const std::string filename = CGAL::data_file_path("meshes/" + name + ".off");
    if(!std::ifstream(filename))
    {
      std::cout << "no " << filename << ": skipped" << std::endl;
      continue;
    }
    Mesh tm;
    assert(CGAL::IO::read_polygon_mesh(filename, tm));
    Mesh qm;
    const Result r = QM::quadrangulate(tm, qm, parameters::target_number_of_quads(4000));
    std::cout << name << ": " << r.message << std::endl;
    assert(r.is_valid() && r.parameterization_attempts <= 2 && r.released_feature_share == 0);
  }
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "features", test_features },
                     { "border", test_border },
                     { "topologies", test_topologies },
                     { "locations", test_locations },
                     { "invariance", test_invariance },
                     { "renumbering", test_renumbering },
                     { "second_run", test_second_run },
                     { "directions_and_features_of_the_user", test_directions_and_features_of_the_user },
                     { "optimized_structure", test_optimized_structure },
                     { "semi_regular", test_semi_regular },
                     { "smoothing_iterations", test_smoothing_iterations },
                     { "release_near_a_face", test_release_near_a_face },
                     { "released_features", test_released_features },
                     { "gaps", test_gaps },
                     { "borders_that_touch", test_borders_that_touch },
                     { "double_edges", test_double_edges },
                     { "components", test_components },
                     { "grid_too_coarse", test_grid_too_coarse },
                     { "too_many_singularities", test_too_many_singularities },
                     { "noise", test_noise },
                     { "stops", test_stops },
                     { "time_limit", test_time_limit },
                     { "bad_input_and_stops", test_bad_input_and_stops },
                     { "real_meshes", test_real_meshes } });
}
