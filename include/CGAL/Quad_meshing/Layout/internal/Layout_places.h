// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_PLACES_H
#define CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_PLACES_H

#include <CGAL/Quad_meshing/Layout/Surface_layout.h>
#include <CGAL/Quad_meshing/Layout/internal/Split_surface.h>
#include <CGAL/Quad_meshing/internal/Reference_surface.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Makes vertices of places on a surface.
class Layout_places
{
public:
  typedef Indexed_triangle_mesh::Point_3 Point_3;
  typedef Indexed_triangle_mesh::Vector_3 Vector_3;

  // A place whose barycentric coordinate is that near to 1 or 0 is moved to the vertex or edge: the triangles that it
  // would make otherwise are needles.
  static constexpr double snapping = 0.02;

  Layout_places(const Indexed_triangle_mesh& input, Split_surface& surface)
    : m_number_of_input_vertices(input.number_of_vertices()), m_reference(input), m_surface(surface)
  {
  }

  // Whether there is nothing to place anything on.
  bool is_empty() const { return m_reference.empty(); }

  // The vertex at a place, -1 if the place names a vertex that there is not, or a point that is not finite.
  int vertex(const Surface_layout::Place& place)
  {
    if(place.vertex != Surface_layout::none)
      return place.vertex < static_cast<std::size_t>(m_number_of_input_vertices) &&
                 m_surface.mesh.halfedge_of_vertex[place.vertex] != -1
               ? static_cast<int>(place.vertex)
               : -1;
    const Point_3 p(place.point[0], place.point[1], place.point[2]);
    if(!is_finite(p))
      return -1;
    const Reference_surface::Location location = m_reference.locate(p, -1);
    return insert(location.face, location.point);
  }

  // The vertex at the place of the border nearest to a place, -1 if there is no border.
  int border_vertex(const Surface_layout::Place& place)
  {
    const Indexed_triangle_mesh& m = m_surface.mesh;
    if(place.vertex != Surface_layout::none)
    {
      const int v = vertex(place);
      return v != -1 && m.opposite[m.halfedge_of_vertex[v]] == -1 ? v : -1;
    }
    const Point_3 p(place.point[0], place.point[1], place.point[2]);
    if(!is_finite(p))
      return -1;
    int best = -1;
    double best_t = 0, best_distance = (std::numeric_limits<double>::infinity)();
    for(int h = 0; h < m.number_of_halfedges(); ++h)
      if(m.opposite[h] == -1)
      {
        const Vector_3 e = m.vector(h);
        const double length2 = e.squared_length();
        const double t = length2 > 0 ? (std::min)((std::max)(((p - m.points[m.source(h)]) * e) / length2, 0.), 1.) : 0;
        const double d = squared_distance(p, m.points[m.source(h)] + t * e);
        if(d < best_distance)
        {
          best = h;
          best_t = t;
          best_distance = d;
        }
      }
    return best == -1 ? -1 : insert_on_edge(best, best_t);
  }

private:
  int insert_on_edge(int h, double t)
  {
    const Indexed_triangle_mesh& m = m_surface.mesh;
    if(t < snapping)
      return m.source(h);
    if(t > 1 - snapping)
      return m.target(h);
    const int before = m.number_of_faces();
    const int v = m_surface.split_edge(h, m.points[m.source(h)] + t * m.vector(h));
    note_new_faces(before);
    return v;
  }

  void note_new_faces(int before)
  {
    for(int f = before; f < m_surface.mesh.number_of_faces(); ++f)
    {
      std::vector<int>& parts = m_parts[m_surface.origin[f]];
      if(parts.empty())
        parts.push_back(m_surface.origin[f]); // an input face keeps its number
      parts.push_back(f);
    }
  }

  // The barycentric coordinates of a point of the plane of a face; a face without area has it at its first corner.
  std::array<double, 3> coordinates(int f, const Point_3& p) const
  {
    const std::array<int, 3>& c = m_surface.mesh.corners[f];
    const Point_3 &a = m_surface.mesh.points[c[0]], &b = m_surface.mesh.points[c[1]], &d = m_surface.mesh.points[c[2]];
    const Vector_3 n = cross_product(b - a, d - a);
    const double n2 = n.squared_length();
    if(!(n2 > 0))
      return { { 1, 0, 0 } };
    const double v = (cross_product(p - a, d - a) * n) / n2, w = (cross_product(b - a, p - a) * n) / n2;
    return { { 1 - v - w, v, w } };
  }

  int insert(int input_face, const Point_3& p)
  {
    const std::map<int, std::vector<int>>::const_iterator found = m_parts.find(input_face);
    const std::vector<int> parts = found == m_parts.end() ? std::vector<int>(1, input_face) : found->second;
    int face = parts.front();
    std::array<double, 3> w = coordinates(face, p);
    for(int f : parts)
    {
      const std::array<double, 3> x = coordinates(f, p);
      if(*std::min_element(x.begin(), x.end()) > *std::min_element(w.begin(), w.end()))
      {
        face = f;
        w = x;
      }
    }
    for(int k = 0; k < 3; ++k)
      if(w[k] > 1 - snapping)
        return m_surface.mesh.corners[face][k];
    const int least = static_cast<int>(std::min_element(w.begin(), w.end()) - w.begin());
    if(w[least] < snapping)
    {
      const int a = (least + 1) % 3, b = (least + 2) % 3;
      return insert_on_edge(3 * face + a, w[b] / (w[a] + w[b]));
    }
    const int before = m_surface.mesh.number_of_faces();
    const int v = m_surface.split_face(face, p);
    note_new_faces(before);
    return v;
  }

  const int m_number_of_input_vertices;
  Reference_surface m_reference;
  Split_surface& m_surface;
  std::map<int, std::vector<int>> m_parts; // the faces in an input face, where it has been split
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_LAYOUT_INTERNAL_LAYOUT_PLACES_H
