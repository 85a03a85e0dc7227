// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CUT_GRAPH_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CUT_GRAPH_H

#include <CGAL/Quad_meshing/internal/Distance_front.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/number_utils.h>

#include <queue>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The edges along which every component of a triangle mesh opens to a topological disk that has all
// singular vertices on its border [Bom12, 8.4, "Cutting the mesh"]: what a dual spanning
// tree does not cross, shortened by removing dangling paths, and shortest paths from there to the
// singular vertices. Border edges are not marked; they are open already.
class Cut_graph
{
public:
  Cut_graph(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_singular)
    : m_mesh(mesh), m_cut(mesh.number_of_edges(), false), m_on_cut(mesh.number_of_vertices(), false)
  {
    number_components();
    cut_what_the_dual_tree_leaves();
    remove_dangling_paths();
    connect_singular_vertices(is_singular);
  }

  const std::vector<bool>& is_cut() const { return m_cut; }
  const std::vector<int>& component_of_face() const { return m_component; }
  int number_of_components() const { return static_cast<int>(m_first_face.size()); }

private:
  const Indexed_triangle_mesh& m_mesh;
  std::vector<bool> m_cut;       // per edge
  std::vector<bool> m_on_cut;    // per vertex: on a cut edge or on the border
  std::vector<int> m_component;  // per face
  std::vector<int> m_first_face; // per component

  void number_components()
  {
    m_component.assign(m_mesh.number_of_faces(), -1);
    std::vector<int> stack;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      if(m_component[f] != -1)
        continue;
      const int c = number_of_components();
      m_first_face.push_back(f);
      m_component[f] = c;
      stack.push_back(f);
      while(!stack.empty())
      {
        const int g = stack.back();
        stack.pop_back();
        for(int h = 3 * g; h < 3 * g + 3; ++h)
        {
          const int o = m_mesh.opposite[h];
          if(o != -1 && m_component[o / 3] == -1)
          {
            m_component[o / 3] = c;
            stack.push_back(o / 3);
          }
        }
      }
    }
  }

  void cut_what_the_dual_tree_leaves()
  {
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      m_cut[e] = !m_mesh.is_border_edge(e);
    std::vector<bool> reached(m_mesh.number_of_faces(), false);
    std::queue<int> front; // breadth first, so that the disk is round and the cut short
    for(int f : m_first_face)
    {
      reached[f] = true;
      front.push(f);
      while(!front.empty())
      {
        const int g = front.front();
        front.pop();
        for(int h = 3 * g; h < 3 * g + 3; ++h)
        {
          const int o = m_mesh.opposite[h];
          if(o == -1 || reached[o / 3])
            continue;
          reached[o / 3] = true;
          m_cut[m_mesh.edge_of[h]] = false;
          front.push(o / 3);
        }
      }
    }
  }

  // Border edges belong to the border of the disk, so a path that ends on the border does not dangle
  // as long as it connects two border loops or closes a cycle with one; counting border edges as
  // incident edges of the graph says just that.
  void remove_dangling_paths()
  {
    std::vector<int> degree(m_mesh.number_of_vertices(), 0);
    std::vector<std::vector<int>> incident(m_mesh.number_of_vertices());
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
    {
      if(!m_cut[e] && !m_mesh.is_border_edge(e))
        continue;
      const int h = m_mesh.halfedge_of_edge[e];
      for(int v : { m_mesh.source(h), m_mesh.target(h) })
      {
        ++degree[v];
        incident[v].push_back(e);
      }
    }
    std::vector<int> leaves;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(degree[v] == 1)
        leaves.push_back(v);
    while(!leaves.empty())
    {
      const int v = leaves.back();
      leaves.pop_back();
      for(int e : incident[v])
      {
        if(!m_cut[e])
          continue;
        m_cut[e] = false;
        const int h = m_mesh.halfedge_of_edge[e];
        const int w = m_mesh.source(h) == v ? m_mesh.target(h) : m_mesh.source(h);
        --degree[v];
        if(--degree[w] == 1)
          leaves.push_back(w);
      }
    }
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      m_on_cut[v] = degree[v] > 0;
  }

  // One Dijkstra search per singular vertex, all of them growing from the graph: the search starts at
  // the singular vertex and ends at the first vertex of the graph, so near pairs cost little. On a
  // sphere nothing is cut before; there the first singular vertex becomes the graph.
  void connect_singular_vertices(const std::vector<bool>& is_singular)
  {
    std::vector<bool> has_graph(number_of_components(), false);
    std::vector<int> component_of_vertex(m_mesh.number_of_vertices(), -1);
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      for(int v : m_mesh.corners[f])
      {
        component_of_vertex[v] = m_component[f];
        if(m_on_cut[v])
          has_graph[m_component[f]] = true;
      }

    Distance_front front(m_mesh.number_of_vertices());
    std::vector<int> arrived_by(m_mesh.number_of_vertices(), -1);
    for(int s = 0; s < m_mesh.number_of_vertices(); ++s)
    {
      if(!is_singular[s] || m_on_cut[s] || component_of_vertex[s] == -1)
        continue;
      if(!has_graph[component_of_vertex[s]])
      {
        has_graph[component_of_vertex[s]] = true;
        m_on_cut[s] = true;
        continue;
      }
      front.clear();
      front.reach(s, 0);
      int v;
      for(double length; front.pop(v, length);)
      {
        if(m_on_cut[v])
        {
          for(int w = v; w != s;
              w = m_mesh.source(arrived_by[w]) == w ? m_mesh.target(arrived_by[w]) : m_mesh.source(arrived_by[w]))
          {
            m_cut[m_mesh.edge_of[arrived_by[w]]] = true;
            m_on_cut[w] = true;
          }
          m_on_cut[s] = true;
          break;
        }
        auto relax = [&](int h, int w)
        {
          if(front.reach(w, length + CGAL::approximate_sqrt(m_mesh.vector(h).squared_length())))
            arrived_by[w] = h;
        };
        for_each_corner_of_vertex(m_mesh, v,
                                  [&](int h)
                                  {
                                    relax(h, m_mesh.target(h));
                                    const int p = Indexed_triangle_mesh::prev(h);
                                    if(m_mesh.opposite[p] == -1)
                                      relax(p, m_mesh.source(p));
                                  });
      }
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CUT_GRAPH_H
