// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEFECTS_H
#define CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEFECTS_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief counts what keeps points and polygons from being a pure quad mesh, that is an oriented
 * 2-manifold, with or without boundary, all of whose faces are quads.
 */
struct Quad_mesh_defects
{
  std::size_t faces = 0;                      ///< number of faces in all
  std::size_t faces_not_quads = 0;            ///< faces with another number of corners than four
  std::size_t faces_repeating_vertices = 0;   ///< faces that use a vertex twice
  std::size_t invalid_indices = 0;            ///< corners that name a vertex that does not exist
  std::size_t invalid_coordinates = 0;        ///< vertices with a coordinate that is not finite
  std::size_t non_manifold_edges = 0;         ///< edges with more than two faces
  std::size_t inconsistent_edges = 0;         ///< edges whose two faces have opposite orientations
  std::size_t non_manifold_vertices = 0;      ///< vertices whose faces are not a single fan
  std::size_t isolated_vertices = 0;          ///< vertices without a face

  /// returns whether there are faces and none of the defects, isolated vertices aside.
  bool is_pure_quad_mesh() const { return faces > 0 && reasons().empty(); }

  /// returns one short sentence for each kind of defect that occurs, isolated vertices aside.
  std::vector<std::string> reasons() const
  {
    std::vector<std::string> list;
    auto say = [&](std::size_t n, const char* one, const char* many)
    {
      if(n > 0)
        list.push_back(std::to_string(n) + (n == 1 ? one : many));
    };
    if(faces == 0)
      list.push_back("there are no faces");
    say(faces_not_quads, " face is not a quad", " faces are not quads");
    say(invalid_indices, " corner names a vertex that does not exist", " corners name vertices that do not exist");
    say(invalid_coordinates, " vertex has a coordinate that is not finite", " vertices have coordinates that are not finite");
    say(faces_repeating_vertices, " face uses a vertex twice", " faces use a vertex twice");
    say(non_manifold_edges, " edge has more than two faces", " edges have more than two faces");
    say(inconsistent_edges, " edge lies between faces of opposite orientation", " edges lie between faces of opposite orientation");
    say(non_manifold_vertices, " vertex has faces that are not a single fan", " vertices have faces that are not a single fan");
    return list;
  }
};

/*!
 * \ingroup PkgQuadMeshingStructureRef
 *
 * \brief looks for everything that keeps points and polygons from being a pure quad mesh.
 *
 * Nothing is assumed about the input. If the result is without defects,
 * `CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh()` makes a quad mesh of it.
 *
 * \tparam PointRange a random access range of 3D points
 * \tparam PolygonRange a range of random access ranges of indices into the points
 *
 * \param points the vertices
 * \param polygons the faces
 */
template <typename PointRange, typename PolygonRange>
Quad_mesh_defects find_quad_mesh_defects(const PointRange& points, const PolygonRange& polygons)
{
  Quad_mesh_defects d;
  const std::size_t n = points.size();
  for(const auto& p : points)
    if(!is_finite(to_double(p.x())) || !is_finite(to_double(p.y())) || !is_finite(to_double(p.z())))
      ++d.invalid_coordinates;

  // sides as (smaller end, larger end), and whether they run from the smaller to the larger
  struct Side
  {
    std::size_t low, high, face, corner;
    bool is_ascending;
    bool operator<(const Side& s) const
    {
      return low != s.low ? low < s.low : high != s.high ? high < s.high : face != s.face ? face < s.face : corner < s.corner;
    }
  };
  std::vector<Side> sides;
  std::vector<std::size_t> first_corner;            // per face, and the number of corners at the end
  std::vector<std::size_t> vertex_of_corner;
  for(const auto& polygon : polygons)
  {
    const std::size_t degree = polygon.size();
    d.faces_not_quads += degree != 4;
    first_corner.push_back(vertex_of_corner.size());
    std::set<std::size_t> distinct;
    bool usable = true;
    for(const auto& v : polygon)
    {
      vertex_of_corner.push_back(static_cast<std::size_t>(v));
      distinct.insert(static_cast<std::size_t>(v));
      if(static_cast<std::size_t>(v) >= n)
      {
        ++d.invalid_indices;
        usable = false;
      }
    }
    d.faces_repeating_vertices += distinct.size() < degree;
    for(std::size_t k = 0; usable && k < degree; ++k)
    {
      const std::size_t v = vertex_of_corner[first_corner.back() + k];
      const std::size_t w = vertex_of_corner[first_corner.back() + (k + 1) % degree];
      sides.push_back(Side{ (std::min)(v, w), (std::max)(v, w), d.faces, first_corner.back() + k, v < w });
    }
    ++d.faces;
  }
  first_corner.push_back(vertex_of_corner.size());
  if(d.invalid_indices > 0)
    return d;

  // Corners of one vertex are joined over shared sides: one set of corners per fan.
  std::vector<std::size_t> fan(vertex_of_corner.size());
  for(std::size_t c = 0; c < fan.size(); ++c)
    fan[c] = c;
  auto find = [&](std::size_t c)
  {
    while(fan[c] != c)
      c = fan[c] = fan[fan[c]];
    return c;
  };
  std::sort(sides.begin(), sides.end());
  for(std::size_t i = 0, j; i < sides.size(); i = j)
  {
    for(j = i + 1; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high; ++j) {}
    d.non_manifold_edges += j - i > 2;
    d.inconsistent_edges += j - i == 2 && sides[i].is_ascending == sides[i + 1].is_ascending;
    for(std::size_t k = i + 1; k < j; ++k)
    {
      auto behind = [&](const Side& s)
      {
        return s.corner + 1 == first_corner[s.face + 1] ? first_corner[s.face] : s.corner + 1;
      };
      const std::size_t a[2] = { sides[i].corner, behind(sides[i]) }, b[2] = { sides[k].corner, behind(sides[k]) };
      const bool same = sides[i].is_ascending == sides[k].is_ascending;
      for(int e = 0; e < 2; ++e)
        fan[find(a[e])] = find(b[same ? e : 1 - e]);
    }
  }
  std::vector<std::size_t> number_of_fans(n, 0);
  for(std::size_t c = 0; c < fan.size(); ++c)
    number_of_fans[vertex_of_corner[c]] += find(c) == c;
  for(std::size_t k : number_of_fans)
  {
    d.isolated_vertices += k == 0;
    d.non_manifold_vertices += k > 1;
  }
  return d;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUAD_MESH_QUAD_MESH_DEFECTS_H
