// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors
#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_SHAPE_OPERATORS_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_SHAPE_OPERATORS_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The curvatures of a surface averaged over a disk.
struct Shape_operator
{
  double maximum = 0; // the principal curvature of larger absolute value
  double minimum = 0; // the other one
  double angle = 0;   // of the axis in which the surface bends least, in the plane of the disk, modulo pi

  double mean() const { return (maximum + minimum) / 2; }

  // 0 where both curvatures are equally strong, 1 on parabolic regions.
  double anisotropy() const { return maximum == 0 ? 0 : (std::abs(maximum) - std::abs(minimum)) / std::abs(maximum); }
};

// Shape operators of disks about face centroids, after Cohen-Steiner and Morvan 2003: every edge bends the surface
// by its dihedral angle around its own direction, in proportion to its length inside the disk. Disks
// are the parts of balls that hang together with the face.
class Shape_operators
{
public:
  typedef Indexed_triangle_mesh::Point_3 Point_3;
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  // Feature edges, if given, have a value per edge: disks end there, as at the border, and what they bend does not
  // count.
  explicit Shape_operators(const Indexed_triangle_mesh& m, const std::vector<char>& is_feature = std::vector<char>())
    : m_mesh(m)
    , m_is_feature(is_feature.empty() ? std::vector<char>(m.number_of_edges(), 0) : is_feature)
    , m_normal(m.number_of_faces())
    , m_bend(m.number_of_edges(), 0.)
    , m_face_mark(m.number_of_faces(), -1)
    , m_edge_mark(m.number_of_edges(), -1)
  {
    for(int f = 0; f < m.number_of_faces(); ++f)
      m_normal[f] = cross_product(m.vector(3 * f), m.vector(3 * f + 1)) / 2;
    for(int e = 0; e < m.number_of_edges(); ++e)
    {
      const int h = m.halfedge_of_edge[e], o = m.opposite[h];
      const double length = std::sqrt(m.vector(h).squared_length());
      if(o == -1 || m_is_feature[e] || !(length > 0))
        continue;
      const Vector_3& n = m_normal[h / 3];
      const Vector_3& k = m_normal[o / 3];
      m_bend[e] = std::atan2(cross_product(n, k) * m.vector(h) / length, n * k);
    }
  }

  // The area vector of a face.
  const Vector_3& normal(int f) const { return m_normal[f]; }

  Point_3 centroid(int f) const
  {
    const std::array<int, 3>& c = m_mesh.corners[f];
    return CGAL::centroid(m_mesh.points[c[0]], m_mesh.points[c[1]], m_mesh.points[c[2]]);
  }

  // The operators of the disks of several radii about face f, and the axes of the plane in which
  // their angles are measured. Radii ascend.
  std::vector<Shape_operator> operator()(int f, const std::vector<double>& radii, Vector_3& x, Vector_3& y)
  {
    const Point_3 center = centroid(f);
    gather(f, center, radii.back());

    Vector_3 n(0, 0, 0);
    for(int g : m_faces)
      if((centroid(g) - center).squared_length() <= radii.front() * radii.front())
        n = n + m_normal[g];
    const double length = std::sqrt(n.squared_length());
    if(!(length > 0))
      return std::vector<Shape_operator>();
    n = n / length;
    const Vector_3 axis = std::abs(n.x()) < 0.6 ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0);
    x = cross_product(axis, n);
    x = x / std::sqrt(x.squared_length());
    y = cross_product(n, x);

    std::vector<Shape_operator> result;
    for(double r : radii)
    {
      double xx = 0, xy = 0, yy = 0, area = 0;
      for(int e : m_edges)
      {
        const int h = m_mesh.halfedge_of_edge[e];
        const double inside = length_in_ball(h, center, r);
        if(!(inside > 0))
          continue;
        const Vector_3 v = m_mesh.vector(h);
        const double squared_length = v.squared_length();
        const double a = v * x, b = v * y, weight = m_bend[e] * inside / squared_length;
        xx += weight * a * a;
        xy += weight * a * b;
        yy += weight * b * b;
        // Every edge stands for a third of its faces.
        const double part = inside / std::sqrt(squared_length) / 3;
        area += part * std::sqrt(m_normal[h / 3].squared_length());
        if(m_mesh.opposite[h] != -1)
          area += part * std::sqrt(m_normal[m_mesh.opposite[h] / 3].squared_length());
      }
      Shape_operator s;
      if(area > 0)
      {
        const double middle = (xx + yy) / (2 * area), deviation = std::hypot((xx - yy) / 2, xy) / area;
        const double major = std::atan2(2 * xy, xx - yy) / 2;
        // Edges bend the surface around themselves: the axis of the stronger bending is the
        // direction of the weaker curvature.
        s.maximum = middle >= 0 ? middle + deviation : middle - deviation;
        s.minimum = middle >= 0 ? middle - deviation : middle + deviation;
        s.angle = middle >= 0 ? major : major + std::acos(0.);
      }
      result.push_back(s);
    }
    return result;
  }

private:
  // Collects the faces and edges that hang together with face f inside of a ball.
  void gather(int f, const Point_3& center, double radius)
  {
    m_faces.assign(1, f);
    m_edges.clear();
    m_face_mark[f] = f;
    for(std::size_t next = 0; next < m_faces.size(); ++next)
      for(int h = 3 * m_faces[next]; h < 3 * m_faces[next] + 3; ++h)
      {
        const int e = m_mesh.edge_of[h];
        if(m_edge_mark[e] == f || !(length_in_ball(h, center, radius) > 0))
          continue;
        m_edge_mark[e] = f;
        m_edges.push_back(e);
        const int o = m_mesh.opposite[h];
        if(o != -1 && !m_is_feature[e] && m_face_mark[o / 3] != f)
        {
          m_face_mark[o / 3] = f;
          m_faces.push_back(o / 3);
        }
      }
  }

  double length_in_ball(int h, const Point_3& center, double radius) const
  {
    const Vector_3 d = m_mesh.vector(h), p = m_mesh.points[m_mesh.source(h)] - center;
    const double a = d * d, b = p * d, c = p * p - radius * radius;
    const double discriminant = b * b - a * c;
    if(!(a > 0) || !(discriminant > 0))
      return 0;
    const double root = std::sqrt(discriminant);
    const double from = (std::max)(0., (-b - root) / a), to = (std::min)(1., (-b + root) / a);
    return to > from ? (to - from) * std::sqrt(a) : 0;
  }

  const Indexed_triangle_mesh& m_mesh;
  const std::vector<char> m_is_feature; // per edge
  std::vector<Vector_3> m_normal;       // per face: its area vector
  std::vector<double> m_bend;           // per edge: its signed dihedral angle, 0 if flat
  std::vector<int> m_face_mark, m_edge_mark;
  std::vector<int> m_faces, m_edges; // of the last disk
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_SHAPE_OPERATORS_H
