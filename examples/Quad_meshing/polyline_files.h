// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXAMPLES_POLYLINE_FILES_H
#define CGAL_QUAD_MESHING_EXAMPLES_POLYLINE_FILES_H

// Polylines in files, as several programs read and write them.

#include "command_line.h"

#include <CGAL/Quad_meshing/IO/read_polylines.h>

#include <ostream>
#include <string>
#include <vector>

namespace command_line {

inline std::vector<CGAL::Quad_meshing::File_polyline> read_lines(const std::string& filename)
{
  std::vector<CGAL::Quad_meshing::File_polyline> polylines;
  const CGAL::Quad_meshing::Guide_reading_result result = CGAL::Quad_meshing::read_polylines(filename, polylines);
  if(!result.is_valid())
    throw Unusable_input(filename + ": " + result.message);
  return polylines;
}

// Writes polylines, each as points in lines and an empty line.
template <typename Point>
void write_lines(const std::string& filename, const std::vector<std::vector<Point>>& polylines)
{
  write_file(filename,
             [&](std::ostream& os)
             {
               for(const std::vector<Point>& polyline : polylines)
               {
                 for(const Point& p : polyline)
                   os << p << "\n";
                 os << "\n";
               }
             });
}

} // namespace command_line

#endif // CGAL_QUAD_MESHING_EXAMPLES_POLYLINE_FILES_H
