// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_ISOLINE_TRACER_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_ISOLINE_TRACER_H

#include <CGAL/Quad_meshing/Extraction/internal/Grid_nodes.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Follows grid lines over the surface, from a ray of one node to a ray of the next.
//
// A grid line is a level set of one coordinate. It is followed through triangles of either orientation: in a triangle
// it leaves by the side whose ends lie on different sides of the line, which does not
// depend on the orientation of the triangle; where it passes to a triangle of the other
// orientation, it runs back in the chart. `m_ahead` is the grid point the line runs to in the
// current chart, `m_behind` the one it runs from, and the current position is always between them.
// Every decision is a comparison of coordinates, but for one orientation test per triangle: whether the line
// reaches `m_ahead` before it leaves the triangle.
class Isoline_tracer
{
  typedef Grid_map::Point_2 Point_2;
  typedef Indexed_triangle_mesh Mesh;

public:
  enum
  {
    LEAVES_THE_SURFACE = -1,
    FAILED = -2
  };

  Isoline_tracer(const Grid_map& map, const Grid_nodes& nodes)
    : m_map(map), m_mesh(map.mesh), m_nodes(nodes), m_steps_left(bound_on_steps(map, nodes))
  {
  }

  // The ray at the other end of the grid line that starts with `ray`, `LEAVES_THE_SURFACE` if the line ends at
  // a border, `FAILED` if it cannot be followed, which happens only in maps that are not integer-grid maps.
  int operator()(int ray)
  {
    m_goal = 1;
    m_is_open[LEFT] = m_is_open[RIGHT] = false;
    for(;;)
    {
      start(ray);
      if(!follow())
        return FAILED;
      if(m_result < 0 || m_nodes.mate[m_result] == -1)
        return m_result;
      ray = m_nodes.mate[m_result];
      m_goal = 1 - m_goal;
    }
  }

  // The ray at which the grid line arrives that crosses halfedge h between the grid point `behind` and the next one in
  // direction d.
  int from_edge_point(int h, const Point_2& behind, int d)
  {
    m_goal = 1;
    m_d = d;
    m_behind = behind;
    m_ahead = neighbor(behind, d);
    if(side(m_map.uv[Mesh::next(h)]) > 0) // it runs out of the face of h, as that is on the left of h
      go_over(h);
    else
      go(FROM_EDGE, h);
    return follow() ? m_result : static_cast<int>(FAILED);
  }

  // How far the last line got: 1 if it ended at the grid point next to its start. If it ran back on a fold it may have
  // ended at another copy of the grid point where it started; this gives 0.
  int length() const { return m_goal; }

  // Whether the last line had the border of the surface on its left or right side somewhere: it ran along a border
  // edge, or passed a border vertex.
  bool is_open_on_left() const { return m_is_open[LEFT]; }
  bool is_open_on_right() const { return m_is_open[RIGHT]; }

private:
  // What the line does next. `m_h` is the halfedge meant, and its face is the one whose chart is in use.
  enum State
  {
    INSIDE,      // it is inside the face
    FROM_EDGE,   // it is on the halfedge, about to cross the face
    OUT_OF_EDGE, // it is inside the face, about to leave through the halfedge
    AT_CORNER,   // it is inside the face, about to pass through the source of the halfedge
    FROM_CORNER, // it is at the source of the halfedge, about to enter the sector
    ALONG,       // it runs along the halfedge
    BACK_ALONG,  // it runs along the halfedge from target to source
    DONE
  };

  // Where an arriving line looks back: a sector, and a direction in its chart.
  struct Way_back
  {
    int h;
    int d;
  };

  struct Fan_ray
  {
    int h;
    int d;
    int turned;
    int sign;
  };

  const Grid_map& m_map;
  const Mesh& m_mesh;
  const Grid_nodes& m_nodes;
  long long m_steps_left;

  State m_state;
  int m_h;
  int m_d; // heading
  Point_2 m_behind;
  Point_2 m_ahead;
  int m_result;
  enum
  {
    LEFT,
    RIGHT
  };
  bool m_is_open[2];
  int m_goal; // 1 if `m_ahead` is the grid point next to the start, 0 if it is the start

  std::vector<Fan_ray> m_fan;
  std::vector<int> m_live;

  // Every crossing of a grid line with an edge is passed at most once in either direction, unless
  // the map is so inconsistent that lines run in circles.
  static long long bound_on_steps(const Grid_map& map, const Grid_nodes& nodes)
  {
    double crossings = 0;
    for(int h = 0; h < map.mesh.number_of_halfedges(); ++h)
    {
      const Point_2& a = map.uv[h];
      const Point_2& b = map.uv[Mesh::next(h)];
      crossings +=
        std::fabs(std::floor(b.x()) - std::floor(a.x())) + std::fabs(std::floor(b.y()) - std::floor(a.y())) + 2;
    }
    return static_cast<long long>(4 * crossings) + 16 * static_cast<long long>(nodes.number_of_rays()) + 16;
  }

