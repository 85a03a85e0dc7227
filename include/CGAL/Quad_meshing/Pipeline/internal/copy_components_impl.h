// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COPY_COMPONENTS_IMPL_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COPY_COMPONENTS_IMPL_H

#include <CGAL/Quad_meshing/Pipeline/copy_components.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Surface_components.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <utility>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Component_copies copy_components(const Triangle_input& input)
{
  Surface_components components(input);
  Component_copies copies;
  copies.surfaces = std::move(components.surfaces);
  for(const auto& surface : copies.surfaces)
    copies.areas.push_back(Polygon_mesh_processing::area(surface->mesh));
  copies.divided_vertices = components.number_of_divided_vertices;
  copies.message = components.error;
  return copies;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COPY_COMPONENTS_IMPL_H
