// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GRID_MAP_SEARCH_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GRID_MAP_SEARCH_H

#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>
#include <CGAL/Quad_meshing/Extraction/transfer_feature_edges.h>
#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Layout/quads_of_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/quantize_t_mesh.h>
#include <CGAL/Quad_meshing/Parameterization/Seamless_map.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation_options.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Grid_map_attempt.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Pipeline_visitor.h>
#include <CGAL/Quad_meshing/Pipeline/internal/release_features.h>
#include <CGAL/Quad_meshing/parameters.h>

#include <CGAL/Real_timer.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Carries out the plans of a quadrangulation on one component, and keeps the best attempt.
//
// An attempt depends on nothing but its plan, the best attempt before it, and what is constant: the prepared triangles,
// the directions and the options.
class Grid_map_search
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_status Status;

public:
  // The directions that the field should have, and what they weigh.
  struct Directions
  {
    std::vector<std::optional<Quadrangulation_kernel::Vector_3>> direction; // per face
    std::vector<double> weight;                                             // per face; infinite: hard
    std::vector<std::optional<int>> index;                                  // that vertices must have; empty: any
    std::vector<char> is_node;          // per vertex: it becomes a vertex of quads; empty: none has to
    bool has_releasable_curves = false; // of the user
    std::vector<double> importance;     // per face: how much it counts for the map; empty: one everywhere
    std::vector<char> is_loose;         // per edge: a feature for the map alone, not for the field; empty: none

    // The feature edges that the field follows.
    std::vector<char> constrained(std::vector<char> is_feature) const
    {
      for(std::size_t e = 0; e < is_loose.size(); ++e)
        is_feature[e] = is_feature[e] && !is_loose[e];
      return is_feature;
    }
  };

  struct Options
  {
    const Quadrangulation_options& quadrangulation;
    double length;            // of a quad edge
    double releasable_length; // of the feature edges that may be released
    double requested_quads;   // in this component; 0: an edge length was asked for
    double number_of_quads;   // that the length stands for
  };

  Grid_map_search(const Quadrangulation_surface& surface, const Directions& directions, const Options& options,
                  Pipeline_visitor& visitor)
    : m_surface(surface)
    , m_directions(directions)
    , m_index(directions.index)
    , m_is_node(directions.is_node)
    , m_importance(directions.importance)
    , m_options(options)
    , m_visitor(visitor)
  {
    m_index.resize(surface.mesh.number_of_vertices());
    m_is_node.resize(surface.mesh.number_of_vertices(), 0);
    m_importance.resize(surface.mesh.number_of_faces(), 1.);
  }

  // The times and the number of attempts of all plans.
  Quadrangulation_result figures;

  // Why there is no attempt, if there is none.
  Status status = Status::FAILED;
  std::string message;

  // The best attempt, or null.
  std::shared_ptr<const Grid_map_attempt> run()
  {
    std::shared_ptr<Grid_map_attempt> best;
    for(const Grid_map_plan_rule& rule : m_options.quadrangulation.plans)
    {
      if(best && !m_visitor.go_further())
        break;
      const std::optional<Grid_map_plan> plan = rule.plan(situation(best.get()));
      if(!plan)
        continue;
      std::shared_ptr<Grid_map_attempt> attempt = carry_out(*plan, best.get());
      if(attempt && attempt->folded.empty() && !attempt->quads && !extract(*attempt))
        attempt.reset();
      if(attempt && (!best || attempt->is_better_than(*best, m_options.requested_quads)))
        best = attempt;
      if(!best) // what fails after there is a map does no harm
        return nullptr;
    }
    if(m_visitor.is_stopped())
      return stopped("The visitor stopped the quadrangulation.");
    if(best && !best->quads && !extract(*best))
      return nullptr;
    return best;
  }

