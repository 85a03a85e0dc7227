// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_COMBED_CHARTS_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_COMBED_CHARTS_H

#include <CGAL/Quad_meshing/Parameterization/internal/Cut_graph.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A cross field whose directions are combed over the disks of a cut graph [Bom12, 8.4].
//
// The first direction of face f turns by `turns[f]` quarters and becomes the u-direction of the chart of f, so
// that charts agree, without rotation, across every edge that is not cut. A cut path is a maximal
// chain of cut edges between nodes (branches, singular vertices, the border); all its edges share one
// transition a -> R90^r a + t from the chart on the left of the path to the one on its right. A wedge
// is a fan of faces around a vertex between cut edges: its corners are one point of the opened mesh.
struct Combed_charts
{
  struct Path
  {
    int rotation;               // quarters, from the left to the right
    std::vector<int> halfedges; // along the path; their faces lie on its left
  };

  const Indexed_triangle_mesh& mesh;
  std::vector<bool> is_cut;   // per edge
  std::vector<int> component; // per face
  int number_of_components = 0;
  std::vector<int> turns;                         // per face
  std::vector<std::array<double, 2>> u_direction; // per face: (cos, sin) of the u-direction in the frame of
                                                  // the face (x along halfedge 3f, y to the left of it)
  std::vector<Path> paths;
  std::vector<int> path_of_edge;                 // per edge: 1 + path if halfedge_of_edge runs along it,
                                                 // -(1 + path) if against it, 0 if the edge is not cut
  std::vector<int> wedge_of_corner;              // per corner 3f+k
  std::vector<std::vector<int>> wedge_halfedges; // per wedge: the halfedges that leave its vertex in it,
                                                 // counterclockwise
  std::vector<int> first_wedge;                  // per vertex, size number of vertices + 1; the wedges of a
                                                 // vertex are consecutive and counterclockwise

  // `angle` per face and `period_jump` per edge as the maps of a cross field hold them.
  Combed_charts(const Indexed_triangle_mesh& mesh, const std::vector<double>& angle,
                const std::vector<int>& period_jump, const std::vector<bool>& is_singular)
    : mesh(mesh)
  {
    Cut_graph cut_graph(mesh, is_singular);
    is_cut = cut_graph.is_cut();
    component = cut_graph.component_of_face();
    number_of_components = cut_graph.number_of_components();
    comb(angle, period_jump);
    trace_paths(period_jump, is_singular);
    gather_wedges();
  }

  int number_of_wedges() const { return static_cast<int>(wedge_halfedges.size()); }

  // Rotation, in quarters, from the chart of the face of h to the chart beyond h.
  int rotation(int h, const std::vector<int>& period_jump) const
  {
    const int e = mesh.edge_of[h];
    const int p = h == mesh.halfedge_of_edge[e] ? period_jump[e] : -period_jump[e];
    return modulo_4(turns[h / 3] - p - turns[mesh.opposite[h] / 3]);
  }

  // The path that is crossed where one leaves the face of h over h: 1 + path if h runs along it, -(1 + path) if against
  // it, 0 if the edge is not cut.
  int path_crossed(int h) const
  {
    const int e = mesh.edge_of[h];
    return h == mesh.halfedge_of_edge[e] ? path_of_edge[e] : -path_of_edge[e];
  }

  // The quarters from the chart of the face of h to the chart beyond it.
  int quarters_across(int h) const
  {
    const int id = path_crossed(h);
    return id == 0 ? 0 : id > 0 ? paths[id - 1].rotation : -paths[-id - 1].rotation;
  }

