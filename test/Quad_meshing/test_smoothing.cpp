// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The energies of the smoothers against finite differences, and how a smoothing is stopped.

#include "structure_meshes.h"
#include "test_cases.h"
#include "visitor_checks.h"

#include <CGAL/Quad_meshing/Smoothing/internal/Corner_energy.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Rectangle_energy.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Side_turn_energy.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>

#include <CGAL/Random.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace SM = structure_meshes;

typedef SM::Mesh Mesh;
typedef QM::internal::Corner_energy Corner_energy;
typedef QM::internal::Corner_energy_model Corner_energy_model;
typedef QM::internal::Rectangle_energy Rectangle_energy;
typedef Corner_energy::Point_3 Point_3;
typedef Corner_energy::Vector_3 Vector_3;
typedef QM::Quad_mesh_status Status;

namespace {

// Step of central differences: the error of a first difference is about its square, plus 1e-16 over it.
constexpr double step = 1e-5;

bool agree(double a, double b, double scale, double tolerance = 1e-6) { return std::abs(a - b) <= tolerance * scale; }

// The quad p, p1, p2, p3, its normal, and the energy of the three corners that move with p.
struct Moving_quad
{
  std::array<Point_3, 4> p;
  Vector_3 normal, u, w;
  double aim, epsilon;

  Corner_energy_model at(double x, double y) const
  {
    Corner_energy_model model(u, w);
    for(const Corner_energy& e : Corner_energy::around(p[0] + x * u + y * w, p[1], p[2], p[3], normal))
      model.add(e, aim, epsilon);
    return model;
  }

