// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Coarse layouts and the optimization of the structure: whatever lengths the arcs of a motorcycle complex get, the mesh
// is a pure quad mesh of the same topology with the same irregular vertices; twisted meshes come back to
// their few patches; the shape of the quads does not become much worse.

#include "quad_mesh_checks.h"
#include "structure_meshes.h"
#include "test_cases.h"
#include "visitor_checks.h"

#include <CGAL/Quad_meshing/Layout/Layout_curves.h>
#include <CGAL/Quad_meshing/Layout/Layout_distortion.h>
#include <CGAL/Quad_meshing/Layout/Layout_quantization.h>
#include <CGAL/Quad_meshing/Layout/Layout_realization.h>
#include <CGAL/Quad_meshing/Layout/Motorcycle_complex.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/grid_preserving_operators.h>
#include <CGAL/Quad_meshing/Structure/internal/Accepted_shape.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_execution.h>
#include <CGAL/Quad_meshing/Structure/internal/Gp_search.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_goals.h>
#include <CGAL/Quad_meshing/Structure/optimize_quad_structure.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace SM = structure_meshes;
typedef SM::Mesh Mesh;
typedef QM::internal::Indexed_quad_mesh Flat_mesh;
typedef QM::Quad_structure_optimization_result Result;
typedef QM::Quad_mesh_status Status;
using QM::internal::Layout_curves;
using QM::internal::Layout_distortion;
using QM::internal::Layout_quantization;
using QM::internal::Layout_realization;
using QM::internal::Motorcycle_complex;

