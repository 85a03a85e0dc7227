// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_QUADRANGULATION_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_QUADRANGULATION_H

#include <CGAL/Quad_meshing/Layout/layout_from_quad_mesh.h>
#include <CGAL/Quad_meshing/Layout/quadrangulate_layout.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Component_guides.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Component_request.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Component_smoothing.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Curve_nodes.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Working_surface.h>
#include <CGAL/Quad_meshing/Pipeline/internal/find_component_directions.h>
#include <CGAL/Quad_meshing/Pipeline/internal/prepare_component.h>
#include <CGAL/Quad_meshing/Pipeline/internal/prescribed_indices.h>
#include <CGAL/Quad_meshing/Pipeline/internal/search_component.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Structure/optimize_quad_structure.h>
#include <CGAL/Quad_meshing/internal/surface_topology.h>

#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The stages of a quadrangulation on one component.
class Component_quadrangulation
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_status Status;

public:
  // `surface` is the component; what it is worked on takes its place. directions: per face of the input, or empty
  Component_quadrangulation(std::unique_ptr<Quadrangulation_surface>& surface, const Component_request& request,
                            const std::vector<std::optional<Quadrangulation_kernel::Vector_3>>& directions,
                            const Quadrangulation_options& options, Pipeline_visitor& visitor)
    : m_surface(surface)
    , m_work(surface, options.align_boundary)
    , m_request(request)
    , m_directions(directions)
    , m_options(options)
    , m_visitor(visitor)
    , m_topology(surface_topology(surface->mesh))
    , m_smoothing(surface, m_work, options, visitor)
  {
    for(Mesh::Face_index f : surface->mesh.faces())
      first_input_face = (std::min)(first_input_face, surface->origin[f]);
  }

  Quadrangulation_result result;
  std::shared_ptr<Quadrangulation_quads> quads;                             // null: there are none
  double feature_length = 0;                                                // of the feature edges that may be released
  std::vector<std::string> unmet;                                           // wishes of the user that contradict others
  std::size_t first_input_face = (std::numeric_limits<std::size_t>::max)(); // the smallest number of a face

  void run()
  {
    if(prepare() && make_quads())
      finish();
    m_work.number_origins();
  }

