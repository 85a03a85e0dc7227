// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_GRID_MAP_PLAN_H
#define CGAL_QUAD_MESHING_PIPELINE_GRID_MAP_PLAN_H

#include <CGAL/Quad_meshing/Fields/Cross_field_result.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingRef

\brief One way to make an integer-grid map and a quad mesh of a surface.

A plan starts from the best attempt so far and says what it does otherwise.
*/
struct Grid_map_plan
{
  /// The method by which the cross field is computed anew; none: the field of the best attempt stays.
  std::optional<Cross_field_method> new_field;
  /// Whether singularities of the new field cost nothing but what they add to its energy
  /// (`Quadrangulation_options::singularity_cost`).
  bool frees_singularities = false;
  /// Whether the new field is of use only if its seamless map is markedly less distorted than that of the best attempt.
  bool evens_quads = false;
  /// The length of quad edges over the one asked for.
  double relative_length = 1;
  /// Feature edges with an end this near to the folded triangles of the best attempt are released: they need not be
  /// followed. In target edge lengths; 0 releases none.
  double release_radius = 0;
  /// Whether curves of the user are released as well (`Quadrangulation_options::feature_curves`).
  bool releases_curves = false;
};

/*!
\ingroup PkgQuadMeshingRef

\brief What the rules of a quadrangulation know when they decide whether to try a plan.
*/
struct Grid_map_situation
{
  Cross_field_method requested_method = Cross_field_method::POLISHED;
  unsigned int random_seed = 0;
  /// Whether there are feature edges that may be released: detected ones, not those of the user.
  bool has_releasable_features = false;
  /// Whether there are curves of the user.
  bool has_curves = false;
  /// The number of quads that was asked for; 0 if an edge length was.
  double requested_quads = 0;
  /// Whether singularities cost something (`Quadrangulation_options::singularity_cost`).
  bool has_singularity_cost = false;

  /// \name The Best Attempt So Far
  /// @{
  bool has_attempt = false;               ///< whether there is one; the members below have no meaning else
  std::size_t folded_triangles = 0;       ///< of its map
  std::size_t folded_before_rounding = 0; ///< of its seamless map, before integers were chosen
  double distortion = 1;                  ///< of its seamless map, see `Seamless_map::distortion()`
  bool is_simple = true;                  ///< whether its quads form a mesh, if no triangle is folded
  std::size_t quads = 0;                  ///< of its mesh, if no triangle is folded
  double relative_length = 1;             ///< of its plan
  bool frees_singularities = false;       ///< of the plan of its field
  Cross_field_method method = Cross_field_method::POLISHED; ///< of its field
  /// @}
};

/*!
\ingroup PkgQuadMeshingRef

\brief A rule of a quadrangulation: gives a plan for a situation, or none if it does not apply.

Rules have no state. `Quadrangulation_options::plans` lists them in the order in which they are asked, each once.
*/
struct Grid_map_plan_rule
{
  std::string name;
  std::function<std::optional<Grid_map_plan>(const Grid_map_situation&)> plan;
};

/*!
\ingroup PkgQuadMeshingRef

\brief returns the rules that `quadrangulate()` follows.

- "as requested": the field and the length that were asked for.
- "other length": the same field for another length, drawn by the random seed, where the integers are to blame for
folded triangles. That can only happen where there is no T-mesh to choose them by, as borders need not be aligned.
- "more singularities": a `POLISHED` field whose singularities cost nothing, where the seamless map is folded.
- "other field": a field whose singularities lie elsewhere: of `REPRESENTATION` if `POLISHED` was asked for, else of
`POLISHED`.
- "shorter edges", "still shorter edges", "shortest edges": 0.85, 0.7 and 0.5 times the length, where integers are to
blame for folded triangles and there is no T-mesh; the message says that there are more quads than were asked for.
- "release within 2", "release within 4", "release within 8": without the detected feature edges that are this near to
folded triangles.
- "release curves within 2", "release curves within 8": without the curves of the user there, the last resort; the
answer names them.
- "finer", "still finer": where the map has no folded triangle, but its grid is too coarse for a mesh, and there is no
T-mesh.
- "more even quads": a `POLISHED` field whose singularities cost nothing, where the seamless map is distorted much; it
is taken if its map is distorted markedly less.
- "nearer number", "still nearer number": another length where the number of quads is far from the one asked for.
*/
CGAL_QUAD_MESHING_INLINE std::vector<Grid_map_plan_rule> default_grid_map_plans();

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/Pipeline/internal/Grid_map_plan_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_PIPELINE_GRID_MAP_PLAN_H
