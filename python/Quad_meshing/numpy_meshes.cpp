// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "numpy_meshes.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <cmath>
#include <stdexcept>

namespace numpy_meshes {

void check_shape(const py::array& array, const std::string& name, py::ssize_t columns)
{
  if(array.ndim() != 2 || array.shape(1) != columns)
    throw std::invalid_argument(name + " must have the shape (n, " + std::to_string(columns) + ")");
}

std::vector<Point_3> points_of(const Doubles& array, const std::string& name)
{
  check_shape(array, name, 3);
  const auto a = array.unchecked<2>();
  std::vector<Point_3> points;
  for(py::ssize_t i = 0; i < a.shape(0); ++i)
  {
    if(!std::isfinite(a(i, 0)) || !std::isfinite(a(i, 1)) || !std::isfinite(a(i, 2)))
      throw std::invalid_argument(name + ": row " + std::to_string(i) + " is not finite");
    points.emplace_back(a(i, 0), a(i, 1), a(i, 2));
  }
  return points;
}

Mesh mesh_of(const Doubles& points, const Integers& polygons, py::ssize_t corners)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const std::string name = corners == 3 ? "triangles" : "quads";
  const std::vector<Point_3> p = points_of(points, "points");
  check_shape(polygons, name, corners);
  const auto a = polygons.unchecked<2>();
  std::vector<std::vector<std::size_t>> faces;
  for(py::ssize_t i = 0; i < a.shape(0); ++i)
  {
    faces.emplace_back();
    for(py::ssize_t k = 0; k < corners; ++k)
    {
      if(a(i, k) < 0 || a(i, k) >= static_cast<long long>(p.size()))
        throw std::invalid_argument(name + ": row " + std::to_string(i) + " names point " + std::to_string(a(i, k)) +
                                    " of " + std::to_string(p.size()));
      faces.back().push_back(static_cast<std::size_t>(a(i, k)));
    }
  }
  if(faces.empty())
    throw std::invalid_argument("there are no " + name);
  if(!PMP::is_polygon_soup_a_polygon_mesh(faces))
    throw std::invalid_argument("the " + name + " are no oriented manifold; read_mesh() repairs what is in a file");
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(p, faces, mesh);
  return mesh;
}

Edge_marks marked_edges(Mesh& mesh, const std::optional<Integers>& edges, const std::string& name)
{
  Edge_marks marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:" + name, false).first;
  if(!edges)
    return marks;
  check_shape(*edges, name, 2);
  const auto a = edges->unchecked<2>();
  const auto n = static_cast<long long>(mesh.number_of_vertices());
  for(py::ssize_t i = 0; i < a.shape(0); ++i)
  {
    Mesh::Halfedge_index h = Mesh::null_halfedge();
    if(0 <= a(i, 0) && a(i, 0) < n && 0 <= a(i, 1) && a(i, 1) < n)
      h = mesh.halfedge(Mesh::Vertex_index(static_cast<Mesh::size_type>(a(i, 0))),
                        Mesh::Vertex_index(static_cast<Mesh::size_type>(a(i, 1))));
    if(h == Mesh::null_halfedge())
      throw std::invalid_argument(name + ": row " + std::to_string(i) + " is no edge of the mesh");
    marks[mesh.edge(h)] = true;
  }
  return marks;
}

std::vector<std::optional<Vector_3>> directions_of(const Doubles& array, std::size_t number_of_faces)
{
  check_shape(array, "directions", 3);
  const auto a = array.unchecked<2>();
  if(a.shape(0) != static_cast<py::ssize_t>(number_of_faces))
    throw std::invalid_argument("directions must have a row for each triangle");
  std::vector<std::optional<Vector_3>> directions(number_of_faces);
  for(py::ssize_t i = 0; i < a.shape(0); ++i)
  {
    const Vector_3 d(a(i, 0), a(i, 1), a(i, 2));
    if(std::isfinite(d.squared_length()) && d.squared_length() > 0)
      directions[static_cast<std::size_t>(i)] = d;
  }
  return directions;
}

Doubles points_array(const Mesh& mesh)
{
  return filled<Doubles>(mesh.number_of_vertices(), 3,
                         [&](std::size_t i, std::size_t j)
                         { return mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(i)))[int(j)]; });
}

Integers faces_array(const Mesh& mesh, py::ssize_t corners)
{
  std::vector<long long> numbers;
  for(Mesh::Face_index f : mesh.faces())
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      numbers.push_back(static_cast<long long>(std::size_t(v)));
  const auto columns = static_cast<std::size_t>(corners);
  if(numbers.size() != columns * mesh.number_of_faces())
    throw std::runtime_error("a face does not have " + std::to_string(corners) + " corners");
  return filled<Integers>(mesh.number_of_faces(), columns,
                          [&](std::size_t i, std::size_t j) { return numbers[columns * i + j]; });
}

Integers edges_array(const Mesh& mesh, const Edge_marks& marks)
{
  std::vector<std::array<long long, 2>> edges;
  for(Mesh::Edge_index e : mesh.edges())
    if(marks[e])
      edges.push_back({ { static_cast<long long>(std::size_t(mesh.vertex(e, 0))),
                          static_cast<long long>(std::size_t(mesh.vertex(e, 1))) } });
  return filled<Integers>(edges.size(), 2, [&](std::size_t i, std::size_t j) { return edges[i][j]; });
}

std::size_t choice(const std::string& name, const std::string& word, const std::vector<std::string>& words)
{
  std::string list;
  for(std::size_t i = 0; i < words.size(); ++i)
  {
    if(words[i] == word)
      return i;
    list += (i == 0 ? "'" : ", '") + words[i] + "'";
  }
  throw std::invalid_argument(name + " must be one of " + list + ", not '" + word + "'");
}

void check_positive(const std::string& name, double x)
{
  if(!std::isfinite(x) || !(x > 0))
    throw std::invalid_argument(name + " must be a positive number");
}

} // namespace numpy_meshes