private:
  void finish()
  {
    if(result.status == Status::VALID && result.other_faces == 0 && !m_visitor.is_time_up())
    {
      if(m_options.optimize_structure || m_options.semi_regular)
        optimize();
      else if(m_options.smoothing_iterations != 0)
        smooth();
    }
    if(m_options.semi_regular && result.status == Status::VALID && !m_visitor.is_time_up())
      make_semi_regular();
    if(result.status == Status::STOPPED)
      return;
    m_work.locate_on_input(*quads);
    check();
  }

  bool prepare()
  {
    feature_length = find_component_features(*m_surface, m_request, m_options, result);
    const std::string stopped = prepare_component(m_surface, m_work, m_request, m_options, m_visitor);
    if(!stopped.empty())
      return stop_early(stopped);
    result.prepared_faces = m_surface->mesh.number_of_faces();
    return true;
  }

  bool make_quads()
  {
    Grid_map_search::Directions directions;
    Real_timer timer;
    timer.start();
    const Curvature_guide_result of_surface =
      find_component_directions(*m_surface, m_work, m_directions, m_request, m_options, m_visitor, directions);
    if(of_surface.status == Curvature_guide_status::STOPPED)
      return stop_early(of_surface.message);
    if(!of_surface.is_valid())
    {
      fail(Status::FAILED, of_surface.message);
      return false;
    }
    result.field_seconds = timer.time();
    const Component_wishes& wishes = m_request.wishes;
    if(!wishes.strokes.empty() || !wishes.indices.empty() || !wishes.connections.empty())
    {
      Component_guides guides(*m_surface, m_work.largest_distance());
      guides.follow_strokes(wishes.strokes, directions.direction, directions.weight, directions.importance);
      directions.is_loose = guides.loose_edges(wishes.connections);
      directions.index = guides.prescribe(wishes.indices, directions.is_loose,
                                          [&](const auto& prescribed)
                                          {
                                            Real_timer field_timer;
                                            field_timer.start();
                                            const std::vector<int> index =
                                              indices_of_field(*m_surface, directions, prescribed, m_request.length,
                                                               m_options, m_visitor);
                                            result.field_seconds += field_timer.time();
                                            return index;
                                          });
      unmet = guides.unmet;
      if(!guides.refusal.empty())
      {
        fail(Status::REFUSED, guides.refusal);
        return false;
      }
    }
    if(m_request.has_curves)
      directions.is_node = Curve_nodes::find(*m_surface);
    directions.has_releasable_curves = m_request.has_curves && !m_request.has_features;
    quads = search_component(
      *m_surface, directions,
      { m_options, m_request.length, feature_length, m_request.requested_quads, m_request.number_of_quads }, m_visitor,
      result);
    if(quads)
    {
      const std::string others = report_other_irregular_vertices(*m_surface, wishes.indices, directions.index);
      if(!others.empty())
        unmet.push_back(others);
      m_smoothing.fix_vertices(*quads, directions);
      m_smoothing.keep_directions(directions);
      m_work.move_to_input(*quads);
    }
    return quads != nullptr;
  }

  // Before there is a mesh.
  bool stop_early(const std::string& message)
  {
    if(m_visitor.is_stopped())
      fail(Status::STOPPED, message);
    else
      fail(Status::OUT_OF_TIME, "The time was up before there was a mesh.");
    return false;
  }

  void fail(Status status, const std::string& message)
  {
    result.status = status;
    result.message = message;
  }

  void stop(const std::string& message)
  {
    quads.reset();
    fail(Status::STOPPED, message);
  }

  void smooth()
  {
    Real_timer timer;
    timer.start();
    const Quad_mesh_smoothing_result smoothing = m_smoothing(*quads);
    result.smoothing_seconds = timer.time();
    if(m_visitor.is_stopped())
      return stop(smoothing.message);
    result.folded_quads = smoothing.folded_quads_after;
    if(!smoothing.flat_corners.empty())
      unmet.push_back(Component_smoothing::message_of_flat_corners(quads->mesh, smoothing.flat_corners));
    locate_vertices(m_surface->mesh, *quads);
  }

  // Its last step is the smoothing.
  void optimize()
  {
    Real_timer timer;
    timer.start();
    Structure_options structure;
    structure.is_layout_wanted = m_options.semi_regular;
    const Quad_structure_optimization_result optimization = optimize_quad_structure_with(
      quads->mesh,
      parameters::smoothing_iterations(m_options.smoothing_iterations)
        .edge_is_constrained_map(quads->is_feature)
        .visitor(std::ref(m_visitor)),
      [&](const Indexed_quad_mesh& m)
      {
        return Smoothing_reference(
          m, m_smoothing.reference(parameters::edge_is_constrained_map(m_work.input().is_feature)));
      },
      structure);
    quads->mesh.collect_garbage();
    result.structure_seconds = timer.time();
    if(m_visitor.is_stopped())
      return stop(optimization.message);
    result.quads = quads->mesh.number_of_faces();
    result.irregular_vertices = optimization.structure_after.number_of_irregular_vertices;
    result.folded_quads = optimization.smoothing.quality_after.number_of_inverted_quads;
    locate_vertices(m_surface->mesh, *quads);
  }

  // Quads along the base complex, on the input, smoothed there. They replace the others unless more of them are
  // inverted.
  void make_semi_regular()
  {
    Real_timer timer;
    timer.start();
    const std::shared_ptr<Quadrangulation_quads> regular = std::make_shared<Quadrangulation_quads>();
    const double target = m_request.requested_quads > 0 ? m_request.requested_quads : double(result.quads);
    const Layout_quadrangulation_result made = quadrangulate_layout(
      m_work.input().mesh,
      layout_from_base_complex(quads->mesh, parameters::edge_is_constrained_map(quads->is_feature)), regular->mesh,
      parameters::target_number_of_quads(target)
        .edge_is_constrained_map(m_work.input().is_feature)
        .visitor(std::ref(m_visitor)),
      parameters::edge_is_constrained_map(regular->is_feature));
    result.layout_seconds = timer.time();
    if(m_visitor.is_stopped())
      return stop(made.message);
    if(!made.is_valid())
    {
      result.not_semi_regular_components = 1;
      return;
    }
    const std::shared_ptr<Quadrangulation_quads> before = quads;
    const std::size_t folded_before = result.folded_quads;
    quads = regular;
    result.folded_quads = made.inverted_quads;
    m_smoothing.fix_nothing(*quads);
    if(m_options.smoothing_iterations != 0 && !m_visitor.is_time_up())
      smooth();
    else
      locate_vertices(m_surface->mesh, *quads);
    if(result.status == Status::STOPPED)
      return;
    if(quad_mesh_quality(quads->mesh).number_of_inverted_quads >
       quad_mesh_quality(before->mesh).number_of_inverted_quads)
    {
      quads = before;
      result.folded_quads = folded_before;
      result.not_semi_regular_components = 1;
      return;
    }
    result.quads = made.quads;
  }

  // The last word: a mesh is valid if it is what the caller asked for, whatever the stages think.
  void check()
  {
    std::string flips;
    if(result.flipped_triangles != 0)
      flips = " (" + std::to_string(result.flipped_triangles) + " triangles of the map are folded over)";
    const std::string found = defects();
    if(result.status == Status::NOT_VALID)
      result.message += flips;
    else if(!found.empty())
      fail(Status::NOT_VALID, found + flips + ".");
    else if(surface_topology(quads->mesh) != m_topology)
      fail(Status::NOT_VALID, "The topology of the quad mesh is not that of the input" + flips + ".");
    else
      fail(Status::VALID, "");
  }

  // What keeps the result from being a pure quad mesh for somebody who reads it as points and polygons.
  std::string defects() const
  {
    std::vector<Quadrangulation_kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> polygons;
    Polygon_mesh_processing::polygon_mesh_to_polygon_soup(quads->mesh, points, polygons);
    std::string list;
    for(const std::string& reason : find_quad_mesh_defects(points, polygons).reasons())
      list += (list.empty() ? "" : ", ") + reason;
    return list;
  }

  std::unique_ptr<Quadrangulation_surface>& m_surface; // that is worked on
  Working_surface m_work;
  const Component_request m_request;
  const std::vector<std::optional<Quadrangulation_kernel::Vector_3>>& m_directions;
  const Quadrangulation_options& m_options;
  Pipeline_visitor& m_visitor;
  const std::vector<Component_topology> m_topology;
  Component_smoothing m_smoothing;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_QUADRANGULATION_H
