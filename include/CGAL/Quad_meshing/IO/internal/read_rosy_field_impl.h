// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_ROSY_FIELD_IMPL_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_ROSY_FIELD_IMPL_H

#include <CGAL/Quad_meshing/IO/internal/Text_scanner.h>
#include <CGAL/Quad_meshing/IO/internal/read_soup_file_impl.h>
#include <CGAL/Quad_meshing/IO/rosy_field.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

inline void read_rosy_text(Text_scanner& in, std::vector<std::array<double, 3>>& directions)
{
  long long number_of_faces = 0, degree = 0;
  in.skip_to_item();
  if(!in.read(number_of_faces))
    return;
  if(number_of_faces < 1)
    return in.fail("there are " + std::to_string(number_of_faces) + " faces");
  in.skip_to_item();
  if(!in.read(degree))
    return;
  if(degree != 4)
    return in.fail("the field has " + std::to_string(degree) + " directions per face instead of 4");
  for(long long i = 0; i < number_of_faces; ++i)
  {
    std::array<double, 3> d;
    in.skip_to_item();
    if(!(in.read(d[0]) && in.read(d[1]) && in.read(d[2])))
      return;
    for(double x : d)
      if(!std::isfinite(x))
        return in.fail("the direction of face " + std::to_string(i) + " is not finite",
                       Mesh_reading_status::INVALID_COORDINATE);
    directions.push_back(d);
  }
  in.skip_to_item();
  if(!in.at_end())
    in.fail("there is more than the " + std::to_string(number_of_faces) + " directions that the file promises");
}

} // namespace internal

CGAL_QUAD_MESHING_INLINE Mesh_reading_result read_rosy_field(const std::string& filename,
                                                             std::vector<std::array<double, 3>>& directions)
{
  Mesh_reading_result result;
  std::string bytes, error;
  if(!internal::read_bytes(filename, bytes, error))
  {
    result.status = Mesh_reading_status::CANNOT_OPEN;
    result.message = "The file cannot be read: " + error + ".";
    return result;
  }
  internal::Text_scanner in(internal::without_byte_order_mark(bytes));
  std::vector<std::array<double, 3>> found;
  internal::read_rosy_text(in, found);
  if(in.failed())
  {
    result.status = in.status();
    result.message = in.error();
    return result;
  }
  directions.swap(found);
  result.faces = File_numbers(directions.size());
  return result;
}

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_READ_ROSY_FIELD_IMPL_H
