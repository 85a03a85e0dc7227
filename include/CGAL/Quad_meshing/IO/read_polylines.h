// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_READ_POLYLINES_H
#define CGAL_QUAD_MESHING_IO_READ_POLYLINES_H

#include <CGAL/Quad_meshing/IO/Guide_reading_result.h>
#include <CGAL/Quad_meshing/IO/internal/Text_scanner.h>
#include <CGAL/Quad_meshing/IO/internal/read_text_file.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief A polyline of a file.
 */
struct File_polyline
{
  std::size_t line = 0;                      ///< the number of its first line, counted from 1
  std::vector<std::array<double, 3>> points; ///< at least one; the first is not repeated at the end
  bool is_closed = false;                    ///< whether the last point is joined to the first one
};

namespace internal {

// `v` and `l` of OBJ; everything else is skipped.
inline void read_obj_polylines(Text_scanner& in, std::vector<File_polyline>& polylines)
{
  std::vector<std::array<double, 3>> points;
  for(; !in.at_end(); in.skip_line())
  {
    const std::size_t line = in.line();
    const std::string_view key = in.word();
    if(key == "v")
    {
      std::array<double, 3> p;
      if(!(in.read(p[0]) && in.read(p[1]) && in.read(p[2])))
        return;
      for(double x : p)
        if(const char* defect = coordinate_defect(x))
          return in.fail("vertex " + std::to_string(points.size() + 1) + defect);
      points.push_back(p);
    }
    if(key != "l")
      continue;
    File_polyline polyline;
    polyline.line = line;
    for(in.skip_blanks(); !in.at_line_end(); in.skip_blanks())
    {
      long long v = 0;
      if(!in.read_before_slash(v))
        return;
      const long long n = static_cast<long long>(points.size()), i = v > 0 ? v - 1 : n + v;
      if(v == 0 || i < 0 || i >= n)
        return in.fail("there is no vertex " + std::to_string(v));
      polyline.points.push_back(points[static_cast<std::size_t>(i)]);
    }
    polylines.push_back(polyline);
  }
}

// A point in each line; an empty line, or one of blanks, ends a polyline.
inline void read_point_polylines(Text_scanner& in, std::vector<File_polyline>& polylines)
{
  bool is_open = false;
  for(; !in.at_end(); in.skip_line())
  {
    const std::size_t line = in.line();
    in.skip_blanks();
    if(in.at_line_end())
    {
      is_open = is_open && !in.at_end() && *in.position() == '#';
      continue;
    }
    std::array<double, 3> p;
    if(!(in.read(p[0]) && in.read(p[1]) && in.read(p[2])))
      return;
    for(double x : p)
      if(const char* defect = coordinate_defect(x))
        return in.fail(std::string("the point") + defect);
    in.skip_blanks();
    if(!in.at_line_end())
      return in.fail("a point has more than three numbers");
    if(!is_open)
    {
      polylines.emplace_back();
      polylines.back().line = line;
    }
    polylines.back().points.push_back(p);
    is_open = true;
  }
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief reads polylines.
 *
 * A file whose name ends with `.obj` has vertices `v` and lines `l`, whose vertices count from 1, or from the last one
 * if they are negative; other statements are skipped. Any other file has a point `x y z` in each line and an empty line
 * between polylines; what follows a `#` is skipped. A polyline whose last point is its first one is closed.
 *
 * \param filename the name of the file
 * \param polylines receives the polylines
 *
 * \return what is wrong, if something is
 */
inline Guide_reading_result read_polylines(const std::string& filename, std::vector<File_polyline>& polylines)
{
  Guide_reading_result result;
  polylines.clear();
  std::string text;
  if(!internal::read_text_file(filename, text))
  {
    result.message = "The file cannot be opened.";
    return result;
  }
  internal::Text_scanner in(text);
  const std::string extension = filename.size() > 4 ? filename.substr(filename.size() - 4) : "";
  if(extension == ".obj" || extension == ".OBJ")
    internal::read_obj_polylines(in, polylines);
  else
    internal::read_point_polylines(in, polylines);
  result.message = in.error();
  if(result.is_valid() && polylines.empty())
    result.message = "The file has no polyline.";
  for(File_polyline& p : polylines)
    if(p.points.size() > 2 && p.points.front() == p.points.back())
    {
      p.points.pop_back();
      p.is_closed = true;
    }
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_READ_POLYLINES_H