namespace {

QM::internal::Any_visitor nobody; // lets everything pass

// Few attempts: these meshes are small.
auto options(QM::Structure_method method = QM::Structure_method::LAYOUT)
{
  return CGAL::parameters::structure_method(method).number_of_iterations(400u);
}

Flat_mesh flat(const SM::Quad_soup& soup) { return QM::internal::make_indexed_quad_mesh(SM::make_mesh(soup)).mesh; }

// A mesh after some random operators.
Flat_mesh twisted(Flat_mesh m, int operators, unsigned int seed)
{
  CGAL::Random random(seed);
  for(int i = 0; i < operators; ++i)
  {
    const QM::internal::Quad_vertex_rules rules = QM::internal::make_quad_vertex_rules(m, false);
    QM::internal::Gp_search search(m, rules);
    const QM::internal::Gp_path path =
      search.close({ 3 * random.get_int(0, m.number_of_halfedges()) + 2 * random.get_int(0, 2) });
    if(path.empty())
      continue;
    std::vector<char> weight(m.number_of_vertices());
    for(int v = 0; v < m.number_of_vertices(); ++v)
      weight[v] = rules.is_special[v] ? 2 : rules.on_feature[v] || rules.on_border[v];
    const Flat_mesh result = QM::internal::Gp_execution(m, path).execute(weight);
    if(QM::internal::is_valid_quad_mesh(result))
      m = result;
  }
  return m;
}

Mesh graph(const Flat_mesh& m)
{
  SM::Quad_soup soup;
  soup.points = m.points;
  for(const std::array<int, 4>& c : m.corners)
    soup.quads.push_back({ { std::size_t(c[0]), std::size_t(c[1]), std::size_t(c[2]), std::size_t(c[3]) } });
  return SM::make_mesh(soup);
}

bool same_topology(const QM::Quad_mesh_structure& s, const QM::Quad_mesh_structure& t)
{
  return s.inner_valences == t.inner_valences && s.boundary_valences == t.boundary_valences &&
         s.euler_characteristic == t.euler_characteristic && s.number_of_components == t.number_of_components &&
         s.number_of_boundary_loops == t.number_of_boundary_loops;
}

// What an optimization promises about the shape of the quads.
void check_shape(const QM::Quad_mesh_quality& before, const QM::Quad_mesh_quality& after)
{
  assert(after.number_of_inverted_quads <= before.number_of_inverted_quads);
  assert(before.minimal_scaled_jacobian <= 0 || after.minimal_scaled_jacobian >= 0.5 * before.minimal_scaled_jacobian);
}

// The irregular base mesh that a triangulated cube gives.
SM::Quad_soup irregular()
{
  const SM::Quad_soup base = SM::cube(2);
  std::vector<std::array<std::size_t, 3>> triangles;
  for(const auto& q : base.quads)
  {
    triangles.push_back({ { q[0], q[1], q[2] } });
    triangles.push_back({ { q[0], q[2], q[3] } });
  }
  return SM::split_triangles(base.points, triangles);
}

// Two thirds of a mesh: irregular vertices on its boundary.
SM::Quad_soup opened(SM::Quad_soup s)
{
  s.quads.resize(s.quads.size() * 2 / 3);
  std::vector<std::size_t> number(s.points.size(), std::size_t(-1));
  SM::Quad_soup used;
  for(auto& q : s.quads)
    for(std::size_t& v : q)
    {
      if(number[v] == std::size_t(-1))
      {
        number[v] = used.points.size();
        used.points.push_back(s.points[v]);
      }
      v = number[v];
    }
  used.quads = s.quads;
  return used;
}

std::multiset<std::array<long, 3>> rounded_points(const Flat_mesh& m)
{
  std::multiset<std::array<long, 3>> result;
  for(const auto& p : m.points)
    result.insert({ { std::lround(1e6 * p.x()), std::lround(1e6 * p.y()), std::lround(1e6 * p.z()) } });
  return result;
}

void check_complex(const Flat_mesh& m, const Motorcycle_complex& complex)
{
  assert(complex.is_valid);
  int quads = 0, pieces = 0, border = 0;
  for(const auto& p : complex.patches)
  {
    quads += p.width * p.height;
    for(int k = 0; k < 4; ++k)
    {
      int length = 0;
      for(const auto& s : p.sides[k])
        length += complex.arcs[s.arc].length();
      assert(length == (k % 2 == 0 ? p.width : p.height));
      pieces += int(p.sides[k].size());
    }
  }
  assert(quads == m.number_of_faces());
  for(const auto& a : complex.arcs)
  {
    assert(a.patch[0] != -1 && (a.patch[1] == -1) == a.is_border);
    border += a.is_border;
  }
  assert(pieces == 2 * int(complex.arcs.size()) - border);
}

void test_layouts()
{
  std::cout << "layouts" << std::endl;
  const Flat_mesh round = flat(SM::sphere(9));
  Flat_mesh creased = flat(SM::cube(6));
  for(int h = 0; h < creased.number_of_halfedges(); ++h)
  {
    const SM::Point_3 &p = creased.points[creased.source(h)], &q = creased.points[creased.target(h)];
    int fixed = 0;
    for(int k = 0; k < 3; ++k)
      fixed += std::abs(p[k]) == 1 && p[k] == q[k];
    creased.is_feature[h] = fixed == 2;
  }
  // a closed feature without any node, and one that ends inside
  Flat_mesh ringed = flat(SM::rolled(12, 8, 0, false)), cut = flat(SM::grid(8, 8));
  for(int h = 0; h < ringed.number_of_halfedges(); ++h)
    ringed.is_feature[h] = std::abs(ringed.points[ringed.source(h)].z() - ringed.points[ringed.target(h)].z()) < 1e-9 &&
                           std::abs(ringed.points[ringed.source(h)].z() - 4 * 2 * SM::pi / 12) < 1e-9;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    cut.is_feature[h] = cut.points[cut.source(h)].y() == 4 && cut.points[cut.target(h)].y() == 4 &&
                        cut.points[cut.source(h)].x() <= 5 && cut.points[cut.target(h)].x() <= 5;
  const std::vector<Flat_mesh> meshes = { round,
                                          twisted(round, 6, 1),
                                          creased,
                                          twisted(creased, 5, 2),
                                          ringed,
                                          cut,
                                          flat(SM::rolled(12, 8, 0, true)),
                                          flat(SM::rolled(12, 8, 1, true)),
                                          flat(SM::rolled(9, 7, 2, false)),
                                          twisted(flat(SM::refined(irregular(), 4)), 20, 3),
                                          twisted(flat(opened(SM::refined(irregular(), 3))), 10, 4),
                                          flat(SM::grid(7, 5)) };
  int number = 0, changes = 0, not_representable = 0;
  for(const Flat_mesh& m : meshes)
  {
    const std::vector<char> is_fixed(m.number_of_vertices(), 0);
    const Motorcycle_complex complex(m, is_fixed);
    check_complex(m, complex);
    Layout_quantization quantization(m, complex, is_fixed, false);
    const QM::Quad_mesh_structure before = QM::internal::structure_of_quad_mesh(m);
    std::size_t features = 0;
    for(char f : m.is_feature)
      features += f;

    // with the lengths it has, the mesh comes back as it is
    const Layout_realization same(m, quantization, quantization.length, is_fixed);
    assert(same.is_closed_up && QM::internal::is_valid_quad_mesh(same.mesh));
    assert(rounded_points(same.mesh) == rounded_points(m));
    const QM::Quad_mesh_structure s = QM::internal::structure_of_quad_mesh(same.mesh);
    assert(same_topology(s, before) && s.number_of_patches == before.number_of_patches);
    assert(s.number_of_helices == before.number_of_helices && s.number_of_dual_curves == before.number_of_dual_curves);
    assert(std::size_t(std::count(same.mesh.is_feature.begin(), same.mesh.is_feature.end(), 1)) == features);

    // random changes
    CGAL::Random random(++number);
    for(int i = 0; i < 150; ++i)
    {
      const int arc = random.get_int(0, int(complex.arcs.size()));
      const double scale = random.get_double(0.5, 4);
      if(!quantization.change(arc, i % 3 == 0 ? 1 : -1, scale, random.get_double(0, 0.2), false))
        continue;
      ++changes;
      const Layout_curves curves(quantization, quantization.length);
      std::size_t patches = 0;
      for(int multiplicity : { 1, 2, 3 })
      {
        const std::vector<int> length = curves.lengths(std::vector<int>(curves.number_of_curves(), multiplicity));
        const Layout_realization r(m, quantization, length, is_fixed);
        assert(r.is_closed_up);
        assert(r.mesh.number_of_faces() == quantization.number_of_quads(length));
        if(!QM::internal::is_valid_quad_mesh(r.mesh))
        {
          // edges that share both ends; threefold, they do not any more
          assert(multiplicity < 3);
          ++not_representable;
          continue;
        }
        const QM::Quad_mesh_defects d = QM::find_quad_mesh_defects(r.mesh.points, r.mesh.corners);
        assert(d.is_pure_quad_mesh() && d.isolated_vertices == 0);
        const QM::Quad_mesh_structure after = QM::internal::structure_of_quad_mesh(r.mesh);
        assert(same_topology(after, before));
        // parallel curves change nothing in the structure
        if(before.number_of_irregular_vertices > 0)
          assert(patches == 0 || after.number_of_patches == patches);
        patches = after.number_of_patches;
        assert(std::count(r.mesh.is_feature.begin(), r.mesh.is_feature.end(), 1) > 0 || features == 0);
      }
    }
  }
  std::cout << "  " << changes << " changes, " << not_representable << " meshes with double edges" << std::endl;
  assert(changes > 500);
}

// The distortion of a layout does not depend on its scale, it is what a map costs that is the same everywhere, and its
// slope foretells how it changes.
void test_distortion()
{
  std::cout << "distortion" << std::endl;
  for(const Flat_mesh& m :
      { flat(SM::grid(8, 8)), flat(SM::sphere(6)), twisted(flat(SM::refined(irregular(), 3)), 8, 1) })
  {
    const std::vector<char> is_fixed(m.number_of_vertices(), 0);
    const Motorcycle_complex complex(m, is_fixed);
    const Layout_quantization quantization(m, complex, is_fixed, false);
    const Layout_distortion distortion(m, complex, quantization.rules(), is_fixed, nobody);
    std::vector<int> length = quantization.length;
    for(int factor : { 1, 3 })
    {
      for(std::size_t a = 0; a < length.size(); ++a)
        length[a] = factor * quantization.length[a];
      assert(std::abs(distortion(length)) < 1e-9);
    }
  }

  // a square that becomes twice as wide as high: 2s - 1 and s - 1 are the strains, at the scale s
  const Flat_mesh square = flat(SM::grid(8, 8));
  const std::vector<char> none(square.number_of_vertices(), 0);
  const Motorcycle_complex complex(square, none);
  const Layout_quantization quantization(square, complex, none, false);
  const Layout_distortion distortion(square, complex, quantization.rules(), none, nobody);
  assert(complex.patches.size() == 1);
  std::vector<int> wide = quantization.length;
  for(int k : { 0, 2 })
    for(const auto& s : complex.patches[0].sides[k])
      wide[s.arc] *= 2;
  const double st = QM::internal::Layout_weights::stretch, si = QM::internal::Layout_weights::size,
               scale = 6 * si / (st + 9 * si);
  assert(std::abs(distortion(wide) - (st * scale * scale + si * (3 * scale - 2) * (3 * scale - 2))) < 1e-9);

  // random changes: never negative, and the prices are the slope along all changes that keep opposite sides equal
  const Flat_mesh m = twisted(flat(SM::refined(irregular(), 3)), 8, 2);
  const std::vector<char> is_fixed(m.number_of_vertices(), 0);
  const Motorcycle_complex walls(m, is_fixed);
  Layout_quantization lengths(m, walls, is_fixed, false);
  const Layout_distortion d(m, walls, lengths.rules(), is_fixed, nobody);
  CGAL::Random random(5);
  int changes = 0, agreeing = 0;
  for(int i = 0; i < 300; ++i)
  {
    const std::vector<int> before = lengths.length;
    const double now = d(before);
    const std::vector<double> price = d.prices(before);
    if(!lengths.change(random.get_int(0, int(walls.arcs.size())), i % 2 == 0 ? 1 : -1, 1., 0.1, false))
      continue;
    double slope = 0;
    for(std::size_t a = 0; a < price.size(); ++a)
      slope += price[a] * (lengths.length[a] - before[a]);
    const double then = d(lengths.length);
    assert(now > -1e-9 && then > -1e-9);
    // to first order only
    if(std::abs(slope) > 1)
    {
      ++changes;
      agreeing += (slope > 0) == (then > now);
    }
  }
  std::cout << "  " << agreeing << " of " << changes << " changes of the distortion foretold" << std::endl;
  assert(changes > 50 && agreeing > 0.75 * changes);
}

// The least distortion of a grid of n x n quads when the vertex (below, 0) goes to `new_below`, the vertex (above, n)
// to `new_above` and the side x = n to `new_width`, by a dense system with all displacements, for the best scale.
double distortion_by_displacements(int n, int below, int above, double new_below, double new_above, double new_width)
{
  typedef QM::internal::Layout_weights Weights;
  auto unknown = [n](int i, int j, int k) { return 2 * ((n + 1) * j + i) + k; };
  const int size = 2 * (n + 1) * (n + 1);
  Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(size, size);
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i)
      for(int corner = 0; corner < 4; ++corner)
      {
        // The derivatives of both coordinates along the sides at this corner.
        const int y = corner / 2, x = corner % 2;
        auto row = [&](int k, int direction)
        {
          Eigen::VectorXd r = Eigen::VectorXd::Zero(size);
          const int i0 = direction == 0 ? i : i + x, j0 = direction == 0 ? j + y : j;
          r[unknown(i0, j0, k)] -= 1;
          r[unknown(i0 + (direction == 0), j0 + (direction == 1), k)] += 1;
          return r;
        };
        const Eigen::VectorXd a = row(0, 0), b = row(0, 1), c = row(1, 0), d = row(1, 1);
        const double share = 1. / (4 * n * n);
        auto add = [&](const Eigen::VectorXd& r, double weight) { energy += weight * share * r * r.transpose(); };
        add(b + c, 1);
        add(a - d, Weights::stretch);
        add(a + d, Weights::size);
        add(b - c, Weights::rotation);
      }
  auto least_energy = [&](double scale)
  {
    std::vector<double> given(size, std::numeric_limits<double>::infinity());
    for(int k = 0; k <= n; ++k)
    {
      given[unknown(0, k, 0)] = 0;
      given[unknown(n, k, 0)] = scale * new_width - n;
      given[unknown(k, 0, 1)] = 0;
      given[unknown(k, n, 1)] = scale * n - n;
    }
    given[unknown(below, 0, 0)] = scale * new_below - below;
    given[unknown(above, n, 0)] = scale * new_above - above;
    // The other displacements: E_ff x = -E_fg g.
    Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
    std::vector<int> free;
    for(int i = 0; i < size; ++i)
      if(std::isfinite(given[i]))
        x[i] = given[i];
      else
        free.push_back(i);
    const Eigen::VectorXd force = energy * x;
    Eigen::MatrixXd matrix(free.size(), free.size());
    Eigen::VectorXd rhs(free.size());
    for(std::size_t i = 0; i < free.size(); ++i)
    {
      rhs[i] = -force[free[i]];
      for(std::size_t j = 0; j < free.size(); ++j)
        matrix(i, j) = energy(free[i], free[j]);
    }
    const Eigen::VectorXd solution = matrix.ldlt().solve(rhs);
    for(std::size_t i = 0; i < free.size(); ++i)
      x[free[i]] = solution[i];
    return x.dot(energy * x);
  };
  // A parabola in the scale.
  const double e0 = least_energy(0), e1 = least_energy(1), e2 = least_energy(2);
  const double curvature = (e0 - 2 * e1 + e2) / 2, slope = (e2 - e0) / 2 - 2 * curvature;
  return e0 - slope * slope / (4 * curvature);
}

