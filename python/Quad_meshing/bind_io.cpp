// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "bindings.h"
#include "numpy_meshes.h"

#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/IO/write_html_page.h>

#include <stdexcept>

namespace py = pybind11;
namespace QM = CGAL::Quad_meshing;
using namespace numpy_meshes;

namespace {

py::tuple read_mesh(const std::string& filename)
{
  Mesh mesh;
  const QM::Mesh_reading_result result = QM::read_triangle_mesh(filename, mesh);
  if(!result)
    throw std::invalid_argument(filename + ": " + result.message);
  return py::make_tuple(points_array(mesh), faces_array(mesh, 3), result.repairs);
}

} // namespace

void bind_io(py::module_& module)
{
  module.def("read_mesh", &read_mesh, py::arg("filename"),
             R"(Reads a triangle mesh from a file OFF, OBJ, PLY or STL and repairs it.

Returns (points, triangles, repairs): arrays of shape (n, 3) and (m, 3), and a list of sentences that say what was
repaired.)");
  module.def("has_html_viewer", &QM::has_html_viewer,
             "Whether the module was built with three.js, which Quadrangulation.write_html() needs.");
}
