// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "bindings.h"
#include "guides.h"
#include "numpy_meshes.h"

#include <CGAL/Quad_meshing/Fields/cross_field_directions.h>
#include <CGAL/Quad_meshing/IO/write_html_page.h>
#include <CGAL/Quad_meshing/IO/write_png_picture.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>
#include <CGAL/Quad_meshing/Pipeline/quadrangulation_layers.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace py = pybind11;
namespace QM = CGAL::Quad_meshing;
using namespace numpy_meshes;

namespace {

// A run with its input, as Python holds it.
struct Run
{
  Mesh input;
  std::unique_ptr<QM::Quadrangulation> quadrangulation;
  QM::Quadrangulation_result result;

  const QM::Quadrangulation_surface& surface() const { return quadrangulation->surface(); }
  const QM::Quadrangulation_quads& quads() const { return quadrangulation->quads(); }
};

// Lets Ctrl-C end a computation.
struct Interruptible_visitor : QM::Default_visitor
{
  bool go_further()
  {
    py::gil_scoped_acquire lock;
    return PyErr_CheckSignals() == 0;
  }
};

std::unique_ptr<Run>
quadrangulate(const Doubles& points, const Integers& triangles, double target_quads, double target_edge_length,
              double sharp_angle, bool align_boundary, const std::optional<Integers>& feature_edges,
              const std::optional<Doubles>& directions, double curvature_alignment, double singularity_cost,
              const std::string& field, const std::string& rounding, bool optimize_structure, bool semi_regular,
              bool work_on_input, unsigned int threads, unsigned int seed, const std::optional<double>& time_limit,
              const std::optional<Integers>& curve_edges, const Curve_arrays& curves, const Curve_arrays& strokes,
              double stroke_weight, const std::optional<Doubles>& indices, const std::optional<Doubles>& index_sums,
              const std::optional<Doubles>& connections, const std::optional<Doubles>& face_lengths,
              const std::optional<Doubles>& vertex_lengths, const std::optional<Doubles>& size_discs,
              const std::string& sizing, const std::vector<py::object>& symmetry, double symmetry_tolerance)
{
  auto run = std::make_unique<Run>();
  run->input = triangle_mesh(points, triangles);
  Mesh& tm = run->input;
  run->quadrangulation = std::make_unique<QM::Quadrangulation>(tm, tm.points());
  QM::Quadrangulation& q = *run->quadrangulation;
  if(feature_edges)
    q.set_feature_edges(tm, marked_edges(tm, feature_edges));
  if(curve_edges)
    q.set_curve_edges(tm, marked_edges(tm, curve_edges, "curve_edges"));
  if(face_lengths)
  {
    const std::vector<double> lengths = lengths_of(*face_lengths, "face_lengths", tm.number_of_faces());
    q.set_face_lengths(tm, boost::make_iterator_property_map(lengths.begin(), get(boost::face_index, tm)));
  }
  if(vertex_lengths)
  {
    const std::vector<double> lengths = lengths_of(*vertex_lengths, "vertex_lengths", tm.number_of_vertices());
    q.set_vertex_lengths(tm, boost::make_iterator_property_map(lengths.begin(), get(boost::vertex_index, tm)));
  }
  const QM::Sizing_method sizings[] = { QM::Sizing_method::CONSTANT, QM::Sizing_method::CURVATURE,
                                        QM::Sizing_method::FEATURE_SIZE };
  q.options.sizing_method = sizings[choice("sizing", sizing, { "constant", "curvature", "features" })];
  q.options.feature_curves = curves_of<QM::Guide_curve>(curves, "curves");
  q.options.strokes = curves_of<QM::Guide_stroke>(strokes, "strokes");
  for(QM::Guide_stroke& stroke : q.options.strokes)
    stroke.weight = stroke_weight;
  q.options.index_guides = index_guides_of(indices, index_sums);
  q.options.connections = connections_of(connections);
  q.options.size_discs = size_discs_of(size_discs);
  q.options.symmetry_planes = symmetry_planes_of(symmetry);
  q.options.symmetry_tolerance = symmetry_tolerance;
  if(directions)
  {
    const auto d = directions_of(*directions, tm.number_of_faces());
    q.set_directions(tm, boost::make_iterator_property_map(d.begin(), get(boost::face_index, tm)));
  }
  const QM::Cross_field_method methods[] = { QM::Cross_field_method::REPRESENTATION, QM::Cross_field_method::GREEDY,
                                             QM::Cross_field_method::GREEDY_AND_SEARCH,
                                             QM::Cross_field_method::POLISHED };
  const QM::Rounding_method roundings[] = { QM::Rounding_method::DIRECT, QM::Rounding_method::GREEDY,
                                            QM::Rounding_method::LATTICE };
  if(target_edge_length == 0)
    check_positive("target_quads", target_quads);
  else
    check_positive("target_edge_length", target_edge_length);
  if(!(curvature_alignment >= 0 && curvature_alignment <= 1))
    throw std::invalid_argument("curvature_alignment must be a number from 0 to 1");
  if(!(singularity_cost >= 0 && std::isfinite(singularity_cost)))
    throw std::invalid_argument("singularity_cost must be a number, 0 or more");
  if(threads < 1)
    throw std::invalid_argument("threads must be at least 1");
  q.options.target_number_of_quads = target_quads;
  q.options.target_edge_length = target_edge_length;
  q.options.sharpness_angle = sharp_angle;
  q.options.align_boundary = align_boundary;
  q.options.curvature_alignment = curvature_alignment;
  q.options.singularity_cost = singularity_cost;
  q.options.cross_field_method =
    methods[choice("field", field, { "representation", "greedy", "greedy-and-search", "polished" })];
  q.options.rounding_method = roundings[choice("rounding", rounding, { "direct", "greedy", "lattice" })];
  q.options.optimize_structure = optimize_structure;
  q.options.semi_regular = semi_regular;
  q.options.work_on_input = work_on_input;
  q.options.number_of_threads = threads;
  q.options.random_seed = seed;
  if(time_limit)
  {
    check_positive("time_limit", *time_limit);
    q.options.maximum_running_time = *time_limit;
  }
  {
    py::gil_scoped_release unlock;
    Interruptible_visitor visitor;
    run->result = q.run(visitor);
  }
  if(PyErr_Occurred())
    throw py::error_already_set();
  if(run->result.status == QM::Quadrangulation_status::INVALID_INPUT)
    throw std::invalid_argument(run->result.message);
  return run;
}

Doubles cross_field(const Run& run)
{
  const QM::Quadrangulation_surface& s = run.surface();
  std::vector<Vector_3> directions;
  for(Mesh::Face_index f : s.mesh.faces())
    directions.push_back(QM::cross_field_direction(f, s.mesh, s.angle));
  return filled<Doubles>(directions.size(), 3, [&](std::size_t i, std::size_t j) { return directions[i][int(j)]; });
}

Doubles integer_grid(const Run& run)
{
  const QM::Quadrangulation_surface& s = run.surface();
  Doubles array({ static_cast<py::ssize_t>(s.mesh.number_of_faces()), py::ssize_t(3), py::ssize_t(2) });
  auto a = array.mutable_unchecked<3>();
  for(Mesh::Face_index f : s.mesh.faces())
  {
    py::ssize_t k = 0;
    for(Mesh::Halfedge_index h : CGAL::halfedges_around_face(s.mesh.halfedge(f), s.mesh))
    {
      a(py::ssize_t(f), k, 0) = s.uv[h].x();
      a(py::ssize_t(f), k, 1) = s.uv[h].y();
      ++k;
    }
  }
  return array;
}

void write_scene(const Run& run, const std::string& filename, bool is_picture)
{
  QM::Scene scene;
  scene.title = "Quadrangulation";
  scene.message = run.result.message;
  scene.is_side_by_side = true;
  QM::add_quadrangulation_layers(scene, run.input, *run.quadrangulation);
  std::ofstream out(filename, std::ios::binary);
  const QM::Scene_writing_result result =
    is_picture ? QM::write_png_picture(out, scene) : QM::write_html_page(out, scene);
  if(!result.is_valid())
    throw std::runtime_error(filename + ": " + result.message);
}

// The figures of a run under their names in C++.
py::dict figures(const Run& run)
{
  const QM::Quadrangulation_result& r = run.result;
  py::dict d;
  d["input_faces"] = r.input_faces;
  d["components"] = r.components;
  d["failed_components"] = r.failed_components;
  d["refined_components"] = r.refined_components;
  d["divided_vertices"] = r.divided_vertices;
  d["target_edge_length"] = r.target_edge_length;
  d["feature_edges"] = r.feature_edges;
  d["dropped_feature_edges"] = r.dropped_feature_edges;
  d["released_feature_share"] = r.released_feature_share;
  d["singularities"] = r.singularities;
  d["field_energy"] = r.field_energy;
  d["parameterization_energy"] = r.parameterization_energy;
  d["parameterization_attempts"] = r.parameterization_attempts;
  d["flipped_triangles"] = r.flipped_triangles;
  d["quads"] = r.quads;
  d["irregular_vertices"] = r.irregular_vertices;
  d["folded_quads"] = r.folded_quads;
  d["total_seconds"] = r.total_seconds;
  return d;
}

} // namespace

