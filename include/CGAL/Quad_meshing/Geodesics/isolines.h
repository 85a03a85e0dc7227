// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_ISOLINES_H
#define CGAL_QUAD_MESHING_GEODESICS_ISOLINES_H

#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

// Follows the isolines of one value from face to face. A vertex with the value itself counts as above it. So an isoline
// enters a face through a halfedge on which the function falls, and leaves it through one on which it rises.
template <typename TriangleMesh, typename VertexPointMap, typename FaceIndexMap, typename VertexDistanceMap>
class Distance_isoline_tracer
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;
  typedef std::vector<Point> Polyline;

public:
  Distance_isoline_tracer(const TriangleMesh& tm, VertexPointMap vpm, FaceIndexMap fim, VertexDistanceMap distances,
                          double value)
    : m_tm(tm), m_vpm(vpm), m_fim(fim), m_distances(distances), m_value(value), m_is_visited(faces(tm).size(), false)
  {
  }

  template <typename OutputIterator>
  OutputIterator operator()(OutputIterator out)
  {
    for(bool from_ends : { true, false })
      for(face_descriptor f : faces(m_tm))
      {
        if(m_is_visited[get(m_fim, f)] || !is_crossed(f))
          continue;
        const halfedge_descriptor h = entrance(f), o = opposite(h, m_tm);
        const bool is_end = is_border(o, m_tm) || !is_crossed(face(o, m_tm));
        if(!from_ends || is_end)
          *out++ = follow(h);
      }
    return out;
  }

private:
  double distance(vertex_descriptor v) const { return to_double(get(m_distances, v)); }
  bool is_above(vertex_descriptor v) const { return distance(v) >= m_value; }
  bool rises(halfedge_descriptor h) const { return !is_above(source(h, m_tm)) && is_above(target(h, m_tm)); }

  bool is_crossed(face_descriptor f) const
  {
    int above = 0;
    for(vertex_descriptor v : vertices_around_face(halfedge(f, m_tm), m_tm))
    {
      if(!std::isfinite(distance(v)))
        return false;
      above += is_above(v);
    }
    return above == 1 || above == 2;
  }

  halfedge_descriptor entrance(face_descriptor f) const
  {
    halfedge_descriptor h = halfedge(f, m_tm);
    while(!(is_above(source(h, m_tm)) && !is_above(target(h, m_tm))))
      h = next(h, m_tm);
    return h;
  }

  Polyline follow(halfedge_descriptor h)
  {
    Polyline line(1, crossing(h));
    while(!is_border(h, m_tm))
    {
      const face_descriptor f = face(h, m_tm);
      if(m_is_visited[get(m_fim, f)] || !is_crossed(f))
        break;
      m_is_visited[get(m_fim, f)] = true;
      while(!rises(h))
        h = next(h, m_tm);
      line.push_back(crossing(h));
      h = opposite(h, m_tm);
    }
    return line;
  }

  Point crossing(halfedge_descriptor h) const
  {
    // the same point from both sides, so that closed lines are closed
    if(rises(h))
      h = opposite(h, m_tm);
    const double high = distance(source(h, m_tm)), low = distance(target(h, m_tm)), t = (high - m_value) / (high - low);
    const Point &p = get(m_vpm, source(h, m_tm)), &q = get(m_vpm, target(h, m_tm));
    return p + t * (q - p);
  }

  const TriangleMesh& m_tm;
  VertexPointMap m_vpm;
  FaceIndexMap m_fim;
  VertexDistanceMap m_distances;
  double m_value;
  std::vector<bool> m_is_visited;
};

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingGeodesicsRef
 *
 * \brief traces the isolines of one value of a function that is given at the vertices and linear in the faces.
 *
 * The function may be any; for distances, `refine_distance_field()` makes a mesh on which linear interpolation is as
 * good as one wants. Each isoline is a polyline with one point on each edge that it crosses; larger values lie to its
 * left. A closed one ends with its first point, others end on the border or at faces with a vertex of infinite
 * distance, which no isoline crosses. The polylines do not meet each other, whatever the values at the vertices are,
 * except at vertices that have exactly the value.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam VertexDistanceMap a model of `ReadablePropertyMap` with
 * `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value type \tparam
 * PolylineOutputIterator a model of `OutputIterator` that takes `std::vector<Point_3>`, with the value type of the
 * vertex point map
 *
 * \param tm a triangle mesh
 * \param distances the function at the vertices
 * \param value the value of the isolines
 * \param out the output iterator
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *       `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
 *                    as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_index_map}
 *     \cgalParamDescription{a property map associating to each face of `tm` a unique index between `0` and
 *       `num_faces(tm) - 1`}
 *     \cgalParamType{a class model of `ReadablePropertyMap`}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \pre `tm` is a triangle mesh
 */
template <typename TriangleMesh, typename VertexDistanceMap, typename PolylineOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
PolylineOutputIterator trace_isolines(const TriangleMesh& tm, VertexDistanceMap distances, double value,
                                      PolylineOutputIterator out,
                                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  CGAL_precondition(is_triangle_mesh(tm));
  auto vpm =
    choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  auto fim = internal::face_numbers(tm, np);
  internal::Distance_isoline_tracer<TriangleMesh, decltype(vpm), decltype(fim), VertexDistanceMap> trace(
    tm, vpm, fim, distances, value);
  return trace(out);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_ISOLINES_H
