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

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

constexpr double quarter_turn = 1.5707963267948966;

// The intrinsic geometry a cross field is measured with: one planar frame per face, whose x-axis is
// the vector of the reference halfedge 3*f, and the angle between the frames of neighbors.
//
// All angles of a face derive from two corner angles and sum up to exactly the angles of a plane
// triangle, also for faces of zero area and edges of zero length. So the discrete Gauss-Bonnet
// theorem, and with it every index formula, holds on degenerate geometry as well.
class Face_frames
{
public:
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  explicit Face_frames(const Indexed_triangle_mesh& m)
    : m_mesh(m)
    , m_corner_angle(m.number_of_halfedges())
    , m_direction(m.number_of_halfedges())
    , m_kappa(m.number_of_edges(), 0.)
  {
    for(int f = 0; f < m.number_of_faces(); ++f)
      set_angles_of_face(f);
    for(int e = 0; e < m.number_of_edges(); ++e)
      if(!m.is_border_edge(e))
      {
        const int h = m.halfedge_of_edge[e], o = m.opposite[h];
        m_kappa[e] = wrap(m_direction[o] + 2 * quarter_turn - m_direction[h]);
      }
  }

  // The interior angle at the source of halfedge h in its face.
  double corner_angle(int h) const { return m_corner_angle[h]; }

  // The angle of the vector of halfedge h in the frame of its face.
  double direction(int h) const { return m_direction[h]; }

  // The angle of a vector in the frame of the face across edge e minus its angle in the frame of
  // the face of `halfedge_of_edge[e]`, in (-pi, pi]; zero on the border.
  double kappa(int e) const { return m_kappa[e]; }

  // Two unit vectors that span face f: along its reference halfedge and, counterclockwise, across
  // it. Returns false, and leaves the vectors alone, if the face has no normal.
  bool axes(int f, Vector_3& x, Vector_3& y) const
  {
    // The longest edge carries the plane of a thin triangle best.
    int k = 0;
    for(int i = 1; i < 3; ++i)
      if(m_mesh.vector(3 * f + i).squared_length() > m_mesh.vector(3 * f + k).squared_length())
        k = i;
    const Vector_3 a = m_mesh.vector(3 * f + k), b = m_mesh.vector(3 * f + (k + 1) % 3);
    const Vector_3 n = cross_product(a, b);
    const double la = std::sqrt(a.squared_length()), ln = std::sqrt(n.squared_length());
    if(!(la > 0) || !(ln > 0))
      return false;
    const Vector_3 u = a / la, v = cross_product(n / ln, u);
    const double t = m_direction[3 * f + k];
    x = std::cos(t) * u - std::sin(t) * v;
    y = std::sin(t) * u + std::cos(t) * v;
    return true;
  }

private:
  static double wrap(double a)
  {
    // Frames that look in opposite directions meet at an angle of pi up to rounding; which of the
    // two ends of (-pi, pi] is taken must not depend on the rounding.
    const double rounding = 1e-9;
    while(a > 2 * quarter_turn + rounding) a -= 4 * quarter_turn;
    while(a < -2 * quarter_turn + rounding) a += 4 * quarter_turn;
    return a;
  }

  void set_angles_of_face(int f)
  {
    const int h = 3 * f;
    double angle[3];
    int longest = 0;
    bool zero[3];
    for(int k = 0; k < 3; ++k)
    {
      if(m_mesh.vector(h + k).squared_length() > m_mesh.vector(h + longest).squared_length())
        longest = k;
      zero[k] = m_mesh.points[m_mesh.source(h + k)] == m_mesh.points[m_mesh.target(h + k)];
    }

    if(zero[0] && zero[1] && zero[2])
      std::fill(angle, angle + 3, 4 * quarter_turn / 6);
    else
    {
      // The two angles at the longest edge are at most right ones; the third completes the sum.
      const int opposite_corner = (longest + 2) % 3;
      double sum = 0;
      for(int k = 0; k < 3; ++k)
        if(k != opposite_corner)
        {
          const Vector_3 a = m_mesh.vector(h + k), b = -m_mesh.vector(h + (k + 2) % 3);
          const Vector_3 n = cross_product(a, b);
          // A triangle with an edge of zero length has two right angles at that edge.
          angle[k] = (zero[k] || zero[(k + 2) % 3]) ? quarter_turn
                                                    : std::atan2(std::sqrt(n.squared_length()), a * b);
          sum += angle[k];
        }
      angle[opposite_corner] = (std::max)(0., 2 * quarter_turn - sum);
    }

    for(int k = 0; k < 3; ++k)
      m_corner_angle[h + k] = angle[k];
    m_direction[h] = 0;
    m_direction[h + 1] = 2 * quarter_turn - angle[1];
    m_direction[h + 2] = angle[0] - 2 * quarter_turn;
  }

  const Indexed_triangle_mesh& m_mesh;
  std::vector<double> m_corner_angle; // per halfedge, at its source
  std::vector<double> m_direction;    // per halfedge
  std::vector<double> m_kappa;        // per edge
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_FACE_FRAMES_H
