// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_OBJ_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_OBJ_H

#include <CGAL/Quad_meshing/IO/Mesh_attributes.h>
#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Quad_meshing/IO/internal/Text_scanner.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

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

// Collects what an OBJ file says besides points and polygons.
class Obj_attributes
{
  Text_scanner& m_in;
  Mesh_attributes& m_attributes;

public:
  Obj_attributes(Text_scanner& in, Mesh_attributes& attributes) : m_in(in), m_attributes(attributes) {}

  // Reads what is behind the coordinates of a vertex. Returns how many numbers that are.
  std::size_t read_color()
  {
    std::array<double, 5> numbers; // a color, or a weight; few files have both
    std::size_t n = 0;
    for(m_in.skip_blanks(); !m_in.at_line_end() && n < numbers.size() && m_in.read(numbers[n]); m_in.skip_blanks())
      ++n;
    if(n == 3 || n == 4)
      m_attributes.colors.push_back({ { numbers[n - 3], numbers[n - 2], numbers[n - 1] } });
    return n + (m_in.at_line_end() ? 0 : m_in.skip_numbers());
  }

  // A corner of a face; returns its vertex index.
  bool read_corner(long long& v)
  {
    std::array<long long, 3> indices;
    if(!m_in.read_with_slashes(indices))
      return false;
    v = indices[0];
    m_attributes.corner_texture.push_back(number(indices[1], m_attributes.texture_coordinates.size()));
    m_attributes.corner_normal.push_back(number(indices[2], m_attributes.normals.size()));
    return true;
  }

  void end_face()
  {
    m_attributes.objects.of_face.push_back(m_object);
    m_attributes.groups.of_face.push_back(m_group);
    m_attributes.materials.of_face.push_back(m_material);
  }

  // Statements about faces. Returns false if the line begins with another one.
  bool read(std::string_view key)
  {
    if(key == "g")
      m_group = number_of(m_in.rest_of_line(), m_attributes.groups);
    else if(key == "o")
      m_object = number_of(m_in.rest_of_line(), m_attributes.objects);
    else if(key == "usemtl")
      m_material = number_of(m_in.rest_of_line(), m_attributes.materials);
    else if(key == "mtllib")
      m_attributes.material_libraries.push_back(m_in.rest_of_line());
    else if(key == "vt")
    {
      std::array<double, 2> t = { { 0, 0 } };
      if(m_in.read(t[0]) && !m_in.at_line_end())
      {
        m_in.skip_blanks();
        if(!m_in.at_line_end())
          m_in.read(t[1]);
      }
      m_attributes.texture_coordinates.push_back(t);
    }
    else if(key == "vn")
    {
      std::array<double, 3> n = { { 0, 0, 0 } };
      for(double& x : n)
        m_in.read(x);
      m_attributes.normals.push_back(n);
    }
    else
      return false;
    return true;
  }

private:
  // Indices count from 1, negative ones from the last one; those of nothing are -1.
  static int number(long long index, std::size_t size)
  {
    const long long n = index > 0 ? index - 1 : index < 0 ? static_cast<long long>(size) + index : -1;
    return n >= 0 && n <= std::numeric_limits<int>::max() ? static_cast<int>(n) : -1;
  }

  int number_of(const std::string& name, Face_names& names)
  {
    const auto inserted = m_numbers[&names].emplace(name, static_cast<int>(names.names.size()));
    if(inserted.second)
      names.names.push_back(name);
    return inserted.first->second;
  }

  std::map<const Face_names*, std::unordered_map<std::string, int>> m_numbers; // of names
  int m_object = Face_names::none, m_group = Face_names::none, m_material = Face_names::none;
};

// Reads the lines `v` and `f` of an OBJ file; indices count from 1, negative ones from the vertex read last. Lines and
// points are counted, free-form surfaces refused, and so are statements that OBJ does not have: such a line may be a
// damaged face.
inline void read_obj(Text_scanner& in, std::string_view text, Polygon_soup& soup, Mesh_attributes* attributes)
{
  std::optional<Obj_attributes> others;
  if(attributes != nullptr)
    others.emplace(in, *attributes);
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
      if(!in.at_line_end() && (others ? others->read_color() : in.skip_numbers()) > 5) // a weight, or a color
        in.fail("a vertex has more than eight numbers");
      soup.points.push_back(p);
    }
    else if(key == "f" || key == "fo")
    {
      for(in.skip_blanks(); !in.at_line_end(); in.skip_blanks())
      {
        long long v = 0;
        if(!(others ? others->read_corner(v) : in.read_before_slash(v)))
          return;
        const long long index = v > 0 ? v - 1 : static_cast<long long>(soup.points.size()) + v;
        if(v == 0 || index < 0)
          return in.fail("face " + std::to_string(soup.size()) + " names vertex " + std::to_string(v) +
                           (v == 0 ? ", but the numbers of OBJ count from 1" : ", but so many have not been there yet"),
                         Mesh_reading_status::INVALID_INDEX);
        soup.add_corner(index);
      }
      soup.end_polygon();
      if(others)
        others->end_face();
    }
    else if(others && others->read(key))
      ;
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
