// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_UNFOLDED_MESH_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_UNFOLDED_MESH_H

#include <CGAL/Quad_meshing/Geodesics/internal/Number_functions.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Turning_angle.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <boost/config.hpp>

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// How a shortest path may pass a vertex.
enum Vertex_passage : unsigned char
{
  PASSAGE_NEVER,     // angle below 2 pi (pi on the border): no shortest path bends here
  PASSAGE_IN_SHADOW, // a saddle or a reflex border vertex: paths bend into the part without straight continuation
  PASSAGE_EVERYWHERE // unclear from the angles (an edge of length zero ends here): assume all directions
};

// The intrinsic geometry of a triangle mesh: what is needed to unfold one triangle after the other
// into the plane.
//
// The frame of halfedge h, which runs from vertex p to vertex q in the face (p, q, r), has its
// origin at p, its x-axis along pq and the face in y >= 0; `apex[h]` is the place of r. A place on
// an edge is its distance from the source of the edge's canonical halfedge `halfedge_of_edge[e]`, the
// one of the larger number.
//
// Directions at a vertex are angles counterclockwise from its first halfedge `halfedge_of_vertex`.
template <typename FT>
struct Unfolded_mesh : Indexed_triangle_mesh
{
  struct Apex
  {
    FT x, y;
    FT back;   // x minus the length of h, with all its digits even if r lies very close to q
    FT length; // of h
  };

  // A total angle that exceeds 2 pi (or pi on the border) by no more than this, or its arc tangent, does not make a
  // saddle. A path that bends by such an angle is shorter by a relative 1e-22 when it is
  // straightened, far less than rounding.
  static double flat_angle_tolerance() { return 1e-14; }

  struct Shape
  {
    bool is_flat; // see `flatness()`
    bool has_area;
  };

  // The height over the longest side of a face, as part of that side, up to which it is flat.
  static FT flatness() { return FT(1e-3); }

  std::vector<Apex> apex;   // per halfedge
  std::vector<Shape> shape; // per face
  std::vector<FT> length;   // per edge
  std::vector<double>
    direction; // per halfedge: its angle at its source; 0 where nobody asks, at vertices with no shadow
  std::vector<double> total_angle;     // per vertex; 0 likewise
  std::vector<Vertex_passage> passage; // per vertex

  Unfolded_mesh() {}

  // Angles are of type double always. With a number type of more digits, a vertex whose angle leaves a
  // doubt is taken to bend paths in every direction, which costs windows but no precision.
  explicit Unfolded_mesh(Indexed_triangle_mesh base) : Indexed_triangle_mesh(std::move(base))
  {
    for(int h = 0; h < number_of_halfedges(); ++h)
      if(is_canonical(h))
        halfedge_of_edge[edge_of[h]] = h;
    length.resize(number_of_edges());
    apex.reserve(number_of_halfedges());
    shape.reserve(number_of_faces());
    std::vector<Turning_angle> angles(number_of_vertices());
    std::vector<bool> has_zero_edge(number_of_vertices(), false);
    for(int f = 0; f < number_of_faces(); ++f)
      unfold(f, angles, has_zero_edge);
    set_passages(angles, has_zero_edge);
  }

  bool is_canonical(int h) const { return opposite[h] < h; } // also on the border, where opposite[h] is -1

  const FT& length_of(int h) const { return apex[h].length; }

  double corner_angle(int h) const { return std::atan2(as_double(apex[h].y), as_double(apex[h].x)); }

private:
  struct Difference
  {
    FT x, y, z;
    Difference(const Point_3& p, const Point_3& q)
      : x(FT(q.x()) - FT(p.x())), y(FT(q.y()) - FT(p.y())), z(FT(q.z()) - FT(p.z()))
    {
    }
    Difference(const FT& x, const FT& y, const FT& z) : x(x), y(y), z(z) {}

    FT dot(const Difference& o) const { return x * o.x + y * o.y + z * o.z; }
    FT norm() const { return square_root(dot(*this)); }
    Difference cross(const Difference& o) const
    {
      return Difference(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
    }
  };

