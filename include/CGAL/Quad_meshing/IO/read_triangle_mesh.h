// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_READ_TRIANGLE_MESH_H
#define CGAL_QUAD_MESHING_IO_READ_TRIANGLE_MESH_H

#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>
#include <CGAL/Quad_meshing/IO/internal/Triangle_surface.h>
#include <CGAL/Quad_meshing/IO/internal/build_mesh.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief reads a triangle mesh from a file, checks it and repairs what can be repaired without
 * changing the surface as a set of points.
 *
 * The format is told by the extension: OFF, OBJ, PLY or STL; \ref Quad_meshing_IO_formats says which variants. The
 * function never throws and never prints on account of the file; if it cannot give a mesh it says why, and `g` stays as
 * it was.
 *
 * Polygons are triangulated. `Mesh_repairs` lists the repairs in the order in which they are made;
 * \ref Quad_meshing_IO_repairs describes them and says how much of each is done. What was done is counted and said in
 * the result, and `Mesh_reading_result::vertices` and `Mesh_reading_result::faces` relate the elements of the mesh to
 * those of the file. If the file holds a proper triangle mesh, vertices and faces of `g` are numbered in the order of
 * the file.
 *
 * A surface with one side only is refused: cutting it open would be the user's choice.
 *
 * \tparam FaceGraph a model of `MutableFaceGraph`
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param filename the name of the file
 * \param g the mesh, whose former content is replaced
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{repair}
 *     \cgalParamDescription{the repairs that may be made}
 *     \cgalParamType{`Mesh_repairs`, or `bool`: all of them or none}
 *     \cgalParamDefault{`true`}
 *     \cgalParamExtra{With `false` a file is read as it is, with vertices that no face names and triangles of zero
 * area, or refused (`Mesh_reading_status::NEEDS_REPAIR`, `Mesh_reading_status::NOT_ORIENTABLE`).}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `g`}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<FaceGraph>::%vertex_descriptor`
 *                    as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, g)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return whether and how it ended, and what was repaired
 */
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Mesh_reading_result read_triangle_mesh(const std::string& filename, FaceGraph& g,
                                       const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  static_assert(internal::Takes_parameters<NamedParameters, internal_np::repair_t, internal_np::vertex_point_t>::value,
                "read_triangle_mesh() does not take all of these named parameters.");
  typedef typename GetVertexPointMap<FaceGraph, NamedParameters>::type VertexPointMap;

  Mesh_reading_result result;
  internal::Triangle_surface surface;
  const Mesh_repairs repairs(choose_parameter(get_parameter(np, internal_np::repair), Mesh_repairs()));
  if(!internal::read_triangle_surface(filename, repairs, surface, result))
    return result;

  clear(g);
  VertexPointMap vpm =
    choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(vertex_point, g));
  internal::build_mesh(surface, g, vpm);
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_READ_TRIANGLE_MESH_H
