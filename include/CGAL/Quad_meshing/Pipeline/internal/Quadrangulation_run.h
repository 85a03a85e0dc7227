// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUADRANGULATION_RUN_H
#define CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUADRANGULATION_RUN_H

#include <CGAL/Quad_meshing/Pipeline/internal/Component_quadrangulation.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Guide_report.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Junction_finisher.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Placed_guides.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Size_plan.h>
#include <CGAL/Quad_meshing/Pipeline/internal/Surface_components.h>
#include <CGAL/Quad_meshing/Pipeline/internal/add_figures.h>
#include <CGAL/Quad_meshing/Pipeline/internal/find_request_problem.h>
#include <CGAL/Quad_meshing/Pipeline/internal/result_message.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// A quadrangulation of all components.
class Quadrangulation_run
{
  typedef Quadrangulation_mesh Mesh;
  typedef Quadrangulation_status Status;

public:
  // `copies`: how many times the quads are there in the end, with their mirror images.
  Quadrangulation_run(const Triangle_input& input, const Quadrangulation_options& options, Any_visitor& visitor,
                      std::size_t copies = 1)
    : m_junctions(options.meet_at_junctions ? Junctions(input) : Junctions())
    , m_marked_input(m_junctions.curves.empty() ? nullptr : std::make_unique<Triangle_input>(input))
    , m_input(m_marked_input ? *m_marked_input : input)
    , m_options(options)
    , m_copies(copies)
    , m_names(options)
    , m_visitor(visitor, options.maximum_running_time)
  {
    if(m_marked_input)
      m_junctions.mark_sides(*m_marked_input);
  }

  Quadrangulation_result run(std::unique_ptr<Quadrangulation_surface>& surface,
                             std::unique_ptr<Quadrangulation_quads>& quads)
  {
    Real_timer timer;
    timer.start();
    surface = std::make_unique<Quadrangulation_surface>();
    quads = std::make_unique<Quadrangulation_quads>();
    m_result.input_faces = m_input.triangles.size();
    const std::string problem = find_request_problem(m_input, m_options, m_names);
    if(problem.empty() ? find_components(m_input) && place_guides() && choose_lengths() : refuse(problem))
    {
      quadrangulate_components();
      find_invalid_components();
      join(surface, quads);
      meet_at_junctions(*surface, quads);
      report_guides(*quads);
      conclude(*quads);
    }
    m_result.total_seconds = timer.time();
    return m_result;
  }

private:
  bool refuse(const std::string& message)
  {
    m_result.status = Status::INVALID_INPUT;
    m_result.message = message;
    return false;
  }

  // The edges inside of the surface that the user has marked to be followed, all as one curve. Both triangles at an
  // edge name it.
  void find_marked_edges()
  {
    m_marked.name = "the edges that were marked as curves";
    std::set<std::pair<int, int>> sides;
    for(std::size_t f = 0; f < m_input.is_curve.size(); ++f)
      for(int k = 0; k < 3; ++k)
        if(m_input.is_curve[f][k] != 0)
        {
          const int a = m_input.triangles[f][k], b = m_input.triangles[f][(k + 1) % 3];
          if(sides.count({ b, a }) != 0)
            m_marked.pieces.push_back({ m_input.points[a], m_input.points[b], NULL_VECTOR });
          sides.insert({ a, b });
        }
  }

  static double weight_of(const Guide_curve&) { return 0; } // it is no stroke
  static double weight_of(const Guide_stroke& s) { return s.weight; }

