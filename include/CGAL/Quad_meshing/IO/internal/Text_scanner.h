// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_TEXT_SCANNER_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_TEXT_SCANNER_H

#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Larger coordinates make squares of areas overflow.
constexpr double largest_coordinate = 1e70;

// What is wrong with a coordinate, null if nothing is.
inline const char* coordinate_defect(double x)
{
  return !std::isfinite(x)                  ? " has a coordinate that is not a finite number"
         : std::abs(x) > largest_coordinate ? " has a coordinate too large to compute with"
                                            : nullptr;
}

// Reads numbers and words from a text in memory and knows the line it is in.
//
// Errors keep the first message and make all later reads fail, so that callers may read several items and look once.
class Text_scanner
{
  const char* m_pos;
  const char* m_end;
  std::size_t m_line = 1;
  std::string m_error;
  Mesh_reading_status m_status = Mesh_reading_status::SUCCESS;

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

  bool at_token_end() const { return at_line_end() || is_blank(*m_pos); }

public:
  Text_scanner(const char* begin, const char* end) : m_pos(begin), m_end(end) {}
  explicit Text_scanner(std::string_view text) : Text_scanner(text.data(), text.data() + text.size()) {}

  const std::string& error() const { return m_error; }
  Mesh_reading_status status() const { return m_status; }
  bool failed() const { return m_status != Mesh_reading_status::SUCCESS; }
  std::size_t line() const { return m_line; }
  const char* position() const { return m_pos; }

  void fail(const std::string& what, Mesh_reading_status status = Mesh_reading_status::MALFORMED_FILE)
  {
    fail_at(m_line, what, status);
  }

  void fail_at(std::size_t line, const std::string& what, Mesh_reading_status status)
  {
    fail_without_line("Line " + std::to_string(line) + ": " + what, status);
  }

  void fail_without_line(const std::string& what, Mesh_reading_status status)
  {
    if(!failed())
    {
      m_error = what + ".";
      m_status = status;
    }
    m_pos = m_end;
  }

  bool at_end() const { return m_pos == m_end; }
  bool at_line_end() const { return m_pos == m_end || *m_pos == '\n' || *m_pos == '#'; }

