// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The kernels of the room Quad_mesh.

#include <CGAL/Quad_meshing/Quad_mesh/internal/quad_mesh_defects_impl.h>
#include <CGAL/Quad_meshing/Quad_mesh/internal/quad_mesh_deviation_impl.h>
#include <CGAL/Quad_meshing/Quad_mesh/internal/quad_mesh_quality_impl.h>
#include <CGAL/Quad_meshing/Quad_mesh/internal/quad_mesh_structure_impl.h>
