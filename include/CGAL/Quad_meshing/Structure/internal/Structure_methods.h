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
#include <CGAL/Quad_meshing/Structure/internal/Layout_helices.h>
#include <CGAL/Quad_meshing/Structure/internal/Layout_optimizer.h>
#include <CGAL/Quad_meshing/Structure/internal/Shape_watch.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_optimizer.h>
#include <CGAL/Quad_meshing/Structure/internal/Structure_state.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

struct Structure_options
{
  bool merge_singularities = false;
  bool collapse_dual_curves = false;
  std::size_t target_quads = 0;
  std::size_t target_patches = 0;
  unsigned int layouts = 10000;
  unsigned int smoothing_iterations = 20;
};

// Looks for a coarse layout and takes one on which the smoothing leaves good quads and that has few helices: the best one, or
// one with better quads among the next few. If there are only others, the one with the fewest helices and patches among
// these is taken; if the shape of none is accepted, the mesh stays as it is. `smooth(state, sweeps)` smooths and returns
// what has been done.
template <typename Smooth, typename Visitor>
void optimize_layout(Structure_optimizer& optimizer, const Structure_options& options, const Accepted_shape& accepted,
                     const Smooth& smooth, Visitor& visitor)
{
  // How many layouts are tried before others are looked for; how many more for better quads once one is accepted, fewer on
  // large meshes: as many as have together so many quads. And how many quads all layouts have together that are tried.
  constexpr int layouts_per_search = 4;
  constexpr std::size_t further_layouts = 4, further_quads = 20000, most_quads = 400000;
  const std::size_t quads = optimizer.state.mesh.corners.size();
  const std::size_t target = options.target_quads > 0 ? (std::min)(options.target_quads, quads)
                           : options.collapse_dual_curves ? 1 : quads;
  const Structure_optimizer::Score before = optimizer.score();
  const double most_helices = Layout_helices::tolerated_part * before.helices;
  const int attempts = static_cast<int>(options.layouts);
  auto go_further = [&] { return visitor.go_further(); };
  auto progress = [&](double p) { visitor.progress(p); };
  Layout_optimizer layout(optimizer.state, options.merge_singularities, target, options.target_patches);
  layout.search(attempts, go_further, progress);

  Structure_state best, candidate;
  bool is_found = false, may_search = true;
  double best_jacobian = 0, best_size = 0;
  int best_helices = 0, tried = 0;
  std::size_t quads_tried = 0;
  int left = static_cast<int>((std::min)(further_layouts, further_quads / quads));
  while(left >= 0 && quads_tried < most_quads && visitor.go_further() && layout.next(candidate))
  {
    quads_tried += candidate.mesh.corners.size();
    const Structure_optimizer::Score score = Structure_optimizer::score_of(candidate.mesh);
    const int helices = score.helices;
    const double size = double(helices) / (std::max)(1, before.helices) + double(score.patches) / before.patches;
    const bool has_few = helices <= most_helices;
    const Quad_mesh_smoothing_result shape = smooth(candidate, options.smoothing_iterations);
    const bool is_accepted = accepted.accepts(shape);
    if(is_accepted)
    {
      const double jacobian = shape.quality_after.minimal_scaled_jacobian;
      const bool is_better = has_few ? best_helices > most_helices || jacobian > best_jacobian
                                      : best_helices > most_helices && size < best_size;
      const bool is_good = accepted.is_good(shape);
      if(!is_found || is_better)
      {
        best_jacobian = jacobian;
        best_helices = helices;
        best_size = size;
        best = std::move(candidate);
      }
      is_found = true;
      if(has_few && is_good)
        break;
    }
    if(is_found && (best_helices <= most_helices || (is_accepted && !may_search)))
      --left;
    if(++tried == layouts_per_search && (!is_found || best_helices > most_helices))
    {
      tried = 0;
      may_search = may_search && layout.search_again(attempts, go_further, progress);
    }
  }
  if(is_found)
    optimizer.set_state(std::move(best));
}

// The greedy removal of helices. What spoils the shape of the quads is taken back.
template <typename Watch, typename TargetReached, typename Visitor>
void remove_helices(Structure_optimizer& optimizer, Watch& watch, const TargetReached& target_reached, Visitor& visitor)
{
  // How often operators are taken back before no more are tried.
  constexpr int most_undone = 20;
  const double helices = (std::max)(1., double(optimizer.score().helices));
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
      visitor.progress((std::max)(0., (std::min)(1., 1 - optimizer.score().helices / helices)));
    }
    if(!watch.accepts())
      undo();
  }
  // helices that could not be removed at first get a second chance after others have gone
  while(optimizer.score() < before && !target_reached() && undone < most_undone && optimizer.forget_failures()
        && visitor.go_further());
}

// Collapses dual curves. If the shape is not accepted in the end, the last ones are taken back.
template <typename Watch, typename TargetReached, typename Visitor>
void collapse_dual_curves(Structure_optimizer& optimizer, Watch& watch, const TargetReached& target_reached, Visitor& visitor)
{
  while(!target_reached() && visitor.go_further() && optimizer.collapse_next_dual_curve())
    watch.accepts_next();
  if(!watch.accepts())
    watch.undo();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_STRUCTURE_METHODS_H
