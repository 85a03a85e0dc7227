// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_GEODESIC_DISTANCE_FIELD_H
#define CGAL_QUAD_MESHING_GEODESICS_GEODESIC_DISTANCE_FIELD_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_result.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_access.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_queries.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Field_sources.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Unfolded_mesh.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_propagation.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Real_timer.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingGeodesicsRef
 *
 * \brief computes the geodesic distance from vertices, points and curves on a triangle mesh, exactly in the
 * sense of the geometry: up to rounding, the distance is the length of the shortest path on the surface.
 *
 * Sources are added one by one, each with an offset that its distances start with; the distance of a point is the
 * smallest one over all sources. Then `propagate()` computes the field, and the queries evaluate it. Sources may
 * be added again afterwards; that drops the field, and `propagate()` starts from scratch.
 *
 * The mesh may have a border, several components and vertices without faces. What no source can reach has the distance
 * infinity. Degenerate faces are allowed. Vertices must be manifold, as they are in every valid halfedge data structure
 * made from a soup by `Polygon_mesh_processing::polygon_soup_to_polygon_mesh()`. The mesh must not change while the
 * object is used.
 *
 * The algorithm is that of Mitchell, Mount and Papadimitriou (1987) with the linear windows of Bommes and
 * Kobbelt (2007): windows are parts of edges in which the distance is one square root or one linear function. They are
 * kept on some edges, between groups of up to 60 faces. Queries make those of a group that they need from the ones
 * around it, once, and keep them: the first query in a group takes some 0.2 milliseconds. All queries are `const`, and
 * any number of threads may ask at a time.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam FT the number type of the windows: `double`, or a binary floating point type of more digits such as
 *         `boost::multiprecision::cpp_bin_float_50`, with as much smaller rounding errors, or an exact type with square
 * roots such as `CORE::Expr`, for meshes of a few triangles
 *
 * \sa `refine_distance_field()`
 */
template <typename TriangleMesh, typename FT = double>
class Geodesic_distance_field
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef internal::Unfolded_mesh<FT> Mesh;
  typedef internal::Window_propagation<FT> Propagation;
  typedef internal::Field_sources<FT> Sources;
  typedef internal::Field_queries<FT> Queries;
  typedef internal::Surface_point<FT> Surface_point;
  typedef internal::Arrival<FT> Arrival;

