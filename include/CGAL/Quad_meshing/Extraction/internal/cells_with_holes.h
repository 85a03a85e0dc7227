// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_CELLS_WITH_HOLES_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_CELLS_WITH_HOLES_H

#include <CGAL/Quad_meshing/Extraction/internal/Grid_graph.h>
#include <CGAL/Quad_meshing/Extraction/internal/Isoline_tracer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Finds the grid cells with a whole border loop inside, which the cycles of the graph do not show: the cell looks
// like any other. Either the loop touches the boundary of the cell somewhere, which the tracing of that edge has
// noticed, or no grid line meets it at all.
class Cells_with_holes
{
public:
  Cells_with_holes(const Grid_map& map, const Grid_nodes& nodes, const Grid_graph& graph)
    : m_map(map), m_mesh(map.mesh), m_trace(map, nodes), m_graph(graph)
  {
  }

  // The faces of the graph, in no particular order, perhaps with repetitions.
  std::vector<int> operator()()
  {
    std::vector<int> cells;
    for(int r = 0; r < m_graph.number_of_rays(); ++r)
      if(m_graph.open_on_left[r] && m_graph.face[r] >= 0)
        cells.push_back(m_graph.face[r]);
    std::vector<char> seen(m_mesh.number_of_halfedges(), false);
    std::vector<int> loop;
    for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
    {
      if(m_mesh.opposite[h] != -1 || seen[h])
        continue;
      loop.clear();
      bool inside = true;
      int g = h;
      do
      {
        seen[g] = true;
        loop.push_back(m_mesh.source(g));
        inside &= is_inside_cell(g);
        g = next_on_border(g);
      }
      while(g != h);
      const int cell = inside ? cell_around(loop) : -1;
      if(cell >= 0)
        cells.push_back(cell);
    }
    return cells;
  }

private:
  typedef Grid_map::Point_2 Point_2;
  typedef Indexed_triangle_mesh Mesh;

  const Grid_map& m_map;
  const Mesh& m_mesh;
  Isoline_tracer m_trace;
  const Grid_graph& m_graph;

  int next_on_border(int h) const
  {
    h = Mesh::next(h);
    while(m_mesh.opposite[h] != -1)
      h = Mesh::next(m_mesh.opposite[h]);
    return h;
  }

  // Whether the whole edge lies in one open grid cell.
  bool is_inside_cell(int h) const
  {
    const Point_2& a = m_map.uv[h];
    const Point_2& b = m_map.uv[Mesh::next(h)];
    return !is_integer(a.x()) && !is_integer(a.y()) && !is_integer(b.x()) && !is_integer(b.y()) &&
           std::floor(a.x()) == std::floor(b.x()) && std::floor(a.y()) == std::floor(b.y());
  }

  // Walks over the edges inside the cell until one leaves it, and along the grid line met there.
  int cell_around(std::vector<int> vertices)
  {
    std::vector<int> sorted(vertices);
    std::sort(sorted.begin(), sorted.end());
    auto is_new = [&](int v)
    {
      const auto it = std::lower_bound(sorted.begin(), sorted.end(), v);
      if(it != sorted.end() && *it == v)
        return false;
      sorted.insert(it, v);
      return true;
    };
    int cell = -1;
    for(std::size_t i = 0; i < vertices.size() && cell == -1; ++i)
      for_each_corner_of_vertex(m_mesh, vertices[i],
                                [&](int h)
                                {
                                  if(is_inside_cell(h))
                                  {
                                    if(is_new(m_mesh.target(h)))
                                      vertices.push_back(m_mesh.target(h));
                                  }
                                  else if(cell == -1)
                                    cell = cell_left_by(h);
                                });
    return cell;
  }

  // The cell that contains the source of h, found where h leaves it; -1 if h leaves it at a corner, if its end lies
  // just on the grid line, or if the cell is open to the border.
  int cell_left_by(int h)
  {
    const Point_2& p = m_map.uv[h];
    const Point_2& q = m_map.uv[Mesh::next(h)];
    const double x = std::floor(p.x()), y = std::floor(p.y());
    const int sx = (q.x() >= x + 1) - (q.x() <= x), sy = (q.y() >= y + 1) - (q.y() <= y);
    const double line_x = sx > 0 ? x + 1 : x, line_y = sy > 0 ? y + 1 : y;

    bool over_x = sx != 0;
    if(sx != 0 && sy != 0)
    {
      const int o = static_cast<int>(CGAL::orientation(p, q, Point_2(line_x, line_y))) * sx * sy;
      if(o == 0)
        return -1;
      over_x = o > 0;
    }
    if(over_x ? q.x() == line_x : q.y() == line_y)
      return -1;

    // The direction of the grid line that has the cell on its left.
    const int d = over_x ? (sx > 0 ? 1 : 3) : (sy > 0 ? 2 : 0);
    const Point_2 behind = over_x ? Point_2(line_x, sx > 0 ? y : y + 1) : Point_2(sy > 0 ? x + 1 : x, line_y);
    const int r = m_trace.from_edge_point(h, behind, d);
    return r < 0 || m_graph.opposite[r] < 0 ? -1 : m_graph.face[m_graph.opposite[r]];
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_CELLS_WITH_HOLES_H
