// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_LAYOUT_REALIZATION_H
#define CGAL_QUAD_MESHING_LAYOUT_LAYOUT_REALIZATION_H

#include <CGAL/Quad_meshing/Layout/Layout_quantization.h>
#include <CGAL/Quad_meshing/Layout/Motorcycle_complex.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The quad mesh that a motorcycle complex becomes when its arcs get other lengths. Positions are those at
// the same place in the rectangles of the input.
class Layout_realization
{
  typedef Indexed_quad_mesh::Point_3 Point_3;
  typedef Indexed_quad_mesh::Vector_3 Vector_3;
  typedef Motorcycle_complex::Patch Patch;
  typedef Motorcycle_complex::Piece Piece;

  const Indexed_quad_mesh& m_mesh;
  const Motorcycle_complex& m_complex;
  const std::vector<int>& m_length;
  Arc_subdivision m_subdivision;

public:
  // Whether vertices get their positions, or all the same.
  enum Kind
  {
    TOPOLOGY,
    GEOMETRY
  };

  Indexed_quad_mesh mesh;
  std::vector<int> origin; // per vertex: the vertex of the input that it is, -1 if it is none
  std::vector<int>
    side_of_edge;           // per edge of the subdivision: a halfedge of the mesh, for one of those that are the same
  bool is_closed_up = true; // whether all sides found their neighbours

  // `length` must live as long as the object.
  Layout_realization(const Indexed_quad_mesh& input, const Layout_quantization& quantization,
                     const std::vector<int>& length, const std::vector<char>& is_fixed, Kind kind = GEOMETRY)
    : m_mesh(input)
    , m_complex(quantization.complex())
    , m_length(length)
    , m_subdivision(quantization.subdivision(length))
    , m_kind(kind)
  {
    place_wall_points(quantization, is_fixed);
    side_of_edge.assign(m_subdivision.number_of_edges(), -1);
    for(const Patch& p : m_complex.patches)
      if(m_subdivision.side_length(p.sides[0]) > 0 && m_subdivision.side_length(p.sides[1]) > 0)
        fill(p);

    std::vector<char> is_border(m_subdivision.number_of_edges(), 0);
    for(std::size_t a = 0; a < length.size(); ++a)
      for(int i = 0; i < length[a]; ++i)
      {
        const Motorcycle_complex::Arc& arc = m_complex.arcs[a];
        const int e = m_subdivision.edges.smallest(m_subdivision.edge(static_cast<int>(a), i)), h = side_of_edge[e];
        is_border[e] |= arc.is_border;
        if(h != -1 && m_mesh.is_feature[arc.halfedges.front()])
          mesh.is_feature[h] = 1;
      }
    for(int e = 0; e < m_subdivision.number_of_edges(); ++e)
      if(side_of_edge[e] != -1)
      {
        const int h = side_of_edge[e], o = mesh.opposite[h];
        if(o == -1)
          is_closed_up = is_closed_up && is_border[e];
        else
          mesh.is_feature[o] = mesh.is_feature[h] = mesh.is_feature[h] | mesh.is_feature[o];
      }
    drop_unused_vertices();
    mesh.find_halfedges_of_vertices();
  }

private:
  Point_3 on_arc(int arc, double t) const
  {
    const std::vector<int>& halfedges = m_complex.arcs[arc].halfedges;
    const int i = (std::min)(static_cast<int>(t), static_cast<int>(halfedges.size()) - 1);
    const Point_3 &p = m_mesh.points[m_mesh.source(halfedges[i])], &q = m_mesh.points[m_mesh.target(halfedges[i])];
    return p + (t - i) * (q - p);
  }

  // Of the points that become one, those that may move least give the position.
  void place_wall_points(const Layout_quantization& quantization, const std::vector<char>& is_fixed)
  {
    const Quad_vertex_rules& rules = quantization.rules();
    const int n = m_subdivision.number_of_points();
    std::vector<int> weight(n, -1), number(n, 0), vertex(n, -1);
    std::vector<Vector_3> sum(n, Vector_3(0, 0, 0));
    auto add = [&](int point, int w, const Point_3& position, int v)
    {
      const int p = m_subdivision.points.smallest(point);
      if(w < weight[p])
        return;
      if(w > weight[p])
      {
        weight[p] = w;
        number[p] = 0;
        sum[p] = Vector_3(0, 0, 0);
        vertex[p] = v;
      }
      ++number[p];
      sum[p] = sum[p] + (position - ORIGIN);
    };
    const std::vector<int>& nodes = quantization.vertex_of_node();
    for(std::size_t i = 0; i < nodes.size(); ++i)
    {
      const int v = nodes[i];
      const int w = is_fixed[v]                                 ? 4
                    : rules.on_feature[v] || rules.on_border[v] ? 2 + rules.is_special[v]
                                                                : is_irregular(m_mesh, v);
      add(static_cast<int>(i), w, m_mesh.points[v], v);
    }
    for(std::size_t a = 0; a < m_length.size() && m_kind == GEOMETRY; ++a)
      for(int i = 1; i < m_length[a]; ++i)
        add(m_subdivision.point(static_cast<int>(a), i),
            m_complex.arcs[a].is_feature || m_complex.arcs[a].is_border ? 2 : 0,
            on_arc(static_cast<int>(a), double(i) * m_complex.arcs[a].length() / m_length[a]), -1);

    m_vertex_of_point.assign(n, -1);
    for(int p = 0; p < n; ++p)
      if(m_subdivision.points.smallest(p) == p)
      {
        m_vertex_of_point[p] = mesh.number_of_vertices();
        mesh.points.push_back(number[p] > 0 ? ORIGIN + sum[p] / number[p] : Point_3(ORIGIN));
        origin.push_back(vertex[p]);
      }
    for(int p = 0; p < n; ++p)
      m_vertex_of_point[p] = m_vertex_of_point[m_subdivision.points.smallest(p)];
  }

