// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PYTHON_GUIDES_H
#define CGAL_QUAD_MESHING_PYTHON_GUIDES_H

// Guides from arrays of numpy. An array that cannot be used raises ValueError with what is wrong about it.

#include "numpy_meshes.h"

#include <CGAL/Quad_meshing/Guides/Guide_connection.h>
#include <CGAL/Quad_meshing/Guides/Guide_curve.h>
#include <CGAL/Quad_meshing/Guides/Index_guide.h>
#include <CGAL/Quad_meshing/Guides/Size_disc.h>
#include <CGAL/Quad_meshing/Guides/Symmetry_plane.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace numpy_meshes {

typedef std::vector<Doubles> Curve_arrays;

// Polylines of arrays of shape (n, 3); one whose last point is its first one is closed.
template <typename Curve>
std::vector<Curve> curves_of(const Curve_arrays& arrays, const std::string& name)
{
  std::vector<Curve> curves;
  for(std::size_t i = 0; i < arrays.size(); ++i)
  {
    Curve c;
    c.name = name + "[" + std::to_string(i) + "]";
    c.points = points_of(arrays[i], c.name);
    if(c.points.size() < 2)
      throw std::invalid_argument(c.name + " must have two points at least");
    c.is_closed = c.points.size() > 2 && c.points.front() == c.points.back();
    if(c.is_closed)
      c.points.pop_back();
    curves.push_back(c);
  }
  return curves;
}

// Rows x, y, z, index, and perhaps a radius; rows x, y, z, radius, sum.
std::vector<CGAL::Quad_meshing::Index_guide> index_guides_of(const std::optional<Doubles>& indices,
                                                             const std::optional<Doubles>& sums);

// Rows x, y, z, x, y, z.
std::vector<CGAL::Quad_meshing::Guide_connection> connections_of(const std::optional<Doubles>& connections);

// Rows x, y, z, radius, length.
std::vector<CGAL::Quad_meshing::Size_disc> size_discs_of(const std::optional<Doubles>& discs);

// Words 'x', 'y', 'z', 'auto', or four numbers.
std::vector<CGAL::Quad_meshing::Symmetry_plane> symmetry_planes_of(const std::vector<py::object>& planes);

// Numbers of an array of shape (size,).
std::vector<double> lengths_of(const Doubles& array, const std::string& name, std::size_t size);

} // namespace numpy_meshes

#endif // CGAL_QUAD_MESHING_PYTHON_GUIDES_H
