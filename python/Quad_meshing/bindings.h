// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_PYTHON_BINDINGS_H
#define CGAL_QUAD_MESHING_PYTHON_BINDINGS_H

// Each part of the module in a file of its own.

#include <pybind11/pybind11.h>

void bind_io(pybind11::module_& module);
void bind_quadrangulation(pybind11::module_& module);
void bind_stages(pybind11::module_& module);
void bind_measures(pybind11::module_& module);
void bind_geodesics(pybind11::module_& module);
void bind_mixed_integer(pybind11::module_& module);

#endif // CGAL_QUAD_MESHING_PYTHON_BINDINGS_H
