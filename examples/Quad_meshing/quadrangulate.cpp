// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Makes a quad mesh out of a triangle mesh: the whole line, as a program.

#include "command_line.h"
#include "group_options.h"
#include "guide_options.h"
#include "quad_mesh_files.h"
#include "scene_files.h"
#include "triangle_input.h"

#include <CGAL/Quad_meshing/Fields/cross_field_directions.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>
#include <CGAL/Quad_meshing/Pipeline/quadrangulation_layers.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>

namespace QM = CGAL::Quad_meshing;

typedef QM::Quadrangulation Quadrangulation;
typedef Quadrangulation::Mesh Mesh;

namespace {

bool is_rosy(const std::string& filename) { return QM::internal::file_extension(filename) == "rosy"; }

// A file F.rosy, and beside it F.triangles.obj, the triangles that the field lies on. Other files have one line per
// triangle: its centroid and the first direction of the cross there.
void write_field(std::ostream& out, const std::string& filename, const QM::Quadrangulation_surface& q)
{
  if(is_rosy(filename))
  {
    QM::write_rosy_field(out, q.mesh,
                         [&](Mesh::Face_index f) { return QM::cross_field_direction(f, q.mesh, q.angle); });
    command_line::write_mesh(filename.substr(0, filename.size() - 5) + ".triangles.obj", q.mesh);
    return;
  }
  for(Mesh::Face_index f : q.mesh.faces())
  {
    const Mesh::Halfedge_index h = q.mesh.halfedge(f);
    out << CGAL::centroid(q.mesh.point(q.mesh.source(h)), q.mesh.point(q.mesh.target(h)),
                          q.mesh.point(q.mesh.target(q.mesh.next(h))))
        << " " << QM::cross_field_direction(f, q.mesh, q.angle) << "\n";
  }
}

// The triangles with the integer-grid map as texture coordinates.
void write_map(std::ostream& out, const QM::Quadrangulation_surface& q)
{
  QM::Obj_content<Mesh> content;
  content.texture = [&](Mesh::Halfedge_index h) {
    return std::array<double, 2>{ { CGAL::to_double(q.uv[h].x()), CGAL::to_double(q.uv[h].y()) } };
  };
  QM::write_obj(out, q.mesh, content);
}

QM::Flat_json figures(const QM::Quadrangulation_result& r)
{
  QM::Flat_json json;
  json.set("status", QM::status_name(r.status));
  json.set("valid", r.is_valid());
  json.set("as_requested", r.is_as_requested);
  json.set("message", r.message);
  json.set("input_faces", r.input_faces);
  json.set("components", r.components);
  json.set("failed_components", r.failed_components);
  json.set("refined_components", r.refined_components);
  json.set("divided_vertices", r.divided_vertices);
  json.set("target_edge_length", r.target_edge_length);
  json.set("feature_edges", r.feature_edges);
  json.set("dropped_feature_edges", r.dropped_feature_edges);
  json.set("released_feature_share", r.released_feature_share);
  json.set("prepared_faces", r.prepared_faces);
  json.set("quads", r.quads);
  json.set("other_faces", r.other_faces);
  json.set("irregular_vertices", r.irregular_vertices);
  json.set("singularities", r.singularities);
  json.set("field_integers", r.field_integers);
  json.set("field_energy", r.field_energy);
  json.set("field_seconds", r.field_seconds);
  json.set("parameterization_integers", r.parameterization_integers);
  json.set("parameterization_energy", r.parameterization_energy);
  json.set("parameterization_seconds", r.parameterization_seconds);
  json.set("parameterization_attempts", r.parameterization_attempts);
  json.set("flipped_triangles", r.flipped_triangles);
  json.set("extraction_seconds", r.extraction_seconds);
  json.set("folded_quads", r.folded_quads);
  json.set("smoothing_seconds", r.smoothing_seconds);
  json.set("structure_seconds", r.structure_seconds);
  json.set("layout_seconds", r.layout_seconds);
  json.set("not_semi_regular_components", r.not_semi_regular_components);
  json.set("total_seconds", r.total_seconds);
  return json;
}

} // namespace

