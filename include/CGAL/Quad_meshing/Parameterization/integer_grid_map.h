// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTEGER_GRID_MAP_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTEGER_GRID_MAP_H

#include <CGAL/Quad_meshing/Parameterization/Seamless_map.h>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief computes an integer-grid map that follows a cross field.

The mesh is cut to disks through all singular vertices, the field is combed over them, and the map is sought whose
gradients are nearest to the combed directions, divided by the target edge length [Bom12, 8.4]. Singular vertices have
to lie on grid points, constrained edges and border edges on grid lines, and the transitions across cuts have to be
grid automorphisms. All these linear conditions are eliminated in integer arithmetic before anything is optimized. Then

- the map without integer conditions is computed and fold-overs are removed from it;
- the integers are rounded with the given method; grid points and lines that meet in the rounded map, but not in the one
  before, are kept apart by further conditions, and the rounding is repeated;
- fold-overs that the integers leave are removed by minimizing the regularized distortion of
  Garanzha et al., "Foldover-free maps in 50 lines of code" (2021), where they are;
- real variables are rounded to multiples of a power of two, so that every condition holds exactly for the numbers
written.

The result is `VALID` if no triangle is folded, by exact predicates; `is_integer_grid_map()` then says yes, too. That is
no guarantee to find such a map: if integers leave no room for one, the result is `FOLDED` and names the faces.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam FaceAngleMap a model of `ReadablePropertyMap` with the faces as keys and `double` as value type
\tparam EdgePeriodJumpMap a model of `ReadablePropertyMap` with the edges as keys and `int` as value type
\tparam VertexSingularityMap a model of `ReadablePropertyMap` with the vertices as keys and `int` as value type
\tparam HalfedgeUVMap a model of `WritablePropertyMap` with the halfedges as keys and a two-dimensional point
        that can be constructed from two `double` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh; a triangle with two constrained edges cannot be mapped without being folded, see
       `split_for_alignment()`
\param angle, period_jump, index the cross field as `smooth_cross_field()` writes it, aligned with the constrained
       edges; see `check_cross_field()` for one that was edited
\param uv receives the map: for each halfedge that is no border halfedge, the image of its target in the chart of its
face
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length of a quad edge, in the unit of the points}
    \cgalParamType{`double`}
    \cgalParamDefault{the mean edge length of `tm`}
  \cgalParamNEnd
  \cgalParamNBegin{face_sizing_map}
    \cgalParamDescription{the target edge length per face; takes precedence over `target_edge_length`}
    \cgalParamType{a model of `ReadablePropertyMap` with the faces as keys and `double` as value type}
    \cgalParamDefault{constant}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that have to lie on grid lines}
    \cgalParamType{a model of `ReadablePropertyMap` with the edges as keys and `bool` as value type}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
  \cgalParamNBegin{face_direction_weight_map}
    \cgalParamDescription{how much a face counts, besides its area: where it is large, the map follows the cross field
      and the lengths more exactly than elsewhere}
    \cgalParamType{a model of `ReadablePropertyMap` with the faces of `tm` as keys and `double` as value type, positive}
    \cgalParamDefault{1 everywhere}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{vertices that become vertices of quads: they lie on grid points, whatever their index is}
    \cgalParamType{a model of `ReadablePropertyMap` with the vertices of `tm` as keys and `bool` as value type}
    \cgalParamDefault{the singular vertices alone}
  \cgalParamNEnd
  \cgalParamNBegin{align_boundary}
    \cgalParamDescription{whether border edges have to lie on grid lines; the field must be aligned likewise}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{rounding_method}
    \cgalParamDescription{how integers are chosen}
    \cgalParamType{`Rounding_method`}
    \cgalParamDefault{`Rounding_method::GREEDY`}
  \cgalParamNEnd
  \cgalParamNBegin{anisotropy_weight}
    \cgalParamDescription{the weight of the length of quads against their direction, in (0, 1] [Bom12, 8.4, "Anisotropic
    norm"]}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{stiffening_iterations}
    \cgalParamDescription{the largest number of times that the energy is weighted anew where triangles are distorted
                          [Bom12, 8.4, "Local stiffening"], as long as there are folded ones}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{5}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_threads}
    \cgalParamDescription{how many threads may work at the same time; the result does not depend on it}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told about the stages and may stop them, see `Default_visitor`; pass it by `std::ref`}
    \cgalParamDefault{`Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the figures and, if there are any, the folded faces

\sa `Seamless_map`
*/
template <typename TriangleMesh, typename FaceAngleMap, typename EdgePeriodJumpMap, typename VertexSingularityMap,
          typename HalfedgeUVMap, typename NamedParameters = parameters::Default_named_parameters>
Integer_grid_map_result integer_grid_map(const TriangleMesh& tm, FaceAngleMap angle, EdgePeriodJumpMap period_jump,
                                         VertexSingularityMap index, HalfedgeUVMap uv,
                                         const NamedParameters& np = parameters::default_values())
{
  Seamless_map map(tm, angle, period_jump, index, np);
  if(!map.is_solved())
    return map.result();
  Integer_grid_map_result result = map.round(tm, 1, uv, np);
  result.seconds += map.result().seconds;
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTEGER_GRID_MAP_H
