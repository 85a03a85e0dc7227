// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_CERTIFY_DISTANCES_H
#define CGAL_QUAD_MESHING_GEODESICS_CERTIFY_DISTANCES_H

#include <CGAL/Quad_meshing/Default_visitor.h>
#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_field.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Certified_paths.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Lipschitz_certificate.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingGeodesicsRef
 * \brief holds what `certify_distances()` has to say about its enclosures.
 */
struct Distance_certificate
{
  /// whether there was a field with windows and the visitor did not stop; else all enclosures are the whole line
  bool is_complete = false;
  /// the largest width of an enclosure
  double largest_width = 0;
  /// the largest width relative to the upper bound
  double largest_relative_width = 0;

  /// returns whether the enclosures were computed.
  explicit operator bool() const { return is_complete; }
};

/*!
 * \ingroup PkgQuadMeshingGeodesicsRef
 *
 * \brief computes an interval for each vertex that is guaranteed to contain its true distance.
 *
 * The true distance is that of real arithmetic on the surface whose vertices have the coordinates as given, from the
 * sources as given (a point inside of a face or an edge is taken as the field stores it, which moves it by rounding).
 * The guarantee rests on the windows of the field in no way: they are checked after the fact. The upper bound is the
 * length of a path that is there. The lower bound is the distance that the field claims, less all that it lacks of
 * being a function which nowhere grows faster than the way does, as no such function can exceed the distance. All of
 * this is computed with proven bounds for rounding errors, in arithmetic of twice the precision of `double`. An error
 * in the field makes enclosures wide, never wrong.
 *
 * Coordinates must be numbers of type `double`; those of other types are rounded first, and the guarantee is for the
 * rounded ones. The rounding mode must be to nearest. Fields with `relative_distance_error` may be certified too, the
 * enclosures are as wide as the errors.
 *
 * \tparam TriangleMesh the type of the mesh of the field
 * \tparam VertexEnclosureMap a model of `WritablePropertyMap` with
 * `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `CGAL::Interval_nt<>` as value type
 *
 * \param field a field after `propagate()` without a limit, with its windows kept
 * \param enclosures receives the intervals; from infinity to infinity where no source reaches
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{learns of the progress and may stop the computation}
 *     \cgalParamType{a type with the members of `Default_visitor`, by `std::ref`}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 */
template <typename TriangleMesh, typename VertexEnclosureMap,
          typename NamedParameters = parameters::Default_named_parameters>
Distance_certificate certify_distances(const Geodesic_distance_field<TriangleMesh>& field,
                                       VertexEnclosureMap enclosures,
                                       const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter_reference;
  typedef internal::Field_access Access;

  Default_visitor default_visitor;
  auto& visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  const double infinity = std::numeric_limits<double>::infinity();
  Distance_certificate certificate;
  std::vector<double> lower, upper;
  const auto* propagation = Access::propagation(field);
  if(propagation != nullptr)
  {
    const auto& mesh = Access::mesh(field);
    const auto& sources = Access::sources(field);
    certificate.is_complete = true;
    double done = 0, share = 0.3;
    const auto go_on = [&](double part)
    {
      visitor.progress(done + share * part);
      certificate.is_complete = certificate.is_complete && visitor.go_further();
      return certificate.is_complete;
    };
    visitor.on_stage_begin("certificate of the distances");
    internal::Certified_paths paths(mesh, *propagation, sources);
    upper = paths(go_on);
    done = share;
    share = 1 - done;
    if(certificate)
      lower = internal::Lipschitz_certificate(mesh, *propagation, sources)(upper, go_on);
    visitor.on_stage_end("certificate of the distances");
  }
  for(auto v : vertices(Access::graph(field)))
  {
    const int i = Access::index(field, v);
    const Interval_nt<> enclosure =
      certificate ? Interval_nt<>(lower[i], upper[i]) : Interval_nt<>(-infinity, infinity);
    put(enclosures, v, enclosure);
    if(!field.is_reached(v))
      continue;
    const double width = enclosure.sup() - enclosure.inf();
    certificate.largest_width = (std::max)(certificate.largest_width, width);
    if(width > 0)
      certificate.largest_relative_width =
        (std::max)(certificate.largest_relative_width, width / std::fabs(enclosure.sup()));
  }
  return certificate;
}

/*!
 * \ingroup PkgQuadMeshingGeodesicsRef
 *
 * \brief a distance field that encloses the distances of all vertices.
 *
 * It is `Geodesic_distance_field<TriangleMesh>` with `certify_distances()` at the end of `propagate()`.
 */
template <typename TriangleMesh, bool Protected>
class Geodesic_distance_field<TriangleMesh, Interval_nt<Protected>>
  : public Geodesic_distance_field<TriangleMesh, double>
{
  typedef Geodesic_distance_field<TriangleMesh, double> Base;

public:
  typedef typename Base::vertex_descriptor vertex_descriptor;

  /// reads the geometry of a mesh; the parameters are those of the base class.
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Geodesic_distance_field(const TriangleMesh& tm, const NamedParameters& np = parameters::default_values())
    : Base(tm, np)
  {
  }

  /// computes the field and the enclosures; the parameters are those of the base class.
  template <typename NamedParameters = parameters::Default_named_parameters>
  Geodesic_distance_result propagate(const NamedParameters& np = parameters::default_values())
  {
    const Geodesic_distance_result result = Base::propagate(np);
    m_enclosures.assign(num_vertices(internal::Field_access::graph(*this)), Interval_nt<Protected>(0));
    const Enclosure_map map{ static_cast<const Base*>(this), &m_enclosures };
    m_certificate = certify_distances(static_cast<const Base&>(*this), map, np);
    return result;
  }

  /// returns an interval that contains the distance of a vertex. \pre `propagate()` was called
  Interval_nt<Protected> distance_value(vertex_descriptor v) const
  {
    return m_enclosures[internal::Field_access::index(static_cast<const Base&>(*this), v)];
  }

  /// returns how wide the enclosures are.
  const Distance_certificate& certificate() const { return m_certificate; }

private:
  struct Enclosure_map
  {
    typedef vertex_descriptor key_type;
    typedef Interval_nt<> value_type;
    typedef const Interval_nt<>& reference;
    typedef boost::writable_property_map_tag category;

    const Base* field;
    std::vector<Interval_nt<Protected>>* enclosures;

    friend void put(const Enclosure_map& map, key_type v, const value_type& enclosure)
    {
      (*map.enclosures)[internal::Field_access::index(*map.field, v)] =
        Interval_nt<Protected>(enclosure.inf(), enclosure.sup());
    }
  };

  std::vector<Interval_nt<Protected>> m_enclosures;
  Distance_certificate m_certificate;
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_CERTIFY_DISTANCES_H
