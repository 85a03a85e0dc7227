// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// What guides fields: salient directions and sizing, on surfaces whose curvatures are known.

#include "stage_checks.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Fields/internal/Representation_field.h>
#include <CGAL/Quad_meshing/Fields/salient_directions.h>
#include <CGAL/Quad_meshing/Fields/sizing.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Random.h>

#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

using namespace test_meshes;
namespace QM = CGAL::Quad_meshing;
namespace params = CGAL::parameters;
typedef Mesh::Face_index Face;
typedef Mesh::Vertex_index Vertex;
typedef std::optional<Vector_3> Direction;
typedef QM::Curvature_guide_status Status;

Point_3 center_of(const Mesh& tm, Face f)
{
  Vector_3 c(0, 0, 0);
  for(Vertex v : tm.vertices_around_face(tm.halfedge(f)))
    c = c + (tm.point(v) - CGAL::ORIGIN) / 3;
  return CGAL::ORIGIN + c;
}

void test_salient_directions()
{
  std::cout << "salient directions" << std::endl;
  {
    // A cylinder is parabolic all over; the axis is principal, however the mesh lies on it.
    Mesh tm = make_mesh(mapped(cylinder(60, 40, false),
                               [](const Point_3& p)
                               {
                                 const double t = std::atan2(p.y(), p.x()) + 0.4 * p.z();
                                 return Point_3(std::cos(t), std::sin(t), p.z());
                               }));
    auto direction = tm.add_property_map<Face, Direction>("f:d").first;
    const int n = QM::salient_directions(tm, 0.3, direction).number_of_faces;
    int found = 0;
    for(Face f : tm.faces())
    {
      if(!direction[f])
        continue;
      ++found;
      assert(std::abs(direction[f]->squared_length() - 1) < 1e-9);
      if(std::abs(center_of(tm, f).z() - 1) < 0.6) // disks that the border does not cut
        assert(std::abs(direction[f]->z()) > 0.99);
    }
    assert(found == n && n > 0.9 * tm.number_of_faces());
  }
  {
    // Nothing on a plane and on a sphere.
    for(const Soup& s : { grid(20, 20), icosphere(4) })
    {
      Mesh tm = make_mesh(s);
      auto direction = tm.add_property_map<Face, Direction>("f:d").first;
      assert(QM::salient_directions(tm, 0.3, direction).number_of_faces == 0);
    }
  }
  for(bool is_inside_out : { false, true })
  {
    // On a thin torus the tube bends much more than the ring does: directions along the ring, seen from either side.
    Soup ring = torus(120, 24, 1, 0.15);
    if(is_inside_out)
      for(auto& t : ring.triangles)
        std::swap(t[1], t[2]);
    Mesh tm = make_mesh(ring);
    auto direction = tm.add_property_map<Face, Direction>("f:d").first;
    const int n = QM::salient_directions(tm, 0.1, direction).number_of_faces;
    assert(n > 0.5 * tm.number_of_faces());
    for(Face f : tm.faces())
      if(direction[f])
      {
        const Point_3 c = center_of(tm, f);
        const Vector_3 along(-c.y(), c.x(), 0);
        const double a = std::abs(*direction[f] * along) / std::sqrt(along.squared_length());
        assert(a > 0.98);
      }
    // A stricter threshold keeps fewer of them.
    assert(QM::salient_directions(tm, 0.1, direction, params::minimum_anisotropy(0.9)).number_of_faces < n);
  }
  {
    Mesh tm = make_mesh(grid(2, 2));
    auto direction = tm.add_property_map<Face, Direction>("f:d", Direction(Vector_3(1, 0, 0))).first;
    for(double length : { 0., -1., std::nan("") })
      assert(QM::salient_directions(tm, length, direction).status == Status::INVALID_LENGTH);
    for(Face f : tm.faces())
      assert(direction[f]);
    assert(QM::salient_directions(tm, 0.5, direction).is_valid());
    for(Face f : tm.faces())
      assert(!direction[f]);
    Mesh empty;
    auto none = empty.add_property_map<Face, Direction>("f:d").first;
    assert(QM::salient_directions(empty, 1, none).is_valid());
  }
}

