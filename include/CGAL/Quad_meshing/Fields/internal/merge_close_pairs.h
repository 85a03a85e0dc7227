// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors
#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_MERGE_CLOSE_PAIRS_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_MERGE_CLOSE_PAIRS_H

#include <CGAL/Quad_meshing/Fields/internal/Dual_laplacian.h>
#include <CGAL/Quad_meshing/Fields/internal/Field_problem.h>
#include <CGAL/Quad_meshing/Fields/internal/Sector_quads.h>

#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A path of halfedges from a vertex with three quads to the nearest one with five, over vertices without
// aligned edges and not longer than `reach`; empty if there is none.
inline std::vector<int> path_to_opposite_singularity(const Field_problem& problem, const Sector_quads& quads, int sector, double reach)
{
  typedef std::pair<double, int> Entry;
  const Indexed_triangle_mesh& m = problem.mesh;
  const Field_sectors& sectors = problem.sectors;

  std::map<int, std::pair<double, int> > reached; // per sector: distance and halfedge that leads there
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
  reached[sector] = std::make_pair(0., -1);
  queue.push(Entry(0., sector));
  while(!queue.empty())
  {
    const Entry top = queue.top();
    queue.pop();
    const int s = top.second;
    if(top.first > reached[s].first)
      continue;
    if(quads.state()[s] == 5)
    {
      std::vector<int> path;
      for(int h = reached[s].second; h != -1; h = reached[sectors.of_corner[h]].second)
        path.push_back(h);
      return path;
    }
    const int first = sectors.first_corner[s];
    int h = first;
    do
    {
      const int t = sectors.of_corner[m.next(h)];
      const double d = top.first + std::sqrt(m.vector(h).squared_length());
      if(d < reach && sectors.closed[t])
      {
        const auto found = reached.find(t);
        if(found == reached.end() || d < found->second.first)
        {
          reached[t] = std::make_pair(d, h);
          queue.push(Entry(d, t));
        }
      }
      h = m.next_around_source(h);
    }
    while(h != first);
  }
  return std::vector<int>();
}

// Annihilates pairs of opposite singularities (three and five quads) closer to each other than `reach`, if that costs
// little: a map for quads of twice this size would put both on one grid point. The angles of the field are the
// best ones for its jumps, before and after.
template <typename Go_further>
void merge_close_pairs(const Field_problem& problem, const Dual_laplacian& laplacian, double reach, Sector_quads& quads,
                       Cross_field& field, const Go_further& go_further)
{
  // What a pair may cost that the search left because it lowers the energy; a singularity alone
  // accounts for about 0.5.
  const double worth_of_pair = 0.3;
  // Every attempt solves a system; more pairs than this are noise that a few merges do not cure.
  const int maximum_attempts = 200;

  double energy = problem.energy(field) + quads.cost();
  int attempts = 0;
  for(int s = 0; s < problem.sectors.number_of_sectors() && attempts < maximum_attempts && go_further(); ++s)
  {
    if(!problem.sectors.closed[s] || quads.state()[s] != 3)
      continue;
    const std::vector<int> path = path_to_opposite_singularity(problem, quads, s, reach);
    if(path.empty())
      continue;
    ++attempts;
    const Cross_field before = field;
    const Sector_quads::State quads_before = quads.state();
    for(int h : path)
    {
      // The quad comes to the source of every halfedge.
      const int e = problem.mesh.edge_of[h];
      const int by = problem.mesh.halfedge_of_edge[e] == h ? -1 : 1;
      field.period_jump[e] += by;
      quads.change_jump(e, by);
    }
    laplacian.solve_angles(field);
    const double merged = problem.energy(field) + quads.cost();
    if(merged < energy + worth_of_pair)
      energy = merged;
    else
    {
      field = before;
      quads.set_state(quads_before);
    }
  }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_MERGE_CLOSE_PAIRS_H
