// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXAMPLES_QUAD_MESH_FILES_H
#define CGAL_QUAD_MESHING_EXAMPLES_QUAD_MESH_FILES_H

// Quad meshes of the programs: how they are read, and the options --patches and --digits of those that write them.

#include "command_line.h"

#include <CGAL/Quad_meshing/IO/write_obj.h>
#include <CGAL/Quad_meshing/Quad_mesh/patch_coordinates.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace command_line {

// Reads a pure quad mesh.
template <typename Mesh>
Mesh read_quad_mesh(const std::string& filename)
{
  std::vector<typename Mesh::Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  read_soup(filename, points, polygons);
  const CGAL::Quad_meshing::Quad_mesh_defects defects = CGAL::Quad_meshing::find_quad_mesh_defects(points, polygons);
  if(!defects.is_pure_quad_mesh())
    throw Unusable_input(filename + ": is not a pure quad mesh: " + defects.reasons().front());
  Mesh qm;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, qm);
  return qm;
}

inline void add_quad_mesh_options(po::options_description& options)
{
  options.add_options()(
    "patches", po::value<std::string>(),
    "OBJ file of the quads with a group for each patch of the base complex, the integer grid of the patch as texture "
    "coordinates, and the separatrices as line elements")("digits", po::value<long long>()->default_value(all_digits),
                                                          "digits of the coordinates, 17: they read back as they are");
}

// The number of digits; throws if the file of --patches cannot be written.
inline int check_quad_mesh_options(const Arguments& args)
{
  if(args.has("patches"))
    check_output(args.value<std::string>("patches"), { "obj" });
  return static_cast<int>(args.whole_number("digits", 1, all_digits));
}

// Writes the file of --patches, for pure quad meshes.
template <typename QuadMesh>
void write_patches(const Arguments& args, const QuadMesh& qm, int digits)
{
  if(!args.has("patches") || !CGAL::is_quad_mesh(qm) || CGAL::is_empty(qm))
    return;
  typedef CGAL::Quad_meshing::Obj_content<QuadMesh> Content;
  const std::string filename = args.value<std::string>("patches");
  const auto is_separatrix = get(CGAL::dynamic_edge_property_t<bool>(), qm);
  const auto patch = get(CGAL::dynamic_face_property_t<std::size_t>(), qm);
  const auto corner = get(CGAL::dynamic_halfedge_property_t<std::array<double, 2>>(), qm);
  const std::size_t number_of_patches = CGAL::Quad_meshing::base_complex(qm, is_separatrix, patch);
  CGAL::Quad_meshing::patch_coordinates(qm, is_separatrix, corner);
  Content content;
  for(std::size_t i = 0; i < number_of_patches; ++i)
    content.groups.names.push_back("patch_" + std::to_string(i));
  content.groups.number = [&](typename Content::face_descriptor f) { return static_cast<int>(get(patch, f)); };
  content.texture = [&](typename Content::halfedge_descriptor h) { return get(corner, h); };
  content.is_line = [&](typename Content::edge_descriptor e) { return get(is_separatrix, e); };
  content.line_group = "separatrices";
  write_file(filename,
             [&](std::ostream& out)
             {
               out.precision(digits);
               CGAL::Quad_meshing::write_obj(out, qm, content);
             });
}

} // namespace command_line

#endif // CGAL_QUAD_MESHING_EXAMPLES_QUAD_MESH_FILES_H
