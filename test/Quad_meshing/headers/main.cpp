// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Two translation units that include everything link, and mean the same by it.

#include <CGAL/Quad_meshing.h>

#include <cassert>
#include <cstdlib>
#include <sstream>
#include <string>

// In second_unit.cpp.
std::string json_of_second_unit();
bool reads_in_second_unit(const std::string& filename);

int main()
{
  CGAL::Quad_meshing::Flat_json json;
  json.set("length", CGAL::parameters::get_parameter(CGAL::parameters::target_edge_length(0.5),
                                                     CGAL::internal_np::target_edge_length));
  std::ostringstream os;
  json.write(os);
  assert(os.str() == json_of_second_unit());
  assert(!reads_in_second_unit("there_is_no_such_file.off"));

  return EXIT_SUCCESS;
}
