// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_QUAD_MESH_TRANSFER_VALUES_H
#define CGAL_QUAD_MESHING_QUAD_MESH_TRANSFER_VALUES_H

#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

template <typename T>
struct Is_std_array : std::false_type
{
};
template <typename T, std::size_t n>
struct Is_std_array<std::array<T, n>> : std::true_type
{
};

// The mean of the values at the corners of a triangle.
template <typename Value>
Value weighted_mean(const std::array<Value, 3>& values, const std::array<double, 3>& weights)
{
  if constexpr(Is_std_array<Value>::value)
  {
    Value result = values[0];
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] = static_cast<typename Value::value_type>(weights[0] * values[0][i] + weights[1] * values[1][i] +
                                                          weights[2] * values[2][i]);
    return result;
  }
  else
    return static_cast<Value>(weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2]);
}

// The triangles below quads.
template <typename TriangleMesh>
class Triangles_below
{
  typedef typename boost::property_map<TriangleMesh, vertex_point_t>::const_type Point_map;
  typedef typename boost::property_traits<Point_map>::value_type Point_3;
  typedef typename Kernel_traits<Point_3>::Kernel Kernel;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef AABB_face_graph_triangle_primitive<TriangleMesh> Primitive;
  typedef AABB_tree<Aabb_traits<Kernel, Primitive>> Tree;

public:
  typedef typename Graph_traits::face_descriptor face_descriptor;

  template <typename FaceRange>
  Triangles_below(const TriangleMesh& tm, const FaceRange& faces)
    : m_tm(tm), m_vpm(get(vertex_point, tm)), m_tree(faces.begin(), faces.end(), tm)
  {
  }

  // That below the center of a face of another mesh. On thin parts, the one on the same side of the surface is meant:
  // it is looked for from a little above the center, as the face cuts off what is bent outwards.
  template <typename QuadMesh>
  face_descriptor below(typename boost::graph_traits<QuadMesh>::face_descriptor f, const QuadMesh& qm) const
  {
    const double lift = 0.1; // of the root of the area of the face
    const auto vpm = get(vertex_point, qm);
    std::vector<Point_3> corners;
    Vector_3 sum(0, 0, 0), area(0, 0, 0);
    for(auto v : vertices_around_face(halfedge(f, qm), qm))
    {
      const auto& p = get(vpm, v);
      corners.push_back(Point_3(p.x(), p.y(), p.z()));
      sum = sum + (corners.back() - ORIGIN);
    }
    const Point_3 center = ORIGIN + sum / static_cast<double>(corners.size());
    for(std::size_t i = 0; i < corners.size(); ++i)
      area = area + cross_product(corners[i] - center, corners[(i + 1) % corners.size()] - center) / 2;
    const double length = std::sqrt(std::sqrt(area.squared_length())); // the root of the area
    return m_tree.closest_point_and_primitive(length > 0 ? center + (lift / length) * area : center).second;
  }

  // The place of a point in the triangle that is nearest to a point `inside` of it: a face, and the weights of its
  // corners from the source of its halfedge on. So a point on a seam is seen from one side.
  std::pair<face_descriptor, std::array<double, 3>> locate(const Point_3& query, const Point_3& inside) const
  {
    const auto found = m_tree.closest_point_and_primitive(inside);
    auto h = halfedge(found.second, m_tm);
    std::array<Point_3, 3> t;
    for(int k = 0; k < 3; ++k, h = next(h, m_tm))
      t[k] = get(m_vpm, source(h, m_tm));
    const Vector_3 n = cross_product(t[1] - t[0], t[2] - t[0]);
    std::array<double, 3> w = { { 1, 0, 0 } };
    if(n * n > 0)
    {
      double total = 0;
      for(int k = 0; k < 3; ++k)
        total += w[k] = (std::max)(0., cross_product(t[(k + 1) % 3] - query, t[(k + 2) % 3] - query) * n / (n * n));
      for(double& x : w)
        x /= total;
    }
    return std::make_pair(found.second, w);
  }

private:
  const TriangleMesh& m_tm;
  const Point_map m_vpm;
  const Tree m_tree;
};

} // namespace internal

/*!
\ingroup PkgQuadMeshingRef

\brief carries values of vertices, such as colors, from a triangle mesh to the vertices of a quad mesh, by the places
where these lie.

Values are linear in triangles. Use `transfer_corner_values()` for what is not continuous, as texture coordinates.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam VertexValueMap a model of `ReadablePropertyMap` with the vertices of `TriangleMesh` as keys; its value type is a
  number, an `std::array` of numbers, or has a sum and a product with a `double`, as vectors have
\tparam QuadMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam FaceLocationMap a model of `ReadablePropertyMap` with the vertices of `QuadMesh` as keys and
  `Polygon_mesh_processing::Face_location<TriangleMesh, double>` as value type
\tparam QuadVertexValueMap a model of `WritablePropertyMap` with the vertices of `QuadMesh` as keys

\param tm the triangle mesh
\param vertex_value the values on it
\param qm the quad mesh
\param location where its vertices lie on `tm`: `face_location_map` of `quadrangulate()`
\param quad_vertex_value receives the values on `qm`
*/
template <typename TriangleMesh, typename VertexValueMap, typename QuadMesh, typename FaceLocationMap,
          typename QuadVertexValueMap>