  // Guides are put onto the surface as it was given; then it is cut along the curves.
  bool place_guides()
  {
    find_marked_edges();
    if(m_options.feature_curves.empty() && m_options.strokes.empty() && m_options.index_guides.empty() &&
       m_options.connections.empty())
      return true;
    std::vector<Placed_curve> cuts;
    {
      const Guide_placer placer(m_surfaces, m_input);
      auto place = [&](const auto& guides, const char* kind, std::vector<Placed_curve>& placed)
      {
        for(std::size_t i = 0; i < guides.size(); ++i)
        {
          Placed_curve c;
          c.name = guide_name(guides[i], kind, i);
          c.weight = weight_of(guides[i]);
          const std::string problem = placer.place(guides[i], c);
          if(problem.empty())
            placed.push_back(c);
          else
            m_result.unmet_guides.push_back(problem);
        }
      };
      place(m_options.feature_curves, "curve", m_curves);
      place(m_options.strokes, "stroke", m_strokes);
      for(std::size_t i = 0; i < m_options.index_guides.size(); ++i)
        m_indices.push_back({ &m_options.index_guides[i], guide_name(m_options.index_guides[i], "index", i),
                              placer.place(m_options.index_guides[i].point) });
      cuts = m_curves;
      for(std::size_t i = 0; i < m_options.connections.size(); ++i)
      {
        const Guide_connection& c = m_options.connections[i];
        Guide_curve path;
        path.points = { c.from, c.to };
        Placed_curve placed;
        placed.name = guide_name(c, "connection", i);
        const std::string problem = placer.place(path, placed);
        if(!problem.empty())
        {
          m_result.unmet_guides.push_back(problem);
          continue;
        }
        m_connections.push_back({ placed.name, placer.place(c.from), placer.place(c.to) });
        cuts.push_back(placed);
      }
    }
    if(cuts.empty())
      return true;
    std::string error;
    m_cut = std::make_unique<Triangle_input>(cut_input(m_input, cuts, error));
    if(!error.empty())
      return refuse(error);
    m_surfaces.clear();
    return find_components(*m_cut);
  }

  // The triangles that are worked on.
  const Triangle_input& triangles() const { return m_cut ? *m_cut : m_input; }

  // The number in the input of one of them.
  std::size_t input_number(std::size_t triangle) const { return m_cut ? m_cut->original(triangle) : triangle; }

  bool asks_for_number() const { return m_options.target_edge_length == 0; }

  bool find_components(const Triangle_input& input)
  {
    Surface_components components(input, m_names);
    if(!components.error.empty())
      return refuse(components.error);
    m_surfaces = std::move(components.surfaces);
    m_result.components = m_surfaces.size();
    m_result.divided_vertices = components.number_of_divided_vertices;
    return true;
  }

  // All components get quads of one size. Where several are asked for together, one that is too small for a mesh of
  // such quads gets smaller ones.
  bool choose_lengths()
  {
    double area = 0;
    std::vector<double> areas;
    Bbox_3 box;
    for(const auto& s : m_surfaces)
    {
      areas.push_back(Polygon_mesh_processing::area(s->mesh));
      area += areas.back();
      for(Mesh::Vertex_index v : s->mesh.vertices())
        box += s->mesh.point(v).bbox();
    }
    if(!(area > 0))
      return refuse("The mesh has no area.");
    const double length =
      asks_for_number() ? std::sqrt(area / m_options.target_number_of_quads) : m_options.target_edge_length;
    const double most_quads =
      5e7; // vertices and faces of a mesh are numbered by 32 bits, halfedges in four times as many places
    if(area / (length * length) > most_quads)
      return refuse(asks_for_number() ? "More than 50 million quads are asked for."
                                      : "The target edge length asks for more than 50 million quads.");
    const double diagonal = std::sqrt(square(box.x_span()) + square(box.y_span()) + square(box.z_span()));
    if(length > diagonal)
      return refuse(asks_for_number() ? "The quads that are asked for are so few that one is larger than the model."
                                      : "The target edge length is larger than the model.");
    m_result.target_edge_length = length;
    std::vector<double> lengths(areas.size(), length); // on average
    const bool is_graded = Size_plan::is_needed(m_input, m_options);
    m_keeps_number = asks_for_number();
    if(is_graded)
    {
      Size_plan plan(
        m_surfaces, m_input, [&](std::size_t i) { return input_number(i); }, m_options, length);
      if(!plan.run(asks_for_number() ? m_options.target_number_of_quads : 0, area, m_visitor))
      {
        m_result.status = m_visitor.is_stopped() ? Status::STOPPED : Status::OUT_OF_TIME;
        m_result.message = m_visitor.is_stopped() ? "The visitor stopped the quadrangulation."
                                                  : "The time was up before there was a mesh.";
        return false;
      }
      m_keeps_number = asks_for_number() && !plan.is_absolute();
      double quads = 0;
      for(std::size_t i = 0; i < areas.size(); ++i)
      {
        lengths[i] = areas[i] > 0 ? std::sqrt(areas[i] / plan.quads[i]) : length;
        quads += plan.quads[i];
      }
      if(quads > most_quads)
        return refuse("The edge lengths ask for more than 50 million quads.");
    }
    for(std::size_t i = 0; i < areas.size(); ++i)
    {
      Component_request request;
      request.has_features = m_input.has_features();
      request.has_curves = !m_curves.empty() || !m_connections.empty() || !m_marked.pieces.empty();
      request.length = edge_length_of_component(areas[i], lengths[i], m_surfaces.size());
      request.is_graded = is_graded;
      request.number_of_quads = areas[i] / (request.length * request.length);
      request.requested_quads = m_keeps_number ? request.number_of_quads : 0;
      m_result.refined_components += request.length < lengths[i];
      for(Mesh::Face_index f : m_surfaces[i]->mesh.faces())
        m_surfaces[i]->length[f] =
          is_graded ? m_surfaces[i]->length[f] * (request.length / lengths[i]) : request.length;
      m_requests.push_back(request);
    }
    for(const Placed_curve& s : m_strokes)
      m_requests[s.component].wishes.strokes.push_back(&s);
    for(const Component_wishes::Index_wish& w : m_indices)
      m_requests[w.place.component].wishes.indices.push_back(w);
    for(const Placed_connection& c : m_connections)
      m_requests[c.from.component].wishes.connections.push_back(&c);
    return true;
  }