  // What the documentation says, from the positions alone.
  double formula(double x, double y) const
  {
    const std::array<Point_3, 4> q = { { p[0] + x * u + y * w, p[1], p[2], p[3] } };
    double sum = 0;
    for(int k : { 0, 1, 3 })
    {
      const Vector_3 a = q[(k + 1) % 4] - q[k], b = q[(k + 3) % 4] - q[k];
      const double d = cross_product(a, b) * normal;
      const double chi = (d + std::sqrt(d * d + epsilon * epsilon)) / 2;
      sum += (a * a + b * b + Corner_energy::area_weight * (aim + d * d / aim)) / (2 * chi);
    }
    return sum;
  }
};

Moving_quad random_quad(CGAL::Random& random, bool folded)
{
  auto about = [&](double x, double y)
  { return Point_3(x + random.get_double(-0.2, 0.2), y + random.get_double(-0.2, 0.2), random.get_double(-0.2, 0.2)); };
  Moving_quad q;
  q.p = { { folded ? about(1.2, 1.1) : about(0, 0), about(1, 0), about(1, 1), about(0, 1) } };
  const double t = random.get_double(0, 3);
  q.normal = Vector_3(0, 0, 1);
  q.u = Vector_3(std::cos(t), std::sin(t), 0);
  q.w = Vector_3(-std::sin(t), std::cos(t), 0);
  q.aim = random.get_double(0.5, 2);
  q.epsilon = folded ? random.get_double(0.05, 0.5) : 0;
  return q;
}

void test_corner_energy()
{
  CGAL::Random random(1);
  int folded_corners = 0;
  for(int i = 0; i < 200; ++i)
  {
    const Moving_quad q = random_quad(random, i % 2 == 1);
    const Corner_energy_model model = q.at(0, 0);
    const std::array<double, 2> g = model.gradient();
    const std::array<double, 3> h = model.hessian();
    double largest_g = 1, largest_h = 1;
    for(double x : g)
      largest_g = (std::max)(largest_g, std::abs(x));
    for(double x : h)
      largest_h = (std::max)(largest_h, std::abs(x));

    assert(agree(model.value(), q.formula(0, 0), model.value(), 1e-12));
    double sum = 0;
    for(const Corner_energy& e : Corner_energy::around(q.p[0], q.p[1], q.p[2], q.p[3], q.normal))
    {
      sum += e.value(q.aim, q.epsilon);
      folded_corners += e.area < 0;
    }
    assert(agree(sum, model.value(), model.value(), 1e-12));

    assert(agree(g[0], (q.formula(step, 0) - q.formula(-step, 0)) / (2 * step), largest_h));
    assert(agree(g[1], (q.formula(0, step) - q.formula(0, -step)) / (2 * step), largest_h));
    // third derivatives grow fast where a corner is small
    const double scale = largest_h * (1 + largest_h) + largest_g;
    for(int k = 0; k < 2; ++k)
    {
      assert(agree(h[k], (q.at(step, 0).gradient()[k] - q.at(-step, 0).gradient()[k]) / (2 * step), scale));
      assert(agree(h[k + 1], (q.at(0, step).gradient()[k] - q.at(0, -step).gradient()[k]) / (2 * step), scale));
    }

    // the steps go downhill, and are those of Newton's method where the energy is convex
    const Vector_3 s = model.step_in_plane(), along = model.step_along_u();
    assert(g[0] * (s * q.u) + g[1] * (s * q.w) <= 0 && g[0] * (along * q.u) <= 0);
    const double determinant = h[0] * h[2] - h[1] * h[1];
    if(h[0] > 0 && determinant > 0.01 * largest_h * largest_h)
    {
      assert(agree(s * q.u, -(h[2] * g[0] - h[1] * g[1]) / determinant, largest_g));
      assert(agree(s * q.w, -(h[0] * g[1] - h[1] * g[0]) / determinant, largest_g));
    }
    assert(agree(along * q.u, -g[0] / std::abs(h[0]), std::abs(g[0] / h[0])));
  }
  std::cout << "  " << folded_corners << " folded corners" << std::endl;
  assert(folded_corners > 50);
}

// A square corner of the right size costs least.
void test_least_energy()
{
  const Vector_3 n(0, 0, 1);
  Moving_quad square{ { { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0) } },
                      n,
                      Vector_3(1, 0, 0),
                      Vector_3(0, 1, 0),
                      1,
                      0 };
  assert(std::abs(square.at(0, 0).value() - 3 * (1 + Corner_energy::area_weight)) < 1e-14);
  const double least = Rectangle_energy::value(Vector_3(1, 0, 0), Vector_3(0, 1, 0), n, 1);
  assert(std::abs(least - Rectangle_energy::least) < 1e-14);
  CGAL::Random random(2);
  for(int i = 0; i < 100; ++i)
  {
    const double x = random.get_double(-0.5, 0.5), y = random.get_double(-0.5, 0.5);
    assert(square.at(x, y).value() > square.at(0, 0).value());
    assert(Rectangle_energy::value(Vector_3(1 + x, y, 0), Vector_3(0, 1, 0), n, 1) > least);
    // the scale is that of the area aimed at
    assert(agree(Rectangle_energy::value(Vector_3(3 + 3 * x, 3 * y, 0), Vector_3(0, 3, 0), n, 9),
                 Rectangle_energy::value(Vector_3(1 + x, y, 0), Vector_3(0, 1, 0), n, 1), least, 1e-12));
  }
}

