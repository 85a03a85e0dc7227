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
#include <CGAL/Quad_meshing/internal/Distance_front.h>
#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// How many quads fit into every sector: four, or those that are prescribed, into a closed one, and into one between
// aligned edges what its angle says. Not a number where a border without alignment leaves the number free.
inline std::vector<double> fitting_quads(const Field_problem& problem)
{
  const Field_sectors& sectors = problem.sectors;
  std::vector<double> result(sectors.number_of_sectors(), 0.);
  for(int h = 0; h < problem.mesh.number_of_halfedges(); ++h)
    result[sectors.of_corner[h]] += problem.frames.corner_angle(h) / quarter_turn;
  for(int s = 0; s < sectors.number_of_sectors(); ++s)
    if(sectors.closed[s])
      result[s] = problem.quads_of_sector(s) == Field_problem::any_quads ? 4 : problem.quads_of_sector(s);
    else if(!sectors.bounded[s])
      result[s] = std::numeric_limits<double>::quiet_NaN();
  return result;
}

// Two opposite singularities, and the halfedges that lead from the one that lacks quads to the one that has too many,
// last one first, over vertices without aligned edges.
struct Singularity_pair
{
  double length;
  int lacking, abundant; // sectors
  std::vector<int> path;
};

// An excess from here on is closer to one quad than to none.
const double one_quad_too_many = 0.75;

// A narrow sector between aligned edges has no quad to give away, though a whole one does not fit.
inline bool can_give_a_quad(int quads, double fitting) { return quads > 1 && quads - fitting > one_quad_too_many; }

// Appends the pairs of the singularity of a sector, which lacks quads, with all opposite ones within reach: nearer than
// that in space, which is what a map cannot tell apart, on a path not much longer. `front` and `arrived_by`, the
// halfedge by which a sector was reached, are work space of one entry per sector.
inline void find_close_partners(const Field_problem& problem, const std::vector<int>& quads,
                                const std::vector<double>& fitting, int sector, double reach, Distance_front& front,
                                std::vector<int>& arrived_by, std::vector<Singularity_pair>& pairs)
{
  // A path along edges of equilateral triangles is up to 2/sqrt(3) times as long as the way it stands for.
  const double detour = 1.2;

  const Indexed_triangle_mesh& m = problem.mesh;
  const Field_sectors& sectors = problem.sectors;

  front.clear();
  front.reach(sector, 0.);
  arrived_by[sector] = -1;
  int s;
  for(double length; front.pop(s, length);)
  {
    const double straight = (m.points[sectors.vertex[s]] - m.points[sectors.vertex[sector]]).squared_length();
    if(can_give_a_quad(quads[s], fitting[s]) && straight < reach * reach)
    {
      Singularity_pair pair = { length, sector, s, std::vector<int>() };
      for(int h = arrived_by[s]; h != -1; h = arrived_by[sectors.of_corner[h]])
        pair.path.push_back(h);
      pairs.push_back(pair);
    }
    if(s != sector && !sectors.closed[s])
      continue;
    const int first = sectors.first_corner[s];
    for(int h = first; h != -1 && sectors.of_corner[h] == s;)
    {
      const int t = sectors.of_corner[m.next(h)];
      const double d = length + std::sqrt(m.vector(h).squared_length());
      if(d < detour * reach && problem.is_movable(m.edge_of[h]) && front.reach(t, d))
        arrived_by[t] = h;
      h = m.next_around_source(h);
      if(h == first)
        break;
    }
  }
}

// Annihilates the pairs of opposite singularities closer to each other than the target edge length, nearest first: an
// integer-grid map would put them on neighboring grid points at best, and bend quads more than the pair is worth. One
// of a pair moves to the other along mesh edges; the angles follow. A sector between aligned edges counts as singular
// if it has a quad more or less than its angle fits.
inline void merge_close_pairs(const Field_problem& problem, const Dual_laplacian& laplacian, double target_edge_length,
                              Sector_quads& quads, Cross_field& field, Stage_progress& progress)
{
  const std::vector<double> fitting = fitting_quads(problem);
  auto excess = [&](int s) { return quads.state()[s] - fitting[s]; };
  const int n = problem.sectors.number_of_sectors();
  bool has_changed = false;
  Distance_front front(n);
  std::vector<int> arrived_by(n, -1);
  for(;;)
  {
    std::vector<Singularity_pair> pairs;
    for(int s = 0; s < n; ++s)
      if(excess(s) < -one_quad_too_many && progress.go_further())
        find_close_partners(problem, quads.state(), fitting, s,
                            problem.length_at(problem.sectors.vertex[s], target_edge_length), front, arrived_by, pairs);
    if(pairs.empty())
      break;
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Singularity_pair& a, const Singularity_pair& b) { return a.length < b.length; });
    for(const Singularity_pair& pair : pairs)
    {
      if(!(excess(pair.lacking) < -one_quad_too_many &&
           can_give_a_quad(quads.state()[pair.abundant], fitting[pair.abundant])))
        continue;
      for(int h : pair.path)
      {
        // The quad comes to the source of every halfedge.
        const int e = problem.mesh.edge_of[h];
        const int by = problem.mesh.halfedge_of_edge[e] == h ? -1 : 1;
        field.period_jump[e] += by;
        quads.change_jump(e, by);
      }
    }
    has_changed = true;
  }
  if(has_changed)
    laplacian.solve_angles(field);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_MERGE_CLOSE_PAIRS_H
