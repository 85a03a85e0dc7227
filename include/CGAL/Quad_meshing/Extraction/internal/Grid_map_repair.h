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
#include <CGAL/Quad_meshing/internal/Stage_progress.h>
#include <CGAL/Quad_meshing/internal/binary_unit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Makes a map fulfill its transitions exactly, and undoes fold-overs by moving images of vertices.
//
// A vertex is handled in the chart of its first sector: `Fan` takes its other corners there. Whatever point is chosen
// for the vertex in that chart, its other corners follow from it through the transitions, so that these hold exactly
// (as long as no sum rounds, for which coordinates are multiples of `m_quantum`). Only turning once around the vertex
// must lead back to the point: that fixes it at singular vertices (Ebke et al. 2013, Section 4).
class Grid_map_repair
{
public:
  typedef Grid_map::Point_2 Point_2;

  // If the visitor stops it, the map is left as it is then.
  Grid_map_repair(Grid_map& map, Stage_progress& progress)
    : m_map(map), m_mesh(map.mesh), m_progress(progress), m_quantum(quantum(map))
  {
  }

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
    Small_steps steps(m_progress, vertices_per_report);
    for(int v = 0; v < m_mesh.number_of_vertices() && steps.go_further(); ++v)
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
    Small_steps steps(m_progress, vertices_per_report);
    for(bool keep_on_isolines : { true, false })
      for(int i = 0; i < sweeps && !bad.empty(); ++i)
      {
        const std::size_t before = moved_vertices;
        for(int f : bad)
        {
          for(int k = 0; k < 3 && m_map.sign[f] <= 0 && m_attempts_left > 0; ++k, --m_attempts_left)
            moved_vertices += move_into_kernel(m_mesh.corners[f][k], keep_on_isolines);
          if(!steps.go_further())
            return;
        }
        bad.erase(std::remove_if(bad.begin(), bad.end(), [&](int f) { return m_map.sign[f] > 0; }), bad.end());
        if(moved_vertices == before)
          break;
      }
  }

  // Where this is not enough: spreads the regular inner vertices around what remains evenly, in ever larger patches,
  // and tries again. Keeps what makes fewer triangles bad.
  void relax_fold_overs(int sweeps)
  {
    for(int rings = 1; rings <= 4; ++rings)
    {
      const std::vector<int> bad = bad_faces();
      if(bad.empty())
        return;
      const std::vector<int> patch = vertices_around(bad, rings);
      if(patch.size() > largest_patch)
        return;
      // Whatever triangle this makes bad has a corner in the patch, and the others at most one ring further.
      const std::vector<int> touched = vertices_around(bad, rings + 1);
      std::vector<Point_2> old_uv;
      const std::size_t old_moved = moved_vertices;
      for(int v : touched)
        for_each_corner_of_vertex(m_mesh, v, [&](int h) { old_uv.push_back(m_map.uv[h]); });

      const int relaxation_steps = 40; // enough to spread the vertices of four rings
      for(int i = 0; i < relaxation_steps && m_progress.go_further(); ++i)
        for(int v : patch)
          move_to_center(v);
      update_signs_around(patch);
      moved_vertices += patch.size();
      undo_fold_overs(sweeps);

      if(bad_faces().size() < bad.size())
        continue;
      auto old = old_uv.begin();
      for(int v : touched)
        for_each_corner_of_vertex(m_mesh, v, [&](int h) { m_map.uv[h] = *old++; });
      update_signs_around(touched);
      moved_vertices = old_moved;
    }
  }

  // Moves regular inner vertices of triangles that are not positive by up to 2^-10. A fold-over in general position
  // leaves crossings of grid lines that cancel; along a fold that runs on a grid line, or in a triangle without area,
  // there is nothing to see.
  void perturb_fold_overs()
  {
    std::vector<char> done(m_mesh.number_of_vertices(), false);
    std::vector<int> changed;
    for(int f : bad_faces())
      for(int v : m_mesh.corners[f])
      {
        if(done[v] || !is_free(v))
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

  // What has more fold-overs than that is not worth the time.
  static const std::size_t largest_patch = 20000;
  // A vertex takes some microseconds.
  static const int vertices_per_report = 4096;

  struct Sector
  {
    int h;
    Grid_automorphism to_first;
  };

  Grid_map& m_map;
  const Mesh& m_mesh;
  Stage_progress& m_progress;
  const double m_quantum;
  int m_attempts_left = 1000000; // a map with this much to unfold is beyond repair, and the time is limited
  std::vector<Sector> m_fan;
  std::vector<Point_2> m_link, m_kernel, m_clipped, m_old;

  // The smallest power of two such that coordinates and translations of the size at hand are sums without round-off.
  static double quantum(const Grid_map& map)
  {
    double largest = 1;
    for(const Point_2& p : map.uv)
      largest = (std::max)(largest, (std::max)(std::fabs(p.x()), std::fabs(p.y())));
    const int significant_bits = 47;
    return binary_unit(largest, significant_bits);
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

  // The vertices of some faces and of `rings` - 1 rings around them that are free to move.
  std::vector<int> vertices_around(const std::vector<int>& faces, int rings)
  {
    std::vector<char> seen(m_mesh.number_of_vertices(), false);
    std::vector<int> vertices, movable;
    auto add = [&](int v)
    {
      if(!seen[v])
        vertices.push_back(v);
      seen[v] = true;
    };
    for(int f : faces)
      for(int v : m_mesh.corners[f])
        add(v);
    std::size_t i = 0;
    for(int ring = 1; ring < rings; ++ring)
      for(const std::size_t end = vertices.size(); i < end; ++i)
        for_each_corner_of_vertex(m_mesh, vertices[i], [&](int h) { add(m_mesh.target(h)); });
    for(int v : vertices)
      if(is_free(v))
        movable.push_back(v);
    return movable;
  }

  void move_to_center(int v)
  {
    Grid_automorphism g;
    unfold(v, g);
    double x = 0, y = 0;
    for(const Sector& s : m_fan)
    {
      const Point_2 p = s.to_first(m_map.uv[Mesh::next(s.h)]);
      x += p.x() / m_fan.size();
      y += p.y() / m_fan.size();
    }
    assign(Point_2(quantized(x), quantized(y)));
  }

  void update_signs_around(const std::vector<int>& vertices)
  {
    for(int v : vertices)
      for_each_corner_of_vertex(
        m_mesh, v, [&](int h) { m_map.sign[h / 3] = static_cast<signed char>(m_map.orientation_of_face(h / 3)); });
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
    for_each_corner_of_vertex(
      m_mesh, v,
      [&](int h) {
        m_fan.push_back(Sector{ h, m_fan.empty() ? Grid_automorphism() : m_fan.back().to_first * m_map.transition[h] });
      });
    const int first = m_fan.front().h;
    if(m_mesh.opposite[first] == -1)
      return false;
    holonomy = m_fan.back().to_first * m_map.transition[first];
    return true;
  }

  // Whether the vertex is a regular inner one, which may be moved. Leaves it in `m_fan`. To turn around a vertex of
  // valence 8 leads back to the start, too; such a vertex is recognized, if fold-overs beside it do not hide it, by
  // being a grid point around which the directions add up to more than one turn. (Less than one turn is what a vertex
  // moved out of its link has.)
  bool is_free(int v)
  {
    Grid_automorphism g;
    if(!unfold(v, g) || !g.is_identity())
      return false;
    if(!m_map.is_integer_corner(m_fan.front().h))
      return true;
    int quarters = 0;
    for(const Sector& s : m_fan)
    {
      if(m_map.sign[s.h / 3] == 0)
        return true;
      for_each_direction_in_sector(m_map, s.h, [&](int, int sign) { quarters += sign; });
    }
    return quarters <= 4;
  }

  // The rotation across an edge whose image is a point cannot be seen there: every rotation about the point describes
  // the same map. It only decides which end of the edge is how singular. In each tree of such edges all vertices but
  // the root are made regular; the root gets what remains. So singular vertices that fell on one point become one, and
  // the others can be moved apart.
  void choose_rotations_of_points(const std::vector<int>& inexact)
  {
    std::vector<std::vector<int>> leaving(m_mesh.number_of_vertices()); // edges whose image is a point
    for(int h : inexact)
    {
      const int o = m_mesh.opposite[h];
      if(m_map.uv[h] == m_map.uv[Mesh::next(h)] && m_map.uv[o] == m_map.uv[Mesh::next(o)])
        for(int g : { h, o })
        {
          set_rotation_of_point(g, m_map.transition[g].r);
          leaving[m_mesh.source(g)].push_back(g);
        }
    }
    // Border vertices are never singular: they are the best roots.
    std::vector<char> done(m_mesh.number_of_vertices(), false);
    for(bool on_border : { true, false })
      for(int root = 0; root < m_mesh.number_of_vertices(); ++root)
        if(!done[root] && !leaving[root].empty() &&
           on_border == (m_mesh.previous_around_source(m_mesh.halfedge_of_vertex[root]) == -1))
          make_all_but_root_regular(root, leaving, done);
  }

  void make_all_but_root_regular(int root, const std::vector<std::vector<int>>& leaving, std::vector<char>& done)
  {
    std::vector<int> tree; // halfedges away from the root, breadth first
    std::vector<int> vertices(1, root);
    done[root] = true;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      for(int h : leaving[vertices[i]])
      {
        const int v = m_mesh.target(h);
        if(done[v])
          continue;
        done[v] = true;
        vertices.push_back(v);
        tree.push_back(h);
      }
    for(auto h = tree.rbegin(); h != tree.rend(); ++h)
    {
      // Turning around the target crosses the edge once; one more rotation about the vertex turns the whole back.
      Grid_automorphism g;
      if(!unfold(m_mesh.target(*h), g) || g.r == 0)
        continue;
      const int before = m_map.transition[*h].r;
      for(int r = 0; r < 4 && g.r != 0; ++r)
      {
        set_rotation_of_point(*h, r);
        unfold(m_mesh.target(*h), g);
      }
      if(g.r != 0)
        set_rotation_of_point(*h, before);
    }
  }

  void set_rotation_of_point(int h, int r)
  {
    const int o = m_mesh.opposite[h];
    const Point_2& b = m_map.uv[o];
    double x = m_map.uv[h].x(), y = m_map.uv[h].y();
    Grid_automorphism::rotate(r, x, y);
    m_map.transition[h] = Grid_automorphism(r, std::floor(b.x() - x + 0.5), std::floor(b.y() - y + 0.5));
    m_map.transition[o] = m_map.transition[h].inverse();
  }

  void make_exact(int v, double snap_distance)
  {
    Grid_automorphism g;
    const bool closed = unfold(v, g);
    bool exact = true;
    for(std::size_t i = closed ? 0 : 1; i < m_fan.size(); ++i)
    {
      const int h = m_fan[i].h, before = m_fan[i == 0 ? m_fan.size() - 1 : i - 1].h;
      exact &= m_map.transition[h](m_map.uv[h]) == m_map.uv[before];
    }
    // Without noise there is nothing to remove here; with it, a border vertex may be off its isoline unnoticed.
    if(exact && snap_distance == 0)
      return;
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
    else if(g.r == 1)
    {
      x = (g.tx - g.ty) / 2;
      y = (g.tx + g.ty) / 2;
    }
    else if(g.r == 2)
    {
      x = g.tx / 2;
      y = g.ty / 2;
    }
    else
    {
      x = (g.tx + g.ty) / 2;
      y = (g.ty - g.tx) / 2;
    }
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
    if(!is_free(v))
      return false;
    const Point_2 p = m_map.uv[m_fan.front().h];
    m_link.clear();
    for(const Sector& s : m_fan)
      m_link.push_back(s.to_first(m_map.uv[Mesh::next(s.h)]));

    // The kernel of the link: its bounding box, clipped by the left sides of all link edges.
    double x0 = HUGE_VAL, x1 = -HUGE_VAL, y0 = HUGE_VAL, y1 = -HUGE_VAL;
    for(const Point_2& q : m_link)
    {
      x0 = (std::min)(x0, q.x());
      x1 = (std::max)(x1, q.x());
      y0 = (std::min)(y0, q.y());
      y1 = (std::max)(y1, q.y());
    }
    const bool keep_x = keep_on_isolines && is_integer(p.x()), keep_y = keep_on_isolines && is_integer(p.y());
    if(keep_x)
      x0 = x1 = p.x();
    if(keep_y)
      y0 = y1 = p.y();
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
    m_old.clear();
    for(const Sector& s : m_fan)
      m_old.push_back(m_map.uv[s.h]);
    assign(c);
    // The clipping is done in floating point; what counts is this.
    const bool positive =
      std::all_of(m_fan.begin(), m_fan.end(), [&](const Sector& s) { return m_map.orientation_of_face(s.h / 3) > 0; });
    for(std::size_t i = 0; i < m_fan.size(); ++i)
    {
      if(positive)
        m_map.sign[m_fan[i].h / 3] = 1;
      else
        m_map.uv[m_fan[i].h] = m_old[i];
    }
    return positive;
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
