// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_MOTORCYCLE_COMPLEX_H
#define CGAL_QUAD_MESHING_LAYOUT_MOTORCYCLE_COMPLEX_H

#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_vertex_rules.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A partition of a quad mesh into few rectangles that may meet in T-junctions (Eppstein, Goodrich, Kim,
// Tamstorf: Motorcycle graphs: canonical quad mesh partitioning, Computer Graphics Forum 27(5), 2008).
//
// All straight lines that start at irregular vertices grow at the same speed, and each ends where it meets
// another one. Unlike the base complex, the partition is small however badly the irregular vertices are
// aligned. Features and the border belong to its walls.
//
// The walls are cut into arcs at the nodes. Side k of a rectangle goes from corner k to corner k+1, the
// rectangle on its left.
struct Motorcycle_complex
{
  struct Arc
  {
    std::vector<int> halfedges; // from the first node to the second
    std::array<int, 2> nodes;   // as vertices of the mesh
    bool is_feature = false, is_border = false;
    std::array<int, 2> patch = { { -1, -1 } }; // on the left and on the right, -1 outside
    std::array<int, 2> side = { { -1, -1 } };  // the side of these patches that the arc is a part of

    int length() const { return static_cast<int>(halfedges.size()); }
  };

  struct Piece
  {
    int arc;
    bool forward; // the side runs along the arc, else against it
  };

  struct Patch
  {
    std::array<std::vector<Piece>, 4> sides;
    int width = 0, height = 0; // edges of side 0, of side 1
    std::vector<int> vertices; // (i, j) at i + j * (width + 1), i along side 0
  };

  std::vector<Arc> arcs;
  std::vector<Patch> patches;
  bool is_valid = true; // whether all patches are rectangles

  Motorcycle_complex(const Indexed_quad_mesh& mesh, const std::vector<char>& is_fixed)
    : m_mesh(mesh)
    , m_rules(make_quad_vertex_rules(mesh, false))
    , m_wall(mesh.number_of_halfedges(), 0)
    , m_visited(mesh.number_of_vertices(), 0)
    , m_is_node(mesh.number_of_vertices(), 0)
  {
    for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if(m_mesh.is_border(h) || m_mesh.is_feature[h])
        build_wall(h);
    std::vector<int> motorcycles;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_mesh.halfedge_of_vertex[v] != -1 && (m_rules.is_special[v] || is_fixed[v] || is_turn(v)))
        start(v, motorcycles);
    ride(motorcycles);

    // rings have no corners until they are cut open
    std::vector<int> bad = find_patches();
    for(int round = 0; !bad.empty() && round < m_mesh.number_of_faces(); ++round)
    {
      motorcycles.clear();
      for(int h : bad)
        start(m_mesh.source(h), motorcycles);
      if(motorcycles.empty())
        break;
      ride(motorcycles);
      bad = find_patches();
    }
    is_valid = bad.empty();
    if(is_valid)
    {
      find_arcs();
      join_patches_and_arcs();
    }
  }

