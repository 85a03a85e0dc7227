// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXAMPLES_TRIANGLE_INPUT_H
#define CGAL_QUAD_MESHING_EXAMPLES_TRIANGLE_INPUT_H

// What `quadrangulate` may do to its input: take the largest component alone, read directions from a file.

#include "command_line.h"

#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>
#include <CGAL/Quad_meshing/IO/rosy_field.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace command_line {

// A halfedge that ends in a vertex and has a face.
template <typename Mesh>
typename Mesh::Halfedge_index surface_halfedge(typename Mesh::Vertex_index v, const Mesh& tm)
{
  // that of a vertex on the border lies on the border
  const typename Mesh::Halfedge_index h = tm.halfedge(v);
  return tm.is_border(h) ? tm.opposite(tm.next(h)) : h;
}

// Reduces a mesh, and the numbers of its elements in the file, to the component of the largest area. Says on the
// standard error stream what is left away.
template <typename Mesh>
void keep_largest_component(Mesh& tm, CGAL::Quad_meshing::Mesh_reading_result& reading)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  // no property of the mesh, which will be assigned to
  std::vector<std::size_t> component(tm.number_of_faces());
  const auto components = boost::make_iterator_property_map(component.begin(), get(boost::face_index, tm));
  std::vector<double> areas(PMP::connected_components(tm, components), 0.);
  if(areas.size() < 2)
    return;
  for(auto f : tm.faces())
    areas[component[f]] += PMP::face_area(f, tm);
  const std::size_t largest = static_cast<std::size_t>(std::max_element(areas.begin(), areas.end()) - areas.begin());
  Mesh part;
  std::vector<typename Mesh::Vertex_index> copies(tm.number_of_vertices(), Mesh::null_vertex());
  std::vector<std::size_t> kept_vertices, kept_faces;
  for(auto v : tm.vertices())
    if(!tm.is_isolated(v) && component[tm.face(surface_halfedge(v, tm))] == largest)
    {
      copies[v] = part.add_vertex(tm.point(v));
      kept_vertices.push_back(v);
    }
  for(auto f : tm.faces())
    if(component[f] == largest)
    {
      std::vector<typename Mesh::Vertex_index> corners;
      for(auto v : tm.vertices_around_face(tm.halfedge(f)))
        corners.push_back(copies[v]);
      part.add_face(corners);
      kept_faces.push_back(f);
    }
  std::cerr << "The largest of " << areas.size() << " components was taken, with "
            << count_of(kept_faces.size(), "face", "faces") << " of " << tm.number_of_faces() << ".\n";
  reading.vertices = reading.vertices.of_part(kept_vertices);
  reading.faces = reading.faces.of_part(kept_faces);
  tm = part;
}

// The directions of a file `.rosy`, which has one for each face of the file of the mesh, for the faces of the mesh.
template <typename Vector>
std::vector<std::optional<Vector>> read_directions(const std::string& filename,
                                                   const CGAL::Quad_meshing::File_numbers& faces)
{
  std::vector<std::array<double, 3>> field;
  const CGAL::Quad_meshing::Mesh_reading_result result = CGAL::Quad_meshing::read_rosy_field(filename, field);
  if(!result)
    throw Unusable_input(filename + ": " + result.message);
  if(field.size() != faces.file_size())
    throw Unusable_input(filename + ": the field has " + count_of(field.size(), "direction", "directions") +
                         ", the mesh " + count_of(faces.file_size(), "face", "faces"));
  std::vector<std::optional<Vector>> directions;
  for(std::size_t i = 0; i < faces.mesh_size(); ++i)
  {
    const std::size_t n = faces.file_number(i);
    directions.emplace_back();
    if(n == CGAL::Quad_meshing::File_numbers::none)
      continue;
    const Vector d(field[n][0], field[n][1], field[n][2]);
    if(d.squared_length() > 0)
      directions.back() = d;
  }
  return directions;
}

} // namespace command_line

#endif // CGAL_QUAD_MESHING_EXAMPLES_TRIANGLE_INPUT_H
