// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "bindings.h"
#include "numpy_meshes.h"

#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_defects.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_deviation.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_quality.h>
#include <CGAL/Quad_meshing/Quad_mesh/quad_mesh_structure.h>
#include <CGAL/Quad_meshing/Structure/optimize_quad_structure.h>

#include <CGAL/boost/graph/helpers.h>

namespace py = pybind11;
namespace QM = CGAL::Quad_meshing;
using namespace numpy_meshes;

namespace {

template <std::size_t N>
Integers counts(const std::array<std::size_t, N>& histogram)
{
  return filled<Integers>(N, [&](std::size_t i) { return static_cast<long long>(histogram[i]); });
}

py::dict quality(const Doubles& points, const Integers& quads)
{
  const QM::Quad_mesh_quality q = QM::quad_mesh_quality(quad_mesh(points, quads));
  py::dict d;
  d["quads"] = q.number_of_quads;
  d["mean_angle_deviation"] = q.mean_angle_deviation;
  d["maximal_angle_deviation"] = q.maximal_angle_deviation;
  d["minimal_angle"] = q.minimal_angle;
  d["maximal_angle"] = q.maximal_angle;
  d["angle_histogram"] = counts(q.angle_histogram);
  d["mean_edge_length"] = q.mean_edge_length;
  d["edge_length_variation"] = q.edge_length_variation;
  d["minimal_edge_length"] = q.minimal_edge_length;
  d["maximal_edge_length"] = q.maximal_edge_length;
  d["edge_length_histogram"] = counts(q.edge_length_histogram);
  d["mean_aspect_ratio"] = q.mean_aspect_ratio;
  d["maximal_aspect_ratio"] = q.maximal_aspect_ratio;
  d["minimal_scaled_jacobian"] = q.minimal_scaled_jacobian;
  d["mean_scaled_jacobian"] = q.mean_scaled_jacobian;
  d["inverted_quads"] = q.number_of_inverted_quads;
  d["scaled_jacobian_histogram"] = counts(q.scaled_jacobian_histogram);
  d["mean_planarity"] = q.mean_planarity;
  d["maximal_planarity"] = q.maximal_planarity;
  d["area"] = q.area;
  return d;
}

py::dict structure(const Doubles& points, const Integers& quads)
{
  const QM::Quad_mesh_structure s = QM::quad_mesh_structure(quad_mesh(points, quads));
  py::dict d;
  d["vertices"] = s.number_of_vertices;
  d["edges"] = s.number_of_edges;
  d["quads"] = s.number_of_quads;
  d["components"] = s.number_of_components;
  d["boundary_loops"] = s.number_of_boundary_loops;
  d["euler_characteristic"] = s.euler_characteristic;
  d["inner_valences"] = s.inner_valences;
  d["boundary_valences"] = s.boundary_valences;
  d["irregular_vertices"] = s.number_of_irregular_vertices;
  d["sum_of_indices"] = s.sum_of_indices;
  d["dual_curves"] = s.number_of_dual_curves;
  d["patches"] = s.number_of_patches;
  d["nodes"] = s.number_of_nodes;
  d["arcs"] = s.number_of_arcs;
  d["helices"] = s.number_of_helices;
  return d;
}

py::tuple base_complex(const Doubles& points, const Integers& quads)
{
  Mesh qm = quad_mesh(points, quads);
  const auto is_separatrix = qm.add_property_map<Mesh::Edge_index, bool>("e:is_separatrix", false).first;
  const auto patch = qm.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 0).first;
  QM::base_complex(qm, is_separatrix, patch);
  return py::make_tuple(map_array<Integers>(qm.number_of_faces(), patch), edges_array(qm, is_separatrix));
}

py::dict deviation(const Doubles& points, const Integers& quads, const Doubles& reference_points,
                   const Integers& reference_triangles, const std::optional<Integers>& feature_edges)
{
  Mesh tm = triangle_mesh(reference_points, reference_triangles);
  const QM::Quad_mesh_deviation v =
    QM::quad_mesh_deviation(quad_mesh(points, quads), tm, CGAL::parameters::default_values(),
                            CGAL::parameters::edge_is_constrained_map(marked_edges(tm, feature_edges)));
  py::dict d;
  d["quads_to_reference_max"] = v.quads_to_reference_max;
  d["quads_to_reference_rms"] = v.quads_to_reference_rms;
  d["reference_to_quads_max"] = v.reference_to_quads_max;
  d["reference_to_quads_rms"] = v.reference_to_quads_rms;
  d["opposed_quads"] = v.opposed_quads;
  d["feature_length"] = v.feature_length;
  d["features_kept"] = v.features_kept;
  d["boundary_length"] = v.boundary_length;
  d["boundary_kept"] = v.boundary_kept;
  return d;
}

