// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_NODES_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_NODES_H

#include <CGAL/Quad_meshing/Extraction/internal/Grid_map.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The grid points of a grid map, and the rays that leave them along the grid lines.
//
// Nodes are numbered: first those on mesh vertices, then those inside edges (by edge, from the
// source of `halfedge_of_edge` on), then those inside faces (by face, by y, then by x).
//
// A ray belongs to one sector of its node. `ray_halfedge` names that sector: the halfedge that leaves
// the vertex, or the halfedge of the edge in the face the ray enters, or the first halfedge of the
// face; `ray_direction` is relative to the chart of the face of that halfedge. A ray that runs along an edge belongs to
// the sector on its left, at a border with no sector there to the one on its right. The rays of a node
// are consecutive, in counterclockwise order on the surface.
//
// Where faces are folded over, the directions around a node run forth and back. Rays that undo each other are
// paired by `mate`: a grid line that arrives at one leaves by the other, as if the node was not
// there. All other rays have mate -1.
class Grid_nodes
{
public:
  typedef Grid_map::Point_2 Point_2;

  std::vector<int> node_halfedge;  // per node: see `ray_halfedge`
  std::vector<Point_2> node_point; // per node: its image in the chart of the face of `node_halfedge`
  std::vector<int> first_ray;      // per node, and one more
  std::vector<char> on_border;     // per node

  std::vector<int> ray_node;
  std::vector<int> ray_halfedge;
  std::vector<signed char> ray_direction;
  std::vector<signed char> ray_sign; // orientation of the sector
  std::vector<int> mate;

  std::vector<int> node_of_vertex; // per mesh vertex: its node, or -1
  std::vector<int> first_on_edge;  // per edge, and one more: its first node
  std::vector<int> first_in_face;  // per face, and one more: its first node

  // Not to be used if the visitor stops it.
  Grid_nodes(const Grid_map& map, Stage_progress& progress) : m_map(map), m_mesh(map.mesh), m_progress(progress)
  {
    collect_on_vertices();
    collect_on_edges();
    collect_in_faces();
    make_rays();
  }

  int number_of_nodes() const { return static_cast<int>(node_halfedge.size()); }
  int number_of_rays() const { return static_cast<int>(ray_node.size()); }
  bool is_on_vertex(int n) const { return n < first_on_edge.front(); }
  bool is_on_edge(int n) const { return !is_on_vertex(n) && n < first_in_face.front(); }

  // The image of the node of a ray in the chart of the ray.
  Point_2 point_of_ray(int ray) const
  {
    const int n = ray_node[ray], h = ray_halfedge[ray];
    if(is_on_vertex(n))
      return m_map.uv[h];
    return h == node_halfedge[n] ? node_point[n] : m_map.transition[node_halfedge[n]](node_point[n]);
  }

  // The node inside the edge of h at p, a point in the chart of face(h); -1 if there is none.
  int find_on_edge(int h, const Point_2& p) const
  {
    const int e = m_mesh.edge_of[h], primary = m_mesh.halfedge_of_edge[e];
    const Point_2 q = (h == primary) ? p : m_map.transition[h](p);
    const Point_2& a = m_map.uv[primary];
    const Point_2& b = m_map.uv[Mesh::next(primary)];
    const int d = along_axis(a, b);
    return find(first_on_edge[e], first_on_edge[e + 1], q,
                [d](const Point_2& s, const Point_2& t) { return coordinate(s, d) < coordinate(t, d); });
  }

  // The node inside face f at p; -1 if there is none.
  int find_in_face(int f, const Point_2& p) const
  {
    return find(first_in_face[f], first_in_face[f + 1], p,
                [](const Point_2& s, const Point_2& t) { return s.y() < t.y() || (s.y() == t.y() && s.x() < t.x()); });
  }

  // The ray of node n in the sector of h with direction d; -1 if there is none.
  int find_ray(int n, int h, int d) const
  {
    for(int r = first_ray[n]; r < first_ray[n + 1]; ++r)
      if(ray_halfedge[r] == h && ray_direction[r] == d)
        return r;
    return -1;
  }

