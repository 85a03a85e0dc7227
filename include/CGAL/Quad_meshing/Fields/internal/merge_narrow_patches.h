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
#include <map>
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
  struct Patch
  {
    double area = 0, perimeter = 0;

    // Of a strip that is long; half the width of a square.
    double width() const { return perimeter > 0 ? 2 * area / perimeter : 0; }
  };

  struct Contact
  {
    double length = 0, bend = 0; // bend: times length, from 0 to 2
    double angle = 0;            // between the normals, times length, positive at convex edges

    double mean_bend() const { return length > 0 ? bend / length : 0; }
    double mean_angle() const { return length > 0 ? angle / length : 0; }
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

  // Every patch takes part in one joining at most: the widths of others are still true then.
  std::size_t join_narrow_patches(double least_width)
  {
    std::vector<std::map<int, Contact>> contacts(m_patches.size());
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
    {
      const int h = m_mesh.halfedge_of_edge[e], o = m_mesh.opposite[h];
      const int p = m_patch_of_face[h / 3], q = o == -1 ? -1 : m_patch_of_face[o / 3];
      if(p == q)
        continue;
      const double l = std::sqrt(m_mesh.vector(h).squared_length());
      for(int side : { p, q })
        if(side != -1)
          m_patches[side].perimeter += l;
      if(q == -1)
        continue;
      const double b = bend(h / 3, o / 3), a = convex_angle(h);
      for(const auto& sides : { std::make_pair(p, q), std::make_pair(q, p) })
      {
        contacts[sides.first][sides.second].length += l;
        contacts[sides.first][sides.second].bend += l * b;
        contacts[sides.first][sides.second].angle += l * a;
      }
    }
    std::vector<std::pair<double, int>> narrow;
    for(int p = 0; p < static_cast<int>(m_patches.size()); ++p)
      if(m_patches[p].width() < least_width && !contacts[p].empty())
        narrow.push_back(std::make_pair(m_patches[p].width(), p));
    std::sort(narrow.begin(), narrow.end());

    std::vector<int> partner(m_patches.size(), -1);
    std::size_t joined = 0;
    for(const auto& entry : narrow)
    {
      const int p = entry.second;
      if(partner[p] != -1)
        continue;
      const int q =
        std::min_element(contacts[p].begin(), contacts[p].end(),
                         [](const auto& a, const auto& b) { return a.second.mean_bend() < b.second.mean_bend(); })
          ->first;
      if(partner[q] != -1 || is_thin_wall(contacts[p], q))
        continue;
      partner[p] = q;
      partner[q] = p;
      ++joined;
    }
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      if(!m_mesh.is_border_edge(e) && m_is_sharp[e])
      {
        const int h = m_mesh.halfedge_of_edge[e];
        const int p = m_patch_of_face[h / 3], q = m_patch_of_face[m_mesh.opposite[h] / 3];
        if(p != q && partner[p] == q)
          m_is_sharp[e] = false;
      }
    return joined;
  }

  // Whether a patch with these contacts stands between q and another one along it that faces away from q. At a sliver
  // that is folded back onto the surface, angles sum up to as much.
  static bool is_thin_wall(const std::map<int, Contact>& contacts, int q)
  {
    const double least_turn = 0.75 * CGAL_PI; // halfway between a chamfer of a right angle and a thin plate
    const double largest_angle = least_turn;  // halfway between a right angle and a fold
    const double least_relative_length = 0.5; // of the other contact
    const Contact& to_q = contacts.at(q);
    for(const auto& c : contacts)
      if(c.first != q && c.second.length > least_relative_length * to_q.length &&
         (std::max)(std::abs(c.second.mean_angle()), std::abs(to_q.mean_angle())) < largest_angle &&
         std::abs(c.second.mean_angle() + to_q.mean_angle()) > least_turn)
        return true;
    return false;
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