// Two vertices that stay on opposite sides of a grid are shifted against each other, which shears and turns quads: all
// weights count.
void test_distortion_of_shifted_vertices()
{
  const int n = 6, below = 2, above = 4;
  const Flat_mesh m = flat(SM::grid(n, n));
  std::vector<char> is_fixed(m.number_of_vertices(), 0);
  for(int v = 0; v < m.number_of_vertices(); ++v)
  {
    const auto& p = m.points[v];
    is_fixed[v] = (p.x() == below && p.y() == 0) || (p.x() == above && p.y() == n);
  }
  assert(std::count(is_fixed.begin(), is_fixed.end(), 1) == 2);
  const Motorcycle_complex complex(m, is_fixed);
  const Layout_quantization quantization(m, complex, is_fixed, false);
  const Layout_distortion distortion(m, complex, quantization.rules(), is_fixed, nobody);
  // Lines from both vertices cut the grid into three strips. The one in the middle becomes twice as wide.
  assert(complex.patches.size() == 3);
  std::vector<int> length = quantization.length;
  int arcs = 0;
  for(std::size_t a = 0; a < complex.arcs.size(); ++a)
  {
    double from = n, to = 0, height = 0;
    for(int h : complex.arcs[a].halfedges)
    {
      const auto &p = m.points[m.source(h)], &q = m.points[m.source(m.next(h))];
      from = (std::min)({ from, p.x(), q.x() });
      to = (std::max)({ to, p.x(), q.x() });
      height += std::abs(p.y() - q.y());
    }
    if(height == 0 && from >= below && to <= above)
    {
      ++arcs;
      length[a] *= 2;
    }
  }
  assert(arcs == 2);
  const double width = above - below,
               expected = distortion_by_displacements(n, below, above, below, above + width, n + width);
  std::cout << "  " << distortion(length) << ", by displacements " << expected << std::endl;
  assert(std::abs(distortion(length) - expected) < 1e-6 * expected);
}

