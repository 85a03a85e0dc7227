// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The module quad_meshing: functions of the package for Python, with arrays of numpy.

#include "bindings.h"

PYBIND11_MODULE(quad_meshing, module)
{
  module.doc() = R"(Quad meshes from triangle meshes.

Points are arrays of shape (n, 3), triangles of shape (m, 3), quads of shape (m, 4); elements are numbered from 0.
Lengths are in the unit of the points, angles in degrees. Functions raise ValueError for arguments that cannot be used.
Results of methods have `is_valid` and `message`: look at them.)";
  bind_io(module);
  bind_quadrangulation(module);
  bind_stages(module);
  bind_measures(module);
  bind_geodesics(module);
  bind_mixed_integer(module);
}
