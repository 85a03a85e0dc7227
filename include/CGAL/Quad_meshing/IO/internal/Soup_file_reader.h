// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_FILE_READER_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_FILE_READER_H

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

struct Polygon_soup
{
  typedef Simple_cartesian<double>::Point_3 Point_3;
  typedef std::vector<std::size_t> Polygon;

  std::vector<Point_3> points;
  std::vector<Polygon> polygons;
};

// A number with the word for what is counted.
inline std::string count_of(std::size_t n, const std::string& singular, const std::string& plural)
{
  return std::to_string(n) + " " + (n == 1 ? singular : plural);
}

// Reads numbers and words from a text in memory and knows the line it is in.
//
// Errors keep the first message and make all later reads fail, so that callers may read several
// items and look once.
class Text_scanner
{
  const char* m_pos;
  const char* m_end;
  std::size_t m_line = 1;
  std::string m_error;

  bool at_blank() const
  {
    return m_pos != m_end && (*m_pos == ' ' || *m_pos == '\t' || *m_pos == '\r' || *m_pos == '\v' || *m_pos == '\f');
  }

  bool at_token_end() const { return at_line_end() || at_blank(); }

public:
  explicit Text_scanner(const std::string& text) : m_pos(text.data()), m_end(text.data() + text.size()) {}

  const std::string& error() const { return m_error; }
  bool failed() const { return !m_error.empty(); }
  std::size_t line() const { return m_line; }

  void fail(const std::string& what)
  {
    if(m_error.empty())
      m_error = "line " + std::to_string(m_line) + ": " + what;
    m_pos = m_end;
  }

  bool at_end() const { return m_pos == m_end; }
  bool at_line_end() const { return m_pos == m_end || *m_pos == '\n' || *m_pos == '#'; }

  // Skips blanks within the line; a backslash before the end of the line joins the next one to it.
  void skip_blanks()
  {
    for(;;)
    {
      while(at_blank())
        ++m_pos;
      const char* p = m_pos;
      if(p == m_end || *p != '\\')
        return;
      ++p;
      if(p != m_end && *p == '\r')
        ++p;
      if(p == m_end || *p != '\n')
        return;
      m_pos = p + 1;
      ++m_line;
    }
  }

  void skip_line()
  {
    while(m_pos != m_end && *m_pos != '\n')
      ++m_pos;
    if(m_pos != m_end)
    {
      ++m_pos;
      ++m_line;
    }
  }

  // Skips blanks, comments and line ends up to the next item.
  void skip_to_item()
  {
    for(skip_blanks(); !at_end() && at_line_end(); skip_blanks())
      skip_line();
  }

  // The next word of the line, empty at its end.
  std::string word()
  {
    skip_blanks();
    const char* begin = m_pos;
    while(!at_token_end())
      ++m_pos;
    return std::string(begin, m_pos);
  }

  // A floating point number; "nan" and "inf" are numbers here, for the sake of the message.
  bool read(double& x)
  {
    skip_blanks();
    const char* begin = m_pos;
    if(m_end - begin > 1 && *begin == '+' && begin[1] != '-')
      ++begin;
#ifdef __cpp_lib_to_chars
    const std::from_chars_result result = std::from_chars(begin, m_end, x);
    const char* parsed = result.ptr;
    if(result.ec == std::errc::result_out_of_range)
      x = std::strtod(std::string(begin, parsed).c_str(), nullptr);
    else if(result.ec != std::errc())
      parsed = begin;
#else
    char* parsed = nullptr;
    x = std::strtod(begin, &parsed);
#endif
    return advance(parsed, begin, "a number");
  }

  bool read(long long& i)
  {
    skip_blanks();
    const char* begin = m_pos;
    const std::from_chars_result result = std::from_chars(begin, m_end, i);
    return advance(result.ec == std::errc() ? result.ptr : begin, begin, "an integer");
  }