// The gradient, and the matrix: the second derivatives by s, theta and t alone, in the directions of their gradients.
void test_rectangle_energy()
{
  typedef Rectangle_energy::Sides Sides;
  const double l = Rectangle_energy::squareness, area_weight = Rectangle_energy::area_weight;
  auto value = [](const Sides& x, double aim)
  { return Rectangle_energy::value(Vector_3(x[0], x[1], 0), Vector_3(x[2], x[3], 0), Vector_3(0, 0, 1), aim); };
  // s, theta, t of two sides, and the energy of them
  auto coordinates = [](const Sides& x, double aim)
  {
    const double dot = x[0] * x[2] + x[1] * x[3], cross = x[0] * x[3] - x[1] * x[2];
    return Eigen::Vector3d(std::log(std::hypot(x[0], x[1]) / std::hypot(x[2], x[3])), std::atan2(cross, dot),
                           std::log(cross / aim));
  };
  auto energy = [&](const Eigen::Vector3d& c)
  { return (l * std::cosh(c[0]) + 1 - l) / std::sin(c[1]) + area_weight * std::cosh(c[2]); };
  constexpr double long_step = 1e-4; // of second differences

  CGAL::Random random(3);
  for(int i = 0; i < 200; ++i)
  {
    Sides x;
    x << random.get_double(0.5, 2), random.get_double(-0.4, 0.4), random.get_double(-0.4, 0.4),
      random.get_double(0.5, 2);
    const double aim = random.get_double(0.5, 2);
    Sides gradient;
    Eigen::Matrix4d matrix;
    Rectangle_energy::derivatives(x, aim, gradient, matrix);
    const Eigen::Vector3d c = coordinates(x, aim);
    const double scale = 1 + matrix.lpNorm<Eigen::Infinity>();
    assert(agree(value(x, aim), energy(c), 1, 1e-12));

    Eigen::Matrix<double, 3, 4> slopes;
    for(int k = 0; k < 4; ++k)
    {
      const Sides e = step * Sides::Unit(k);
      assert(agree(gradient[k], (value(x + e, aim) - value(x - e, aim)) / (2 * step), scale));
      slopes.col(k) = (coordinates(x + e, aim) - coordinates(x - e, aim)) / (2 * step);
    }
    Eigen::Matrix3d second;
    for(int r = 0; r < 3; ++r)
      for(int k = 0; k < 3; ++k)
      {
        const Eigen::Vector3d a = long_step * Eigen::Vector3d::Unit(r), b = long_step * Eigen::Vector3d::Unit(k);
        second(r, k) =
          (energy(c + a + b) - energy(c + a - b) - energy(c - a + b) + energy(c - a - b)) / (4 * long_step * long_step);
      }
    const Eigen::Matrix4d expected = slopes.transpose() * second * slopes;
    assert((matrix - expected).lpNorm<Eigen::Infinity>() < 1e-5 * scale);
    assert((matrix - matrix.transpose()).lpNorm<Eigen::Infinity>() < 1e-12 * scale);
    // positive semidefinite, whatever the direction
    for(int k = 0; k < 10; ++k)
    {
      Sides d;
      d << random.get_double(-1, 1), random.get_double(-1, 1), random.get_double(-1, 1), random.get_double(-1, 1);
      assert(d.dot(matrix * d) > -1e-12 * scale);
    }
  }
}

// The energy of a side: what the documentation says, and its derivatives against finite differences.
void test_side_turn_energy()
{
  typedef QM::internal::Side_turn_energy Side_turn_energy;
  const double quarter_turn = std::acos(-1.) / 2;
  auto at = [](double psi, double length) { return Side_turn_energy(length * std::cos(psi), length * std::sin(psi)); };
  CGAL::Random random(11);
  for(int i = 0; i < 200; ++i)
  {
    const double psi = random.get_double(-3, 3), length = random.get_double(0.1, 10);
    const double value = at(psi, length).value();
    assert(agree(value, (1 - std::cos(4 * psi)) / 16, 1, 1e-12));
    assert(agree(value, at(psi + quarter_turn, 1).value(), 1, 1e-12));
    const double h = 1e-4, before = at(psi - h, length).value(), after = at(psi + h, length).value();
    assert(agree(at(psi, length).slope(), (after - before) / (2 * h), 1));
    assert(agree(at(psi, length).curvature(), (std::max)((after - 2 * value + before) / (h * h), 0.), 1));
  }
  // near zero, half the square of the angle
  assert(agree(at(0.01, 1).value(), 0.00005, 1, 1e-8));
  assert(Side_turn_energy(0, 0).value() == 0);

  // A vertex that moves: the gradient along both directions.
  for(int i = 0; i < 200; ++i)
  {
    auto some = [&] { return random.get_double(-1, 1); };
    const Vector_3 u(1, 0, 0), w(0, 1, 0), along(std::cos(i), std::sin(i), 0), across(-std::sin(i), std::cos(i), 0);
    const Point_3 other(some(), some(), some()), p(some() + 2, some(), some());
    auto model = [&](double x, double y)
    {
      Corner_energy_model m(u, w);
      m.add_side(other - (p + x * u + y * w), along, across, 3);
      return m;
    };
    const std::array<double, 2> gradient = model(0, 0).gradient();
    assert(agree(gradient[0], (model(step, 0).value() - model(-step, 0).value()) / (2 * step), 3));
    assert(agree(gradient[1], (model(0, step).value() - model(0, -step).value()) / (2 * step), 3));
  }
}

typedef std::optional<SM::Kernel::Vector_3> Optional_direction;

// A plate of n x n quads, and a cross field on it that is turned by up to 15 degrees in the middle.
struct Turned_plate
{
  const int n = 16;
  const double pi = std::acos(-1.);
  Mesh quads, triangles;
  std::vector<Optional_direction> direction; // per triangle

