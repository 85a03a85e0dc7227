// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_SURFACE_TOPOLOGY_H
#define CGAL_QUAD_MESHING_INTERNAL_SURFACE_TOPOLOGY_H

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
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

// The topology of all components that have faces, sorted, so that two surfaces can be compared.
template <typename FaceGraph>
std::vector<Component_topology> surface_topology(const FaceGraph& g)
{
  auto component = get(CGAL::dynamic_face_property_t<int>(), g);
  for(auto f : faces(g))
    put(component, f, -1);
  std::vector<Component_topology> result;
  std::vector<typename boost::graph_traits<FaceGraph>::face_descriptor> stack;
  for(auto seed : faces(g))
  {
    if(get(component, seed) != -1)
      continue;
    const int c = static_cast<int>(result.size());
    result.emplace_back();
    put(component, seed, c);
    stack.push_back(seed);
    while(!stack.empty())
    {
      const auto f = stack.back();
      stack.pop_back();
      ++result[c].euler_number;
      for(auto h : halfedges_around_face(halfedge(f, g), g))
      {
        const auto o = opposite(h, g);
        if(!is_border(o, g) && get(component, face(o, g)) == -1)
        {
          put(component, face(o, g), c);
          stack.push_back(face(o, g));
        }
      }
    }
  }
  for(auto e : edges(g))
  {
    auto h = halfedge(e, g);
    if(is_border(h, g))
      h = opposite(h, g);
    if(!is_border(h, g))
      --result[get(component, face(h, g))].euler_number;
  }
  for(auto v : vertices(g))
  {
    auto h = halfedge(v, g);
    if(h == boost::graph_traits<FaceGraph>::null_halfedge())
      continue;
    if(is_border(h, g))
      h = opposite(h, g);
    if(!is_border(h, g))
      ++result[get(component, face(h, g))].euler_number;
  }
  auto seen = get(CGAL::dynamic_halfedge_property_t<bool>(), g);
  for(auto h : halfedges(g))
    put(seen, h, false);
  for(auto h : halfedges(g))
  {
    if(!is_border(h, g) || get(seen, h) || is_border(opposite(h, g), g))
      continue;
    ++result[get(component, face(opposite(h, g), g))].border_loops;
    for(auto i : halfedges_around_face(h, g))
      put(seen, i, true);
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_SURFACE_TOPOLOGY_H