// The prices are the gradient of the distortion, but for a factor, along all changes that keep opposite sides equal.
// The distortion does not depend on the scale, so small steps are taken from large multiples of the lengths.
void test_distortion_derivatives()
{
  constexpr int multiple = 1000;
  const Flat_mesh m = twisted(flat(SM::refined(irregular(), 3)), 8, 2);
  const std::vector<char> is_fixed(m.number_of_vertices(), 0);
  const Motorcycle_complex walls(m, is_fixed);
  Layout_quantization lengths(m, walls, is_fixed, false);
  const Layout_distortion d(m, walls, lengths.rules(), is_fixed, nobody);
  CGAL::Random random(7);
  // away from the lengths of the input, where the gradient vanishes
  auto change = [&](int by) { return lengths.change(random.get_int(0, int(walls.arcs.size())), by, 1., 0.1, false); };
  for(int i = 0; i < 20; ++i)
    change(i % 2 == 0 ? 1 : -1);
  const std::vector<int> start = lengths.length;
  const std::vector<double> price = d.prices(start);
  std::vector<double> foretold, measured;
  for(int i = 0; i < 60; ++i)
  {
    lengths.length = start;
    if(!change(1))
      continue;
    std::vector<int> more = start, less = start;
    double slope = 0;
    for(std::size_t a = 0; a < start.size(); ++a)
    {
      const int by = lengths.length[a] - start[a];
      more[a] = multiple * start[a] + by;
      less[a] = multiple * start[a] - by;
      slope += price[a] * by;
    }
    foretold.push_back(slope);
    measured.push_back(multiple * (d(more) - d(less)) / 2);
  }
  // the factor by least squares; what is left is rounding
  double fm = 0, ff = 0, mm = 0, left = 0;
  for(std::size_t i = 0; i < foretold.size(); ++i)
  {
    fm += foretold[i] * measured[i];
    ff += foretold[i] * foretold[i];
    mm += measured[i] * measured[i];
  }
  for(std::size_t i = 0; i < foretold.size(); ++i)
    left += CGAL::square(measured[i] - fm / ff * foretold[i]);
  std::cout << "  " << foretold.size() << " directions, relative residual " << std::sqrt(left / mm) << std::endl;
  assert(foretold.size() > 20 && fm > 0 && left < 1e-6 * mm);
}

// A cube twisted by a random shift comes back to its six patches.
void test_twisted_cubes(QM::Structure_method method)
{
  std::cout << "twisted cubes" << std::endl;
  int number = 0;
  for(unsigned int seed = 0; seed < 6; ++seed)
  {
    Mesh qm = graph(twisted(flat(SM::sphere(12)), 1, seed));
    const QM::Quad_mesh_structure before = QM::quad_mesh_structure(qm);
    if(before.number_of_patches == 6)
      continue;
    ++number;
    const Mesh reference = SM::triangulated(SM::sphere(20));
    const Result r = QM::optimize_quad_structure(qm, reference, options(method));
    assert(r.status == Status::SUCCESS && r.structure_before.number_of_patches == before.number_of_patches);
    const QM::Quad_mesh_structure after = QM::quad_mesh_structure(qm);
    assert(after.number_of_patches == 6 && after.number_of_helices == 0 && same_topology(after, before));
    assert(QM::quad_mesh_quality(qm).minimal_scaled_jacobian > 0);
    assert(CGAL::is_valid_polygon_mesh(qm) && quad_mesh_checks::figures(qm).consistent);
    for(auto v : qm.vertices())
      assert(std::abs(std::sqrt((qm.point(v) - CGAL::ORIGIN).squared_length()) - 1) < 0.02);
  }
  assert(number > 2);
}