int main(int argc, char* argv[])
{
  return command_line::run(
    "quadrangulate",
    [&]
    {
      po::options_description options("Options");
      options.add_options()("target-edge-length", po::value<double>(),
                            "length of the quad edges, in the unit of the input")(
        "target-quads", po::value<double>()->default_value(4000), "number of quads, where no edge length is given")(
        "sharp-angle", po::value<double>()->default_value(40),
        "edges with a larger angle between the normals (degrees) become chains of quad edges; 180: none")(
        "align-boundary", po::value<std::string>()->default_value("on"),
        "on or off: make the boundary a chain of quad edges")(
        "field", po::value<std::string>()->default_value("polished"),
        "representation, greedy, greedy-and-search or polished: how the singularities of the cross field are found; or "
        "a file .rosy with a direction for each face of IN, which the field gets")(
        "curvature-alignment", po::value<double>()->default_value(1),
        "0 to 1: how much quads follow the directions in which the surface bends least")(
        "singularity-cost", po::value<double>()->default_value(0.6),
        "what an irregular vertex must save: more means fewer of them, and quads that follow the surface less")(
        "work-on-input", "make field and map on the input's own triangles instead of a working mesh")(
        "rounding", po::value<std::string>()->default_value("greedy"),
        "direct, greedy or lattice: how integers are found")(
        "optimize-structure", "make the base complex coarser: fewer patches with the same irregular vertices")(
        "smoothing", po::value<long long>()->default_value(20), "steps of the smoothing in the end; 0: none")(
        "semi-regular", "optimize the structure, then make the quads anew on IN along the base complex")(
        "seed", po::value<long long>()->default_value(0),
        "seed of the edge lengths that are tried when the given one allows no valid map")(
        "threads", po::value<long long>()->default_value(1),
        "how many threads may work at the same time; the result is the same")(
        "time-limit", po::value<double>(), "seconds after which the best mesh so far is written")(
        "save-field", po::value<std::string>(),
        "file for the cross field: x y z of a centroid and of a direction per line; F.rosy: in that format, with its "
        "triangles in F.triangles.obj")("largest-component", "take the component of the largest area alone")(
        "save-uv", po::value<std::string>(),
        "OBJ file for the map as texture coordinates: an integer-grid map, or a "
        "seamless one where quads were made along its T-mesh")("strict",
                                                               "exit with 1 unless all that was asked for was met")(
        "json", po::value<std::string>(), "file for the figures of the run as one flat JSON object");
      command_line::add_greedy_rounding(options);
      command_line::add_scene_options(options);
      command_line::add_quad_mesh_options(options);
      guide_options::add(options);
      group_options::add(options);
      command_line::Arguments args("quadrangulate", "makes a quad mesh of the triangle mesh IN", { "IN", "OUT" },
                                   options);
      if(!args.parse(argc, argv))
        return command_line::done;

      double edge_length = 0;
      if(args.has("target-edge-length"))
        edge_length = args.positive_number("target-edge-length");
      const double number_of_quads = args.positive_number("target-quads");
      const double sharp_angle = args.number("sharp-angle", 0, 180);
      const bool align_boundary = args.is_on("align-boundary");
      const QM::Rounding_method methods[] = { QM::Rounding_method::DIRECT, QM::Rounding_method::GREEDY,
                                              QM::Rounding_method::LATTICE };
      const QM::Rounding_method rounding = methods[args.choice("rounding", { "direct", "greedy", "lattice" })];

      const QM::Cross_field_method fields[] = { QM::Cross_field_method::REPRESENTATION, QM::Cross_field_method::GREEDY,
                                                QM::Cross_field_method::GREEDY_AND_SEARCH,
                                                QM::Cross_field_method::POLISHED };
      const std::string field_file = is_rosy(args.value<std::string>("field")) ? args.value<std::string>("field") : "";
      const QM::Cross_field_method field =
        field_file.empty()
          ? fields[args.choice("field", { "representation", "greedy", "greedy-and-search", "polished" })]
          : QM::Cross_field_method::POLISHED;
      const command_line::Greedy_rounding greedy = command_line::greedy_rounding(args);

      QM::Mesh_reading_result reading;
      Mesh tm = command_line::read_mesh<Mesh>(args.positional(0), reading);
      if(args.has("largest-component"))
        command_line::keep_largest_component(tm, reading);
      command_line::check_mesh_output(args.positional(1));
      const int digits = command_line::check_quad_mesh_options(args);
      for(const char* file : { "save-field", "json" })
        if(args.has(file))
          command_line::check_output(args.value<std::string>(file));
      if(args.has("save-uv"))
        command_line::check_output(args.value<std::string>("save-uv"), { "obj" });

      command_line::check_scene_files(args);

      Quadrangulation q(tm, tm.points());
      if(!field_file.empty())
      {
        const auto directions =
          command_line::read_directions<Quadrangulation::Kernel::Vector_3>(field_file, reading.faces);
        q.set_directions(tm, boost::make_iterator_property_map(directions.begin(), get(boost::face_index, tm)));
      }
      q.options.face_name = command_line::names_in_file("face", reading.faces);
      q.options.vertex_name = command_line::names_in_file("vertex", reading.vertices);
      q.options.meet_at_junctions = reading.counts.separated_edges > 0;
      q.options.target_edge_length = edge_length;
      q.options.target_number_of_quads = number_of_quads;
      q.options.sharpness_angle = sharp_angle;
      q.options.align_boundary = align_boundary;
      q.options.curvature_alignment = args.number("curvature-alignment", 0, 1);
      q.options.singularity_cost = args.number("singularity-cost", 0, 1000);
      q.options.cross_field_method = field;
      q.options.work_on_input = args.has("work-on-input");
      q.options.rounding_tolerance = greedy.tolerance;
      q.options.gauss_seidel_iterations = greedy.gauss_seidel;
      q.options.conjugate_gradient_iterations = greedy.conjugate_gradient;
      q.options.allow_refactorization = greedy.has_cholesky;
      q.options.rounding_method = rounding;
      q.options.optimize_structure = args.has("optimize-structure");
      q.options.semi_regular = args.has("semi-regular");
      q.options.smoothing_iterations =
        static_cast<unsigned int>(args.whole_number("smoothing", 0, (std::numeric_limits<int>::max)()));
      q.options.number_of_threads = args.number_of_threads();
      q.options.random_seed = args.random_seed();

      guide_options::read(args, { tm, args.positional(0), reading }, q);
      std::optional<group_options::Groups> groups;
      if(args.has("groups"))
        groups.emplace(args, tm, reading, q);
      if(args.has("time-limit"))
        q.options.maximum_running_time = args.positive_number("time-limit");

      QM::Quadrangulation_result result;
      {
        command_line::Progress_bar progress;
        result = q.run(progress);
      }

      if(args.has("json"))
        command_line::write_json(args.value<std::string>("json"), figures(result));
      if(result.status == QM::Quadrangulation_status::INVALID_INPUT)
        throw command_line::Unusable_input(args.positional(0) + ": " + result.message);
      if(args.has("save-field"))
      {
        const std::string filename = args.value<std::string>("save-field");
        command_line::write_file(filename, [&](std::ostream& out) { write_field(out, filename, q.surface()); });
      }
      if(args.has("save-uv"))
      {
        command_line::write_file(args.value<std::string>("save-uv"),
                                 [&](std::ostream& out) { write_map(out, q.surface()); });
        if(!q.surface().t_meshes.empty())
          std::cerr << "The map that was saved is not rounded to integers where quads were made along its T-mesh."
                    << std::endl;
      }
      if(q.quads().mesh.number_of_faces() > 0)
      {
        if(groups && QM::internal::file_extension(args.positional(1)) == "obj")
          groups->write(args.positional(1), q, digits);
        else
          command_line::write_mesh(args.positional(1), q.quads().mesh, digits);
        command_line::write_patches(args, q.quads().mesh, digits);
      }

      if(command_line::shows_scene(args))
      {
        QM::Scene scene;
        scene.message = result.message;
        scene.is_side_by_side = true;
        QM::add_quadrangulation_layers(scene, tm, q);
        command_line::write_scene_files(args, figures(result), scene);
      }

      std::cout << result.message << "\n"
                << command_line::count_of(result.quads, "quad", "quads") << ", "
                << command_line::count_of(result.irregular_vertices, "irregular vertex", "irregular vertices") << ", "
                << result.total_seconds << " s" << std::endl;
      if(!result.is_valid())
        std::cerr << "quadrangulate: " << args.positional(0)
                  << ": the result is not valid: " << command_line::one_line(result.message) << std::endl;
      const bool is_refused = args.has("strict") && result.is_valid() && !result.is_as_requested;
      if(is_refused)
        std::cerr << "quadrangulate: " << args.positional(0)
                  << ": not all that was asked for was met: " << command_line::one_line(result.message) << std::endl;
      return result.is_valid() && !is_refused ? command_line::done : command_line::not_valid;
    });
}
