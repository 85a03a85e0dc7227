// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PARAMETERIZATION_IS_INTEGER_GRID_MAP_H
#define CGAL_QUAD_MESHING_PARAMETERIZATION_IS_INTEGER_GRID_MAP_H

#include <CGAL/Quad_meshing/internal/Grid_automorphism.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief The answer of `is_integer_grid_map()`: which simplices break which condition.

\tparam TriangleMesh a model of `HalfedgeListGraph` and `FaceListGraph`
*/
template <typename TriangleMesh>
struct Integer_grid_map_report
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  /// Edges whose two images no rotation by a multiple of 90 degrees and integer translation maps onto each other.
  std::vector<edge_descriptor> edges_without_transition;
  /// Singular vertices that do not lie on a grid point.
  std::vector<vertex_descriptor> vertices_off_grid;
  /// Faces whose image is folded over or has no area.
  std::vector<face_descriptor> folded_faces;
  /// Edges that had to lie on a grid line and do not.
  std::vector<edge_descriptor> edges_off_grid;
  /// Faces with a coordinate that is not finite.
  std::vector<face_descriptor> faces_not_finite;

  /// Whether all conditions hold.
  bool is_valid() const
  {
    return edges_without_transition.empty() && vertices_off_grid.empty() && folded_faces.empty() &&
           edges_off_grid.empty() && faces_not_finite.empty();
  }

  /// \copydoc is_valid()
  explicit operator bool() const { return is_valid(); }

  /// One sentence.
  std::string message() const
  {
    if(is_valid())
      return "the map is an integer-grid map";
    std::string s;
    auto add = [&s](std::size_t n, const char* what)
    {
      if(n != 0)
        s += (s.empty() ? "" : ", ") + std::to_string(n) + " " + what;
    };
    add(faces_not_finite.size(), "faces with coordinates that are not finite");
    add(folded_faces.size(), "folded or degenerate faces");
    add(edges_without_transition.size(), "edges without a grid automorphism across");
    add(vertices_off_grid.size(), "singular vertices off the grid points");
    add(edges_off_grid.size(), "aligned edges off the grid lines");
    return s;
  }
};

/*!
\ingroup PkgQuadMeshingParameterizationRef

\brief tells, exactly, whether a map is an integer-grid map.

The three conditions are those of the thesis, Chapter 6: the transition across every edge is a rotation by a multiple of
90 degrees and an integer translation; every singular vertex lies on a grid point; every triangle is positively
oriented. Edges in `edge_is_constrained_map`, and border edges unless `align_boundary` is `false`, must moreover lie on
integer grid lines. Nothing is compared with a tolerance.

A vertex inside the surface is singular if the number of grid directions that leave it is not four.

\tparam TriangleMesh a model of `HalfedgeListGraph` and `FaceListGraph`
\tparam HalfedgeUVMap a model of `ReadablePropertyMap` with the halfedges as keys and a two-dimensional point over `double` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param uv the map: for each halfedge that is no border halfedge, the image of its target in the chart of its face
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{align_boundary}
    \cgalParamDescription{whether border edges must lie on grid lines}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that must lie on grid lines}
    \cgalParamType{a model of `ReadablePropertyMap` with value type `bool`}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the report, which converts to `bool`
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Integer_grid_map_report<TriangleMesh>
is_integer_grid_map(const TriangleMesh& tm, HalfedgeUVMap uv, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef Exact_predicates_inexact_constructions_kernel::Point_2 Point_2;

  const bool align_boundary = choose_parameter(get_parameter(np, internal_np::align_boundary), true);
  auto is_constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                         Static_boolean_property_map<edge_descriptor, false>());

  auto image = [&](halfedge_descriptor h)
  {
    const auto& p = get(uv, h);
    return Point_2(to_double(p.x()), to_double(p.y()));
  };
  auto is_integer = [](double a) { return a == std::floor(a); };

  Integer_grid_map_report<TriangleMesh> report;

  for(face_descriptor f : faces(tm))
  {
    const halfedge_descriptor h = halfedge(f, tm);
    const Point_2 a = image(h), b = image(next(h, tm)), c = image(prev(h, tm));
    bool finite = true;
    for(const Point_2& p : { a, b, c })
      finite = finite && std::isfinite(p.x()) && std::isfinite(p.y());
    if(!finite)
      report.faces_not_finite.push_back(f);
    else if(orientation(a, b, c) != LEFT_TURN)
      report.folded_faces.push_back(f);
  }
  if(!report.faces_not_finite.empty())
    return report; // no other question makes sense

  for(edge_descriptor e : edges(tm))
  {
    const halfedge_descriptor h = halfedge(e, tm), o = opposite(h, tm);
    if(!is_border(h, tm) && !is_border(o, tm))
    {
      internal::Grid_automorphism g;
      if(internal::recover_grid_automorphism(image(prev(h, tm)), image(h), image(o), image(prev(o, tm)), g) !=
         internal::Transition_kind::EXACT)
        report.edges_without_transition.push_back(e);
    }
    if(get(is_constrained, e) || (align_boundary && is_border(e, tm)))
    {
      const halfedge_descriptor i = is_border(h, tm) ? o : h;
      if(is_border(i, tm))
        continue;
      const Point_2 a = image(prev(i, tm)), b = image(i);
      if(!(a.x() == b.x() && is_integer(a.x())) && !(a.y() == b.y() && is_integer(a.y())))
        report.edges_off_grid.push_back(e);
    }
  }

  for(vertex_descriptor v : vertices(tm))
  {
    if(halfedge(v, tm) == Graph_traits::null_halfedge() || is_border(v, tm))
      continue;
    // A grid direction d leaves v in the corner between a and b, counted with the side of a, if a x d >= 0 < d x b.
    int directions = 0;
    bool on_grid = true, folded = false;
    for(halfedge_descriptor h : halfedges_around_target(v, tm))
    {
      const Point_2 p = image(h), q = image(next(h, tm)), r = image(prev(h, tm));
      on_grid = on_grid && is_integer(p.x()) && is_integer(p.y());
      folded = folded || orientation(p, q, r) != LEFT_TURN;
      const double ax = q.x() - p.x(), ay = q.y() - p.y(), bx = r.x() - p.x(), by = r.y() - p.y();
      // cross products with (1,0), (0,1), (-1,0), (0,-1); differences of doubles have the right sign
      directions += (-ay >= 0 && by > 0) + (ax >= 0 && -bx > 0) + (ay >= 0 && -by > 0) + (-ax >= 0 && bx > 0);
    }
    if(!folded && directions != 4 && !on_grid)
      report.vertices_off_grid.push_back(v);
  }
  return report;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PARAMETERIZATION_IS_INTEGER_GRID_MAP_H