// The grid of a cube is cut along its equator and glued again some quads further on: the twelve lines between the eight
// corners become helices. They come back.
void test_cubes_with_helices(QM::Structure_method method)
{
  std::cout << "cubes with helices" << std::endl;
  for(int shift = 1; shift <= (method == QM::Structure_method::HELICES ? 2 : 1); ++shift)
  {
    Mesh qm = SM::make_mesh(SM::sphere(9));
    for(int i = 0; i < shift; ++i)
    {
      // the dual curve along the equator crosses edges whose ends have opposite heights
      Mesh::Halfedge_index h = *qm.halfedges().begin();
      while(!(qm.point(qm.source(h)).z() > 0.01 && qm.point(qm.target(h)).z() < -0.01))
        ++h;
      const auto flip = QM::dual_curve_operator(qm, h, QM::Grid_preserving_step_kind::SHIFT_LEFT);
      assert(flip.size() == 36 && QM::apply_grid_preserving_operator(qm, flip));
    }
    const QM::Quad_mesh_structure before = QM::quad_mesh_structure(qm);
    assert(before.number_of_patches > 6 && before.number_of_helices > 0 && before.inner_valences.at(3) == 8);
    const QM::Quad_mesh_quality quality = QM::quad_mesh_quality(qm);
    const Result r = QM::optimize_quad_structure(qm, SM::triangulated(SM::sphere(20)), options(method));
    const QM::Quad_mesh_structure after = QM::quad_mesh_structure(qm);
    assert(r.status == Status::SUCCESS && same_topology(after, before));
    assert(after.number_of_patches == 6 && after.number_of_helices == 0 && after.number_of_nodes == 8);
    check_shape(quality, QM::quad_mesh_quality(qm));
  }
}

void test_twisted_meshes()
{
  std::cout << "twisted meshes" << std::endl;
  const Mesh reference = SM::triangulated(SM::sphere(24));
  for(unsigned int seed = 0; seed < 2; ++seed)
    for(QM::Structure_method method : { QM::Structure_method::LAYOUT, QM::Structure_method::HELICES })
    {
      SM::Quad_soup ball = SM::refined(irregular(), 3);
      for(SM::Point_3& p : ball.points)
        p = CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length());
      Mesh qm = graph(twisted(flat(ball), 12, seed));
      QM::smooth_quad_mesh(qm, reference);
      const QM::Quad_mesh_structure before = QM::quad_mesh_structure(qm);
      const QM::Quad_mesh_quality quality = QM::quad_mesh_quality(qm);
      const Mesh input = qm;
      const Result r = QM::optimize_quad_structure(qm, reference, options(method));
      const QM::Quad_mesh_structure after = QM::quad_mesh_structure(qm);
      assert(r.status == Status::SUCCESS && same_topology(after, before));
      assert(after.number_of_patches <= before.number_of_patches && after.number_of_quads <= before.number_of_quads);
      if(method == QM::Structure_method::LAYOUT)
        assert(after.number_of_patches < 0.8 * before.number_of_patches &&
               after.number_of_quads > 0.7 * before.number_of_quads);
      else
        assert(after.number_of_helices <= before.number_of_helices &&
               after.number_of_helices_with_crossings < before.number_of_helices_with_crossings);
      check_shape(quality, QM::quad_mesh_quality(qm));
      assert(CGAL::is_valid_polygon_mesh(qm) && quad_mesh_checks::figures(qm).vertex_manifold);

      // same input, same output; on another graph too
      Mesh again = input;
      QM::optimize_quad_structure(again, reference, options(method));
      assert(again.number_of_faces() == qm.number_of_faces());
      assert(std::equal(again.points().begin(), again.points().end(), qm.points().begin()));
    }
}

// Few helices are left, in whichever way the search ends; and no curve with helices is multiplied beyond what is
// tolerated.
void test_helices_become_few()
{
  std::cout << "helices become few" << std::endl;
  std::size_t before = 0, after = 0;
  for(unsigned int seed = 0; seed < 4; ++seed)
  {
    Mesh qm = graph(twisted(flat(SM::refined(irregular(), 4)), 12, seed));
    const Result r = QM::optimize_quad_structure(qm, options().smoothing_iterations(0));
    before += r.structure_before.number_of_helices;
    after += r.structure_after.number_of_helices;
    std::cout << "  " << r.structure_before.number_of_helices << " -> " << r.structure_after.number_of_helices
              << ", patches " << r.structure_before.number_of_patches << " -> " << r.structure_after.number_of_patches
              << ", quads " << r.structure_before.number_of_quads << " -> " << r.structure_after.number_of_quads
              << std::endl;
  }
  assert(before >= 20 && after <= 0.2 * before);

  // one by one: no step makes more of them, in either way of counting
  for(unsigned int seed = 0; seed < 2; ++seed)
  {
    Mesh qm = graph(twisted(flat(SM::refined(irregular(), 4)), 12, seed));
    const Result r = QM::optimize_quad_structure(qm, options(QM::Structure_method::HELICES).smoothing_iterations(0));
    std::cout << "  " << r.structure_before.number_of_helices << " -> " << r.structure_after.number_of_helices
              << ", with crossings " << r.structure_before.number_of_helices_with_crossings << " -> "
              << r.structure_after.number_of_helices_with_crossings << std::endl;
    assert(r.structure_after.number_of_helices <= r.structure_before.number_of_helices &&
           r.structure_after.number_of_helices_with_crossings < r.structure_before.number_of_helices_with_crossings);
  }
}

