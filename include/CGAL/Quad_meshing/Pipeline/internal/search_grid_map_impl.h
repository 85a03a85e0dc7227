// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SEARCH_GRID_MAP_IMPL_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SEARCH_GRID_MAP_IMPL_H

#include <CGAL/Quad_meshing/Pipeline/internal/search_component.h>
#include <CGAL/Quad_meshing/Pipeline/search_grid_map.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

CGAL_QUAD_MESHING_INLINE Grid_map_search_result search_grid_map(
  Quadrangulation_surface& surface, const std::vector<std::optional<Quadrangulation_kernel::Vector_3>>& direction,
  const std::vector<double>& weight, const Grid_map_request& request, const Quadrangulation_options& options,
  Any_visitor& visitor)
{
  Pipeline_visitor limited(visitor, options.maximum_running_time);
  Grid_map_search_result r;
  for(Quadrangulation_mesh::Face_index f : surface.mesh.faces())
    if(!(surface.length[f] > 0))
      surface.length[f] = request.edge_length;
  r.quads = search_component(surface, { direction, weight, {}, {}, false, {}, {} },
                             { options, request.edge_length, request.releasable_length,
                               options.target_edge_length == 0 ? request.number_of_quads : 0, request.number_of_quads },
                             limited, r.figures);
  return r;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SEARCH_GRID_MAP_IMPL_H