  // Pairs the members of a sequence of signs that undo each other. Those left over, in `left`, have
  // one sign. In a cyclic sequence it does not matter where one starts: what is paired is always
  // what has nothing unpaired in between.
  template <typename SignOf, typename Pair>
  static void pair_opposite_signs(int n, const SignOf& sign, const Pair& pair, std::vector<int>& left)
  {
    left.clear();
    for(int i = 0; i < n; ++i)
    {
      if(!left.empty() && sign(left.back()) != sign(i))
      {
        pair(left.back(), i);
        left.pop_back();
      }
      else
        left.push_back(i);
    }
  }

private:
  typedef Indexed_triangle_mesh Mesh;

  const Grid_map& m_map;
  const Mesh& m_mesh;
  Stage_progress& m_progress;

  static constexpr int nodes_per_report = 0x8000; // each takes about a microsecond

  template <typename Less>
  int find(int first, int last, const Point_2& p, const Less& less) const
  {
    const auto begin = node_point.begin();
    const auto it = std::lower_bound(begin + first, begin + last, p, less);
    return it != begin + last && *it == p ? static_cast<int>(it - begin) : -1;
  }

  // The direction in which a segment extends farthest.
  static int along_axis(const Point_2& a, const Point_2& b)
  {
    const double dx = b.x() - a.x(), dy = b.y() - a.y();
    if(std::fabs(dx) >= std::fabs(dy))
      return dx >= 0 ? 0 : 2;
    return dy >= 0 ? 1 : 3;
  }

  void add_node(int h, const Point_2& p)
  {
    node_halfedge.push_back(h);
    node_point.push_back(p);
  }

