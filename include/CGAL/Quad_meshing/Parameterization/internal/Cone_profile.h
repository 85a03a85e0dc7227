// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CONE_PROFILE_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CONE_PROFILE_H

#include <CGAL/Quad_meshing/Parameterization/internal/Vertex_sectors.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/centroid.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the orientation energy asks for near irregular vertices.
//
// Around a vertex with q right angles the field turns by q - 4 quarters, and every map along it is, to first order, a
// sum of powers of the distance r: r^(q/4), which winds around the vertex as it should, and r^(q/4 - k) and
// r^(k - q/4) for whole k, which wind around it too seldom or backwards but have the same transitions. Where q is 5,
// r^(1/4) has little energy in the plain energy, so that its minimum folds or winds wrongly around many vertices that
// the neighbourhood pulls aside, up to several edge lengths from them. A weight of r^(-2) gives all wrong powers
// infinite energy and leaves the right one finite if the lengths that are asked for shrink with it, as r^(q/4 - 1).
// Both hold within a small distance of the vertex. For a sector between aligned edges, q/4 is its right angles
// over its angle on the surface.
//
// How small that distance is depends on what pulls at the vertex: each sector has a reach of its own.
class Cone_profile
{
public:
  // The reach to begin with, in target edge lengths. Measured on 36 models at 4000 quads, with weights at all irregular
  // corners: with 2 and with 4, 31 of them need no second map (26 without these weights); 4 makes edge lengths less
  // even.
  static constexpr double first_reach = 2;

  std::vector<double> weight; // per face
  std::vector<double> sizing; // per face: the target edge length

  // The weights times others, per face.
  std::vector<double> weighted(std::vector<double> other) const
  {
    for(std::size_t f = 0; f < weight.size(); ++f)
      other[f] *= weight[f];
    return other;
  }

  // `reach` per sector, in target edge lengths.
  Cone_profile(const Indexed_triangle_mesh& mesh, const Vertex_sectors& sectors, const std::vector<bool>& is_aligned,
               const std::vector<double>& target_edge_length, const std::vector<double>& reach)
    : weight(mesh.number_of_faces(), 1.), sizing(target_edge_length)
  {
    Search search{ mesh, is_aligned, target_edge_length, std::vector<double>(mesh.number_of_faces(), 1.),
                   std::vector<int>(mesh.number_of_faces(), -1) };
    for(std::size_t i = 0; i < sectors.list.size(); ++i)
      if(sectors.list[i].is_irregular)
        visit(sectors.list[i], static_cast<int>(i), reach[i], search);
  }

private:
  // What the visits share.
  struct Search
  {
    const Indexed_triangle_mesh& mesh;
    const std::vector<bool>& is_aligned;
    const std::vector<double>& target_edge_length;
    std::vector<double> nearest; // per face: the distance to the nearest irregular vertex, over the reach
    std::vector<int> seen_from;  // per face: a sector
  };

  void visit(const Vertex_sectors::Sector& sector, int number, double reach, Search& s)
  {
    const double largest_weight = 1000; // a triangle whose centroid is this near is far smaller than a quad
    const double largest_grading = 4;   // of the lengths, either way
    std::vector<int> front;
    auto reached = [&](int f)
    {
      if(s.seen_from[f] == number)
        return;
      s.seen_from[f] = number;
      front.push_back(f);
    };
    double angle = 0;
    for(int h : sector.halfedges)
    {
      angle += Vertex_sectors::angle_at_source(s.mesh, h);
      reached(h / 3);
    }
    if(!(angle > 0))
      return;
    const double exponent = sector.quarters * Vertex_sectors::right_angle / angle - 1;
    // A corner that is about as wide on the surface as in the map, such as that of a box, needs nothing.
    const double least_exponent = 0.1;
    if(std::abs(exponent) < least_exponent)
      return;
    for(std::size_t k = 0; k < front.size(); ++k)
    {
      const int f = front[k];
      const double r = distance(s.mesh, sector.vertex, f) / (reach * s.target_edge_length[f]);
      if(!(r < 1))
        continue;
      if(r < s.nearest[f])
      {
        s.nearest[f] = r;
        weight[f] = r * r * largest_weight > 1 ? 1 / (r * r) : largest_weight;
        sizing[f] =
          s.target_edge_length[f] / (std::min)(largest_grading, (std::max)(1 / largest_grading, std::pow(r, exponent)));
      }
      for(int h = 3 * f; h < 3 * f + 3; ++h)
        if(s.mesh.opposite[h] != -1 && !s.is_aligned[s.mesh.edge_of[h]])
          reached(s.mesh.opposite[h] / 3);
    }
  }

  static double distance(const Indexed_triangle_mesh& m, int v, int f)
  {
    const auto& c = m.corners[f];
    return std::sqrt((CGAL::centroid(m.points[c[0]], m.points[c[1]], m.points[c[2]]) - m.points[v]).squared_length());
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_INTERNAL_CONE_PROFILE_H
