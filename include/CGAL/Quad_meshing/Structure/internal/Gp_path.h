// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_PATH_H
#define CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_PATH_H

#include <CGAL/Quad_meshing/internal/Dual_lines.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Grid-preserving operators (thesis, section 10.1) are paths of dual halfedges with an operation on
// each edge that they cross. Seen as a whole, such a path cuts the surface and glues the side on its
// left back one unit backwards, in the frame in which a collapse heads to the right. So the heading
// and the operation go together:
//
//   shift left: heads ahead; the edge (l, r) becomes (l', r), l' being the vertex that follows l
//   collapse:   heads to the right; l and r become one vertex
//   shift right: heads backwards; (l, r) becomes (l, r')
//
// and a path turns right from a shift left into a collapse, left or right from a collapse into a
// shift left or right, left from a shift right into a collapse.
enum Gp_kind : char
{
  gp_shift_left = 0,
  gp_collapse = 1,
  gp_shift_right = 2
};

// One crossing of an edge. `out` is the halfedge in the face that is left, `in` the one in the face
// that is entered. One of them is -1 where a path begins or ends on the border; only a collapse can.
struct Gp_step
{
  int out;
  int in;
  Gp_kind kind;

  int left(const Indexed_quad_mesh& m) const { return in != -1 ? m.source(in) : m.target(out); }
  int right(const Indexed_quad_mesh& m) const { return in != -1 ? m.target(in) : m.source(out); }
  int edge() const { return (std::max)(in, out); }
};

// A cyclic sequence of steps. A step that leaves the mesh is followed by one that enters it.
typedef std::vector<Gp_step> Gp_path;

// Steps as numbers: 3*h + kind crosses the edge of h outwards, 3*n + h enters the mesh across h.
inline Gp_step gp_step(const Indexed_quad_mesh& m, int state)
{
  const int n = m.number_of_halfedges();
  return state < 3 * n ? Gp_step{ state / 3, m.opposite[state / 3], Gp_kind(state % 3) }
                       : Gp_step{ -1, state - 3 * n, gp_collapse };
}

// Calls f(state) for the states that may follow a step that enters a face.
template <typename Function>
void for_each_next_gp_state(const Gp_step& s, const Function& f)
{
  typedef Indexed_quad_mesh M;
  f(3 * M::across(s.in) + s.kind);
  const int to_the_left = M::prev(s.in), to_the_right = M::next(s.in);
  if(s.kind == gp_shift_left)
    f(3 * to_the_right + gp_collapse);
  else if(s.kind == gp_shift_right)
    f(3 * to_the_left + gp_collapse);
  else
  {
    f(3 * to_the_left + gp_shift_left);
    f(3 * to_the_right + gp_shift_right);
  }
}

// How a path passes a face.
enum Gp_passage : char
{
  gp_not_visited = 0,
  gp_straight_collapse,
  gp_straight_shift,
  gp_turn
};

inline Gp_passage gp_passage(const Gp_step& enter, const Gp_step& leave)
{
  return leave.out != Indexed_quad_mesh::across(enter.in) ? gp_turn
         : enter.kind == gp_collapse                      ? gp_straight_collapse
                                                          : gp_straight_shift;
}

// A face may be passed twice only straight, crosswise, and not by two shifts: a row that has been
// collapsed away does not hinder what crosses it.
inline bool gp_passages_are_compatible(Gp_passage a, int side_a, Gp_passage b, int side_b)
{
  return a != gp_turn && b != gp_turn && (a == gp_straight_collapse || b == gp_straight_collapse) &&
         ((side_a ^ side_b) & 1) == 1;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_STRUCTURE_INTERNAL_GP_PATH_H
