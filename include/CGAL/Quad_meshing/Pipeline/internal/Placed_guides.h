// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PLACED_GUIDES_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PLACED_GUIDES_H

#include <CGAL/Quad_meshing/Guides/Polyline_tracer.h>
#include <CGAL/Quad_meshing/Guides/cut_triangles.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Triangle_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What messages call a guide: its name, or its kind and number.
template <typename Guide>
std::string guide_name(const Guide& guide, const char* kind, std::size_t i)
{
  return guide.name.empty() ? std::string(kind) + " " + std::to_string(i + 1) : guide.name;
}

// A piece of a stroke or curve in one triangle of the input.
struct Guide_piece
{
  Quadrangulation_kernel::Point_3 from, to;
  Quadrangulation_kernel::Vector_3 normal; // unit, of the triangle; zero if it has none
};

// A stroke or curve on its component.
struct Placed_curve
{
  std::string name;
  std::size_t component = 0;
  double weight = 0;
  std::vector<Guide_piece> pieces;
  std::vector<Triangle_place> places; // in the triangles of the input
};

// A point on its component.
struct Placed_point
{
  std::size_t component = 0;
  Quadrangulation_kernel::Point_3 point;
  Quadrangulation_kernel::Vector_3 normal;
};

// A connection on its component.
struct Placed_connection
{
  std::string name;
  Placed_point from, to;
};

// Finds the places of guides on the surfaces of a quadrangulation.
class Guide_placer
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_kernel::Point_3 Point_3;
  typedef Quadrangulation_kernel::Vector_3 Vector_3;
  typedef Polyline_tracer<Mesh, Mesh::Property_map<Mesh::Vertex_index, Point_3>> Tracer;

public:
  Guide_placer(const std::vector<std::unique_ptr<Quadrangulation_surface>>& surfaces, const Triangle_input& input)
    : m_surfaces(surfaces), m_input(input)
  {
    for(const auto& s : surfaces)
      m_tracers.push_back(std::make_unique<Tracer>(s->mesh, s->mesh.points()));
  }

  // Returns what is wrong with the curve, as a sentence without a period; empty if nothing is.
  std::string place(const Guide_curve& curve, Placed_curve& placed) const
  {
    if(curve.points.size() < 2)
      return placed.name + " has less than two points";
    for(const Point_3& p : curve.points)
      if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
        return placed.name + " has a coordinate that is not a finite number";
    placed.component = nearest_component(curve.points.front());
    for(const Point_3& p : curve.points)
      if(nearest_component(p) != placed.component)
        return placed.name + " leads from one component of the surface to another";
    const Quadrangulation_surface& s = *m_surfaces[placed.component];
    Tracer& tracer = *m_tracers[placed.component];
    std::vector<Tracer::Face_location> path;
    if(!tracer.trace(curve.points, curve.is_closed, path))
      return placed.name + " cannot be traced on the surface";
    for(std::size_t i = 0; i < path.size(); ++i)
    {
      placed.places.push_back(place_in_input(s, path[i]));
      const Point_3 p = tracer.point(path[i]);
      if(i > 0 && p != placed.pieces.back().to)
      {
        placed.pieces.back().to = p;
        placed.pieces.back().normal = normal(s.mesh, path[i].first);
        placed.pieces.push_back({ p, p, NULL_VECTOR });
      }
      else if(i == 0)
        placed.pieces.push_back({ p, p, NULL_VECTOR });
    }
    placed.pieces.pop_back();
    return placed.pieces.empty() ? placed.name + " has no length on the surface" : std::string();
  }

  Placed_point place(const Point_3& p) const
  {
    Placed_point placed;
    placed.component = nearest_component(p);
    const Tracer& tracer = *m_tracers[placed.component];
    const Tracer::Face_location l = tracer.locate(p);
    placed.point = tracer.point(l);
    placed.normal = normal(m_surfaces[placed.component]->mesh, l.first);
    return placed;
  }

  // The component of the nearest place to a point, and the face there.
  std::pair<std::size_t, Mesh::Face_index> locate(const Point_3& p) const
  {
    const std::size_t c = nearest_component(p);
    return std::make_pair(c, m_tracers[c]->locate(p).first);
  }

private:
  std::size_t nearest_component(const Point_3& p) const
  {
    std::size_t nearest = 0;
    double distance = std::numeric_limits<double>::infinity();
    for(std::size_t c = 0; c < m_tracers.size(); ++c)
      if(m_tracers.size() > 1)
        if(const double d = m_tracers[c]->squared_distance_to(p); d < distance)
        {
          distance = d;
          nearest = c;
        }
    return nearest;
  }

  static Vector_3 normal(const Mesh& m, Mesh::Face_index f)
  {
    const Mesh::Halfedge_index h = m.halfedge(f);
    const Point_3& a = m.point(m.source(h));
    const Vector_3 n = cross_product(m.point(m.target(h)) - a, m.point(m.target(m.next(h))) - a);
    const double length = std::sqrt(n.squared_length());
    return length > 0 ? n / length : Vector_3(0, 0, 0);
  }

  // Corners of the copies are turned against those of the input.
  Triangle_place place_in_input(const Quadrangulation_surface& s, const Tracer::Face_location& l) const
  {
    const std::size_t f = s.origin[l.first];
    Triangle_place place{ static_cast<int>(f), { { 0, 0, 0 } } };
    const Point_3& first = s.mesh.point(s.mesh.source(s.mesh.halfedge(l.first)));
    int turn = 0;
    while(turn < 2 && m_input.points[m_input.triangles[f][turn]] != first)
      ++turn;
    for(int k = 0; k < 3; ++k)
      place.weight[(k + turn) % 3] = l.second[k];
    return place;
  }

  const std::vector<std::unique_ptr<Quadrangulation_surface>>& m_surfaces;
  const Triangle_input& m_input;
  std::vector<std::unique_ptr<Tracer>> m_tracers;
};

// The input, cut along curves.
inline Triangle_input cut_input(const Triangle_input& input, const std::vector<Placed_curve>& curves,
                                std::string& error)
{
  Guided_triangles triangles;
  triangles.points = input.points;
  triangles.triangles = input.triangles;
  std::vector<std::vector<Triangle_place>> places;
  for(const Placed_curve& c : curves)
    places.push_back(c.places);
  const Cut_triangles cut = cut_triangles(triangles, places);
  error = cut.error;
  Triangle_input result;
  result.points = cut.points;
  result.triangles = cut.triangles;
  for(std::size_t i = 0; i < cut.triangles.size(); ++i)
  {
    const std::size_t f = cut.origin[i];
    auto inherited = [&](const std::vector<std::array<char, 3>>& marks)
    {
      std::array<char, 3> sides = { { 0, 0, 0 } };
      for(int k = 0; k < 3; ++k)
        sides[k] = cut.side[i][k] != Cut_triangles::inside && !marks.empty() &&
                   marks[f][static_cast<std::size_t>(cut.side[i][k])] != 0;
      return sides;
    };
    result.origin.push_back(f);
    result.is_curve.push_back(inherited(input.is_curve));
    for(int k = 0; k < 3; ++k)
      if(cut.is_curve[i][k])
        result.is_curve.back()[k] = 1;
    if(input.has_features())
      result.is_feature.push_back(inherited(input.is_feature));
    if(!input.directions.empty())
      result.directions.push_back(input.directions[f]);
  }
  return result;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_PLACED_GUIDES_H