py::list defects(const Doubles& points, const Integers& polygons)
{
  const std::vector<Point_3> p = points_of(points, "points");
  if(polygons.ndim() != 2)
    throw std::invalid_argument("polygons must have the shape (m, k)");
  const auto a = polygons.unchecked<2>();
  std::vector<std::vector<std::size_t>> faces;
  for(py::ssize_t i = 0; i < a.shape(0); ++i)
  {
    faces.emplace_back();
    for(py::ssize_t k = 0; k < a.shape(1); ++k)
    {
      if(a(i, k) < 0 || a(i, k) >= static_cast<long long>(p.size()))
        throw std::invalid_argument("polygons: row " + std::to_string(i) + " names a point that is not there");
      faces.back().push_back(static_cast<std::size_t>(a(i, k)));
    }
  }
  return py::cast(QM::find_quad_mesh_defects(p, faces).reasons());
}

py::tuple optimize_structure(const Doubles& points, const Integers& quads, const std::optional<Integers>& feature_edges,
                             std::size_t target_quads, std::size_t target_patches, unsigned int iterations,
                             bool merge_singularities)
{
  Mesh qm = quad_mesh(points, quads);
  const Edge_marks marks = marked_edges(qm, feature_edges);
  QM::Quad_structure_optimization_result result;
  {
    py::gil_scoped_release unlock;
    result = QM::optimize_quad_structure(qm, CGAL::parameters::merge_singularities(merge_singularities)
                                               .edge_is_constrained_map(marks)
                                               .number_of_iterations(iterations)
                                               .target_number_of_quads(target_quads)
                                               .target_number_of_patches(target_patches));
    qm.collect_garbage();
  }
  if(result.status != QM::Quad_mesh_status::SUCCESS)
    throw std::runtime_error(result.message);
  return py::make_tuple(points_array(qm), faces_array(qm, 4), result.message);
}

} // namespace

void bind_measures(py::module_& module)
{
  module.def("quality", &quality, py::arg("points"), py::arg("quads"),
             "Angles (degrees), edge lengths, scaled Jacobians and planarity of a quad mesh, as a dict; histograms are "
             "arrays of counts: corners per ten degrees, edges per tenth of the mean length, quads per tenth.");
  module.def("structure", &structure, py::arg("points"), py::arg("quads"),
             "Topology, irregular vertices, dual curves and base complex of a quad mesh, as a dict of numbers.");
  module.def("base_complex", &base_complex, py::arg("points"), py::arg("quads"),
             "Returns (patches, separatrices): the patch of each quad, shape (m,), and edges, shape (k, 2).");
  module.def("deviation", &deviation, py::arg("points"), py::arg("quads"), py::arg("reference_points"),
             py::arg("reference_triangles"), py::arg("feature_edges") = py::none(),
             "Distances between a quad mesh and a triangle mesh over the diagonal of its bounding box, and how much of "
             "the feature edges, shape (k, 2), and of the border lies on quad edges, as a dict.");
  module.def("defects", &defects, py::arg("points"), py::arg("polygons"),
             "What keeps polygons, shape (m, k), from being a pure quad mesh, as a list of sentences.");
  module.def("optimize_structure", &optimize_structure, py::arg("points"), py::arg("quads"), py::kw_only(),
             py::arg("feature_edges") = py::none(), py::arg("target_quads") = 0, py::arg("target_patches") = 0,
             py::arg("iterations") = 10000, py::arg("merge_singularities") = false,
             "Makes the base complex of a quad mesh coarser; feature edges, shape (k, 2), are kept. target_quads: "
             "largest number of quads, 0 for as many as there are; iterations: layouts that are tried. Returns "
             "(points, quads, message).");
}
