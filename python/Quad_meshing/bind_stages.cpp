// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "bindings.h"
#include "numpy_meshes.h"

#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>
#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/cross_field_directions.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Parameterization/integer_grid_map.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <memory>
#include <stdexcept>

namespace py = pybind11;
namespace QM = CGAL::Quad_meshing;
using namespace numpy_meshes;

namespace {

typedef Kernel::Point_2 Point_2;

Integers feature_edges(const Doubles& points, const Integers& triangles, double sharp_angle, double edge_length)
{
  Mesh tm = triangle_mesh(points, triangles);
  const Edge_marks marks = marked_edges(tm, std::nullopt);
  QM::detect_feature_edges(tm, sharp_angle, edge_length, marks);
  return edges_array(tm, marks);
}

py::tuple split_for_alignment(const Doubles& points, const Integers& triangles, double longest_edge,
                              const std::optional<Integers>& features, bool align_boundary)
{
  check_positive("longest_edge", longest_edge);
  Mesh tm = triangle_mesh(points, triangles);
  const Edge_marks marks = marked_edges(tm, features);
  const auto origin = tm.add_property_map<Mesh::Face_index, std::size_t>("f:origin", 0).first;
  for(Mesh::Face_index f : tm.faces())
    origin[f] = f;
  QM::split_for_alignment(tm, tm.points(), marks, align_boundary, origin, longest_edge);
  return py::make_tuple(points_array(tm), faces_array(tm, 3), edges_array(tm, marks),
                        filled<Integers>(tm.number_of_faces(), [&](std::size_t i)
                                         { return origin[Mesh::Face_index(static_cast<Mesh::size_type>(i))]; }));
}

// A cross field with its mesh.
struct Field
{
  Mesh mesh;
  Edge_marks features;
  bool align_boundary;
  Mesh::Property_map<Mesh::Face_index, double> angle;
  Mesh::Property_map<Mesh::Edge_index, int> period_jump;
  Mesh::Property_map<Mesh::Vertex_index, int> index;
  QM::Cross_field_result result;

  Field(const Doubles& points, const Integers& triangles, const std::optional<Integers>& feature_edges, bool align)
    : mesh(triangle_mesh(points, triangles))
    , features(marked_edges(mesh, feature_edges))
    , align_boundary(align)
    , angle(mesh.add_property_map<Mesh::Face_index, double>("f:angle", 0).first)
    , period_jump(mesh.add_property_map<Mesh::Edge_index, int>("e:period_jump", 0).first)
    , index(mesh.add_property_map<Mesh::Vertex_index, int>("v:index", 0).first)
  {
  }
  Field(const Field&) = delete; // its maps belong to its mesh
  Field& operator=(const Field&) = delete;
};

std::unique_ptr<Field> cross_field(const Doubles& points, const Integers& triangles,
                                   const std::optional<Integers>& feature_edges,
                                   const std::optional<Doubles>& directions, bool align_boundary,
                                   const std::string& method)
{
  auto field = std::make_unique<Field>(points, triangles, feature_edges, align_boundary);
  const Mesh& tm = field->mesh;
  std::vector<std::optional<Vector_3>> given(tm.number_of_faces());
  if(directions)
    given = directions_of(*directions, tm.number_of_faces());
  const QM::Cross_field_method methods[] = { QM::Cross_field_method::REPRESENTATION, QM::Cross_field_method::GREEDY,
                                             QM::Cross_field_method::GREEDY_AND_SEARCH,
                                             QM::Cross_field_method::POLISHED };
  const auto m = methods[choice("method", method, { "representation", "greedy", "greedy-and-search", "polished" })];
  py::gil_scoped_release unlock;
  field->result = QM::smooth_cross_field(
    tm, field->angle, field->period_jump, field->index,
    CGAL::parameters::cross_field_method(m)
      .edge_is_constrained_map(field->features)
      .align_boundary(align_boundary)
      .face_direction_map(boost::make_iterator_property_map(given.begin(), get(boost::face_index, tm))));
  return field;
}

Doubles directions(const Field& field)
{
  std::vector<Vector_3> d;
  for(Mesh::Face_index f : field.mesh.faces())
    d.push_back(QM::cross_field_direction(f, field.mesh, field.angle));
  return filled<Doubles>(d.size(), 3, [&](std::size_t i, std::size_t j) { return d[i][int(j)]; });
}

py::tuple integer_grid_map(const Field& field, double edge_length, const std::string& rounding)
{
  check_positive("edge_length", edge_length);
  const QM::Rounding_method roundings[] = { QM::Rounding_method::DIRECT, QM::Rounding_method::GREEDY,
                                            QM::Rounding_method::LATTICE };
  const auto method = roundings[choice("rounding", rounding, { "direct", "greedy", "lattice" })];
  Mesh tm = field.mesh;
  const auto uv = tm.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  QM::Integer_grid_map_result result;
  {
    py::gil_scoped_release unlock;
    result = QM::integer_grid_map(tm, field.angle, field.period_jump, field.index, uv,
                                  CGAL::parameters::target_edge_length(edge_length)
                                    .edge_is_constrained_map(field.features)
                                    .align_boundary(field.align_boundary)
                                    .rounding_method(method));
  }
  Doubles array({ static_cast<py::ssize_t>(tm.number_of_faces()), py::ssize_t(3), py::ssize_t(2) });
  auto a = array.mutable_unchecked<3>();
  for(Mesh::Face_index f : tm.faces())
  {
    py::ssize_t k = 0;
    for(Mesh::Halfedge_index h : CGAL::halfedges_around_face(tm.halfedge(f), tm))
    {
      a(py::ssize_t(f), k, 0) = uv[h].x();
      a(py::ssize_t(f), k, 1) = uv[h].y();
      ++k;
    }
  }
  return py::make_tuple(array, result.is_valid(), result.message);
}

py::tuple extract_quads(const Doubles& points, const Integers& triangles, const Doubles& grid)
{
  Mesh tm = triangle_mesh(points, triangles);
  if(grid.ndim() != 3 || grid.shape(0) != static_cast<py::ssize_t>(tm.number_of_faces()) || grid.shape(1) != 3 ||
     grid.shape(2) != 2)
    throw std::invalid_argument("grid must have the shape (m, 3, 2)");
  const auto uv = tm.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  const auto a = grid.unchecked<3>();
  for(Mesh::Face_index f : tm.faces())
  {
    py::ssize_t k = 0;
    for(Mesh::Halfedge_index h : CGAL::halfedges_around_face(tm.halfedge(f), tm))
    {
      uv[h] = Point_2(a(py::ssize_t(f), k, 0), a(py::ssize_t(f), k, 1));
      ++k;
    }
  }
  Mesh qm;
  QM::Quad_extraction_result result;
  {
    py::gil_scoped_release unlock;
    result = QM::extract_quad_mesh(tm, uv, qm);
  }
  if(!result.is_valid() || !CGAL::is_quad_mesh(qm))
    throw std::runtime_error(result.message);
  return py::make_tuple(points_array(qm), faces_array(qm, 4), result.message);
}

py::tuple smooth_quads(const Doubles& points, const Integers& quads, const Doubles& reference_points,
                       const Integers& reference_triangles, const std::optional<Integers>& feature_edges,
                       const std::optional<Integers>& reference_feature_edges, unsigned int iterations)
{
  Mesh qm = quad_mesh(points, quads), tm = triangle_mesh(reference_points, reference_triangles);
  const Edge_marks marks = marked_edges(qm, feature_edges), reference_marks = marked_edges(tm, reference_feature_edges);
  QM::Quad_mesh_smoothing_result result;
  {
    py::gil_scoped_release unlock;
    result = QM::smooth_quad_mesh(
      qm, tm, CGAL::parameters::smooth_globally(true).edge_is_constrained_map(marks).smoothing_iterations(iterations),
      CGAL::parameters::edge_is_constrained_map(reference_marks));
  }
  return py::make_tuple(points_array(qm), result.message);
}

} // namespace

