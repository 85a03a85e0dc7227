// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_QUAD_MESH_ON_REFERENCE_H
#define CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_QUAD_MESH_ON_REFERENCE_H

#include <CGAL/Quad_meshing/Smoothing/internal/Reference_curves.h>
#include <CGAL/Quad_meshing/Smoothing/internal/Wanted_directions.h>
#include <CGAL/Quad_meshing/internal/Any_visitor.h>
#include <CGAL/Quad_meshing/internal/Indexed_quad_mesh.h>
#include <CGAL/Quad_meshing/internal/Quad_shape.h>
#include <CGAL/Quad_meshing/internal/Reference_surface.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A quad mesh on a reference surface: where each vertex may go, and what becomes of the quads around it then.
class Quad_mesh_on_reference
{
public:
  typedef Indexed_quad_mesh::Point_3 Point_3;
  typedef Indexed_quad_mesh::Vector_3 Vector_3;

  // A step may not make the smallest scaled Jacobian around its vertex smaller, if it is below this then.
  // What has just been unfolded needs more freedom.
  static constexpr double guarded_jacobian = 0.7, guarded_when_unfolding = 0.2;

  enum Vertex_kind : char
  {
    fixed,
    on_surface,
    on_feature,
    on_border
  };

  Quad_mesh_on_reference(Indexed_quad_mesh& mesh, Reference_surface& surface, Reference_curves& features,
                         Reference_curves& borders, const std::vector<char>& is_fixed_vertex,
                         const std::vector<double>& length, const Wanted_directions* directions, Any_visitor& visitor)
    : m_mesh(mesh)
    , m_surface(surface)
    , m_features(features)
    , m_borders(borders)
    , m_length(length)
    , m_directions(directions)
    , m_visitor(visitor)
  {
    m_was_unfolded.assign(m_mesh.number_of_vertices(), 0);
    collect_incident_corners();
    classify(is_fixed_vertex);
    m_normal.resize(m_mesh.number_of_faces());
    m_jacobian.resize(m_mesh.number_of_faces());
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      update_face(f);
    update_scales();
  }

  // All that takes long ends early if the visitor says so; the mesh is of no use then.

  // Puts every free vertex onto its reference where this folds nothing.
  void project()
  {
    m_place.assign(m_mesh.number_of_vertices(), -1);
    m_is_off.assign(m_mesh.number_of_vertices(), 0);
    int hint = -1;
    for(int v = 0; v < m_mesh.number_of_vertices() && goes_on(v); ++v)
    {
      if(m_kind[v] == fixed)
        continue;
      if(m_kind[v] == on_surface)
        for(int i = m_first[v]; i < m_first[v + 1]; ++i)
        {
          const int w = m_mesh.target(m_corner[i]);
          if(m_kind[w] == on_surface && m_place[w] != -1)
            hint = m_place[w];
        }
      const Nearest nearest = nearest_on_reference(v, hint);
      m_place[v] = nearest.place;
      if(m_kind[v] == on_surface)
        hint = nearest.place;
      // what sits at the end of a curve is the corner there
      else if(nearest.at_end &&
              squared_distance(nearest.point, m_mesh.points[v]) <= corner_capture * corner_capture * m_scale[v])
        m_kind[v] = fixed;
      put_onto_reference(v, nearest, guarded_jacobian);
    }
  }

  // Puts the vertices that were left off their reference, as they would have folded something there, onto it now that
  // their neighbours have moved, however much worse, but not folded, the quads around them become. Returns whether one
  // has moved.
  bool project_leftovers()
  {
    bool any = false;
    for(int v = 0; v < m_mesh.number_of_vertices() && goes_on(v); ++v)
      if(m_is_off[v] && m_kind[v] != fixed)
      {
        put_onto_reference(v, nearest_on_reference(v, m_place[v]), 0);
        any = any || !m_is_off[v];
      }
    return any;
  }

  // The quads that are folded: those with a corner that is not convex, and those whose normal is
  // opposed to the normal of the surface below. (At a sharp tip the two may well differ by more than a
  // right angle.)
  std::vector<int> folded_quads()
  {
    std::vector<int> folded;
    for(int f = 0; f < m_mesh.number_of_faces() && goes_on(f); ++f)
      if(m_jacobian[f] <= 0 || is_opposed(f))
        folded.push_back(f);
    return folded;
  }

protected:
  // Elements that are worked on before the visitor is asked again: some milliseconds.
  static constexpr int elements_at_once = 256;

  // Whether to go on with element i of many.
  bool goes_on(int i) const { return i % elements_at_once != 0 || m_visitor.go_further(); }

  // A curve vertex that lies this close to a corner of the reference, relative to the sides around
  // it, is that corner.
  static constexpr double corner_capture = 0.02;
  // Cosine of the angle between opposed normals.
  static constexpr double opposed = -0.5;

