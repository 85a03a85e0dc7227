// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_OFF_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_OFF_H

#include <CGAL/Quad_meshing/IO/internal/Binary_scanner.h>
#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Quad_meshing/IO/internal/Text_scanner.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What the key word of an OFF file says: [ST][C][N][4][n]OFF [BINARY].
struct Off_header
{
  bool is_homogeneous = false;
  bool is_binary = false;
  std::size_t number_of_values = 3; // per vertex: coordinates, and what comes with them, without colors
};

inline bool read_off_key(Text_scanner& in, Off_header& header)
{
  in.skip_to_item();
  std::string_view key = in.word();
  if(key == "off")
    key = "OFF";
  const std::string name(key.substr(0, 10));
  auto take = [&](std::string_view prefix)
  {
    const bool is_there = key.size() > prefix.size() && key.substr(0, prefix.size()) == prefix;
    if(is_there)
      key.remove_prefix(prefix.size());
    return is_there;
  };
  const bool has_texture = take("ST");
  take("C");
  const bool has_normals = take("N");
  header.is_homogeneous = take("4");
  if(take("n"))
    in.fail("'" + name + "' is a surface in a space of any dimension, which is not read");
  else if(key != "OFF")
    in.fail("the file does not start with OFF");
  header.number_of_values = 3u + header.is_homogeneous + (has_normals ? 3u : 0u) + (has_texture ? 2u : 0u);
  return !in.failed();
}

// Refuses counts that a file of that size cannot hold, so that no one tries to allocate what is not there.
inline bool check_off_counts(Text_scanner& in, long long nv, long long nf, std::size_t size)
{
  // A vertex and a face take six bytes at least ("0 0 0\n").
  const long long most = static_cast<long long>(size / 6 + 1);
  if(!in.failed() && (nv < 0 || nf < 0 || nv > most || nf > most))
    in.fail("the header promises " + std::to_string(nv) + " vertices and " + std::to_string(nf) +
            " faces, more than the file can hold");
  return !in.failed();
}

inline void fail_on_index(Text_scanner& in, std::size_t f, long long v, std::size_t nv)
{
  in.fail("face " + std::to_string(f) + names_missing_vertex(v, nv), Mesh_reading_status::INVALID_INDEX);
}

inline bool check_point(Text_scanner& in, const Polygon_soup::Point& p, std::size_t v)
{
  for(double x : p)
    if(const char* defect = coordinate_defect(x))
    {
      in.fail("vertex " + std::to_string(v) + defect + " (numbers count from 0)",
              Mesh_reading_status::INVALID_COORDINATE);
      return false;
    }
  return true;
}

// Vertices and faces begin on lines of their own. Numbers behind the coordinates of a vertex (normals, colors, ...) are
// passed over, but all vertices must have the same number of them: else a line end is missing. The same for the colors
// of faces, which may differ.
inline void read_off_text(Text_scanner& in, const Off_header& header, std::size_t size, Polygon_soup& soup)
{
  long long nv = 0, nf = 0;
  in.skip_to_item();
  in.read(nv);
  in.skip_to_item();
  in.read(nf);
  in.skip_numbers(); // the number of edges
  if(!check_off_counts(in, nv, nf, size))
    return;
  in.skip_line();
  soup.points.reserve(static_cast<std::size_t>(nv));
  soup.corners.reserve(3 * static_cast<std::size_t>(nf));
  soup.first_corner.reserve(static_cast<std::size_t>(nf) + 1);

  std::size_t more_values = 0;
  for(std::size_t i = 0; i < static_cast<std::size_t>(nv); ++i)
  {
    double x = 0, y = 0, z = 0, w = 1;
    in.skip_to_item();
    if(!(in.read(x) && in.read(y) && in.read(z) && (!header.is_homogeneous || in.read(w))))
      return;
    const Polygon_soup::Point p =
      header.is_homogeneous ? Polygon_soup::Point{ { x / w, y / w, z / w } } : Polygon_soup::Point{ { x, y, z } };
    if(!check_point(in, p, i))
      return;
    soup.points.push_back(p);
    const std::size_t more = in.skip_numbers();
    if(i == 0)
      more_values = more;
    if(!in.failed() && more != more_values)
      in.fail("vertex " + std::to_string(i) + " has " + std::to_string(3 + more) + " numbers where the others have " +
              std::to_string(3 + more_values));
    if(in.failed())
      return;
    in.skip_line();
  }
  for(std::size_t f = 0; f < static_cast<std::size_t>(nf); ++f)
  {
    long long n = 0;
    in.skip_to_item();
    if(!in.read(n))
      return;
    if(n < 0)
      in.fail("face " + std::to_string(f) + " has " + std::to_string(n) + " vertices");
    for(long long k = 0; k < n; ++k)
    {
      long long v = 0;
      if(!in.read(v))
        return;
      if(v < 0 || v >= nv)
        fail_on_index(in, f, v, soup.points.size());
      soup.add_corner(v);
    }
    soup.end_polygon();
    if(!in.at_line_end())
      in.skip_numbers();
    if(in.failed())
      return;
    in.skip_line();
  }
  in.skip_to_item();
  if(!in.at_end())
    in.fail("there is more than the " + count_of(static_cast<std::size_t>(nf), "face", "faces") +
            " that the header promises");
}

