// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_QUADRANGULATION_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_QUADRANGULATION_H

#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Grid_map_search.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/optimize_quad_structure.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>
#include <CGAL/Quad_meshing/internal/surface_topology.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What one component is asked for.
struct Component_request
{
  double length = 0;          // of a quad edge, in the unit of the points
  double requested_quads = 0; // 0: an edge length was asked for
  double number_of_quads = 0; // that the length stands for
  bool has_features = false;  // marked by the user: none are detected, none are released
};

// The stages of a quadrangulation on one component.
class Component_quadrangulation
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_status Status;

public:
  // directions: per face of the input, or empty
  Component_quadrangulation(Quadrangulation_surface& surface, const Component_request& request,
                            const std::vector<std::optional<Quadrangulation_kernel::Vector_3>>& directions,
                            const Quadrangulation_options& options, Pipeline_visitor& visitor)
    : m_surface(surface)
    , m_request(request)
    , m_directions(directions)
    , m_options(options)
    , m_visitor(visitor)
    , m_topology(surface_topology(surface.mesh))
  {
  }

  Quadrangulation_result result;
  std::shared_ptr<Quadrangulation_quads> quads; // null: there are none
  double feature_length = 0;                    // of the feature edges that may be released

  void run()
  {
    prepare();
    if(!make_quads())
      return;
    if(result.status == Status::VALID && result.other_faces == 0 && !m_visitor.is_time_up())
    {
      if(m_options.optimize_structure)
        optimize();
      else if(m_options.smoothing_iterations != 0)
        smooth();
    }
    if(result.status != Status::STOPPED)
      check();
  }

  // Makes quads by the plans of the options. Returns whether there are any.
  bool search(const Grid_map_search::Directions& directions)
  {
    Grid_map_search search(
      m_surface, directions,
      { m_options, m_request.length, feature_length, m_request.requested_quads, m_request.number_of_quads }, m_visitor);
    const std::shared_ptr<const Grid_map_attempt> attempt = search.run();
    result.field_seconds += search.figures.field_seconds;
    result.parameterization_seconds = search.figures.parameterization_seconds;
    result.parameterization_attempts = search.figures.parameterization_attempts;
    result.extraction_seconds = search.figures.extraction_seconds;
    if(attempt)
    {
      take(*attempt);
      return true;
    }
    result.singularities = search.figures.singularities;
    result.released_feature_share = search.figures.released_feature_share;
    fail(search.status, search.message);
    return false;
  }