  static int modulo_4(int i) { return ((i % 4) + 4) % 4; }

private:
  // theta_i + kappa + (pi/2) p - theta_j is the small angle that a smooth field leaves, so the direction
  // theta_i + c (pi/2) of face i continues as theta_j + (c - p) (pi/2) in face j.
  void comb(const std::vector<double>& angle, const std::vector<int>& period_jump)
  {
    turns.assign(mesh.number_of_faces(), 0);
    std::vector<bool> reached(mesh.number_of_faces(), false);
    std::queue<int> front;
    for(int s = 0; s < mesh.number_of_faces(); ++s)
    {
      if(reached[s])
        continue;
      reached[s] = true;
      front.push(s);
      while(!front.empty())
      {
        const int f = front.front();
        front.pop();
        for(int h = 3 * f; h < 3 * f + 3; ++h)
        {
          const int o = mesh.opposite[h], e = mesh.edge_of[h];
          if(o == -1 || is_cut[e] || reached[o / 3])
            continue;
          turns[o / 3] = modulo_4(turns[f] - (h == mesh.halfedge_of_edge[e] ? period_jump[e] : -period_jump[e]));
          reached[o / 3] = true;
          front.push(o / 3);
        }
      }
    }
    u_direction.resize(mesh.number_of_faces());
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      const double a = angle[f] + turns[f] * (CGAL_PI / 2);
      u_direction[f] = { { std::cos(a), std::sin(a) } };
    }
  }

  // The next cut halfedge after h along its path, or -1 if the target of h is a node.
  int next_on_path(int h, const std::vector<bool>& is_node) const
  {
    if(is_node[mesh.target(h)])
      return -1;
    int g = Indexed_triangle_mesh::next(h); // turn clockwise around the target, over faces on the left
    while(!is_cut[mesh.edge_of[g]])
      g = Indexed_triangle_mesh::next(mesh.opposite[g]);
    return g;
  }

  void trace_paths(const std::vector<int>& period_jump, const std::vector<bool>& is_singular)
  {
    std::vector<int> degree(mesh.number_of_vertices(), 0);
    std::vector<bool> is_node(mesh.number_of_vertices(), false);
    for(int e = 0; e < mesh.number_of_edges(); ++e)
    {
      const int h = mesh.halfedge_of_edge[e];
      for(int v : { mesh.source(h), mesh.target(h) })
      {
        degree[v] += is_cut[e];
        if(mesh.is_border_edge(e))
          is_node[v] = true;
      }
    }
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(degree[v] != 2 || is_singular[v])
        is_node[v] = true;

    path_of_edge.assign(mesh.number_of_edges(), 0);
    auto trace = [&](int h)
    {
      const int id = static_cast<int>(paths.size());
      Path path;
      path.rotation = rotation(h, period_jump);
      for(; h != -1 && path_of_edge[mesh.edge_of[h]] == 0; h = next_on_path(h, is_node))
      {
        const int e = mesh.edge_of[h];
        path_of_edge[e] = h == mesh.halfedge_of_edge[e] ? 1 + id : -(1 + id);
        path.halfedges.push_back(h);
      }
      paths.push_back(path);
    };
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
      if(is_cut[mesh.edge_of[h]] && is_node[mesh.source(h)] && path_of_edge[mesh.edge_of[h]] == 0)
        trace(h);
    for(int h = 0; h < mesh.number_of_halfedges(); ++h) // closed cuts without a node
      if(is_cut[mesh.edge_of[h]] && path_of_edge[mesh.edge_of[h]] == 0)
        trace(h);
  }

  void gather_wedges()
  {
    wedge_of_corner.assign(mesh.number_of_halfedges(), -1);
    first_wedge.assign(1, 0);
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
    {
      int start = mesh.halfedge_of_vertex[v];
      if(start != -1 && mesh.opposite[start] != -1)
      {
        int h = start; // an interior vertex: begin at a cut edge if there is one
        do
        {
          if(is_cut[mesh.edge_of[h]])
          {
            start = h;
            break;
          }
          h = mesh.next_around_source(h);
        }
        while(h != start);
      }
      for(int h = start; h != -1;)
      {
        if(h == start || is_cut[mesh.edge_of[h]])
          wedge_halfedges.emplace_back();
        wedge_halfedges.back().push_back(h);
        wedge_of_corner[h] = number_of_wedges() - 1; // halfedge 3f+k leaves corner k of face f
        h = mesh.next_around_source(h);
        if(h == start)
          break;
      }
      first_wedge.push_back(number_of_wedges());
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_COMBED_CHARTS_H
