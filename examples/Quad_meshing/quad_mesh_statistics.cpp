// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Measures a quad mesh: its topology, its structure, the shape of its quads, and how well it
// represents the triangle mesh that it stands for.

#include "command_line.h"
#include "quad_mesh_files.h"
#include "scene_files.h"
#include "triangle_input.h"

#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/Pipeline/quadrangulation_layers.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_deviation.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <optional>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

// Prints each figure and keeps it for the JSON file.
class Report
{
  QM::Flat_json m_json;

public:
  const QM::Flat_json& json() const { return m_json; }

  void title(const std::string& text) { std::cout << "\n" << text << "\n"; }

  template <typename T>
  void add(const std::string& key, const T& value, const std::string& label)
  {
    m_json.set(key, value);
    std::cout << "  " << label << std::string(label.size() < 44 ? 44 - label.size() : 1, ' ') << value << "\n";
  }
};

std::string valences(const std::map<int, std::size_t>& counts)
{
  std::string text;
  for(const auto& c : counts)
    text += (text.empty() ? "" : " ") + std::to_string(c.first) + ":" + std::to_string(c.second);
  return text;
}

template <std::size_t N>
std::string histogram(const std::array<std::size_t, N>& counts)
{
  std::string text;
  for(std::size_t c : counts)
    text += (text.empty() ? "" : " ") + std::to_string(c);
  return text;
}

const char* name_of(QM::Quad_mesh_class c)
{
  return c == QM::Quad_mesh_class::REGULAR                ? "regular"
         : c == QM::Quad_mesh_class::SEMI_REGULAR         ? "semi-regular"
         : c == QM::Quad_mesh_class::VALENCE_SEMI_REGULAR ? "valence semi-regular"
                                                          : "unstructured";
}

void report_structure(const Mesh& qm, Report& r)
{
  const QM::Quad_mesh_structure s = QM::quad_mesh_structure(qm);
  r.title("Topology");
  r.add("vertices", s.number_of_vertices, "vertices");
  r.add("edges", s.number_of_edges, "edges");
  r.add("quads", s.number_of_quads, "quads");
  r.add("components", s.number_of_components, "components");
  r.add("boundary_loops", s.number_of_boundary_loops, "boundary loops");
  r.add("euler_characteristic", s.euler_characteristic, "Euler characteristic");

  r.title("Irregular vertices");
  r.add("irregular_vertices", s.number_of_irregular_vertices, "irregular vertices");
  r.add("irregular_inner_valences", valences(s.inner_valences), "  inside (valence:number)");
  r.add("irregular_boundary_valences", valences(s.boundary_valences), "  on the boundary (valence:number)");
  r.add("irregular_share", s.irregularity(), "irregular vertices per vertex");

  r.title("Dual curves");
  r.add("dual_curves", s.number_of_dual_curves, "dual curves");
  r.add("dual_curves_closed", s.number_of_closed_dual_curves, "  closed");
  r.add("dual_curves_self_intersecting", s.number_of_self_intersecting_dual_curves, "  crossing themselves");
  r.add("dual_curve_self_intersections", s.number_of_self_intersections, "quads in which a curve crosses itself");
  r.add("dual_curve_classes", s.number_of_parallel_classes, "classes of parallel dual curves");
  r.add("dual_curve_longest", s.longest_dual_curve, "longest dual curve (quads)");

  r.title("Base complex");
  r.add("base_complex", s.number_of_patches, "patches");
  r.add("base_complex_nodes", s.number_of_nodes, "nodes");
  r.add("base_complex_arcs", s.number_of_arcs, "arcs");
  r.add("base_complex_share", s.patch_density(), "patches per quad");
  r.add("helices", s.number_of_helices, "minimal helices");
  r.add("helices_with_crossings", s.number_of_helices_with_crossings, "  and with turns that cross themselves");
  r.add("helix_smallest_pitch", s.smallest_pitch, "  smallest pitch");
  r.add("helix_largest_winding_number", s.largest_winding_number, "  largest winding number");
  r.add("class", name_of(s.classification()), "class");
}

