// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Makes the base complex of a quad mesh coarser, and smooths the mesh.

#include "command_line.h"
#include "quad_mesh_files.h"
#include "scene_files.h"

#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Pipeline/quadrangulation_layers.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Structure/optimize_quad_structure.h>
#include <CGAL/Quad_meshing/internal/compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

// Marks the edges of a quad mesh that follow marked edges of its reference. An edge is a chord of what it follows, so
// its inner points may lie farther away than its ends.
template <typename SharpEdges>
void mark_edges_on_reference(const Mesh& qm, const Mesh& tm, const SharpEdges& is_sharp_in_reference,
                             SharpEdges is_sharp)
{
  // Distances as parts of the length of the edge, of its ends and of the points in between.
  constexpr double end_distance = 0.15, inner_distance = 0.3;
  typedef std::vector<Kernel::Segment_3> Segments;
  typedef QM::internal::Aabb_segment_primitive<Kernel, Segments::const_iterator> Primitive;
  Segments segments;
  for(Mesh::Edge_index e : tm.edges())
    if(is_sharp_in_reference[e])
      segments.emplace_back(tm.point(tm.vertex(e, 0)), tm.point(tm.vertex(e, 1)));
  if(segments.empty())
    return;
  const CGAL::AABB_tree<CGAL::Quad_meshing::internal::Aabb_traits<Kernel, Primitive>> tree(segments.begin(),
                                                                                           segments.end());
  for(Mesh::Edge_index e : qm.edges())
  {
    const Point_3 &p = qm.point(qm.vertex(e, 0)), &q = qm.point(qm.vertex(e, 1));
    const double squared_length = CGAL::squared_distance(p, q);
    is_sharp[e] = true;
    for(double t : { 0., 1., 0.25, 0.5, 0.75 })
    {
      const double nearby = t == 0 || t == 1 ? end_distance : inner_distance;
      is_sharp[e] = is_sharp[e] && tree.squared_distance(p + t * (q - p)) < nearby * nearby * squared_length;
    }
  }
}

// Sharp edges of a quad mesh are those of its quads, cut in two. Returns how many were taken for noise.
template <typename SharpEdges>
std::size_t detect_sharp_edges(const Mesh& qm, double sharp_angle, double edge_length, SharpEdges is_sharp)
{
  Mesh triangles = qm; // its vertices keep their numbers
  PMP::triangulate_faces(triangles);
  auto is_sharp_triangle_edge =
    triangles.add_property_map<Mesh::Edge_index, bool>("e:is_sharp_triangle_edge", false).first;
  const QM::Feature_edges_result found =
    QM::detect_feature_edges(triangles, sharp_angle, edge_length, is_sharp_triangle_edge);
  for(Mesh::Edge_index e : qm.edges())
    is_sharp[e] = is_sharp_triangle_edge[triangles.edge(triangles.halfedge(qm.vertex(e, 0), qm.vertex(e, 1)))];
  return found.number_of_dropped_edges;
}

// The mesh before is drawn at the left.
void add_quads_before(QM::Scene& scene, const Mesh& qm)
{
  QM::add_quad_mesh_layers(scene, qm, "Before");
  for(QM::Scene_layer& layer : scene.layers)
    layer.side = QM::Scene_side::LEFT;
  scene.is_side_by_side = true;
}

