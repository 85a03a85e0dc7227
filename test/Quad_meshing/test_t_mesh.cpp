// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// T-meshes of seamless maps, the integer lengths of their arcs, and the quads that come of these.

#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Layout/layout_from_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/quadrangulate_layout.h>
#include <CGAL/Quad_meshing/Layout/quads_of_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/quantize_t_mesh.h>
#include <CGAL/Quad_meshing/Parameterization/Seamless_map.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/internal/surface_topology.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace parameters = CGAL::parameters;

typedef test_meshes::Mesh Mesh;

namespace {

// A surface with sharp edges, a cross field, and its seamless map for a length of quad edges.
struct Mapped_surface
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;
  Mesh::Property_map<Mesh::Vertex_index, int> index;
  Mesh::Property_map<Mesh::Halfedge_index, test_meshes::Kernel::Point_2> uv;
  QM::Seamless_map map;

  Mapped_surface(const test_meshes::Soup& soup, double length) : Mapped_surface(prepared(soup, length), length, 0) {}

  // The T-mesh for a multiple of the length.
  QM::T_mesh t_mesh(double relative_length = 1)
  {
    map.round_without_repair(mesh, relative_length, uv);
    return map.t_mesh();
  }

private:
  static Mesh prepared(const test_meshes::Soup& soup, double length)
  {
    Mesh m = test_meshes::make_mesh<Mesh>(soup);
    auto is_feature = m.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
    auto origin = m.add_property_map<Mesh::Face_index, std::size_t>("f:origin", 0).first;
    QM::detect_feature_edges(m, 40, length, is_feature);
    QM::split_for_alignment(m, m.points(), is_feature, true, origin, 1.5 * length);
    return m;
  }

  static QM::Seamless_map mapped(Mesh& m, double length)
  {
    auto is_feature = m.property_map<Mesh::Edge_index, bool>("e:is_feature").first;
    auto angle = m.add_property_map<Mesh::Face_index, double>("f:angle").first;
    auto jump = m.add_property_map<Mesh::Edge_index, int>("e:jump").first;
    auto index = m.add_property_map<Mesh::Vertex_index, int>("v:index").first;
    const auto np = parameters::target_edge_length(length).edge_is_constrained_map(is_feature);
    assert(QM::smooth_cross_field(m, angle, jump, index, np).is_valid());
    return QM::Seamless_map(m, angle, jump, index, np);
  }

  Mapped_surface(Mesh&& m, double length, int)
    : mesh(std::move(m))
    , is_feature(mesh.property_map<Mesh::Edge_index, bool>("e:is_feature").first)
    , map(mapped(mesh, length))
  {
    index = mesh.property_map<Mesh::Vertex_index, int>("v:index").first;
    uv = mesh.add_property_map<Mesh::Halfedge_index, test_meshes::Kernel::Point_2>("h:uv").first;
    assert(map.is_solved() && map.result().folded_before_rounding.empty());
  }
};

struct Named_soup
{
  std::string name;
  test_meshes::Soup soup;
  double length;
};

// With and without features, borders and irregular vertices; one with annuli, one with none of these at all.
std::vector<Named_soup> surfaces()
{
  return { { "cube", test_meshes::cube(6), 0.2 },
           { "ball", test_meshes::perturbed(test_meshes::icosphere(3), 0.02, 1), 0.25 },
           { "torus", test_meshes::torus(40, 20), 0.2 },
           { "tube", test_meshes::cylinder(24, 12, false), 0.3 },
           { "can", test_meshes::cylinder(24, 12, true), 0.3 },
           { "cone", test_meshes::cone(24, 8), 0.2 },
           { "square with a hole", test_meshes::grid_with_hole(14, 14, 5, 9, 5, 9), 0.1 },
           { "prism", test_meshes::l_prism(4), 0.2 },
           { "two rings", test_meshes::double_ring(3), 0.3 },
           { "two components", test_meshes::two_components(5, 3), 0.25 } };
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::sqrt(CGAL::square(a[0] - b[0]) + CGAL::square(a[1] - b[1]) + CGAL::square(a[2] - b[2]));
}

