// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_FLAT_JSON_H
#define CGAL_QUAD_MESHING_IO_FLAT_JSON_H

#include <cmath>
#include <cstddef>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

namespace internal {

// The length of the well-formed UTF-8 sequence that starts at position i of s, 0 if there is none
// (Unicode standard, table 3-7: no overlong forms, no surrogates, nothing above U+10FFFF).
inline std::size_t utf8_sequence_length(const std::string& s, std::size_t i)
{
  auto byte = [&](std::size_t j) -> unsigned { return j < s.size() ? static_cast<unsigned char>(s[j]) : 0u; };
  auto in = [](unsigned b, unsigned first, unsigned last) { return first <= b && b <= last; };
  auto tail = [&](std::size_t j) { return in(byte(j), 0x80, 0xBF); };

  const unsigned b = byte(i), c = byte(i + 1);
  if(b < 0x80)
    return 1;
  if(in(b, 0xC2, 0xDF))
    return tail(i + 1) ? 2 : 0;
  if(in(b, 0xE0, 0xEF))
    return in(c, b == 0xE0 ? 0xA0 : 0x80, b == 0xED ? 0x9F : 0xBF) && tail(i + 2) ? 3 : 0;
  if(in(b, 0xF0, 0xF4))
    return in(c, b == 0xF0 ? 0x90 : 0x80, b == 0xF4 ? 0x8F : 0xBF) && tail(i + 2) && tail(i + 3) ? 4 : 0;
  return 0;
}

// A string as a JSON literal. File names may hold bytes that are not UTF-8, which JSON does not
// allow: each becomes the replacement character.
inline std::string json_string(const std::string& s)
{
  static const char* const hexadecimal = "0123456789abcdef";
  std::string out = "\"";
  for(std::size_t i = 0; i < s.size();)
  {
    const std::size_t length = utf8_sequence_length(s, i);
    const unsigned char c = static_cast<unsigned char>(s[i]);
    if(length == 0)
      out += "\xEF\xBF\xBD";
    else if(length > 1)
      out.append(s, i, length);
    else if(c == '"' || c == '\\')
      out += { '\\', static_cast<char>(c) };
    else if(c == '\n')
      out += "\\n";
    else if(c == '\r')
      out += "\\r";
    else if(c == '\t')
      out += "\\t";
    else if(c < 0x20 || c == 0x7F)
      out += { '\\', 'u', '0', '0', hexadecimal[c >> 4], hexadecimal[c & 15] };
    else
      out += static_cast<char>(c);
    i += (length == 0) ? 1 : length;
  }
  return out + '"';
}

// The shortest of the usual precisions that reads back as the same number; JSON knows no infinity
// and no NaN.
inline std::string json_number(double x)
{
  if(!std::isfinite(x))
    return "null";
  std::string out;
  for(int precision : { 6, 15, 16, 17 })
  {
    std::ostringstream os;
    os.imbue(std::locale::classic());
    os.precision(precision);
    os << x;
    out = os.str();
    std::istringstream is(out);
    is.imbue(std::locale::classic());
    double y = 0;
    if(is >> y && y == x)
      break;
  }
  return out;
}

} // namespace internal

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief is one flat JSON object: a list of keys with values that are truth values, integers,
 * floating point numbers or strings, written in the order in which the keys were first set.
 *
 * Floating point numbers are written such that they read back as the same `double`; numbers that are
 * not finite become `null`, as JSON has no word for them. Strings are escaped and always valid UTF-8.
 */
class Flat_json
{
  std::vector<std::pair<std::string, std::string>> m_members;

  void set_literal(const std::string& key, std::string literal)
  {
    for(auto& member : m_members)
    {
      if(member.first == key)
      {
        member.second = std::move(literal);
        return;
      }
    }
    m_members.emplace_back(key, std::move(literal));
  }

public:
  /// gives `key` the value `value`, in place of the value it may have had.
  /// `Number` is `bool`, an integer type or a floating point type.
  template <typename Number>
  std::enable_if_t<std::is_arithmetic<Number>::value> set(const std::string& key, Number value)
  {
    if constexpr(std::is_same<Number, bool>::value)
      set_literal(key, value ? "true" : "false");
    else if constexpr(std::is_integral<Number>::value)
      set_literal(key, std::to_string(value));
    else
      set_literal(key, internal::json_number(static_cast<double>(value)));
  }

  /// gives `key` the value `value`, in place of the value it may have had.
  void set(const std::string& key, const std::string& value) { set_literal(key, internal::json_string(value)); }

  /// gives `key` the value `value`, in place of the value it may have had.
  void set(const std::string& key, const char* value) { set(key, std::string(value)); }

  /// returns keys and values, these as JSON literals, in the order in which the keys were first set.
  const std::vector<std::pair<std::string, std::string>>& members() const { return m_members; }

  /// returns the number of keys.
  std::size_t size() const { return m_members.size(); }

  /// writes the object, one key per line.
  void write(std::ostream& os) const
  {
    os << "{";
    const char* separator = "\n";
    for(const auto& member : m_members)
    {
      os << separator << "  " << internal::json_string(member.first) << ": " << member.second;
      separator = ",\n";
    }
    os << (m_members.empty() ? "}\n" : "\n}\n");
  }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_FLAT_JSON_H
