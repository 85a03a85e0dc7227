// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Makes a quad mesh of a triangle mesh along a layout of four-sided patches.

#include "command_line.h"
#include "quad_mesh_files.h"
#include "scene_files.h"

#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Layout/layout_from_quad_mesh.h>
#include <CGAL/Quad_meshing/Layout/quadrangulate_layout.h>
#include <CGAL/Quad_meshing/Layout/surface_layout_files.h>
#include <CGAL/Quad_meshing/Pipeline/quadrangulation_layers.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <map>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

// Vertices in the layout have the numbers that they have in the file of the mesh.
void renumber(QM::Surface_layout& layout, const Mesh& tm, const QM::Mesh_reading_result& reading,
              const std::string& filename)
{
  std::map<std::size_t, std::size_t> number;
  for(std::size_t i = 0; i < tm.number_of_vertices(); ++i)
    number.insert({ reading.vertices.file_number(i), i });
  auto rename = [&](QM::Surface_layout::Place& place)
  {
    if(place.vertex == QM::Surface_layout::none)
      return;
    const auto found = number.find(place.vertex);
    if(found == number.end())
      throw command_line::Unusable_input(filename + ": the mesh has no vertex " + std::to_string(place.vertex));
    place.vertex = found->second;
  };
  for(QM::Surface_layout::Place& n : layout.nodes)
    rename(n);
  for(QM::Surface_layout::Arc& a : layout.arcs)
    for(QM::Surface_layout::Place& p : a.way)
      rename(p);
}

// Whether an OBJ file holds curves and no faces.
bool holds_curves(const std::string& filename)
{
  std::ifstream in(filename);
  bool has_curves = false;
  for(std::string line; std::getline(in, line);)
  {
    if(line.compare(0, 2, "f ") == 0)
      return false;
    has_curves = has_curves || line.compare(0, 2, "l ") == 0;
  }
  return has_curves;
}

// A layout in the package's format, curves, or a coarse quad mesh; of a quad mesh the base complex if it is asked for.
QM::Surface_layout read_layout(const std::string& filename, bool base_complex)
{
  const std::string extension = QM::internal::file_extension(filename);
  if(extension == "off" || extension == "ply" || (extension == "obj" && !holds_curves(filename)))
  {
    const Mesh qm = command_line::read_quad_mesh<Mesh>(filename);
    const QM::Surface_layout layout = base_complex ? QM::layout_from_base_complex(qm) : QM::layout_from_quad_mesh(qm);
    if(layout.patches.empty())
      throw command_line::Unusable_input(filename + ": its base complex has a patch that is no rectangle");
    return layout;
  }
  if(base_complex)
    throw command_line::Unusable_input(filename + ": --base-complex needs a quad mesh");
  QM::Surface_layout layout;
  const QM::Layout_reading_result result = QM::read_surface_layout(filename, layout);
  if(!result.is_valid())
    throw command_line::Unusable_input(filename + ": " + result.message);
  return layout;
}

QM::Flat_json figures(const QM::Layout_quadrangulation_result& result, const QM::Quad_mesh_quality& quality,
                      double seconds)
{
  QM::Flat_json json;
  json.set("status", QM::status_name(result.status));
  json.set("message", result.message);
  json.set("quads", result.quads);
  json.set("vertices", result.vertices);
  json.set("nodes", result.nodes);
  json.set("arcs", result.arcs);
  json.set("patches", result.patches);
  json.set("t_vertices", result.t_vertices);
  json.set("quadrilateral_charts", result.quadrilateral_charts);
  json.set("iterations", result.energies.empty() ? std::size_t(0) : result.energies.size() - 1);
  json.set("energy_before", result.energies.empty() ? 0. : result.energies.front());
  json.set("energy_after", result.energies.empty() ? 0. : result.energies.back());
  json.set("aligned_arcs", result.aligned_arcs);
  json.set("forced_arcs", result.forced_arcs);
  json.set("untangled_patches", result.untangled_patches);
  json.set("feature_length", result.feature_length);
  json.set("feature_length_on_arcs", result.feature_length_on_arcs);
  json.set("inverted_quads", quality.number_of_inverted_quads);
  json.set("mean_angle_deviation", quality.mean_angle_deviation);
  json.set("minimal_scaled_jacobian", quality.minimal_scaled_jacobian);
  json.set("edge_length_variation", quality.edge_length_variation);
  json.set("seconds", seconds);
  return json;
}