void bind_stages(py::module_& module)
{
  module.def("feature_edges", &feature_edges, py::arg("points"), py::arg("triangles"), py::arg("sharp_angle") = 40.,
             py::arg("edge_length") = 0.,
             "The sharp edges, shape (k, 2), that are worth a chain of quad edges of that length; 0: all of them. "
             "sharp_angle: between normals, in degrees.");
  module.def("split_for_alignment", &split_for_alignment, py::arg("points"), py::arg("triangles"),
             py::arg("longest_edge"), py::arg("feature_edges") = py::none(), py::arg("align_boundary") = true,
             "Splits edges so that a map can follow feature edges and border, and edges longer than longest_edge. "
             "Returns (points, triangles, feature_edges, origins): origins, shape (m,), are the triangles before.");

  py::class_<Field>(module, "CrossField", "A cross field on a triangle mesh; the answer of cross_field().")
    .def_property_readonly(
      "is_valid", [](const Field& f) { return f.result.is_valid(); }, "Whether there is a field.")
    .def_property_readonly(
      "message", [](const Field& f) { return f.result.message; }, "How it ended, as a sentence.")
    .def_property_readonly("directions", &directions,
                           "One of the four directions of each triangle, unit vectors of shape (m, 3).")
    .def_property_readonly(
      "indices",
      [](const Field& f)
      {
        return filled<Integers>(f.mesh.number_of_vertices(), [&](std::size_t i)
                                { return f.index[Mesh::Vertex_index(static_cast<Mesh::size_type>(i))]; });
      },
      "The index at each point in quarters, shape (n,). Their sum is four times the Euler number on closed surfaces.");
  module.def("cross_field", &cross_field, py::arg("points"), py::arg("triangles"), py::kw_only(),
             py::arg("feature_edges") = py::none(), py::arg("directions") = py::none(),
             py::arg("align_boundary") = true, py::arg("method") = "polished",
             "A smooth cross field along feature edges, shape (k, 2), border and directions, shape (m, 3). method: "
             "'representation', 'greedy', 'greedy-and-search' or 'polished'. Returns a CrossField.");
  module.def("integer_grid_map", &integer_grid_map, py::arg("field"), py::arg("edge_length"),
             py::arg("rounding") = "greedy",
             "A map along a CrossField whose integer isolines are edges of quads of that length. Returns (grid, "
             "is_valid, message): grid, shape (m, 3, 2), are the coordinates of the three corners of each triangle.");
  module.def("extract_quads", &extract_quads, py::arg("points"), py::arg("triangles"), py::arg("grid"),
             "The quads of an integer-grid map, shape (m, 3, 2). Returns (points, quads, message).");
  module.def("smooth_quads", &smooth_quads, py::arg("points"), py::arg("quads"), py::arg("reference_points"),
             py::arg("reference_triangles"), py::kw_only(), py::arg("feature_edges") = py::none(),
             py::arg("reference_feature_edges") = py::none(), py::arg("iterations") = 20,
             "Moves the points of quads on a reference surface until the quads are even; feature edges, shape (k, 2), "
             "stay on those of the reference. Returns (points, message).");
}
