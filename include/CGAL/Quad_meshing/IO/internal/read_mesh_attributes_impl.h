// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_MESH_ATTRIBUTES_IMPL_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_MESH_ATTRIBUTES_IMPL_H

#include <CGAL/Quad_meshing/IO/internal/read_soup_file.h>
#include <CGAL/Quad_meshing/IO/read_mesh_attributes.h>

#include <string>
#include <utility>

namespace CGAL {
namespace Quad_meshing {

CGAL_QUAD_MESHING_INLINE Mesh_reading_result read_mesh_attributes(const std::string& filename,
                                                                  Mesh_attributes& attributes)
{
  Mesh_reading_result result;
  internal::Polygon_soup soup;
  Mesh_attributes found;
  if(!internal::read_soup_file(filename, soup, result, &found))
    return result;
  found.first_corner.assign(soup.first_corner.begin(), soup.first_corner.end());
  found.corner_vertex.assign(soup.corners.begin(), soup.corners.end());
  found.corner_texture.resize(soup.corners.size(), -1);
  found.corner_normal.resize(soup.corners.size(), -1);
  for(Face_names* names : { &found.objects, &found.groups, &found.materials })
    names->of_face.resize(soup.size(), Face_names::none);
  if(found.colors.size() != soup.points.size())
    found.colors.clear();
  result.vertices = File_numbers(soup.points.size());
  result.faces = File_numbers(soup.size());
  attributes = std::move(found);
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_READ_MESH_ATTRIBUTES_IMPL_H
