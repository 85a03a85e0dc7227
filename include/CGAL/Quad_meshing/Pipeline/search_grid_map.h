// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_SEARCH_GRID_MAP_H
#define CGAL_QUAD_MESHING_PIPELINE_SEARCH_GRID_MAP_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_result.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <CGAL/number_utils.h>

#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingRef

\brief What `search_grid_map()` is asked for.
*/
struct Grid_map_request
{
  double edge_length = 0;       ///< of a quad, in the unit of the points
  double number_of_quads = 0;   ///< that the length stands for: the area of the component over its square
  double releasable_length = 0; ///< of the feature edges, if they may be released: `Feature_edges_result::length`
};

/*!
\ingroup PkgQuadMeshingRef

\brief The answer of `search_grid_map()`.
*/
struct Grid_map_search_result
{
  /// The quads of the best map; null if there is none.
  std::shared_ptr<Quadrangulation_quads> quads;
  /// The figures of field, map and quads. The status is `VALID` if there are quads that form a mesh.
  Quadrangulation_result figures;

  /// returns whether there are quads that form a mesh.
  bool is_valid() const { return figures.is_valid(); }
};

namespace internal {

CGAL_QUAD_MESHING_INLINE Grid_map_search_result search_grid_map(
  Quadrangulation_surface& surface, const std::vector<std::optional<Quadrangulation_kernel::Vector_3>>& direction,
  const std::vector<double>& weight, const Grid_map_request& request, const Quadrangulation_options& options,
  Any_visitor& visitor);

} // namespace internal

/*!
\ingroup PkgQuadMeshingRef

\brief makes quads of a component: the stage of `quadrangulate()` between `split_for_alignment()` and the smoothing.

Computes a cross field (`smooth_cross_field()`), an integer-grid map along it (`integer_grid_map()`), and the quads of
the map (`extract_quad_mesh()`, `transfer_feature_edges()`), by one plan after the other of
`Quadrangulation_options::plans`, and keeps the best. With the plan "as requested" alone it does no more than these four
functions one after the other.

\tparam FaceDirectionMap a model of `ReadablePropertyMap` with the faces of the surface as keys and an optional vector
as value type
\tparam FaceWeightMap a model of `ReadablePropertyMap` with the faces of the surface as keys and `double` as value type
\tparam Visitor a type with the members of `Default_visitor`

\param surface the triangles and their feature edges; receives field and map, and keeps those feature edges that were
not released
\param direction the directions that the field should have
\param weight their weights; infinite: the field has that direction
\param request the length and the number of the quads
\param options what is asked for; its edge length is only looked at for whether it is 0: then plans may change the
length for a number of quads that is nearer to the one asked for
\param visitor may stop the search

\sa `quadrangulate()`
*/
template <typename FaceDirectionMap, typename FaceWeightMap, typename Visitor>
Grid_map_search_result search_grid_map(Quadrangulation_surface& surface, FaceDirectionMap direction,
                                       FaceWeightMap weight, const Grid_map_request& request,
                                       const Quadrangulation_options& options, Visitor& visitor)
{
  typedef Quadrangulation_kernel::Vector_3 Vector_3;
  std::vector<std::optional<Vector_3>> directions;
  std::vector<double> weights;
  for(Quadrangulation_mesh::Face_index f : surface.mesh.faces())
  {
    const auto d = get(direction, f);
    directions.push_back(d ? std::make_optional(Vector_3(to_double(d->x()), to_double(d->y()), to_double(d->z())))
                           : std::nullopt);
    weights.push_back(to_double(get(weight, f)));
  }
  internal::Visitor_adaptor<Visitor> any_visitor(visitor);
  return internal::search_grid_map(surface, directions, weights, request, options, any_visitor);
}

/// \ingroup PkgQuadMeshingRef
/// \brief The same without a visitor.
template <typename FaceDirectionMap, typename FaceWeightMap>
Grid_map_search_result search_grid_map(Quadrangulation_surface& surface, FaceDirectionMap direction,
                                       FaceWeightMap weight, const Grid_map_request& request,
                                       const Quadrangulation_options& options = Quadrangulation_options())
{
  Default_visitor visitor;
  return search_grid_map(surface, direction, weight, request, options, visitor);
}

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Pipeline/internal/search_grid_map_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_PIPELINE_SEARCH_GRID_MAP_H