  Turned_plate() : quads(SM::make_mesh(SM::grid(n, n)))
  {
    SM::Quad_soup fine = SM::grid(3 * n, 3 * n);
    for(SM::Point_3& p : fine.points)
      p = SM::Point_3(p.x() / 3, p.y() / 3, 0);
    triangles = SM::triangulated(fine);
    for(Mesh::Face_index f : triangles.faces())
    {
      const Mesh::Halfedge_index h = triangles.halfedge(f);
      const double a = angle(CGAL::centroid(triangles.point(triangles.source(h)), triangles.point(triangles.target(h)),
                                            triangles.point(triangles.target(triangles.next(h)))));
      // one of the two in turn: they stand for each other
      const bool is_second = std::size_t(f) % 2 == 0;
      direction.push_back(is_second ? SM::Kernel::Vector_3(-std::sin(a), std::cos(a), 0)
                                    : SM::Kernel::Vector_3(std::cos(a), std::sin(a), 0));
    }
  }

  double angle(const SM::Point_3& p) const { return pi / 12 * std::sin(pi * p.x() / n) * std::sin(pi * p.y() / n); }

  // Of the edges from the field, on average, in degrees.
  double deviation(const Mesh& qm) const
  {
    double sum = 0;
    for(Mesh::Edge_index e : qm.edges())
    {
      const SM::Point_3 &p = qm.point(qm.vertex(e, 0)), &q = qm.point(qm.vertex(e, 1));
      const double turn = std::atan2(q.y() - p.y(), q.x() - p.x()) - angle(CGAL::midpoint(p, q));
      sum += std::abs(turn - pi / 2 * std::round(turn / (pi / 2))) * 180 / pi;
    }
    return sum / qm.number_of_edges();
  }
};

// Quads turn to the directions that are wanted, up to quarter turns, the more these count; not at all with weight 0.
void test_directions()
{
  const Turned_plate plate;
  const auto direction =
    boost::make_iterator_property_map(plate.direction.begin(), get(boost::face_index, plate.triangles));
  typedef CGAL::Constant_property_map<Mesh::Face_index, double> Weight;
  for(bool globally : { false, true })
  {
    const auto np = CGAL::parameters::smooth_globally(globally).smoothing_iterations(60u);
    auto smoothed = [&](double weight)
    {
      Mesh qm = plate.quads;
      const auto r =
        QM::smooth_quad_mesh(qm, plate.triangles, np,
                             CGAL::parameters::face_direction_map(direction).face_direction_weight_map(Weight(weight)));
      assert(r.is_valid() && r.folded_quads_after == 0);
      return qm;
    };
    Mesh without = plate.quads, by_default = plate.quads;
    QM::smooth_quad_mesh(without, plate.triangles, np);
    QM::smooth_quad_mesh(by_default, plate.triangles, np, CGAL::parameters::face_direction_map(direction));
    const Mesh ignored = smoothed(0), with = smoothed(1), strictly = smoothed(10);
    std::cout << "  " << (globally ? "all at once: " : "one by one: ") << plate.deviation(without)
              << " degrees from the field without it, " << plate.deviation(with) << " with weight 1, "
              << plate.deviation(strictly) << " with weight 10" << std::endl;
    assert(plate.deviation(without) > 5);
    assert(plate.deviation(with) < 0.95 * plate.deviation(without));
    assert(plate.deviation(strictly) < 0.5 * plate.deviation(without));
    assert(std::equal(without.points().begin(), without.points().end(), ignored.points().begin()));
    assert(std::equal(with.points().begin(), with.points().end(), by_default.points().begin()));
  }
}

SM::Quad_soup shaken(SM::Quad_soup soup, double amount, unsigned int seed)
{
  CGAL::Random random(seed);
  auto some = [&] { return random.get_double(-amount, amount); };
  for(SM::Point_3& p : soup.points)
    p = p + SM::Kernel::Vector_3(some(), some(), some());
  return soup;
}