void transfer_vertex_values(const TriangleMesh& tm, VertexValueMap vertex_value, const QuadMesh& qm,
                            FaceLocationMap location, QuadVertexValueMap quad_vertex_value)
{
  typedef typename boost::property_traits<VertexValueMap>::value_type Value;
  for(auto v : vertices(qm))
  {
    const auto l = get(location, v);
    const auto h = halfedge(l.first, tm);
    const std::array<Value, 3> values = { { get(vertex_value, source(h, tm)), get(vertex_value, target(h, tm)),
                                            get(vertex_value, target(next(h, tm), tm)) } };
    put(quad_vertex_value, v, internal::weighted_mean(values, l.second));
  }
}

/*!
\ingroup PkgQuadMeshingRef

\brief carries values of faces, such as groups and materials, from a triangle mesh to the faces of a quad mesh: each
gets that of the triangle below its center.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with an internal point map
\tparam FaceValueMap a model of `ReadablePropertyMap` with the faces of `TriangleMesh` as keys
\tparam QuadMesh a model of `FaceListGraph` and `HalfedgeListGraph` with an internal point map
\tparam QuadFaceValueMap a model of `WritablePropertyMap` with the faces of `QuadMesh` as keys

\param tm the triangle mesh, with one face at least
\param face_value the values on it
\param qm the quad mesh
\param quad_face_value receives the values on `qm`
*/
template <typename TriangleMesh, typename FaceValueMap, typename QuadMesh, typename QuadFaceValueMap>
void transfer_face_values(const TriangleMesh& tm, FaceValueMap face_value, const QuadMesh& qm,
                          QuadFaceValueMap quad_face_value)
{
  const internal::Triangles_below<TriangleMesh> triangles(tm, faces(tm));
  for(auto f : faces(qm))
    put(quad_face_value, f, get(face_value, triangles.below(f, qm)));
}

/*!
\ingroup PkgQuadMeshingRef

\brief carries values of corners, such as texture coordinates, from a triangle mesh to the corners of a quad mesh.

Seams divide the triangle mesh into charts. A quad belongs to the chart of the triangle below its center, and all of its
corners have values of this chart, each that of the nearest place in it. Where seams are chains of quad edges, the
values are continuous in the same places as those of the triangles.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with an internal point map
\tparam EdgeIsSeamMap a model of `ReadablePropertyMap` with the edges of `TriangleMesh` as keys and `bool` as value type
\tparam CornerValueMap a model of `ReadablePropertyMap` with the halfedges of `TriangleMesh` as keys: the value of the
  corner at the target of the halfedge in its face. The value type is as for `transfer_vertex_values()`.
\tparam QuadMesh a model of `FaceListGraph` and `HalfedgeListGraph` with an internal point map
\tparam QuadCornerValueMap a model of `WritablePropertyMap` with the halfedges of `QuadMesh` as keys

\param tm the triangle mesh, with one face at least
\param edge_is_seam the edges at which the values are not continuous
\param corner_value the values on it
\param qm the quad mesh
\param quad_corner_value receives the values at the targets of the halfedges of faces of `qm`
*/
template <typename TriangleMesh, typename EdgeIsSeamMap, typename CornerValueMap, typename QuadMesh,
          typename QuadCornerValueMap>
void transfer_corner_values(const TriangleMesh& tm, EdgeIsSeamMap edge_is_seam, CornerValueMap corner_value,
                            const QuadMesh& qm, QuadCornerValueMap quad_corner_value)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  typedef typename boost::property_traits<CornerValueMap>::value_type Value;
  typedef internal::Triangles_below<TriangleMesh> Triangles;
  typedef
    typename boost::property_traits<typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type
      Point_3;

  const auto chart = get(CGAL::dynamic_face_property_t<std::size_t>(), tm);
  const std::size_t number_of_charts =
    Polygon_mesh_processing::connected_components(tm, chart, parameters::edge_is_constrained_map(edge_is_seam));
  std::vector<std::vector<face_descriptor>> members(number_of_charts);
  for(face_descriptor f : faces(tm))
    members[get(chart, f)].push_back(f);
  const Triangles all(tm, faces(tm));
  std::vector<std::unique_ptr<Triangles>> charts(number_of_charts);
  const auto vpm = get(vertex_point, qm);
  for(auto f : faces(qm))
  {
    const std::size_t c = get(chart, all.below(f, qm));
    if(!charts[c])
      charts[c] = std::make_unique<Triangles>(tm, members[c]);
    // A seam may have the same chart on both sides: corners are seen from a thousandth of the way to the center.
    const double inwards = 1e-3;
    double x = 0, y = 0, z = 0, corners = 0;
    for(auto h : halfedges_around_face(halfedge(f, qm), qm))
    {
      const auto& p = get(vpm, target(h, qm));
      x += p.x();
      y += p.y();
      z += p.z();
      ++corners;
    }
    const Point_3 center(x / corners, y / corners, z / corners);
    for(auto h : halfedges_around_face(halfedge(f, qm), qm))
    {
      const auto& p = get(vpm, target(h, qm));
      const Point_3 query(p.x(), p.y(), p.z());
      const auto l = charts[c]->locate(query, query + inwards * (center - query));
      const auto first = halfedge(l.first, tm); // its source is corner 0
      const std::array<Value, 3> values = { { get(corner_value, prev(first, tm)), get(corner_value, first),
                                              get(corner_value, next(first, tm)) } };
      put(quad_corner_value, h, internal::weighted_mean(values, l.second));
    }
  }
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_QUAD_MESH_TRANSFER_VALUES_H