private:
  // The weight, at full alignment, of a squared deviation from a reliable direction of curvature over the area of one
  // quad, against a squared difference between two triangles. From 0.03 to 3, directions get nearer to those of the
  // surface and singularities more: on a rocker arm at 4000 quads 9.6 degrees and 18 with 0.1, 8.2 and 32 with 1, 7.7
  // and 46 with 3.
  static constexpr double weight_of_alignment = 1;

  void prepare()
  {
    Mesh& mesh = m_surface.mesh;
    if(m_request.has_features)
    {
      for(Mesh::Edge_index e : mesh.edges())
        result.feature_edges += m_surface.is_feature[e];
    }
    else
    {
      const Feature_edges_result features =
        detect_feature_edges(mesh, m_options.sharpness_angle, m_request.length, m_surface.is_feature);
      result.feature_edges = features.number_of_edges;
      result.dropped_feature_edges = features.number_of_dropped_edges;
      feature_length = features.length;
    }
    // In target edge lengths. A map is linear on a triangle; a few triangles per quad let it bend.
    const double longest_edge = 1.5;
    split_for_alignment(mesh, mesh.points(), m_surface.is_feature, m_options.align_boundary, m_surface.origin,
                        longest_edge * m_request.length);
    result.prepared_faces = mesh.number_of_faces();
  }

  bool make_quads()
  {
    Grid_map_search::Directions directions;
    return find_directions(directions) && search(directions);
  }

  // Those of the user are hard, those of the surface are soft.
  bool find_directions(Grid_map_search::Directions& directions)
  {
    const Mesh& mesh = m_surface.mesh;
    Real_timer timer;
    timer.start();
    directions.direction.resize(mesh.number_of_faces());
    directions.weight.resize(mesh.number_of_faces(), 0.);
    if(m_options.curvature_alignment > 0)
    {
      const Curvature_guide_result guides = curvature_directions(
        mesh, m_request.length,
        boost::make_iterator_property_map(directions.direction.begin(), get(boost::face_index, mesh)),
        boost::make_iterator_property_map(directions.weight.begin(), get(boost::face_index, mesh)),
        parameters::edge_is_constrained_map(m_surface.is_feature).visitor(std::ref(m_visitor)));
      if(!guides.is_valid())
      {
        if(m_visitor.is_stopped())
          fail(Status::STOPPED, guides.message);
        else if(guides.status == Curvature_guide_status::STOPPED)
          fail(Status::OUT_OF_TIME, "The time was up before there was a mesh.");
        else
          fail(Status::FAILED, guides.message);
        return false;
      }
    }
    for(Mesh::Face_index f : mesh.faces())
    {
      directions.weight[f] *= m_options.curvature_alignment * weight_of_alignment;
      if(!m_directions.empty() && m_directions[m_surface.origin[f]])
      {
        directions.direction[f] = m_directions[m_surface.origin[f]];
        directions.weight[f] = (std::numeric_limits<double>::infinity)();
      }
    }
    result.field_seconds = timer.time();
    return true;
  }

  void take(const Grid_map_attempt& attempt)
  {
    const Field_attempt& field = *attempt.field;
    assign(m_surface.mesh.edges(), field.is_feature, m_surface.is_feature);
    assign(m_surface.mesh.faces(), field.angle, m_surface.angle);
    assign(m_surface.mesh.edges(), field.period_jump, m_surface.period_jump);
    assign(m_surface.mesh.vertices(), field.index, m_surface.index);
    assign(m_surface.mesh.halfedges(), attempt.uv, m_surface.uv);
    quads = attempt.quads;
    result.released_feature_share = feature_length > 0 ? field.released_length / feature_length : 0;
    result.singularities = field.singularities;
    result.field_integers = field.integers;
    result.field_energy = field.energy;
    result.target_edge_length = attempt.relative_length * m_request.length;
    result.parameterization_integers = attempt.integers;
    result.parameterization_energy = attempt.energy;
    result.relaxed_parameterization_energy = attempt.relaxed_energy;
    result.flipped_triangles = attempt.folded.size();
    result.quads = quads->mesh.number_of_faces() - attempt.other_faces;
    result.other_faces = attempt.other_faces;
    result.irregular_vertices = attempt.irregular_vertices;
    result.message = attempt.message;
    result.status = attempt.is_simple ? Status::VALID : Status::NOT_VALID;
  }

  template <typename Range, typename T, typename Map>
  static void assign(const Range& range, const std::vector<T>& values, Map map)
  {
    std::size_t i = 0;
    for(auto x : range)
      map[x] = values[i++];
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
    const Quad_mesh_smoothing_result smoothing =
      smooth_quad_mesh(quads->mesh, m_surface.mesh,
                       parameters::smooth_globally(true)
                         .edge_is_constrained_map(quads->is_feature)
                         .smoothing_iterations(m_options.smoothing_iterations)
                         .visitor(std::ref(m_visitor)),
                       parameters::edge_is_constrained_map(m_surface.is_feature));
    result.smoothing_seconds = timer.time();
    if(m_visitor.is_stopped())
      return stop(smoothing.message);
    result.folded_quads = smoothing.folded_quads_after;
    locate_vertices();
  }

  // Its last step is the smoothing.
  void optimize()
  {
    Real_timer timer;
    timer.start();
    const Quad_structure_optimization_result optimization =
      optimize_quad_structure(quads->mesh, m_surface.mesh,
                              parameters::smoothing_iterations(m_options.smoothing_iterations)
                                .edge_is_constrained_map(quads->is_feature)
                                .visitor(std::ref(m_visitor)),
                              parameters::edge_is_constrained_map(m_surface.is_feature));
    quads->mesh.collect_garbage();
    result.structure_seconds = timer.time();
    if(m_visitor.is_stopped())
      return stop(optimization.message);
    result.quads = quads->mesh.number_of_faces();
    result.irregular_vertices = optimization.structure_after.number_of_irregular_vertices;
    result.folded_quads = optimization.smoothing.quality_after.number_of_inverted_quads;
    locate_vertices();
  }

  // Vertices that have moved, or that the extraction did not make, lie at the nearest place of the triangle mesh.
  void locate_vertices()
  {
    typedef AABB_face_graph_triangle_primitive<Mesh> Primitive;
    typedef AABB_tree<Aabb_traits<Quadrangulation_kernel, Primitive>> Tree;
    const Mesh& mesh = m_surface.mesh;
    const Tree tree(faces(mesh).first, faces(mesh).second, mesh);
    for(Mesh::Vertex_index v : quads->mesh.vertices())
      quads->location[v] = Polygon_mesh_processing::locate_with_AABB_tree(quads->mesh.point(v), tree, mesh);
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

  Quadrangulation_surface& m_surface;
  const Component_request m_request;
  const std::vector<std::optional<Quadrangulation_kernel::Vector_3>>& m_directions;
  const Quadrangulation_options& m_options;
  Pipeline_visitor& m_visitor;
  const std::vector<Component_topology> m_topology;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_QUADRANGULATION_H
