// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_GUIDES_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_GUIDES_H

#include <CGAL/Quad_meshing/Fields/Face_frames.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_stages.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Index_prescriptions.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Placed_guides.h>
#include <CGAL/Quad_meshing/internal/Distance_front.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/number_type_config.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the user has drawn on one component.
struct Component_wishes
{
  struct Index_wish
  {
    const Index_guide* guide;
    std::string name;
    Placed_point place;
  };

  std::vector<const Placed_curve*> strokes;
  std::vector<Index_wish> indices;
  std::vector<const Placed_connection*> connections;
};

// Brings the guides of a component to the triangles that its field is made on.
class Component_guides
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_kernel::Point_3 Point_3;
  typedef Quadrangulation_kernel::Vector_3 Vector_3;

public:
  // `distance`: how far the triangles are from the input at most.
  Component_guides(const Quadrangulation_surface& surface, double distance)
    : m_surface(surface)
    , m_distance(distance)
    , m_tree(faces(surface.mesh).first, faces(surface.mesh).second, surface.mesh)
  {
  }

  // How much more the map counts on a stroke than elsewhere.
  static constexpr double largest_importance = 50;

  std::vector<std::string> unmet; // guides that cannot be met, see `Quadrangulation_result`
  std::string refusal;            // why no mesh can meet all of them, as a sentence; empty: one may

  // Gives the faces that strokes cross their directions, and those nearby softer ones; `importance` is how much faces
  // count for the map. Hard directions that are there are kept.
  void follow_strokes(const std::vector<const Placed_curve*>& strokes, std::vector<std::optional<Vector_3>>& direction,
                      std::vector<double>& weight, std::vector<double>& importance) const
  {
    const Mesh& mesh = m_surface.mesh;
    std::map<Mesh::Face_index, Crossing> crossings = find_crossings(strokes);
    if(crossings.empty())
      return;
    importance.assign(mesh.number_of_faces(), 1.);
    // What is near follows the nearest crossing, and what the surface itself says fades in.
    Distance_front front(static_cast<int>(mesh.number_of_faces()));
    std::vector<Mesh::Face_index> source(mesh.number_of_faces());
    for(const auto& c : crossings)
    {
      front.reach(static_cast<int>(c.first), 0);
      source[c.first] = c.first;
    }
    int i;
    for(double d; front.pop(i, d);)
    {
      const Mesh::Face_index f(static_cast<Mesh::size_type>(i));
      for(Mesh::Face_index g : mesh.faces_around_face(mesh.halfedge(f)))
        if(g != Mesh::null_face())
        {
          const double e = d + std::sqrt(squared_distance(center(f), center(g))) / m_surface.length[g];
          if(e < fading_radius && front.reach(static_cast<int>(g), e))
            source[g] = source[f];
        }
      if(std::isinf(weight[f]))
        continue;
      weight[f] *= d / fading_radius;
      const Crossing& c = crossings[source[f]];
      const double part = 1 - d / band_radius;
      const std::optional<Vector_3> along = c.vector();
      if(part <= 0 || !along)
        continue;
      importance[f] = 1 + (largest_importance - 1) * part;
      direction[f] = along;
      weight[f] = d > 0 ? part * c.soft_weight() * area(f) / (m_surface.length[f] * m_surface.length[f])
                        : c.weight_in(m_surface.length[f]);
    }
  }

  // The edges at the ends of connections: the map follows them, but not the field. So the index of the vertex at the
  // end can be prescribed, as that of one without features. Empty if there are none.
  std::vector<char> loose_edges(const std::vector<const Placed_connection*>& connections) const
  {
    const Mesh& mesh = m_surface.mesh;
    std::vector<char> is_loose;
    if(connections.empty())
      return is_loose;
    is_loose.assign(mesh.number_of_edges(), 0);
    std::vector<int> degree(mesh.number_of_vertices(), 0); // edges of features
    for(Mesh::Edge_index e : mesh.edges())
      if(m_surface.is_feature[e] || mesh.is_border(e))
        for(int k = 0; k < 2; ++k)
          ++degree[mesh.vertex(e, k)];
    for(const Placed_connection* c : connections)
      for(const Placed_point* end : { &c->from, &c->to })
        for(Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(end_of_feature(*end, degree))))
          if(degree[mesh.target(h)] == 1 && m_surface.is_kept[mesh.edge(h)])
            is_loose[mesh.edge(h)] = 1;
    return is_loose;
  }

  // The indices that vertices must have. `is_loose`: per edge, see above. `index_of_free_field(prescribed)` gives the
  // indices of the field that has the prescribed ones, and no others that are wanted; it is asked if there are sums.
  // Sets `refusal` if the wishes cannot be met by any field.
  template <typename FreeField>
  std::vector<std::optional<int>> prescribe(const std::vector<Component_wishes::Index_wish>& wishes,
                                            const std::vector<char>& is_loose, const FreeField& index_of_free_field)
  {
    Index_prescriptions prescriptions(m_surface, is_loose);
    for(const Component_wishes::Index_wish& w : wishes)
      if(!w.guide->is_sum && std::isfinite(w.guide->radius))
        prescriptions.add(w.guide->index, w.name, vertices_of(w, prescriptions));
    for(const Component_wishes::Index_wish& w : wishes)
      if(!w.guide->is_sum && std::isinf(w.guide->radius))
        prescriptions.forbid_others(w.name);
    std::vector<int> index;
    for(const Component_wishes::Index_wish& w : wishes)
      if(w.guide->is_sum)
      {
        if(index.empty())
          index = index_of_free_field(prescriptions.index());
        if(index.empty()) // there is none; the search for the final one says why
          break;
        // Irregular vertices that are just outside must not slip in when the quads are smoothed.
        const double guarded = w.guide->radius + m_surface.length[face_at(w.place.point, w.place.normal)];
        prescriptions.add_sum(w.guide->index, w.name, within(w, w.guide->radius), within(w, guarded), index);
      }
    prescriptions.check_total();
    unmet.insert(unmet.end(), prescriptions.unmet.begin(), prescriptions.unmet.end());
    refusal = prescriptions.refusal;
    return prescriptions.index();
  }

