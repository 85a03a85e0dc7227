// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The kernels of the room Guides.

#include <CGAL/Quad_meshing/Guides/internal/cut_triangles_impl.h>
#include <CGAL/Quad_meshing/Guides/internal/mirror_triangles_impl.h>
