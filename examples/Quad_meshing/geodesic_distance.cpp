// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Computes the geodesic distance on a triangle mesh from vertices, points, polylines, sharp edges and the border.

#include "command_line.h"
#include "polyline_files.h"
#include "scene_files.h"

#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_field.h>
#include <CGAL/Quad_meshing/Geodesics/certify_distances.h>
#include <CGAL/Quad_meshing/Geodesics/isolines.h>
#include <CGAL/Quad_meshing/Geodesics/refine_distance_field.h>
#include <CGAL/Quad_meshing/Guides/Polyline_tracer.h>
#include <CGAL/Quad_meshing/IO/scene_layers.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Quad_meshing::Geodesic_distance_field<Mesh> Field;
typedef Field::Face_location Location;
typedef CGAL::Quad_meshing::Polyline_tracer<Mesh, Mesh::Property_map<Mesh::Vertex_index, Point_3>> Tracer;

namespace QM = CGAL::Quad_meshing;
namespace params = CGAL::parameters;
using command_line::Unusable_input;

namespace {

// The points of a polyline, the first one twice if it is closed.
std::vector<Point_3> points_of(const QM::File_polyline& polyline)
{
  std::vector<Point_3> points;
  for(const auto& p : polyline.points)
    points.emplace_back(p[0], p[1], p[2]);
  if(polyline.is_closed)
    points.push_back(points.front());
  return points;
}

// The vertices of the mesh that stand for each vertex of the file: none if no face has it, several if it was split.
class File_vertices
{
  std::vector<std::vector<Mesh::Vertex_index>> m_vertices;

public:
  explicit File_vertices(const QM::File_numbers& numbers) : m_vertices(numbers.file_size())
  {
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
      if(numbers.mesh_number(v) != QM::File_numbers::none)
        m_vertices[v].emplace_back(static_cast<Mesh::size_type>(numbers.mesh_number(v)));
    for(std::size_t i = 0; i < numbers.mesh_size(); ++i)
    {
      const std::size_t v = numbers.file_number(i);
      const Mesh::Vertex_index vertex(static_cast<Mesh::size_type>(i));
      if(v != QM::File_numbers::none && m_vertices[v].front() != vertex)
        m_vertices[v].push_back(vertex);
    }
  }

