// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The kernels of the room Mixed_integer.

#include <CGAL/Quad_meshing/Mixed_integer/internal/Integer_energy_impl.h>
#include <CGAL/Quad_meshing/Mixed_integer/internal/solve_mixed_integer_kernel_impl.h>
