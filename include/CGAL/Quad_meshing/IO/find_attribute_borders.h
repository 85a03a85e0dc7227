// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_FIND_ATTRIBUTE_BORDERS_H
#define CGAL_QUAD_MESHING_IO_FIND_ATTRIBUTE_BORDERS_H

#include <CGAL/Quad_meshing/IO/Attributes_on_mesh.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/// \ingroup PkgQuadMeshingIORef
/// \brief Which borders `find_attribute_borders()` looks for.
struct Attribute_border_kinds
{
  bool groups = true;    ///< between objects or groups
  bool materials = true; ///< between materials
  bool seams = true;     ///< where texture coordinates are not continuous
  bool normals = true;   ///< where vertex normals are not continuous
};

/*!
\ingroup PkgQuadMeshingIORef

\brief How many edges `find_attribute_borders()` has found.

An edge can be there for several reasons.
*/
struct Attribute_borders
{
  std::size_t groups = 0;    ///< between objects or groups
  std::size_t materials = 0; ///< between materials
  std::size_t seams = 0;     ///< where texture coordinates are not continuous
  std::size_t normals = 0;   ///< where vertex normals are not continuous
  /// Whether the normals are those of faces: not continuous at more than nine tenths of the edges that are bent. Then
  /// they say nothing about edges, and none is taken.
  bool has_flat_shading = false;
  std::size_t edges = 0; ///< all that were taken
};

/*!
\ingroup PkgQuadMeshingIORef

\brief finds the edges at which the attributes of a file change.

Made chains of quad edges (`edge_is_curve_map` of `quadrangulate()`), these let groups, materials, texture coordinates
and hard edges reach the quads.

Texture coordinates, and normals by more than one degree, are compared by their values at both ends of an edge: many
programs write them for every face anew.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with an internal point map
\tparam EdgeIsBorderMap a model of `ReadWritePropertyMap` with the edges as keys and `bool` as value type

\param tm the mesh of `on_mesh`
\param on_mesh the attributes
\param edge_is_border receives for every edge whether it is one; those of the border of the surface are none
\param kinds which borders count

\return how many there are, and why
*/
template <typename TriangleMesh, typename EdgeIsBorderMap>
Attribute_borders find_attribute_borders(const TriangleMesh& tm, const Attributes_on_mesh<TriangleMesh>& on_mesh,
                                         EdgeIsBorderMap edge_is_border,
                                         const Attribute_border_kinds& kinds = Attribute_border_kinds())
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef
    typename boost::property_traits<typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type
      Point;
  typedef typename Kernel_traits<Point>::Kernel::Vector_3 Vector;

  const auto vpm = get(vertex_point, tm);
  const Mesh_attributes& attributes = on_mesh.attributes();
  const double same_texture = 1e-6;                      // over the range of all texture coordinates
  const double same_direction = std::cos(CGAL_PI / 180); // of normals
  const double most_split = 0.9;                         // of the edges that are bent, if normals mean something
  double range = 0;
  for(const std::array<double, 2>& t : attributes.texture_coordinates)
    range = (std::max)(range, (std::max)(std::abs(t[0]), std::abs(t[1])));

  auto cosine = [](const auto& a, const auto& b)
  {
    const double l = std::sqrt((a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) * (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]));
    return l > 0 ? (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / l : 1;
  };
  auto face_normal = [&](halfedge_descriptor h)
  {
    const Vector n = cross_product(get(vpm, target(h, tm)) - get(vpm, source(h, tm)),
                                   get(vpm, target(next(h, tm), tm)) - get(vpm, source(h, tm)));
    return std::array<double, 3>{ { to_double(n.x()), to_double(n.y()), to_double(n.z()) } };
  };
  // Calls differ(a, b) for what the two faces say at each end.
  auto differs = [&](halfedge_descriptor h, const auto& value, const auto& differ)
  {
    const halfedge_descriptor o = opposite(h, tm);
    const auto at_target = value(h), at_target_beyond = value(prev(o, tm));
    const auto at_source = value(prev(h, tm)), at_source_beyond = value(o);
    return (at_target && at_target_beyond && differ(*at_target, *at_target_beyond)) ||
           (at_source && at_source_beyond && differ(*at_source, *at_source_beyond));
  };

  Attribute_borders result;
  std::vector<edge_descriptor> split; // by normals alone
  std::size_t bent = 0;
  for(edge_descriptor e : edges(tm))
  {
    put(edge_is_border, e, false);
    if(is_border(e, tm))
      continue;
    const halfedge_descriptor h = halfedge(e, tm);
    const auto f = face(h, tm), g = face(opposite(h, tm), tm);
    const std::size_t p = on_mesh.polygon(f), q = on_mesh.polygon(g);
    if(p == q || p == File_numbers::none || q == File_numbers::none)
      continue;
    auto have_other_names = [&](const Face_names& names) { return on_mesh.name(f, names) != on_mesh.name(g, names); };
    const bool is_of_groups =
      kinds.groups && (have_other_names(attributes.objects) || have_other_names(attributes.groups));
    const bool is_of_materials = kinds.materials && have_other_names(attributes.materials);
    const bool is_seam = kinds.seams && differs(
                                          h, [&](halfedge_descriptor i) { return on_mesh.texture(i); },
                                          [&](const auto& a, const auto& b)
                                          { return std::hypot(a[0] - b[0], a[1] - b[1]) > same_texture * range; });
    const bool is_split =
      kinds.normals && differs(
                         h, [&](halfedge_descriptor i) { return on_mesh.normal(i); },
                         [&](const auto& a, const auto& b) { return cosine(a, b) < same_direction; });
    result.groups += is_of_groups;
    result.materials += is_of_materials;
    result.seams += is_seam;
    bent += cosine(face_normal(h), face_normal(opposite(h, tm))) < same_direction;
    if(is_split)
      split.push_back(e);
    if(!is_of_groups && !is_of_materials && !is_seam)
      continue;
    ++result.edges;
    put(edge_is_border, e, true);
  }
  result.has_flat_shading =
    !split.empty() && static_cast<double>(split.size()) > most_split * static_cast<double>(bent);
  if(result.has_flat_shading)
    return result;
  result.normals = split.size();
  for(edge_descriptor e : split)
  {
    result.edges += !get(edge_is_border, e);
    put(edge_is_border, e, true);
  }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_FIND_ATTRIBUTE_BORDERS_H
