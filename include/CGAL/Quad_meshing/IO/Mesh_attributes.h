// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_MESH_ATTRIBUTES_H
#define CGAL_QUAD_MESHING_IO_MESH_ATTRIBUTES_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingIORef

\brief Names that faces of a file have: of objects, of groups or of materials.
*/
struct Face_names
{
  static constexpr int none = -1; ///< the number of a face that has no name

  std::vector<std::string> names; ///< in the order in which they occur
  std::vector<int> of_face;       ///< per face: the number of its name, or `none`

  /// returns whether no face has a name.
  bool is_empty() const { return names.empty(); }
};

/*!
\ingroup PkgQuadMeshingIORef

\brief What a file says about its faces, their corners and its vertices besides the shape.

Faces and vertices have the numbers of the file, from 0. `Mesh_reading_result` relates them to those of a mesh that was
read from the file.

\sa `read_mesh_attributes()`
*/
struct Mesh_attributes
{
  Face_names objects;                          ///< OBJ, `o`
  Face_names groups;                           ///< OBJ, `g`; a face in several groups has all their names, by blanks
  Face_names materials;                        ///< OBJ, `usemtl`
  std::vector<std::string> material_libraries; ///< OBJ, `mtllib`: the files as they are named

  /// The corners of face `f` have the numbers from `first_corner[f]` to, exclusive, `first_corner[f + 1]`.
  std::vector<std::size_t> first_corner;
  std::vector<std::size_t> corner_vertex; ///< per corner: its vertex
  std::vector<int> corner_texture;        ///< per corner: its texture coordinates, -1 for none; OBJ, `f v/vt`
  std::vector<int> corner_normal;         ///< per corner: its normal, -1 for none; OBJ, `f v//vn`

  std::vector<std::array<double, 2>> texture_coordinates; ///< OBJ, `vt`
  std::vector<std::array<double, 3>> normals;             ///< OBJ, `vn`
  /// Per vertex: red, green and blue from 0 to 1; empty if not all vertices have a color. OBJ, `v x y z r g b`; PLY,
  /// properties `red`, `green`, `blue`, as integers of one byte or as fractions.
  std::vector<std::array<double, 3>> colors;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_MESH_ATTRIBUTES_H
