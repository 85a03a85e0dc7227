// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_VTK_IMPL_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_VTK_IMPL_H

#include <CGAL/Quad_meshing/IO/internal/check_scene.h>
#include <CGAL/Quad_meshing/IO/write_vtk.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

// The format knows names of one word, and titles of one line of at most 255 characters.
inline std::string vtk_name(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }, '_');
  return name.empty() ? "numbers" : name.substr(0, 255);
}

// The number that the format has for a kind of cell.
inline int vtk_cell_type(Scene_layer_kind kind, std::size_t number_of_corners)
{
  constexpr int vertex = 1, poly_vertex = 2, line = 3, poly_line = 4, triangle = 5, polygon = 7, quad = 9;
  switch(kind)
  {
    case Scene_layer_kind::FACES: return number_of_corners == 3 ? triangle : number_of_corners == 4 ? quad : polygon;
    case Scene_layer_kind::LINES: return number_of_corners == 2 ? line : poly_line;
    case Scene_layer_kind::POINTS: break;
  }
  return number_of_corners == 1 ? vertex : poly_vertex;
}

} // namespace internal

CGAL_QUAD_MESHING_INLINE Scene_writing_result write_vtk(std::ostream& os, const Scene_layer& layer)
{
  Scene scene;
  scene.layers.push_back(layer);
  Scene_writing_result result = internal::check_scene(scene);
  if(!result.is_valid())
    return result;
  os << "# vtk DataFile Version 3.0\n"
     << internal::vtk_name(layer.name) << "\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " << layer.points.size()
     << " double\n";
  for(const std::array<double, 3>& p : layer.points)
    os << p[0] << " " << p[1] << " " << p[2] << "\n";
  os << "CELLS " << layer.size() << " " << layer.size() + layer.corners.size() << "\n";
  for(std::size_t e = 0; e < layer.size(); ++e)
  {
    os << layer.first_corner[e + 1] - layer.first_corner[e];
    for(std::size_t c = layer.first_corner[e]; c < layer.first_corner[e + 1]; ++c)
      os << " " << layer.corners[c];
    os << "\n";
  }
  os << "CELL_TYPES " << layer.size() << "\n";
  for(std::size_t e = 0; e < layer.size(); ++e)
    os << internal::vtk_cell_type(layer.kind, layer.first_corner[e + 1] - layer.first_corner[e]) << "\n";
  if(!layer.numbers.empty())
    os << "CELL_DATA " << layer.size() << "\n";
  for(const Scene_numbers& numbers : layer.numbers)
  {
    os << "SCALARS " << internal::vtk_name(numbers.name) << " double 1\nLOOKUP_TABLE default\n";
    for(double x : numbers.values)
      os << x << "\n";
  }
  result.message = "The layer was written.";
  if(!os.flush())
  {
    result.status = Scene_writing_status::WRITING_FAILED;
    result.message = "The layer could not be written.";
  }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_WRITE_VTK_IMPL_H
