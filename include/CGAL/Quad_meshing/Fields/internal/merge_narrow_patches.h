// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_FIELDS_INTERNAL_MERGE_NARROW_PATCHES_H
#define CGAL_QUAD_MESHING_FIELDS_INTERNAL_MERGE_NARROW_PATCHES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The regions that sharp edges divide a surface into, of which those are joined to a neighbor that are too narrow for quads:
// slivers along a crease, fillets and chamfers of a few percent of a quad.
template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsSharpMap>
class Patch_merging
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef Simple_cartesian<double>::Vector_3 Vector_3;

public:
  Patch_merging(const TriangleMesh& tm, VertexPointMap vpm, EdgeIsSharpMap is_sharp)
    : tm(tm), vpm(vpm), is_sharp(is_sharp), patch(get(CGAL::dynamic_face_property_t<int>(), tm))
  {}

  // Unmarks the sharp edges between a patch narrower than `least_width` and the neighbor that it bends least to, until no patch with a
  // neighbor is narrow. Returns the number of patches that were joined.
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

    double mean_bend() const { return length > 0 ? bend / length : 0; }
  };

  Vector_3 vector(halfedge_descriptor h) const
  {
    const auto& p = get(vpm, source(h, tm));
    const auto& q = get(vpm, target(h, tm));
    return Vector_3(to_double(q.x()) - to_double(p.x()), to_double(q.y()) - to_double(p.y()), to_double(q.z()) - to_double(p.z()));
  }

  double length(edge_descriptor e) const { return approximate_sqrt(vector(halfedge(e, tm)).squared_length()); }

  Vector_3 area_vector(face_descriptor f) const
  {
    const halfedge_descriptor h = halfedge(f, tm);
    return cross_product(vector(h), vector(next(h, tm))) / 2;
  }

  void find_patches()
  {
    patches.clear();
    for(face_descriptor f : faces(tm))
      put(patch, f, -1);
    std::vector<face_descriptor> stack;
    for(face_descriptor seed : faces(tm))
    {
      if(get(patch, seed) != -1)
        continue;
      const int id = static_cast<int>(patches.size());
      patches.push_back(Patch());
      put(patch, seed, id);
      stack.push_back(seed);
      while(!stack.empty())
      {
        const face_descriptor f = stack.back();
        stack.pop_back();
        patches[id].area += approximate_sqrt(area_vector(f).squared_length());
        for(halfedge_descriptor h : halfedges_around_face(halfedge(f, tm), tm))
        {
          const face_descriptor g = face(opposite(h, tm), tm);
          if(g == Graph_traits::null_face() || get(is_sharp, edge(h, tm)) || get(patch, g) != -1)
            continue;
          put(patch, g, id);
          stack.push_back(g);
        }
      }
    }
  }

  // Every patch takes part in one joining at most: the widths of others are still true then.
  std::size_t join_narrow_patches(double least_width)
  {
    std::vector<std::map<int, Contact> > contacts(patches.size());
    for(edge_descriptor e : edges(tm))
    {
      const face_descriptor f = face(halfedge(e, tm), tm), g = face(opposite(halfedge(e, tm), tm), tm);
      const int p = f == Graph_traits::null_face() ? -1 : get(patch, f), q = g == Graph_traits::null_face() ? -1 : get(patch, g);
      if(p == q)
        continue;
      const double l = length(e);
      for(int side : { p, q })
        if(side != -1)
          patches[side].perimeter += l;
      if(p == -1 || q == -1)
        continue;
      const double b = bend(f, g);
      for(const auto& sides : { std::make_pair(p, q), std::make_pair(q, p) })
      {
        contacts[sides.first][sides.second].length += l;
        contacts[sides.first][sides.second].bend += l * b;
      }
    }
    std::vector<std::pair<double, int> > narrow;
    for(int p = 0; p < static_cast<int>(patches.size()); ++p)
      if(patches[p].width() < least_width && !contacts[p].empty())
        narrow.push_back(std::make_pair(patches[p].width(), p));
    std::sort(narrow.begin(), narrow.end());

    std::vector<int> partner(patches.size(), -1);
    std::size_t joined = 0;
    for(const auto& entry : narrow)
    {
      const int p = entry.second;
      if(partner[p] != -1)
        continue;
      const int q = std::min_element(contacts[p].begin(), contacts[p].end(), [](const auto& a, const auto& b)
                                     { return a.second.mean_bend() < b.second.mean_bend(); })->first;
      if(partner[q] != -1)
        continue;
      partner[p] = q;
      partner[q] = p;
      ++joined;
    }
    for(edge_descriptor e : edges(tm))
      if(!is_border(e, tm) && get(is_sharp, e))
      {
        const int p = get(patch, face(halfedge(e, tm), tm)), q = get(patch, face(opposite(halfedge(e, tm), tm), tm));
        if(p != q && partner[p] == q)
          put(is_sharp, e, false);
      }
    return joined;
  }

  // One minus the cosine of the angle between the normals; one if a face has none.
  double bend(face_descriptor f, face_descriptor g) const
  {
    const Vector_3 a = area_vector(f), b = area_vector(g);
    const double lengths = approximate_sqrt(a.squared_length() * b.squared_length());
    return lengths > 0 ? 1 - a * b / lengths : 1;
  }

  const TriangleMesh& tm;
  const VertexPointMap vpm;
  EdgeIsSharpMap is_sharp;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int> >::const_type patch;
  std::vector<Patch> patches;
};

// See Patch_merging. Border edges must not be marked.
template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsSharpMap>
std::size_t merge_narrow_patches(const TriangleMesh& tm, VertexPointMap vpm, double least_width, EdgeIsSharpMap is_sharp)
{
  return Patch_merging<TriangleMesh, VertexPointMap, EdgeIsSharpMap>(tm, vpm, is_sharp).run(least_width);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_INTERNAL_MERGE_NARROW_PATCHES_H
