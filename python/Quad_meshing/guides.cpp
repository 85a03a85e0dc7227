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

// Appends a guide for each row of an array, with the name of the row, that `fill(guide, row)` completes; nothing for
// None.
template <typename Guide, typename Fill>
void append_rows(const std::optional<Doubles>& array, const std::string& name, py::ssize_t columns, const Fill& fill,
                 std::vector<Guide>& guides)
{
  if(!array)
    return;
  check_shape(*array, name, columns);
  for(py::ssize_t i = 0; i < array->shape(0); ++i)
  {
    Guide g;
    g.name = name + "[" + std::to_string(i) + "]";
    fill(g, array->data(i, 0));
    guides.push_back(g);
  }
}

} // namespace

std::vector<QM::Index_guide> index_guides_of(const std::optional<Doubles>& indices, const std::optional<Doubles>& sums)
{
  std::vector<QM::Index_guide> guides;
  const bool has_radius = indices && indices->ndim() == 2 && indices->shape(1) == 5;
  if(indices && !has_radius && (indices->ndim() != 2 || indices->shape(1) != 4))
    throw std::invalid_argument("indices must have the shape (n, 4) or (n, 5)");
  append_rows(
    indices, "indices", has_radius ? 5 : 4,
    [&](QM::Index_guide& g, const double* row)
    {
      g.point = Point_3(row[0], row[1], row[2]);
      g.index = whole_number(row[3], g.name + ": the index");
      g.radius = has_radius ? row[4] : 0;
    },
    guides);
  append_rows(
    sums, "index_sums", 5,
    [](QM::Index_guide& g, const double* row)
    {
      g.point = Point_3(row[0], row[1], row[2]);
      g.radius = row[3];
      g.index = whole_number(row[4], g.name + ": the sum");
      g.is_sum = true;
    },
    guides);
  return guides;
}

std::vector<QM::Guide_connection> connections_of(const std::optional<Doubles>& connections)
{
  std::vector<QM::Guide_connection> result;
  append_rows(
    connections, "connections", 6,
    [](QM::Guide_connection& c, const double* row)
    {
      c.from = Point_3(row[0], row[1], row[2]);
      c.to = Point_3(row[3], row[4], row[5]);
    },
    result);
  return result;
}

std::vector<QM::Size_disc> size_discs_of(const std::optional<Doubles>& discs)
{
  std::vector<QM::Size_disc> result;
  append_rows(
    discs, "size_discs", 5,
    [](QM::Size_disc& d, const double* row)
    {
      d.center = Point_3(row[0], row[1], row[2]);
      d.radius = row[3];
      d.length = row[4];
    },
    result);
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