  std::size_t size() const { return m_vertices.size(); }
  const std::vector<Mesh::Vertex_index>& operator[](std::size_t v) const { return m_vertices[v]; }
};

// Numbers of vertices are those of the file.
void add_vertices(const std::string& list, const File_vertices& file_vertices, Field& field)
{
  std::istringstream words(list);
  std::string word;
  while(std::getline(words, word, ','))
  {
    std::istringstream number(word);
    long long v;
    char rest;
    if(!(number >> v) || (number >> rest) || v < 0 || v >= static_cast<long long>(file_vertices.size()))
      throw Unusable_input("--vertices: '" + word + "' is not the number of a vertex (0 to " +
                           std::to_string(static_cast<long long>(file_vertices.size()) - 1) + ")");
    if(file_vertices[static_cast<std::size_t>(v)].empty())
      throw Unusable_input("--vertices: vertex " + word + " is in no face");
    for(Mesh::Vertex_index vertex : file_vertices[static_cast<std::size_t>(v)])
      field.add_source(vertex);
  }
}

void add_polylines(const std::string& filename, Tracer& tracer, Field& field)
{
  for(const QM::File_polyline& polyline : command_line::read_lines(filename))
  {
    std::vector<Location> curve;
    if(!tracer.trace(points_of(polyline), false, curve))
      throw Unusable_input("two consecutive points of a polyline lie on different parts of the surface");
    if(field.add_polyline_source(curve) == Field::no_source())
      throw Unusable_input(filename + ": a polyline cannot be traced on the surface");
  }
}

void add_sharp_edges(double angle, Mesh& tm, Field& field)
{
  auto is_sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(tm, angle, is_sharp);
  std::vector<Mesh::Edge_index> sharp_edges;
  for(Mesh::Edge_index e : tm.edges())
    if(is_sharp[e])
      sharp_edges.push_back(e);
  if(field.add_edges_source(sharp_edges) == Field::no_source())
    throw Unusable_input("--sharp-edges: there is no edge with such an angle");
}

// Writes the distance of each vertex of the file, one in each line, and inf for those without a face.
template <typename DistanceMap>
void write_distances_of_file(const std::string& filename, const File_vertices& file_vertices,
                             const DistanceMap& distance)
{
  command_line::write_file(filename,
                           [&](std::ostream& os)
                           {
                             for(std::size_t v = 0; v < file_vertices.size(); ++v)
                             {
                               double d = std::numeric_limits<double>::infinity();
                               for(Mesh::Vertex_index vertex : file_vertices[v])
                                 d = (std::min)(d, distance[vertex]);
                               os << d << "\n";
                             }
                           });
}

// Writes the lower and the upper bound of each distance in the same way.
template <typename EnclosureMap>
void write_enclosures(const std::string& filename, const File_vertices& file_vertices, const EnclosureMap& enclosures)
{
  command_line::write_file(filename,
                           [&](std::ostream& os)
                           {
                             for(std::size_t v = 0; v < file_vertices.size(); ++v)
                             {
                               double low = std::numeric_limits<double>::infinity(), high = low;
                               for(Mesh::Vertex_index vertex : file_vertices[v])
                               {
                                 low = (std::min)(low, enclosures[vertex].inf());
                                 high = (std::min)(high, enclosures[vertex].sup());
                               }
                               os << low << " " << high << "\n";
                             }
                           });
}

// Writes a mesh with the vertex property 'distance'.
void write_distances(const std::string& filename, const Mesh& tm,
                     const std::function<double(Mesh::Vertex_index)>& distance)
{
  command_line::write_file(
    filename,
    [&](std::ostream& os)
    {
      os << "ply\nformat ascii 1.0\ncomment geodesic distances\nelement vertex " << tm.number_of_vertices()
         << "\nproperty double x\nproperty double y\nproperty double z\nproperty double distance\nelement face "
         << tm.number_of_faces() << "\nproperty list uchar int vertex_indices\nend_header\n";
      for(Mesh::Vertex_index v : tm.vertices())
        os << tm.point(v) << " " << distance(v) << "\n";
      for(Mesh::Face_index f : tm.faces())
      {
        os << 3;
        for(Mesh::Vertex_index v : tm.vertices_around_face(tm.halfedge(f)))
          os << " " << static_cast<std::size_t>(v);
        os << "\n";
      }
    });
}

// The isolines of all multiples of `spacing`, and their values.
struct Isolines
{
  std::vector<std::vector<Point_3>> polylines;
  std::vector<double> values;
};

template <typename DistanceMap>
Isolines trace_isolines(const Mesh& tm, const DistanceMap& distances, double spacing, double maximum)
{
  const double most_values = 1e6;
  if(maximum > most_values * spacing)
    throw Unusable_input("--isolines: more than a million lines up to the largest distance, " +
                         std::to_string(maximum));
  Isolines isolines;
  for(double k = 1; k * spacing < maximum; ++k)
  {
    QM::trace_isolines(tm, distances, k * spacing, std::back_inserter(isolines.polylines));
    isolines.values.resize(isolines.polylines.size(), k * spacing);
  }
  return isolines;
}

// What the page shows: the faces by the mean distance of their corners, and isolines, which follow the spacing that was
// asked for or divide the largest distance.
template <typename DistanceMap>
void write_page(const command_line::Arguments& args, const QM::Flat_json& figures, const Mesh& tm,
                const DistanceMap& distance, double maximum, const std::vector<std::vector<Point_3>>& paths)
{
  constexpr double number_of_isolines = 25;
  QM::Scene scene;
  scene.message = "Geodesic distances.";
  scene.layers.push_back(QM::make_display_layer(tm, "triangles", "Distances", scene));
  QM::Scene_layer& triangles = scene.layers.back();
  triangles.has_sides = false;
  if(triangles.size() == tm.number_of_faces())
  {
    QM::Scene_numbers mean;
    mean.name = "mean distance of the corners";
    for(Mesh::Face_index f : tm.faces())
    {
      mean.values.push_back(0);
      for(Mesh::Vertex_index v : tm.vertices_around_face(tm.halfedge(f)))
        mean.values.back() += distance[v] / 3;
    }
    triangles.numbers.push_back(mean);
    triangles.colored_by = 0;
  }
  const double spacing = args.has("isolines") ? args.value<double>("isolines") : maximum / number_of_isolines;
  if(spacing > 0)
  {
    const Isolines isolines = trace_isolines(tm, distance, spacing, maximum);
    scene.layers.push_back(QM::make_polylines_layer(isolines.polylines, "isolines", "Distances"));
    QM::Scene_numbers value;
    value.name = "distance";
    value.values = isolines.values;
    scene.layers.back().numbers.push_back(value);
    scene.layers.back().color = "#101010";
  }
  if(!paths.empty())
  {
    scene.layers.push_back(QM::make_polylines_layer(paths, "shortest paths", "Distances"));
    scene.layers.back().color = "#c02020";
  }
  command_line::write_scene_files(args, figures, scene);
}

std::string status_word(QM::Geodesic_distance_status status, std::size_t unreached)
{
  return status != QM::Geodesic_distance_status::SUCCESS ? "failed" : unreached > 0 ? "unreached_vertices" : "success";
}

int distances(int argc, char* argv[])
{
  po::options_description options("Options");
  options.add_options()("vertices", po::value<std::string>(), "source vertices in the numbers of IN, as 0,17,4")(
    "points", po::value<std::string>(), "file with source points, x y z in each line, projected to the surface")(
    "polyline", po::value<std::string>(),
    "file with source polylines, a point in each line, consecutive points are joined "
    "by the shortest curve on the surface; an empty line begins a new one")("boundary", "the boundary is a source")(
    "sharp-edges", po::value<double>(), "the edges with a dihedral angle above this one (degrees) are a source")(
    "epsilon", po::value<double>()->default_value(0), "relative error allowed, 0 for exact distances")(
    "certified", "enclose each distance in an interval that is guaranteed to contain it, and write the intervals")(
    "enclosures-out", po::value<std::string>(),
    "file for the intervals, the lower and the upper bound of each vertex in a line; default: OUT.enclosures.txt")(
    "vertices-only", "keep no windows: less time and memory, for distances alone")(
    "refine", po::value<double>(),
    "refine the mesh until linear interpolation of the distance is good to this length "
    "(OUT must be .ply)")(
    "isolines", po::value<double>(),
    "write the isolines of all multiples of this distance as polylines, on the refined mesh if there is one")(
    "isolines-out", po::value<std::string>(), "file for the isolines; default: OUT.isolines.txt")(
    "paths-from", po::value<std::string>(), "file with points from which shortest paths are traced")(
    "paths-out", po::value<std::string>(), "file for these paths as polylines; default: OUT.paths.txt")(
    "json", po::value<std::string>(), "file for the figures");
  command_line::add_scene_options(options);
  command_line::Arguments args(
    "geodesic_distance",
    "Computes the geodesic distance from sources on a triangle mesh. OUT is a .txt file with one "
    "distance per vertex of IN, inf for those without a face, or a .ply mesh with the vertex property 'distance'.",
    { "IN", "OUT" }, options);
  if(!args.parse(argc, argv))
    return command_line::done;
  const double epsilon = args.number("epsilon", 0, 1);
  const std::string out = args.positional(1);
  command_line::check_output(out, { "txt", "ply" });
  const std::string extension = QM::internal::file_extension(out);
  if(args.has("refine") && (args.positive_number("refine"), extension != "ply"))
    throw Unusable_input(out + ": a refined mesh needs the format ply");
  if(args.has("isolines"))
    args.positive_number("isolines");
  command_line::check_scene_files(args);
  const bool vertices_only = args.has("vertices-only");
  for(const char* option : { "refine", "paths-from", "certified" })
    if(vertices_only && args.has(option))
      throw Unusable_input(std::string("--vertices-only excludes --") + option);

  CGAL::Real_timer timer;
  timer.start();
  QM::Mesh_reading_result reading;
  Mesh tm = command_line::read_mesh<Mesh>(args.positional(0), reading);
  const File_vertices file_vertices(reading.vertices);
  const double reading_seconds = timer.time();
  Field field(tm);
  std::unique_ptr<Tracer> made_tracer; // when it is needed for the first time
  const auto tracer = [&]() -> Tracer&
  {
    if(!made_tracer)
      made_tracer = std::make_unique<Tracer>(tm, tm.points());
    return *made_tracer;
  };
  if(args.has("vertices"))
    add_vertices(args.value<std::string>("vertices"), file_vertices, field);
  if(args.has("points"))
    for(const QM::File_polyline& part : command_line::read_lines(args.value<std::string>("points")))
      for(const Point_3& p : points_of(part))
        field.add_source(tracer().locate(p));
  if(args.has("polyline"))
    add_polylines(args.value<std::string>("polyline"), tracer(), field);
  if(args.has("boundary") && field.add_border_source() == Field::no_source())
    throw Unusable_input(args.positional(0) + ": the mesh has no boundary");
  if(args.has("sharp-edges"))
    add_sharp_edges(args.number("sharp-edges", 0, 180), tm, field);
  if(field.number_of_sources() == 0)
    throw Unusable_input("there is no source: give --vertices, --points, --polyline, --boundary or --sharp-edges");
  const double setup_seconds = timer.time() - reading_seconds;

  command_line::Progress_bar progress_bar;
  const QM::Geodesic_distance_result result = field.propagate(
    params::relative_distance_error(epsilon).keep_windows(!vertices_only).visitor(std::ref(progress_bar)));
  if(!result)
    throw Unusable_input(args.positional(0) + ": " + result.message);

  QM::Flat_json json;
  json.set("status", status_word(result.status, result.number_of_unreached_vertices));
  json.set("vertices", tm.number_of_vertices());
  json.set("faces", tm.number_of_faces());
  json.set("sources", field.number_of_sources());
  // those on all edges, counted outside of the time of the propagation
  const std::size_t number_of_windows = vertices_only ? result.number_of_windows : field.number_of_windows();
  json.set("windows", number_of_windows);
  json.set("windows_per_edge", double(number_of_windows) / double(tm.number_of_edges()));
  json.set("setup_seconds", setup_seconds);
  json.set("propagation_seconds", result.seconds);
  json.set("unreached_vertices", result.number_of_unreached_vertices);
  json.set("maximum_distance", result.maximum_distance);
  using command_line::count_of;
  std::cout << count_of(tm.number_of_faces(), "face", "faces") << ", "
            << count_of(field.number_of_sources(), "source", "sources") << ", "
            << count_of(number_of_windows, "window", "windows") << ", largest distance " << result.maximum_distance
            << ", " << count_of(result.number_of_unreached_vertices, "vertex", "vertices") << " unreached, "
            << result.seconds << " s\n";

  bool is_valid = true;
  if(args.has("certified"))
  {
    auto enclosures = tm.add_property_map<Mesh::Vertex_index, CGAL::Interval_nt<>>("v:enclosure").first;
    const QM::Distance_certificate certificate =
      QM::certify_distances(field, enclosures, params::visitor(std::ref(progress_bar)));
    write_enclosures(args.has("enclosures-out") ? args.value<std::string>("enclosures-out") : out + ".enclosures.txt",
                     file_vertices, enclosures);
    std::cout << "the distances are certain up to " << certificate.largest_width << ", relative to the distance "
              << certificate.largest_relative_width << "\n";
    json.set("enclosure_width", certificate.largest_relative_width);
    json.set("largest_enclosure_width", certificate.largest_width);
  }
  std::vector<std::vector<Point_3>> paths;
  if(args.has("paths-from"))
  {
    for(const QM::File_polyline& part : command_line::read_lines(args.value<std::string>("paths-from")))
      for(const Point_3& p : points_of(part))
      {
        std::vector<Location> path;
        field.shortest_path(tracer().locate(p), std::back_inserter(path));
        paths.emplace_back();
        for(const Location& l : path)
          paths.back().push_back(tracer().point(l));
      }
    command_line::write_lines(args.has("paths-out") ? args.value<std::string>("paths-out") : out + ".paths.txt", paths);
  }

  Mesh refined;
  const Mesh* result_mesh = &tm;
  auto distance = tm.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  if(args.has("refine"))
  {
    distance = refined.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
    const QM::Distance_refinement_result r =
      QM::refine_distance_field(field, refined, distance, args.value<double>("refine"));
    std::cout << "interpolation error " << r.initial_error << " refined to " << r.error << " with "
              << count_of(r.number_of_faces, "face", "faces") << "\n";
    json.set("interpolation_error", r.error);
    json.set("refined_faces", r.number_of_faces);
    is_valid = is_valid && r;
    result_mesh = &refined;
  }
  else
    for(Mesh::Vertex_index v : tm.vertices())
      distance[v] = field.distance(v);

  if(extension == "ply")
    write_distances(out, *result_mesh, [&](Mesh::Vertex_index v) { return distance[v]; });
  else
    write_distances_of_file(out, file_vertices, distance);
  if(args.has("isolines"))
  {
    const Isolines isolines =
      trace_isolines(*result_mesh, distance, args.value<double>("isolines"), result.maximum_distance);
    command_line::write_lines(
      args.has("isolines-out") ? args.value<std::string>("isolines-out") : out + ".isolines.txt", isolines.polylines);
    json.set("isolines", isolines.polylines.size());
  }

  json.set("total_seconds", timer.time());
  if(args.has("json"))
    command_line::write_json(args.value<std::string>("json"), json);
  if(command_line::shows_scene(args))
    write_page(args, json, *result_mesh, distance, result.maximum_distance, paths);
  return is_valid ? command_line::done : command_line::not_valid;
}

} // namespace

int main(int argc, char* argv[])
{
  return command_line::run("geodesic_distance", [&] { return distances(argc, argv); });
}
