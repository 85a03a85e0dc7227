// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GRID_MAP_PLAN_IMPL_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GRID_MAP_PLAN_IMPL_H

#include <CGAL/Quad_meshing/Pipeline/Grid_map_plan.h>
#include <CGAL/Quad_meshing/Pipeline/internal/quad_counts.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

typedef std::optional<Grid_map_plan> Optional_plan;

// The distortion of a seamless map from which another field is worth its time. Of 37 models at 4000 quads, five have
// more.
inline constexpr double least_distortion = 1.25;

inline bool is_folded(const Grid_map_situation& s) { return s.has_attempt && s.folded_triangles != 0; }

inline bool is_unfolded(const Grid_map_situation& s) { return s.has_attempt && s.folded_triangles == 0; }

inline Optional_plan plan_as_requested(const Grid_map_situation& s)
{
  Grid_map_plan plan;
  plan.new_field = s.requested_method;
  return plan;
}

inline Optional_plan plan_other_length(const Grid_map_situation& s)
{
  if(!is_folded(s) || s.folded_before_rounding != 0)
    return std::nullopt;
  const double shortest = 0.93, longest = 1.05; // within 16 percent of the number of quads
  Grid_map_plan plan;
  plan.relative_length = Random(s.random_seed).get_double(shortest, longest);
  return plan;
}

// Where the surface bends much, a map with few singularities is so distorted that it folds.
inline Optional_plan plan_more_singularities(const Grid_map_situation& s)
{
  if(!is_folded(s) || s.folded_before_rounding == 0 || s.requested_method != Cross_field_method::POLISHED)
    return std::nullopt;
  Grid_map_plan plan;
  plan.new_field = s.requested_method;
  plan.frees_singularities = true;
  return plan;
}

inline Optional_plan plan_other_field(const Grid_map_situation& s)
{
  if(!is_folded(s))
    return std::nullopt;
  Grid_map_plan plan;
  plan.new_field = s.requested_method == Cross_field_method::POLISHED ? Cross_field_method::REPRESENTATION
                                                                      : Cross_field_method::POLISHED;
  return plan;
}

// Where things lie so near to each other that no integers keep them apart, shorter edges give them room: more quads
// than were asked for are better than features that are not followed.
inline Optional_plan plan_shorter(const Grid_map_situation& s, double relative_length)
{
  if(!is_folded(s) || s.folded_before_rounding != 0)
    return std::nullopt;
  Grid_map_plan plan;
  plan.relative_length = relative_length;
  return plan;
}

// Where feature edges leave no room, those nearby are released, farther and farther around.
inline Optional_plan plan_release(const Grid_map_situation& s, double radius)
{
  if(!is_folded(s) || !s.has_releasable_features)
    return std::nullopt;
  Grid_map_plan plan;
  plan.new_field = s.method;
  plan.frees_singularities = s.frees_singularities;
  plan.release_radius = radius;
  return plan;
}

// Curves that leave no room for each other are given up in places rather than the mesh.
inline Optional_plan plan_release_curves(const Grid_map_situation& s, double radius)
{
  if(!is_folded(s) || !s.has_curves)
    return std::nullopt;
  Grid_map_plan plan;
  plan.new_field = s.method;
  plan.frees_singularities = s.frees_singularities;
  plan.release_radius = radius;
  plan.releases_curves = true;
  return plan;
}

// The grid of a map without fold-overs may still be too coarse for a mesh, where the surface is narrow.
inline Optional_plan plan_finer(const Grid_map_situation& s, double relative_length)
{
  if(!is_unfolded(s) || s.is_simple)
    return std::nullopt;
  Grid_map_plan plan;
  plan.relative_length = relative_length;
  return plan;
}

// Few singularities may make quads of very different sizes, or stretched ones, where the surface bends much.
inline Optional_plan plan_more_even_quads(const Grid_map_situation& s)
{
  if(!is_unfolded(s) || !s.has_singularity_cost || s.frees_singularities ||
     s.requested_method != Cross_field_method::POLISHED || s.distortion < least_distortion)
    return std::nullopt;
  Grid_map_plan plan;
  plan.new_field = s.requested_method;
  plan.frees_singularities = true;
  plan.evens_quads = true;
  return plan;
}

// Integers round lengths, most of all between features: the number of quads says by how much.
inline Optional_plan plan_nearer_number(const Grid_map_situation& s)
{
  if(!is_unfolded(s) || !s.is_simple || s.requested_quads == 0 || is_about(s.quads, s.requested_quads))
    return std::nullopt;
  const double largest_step = 1.25; // of the length: beyond it the next rounding is another one anyway
  const double step = std::sqrt(s.quads / s.requested_quads);
  Grid_map_plan plan;
  plan.relative_length = s.relative_length * (std::min)((std::max)(step, 1 / largest_step), largest_step);
  return plan;
}

} // namespace internal

CGAL_QUAD_MESHING_INLINE std::vector<Grid_map_plan_rule> default_grid_map_plans()
{
  // Each about doubles the number of quads at most, up to four times as many.
  auto shorter = [](double relative_length)
  { return [relative_length](const Grid_map_situation& s) { return internal::plan_shorter(s, relative_length); }; };
  auto release = [](double radius)
  { return [radius](const Grid_map_situation& s) { return internal::plan_release(s, radius); }; };
  auto release_curves = [](double radius)
  { return [radius](const Grid_map_situation& s) { return internal::plan_release_curves(s, radius); }; };
  auto finer = [](double relative_length)
  { return [relative_length](const Grid_map_situation& s) { return internal::plan_finer(s, relative_length); }; };
  return { { "as requested", internal::plan_as_requested },
           { "other length", internal::plan_other_length },
           { "more singularities", internal::plan_more_singularities },
           { "other field", internal::plan_other_field },
           { "shorter edges", shorter(0.85) },
           { "still shorter edges", shorter(0.7) },
           { "shortest edges", shorter(0.5) },
           { "release within 2", release(2) },
           { "release within 4", release(4) },
           { "release within 8", release(8) },
           { "release curves within 2", release_curves(2) },
           { "release curves within 8", release_curves(8) },
           { "finer", finer(0.95) },
           { "still finer", finer(0.9) },
           { "more even quads", internal::plan_more_even_quads },
           { "nearer number", internal::plan_nearer_number },
           { "still nearer number", internal::plan_nearer_number } };
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GRID_MAP_PLAN_IMPL_H
