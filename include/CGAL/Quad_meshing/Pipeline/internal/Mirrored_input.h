// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_MIRRORED_INPUT_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_MIRRORED_INPUT_H

#include <CGAL/Quad_meshing/Guides/mirror_triangles.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Placed_guides.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Triangle_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

inline Guided_triangles guided_triangles(const Triangle_input& input)
{
  Guided_triangles t;
  t.points = input.points;
  t.triangles = input.triangles;
  return t;
}

// The half of an input on the positive side of a mirror, with what was given on it. Sides in the mirror are curves.
inline Triangle_input half_of_input(const Triangle_input& input, const Mirror_half& half)
{
  Triangle_input result;
  result.points = half.points;
  result.triangles = half.triangles;
  for(std::size_t i = 0; i < half.triangles.size(); ++i)
  {
    const std::size_t f = half.origin[i];
    result.origin.push_back(input.original(f));
    auto inherited = [&](const std::vector<std::array<char, 3>>& marks)
    {
      std::array<char, 3> sides = { { 0, 0, 0 } };
      for(int k = 0; k < 3; ++k)
        if(half.side[i][k] != Cut_triangles::inside && !marks.empty())
          sides[k] = marks[f][static_cast<std::size_t>(half.side[i][k])];
      return sides;
    };
    result.is_curve.push_back(inherited(input.is_curve));
    for(int k = 0; k < 3; ++k)
      if(half.is_cut[i][k])
        result.is_curve.back()[k] = 1;
    if(input.has_features())
      result.is_feature.push_back(inherited(input.is_feature));
    if(!input.directions.empty())
      result.directions.push_back(input.directions[f]);
    if(!input.face_lengths.empty())
      result.face_lengths.push_back(input.face_lengths[f]);
  }
  if(!input.vertex_lengths.empty())
    for(std::size_t v = 0; v < half.points.size(); ++v)
    {
      const double a = input.vertex_lengths[half.ends[v][0]], b = input.vertex_lengths[half.ends[v][1]];
      result.vertex_lengths.push_back(a > 0 && b > 0 ? (1 - half.weight[v]) * a + half.weight[v] * b : 0);
    }
  return result;
}

// What the user has drawn, on the positive side of a mirror: the rest is mirrored. Lines are divided where they cross.
class Mirrored_guides
{
  typedef Mirror::Point_3 Point_3;

public:
  explicit Mirrored_guides(const Mirror& mirror) : m_mirror(mirror) {}

  // What lies on both sides and cannot be divided, as a sentence; empty: nothing does.
  std::string crossing(const Quadrangulation_options& o) const
  {
    for(std::size_t i = 0; i < o.connections.size(); ++i)
      if(m_mirror.distance(o.connections[i].from) * m_mirror.distance(o.connections[i].to) < 0)
        return "The ends of " + guide_name(o.connections[i], "connection", i) +
               " lie on different sides of a plane of symmetry; connect each of them with a point of the plane.";
    for(std::size_t i = 0; i < o.index_guides.size(); ++i)
      if(o.index_guides[i].is_sum && std::abs(m_mirror.distance(o.index_guides[i].point)) < o.index_guides[i].radius)
        return "The region of " + guide_name(o.index_guides[i], "index", i) +
               " crosses a plane of symmetry; a sum can be chosen on one side of it alone.";
    return std::string();
  }

  void apply(Quadrangulation_options& o) const
  {
    o.feature_curves = divided(o.feature_curves, "curve");
    o.strokes = divided(o.strokes, "stroke");
    for(Size_disc& d : o.size_discs)
      d.center = folded(d.center);
    for(std::size_t i = 0; i < o.connections.size(); ++i)
    {
      o.connections[i].name = guide_name(o.connections[i], "connection", i);
      o.connections[i].from = folded(o.connections[i].from);
      o.connections[i].to = folded(o.connections[i].to);
    }
    for(std::size_t i = 0; i < o.index_guides.size(); ++i)
    {
      o.index_guides[i].name = guide_name(o.index_guides[i], "index", i);
      o.index_guides[i].point = folded(o.index_guides[i].point);
    }
  }

private:
  Point_3 folded(const Point_3& p) const { return m_mirror.distance(p) < 0 ? m_mirror.image(p) : p; }

  template <typename Curve>
  std::vector<Curve> divided(const std::vector<Curve>& curves, const char* kind) const
  {
    std::vector<Curve> result;
    for(std::size_t i = 0; i < curves.size(); ++i)
    {
      Curve part = curves[i];
      part.name = guide_name(curves[i], kind, i);
      std::vector<Point_3> points = part.points;
      if(part.is_closed && !points.empty())
        points.push_back(points.front());
      part.points.clear();
      bool is_divided = false;
      for(std::size_t k = 0; k < points.size(); ++k)
      {
        if(k > 0)
        {
          const double a = m_mirror.distance(points[k - 1]), b = m_mirror.distance(points[k]);
          if(a * b < 0)
          {
            const Point_3 p = m_mirror.projection(points[k - 1] + a / (a - b) * (points[k] - points[k - 1]));
            part.points.push_back(p);
            part.is_closed = false;
            result.push_back(part);
            part.points.assign(1, p);
            is_divided = true;
          }
        }
        part.points.push_back(folded(points[k]));
      }
      if(part.is_closed && !is_divided)
        part.points.pop_back();
      else
        part.is_closed = false;
      result.push_back(part);
    }
    return result;
  }

  const Mirror& m_mirror;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_MIRRORED_INPUT_H