void bind_quadrangulation(py::module_& module)
{
  py::class_<Run>(module, "Quadrangulation",
                  R"(A quad mesh, and what its stages left behind; the answer of quadrangulate().

"Working triangles" are those that field and map lie on: of a working mesh, or of the input with edges split.)")
    .def_property_readonly(
      "is_valid", [](const Run& r) { return r.result.is_valid(); },
      "Whether there is a pure quad mesh with the topology of the input.")
    .def_property_readonly(
      "is_as_requested", [](const Run& r) { return r.result.is_as_requested; },
      "Whether all that was asked for was met.")
    .def_property_readonly(
      "status", [](const Run& r) { return std::string(QM::status_name(r.result.status)); },
      "'valid', 'not_valid', 'failed', 'refused', 'stopped' or 'out_of_time'.")
    .def_property_readonly(
      "message", [](const Run& r) { return r.result.message; }, "How it ended, as a sentence.")
    .def_property_readonly(
      "unmet_guides", [](const Run& r) { return r.result.unmet_guides; },
      "The guides that the mesh does not meet, a list of sentences.")
    .def_property_readonly("figures", &figures, "The figures of the run as a dict; times in seconds.")
    .def_property_readonly(
      "points", [](const Run& r) { return points_array(r.quads().mesh); }, "The points of the quads, shape (n, 3).")
    .def_property_readonly(
      "quads", [](const Run& r) { return faces_array(r.quads().mesh, 4); },
      "The quads, shape (m, 4), counterclockwise.")
    .def_property_readonly(
      "feature_edges", [](const Run& r) { return edges_array(r.quads().mesh, r.quads().is_feature); },
      "The edges of quads along feature edges, shape (k, 2).")
    .def_property_readonly(
      "input_faces",
      [](const Run& r) { return map_array<Integers>(r.quads().mesh.number_of_vertices(), r.quads().input_face); },
      "The triangle of the input that each point of the quads lies in, shape (n,).")
    .def_property_readonly(
      "working_points", [](const Run& r) { return points_array(r.surface().mesh); },
      "The points of the working triangles, shape (p, 3).")
    .def_property_readonly(
      "working_triangles", [](const Run& r) { return faces_array(r.surface().mesh, 3); },
      "The working triangles, shape (q, 3).")
    .def_property_readonly(
      "working_feature_edges", [](const Run& r) { return edges_array(r.surface().mesh, r.surface().is_feature); },
      "The edges of working triangles that quads follow, shape (k, 2).")
    .def_property_readonly(
      "origins",
      [](const Run& r) { return map_array<Integers>(r.surface().mesh.number_of_faces(), r.surface().origin); },
      "The triangle of the input in or at which each working triangle lies, shape (q,).")
    .def_property_readonly("cross_field", &cross_field,
                           "One of the four directions of each working triangle, unit vectors of shape (q, 3).")
    .def_property_readonly(
      "singularity_indices",
      [](const Run& r) { return map_array<Integers>(r.surface().mesh.number_of_vertices(), r.surface().index); },
      "The index of the cross field at each working point in quarters, shape (p,): 1 for three quads, -1 for five.")
    .def_property_readonly("integer_grid_map", &integer_grid,
                           "The coordinates of the three corners of each working triangle in the integer grid, "
                           "shape (q, 3, 2).")
    .def(
      "write_html", [](const Run& r, const std::string& f) { write_scene(r, f, false); }, py::arg("filename"),
      "Writes a page that shows all of this in three dimensions.")
    .def(
      "write_png", [](const Run& r, const std::string& f) { write_scene(r, f, true); }, py::arg("filename"),
      "Writes a picture of the quads, 640 x 480 pixels.");

  module.def(
    "quadrangulate", &quadrangulate, py::arg("points"), py::arg("triangles"), py::kw_only(),
    py::arg("target_quads") = 4000., py::arg("target_edge_length") = 0., py::arg("sharp_angle") = 40.,
    py::arg("align_boundary") = true, py::arg("feature_edges") = py::none(), py::arg("directions") = py::none(),
    py::arg("curvature_alignment") = 1., py::arg("singularity_cost") = QM::Quadrangulation_options().singularity_cost,
    py::arg("field") = "polished", py::arg("rounding") = "greedy", py::arg("optimize_structure") = false,
    py::arg("semi_regular") = false, py::arg("work_on_input") = false, py::arg("threads") = 1, py::arg("seed") = 0,
    py::arg("time_limit") = py::none(), py::arg("curve_edges") = py::none(), py::arg("curves") = Curve_arrays(),
    py::arg("strokes") = Curve_arrays(), py::arg("stroke_weight") = QM::Guide_stroke().weight,
    py::arg("indices") = py::none(), py::arg("index_sums") = py::none(), py::arg("connections") = py::none(),
    py::arg("face_lengths") = py::none(), py::arg("vertex_lengths") = py::none(), py::arg("size_discs") = py::none(),
    py::arg("sizing") = "constant", py::arg("symmetry") = std::vector<py::object>(),
    py::arg("symmetry_tolerance") = QM::Quadrangulation_options().symmetry_tolerance,
    R"(Makes a quad mesh of a triangle mesh. Returns a Quadrangulation; look at its is_valid.

points: (n, 3), triangles: (m, 3), an oriented manifold.
target_quads: about how many quads; counts only where target_edge_length is 0.
target_edge_length: of the quads, in the unit of the points.
sharp_angle: angle between normals in degrees from which on an edge is sharp; 180: none is.
align_boundary: whether borders become chains of quad edges.
feature_edges: (k, 2), pairs of points; none are detected then.
directions: (m, 3), a vector in the plane of each triangle that the quads follow; rows of zeros or nan: none.
curvature_alignment: from 0 to 1, how much quads follow the directions in which the surface bends least.
singularity_cost: 0 or more, what an irregular vertex must save; more means fewer of them.
field: 'representation', 'greedy', 'greedy-and-search' or 'polished'. rounding: 'direct', 'greedy' or 'lattice'.
optimize_structure: whether the base complex is made coarser.
semi_regular: whether the quads are then made anew along it.
work_on_input: whether field and map lie on the given triangles instead of a working mesh.
threads, seed: the result does not depend on the number of threads.
time_limit: in seconds; the best mesh until then is the result.

Guides; what is not met stands in Quadrangulation.unmet_guides. Points are projected to the surface.
curve_edges: (k, 2), pairs of points: edges that become chains of quad edges besides those that are detected.
curves: a list of arrays (n, 3), polylines that become chains of quad edges; closed if the last point is the first one.
strokes: the same; the quads follow their direction. stroke_weight: positive; inf: exactly.
indices: (n, 4) or (n, 5), rows x, y, z, index in quarters (1: three quads, -1: five, 0: none irregular), and, for index
0, the radius of a region without irregular vertices.
index_sums: (n, 5), rows x, y, z, radius, sum of the indices in that region.
connections: (n, 6), rows x, y, z, x, y, z: places of irregular vertices that a straight chain of quad edges joins.
face_lengths: (m,), vertex_lengths: (n,): lengths of quad edges, 0 where there is no wish.
size_discs: (n, 5), rows x, y, z, radius, length.
sizing: 'constant', 'curvature' or 'features': what lengths adapt to elsewhere.
symmetry: a list of planes: 'x', 'y', 'z', 'auto' or (a, b, c, d). symmetry_tolerance: over the diagonal.)");
}