private:
  // In lengths of quads: how far from a stroke faces follow it, and from where on they follow the surface as they would
  // without it. One row of quads on each side alone would be bent over by its neighbors.
  static constexpr double band_radius = 2, fading_radius = 5;

  // What strokes say in a face.
  struct Crossing
  {
    std::complex<double> direction = 0; // sum of lengths times fourth powers of directions in the plane of the face
    Vector_3 x, y;                      // the axes of that plane
    double length = 0, weight = 0;      // sums, the second one times weights
    bool is_hard = false;

    // None where strokes contradict each other.
    std::optional<Vector_3> vector() const
    {
      if(!(std::abs(direction) > 0))
        return std::nullopt;
      const double angle = std::arg(direction) / 4;
      return std::cos(angle) * x + std::sin(angle) * y;
    }

    // Strokes count as far as they agree; hard ones are soft in the faces nearby.
    double soft_weight() const
    {
      const double agreement = length > 0 ? std::abs(direction) / length : 0;
      return agreement * (is_hard ? Guide_stroke().weight : weight / length);
    }

    // A stroke that leaves a face after this part of the length of quads has its full weight there.
    double weight_in(double quad) const
    {
      const double full_part = 0.25;
      return is_hard ? std::numeric_limits<double>::infinity()
                     : soft_weight() * (std::min)(1., length / (full_part * quad));
    }
  };

  std::map<Mesh::Face_index, Crossing> find_crossings(const std::vector<const Placed_curve*>& strokes) const
  {
    // Along a stroke, in parts of the length of quads: short against the triangles.
    const double step = 0.05;
    std::map<Mesh::Face_index, Crossing> crossings;
    for(const Placed_curve* stroke : strokes)
      for(const Guide_piece& piece : stroke->pieces)
      {
        const Vector_3 along = piece.to - piece.from;
        const double length = std::sqrt(along.squared_length());
        const double quad = m_surface.length[face_at(midpoint(piece.from, piece.to), piece.normal)];
        const int n = (std::max)(1, static_cast<int>(std::ceil(length / (step * quad))));
        for(int i = 0; i < n; ++i)
        {
          const Mesh::Face_index f = face_at(piece.from + ((i + 0.5) / n) * along, piece.normal);
          Vector_3 x, y;
          if(!triangle_axes(corners(f), x, y))
            continue;
          const std::complex<double> d(along * x, along * y);
          if(!(std::abs(d) > 0))
            continue;
          Crossing& c = crossings[f];
          const double part = length / n;
          c.x = x;
          c.y = y;
          c.direction += part * std::pow(d / std::abs(d), 4);
          c.length += part;
          if(std::isinf(stroke->weight))
            c.is_hard = true;
          else
            c.weight += part * stroke->weight;
        }
      }
    return crossings;
  }

  Point_3 center(Mesh::Face_index f) const
  {
    const std::array<Point_3, 3> t = corners(f);
    return centroid(t[0], t[1], t[2]);
  }

  double area(Mesh::Face_index f) const
  {
    const std::array<Point_3, 3> t = corners(f);
    return std::sqrt(cross_product(t[1] - t[0], t[2] - t[0]).squared_length()) / 2;
  }

  typedef AABB_face_graph_triangle_primitive<Mesh> Primitive;
  typedef AABB_tree<Aabb_traits<Quadrangulation_kernel, Primitive>> Tree;

  // The face near a point of the input. On thin parts, the one on the same side of the surface is looked for: from as
  // far above the point as the triangles may be.
  Mesh::Face_index face_at(const Point_3& p, const Vector_3& normal) const
  {
    return m_tree.closest_point_and_primitive(p + m_distance * normal).second;
  }

  std::array<Point_3, 3> corners(Mesh::Face_index f) const
  {
    const Mesh& m = m_surface.mesh;
    const Mesh::Halfedge_index h = m.halfedge(f);
    return { { m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))) } };
  }

  // The vertex with features that is nearest to a place; it is as near as the working mesh is to the input.
  Mesh::Vertex_index end_of_feature(const Placed_point& place, const std::vector<int>& degree) const
  {
    const Mesh& mesh = m_surface.mesh;
    Mesh::Vertex_index nearest = *mesh.vertices().begin();
    double distance = std::numeric_limits<double>::infinity();
    for(Mesh::Vertex_index v : mesh.vertices())
      if(degree[v] > 0 && squared_distance(mesh.point(v), place.point) < distance)
      {
        nearest = v;
        distance = squared_distance(mesh.point(v), place.point);
      }
    return nearest;
  }

  // The vertices of the part of the surface around a place that lies within a distance of it, in order.
  std::vector<Mesh::Vertex_index> within(const Component_wishes::Index_wish& w, double reach) const
  {
    const Mesh& mesh = m_surface.mesh;
    const Point_3& p = w.place.point;
    const Mesh::Face_index first = face_at(p, w.place.normal);
    std::vector<Mesh::Face_index> queue(1, first);
    std::vector<char> is_reached(mesh.number_of_faces(), 0);
    is_reached[first] = 1;
    std::vector<Mesh::Vertex_index> result;
    for(std::size_t i = 0; i < queue.size(); ++i)
      for(Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(queue[i])))
      {
        const Mesh::Vertex_index v = mesh.target(h);
        if(squared_distance(mesh.point(v), p) > reach * reach)
          continue;
        result.push_back(v);
        for(Mesh::Face_index g : mesh.faces_around_target(h))
          if(g != Mesh::null_face() && !is_reached[g])
          {
            is_reached[g] = 1;
            queue.push_back(g);
          }
      }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Those within the radius of a wish; if there are none, the nearest vertex that is on no feature, among those near
  // the face.
  std::vector<Mesh::Vertex_index> vertices_of(const Component_wishes::Index_wish& w,
                                              const Index_prescriptions& prescriptions) const
  {
    const Mesh& mesh = m_surface.mesh;
    const Point_3& p = w.place.point;
    std::vector<Mesh::Vertex_index> result = within(w, w.guide->radius);
    if(!result.empty())
      return result;
    for(Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(face_at(p, w.place.normal))))
      for(Mesh::Face_index g : mesh.faces_around_target(h))
        if(g != Mesh::null_face())
          for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(g)))
            result.push_back(v);
    const auto is_nearer = [&](Mesh::Vertex_index a, Mesh::Vertex_index b)
    {
      if(prescriptions.is_on_feature(a) != prescriptions.is_on_feature(b))
        return prescriptions.is_on_feature(b);
      return squared_distance(mesh.point(a), p) < squared_distance(mesh.point(b), p);
    };
    return { *std::min_element(result.begin(), result.end(), is_nearer) };
  }

  const Quadrangulation_surface& m_surface;
  const double m_distance;
  const Tree m_tree;
};

