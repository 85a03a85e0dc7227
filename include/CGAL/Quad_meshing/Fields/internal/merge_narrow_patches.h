// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_MERGE_NARROW_PATCHES_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_MERGE_NARROW_PATCHES_H

#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The regions that sharp edges divide a surface into, of which those are joined to a neighbor that are too narrow for
// quads: slivers along a crease, fillets and chamfers of a few percent of a quad. The wall of a thin part between two
// sides that face away from each other is none of these: both its edges stay.
class Patch_merging
{
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

public:
  Patch_merging(const Indexed_triangle_mesh& mesh, std::vector<char>& is_sharp) : m_mesh(mesh), m_is_sharp(is_sharp) {}

  // Unmarks the sharp edges between a patch narrower than `least_width` and the neighbor that it bends least to, until
  // no patch with a neighbor is narrow. Returns the number of patches that were joined.
  std::size_t run(double least_width)
  {
    std::size_t joined = 0;
    for(;;)
    {
      find_patches();
      const std::size_t now = join_narrow_patches(least_width);
      if(now == 0)
        return joined;
      joined += now;
    }
  }

private:
  // A stretch of the outline of a patch along one other patch, without a corner, that bends about as much everywhere.
  struct Side
  {
    int neighbor = -1;
    double length = 0, bend = 0; // bend: times length, from 0 to 2
    double angle = 0;            // between the normals, times length, positive at convex edges
    std::vector<int> edges;

    double mean_bend() const { return length > 0 ? bend / length : 0; }
    double mean_angle() const { return length > 0 ? angle / length : 0; }
  };

  struct Patch
  {
    double area = 0, perimeter = 0;
    std::vector<int> faces;
    std::vector<Side> sides; // those at the border of the surface are none

    // Of a strip that is long; half the width of a square.
    double width() const { return perimeter > 0 ? 2 * area / perimeter : 0; }
  };

  Vector_3 area_vector(int f) const { return cross_product(m_mesh.vector(3 * f), m_mesh.vector(3 * f + 1)) / 2; }

  void find_patches()
  {
    m_patches.clear();
    m_patch_of_face.assign(m_mesh.number_of_faces(), -1);
    std::vector<int> stack;
    for(int seed = 0; seed < m_mesh.number_of_faces(); ++seed)
    {
      if(m_patch_of_face[seed] != -1)
        continue;
      const int id = static_cast<int>(m_patches.size());
      m_patches.push_back(Patch());
      m_patch_of_face[seed] = id;
      stack.push_back(seed);
      while(!stack.empty())
      {
        const int f = stack.back();
        stack.pop_back();
        m_patches[id].faces.push_back(f);
        m_patches[id].area += std::sqrt(area_vector(f).squared_length());
        for(int h = 3 * f; h < 3 * f + 3; ++h)
        {
          const int o = m_mesh.opposite[h];
          if(o == -1 || m_is_sharp[m_mesh.edge_of[h]] || m_patch_of_face[o / 3] != -1)
            continue;
          m_patch_of_face[o / 3] = id;
          stack.push_back(o / 3);
        }
      }
    }
  }

  bool is_outline(int h) const
  {
    const int o = m_mesh.opposite[h];
    return o == -1 || m_patch_of_face[o / 3] != m_patch_of_face[h / 3];
  }

  // The perimeters and sides of all patches. Where one patch lies on both sides of a strip, these sides are two.
  void find_sides()
  {
    const double least_change = CGAL_PI / 6; // of the angle between the normals: a crease begins or ends there
    std::vector<bool> is_seen(m_mesh.number_of_halfedges(), false);
    for(int first = 0; first < m_mesh.number_of_halfedges(); ++first)
    {
      if(is_seen[first] || !is_outline(first))
        continue;
      const int start = after_corner(first);
      Patch& patch = m_patches[m_patch_of_face[first / 3]];
      int before = -1; // the neighbor along the halfedge before
      for(int h = start; !is_seen[h]; h = next_of_outline(h))
      {
        is_seen[h] = true;
        const double l = std::sqrt(m_mesh.vector(h).squared_length());
        patch.perimeter += l;
        const int o = m_mesh.opposite[h], q = o == -1 ? -1 : m_patch_of_face[o / 3];
        if(q != -1)
        {
          if(q != before || h == start || is_corner(h) ||
             std::abs(convex_angle(h) - convex_angle(previous_of_outline(h))) > least_change)
            patch.sides.push_back(Side{ q });
          Side& side = patch.sides.back();
          side.length += l;
          side.bend += l * bend(h / 3, o / 3);
          side.angle += l * convex_angle(h);
          side.edges.push_back(m_mesh.edge_of[h]);
        }
        before = q;
      }
    }
  }

  // The halfedge of the outline that leaves the target of one of its halfedges.
  int next_of_outline(int h) const
  {
    int g = Indexed_triangle_mesh::next(h);
    while(!is_outline(g))
      g = Indexed_triangle_mesh::next(m_mesh.opposite[g]);
    return g;
  }

  int previous_of_outline(int h) const
  {
    int g = Indexed_triangle_mesh::prev(h);
    while(!is_outline(g))
      g = Indexed_triangle_mesh::prev(m_mesh.opposite[g]);
    return g;
  }

