// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_FACE_FRAMES_H
#define CGAL_QUAD_MESHING_FIELDS_FACE_FRAMES_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

constexpr double quarter_turn = CGAL_PI / 2;

// The angles of one triangle in its frame, whose x-axis is the vector from corner 0 to corner 1.
struct Triangle_angles
{
  std::array<double, 3> corner;    // the interior angle at corner k
  std::array<double, 3> direction; // the angle of the vector from corner k to corner k+1
};

// Computes the angles of a triangle such that they sum up to exactly those of a plane triangle, also
// if it has no area or edges of length zero.
template <typename Point_3>
Triangle_angles make_triangle_angles(const Point_3& p0, const Point_3& p1, const Point_3& p2)
{
  const std::array<Point_3, 3> p = { { p0, p1, p2 } };
  Triangle_angles t;
  int longest = 0;
  double longest_length = -1;
  bool zero[3];
  for(int k = 0; k < 3; ++k)
  {
    const double length = (p[(k + 1) % 3] - p[k]).squared_length();
    zero[k] = p[(k + 1) % 3] == p[k];
    if(length > longest_length)
    {
      longest = k;
      longest_length = length;
    }
  }

  if(zero[0] && zero[1] && zero[2])
    t.corner.fill(4 * quarter_turn / 6);
  else
  {
    // The two angles at the longest edge are at most right ones; the third completes the sum.
    const int opposite_corner = (longest + 2) % 3;
    double sum = 0;
    for(int k = 0; k < 3; ++k)
      if(k != opposite_corner)
      {
        const auto a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
        // A triangle with an edge of zero length has two right angles at that edge.
        t.corner[k] = (zero[k] || zero[(k + 2) % 3])
                        ? quarter_turn
                        : std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
        sum += t.corner[k];
      }
    t.corner[opposite_corner] = (std::max)(0., 2 * quarter_turn - sum);
  }

  t.direction = { { 0., 2 * quarter_turn - t.corner[1], t.corner[0] - 2 * quarter_turn } };
  return t;
}

// An angle between frames, in (-pi, pi]. Frames that look in opposite directions meet at an angle of
// pi up to rounding; which of the two ends is taken must not depend on the rounding.
inline double wrap_frame_angle(double a)
{
  const double rounding = 1e-9;
  while(a > 2 * quarter_turn + rounding)
    a -= 4 * quarter_turn;
  while(a < -2 * quarter_turn + rounding)
    a += 4 * quarter_turn;
  return a;
}

// Two unit vectors that span a triangle: along its first edge and, counterclockwise, across it.
// Returns false, and leaves the vectors alone, if the triangle has no normal.
template <typename Point_3, typename Vector_3>
bool triangle_axes(const std::array<Point_3, 3>& p, Vector_3& x, Vector_3& y)
{
  // The longest edge carries the plane of a thin triangle best.
  int k = 0;
  for(int i = 1; i < 3; ++i)
    if((p[(i + 1) % 3] - p[i]).squared_length() > (p[(k + 1) % 3] - p[k]).squared_length())
      k = i;
  const Vector_3 a = p[(k + 1) % 3] - p[k], n = cross_product(a, p[(k + 2) % 3] - p[k]);
  const double la = std::sqrt(a.squared_length()), ln = std::sqrt(n.squared_length());
  if(!(la > 0) || !(ln > 0))
    return false;
  const Vector_3 u = a / la, v = cross_product(n / ln, u);
  const double t = make_triangle_angles(p[0], p[1], p[2]).direction[k];
  x = std::cos(t) * u - std::sin(t) * v;
  y = std::sin(t) * u + std::cos(t) * v;
  return true;
}

// The intrinsic geometry a cross field is measured with: one planar frame per face, whose x-axis is
// the vector of the reference halfedge 3*f, and the angle between the frames of neighbors. The
// discrete Gauss-Bonnet theorem, and with it every index formula, holds on degenerate geometry, too.
class Face_frames
{
public:
  explicit Face_frames(const Indexed_triangle_mesh& m)
    : m_corner_angle(m.number_of_halfedges()), m_direction(m.number_of_halfedges()), m_kappa(m.number_of_edges(), 0.)
  {
    for(int f = 0; f < m.number_of_faces(); ++f)
    {
      const Triangle_angles t =
        make_triangle_angles(m.points[m.corners[f][0]], m.points[m.corners[f][1]], m.points[m.corners[f][2]]);
      for(int k = 0; k < 3; ++k)
      {
        m_corner_angle[3 * f + k] = t.corner[k];
        m_direction[3 * f + k] = t.direction[k];
      }
    }
    for(int e = 0; e < m.number_of_edges(); ++e)
      if(!m.is_border_edge(e))
      {
        const int h = m.halfedge_of_edge[e], o = m.opposite[h];
        m_kappa[e] = wrap_frame_angle(m_direction[o] + 2 * quarter_turn - m_direction[h]);
      }
  }

  // The interior angle at the source of halfedge h in its face.
  double corner_angle(int h) const { return m_corner_angle[h]; }

  // The angle of the vector of halfedge h in the frame of its face.
  double direction(int h) const { return m_direction[h]; }

  // The angle of a vector in the frame of the face across edge e minus its angle in the frame of
  // the face of `halfedge_of_edge[e]`, in (-pi, pi]; zero on the border.
  double kappa(int e) const { return m_kappa[e]; }

private:
  std::vector<double> m_corner_angle; // per halfedge, at its source
  std::vector<double> m_direction;    // per halfedge
  std::vector<double> m_kappa;        // per edge
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_FACE_FRAMES_H