  // The position in the input of each point along a side, in its edges.
  std::vector<double> places_on(const std::vector<Piece>& side) const
  {
    std::vector<double> places(1, 0.);
    double at = 0;
    for(const Piece& s : side)
    {
      const int n = m_length[s.arc], l = m_complex.arcs[s.arc].length();
      // what vanishes between two arcs leaves its point in the middle
      if(n == 0 && places.size() > 1)
        places.back() += l / 2.;
      for(int i = 1; i <= n; ++i)
        places.push_back(at + double(l) * i / n);
      at += l;
    }
    places.back() = at;
    return places;
  }

  // A grid of quads in a rectangle.
  void fill(const Patch& p)
  {
    const int w = m_subdivision.side_length(p.sides[0]), h = m_subdivision.side_length(p.sides[1]);
    std::array<std::vector<double>, 4> place;
    std::array<std::vector<int>, 4> points, edges;
    for(int k = 0; k < 4; ++k)
    {
      if(m_kind == GEOMETRY)
        place[k] = places_on(p.sides[k]);
      m_subdivision.points_of(p.sides[k], points[k]);
      m_subdivision.edges_of(p.sides[k], edges[k]);
    }
    std::vector<int> vertex((w + 1) * (h + 1));
    for(int j = 0; j <= h; ++j)
      for(int i = 0; i <= w; ++i)
      {
        int& v = vertex[i + j * (w + 1)];
        if(j == 0)
          v = m_vertex_of_point[points[0][i]];
        else if(j == h)
          v = m_vertex_of_point[points[2][w - i]];
        else if(i == w)
          v = m_vertex_of_point[points[1][j]];
        else if(i == 0)
          v = m_vertex_of_point[points[3][h - j]];
        else
        {
          const double s = double(i) / w, t = double(j) / h;
          v = mesh.number_of_vertices();
          mesh.points.push_back(m_kind == TOPOLOGY ? Point_3(ORIGIN)
                                                   : inside(p, (1 - t) * place[0][i] + t * (p.width - place[2][w - i]),
                                                            (1 - s) * (p.height - place[3][h - j]) + s * place[1][j]));
          origin.push_back(-1);
        }
      }

    const int first = mesh.number_of_faces();
    for(int j = 0; j < h; ++j)
      for(int i = 0; i < w; ++i)
      {
        const int v = i + j * (w + 1), f = first + i + j * w;
        mesh.corners.push_back({ { vertex[v], vertex[v + 1], vertex[v + w + 2], vertex[v + w + 1] } });
        const int neighbor[4] = { j > 0 ? 4 * (f - w) + 2 : -1, i + 1 < w ? 4 * (f + 1) + 3 : -1,
                                  j + 1 < h ? 4 * (f + w) : -1, i > 0 ? 4 * (f - 1) + 1 : -1 };
        mesh.opposite.insert(mesh.opposite.end(), neighbor, neighbor + 4);
        mesh.is_feature.insert(mesh.is_feature.end(), 4, 0);
      }
    auto join = [&](int edge, int side)
    {
      int& other = side_of_edge[m_subdivision.edges.smallest(edge)];
      if(other == -1)
        other = side;
      else
      {
        is_closed_up = is_closed_up && mesh.opposite[other] == -1;
        mesh.opposite[other] = side;
        mesh.opposite[side] = other;
      }
    };
    for(int i = 0; i < w; ++i)
    {
      join(edges[0][i], 4 * (first + i));
      join(edges[2][i], 4 * (first + (h - 1) * w + w - 1 - i) + 2);
    }
    for(int j = 0; j < h; ++j)
    {
      join(edges[1][j], 4 * (first + j * w + w - 1) + 1);
      join(edges[3][j], 4 * (first + (h - 1 - j) * w) + 3);
    }
  }

  // Bilinear between the vertices of the input.
  Point_3 inside(const Patch& p, double u, double v) const
  {
    const int i = (std::min)((std::max)(static_cast<int>(u), 0), p.width - 1);
    const int j = (std::min)((std::max)(static_cast<int>(v), 0), p.height - 1);
    const double s = u - i, t = v - j;
    auto at = [&](int a, int b) { return m_mesh.points[p.vertices[a + b * (p.width + 1)]] - ORIGIN; };
    return ORIGIN + (1 - s) * (1 - t) * at(i, j) + s * (1 - t) * at(i + 1, j) + (1 - s) * t * at(i, j + 1) +
           s * t * at(i + 1, j + 1);
  }

  void drop_unused_vertices()
  {
    std::vector<int> number(mesh.number_of_vertices(), -1);
    for(const std::array<int, 4>& c : mesh.corners)
      for(int v : c)
        number[v] = 0;
    int n = 0;
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(number[v] == 0)
      {
        number[v] = n;
        mesh.points[n] = mesh.points[v];
        origin[n++] = origin[v];
      }
    mesh.points.resize(n);
    origin.resize(n);
    for(std::array<int, 4>& c : mesh.corners)
      for(int& v : c)
        v = number[v];
  }

  Kind m_kind;
  std::vector<int> m_vertex_of_point;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_LAYOUT_REALIZATION_H