  // Whether the outline has a corner where a halfedge begins.
  bool is_corner(int h) const
  {
    const double least_turn = CGAL_PI / 3; // the end of a strip turns by a right angle or, as a tip, by nearly two
    const Vector_3 a = m_mesh.vector(previous_of_outline(h)), b = m_mesh.vector(h);
    return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b) > least_turn;
  }

  // The first halfedge of the outline from h on that begins at a corner; h if there is none.
  int after_corner(int h) const
  {
    for(int g = h;;)
    {
      if(is_corner(g))
        return g;
      g = next_of_outline(g);
      if(g == h)
        return h;
    }
  }

  // Every patch takes part in one joining at most: the widths of others are still true then.
  std::size_t join_narrow_patches(double least_width)
  {
    find_sides();
    std::vector<std::pair<double, int>> narrow;
    for(int p = 0; p < static_cast<int>(m_patches.size()); ++p)
      if(m_patches[p].width() < least_width && !m_patches[p].sides.empty())
        narrow.push_back(std::make_pair(m_patches[p].width(), p));
    std::sort(narrow.begin(), narrow.end());

    std::vector<bool> is_joined(m_patches.size(), false);
    std::size_t joined = 0;
    for(const auto& entry : narrow)
    {
      const int p = entry.second;
      if(is_joined[p])
        continue;
      const Side& side = *std::min_element(m_patches[p].sides.begin(), m_patches[p].sides.end(),
                                           [](const Side& a, const Side& b) { return a.mean_bend() < b.mean_bend(); });
      if(is_joined[side.neighbor] || is_thin_wall(p, side))
        continue;
      is_joined[p] = is_joined[side.neighbor] = true;
      join(m_patches[p], side);
      ++joined;
    }
    return joined;
  }

  // Unmarks the edges between a patch and its neighbor along one of its sides. Where that neighbor is all around a
  // strip along a crease that ends, the other side is the crease and stays.
  void join(const Patch& patch, const Side& side)
  {
    const double least_share = 0.25; // of the outline along others, where the neighbor is on one side only
    double along_others = patch.perimeter, largest_bend = 0;
    for(const Side& s : patch.sides)
      if(s.neighbor == side.neighbor)
      {
        along_others -= s.length;
        largest_bend = (std::max)(largest_bend, s.mean_bend());
      }
    const bool is_all_around = along_others < least_share * patch.perimeter;
    for(const Side& s : patch.sides)
      if(s.neighbor == side.neighbor &&
         (!is_all_around || &s == &side || 2 * s.mean_bend() < side.mean_bend() + largest_bend))
        for(int e : s.edges)
          m_is_sharp[e] = false;
  }

  // Whether patch p stands between its neighbor along one side and another one along it that faces away from that. At a
  // sliver that is folded back onto the surface, angles sum up to as much; and where the two neighbors meet beside the
  // patch, it only blunts their sharp edge.
  bool is_thin_wall(int p, const Side& side) const
  {
    const double least_turn = 0.75 * CGAL_PI; // halfway between a chamfer of a right angle and a thin plate
    const double largest_angle = least_turn;  // halfway between a right angle and a fold
    const double least_relative_length = 0.5; // of the other side
    for(const Side& s : m_patches[p].sides)
      if(s.neighbor != side.neighbor && s.length > least_relative_length * side.length &&
         (std::max)(std::abs(s.mean_angle()), std::abs(side.mean_angle())) < largest_angle &&
         std::abs(s.mean_angle() + side.mean_angle()) > least_turn && !meet_at(p, side.neighbor, s.neighbor))
        return true;
    return false;
  }

  // Whether patches q and r have a common edge that ends at patch p.
  bool meet_at(int p, int q, int r) const
  {
    bool result = false;
    for(int f : m_patches[p].faces)
      for(int v : m_mesh.corners[f])
        for_each_corner_of_vertex(m_mesh, v,
                                  [&](int h)
                                  {
                                    const int o = m_mesh.opposite[h], a = m_patch_of_face[h / 3];
                                    if(o != -1 && (a == q || a == r))
                                      result = result || m_patch_of_face[o / 3] == q + r - a;
                                  });
    return result;
  }

  // The angle between the normals at the edge of h, positive where it is convex.
  double convex_angle(int h) const
  {
    const Vector_3 a = area_vector(h / 3), b = area_vector(m_mesh.opposite[h] / 3), n = cross_product(a, b);
    const double angle = std::atan2(std::sqrt(n.squared_length()), a * b);
    return n * m_mesh.vector(h) < 0 ? -angle : angle;
  }

  // One minus the cosine of the angle between the normals; one if a face has none.
  double bend(int f, int g) const
  {
    const Vector_3 a = area_vector(f), b = area_vector(g);
    const double lengths = std::sqrt(a.squared_length() * b.squared_length());
    return lengths > 0 ? 1 - a * b / lengths : 1;
  }

  const Indexed_triangle_mesh& m_mesh;
  std::vector<char>& m_is_sharp; // per edge
  std::vector<int> m_patch_of_face;
  std::vector<Patch> m_patches;
};

// See Patch_merging. Border edges must not be marked.
inline std::size_t merge_narrow_patches(const Indexed_triangle_mesh& mesh, double least_width,
                                        std::vector<char>& is_sharp)
{
  return Patch_merging(mesh, is_sharp).run(least_width);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_MERGE_NARROW_PATCHES_H
