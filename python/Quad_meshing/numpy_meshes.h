// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PYTHON_NUMPY_MESHES_H
#define CGAL_QUAD_MESHING_PYTHON_NUMPY_MESHES_H

// Meshes from arrays of numpy and back. An array that cannot be used raises ValueError with what is wrong about it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace numpy_meshes {

namespace py = pybind11;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef py::array_t<double, py::array::c_style | py::array::forcecast> Doubles;
typedef py::array_t<long long, py::array::c_style | py::array::forcecast> Integers;

// Raises ValueError unless an array has the shape (n, columns).
void check_shape(const py::array& array, const std::string& name, py::ssize_t columns);

// The points of an array of shape (n, 3).
std::vector<Point_3> points_of(const Doubles& array, const std::string& name);

// A mesh of polygons with `corners` corners: vertex i is points[i], face i is polygons[i]. Raises ValueError if they
// are no manifold.
Mesh mesh_of(const Doubles& points, const Integers& polygons, py::ssize_t corners);

inline Mesh triangle_mesh(const Doubles& points, const Integers& triangles) { return mesh_of(points, triangles, 3); }
inline Mesh quad_mesh(const Doubles& points, const Integers& quads) { return mesh_of(points, quads, 4); }

// Marks the edges of an array of shape (k, 2) of vertex numbers.
typedef Mesh::Property_map<Mesh::Edge_index, bool> Edge_marks;
Edge_marks marked_edges(Mesh& mesh, const std::optional<Integers>& edges, const std::string& name = "feature_edges");

// Vectors of an array of shape (m, 3), none for rows of zeros or of what is not finite.
std::vector<std::optional<Vector_3>> directions_of(const Doubles& array, std::size_t number_of_faces);

// Arrays of a mesh without removed elements: points (n, 3), faces (m, corners), marked edges (k, 2).
Doubles points_array(const Mesh& mesh);
Integers faces_array(const Mesh& mesh, py::ssize_t corners);
Integers edges_array(const Mesh& mesh, const Edge_marks& marks);

// An array of shape (n, columns) filled by a function of row and column.
template <typename Array, typename Function>
Array filled(std::size_t rows, std::size_t columns, Function value)
{
  Array array({ static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns) });
  auto a = array.template mutable_unchecked<2>();
  for(std::size_t i = 0; i < rows; ++i)
    for(std::size_t j = 0; j < columns; ++j)
      a(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(j)) = value(i, j);
  return array;
}

// An array of shape (n,).
template <typename Array, typename Function>
Array filled(std::size_t size, Function value)
{
  Array array(static_cast<py::ssize_t>(size));
  auto a = array.template mutable_unchecked<1>();
  for(std::size_t i = 0; i < size; ++i)
    a(static_cast<py::ssize_t>(i)) = value(i);
  return array;
}

// The values of a property map of a mesh without removed elements, shape (n,).
template <typename Array, typename PropertyMap>
Array map_array(std::size_t size, const PropertyMap& map)
{
  typedef typename PropertyMap::key_type Index;
  return filled<Array>(size, [&](std::size_t i) { return map[Index(static_cast<Mesh::size_type>(i))]; });
}

// The place of a word in a list. Raises ValueError if it is not there.
std::size_t choice(const std::string& name, const std::string& word, const std::vector<std::string>& words);

// Raises ValueError unless a number is finite and positive.
void check_positive(const std::string& name, double x);

} // namespace numpy_meshes

#endif // CGAL_QUAD_MESHING_PYTHON_NUMPY_MESHES_H