  // As `read(long long&)`, but a slash may follow.
  bool read_before_slash(long long& i)
  {
    skip_blanks();
    const std::from_chars_result result = std::from_chars(m_pos, m_end, i);
    if(result.ec != std::errc() || (result.ptr != m_end && *result.ptr != '/' && !std::strchr(" \t\r\n\v\f\\#", *result.ptr)))
      return advance(m_pos, m_pos, "a vertex number");
    m_pos = result.ptr;
    while(!at_token_end())
      ++m_pos;
    return true;
  }

private:
  bool advance(const char* parsed, const char* begin, const char* expected)
  {
    if(failed())
      return false;
    const char* const before = m_pos;
    m_pos = parsed;
    if(parsed != begin && at_token_end())
      return true;
    m_pos = before;
    const std::string found = word().substr(0, 40);
    if(found.empty())
      fail(std::string(at_end() ? "the file ends" : "the line ends") + " where " + expected + " was expected");
    else
      fail(std::string("expected ") + expected + ", found '" + found + "'");
    return false;
  }
};

// OFF in text form, with the optional prefixes ST, C, N, 4 of the key word. A vertex and a face
// begin on lines of their own; what follows their coordinates and indices (colors, ...) is skipped.
inline bool read_off_text(const std::string& text, Polygon_soup& soup, std::string& error)
{
  Text_scanner in(text);
  bool is_homogeneous = false;
  in.skip_to_item();
  const std::string key = in.word();
  if(key.size() < 3 || key.compare(key.size() - 3, 3, "OFF") != 0)
    in.fail("the file does not start with OFF");
  else
    is_homogeneous = key.find('4') != std::string::npos;

  long long nv = 0, nf = 0;
  in.skip_to_item();
  in.read(nv);
  in.skip_to_item();
  in.read(nf);
  in.skip_line();
  // Every vertex and every face takes at least six bytes ("0 0 0\n").
  if(!in.failed() && (nv < 0 || nf < 0 || static_cast<unsigned long long>(nv) + static_cast<unsigned long long>(nf) > text.size()))
    in.fail("the header promises " + std::to_string(nv) + " vertices and " + std::to_string(nf) +
            " faces, more than the file can hold");

  for(long long i = 0; i < nv && !in.failed(); ++i)
  {
    double x = 0, y = 0, z = 0, w = 1;
    in.skip_to_item();
    in.read(x) && in.read(y) && in.read(z) && (!is_homogeneous || in.read(w));
    in.skip_line();
    soup.points.emplace_back(x / w, y / w, z / w);
  }
  for(long long i = 0; i < nf && !in.failed(); ++i)
  {
    long long n = 0;
    in.skip_to_item();
    if(!in.read(n))
      break;
    Polygon_soup::Polygon polygon;
    for(long long k = 0; k < n; ++k)
    {
      long long v = 0;
      if(!in.read(v))
        break;
      // A negative index becomes one that no vertex has, to be found with the other bad ones.
      polygon.push_back(static_cast<std::size_t>(v));
    }
    in.skip_line();
    soup.polygons.push_back(polygon);
  }
  error = in.error();
  return !in.failed();
}

// OBJ: the lines `v` and `f`; indices count from 1, negative ones from the vertex read last.
inline bool read_obj_text(const std::string& text, Polygon_soup& soup, std::string& error)
{
  Text_scanner in(text);
  while(!in.at_end())
  {
    const std::string key = in.word();
    if(key == "v")
    {
      double x = 0, y = 0, z = 0;
      in.read(x) && in.read(y) && in.read(z);
      soup.points.emplace_back(x, y, z);
    }
    else if(key == "f")
    {
      Polygon_soup::Polygon polygon;
      in.skip_blanks();
      while(!in.at_line_end())
      {
        long long v = 0;
        if(!in.read_before_slash(v))
          break;
        // Index 0, which OBJ does not have, becomes one that no vertex has.
        polygon.push_back(static_cast<std::size_t>(v > 0 ? v - 1
                                                         : v < 0 ? static_cast<long long>(soup.points.size()) + v : -1));
        in.skip_blanks();
      }
      soup.polygons.push_back(polygon);
    }
    in.skip_line();
  }
  error = in.error();
  return !in.failed();
}

