// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_BINARY_SCANNER_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_BINARY_SCANNER_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

inline bool is_machine_big_endian()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

// Reads numbers of a given byte order from memory. What lies behind the end reads as 0 and is remembered.
class Binary_scanner
{
  const char* m_pos;
  const char* m_end;
  bool m_swaps;
  bool m_failed = false;

public:
  Binary_scanner(const char* begin, const char* end, bool is_big_endian)
    : m_pos(begin), m_end(end), m_swaps(is_big_endian != is_machine_big_endian())
  {
  }

  bool failed() const { return m_failed; }
  std::size_t left() const { return static_cast<std::size_t>(m_end - m_pos); }
  const char* position() const { return m_pos; }

  bool skip(std::size_t n)
  {
    m_failed = m_failed || n > left();
    if(!m_failed)
      m_pos += n;
    return !m_failed;
  }

  template <typename T>
  T read()
  {
    T value = 0;
    if(m_failed || left() < sizeof(T))
    {
      m_failed = true;
      return value;
    }
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), m_pos, sizeof(T));
    if(m_swaps)
      std::reverse(bytes.begin(), bytes.end());
    std::memcpy(&value, bytes.data(), sizeof(T));
    m_pos += sizeof(T);
    return value;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_BINARY_SCANNER_H
