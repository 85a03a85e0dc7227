// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_QUADRANGULATION_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_QUADRANGULATION_H

#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Layout/layout_from_quad_mesh.h>
#include <CGAL/Quad_meshing/Layout/quadrangulate_layout.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Component_guides.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Curve_nodes.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Working_surface.h>
#include <CGAL/Quad_meshing/Pipeline/internal/search_component.h>
#include <CGAL/Quad_meshing/Pipeline/smoothing_directions.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>
#include <CGAL/Quad_meshing/Structure/optimize_quad_structure.h>
#include <CGAL/Quad_meshing/internal/Indexed_reference.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>
#include <CGAL/Quad_meshing/internal/surface_topology.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What one component is asked for.
struct Component_request
{
  double length = 0;          // of a quad edge, in the unit of the points; on average, if it differs
  bool is_graded = false;     // the lengths on the surface are not all the same
  double requested_quads = 0; // 0: an edge length was asked for
  double number_of_quads = 0; // that the length stands for
  bool has_features = false;  // marked by the user: none are detected, none are released
  bool has_curves = false;    // of the user: those of its feature edges that are kept have nodes
  Component_wishes wishes;    // of the user
};

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

  // The weight, at full alignment, of a squared deviation from a reliable direction of curvature over the area of one
  // quad, against a squared difference between two triangles. What a heavier weight adds to the singularities, their
  // cost takes away again: at 4000 quads on spot, 12.2 degrees from the directions and 80 irregular vertices with 1 and
  // no cost, 12.1 and 76 with 2 and a cost of 0.5, 14.3 and 64 with 3 and a cost of 1.
  static constexpr double weight_of_alignment = 2;

  bool prepare()
  {
    find_features();
    const Kept_features kept(*m_surface);
    if(!m_options.work_on_input)
    {
      const std::string stopped = m_work.make(m_request.length, m_visitor);
      if(!stopped.empty())
        return stop_early(stopped);
    }
    // In target edge lengths. A map is linear on a triangle; a few triangles per quad let it bend.
    const double longest_edge = 1.5;
    double shortest_length = m_request.length;
    if(m_request.is_graded)
      for(Mesh::Face_index f : m_surface->mesh.faces())
        shortest_length = (std::min)(shortest_length, m_surface->length[f]);
    // A working mesh has no edge that is longer for its place.
    split_for_alignment(m_surface->mesh, m_surface->mesh.points(), m_surface->is_feature, m_options.align_boundary,
                        Inherited_values{ m_surface.get() },
                        m_request.is_graded && !m_options.work_on_input ? 0 : longest_edge * shortest_length);
    const double rounding = 1e-6; // in target edge lengths
    kept.mark(*m_surface, (std::max)(m_work.largest_curve_error(), rounding * m_request.length));
    result.prepared_faces = m_surface->mesh.number_of_faces();
    return true;
  }

  // What a face inherits when it is split.
  struct Inherited_values
  {
    typedef Mesh::Face_index key_type;
    typedef std::pair<std::size_t, double> value_type;
    typedef value_type reference;
    typedef boost::read_write_property_map_tag category;

    Quadrangulation_surface* surface;

    friend value_type get(const Inherited_values& m, Mesh::Face_index f)
    {
      return value_type(m.surface->origin[f], m.surface->length[f]);
    }
    friend void put(const Inherited_values& m, Mesh::Face_index f, const value_type& value)
    {
      m.surface->origin[f] = value.first;
      m.surface->length[f] = value.second;
    }
  };

  void find_features()
  {
    const Mesh& mesh = m_surface->mesh;
    if(m_request.has_features)
    {
      for(Mesh::Edge_index e : mesh.edges())
        result.feature_edges += m_surface->is_feature[e];
    }
    else
    {
      const Feature_edges_result features =
        detect_feature_edges(mesh, m_options.sharpness_angle, m_request.length, m_surface->is_feature);
      result.feature_edges = features.number_of_edges;
      result.dropped_feature_edges = features.number_of_dropped_edges;
      feature_length = features.length;
      // Curves of the user besides.
      for(Mesh::Edge_index e : mesh.edges())
        if(m_surface->is_kept[e])
        {
          if(m_surface->is_feature[e])
            feature_length -= std::sqrt(squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
          m_surface->is_feature[e] = true;
        }
    }
  }

  bool make_quads()
  {
    Grid_map_search::Directions directions;
    if(!find_directions(directions))
      return false;
    const Component_wishes& wishes = m_request.wishes;
    if(!wishes.strokes.empty() || !wishes.indices.empty() || !wishes.connections.empty())
    {
      Component_guides guides(*m_surface, m_work.largest_distance());
      guides.follow_strokes(wishes.strokes, directions.direction, directions.weight, directions.importance);
      directions.is_loose = guides.loose_edges(wishes.connections);
      directions.index =
        guides.prescribe(wishes.indices, directions.is_loose,
                         [&](const auto& prescribed) { return indices_of_field(directions, prescribed); });
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
      report_others(directions.index);
      find_fixed_vertices(directions);
      keep_directions(directions);
      m_work.move_to_input(*quads);
    }
    return quads != nullptr;
  }

  // Irregular vertices where none but those of guides were wanted.
  void report_others(const std::vector<std::optional<int>>& prescribed)
  {
    for(const Component_wishes::Index_wish& w : m_request.wishes.indices)
      if(!w.guide->is_sum && std::isinf(w.guide->radius))
      {
        std::size_t others = 0;
        for(Mesh::Vertex_index v : m_surface->mesh.vertices())
          others += prescribed[v] && *prescribed[v] == 0 && m_surface->index[v] != 0;
        if(others > 0)
          unmet.push_back(std::to_string(others) + " irregular vertices are besides those that " + w.name + " allows");
        return;
      }
  }

  // The indices of the field that the search begins with, per vertex; none if there is no field.
  std::vector<int> indices_of_field(const Grid_map_search::Directions& directions,
                                    const std::vector<std::optional<int>>& prescribed)
  {
    const Mesh& mesh = m_surface->mesh;
    Real_timer timer;
    timer.start();
    std::vector<double> angle(mesh.number_of_faces());
    std::vector<int> jump(mesh.number_of_edges()), index(mesh.number_of_vertices());
    std::vector<char> is_feature;
    for(Mesh::Edge_index e : mesh.edges())
      is_feature.push_back(m_surface->is_feature[e]);
    is_feature = directions.constrained(is_feature);
    auto of_edges = [&](auto& values)
    { return boost::make_iterator_property_map(values.begin(), get(boost::edge_index, mesh)); };
    auto of_faces = [&](auto& values)
    { return boost::make_iterator_property_map(values.begin(), get(boost::face_index, mesh)); };
    auto of_vertices = [&](auto& values)
    { return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, mesh)); };
    const Cross_field_result r = smooth_cross_field(mesh, of_faces(angle), of_edges(jump), of_vertices(index),
                                                    parameters::target_edge_length(m_request.length)
                                                      .edge_is_constrained_map(of_edges(is_feature))
                                                      .align_boundary(m_options.align_boundary)
                                                      .cross_field_method(m_options.cross_field_method)
                                                      .face_direction_map(of_faces(directions.direction))
                                                      .face_direction_weight_map(of_faces(directions.weight))
                                                      .face_sizing_map(m_surface->length)
                                                      .prescribed_index_map(of_vertices(prescribed))
                                                      .visitor(std::ref(m_visitor)));
    result.field_seconds += timer.time();
    if(!r.is_valid() && r.status != Cross_field_status::EMPTY_SECTORS)
      index.clear();
    return index;
  }

  // Irregular vertices that the user has placed, and nodes of curves, stay where they are.
  void find_fixed_vertices(const Grid_map_search::Directions& d)
  {
    m_fixed.assign(quads->mesh.number_of_vertices(), 0);
    for(Mesh::Vertex_index v : m_surface->mesh.vertices())
    {
      const bool is_placed = !d.index.empty() && d.index[v] && *d.index[v] != 0 && m_surface->index[v] == *d.index[v];
      if(!is_placed && (d.is_node.empty() || !d.is_node[v]))
        continue;
      const auto is_nearer = [&](Mesh::Vertex_index a, Mesh::Vertex_index b)
      {
        return squared_distance(quads->mesh.point(a), m_surface->mesh.point(v)) <
               squared_distance(quads->mesh.point(b), m_surface->mesh.point(v));
      };
      m_fixed[*std::min_element(quads->mesh.vertices().begin(), quads->mesh.vertices().end(), is_nearer)] = 1;
    }
  }

  // What the smoothing is told: the directions of the field, and how much they count.
  void keep_directions(const Grid_map_search::Directions& d)
  {
    const Smoothing_directions directions = smoothing_directions(*m_surface, d.weight, d.importance);
    m_smoothed_directions = Indexed_directions();
    if(m_work.is_made())
      m_smoothed_directions.mesh = make_indexed_triangle_mesh(m_surface->mesh, parameters::default_values());
    m_smoothed_directions.weight = directions.weight;
    for(const auto& v : directions.direction)
      m_smoothed_directions.direction.push_back(Indexed_triangle_mesh::Vector_3(v->x(), v->y(), v->z()));
  }

  // The input, with these directions.
  template <typename NamedParameters>
  Indexed_reference smoothing_reference(const NamedParameters& np) const
  {
    Indexed_reference reference = make_indexed_reference<internal_np::face_sizing_map_t>(m_work.input().mesh, np);
    reference.directions = m_smoothed_directions;
    return reference;
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

  // Where lengths change, the field has to turn with them: directions of the surface count less, the steeper they do.
  double share_of_alignment(Mesh::Face_index f) const
  {
    if(!m_request.is_graded)
      return 1;
    const double half_slope = 0.05; // of the length, at which they count half
    const Mesh& mesh = m_surface->mesh;
    auto center = [&](Mesh::Face_index g)
    {
      const Mesh::Halfedge_index h = mesh.halfedge(g);
      return centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
    };
    double slope = 0;
    for(Mesh::Face_index g : mesh.faces_around_face(mesh.halfedge(f)))
      if(g != Mesh::null_face() && center(g) != center(f))
        slope = (std::max)(slope, std::abs(m_surface->length[g] - m_surface->length[f]) /
                                    std::sqrt(squared_distance(center(g), center(f))));
    return 1 / (1 + square(slope / half_slope));
  }

  // Those of the user are hard, those of the surface are soft.
  bool find_directions(Grid_map_search::Directions& directions)
  {
    const Mesh& mesh = m_surface->mesh;
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
        parameters::face_sizing_map(m_surface->length)
          .edge_is_constrained_map(m_surface->is_feature)
          .visitor(std::ref(m_visitor)));
      if(!guides.is_valid())
      {
        if(guides.status == Curvature_guide_status::STOPPED)
          return stop_early(guides.message);
        fail(Status::FAILED, guides.message);
        return false;
      }
    }
    for(Mesh::Face_index f : mesh.faces())
    {
      directions.weight[f] *= m_options.curvature_alignment * weight_of_alignment * share_of_alignment(f);
      if(!m_directions.empty() && m_directions[m_work.input_face(f)])
      {
        directions.direction[f] = m_directions[m_work.input_face(f)];
        directions.weight[f] = (std::numeric_limits<double>::infinity)();
      }
    }
    result.field_seconds = timer.time();
    return true;
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
    const auto of_quads = parameters::smooth_globally(true)
                            .edge_is_constrained_map(quads->is_feature)
                            .vertex_is_constrained_map(
                              boost::make_iterator_property_map(m_fixed.begin(), get(boost::vertex_index, quads->mesh)))
                            .smoothing_iterations(m_options.smoothing_iterations)
                            .visitor(std::ref(m_visitor));
    const Quadrangulation_surface& input = m_work.input();
    const Quad_mesh_smoothing_result smoothing = smooth_quad_mesh_with(
      quads->mesh, of_quads,
      [&](const Indexed_quad_mesh& m)
      {
        return Smoothing_reference(
          m,
          m_request.is_graded
            ? smoothing_reference(parameters::face_sizing_map(input.length).edge_is_constrained_map(input.is_feature))
            : smoothing_reference(parameters::edge_is_constrained_map(input.is_feature)));
      });
    result.smoothing_seconds = timer.time();
    if(m_visitor.is_stopped())
      return stop(smoothing.message);
    result.folded_quads = smoothing.folded_quads_after;
    if(!smoothing.flat_corners.empty())
      unmet.push_back(message_of_flat_corners(smoothing.flat_corners));
    locate_vertices();
  }

  std::string message_of_flat_corners(const std::vector<std::size_t>& corners) const
  {
    std::ostringstream message;
    message << "features meet at an angle of 0 or 180 degrees and leave a quad no room at "
            << (corners.size() == 1 ? "the corner " : std::to_string(corners.size()) + " corners, the first one ")
            << quads->mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(corners.front())));
    return message.str();
  }

  // Its last step is the smoothing.
  void optimize()
  {
    Real_timer timer;
    timer.start();
    const Quad_structure_optimization_result optimization =
      optimize_quad_structure(quads->mesh, m_work.input().mesh,
                              parameters::smoothing_iterations(m_options.smoothing_iterations)
                                .edge_is_constrained_map(quads->is_feature)
                                .visitor(std::ref(m_visitor)),
                              parameters::edge_is_constrained_map(m_work.input().is_feature));
    quads->mesh.collect_garbage();
    result.structure_seconds = timer.time();
    if(m_visitor.is_stopped())
      return stop(optimization.message);
    result.quads = quads->mesh.number_of_faces();
    result.irregular_vertices = optimization.structure_after.number_of_irregular_vertices;
    result.folded_quads = optimization.smoothing.quality_after.number_of_inverted_quads;
    locate_vertices();
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
    m_fixed.assign(quads->mesh.number_of_vertices(), 0);
    if(m_options.smoothing_iterations != 0 && !m_visitor.is_time_up())
      smooth();
    else
      locate_vertices();
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

  // Vertices that have moved, or that the extraction did not make, lie at the nearest place of the triangles of the
  // work.
  void locate_vertices()
  {
    typedef AABB_face_graph_triangle_primitive<Mesh> Primitive;
    typedef AABB_tree<Aabb_traits<Quadrangulation_kernel, Primitive>> Tree;
    const Mesh& mesh = m_surface->mesh;
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

  std::unique_ptr<Quadrangulation_surface>& m_surface; // that is worked on
  Working_surface m_work;
  const Component_request m_request;
  const std::vector<std::optional<Quadrangulation_kernel::Vector_3>>& m_directions;
  const Quadrangulation_options& m_options;
  Pipeline_visitor& m_visitor;
  const std::vector<Component_topology> m_topology;
  std::vector<char> m_fixed;                // per vertex of the quads: it stays where it is
  Indexed_directions m_smoothed_directions; // for the smoothing
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_COMPONENT_QUADRANGULATION_H
