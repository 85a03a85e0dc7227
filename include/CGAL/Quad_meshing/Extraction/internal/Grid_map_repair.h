// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_MAP_REPAIR_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_MAP_REPAIR_H

#include <CGAL/Quad_meshing/Extraction/internal/Grid_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Makes a map fulfill its transitions exactly, and undoes fold-overs by moving images of vertices.
//
// A vertex is handled in the chart of its first sector: `Fan` takes its other corners there. Whatever point is chosen for
// the vertex in that chart, its other corners follow from it through the transitions, so that these hold exactly (as
// long as no sum rounds, for which coordinates are multiples of `m_quantum`). Only turning once around the vertex must
// lead back to the point: that fixes it at singular vertices (Ebke et al. 2013, Section 4).
class Grid_map_repair
{
public:
  typedef Grid_map::Point_2 Point_2;

  explicit Grid_map_repair(Grid_map& map)
    : m_map(map), m_mesh(map.mesh), m_quantum(quantum(map))
  {}

  double largest_change = 0;
  std::size_t moved_vertices = 0;

  // Makes the transitions exact. `inexact` are the edges over which they are not, one halfedge each.
  void make_transitions_exact(const std::vector<int>& inexact)
  {
    choose_rotations_of_points(inexact);
    double discrepancy = 0;
    for(int h : inexact)
      discrepancy = (std::max)(discrepancy, discrepancy_of(h));
    // A coordinate this near to an integer cannot be told from one: alignment to isolines must not get lost.
    const double snap_distance = (std::min)(4 * discrepancy, 1. / 64);
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_mesh.halfedge_of_vertex[v] != -1)
        make_exact(v, snap_distance);
  }

  // The number of edges over which the transition does not hold exactly.
  std::size_t number_of_inexact_transitions() const
  {
    std::size_t n = 0;
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      n += m_mesh.opposite[m_mesh.halfedge_of_edge[e]] != -1 && discrepancy_of(m_mesh.halfedge_of_edge[e]) != 0;
    return n;
  }

  // Moves regular inner vertices of triangles that are not positive to where all triangles around them are, if there
  // is such a place. First a coordinate on an isoline stays on it: the vertex may be there on purpose. Where this does
  // not help, it may leave it. Each time sweeps until nothing moves.
  void undo_fold_overs(int sweeps)
  {
    std::vector<int> bad = bad_faces();
    for(bool keep_on_isolines : { true, false })
      for(int i = 0; i < sweeps && !bad.empty(); ++i)
      {
        const std::size_t before = moved_vertices;
        for(int f : bad)
          for(int k = 0; k < 3 && m_map.sign[f] <= 0; ++k)
            moved_vertices += move_into_kernel(m_mesh.corners[f][k], keep_on_isolines);
        bad.erase(std::remove_if(bad.begin(), bad.end(), [&](int f) { return m_map.sign[f] > 0; }), bad.end());
        if(moved_vertices == before)
          break;
      }
  }

  // Moves regular inner vertices of triangles that are not positive by up to 2^-10. A fold-over in general position leaves crossings
  // of grid lines that cancel; along a fold that runs on a grid line, or in a triangle without area, there is nothing to see.
  void perturb_fold_overs()
  {
    std::vector<char> done(m_mesh.number_of_vertices(), false);
    std::vector<int> changed;
    for(int f : bad_faces())
      for(int v : m_mesh.corners[f])
      {
        Grid_automorphism g;
        if(done[v] || !unfold(v, g) || !g.is_identity())
          continue;
        done[v] = true;
        // Any offsets will do that have no pattern in common with those of the neighbors.
        const double x = fraction(0.7548776662466927 * (v + 1)), y = fraction(0.5698402909980532 * (v + 1));
        const Point_2& p = m_map.uv[m_fan.front().h];
        assign(Point_2(p.x() + quantized((2 * x - 1) / 1024), p.y() + quantized((2 * y - 1) / 1024)));
        for(const Sector& s : m_fan)
          changed.push_back(s.h / 3);
      }
    for(int f : changed)
      m_map.sign[f] = static_cast<signed char>(m_map.orientation_of_face(f));
  }