public:
  /// the vertex descriptor of the mesh
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  /// the halfedge descriptor of the mesh
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  /// the edge descriptor of the mesh
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  /// the face descriptor of the mesh
  typedef typename Graph_traits::face_descriptor face_descriptor;

  /// a point on the mesh: the same type as `Polygon_mesh_processing::Face_location<TriangleMesh, double>`. The weights
  /// belong to the source and the target of `halfedge(f, tm)` and to the target of the next halfedge.
  typedef std::pair<face_descriptor, std::array<double, 3>> Face_location;

  /// a vector in space
  typedef Simple_cartesian<double>::Vector_3 Vector_3;

  /// what `add_source()` and its kin return when nothing was added
  static std::size_t no_source() { return (std::numeric_limits<std::size_t>::max)(); }

  /*!
   * a part of an edge on which the distance is one function: with `t` the distance from the target of
   * `opposite(from, tm)`, that is, from the source of `from`, it is \f$ \sigma + \sqrt{(t-x)^2 + y^2} \f$, or
   * \f$ \sigma + x t\f$ if the window is linear.
   */
  struct Window
  {
    /// the halfedge along which `t` is measured
    halfedge_descriptor from;
    /// where the window begins
    FT begin;
    /// where the window ends
    FT end;
    /// whether the distance is a linear function
    bool is_linear;
    /// the coefficients
    FT x, y, sigma;
    /// whether the shortest paths arrive through the face of `from` (else of its opposite)
    bool arrives_through_face;
    /// the nearest source
    std::size_t source;

    /// returns the distance at `t`.
    FT distance(const FT& t) const
    {
      return is_linear ? FT(sigma + x * t) : FT(sigma + internal::square_root((t - x) * (t - x) + y * y));
    }
  };

  /*!
   * \brief reads the geometry of a mesh.
   *
   * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{vertex_point_map}
   *     \cgalParamDescription{a property map associating points to the vertices of `tm`}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *       `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
   *                    as key type and `%Point_3` as value type}
   *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_index_map}
   *     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index between `0` and
   *       `num_vertices(tm) - 1`}
   *     \cgalParamType{a class model of `ReadablePropertyMap`}
   *     \cgalParamDefault{an automatically indexed internal map}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{face_index_map}
   *     \cgalParamDescription{a property map associating to each face of `tm` a unique index between `0` and
   *       `num_faces(tm) - 1`}
   *     \cgalParamType{a class model of `ReadablePropertyMap`}
   *     \cgalParamDefault{an automatically indexed internal map}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Geodesic_distance_field(const TriangleMesh& tm, const NamedParameters& np = parameters::default_values())
    : m_tm(tm), m_mesh(m_field_mesh.unfolded())
  {
    m_status = m_field_mesh.read(tm, np);
  }

  Geodesic_distance_field(const Geodesic_distance_field&) = delete;
  Geodesic_distance_field& operator=(const Geodesic_distance_field&) = delete;

  /// \name Sources
  /// Each function returns the number of the source, counted from 0. Nothing is added, and `no_source()` is returned,
  /// if the mesh cannot be used or the source is empty.
  ///@{

  /// adds a vertex.
  std::size_t add_source(vertex_descriptor v, double offset = 0)
  {
    if(m_status != Geodesic_distance_status::SUCCESS)
      return no_source();
    m_sources.add_point(m_mesh, vertex_point(index(v)), FT(offset), m_number_of_sources);
    return added();
  }

  /// adds a point on the surface.
  std::size_t add_source(const Face_location& location, double offset = 0)
  {
    if(m_status != Geodesic_distance_status::SUCCESS)
      return no_source();
    m_sources.add_point(m_mesh, point(location), FT(offset), m_number_of_sources);
    return added();
  }

  /// adds a polyline on the surface, given by a range of `Face_location`. Any two consecutive points must lie in a
  /// common face (on its edges and corners included), which need not be the one of their locations; a closed curve
  /// repeats its first point at the end. Nothing is added if two consecutive points have no face in common.
  template <typename FaceLocationRange>
  std::size_t add_polyline_source(const FaceLocationRange& locations, double offset = 0)
  {
    if(m_status != Geodesic_distance_status::SUCCESS || locations.begin() == locations.end())
      return no_source();
    std::vector<Surface_point> points;
    for(const auto& location : locations)
      points.push_back(point(location));
    Sources sources = m_sources;
    if(!sources.add_polyline(m_mesh, points, FT(offset), m_number_of_sources))
      return no_source();
    std::swap(m_sources, sources);
    return added();
  }

  /// adds all edges of a range as one source.
  template <typename EdgeRange>
  std::size_t add_edges_source(const EdgeRange& edge_range, double offset = 0)
  {
    if(m_status != Geodesic_distance_status::SUCCESS || edge_range.begin() == edge_range.end())
      return no_source();
    std::vector<int> halfedges;
    for(edge_descriptor e : edge_range)
    {
      halfedge_descriptor h = halfedge(e, m_tm);
      if(is_border(h, m_tm))
        h = opposite(h, m_tm);
      if(!is_border(h, m_tm))
        halfedges.push_back(m_field_mesh.halfedge_index(h));
    }
    m_sources.add_edges(m_mesh, halfedges, FT(offset), m_number_of_sources);
    return added();
  }

  /// adds the whole border as one source.
  std::size_t add_border_source(double offset = 0)
  {
    std::vector<edge_descriptor> border;
    for(edge_descriptor e : edges(m_tm))
      if(is_border(e, m_tm))
        border.push_back(e);
    return add_edges_source(border, offset);
  }

  /// removes all sources and the field.
  void clear()
  {
    m_sources.clear();
    m_number_of_sources = 0;
    m_propagation.reset();
  }

  /// returns the number of sources.
  std::size_t number_of_sources() const { return m_number_of_sources; }

  ///@}

  /*!
   * \brief computes the field of all sources added so far.
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{distance_limit}
   *     \cgalParamDescription{distances up to this one are computed, larger ones may be missing or too large}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{infinity}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{target_vertices}
   *     \cgalParamDescription{the computation ends when the distances of these vertices are known}
   *     \cgalParamType{a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, by `std::cref`}
   *     \cgalParamDefault{none: all vertices}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{relative_distance_error}
   *     \cgalParamDescription{every distance may differ from the true one by this part of it, which saves windows}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`0`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{keep_windows}
   *     \cgalParamDescription{if `false`, windows are dropped when the front has passed them. Then only distances at
   *       vertices can be asked for,
   *                           and the memory needed is that of the front.}
   *     \cgalParamType{`bool`}
   *     \cgalParamDefault{`true`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{visitor}
   *     \cgalParamDescription{learns of the progress, by the part of vertices that are reached, and may stop the
   *       computation}
   *     \cgalParamType{a type with the members of `Default_visitor`, by `std::ref`}
   *     \cgalParamDefault{`Default_visitor`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   */
  template <typename NamedParameters = parameters::Default_named_parameters>
  Geodesic_distance_result propagate(const NamedParameters& np = parameters::default_values())
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    using parameters::get_parameter_reference;

    typedef std::vector<vertex_descriptor> No_targets;
    Default_visitor default_visitor;
    const No_targets no_targets;
    auto& visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
    const auto& targets = choose_parameter(get_parameter_reference(np, internal_np::target_vertices), no_targets);
    const double limit = choose_parameter(get_parameter(np, internal_np::distance_limit), infinity());
    const double error = choose_parameter(get_parameter(np, internal_np::relative_distance_error), 0.);
    m_has_windows = choose_parameter(get_parameter(np, internal_np::keep_windows), true);

    Real_timer timer;
    timer.start();
    Geodesic_distance_result result;
    result.status = m_status != Geodesic_distance_status::SUCCESS ? m_status
                    : m_sources.elements().empty()                ? Geodesic_distance_status::NO_SOURCE
                                                                  : m_status;
    m_propagation.reset();
    if(result)
    {
      std::vector<int> target_indices;
      for(vertex_descriptor v : targets)
        target_indices.push_back(index(v));

      visitor.on_stage_begin("geodesic distances");
      m_sources.sort();
      m_propagation.reset(new Propagation(m_mesh, m_sources, error, m_has_windows));
      m_propagation->run(
        [&](double front)
        {
          visitor.progress(m_mesh.number_of_vertices() == 0
                             ? 1.
                             : double(m_propagation->number_of_passed_vertices()) / m_mesh.number_of_vertices());
          if(!visitor.go_further())
            result.status = Geodesic_distance_status::STOPPED;
          else if(front > limit || (!target_indices.empty() && all_nearer(target_indices, front)))
            result.status = Geodesic_distance_status::LIMIT_REACHED;
          return result.status == Geodesic_distance_status::SUCCESS;
        });
      visitor.on_stage_end("geodesic distances");
    }
    result.number_of_unreached_vertices = vertices(m_tm).size();
    if(m_propagation)
      m_propagation->count(result);
    result.message = get_message(result.status);
    result.seconds = timer.time();
    return result;
  }

  /// \name Queries
  /// All of them may be called after `propagate()`. Those for other places than vertices, and all paths, need the
  /// windows to be kept.
  ///@{

  /// returns the distance of a vertex, infinity if no source reaches it.
  double distance(vertex_descriptor v) const
  {
    return is_reached(v) ? internal::as_double(m_propagation->label(index(v)).distance) : infinity();
  }

  /// returns whether a vertex has a distance.
  bool is_reached(vertex_descriptor v) const { return m_propagation && m_propagation->is_reached(index(v)); }

  /// returns the distance of a vertex in the number type of the windows. \pre `is_reached(v)`
  FT distance_value(vertex_descriptor v) const
  {
    CGAL_precondition(is_reached(v));
    return m_propagation->label(index(v)).distance;
  }

  /// returns the distance of a point, infinity if no source reaches it.
  double distance(const Face_location& location) const
  {
    const Arrival a = arrival(location);
    return a.kind == Arrival::NOWHERE ? infinity() : internal::as_double(a.distance);
  }

  /// returns the number of the source that is nearest to a vertex, `no_source()` if none reaches it.
  std::size_t nearest_source(vertex_descriptor v) const
  {
    return is_reached(v) ? source_of_origin(m_propagation->label(index(v)).origin) : no_source();
  }

  /// returns the number of the source that is nearest to a point, `no_source()` if none reaches it.
  std::size_t nearest_source(const Face_location& location) const
  {
    const Arrival a = arrival(location);
    return a.kind == Arrival::NOWHERE ? no_source() : source_of_origin(a.origin);
  }

  /// returns the direction in which the distance grows, a unit vector in the plane of the face of the location; the
  /// zero vector if there is none, on a source and where no source reaches.
  Vector_3 gradient(const Face_location& location) const
  {
    const Arrival a = arrival(location);
    const int f = m_field_mesh.face_index(location.first);
    const auto p = place(f, point(location));
    return a.kind == Arrival::NOWHERE ? Vector_3(0, 0, 0)
                                      : queries().direction(f, FT(p.first - a.x), FT(p.second - a.y));
  }

  /// writes a shortest path from a point to its nearest source as a polyline of `Face_location`, beginning with the
  /// point and ending on the source; consecutive ones lie in a common face. Returns the number of the source, or
  /// `no_source()` with nothing written.
  template <typename OutputIterator>
  std::size_t shortest_path(const Face_location& location, OutputIterator out) const
  {
    if(!m_propagation || !m_has_windows)
      return no_source();
    const int f = m_field_mesh.face_index(location.first);
    const auto p = place(f, point(location));
    std::vector<typename Queries::Step> steps;
    const int element = queries().trace(f, p.first, p.second, steps);
    if(element < 0)
      return no_source();
    for(const typename Queries::Step& s : steps)
      *out++ = Face_location(m_field_mesh.face_of_index(s.face), queries().barycentric(s.face, s.x, s.y));
    return m_sources.elements()[element].source;
  }

  /// writes a shortest path from a vertex to its nearest source.
  template <typename OutputIterator>
  std::size_t shortest_path(vertex_descriptor v, OutputIterator out) const
  {
    const int h = is_reached(v) ? m_mesh.halfedge_of_vertex[index(v)] : -1;
    if(h == -1)
      return no_source();
    Face_location location(m_field_mesh.face_of_index(h / 3), { { 0, 0, 0 } });
    location.second[h % 3] = 1;
    return shortest_path(location, out);
  }

  /// returns the number of windows on all edges, 0 if they are not kept. Those between faces of a group are made to be
  /// counted, which takes a part of the time of `propagate()` but no memory.
  std::size_t number_of_windows() const
  {
    return m_propagation && m_has_windows ? m_propagation->number_of_windows() : 0;
  }

  /// writes the windows of an edge in their order along `halfedge(e, tm)`.
  template <typename OutputIterator>
  OutputIterator windows(edge_descriptor e, OutputIterator out) const
  {
    halfedge_descriptor h = halfedge(e, m_tm);
    if(is_border(h, m_tm))
      h = opposite(h, m_tm);
    if(!m_propagation || !m_has_windows || is_border(h, m_tm))
      return out;
    const int i = m_mesh.halfedge_of_edge[m_mesh.edge_of[m_field_mesh.halfedge_index(h)]];
    const halfedge_descriptor from = i == m_field_mesh.halfedge_index(h) ? h : opposite(h, m_tm);
    for(const internal::Window<FT>& w : m_propagation->windows(m_mesh.edge_of[i]))
      *out++ = Window{ from, w.b0, w.b1, w.linear, w.x, w.y, w.sigma, w.from_left, source_of_origin(w.origin) };
    return out;
  }

  ///@}

