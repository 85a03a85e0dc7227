// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_FACE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_FACE_H

#include <CGAL/Quad_meshing/Geodesics/internal/Certified_number.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_sources.h>

#include <array>
#include <utility>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The shape of a face, certified: the true triangle between the points of the mesh. Halfedges are numbered 0 to 2.
class Certified_face
{
public:
  typedef Certified_number Number;
  typedef std::pair<Number, Number> Place;

  Certified_face(const Indexed_triangle_mesh& mesh, int face)
  {
    std::array<std::array<Number, 3>, 3> side;
    for(int k = 0; k < 3; ++k)
    {
      const auto &p = mesh.points[mesh.corners[face][k]], &q = mesh.points[mesh.corners[face][(k + 1) % 3]];
      for(int c = 0; c < 3; ++c)
        side[k][c] = Number::difference(q[c], p[c]);
      m_length[k] = sqrt(dot(side[k], side[k]));
    }
    const auto &u = side[0], &v = side[1];
    const std::array<Number, 3> n = { { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                        u[0] * v[1] - u[1] * v[0] } };
    const Number area = sqrt(dot(n, n)); // twice
    for(int k = 0; k < 3; ++k)
    {
      if(is_point(k))
        continue;
      m_apex[k] = Place(-dot(side[k], side[(k + 2) % 3]) / m_length[k], area / m_length[k]);
    }
    for(int k = 0; k < 3; ++k)
    {
      const int n = (k + 1) % 3, p = (k + 2) % 3;
      if(is_point(k))
        continue;
      if(!is_point(n))
        m_to_next[k] = Place(dot(side[k], side[n]) / (m_length[k] * m_length[n]), area / (m_length[k] * m_length[n]));
      if(!is_point(p))
        m_to_apex[k] = Place(m_apex[k].first / m_length[p], m_apex[k].second / m_length[p]);
    }
  }

  // Whether an edge has no length.
  bool is_point(int k) const { return !(m_length[k].lower() > 0); }

  const Number& length(int k) const { return m_length[k]; }

  // In the frame of halfedge k: its opposite corner, the direction of the next halfedge, and the direction from its
  // source to the opposite corner.
  const Place& apex(int k) const { return m_apex[k]; }
  const Place& to_next(int k) const { return m_to_next[k]; }
  const Place& to_apex(int k) const { return m_to_apex[k]; }

  // The corners in the frame of halfedge 0, which must not be a point.
  Place corner(int k) const { return k == 0 ? Place() : k == 1 ? Place(m_length[0], Number()) : m_apex[0]; }

  // The place at a part of halfedge k in the frame of halfedge 0.
  Place along(int k, const Number& part) const
  {
    const Place a = corner(k), b = corner((k + 1) % 3);
    return Place(a.first + part * (b.first - a.first), a.second + part * (b.second - a.second));
  }

private:
  static Number dot(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  std::array<Number, 3> m_length;
  std::array<Place, 3> m_apex, m_to_next, m_to_apex;
};

// The place of a point of a face in the frame of its first halfedge, which must not be a point.
inline Certified_face::Place certified_place(const Indexed_triangle_mesh& mesh, int face, const Certified_face& shape,
                                             const Surface_point<double>& p)
{
  typedef Surface_point<double> Point;
  typedef Certified_number Number;
  if(p.carrier == Point::FACE)
    return Certified_face::Place(p.x, p.y);
  if(p.carrier == Point::VERTEX)
  {
    int k = 0;
    while(k < 2 && mesh.corners[face][k] != p.simplex)
      ++k;
    return shape.corner(k);
  }
  const bool is_here = Indexed_triangle_mesh::face(p.simplex) == face;
  const int k = (is_here ? p.simplex : mesh.opposite[p.simplex]) % 3;
  const Number part = (is_here ? Number(p.x) : shape.length(k) - Number(p.x)) / shape.length(k);
  return shape.along(k, part);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_CERTIFIED_FACE_H