// What the page shows: the mesh with its features and the layout as it was given, and the quads.
void write_scene(const command_line::Arguments& args, const QM::Flat_json& figures, const std::string& message,
                 const Mesh& tm, const Mesh::Property_map<Mesh::Edge_index, bool>& is_sharp,
                 const QM::Surface_layout& layout, const Mesh& qm)
{
  QM::Scene scene;
  scene.message = message;
  scene.is_side_by_side = true;
  scene.layers.push_back(QM::make_display_layer(tm, "triangles", "Input", scene));
  scene.layers.push_back(QM::make_edges_layer(
    tm, [&](Mesh::Edge_index e) { return bool(is_sharp[e]); }, "features", "Input"));
  scene.layers.back().color = "#c02020";
  auto point = [&](const QM::Surface_layout::Place& p)
  {
    return p.vertex == QM::Surface_layout::none ? Point_3(p.point[0], p.point[1], p.point[2])
                                                : tm.point(Mesh::Vertex_index(Mesh::size_type(p.vertex)));
  };
  std::vector<std::vector<Point_3>> arcs;
  for(const QM::Surface_layout::Arc& a : layout.arcs)
  {
    arcs.emplace_back(1, point(layout.nodes[a.source]));
    for(const QM::Surface_layout::Place& p : a.way)
      arcs.back().push_back(point(p));
    arcs.back().push_back(point(layout.nodes[a.target]));
  }
  scene.layers.push_back(QM::make_polylines_layer(arcs, "arcs as they are given", "Layout"));
  scene.layers.back().color = "#d07000";
  for(QM::Scene_layer& layer : scene.layers)
    layer.side = QM::Scene_side::LEFT;
  QM::add_quad_mesh_layers(scene, qm);
  command_line::write_scene_files(args, figures, scene);
}

} // namespace