  void collect_on_vertices()
  {
    node_of_vertex.assign(m_mesh.number_of_vertices(), -1);
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      const int h = m_mesh.halfedge_of_vertex[v];
      if(h == -1 || !m_map.is_integer_corner(h))
        continue;
      node_of_vertex[v] = number_of_nodes();
      add_node(h, m_map.uv[h]);
    }
  }

  void collect_on_edges()
  {
    first_on_edge.reserve(m_mesh.number_of_edges() + 1);
    Small_steps steps(m_progress, nodes_per_report);
    for(int e = 0; e < m_mesh.number_of_edges() && steps.go_further(); ++e)
    {
      first_on_edge.push_back(number_of_nodes());
      const int h = m_mesh.halfedge_of_edge[e];
      const Point_2& a = m_map.uv[h];
      const Point_2& b = m_map.uv[Mesh::next(h)];

      // Walk over the integers of the coordinate that changes less, unless it does not change at all:
      // along it the grid points are as sparse as they can be.
      const double ex = std::fabs(b.x() - a.x()), ey = std::fabs(b.y() - a.y());
      if(ex == 0 && ey == 0)
        continue;
      const bool aligned = ex == 0 || ey == 0;
      const int d = aligned ? along_axis(a, b) : ex < ey ? (b.x() > a.x() ? 0 : 2) : (b.y() > a.y() ? 1 : 3);
      const double a0 = coordinate(a, d), b0 = coordinate(b, d), a1 = coordinate(a, d + 1), b1 = coordinate(b, d + 1);
      if(aligned && !is_integer(a1))
        continue;
      for(double t = std::floor(a0) + 1; t < b0; ++t)
      {
        const double s = aligned ? a1 : std::floor(a1 + (t - a0) * ((b1 - a1) / (b0 - a0)) + 0.5);
        const Point_2 p = point_from_coordinates<Point_2>(d, t, s);
        if(aligned || CGAL::collinear(a, b, p))
          add_node(h, p);
      }
    }
    first_on_edge.push_back(number_of_nodes());
  }

  void collect_in_faces()
  {
    first_in_face.reserve(m_mesh.number_of_faces() + 1);
    Small_steps steps(m_progress, nodes_per_report);
    for(int f = 0; f < m_mesh.number_of_faces() && steps.go_further(); ++f)
    {
      first_in_face.push_back(number_of_nodes());
      const int s = m_map.sign[f];
      if(s == 0)
        continue;
      const Point_2* c = &m_map.uv[3 * f];
      const double y0 = (std::min)((std::min)(c[0].y(), c[1].y()), c[2].y());
      const double y1 = (std::max)((std::max)(c[0].y(), c[1].y()), c[2].y());
      auto inside = [&](double x, double y)
      {
        const Point_2 p(x, y);
        for(int k = 0; k < 3; ++k)
          if(static_cast<int>(CGAL::orientation(c[k], c[(k + 1) % 3], p)) != s)
            return false;
        return true;
      };

      for(double y = std::floor(y0) + 1; y < y1 && steps.go_further(); ++y)
      {
        // The interval of the row in floating point, one point wider than that on either side; both ends are then moved
        // inward by exact tests. What lies between two points inside is inside.
        double lo = HUGE_VAL, hi = -HUGE_VAL;
        for(int k = 0; k < 3; ++k)
        {
          const Point_2& p = c[k];
          const Point_2& q = c[(k + 1) % 3];
          if((p.y() < y && q.y() < y) || (p.y() > y && q.y() > y) || p.y() == q.y())
            continue;
          const double x = p.x() + (y - p.y()) * ((q.x() - p.x()) / (q.y() - p.y()));
          lo = (std::min)(lo, x);
          hi = (std::max)(hi, x);
        }
        double x0 = std::ceil(lo) - 1, x1 = std::floor(hi) + 1;
        while(x0 <= x1 && !inside(x0, y))
          ++x0;
        while(x0 <= x1 && !inside(x1, y))
          --x1;
        for(double x = x0; x <= x1; ++x)
          add_node(3 * f, Point_2(x, y));
      }
    }
    first_in_face.push_back(number_of_nodes());
  }

  void add_ray(int h, int d, int s)
  {
    ray_node.push_back(static_cast<int>(first_ray.size()) - 1);
    ray_halfedge.push_back(h);
    ray_direction.push_back(static_cast<signed char>(d));
    ray_sign.push_back(static_cast<signed char>(s));
  }

  // The rays in the sector of halfedge h. Returns whether it is negative.
  bool add_rays_at_corner(int h)
  {
    for_each_direction_in_sector(m_map, h, [&](int d, int s) { add_ray(h, d, s); });
    return m_map.is_reversed(h / 3);
  }

  // The rays on the side of halfedge h at a point inside it. Returns whether that side is negative.
  bool add_rays_at_edge(int h)
  {
    const Point_2& a = m_map.uv[h];
    const Point_2& b = m_map.uv[Mesh::next(h)];
    const bool closed = m_mesh.opposite[h] == -1;
    const int sign = m_map.sign[h / 3];
    // Seen from the point, the right side points to b and the left side away from it.
    const Point_2 o(0, 0), along(sign_of(b.x() - a.x()), sign_of(b.y() - a.y())), back(-along.x(), -along.y());
    for_each_direction_in_sector(o, along, back, sign, closed, [&](int d, int s) { add_ray(h, d, s); });
    return sign < 0;
  }

  void make_rays()
  {
    const std::size_t n = node_halfedge.size();
    first_ray.reserve(n + 1);
    on_border.assign(n, 0);
    for(auto* v : { &ray_node, &ray_halfedge })
      v->reserve(4 * n);
    ray_direction.reserve(4 * n);
    ray_sign.reserve(4 * n);

    std::vector<int> folded;
    Small_steps steps(m_progress, nodes_per_report);
    for(int i = 0; i < static_cast<int>(n) && steps.go_further(); ++i)
    {
      first_ray.push_back(number_of_rays());
      const int h = node_halfedge[i];
      bool is_folded = false;
      if(is_on_vertex(i))
      {
        const int v = m_mesh.source(h);
        on_border[i] = m_mesh.previous_around_source(h) == -1;
        for_each_corner_of_vertex(m_mesh, v, [&](int g) { is_folded |= add_rays_at_corner(g); });
      }
      else if(is_on_edge(i))
      {
        const int o = m_mesh.opposite[h];
        on_border[i] = o == -1;
        is_folded = add_rays_at_edge(h);
        if(o != -1)
          is_folded |= add_rays_at_edge(o);
      }
      else
      {
        const bool reversed = m_map.is_reversed(h / 3);
        for(int d = 0; d < 4; ++d)
          add_ray(h, reversed ? (4 - d) & 3 : d, reversed ? -1 : 1);
      }
      if(is_folded)
        folded.push_back(i);
    }
    first_ray.push_back(number_of_rays());

    if(m_progress.is_stopped())
      return;
    mate.assign(number_of_rays(), -1);
    std::vector<int> left;
    for(int i : folded)
    {
      const int r0 = first_ray[i];
      pair_opposite_signs(
        first_ray[i + 1] - r0, [&](int k) { return ray_sign[r0 + k]; },
        [&](int k, int l)
        {
          mate[r0 + k] = r0 + l;
          mate[r0 + l] = r0 + k;
        },
        left);
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_GRID_NODES_H