  void quadrangulate_components()
  {
    // A component alone has all threads for its map; several share them.
    Quadrangulation_options options = m_options;
    const std::size_t workers = (std::min)(std::size_t(m_options.number_of_threads), m_surfaces.size());
    if(workers > 1)
      options.number_of_threads = 1;
    for(std::size_t i = 0; i < m_surfaces.size(); ++i)
      m_components.push_back(std::make_unique<Component_quadrangulation>(m_surfaces[i], m_requests[i],
                                                                         triangles().directions, options, m_visitor));
    std::atomic<std::size_t> next(0);
    auto work = [&]
    {
      for(std::size_t i; (i = next++) < m_components.size();)
        m_components[i]->run();
    };
    std::vector<std::thread> others;
    for(std::size_t t = 1; t < workers; ++t)
      others.emplace_back(work);
    work();
    for(std::thread& t : others)
      t.join();
  }

  void join(std::unique_ptr<Quadrangulation_surface>& surface, std::unique_ptr<Quadrangulation_quads>& quads)
  {
    if(m_visitor.is_stopped())
      return;
    for(std::size_t i = 0; i < m_components.size(); ++i)
    {
      const std::size_t first_face = surface->mesh.number_of_faces();
      if(m_components.size() == 1)
        surface = std::move(m_surfaces.front());
      else
      {
        surface->mesh += m_surfaces[i]->mesh; // with its maps, that have the same names
        surface->t_meshes.insert(surface->t_meshes.end(), m_surfaces[i]->t_meshes.begin(),
                                 m_surfaces[i]->t_meshes.end());
      }
      if(m_components[i]->quads)
        append(*m_components[i]->quads, first_face, *quads);
    }
    if(!m_cut)
      return;
    for(Mesh::Face_index f : surface->mesh.faces())
      surface->origin[f] = m_cut->original(surface->origin[f]);
    for(Mesh::Vertex_index v : quads->mesh.vertices())
      quads->input_face[v] = m_cut->original(quads->input_face[v]);
  }

  void meet_at_junctions(const Quadrangulation_surface& surface, std::unique_ptr<Quadrangulation_quads>& quads)
  {
    if(m_junctions.curves.empty() || m_visitor.is_stopped() || quads->mesh.number_of_faces() == 0 ||
       !is_quad_mesh(quads->mesh))
      return;
    const Junction_finisher finisher(m_input, m_junctions, surface, m_result.target_edge_length,
                                     m_options.smoothing_iterations, quads);
    if(!finisher.unmet.empty())
      m_result.unmet_guides.push_back(finisher.unmet);
  }

  // What became of the guides, seen from the mesh.
  void report_guides(const Quadrangulation_quads& quads)
  {
    for(const auto& c : m_components)
      m_result.unmet_guides.insert(m_result.unmet_guides.end(), c->unmet.begin(), c->unmet.end());
    if(quads.mesh.number_of_faces() == 0 ||
       (m_curves.empty() && m_marked.pieces.empty() && m_strokes.empty() && m_indices.empty() && m_connections.empty()))
      return;
    const Guide_report report(quads.mesh);
    auto add = [&](const std::string& sentence)
    {
      if(!sentence.empty())
        m_result.unmet_guides.push_back(sentence);
    };
    for(const Placed_curve& c : m_curves)
      add(report.of_curve(c));
    if(!m_marked.pieces.empty())
      add(report.of_curve(m_marked));
    for(const Placed_curve& s : m_strokes)
      add(report.of_stroke(s));
    for(const Component_wishes::Index_wish& w : m_indices)
      add(report.of_index(w));
    for(const Placed_connection& c : m_connections)
      add(report.of_connection(c));
  }

