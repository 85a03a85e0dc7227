// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_PLY_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_PLY_H

#include <CGAL/Quad_meshing/IO/Mesh_attributes.h>
#include <CGAL/Quad_meshing/IO/internal/Binary_scanner.h>
#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Quad_meshing/IO/internal/Text_scanner.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

enum class Ply_type
{
  NONE,
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  INT64,
  UINT64,
  FLOAT32,
  FLOAT64
};

inline Ply_type ply_type(std::string_view name)
{
  static const std::array<std::pair<std::string_view, Ply_type>, 18> names = { { { "char", Ply_type::INT8 },
                                                                                 { "int8", Ply_type::INT8 },
                                                                                 { "uchar", Ply_type::UINT8 },
                                                                                 { "uint8", Ply_type::UINT8 },
                                                                                 { "short", Ply_type::INT16 },
                                                                                 { "int16", Ply_type::INT16 },
                                                                                 { "ushort", Ply_type::UINT16 },
                                                                                 { "uint16", Ply_type::UINT16 },
                                                                                 { "int", Ply_type::INT32 },
                                                                                 { "int32", Ply_type::INT32 },
                                                                                 { "uint", Ply_type::UINT32 },
                                                                                 { "uint32", Ply_type::UINT32 },
                                                                                 { "int64", Ply_type::INT64 },
                                                                                 { "uint64", Ply_type::UINT64 },
                                                                                 { "float", Ply_type::FLOAT32 },
                                                                                 { "float32", Ply_type::FLOAT32 },
                                                                                 { "double", Ply_type::FLOAT64 },
                                                                                 { "float64", Ply_type::FLOAT64 } } };
  for(const auto& entry : names)
    if(entry.first == name)
      return entry.second;
  return Ply_type::NONE;
}

inline bool is_ply_integer(Ply_type type) { return Ply_type::INT8 <= type && type <= Ply_type::UINT64; }

struct Ply_property
{
  std::string name;
  Ply_type count_type = Ply_type::NONE; // NONE: no list
  Ply_type type = Ply_type::NONE;
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t find(std::string_view property) const
  {
    for(std::size_t i = 0; i < properties.size(); ++i)
      if(properties[i].name == property)
        return i;
    return none;
  }
};

// The values of a PLY file in text form, as Binary_scanner gives them in binary form.
class Ply_text_values
{
  Text_scanner& m_in;

public:
  explicit Ply_text_values(Text_scanner& in) : m_in(in) {}

  bool failed() const { return m_in.failed(); }

  double real(Ply_type)
  {
    double x = 0;
    m_in.skip_to_item();
    m_in.read(x);
    return x;
  }

  long long integer(Ply_type)
  {
    long long i = 0;
    m_in.skip_to_item();
    m_in.read(i);
    return i;
  }
};

class Ply_binary_values
{
  Binary_scanner& m_in;

public:
  explicit Ply_binary_values(Binary_scanner& in) : m_in(in) {}

  bool failed() const { return m_in.failed(); }

  double real(Ply_type type)
  {
    return type == Ply_type::FLOAT32   ? static_cast<double>(m_in.read<float>())
           : type == Ply_type::FLOAT64 ? m_in.read<double>()
                                       : static_cast<double>(integer(type));
  }

  long long integer(Ply_type type)
  {
    switch(type)
    {
      case Ply_type::INT8: return m_in.read<std::int8_t>();
      case Ply_type::UINT8: return m_in.read<std::uint8_t>();
      case Ply_type::INT16: return m_in.read<std::int16_t>();
      case Ply_type::UINT16: return m_in.read<std::uint16_t>();
      case Ply_type::INT32: return m_in.read<std::int32_t>();
      case Ply_type::UINT32: return m_in.read<std::uint32_t>();
      case Ply_type::INT64: return m_in.read<std::int64_t>();
      case Ply_type::UINT64: return static_cast<long long>(m_in.read<std::uint64_t>());
      default: return static_cast<long long>(real(type));
    }
  }
};

// Reads a PLY file: any types of numbers, text or binary of both byte orders, further properties and lists before and
// behind those that matter, triangle strips.
class Ply_reader
{
  Text_scanner& m_in;
  std::string_view m_text;
  Polygon_soup& m_soup;
  Mesh_attributes* m_attributes; // null: they are passed over
  std::string m_format;
  std::vector<Ply_element> m_elements;

public:
  Ply_reader(Text_scanner& in, std::string_view text, Polygon_soup& soup, Mesh_attributes* attributes)
    : m_in(in), m_text(text), m_soup(soup), m_attributes(attributes)
  {
  }