// The feature edges of the user, to be found again among those of other triangles.
class Kept_features
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_kernel::Segment_3 Segment_3;

public:
  explicit Kept_features(const Quadrangulation_surface& surface)
  {
    const Mesh& m = surface.mesh;
    for(Mesh::Edge_index e : m.edges())
      if(surface.is_kept[e])
        m_segments.push_back(Segment_3(m.point(m.vertex(e, 0)), m.point(m.vertex(e, 1))));
  }

  bool empty() const { return m_segments.empty(); }

  // Marks the feature edges along them: vertices of curves stay on these, and edges between them leave the curve by so
  // much at most.
  void mark(Quadrangulation_surface& surface, double largest_distance) const
  {
    const Mesh& m = surface.mesh;
    for(Mesh::Edge_index e : m.edges())
      surface.is_kept[e] = false;
    if(empty())
      return;
    const Tree tree(m_segments.cbegin(), m_segments.cend());
    auto is_near = [&](const Quadrangulation_kernel::Point_3& p, double d)
    { return tree.squared_distance(p) <= d * d; };
    for(Mesh::Edge_index e : m.edges())
    {
      const auto &p = m.point(m.vertex(e, 0)), &q = m.point(m.vertex(e, 1));
      surface.is_kept[e] = surface.is_feature[e] && is_near(p, largest_distance) && is_near(q, largest_distance) &&
                           is_near(midpoint(p, q), largest_distance);
    }
  }

private:
  typedef AABB_tree<Aabb_traits<Quadrangulation_kernel,
                                Aabb_segment_primitive<Quadrangulation_kernel, std::vector<Segment_3>::const_iterator>>>
    Tree;

  std::vector<Segment_3> m_segments;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_GUIDES_H
