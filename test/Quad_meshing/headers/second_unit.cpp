// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#include <CGAL/Quad_meshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <sstream>
#include <string>

std::string json_of_second_unit()
{
  CGAL::Quad_meshing::Flat_json json;
  json.set("length", CGAL::parameters::get_parameter(CGAL::parameters::target_edge_length(0.5),
                                                     CGAL::internal_np::target_edge_length));
  std::ostringstream os;
  json.write(os);
  return os.str();
}

bool reads_in_second_unit(const std::string& filename)
{
  CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> tm;
  return static_cast<bool>(CGAL::Quad_meshing::read_triangle_mesh(filename, tm));
}
