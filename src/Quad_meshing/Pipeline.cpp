// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The kernels of the room Pipeline.

#include <CGAL/Quad_meshing/Pipeline/internal/Grid_map_plan_impl.h>
#include <CGAL/Quad_meshing/Pipeline/internal/copy_components_impl.h>
#include <CGAL/Quad_meshing/Pipeline/internal/quadrangulation_layers_impl.h>
#include <CGAL/Quad_meshing/Pipeline/internal/run_quadrangulation_impl.h>
#include <CGAL/Quad_meshing/Pipeline/internal/search_grid_map_impl.h>