void test_sizing()
{
  std::cout << "sizing" << std::endl;
  {
    const Mesh tm = make_mesh(grid(7, 5, 3, 2));
    assert(std::abs(QM::edge_length_for_number_of_quads(tm, 600) - 0.1) < 1e-12);
  }
  {
    // A sphere needs the same length everywhere, that of a chord of height `tolerance`.
    Mesh tm = make_mesh(icosphere(4));
    auto sizing = tm.add_property_map<Face, double>("f:s").first;
    const double tolerance = 0.01, chord = 2 * std::sqrt(2 * tolerance - tolerance * tolerance);
    QM::curvature_sizing(tm, tolerance, 1e-3, 10, sizing);
    for(Face f : tm.faces())
      assert(std::abs(sizing[f] - chord) < 0.1 * chord);
    // Bounds are kept.
    QM::curvature_sizing(tm, tolerance, 0.5, 0.6, sizing);
    for(Face f : tm.faces())
      assert(sizing[f] == 0.5);
    QM::curvature_sizing(tm, tolerance, 0.01, 0.02, sizing);
    for(Face f : tm.faces())
      assert(sizing[f] == 0.02);
  }
  {
    // A cylinder next to a plane: the plane's length is bounded only by the distance from the bend.
    Mesh tm = make_mesh(mapped(grid(120, 20, 6, 1),
                               [](const Point_3& p)
                               {
                                 const double r = 0.5, x = p.x() - 3;
                                 return x < 0
                                          ? Point_3(x, p.y(), 0)
                                          : Point_3(r * std::sin((std::min)(x / r, pi)) - (std::max)(0., x - pi * r),
                                                    p.y(), r * (1 - std::cos((std::min)(x / r, pi))));
                               }));
    auto sizing = tm.add_property_map<Face, double>("f:s").first;
    QM::curvature_sizing(tm, 0.005, 0.01, 2, sizing, params::sizing_gradation(0.2));
    double shortest = 10, longest = 0;
    for(Face f : tm.faces())
    {
      shortest = (std::min)(shortest, sizing[f]);
      longest = (std::max)(longest, sizing[f]);
      for(Face g : tm.faces_around_face(tm.halfedge(f)))
        if(g != Mesh::null_face())
          assert(sizing[g] <=
                 sizing[f] + 0.2 * std::sqrt(CGAL::squared_distance(center_of(tm, f), center_of(tm, g))) + 1e-12);
    }
    const double chord = 2 * std::sqrt(2 * 0.5 * 0.005 - 0.005 * 0.005);
    assert(std::abs(shortest - chord) < 0.2 * chord && longest > 2.5 * chord);
  }
}

void test_bad_lengths()
{
  Mesh tm = make_mesh(icosphere(2));
  auto sizing = tm.add_property_map<Face, double>("f:s", 7.).first;
  assert(QM::curvature_sizing(tm, 0, 0.1, 0.2, sizing).status == Status::INVALID_LENGTH);
  assert(QM::curvature_sizing(tm, 0.1, 0, 0.2, sizing).status == Status::INVALID_LENGTH);
  assert(QM::curvature_sizing(tm, 0.1, 0.3, 0.2, sizing).status == Status::INVALID_LENGTH);
  assert(QM::curvature_sizing(tm, 0.1, std::nan(""), 0.2, sizing).status == Status::INVALID_LENGTH);
  for(Face f : tm.faces())
    assert(sizing[f] == 7);
  for(int s = 0; s <= static_cast<int>(Status::NOT_A_TRIANGLE_MESH); ++s)
    assert(*status_name(static_cast<Status>(s)) != 0);
}