int main(int argc, char* argv[])
{
  return command_line::run(
    "quadrangulate_layout",
    [&]
    {
      po::options_description options("Options");
      options.add_options()("edge-length", po::value<double>(), "length of the quad edges, in the unit of the input")(
        "quads", po::value<double>()->default_value(4000), "number of quads, where no edge length is given")(
        "charts", po::value<std::string>()->default_value("auto"),
        "unit, rectangle, quadrilateral, or auto: what the layout says for each patch, else by its features")(
        "iterations", po::value<long long>()->default_value(3), "how often the charts are optimized")(
        "align", po::value<std::string>()->default_value("features"),
        "tagged, features or all: the arcs that quad edges have to represent")(
        "sharp-angle", po::value<double>()->default_value(40),
        "edges with a larger angle between the normals (degrees) are features; 180: none")(
        "weights", po::value<std::string>()->default_value("harmonic"), "harmonic or mean-value")(
        "least-squares", po::bool_switch(), "meet all equations at aligned arcs in the sense of least squares")(
        "rounding", po::value<std::string>()->default_value("optimal"),
        "optimal or direct: how the numbers of segments are found where T-vertices relate them")(
        "base-complex", po::bool_switch(), "LAYOUT is a quad mesh whose base complex is the layout")(
        "save-layout", po::value<std::string>(), "file for the layout, in the format of layouts")(
        "strict", "exit with 1 unless all that was asked for was met")(
        "json", po::value<std::string>(), "file for the figures of the run as one flat JSON object");
      command_line::add_scene_options(options);
      command_line::add_quad_mesh_options(options);
      command_line::Arguments args("quadrangulate_layout",
                                   "makes a quad mesh of the triangle mesh MESH along LAYOUT (a layout, an OBJ file of "
                                   "curves, or a coarse quad mesh) and writes OUT",
                                   { "MESH", "LAYOUT", "OUT" }, options);
      if(!args.parse(argc, argv))
        return command_line::done;
      const double edge_length = args.has("edge-length") ? args.positive_number("edge-length") : 0;
      const double number_of_quads = args.positive_number("quads");
      const double sharp_angle = args.number("sharp-angle", 0, 180);
      const QM::Layout_chart charts[] = { QM::Layout_chart::AUTOMATIC, QM::Layout_chart::UNIT,
                                          QM::Layout_chart::RECTANGLE, QM::Layout_chart::QUADRILATERAL };
      const QM::Arc_alignment alignments[] = { QM::Arc_alignment::TAGGED, QM::Arc_alignment::FEATURES,
                                               QM::Arc_alignment::ALL };
      const QM::Layout_chart chart = charts[args.choice("charts", { "auto", "unit", "rectangle", "quadrilateral" })];
      const QM::Arc_alignment alignment = alignments[args.choice("align", { "tagged", "features", "all" })];
      const bool mean_value = args.choice("weights", { "harmonic", "mean-value" }) == 1;
      const QM::Rounding_method rounding = args.choice("rounding", { "optimal", "direct" }) == 0
                                             ? QM::Rounding_method::BRANCH_AND_BOUND
                                             : QM::Rounding_method::DIRECT;
      const long long iterations = args.whole_number("iterations", 0, 1000);

      QM::Mesh_reading_result reading;
      Mesh tm = command_line::read_mesh<Mesh>(args.positional(0), reading);
      QM::Surface_layout layout = read_layout(args.positional(1), args.value<bool>("base-complex"));
      renumber(layout, tm, reading, args.positional(1));
      command_line::check_mesh_output(args.positional(2));
      for(const char* file : { "save-layout", "json" })
        if(args.has(file))
          command_line::check_output(args.value<std::string>(file));
      command_line::check_scene_files(args);
      const int digits = command_line::check_quad_mesh_options(args);
      if(args.has("save-layout"))
      {
        command_line::write_file(args.value<std::string>("save-layout"),
                                 [&](std::ostream& out) { QM::write_surface_layout(out, layout); });
      }

      CGAL::Real_timer timer;
      timer.start();
      auto is_sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
      const double length = edge_length > 0 ? edge_length : std::sqrt(PMP::area(tm) / number_of_quads);
      if(length > 0)
        QM::detect_feature_edges(tm, sharp_angle, length, is_sharp);
      Mesh qm;
      QM::Layout_quadrangulation_result result;
      {
        command_line::Progress_bar progress;
        result = QM::quadrangulate_layout(tm, layout, qm,
                                          CGAL::parameters::target_edge_length(edge_length)
                                            .target_number_of_quads(number_of_quads)
                                            .layout_chart(chart)
                                            .arc_alignment(alignment)
                                            .number_of_iterations(static_cast<unsigned int>(iterations))
                                            .mean_value_weights(mean_value)
                                            .least_squares_alignment(args.value<bool>("least-squares"))
                                            .rounding_method(rounding)
                                            .edge_is_constrained_map(is_sharp)
                                            .visitor(std::ref(progress)));
      }
      const QM::Quad_mesh_quality quality = QM::quad_mesh_quality(qm);
      if(args.has("json"))
        command_line::write_json(args.value<std::string>("json"), figures(result, quality, timer.time()));
      if(result.status == QM::Layout_quadrangulation_status::BAD_MESH)
        throw command_line::Unusable_input(args.positional(0) + ": " + result.message);
      if(result.status == QM::Layout_quadrangulation_status::BAD_LAYOUT)
        throw command_line::Unusable_input(args.positional(1) + ": " + result.message);
      if(!result.is_valid())
      {
        std::cerr << "quadrangulate_layout: " << args.positional(0) << ": " << result.message << std::endl;
        return command_line::not_valid;
      }
      command_line::write_mesh(args.positional(2), qm, digits);
      command_line::write_patches(args, qm, digits);
      if(command_line::shows_scene(args))
        write_scene(args, figures(result, quality, timer.time()), result.message, tm, is_sharp, layout, qm);
      std::cout << result.message << "\n"
                << command_line::count_of(result.quads, "quad", "quads") << ", energy " << result.energies.front()
                << " before and " << result.energies.back() << " after "
                << command_line::count_of(result.energies.size() - 1, "iteration", "iterations") << ", " << timer.time()
                << " s" << std::endl;

      // the deviation from the number of quads that counts as met
      const double close_enough = 0.05;
      std::string unmet;
      if(edge_length == 0 && std::abs(result.quads - number_of_quads) > close_enough * number_of_quads)
        unmet +=
          " The layout allows no number of quads nearer to " + std::to_string(std::llround(number_of_quads)) + ".";
      if(quality.number_of_inverted_quads > 0)
        unmet += " " + command_line::count_of(quality.number_of_inverted_quads, "quad is", "quads are") + " inverted.";
      if(!unmet.empty())
        std::cerr << "quadrangulate_layout: " << args.positional(0) << ":" << unmet << std::endl;
      return args.has("strict") && !unmet.empty() ? command_line::not_valid : command_line::done;
    });
}
