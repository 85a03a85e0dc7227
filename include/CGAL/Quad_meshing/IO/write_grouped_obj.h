// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_WRITE_GROUPED_OBJ_H
#define CGAL_QUAD_MESHING_IO_WRITE_GROUPED_OBJ_H

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingIORef

\brief writes a mesh in the format OBJ, with a group (`g`) for each number of its faces and a line element (`l`) for
each edge that is marked.

With the maps of `base_complex()`, the groups are the patches of a quad mesh and the lines its separatrices.

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph` whose vertices have an internal point map
\tparam FaceGroupMap a model of `ReadablePropertyMap` with the faces as keys and an integer as value type
\tparam EdgeIsLineMap a model of `ReadablePropertyMap` with the edges as keys and `bool` as value type

\param os the stream; its precision says how many digits numbers have
\param mesh the mesh
\param face_group the number of the group of a face
\param edge_is_line whether an edge becomes a line element
\param group_name what precedes the number in the name of a group
\param line_group the name of the group of the line elements

\return whether the stream is good
*/
template <typename FaceGraph, typename FaceGroupMap, typename EdgeIsLineMap>
bool write_grouped_obj(std::ostream& os, const FaceGraph& mesh, FaceGroupMap face_group, EdgeIsLineMap edge_is_line,
                       const std::string& group_name = "patch_", const std::string& line_group = "separatrices")
{
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;
  const auto vpm = get(vertex_point, mesh);
  std::unordered_map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, std::size_t> number; // from 1 on
  for(auto v : vertices(mesh))
  {
    const auto& p = get(vpm, v);
    os << "v " << to_double(p.x()) << " " << to_double(p.y()) << " " << to_double(p.z()) << "\n";
    const std::size_t n = number.size() + 1;
    number.emplace(v, n);
  }
  std::map<long long, std::vector<face_descriptor>> groups;
  for(auto f : faces(mesh))
    groups[static_cast<long long>(get(face_group, f))].push_back(f);
  for(const auto& group : groups)
  {
    os << "g " << group_name << group.first << "\n";
    for(face_descriptor f : group.second)
    {
      os << "f";
      for(auto h : halfedges_around_face(halfedge(f, mesh), mesh))
        os << " " << number[target(h, mesh)];
      os << "\n";
    }
  }
  bool is_first = true;
  for(auto e : edges(mesh))
    if(get(edge_is_line, e))
    {
      if(is_first)
        os << "g " << line_group << "\n";
      is_first = false;
      os << "l " << number[source(e, mesh)] << " " << number[target(e, mesh)] << "\n";
    }
  return os.good();
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_WRITE_GROUPED_OBJ_H
