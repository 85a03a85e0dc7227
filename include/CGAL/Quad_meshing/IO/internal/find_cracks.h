// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_FIND_CRACKS_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_FIND_CRACKS_H

#include <CGAL/Quad_meshing/IO/internal/Triangle_surface.h>
#include <CGAL/Quad_meshing/IO/internal/soup_geometry.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

struct Cracks
{
  std::size_t number_of_edges = 0;
  double width = 0; // the largest
};

inline double distance_to_segment(const Soup_vector& x, const Soup_vector& p, const Soup_vector& q)
{
  const Soup_vector d = soup_difference(q, p);
  const double dd = soup_dot(d, d);
  const double t = dd > 0 ? (std::min)((std::max)(soup_dot(soup_difference(x, p), d) / dd, 0.), 1.) : 0;
  return soup_distance(x, { { p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2] } });
}

// Finds border edges that run along another border edge: those whose midpoint and whose points a quarter from their
// ends are closer to it than a tenth of their own length and a thousandth of the diagonal.
inline Cracks find_cracks(const Triangle_surface& surface, double diagonal)
{
  constexpr double share_of_length = 0.1, share_of_diagonal = 1e-3;
  typedef Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Box;
  typedef std::array<Soup_vector, 2> Segment;

  std::vector<Segment> segments;
  std::vector<double> limits, widths;
  std::vector<Box> boxes;
  for(std::size_t s = 0; s < surface.opposite.size(); ++s)
  {
    if(surface.opposite[s] != no_index)
      continue;
    const Soup_vector& p = surface.points[surface.triangles[s / 3][s % 3]];
    const Soup_vector& q = surface.points[surface.triangles[s / 3][(s + 1) % 3]];
    const double limit = (std::min)(share_of_length * soup_distance(p, q), share_of_diagonal * diagonal);
    const double r = 0.5 * limit;
    boxes.emplace_back(Bbox_3((std::min)(p[0], q[0]) - r, (std::min)(p[1], q[1]) - r, (std::min)(p[2], q[2]) - r,
                              (std::max)(p[0], q[0]) + r, (std::max)(p[1], q[1]) + r, (std::max)(p[2], q[2]) + r),
                       segments.size());
    segments.push_back({ { p, q } });
    limits.push_back(limit);
    widths.push_back((std::numeric_limits<double>::max)());
  }

  auto compare = [&](std::size_t i, std::size_t j)
  {
    double width = 0;
    for(double t : { 0.25, 0.5, 0.75 })
    {
      Soup_vector x;
      for(std::size_t d = 0; d < 3; ++d)
        x[d] = (1 - t) * segments[i][0][d] + t * segments[i][1][d];
      width = (std::max)(width, distance_to_segment(x, segments[j][0], segments[j][1]));
      if(width > limits[i])
        return;
    }
    widths[i] = (std::min)(widths[i], width);
  };
  struct Too_many
  {
  };
  constexpr std::size_t most_pairs = 20000000; // some seconds
  std::size_t number_of_pairs = 0;
  try
  {
    box_self_intersection_d(boxes.begin(), boxes.end(),
                            [&](const Box& a, const Box& b)
                            {
                              if(++number_of_pairs > most_pairs)
                                throw Too_many();
                              compare(a.info(), b.info());
                              compare(b.info(), a.info());
                            });
  }
  catch(const Too_many&)
  {
    // the algorithm of the boxes can only be left this way
  }

  Cracks cracks;
  for(std::size_t i = 0; i < widths.size(); ++i)
    if(widths[i] <= limits[i])
    {
      ++cracks.number_of_edges;
      cracks.width = (std::max)(cracks.width, widths[i]);
    }
  return cracks;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_FIND_CRACKS_H
