// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CUT_GRAPH_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CUT_GRAPH_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The edges along which every component of a triangle mesh opens to a topological disk that has all
// singular vertices on its border (thesis, Section 8.4, "Cutting the mesh"): what a dual spanning
// tree does not cross, shortened by removing dangling paths, and shortest paths from there to the
// singular vertices. Border edges are not marked; they are open already.
class Cut_graph
{
public:
  Cut_graph(const Indexed_triangle_mesh& mesh, const std::vector<bool>& is_singular)
    : mesh(mesh), cut(mesh.number_of_edges(), false), on_cut(mesh.number_of_vertices(), false)
  {
    number_components();
    cut_what_the_dual_tree_leaves();
    remove_dangling_paths();
    connect_singular_vertices(is_singular);
  }

  const std::vector<bool>& is_cut() const { return cut; }
  const std::vector<int>& component_of_face() const { return component; }
  int number_of_components() const { return static_cast<int>(first_face.size()); }

private:
  const Indexed_triangle_mesh& mesh;
  std::vector<bool> cut;        // per edge
  std::vector<bool> on_cut;     // per vertex: on a cut edge or on the border
  std::vector<int> component;   // per face
  std::vector<int> first_face;  // per component

  void number_components()
  {
    component.assign(mesh.number_of_faces(), -1);
    std::vector<int> stack;
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      if(component[f] != -1)
        continue;
      const int c = number_of_components();
      first_face.push_back(f);
      component[f] = c;
      stack.push_back(f);
      while(!stack.empty())
      {
        const int g = stack.back();
        stack.pop_back();
        for(int h = 3 * g; h < 3 * g + 3; ++h)
        {
          const int o = mesh.opposite[h];
          if(o != -1 && component[o / 3] == -1)
          {
            component[o / 3] = c;
            stack.push_back(o / 3);
          }
        }
      }
    }
  }

  void cut_what_the_dual_tree_leaves()
  {
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      cut[e] = !mesh.is_border_edge(e);
    std::vector<bool> reached(mesh.number_of_faces(), false);
    std::queue<int> front; // breadth first, so that the disk is round and the cut short
    for(int f : first_face)
    {
      reached[f] = true;
      front.push(f);
      while(!front.empty())
      {
        const int g = front.front();
        front.pop();
        for(int h = 3 * g; h < 3 * g + 3; ++h)
        {
          const int o = mesh.opposite[h];
          if(o == -1 || reached[o / 3])
            continue;
          reached[o / 3] = true;
          cut[mesh.edge_of[h]] = false;
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
    std::vector<int> degree(mesh.number_of_vertices(), 0);
    std::vector<std::vector<int> > incident(mesh.number_of_vertices());
    for(int e = 0; e < mesh.number_of_edges(); ++e)
    {
      if(!cut[e] && !mesh.is_border_edge(e))
        continue;
      const int h = mesh.halfedge_of_edge[e];
      for(int v : { mesh.source(h), mesh.target(h) })
      {
        ++degree[v];
        incident[v].push_back(e);
      }
    }
    std::vector<int> leaves;
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(degree[v] == 1)
        leaves.push_back(v);
    while(!leaves.empty())
    {
      const int v = leaves.back();
      leaves.pop_back();
      for(int e : incident[v])
      {
        if(!cut[e])
          continue;
        cut[e] = false;
        const int h = mesh.halfedge_of_edge[e];
        const int w = mesh.source(h) == v ? mesh.target(h) : mesh.source(h);
        --degree[v];
        if(--degree[w] == 1)
          leaves.push_back(w);
      }
    }
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      on_cut[v] = degree[v] > 0;
  }

  // One Dijkstra search per singular vertex, all of them growing from the graph: the search starts at
  // the singular vertex and ends at the first vertex of the graph, so near pairs cost little. On a
  // sphere nothing is cut before; there the first singular vertex becomes the graph.
  void connect_singular_vertices(const std::vector<bool>& is_singular)
  {
    std::vector<bool> has_graph(number_of_components(), false);
    std::vector<int> component_of_vertex(mesh.number_of_vertices(), -1);
    for(int f = 0; f < mesh.number_of_faces(); ++f)
      for(int v : mesh.corners[f])
      {
        component_of_vertex[v] = component[f];
        if(on_cut[v])
          has_graph[component[f]] = true;
      }

    const double infinity = (std::numeric_limits<double>::max)();
    std::vector<double> distance(mesh.number_of_vertices(), infinity);
    std::vector<int> arrived_by(mesh.number_of_vertices(), -1);
    std::vector<int> touched;
    typedef std::pair<double, int> Entry;
    for(int s = 0; s < mesh.number_of_vertices(); ++s)
    {
      if(!is_singular[s] || on_cut[s] || component_of_vertex[s] == -1)
        continue;
      if(!has_graph[component_of_vertex[s]])
      {
        has_graph[component_of_vertex[s]] = true;
        on_cut[s] = true;
        continue;
      }
      std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
      distance[s] = 0;
      touched.assign(1, s);
      queue.push(Entry(0, s));
      while(!queue.empty())
      {
        const Entry top = queue.top();
        queue.pop();
        const int v = top.second;
        if(top.first > distance[v])
          continue;
        if(on_cut[v])
        {
          for(int w = v; w != s; w = mesh.source(arrived_by[w]) == w ? mesh.target(arrived_by[w])
                                                                      : mesh.source(arrived_by[w]))
          {
            cut[mesh.edge_of[arrived_by[w]]] = true;
            on_cut[w] = true;
          }
          on_cut[s] = true;
          break;
        }
        auto relax = [&](int h, int w)
        {
          const double d = top.first + CGAL::approximate_sqrt(mesh.vector(h).squared_length());
          if(d >= distance[w])
            return;
          if(distance[w] == infinity)
            touched.push_back(w);
          distance[w] = d;
          arrived_by[w] = h;
          queue.push(Entry(d, w));
        };
        const int start = mesh.halfedge_of_vertex[v];
        int h = start;
        do
        {
          relax(h, mesh.target(h));
          const int p = Indexed_triangle_mesh::prev(h);
          if(mesh.opposite[p] == -1)
            relax(p, mesh.source(p));
          h = mesh.next_around_source(h);
        }
        while(h != -1 && h != start);
      }
      for(int v : touched)
        distance[v] = infinity;
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CUT_GRAPH_H
