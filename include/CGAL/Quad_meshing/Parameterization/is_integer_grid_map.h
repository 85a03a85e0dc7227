// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_IS_INTEGER_GRID_MAP_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_IS_INTEGER_GRID_MAP_H

#include <CGAL/Quad_meshing/Parameterization/internal/check_grid_map.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/internal/copy_corners.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/parameter_checks.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief The answer of `is_integer_grid_map()`: which simplices break which condition.

\tparam TriangleMesh a model of `HalfedgeListGraph` and `FaceListGraph`
*/
template <typename TriangleMesh>
struct Integer_grid_map_report
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  /// Edges whose two images no rotation by a multiple of 90 degrees and integer translation maps onto each other.
  std::vector<edge_descriptor> edges_without_transition;
  /// Singular vertices that do not lie on a grid point.
  std::vector<vertex_descriptor> vertices_off_grid;
  /// Faces whose image is folded over or has no area.
  std::vector<face_descriptor> folded_faces;
  /// Edges that had to lie on a grid line and do not.
  std::vector<edge_descriptor> edges_off_grid;
  /// Faces with a coordinate that is not finite.
  std::vector<face_descriptor> faces_not_finite;

  /// Whether all conditions hold.
  bool is_valid() const
  {
    return edges_without_transition.empty() && vertices_off_grid.empty() && folded_faces.empty() &&
           edges_off_grid.empty() && faces_not_finite.empty();
  }

  /// \copydoc is_valid()
  explicit operator bool() const { return is_valid(); }

  /// The same as a sentence.
  std::string message() const
  {
    if(is_valid())
      return "The map is an integer-grid map.";
    std::string s;
    auto add = [&s](std::size_t n, const char* what)
    {
      if(n != 0)
        s += (s.empty() ? "" : ", ") + std::to_string(n) + " " + what;
    };
    add(faces_not_finite.size(), "faces with coordinates that are not finite");
    add(folded_faces.size(), "folded or degenerate faces");
    add(edges_without_transition.size(), "edges without a grid automorphism across");
    add(vertices_off_grid.size(), "singular vertices off the grid points");
    add(edges_off_grid.size(), "aligned edges off the grid lines");
    return "The map has " + s + ".";
  }
};

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief tells, exactly, whether a map is an integer-grid map.

The three conditions are those of [Bom12, 6]: the transition across every edge is a rotation by a multiple of
90 degrees and an integer translation; every singular vertex lies on a grid point; every triangle is positively
oriented. Edges in `edge_is_constrained_map`, and border edges unless `align_boundary` is `false`, must moreover lie on
integer grid lines. Nothing is compared with a tolerance.

A vertex inside the surface is singular if the number of grid directions that leave it is not four.

\tparam TriangleMesh a model of `HalfedgeListGraph` and `FaceListGraph`
\tparam HalfedgeUVMap a model of `ReadablePropertyMap` with the halfedges as keys and a two-dimensional point over
        `double` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param uv the map: for each halfedge that is no border halfedge, the image of its target in the chart of its face
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{align_boundary}
    \cgalParamDescription{whether border edges must lie on grid lines}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that must lie on grid lines}
    \cgalParamType{a model of `ReadablePropertyMap` with value type `bool`}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{consecutive numbers of the vertices from 0}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{consecutive numbers of the faces from 0}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the report, which converts to `bool`; the simplices are in the order of their numbers

\pre `is_triangle_mesh(tm)`
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Integer_grid_map_report<TriangleMesh> is_integer_grid_map(const TriangleMesh& tm, HalfedgeUVMap uv,
                                                          const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  constexpr bool takes_parameters =
    internal::Takes_parameters<NamedParameters, internal_np::align_boundary_t, internal_np::edge_is_constrained_t,
                               internal_np::vertex_point_t, internal_np::vertex_index_t,
                               internal_np::face_index_t>::value;
  static_assert(takes_parameters, "is_integer_grid_map() does not take one of the named parameters.");
  constexpr bool has_edge_map =
    internal::map_parameter_is_readable<internal_np::edge_is_constrained_t, NamedParameters, edge_descriptor, bool>();
  static_assert(has_edge_map, "edge_is_constrained_map must give a bool for every edge of the triangle mesh.");

  CGAL_precondition(is_triangle_mesh(tm));

  const bool align_boundary = choose_parameter(get_parameter(np, internal_np::align_boundary), true);
  auto is_constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                         Static_boolean_property_map<edge_descriptor, false>());
  const auto vim = internal::vertex_numbers(tm, np);
  const auto fim = internal::face_numbers(tm, np);
  const internal::Indexed_triangle_mesh mesh = internal::make_indexed_triangle_mesh(tm, np);
  std::vector<bool> is_aligned(mesh.number_of_edges());
  std::vector<edge_descriptor> edge_of_number(mesh.number_of_edges());
  internal::for_each_edge_of_faces(tm,
                                   [&](edge_descriptor e, int i)
                                   {
                                     edge_of_number[i] = e;
                                     is_aligned[i] =
                                       get(is_constrained, e) || (align_boundary && mesh.is_border_edge(i));
                                   });
  std::vector<vertex_descriptor> vertex_of_number(mesh.number_of_vertices());
  for(vertex_descriptor v : vertices(tm))
    vertex_of_number[get(vim, v)] = v;
  std::vector<face_descriptor> face_of_number(mesh.number_of_faces());
  for(face_descriptor f : faces(tm))
    face_of_number[get(fim, f)] = f;

  const internal::Grid_map_defects defects =
    internal::check_grid_map(mesh, internal::copy_corners(tm, uv, fim), is_aligned);
  Integer_grid_map_report<TriangleMesh> report;
  auto translate = [](const std::vector<int>& numbers, const auto& descriptor_of, auto& descriptors)
  {
    for(int i : numbers)
      descriptors.push_back(descriptor_of[i]);
  };
  translate(defects.faces_not_finite, face_of_number, report.faces_not_finite);
  translate(defects.folded_faces, face_of_number, report.folded_faces);
  translate(defects.edges_without_transition, edge_of_number, report.edges_without_transition);
  translate(defects.edges_off_grid, edge_of_number, report.edges_off_grid);
  translate(defects.vertices_off_grid, vertex_of_number, report.vertices_off_grid);
  return report;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_IS_INTEGER_GRID_MAP_H