double length_of_polyline(const QM::T_mesh& t, int arc)
{
  double sum = 0;
  const std::vector<QM::T_mesh::Location> line = t.polyline(arc);
  for(std::size_t i = 0; i + 1 < line.size(); ++i)
    sum += distance(t.position(line[i]), t.position(line[i + 1]));
  return sum;
}

std::array<double, 3> end_of(const QM::T_mesh& t, int direction)
{
  const QM::T_mesh::Arc& a = t.arcs[direction / 2];
  return t.position(t.locate(direction / 2, direction & 1 ? a.length : 0));
}

// Patches are rectangles, exactly; arcs end where their nodes lie; all features and borders are arcs.
void check_t_mesh(const Mapped_surface& s, const QM::T_mesh& t)
{
  assert(t.is_valid());
  for(const QM::T_mesh::Patch& p : t.patches)
    for(int k = 0; k < 4; ++k)
    {
      CGAL::Exact_rational one = 0, other = 0;
      double one_rounded = 0, other_rounded = 0;
      for(int d : p.sides[k])
      {
        one += CGAL::Exact_rational(t.arcs[d / 2].length);
        one_rounded += t.arcs[d / 2].rounded_length;
      }
      for(int d : p.sides[(k + 2) % 4])
      {
        other += CGAL::Exact_rational(t.arcs[d / 2].length);
        other_rounded += t.arcs[d / 2].rounded_length;
      }
      assert(one > 0 && one == other && one_rounded == other_rounded);
      for(std::size_t i = 0; i + 1 < p.sides[k].size(); ++i)
        assert(t.target(p.sides[k][i]) == t.source(p.sides[k][i + 1]));
      assert(t.target(p.sides[k].back()) == t.source(p.sides[(k + 1) % 4].front()));
    }
  const double rounding = 1e-7;
  for(std::size_t n = 0; n < t.nodes.size(); ++n)
    for(int d : t.nodes[n].directions)
    {
      assert(t.source(d) == static_cast<int>(n));
      assert(distance(end_of(t, d), end_of(t, t.nodes[n].directions.front())) < rounding);
    }
  double on_arcs = 0, on_mesh = 0;
  for(std::size_t a = 0; a < t.arcs.size(); ++a)
  {
    assert(t.arcs[a].length > 0);
    if(t.arcs[a].is_aligned)
      on_arcs += length_of_polyline(t, static_cast<int>(a));
  }
  for(Mesh::Edge_index e : s.mesh.edges())
    if(s.is_feature[e] || s.mesh.is_border(e))
      on_mesh +=
        std::sqrt(CGAL::squared_distance(s.mesh.point(s.mesh.vertex(e, 0)), s.mesh.point(s.mesh.vertex(e, 1))));
  assert(std::abs(on_arcs - on_mesh) <= rounding * (1 + on_mesh));
  std::set<int> vertices;
  for(const QM::T_mesh::Node& n : t.nodes)
    if(n.is_critical)
      vertices.insert(n.vertex);
  for(Mesh::Vertex_index v : s.mesh.vertices())
    if(!s.mesh.is_border(v) && s.index[v] != 0)
      assert(vertices.count(static_cast<int>(v.idx())) == 1);
}

void test_partition()
{
  for(const Named_soup& n : surfaces())
  {
    Mapped_surface s(n.soup, n.length);
    const QM::T_mesh t = s.t_mesh();
    std::cout << n.name << ": " << t.message << t.nodes.size() << " nodes, " << t.arcs.size() << " arcs, "
              << t.patches.size() << " patches" << std::endl;
    check_t_mesh(s, t);
  }
}

// A point of a patch lies where its distances from the sides say, in a plane square, of which the map is the identity.
void test_places()
{
  Mapped_surface s(test_meshes::grid_with_hole(12, 12, 4, 8, 4, 8), 1. / 12);
  const QM::T_mesh t = s.t_mesh();
  check_t_mesh(s, t);
  for(std::size_t p = 0; p < t.patches.size(); ++p)
  {
    const int patch = static_cast<int>(p);
    const double width = t.length(patch, 0), height = t.length(patch, 1);
    std::array<std::array<double, 3>, 4> corner;
    for(int k = 0; k < 4; ++k)
      corner[k] = end_of(t, t.patches[p].sides[k].front());
    for(double u : { 0.1, 0.5, 0.8 })
      for(double v : { 0.2, 0.5, 0.9 })
      {
        std::array<double, 3> q;
        for(int c = 0; c < 3; ++c)
          q[c] = corner[0][c] + u * (corner[1][c] - corner[0][c]) + v * (corner[3][c] - corner[0][c]);
        // The least-squares map of a square with a hole at its middle is the identity up to rounding errors.
        assert(distance(q, t.position(t.locate_in_patch(patch, u * width, v * height))) < 1e-6);
      }
  }
}

