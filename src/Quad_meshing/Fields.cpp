// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The kernels of the room Fields.

#include <CGAL/Quad_meshing/Fields/internal/Length_field_impl.h>
#include <CGAL/Quad_meshing/Fields/internal/curvature_guides_impl.h>
#include <CGAL/Quad_meshing/Fields/internal/find_curvature_directions_impl.h>
#include <CGAL/Quad_meshing/Fields/internal/find_feature_edges_impl.h>
#include <CGAL/Quad_meshing/Fields/internal/find_feature_sizes_impl.h>
#include <CGAL/Quad_meshing/Fields/internal/inspect_field_impl.h>
#include <CGAL/Quad_meshing/Fields/internal/solve_field_impl.h>
