// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_WRITE_GROUPED_OBJ_H
#define CGAL_QUAD_MESHING_IO_WRITE_GROUPED_OBJ_H

#include <CGAL/Quad_meshing/IO/write_obj.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <map>
#include <ostream>
#include <string>

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
  typedef typename boost::graph_traits<FaceGraph>::edge_descriptor edge_descriptor;
  std::map<long long, int> position; // of a number among those that occur
  for(face_descriptor f : faces(mesh))
    position.emplace(static_cast<long long>(get(face_group, f)), 0);
  Obj_content<FaceGraph> content;
  for(auto& p : position)
  {
    p.second = static_cast<int>(content.groups.names.size());
    content.groups.names.push_back(group_name + std::to_string(p.first));
  }
  content.groups.number = [&](face_descriptor f) { return position.at(static_cast<long long>(get(face_group, f))); };
  content.is_line = [&](edge_descriptor e) { return get(edge_is_line, e); };
  content.line_group = line_group;
  return write_obj(os, mesh, content);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_WRITE_GROUPED_OBJ_H