// Whether the counts that a PLY header promises can fit into the file, so that no reader tries to
// allocate what is not there.
inline bool is_ply_header_plausible(const std::string& text, std::string& error)
{
  Text_scanner in(text);
  if(in.word() != "ply")
    in.fail("the file does not start with ply");
  while(!in.at_end())
  {
    in.skip_line();
    const std::string key = in.word();
    if(key == "end_header")
      return true;
    if(key != "element")
      continue;
    const std::string name = in.word();
    long long n = 0;
    if(in.read(n) && (n < 0 || static_cast<unsigned long long>(n) > text.size()))
      in.fail("the header promises " + std::to_string(n) + " elements '" + name + "', more than the file can hold");
  }
  if(!in.failed())
    in.fail("the header has no end");
  error = in.error();
  return false;
}

// Calls a reader of CGAL, which says no more than yes or no, on the bytes of the file.
template <typename Read>
bool read_with_cgal(const std::string& bytes, Read read, std::string& error)
{
  try
  {
    std::istringstream is(bytes, std::ios::in | std::ios::binary);
    if(read(is))
      return true;
  }
  catch(const std::exception&)
  {
    // Broken files make readers fail in many ways, the answer is one.
  }
  error = "the file is damaged or incomplete";
  return false;
}

// The extension of a file name in lower case letters, without the dot.
inline std::string file_extension(const std::string& filename)
{
  const std::size_t dot = filename.find_last_of("./\\");
  if(dot == std::string::npos || filename[dot] != '.')
    return std::string();
  std::string extension = filename.substr(dot + 1);
  for(char& c : extension)
    if('A' <= c && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

inline bool is_readable_format(const std::string& extension)
{
  return extension == "off" || extension == "obj" || extension == "ply" || extension == "stl";
}

// Parses the bytes of a file in the format that its extension names. The text formats are read here
// and not by CGAL's readers since those cannot say what is wrong and where, and take the first
// coordinate that is not a number for the end of the file.
inline bool parse_polygon_soup(const std::string& extension, const std::string& bytes,
                               Polygon_soup& soup, std::string& error)
{
  if(extension == "obj")
    return read_obj_text(bytes, soup, error);

  if(extension == "off")
  {
    const std::string first_line = bytes.substr(0, bytes.find('\n'));
    if(first_line.find("BINARY") == std::string::npos)
      return read_off_text(bytes, soup, error);
    return read_with_cgal(bytes, [&](std::istream& is) { return IO::read_OFF(is, soup.points, soup.polygons); }, error);
  }

  if(extension == "ply")
    return is_ply_header_plausible(bytes, error) &&
           read_with_cgal(bytes, [&](std::istream& is) { return IO::read_PLY(is, soup.points, soup.polygons); }, error);

  return read_with_cgal(bytes, [&](std::istream& is) { return IO::read_STL(is, soup.points, soup.polygons); }, error);
}

// All bytes of a file. Returns false, with the system's reason, if it cannot be read.
inline bool read_bytes(const std::string& filename, std::string& bytes, std::string& error)
{
  errno = 0;
  std::ifstream in(filename, std::ios::in | std::ios::binary);
  if(in)
  {
    std::ostringstream buffer;
    if(in.peek() != std::char_traits<char>::eof())
      buffer << in.rdbuf();
    if(!in.bad() && errno == 0)
    {
      bytes = buffer.str();
      return true;
    }
  }
  error = errno != 0 ? std::strerror(errno) : "unknown reason";
  return false;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SOUP_FILE_READER_H
