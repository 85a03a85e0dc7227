// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_GRID_MAP_SEARCH_H
#define CGAL_QUAD_MESHING_INTERNAL_GRID_MAP_SEARCH_H

#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Parameterization/integer_grid_map.h>
#include <CGAL/Quad_meshing/Quadrangulation_result.h>
#include <CGAL/Quad_meshing/internal/release_features.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Random.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/optional.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The cross field and the integer-grid map of a quadrangulation, anew until there is a map without fold-overs. What is left behind
// in the quadrangulation is the attempt with the fewest.
template <typename Quadrangulation, typename Visitor>
class Grid_map_search
{
  typedef Quadrangulation_result Result;
  typedef typename Quadrangulation::Kernel Kernel;
  typedef typename Quadrangulation::Mesh Mesh;
  typedef typename Mesh::Face_index Face_index;
  typedef typename Mesh::template Property_map<Face_index, boost::optional<typename Kernel::Vector_3> > Directions;

public:
  // feature_length: of the feature edges that may be released.
  Grid_map_search(Quadrangulation& quadrangulation, const Directions& directions, double length, double feature_length, Visitor& visitor,
                  Result& result)
    : q(quadrangulation), directions(directions), length(length), feature_length(feature_length)
    , number_of_quads(Polygon_mesh_processing::area(quadrangulation.mesh) / (length * length)), visitor(visitor), result(result)
  {}

  // If the integers are to blame for fold-overs, a slightly different length may leave room where the first one does not. The other
  // field has its singularities elsewhere. Where sharp edges leave no room, those nearby are released, farther and farther around.
  bool run()
  {
    const double shortest = 0.93, longest = 1.05; // within 16 percent of the number of quads
    const int most_releases = 3;
    Random random(q.random_seed);
    if(!attempt(q.cross_field_method))
      return false;
    if(is_folded() && best.folded_before_rounding.empty() &&
       !attempt_other_length(random.get_double(shortest, longest)))
      return false;
    if(is_folded() && q.cross_field_method == Cross_field_method::REPRESENTATION &&
       !attempt(Cross_field_method::POLISHED))
      return false;
    double radius = 2 * length;
    for(int release = 0; release < most_releases && is_folded(); ++release, radius *= 2)
    {
      best.restore(q, result);
      const double released = release_features(radius);
      if(released == 0)
        break;
      result.released_feature_share += released / feature_length;
      if(!attempt(best.method))
        return false;
    }
    best.restore(q, result);
    return true;
  }

  // The map of the field that was found, for another length. Returns whether it has no fold-overs; else all is as before.
  bool run_for_length(double relative_length)
  {
    const Result before = result;
    best.folded.assign(1, Face_index()); // any map without is better
    if(compute_map(relative_length) && !is_folded())
      return true;
    best.folded.clear();
    if(result.status != Result::STOPPED)
    {
      best.restore_maps(q);
      set_figures(before, result);
    }
    return false;
  }

private:
  // The field and the map of an attempt, with their figures.
  struct Attempt
  {
    Cross_field_method method = Cross_field_method::REPRESENTATION;
    std::vector<Face_index> folded, folded_before_rounding;
    std::vector<bool> is_feature;
    std::vector<double> angle;
    std::vector<int> period_jump, index;
    std::vector<typename Kernel::Point_2> uv;
    Result result;

    void take(const Quadrangulation& q, const Result& r)
    {
      is_feature = values(q.is_feature, q.mesh.edges());
      angle = values(q.angle, q.mesh.faces());
      period_jump = values(q.period_jump, q.mesh.edges());
      index = values(q.index, q.mesh.vertices());
      uv = values(q.uv, q.mesh.halfedges());
      result = r;
    }

    void restore_maps(Quadrangulation& q) const
    {
      assign(q.is_feature, q.mesh.edges(), is_feature);
      assign(q.angle, q.mesh.faces(), angle);
      assign(q.period_jump, q.mesh.edges(), period_jump);
      assign(q.index, q.mesh.vertices(), index);
      assign(q.uv, q.mesh.halfedges(), uv);
    }

    void restore(Quadrangulation& q, Result& r) const
    {
      restore_maps(q);
      set_figures(result, r);
    }

    template <typename Map, typename Range>
    static std::vector<typename Map::value_type> values(const Map& map, const Range& range)
    {
      std::vector<typename Map::value_type> result;
      for(auto i : range)
        result.push_back(map[i]);
      return result;
    }

    template <typename Map, typename Range>
    static void assign(Map& map, const Range& range, const std::vector<typename Map::value_type>& values)
    {
      std::size_t k = 0;
      for(auto i : range)
        map[i] = values[k++];
    }
  };