  // Sets what belongs to a face, and adds its angles to those around its corners.
  void unfold(int f, std::vector<Turning_angle>& angles, std::vector<bool>& has_zero_edge)
  {
    const Point_3 &p = points[corners[f][0]], &q = points[corners[f][1]], &r = points[corners[f][2]];
    const Difference side[3] = { Difference(p, q), Difference(q, r), Difference(r, p) };
    const FT square[3] = { side[0].dot(side[0]), side[1].dot(side[1]), side[2].dot(side[2]) };
    // of each side and the next one
    const FT dot[3] = { side[0].dot(side[1]), side[1].dot(side[2]), side[2].dot(side[0]) };
    const int longer = square[0] < square[1], longest = square[longer] < square[2] ? 2 : longer;
    // the two shorter sides keep the digits of the area
    const FT area = side[(longest + 1) % 3].cross(side[(longest + 2) % 3]).norm();
    shape.push_back(Shape{ !(area > flatness() * square[longest]), FT(0) < area });
    for(int k = 0; k < 3; ++k)
    {
      const FT l = square_root(square[k]);
      length[edge_of[3 * f + k]] = l;
      const Apex a = l == FT(0) ? Apex{ FT(0), FT(0), FT(0), FT(0) }
                                : Apex{ FT(-dot[(k + 2) % 3] / l), FT(area / l), FT(dot[k] / l), l };
      apex.push_back(a);
      angles[corners[f][k]].add(as_double(a.x), as_double(a.y));
      if(l == FT(0))
        has_zero_edge[corners[f][k]] = has_zero_edge[corners[f][(k + 1) % 3]] = true;
    }
  }

  void set_passages(const std::vector<Turning_angle>& angles, const std::vector<bool>& has_zero_edge)
  {
    direction.assign(number_of_halfedges(), 0.);
    total_angle.assign(number_of_vertices(), 0.);
    passage.assign(number_of_vertices(), PASSAGE_NEVER);
    for(int v = 0; v < number_of_vertices(); ++v)
    {
      const int first = halfedge_of_vertex[v];
      if(first == -1)
        continue;
      passage[v] = has_zero_edge[v] ? PASSAGE_EVERYWHERE : passage_around(first, angles[v]);
      if(passage[v] == PASSAGE_IN_SHADOW)
        total_angle[v] = set_directions(first);
    }
  }

  // At the source of its first halfedge, from the sum of the angles around it.
  Vertex_passage passage_around(int first, const Turning_angle& sum) const
  {
    const int straight = opposite[first] == -1 ? 1 : 2;
    if(!std::is_same<FT, double>::value)
      return sum.exceeds(straight, -doubtful_angle(), [&] { return true; }) ? PASSAGE_EVERYWHERE : PASSAGE_NEVER;
    return sum.exceeds(straight, flat_angle_tolerance(), [&] { return is_saddle(first, straight); }) ? PASSAGE_IN_SHADOW
                                                                                                     : PASSAGE_NEVER;
  }

  // The same, exactly.
  BOOST_NOINLINE bool is_saddle(int first, int straight) const
  {
    std::vector<Turning_angle::Vector> corners;
    int h = first;
    do
    {
      corners.push_back(Turning_angle::Vector{ as_double(apex[h].x), as_double(apex[h].y) });
      h = next_around_source(h);
    }
    while(h != -1 && h != first);
    return Turning_angle::exceeds_exactly(corners, straight, flat_angle_tolerance());
  }

  // Returns the sum of the angles.
  double set_directions(int first)
  {
    double sum = 0;
    int h = first;
    do
    {
      direction[h] = sum;
      sum += corner_angle(h);
      h = next_around_source(h);
    }
    while(h != -1 && h != first);
    return sum;
  }

  static double doubtful_angle() { return 1e-6; }
};

// Changes from the frame of h to the frame of next(h).
template <typename FT>
void to_next_frame(const Unfolded_mesh<FT>& m, int h, FT& x, FT& y)
{
  const FT l = m.length_of(h), n = m.length_of(Unfolded_mesh<FT>::next(h));
  const FT vx = m.apex[h].back, vy = m.apex[h].y, dx = x - l;
  x = (dx * vx + y * vy) / n;
  y = (y * vx - dx * vy) / n;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_UNFOLDED_MESH_H