  double along(const Point_2& p) const { return coordinate(p, m_d); }

  // On which side of the line p is: 1 left, 0 on it, -1 right.
  int side(const Point_2& p) const { return sign_of_difference(coordinate(p, m_d + 1), coordinate(m_ahead, m_d + 1)); }

  static int sign_of_difference(double a, double b) { return (a > b) - (a < b); }

  static Point_2 neighbor(const Point_2& p, int d)
  {
    return point_from_coordinates<Point_2>(d, coordinate(p, d) + 1, coordinate(p, d + 1));
  }

  Way_back back_in(int h) const { return Way_back{ h, (m_d + 2) & 3 }; }
  static Way_back nowhere() { return Way_back{ -1, 0 }; }

  void go(State s, int h)
  {
    m_state = s;
    m_h = h;
  }
  void finish(int result)
  {
    m_state = DONE;
    m_result = result;
  }
  void turn_round()
  {
    m_d = (m_d + 2) & 3;
    m_goal = 1 - m_goal;
    std::swap(m_ahead, m_behind);
  }

  void start(int ray)
  {
    const int n = m_nodes.ray_node[ray], h = m_nodes.ray_halfedge[ray];
    m_d = m_nodes.ray_direction[ray];
    m_behind = m_nodes.point_of_ray(ray);
    m_ahead = neighbor(m_behind, m_d);
    if(m_nodes.is_on_vertex(n))
      go(FROM_CORNER, h);
    else if(!m_nodes.is_on_edge(n))
      go(INSIDE, h);
    else
    {
      const Point_2& a = m_map.uv[h];
      const Point_2& b = m_map.uv[Mesh::next(h)];
      if(side(a) != 0 || side(b) != 0)
        go(FROM_EDGE, h);
      else
        go(along(b) > along(a) ? ALONG : BACK_ALONG, h);
    }
  }

  bool follow()
  {
    while(m_state != DONE)
    {
      if(--m_steps_left < 0)
        return false;
      step();
    }
    return true;
  }

  void step()
  {
    switch(m_state)
    {
      case INSIDE: inside(); break;
      case FROM_EDGE: from_edge(); break;
      case OUT_OF_EDGE: out_of_edge(); break;
      case AT_CORNER: at_corner(); break;
      case FROM_CORNER: from_corner(); break;
      case ALONG: along_edge(m_h, Mesh::next(m_h), true); break;
      case BACK_ALONG: along_edge(m_h, m_h, false); break;
      case DONE: break;
    }
  }

  void inside()
  {
    const int h0 = m_h - m_h % 3, exit_side = m_map.is_reversed(m_h / 3) ? 1 : -1;
    for(int h = h0; h < h0 + 3; ++h)
    {
      const int s = side(m_map.uv[h]);
      if(s == 0 && along(m_map.uv[h]) > along(m_behind))
        return go(AT_CORNER, h);
      if(s == exit_side && side(m_map.uv[Mesh::next(h)]) == -s)
        return go(OUT_OF_EDGE, h);
    }
    finish(FAILED);
  }

  void from_edge()
  {
    const int left_over = Mesh::prev(m_h);
    const int s = side(m_map.uv[left_over]);
    if(s == 0)
      return go(AT_CORNER, left_over);
    go(OUT_OF_EDGE, s == side(m_map.uv[m_h]) ? Mesh::next(m_h) : left_over);
  }

  void out_of_edge()
  {
    const int f = m_h / 3;
    const Point_2& a = m_map.uv[m_h];
    const Point_2& b = m_map.uv[Mesh::next(m_h)];
    if(m_map.sign[f] != 0)
    {
      const int o = static_cast<int>(CGAL::orientation(a, b, m_ahead)) * m_map.sign[f];
      if(o > 0)
        return arrive_in_face(f);
      if(o == 0)
        return arrive(m_nodes.find_on_edge(m_h, m_ahead), back_in(m_h), nowhere());
    }
    go_over(m_h);
  }

  void go_over(int h)
  {
    const int f = h / 3, g = m_mesh.opposite[h];
    if(g == -1)
      return finish(LEAVES_THE_SURFACE);
    const Grid_automorphism& t = m_map.transition[h];
    m_behind = t(m_behind);
    m_ahead = t(m_ahead);
    m_d = t.direction(m_d);
    if(m_map.is_reversed(f) != m_map.is_reversed(g / 3))
      turn_round();
    go(FROM_EDGE, g);
  }

  void at_corner()
  {
    const double c = along(m_map.uv[m_h]), goal = along(m_ahead);
    if(c > goal)
      return arrive_in_face(m_h / 3);
    if(c == goal)
      return arrive(m_nodes.node_of_vertex[m_mesh.source(m_h)], back_in(m_h), nowhere());
    pass_through_vertex(back_in(m_h), nowhere());
  }

