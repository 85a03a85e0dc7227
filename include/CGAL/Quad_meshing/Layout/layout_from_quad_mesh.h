// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_LAYOUT_FROM_QUAD_MESH_H
#define CGAL_QUAD_MESHING_LAYOUT_LAYOUT_FROM_QUAD_MESH_H

#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/quad_mesh_layout.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/quad_mesh_parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief returns the layout that a coarse quad mesh stands for: its vertices are the nodes, its edges the arcs, its
 * faces the patches.
 *
 * The quad mesh need not lie on the surface on which the layout is drawn later, but near it: a node is the point of the
 * surface nearest to its vertex, an arc a short path between its nodes.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param qm the quad mesh
 * \param np an optional sequence of named parameters: `vertex_point_map`, and `edge_is_constrained_map`, a readable map
 *        that tells which edges become aligned arcs; none by default
 *
 * \return the layout; node, arc and patch numbers follow the order of vertices, of the edges by the faces, and of faces
 *
 * \pre `CGAL::is_quad_mesh(qm)`
 */
template <typename QuadMesh, typename NamedParameters = parameters::Default_named_parameters>
Surface_layout layout_from_quad_mesh(const QuadMesh& qm, const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition(is_quad_mesh(qm));
  return internal::quad_mesh_layout(internal::make_indexed_quad_mesh(qm, np).mesh);
}

/*!
 * \ingroup PkgQuadMeshingLayoutRef
 *
 * \brief returns the base complex of a quad mesh as a layout.
 *
 * Its arcs pass through the vertices of the quad mesh, which should lie on the surface on which the layout is drawn
 * later, or very near it. Constrained edges are arcs, too; where a chain of them ends or bends inside a patch, it goes
 * straight on up to the next arc. An arc is aligned if one of its edges is constrained.
 *
 * \tparam QuadMesh a model of `FaceListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param qm the quad mesh
 * \param np an optional sequence of named parameters: `vertex_point_map`, and `edge_is_constrained_map`, a readable
 *        map; no edge is constrained by default
 *
 * \return the layout. It is empty if the base complex has a patch that is no rectangle, as that of a torus without
 *         irregular vertices.
 *
 * \pre `CGAL::is_quad_mesh(qm)`
 */
template <typename QuadMesh, typename NamedParameters = parameters::Default_named_parameters>
Surface_layout layout_from_base_complex(const QuadMesh& qm, const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition(is_quad_mesh(qm));
  return internal::base_complex_layout(internal::make_indexed_quad_mesh(qm, np).mesh);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_LAYOUT_FROM_QUAD_MESH_H