void test_stops()
{
  Mesh tm = make_mesh(torus(60, 24, 1, 0.15));
  auto direction = tm.add_property_map<Face, Direction>("f:d").first;
  auto sizing = tm.add_property_map<Face, double>("f:s").first;
  stage_checks::check_stops(
    [&](stage_checks::Counting_visitor& visitor)
    {
      for(Face f : tm.faces())
        direction[f] = Vector_3(0, 0, 7);
      const bool is_done = QM::salient_directions(tm, 0.2, direction, params::visitor(std::ref(visitor))).is_valid();
      for(Face f : tm.faces())
        assert(is_done || (direction[f] && *direction[f] == Vector_3(0, 0, 7)));
      return is_done;
    });
  stage_checks::check_stops(
    [&](stage_checks::Counting_visitor& visitor)
    {
      for(Face f : tm.faces())
        sizing[f] = 7;
      const bool is_done =
        QM::curvature_sizing(tm, 0.01, 0.01, 1, sizing, params::visitor(std::ref(visitor))).is_valid();
      for(Face f : tm.faces())
        assert((sizing[f] == 7) != is_done);
      return is_done;
    });
}

// How far directions are on the mean from those that are known, in radians, weighted; 1 if nothing has a weight.
template <typename Known>
double mean_deviation(const Mesh& tm, const Mesh::Property_map<Face, Direction>& direction,
                      const Mesh::Property_map<Face, double>& weight, const Known& known)
{
  double sum = 0, weights = 0;
  for(Face f : tm.faces())
    if(weight[f] > 0)
    {
      assert(direction[f] && std::abs(direction[f]->squared_length() - 1) < 1e-9);
      const Vector_3 k = known(center_of(tm, f));
      sum += weight[f] * std::acos((std::min)(1., std::abs(*direction[f] * k) / std::sqrt(k.squared_length())));
      weights += weight[f];
    }
  return weights > 0 ? sum / weights : 1;
}

double area_in_quads(const Mesh& tm, double length)
{
  return CGAL::Polygon_mesh_processing::area(tm) / (length * length);
}

