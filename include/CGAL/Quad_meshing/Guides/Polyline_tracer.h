// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GUIDES_POLYLINE_TRACER_H
#define CGAL_QUAD_MESHING_GUIDES_POLYLINE_TRACER_H

#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_field.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingGuidesRef

\brief Puts points and polylines onto a triangle mesh.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexPointMap a model of `ReadablePropertyMap` with a 3D point of a \cgal kernel as value type
*/
template <typename TriangleMesh, typename VertexPointMap>
class Polyline_tracer
{
  typedef AABB_face_graph_triangle_primitive<TriangleMesh, VertexPointMap> Primitive;
  typedef Geodesic_distance_field<TriangleMesh> Distance_field;

public:
  typedef typename boost::property_traits<VertexPointMap>::value_type Point_3;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  /// a face and the weights of its corners, as `Polygon_mesh_processing::Face_location`
  typedef std::pair<face_descriptor, std::array<double, 3>> Face_location;

  /// prepares the search for nearest points. The mesh must not change while the tracer is in use.
  Polyline_tracer(const TriangleMesh& tm, VertexPointMap vpm)
    : m_tm(tm), m_vpm(vpm), m_tree(faces(tm).begin(), faces(tm).end(), tm, vpm)
  {
  }

  /// returns the nearest place on the surface.
  Face_location locate(const Point_3& query) const
  {
    const auto found = m_tree.closest_point_and_primitive(query);
    const std::array<Point_3, 3> t = corners(found.second);
    const auto n = cross_product(t[1] - t[0], t[2] - t[0]);
    std::array<double, 3> w = { { 0, 0, 0 } };
    double sum = 0;
    for(int k = 0; k < 3; ++k)
    {
      w[k] = (std::max)(0., cross_product(t[(k + 1) % 3] - found.first, t[(k + 2) % 3] - found.first) * n);
      sum += w[k];
    }
    if(!(sum > 0))
    {
      // a triangle without area: the nearest corner
      const auto nearer = [&](const Point_3& a, const Point_3& b)
      { return squared_distance(a, query) < squared_distance(b, query); };
      w[std::min_element(t.begin(), t.end(), nearer) - t.begin()] = sum = 1;
    }
    for(double& x : w)
      x /= sum;
    return Face_location(found.second, w);
  }

  /// returns the squared distance of a point from the surface.
  double squared_distance_to(const Point_3& query) const { return to_double(m_tree.squared_distance(query)); }

  /// returns the point of a place.
  Point_3 point(const Face_location& l) const
  {
    const std::array<Point_3, 3> t = corners(l.first);
    return barycenter(t[0], l.second[0], t[1], l.second[1], t[2], l.second[2]);
  }

  /// appends the shortest curve on the surface between two places to `curve`: places of which any two consecutive ones
  /// lie in a common face, its edges and corners included. Returns false, and appends nothing, if there is none as they
  /// lie on different components.
  bool join(const Face_location& from, const Face_location& to, std::vector<Face_location>& curve)
  {
    if(from.first == to.first)
    {
      curve.push_back(from);
      curve.push_back(to);
      return true;
    }
    if(!m_field)
      m_field = std::make_unique<Distance_field>(m_tm, parameters::vertex_point_map(m_vpm));
    m_field->clear();
    m_field->add_source(to);
    // first how far it is, then the windows up to there
    std::vector<vertex_descriptor> ends;
    for(vertex_descriptor v : vertices_around_face(halfedge(from.first, m_tm), m_tm))
      ends.push_back(v);
    m_field->propagate(parameters::target_vertices(std::cref(ends)));
    double limit = 0;
    for(vertex_descriptor v : ends)
      limit =
        (std::max)(limit, m_field->distance(v) + std::sqrt(to_double(squared_distance(point(from), get(m_vpm, v)))));
    if(!std::isfinite(limit))
      return false;
    m_field->propagate(parameters::distance_limit(limit));
    return m_field->shortest_path(from, std::back_inserter(curve)) != Distance_field::no_source();
  }

  /// appends the curve on the surface that joins the projections of all points to `curve`, as `join()` does.
  template <typename PointRange>
  bool trace(const PointRange& points, bool is_closed, std::vector<Face_location>& curve)
  {
    std::vector<Face_location> places;
    for(const Point_3& p : points)
      places.push_back(locate(p));
    if(is_closed && places.size() > 1)
      places.push_back(places.front());
    for(std::size_t i = 0; i + 1 < places.size(); ++i)
      if(!join(places[i], places[i + 1], curve))
        return false;
    if(places.size() == 1)
      curve.push_back(places.front());
    return true;
  }

private:
  std::array<Point_3, 3> corners(face_descriptor f) const
  {
    const auto h = halfedge(f, m_tm);
    return { { get(m_vpm, source(h, m_tm)), get(m_vpm, target(h, m_tm)), get(m_vpm, target(next(h, m_tm), m_tm)) } };
  }

  const TriangleMesh& m_tm;
  VertexPointMap m_vpm;
  AABB_tree<internal::Aabb_traits<typename Kernel_traits<Point_3>::Kernel, Primitive>> m_tree;
  std::unique_ptr<Distance_field> m_field; // made when two points are in different faces for the first time
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GUIDES_POLYLINE_TRACER_H
