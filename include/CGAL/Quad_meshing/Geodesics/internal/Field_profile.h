// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_PROFILE_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_PROFILE_H

#include <CGAL/Quad_meshing/Geodesics/internal/Field_sources.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_envelope.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_propagation.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The distance along any segment within a face, as a list of windows: everything by which the face is
// reached (see Field_queries) is restricted to the segment and inserted into an envelope.
class Field_profile
{
public:
  typedef Unfolded_mesh<double> Mesh;
  typedef Window_propagation<double> Propagation;
  typedef Field_sources<double> Sources;
  typedef Window<double> W;
  typedef std::pair<double, double> Place;

  Field_profile(const Mesh& mesh, const Propagation& propagation, const Sources& sources)
    : m_mesh(mesh), m_propagation(propagation), m_sources(sources)
  {
  }

  // Where along the segment from a to b (fractions of it) the distance differs most from the line between
  // the distances da and db at its ends, and by how much.
  //
  // The windows tell where that may be. What they say of the distance there is asked again of the field (`distance_at`,
  // for a fraction of the segment): where a segment runs along the rays at the end of a window it is a matter of
  // rounding which windows reach it.
  template <typename DistanceAt>
  std::pair<double, double> largest_deviation(int face, const Place& a, const Place& b, double da, double db,
                                              const DistanceAt& distance_at)
  {
    const double length = std::hypot(b.first - a.first, b.second - a.second);
    std::pair<double, double> worst(0.5, 0.);
    if(!(length > 0))
      return worst;
    make(face, a, b, length);
    const double slope = (db - da) / length;
    const auto look_at = [&](const W& w, double t)
    {
      // Neither function grows faster than the way does. So rounding at the ends cannot count as an error,
      // and an edge shorter than the tolerance needs no split.
      const double possible = 2 * (std::min)(t, length - t);
      if((std::min)(std::abs(w.distance(t) - (da + slope * t)), possible) > worst.second)
      {
        const double deviation = (std::min)(std::abs(distance_at(t / length) - (da + slope * t)), possible);
        if(deviation > worst.second)
          worst = std::make_pair(t / length, deviation);
      }
    };
    for(const W& w : m_lists[0])
    {
      look_at(w, w.b0);
      look_at(w, w.b1);
      // between its ends a circular window is farthest from a line where it is parallel to it
      if(!w.linear && std::abs(slope) < 1)
      {
        const double t = w.x + w.y * slope / std::sqrt(1 - slope * slope);
        if(t > w.b0 && t < w.b1)
          look_at(w, t);
      }
    }
    return worst;
  }

private:
  // Everything in the frame of the segment: a at the origin, b on the x-axis.
  void make(int face, const Place& a, const Place& b, double length)
  {
    m_lists.clear(m_lists[0]);
    m_length = length;
    const double ux = (b.first - a.first) / length, uy = (b.second - a.second) / length;
    const auto placed = [&](double x, double y)
    {
      const double dx = x - a.first, dy = y - a.second;
      return Place(dx * ux + dy * uy, dy * ux - dx * uy);
    };

    for(int k = 0; k < 3; ++k)
    {
      const auto c = corner_place(m_mesh, face, k);
      const int v = m_mesh.corners[face][k];
      if(m_propagation.is_reached(v))
        insert_circular(placed(c.first, c.second), m_propagation.label(v).distance, 0, length);
    }
    const auto range = m_sources.elements_in_face(face);
    for(auto it = range.first; it != range.second; ++it)
    {
      const Source_element<double>& e = m_sources.elements()[it->second];
      const auto from = place_in_face(m_mesh, face, e.from), to = place_in_face(m_mesh, face, e.to);
      const Place p = placed(from.first, from.second), q = placed(to.first, to.second);
      if(e.is_segment)
        insert_segment(p, q, e.offset);
      else
        insert_circular(p, e.offset, 0, length);
    }
    for(int h = 3 * face; h < 3 * face + 3; ++h)
    {
      const double l = m_mesh.length_of(h);
      const auto c = corner_place(m_mesh, face, h % 3), d = corner_place(m_mesh, face, (h + 1) % 3);
      const Place p = placed(c.first, c.second), q = placed(d.first, d.second);
      if(l > 0 && m_mesh.opposite[h] != -1)
        for(const W& window : m_propagation.windows(m_mesh.edge_of[h]))
          if(window.from_left != m_mesh.is_canonical(h))
            insert_window(h, window, p, Place((q.first - p.first) / l, (q.second - p.second) / l));
    }
  }