private:
  typedef Indexed_triangle_mesh Mesh;

  struct Sector { int h; Grid_automorphism to_first; };

  Grid_map& m_map;
  const Mesh& m_mesh;
  const double m_quantum;
  std::vector<Sector> m_fan;
  std::vector<Point_2> m_link, m_kernel, m_clipped;

  // The smallest power of two such that coordinates and translations of the size at hand are sums without round-off.
  static double quantum(const Grid_map& map)
  {
    double largest = 1;
    for(const Point_2& p : map.uv)
      largest = (std::max)(largest, (std::max)(std::fabs(p.x()), std::fabs(p.y())));
    return std::ldexp(1., std::ilogb(largest) - 46);
  }

  static double fraction(double x) { return x - std::floor(x); }

  std::vector<int> bad_faces() const
  {
    std::vector<int> bad;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      if(m_map.sign[f] <= 0)
        bad.push_back(f);
    return bad;
  }

  double quantized(double x) const { return std::floor(x / m_quantum + 0.5) * m_quantum; }

  double discrepancy_of(int h) const
  {
    const int o = m_mesh.opposite[h];
    const Point_2 a = m_map.transition[h](m_map.uv[h]), b = m_map.transition[h](m_map.uv[Mesh::next(h)]);
    const Point_2& c = m_map.uv[Mesh::next(o)];
    const Point_2& d = m_map.uv[o];
    return (std::max)((std::max)(std::fabs(a.x() - c.x()), std::fabs(a.y() - c.y())),
                      (std::max)(std::fabs(b.x() - d.x()), std::fabs(b.y() - d.y())));
  }

  // Fills `m_fan`; returns whether it is closed, and then the automorphism that turning once around gives.
  bool unfold(int v, Grid_automorphism& holonomy)
  {
    m_fan.clear();
    for_each_sector(m_mesh, v, [&](int h)
    {
      m_fan.push_back(Sector{ h, m_fan.empty() ? Grid_automorphism() : m_fan.back().to_first * m_map.transition[h] });
    });
    const int first = m_fan.front().h;
    if(m_mesh.opposite[first] == -1)
      return false;
    holonomy = m_fan.back().to_first * m_map.transition[first];
    return true;
  }

  // The rotation across an edge whose image is a point cannot be seen there. Either end is at the same place, so any rotation whose
  // translation is integer describes the same map; one that leaves an end regular is preferred.
  void choose_rotations_of_points(const std::vector<int>& inexact)
  {
    for(int h : inexact)
    {
      const Point_2& a = m_map.uv[h];
      const int o = m_mesh.opposite[h];
      if(!(a == m_map.uv[Mesh::next(h)]) || !(m_map.uv[o] == m_map.uv[Mesh::next(o)]))
        continue;
      const Point_2& b = m_map.uv[o];
      int best_score = -1;
      Grid_automorphism best;
      for(int r = 0; r < 4; ++r)
      {
        double x = a.x(), y = a.y();
        Grid_automorphism::rotate(r, x, y);
        const Grid_automorphism t(r, std::floor(b.x() - x + 0.5), std::floor(b.y() - y + 0.5));
        const Point_2 image = t(a);
        m_map.transition[h] = t;
        m_map.transition[o] = t.inverse();
        int score = 4 * (std::fabs(image.x() - b.x()) + std::fabs(image.y() - b.y()) < 1. / 64);
        for(int v : { m_mesh.source(h), m_mesh.target(h) })
        {
          Grid_automorphism holonomy;
          score += unfold(v, holonomy) && holonomy.r == 0;
        }
        if(score > best_score)
        {
          best_score = score;
          best = t;
        }
      }
      m_map.transition[h] = best;
      m_map.transition[o] = best.inverse();
    }
  }

  void make_exact(int v, double snap_distance)
  {
    Grid_automorphism g;
    const bool closed = unfold(v, g);
    double x = 0, y = 0;
    for(const Sector& s : m_fan)
    {
      const Point_2 p = s.to_first(m_map.uv[s.h]);
      x += p.x();
      y += p.y();
    }
    x /= m_fan.size();
    y /= m_fan.size();
    auto snapped = [&](double c)
    {
      const double i = std::floor(c + 0.5);
      return std::fabs(c - i) <= snap_distance ? i : quantized(c);
    };
    if(!closed || g.r == 0)
    {
      x = snapped(x);
      y = snapped(y);
    }
    else if(g.r == 1) { x = (g.tx - g.ty) / 2; y = (g.tx + g.ty) / 2; }
    else if(g.r == 2) { x = g.tx / 2;          y = g.ty / 2; }
    else              { x = (g.tx + g.ty) / 2; y = (g.ty - g.tx) / 2; }
    assign(Point_2(x, y));
  }

  // Gives the vertex of the fan the point p in the chart of the first sector.
  void assign(const Point_2& p)
  {
    for(const Sector& s : m_fan)
    {
      Point_2& c = m_map.uv[s.h];
      const Point_2 q = s.to_first.inverse()(p);
      largest_change = (std::max)(largest_change, (std::max)(std::fabs(q.x() - c.x()), std::fabs(q.y() - c.y())));
      c = q;
    }
  }

  bool move_into_kernel(int v, bool keep_on_isolines)
  {
    Grid_automorphism g;
    if(!unfold(v, g) || !g.is_identity())
      return false;
    const Point_2 p = m_map.uv[m_fan.front().h];
    m_link.clear();
    for(const Sector& s : m_fan)
      m_link.push_back(s.to_first(m_map.uv[Mesh::next(s.h)]));

    // The kernel of the link: its bounding box, clipped by the left sides of all link edges.
    double x0 = HUGE_VAL, x1 = -HUGE_VAL, y0 = HUGE_VAL, y1 = -HUGE_VAL;
    for(const Point_2& q : m_link)
    {
      x0 = (std::min)(x0, q.x()); x1 = (std::max)(x1, q.x());
      y0 = (std::min)(y0, q.y()); y1 = (std::max)(y1, q.y());
    }
    const bool keep_x = keep_on_isolines && is_integer(p.x()), keep_y = keep_on_isolines && is_integer(p.y());
    if(keep_x) x0 = x1 = p.x();
    if(keep_y) y0 = y1 = p.y();
    m_kernel = { Point_2(x0, y0), Point_2(x1, y0), Point_2(x1, y1), Point_2(x0, y1) };
    for(std::size_t i = 0; i < m_link.size() && !m_kernel.empty(); ++i)
      clip(m_link[i], m_link[(i + 1) % m_link.size()]);
    if(m_kernel.empty())
      return false;

    double x = 0, y = 0;
    for(const Point_2& q : m_kernel)
    {
      x += q.x() / m_kernel.size();
      y += q.y() / m_kernel.size();
    }
    const Point_2 c(keep_x ? p.x() : quantized(x), keep_y ? p.y() : quantized(y));
    // The clipping is done in floating point; what counts is this.
    for(std::size_t i = 0; i < m_link.size(); ++i)
      if(CGAL::orientation(m_link[i], m_link[(i + 1) % m_link.size()], c) != CGAL::LEFT_TURN)
        return false;
    assign(c);
    for(const Sector& s : m_fan)
      m_map.sign[s.h / 3] = 1;
    return true;
  }

  // Clips `m_kernel` by the left side of the line from a to b.
  void clip(const Point_2& a, const Point_2& b)
  {
    auto height = [&](const Point_2& p)
    { return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x()); };
    m_clipped.clear();
    for(std::size_t i = 0; i < m_kernel.size(); ++i)
    {
      const Point_2& p = m_kernel[i];
      const Point_2& q = m_kernel[(i + 1) % m_kernel.size()];
      const double s = height(p), t = height(q);
      if(s >= 0)
        m_clipped.push_back(p);
      if((s > 0 && t < 0) || (s < 0 && t > 0))
        m_clipped.push_back(Point_2(p.x() + (q.x() - p.x()) * (s / (s - t)), p.y() + (q.y() - p.y()) * (s / (s - t))));
    }
    m_kernel.swap(m_clipped);
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_MAP_REPAIR_H