  // Skips blanks within the line; a backslash before the end of the line joins the next one to it.
  void skip_blanks()
  {
    for(;;)
    {
      while(m_pos != m_end && is_blank(*m_pos))
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
    if(m_pos != m_end && *m_pos == '\n') // the usual case, after all items of the line
    {
      ++m_pos;
      ++m_line;
      return;
    }
    const void* end = m_pos == m_end ? nullptr : std::memchr(m_pos, '\n', static_cast<std::size_t>(m_end - m_pos));
    if(end == nullptr)
      m_pos = m_end;
    else
    {
      m_pos = static_cast<const char*>(end) + 1;
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
  std::string_view word()
  {
    skip_blanks();
    const char* begin = m_pos;
    while(!at_token_end())
      ++m_pos;
    return std::string_view(begin, static_cast<std::size_t>(m_pos - begin));
  }

  // A floating point number; "nan" and "inf" are numbers here, for the sake of the message.
  bool read(double& x)
  {
    skip_blanks();
    const char* begin = m_pos;
    if(m_end - begin > 1 && *begin == '+' && begin[1] != '-')
      ++begin;
    return advance(parse(begin, x), begin, "a number");
  }

  bool read(long long& i)
  {
    skip_blanks();
    const char* begin = m_pos;
    const std::from_chars_result result = std::from_chars(begin, m_end, i);
    return advance(result.ec == std::errc() ? result.ptr : begin, begin, "an integer");
  }

  // A vertex of a face in OBJ, as 7, 7/1, 7//1 or 7/1/1; the numbers behind the slashes are passed over.
  bool read_before_slash(long long& i)
  {
    skip_blanks();
    const char* begin = m_pos;
    const std::from_chars_result result = std::from_chars(begin, m_end, i);
    const char* parsed = result.ec == std::errc() ? result.ptr : begin;
    if(parsed != begin && parsed != m_end && *parsed == '/')
      while(parsed != m_end && (*parsed == '/' || *parsed == '-' || ('0' <= *parsed && *parsed <= '9')))
        ++parsed;
    return advance(parsed, begin, "a vertex number");
  }

  // The same with the texture and the normal index, 0 where there is none.
  bool read_with_slashes(std::array<long long, 3>& indices)
  {
    indices = { { 0, 0, 0 } };
    skip_blanks();
    const char *const begin = m_pos, *parsed = begin;
    for(int k = 0; k < 3; ++k)
    {
      const std::from_chars_result result = std::from_chars(parsed, m_end, indices[k]);
      if(result.ec == std::errc())
        parsed = result.ptr;
      else if(k == 0)
        return advance(begin, begin, "a vertex number");
      if(parsed == m_end || *parsed != '/' || k == 2)
        break;
      ++parsed;
    }
    return advance(parsed, begin, "a vertex number");
  }

  // What is left of the line, without blanks at its ends: names may have blanks, and signs # that follow no blank.
  std::string rest_of_line()
  {
    skip_blanks();
    const char *const begin = m_pos, *end = begin;
    for(; m_pos != m_end && *m_pos != '\n' && !(*m_pos == '#' && end != m_pos); ++m_pos)
      if(!is_blank(*m_pos))
        end = m_pos + 1;
    return std::string(begin, end);
  }

  // Reads the numbers that are left in the line. Returns how many there are.
  std::size_t skip_numbers()
  {
    std::size_t n = 0;
    double ignored = 0;
    for(skip_blanks(); !at_line_end() && read(ignored); skip_blanks())
      ++n;
    return n;
  }

private:
  const char* parse(const char* begin, double& x) const
  {
#ifdef __cpp_lib_to_chars
    const std::from_chars_result result = std::from_chars(begin, m_end, x);
    if(result.ec == std::errc::result_out_of_range)
      x = out_of_range(std::string_view(begin, static_cast<std::size_t>(result.ptr - begin)));
    else if(result.ec != std::errc())
      return begin;
    return result.ptr;
#else
    // Standard libraries without that function: a copy of the word, read without regard to the locale.
    const char* end = begin;
    while(end != m_end && *end != '\n' && !is_blank(*end))
      ++end;
    std::istringstream is(std::string(begin, end));
    is.imbue(std::locale::classic());
    if(is >> x)
      return is.eof() ? end : begin + static_cast<std::ptrdiff_t>(is.tellg());
    const std::string text(begin, end);
    if(text == "nan" || text == "-nan" || text == "inf" || text == "-inf")
    {
      x = std::numeric_limits<double>::infinity();
      return end;
    }
    return begin;
#endif
  }

  // Such a number is too large if its exponent is positive or, without an exponent, if it has digits before the point;
  // else it is as good as zero.
  static double out_of_range(std::string_view text)
  {
    const std::size_t exponent = text.find_first_of("eE");
    const bool is_tiny = exponent != std::string_view::npos ? exponent + 1 < text.size() && text[exponent + 1] == '-'
                                                            : text.find_first_of("123456789") > text.find('.');
    return is_tiny ? 0 : std::numeric_limits<double>::infinity();
  }

  bool advance(const char* parsed, const char* begin, const char* expected)
  {
    if(failed())
      return false;
    const char* const before = m_pos;
    m_pos = parsed;
    if(parsed != begin && at_token_end())
      return true;
    m_pos = before;
    const std::string found(word().substr(0, 40));
    if(found.empty())
      fail(std::string(at_end() ? "the file ends" : "the line ends") + " where " + expected + " was expected");
    else
      fail(std::string("expected ") + expected + ", found '" + printable(found) + "'");
    return false;
  }

  // Damaged files hold any bytes, messages only letters.
  static std::string printable(std::string text)
  {
    for(char& c : text)
      if(static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E)
        c = '?';
    return text;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_TEXT_SCANNER_H
