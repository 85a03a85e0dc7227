// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SURFACE_COMPONENTS_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SURFACE_COMPONENTS_H

#include <CGAL/Quad_meshing/Pipeline/internal/Element_names.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Triangle_input.h>
#include <CGAL/Quad_meshing/internal/Disjoint_sets.h>
#include <CGAL/Quad_meshing/internal/Spatial_numbers.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The components of the input as meshes of their own.
//
// Vertices and faces are numbered by their places in space, so that the numbers of the input do not matter; what lies
// close together is close in memory. A vertex in which borders touch is divided: each fan of triangles gets its own.
class Surface_components
{
  typedef Quadrangulation_mesh Mesh;
  typedef std::array<int, 3> Triangle;

public:
  std::vector<std::unique_ptr<Quadrangulation_surface>> surfaces; // those with the smallest points come first
  std::size_t number_of_divided_vertices = 0;
  std::string error; // a sentence; empty if all went well

  explicit Surface_components(const Triangle_input& input, const Element_names& names = Element_names())
    : m_input(input), m_names(names)
  {
    if(!match_sides())
      return;
    find_components();
    number_vertices();
    const std::vector<std::vector<Face>> components = sorted_components();
    for(const std::vector<Face>& faces : components)
    {
      surfaces.push_back(std::make_unique<Quadrangulation_surface>());
      fill(faces, *surfaces.back());
    }
  }

private:
  // A triangle in new vertices, turned so that the first is the smallest.
  struct Face
  {
    Triangle corners;
    int number;     // in the input
    int first_side; // of the input's triangle, that starts at the first corner

    bool operator<(const Face& f) const { return std::tie(corners, number) < std::tie(f.corners, f.number); }
  };

  int number_of_faces() const { return static_cast<int>(m_input.triangles.size()); }
  int vertex(int side) const { return m_input.triangles[side / 3][side % 3]; }
  static int next(int side) { return side % 3 == 2 ? side - 2 : side + 1; }

  // Side 3 f + k runs from corner k of face f to the next. In a surface, each has at most one opposite.
  bool match_sides()
  {
    const int ns = 3 * number_of_faces();
    std::vector<int> order(ns);
    std::iota(order.begin(), order.end(), 0);
    auto ends = [&](int s)
    {
      const int a = vertex(s), b = vertex(next(s));
      return std::make_pair((std::min)(a, b), (std::max)(a, b));
    };
    std::sort(order.begin(), order.end(),
              [&](int s, int t)
              {
                const std::pair<int, int> a = ends(s), b = ends(t);
                return a != b ? a < b : s < t;
              });
    m_opposite.assign(ns, -1);
    for(int i = 0; i < ns;)
    {
      int j = i + 1;
      while(j < ns && ends(order[j]) == ends(order[i]))
        ++j;
      const int s = order[i], t = order[j - 1];
      if(vertex(s) == vertex(next(s)))
        return fail("There is a triangle that has " + name(s) + " twice.");
      if(j - i > 2)
        return fail("There is more than one edge between " + name(s) + " and " + name(next(s)) + ".");
      if(j - i == 2)
      {
        if(vertex(s) == vertex(t))
          return fail("The triangles at the edge between " + name(s) + " and " + name(next(s)) +
                      " have opposite orientations.");
        m_opposite[s] = t;
        m_opposite[t] = s;
      }
      i = j;
    }
    return true;
  }

  std::string name(int side) const { return m_names.vertex(static_cast<std::size_t>(vertex(side))); }

  bool fail(const std::string& message)
  {
    error = message;
    return false;
  }

  // One vertex per fan of triangles, in the order of a curve through space.
  void number_vertices()
  {
    const int ns = 3 * number_of_faces();
    Disjoint_sets fans(ns); // of corners, each with the number of the side that starts there
    for(int s = 0; s < ns; ++s)
      if(m_opposite[s] != -1)
        fans.join(s, next(m_opposite[s]));
    std::vector<int> roots;
    std::vector<char> is_used(m_input.points.size(), 0);
    for(int s = 0; s < ns; ++s)
      if(fans.find(s) == s)
      {
        roots.push_back(s);
        number_of_divided_vertices += is_used[vertex(s)] == 1;
        is_used[vertex(s)] = static_cast<char>((std::min)(2, is_used[vertex(s)] + 1));
      }
    // A component is numbered as if it were alone.
    std::vector<Bbox_3> boxes(m_number_of_components);
    std::vector<std::size_t> sizes(m_number_of_components, 0);
    for(int r : roots)
    {
      boxes[m_component[r / 3]] += point(r).bbox();
      ++sizes[m_component[r / 3]];
    }
    std::vector<Z_curve> curves;
    for(int c = 0; c < m_number_of_components; ++c)
      curves.emplace_back(boxes[c], sizes[c]);
    std::vector<std::pair<std::array<int, 2>, int>> keys; // component and cell of its curve, root
    for(int r : roots)
    {
      const int c = m_component[r / 3];
      keys.push_back({ { { c, curves[c].cell(point(r)) } }, r });
    }
    std::sort(keys.begin(), keys.end(),
              [&](const auto& a, const auto& b)
              {
                if(a.first != b.first)
                  return a.first < b.first;
                if(point(a.second) != point(b.second))
                  return point(a.second) < point(b.second);
                return a.second < b.second;
              });
    std::vector<int> number(ns);
    for(const auto& k : keys)
    {
      number[k.second] = static_cast<int>(m_points.size());
      m_points.push_back(point(k.second));
    }
    m_corner.resize(ns);
    for(int s = 0; s < ns; ++s)
      m_corner[s] = number[fans.find(s)];
  }