// The principal directions of a cylinder, a cone and a torus, with noise and however fine the triangles are; none on
// planes and spheres.
void test_curvature_directions()
{
  const double degree = CGAL_PI / 180;
  auto directions_of = [](Mesh& tm, double length, double& weights)
  {
    auto direction = tm.add_property_map<Face, Direction>("f:d").first;
    auto weight = tm.add_property_map<Face, double>("f:w", 0.).first;
    const QM::Curvature_guide_result r = QM::curvature_directions(tm, length, direction, weight);
    assert(r.is_valid());
    weights = 0;
    int found = 0;
    for(Face f : tm.faces())
    {
      weights += weight[f];
      found += weight[f] > 0;
      assert(weight[f] >= 0 && (weight[f] > 0) == static_cast<bool>(direction[f]));
    }
    assert(found == r.number_of_faces);
    return std::make_pair(direction, weight);
  };
  auto axis = [](const Point_3&) { return Vector_3(0, 0, 1); };
  double weights = 0;
  for(int n : { 40, 120 })
    for(double noise : { 0., 0.3 }) // in percent of the diagonal
    {
      Mesh tm = make_mesh(perturbed(cylinder(n, n, false, 0.5, 2), noise / 100 * 2.4));
      const auto maps = directions_of(tm, 0.2, weights);
      const double deviation = mean_deviation(tm, maps.first, maps.second, axis) / degree;
      std::cout << "cylinder of " << tm.number_of_faces() << " triangles, noise " << noise << ": " << deviation
                << " degrees, weights " << weights / area_in_quads(tm, 0.2) << std::endl;
      assert(deviation < (noise == 0 ? 1 : 6) && weights > (noise == 0 ? 0.7 : 0.3) * area_in_quads(tm, 0.2));
    }
  {
    Mesh tm = make_mesh(torus(160, 48, 1, 0.25));
    const auto maps = directions_of(tm, 0.15, weights);
    assert(mean_deviation(tm, maps.first, maps.second, [](const Point_3& p) { return Vector_3(-p.y(), p.x(), 0); }) <
           2 * degree);
    assert(weights > 0.3 * area_in_quads(tm, 0.15));
  }
  {
    Mesh tm = make_mesh(cone(80, 30, 1, 2));
    const auto maps = directions_of(tm, 0.2, weights);
    // the apex is where all directions meet
    const double deviation =
      mean_deviation(tm, maps.first, maps.second, [&](const Point_3& p) { return Vector_3(p.x(), p.y(), p.z() - 2); });
    std::cout << "cone: " << deviation / degree << " degrees" << std::endl;
    assert(deviation < 8 * degree && weights > 0.4 * area_in_quads(tm, 0.2));
  }
  for(const Soup& flat : { grid(30, 30), icosphere(5) })
  {
    Mesh tm = make_mesh(flat);
    directions_of(tm, 0.15, weights);
    assert(weights < 1e-3 * area_in_quads(tm, 0.15));
  }
  {
    // An edge of a prism is a crease: with it as a feature, nothing is bent.
    Mesh tm = make_mesh(cube(12));
    auto sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:s", false).first;
    CGAL::Polygon_mesh_processing::detect_sharp_edges(tm, 40, sharp);
    auto direction = tm.add_property_map<Face, Direction>("f:d").first;
    auto weight = tm.add_property_map<Face, double>("f:w", 0.).first;
    assert(QM::curvature_directions(tm, 0.15, direction, weight).number_of_faces > 0);
    assert(
      QM::curvature_directions(tm, 0.15, direction, weight, params::edge_is_constrained_map(sharp)).number_of_faces ==
      0);
    assert(QM::curvature_directions(tm, -1, direction, weight).status == Status::INVALID_LENGTH);
  }
  Mesh tm = make_mesh(torus(60, 24, 1, 0.15));
  auto direction = tm.add_property_map<Face, Direction>("f:d").first;
  auto weight = tm.add_property_map<Face, double>("f:w", 7.).first;
  stage_checks::check_stops(
    [&](stage_checks::Counting_visitor& visitor)
    {
      for(Face f : tm.faces())
        weight[f] = 7;
      const bool is_done =
        QM::curvature_directions(tm, 0.2, direction, weight, params::visitor(std::ref(visitor))).is_valid();
      assert(is_done || weight[*tm.faces().begin()] == 7);
      return is_done;
    });
}

// Soft directions in a field: with no weight they do nothing, with a large one what hard ones do; in between, no small
// change of an angle lowers the energy.
void test_soft_directions()
{
  Mesh tm = make_mesh(perturbed(icosphere(3), 0.02, 1));
  auto angle = tm.add_property_map<Face, double>("f:angle", 0.).first;
  auto jump = tm.add_property_map<Mesh::Edge_index, int>("e:jump", 0).first;
  auto index = tm.add_property_map<Vertex, int>("v:index", 0).first;
  auto direction = tm.add_property_map<Face, Direction>("f:d").first;
  auto weight = tm.add_property_map<Face, double>("f:w", 0.).first;
  for(Face f : tm.faces())
    if(f % 7 == 0)
    {
      const Point_3 c = center_of(tm, f);
      direction[f] = Vector_3(-c.y(), c.x(), 0);
    }
  auto energy = [&](double w, bool hard)
  {
    for(Face f : tm.faces())
      weight[f] = w;
    const auto method = params::cross_field_method(QM::Cross_field_method::REPRESENTATION);
    const QM::Cross_field_result r =
      hard ? QM::smooth_cross_field(tm, angle, jump, index, method.face_direction_map(direction))
           : QM::smooth_cross_field(tm, angle, jump, index,
                                    method.face_direction_map(direction).face_direction_weight_map(weight));
    assert(r.is_valid());
    return r.energy;
  };
  const double free =
    QM::smooth_cross_field(tm, angle, jump, index, params::cross_field_method(QM::Cross_field_method::REPRESENTATION))
      .energy;
  const double hard = energy(0, true);
  assert(std::abs(energy(0, false) - free) < 1e-9 * free);
  assert(std::abs(energy(std::numeric_limits<double>::infinity(), false) - hard) < 1e-9 * hard);
  const double stiff = energy(1e4, false), soft = energy(0.1, false);
  std::cout << "free " << free << ", soft " << soft << ", stiff " << stiff << ", hard " << hard << std::endl;
  assert(std::abs(stiff - hard) < 1e-2 * hard && free < soft && soft < stiff);

  // The gradient by the angles vanishes.
  namespace I = CGAL::Quad_meshing::internal;
  const I::Indexed_triangle_mesh m = I::make_indexed_triangle_mesh(tm, params::default_values());
  I::Field_problem problem(m);
  problem.set_surface_weights();
  for(Face f : tm.faces())
    I::constrain_face(problem, static_cast<int>(f), direction[f], 0.1);
  I::Cross_field field;
  for(Face f : tm.faces())
    field.angle.push_back(angle[f]);
  for(Mesh::Edge_index e : tm.edges())
    field.period_jump.push_back(jump[e]);
  assert(std::abs(problem.energy(field) - soft) < 1e-9 * soft);
  const double step = 1e-4;
  for(int f = 0; f < m.number_of_faces(); f += 3)
  {
    I::Cross_field up = field, down = field;
    up.angle[f] += step;
    down.angle[f] -= step;
    assert(std::abs(problem.energy(up) - problem.energy(down)) / (2 * step) < 1e-6);
    assert(problem.energy(up) > soft);
  }
}

