// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_ELEMENT_NUMBERS_H
#define CGAL_QUAD_MESHING_INTERNAL_ELEMENT_NUMBERS_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// An index map whose values are consecutive from 0 even if those of the map that it is made of are not: a
// `Surface_mesh` with removed elements that were not collected yet has gaps.
template <typename Element, typename IndexMap>
class Element_numbers
{
public:
  typedef Element key_type;
  typedef std::size_t value_type;
  typedef std::size_t reference;
  typedef boost::readable_property_map_tag category;

  template <typename Range>
  Element_numbers(const Range& elements, IndexMap index) : m_index(index)
  {
    std::size_t n = 0, end = 0;
    for(const Element& e : elements)
    {
      ++n;
      end = (std::max)(end, std::size_t(get(m_index, e)) + 1);
    }
    if(end <= n)
      return;
    m_number = std::make_shared<std::vector<std::size_t>>(end, 0);
    n = 0;
    for(const Element& e : elements)
      (*m_number)[get(m_index, e)] = n++;
  }

  friend std::size_t get(const Element_numbers& numbers, const Element& e)
  {
    const std::size_t i = get(numbers.m_index, e);
    return numbers.m_number ? (*numbers.m_number)[i] : i;
  }

private:
  IndexMap m_index;
  std::shared_ptr<std::vector<std::size_t>> m_number; // per index; empty if there are no gaps
};

// The `vertex_index_map` of the named parameters or of the mesh, without gaps.
template <typename TriangleMesh, typename NamedParameters>
auto vertex_numbers(const TriangleMesh& tm, const NamedParameters& np)
{
  typedef decltype(get_initialized_vertex_index_map(tm, np)) Index_map;
  return Element_numbers<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, Index_map>(
    vertices(tm), get_initialized_vertex_index_map(tm, np));
}

// The `face_index_map` of the named parameters or of the mesh, without gaps.
template <typename TriangleMesh, typename NamedParameters>
auto face_numbers(const TriangleMesh& tm, const NamedParameters& np)
{
  typedef decltype(get_initialized_face_index_map(tm, np)) Index_map;
  return Element_numbers<typename boost::graph_traits<TriangleMesh>::face_descriptor, Index_map>(
    faces(tm), get_initialized_face_index_map(tm, np));
}

// Calls f(e, i) for the edges that have a face, numbered from 0 in the order in which the graph enumerates them. This
// is how `Indexed_triangle_mesh` numbers edges.
template <typename FaceGraph, typename Function>
void for_each_edge_of_faces(const FaceGraph& g, Function f)
{
  int i = 0;
  for(auto e : edges(g))
  {
    const auto h = halfedge(e, g);
    if(!is_border(h, g) || !is_border(opposite(h, g), g))
      f(e, i++);
  }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_ELEMENT_NUMBERS_H
