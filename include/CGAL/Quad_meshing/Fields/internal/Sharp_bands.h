// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_SHARP_BANDS_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_SHARP_BANDS_H

#include <CGAL/Quad_meshing/Fields/internal/find_sharp_edges.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The edges of bands that are so narrow that quads see one sharp edge in their place.
//
// A crease with a chamfer of a hundredth of a quad is two edges of half its angle, or three of a third. Some of them
// are sharp and others are not, so that a crease along them would change from one side of the band to the other and end
// in between. All edges of a band count that turn the surface noticeably, if the band as a whole turns it as much as a
// sharp edge does; `merge_narrow_patches()` then chooses one of them, the same all along the band.
class Sharp_bands
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

public:
  Sharp_bands(const Indexed_triangle_mesh& mesh, double angle_in_degrees, double target_edge_length)
    : m_mesh(mesh)
    , m_cosine(std::cos(angle_in_degrees * CGAL_PI / 180))
    , m_bends(find_sharp_edges(mesh, angle_in_degrees * least_share))
    , m_is_narrow(mesh.number_of_faces(), false)
    , m_seen_from(mesh.number_of_faces(), -1)
  {
    for(int f = 0; f < mesh.number_of_faces(); ++f)
      m_is_narrow[f] = is_narrow(f, greatest_height * target_edge_length);
  }

  // Adds the edges to those that are sharp by themselves.
  void mark(std::vector<char>& is_sharp)
  {
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      if(!is_sharp[e] && m_bends[e] && !m_mesh.is_border_edge(e))
        is_sharp[e] = is_in_sharp_band(e);
  }

private:
  // In target edge lengths: what lies within it cannot be told from one edge.
  static constexpr double greatest_height = 1. / 16;
  // Of the longest side: small triangles of a fine mesh are no bands.
  static constexpr double greatest_relative_height = 0.25;
  // Of the angle of sharp edges, from which on an edge is one of those that make up the band.
  static constexpr double least_share = 0.25;
  // The faces of a band that are looked at on either side of an edge: enough for the strips of a chamfer side by side.
  static constexpr std::size_t most_faces = 16;

  bool is_narrow(int f, double height) const
  {
    double longest = 0;
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      longest = (std::max)(longest, m_mesh.vector(h).squared_length());
    const double area = std::sqrt(area_vector(f).squared_length()); // of the parallelogram
    longest = std::sqrt(longest);
    return area <= (std::min)(height, greatest_relative_height * longest) * longest;
  }

  Vector_3 area_vector(int f) const { return cross_product(m_mesh.vector(3 * f), m_mesh.vector(3 * f + 1)); }

  // Whether there are a wall on the one side and one on the other side of an edge that meet at a sharp angle.
  bool is_in_sharp_band(int e)
  {
    const int h = m_mesh.halfedge_of_edge[e], o = m_mesh.opposite[h];
    if(!m_is_narrow[h / 3] && !m_is_narrow[o / 3])
      return false;
    find_walls(h / 3, o / 3, m_walls);
    find_walls(o / 3, h / 3, m_other_walls);
    for(int f : m_walls)
      for(int g : m_other_walls)
        if(is_sharp_between(f, g))
          return true;
    return false;
  }

  bool is_sharp_between(int f, int g) const
  {
    const Vector_3 a = area_vector(f), b = area_vector(g);
    return a * b <= m_cosine * std::sqrt(a.squared_length() * b.squared_length());
  }

  // The faces that are not narrow and are reached from `seed` through narrow ones, without the face `barrier`.
  void find_walls(int seed, int barrier, std::vector<int>& walls)
  {
    walls.clear();
    m_band.assign(1, seed);
    m_seen_from[seed] = m_seen_from[barrier] = ++m_search;
    for(std::size_t i = 0; i < m_band.size(); ++i)
    {
      const int f = m_band[i];
      if(!m_is_narrow[f])
      {
        walls.push_back(f);
        continue;
      }
      for(int h = 3 * f; h < 3 * f + 3 && m_band.size() < most_faces; ++h)
        if(const int o = m_mesh.opposite[h]; o != -1 && m_seen_from[o / 3] != m_search)
        {
          m_seen_from[o / 3] = m_search;
          m_band.push_back(o / 3);
        }
    }
  }

  const Indexed_triangle_mesh& m_mesh;
  const double m_cosine;
  const std::vector<char> m_bends; // per edge: it may be part of a band
  std::vector<bool> m_is_narrow;   // per face
  std::vector<int> m_seen_from;    // per face: the last search that came by
  int m_search = 0;
  std::vector<int> m_band, m_walls, m_other_walls;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_SHARP_BANDS_H
