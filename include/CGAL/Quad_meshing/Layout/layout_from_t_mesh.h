// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_LAYOUT_FROM_T_MESH_H
#define CGAL_QUAD_MESHING_LAYOUT_LAYOUT_FROM_T_MESH_H

#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief returns the T-mesh of a seamless map as a layout: nodes, arcs and patches have the same numbers.
 *
 * A T-mesh has few patches where a field has few singularities, and none of them is cut by lines that come from
 * elsewhere. The arcs pass through the points where those of the T-mesh cross the edges of its triangle mesh, so the
 * layout may be drawn on that mesh, or on the one that it was refined from. Parts of features and borders are aligned.
 *
 * \param t the T-mesh
 *
 * \return the layout; it is empty if `t` is not valid
 *
 * \sa `Seamless_map::t_mesh()`
 * \sa `quadrangulate_layout()`
 */
inline Surface_layout layout_from_t_mesh(const T_mesh& t)
{
  Surface_layout layout;
  if(!t.is_valid())
    return layout;
  auto place = [&](const T_mesh::Location& l)
  {
    Surface_layout::Place p;
    p.point = t.position(l);
    return p;
  };
  layout.nodes.resize(t.nodes.size());
  for(std::size_t i = 0; i < t.arcs.size(); ++i)
  {
    const std::vector<T_mesh::Location> line = t.polyline(static_cast<int>(i));
    Surface_layout::Arc arc;
    arc.source = static_cast<std::size_t>(t.arcs[i].source);
    arc.target = static_cast<std::size_t>(t.arcs[i].target);
    arc.is_aligned = t.arcs[i].is_aligned;
    layout.nodes[arc.source] = place(line.front());
    layout.nodes[arc.target] = place(line.back());
    for(std::size_t k = 1; k + 1 < line.size(); ++k)
      arc.way.push_back(place(line[k]));
    layout.arcs.push_back(arc);
  }
  for(const T_mesh::Patch& p : t.patches)
  {
    layout.patches.emplace_back();
    for(std::size_t k = 0; k < 4; ++k)
      for(int d : p.sides[k])
        layout.patches.back().sides[k].push_back(
          Surface_layout::Side_arc{ static_cast<std::size_t>(d / 2), d % 2 == 0 });
  }
  return layout;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_LAYOUT_FROM_T_MESH_H
