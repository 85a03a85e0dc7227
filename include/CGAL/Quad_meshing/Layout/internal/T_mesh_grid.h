// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_T_MESH_GRID_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_T_MESH_GRID_H

#include <CGAL/Quad_meshing/Layout/internal/Collapsed_t_mesh.h>
#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The quads of a T-mesh whose arcs have integer lengths: a grid in every patch. The lengths must have no conflicts.
class T_mesh_grid
{
public:
  struct Quad
  {
    std::array<int, 4> points; // counterclockwise
    int patch;
  };

  // Where a patch with inner points begins to number them.
  struct Block
  {
    int first;
    int width, height;
  };

  struct Aligned_edge
  {
    std::array<int, 2> points;
    int arc;
  };

  std::vector<Quad> quads;
  std::vector<Block> blocks; // per patch
  std::vector<Aligned_edge> aligned_edges;
  int number_of_points = 0; // of the T-mesh, and inside patches
  Collapsed_t_mesh collapsed;

  T_mesh_grid(const T_mesh& t, const std::vector<int>& length) : collapsed(t, length)
  {
    number_of_points = collapsed.number_of_points();
    for(std::size_t p = 0; p < t.patches.size(); ++p)
    {
      const int i = static_cast<int>(p);
      blocks.push_back({ number_of_points, collapsed.length(i, 0), collapsed.length(i, 1) });
      add_quads(i);
      number_of_points += (std::max)(0, blocks[p].width - 1) * (std::max)(0, blocks[p].height - 1);
    }
    for(std::size_t a = 0; a < t.arcs.size(); ++a)
      if(t.arcs[a].is_aligned)
        for(int i = 0; i < length[a]; ++i)
          aligned_edges.push_back({ { { representative(collapsed.point(2 * static_cast<int>(a), i)),
                                        representative(collapsed.point(2 * static_cast<int>(a), i + 1)) } },
                                    static_cast<int>(a) });
  }

  // The point that a point of the T-mesh has become.
  int representative(int point)
  {
    return point < collapsed.number_of_points() ? collapsed.representative(point) : point;
  }

  // Arcs that have to become longer before the quads form a mesh: two edges join the same two vertices, or a quad has a
  // vertex twice.
  std::vector<int> defects() const
  {
    std::map<std::pair<int, int>, int> side_of; // directed edges: 4 * quad + side
    std::vector<int> arcs;
    const auto lengthen = [&](int side) { arcs.push_back(collapsed.longest_arc(quads[side / 4].patch, side & 3)); };
    for(std::size_t q = 0; q < quads.size(); ++q)
      for(int k = 0; k < 4; ++k)
      {
        const int a = quads[q].points[k], b = quads[q].points[(k + 1) % 4], side = 4 * static_cast<int>(q) + k;
        if(a == b)
          lengthen(side);
        if(a == quads[q].points[(k + 2) % 4])
        {
          lengthen(side);
          lengthen(4 * static_cast<int>(q) + (k + 1) % 4);
        }
        const auto known = side_of.emplace(std::make_pair(a, b), side);
        if(!known.second)
        {
          lengthen(side);
          lengthen(known.first->second);
        }
      }
    // Where two edges join the same vertices, one of their directions occurs twice, unless both lie on the border.
    std::map<std::pair<int, int>, int> arc_of; // undirected edges
    for(const Aligned_edge& e : aligned_edges)
    {
      const auto known = arc_of.emplace(std::minmax(e.points[0], e.points[1]), e.arc);
      if(!known.second)
      {
        arcs.push_back(e.arc);
        arcs.push_back(known.first->second);
      }
    }
    std::sort(arcs.begin(), arcs.end());
    arcs.erase(std::unique(arcs.begin(), arcs.end()), arcs.end());
    return arcs;
  }

private:
  void add_quads(int p)
  {
    const Block& b = blocks[p];
    if(b.width == 0 || b.height == 0)
      return;
    std::array<std::vector<int>, 4> side;
    for(int k = 0; k < 4; ++k)
    {
      side[k] = collapsed.points(p, k);
      for(int& i : side[k])
        i = representative(i);
    }
    const auto point = [&](int i, int j)
    {
      if(j == 0)
        return side[0][i];
      if(i == b.width)
        return side[1][j];
      if(j == b.height)
        return side[2][b.width - i];
      if(i == 0)
        return side[3][b.height - j];
      return b.first + (j - 1) * (b.width - 1) + i - 1;
    };
    for(int j = 0; j < b.height; ++j)
      for(int i = 0; i < b.width; ++i)
        quads.push_back({ { { point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1) } }, p });
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_T_MESH_GRID_H