void report_quality(const Mesh& qm, Report& r, int number_of_worst)
{
  const QM::Quad_mesh_quality q = QM::quad_mesh_quality(qm);
  r.title("Angles (degrees)");
  r.add("angle_deviation_mean", q.mean_angle_deviation, "mean deviation from 90");
  r.add("angle_deviation_max", q.maximal_angle_deviation, "largest deviation from 90");
  r.add("angle_min", q.minimal_angle, "smallest");
  r.add("angle_max", q.maximal_angle, "largest");
  r.add("angle_histogram", histogram(q.angle_histogram), "corners per ten degrees, reflex last");

  r.title("Lengths");
  r.add("edge_length_mean", q.mean_edge_length, "mean edge length");
  r.add("edge_length_variation", q.edge_length_variation, "standard deviation over mean");
  r.add("edge_length_min", q.minimal_edge_length, "shortest edge");
  r.add("edge_length_max", q.maximal_edge_length, "longest edge");
  r.add("edge_length_histogram", histogram(q.edge_length_histogram), "edges per tenth of the mean");
  r.add("aspect_ratio_mean", q.mean_aspect_ratio, "mean aspect ratio");
  r.add("aspect_ratio_max", q.maximal_aspect_ratio, "largest aspect ratio");

  r.title("Shape");
  r.add("minimal_scaled_jacobian", q.minimal_scaled_jacobian, "smallest scaled Jacobian");
  r.add("mean_scaled_jacobian", q.mean_scaled_jacobian, "mean scaled Jacobian");
  r.add("inverted_quads", q.number_of_inverted_quads, "quads with scaled Jacobian <= 0");
  r.add("scaled_jacobian_histogram", histogram(q.scaled_jacobian_histogram), "quads per tenth, <= 0 first");
  r.add("planarity_mean", q.mean_planarity, "mean gap of the diagonals over side");
  r.add("planarity_max", q.maximal_planarity, "largest gap of the diagonals over side");

  std::string worst;
  for(const auto& w : QM::worst_quads(qm, number_of_worst))
    worst += (worst.empty() ? "" : " ") + std::to_string(static_cast<std::size_t>(w.first));
  r.add("worst_quads", worst, "quads of smallest scaled Jacobian");
}

typedef std::vector<std::optional<Kernel::Vector_3>> Directions;

// The principal directions of a surface, where they are reliable at the size of the quads (thesis 8.1).
template <typename EdgeIsSharp>
Directions principal_directions(const Mesh& tm, EdgeIsSharp is_sharp, double edge_length)
{
  Directions direction(tm.number_of_faces());
  std::vector<double> weight(tm.number_of_faces());
  const auto face_index = get(boost::face_index, tm);
  QM::curvature_directions(tm, edge_length, boost::make_iterator_property_map(direction.begin(), face_index),
                           boost::make_iterator_property_map(weight.begin(), face_index),
                           CGAL::parameters::minimum_anisotropy(0.8).edge_is_constrained_map(is_sharp));
  return direction;
}

void report_deviation(const Mesh& qm, Mesh& tm, double sharp_angle, Directions direction, Report& r)
{
  auto is_sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  if(sharp_angle < 180)
    PMP::detect_sharp_edges(tm, sharp_angle, is_sharp);
  if(direction.empty())
    direction = principal_directions(tm, is_sharp, QM::quad_mesh_quality(qm).mean_edge_length);
  const QM::Quad_mesh_deviation d =
    QM::quad_mesh_deviation(qm, tm, CGAL::parameters::default_values(),
                            CGAL::parameters::face_direction_map(
                              boost::make_iterator_property_map(direction.begin(), get(boost::face_index, tm)))
                              .edge_is_constrained_map(is_sharp));
  r.title("Against the reference (distances over the diagonal of its bounding box)");
  r.add("distance_to_reference_max", d.quads_to_reference_max, "quads to reference, largest");
  r.add("distance_to_reference_rms", d.quads_to_reference_rms, "quads to reference, root mean square");
  r.add("distance_from_reference_max", d.reference_to_quads_max, "reference to quads, largest");
  r.add("distance_from_reference_rms", d.reference_to_quads_rms, "reference to quads, root mean square");
  r.add("opposed_quads_share", d.opposed_quads, "share of quads with opposed normal");
  r.add("sharp_length", d.feature_length, "length of sharp edges in mean quad edges");
  r.add("sharp_kept", d.features_kept, "share of that length on quad edges");
  r.add("boundary_length", d.boundary_length, "length of the boundary in mean quad edges");
  r.add("boundary_kept", d.boundary_kept, "share of that length on boundary edges");

  r.title("Orientation (degrees between quad edges and the directions of the reference, 0 to 45)");
  r.add("oriented_edges", d.oriented_edges, "edges where the reference has a direction");
  r.add("orientation_deviation_mean", d.orientation_deviation_mean, "mean deviation");
  r.add("orientation_over_15", d.orientation_over_15, "share of edges over 15");
  r.add("orientation_histogram", histogram(d.orientation_histogram), "edges per five degrees");
}

