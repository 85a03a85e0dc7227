// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_TRACE_GRID_GRAPH_H
#define CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_TRACE_GRID_GRAPH_H

#include <CGAL/Quad_meshing/Extraction/internal/Grid_graph.h>
#include <CGAL/Quad_meshing/Extraction/internal/Isoline_tracer.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Traces all rays. The progress runs to `end`; returns whether the visitor let it.
inline bool make_grid_graph(const Grid_map& map, const Grid_nodes& nodes, Grid_graph& g, Stage_progress& progress,
                            double begin, double end)
{
  const int rays_per_report = 0x1000; // each is followed over some triangles

  const int UNKNOWN = -4;
  const int n = nodes.number_of_rays();
  g.node = nodes.ray_node;
  g.sign = nodes.ray_sign;
  g.length.assign(n, 1);
  g.open_on_left.assign(n, false);
  g.opposite.assign(n, UNKNOWN);
  g.ccw.assign(n, Grid_graph::NONE);
  g.cw.assign(n, Grid_graph::NONE);
  g.first.assign(nodes.number_of_nodes(), Grid_graph::NONE);

  for(int i = 0; i < nodes.number_of_nodes(); ++i)
  {
    int last = Grid_graph::NONE;
    for(int r = nodes.first_ray[i]; r < nodes.first_ray[i + 1]; ++r)
    {
      if(nodes.mate[r] != -1)
      {
        g.opposite[r] = Grid_graph::REMOVED;
        continue;
      }
      if(last == Grid_graph::NONE)
        g.first[i] = r;
      else
      {
        g.ccw[last] = r;
        g.cw[r] = last;
      }
      last = r;
    }
    if(last != Grid_graph::NONE && !nodes.on_border[i])
    {
      g.ccw[last] = g.first[i];
      g.cw[g.first[i]] = last;
    }
  }

  Isoline_tracer trace(map, nodes);
  for(int r = 0; r < n; ++r)
  {
    if(r % rays_per_report == 0 && !progress.go_further(begin + (end - begin) * r / n))
      return false;
    if(g.opposite[r] != UNKNOWN)
      continue;
    const int o = trace(r);
    if(o >= 0 && o != r && g.opposite[o] == UNKNOWN)
    {
      g.opposite[r] = o;
      g.opposite[o] = r;
      g.length[r] = g.length[o] = static_cast<signed char>(trace.length());
      g.open_on_left[r] = trace.is_open_on_left();
      g.open_on_left[o] = trace.is_open_on_right();
    }
    else
      g.opposite[r] = (o == Isoline_tracer::LEAVES_THE_SURFACE) ? Grid_graph::CUT_BY_BORDER : Grid_graph::FAILED;
  }
  return true;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_EXTRACTION_INTERNAL_TRACE_GRID_GRAPH_H