// A quad in a triangle, one of whose vertices lies on the middle of a side, has no room there: the result names it, if
// the vertex cannot move.
void test_flat_corners()
{
  SM::Quad_soup soup;
  soup.points = { SM::Point_3(0, 0, 0), SM::Point_3(1, 0, 0), SM::Point_3(2, 0, 0), SM::Point_3(1, 1, 0) };
  soup.quads = { { { 0, 1, 2, 3 } } };
  for(bool is_fixed : { false, true })
  {
    Mesh qm = SM::make_mesh(soup);
    const Mesh reference = SM::triangulated(soup);
    const auto r = QM::smooth_quad_mesh(qm, reference,
                                        CGAL::parameters::smoothing_iterations(5u).vertex_is_constrained_map(
                                          CGAL::Constant_property_map<Mesh::Vertex_index, bool>(is_fixed)));
    std::cout << "  " << r.message << std::endl;
    assert(r.status == Status::SUCCESS);
    if(!is_fixed)
      continue;
    assert(r.folded_quads_after == 1 && r.flat_corners == std::vector<std::size_t>(1, 1));
    assert(r.message.find("at vertex 1") != std::string::npos);
  }
  Mesh sphere = SM::make_mesh(shaken(SM::sphere(12), 0.02, 4));
  assert(QM::smooth_quad_mesh(sphere).flat_corners.empty());
}

// A visitor that says stop ends the call soon, wherever it is, and the mesh is as it was; until then the progress moves
// on.
void test_stop()
{
  const SM::Quad_soup soup = SM::sphere(80);
  const Mesh reference = SM::triangulated(soup);
  // some folded quads, too
  const Mesh input = SM::make_mesh(shaken(soup, 0.012, 1));
  std::cout << "  " << input.number_of_faces() << " quads" << std::endl;
  for(bool globally : { false, true })
  {
    int stopped = 0;
    for(double seconds : { 0.02, 0.2, 0.5, 1., 1e6 })
    {
      visitor_checks::Stopwatch_visitor visitor(seconds);
      Mesh qm = input;
      const QM::Quad_mesh_smoothing_result r =
        QM::smooth_quad_mesh(qm, reference, CGAL::parameters::smooth_globally(globally).visitor(std::ref(visitor)));
      visitor.report();
      assert(visitor.longest_gap() < visitor_checks::longest_gap && visitor.is_monotone());
      assert(visitor.longest_rest_of_progress() < visitor_checks::longest_gap);
      assert(visitor.has_stopped() == (r.status == Status::STOPPED) && r.is_valid() == (r.status == Status::SUCCESS));
      const bool is_as_it_was = std::equal(qm.points().begin(), qm.points().end(), input.points().begin());
      assert(is_as_it_was == (r.status == Status::STOPPED));
      stopped += r.status == Status::STOPPED;
      if(r.status == Status::STOPPED)
        assert(r.message == "The smoothing was stopped; the mesh is as it was.");
    }
    assert(stopped >= 2 && stopped < 5);
  }
}

// No step, no change but that the vertices are put onto the reference; the default is 20 steps at most.
void test_iterations()
{
  const SM::Quad_soup soup = SM::sphere(12);
  const Mesh reference = SM::triangulated(SM::sphere(24));
  const Mesh input = SM::make_mesh(shaken(soup, 0.02, 2));
  for(bool globally : { false, true })
    for(unsigned int steps : { 0u, 1u, 3u, 20u })
    {
      Mesh qm = input;
      const auto r =
        QM::smooth_quad_mesh(qm, reference, CGAL::parameters::smoothing_iterations(steps).smooth_globally(globally));
      assert(r.iterations <= steps && (steps > 1 || r.iterations == steps));
      Mesh by_default = input;
      if(steps == 20)
      {
        QM::smooth_quad_mesh(by_default, reference, CGAL::parameters::smooth_globally(globally));
        assert(std::equal(qm.points().begin(), qm.points().end(), by_default.points().begin()));
      }
    }
}

void test_status_names()
{
  assert(status_name(Status::SUCCESS) == std::string("success"));
  assert(status_name(Status::NOT_A_QUAD_MESH) == std::string("not_a_quad_mesh"));
  assert(status_name(Status::EMPTY_REFERENCE) == std::string("empty_reference"));
  assert(status_name(Status::STOPPED) == std::string("stopped"));
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "corner_energy", test_corner_energy },
                     { "least_energy", test_least_energy },
                     { "rectangle_energy", test_rectangle_energy },
                     { "side_turn_energy", test_side_turn_energy },
                     { "directions", test_directions },
                     { "flat_corners", test_flat_corners },
                     { "stop", test_stop },
                     { "iterations", test_iterations },
                     { "status_names", test_status_names } });
}
