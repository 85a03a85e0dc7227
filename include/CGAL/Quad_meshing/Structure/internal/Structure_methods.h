// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_METHODS_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_METHODS_H

#include <CGAL/Quad_meshing/Structure/internal/Accepted_shape.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_goals.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_optimizer.h>
#include <CGAL/Quad_meshing/Structure/internal/Shape_watch.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_optimizer.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>
#include <CGAL/Quad_meshing/Structure/internal/optimize_indexed_quad_structure.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Base_complex_arrays.h>
#include <CGAL/Quad_meshing/internal/Watched_visitor.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Looks for a coarse layout that reaches all goals, and gives the one that comes closest among those whose shape is
// accepted after smoothing, and that have not more helices than the input, or so few that these do no harm. Returns
// false if there is none.
// `smooth(state, sweeps)` smooths and returns what has been done.
template <typename Smooth>
bool find_layout(const Structure_optimizer& optimizer, const Structure_options& options, std::size_t target_patches,
                 const Accepted_shape& accepted, const Smooth& smooth, Any_visitor& visitor, Structure_state& best)
{
  // How many layouts are realized and smoothed after each search, and how many quads all of them have together at most.
  constexpr int layouts_per_search = 4;
  constexpr std::size_t most_quads = 400000;
  // The part of the running time that a first search may take, so that some is left for its layouts.
  constexpr double search_share = 0.5;
  const std::size_t quads = optimizer.state.mesh.corners.size();
  const std::size_t target = options.target_quads > 0       ? (std::min)(options.target_quads, quads)
                             : options.collapse_dual_curves ? 1
                                                            : quads;
  const int attempts = static_cast<int>(options.layouts);
  if(!visitor.go_further())
    return false;
  Layout_optimizer layout(optimizer.state, options.merge_singularities, target, target_patches,
                          options.is_layout_wanted);
  if(!visitor.go_further())
    return false;
  Watched_visitor searching(visitor, search_share * options.maximum_running_time);
  layout.search(attempts, searching);

  const int most_helices = layout.goals().tolerated_helices(optimizer.score().helices);
  Structure_state candidate;
  double least_price = Layout_cost::forbidden;
  std::size_t quads_tried = 0;
  bool is_done = false;
  for(int tried = 0; !is_done && quads_tried < most_quads && visitor.go_further() && layout.next(candidate, visitor);)
  {
    quads_tried += candidate.mesh.corners.size();
    const Structure_optimizer::Score score = Structure_optimizer::score_of(candidate.mesh);
    const Quad_mesh_smoothing_result shape = smooth(candidate, options.smoothing_iterations);
    const Layout_goals::Reached reached = layout.goals().reached(score.helices, score.patches, shape.quality_after);
    const bool is_accepted = score.helices <= most_helices && accepted.accepts(shape);
    if(is_accepted && reached.price < least_price)
    {
      least_price = reached.price;
      best = std::move(candidate);
    }
    is_done = is_accepted && reached.all && accepted.is_good(shape);
    if(++tried == layouts_per_search && !is_done)
    {
      const bool any = least_price < Layout_cost::forbidden;
      is_done = !layout.search_again(attempts, !any, visitor) && any;
      tried = 0;
    }
  }
  return least_price < Layout_cost::forbidden;
}

// Takes the best layout that is found. If there is none, the mesh stays as it is.
template <typename Smooth>
void optimize_layout(Structure_optimizer& optimizer, const Structure_options& options, const Accepted_shape& accepted,
                     const Smooth& smooth, Any_visitor& visitor)
{
  Structure_state best;
  bool is_found = find_layout(optimizer, options, options.target_patches, accepted, smooth, visitor, best);
  auto patches = [](const Structure_state& s) { return std::size_t(number_of_base_complex_patches(s.mesh)); };
  // As coarse as a target that is out of reach, layouts have a shape that is not accepted, and what is left is worse
  // than what a search without it finds.
  if(options.target_patches > 0 && (!is_found || patches(best) > options.target_patches))
  {
    Structure_state other;
    if(find_layout(optimizer, options, 0, accepted, smooth, visitor, other) &&
       (!is_found || patches(other) < patches(best)))
    {
      is_found = true;
      best = std::move(other);
    }
  }
  if(is_found)
    optimizer.set_state(std::move(best));
}

// The greedy removal of helices. What spoils the shape of the quads is taken back.
template <typename Watch, typename TargetReached>
void remove_helices(Structure_optimizer& optimizer, Watch& watch, const TargetReached& target_reached,
                    Any_visitor& visitor)
{
  // How often operators are taken back before no more are tried.
  constexpr int most_undone = 20;
  const double helices = (std::max)(1., double(optimizer.score().helices_with_crossings));
  auto go_further = [&] { return visitor.go_further(); };
  int undone = 0;
  auto undo = [&]
  {
    watch.undo();
    ++undone;
  };
  Structure_optimizer::Score before;
  do
  {
    before = optimizer.score();
    while(!target_reached() && undone < most_undone && optimizer.remove_next_helix(go_further))
    {
      if(!watch.accepts_next())
        undo();
      visitor.progress((std::max)(0., (std::min)(1., 1 - optimizer.score().helices_with_crossings / helices)));
    }
    if(!watch.accepts())
      undo();
  }
  // helices that could not be removed at first get a second chance after others have gone
  while(optimizer.score().is_better_than(before) && !target_reached() && undone < most_undone &&
        optimizer.forget_failures() && visitor.go_further());
}

// Collapses dual curves. If the shape is not accepted in the end, the last ones are taken back; and if the base complex
// has become finer than it was on the way, the mesh with the coarsest one is.
template <typename Watch, typename TargetReached>
void collapse_dual_curves(Structure_optimizer& optimizer, Watch& watch, const TargetReached& target_reached,
                          Any_visitor& visitor)
{
  auto go_further = [&] { return visitor.go_further(); };
  // as coarse and with fewer quads is better, too
  Structure_state coarsest = optimizer.state;
  int least_patches = optimizer.score().patches;
  while(!target_reached() && visitor.go_further() && optimizer.collapse_next_dual_curve(go_further))
    if(watch.accepts_next() && optimizer.score().patches <= least_patches)
    {
      least_patches = optimizer.score().patches;
      coarsest = optimizer.state;
    }
  if(!watch.accepts())
    watch.undo();
  if(optimizer.score().patches > least_patches && !target_reached())
  {
    const Structure_state last = optimizer.state;
    optimizer.set_state(std::move(coarsest));
    if(!watch.accepts_next() || !watch.accepts())
      optimizer.set_state(last);
  }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_METHODS_H