// The quads of lengths: a mesh with the topology of the surface, in which every critical node is a vertex at its place,
// irregular vertices are those of the field, and features are as long as their arcs.
void check_quads(const Mapped_surface& s, const QM::T_mesh& t, const std::vector<int>& lengths)
{
  for(const QM::T_mesh::Patch& p : t.patches)
    for(int k = 0; k < 2; ++k)
    {
      int difference = 0;
      for(int d : p.sides[k])
        difference += lengths[d / 2];
      for(int d : p.sides[k + 2])
        difference -= lengths[d / 2];
      assert(difference == 0);
    }
  assert(*std::min_element(lengths.begin(), lengths.end()) >= 0);

  Mesh quads;
  auto is_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  assert(QM::quads_of_t_mesh(t, lengths, s.mesh, quads, is_feature));
  assert(CGAL::is_valid_polygon_mesh(quads) && CGAL::is_quad_mesh(quads));
  assert(QM::internal::surface_topology(quads) == QM::internal::surface_topology(s.mesh));

  std::map<std::array<double, 3>, Mesh::Vertex_index> vertex_at;
  const auto place = [](const test_meshes::Kernel::Point_3& p) {
    return std::array<double, 3>{ { p.x(), p.y(), p.z() } };
  };
  for(Mesh::Vertex_index v : quads.vertices())
    vertex_at[place(quads.point(v))] = v;
  std::size_t irregular = 0;
  for(const QM::T_mesh::Node& n : t.nodes)
  {
    if(!n.is_critical)
      continue;
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(n.vertex));
    const auto found = vertex_at.find(place(s.mesh.point(v)));
    assert(found != vertex_at.end());
    const int valence = static_cast<int>(quads.degree(found->second));
    const bool on_border = quads.is_border(found->second);
    assert(on_border == s.mesh.is_border(v));
    if(!on_border)
      assert(valence == 4 - s.index[v]);
    irregular += valence != (on_border ? 3 : 4);
  }
  for(Mesh::Vertex_index v : quads.vertices())
    irregular -= static_cast<int>(quads.degree(v)) != (quads.is_border(v) ? 3 : 4);
  assert(irregular == 0);

  std::size_t wanted = 0, found = 0;
  for(std::size_t a = 0; a < t.arcs.size(); ++a)
    if(t.arcs[a].is_aligned)
      wanted += static_cast<std::size_t>(lengths[a]);
  for(Mesh::Edge_index e : quads.edges())
    found += is_feature[e] || quads.is_border(e);
  assert(found == wanted);
}

// From far too coarse to fine, whatever the rounding says.
void test_any_density()
{
  for(const Named_soup& n : surfaces())
  {
    Mapped_surface s(n.soup, n.length);
    for(double relative_length : { 0.5, 1., 2., 3.7, 8., 30. })
    {
      const QM::T_mesh t = s.t_mesh(relative_length);
      check_t_mesh(s, t);
      std::vector<int> lengths;
      const QM::T_mesh_quantization_result r = QM::quantize_t_mesh(t, lengths);
      std::cout << n.name << " x " << relative_length << ": " << r.message << " zero " << r.zero_arcs << ", lengthened "
                << r.lengthened_arcs << ", energy " << r.energy << std::endl;
      assert(r.is_valid);
      check_quads(s, t, lengths);
    }
  }
}

