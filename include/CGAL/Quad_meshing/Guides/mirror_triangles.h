// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GUIDES_MIRROR_TRIANGLES_H
#define CGAL_QUAD_MESHING_GUIDES_MIRROR_TRIANGLES_H

#include <CGAL/Quad_meshing/Guides/Symmetry_plane.h>
#include <CGAL/Quad_meshing/Guides/cut_triangles.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A plane to mirror at. For a plane orthogonal to an axis, two of the coordinates of a mirror image are those of the
// point, bit for bit.
class Mirror
{
  typedef Exact_predicates_inexact_constructions_kernel Kernel;

public:
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  // The normal has length one.
  Mirror(const Point_3& point, const Vector_3& normal) : m_point(point), m_normal(normal)
  {
    for(int c = 0; c < 3; ++c)
      if(m_normal[(c + 1) % 3] == 0 && m_normal[(c + 2) % 3] == 0)
        m_axis = c;
  }

  const Vector_3& normal() const { return m_normal; }

  // Positive on the side that the normal shows to.
  double distance(const Point_3& p) const { return (p - m_point) * m_normal; }

  Point_3 image(const Point_3& p) const
  {
    return m_axis == -1 ? p - (2 * distance(p)) * m_normal : with_coordinate(p, 2 * m_point[m_axis] - p[m_axis]);
  }

  // The nearest point of the plane.
  Point_3 projection(const Point_3& p) const
  {
    return m_axis == -1 ? p - distance(p) * m_normal : with_coordinate(p, m_point[m_axis]);
  }

private:
  Point_3 with_coordinate(const Point_3& p, double x) const
  {
    std::array<double, 3> c = { { p.x(), p.y(), p.z() } };
    c[m_axis] = x;
    return Point_3(c[0], c[1], c[2]);
  }

  Point_3 m_point;
  Vector_3 m_normal;
  int m_axis = -1; // that the plane is orthogonal to, -1 if to none
};

// The plane that the user asks for; the best one that is found, if nothing is known of it.
CGAL_QUAD_MESHING_INLINE Mirror make_mirror(const Guided_triangles& surface, const Symmetry_plane& plane);

// The largest distance of a mirrored vertex from the surface.
CGAL_QUAD_MESHING_INLINE double mirror_deviation(const Guided_triangles& surface, const Mirror& mirror);

// The half of a surface on the positive side of a mirror.
struct Mirror_half : Guided_triangles
{
  std::vector<std::size_t> origin;         // per triangle: the one that it lies in
  std::vector<std::array<char, 3>> side;   // per triangle: as in `Cut_triangles`
  std::vector<std::array<char, 3>> is_cut; // per triangle: whether a side lies in the mirror
  std::vector<std::array<int, 2>> ends; // per point: the points of the surface that it lies between, or twice its own
  std::vector<double> weight;           // per point: of the second of them
  std::string error;                    // a sentence; empty if all went well
};

// Points within the distance `snap` of the mirror are moved into it.
CGAL_QUAD_MESHING_INLINE Mirror_half cut_half(const Guided_triangles& surface, const Mirror& mirror, double snap);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Guides/internal/mirror_triangles_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_GUIDES_MIRROR_TRIANGLES_H
