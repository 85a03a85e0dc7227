// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "bindings.h"
#include "numpy_meshes.h"

#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_field.h>
#include <CGAL/Quad_meshing/Geodesics/isolines.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <stdexcept>

namespace py = pybind11;
namespace QM = CGAL::Quad_meshing;
using namespace numpy_meshes;

namespace {

typedef QM::Geodesic_distance_field<Mesh> Field;

Doubles geodesic_distance(const Doubles& points, const Integers& triangles, const std::vector<long long>& vertices,
                          const std::optional<Integers>& edges, bool border, double epsilon)
{
  Mesh tm = triangle_mesh(points, triangles);
  if(!(epsilon >= 0 && epsilon <= 1))
    throw std::invalid_argument("epsilon must be a number from 0 to 1");
  Field field(tm);
  for(long long v : vertices)
  {
    if(v < 0 || v >= static_cast<long long>(tm.number_of_vertices()))
      throw std::invalid_argument("vertices: there is no point " + std::to_string(v));
    field.add_source(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
  }
  if(edges)
  {
    const Edge_marks marks = marked_edges(tm, edges);
    std::vector<Mesh::Edge_index> sources;
    for(Mesh::Edge_index e : tm.edges())
      if(marks[e])
        sources.push_back(e);
    field.add_edges_source(sources);
  }
  if(border && field.add_border_source() == Field::no_source())
    throw std::invalid_argument("border: the mesh has none");
  if(field.number_of_sources() == 0)
    throw std::invalid_argument("there is no source: give vertices, edges or border");
  QM::Geodesic_distance_result result;
  {
    py::gil_scoped_release unlock;
    result = field.propagate(CGAL::parameters::relative_distance_error(epsilon).keep_windows(false));
  }
  if(!result)
    throw std::runtime_error(result.message);
  return filled<Doubles>(tm.number_of_vertices(), [&](std::size_t i)
                         { return field.distance(Mesh::Vertex_index(static_cast<Mesh::size_type>(i))); });
}

py::list isolines(const Doubles& points, const Integers& triangles, const std::vector<double>& values, double value)
{
  const Mesh tm = triangle_mesh(points, triangles);
  if(values.size() != tm.number_of_vertices())
    throw std::invalid_argument("values must have the shape (n,)");
  std::vector<std::vector<Point_3>> polylines;
  QM::trace_isolines(tm, boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, tm)), value,
                     std::back_inserter(polylines));
  py::list list;
  for(const std::vector<Point_3>& line : polylines)
    list.append(filled<Doubles>(line.size(), 3, [&](std::size_t i, std::size_t j) { return line[i][int(j)]; }));
  return list;
}

} // namespace

void bind_geodesics(py::module_& module)
{
  module.def(
    "geodesic_distance", &geodesic_distance, py::arg("points"), py::arg("triangles"), py::kw_only(),
    py::arg("vertices") = std::vector<long long>(), py::arg("edges") = py::none(), py::arg("border") = false,
    py::arg("epsilon") = 0.,
    R"(The distance on the surface from each point, shape (n,), to the nearest source; inf where none is reached.

vertices: numbers of points that are sources. edges: (k, 2), edges that are sources in all their points.
border: whether the border is a source. epsilon: relative error allowed; 0: exact but for rounding.)");
  module.def("isolines", &isolines, py::arg("points"), py::arg("triangles"), py::arg("values"), py::arg("value"),
             "The isolines of a value of a function that is given at the points, shape (n,), and linear in the "
             "triangles: a list of polylines, arrays of shape (k, 3). Closed ones end with their first point.");
}