private:
  template <typename Tag, typename T>
  auto map_of(Tag tag, std::vector<T>& values) const
  {
    return boost::make_iterator_property_map(values.begin(), get(tag, m_surface.mesh));
  }

  template <typename Tag, typename T>
  auto map_of(Tag tag, const std::vector<T>& values) const
  {
    return boost::make_iterator_property_map(values.begin(), get(tag, m_surface.mesh));
  }

  Grid_map_situation situation(const Grid_map_attempt* best) const
  {
    Grid_map_situation s;
    s.requested_method = m_options.quadrangulation.cross_field_method;
    s.random_seed = m_options.quadrangulation.random_seed;
    s.has_releasable_features = m_options.releasable_length > 0;
    s.has_curves = m_directions.has_releasable_curves;
    s.requested_quads = m_options.requested_quads;
    s.has_singularity_cost = m_options.quadrangulation.singularity_cost > 0 && !is_graded();
    if(best)
    {
      s.has_attempt = true;
      s.folded_triangles = best->folded.size();
      s.folded_before_rounding = best->folded_before_rounding.size();
      s.distortion = best->field->map->distortion();
      s.is_simple = best->is_simple;
      s.quads = best->number_of_quads();
      s.relative_length = best->relative_length;
      s.method = best->field->method;
      s.frees_singularities = best->field->frees_singularities;
    }
    return s;
  }

  // Null if there is no map, or if the plan changes nothing.
  std::shared_ptr<Grid_map_attempt> carry_out(const Grid_map_plan& plan, const Grid_map_attempt* best)
  {
    std::shared_ptr<Field_attempt> field = best ? best->field : nullptr;
    if(plan.new_field)
    {
      std::vector<char> is_feature = best ? best->field->is_feature : initial_features();
      double released = best ? best->field->released_length : 0;
      if(plan.release_radius > 0)
      {
        const double length = release(*best, plan.release_radius * m_options.length, plan.releases_curves, is_feature);
        if(length == 0)
          return nullptr;
        released += plan.releases_curves ? 0 : length; // curves of the user have an answer of their own
      }
      field = field_with_room(plan, is_feature, released);
    }
    if(plan.evens_quads && best && field && !is_more_even(*field, *best->field))
      return nullptr;
    return field ? map(field, plan) : nullptr;
  }

  // Whether the map of a field is distorted so much less than that of another one that it is worth more singularities:
  // the distortion goes down by twice the share that their number goes up by. The least distortion is 1.
  bool is_more_even(Field_attempt& field, const Field_attempt& other)
  {
    const double least_gain = 0.3;   // below it, nobody sees the difference
    const double gain_of_growth = 2; // armadillo at 2000 quads is no better with 40 percent more
    const double growth = field.singularities / (std::max)(1., double(other.singularities)) - 1;
    if(gain_of_growth * growth >= 1 || !compute_seamless_map(field) ||
       !field.map->result().folded_before_rounding.empty())
      return false;
    const double gain = 1 - (field.map->distortion() - 1) / (other.map->distortion() - 1);
    return gain > (std::max)(least_gain, gain_of_growth * growth);
  }

  std::vector<char> initial_features() const
  {
    std::vector<char> is_feature;
    for(Mesh::Edge_index e : m_surface.mesh.edges())
      is_feature.push_back(m_surface.is_feature[e]);
    return is_feature;
  }

  // Those that are never released.
  std::vector<char> kept_features() const
  {
    std::vector<char> is_kept;
    for(Mesh::Edge_index e : m_surface.mesh.edges())
      is_kept.push_back(m_surface.is_kept[e]);
    return is_kept;
  }

  // The edges near the folded triangles of an attempt; returns their length.
  double release(const Grid_map_attempt& attempt, double radius, bool releases_curves,
                 std::vector<char>& is_feature) const
  {
    std::vector<char> is_kept = kept_features();
    if(releases_curves) // those in the border stay
      for(Mesh::Edge_index e : m_surface.mesh.edges())
        is_kept[e] = is_kept[e] && m_surface.mesh.is_border(e);
    return release_features(m_surface.mesh,
                            attempt.folded_before_rounding.empty() ? attempt.folded : attempt.folded_before_rounding,
                            radius, map_of(boost::edge_index, is_kept), map_of(boost::edge_index, is_feature));
  }

  // The work for a map grows with the cube of the number of singularities, and with less than four quads for each there
  // is hardly one to be found: then the feature edges are given up, all of them. Few singularities may be as close as
  // they like.
  std::shared_ptr<Field_attempt> field_with_room(const Grid_map_plan& plan, const std::vector<char>& is_feature,
                                                 double released)
  {
    std::shared_ptr<Field_attempt> field = compute_field(plan, is_feature, released);
    if(field && !has_room(*field) && m_options.releasable_length > released)
      field = compute_field(plan, kept_features(), m_options.releasable_length);
    if(!field || has_room(*field))
      return field;
    figures.singularities = field->singularities;
    figures.released_feature_share =
      m_options.releasable_length > 0 ? field->released_length / m_options.releasable_length : 0;
    fail(Status::FAILED, "The cross field has " + std::to_string(field->singularities) +
                           " singularities: too many for about " +
                           std::to_string(std::lround(m_options.number_of_quads)) + " quads. More quads may help.");
    return nullptr;
  }

  bool has_room(const Field_attempt& field) const
  {
    const int few = 1200, least_quads_per_singularity = 4;
    return field.singularities <= few || field.singularities * least_quads_per_singularity <= m_options.number_of_quads;
  }

  void fail(Status s, const std::string& m)
  {
    status = s;
    message = m;
  }

  // Lengths that change need singularities.
  double singularity_cost(const Grid_map_plan& plan) const
  {
    return plan.frees_singularities || is_graded() ? 0 : m_options.quadrangulation.singularity_cost;
  }

  // Whether the lengths on the surface are not all the same.
  bool is_graded() const
  {
    return std::any_of(m_surface.mesh.faces().begin(), m_surface.mesh.faces().end(),
                       [this](Mesh::Face_index f)
                       { return m_surface.length[f] != m_surface.length[*m_surface.mesh.faces().begin()]; });
  }

  std::shared_ptr<Field_attempt> compute_field(const Grid_map_plan& plan, const std::vector<char>& is_feature,
                                               double released)
  {
    const Mesh& mesh = m_surface.mesh;
    auto field = std::make_shared<Field_attempt>();
    field->method = *plan.new_field;
    field->frees_singularities = plan.frees_singularities;
    field->is_feature = is_feature;
    field->released_length = released;
    field->angle.resize(mesh.number_of_faces());
    field->period_jump.resize(mesh.number_of_edges());
    field->index.resize(mesh.number_of_vertices());
    const std::vector<char> constrained = m_directions.constrained(is_feature);
    const Cross_field_result r =
      smooth_cross_field(mesh, map_of(boost::face_index, field->angle), map_of(boost::edge_index, field->period_jump),
                         map_of(boost::vertex_index, field->index),
                         parameters::target_edge_length(m_options.length)
                           .edge_is_constrained_map(map_of(boost::edge_index, constrained))
                           .align_boundary(m_options.quadrangulation.align_boundary)
                           .cross_field_method(field->method)
                           .singularity_cost(singularity_cost(plan))
                           .rounding_tolerance(m_options.quadrangulation.rounding_tolerance)
                           .gauss_seidel_iterations(m_options.quadrangulation.gauss_seidel_iterations)
                           .conjugate_gradient_iterations(m_options.quadrangulation.conjugate_gradient_iterations)
                           .allow_refactorization(m_options.quadrangulation.allow_refactorization)
                           .face_direction_map(map_of(boost::face_index, m_directions.direction))
                           .face_direction_weight_map(map_of(boost::face_index, m_directions.weight))
                           .face_sizing_map(m_surface.length)
                           .prescribed_index_map(map_of(boost::vertex_index, m_index))
                           .visitor(std::ref(m_visitor)));
    figures.field_seconds += r.seconds;
    if(r.status == Cross_field_status::STOPPED)
      return stopped(r.message);
    if(!r.is_valid() && r.status != Cross_field_status::EMPTY_SECTORS)
    {
      fail(Status::FAILED, r.message);
      return nullptr;
    }
    field->singularities = r.singularities;
    field->integers = r.integers;
    field->energy = r.energy;
    return field;
  }

  std::nullptr_t stopped(const std::string& m)
  {
    fail(m_visitor.is_stopped() ? Status::STOPPED : Status::OUT_OF_TIME,
         m_visitor.is_stopped() ? m : "The time was up before there was a mesh.");
    return nullptr;
  }

  std::shared_ptr<Grid_map_attempt> map(const std::shared_ptr<Field_attempt>& field, const Grid_map_plan& plan)
  {
    if(!field->map && !compute_seamless_map(*field))
      return nullptr;
    auto attempt = std::make_shared<Grid_map_attempt>();
    attempt->field = field;
    attempt->relative_length = plan.relative_length;
    attempt->evens_quads = plan.evens_quads;
    attempt->uv.resize(m_surface.mesh.number_of_halfedges());
    if(!round(*attempt, false))
      return nullptr;
    // Where no integers come at once that the map can follow, lengths of the arcs of its T-mesh do.
    if(!attempt->folded.empty() && attempt->folded_before_rounding.empty() && !make_quads_of_t_mesh(*attempt) &&
       !round(*attempt, true))
      return nullptr;
    return attempt;
  }

  // Returns false after a stop.
  bool round(Grid_map_attempt& attempt, bool repairs)
  {
    const auto uv = map_of(boost::halfedge_index, attempt.uv);
    const auto np = parameters::rounding_method(m_options.quadrangulation.rounding_method).visitor(std::ref(m_visitor));
    Seamless_map& map = *attempt.field->map;
    const Integer_grid_map_result r = repairs ? map.round(m_surface.mesh, attempt.length(), uv, np)
                                              : map.round_without_repair(m_surface.mesh, attempt.length(), uv, np);
    ++figures.parameterization_attempts;
    figures.parameterization_seconds += r.seconds;
    if(r.status == Integer_grid_map_status::STOPPED)
    {
      stopped(r.message);
      return false;
    }
    attempt.integers = r.integers;
    attempt.energy = r.energy;
    attempt.relaxed_energy = r.relaxed_energy;
    attempt.folded = faces(r.folded_faces);
    attempt.folded_before_rounding = faces(r.folded_before_rounding);
    return true;
  }

  // Returns whether there are quads now.
  bool make_quads_of_t_mesh(Grid_map_attempt& attempt)
  {
    Real_timer timer;
    timer.start();
    const auto t = std::make_shared<T_mesh>(attempt.field->map->t_mesh(parameters::visitor(std::ref(m_visitor))));
    std::vector<int> lengths;
    auto quads = std::make_shared<Quadrangulation_quads>();
    const bool is_made = quantize_t_mesh(*t, lengths).is_valid &&
                         quads_of_t_mesh(*t, lengths, m_surface.mesh, quads->mesh, quads->is_feature,
                                         parameters::face_location_map(quads->location));
    figures.extraction_seconds += timer.time();
    if(!is_made)
      return false;
    attempt.quads = quads;
    attempt.t_mesh = t;
    for(Mesh::Face_index f : m_surface.mesh.faces())
    {
      int k = 0;
      for(Mesh::Halfedge_index h : m_surface.mesh.halfedges_around_face(m_surface.mesh.halfedge(f)))
      {
        const std::array<double, 2> p = t->image(f, ++k % 3); // of its target; corner 0 is the source of the first
        attempt.uv[h] = Quadrangulation_kernel::Point_2(p[0], p[1]);
      }
    }
    attempt.is_simple = true;
    attempt.other_faces = 0;
    attempt.folded.clear();
    attempt.irregular_vertices = count_irregular_vertices(quads->mesh);
    attempt.message = "The quads were made along the T-mesh of the seamless map.";
    return true;
  }

  static std::size_t count_irregular_vertices(const Mesh& mesh)
  {
    return std::count_if(mesh.vertices().begin(), mesh.vertices().end(),
                         [&](Mesh::Vertex_index v) { return mesh.degree(v) != (mesh.is_border(v) ? 3u : 4u); });
  }

  // The map of a field, for the length asked for, and the length at which it has as many quads as are asked for.
  bool compute_seamless_map(Field_attempt& field)
  {
    const Quadrangulation_options& o = m_options.quadrangulation;
    field.map = std::make_shared<Seamless_map>(m_surface.mesh, map_of(boost::face_index, field.angle),
                                               map_of(boost::edge_index, field.period_jump),
                                               map_of(boost::vertex_index, field.index),
                                               parameters::target_edge_length(m_options.length)
                                                 .face_sizing_map(m_surface.length)
                                                 .edge_is_constrained_map(map_of(boost::edge_index, field.is_feature))
                                                 .face_direction_weight_map(map_of(boost::face_index, m_importance))
                                                 .vertex_is_constrained_map(map_of(boost::vertex_index, m_is_node))
                                                 .align_boundary(o.align_boundary)
                                                 .anisotropy_weight(o.anisotropy_weight)
                                                 .number_of_threads(o.number_of_threads)
                                                 .visitor(std::ref(m_visitor)));
    const Integer_grid_map_result& r = field.map->result();
    figures.parameterization_seconds += r.seconds;
    if(!field.map->is_solved())
    {
      if(r.status == Integer_grid_map_status::STOPPED)
        stopped(r.message);
      else
        fail(Status::FAILED, r.message);
      return false;
    }
    // Further off, the map is so distorted that the number of quads says little.
    const double largest_correction = 1.5;
    if(m_options.requested_quads > 0 && field.map->number_of_quads() > 0)
      field.fitting_length = (std::min)(
        largest_correction,
        (std::max)(1 / largest_correction, std::sqrt(field.map->number_of_quads() / m_options.requested_quads)));
    return true;
  }

  static std::vector<Mesh::Face_index> faces(const std::vector<std::size_t>& numbers)
  {
    std::vector<Mesh::Face_index> result;
    for(std::size_t i : numbers)
      result.push_back(Mesh::Face_index(static_cast<Mesh::size_type>(i)));
    return result;
  }

  // Makes the quads of an attempt. A map that has cost so much is not lost to a time limit.
  bool extract(Grid_map_attempt& attempt)
  {
    if(m_visitor.is_time_up())
      m_visitor.lift_time_limit();
    Real_timer timer;
    timer.start();
    auto quads = std::make_shared<Quadrangulation_quads>();
    const Quad_extraction_result r =
      extract_quad_mesh(m_surface.mesh, map_of(boost::halfedge_index, attempt.uv), quads->mesh,
                        parameters::face_location_map(quads->location).visitor(std::ref(m_visitor)));
    figures.extraction_seconds += timer.time();
    if(r.status == Quad_extraction_status::STOPPED)
    {
      stopped(r.message);
      return false;
    }
    if(r.status == Quad_extraction_status::FAILED)
    {
      fail(Status::FAILED, r.message);
      return false;
    }
    attempt.message = r.message;
    attempt.other_faces = r.other_faces;
    attempt.irregular_vertices = r.irregular_vertices + r.irregular_border_vertices;
    attempt.is_simple = r.status != Quad_extraction_status::NOT_SIMPLE;
    if(!attempt.is_simple && make_quads_of_t_mesh(attempt)) // there, no grid is too coarse
      return true;
    transfer_feature_edges(m_surface.mesh, map_of(boost::edge_index, attempt.field->is_feature), quads->mesh,
                           quads->location, quads->is_feature);
    attempt.quads = quads;
    return true;
  }

  const Quadrangulation_surface& m_surface;
  const Directions& m_directions;
  std::vector<std::optional<int>> m_index; // per vertex
  std::vector<char> m_is_node;             // per vertex
  std::vector<double> m_importance;        // per face
  const Options m_options;
  Pipeline_visitor& m_visitor;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_GRID_MAP_SEARCH_H
