// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The kernels of the room IO.

#include <CGAL/Quad_meshing/IO/internal/Triangle_surface_impl.h>
#include <CGAL/Quad_meshing/IO/internal/read_mesh_attributes_impl.h>
#include <CGAL/Quad_meshing/IO/internal/read_polygon_soup_impl.h>
#include <CGAL/Quad_meshing/IO/internal/read_rosy_field_impl.h>
#include <CGAL/Quad_meshing/IO/internal/read_soup_file_impl.h>
#include <CGAL/Quad_meshing/IO/internal/simplify_layer_impl.h>
#include <CGAL/Quad_meshing/IO/internal/write_html_page_impl.h>
#include <CGAL/Quad_meshing/IO/internal/write_png_picture_impl.h>
#include <CGAL/Quad_meshing/IO/internal/write_vtk_impl.h>