// The same in binary form: big-endian integers and floats of 32 bits; each face has the number of its colors at its
// end.
inline void read_off_binary(Text_scanner& in, const Off_header& header, std::size_t size, const char* end,
                            Polygon_soup& soup)
{
  Binary_scanner data(in.position(), end, true);
  const long long nv = data.read<std::int32_t>(), nf = data.read<std::int32_t>();
  data.read<std::int32_t>(); // the number of edges
  if(data.failed())
    in.fail("the file ends within the header");
  if(!check_off_counts(in, nv, nf, size))
    return;
  soup.set_single_precision();
  for(std::size_t i = 0; i < static_cast<std::size_t>(nv); ++i)
  {
    std::array<double, 4> x = { { 0, 0, 0, 1 } };
    for(std::size_t k = 0; k < header.number_of_values; ++k)
    {
      const double value = data.read<float>();
      if(k < (header.is_homogeneous ? 4u : 3u))
        x[k] = value;
    }
    if(data.failed())
      return in.fail("the file ends within vertex " + std::to_string(i));
    soup.points.push_back({ { x[0] / x[3], x[1] / x[3], x[2] / x[3] } });
    if(!check_point(in, soup.points.back(), i))
      return;
  }
  for(std::size_t f = 0; f < static_cast<std::size_t>(nf); ++f)
  {
    const long long n = data.read<std::int32_t>();
    for(long long k = 0; k < n && !data.failed(); ++k)
    {
      const long long v = data.read<std::int32_t>();
      if(v < 0 || v >= nv)
        return fail_on_index(in, f, v, soup.points.size());
      soup.add_corner(v);
    }
    soup.end_polygon();
    const long long colors = data.read<std::int32_t>();
    if(data.failed() || n < 0 || colors < 0 || !data.skip(4u * static_cast<std::size_t>(colors)))
      return in.fail("face " + std::to_string(f) + " is damaged, or the file ends in it");
  }
  const std::size_t smallest_face = 8; // bytes: the number of vertices and the number of colors
  if(data.left() >= smallest_face)
    in.fail("there is more than the " + count_of(static_cast<std::size_t>(nf), "face", "faces") +
            " that the header promises");
}

// Reads an OFF file; what is wrong with it is left in the scanner.
inline void read_off(Text_scanner& in, std::string_view text, Polygon_soup& soup)
{
  Off_header header;
  if(!read_off_key(in, header))
    return;
  const char* behind_key = in.position();
  Text_scanner ahead(behind_key, text.data() + text.size());
  if(ahead.word() == "BINARY")
  {
    if(in.word() == "BINARY")
      in.skip_line();
    read_off_binary(in, header, text.size(), text.data() + text.size(), soup);
  }
  else
    read_off_text(in, header, text.size(), soup);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_READ_OFF_H
