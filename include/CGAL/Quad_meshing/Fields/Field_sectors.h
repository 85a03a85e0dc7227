// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_FIELD_SECTORS_H
#define CGAL_QUAD_MESHING_FIELDS_FIELD_SECTORS_H

#include <CGAL/Quad_meshing/Fields/Face_frames.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The corners around the vertices, grouped into sectors by the edges the field is aligned with.
//
// A corner is named by the halfedge that leaves its vertex in its face. A sector is a maximal run of
// corners around one vertex that are joined by edges without alignment; it is closed if it is the
// whole fan of an inner vertex. Unfolded into the plane a sector has the angle A, and a direction of
// the field that is carried through it by the period jumps turns by minus the sum of the residuals
// (r counted along the counterclockwise crossing); between two aligned edges, and around a closed
// sector, the number of quads
//   k = (A + sum of r) / (pi/2)
// is therefore an integer. Changing the period jump of an edge by d takes d quads from the sector at
// the source of `halfedge_of_edge` and gives them to the sector at its target.
struct Field_sectors
{
  std::vector<int> of_corner;    // per halfedge: the sector of the corner at its source
  std::vector<int> vertex;       // per sector
  std::vector<int> first_corner; // per sector: its clockwise-most corner, any one if closed
  std::vector<char> closed;      // per sector
  std::vector<char> bounded;     // per sector: runs from one aligned edge to another (or the same)

  int number_of_sectors() const { return static_cast<int>(vertex.size()); }
};

inline Field_sectors make_field_sectors(const Indexed_triangle_mesh& m, const std::vector<char>& aligned)
{
  Field_sectors s;
  s.of_corner.assign(m.number_of_halfedges(), -1);
  for(int seed = 0; seed < m.number_of_halfedges(); ++seed)
  {
    if(s.of_corner[seed] != -1)
      continue;

    int first = seed;
    bool is_closed = false;
    while(!aligned[m.edge_of[first]] && m.opposite[first] != -1)
    {
      first = m.previous_around_source(first);
      if(first == seed)
      {
        is_closed = true;
        break;
      }
    }

    const int id = s.number_of_sectors();
    int last = first;
    for(int h = first;;)
    {
      s.of_corner[h] = id;
      last = h;
      if(aligned[m.edge_of[m.prev(h)]])
        break;
      h = m.next_around_source(h);
      if(h == -1 || h == first)
        break;
    }
    s.vertex.push_back(m.source(first));
    s.first_corner.push_back(first);
    s.closed.push_back(is_closed);
    s.bounded.push_back(!is_closed && aligned[m.edge_of[first]] && aligned[m.edge_of[m.prev(last)]]);
  }
  return s;
}

// The quads between two halfedges with a common source, counterclockwise from `first` to `last`, for
// a field given by its residuals r (per edge, oriented as `halfedge_of_edge`): an integer up to
// rounding if the field is aligned with both. The full turn is taken if both are the same halfedge.
// `last` may be -1, which stands for the border halfedge that ends the fan of a border vertex.
template <typename Residual>
double quads_between(const Indexed_triangle_mesh& m, const Face_frames& frames, const Residual& residual, int first,
                     int last)
{
  double turn = 0;
  int h = first;
  do
  {
    turn += frames.corner_angle(h);
    const int crossed = m.prev(h);
    h = m.opposite[crossed];
    if(h == -1 || (h == last && last != first))
      break;
    const int e = m.edge_of[crossed];
    turn += m.halfedge_of_edge[e] == crossed ? residual(e) : -residual(e);
  }
  while(h != first);
  return turn / quarter_turn;
}

// The number of quads of every sector, rounded where the field is not aligned with its sides.
template <typename Residual>
std::vector<int> quads_of_sectors(const Indexed_triangle_mesh& m, const Face_frames& frames,
                                  const std::vector<char>& aligned, const Field_sectors& s, const Residual& residual)
{
  std::vector<double> turn(s.number_of_sectors(), 0.);
  for(int h = 0; h < m.number_of_halfedges(); ++h)
  {
    turn[s.of_corner[h]] += frames.corner_angle(h);
    const int e = m.edge_of[h];
    // Counterclockwise around the source of h one enters its face through h.
    if(m.opposite[h] != -1 && !aligned[e])
      turn[s.of_corner[h]] += m.halfedge_of_edge[e] == h ? -residual(e) : residual(e);
  }
  std::vector<int> k(s.number_of_sectors());
  for(int i = 0; i < s.number_of_sectors(); ++i)
    k[i] = static_cast<int>(std::lround(turn[i] / quarter_turn));
  return k;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_FIELD_SECTORS_H
