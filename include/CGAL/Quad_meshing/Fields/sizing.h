// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors
#ifndef CGAL_QUAD_MESHING_FIELDS_SIZING_H
#define CGAL_QUAD_MESHING_FIELDS_SIZING_H

#include <CGAL/Quad_meshing/Fields/internal/Shape_operators.h>
#include <CGAL/Quad_meshing/internal/element_numbers.h>
#include <CGAL/Quad_meshing/internal/Indexed_triangle_mesh.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief returns the edge length with which a given number of quads covers a surface.
 *
 * This is the square root of the area per quad, 0 if the mesh has no area.
 *
 * \pre `number_of_quads > 0`
 */
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
double edge_length_for_number_of_quads(const TriangleMesh& tm, double number_of_quads,
                                       const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  CGAL_precondition(number_of_quads > 0);
  const internal::Indexed_triangle_mesh m = internal::make_indexed_triangle_mesh(
    tm, choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tm)),
    internal::vertex_numbers(tm, np), internal::face_numbers(tm, np));
  double area = 0;
  for(int f = 0; f < m.number_of_faces(); ++f)
    area += std::sqrt(cross_product(m.vector(3 * f), m.vector(3 * f + 1)).squared_length()) / 2;
  return std::sqrt(area / number_of_quads);
}

/*!
 * \ingroup PkgQuadMeshingFieldsRef
 *
 * \brief computes target edge lengths that adapt to the curvature.
 *
 * An edge over an arc of radius `R` leaves the surface by `t` if its length is \f$ 2 \sqrt{2 R t - t^2} \f$. Every face gets
 * this length for the stronger principal curvature and the tolerance `t`, within the given bounds. Then lengths are reduced where
 * they grow too fast: along the surface they grow by at most `sizing_gradation` per unit of length.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FaceSizingMap a model of `WritablePropertyMap` with the face descriptor of `TriangleMesh` as key and `double` as value type
 *
 * \param tm the triangle mesh
 * \param tolerance the distance allowed between an edge and the surface
 * \param minimum the smallest edge length
 * \param maximum the largest edge length
 * \param sizing gets the target edge length of every face
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{sizing_gradation}
 *     \cgalParamDescription{the largest slope of the target edge length}
 *     \cgalParamType{`double`, positive}
 *     \cgalParamDefault{0.3}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a 3D point as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \pre `tolerance > 0` and `0 < minimum <= maximum`
 */
template <typename TriangleMesh, typename FaceSizingMap, typename NamedParameters = parameters::Default_named_parameters>
void curvature_sizing(const TriangleMesh& tm, double tolerance, double minimum, double maximum, FaceSizingMap sizing,
                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef std::pair<double, int> Entry;

  CGAL_precondition(tolerance > 0 && minimum > 0 && minimum <= maximum);

  const double gradation = choose_parameter(get_parameter(np, internal_np::sizing_gradation), 0.3);
  const auto fim = internal::face_numbers(tm, np);
  const internal::Indexed_triangle_mesh m = internal::make_indexed_triangle_mesh(
    tm, choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tm)),
    internal::vertex_numbers(tm, np), fim);

  // Curvature is averaged over disks of twice the mean edge length: large enough to level the
  // angles of single edges.
  double edge_length = 0;
  for(int e = 0; e < m.number_of_edges(); ++e)
    edge_length += std::sqrt(m.vector(m.halfedge_of_edge[e]).squared_length());
  const std::vector<double> radii(1, m.number_of_edges() == 0 ? 0. : 2 * edge_length / m.number_of_edges());

  internal::Shape_operators operators(m);
  std::vector<double> length(m.number_of_faces(), maximum);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
  for(int f = 0; f < m.number_of_faces(); ++f)
  {
    internal::Shape_operators::Vector_3 x, y;
    const std::vector<internal::Shape_operator> s = operators(f, radii, x, y);
    const double curvature = s.empty() ? 0. : std::abs(s.front().maximum);
    // A chord cannot leave the arc by more than its radius.
    const double half = curvature * tolerance < 1 ? std::sqrt(2 * tolerance / curvature - tolerance * tolerance) : 0;
    length[f] = curvature > 0 ? (std::min)(maximum, (std::max)(minimum, 2 * half)) : maximum;
    queue.push(Entry(length[f], f));
  }

  // Limits the slope, short lengths first.
  while(!queue.empty())
  {
    const Entry top = queue.top();
    queue.pop();
    const int f = top.second;
    if(top.first > length[f])
      continue;
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      if(m.opposite[h] != -1)
      {
        const int g = m.opposite[h] / 3;
        const double bound = top.first + gradation * std::sqrt((operators.centroid(g) - operators.centroid(f)).squared_length());
        if(bound < length[g])
        {
          length[g] = bound;
          queue.push(Entry(bound, g));
        }
      }
  }
  for(auto f : faces(tm))
    put(sizing, f, length[get(fim, f)]);
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_FIELDS_SIZING_H