  const Quadrangulation_kernel::Point_3& point(int side) const { return m_input.points[vertex(side)]; }

  // Components are numbered in the order of their smallest points.
  void find_components()
  {
    Disjoint_sets sets(number_of_faces());
    for(int s = 0; s < 3 * number_of_faces(); ++s)
      if(m_opposite[s] != -1)
        sets.join(s / 3, m_opposite[s] / 3);
    std::vector<int> smallest(number_of_faces(), -1); // per root: the side that starts at the smallest point
    for(int s = 0; s < 3 * number_of_faces(); ++s)
    {
      int& t = smallest[sets.find(s / 3)];
      if(t == -1 || point(s) < point(t))
        t = s;
    }
    std::vector<int> roots;
    for(int f = 0; f < number_of_faces(); ++f)
      if(sets.find(f) == f)
        roots.push_back(f);
    std::sort(roots.begin(), roots.end(),
              [&](int a, int b)
              {
                const auto& p = point(smallest[a]);
                const auto& q = point(smallest[b]);
                return p != q ? p < q : a < b;
              });
    m_number_of_components = static_cast<int>(roots.size());
    std::vector<int> component_of_root(number_of_faces(), -1);
    for(int c = 0; c < m_number_of_components; ++c)
      component_of_root[roots[c]] = c;
    m_component.resize(number_of_faces());
    for(int f = 0; f < number_of_faces(); ++f)
      m_component[f] = component_of_root[sets.find(f)];
  }

  std::vector<std::vector<Face>> sorted_components() const
  {
    std::vector<std::vector<Face>> components(m_number_of_components);
    for(int f = 0; f < number_of_faces(); ++f)
    {
      int first = 0;
      for(int k = 1; k < 3; ++k)
        if(m_corner[3 * f + k] < m_corner[3 * f + first])
          first = k;
      Face face;
      for(int k = 0; k < 3; ++k)
        face.corners[k] = m_corner[3 * f + (first + k) % 3];
      face.number = f;
      face.first_side = first;
      components[m_component[f]].push_back(face);
    }
    for(std::vector<Face>& faces : components)
      std::sort(faces.begin(), faces.end());
    return components;
  }

  void fill(const std::vector<Face>& faces, Quadrangulation_surface& surface) const
  {
    std::vector<int> used;
    for(const Face& f : faces)
      used.insert(used.end(), f.corners.begin(), f.corners.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    surface.mesh.reserve(static_cast<Mesh::size_type>(used.size()), static_cast<Mesh::size_type>(3 * faces.size() / 2),
                         static_cast<Mesh::size_type>(faces.size()));
    for(int v : used)
      surface.mesh.add_vertex(m_points[v]);
    auto index = [&](int v)
    {
      return Mesh::Vertex_index(
        static_cast<Mesh::size_type>(std::lower_bound(used.begin(), used.end(), v) - used.begin()));
    };
    for(const Face& f : faces)
    {
      const Mesh::Vertex_index v = index(f.corners[0]);
      const Mesh::Face_index face = surface.mesh.add_face(v, index(f.corners[1]), index(f.corners[2]));
      surface.origin[face] = static_cast<std::size_t>(f.number);
      if(!m_input.has_features() && m_input.is_curve.empty())
        continue;
      Mesh::Halfedge_index h = surface.mesh.halfedge(face);
      while(surface.mesh.source(h) != v)
        h = surface.mesh.next(h);
      for(int k = 0; k < 3; ++k, h = surface.mesh.next(h))
      {
        const int side = (f.first_side + k) % 3;
        if((m_input.has_features() && m_input.is_feature[f.number][side] != 0) ||
           (!m_input.is_curve.empty() && m_input.is_curve[f.number][side] != 0))
          surface.is_feature[surface.mesh.edge(h)] = surface.is_kept[surface.mesh.edge(h)] = true;
      }
    }
  }

  const Triangle_input& m_input;
  const Element_names m_names;
  std::vector<int> m_opposite; // per side, -1 on the border
  int m_number_of_components = 0;
  std::vector<int> m_component;                          // per face
  std::vector<int> m_corner;                             // per side: the new vertex that it starts at
  std::vector<Quadrangulation_kernel::Point_3> m_points; // per new vertex
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_SURFACE_COMPONENTS_H
