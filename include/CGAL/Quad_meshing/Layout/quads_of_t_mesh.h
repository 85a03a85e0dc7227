// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_QUADS_OF_T_MESH_H
#define CGAL_QUAD_MESHING_LAYOUT_QUADS_OF_T_MESH_H

#include <CGAL/Quad_meshing/Layout/internal/T_mesh_placement.h>
#include <CGAL/Quad_meshing/Parameterization/T_mesh.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingLayoutRef

\brief The quads that a T-mesh with integer lengths stands for.
*/
struct T_mesh_quads
{
  std::vector<T_mesh::Location> vertices;                ///< their places on the triangle mesh
  std::vector<std::array<std::size_t, 4>> quads;         ///< their vertices, counterclockwise
  std::vector<std::array<std::size_t, 2>> aligned_edges; ///< those along features and borders: their vertices
};

/*!
\ingroup PkgQuadMeshingLayoutRef

\brief makes the quads of a T-mesh: in each patch a grid, whose lines are straight in the map from side to side.

Where arcs have length 0, vertices of the T-mesh come together: critical nodes stay where they are, features take what
lies beside them, and other vertices meet in the middle. So quads can be badly shaped there, or folded over; their
vertices have to be moved (`smooth_quad_mesh()`).

\param t the T-mesh
\param lengths the lengths of its arcs, as `quantize_t_mesh()` chooses them

\pre `t` is valid, and the lengths are of `quantize_t_mesh()` for it
*/
inline T_mesh_quads quads_of_t_mesh(const T_mesh& t, const std::vector<int>& lengths)
{
  internal::T_mesh_placement placement(t, lengths);
  T_mesh_quads result;
  result.vertices = placement.locations();
  for(const internal::T_mesh_grid::Quad& q : placement.grid().quads)
  {
    result.quads.emplace_back();
    for(int k = 0; k < 4; ++k)
      result.quads.back()[k] = placement.vertex(q.points[k]);
  }
  for(const auto& e : placement.grid().aligned_edges)
    result.aligned_edges.push_back({ { placement.vertex(e.points[0]), placement.vertex(e.points[1]) } });
  return result;
}

/*!
\ingroup PkgQuadMeshingLayoutRef

\brief writes the quads of a T-mesh into a mesh.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam QuadMesh a model of `MutableFaceGraph` and `EdgeListGraph`
\tparam QuadEdgeIsFeatureMap a model of `WritablePropertyMap` with
        `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\param t the T-mesh
\param lengths the lengths of its arcs, as `quantize_t_mesh()` chooses them
\param tm the triangle mesh that the map of `t` was computed for
\param qm the output; it must be empty
\param quad_edge_is_feature is set for the edges that lie on features, not for those on the border
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{face_location_map}
    \cgalParamDescription{a property map that receives for each vertex of `qm` the place on `tm` where it lies}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<QuadMesh>::%vertex_descriptor`
                   as key type and `Polygon_mesh_processing::Face_location<TriangleMesh, double>` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{the property map with the numbers of the faces of `tm` that the map was computed with}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return whether the quads form a mesh; if not, `qm` is empty

\pre `t` is valid, and the lengths are of `quantize_t_mesh()` for it
*/
template <typename TriangleMesh, typename QuadMesh, typename QuadEdgeIsFeatureMap,
          typename NamedParameters = parameters::Default_named_parameters>
bool quads_of_t_mesh(const T_mesh& t, const std::vector<int>& lengths, const TriangleMesh& tm, QuadMesh& qm,
                     QuadEdgeIsFeatureMap quad_edge_is_feature,
                     const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  typedef boost::graph_traits<QuadMesh> Graph_traits;
  typedef typename boost::property_map<QuadMesh, vertex_point_t>::type Vertex_point_map;
  typedef typename boost::property_traits<Vertex_point_map>::value_type Point;

  internal::check_parameters<NamedParameters, internal_np::face_index_t, internal_np::face_location_map_t>();

  const T_mesh_quads quads = quads_of_t_mesh(t, lengths);
  const auto fim = internal::face_numbers(tm, np);
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> face_of_index(num_faces(tm));
  for(auto f : faces(tm))
    face_of_index[get(fim, f)] = f;
  Vertex_point_map vpm = get(vertex_point, qm);
  std::vector<typename Graph_traits::vertex_descriptor> vertex;
  for(const T_mesh::Location& l : quads.vertices)
  {
    const std::array<double, 3> p = t.position(l);
    vertex.push_back(add_vertex(qm));
    put(vpm, vertex.back(), Point(p[0], p[1], p[2]));
    if constexpr(!is_default_parameter<NamedParameters, internal_np::face_location_map_t>::value)
      put(get_parameter(np, internal_np::face_location_map), vertex.back(),
          std::make_pair(face_of_index[l.first], l.second));
  }
  bool is_mesh = true;
  for(const auto& q : quads.quads)
    is_mesh = is_mesh &&
              Euler::add_face(std::array<typename Graph_traits::vertex_descriptor, 4>{ { vertex[q[0]], vertex[q[1]],
                                                                                         vertex[q[2]], vertex[q[3]] } },
                              qm) != Graph_traits::null_face();
  for(const auto& e : quads.aligned_edges)
  {
    const auto found = halfedge(vertex[e[0]], vertex[e[1]], qm);
    is_mesh = is_mesh && found.second;
    if(is_mesh)
      put(quad_edge_is_feature, edge(found.first, qm), !is_border_edge(found.first, qm));
  }
  if(!is_mesh)
    clear(qm);
  return is_mesh;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_QUADS_OF_T_MESH_H