// Patches are what changes: they color the quads.
void show_base_complexes(QM::Scene& scene)
{
  for(QM::Scene_layer& layer : scene.layers)
  {
    layer.is_visible = true;
    if(layer.kind == QM::Scene_layer_kind::FACES)
      for(std::size_t i = 0; i < layer.numbers.size(); ++i)
        if(layer.numbers[i].scale == QM::Scene_color_scale::CATEGORIES)
          layer.colored_by = static_cast<int>(i);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  return command_line::run(
    "optimize_quad_structure",
    [&]
    {
      po::options_description options("Options");
      options.add_options()("reference", po::value<std::string>(),
                            "triangle mesh that the result is smoothed on (default: the surface of IN)")(
        "method", po::value<std::string>()->default_value("layout"),
        "layout: search a coarse layout and multiply its dual curves; helices: remove helices one by one")(
        "iterations", po::value<long long>()->default_value(10000), "number of layouts that are tried")(
        "merge-singularities", "allow irregular vertices to be merged with each other and moved onto sharp edges")(
        "collapse-loops", "collapse all dual curves that can be collapsed, at the end")(
        "sharp-angle", po::value<double>()->default_value(40),
        "edges with a larger angle between normals are kept, those of the reference if there is one (degrees; 180 = "
        "none)")("target-quads", po::value<long long>()->default_value(0),
                 "largest number of quads (0 = as many as IN; 1 = the layout itself)")(
        "target-patches", po::value<long long>()->default_value(0), "largest size of the base complex (0 = no target)")(
        "json", po::value<std::string>(), "file for the figures as one flat JSON object");
      command_line::add_scene_options(options);
      command_line::add_quad_mesh_options(options);
      command_line::Arguments args("optimize_quad_structure",
                                   "makes the base complex of the quad mesh IN coarser and writes OUT", { "IN", "OUT" },
                                   options);
      if(!args.parse(argc, argv))
        return static_cast<int>(command_line::done);
      const double sharp_angle = args.number("sharp-angle", 0, 180);
      const long long most = (std::numeric_limits<unsigned int>::max)();
      const long long number_of_iterations = args.whole_number("iterations", 0, most);
      const long long number_of_quads = args.whole_number("target-quads", 0, most);
      const long long number_of_patches = args.whole_number("target-patches", 0, most);
      const QM::Structure_method method = args.choice("method", { "layout", "helices" }) == 0
                                            ? QM::Structure_method::LAYOUT
                                            : QM::Structure_method::HELICES;
      Mesh qm = command_line::read_quad_mesh<Mesh>(args.positional(0));
      command_line::check_mesh_output(args.positional(1));
      command_line::check_scene_files(args);
      const int digits = command_line::check_quad_mesh_options(args);
      QM::Scene scene;
      if(command_line::shows_scene(args))
        add_quads_before(scene, qm);
      auto is_sharp = qm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
      const QM::Quad_mesh_quality quality_before = QM::quad_mesh_quality(qm);
      if(!(quality_before.area > 0))
        throw command_line::Unusable_input(args.positional(0) + ": its quads have no area");
      const double edge_length = quality_before.mean_edge_length;
      const std::size_t inverted_before = quality_before.number_of_inverted_quads;
      std::size_t dropped;
      Mesh tm;
      auto is_sharp_in_reference = tm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
      if(args.has("reference"))
      {
        tm = command_line::read_mesh<Mesh>(args.value<std::string>("reference"));
        is_sharp_in_reference = tm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
        dropped = QM::detect_feature_edges(tm, sharp_angle, edge_length, is_sharp_in_reference).number_of_dropped_edges;
        mark_edges_on_reference(qm, tm, is_sharp_in_reference, is_sharp);
      }
      else
        dropped = detect_sharp_edges(qm, sharp_angle, edge_length, is_sharp);

      CGAL::Real_timer timer;
      timer.start();
      command_line::Progress_bar progress;
      const auto np = CGAL::parameters::structure_method(method)
                        .number_of_iterations(static_cast<unsigned int>(number_of_iterations))
                        .merge_singularities(args.has("merge-singularities"))
                        .collapse_dual_curves(args.has("collapse-loops"))
                        .target_number_of_quads(static_cast<std::size_t>(number_of_quads))
                        .target_number_of_patches(static_cast<std::size_t>(number_of_patches))
                        .edge_is_constrained_map(is_sharp)
                        .visitor(std::ref(progress));
      const QM::Quad_structure_optimization_result result =
        args.has("reference")
          ? QM::optimize_quad_structure(qm, tm, np, CGAL::parameters::edge_is_constrained_map(is_sharp_in_reference))
          : QM::optimize_quad_structure(qm, np);

      qm.collect_garbage();
      command_line::write_mesh(args.positional(1), qm, digits);
      command_line::write_patches(args, qm, digits);
      const std::size_t inverted = result.smoothing.quality_after.number_of_inverted_quads;
      const bool is_optimized = result.status == QM::Quad_mesh_status::SUCCESS;
      const bool valid = is_optimized && inverted == 0;
      if(is_optimized)
        std::cout << result.message << std::endl;
      if(!valid)
        std::cerr << "optimize_quad_structure: "
                  << (is_optimized ? "number of quads of the result that are not convex: " + std::to_string(inverted) +
                                       ", of the input: " + std::to_string(inverted_before)
                                   : result.message)
                  << std::endl;

      const QM::Quad_mesh_structure &before = result.structure_before, &after = result.structure_after;
      QM::Flat_json json;
      json.set("status", valid ? "done" : "not valid");
      json.set("message", result.message);
      json.set("quads_before", before.number_of_quads);
      json.set("quads_after", after.number_of_quads);
      json.set("base_complex_before", before.number_of_patches);
      json.set("base_complex_after", after.number_of_patches);
      json.set("helices_before", before.number_of_helices);
      json.set("helices_after", after.number_of_helices);
      json.set("helices_with_crossings_before", before.number_of_helices_with_crossings);
      json.set("helices_with_crossings_after", after.number_of_helices_with_crossings);
      json.set("irregular_vertices", after.number_of_irregular_vertices);
      json.set("dropped_sharp_edges", dropped);
      json.set("operators_applied", result.operators_applied);
      json.set("inverted_quads_before", inverted_before);
      json.set("inverted_quads_after", inverted);
      json.set("minimal_scaled_jacobian_before", quality_before.minimal_scaled_jacobian);
      json.set("minimal_scaled_jacobian", result.smoothing.quality_after.minimal_scaled_jacobian);
      json.set("seconds", timer.time());
      if(args.has("json"))
        command_line::write_json(args.value<std::string>("json"), json);
      if(command_line::shows_scene(args))
      {
        scene.message = result.message;
        QM::add_quad_mesh_layers(scene, qm, "After");
        show_base_complexes(scene);
        command_line::write_scene_files(args, json, scene);
      }
      return static_cast<int>(valid ? command_line::done : command_line::not_valid);
    });
}