  void from_corner()
  {
    const Point_2& c = m_map.uv[m_h];
    const Point_2& right = m_map.uv[Mesh::next(m_h)];
    const Point_2& left = m_map.uv[Mesh::prev(m_h)];
    if(side(right) == 0 && along(right) > along(c))
      return go(ALONG, m_h);
    if(side(left) == 0 && along(left) > along(c))
      return go(BACK_ALONG, Mesh::prev(m_h));
    go(OUT_OF_EDGE, Mesh::next(m_h));
  }

  // The line runs along h to the corner at the source of `corner`.
  void along_edge(int h, int corner, bool forward)
  {
    // The edge is a side of two sectors, in the face of h and in the one beyond; the ray back belongs to one of them.
    const int beyond = m_mesh.opposite[h], turn = beyond == -1 ? 0 : m_map.transition[h].r;
    if(beyond == -1)
      m_is_open[forward ? RIGHT : LEFT] = true;
    const Point_2& target = m_map.uv[corner];
    const double c = along(target), goal = along(m_ahead);
    const Way_back here = { c > goal ? h : corner, (m_d + 2) & 3 };
    const Way_back there = { c > goal || forward ? beyond
                             : beyond == -1      ? -1
                                                 : Mesh::next(beyond),
                             (m_d + 2 + turn) & 3 };
    if(c > goal)
      arrive(m_nodes.find_on_edge(h, m_ahead), here, there);
    else if(c == goal)
      arrive(m_nodes.node_of_vertex[m_mesh.source(corner)], here, there);
    else
      pass_through_vertex(here, there);
  }

  void arrive_in_face(int f)
  {
    if(m_map.sign[f] == 0)
      finish(FAILED);
    else
      arrive(m_nodes.find_in_face(f, m_ahead), back_in(3 * f), nowhere());
  }

  void arrive(int node, const Way_back& here, const Way_back& there)
  {
    int r = node == -1 ? -1 : m_nodes.find_ray(node, here.h, here.d);
    if(r == -1 && node != -1 && there.h != -1)
      r = m_nodes.find_ray(node, there.h, there.d);
    finish(r == -1 ? static_cast<int>(FAILED) : r);
  }

  // The line arrives at a vertex that is no node, and looks back in one of the given ways. All rays of its two
  // directions there are paired as at a folded node; the two left over belong together.
  void pass_through_vertex(const Way_back& here, const Way_back& there)
  {
    const int h = here.h;
    m_fan.clear();
    int turned = 0, arrival = -1;
    for_each_corner_of_vertex(m_mesh, m_mesh.source(h),
                              [&](int g)
                              {
                                if(g != m_mesh.halfedge_of_vertex[m_mesh.source(h)])
                                  turned += m_map.transition[g].r;
                                for_each_direction_in_sector(
                                  m_map, g,
                                  [&](int e, int s)
                                  {
                                    if((g == here.h && e == here.d) || (arrival == -1 && g == there.h && e == there.d))
                                      arrival = static_cast<int>(m_fan.size());
                                    m_fan.push_back(Fan_ray{ g, e, (e + turned) & 3, s });
                                  });
                              });
    if(arrival == -1)
      return finish(FAILED);

    const int axis = m_fan[arrival].turned & 1;
    int n = 0, a = -1;
    for(std::size_t i = 0; i < m_fan.size(); ++i)
    {
      if((m_fan[i].turned & 1) != axis)
        continue;
      if(static_cast<int>(i) == arrival)
        a = n;
      m_fan[n++] = m_fan[i];
    }

    const bool on_border = m_mesh.previous_around_source(m_mesh.halfedge_of_vertex[m_mesh.source(h)]) == -1;
    int partner = -1;
    Grid_nodes::pair_opposite_signs(
      n, [&](int i) { return m_fan[i].sign; },
      [&](int i, int j)
      {
        if(i == a)
          partner = j;
        else if(j == a)
          partner = i;
      },
      m_live);
    if(partner == -1)
    {
      if(m_live.size() == 1 && on_border)
        return finish(LEAVES_THE_SURFACE);
      if(m_live.size() != 2)
        return finish(FAILED);
      partner = m_live[0] == a ? m_live[1] : m_live[0];
    }
    // The fan runs counterclockwise: from the way in to the way out on the right of the line, or the other way on its
    // left.
    if(on_border)
      m_is_open[a < partner ? LEFT : RIGHT] = true;

    if(m_fan[partner].turned == m_fan[a].turned)
      m_goal = 1 - m_goal;
    const Point_2& p = m_map.uv[m_fan[partner].h];
    m_d = m_fan[partner].d;
    const double behind = std::floor(coordinate(p, m_d)), left = coordinate(p, m_d + 1);
    m_behind = point_from_coordinates<Point_2>(m_d, behind, left);
    m_ahead = point_from_coordinates<Point_2>(m_d, behind + 1, left);
    go(FROM_CORNER, m_fan[partner].h);
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_ISOLINE_TRACER_H
