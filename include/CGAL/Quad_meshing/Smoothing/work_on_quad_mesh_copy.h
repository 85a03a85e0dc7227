// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_WORK_ON_QUAD_MESH_COPY_H
#define CGAL_QUAD_MESHING_SMOOTHING_WORK_ON_QUAD_MESH_COPY_H

#include <CGAL/Quad_meshing/Smoothing/Quad_mesh_status.h>
#include <CGAL/Quad_meshing/Smoothing/Smoothing_reference.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/internal/quad_mesh_parameters.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Reads the named parameters of a quad mesh that is smoothed: `edge_is_constrained_map`, `vertex_is_constrained_map`,
// `vertex_point_map` and `visitor`. Calls work(copy, constrained vertices, reference, visitor, vertex points, edge
// constraints) with a flat copy of the mesh and the reference make_reference(flat copy) that it is smoothed on. A
// `Result` says so if the mesh or the reference cannot be used.
template <typename Result, typename QuadMesh, typename NamedParameters, typename MakeReference, typename Work>
Result work_on_quad_mesh_copy(QuadMesh& qm, const NamedParameters& np, const MakeReference& make_reference,
                              const Work& work)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(vertex_point, qm));
  auto ecm = edge_constraint_map(qm, np);
  Named_visitor<NamedParameters> visitor(np);

  Result result;
  if(!is_quad_mesh(qm))
  {
    result.status = Quad_mesh_status::NOT_A_QUAD_MESH;
    result.message = "The mesh has faces that are not quads.";
    return result;
  }
  Indexed_quad_mesh_copy<QuadMesh> copy = make_indexed_quad_mesh(qm, vpm, ecm);
  Smoothing_reference reference = make_reference(copy.mesh);
  if(copy.mesh.number_of_faces() > 0 && reference.is_empty())
  {
    result.status = Quad_mesh_status::EMPTY_REFERENCE;
    result.message = "The reference surface has no triangle of positive area.";
    return result;
  }
  return work(copy, constrained_vertices(copy, np), reference, visitor, vpm, ecm);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_WORK_ON_QUAD_MESH_COPY_H