// The guarantee does not depend on the lengths to begin with: multiples of those for another density and zero
// are consistent and are mended as well.
void test_any_start()
{
  CGAL::Random random(7);
  for(const Named_soup& n : surfaces())
  {
    Mapped_surface s(n.soup, n.length);
    for(int factor : { 0, 3 })
    {
      const QM::T_mesh other = s.t_mesh(random.get_double(0.5, 4));
      QM::T_mesh t = s.t_mesh(1);
      for(std::size_t a = 0; a < t.arcs.size(); ++a)
        t.arcs[a].rounded_length = other.arcs.size() == t.arcs.size() ? factor * other.arcs[a].rounded_length : 0;
      std::vector<int> lengths;
      const QM::T_mesh_quantization_result r = QM::quantize_t_mesh(t, lengths);
      if(!r.is_valid)
        std::cout << n.name << " times " << factor << ": " << r.message << std::endl;
      assert(r.is_valid);
      check_quads(s, t, lengths);
    }
  }
}

// The energy that lengths have: of all differences between integer and real sides, in the Dirichlet norm.
double energy(const QM::T_mesh& t, const std::vector<int>& lengths)
{
  double sum = 0;
  for(std::size_t p = 0; p < t.patches.size(); ++p)
    for(int k = 0; k < 2; ++k)
    {
      const double thinnest = 0.25;
      const double w = t.length(static_cast<int>(p), k), h = t.length(static_cast<int>(p), 1 - k);
      double n = 0;
      for(int d : t.patches[p].sides[k])
        n += lengths[d / 2];
      sum += (std::max)(thinnest, h) / (std::max)(thinnest, w) * CGAL::square(n - w);
    }
  return sum;
}

// The least energy of all consistent lengths with at least one everywhere, and at most a number.
double least_energy(const QM::T_mesh& t, int most)
{
  const int n = static_cast<int>(t.arcs.size());
  std::vector<int> lengths(n, 0);
  double best = (std::numeric_limits<double>::max)();
  // A patch is checked once its last arc has a length.
  std::vector<std::vector<std::pair<int, int>>> closed(n);
  for(std::size_t p = 0; p < t.patches.size(); ++p)
    for(int k = 0; k < 2; ++k)
    {
      int last = 0;
      for(int side : { k, k + 2 })
        for(int d : t.patches[p].sides[side])
          last = (std::max)(last, d / 2);
      closed[last].emplace_back(static_cast<int>(p), k);
    }
  const std::function<void(int)> choose = [&](int a)
  {
    if(a == n)
    {
      best = (std::min)(best, energy(t, lengths));
      return;
    }
    for(lengths[a] = 1; lengths[a] <= most; ++lengths[a])
    {
      bool fits = true;
      for(const auto& c : closed[a])
      {
        int difference = 0;
        for(int d : t.patches[c.first].sides[c.second])
          difference += lengths[d / 2];
        for(int d : t.patches[c.first].sides[c.second + 2])
          difference -= lengths[d / 2];
        fits = fits && difference == 0;
      }
      if(fits)
        choose(a + 1);
    }
    lengths[a] = 0;
  };
  choose(0);
  return best;
}

// Against all lengths there are, on small T-meshes, with every arc at least one long.
void test_brute_force()
{
  const std::vector<Named_soup> small = { { "cube", test_meshes::cube(4), 0.4 },
                                          { "sheared cube", test_meshes::sheared_cube(4), 0.45 },
                                          { "tube", test_meshes::cylinder(16, 8, false), 0.9 },
                                          { "square with a hole", test_meshes::grid_with_hole(12, 12, 3, 7, 4, 9),
                                            0.4 } };
  for(const Named_soup& n : small)
  {
    Mapped_surface s(n.soup, n.length);
    const QM::T_mesh t = s.t_mesh();
    check_t_mesh(s, t);
    const std::vector<int> at_least(t.arcs.size(), 1);
    const double best = least_energy(t, t.arcs.size() > 12 ? 2 : 7);
    // From the rounded lengths, and from far longer ones.
    for(int factor : { 1, 3 })
    {
      std::vector<int> lengths;
      for(const QM::T_mesh::Arc& a : t.arcs)
        lengths.push_back(factor * static_cast<int>(a.rounded_length));
      QM::internal::T_mesh_lengths search(t, lengths, at_least);
      assert(search.satisfy_bounds());
      search.improve();
      assert(std::abs(search.energy() - energy(t, lengths)) < 1e-9 * (1 + search.energy()));
      std::cout << n.name << " x " << factor << ": " << t.arcs.size() << " arcs, energy " << search.energy()
                << ", least " << best << std::endl;
      assert(search.energy() <= best * (1 + 1e-9) + 1e-9);
    }
  }
}

