// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_SURFACE_TOPOLOGY_H
#define CGAL_QUAD_MESHING_INTERNAL_SURFACE_TOPOLOGY_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The topology of one component of a surface.
struct Component_topology
{
  long euler_number = 0;
  long border_loops = 0;

  bool operator==(const Component_topology& b) const
  {
    return euler_number == b.euler_number && border_loops == b.border_loops;
  }
  bool operator<(const Component_topology& b) const
  {
    return std::tie(euler_number, border_loops) < std::tie(b.euler_number, b.border_loops);
  }
};

// The halfedges of an oriented surface as `surface_topology()` looks at them. Those without a face are border
// halfedges.
struct Halfedge_arrays
{
  std::vector<int> opposite;
  std::vector<int> next;
  std::vector<int> face;   // -1 on the border
  std::vector<int> source; // vertices
  int number_of_faces = 0;
  int number_of_vertices = 0;
};

// The topology of all components that have faces, sorted, so that two surfaces can be compared. Edges without faces and
// vertices without such edges do not count.
inline std::vector<Component_topology> surface_topology(const Halfedge_arrays& a)
{
  const int n = static_cast<int>(a.opposite.size());
  std::vector<std::vector<int>> halfedges_of_face(a.number_of_faces);
  for(int h = 0; h < n; ++h)
    if(a.face[h] != -1)
      halfedges_of_face[a.face[h]].push_back(h);

  std::vector<Component_topology> result;
  std::vector<int> component(a.number_of_faces, -1), stack;
  for(int seed = 0; seed < a.number_of_faces; ++seed)
  {
    if(component[seed] != -1)
      continue;
    const int c = static_cast<int>(result.size());
    result.emplace_back();
    component[seed] = c;
    stack.push_back(seed);
    while(!stack.empty())
    {
      const int f = stack.back();
      stack.pop_back();
      ++result[c].euler_number;
      for(int h : halfedges_of_face[f])
      {
        const int g = a.face[a.opposite[h]];
        if(g != -1 && component[g] == -1)
        {
          component[g] = c;
          stack.push_back(g);
        }
      }
    }
  }

  std::vector<bool> seen_vertex(a.number_of_vertices, false), seen_border(n, false);
  for(int h = 0; h < n; ++h)
  {
    const int f = a.face[h], o = a.opposite[h];
    if(f != -1)
    {
      if(a.face[o] == -1 || h < o)
        --result[component[f]].euler_number;
      if(!seen_vertex[a.source[h]])
        ++result[component[f]].euler_number;
      seen_vertex[a.source[h]] = true;
    }
    else if(a.face[o] != -1 && !seen_border[h])
    {
      ++result[component[a.face[o]]].border_loops;
      for(int g = h; !seen_border[g]; g = a.next[g])
        seen_border[g] = true;
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <typename FaceGraph>
std::vector<Component_topology> surface_topology(const FaceGraph& g)
{
  auto number = get(CGAL::dynamic_halfedge_property_t<int>(), g);
  auto vertex_number = get(CGAL::dynamic_vertex_property_t<int>(), g);
  auto face_number = get(CGAL::dynamic_face_property_t<int>(), g);
  Halfedge_arrays a;
  for(auto v : vertices(g))
    put(vertex_number, v, a.number_of_vertices++);
  for(auto f : faces(g))
    put(face_number, f, a.number_of_faces++);
  int n = 0;
  for(auto h : halfedges(g))
    put(number, h, n++);
  for(auto h : halfedges(g))
  {
    a.opposite.push_back(get(number, opposite(h, g)));
    a.next.push_back(get(number, next(h, g)));
    a.face.push_back(is_border(h, g) ? -1 : get(face_number, face(h, g)));
    a.source.push_back(get(vertex_number, source(h, g)));
  }
  return surface_topology(a);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_SURFACE_TOPOLOGY_H