void test_features()
{
  std::cout << "features" << std::endl;
  Mesh qm = SM::make_mesh(SM::cube(12));
  auto feature = qm.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  auto is_fixed = qm.add_property_map<Mesh::Vertex_index, bool>("v:fixed", false).first;
  auto on_cube_edge = [&](Mesh::Edge_index e)
  {
    int fixed = 0;
    const SM::Point_3 &p = qm.point(qm.vertex(e, 0)), &q = qm.point(qm.vertex(e, 1));
    for(int k = 0; k < 3; ++k)
      fixed += std::abs(std::abs(p[k]) - 1) < 1e-9 && std::abs(p[k] - q[k]) < 1e-9;
    return fixed == 2;
  };
  for(auto e : qm.edges())
    feature[e] = on_cube_edge(e);
  // helices around each of the cube's corners: features are not shifted, the rings around them are
  const Mesh::Vertex_index anchor(200);
  is_fixed[anchor] = true;
  const SM::Point_3 place = qm.point(anchor);
  const Result r = QM::optimize_quad_structure(
    qm, SM::triangulated(SM::cube(4)),
    options().target_number_of_quads(400).edge_is_constrained_map(feature).vertex_is_constrained_map(is_fixed));
  assert(r.status == Status::SUCCESS && qm.number_of_faces() <= 400 && qm.number_of_faces() > 200);
  std::size_t corners = 0;
  for(auto v : qm.vertices())
    corners += std::abs(qm.point(v).x()) == 1 && std::abs(qm.point(v).y()) == 1 && std::abs(qm.point(v).z()) == 1;
  assert(corners == 8);
  for(auto e : qm.edges())
    assert(feature[e] == on_cube_edge(e));
  assert(qm.is_valid(anchor) && is_fixed[anchor] && qm.point(anchor) == place);
}

// Given the directions that the sides of quads should have, the smoothing of a layout turns them there.
void test_directions()
{
  const double pi = std::acos(-1.), angle = pi / 12, largest_height = 0.5;
  const Mesh reference = SM::triangulated(SM::sphere(24));
  const SM::Kernel::Vector_3 up(0, 0, 1);
  auto direction_at = [&](const SM::Point_3& p, double turn)
  {
    const SM::Kernel::Vector_3 n = p - CGAL::ORIGIN, along = CGAL::cross_product(up, n),
                               across = CGAL::cross_product(n, along);
    return std::cos(turn) / std::sqrt(along.squared_length()) * along +
           std::sin(turn) / std::sqrt(across.squared_length()) * across;
  };
  std::vector<std::optional<SM::Kernel::Vector_3>> directions;
  for(Mesh::Face_index f : reference.faces())
  {
    const Mesh::Halfedge_index h = reference.halfedge(f);
    const SM::Point_3 p = CGAL::centroid(reference.point(reference.source(h)), reference.point(reference.target(h)),
                                         reference.point(reference.target(reference.next(h))));
    directions.emplace_back();
    if(std::abs(p.z()) < largest_height)
      directions.back() = direction_at(p, angle);
  }
  // Of the edges around the equator, on average, in degrees.
  auto deviation = [&](const Mesh& qm)
  {
    double sum = 0;
    int number = 0;
    for(Mesh::Edge_index e : qm.edges())
    {
      const SM::Point_3 &p = qm.point(qm.vertex(e, 0)), &q = qm.point(qm.vertex(e, 1)), m = CGAL::midpoint(p, q);
      if(std::abs(m.z()) > largest_height)
        continue;
      const double turn = std::atan2((q - p) * direction_at(m, angle + pi / 2), (q - p) * direction_at(m, angle));
      sum += std::abs(turn - pi / 2 * std::round(turn / (pi / 2))) * 180 / pi;
      ++number;
    }
    return sum / number;
  };
  Mesh without = SM::make_mesh(SM::sphere(12)), with = without;
  typedef CGAL::Constant_property_map<Mesh::Face_index, double> Weight;
  const auto of_quads = CGAL::parameters::smoothing_iterations(60u);
  const Result r = QM::optimize_quad_structure(without, reference, of_quads);
  const Result s = QM::optimize_quad_structure(
    with, reference, of_quads,
    CGAL::parameters::face_direction_map(
      boost::make_iterator_property_map(directions.begin(), get(boost::face_index, reference)))
      .face_direction_weight_map(Weight(10)));
  std::cout << "directions: " << deviation(without) << " degrees without, " << deviation(with) << " with" << std::endl;
  assert(r.status == Status::SUCCESS && s.status == Status::SUCCESS);
  assert(r.structure_after.number_of_patches == 6 && s.structure_after.number_of_patches == 6);
  assert(deviation(without) > 10 && deviation(with) < 0.7 * deviation(without));
}

// A target that cannot be reached does no harm: the result is as coarse as without it.
void test_unreachable_target()
{
  for(unsigned int seed = 0; seed < 2; ++seed)
  {
    const Mesh input = graph(twisted(flat(SM::refined(irregular(), 3)), 12, seed));
    Mesh free = input, strict = input;
    const Result f = QM::optimize_quad_structure(free, options());
    const Result t = QM::optimize_quad_structure(strict, options().target_number_of_patches(1));
    std::cout << "unreachable target: " << f.structure_before.number_of_patches << " patches, without it "
              << f.structure_after.number_of_patches << ", with it " << t.structure_after.number_of_patches
              << std::endl;
    assert(t.structure_after.number_of_patches <= f.structure_after.number_of_patches);
    assert(t.message.find("has not been reached") != std::string::npos);
  }
}

void test_targets_and_experiments()
{
  std::cout << "targets, collapse of all dual curves, merging" << std::endl;
  // the maximal collapse of a cube is a cube of six quads
  Mesh cube = SM::make_mesh(SM::cube(5));
  QM::optimize_quad_structure(cube, options().collapse_dual_curves(true).smoothing_iterations(0));
  assert(cube.number_of_faces() == 6);
  for(QM::Structure_method method : { QM::Structure_method::LAYOUT, QM::Structure_method::HELICES })
  {
    Mesh half = SM::make_mesh(SM::cube(6));
    QM::optimize_quad_structure(half, options(method).collapse_dual_curves(true).target_number_of_quads(120u));
    assert(half.number_of_faces() <= 120 && half.number_of_faces() > 60);
  }

  const Flat_mesh input = twisted(flat(SM::refined(irregular(), 4)), 12, 5);
  const QM::Quad_mesh_structure before = QM::internal::structure_of_quad_mesh(input);
  Mesh few = graph(input);
  const Result target =
    QM::optimize_quad_structure(few, options().target_number_of_patches(500).smoothing_iterations(0));
  assert(target.structure_after.number_of_patches <= 500 && target.structure_after.number_of_patches > 100);

  // merged irregular vertices: another set of valences, the same topology, the same sum of indices
  Mesh merged = graph(input), kept = graph(input);
  const Result m = QM::optimize_quad_structure(
    merged, options().merge_singularities(true).target_number_of_patches(20).target_number_of_quads(1));
  const Result k = QM::optimize_quad_structure(kept, options().target_number_of_patches(20).target_number_of_quads(1));
  assert(same_topology(k.structure_after, before));
  assert(m.structure_after.number_of_irregular_vertices < before.number_of_irregular_vertices);
  assert(m.structure_after.number_of_patches < k.structure_after.number_of_patches);
  for(const Result* r : { &m, &k })
  {
    assert(r->structure_after.euler_characteristic == 2 && r->structure_after.sum_of_indices == 8);
    assert(r->structure_after.number_of_quads < before.number_of_quads / 2);
  }
  assert(CGAL::is_valid_polygon_mesh(merged) && CGAL::is_quad_mesh(merged));
}

