// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_WORKING_MESH_MAKE_WORKING_MESH_H
#define CGAL_QUAD_MESHING_WORKING_MESH_MAKE_WORKING_MESH_H

#include <CGAL/Quad_meshing/Working_mesh/Working_mesh_result.h>
#include <CGAL/Quad_meshing/Working_mesh/internal/build_working_mesh.h>
#include <CGAL/Quad_meshing/internal/Named_visitor.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/internal/triangle_mesh_parameters.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingWorkingMeshRef
 *
 * \brief makes a triangle mesh of a surface that is as fine as quads of a given size need it.
 *
 * All stages from the field to the extraction work on triangles, and cost what these cost. Scans have a thousand of
 * them for a quad, parts from CAD have slivers that no map can bend on. The working mesh has some ten well-shaped
 * triangles for each quad, more where features are close to each other or the surface is narrow.
 *
 * Edges that are too short are collapsed onto one of their ends, edges that are too long are split, and edges that are
 * not locally Delaunay are flipped where the surface is flat enough; inner vertices move along the input. The topology
 * stays what it is. Features and borders stay where they are: a vertex of them is removed only if the curve stays
 * within 0.05 target edge lengths and turns by no more than 25 degrees at its neighbors; their ends and crossings stay.
 * The input and the working mesh are within about 0.1 target edge lengths of each other, and a triangle lies within 30
 * degrees of the mean normal of the part of the input that it stands for, unless the input is rougher than that itself.
 * Every step is small against the surface around it, so no vertex comes to lie on another part of the surface.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam WorkingMesh a model of `MutableFaceGraph`
 *
 * \param tm the triangle mesh; vertices in which borders touch must have been divided, see `copy_components()`
 * \param target_edge_length the edge length of the quads, in the unit of the points
 * \param wm receives the working mesh, in addition to what it holds
 * \param np_tm an optional sequence of \ref bgl_namedparameters "Named Parameters" of the input among the ones listed
 * below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{feature edges}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor of `TriangleMesh` as key and `bool` as
 *       value type}
 *     \cgalParamDefault{no edge}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_sizing_map}
 *     \cgalParamDescription{the edge length of the quads per face, positive: triangles are as fine as the quads there}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the face descriptor of `TriangleMesh` as key and `double` as
 *       value type}
 *     \cgalParamDefault{`target_edge_length` everywhere}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{is told about the stage and may stop it, see `Default_visitor`; pass it by `std::ref`}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{consecutive numbers of the vertices from 0}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_index_map}
 *     \cgalParamDescription{consecutive numbers of the faces from 0}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \param np_wm an optional sequence of \ref bgl_namedparameters "Named Parameters" of the working mesh among the ones
 * listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{receives `true` for the edges along the features}
 *     \cgalParamType{a model of `WritablePropertyMap` with the edge descriptor of `WorkingMesh` as key and `bool` as
 *       value type}
 *     \cgalParamDefault{not written}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{input_face_map}
 *     \cgalParamDescription{receives a face of the input at or near each vertex}
 *     \cgalParamType{a model of `WritablePropertyMap` with the vertex descriptor of `WorkingMesh` as key and the face
 *       descriptor of `TriangleMesh` as value type}
 *     \cgalParamDefault{not written}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{receives the points of the vertices}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, wm)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return how it ended, with the numbers of edits
 */
template <typename TriangleMesh, typename WorkingMesh,
          typename NamedParametersTM = parameters::Default_named_parameters,
          typename NamedParametersWM = parameters::Default_named_parameters>
Working_mesh_result make_working_mesh(const TriangleMesh& tm, double target_edge_length, WorkingMesh& wm,
                                      const NamedParametersTM& np_tm = parameters::default_values(),
                                      const NamedParametersWM& np_wm = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<WorkingMesh>::vertex_descriptor working_vertex_descriptor;
  typedef typename boost::graph_traits<WorkingMesh>::face_descriptor working_face_descriptor;
  typedef typename boost::graph_traits<WorkingMesh>::halfedge_descriptor working_halfedge_descriptor;

  internal::check_parameters<NamedParametersTM, internal_np::edge_is_constrained_t, internal_np::face_sizing_map_t,
                             internal_np::visitor_t, internal_np::vertex_point_t, internal_np::vertex_index_t,
                             internal_np::face_index_t>();
  internal::check_parameters<NamedParametersWM, internal_np::edge_is_constrained_t, internal_np::vertex_point_t,
                             internal_np::input_face_map_t>();

  Working_mesh_result result;
  if(!internal::has_triangles_only(tm, result))
    return result;
  internal::Reference_surface input(internal::make_indexed_triangle_mesh(tm, np_tm));
  const auto fim = internal::face_numbers(tm, np_tm);
  internal::Named_visitor<NamedParametersTM> visitor(np_tm);
  internal::Working_triangles triangles;
  result =
    internal::build_working_mesh(input, internal::constrained_edges(tm, np_tm), target_edge_length,
                                 internal::face_lengths(tm, input.mesh().corners.size(), np_tm), visitor, triangles);
  if(!result.is_valid())
    return result;

  std::vector<face_descriptor> input_faces(input.mesh().corners.size());
  for(face_descriptor f : faces(tm))
    input_faces[get(fim, f)] = f;
  auto vpm = choose_parameter(get_parameter(np_wm, internal_np::vertex_point), get_property_map(vertex_point, wm));
  typedef typename boost::property_traits<decltype(vpm)>::value_type Point;
  std::vector<working_vertex_descriptor> vertices;
  for(std::size_t i = 0; i < triangles.points.size(); ++i)
  {
    const auto& p = triangles.points[i];
    vertices.push_back(add_vertex(wm));
    put(vpm, vertices.back(), Point(p.x(), p.y(), p.z()));
    if constexpr(!is_default_parameter<NamedParametersWM, internal_np::input_face_map_t>::value)
      put(get_parameter(np_wm, internal_np::input_face_map), vertices.back(), input_faces[triangles.input_face[i]]);
  }
  for(std::size_t i = 0; i < triangles.triangles.size(); ++i)
  {
    const std::array<int, 3>& t = triangles.triangles[i];
    const working_face_descriptor f = Euler::add_face(
      std::array<working_vertex_descriptor, 3>{ { vertices[t[0]], vertices[t[1]], vertices[t[2]] } }, wm);
    if constexpr(!is_default_parameter<NamedParametersWM, internal_np::edge_is_constrained_t>::value)
      for(working_halfedge_descriptor h : halfedges_around_face(halfedge(f, wm), wm))
        for(int k = 0; k < 3; ++k)
          if(source(h, wm) == vertices[t[k]])
            put(get_parameter(np_wm, internal_np::edge_is_constrained), edge(h, wm), triangles.is_feature[i][k] != 0);
  }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_WORKING_MESH_MAKE_WORKING_MESH_H
