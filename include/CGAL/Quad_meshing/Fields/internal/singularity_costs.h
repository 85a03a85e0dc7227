// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_SINGULARITY_COSTS_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_SINGULARITY_COSTS_H

#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/internal/Distance_front.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What a singularity costs at every vertex, in units of the energy, besides what it adds to the energy:
// `singularity_cost`, and something more near aligned edges but not on them, where it would share a coordinate with the
// edge after rounding. Near is less than half the target edge length, measured along mesh edges and across the faces at
// the aligned edges.
inline std::vector<double> singularity_costs(const Field_problem& problem, double target_edge_length,
                                             double singularity_cost)
{
  // A singularity costs about 0.5 of smoothness energy; so much is worth avoiding the trap.
  const double trap_cost = 0.3;

  const Indexed_triangle_mesh& m = problem.mesh;
  std::vector<double> cost(m.number_of_vertices(), singularity_cost);
  if(!(target_edge_length > 0))
    return cost;
  const double reach = 0.5; // in target edge lengths
  auto relative = [&](double length, int v) { return length / problem.length_at(v, target_edge_length); };

  Distance_front front(m.number_of_vertices());
  auto reach_vertex = [&](int v, double d)
  {
    if(d < reach)
      front.reach(v, d);
  };
  for(int h = 0; h < m.number_of_halfedges(); ++h)
    if(problem.aligned[m.edge_of[h]])
    {
      reach_vertex(m.source(h), 0.);
      reach_vertex(m.target(h), 0.);
      const double side = std::sqrt(m.vector(m.prev(h)).squared_length());
      reach_vertex(m.source(m.prev(h)),
                   relative(side * std::abs(std::sin(problem.frames.corner_angle(h))), m.source(m.prev(h))));
    }
  std::vector<std::vector<int>> around(m.number_of_vertices());
  for(int h = 0; h < m.number_of_halfedges(); ++h)
  {
    around[m.source(h)].push_back(h);
    if(m.opposite[h] == -1)
      around[m.target(h)].push_back(h);
  }
  int v;
  for(double d; front.pop(v, d);)
  {
    if(d > 0)
      cost[v] += trap_cost;
    for(int h : around[v])
      reach_vertex(m.source(h) == v ? m.target(h) : m.source(h),
                   d + relative(std::sqrt(m.vector(h).squared_length()), v));
  }
  return cost;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_SINGULARITY_COSTS_H
