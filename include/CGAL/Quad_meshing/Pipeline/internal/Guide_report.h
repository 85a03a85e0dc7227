// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GUIDE_REPORT_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GUIDE_REPORT_H

#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Component_guides.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Placed_guides.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/number_type_config.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Measures on a quad mesh how far the guides of the user are met. Each function returns what is not, as a sentence
// without a period, or nothing.
class Guide_report
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_kernel::Point_3 Point_3;
  typedef Quadrangulation_kernel::Vector_3 Vector_3;

public:
  explicit Guide_report(const Mesh& quads) : m_quads(quads)
  {
    m_edges.insert(edges(quads).first, edges(quads).second, quads);
    for(Mesh::Vertex_index v : quads.vertices())
      for(Mesh::Halfedge_index h : quads.halfedges_around_target(quads.halfedge(v)))
        m_reach = (std::max)(m_reach, length(h));
  }

  std::string of_curve(const Placed_curve& curve) const
  {
    const double least_share = 0.99; // of the length
    double on_edges = 0, total = 0;
    for_each_part(curve,
                  [&](const Point_3& p, const Vector_3& along, const Vector_3&, double part)
                  {
                    total += part;
                    // Chords leave a bent curve; an edge along the curve has its direction.
                    const double largest_distance = 0.15, largest_angle = 20; // edge lengths, degrees
                    const auto nearest = m_edges.closest_point_and_primitive(p);
                    const Mesh::Halfedge_index h = m_quads.halfedge(nearest.second);
                    const double l = length(h);
                    if(squared_distance(nearest.first, p) <= largest_distance * largest_distance * l * l &&
                       angle(vector(h), along) <= largest_angle)
                      on_edges += part;
                  });
    if(on_edges >= least_share * total)
      return std::string();
    return "only " + percent(on_edges / total) + " percent of the length of " + curve.name + " are quad edges";
  }

  std::string of_stroke(const Placed_curve& stroke) const
  {
    const double largest_mean = 5; // degrees
    double sum = 0, total = 0;
    for_each_part(stroke,
                  [&](const Point_3& p, const Vector_3& along, const Vector_3& normal, double part)
                  {
                    const double a = deviation(p, along, normal);
                    if(a < 0)
                      return;
                    total += part;
                    sum += a * part;
                  });
    if(!(sum > largest_mean * total))
      return std::string();
    return "the quads deviate from " + stroke.name + " by " + std::to_string(std::lround(sum / total)) +
           " degrees on average";
  }

  std::string of_index(const Component_wishes::Index_wish& wish) const
  {
    if(wish.guide->is_sum)
      return of_sum(wish);
    const double reach = wish.guide->index == 0 && std::isfinite(wish.guide->radius) ? wish.guide->radius : 0;
    if(std::isinf(wish.guide->radius)) // the indices of the field tell
      return std::string();
    const Mesh::Halfedge_index nearest = m_quads.halfedge(m_edges.closest_point_and_primitive(wish.place.point).second);
    const double local = length(nearest);
    // The place of an irregular vertex is that of a vertex of the working mesh.
    const double near = 1; // edge lengths
    bool is_there = false;
    int index_there = 0; // of the nearest vertex
    double nearest_distance = std::numeric_limits<double>::infinity();
    std::size_t irregular = 0;
    for(Mesh::Vertex_index v : m_quads.vertices())
    {
      const double d = std::sqrt(squared_distance(m_quads.point(v), wish.place.point));
      if(m_quads.is_border(v))
        continue;
      const int index = 4 - static_cast<int>(m_quads.degree(v));
      is_there = is_there || (d <= near * local && index == wish.guide->index);
      if(d < nearest_distance)
      {
        nearest_distance = d;
        index_there = index;
      }
    }
    for(Mesh::Vertex_index v : part_around(wish.place, reach))
      irregular += !m_quads.is_border(v) && m_quads.degree(v) != 4;
    if(wish.guide->index == 0 && reach > 0)
      return irregular == 0 ? std::string()
                            : std::to_string(irregular) + " irregular vertices lie in the region of " + wish.name;
    if(wish.guide->index == 0)
      is_there = index_there == 0;
    return is_there ? std::string()
                    : "there is no vertex of index " + std::to_string(wish.guide->index) + " at " + wish.name;
  }

  std::string of_connection(const Placed_connection& c) const
  {
    const Mesh::Vertex_index from = nearest_vertex(c.from.point), to = nearest_vertex(c.to.point);
    for(Mesh::Halfedge_index h : m_quads.halfedges_around_target(m_quads.halfedge(from)))
      if(leads_straight_to(m_quads.opposite(h), to))
        return std::string();
    return "no straight chain of quad edges joins the ends of " + c.name;
  }

  std::string of_sum(const Component_wishes::Index_wish& wish) const
  {
    long long sum = 0;
    for(Mesh::Vertex_index v : part_around(wish.place, wish.guide->radius))
      sum += (m_quads.is_border(v) ? 3 : 4) - static_cast<long long>(m_quads.degree(v));
    return sum == wish.guide->index ? std::string()
                                    : "the indices in the region of " + wish.name + " sum up to " +
                                        std::to_string(sum) + " instead of " + std::to_string(wish.guide->index);
  }