// A cube is mapped as it is; the rings of a cup that widens get as many quads at both ends. The size of quads does not
// matter.
void test_distortion()
{
  const test_meshes::Soup cup =
    test_meshes::mapped(test_meshes::cylinder(48, 24, false), [](const test_meshes::Kernel::Point_3& p)
                        { return test_meshes::Kernel::Point_3((1 + p.z()) * p.x(), (1 + p.z()) * p.y(), 3 * p.z()); });
  std::vector<double> of_cup;
  for(double length : { 0.25, 0.125 })
  {
    const Mapped_surface cube(test_meshes::cube(8), length);
    assert(std::abs(cube.map.distortion() - 1) < 1e-9);
    assert(std::abs(cube.map.number_of_quads() * length * length - 6) < 1e-6);
    of_cup.push_back(Mapped_surface(cup, length).map.distortion());
    std::cout << "cup: " << of_cup.back() << std::endl;
  }
  assert(of_cup[0] > 1.02 && std::abs(of_cup[0] - of_cup[1]) < 0.005);
}

// Before a map is rounded, and where borders are not aligned, there is no T-mesh; it says so, and there are no lengths.
void test_refusals()
{
  Mapped_surface s(test_meshes::cube(4), 0.4);
  Mesh tube = test_meshes::make_mesh<Mesh>(test_meshes::cylinder(24, 12, false));
  auto angle = tube.add_property_map<Mesh::Face_index, double>("f:angle").first;
  auto jump = tube.add_property_map<Mesh::Edge_index, int>("e:jump").first;
  auto index = tube.add_property_map<Mesh::Vertex_index, int>("v:index").first;
  auto uv = tube.add_property_map<Mesh::Halfedge_index, test_meshes::Kernel::Point_2>("h:uv").first;
  const auto np = parameters::target_edge_length(0.3).align_boundary(false);
  assert(QM::smooth_cross_field(tube, angle, jump, index, np).is_valid());
  QM::Seamless_map map(tube, angle, jump, index, np);
  assert(map.is_solved());
  map.round_without_repair(tube, 1, uv);
  for(const QM::T_mesh& t : { s.map.t_mesh(), map.t_mesh() })
  {
    std::vector<int> lengths;
    const QM::T_mesh_quantization_result r = QM::quantize_t_mesh(t, lengths);
    std::cout << r.message << std::endl;
    assert(!t.is_valid() && !r.is_valid && !r.message.empty() && lengths.empty());
  }
}

// The T-mesh is a layout of its mesh: as many patches, features on quad edges, at any density.
void t_meshes_are_layouts()
{
  const std::vector<Named_soup> with_and_without_features = { surfaces()[0], surfaces()[1] };
  for(const Named_soup& s : with_and_without_features)
  {
    Mapped_surface surface(s.soup, s.length);
    const QM::T_mesh t = surface.t_mesh();
    const QM::Surface_layout layout = QM::layout_from_t_mesh(t);
    assert(layout.nodes.size() == t.nodes.size() && layout.arcs.size() == t.arcs.size());
    for(double quads : { 300., 1200. })
    {
      Mesh qm;
      const QM::Layout_quadrangulation_result r =
        QM::quadrangulate_layout(surface.mesh, layout, qm,
                                 parameters::target_number_of_quads(quads).edge_is_constrained_map(surface.is_feature));
      std::cout << "  " << s.name << ": " << r.message << std::endl;
      assert(r.is_valid() && r.patches == t.patches.size() && r.folded_patches == 0);
      assert(r.feature_length_on_arcs >= 0.999 * r.feature_length);
    }
  }
  assert(QM::layout_from_t_mesh(QM::T_mesh()).patches.empty());
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "partition", test_partition },
                     { "places", test_places },
                     { "any_density", test_any_density },
                     { "any_start", test_any_start },
                     { "brute_force", test_brute_force },
                     { "layouts", t_meshes_are_layouts },
                     { "distortion", test_distortion },
                     { "refusals", test_refusals } });
}
