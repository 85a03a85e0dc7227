// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The smoothing knows which side of a quad is outside: what counts as opposed to the surface, how that is undone, and
// that no direction of space differs from the others.

#undef NDEBUG
#include "structure_meshes.h"
#include "test_cases.h"

#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>

namespace QM = CGAL::Quad_meshing;
namespace SM = structure_meshes;

typedef SM::Mesh Mesh;
typedef CGAL::Aff_transformation_3<SM::Kernel> Transformation;
typedef CGAL::Constant_property_map<Mesh::Vertex_index, bool> Same_for_all;

namespace {

// A rotation about the axis through the origin and (2, -1, 3).
Transformation rotation(double degrees)
{
  const double angle = degrees * std::acos(-1.) / 180, c = std::cos(angle), s = std::sin(angle), n = std::sqrt(14.);
  const double x = 2 / n, y = -1 / n, z = 3 / n, d = 1 - c;
  return Transformation(d * x * x + c, d * x * y - s * z, d * x * z + s * y, d * y * x + s * z, d * y * y + c,
                        d * y * z - s * x, d * z * x - s * y, d * z * y + s * x, d * z * z + c);
}

// A plate that cannot move, over a plane that is tilted: its quads are opposed from 120 degrees on.
void test_opposed_quads()
{
  const int n = 4;
  const Mesh plate = SM::make_mesh(SM::grid(n, n));
  const double middle = n / 2.;
  for(int degrees : { 0, 45, 89, 91, 119, 121, 150, 180 })
  {
    const double angle = degrees * std::acos(-1.) / 180, c = std::cos(angle), s = std::sin(angle);
    Mesh plane = SM::triangulated(SM::grid(n, n));
    // about the line in the middle, and larger than the plate, so that all of the plate lies above or below it
    const double larger = 10;
    for(Mesh::Vertex_index v : plane.vertices())
    {
      const SM::Point_3 p = plane.point(v);
      const double x = larger * (p.x() - middle), y = larger * (p.y() - middle);
      plane.point(v) = SM::Point_3(middle + x, middle + c * y, s * y);
    }
    Mesh qm = plate;
    const auto r = QM::smooth_quad_mesh(qm, plane, CGAL::parameters::vertex_is_constrained_map(Same_for_all(true)));
    std::cout << "  " << degrees << " degrees: " << r.folded_quads_after << " folded" << std::endl;
    const std::size_t opposed = degrees > 120 ? n * n : 0;
    assert(r.folded_quads_before == opposed && r.folded_quads_after == opposed);
  }
}

// A block in a plate that is turned over, by a reflection: its quads are squares, but seen from below. Nothing but the
// normals of the surface tells that they are wrong.
void test_block_turned_over()
{
  const int n = 12, first = 5, last = 7; // its vertices
  const Mesh plane = SM::triangulated(SM::grid(n, n));
  for(bool globally : { false, true })
  {
    Mesh qm = SM::make_mesh(SM::grid(n, n));
    for(Mesh::Vertex_index v : qm.vertices())
    {
      const SM::Point_3 p = qm.point(v);
      if(p.x() >= first && p.x() <= last && p.y() >= first && p.y() <= last)
        qm.point(v) = SM::Point_3(first + last - p.x(), p.y(), 0);
    }
    const auto r = QM::smooth_quad_mesh(qm, plane, CGAL::parameters::smooth_globally(globally));
    std::cout << "  " << r.folded_quads_before << " folded before, " << r.folded_quads_after << " after" << std::endl;
    assert(r.folded_quads_before >= (last - first) * (last - first) && r.folded_quads_after == 0);
    for(Mesh::Face_index f : qm.faces())
      assert(CGAL::Polygon_mesh_processing::compute_face_normal(f, qm).z() > 0.9);
  }
}

// What is smoothed and then turned is what is turned and then smoothed.
void test_rotation()
{
  SM::Quad_soup soup = SM::sphere(10);
  CGAL::Random random(5);
  const double noise = 0.03; // of the radius; a third of a side
  auto some = [&] { return random.get_double(-noise, noise); };
  for(SM::Point_3& p : soup.points)
    p = p + SM::Kernel::Vector_3(some(), some(), some());
  const Mesh input = SM::make_mesh(soup), reference = SM::triangulated(SM::sphere(20));
  for(bool globally : { false, true })
  {
    const auto np = CGAL::parameters::smooth_globally(globally).smoothing_iterations(4u);
    Mesh smoothed = input;
    QM::smooth_quad_mesh(smoothed, reference, np);
    for(double degrees : { 25., 110., 200. })
    {
      const Transformation turn = rotation(degrees);
      Mesh turned = input, turned_reference = reference, expected = smoothed;
      CGAL::Polygon_mesh_processing::transform(turn, turned);
      CGAL::Polygon_mesh_processing::transform(turn, turned_reference);
      CGAL::Polygon_mesh_processing::transform(turn, expected);
      QM::smooth_quad_mesh(turned, turned_reference, np);
      double farthest = 0, moved = 0;
      for(Mesh::Vertex_index v : turned.vertices())
      {
        farthest = (std::max)(farthest, CGAL::squared_distance(turned.point(v), expected.point(v)));
        moved = (std::max)(moved, CGAL::squared_distance(input.point(v), smoothed.point(v)));
      }
      std::cout << "  " << degrees << " degrees: " << std::sqrt(farthest) << " apart, moved by " << std::sqrt(moved)
                << std::endl;
      // One by one, only rounding differs. All at once, the frames of the vertices turn another way than the mesh, and
      // conjugate gradients in these frames end at a residual of a hundredth.
      const double tolerance = globally ? 0.2 * std::sqrt(moved) : 1e-9;
      assert(std::sqrt(farthest) < tolerance && std::sqrt(moved) > noise);
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "opposed_quads", test_opposed_quads },
                     { "block_turned_over", test_block_turned_over },
                     { "rotation", test_rotation } });
}