private:
  typedef AABB_halfedge_graph_segment_primitive<Mesh> Edge_primitive;
  typedef AABB_tree<Aabb_traits<Quadrangulation_kernel, Edge_primitive>> Edge_tree;

  Mesh::Vertex_index nearest_vertex(const Point_3& p) const
  {
    Mesh::Vertex_index nearest = *m_quads.vertices().begin();
    for(Mesh::Vertex_index v : m_quads.vertices())
      if(squared_distance(m_quads.point(v), p) < squared_distance(m_quads.point(nearest), p))
        nearest = v;
    return nearest;
  }

  // Whether one comes to a vertex from a halfedge on, with as many quads on the left as on the right at every vertex.
  bool leads_straight_to(Mesh::Halfedge_index h, Mesh::Vertex_index end) const
  {
    for(std::size_t steps = 0; steps < m_quads.number_of_edges(); ++steps)
    {
      const Mesh::Vertex_index v = m_quads.target(h);
      if(v == end)
        return true;
      if(m_quads.is_border(v) || m_quads.degree(v) != 4)
        return false;
      h = m_quads.next(m_quads.opposite(m_quads.next(h)));
    }
    return false;
  }

  // The vertices of the part of the surface around a place that lies within a distance of it.
  std::vector<Mesh::Vertex_index> part_around(const Placed_point& place, double reach) const
  {
    const Mesh::Halfedge_index h = m_quads.halfedge(m_edges.closest_point_and_primitive(place.point).second);
    std::vector<Mesh::Vertex_index> part = { m_quads.source(h), m_quads.target(h) };
    std::set<Mesh::Vertex_index> is_reached(part.begin(), part.end());
    auto is_outside = [&](Mesh::Vertex_index v)
    { return squared_distance(m_quads.point(v), place.point) > reach * reach; };
    part.erase(std::remove_if(part.begin(), part.end(), is_outside), part.end());
    for(std::size_t i = 0; i < part.size(); ++i)
      for(Mesh::Vertex_index w : m_quads.vertices_around_target(m_quads.halfedge(part[i])))
        if(!is_outside(w) && is_reached.insert(w).second)
          part.push_back(w);
    return part;
  }

  double length(Mesh::Halfedge_index h) const { return std::sqrt(vector(h).squared_length()); }
  Vector_3 vector(Mesh::Halfedge_index h) const
  {
    return m_quads.point(m_quads.target(h)) - m_quads.point(m_quads.source(h));
  }

  // Between two lines, in degrees.
  static double angle(const Vector_3& a, const Vector_3& b)
  {
    return std::atan2(std::sqrt(cross_product(a, b).squared_length()), std::abs(a * b)) * 180 / CGAL_PI;
  }

  // Rounded down to a tenth: what is less than asked for is not told as if it were not.
  static std::string percent(double x)
  {
    const long long tenths = static_cast<long long>(std::floor(1000 * x));
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
  }

  // The angle between a direction and the sides of the quad at a point, in degrees, at most 45; -1 if the quad nearby
  // lies on another part of the surface.
  double deviation(const Point_3& p, const Vector_3& along, const Vector_3& normal) const
  {
    const Mesh::Halfedge_index e = m_quads.halfedge(m_edges.closest_point_and_primitive(p).second);
    double best = -1;
    for(Mesh::Halfedge_index h : { e, m_quads.opposite(e) })
    {
      if(m_quads.is_border(h))
        continue;
      const Mesh::Halfedge_index n1 = m_quads.next(h), n2 = m_quads.next(n1), n3 = m_quads.next(n2);
      const Vector_3 u = vector(h) - vector(n2), v = vector(n1) - vector(n3);
      if(cross_product(u, v) * normal < 0)
        continue;
      const double a = angle(u, along), b = angle(v, along);
      const double d = (std::min)((std::min)(a, b), 45.);
      best = best < 0 ? d : (std::min)(best, d);
    }
    return best;
  }

  // Calls a function for parts of a curve, a tenth of the longest edge long at most: with the middle, the direction,
  // the normal and the length.
  template <typename Function>
  void for_each_part(const Placed_curve& curve, const Function& function) const
  {
    for(const Guide_piece& piece : curve.pieces)
    {
      const Vector_3 along = piece.to - piece.from;
      const double l = std::sqrt(along.squared_length());
      const int n = (std::max)(1, static_cast<int>(std::ceil(10 * l / m_reach)));
      for(int i = 0; i < n; ++i)
        function(piece.from + ((i + 0.5) / n) * along, along, piece.normal, l / n);
    }
  }

  const Mesh& m_quads;
  Edge_tree m_edges;
  double m_reach = 0; // the longest edge
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GUIDE_REPORT_H