// What the page shows: the quads, or the faces as they are, and the reference.
void write_page(const command_line::Arguments& args, const Report& report, const Mesh& qm, const Mesh& reference,
                const std::vector<Point_3>& points, const std::vector<std::vector<std::size_t>>& polygons)
{
  QM::Scene scene;
  if(reference.number_of_faces() > 0)
  {
    scene.layers.push_back(QM::make_display_layer(reference, "triangles", "Reference", scene));
    scene.layers.back().side = QM::Scene_side::LEFT;
    scene.is_side_by_side = true;
  }
  if(qm.number_of_faces() > 0)
  {
    scene.message = "A pure quad mesh.";
    QM::add_quad_mesh_layers(scene, qm);
  }
  else
  {
    scene.message = "Not a pure quad mesh.";
    scene.layers.push_back(QM::make_polygons_layer(points, polygons, "faces", "Faces"));
  }
  command_line::write_scene_files(args, report.json(), scene);
}

} // namespace

int main(int argc, char* argv[])
{
  return command_line::run(
    "quad_mesh_statistics",
    [&]
    {
      po::options_description options("Options");
      options.add_options()("reference", po::value<std::string>(),
                            "triangle mesh that the quad mesh stands for: adds distances and kept features")(
        "directions", po::value<std::string>(),
        "file .rosy with a direction for each face of the reference, to compare the edges with; otherwise those in "
        "which "
        "the reference bends")("sharp-angle", po::value<double>()->default_value(40),
                               "edges of the reference with a larger angle between normals are sharp (degrees)")(
        "worst", po::value<long long>()->default_value(10), "number of worst quads to list")(
        "json", po::value<std::string>(), "file for the figures as one flat JSON object");
      command_line::add_scene_options(options);
      command_line::add_quad_mesh_options(options);
      command_line::Arguments args("quad_mesh_statistics", "measures the quad mesh IN", { "IN" }, options);
      if(!args.parse(argc, argv))
        return static_cast<int>(command_line::done);
      const std::string filename = args.positional(0);
      const double sharp_angle = args.number("sharp-angle", 0, 180);
      const int number_of_worst = static_cast<int>(args.whole_number("worst", 0, (std::numeric_limits<int>::max)()));

      command_line::check_scene_files(args);
      const int digits = command_line::check_quad_mesh_options(args);

      std::vector<Point_3> points;
      std::vector<std::vector<std::size_t>> polygons;
      command_line::read_soup(filename, points, polygons);
      if(polygons.empty())
        throw command_line::Unusable_input(filename + ": has no faces");

      Report report;
      const QM::Quad_mesh_defects defects = QM::find_quad_mesh_defects(points, polygons);
      std::string message;
      for(const std::string& reason : defects.reasons())
        message += (message.empty() ? "" : "; ") + reason;
      const bool is_pure = defects.is_pure_quad_mesh();
      report.add("status", is_pure ? "done" : "not a pure quad mesh", filename);
      report.add("valid", is_pure, "valid pure quad mesh");
      report.add("message", message, "reasons against it");
      report.add("faces", defects.faces, "faces");
      report.add("faces_not_quads", defects.faces_not_quads, "faces that are not quads");
      report.add("isolated_vertices", defects.isolated_vertices, "vertices without a face");

      Mesh qm, reference;
      Directions directions;
      if(args.has("reference"))
      {
        QM::Mesh_reading_result reading;
        reference = command_line::read_mesh<Mesh>(args.value<std::string>("reference"), reading);
        if(args.has("directions"))
          directions =
            command_line::read_directions<Kernel::Vector_3>(args.value<std::string>("directions"), reading.faces);
      }
      if(is_pure)
      {
        PMP::polygon_soup_to_polygon_mesh(points, polygons, qm);
        report_structure(qm, report);
        report_quality(qm, report, number_of_worst);
        if(args.has("reference"))
          report_deviation(qm, reference, sharp_angle, directions, report);
        command_line::write_patches(args, qm, digits);
      }
      if(command_line::shows_scene(args))
        write_page(args, report, qm, reference, points, polygons);
      if(args.has("json"))
        command_line::write_json(args.value<std::string>("json"), report.json());
      if(!is_pure)
        std::cerr << "quad_mesh_statistics: " << filename << ": not a pure quad mesh: " << message << std::endl;
      return static_cast<int>(is_pure ? command_line::done : command_line::not_valid);
    });
}