private:
  friend struct internal::Field_access;

  static double infinity() { return std::numeric_limits<double>::infinity(); }

  // Counts a source. What was computed without it is no field of all sources.
  std::size_t added()
  {
    m_propagation.reset();
    return m_number_of_sources++;
  }

  int index(vertex_descriptor v) const { return m_field_mesh.vertex_index(v); }

  static Surface_point vertex_point(int v) { return Sources::vertex_point(v); }

  template <typename Location>
  Surface_point point(const Location& location) const
  {
    return internal::surface_point(m_mesh, m_field_mesh.face_index(location.first),
                                   { { CGAL::to_double(location.second[0]), CGAL::to_double(location.second[1]),
                                       CGAL::to_double(location.second[2]) } });
  }

  std::pair<FT, FT> place(int f, const Surface_point& p) const { return internal::place_in_face(m_mesh, f, p); }

  Queries queries() const { return Queries(m_mesh, *m_propagation, m_sources); }

  Arrival arrival(const Face_location& location) const
  {
    if(!m_propagation || !m_has_windows)
      return Arrival{ Arrival::NOWHERE, FT(0), -1, FT(0), FT(0), FT(0), 0 };
    const int f = m_field_mesh.face_index(location.first);
    const auto p = place(f, point(location));
    return queries().arrival(f, p.first, p.second);
  }

  std::size_t source_of_origin(int origin) const
  {
    return m_sources.elements()[queries().element_of_origin(origin)].source;
  }

  bool all_nearer(const std::vector<int>& targets, double front) const
  {
    return std::all_of(
      targets.begin(), targets.end(),
      [&](int v)
      { return m_propagation->is_reached(v) && internal::as_double(m_propagation->label(v).distance) < front; });
  }

  const TriangleMesh& m_tm;
  internal::Field_mesh<TriangleMesh, FT> m_field_mesh;
  const Mesh& m_mesh; // its unfolded form
  Geodesic_distance_status m_status = Geodesic_distance_status::SUCCESS;
  Sources m_sources;
  std::size_t m_number_of_sources = 0;
  std::unique_ptr<Propagation> m_propagation;
  bool m_has_windows = true;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_GEODESIC_DISTANCE_FIELD_H