  static void append(Quadrangulation_quads& part, std::size_t first_face, Quadrangulation_quads& quads)
  {
    for(Mesh::Vertex_index v : part.mesh.vertices())
      part.location[v].first = Mesh::Face_index(static_cast<Mesh::size_type>(part.location[v].first + first_face));
    quads.mesh += part.mesh;
  }

  void conclude(const Quadrangulation_quads& quads)
  {
    double feature_length = 0, released_length = 0;
    bool is_for_other_length = false;
    double relative_length = 1;
    for(std::size_t i = 0; i < m_components.size(); ++i)
    {
      const Quadrangulation_result& r = m_components[i]->result;
      add_figures(r, m_result);
      m_result.failed_components += !m_components[i]->quads;
      feature_length += m_components[i]->feature_length;
      released_length += r.released_feature_share * m_components[i]->feature_length;
      if(!asks_for_number() && r.is_valid() && r.target_edge_length != m_requests[i].length)
      {
        is_for_other_length = true;
        relative_length = r.target_edge_length / m_requests[i].length;
      }
    }
    if(!m_junctions.curves.empty())
    {
      m_result.quads = quads.mesh.number_of_faces();
      m_result.folded_quads = quad_mesh_quality(quads.mesh).number_of_inverted_quads;
    }
    m_result.released_feature_share = feature_length > 0 ? released_length / feature_length : 0;
    if(m_components.size() == 1 && m_components.front()->quads)
      m_result.target_edge_length = m_components.front()->result.target_edge_length;
    if(m_visitor.is_stopped())
    {
      m_result.status = Status::STOPPED;
      m_result.message = "The visitor stopped the quadrangulation.";
      m_result.quads = 0;
      return;
    }
    if(m_result.invalid_components.empty())
    {
      m_result.status = Status::VALID;
      m_result.message = "A pure quad mesh with the topology of the input";
      if(is_for_other_length)
        m_result.message += m_components.size() == 1
                              ? ", for edges of length " + std::to_string(relative_length) + " times the one asked for"
                              : ", some components for edges of another length than asked for";
    }
    else if(m_components.size() == 1)
    {
      m_result.status = m_components.front()->result.status;
      m_result.message = without_period(m_components.front()->result.message);
    }
    else
    {
      m_result.status = quads.mesh.number_of_faces() > 0 ? Status::NOT_VALID : m_components.front()->result.status;
      m_result.message = names_of_invalid_components(m_result, m_names);
    }
    const std::string given_up = remarks(m_result, m_options, { m_keeps_number, m_visitor.is_time_up(), m_copies });
    m_result.is_as_requested = m_result.is_valid() && !is_for_other_length && given_up.empty();
    m_result.message += given_up + ".";
  }

  void find_invalid_components()
  {
    if(m_visitor.is_stopped())
      return;
    for(std::size_t i = 0; i < m_components.size(); ++i)
    {
      const Quadrangulation_result& r = m_components[i]->result;
      if(r.is_valid())
        continue;
      m_result.invalid_components.push_back({ input_number(m_components[i]->first_input_face), r.status, r.message });
    }
  }

  Junctions m_junctions;                                // where sheets are to meet; none if that is not asked for
  const std::unique_ptr<Triangle_input> m_marked_input; // the input with these as curves; null if there are none
  const Triangle_input& m_input;
  const Quadrangulation_options& m_options;
  const std::size_t m_copies;
  const Element_names m_names;
  Pipeline_visitor m_visitor;
  Quadrangulation_result m_result;
  std::vector<std::unique_ptr<Quadrangulation_surface>> m_surfaces;
  std::vector<Component_request> m_requests;
  bool m_keeps_number = true; // the number of quads is asked for, and nothing that is more important than it
  std::vector<Placed_curve> m_curves, m_strokes;
  Placed_curve m_marked; // edges of the input
  std::vector<Placed_connection> m_connections;
  std::vector<Component_wishes::Index_wish> m_indices;
  std::unique_ptr<Triangle_input> m_cut; // along the curves; null if there are none
  std::vector<std::unique_ptr<Component_quadrangulation>> m_components;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_PIPELINE_INTERNAL_QUADRANGULATION_RUN_H
