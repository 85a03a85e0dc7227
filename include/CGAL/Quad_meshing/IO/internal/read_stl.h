// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_STL_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_STL_H

#include <CGAL/Quad_meshing/IO/internal/Binary_scanner.h>
#include <CGAL/Quad_meshing/IO/internal/Point_numbers.h>
#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Quad_meshing/IO/internal/Text_scanner.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Reads STL files, text or binary. Equal points become one vertex, in the order in which they first occur: STL has no
// other way to say that triangles share a vertex.
class Stl_reader
{
  static constexpr std::size_t header_size = 84, facet_size = 50; // bytes of the binary form

  Text_scanner& m_in;
  std::string_view m_text;
  Polygon_soup& m_soup;
  Point_numbers m_numbers;

public:
  Stl_reader(Text_scanner& in, std::string_view text, Polygon_soup& soup)
    : m_in(in), m_text(text), m_soup(soup), m_numbers(soup.points, text.size() / 100)
  {
  }

  void operator()()
  {
    m_soup.set_single_precision(); // text, too, is mostly written from such numbers
    // The header of a binary file may begin with "solid" too: its size tells.
    if(has_binary_size() || !begins_with_solid())
      read_binary();
    else
      read_text();
  }

private:
  std::uint64_t promised_facets() const
  {
    return Binary_scanner(m_text.data() + header_size - 4, m_text.data() + m_text.size(), false).read<std::uint32_t>();
  }

  bool has_binary_size() const
  {
    return m_text.size() >= header_size && m_text.size() == header_size + facet_size * promised_facets();
  }

  bool begins_with_solid() const
  {
    Text_scanner ahead(m_text);
    ahead.skip_to_item();
    return is_word(ahead.word(), "solid");
  }

  static bool is_word(std::string_view found, std::string_view lower_case)
  {
    if(found.size() != lower_case.size())
      return false;
    for(std::size_t i = 0; i < found.size(); ++i)
      if((found[i] | 0x20) != lower_case[i])
        return false;
    return true;
  }

  void add_vertex(const Polygon_soup::Point& p)
  {
    for(double x : p)
      if(const char* defect = coordinate_defect(x))
        return m_in.fail("facet " + std::to_string(m_soup.size()) + defect + " (numbers count from 0)",
                         Mesh_reading_status::INVALID_COORDINATE);
    const Soup_index number = static_cast<Soup_index>(m_soup.points.size());
    const Soup_index found = m_numbers.find(p, number);
    if(found == number)
      m_soup.points.push_back(p);
    m_soup.add_corner(found);
  }

  void read_binary()
  {
    const std::string no_stl = "The file is neither text that starts with solid nor a binary STL file: ";
    if(m_text.size() < header_size)
      return m_in.fail_without_line(no_stl + "it is too short for the header", Mesh_reading_status::MALFORMED_FILE);
    const std::uint64_t n = promised_facets(), room = (m_text.size() - header_size) / facet_size;
    // Some programs write a few bytes behind the last facet.
    if(n != room)
      return m_in.fail_without_line(no_stl + "the header promises " + count_of(n, "facet", "facets") +
                                      ", and the file has room for " + std::to_string(room),
                                    Mesh_reading_status::MALFORMED_FILE);
    Binary_scanner data(m_text.data() + header_size, m_text.data() + m_text.size(), false);
    m_soup.corners.reserve(3 * n);
    m_soup.first_corner.reserve(n + 1);
    for(std::uint64_t f = 0; f < n; ++f)
    {
      data.skip(3 * sizeof(float)); // the normal
      for(int k = 0; k < 3; ++k)
      {
        Polygon_soup::Point p;
        for(double& x : p)
          x = data.read<float>();
        add_vertex(p);
      }
      m_soup.end_polygon();
      data.skip(sizeof(std::uint16_t));
      if(m_in.failed())
        return;
    }
  }

  std::string_view next_word()
  {
    m_in.skip_to_item();
    return m_in.word();
  }

  bool expect(std::string_view lower_case)
  {
    const std::string_view found = next_word();
    if(!is_word(found, lower_case))
      m_in.fail("expected '" + std::string(lower_case) + "'");
    return !m_in.failed();
  }

  // "endloop", or "end loop" as some programs write it.
  bool expect_end(std::string_view of)
  {
    const std::string_view found = next_word();
    if(is_word(found, "end"))
      return expect(of);
    if(found.size() != of.size() + 3 || !is_word(found.substr(0, 3), "end") || !is_word(found.substr(3), of))
      m_in.fail("expected 'end" + std::string(of) + "'");
    return !m_in.failed();
  }

  void read_text()
  {
    for(m_in.skip_to_item(); !m_in.at_end(); m_in.skip_to_item())
    {
      if(!expect("solid"))
        return;
      m_in.skip_line(); // its name
      while(!m_in.failed() && read_facet())
        ;
      if(m_in.failed())
        return;
    }
  }

  // Returns false at the end of the solid.
  bool read_facet()
  {
    const std::string_view word = next_word();
    if(is_word(word, "endsolid") || is_word(word, "end"))
    {
      m_in.skip_line();
      return false;
    }
    if(!is_word(word, "facet"))
    {
      m_in.fail(m_in.at_end() ? "the file ends within a solid" : "expected 'facet' or 'endsolid'");
      return false;
    }
    if(!expect("normal"))
      return false;
    for(int d = 0; d < 3; ++d)
      m_in.word(); // whatever some program takes for the normal of a triangle without area
    if(m_in.failed() || !expect("outer") || !expect("loop"))
      return false;
    for(int k = 0; k < 3; ++k)
    {
      Polygon_soup::Point p = { { 0, 0, 0 } };
      if(!expect("vertex") || !(m_in.read(p[0]) && m_in.read(p[1]) && m_in.read(p[2])))
        return false;
      add_vertex(p);
    }
    m_soup.end_polygon();
    return !m_in.failed() && expect_end("loop") && expect_end("facet");
  }
};

inline void read_stl(Text_scanner& in, std::string_view text, Polygon_soup& soup) { Stl_reader(in, text, soup)(); }

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_READ_STL_H