void test_other_graph_and_bad_input()
{
  std::cout << "another graph, stopping, bad input" << std::endl;
  typedef CGAL::Polyhedron_3<SM::Kernel> Polyhedron;
  Polyhedron p = SM::make_mesh<Polyhedron>(opened(SM::refined(irregular(), 4)));
  const QM::Quad_mesh_structure before = QM::quad_mesh_structure(p);
  QM::optimize_quad_structure(p, options().target_number_of_quads(200));
  assert(p.is_valid() && CGAL::is_quad_mesh(p) && same_topology(QM::quad_mesh_structure(p), before));
  assert(quad_mesh_checks::figures(p).consistent && quad_mesh_checks::figures(p).vertex_manifold);

  // stopping at any time leaves everything as it was
  struct Stop : QM::Default_visitor
  {
    int left;
    explicit Stop(int n) : left(n) {}
    bool go_further() { return --left >= 0; }
  };
  const Mesh input = graph(twisted(flat(SM::sphere(10)), 2, 3));
  for(int asked : { 0, 1, 5, 50 })
    for(QM::Structure_method method : { QM::Structure_method::LAYOUT, QM::Structure_method::HELICES })
    {
      Stop stop(asked);
      Mesh qm = input;
      const Result r = QM::optimize_quad_structure(qm, options(method).visitor(std::ref(stop)));
      if(r.status == Status::STOPPED)
        assert(qm.number_of_faces() == input.number_of_faces() &&
               std::equal(qm.points().begin(), qm.points().end(), input.points().begin()));
      else
        assert(stop.left >= 0);
    }

  // what has no irregular vertices: the helix of a cylinder goes over its border
  Mesh helix = SM::make_mesh(SM::rolled(12, 8, 1, false));
  assert(QM::optimize_quad_structure(helix).status == Status::SUCCESS && CGAL::is_valid_polygon_mesh(helix));
  Mesh rectangle = SM::make_mesh(SM::grid(8, 8));
  QM::optimize_quad_structure(rectangle);
  assert(QM::quad_mesh_structure(rectangle).number_of_patches == 1 && rectangle.number_of_faces() == 64);

  // what is not a quad mesh is not touched
  Mesh triangles = SM::triangulated(SM::cube(2)), empty;
  assert(QM::optimize_quad_structure(triangles).status == Status::NOT_A_QUAD_MESH);
  assert(QM::optimize_quad_structure(empty).status == Status::NOT_A_QUAD_MESH);
  Mesh cube = SM::make_mesh(SM::cube(2));
  assert(QM::optimize_quad_structure(cube, empty).status == Status::EMPTY_REFERENCE);
}

// A visitor that says stop ends the call soon, wherever it is, and the mesh is as it was; until then the progress moves
// on.
void test_stop()
{
  const Mesh input = graph(twisted(flat(SM::refined(irregular(), 8)), 16, 3));
  const Mesh reference = SM::triangulated(SM::refined(irregular(), 8));
  for(QM::Structure_method method : { QM::Structure_method::LAYOUT, QM::Structure_method::HELICES })
  {
    std::cout << "  " << input.number_of_faces() << " quads, method " << int(method) << std::endl;
    for(double seconds : { 0.3, 1.5, 4. })
    {
      visitor_checks::Stopwatch_visitor visitor(seconds);
      Mesh qm = input;
      const Result r = QM::optimize_quad_structure(
        qm, reference, CGAL::parameters::structure_method(method).visitor(std::ref(visitor)));
      visitor.report();
      assert(visitor.longest_gap() < visitor_checks::longest_gap);
      assert(visitor.longest_rest_of_progress() < visitor_checks::longest_gap);
      assert(visitor.has_stopped() == (r.status == Status::STOPPED));
      if(r.status == Status::STOPPED)
        assert(qm.number_of_faces() == input.number_of_faces() &&
               std::equal(qm.points().begin(), qm.points().end(), input.points().begin()));
    }
  }
}

// The search ends when its time is up, with a mesh of the same topology that is as good as the input at least, and says
// so.
void test_time_limit()
{
  const Mesh input = graph(twisted(flat(SM::refined(irregular(), 8)), 16, 3));
  const QM::Quad_mesh_structure before = QM::quad_mesh_structure(input);
  for(QM::Structure_method method : { QM::Structure_method::LAYOUT, QM::Structure_method::HELICES })
    for(double limit : { 0., 0.5, 2., 1e6 })
    {
      Mesh qm = input;
      const Result r = QM::optimize_quad_structure(qm, options(method).maximum_running_time(limit));
      const QM::Quad_mesh_structure after = QM::quad_mesh_structure(qm);
      std::cout << "  limit " << limit << " s: " << r.message << std::endl;
      assert(r.is_valid() && same_topology(after, before) && CGAL::is_valid_polygon_mesh(qm));
      assert(after.number_of_patches == r.structure_after.number_of_patches);
      assert(r.is_time_up == (r.message.find("time was up") != std::string::npos));
      assert(after.number_of_patches <= before.number_of_patches);
      if(limit == 0)
        assert(r.is_time_up && after.number_of_patches == before.number_of_patches);
      if(limit == 1e6)
        assert(!r.is_time_up && after.number_of_patches < before.number_of_patches);
    }
}