  void operator()()
  {
    read_header();
    check_header();
    if(m_in.failed())
      return;
    if(m_format == "ascii")
    {
      Ply_text_values values(m_in);
      read_elements(values);
      m_in.skip_to_item();
      if(!m_in.at_end())
        m_in.fail("there is more than the header promises");
      return;
    }
    const char* const end = m_text.data() + m_text.size();
    Binary_scanner data(m_in.position(), end, m_format == "binary_big_endian");
    Ply_binary_values values(data);
    read_elements(values);
    if(!m_in.failed() &&
       std::string_view(data.position(), data.left()).find_first_not_of(" \t\r\n") != std::string_view::npos)
      m_in.fail("there is more than the header promises");
  }

private:
  void read_header()
  {
    if(m_in.word() != "ply")
      m_in.fail("the file does not start with ply");
    while(!m_in.failed())
    {
      m_in.skip_line();
      if(m_in.at_end())
        return m_in.fail("the header has no end");
      const std::string_view key = m_in.word();
      if(key == "end_header")
        break;
      if(key == "format")
        read_format();
      else if(key == "element")
        read_element();
      else if(key == "property")
        read_property();
      else if(!key.empty() && key != "comment" && key != "obj_info")
        m_in.fail("the header has no such line");
    }
    m_in.skip_line();
  }

  void read_format()
  {
    m_format = std::string(m_in.word());
    if((m_format != "ascii" && m_format != "binary_little_endian" && m_format != "binary_big_endian") ||
       m_in.word() != "1.0")
      m_in.fail("the format is not one of ascii, binary_little_endian, binary_big_endian, version 1.0");
  }

  void read_element()
  {
    Ply_element element;
    element.name = std::string(m_in.word());
    long long n = 0;
    // Every element takes at least one byte.
    if(m_in.read(n) && (n < 0 || static_cast<unsigned long long>(n) > m_text.size()))
      m_in.fail("the header promises " + std::to_string(n) + " elements '" + element.name +
                "', more than the file can hold");
    element.count = static_cast<std::size_t>(n);
    m_elements.push_back(element);
  }

  void read_property()
  {
    Ply_property property;
    std::string_view type = m_in.word();
    if(type == "list")
    {
      property.count_type = ply_type(m_in.word());
      if(!is_ply_integer(property.count_type))
        m_in.fail("the length of a list is no integer");
      type = m_in.word();
    }
    property.type = ply_type(type);
    property.name = std::string(m_in.word());
    if(property.type == Ply_type::NONE || property.name.empty())
      m_in.fail("a property has no known type or no name");
    else if(m_elements.empty())
      m_in.fail("a property belongs to no element");
    else
      m_elements.back().properties.push_back(property);
  }

  // The list with the vertices of a face or of a strip.
  static std::size_t vertex_list(const Ply_element& element)
  {
    const std::size_t i = element.find("vertex_indices");
    return i != Ply_element::none ? i : element.find("vertex_index");
  }

  void check_header()
  {
    if(m_in.failed())
      return;
    if(m_format.empty())
      m_in.fail("the header names no format");
    for(const Ply_element& element : m_elements)
    {
      if(element.properties.empty() && element.count > 0)
        m_in.fail("the element '" + element.name + "' has no properties");
      if(element.name == "vertex")
        for(const char* name : { "x", "y", "z" })
        {
          const std::size_t i = element.find(name);
          if(i == Ply_element::none || element.properties[i].count_type != Ply_type::NONE)
            m_in.fail(std::string("the vertices have no coordinate ") + name);
          else if(element.properties[i].type == Ply_type::FLOAT32)
            m_soup.set_single_precision();
        }
      if(element.name == "face" || element.name == "tristrips")
      {
        const std::size_t i = vertex_list(element);
        if(i == Ply_element::none || element.properties[i].count_type == Ply_type::NONE ||
           !is_ply_integer(element.properties[i].type))
          m_in.fail("the element '" + element.name + "' has no list of integers vertex_indices");
      }
    }
  }

  template <typename Values>
  void read_elements(Values& values)
  {
    for(const Ply_element& element : m_elements)
    {
      for(std::size_t i = 0; i < element.count; ++i)
      {
        if(element.name == "vertex")
          read_vertex(element, values);
        else if(element.name == "face")
          read_face(element, i, values);
        else if(element.name == "tristrips")
          read_strips(element, i, values);
        else
          for(const Ply_property& property : element.properties)
            skip(property, values);
        if(values.failed())
          m_in.fail("the file ends within the element '" + element.name + "' number " + std::to_string(i));
        if(m_in.failed())
          return;
      }
    }
  }