  // A window of halfedge h, which begins at p and has the direction u.
  void insert_window(int h, W w, const Place& p, const Place& u)
  {
    if(!(w.y > 0))
      return;
    if(!m_mesh.is_canonical(h))
      w.reverse(m_mesh.length_of(h));
    const Place p0(p.first + w.b0 * u.first, p.second + w.b0 * u.second);
    const Place p1(p.first + w.b1 * u.first, p.second + w.b1 * u.second);
    // the face lies to the left of u
    const auto in_frame = [&](double x, double y)
    { return Place(x * u.first - y * u.second, x * u.second + y * u.first); };
    double t0 = 0, t1 = m_length;
    if(w.linear)
    {
      const Place n = in_frame(w.x, w.y);
      if(!clip_right(p0, n, t0, t1) || !clip_left(p1, n, t0, t1))
        return;
      insert_linear(n, w.sigma + w.x * w.b0, p0, t0, t1);
    }
    else
    {
      const Place r = in_frame(w.x, -w.y), s(p.first + r.first, p.second + r.second);
      if(!clip_right(p0, Place(p0.first - s.first, p0.second - s.second), t0, t1) ||
         !clip_left(p1, Place(p1.first - s.first, p1.second - s.second), t0, t1))
        return;
      insert_circular(s, w.sigma, t0, t1);
    }
  }

  // Restricts [t0, t1] to the right (left) of the ray from p in direction d.
  bool clip_right(const Place& p, const Place& d, double& t0, double& t1) const
  {
    return clip(d.second, d.first * p.second - d.second * p.first, d, t0, t1);
  }
  bool clip_left(const Place& p, const Place& d, double& t0, double& t1) const
  {
    return clip(-d.second, d.second * p.first - d.first * p.second, d, t0, t1);
  }

  // A window that reaches the segment is taken to reach so much farther, as a part of the length: windows leave gaps
  // from rounding, and a segment along their rays would fall into them. A distance found so is wrong by the square of
  // this.
  static double clip_slack() { return 1e-7; }

  // Restricts [t0, t1] to where a t + b >= 0, up to rounding.
  bool clip(double a, double b, const Place& d, double& t0, double& t1) const
  {
    const double slack = clip_slack() * m_length * (std::abs(d.first) + std::abs(d.second));
    if(a == 0)
      return b >= -slack;
    const double t = -(b + slack) / a;
    (a > 0 ? t0 : t1) = a > 0 ? (std::max)(t0, t) : (std::min)(t1, t);
    return t0 < t1;
  }

  void insert_circular(const Place& source, double sigma, double t0, double t1)
  {
    insert(W{ t0, t1, source.first, std::abs(source.second), sigma, 0, false, true, false, 0.f });
  }

  // The distance `d` at p grows in direction n.
  void insert_linear(const Place& n, double d, const Place& p, double t0, double t1)
  {
    insert(
      W{ t0, t1, n.first, std::abs(n.second), d - n.first * p.first - n.second * p.second, 0, true, true, false, 0.f });
  }

  // The distance to the segment pq where the foot lies within it; its ends are sources of their own.
  void insert_segment(const Place& p, const Place& q, double offset)
  {
    const double vx = q.first - p.first, vy = q.second - p.second, norm = std::hypot(vx, vy);
    for(double side : { 1., -1. })
    {
      const Place n(-side * vy / norm, side * vx / norm);
      double t0 = 0, t1 = m_length;
      if(clip(vx, -(vx * p.first + vy * p.second), Place(vx, vy), t0, t1) &&
         clip(-vx, vx * q.first + vy * q.second, Place(vx, vy), t0, t1) &&
         clip(n.first, -(n.first * p.first + n.second * p.second), n, t0, t1))
        insert_linear(n, offset, p, t0, t1);
    }
  }

  void insert(W w)
  {
    int hint = 0;
    m_envelope.insert(m_lists, m_lists[0], hint, w, m_length);
  }

  const Mesh& m_mesh;
  const Propagation& m_propagation;
  const Sources& m_sources;
  Window_envelope<double> m_envelope;
  Window_lists<double> m_lists{ 1 };
  double m_length = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_FIELD_PROFILE_H
