// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_VERTEX_SECTORS_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_VERTEX_SECTORS_H

#include <CGAL/Quad_meshing/Parameterization/internal/Seamless_coordinates.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The sectors around the vertices, and how many right angles the image of each has to span.
//
// A sector is a fan of corners between two aligned edges, or the whole star of a vertex that has none. A map
// whose triangles are all well oriented is injective around a vertex if and only if its sectors span these angles:
// without that, images can wind around a vertex twice.
struct Vertex_sectors
{
  struct Sector
  {
    int vertex;
    int quarters;               // right angles to be spanned
    bool is_anchored;           // whether it begins and ends at aligned edges
    bool is_irregular;          // whether the vertex is singular, or a corner of aligned edges
    std::vector<int> halfedges; // that leave the vertex, one per corner, counterclockwise
    int last; // anchored: the halfedge that arrives at the vertex along the last edge, in the last face
  };

  std::vector<Sector> list;
  std::vector<int> sector_of_corner; // per corner 3f+k; -1 where any angle will do

  // `quarters` per vertex: right angles around it, -1 where any will do.
  Vertex_sectors(const Seamless_coordinates& coordinates, const std::vector<int>& quarters,
                 const std::vector<bool>& is_aligned)
    : sector_of_corner(coordinates.charts.mesh.number_of_halfedges(), -1)
  {
    const Indexed_triangle_mesh& mesh = coordinates.charts.mesh;
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(quarters[v] != -1 && mesh.halfedge_of_vertex[v] != -1)
        add_sectors(v, coordinates, quarters[v], is_aligned);
    for(std::size_t s = 0; s < list.size(); ++s)
      for(int h : list[s].halfedges)
        sector_of_corner[h] = static_cast<int>(s);
  }

  static constexpr double right_angle = CGAL_PI / 2;

  // The angle of a triangle on the surface, at the source of halfedge h.
  static double angle_at_source(const Indexed_triangle_mesh& mesh, int h)
  {
    const auto a = mesh.vector(h), b = -mesh.vector(Indexed_triangle_mesh::prev(h));
    return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
  }

private:
  void add_sectors(int v, const Seamless_coordinates& coordinates, int quarters, const std::vector<bool>& is_aligned)
  {
    const Indexed_triangle_mesh& mesh = coordinates.charts.mesh;
    int start = mesh.halfedge_of_vertex[v];
    const bool on_border = mesh.opposite[start] == -1;
    if(!on_border) // begin at an aligned edge if there is one
    {
      int h = start;
      do
      {
        if(is_aligned[mesh.edge_of[h]])
        {
          start = h;
          break;
        }
        h = mesh.next_around_source(h);
      }
      while(h != start);
    }
    const std::size_t first = list.size();
    const bool anchored = is_aligned[mesh.edge_of[start]];
    int begin = 0; // quarter of the edge at which the sector begins, in the chart of the face after it
    int turned = 0, sum = 0;
    int h = start;
    do
    {
      if(h == start || is_aligned[mesh.edge_of[h]])
      {
        list.push_back(Sector{ v, 0, anchored, false, {}, -1 });
        begin = anchored ? coordinates.quarter_of(h) : 0;
        turned = 0;
      }
      list.back().halfedges.push_back(h);
      const int out = Indexed_triangle_mesh::prev(h);
      if(anchored && is_aligned[mesh.edge_of[out]])
      {
        const int end = coordinates.quarter_of(out) + 2; // seen from v
        const int k = Combed_charts::modulo_4(end - begin - turned);
        list.back().quarters = k == 0 ? 4 : k;
        list.back().last = out;
        sum += list.back().quarters;
      }
      if(mesh.opposite[out] != -1)
        turned += coordinates.charts.quarters_across(out);
      h = mesh.opposite[out];
    }
    while(h != -1 && h != start);
    if(!anchored)
      list.back().quarters = quarters;
    else if(sum != quarters) // a sector of more than a full turn: only one of them can be told by the sum
    {
      auto widest =
        std::max_element(list.begin() + first, list.end(),
                         [](const Sector& a, const Sector& b) { return a.halfedges.size() < b.halfedges.size(); });
      widest->quarters += quarters - sum;
    }
    bool regular = quarters == (on_border ? 2 : 4);
    for(std::size_t i = first; i < list.size(); ++i)
      regular = regular && (list.size() == first + 1 || list[i].quarters == 2);
    for(std::size_t i = first; i < list.size(); ++i)
      list[i].is_irregular = !regular;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_VERTEX_SECTORS_H