  struct Nearest
  {
    int place;
    Point_3 point;
    bool at_end; // of a curve
  };

  Nearest nearest_on_reference(int v, int hint)
  {
    if(m_kind[v] == on_surface)
    {
      const Reference_surface::Location l = m_surface.locate(m_mesh.points[v], hint);
      return Nearest{ l.face, l.point, false };
    }
    const Reference_curves::Location l = (m_kind[v] == on_feature ? m_features : m_borders).locate(m_mesh.points[v]);
    return Nearest{ l.segment, l.point, l.at_end };
  }

  // The place on its reference downhill from where v is: it cannot jump.
  Nearest walk_on_reference(int v, const Point_3& p) const
  {
    if(m_kind[v] == on_surface)
    {
      const Reference_surface::Location l = m_surface.walk(p, m_place[v]);
      return Nearest{ l.face, l.point, false };
    }
    const Reference_curves::Location l = (m_kind[v] == on_feature ? m_features : m_borders).walk(p, m_place[v]);
    return Nearest{ l.segment, l.point, l.at_end };
  }

  void put_onto_reference(int v, const Nearest& nearest, double guard)
  {
    m_is_off[v] = !is_safe(v, nearest.point, guard);
    if(m_is_off[v])
      return;
    m_place[v] = nearest.place;
    move(v, nearest.point);
  }

  void collect_incident_corners()
  {
    m_first.assign(m_mesh.number_of_vertices() + 1, 0);
    for(const std::array<int, 4>& c : m_mesh.corners)
      for(int v : c)
        ++m_first[v + 1];
    for(std::size_t i = 1; i < m_first.size(); ++i)
      m_first[i] += m_first[i - 1];
    m_corner.resize(m_mesh.number_of_halfedges());
    std::vector<int> fill(m_first.begin(), m_first.end() - 1);
    for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      m_corner[fill[m_mesh.source(h)]++] = h;
  }

  void classify(const std::vector<char>& is_fixed_vertex)
  {
    std::vector<int> feature_degree(m_mesh.number_of_vertices(), 0), border_degree(m_mesh.number_of_vertices(), 0);
    for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if(m_mesh.edge(h) == h && (m_mesh.is_feature[h] || m_mesh.is_border(h)))
        for(int v : { m_mesh.source(h), m_mesh.target(h) })
          ++(m_mesh.is_border(h) ? border_degree : feature_degree)[v];

    m_kind.assign(m_mesh.number_of_vertices(), on_surface);
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(is_fixed_vertex[v] || m_first[v] == m_first[v + 1])
        m_kind[v] = fixed;
      else if(feature_degree[v] + border_degree[v] != 0)
        m_kind[v] = border_degree[v] == 2 && feature_degree[v] == 0 && !m_borders.empty()    ? on_border
                    : feature_degree[v] == 2 && border_degree[v] == 0 && !m_features.empty() ? on_feature
                                                                                             : fixed;
  }

