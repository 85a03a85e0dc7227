// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// What guides fields: salient directions and sizing, on surfaces whose curvatures are known.

#include "stage_checks.h"
#include "test_meshes.h"
#include "test_cases.h"

#include <CGAL/Quad_meshing/Fields/salient_directions.h>
#include <CGAL/Quad_meshing/Fields/sizing.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>

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
    Mesh tm = make_mesh(mapped(cylinder(60, 40, false), [](const Point_3& p)
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
  {
    // On a thin torus the tube bends much more than the ring does: directions along the ring.
    Mesh tm = make_mesh(torus(120, 24, 1, 0.15));
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
    Mesh tm = make_mesh(mapped(grid(120, 20, 6, 1), [](const Point_3& p)
    {
      const double r = 0.5, x = p.x() - 3;
      return x < 0 ? Point_3(x, p.y(), 0)
                   : Point_3(r * std::sin((std::min)(x / r, pi)) - (std::max)(0., x - pi * r), p.y(),
                             r * (1 - std::cos((std::min)(x / r, pi))));
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
          assert(sizing[g] <= sizing[f] + 0.2 * std::sqrt(CGAL::squared_distance(center_of(tm, f), center_of(tm, g))) + 1e-12);
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
  stage_checks::check_stops([&](stage_checks::Counting_visitor& visitor)
  {
    for(Face f : tm.faces())
      direction[f] = Vector_3(0, 0, 7);
    const bool is_done = QM::salient_directions(tm, 0.2, direction, params::visitor(std::ref(visitor))).is_valid();
    for(Face f : tm.faces())
      assert(is_done || (direction[f] && *direction[f] == Vector_3(0, 0, 7)));
    return is_done;
  });
  stage_checks::check_stops([&](stage_checks::Counting_visitor& visitor)
  {
    for(Face f : tm.faces())
      sizing[f] = 7;
    const bool is_done = QM::curvature_sizing(tm, 0.01, 0.01, 1, sizing, params::visitor(std::ref(visitor))).is_valid();
    for(Face f : tm.faces())
      assert((sizing[f] == 7) != is_done);
    return is_done;
  });
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv, {
    { "salient_directions", test_salient_directions },
    { "sizing", test_sizing },
    { "bad_lengths", test_bad_lengths },
    { "stops", test_stops }
  });
}