  // The times are those of all attempts.
  static void set_figures(const Result& figures, Result& r)
  {
    const Result last = r;
    r = figures;
    r.field_seconds = last.field_seconds;
    r.parameterization_seconds = last.parameterization_seconds;
    r.parameterization_attempts = last.parameterization_attempts;
  }

  bool is_folded() const { return !best.folded.empty(); }

  bool fail(Result::Status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
    return false;
  }

  // Whether to go on: what fails after there is a map does no harm.
  bool attempt(Cross_field_method method)
  {
    current_method = method;
    return (compute_field() && make_room() && compute_map(1)) || (has_map() && result.status != Result::STOPPED);
  }

  // The work for a map grows with the cube of the number of singularities, and with less than four quads for each there is hardly one
  // to be found: then the feature edges are given up, all of them. Few singularities may be as close as they like.
  bool make_room()
  {
    if(has_room())
      return true;
    if(feature_length > 0 && result.released_feature_share < 1)
    {
      for(typename Mesh::Edge_index e : q.mesh.edges())
        q.is_feature[e] = false;
      result.released_feature_share = 1;
      if(!compute_field())
        return false;
      if(has_room())
        return true;
    }
    return fail(Result::FAILED, "The cross field has " + std::to_string(result.singularities) + " singularities: too many for about " +
                                std::to_string(std::lround(number_of_quads)) + " quads. More quads may help.");
  }

  bool has_room() const
  {
    const int few = 1200, least_quads_per_singularity = 4;
    return result.singularities <= few || result.singularities * least_quads_per_singularity <= number_of_quads;
  }

  bool attempt_other_length(double relative_length)
  {
    return compute_map(relative_length) || result.status != Result::STOPPED;
  }

  bool has_map() const { return !best.uv.empty(); }

  bool compute_field()
  {
    const Cross_field_result field =
      smooth_cross_field(q.mesh, q.angle, q.period_jump, q.index,
                         parameters::target_edge_length(length)
                           .edge_is_constrained_map(q.is_feature)
                           .align_boundary(q.align_boundary)
                           .cross_field_method(current_method)
                           .face_direction_map(directions)
                           .visitor(std::ref(visitor)));
    result.singularities = field.singularities;
    result.field_integers = field.integers;
    result.field_energy = field.energy;
    result.field_seconds += field.seconds;
    if(field.status == Cross_field_status::STOPPED)
      return fail(Result::STOPPED, field.message);
    if(!field.is_valid() && field.status != Cross_field_status::EMPTY_SECTORS)
      return fail(Result::FAILED, field.message);
    return true;
  }

  bool compute_map(double relative_length)
  {
    const Integer_grid_map_result map =
      integer_grid_map(q.mesh, q.angle, q.period_jump, q.index, q.uv,
                       parameters::target_edge_length(relative_length * length)
                         .edge_is_constrained_map(q.is_feature)
                         .align_boundary(q.align_boundary)
                         .rounding_method(q.rounding_method)
                         .anisotropy_weight(q.anisotropy_weight)
                         .number_of_threads(q.number_of_threads)
                         .visitor(std::ref(visitor)));
    ++result.parameterization_attempts;
    result.parameterization_seconds += map.seconds;
    if(map.status == Integer_grid_map_status::STOPPED)
      return fail(Result::STOPPED, map.message);
    if(map.status != Integer_grid_map_status::VALID && map.status != Integer_grid_map_status::FOLDED)
      return fail(Result::FAILED, map.message);
    result.parameterization_integers = map.integers;
    result.parameterization_energy = map.energy;
    result.relaxed_parameterization_energy = map.relaxed_energy;
    result.flipped_triangles = map.folded_faces.size();
    result.target_edge_length = relative_length * length;
    if(!has_map() || map.folded_faces.size() < best.folded.size())
    {
      best.method = current_method;
      best.folded = faces(map.folded_faces);
      best.folded_before_rounding = faces(map.folded_before_rounding);
      best.take(q, result);
    }
    return true;
  }

  static std::vector<Face_index> faces(const std::vector<std::size_t>& numbers)
  {
    std::vector<Face_index> result;
    for(std::size_t i : numbers)
      result.push_back(Face_index(static_cast<typename Mesh::size_type>(i)));
    return result;
  }

  // The feature edges near the folded faces of the best map; returns their length.
  double release_features(double radius)
  {
    if(feature_length == 0)
      return 0;
    return internal::release_features(q.mesh, q.mesh.points(),
                                      best.folded_before_rounding.empty() ? best.folded : best.folded_before_rounding, radius,
                                      q.is_feature);
  }

  Quadrangulation& q;
  const Directions& directions;
  const double length, feature_length, number_of_quads;
  Visitor& visitor;
  Result& result;
  Attempt best;
  Cross_field_method current_method = Cross_field_method::REPRESENTATION;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_GRID_MAP_SEARCH_H
