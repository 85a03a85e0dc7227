// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_WRITE_OBJ_H
#define CGAL_QUAD_MESHING_IO_WRITE_OBJ_H

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingIORef

\brief What an OBJ file says about a mesh besides its shape. Functions that are empty say nothing.

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
*/
template <typename FaceGraph>
struct Obj_content
{
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<FaceGraph>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;

  /// names and, for a face, the number of its name; a number that is none of a name stands for no name
  struct Names
  {
    std::vector<std::string> names;
    std::function<int(face_descriptor)> number; ///< empty: there are none
  };

  Names objects;                               ///< statements `o`
  Names groups;                                ///< statements `g`
  Names materials;                             ///< statements `usemtl`
  std::vector<std::string> material_libraries; ///< statements `mtllib`
  /// the texture coordinates at the target of a halfedge in its face
  std::function<std::optional<std::array<double, 2>>(halfedge_descriptor)> texture;
  std::function<std::array<double, 3>(vertex_descriptor)> color; ///< red, green and blue from 0 to 1, behind `x y z`
  std::function<bool(edge_descriptor)> is_line;                  ///< whether an edge becomes an element `l`
  std::string line_group = "lines";                              ///< the group of these
};

/*!
\ingroup PkgQuadMeshingIORef

\brief writes a mesh in the format OBJ, with names of faces, texture coordinates, colors and lines.

Faces are ordered by object, group and material, else as in the mesh. Texture coordinates that are equal at one vertex
are written once, so that their seams can be told from it.

\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph` whose vertices have an internal point map

\param os the stream; its precision says how many digits numbers have
\param mesh the mesh
\param content what is written besides points and faces

\return whether the stream is good
*/
template <typename FaceGraph>
bool write_obj(std::ostream& os, const FaceGraph& mesh, const Obj_content<FaceGraph>& content)
{
  typedef Obj_content<FaceGraph> Content;
  typedef typename Content::face_descriptor face_descriptor;
  typedef typename Content::vertex_descriptor vertex_descriptor;

  const auto vpm = get(vertex_point, mesh);
  std::unordered_map<vertex_descriptor, std::size_t> number; // from 1 on
  for(const std::string& library : content.material_libraries)
    os << "mtllib " << library << "\n";
  for(vertex_descriptor v : vertices(mesh))
  {
    const auto& p = get(vpm, v);
    os << "v " << to_double(p.x()) << " " << to_double(p.y()) << " " << to_double(p.z());
    if(content.color)
      for(double c : content.color(v))
        os << " " << c;
    os << "\n";
    const std::size_t n = number.size() + 1;
    number.emplace(v, n);
  }

  const std::array<std::pair<const char*, const typename Content::Names*>, 3> kinds = {
    { { "o", &content.objects }, { "g", &content.groups }, { "usemtl", &content.materials } }
  };
  std::map<std::array<int, 3>, std::vector<face_descriptor>> parts;
  for(face_descriptor f : faces(mesh))
  {
    std::array<int, 3> key = { { -1, -1, -1 } };
    for(std::size_t k = 0; k < kinds.size(); ++k)
      if(kinds[k].second->number)
        key[k] = kinds[k].second->number(f);
    parts[key].push_back(f);
  }

  std::map<std::pair<std::size_t, std::array<double, 2>>, std::size_t> texture_number; // from 1 on
  auto texture_of = [&](typename Content::halfedge_descriptor h)
  {
    const std::optional<std::array<double, 2>> t = content.texture ? content.texture(h) : std::nullopt;
    if(!t)
      return std::string();
    const auto inserted =
      texture_number.emplace(std::make_pair(number[target(h, mesh)], *t), texture_number.size() + 1);
    if(inserted.second)
      os << "vt " << (*t)[0] << " " << (*t)[1] << "\n";
    return "/" + std::to_string(inserted.first->second);
  };
  std::array<int, 3> last = { { -1, -1, -1 } };
  for(const auto& part : parts)
  {
    for(std::size_t k = 0; k < kinds.size(); ++k)
    {
      const std::vector<std::string>& names = kinds[k].second->names;
      const int n = part.first[k];
      if(n != last[k]) // what has no name does not go on with that of the part before
        os << kinds[k].first << " "
           << (n >= 0 && static_cast<std::size_t>(n) < names.size() ? names[static_cast<std::size_t>(n)] : "default")
           << "\n";
    }
    last = part.first;
    for(face_descriptor f : part.second)
    {
      std::string line = "f";
      for(auto h : halfedges_around_face(halfedge(f, mesh), mesh))
        line += " " + std::to_string(number[target(h, mesh)]) + texture_of(h);
      os << line << "\n";
    }
  }

  bool is_first = true;
  for(auto e : edges(mesh))
    if(content.is_line && content.is_line(e))
    {
      if(is_first)
        os << "g " << content.line_group << "\n";
      is_first = false;
      os << "l " << number[source(e, mesh)] << " " << number[target(e, mesh)] << "\n";
    }
  return os.good();
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_WRITE_OBJ_H