// The representation field that a search starts from is the least one of its quadratic energy, soft directions with
// their weights: exactly where every face is a cluster, and nearly after the smoothing where clusters are larger.
void test_soft_start()
{
  namespace I = CGAL::Quad_meshing::internal;
  typedef std::complex<double> Complex;
  const Mesh tm = make_mesh(perturbed(icosphere(2), 0.02, 1));
  const I::Indexed_triangle_mesh m = I::make_indexed_triangle_mesh(tm, params::default_values());
  const int n = m.number_of_faces();
  I::Field_problem problem(m);
  CGAL::Random random(4);
  for(int f = 0; f < n; ++f)
  {
    problem.soft_angle.push_back(random.get_double(-0.8, 0.8));
    problem.soft_weight.push_back(f % 3 == 0 ? 0.2 : 0.5);
  }
  problem.find_components();
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Zero(n, n);
  Eigen::VectorXcd rhs(n);
  for(int f = 0; f < n; ++f)
  {
    matrix(f, f) = problem.soft_weight[f];
    rhs[f] = problem.soft_weight[f] * std::polar(1., 4 * problem.soft_angle[f]);
  }
  for(int e = 0; e < m.number_of_edges(); ++e)
  {
    // |turn z_f - z_g|^2
    const int f = problem.first_face(e), g = problem.second_face(e);
    const Complex turn = std::polar(1., 4 * problem.frames.kappa(e));
    matrix(f, f) += 1.;
    matrix(g, g) += 1.;
    matrix(f, g) -= std::conj(turn);
    matrix(g, f) -= turn;
  }
  const Eigen::VectorXcd z = matrix.partialPivLu().solve(rhs);
  stage_checks::Silent_progress silent;
  for(int clusters : { n, n / 3 })
  {
    std::vector<double> angle;
    assert(I::Representation_field(problem, clusters, silent.progress)(angle));
    double largest = 0;
    for(int f = 0; f < n; ++f)
      largest = (std::max)(largest, std::abs(std::polar(std::abs(z[f]), 4 * angle[f]) - z[f]));
    std::cout << "  " << clusters << " clusters: " << largest << std::endl;
    assert(largest < (clusters == n ? 1e-6 : 1e-2));
  }
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "salient_directions", test_salient_directions },
                     { "curvature_directions", test_curvature_directions },
                     { "soft_directions", test_soft_directions },
                     { "soft_start", test_soft_start },
                     { "sizing", test_sizing },
                     { "bad_lengths", test_bad_lengths },
                     { "stops", test_stops } });
}