private:
  void build_wall(int h)
  {
    m_wall[h] = 1;
    if(!m_mesh.is_border(h))
      m_wall[m_mesh.opposite[h]] = 1;
    m_visited[m_mesh.source(h)] = m_visited[m_mesh.target(h)] = 1;
  }

  // Whether walls meet in an inner regular vertex otherwise than crossing, touching or passing straight:
  // then a region around it has a reflex corner.
  bool is_turn(int v) const
  {
    if(!m_visited[v] || m_mesh.is_border_vertex(v))
      return false;
    int degree = 0;
    bool straight = false;
    const int first = m_mesh.halfedge_of_vertex[v];
    int h = first;
    do
    {
      degree += m_wall[h];
      straight = straight || (m_wall[h] && m_wall[m_mesh.next_around_source(m_mesh.next_around_source(h))]);
      h = m_mesh.next_around_source(h);
    }
    while(h != first);
    return degree == 1 || (degree == 2 && !straight);
  }

  // Motorcycles in all directions that have no wall yet.
  void start(int v, std::vector<int>& motorcycles)
  {
    m_visited[v] = m_is_node[v] = 1;
    const int first = m_mesh.halfedge_of_vertex[v];
    int h = first;
    do
    {
      if(!m_wall[h])
        motorcycles.push_back(h);
      h = m_mesh.next_around_source(h);
    }
    while(h != -1 && h != first);
  }

  void ride(std::vector<int> motorcycles)
  {
    std::vector<int> going_on;
    for(; !motorcycles.empty(); motorcycles.swap(going_on))
    {
      going_on.clear();
      for(int h : motorcycles)
      {
        if(m_wall[h])
          continue; // another one has come the other way
        const bool ends = m_visited[m_mesh.target(h)] != 0;
        build_wall(h);
        if(!ends)
          going_on.push_back(m_mesh.next(m_mesh.opposite[m_mesh.next(h)]));
      }
    }
  }

  // The edge that follows a wall edge on the same side of a rectangle, -1 at the corner.
  int next_on_side(int h) const
  {
    const int n = m_mesh.next(h);
    return m_wall[n] ? -1 : m_mesh.next(m_mesh.opposite[n]);
  }

  // Finds the rectangles; a halfedge of each region that is not one, on a wall if it has walls.
  std::vector<int> find_patches()
  {
    patches.clear();
    std::vector<int> bad, region;
    std::vector<char> seen(m_mesh.number_of_faces(), 0);
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      if(seen[f])
        continue;
      region.assign(1, f);
      seen[f] = 1;
      int corner = -1, wall = -1, corners = 0;
      for(std::size_t i = 0; i < region.size(); ++i)
        for(int h = 4 * region[i]; h < 4 * region[i] + 4; ++h)
          if(m_wall[h])
          {
            wall = wall == -1 ? h : wall;
            if(m_wall[m_mesh.prev(h)])
            {
              corner = corner == -1 ? h : corner;
              ++corners;
            }
          }
          else if(!seen[m_mesh.opposite[h] / 4])
          {
            seen[m_mesh.opposite[h] / 4] = 1;
            region.push_back(m_mesh.opposite[h] / 4);
          }
      Patch p;
      if(corners == 4 && fill_patch(corner, static_cast<int>(region.size()), p))
        patches.push_back(std::move(p));
      else
        bad.push_back(wall == -1 ? 4 * f : wall);
    }
    return bad;
  }

  // Walks around a region with four corners; false if it is not a rectangle after all.
  bool fill_patch(int corner, int number_of_faces, Patch& p)
  {
    std::array<int, 4> length;
    int h = corner;
    for(int k = 0; k < 4; ++k)
    {
      p.sides[k].assign(1, Piece{ h, true }); // its first halfedge, until there are arcs
      length[k] = 1;
      for(int ahead; (ahead = next_on_side(h)) != -1; h = ahead)
        if(!m_wall[ahead] || ++length[k] > number_of_faces)
          return false;
      h = m_mesh.next(h);
    }
    p.width = length[0];
    p.height = length[1];
    if(h != corner || length[2] != p.width || length[3] != p.height || p.width * p.height != number_of_faces)
      return false;

    p.vertices.resize((p.width + 1) * (p.height + 1));
    int row = corner;
    for(int j = 0; j < p.height; ++j)
    {
      int g = row;
      for(int i = 0; i < p.width; ++i)
      {
        p.vertices[i + j * (p.width + 1)] = m_mesh.source(g);
        p.vertices[i + 1 + j * (p.width + 1)] = m_mesh.target(g);
        p.vertices[i + 1 + (j + 1) * (p.width + 1)] = m_mesh.target(m_mesh.next(g));
        p.vertices[i + (j + 1) * (p.width + 1)] = m_mesh.source(m_mesh.prev(g));
        if(i + 1 < p.width)
          g = m_mesh.next(m_mesh.opposite[m_mesh.next(g)]);
      }
      if(j + 1 < p.height)
        row = m_mesh.opposite[m_mesh.across(row)];
    }
    return true;
  }

  // Nodes are where walls end, turn, touch or cross, where motorcycles start, and where features on the border end.
  void find_arcs()
  {
    std::vector<int> degree(m_mesh.number_of_vertices(), 0);
    for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if(m_wall[h])
      {
        if(m_mesh.edge(h) == h)
        {
          ++degree[m_mesh.source(h)];
          ++degree[m_mesh.target(h)];
        }
        const int ahead = next_on_side(h);
        if(ahead == -1)
          m_is_node[m_mesh.target(h)] = 1; // a corner
        else if(m_mesh.is_border(h) && m_mesh.is_feature[h] != m_mesh.is_feature[ahead])
          m_is_node[m_mesh.target(h)] = 1;
      }
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(degree[v] > 2)
        m_is_node[v] = 1;

    m_arc.assign(m_mesh.number_of_halfedges(), -1);
    for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if(m_wall[h] && m_arc[h] == -1 && m_is_node[m_mesh.source(h)])
      {
        Arc a;
        for(int g = h;; g = next_on_side(g))
        {
          m_arc[g] = static_cast<int>(arcs.size());
          if(!m_mesh.is_border(g))
            m_arc[m_mesh.opposite[g]] = static_cast<int>(arcs.size());
          a.halfedges.push_back(g);
          if(m_is_node[m_mesh.target(g)])
            break;
        }
        a.nodes = { { m_mesh.source(h), m_mesh.target(a.halfedges.back()) } };
        a.is_border = m_mesh.is_border(h);
        a.is_feature = m_mesh.is_feature[h] && !a.is_border;
        arcs.push_back(std::move(a));
      }
  }

  void join_patches_and_arcs()
  {
    for(std::size_t p = 0; p < patches.size(); ++p)
      for(int k = 0; k < 4; ++k)
      {
        std::vector<Piece> pieces;
        for(int h = patches[p].sides[k][0].arc; h != -1; h = next_on_side(h))
          if(m_is_node[m_mesh.source(h)])
          {
            Arc& a = arcs[m_arc[h]];
            const bool forward = a.halfedges.front() == h;
            a.patch[!forward] = static_cast<int>(p);
            a.side[!forward] = k;
            pieces.push_back(Piece{ m_arc[h], forward });
          }
        patches[p].sides[k].swap(pieces);
      }
  }

  const Indexed_quad_mesh& m_mesh;
  Quad_vertex_rules m_rules;
  std::vector<char> m_wall;               // per halfedge
  std::vector<char> m_visited, m_is_node; // per vertex
  std::vector<int> m_arc;                 // per halfedge
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_MOTORCYCLE_COMPLEX_H