  template <typename Values>
  void skip(const Ply_property& property, Values& values)
  {
    if(property.count_type == Ply_type::NONE)
    {
      values.real(property.type);
      return;
    }
    const long long n = values.integer(property.count_type);
    for(long long k = 0; k < n && !values.failed(); ++k)
      values.real(property.type);
  }

  template <typename Values>
  void read_vertex(const Ply_element& element, Values& values)
  {
    Polygon_soup::Point p = { { 0, 0, 0 } };
    std::array<double, 3> color;
    int colored = 0;
    for(const Ply_property& property : element.properties)
    {
      if(m_attributes != nullptr)
        if(const int c = color_channel(property); c >= 0)
        {
          color[c] = values.real(property.type) / (property.type == Ply_type::UINT8 ? 255 : 1);
          ++colored;
          continue;
        }
      if(property.count_type == Ply_type::NONE && property.name.size() == 1 && 'x' <= property.name[0] &&
         property.name[0] <= 'z')
        p[static_cast<std::size_t>(property.name[0] - 'x')] = values.real(property.type);
      else
        skip(property, values);
    }
    for(double x : p)
      if(const char* defect = coordinate_defect(x))
        m_in.fail("vertex " + std::to_string(m_soup.points.size()) + defect + " (numbers count from 0)",
                  Mesh_reading_status::INVALID_COORDINATE);
    m_soup.points.push_back(p);
    if(colored == 3)
      m_attributes->colors.push_back(color);
  }

  // Which of red, green and blue a property is, -1 if it is none of them.
  static int color_channel(const Ply_property& property)
  {
    static const std::array<std::string_view, 3> names = { { "red", "green", "blue" } };
    if(property.count_type != Ply_type::NONE)
      return -1;
    const auto found = std::find(names.begin(), names.end(), property.name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
  }

  // Reads the element of number i and calls f(v) for the vertices that its list names.
  template <typename Values, typename Function>
  void read_list(const Ply_element& element, std::size_t i, Values& values, Function f)
  {
    const std::size_t list = vertex_list(element);
    for(std::size_t p = 0; p < element.properties.size(); ++p)
    {
      const Ply_property& property = element.properties[p];
      if(p != list)
      {
        skip(property, values);
        continue;
      }
      const long long n = values.integer(property.count_type);
      if(n < 0)
        m_in.fail(element.name + " " + std::to_string(i) + " has " + std::to_string(n) + " vertices");
      for(long long k = 0; k < n && !values.failed(); ++k)
        f(values.integer(property.type));
    }
  }

  template <typename Values>
  void read_face(const Ply_element& element, std::size_t i, Values& values)
  {
    read_list(element, i, values, [&](long long v) { m_soup.add_corner(v); });
    m_soup.end_polygon();
  }

  // A strip a b c d ... is the triangles abc, cbd, ...; -1 begins a new one.
  template <typename Values>
  void read_strips(const Ply_element& element, std::size_t i, Values& values)
  {
    const bool is_unsigned = element.properties[vertex_list(element)].type == Ply_type::UINT32;
    std::array<long long, 2> last = { { -1, -1 } };
    std::size_t length = 0;
    read_list(element, i, values,
              [&](long long v)
              {
                const bool is_break = v == -1 || (v == 0xFFFFFFFFll && is_unsigned);
                length = is_break ? 0 : length + 1;
                // Repeated vertices turn a corner of the strip without a triangle.
                if(length >= 3 && v != last[0] && v != last[1] && last[0] != last[1])
                {
                  const bool is_odd = length % 2 == 0;
                  m_soup.add_corner(last[is_odd ? 1 : 0]);
                  m_soup.add_corner(last[is_odd ? 0 : 1]);
                  m_soup.add_corner(v);
                  m_soup.end_polygon();
                }
                last = { { last[1], v } };
              });
  }
};

inline void read_ply(Text_scanner& in, std::string_view text, Polygon_soup& soup, Mesh_attributes* attributes)
{
  Ply_reader(in, text, soup, attributes)();
  if(in.failed())
    return;
  for(std::size_t f = 0; f < soup.size(); ++f)
    for(std::size_t c = soup.first_corner[f]; c < soup.first_corner[f + 1]; ++c)
      if(soup.corners[c] >= soup.points.size())
        return in.fail_without_line(
          "Face " + std::to_string(f) +
            names_missing_vertex(
              c == soup.impossible_corner ? soup.impossible_index : static_cast<long long>(soup.corners[c]),
              soup.points.size()),
          Mesh_reading_status::INVALID_INDEX);
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_READ_PLY_H
