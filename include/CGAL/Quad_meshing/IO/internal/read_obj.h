// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_OBJ_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_OBJ_H

#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Quad_meshing/IO/internal/Text_scanner.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Statements of OBJ that say nothing about the vertices of faces.
inline bool is_other_obj_statement(std::string_view key)
{
  static const std::array<std::string_view, 30> keys = {
    { "vt",     "vn",    "vp",       "g",        "o",    "s",          "mg",        "usemtl", "mtllib", "usemap",
      "maplib", "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech",  "stech",  "cstype",
      "deg",    "bmat",  "step",     "parm",     "trim", "hole",       "scrv",      "sp",     "end",    "con" }
  };
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

// The number of the line with the face of that number.
inline std::size_t line_of_obj_face(std::string_view text, std::size_t face)
{
  Text_scanner in(text);
  for(std::size_t f = 0; !in.at_end(); in.skip_line())
  {
    const std::string_view key = in.word();
    if((key == "f" || key == "fo") && f++ == face)
      break;
  }
  return in.line();
}

// Reads the lines `v` and `f` of an OBJ file; indices count from 1, negative ones from the vertex read last. Lines and
// points are counted, free-form surfaces refused, and so are statements that OBJ does not have: such a line may be a
// damaged face.
inline void read_obj(Text_scanner& in, std::string_view text, Polygon_soup& soup)
{
  while(!in.at_end())
  {
    const std::string_view key = in.word();
    if(key.empty())
      ;
    else if(key == "v")
    {
      Polygon_soup::Point p;
      if(!(in.read(p[0]) && in.read(p[1]) && in.read(p[2])))
        return;
      for(double x : p)
        if(const char* defect = coordinate_defect(x))
          return in.fail("vertex " + std::to_string(soup.points.size()) + defect + " (numbers count from 0)",
                         Mesh_reading_status::INVALID_COORDINATE);
      if(!in.at_line_end() && in.skip_numbers() > 5) // a weight, or a color
        in.fail("a vertex has more than eight numbers");
      soup.points.push_back(p);
    }
    else if(key == "f" || key == "fo")
    {
      for(in.skip_blanks(); !in.at_line_end(); in.skip_blanks())
      {
        long long v = 0;
        if(!in.read_before_slash(v))
          return;
        const long long index = v > 0 ? v - 1 : static_cast<long long>(soup.points.size()) + v;
        if(v == 0 || index < 0)
          return in.fail("face " + std::to_string(soup.size()) + " names vertex " + std::to_string(v) +
                           (v == 0 ? ", but the numbers of OBJ count from 1" : ", but so many have not been there yet"),
                         Mesh_reading_status::INVALID_INDEX);
        soup.add_corner(index);
      }
      soup.end_polygon();
    }
    else if(key == "l")
      ++soup.number_of_lines;
    else if(key == "p")
      ++soup.number_of_points;
    else if(key == "surf" || key == "curv" || key == "curv2")
      return in.fail("'" + std::string(key) + "' begins a free-form surface or curve, which is not read");
    else if(!is_other_obj_statement(key))
      return in.fail("the line begins with no statement of OBJ");
    in.skip_line();
  }

  const std::size_t nv = soup.points.size();
  for(std::size_t f = 0; f < soup.size(); ++f)
    for(std::size_t c = soup.first_corner[f]; c < soup.first_corner[f + 1]; ++c)
    {
      if(soup.corners[c] < nv)
        continue;
      const long long v = soup.corners[c] == no_index ? soup.impossible_index : static_cast<long long>(soup.corners[c]);
      return in.fail_at(line_of_obj_face(text, f), "face " + std::to_string(f) + names_missing_vertex(v, nv),
                        Mesh_reading_status::INVALID_INDEX);
    }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_READ_OBJ_H