  // The mean squared side around a vertex, and from there around a quad: the area its corners aim at.
  void update_scales()
  {
    m_scale.assign(m_mesh.number_of_vertices(), 0);
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      for(int i = m_first[v]; i < m_first[v + 1]; ++i)
      {
        const std::array<int, 4>& c = m_mesh.corners[m_corner[i] / 4];
        for(int k = 0; k < 4; ++k)
          m_scale[v] += squared_distance(m_mesh.points[c[k]], m_mesh.points[c[(k + 1) % 4]]) / 4;
      }
      if(m_first[v] < m_first[v + 1])
        m_scale[v] /= m_first[v + 1] - m_first[v];
    }
    m_area.resize(m_mesh.number_of_faces());
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      m_area[f] = 0;
      for(int v : m_mesh.corners[f])
        m_area[f] += m_scale[v] / 4;
      // a mesh that has collapsed here altogether
      m_area[f] = (std::max)(m_area[f], (std::numeric_limits<double>::min)());
    }
    if(!m_length.empty() && !m_place.empty())
      aim_at_lengths();
    if(m_directions != nullptr)
      update_wishes();
  }

  // What directions are wanted where the quads are now.
  void update_wishes()
  {
    const bool is_first = m_direction_place.empty();
    m_direction_place.resize(m_mesh.number_of_faces(), -1);
    m_wish.resize(m_mesh.number_of_faces());
    for(int f = 0; f < m_mesh.number_of_faces() && goes_on(f); ++f)
    {
      const Point_3 middle = middle_of(f);
      const int before = is_first ? f == 0 ? -1 : m_direction_place[f - 1] : m_direction_place[f];
      m_direction_place[f] = is_first ? m_directions->locate(middle, before) : m_directions->walk(middle, before);
      m_wish[f] = m_directions->at(m_direction_place[f], m_normal[f]);
    }
  }

  Point_3 middle_of(int f) const
  {
    Vector_3 sum(0, 0, 0);
    for(int v : m_mesh.corners[f])
      sum = sum + (m_mesh.points[v] - ORIGIN) / 4;
    return ORIGIN + sum;
  }

  // Where lengths are given, the corners of a quad aim at their squares, as far as these fit on the surface together.
  void aim_at_lengths()
  {
    std::vector<double> aim(m_mesh.number_of_faces(), 0);
    double aims = 0, areas = 0;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      int n = 0;
      for(int v : m_mesh.corners[f])
        if(m_kind[v] == on_surface && m_place[v] != -1)
        {
          aim[f] += m_length[m_place[v]] * m_length[m_place[v]];
          ++n;
        }
      if(n == 0)
        continue;
      aim[f] /= n;
      aims += aim[f];
      areas += m_area[f];
    }
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      if(aim[f] > 0)
        m_area[f] = aim[f] * (areas / aims);
  }

  void update_face(int f)
  {
    const std::array<int, 4>& c = m_mesh.corners[f];
    m_jacobian[f] = minimal_scaled_jacobian(m_mesh.points[c[0]], m_mesh.points[c[1]], m_mesh.points[c[2]],
                                            m_mesh.points[c[3]], m_normal[f]);
  }

  void move(int v, const Point_3& p)
  {
    m_mesh.points[v] = p;
    for(int i = m_first[v]; i < m_first[v + 1]; ++i)
      update_face(m_corner[i] / 4);
  }

  // Whether v may move to p: no quad around it that is convex would be so no longer, or be turned
  // over, and the worst of them would not be worse than now, unless it is good enough.
  bool is_safe(int v, const Point_3& p, double guard) const
  {
    double worst_now = m_was_unfolded[v] ? (std::min)(guard, guarded_when_unfolding) : guard;
    for(int i = m_first[v]; i < m_first[v + 1]; ++i)
      worst_now = (std::min)(worst_now, m_jacobian[m_corner[i] / 4]);
    for(int i = m_first[v]; i < m_first[v + 1]; ++i)
    {
      const int h = m_corner[i], f = h / 4;
      const std::array<int, 4>& c = m_mesh.corners[f];
      Vector_3 normal;
      const double jacobian = minimal_scaled_jacobian(p, m_mesh.points[c[(h + 1) & 3]], m_mesh.points[c[(h + 2) & 3]],
                                                      m_mesh.points[c[(h + 3) & 3]], normal);
      if(jacobian < worst_now || (m_jacobian[f] > 0 && (jacobian <= 0 || normal * m_normal[f] <= 0)))
        return false;
    }
    return true;
  }

  // Whether the normal of a quad is opposed to that of the surface below.
  bool is_opposed(int f) { return reference_normal(f) * m_normal[f] < opposed; }

  // The surface normal below the middle of a quad, found from one of its vertices on the surface.
  Vector_3 reference_normal(int f)
  {
    Vector_3 normals(0, 0, 0);
    int place = -1;
    for(int v : m_mesh.corners[f])
      if(m_kind[v] == on_surface && m_place[v] != -1)
      {
        place = m_place[v];
        normals = normals + m_surface.normal(place);
      }
    const Point_3 middle = middle_of(f);
    place = place == -1 ? m_surface.locate(middle, -1).face : m_surface.walk(middle, place).face;
    return unit_or_zero(normals + m_surface.normal(place));
  }

  Indexed_quad_mesh& m_mesh;
  Reference_surface& m_surface;
  Reference_curves& m_features;
  Reference_curves& m_borders;
  const std::vector<double>& m_length;   // per face of the surface: see `Indexed_reference`
  const Wanted_directions* m_directions; // null: there are none
  Any_visitor& m_visitor;

  std::vector<int> m_first, m_corner;          // per vertex: the halfedges that leave it, border or not
  std::vector<Vertex_kind> m_kind;             // per vertex
  std::vector<int> m_place;                    // per vertex: the face, or curve segment, it lies on
  std::vector<char> m_is_off;                  // per vertex: it is not there yet, as that would fold something
  std::vector<double> m_scale;                 // per vertex: mean squared side around it
  std::vector<double> m_area;                  // per face: the area its corners aim at
  std::vector<Vector_3> m_normal;              // per face: unit; of the quad, or of the surface while unfolding
  std::vector<double> m_jacobian;              // per face: minimal scaled Jacobian
  std::vector<char> m_was_unfolded;            // per vertex: lay close to a fold
  std::vector<int> m_direction_place;          // per face: where in the directions its middle lies
  std::vector<Wanted_directions::Wish> m_wish; // per face: a direction of its sides; empty: there are none
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_SMOOTHING_INTERNAL_QUAD_MESH_ON_REFERENCE_H
