// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include "guides.h"

#include <array>
#include <cmath>

namespace numpy_meshes {

namespace QM = CGAL::Quad_meshing;

namespace {

// A whole number in an array of floating point numbers.
int whole_number(double x, const std::string& name)
{
  const double largest = 1e6; // more than any index
  if(!(std::abs(x) <= largest) || x != std::round(x))
    throw std::invalid_argument(name + " must be a whole number");
  return static_cast<int>(x);
}

} // namespace

std::vector<QM::Index_guide> index_guides_of(const std::optional<Doubles>& indices, const std::optional<Doubles>& sums)
{
  std::vector<QM::Index_guide> guides;
  if(indices)
  {
    if(indices->ndim() != 2 || (indices->shape(1) != 4 && indices->shape(1) != 5))
      throw std::invalid_argument("indices must have the shape (n, 4) or (n, 5)");
    const auto a = indices->unchecked<2>();
    for(py::ssize_t i = 0; i < a.shape(0); ++i)
    {
      QM::Index_guide g;
      g.name = "indices[" + std::to_string(i) + "]";
      g.point = Point_3(a(i, 0), a(i, 1), a(i, 2));
      g.index = whole_number(a(i, 3), g.name + ": the index");
      g.radius = a.shape(1) == 5 ? a(i, 4) : 0;
      guides.push_back(g);
    }
  }
  if(sums)
  {
    check_shape(*sums, "index_sums", 5);
    const auto a = sums->unchecked<2>();
    for(py::ssize_t i = 0; i < a.shape(0); ++i)
    {
      QM::Index_guide g;
      g.name = "index_sums[" + std::to_string(i) + "]";
      g.point = Point_3(a(i, 0), a(i, 1), a(i, 2));
      g.radius = a(i, 3);
      g.index = whole_number(a(i, 4), g.name + ": the sum");
      g.is_sum = true;
      guides.push_back(g);
    }
  }
  return guides;
}

std::vector<QM::Guide_connection> connections_of(const std::optional<Doubles>& connections)
{
  std::vector<QM::Guide_connection> result;
  if(!connections)
    return result;
  check_shape(*connections, "connections", 6);
  const auto a = connections->unchecked<2>();
  for(py::ssize_t i = 0; i < a.shape(0); ++i)
  {
    QM::Guide_connection c;
    c.name = "connections[" + std::to_string(i) + "]";
    c.from = Point_3(a(i, 0), a(i, 1), a(i, 2));
    c.to = Point_3(a(i, 3), a(i, 4), a(i, 5));
    result.push_back(c);
  }
  return result;
}

std::vector<QM::Size_disc> size_discs_of(const std::optional<Doubles>& discs)
{
  std::vector<QM::Size_disc> result;
  if(!discs)
    return result;
  check_shape(*discs, "size_discs", 5);
  const auto a = discs->unchecked<2>();
  for(py::ssize_t i = 0; i < a.shape(0); ++i)
  {
    QM::Size_disc d;
    d.name = "size_discs[" + std::to_string(i) + "]";
    d.center = Point_3(a(i, 0), a(i, 1), a(i, 2));
    d.radius = a(i, 3);
    d.length = a(i, 4);
    result.push_back(d);
  }
  return result;
}

std::vector<QM::Symmetry_plane> symmetry_planes_of(const std::vector<py::object>& planes)
{
  std::vector<QM::Symmetry_plane> result;
  for(const py::object& plane : planes)
  {
    if(py::isinstance<py::str>(plane))
    {
      const std::size_t c = choice("symmetry", plane.cast<std::string>(), { "x", "y", "z", "auto" });
      result.push_back(c == 3 ? QM::Symmetry_plane() : QM::Symmetry_plane::with_normal(c == 0, c == 1, c == 2));
      continue;
    }
    std::array<double, 4> n = { { 0, 0, 0, 0 } };
    try
    {
      n = plane.cast<std::array<double, 4>>();
    }
    catch(const py::cast_error&)
    {
      throw std::invalid_argument("symmetry must be a list of 'x', 'y', 'z', 'auto' or four numbers");
    }
    result.push_back(QM::Symmetry_plane::with_equation(n[0], n[1], n[2], n[3]));
  }
  return result;
}

std::vector<double> lengths_of(const Doubles& array, const std::string& name, std::size_t size)
{
  if(array.ndim() != 1 || array.shape(0) != static_cast<py::ssize_t>(size))
    throw std::invalid_argument(name + " must have the shape (" + std::to_string(size) + ",)");
  return std::vector<double>(array.data(), array.data() + size);
}

} // namespace numpy_meshes
