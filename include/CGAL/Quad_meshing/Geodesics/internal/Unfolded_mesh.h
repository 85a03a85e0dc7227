// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_UNFOLDED_MESH_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_UNFOLDED_MESH_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// How a shortest path may pass a vertex.
enum Vertex_passage : unsigned char
{
  PASSAGE_NEVER,         // angle below 2 pi (pi on the border): no shortest path bends here
  PASSAGE_IN_SHADOW,     // a saddle or a reflex border vertex: paths bend into the part without straight continuation
  PASSAGE_EVERYWHERE     // unclear from the angles (an edge of length zero ends here): assume all directions
};

// The intrinsic geometry of a triangle mesh: what is needed to unfold one triangle after the other
// into the plane.
//
// The frame of halfedge h, which runs from vertex p to vertex q in the face (p, q, r), has its
// origin at p, its x-axis along pq and the face in y >= 0; `apex[h]` is the place of r. A place on
// an edge is its distance from the source of the edge's canonical halfedge `halfedge_of_edge[e]`.
//
// Directions at a vertex are angles counterclockwise from its first halfedge `halfedge_of_vertex`.
template <typename FT>
struct Unfolded_mesh
  : Indexed_triangle_mesh
{
  struct Apex { FT x, y; };

  // A total angle that exceeds 2 pi (or pi on the border) by no more than this does not make a
  // saddle. A path that bends by such an angle is shorter by a relative 1e-22 when it is
  // straightened, far less than rounding.
  static double flat_angle_tolerance() { return 1e-11; }

  std::vector<Apex> apex;                 // per halfedge
  std::vector<FT> length;                 // per edge
  std::vector<double> direction;          // per halfedge: its angle at its source
  std::vector<double> total_angle;        // per vertex
  std::vector<Vertex_passage> passage;    // per vertex

  Unfolded_mesh() {}

  // `is_exact`: the angles, which are floating point numbers always, must only be trusted to be
  // wrong by less than 1e-6; a vertex in doubt may bend paths in every direction.
  explicit Unfolded_mesh(Indexed_triangle_mesh base, bool is_exact = false)
    : Indexed_triangle_mesh(std::move(base))
  {
    set_lengths();
    set_angles(is_exact);
  }

  bool is_canonical(int h) const { return halfedge_of_edge[edge_of[h]] == h; }
  bool is_border_vertex(int v) const { return halfedge_of_vertex[v] != -1 && opposite[halfedge_of_vertex[v]] == -1; }

  FT length_of(int h) const { return length[edge_of[h]]; }

  // The halfedge from which the face of h appears with the vertex of corner k of the face as its apex.
  static int halfedge_facing(int face, int k) { return 3 * face + (k + 1) % 3; }

private:
  void set_lengths()
  {
    length.resize(number_of_edges());
    for(int e = 0; e < number_of_edges(); ++e)
    {
      const Exact_vector d(points[source(halfedge_of_edge[e])], points[target(halfedge_of_edge[e])]);
      length[e] = CGAL::sqrt(dot(d, d));
    }

    apex.resize(number_of_halfedges());
    for(int h = 0; h < number_of_halfedges(); ++h)
    {
      const FT& l = length[edge_of[h]];
      if(l == FT(0))
      {
        apex[h] = Apex{ FT(0), FT(0) };
        continue;
      }
      const Exact_vector u(points[source(h)], points[target(h)]);
      const Exact_vector w(points[source(h)], points[target(next(h))]);
      apex[h] = Apex{ dot(u, w) / l, cross_length(u, w) / l };
    }
  }

  void set_angles(bool is_exact)
  {
    const double pi = std::acos(-1.);
    direction.assign(number_of_halfedges(), 0.);
    total_angle.assign(number_of_vertices(), 0.);
    passage.assign(number_of_vertices(), PASSAGE_NEVER);

    for(int v = 0; v < number_of_vertices(); ++v)
    {
      const int first = halfedge_of_vertex[v];
      if(first == -1)
        continue;
      double sum = 0;
      bool has_zero_edge = false;
      int h = first;
      do
      {
        direction[h] = sum;
        has_zero_edge = has_zero_edge || length_of(h) == FT(0) || length_of(prev(h)) == FT(0);
        const double l = to_double(length_of(h));
        sum += l == 0 ? 0 : std::atan2(to_double(apex[prev_frame_y(h)].y), 0) * 0 + corner_angle(h);
        h = next_around_source(h);
      }
      while(h != -1 && h != first);
      total_angle[v] = sum;

      const double straight = h == -1 ? pi : 2 * pi;
      const double slack = is_exact ? -1e-6 : flat_angle_tolerance();
      if(has_zero_edge || (is_exact && sum > straight + slack))
        passage[v] = PASSAGE_EVERYWHERE;
      else if(sum > straight + slack)
        passage[v] = PASSAGE_IN_SHADOW;
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_UNFOLDED_MESH_H