// Which shapes are accepted, by what the input is like.
void test_accepted_shapes()
{
  QM::Quad_mesh_smoothing_result input;
  input.folded_quads_before = 2;
  input.quality_before.number_of_inverted_quads = 1;
  input.quality_before.minimal_scaled_jacobian = 0.6;
  const auto result = [](double jacobian, std::size_t folded, std::size_t inverted)
  {
    QM::Quad_mesh_smoothing_result r;
    r.folded_quads_after = folded;
    r.quality_after.number_of_inverted_quads = inverted;
    r.quality_after.minimal_scaled_jacobian = jacobian;
    return r;
  };
  const QM::internal::Accepted_shape shape(input, false), coarse(input, true), any;
  assert(shape.accepts(result(0.31, 2, 1)) && !shape.accepts(result(0.29, 2, 1))); // half of 0.6
  assert(!shape.accepts(result(0.6, 3, 1)) && !shape.accepts(result(0.6, 2, 2)));
  assert(coarse.accepts(result(0.29, 2, 1)) && !coarse.accepts(result(0.6, 3, 1)));
  assert(any.accepts(result(-1, 9, 9)) && any.is_good(result(-1, 9, 9)));
  assert(shape.is_good(result(0.49, 0, 0)) && !shape.is_good(result(0.47, 0, 0))); // 0.8 of 0.6
  QM::Quad_mesh_smoothing_result stopped = result(0.6, 0, 0);
  stopped.status = Status::STOPPED;
  assert(!shape.accepts(stopped) && !any.accepts(stopped));
  input.quality_before.minimal_scaled_jacobian = 0.9;
  assert(QM::internal::Accepted_shape(input, false).is_good(result(0.51, 0, 0))); // enough for anyone
}

// The prices of layouts: what reaches a goal costs half, what misses it costs more the farther it is, and quads too
// many cost more than anything that they could be a price for.
void test_goals()
{
  typedef QM::internal::Layout_weights Weights;
  QM::Quad_mesh_structure structure;
  structure.number_of_helices = 50;
  structure.number_of_patches = 300;
  structure.number_of_irregular_vertices = 300;
  structure.number_of_quads = 1000;
  QM::Quad_mesh_quality quality;
  quality.mean_angle_deviation = 10;
  QM::internal::Layout_goals goals(structure, quality, 1000);
  const double patches = Weights::patches * 300, fewest = 1000 * (1 - Weights::loss);
  assert(std::abs(goals.price_of_structure(10, patches, fewest) - 1.5) < 1e-12);
  const double enough = fewest + 1; // whatever rounding does
  assert(goals.are_reached(10, patches, enough, 0) && !goals.are_reached(10.1, patches, enough, 0));
  assert(!goals.are_reached(10, patches + 1, enough, 0) && !goals.are_reached(10, patches, fewest - 1, 0));
  assert(!goals.are_reached(10, patches, enough, 100.1 * (Weights::growth * Weights::growth - 1)));
  assert(std::abs(goals.price_of_structure(20, 0, 1000) - (1 + Weights::helices_and_patches_above_goal)) < 1e-12);
  assert(goals.price_of_quads(1000) == 0);
  assert(std::abs(goals.price_of_quads(1100) - Weights::surplus / 10) < 1e-12);
  const double half_lost = goals.price_of_quads(500);
  assert(half_lost > goals.price_of_quads(fewest));
  goals.neglect_loss();
  assert(goals.price_of_quads(500) < half_lost && std::abs(goals.price_of_quads(1100) - Weights::surplus / 10) < 1e-12);
  assert(goals.price_of_growth(-3) == 0 && goals.price_of_growth(50) > goals.price_of_growth(20));
  // A few helices do no harm, however few the input has; irregular vertices limit the patches, however many it has.
  structure.number_of_helices = 0;
  structure.number_of_irregular_vertices = 10;
  const QM::internal::Layout_goals few(structure, quality, 1000);
  assert(few.tolerated_helices(0) == Weights::few_helices && few.tolerated_helices(7) == 7);
  const double of_vertices = Weights::patches_per_irregular_vertex * 10;
  assert(of_vertices < patches && few.are_reached(Weights::few_helices, of_vertices, 1000, 0));
  assert(!few.are_reached(Weights::few_helices + 1, of_vertices, 1000, 0) &&
         !few.are_reached(0, of_vertices + 1, 1000, 0));
  // A target far below the input is no goal.
  assert(QM::internal::Layout_goals(structure, quality, 100).price_of_quads(900) == 0);
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(
    argc, argv,
    { { "layouts", test_layouts },
      { "distortion", test_distortion },
      { "distortion_derivatives", test_distortion_derivatives },
      { "distortion_of_shifted_vertices", test_distortion_of_shifted_vertices },
      { "accepted_shapes", test_accepted_shapes },
      { "goals", test_goals },
      { "twisted_cubes_by_layout", [] { test_twisted_cubes(QM::Structure_method::LAYOUT); } },
      { "twisted_cubes_by_helices", [] { test_twisted_cubes(QM::Structure_method::HELICES); } },
      { "cubes_with_helices_by_layout", [] { test_cubes_with_helices(QM::Structure_method::LAYOUT); } },
      { "cubes_with_helices_by_helices", [] { test_cubes_with_helices(QM::Structure_method::HELICES); } },
      { "twisted_meshes", test_twisted_meshes },
      { "helices_become_few", test_helices_become_few },
      { "features", test_features },
      { "directions", test_directions },
      { "unreachable_target", test_unreachable_target },
      { "targets", test_targets_and_experiments },
      { "bad_input", test_other_graph_and_bad_input },
      { "stop", test_stop },
      { "time_limit", test_time_limit } });
}
