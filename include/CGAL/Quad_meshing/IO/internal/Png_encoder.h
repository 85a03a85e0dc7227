// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_PNG_ENCODER_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_PNG_ENCODER_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Compresses bytes as RFC 1950 and 1951 say, with the fixed codes, and with repetitions of the last byte as the only
// ones: that is enough for pictures whose rows are differences to the row above, which are zero almost everywhere.
class Run_deflater
{
  std::string m_out;
  std::uint32_t m_bits = 0;
  int m_number_of_bits = 0;

public:
  std::string operator()(const std::string& data)
  {
    m_out = "\x78\x01";
    put(1, 1); // the last block
    put(1, 2); // of fixed codes
    for(std::size_t i = 0; i < data.size();)
    {
      const std::size_t run = i > 0 ? run_length(data, i) : 0;
      if(run >= shortest_run)
        put_run(run);
      else
        put_symbol(static_cast<unsigned char>(data[i]));
      i += run >= shortest_run ? run : 1;
    }
    put_symbol(256); // the end of the block
    put(0, 7);       // fills the last byte
    m_number_of_bits = 0;
    const std::uint32_t sum = checksum(data);
    for(int k = 3; k >= 0; --k)
      m_out += static_cast<char>(sum >> (8 * k) & 0xFF);
    return m_out;
  }

private:
  static constexpr std::size_t shortest_run = 3, longest_run = 258;

  static std::size_t run_length(const std::string& data, std::size_t i)
  {
    std::size_t n = 0;
    while(n < longest_run && i + n < data.size() && data[i + n] == data[i - 1])
      ++n;
    return n;
  }

  // Lower bits first.
  void put(std::uint32_t value, int number)
  {
    m_bits |= value << m_number_of_bits;
    m_number_of_bits += number;
    for(; m_number_of_bits >= 8; m_number_of_bits -= 8, m_bits >>= 8)
      m_out += static_cast<char>(m_bits & 0xFF);
  }

  // Codes have their higher bits first.
  void put_code(std::uint32_t code, int number)
  {
    for(int k = number - 1; k >= 0; --k)
      put(code >> k & 1, 1);
  }

  void put_symbol(unsigned symbol)
  {
    if(symbol < 144)
      put_code(0x30 + symbol, 8);
    else if(symbol < 256)
      put_code(0x190 + symbol - 144, 9);
    else if(symbol < 280)
      put_code(symbol - 256, 7);
    else
      put_code(0xC0 + symbol - 280, 8);
  }

  // A repetition of the byte before: distance 1, which is code 0 of five bits. Lengths from 3 to 10 have symbols of
  // their own, each following group of four symbols has one more bit behind it, 258 has the last symbol.
  void put_run(std::size_t run)
  {
    if(run == longest_run)
      put_symbol(285);
    else
    {
      unsigned rest = static_cast<unsigned>(run - shortest_run), extra = 0;
      for(; rest >> extra >= 8; ++extra)
      {
      }
      put_symbol(257 + 4 * extra + (rest >> extra));
      put(rest & ((1u << extra) - 1), static_cast<int>(extra));
    }
    put_code(0, 5);
  }

  // Adler's.
  static std::uint32_t checksum(const std::string& data)
  {
    const std::uint32_t prime = 65521;
    std::uint32_t a = 1, b = 0;
    for(char c : data)
    {
      a = (a + static_cast<unsigned char>(c)) % prime;
      b = (b + a) % prime;
    }
    return b << 16 | a;
  }
};

// Writes pictures of red, green and blue, eight bits each, as ISO/IEC 15948 says.
class Png_encoder
{
public:
  typedef std::array<unsigned char, 3> Pixel;

  // `pixels`: row after row from the top
  static void write(std::ostream& os, const std::vector<Pixel>& pixels, std::size_t width)
  {
    const std::size_t height = pixels.size() / width;
    std::string header = number(width) + number(height);
    header += { 8, 2, 0, 0, 0 }; // bits, color type, and the only methods there are
    os << "\x89PNG\r\n\x1a\n";
    write_chunk(os, "IHDR", header);
    write_chunk(os, "IDAT", Run_deflater()(rows(pixels, width, height)));
    write_chunk(os, "IEND", "");
  }

private:
  // Each row as the difference to the row above.
  static std::string rows(const std::vector<Pixel>& pixels, std::size_t width, std::size_t height)
  {
    std::string out;
    out.reserve(height * (3 * width + 1));
    for(std::size_t y = 0; y < height; ++y)
    {
      out += '\2';
      for(std::size_t x = 0; x < width; ++x)
        for(std::size_t k = 0; k < 3; ++k)
          out += static_cast<char>(pixels[y * width + x][k] - (y > 0 ? pixels[(y - 1) * width + x][k] : 0));
    }
    return out;
  }

  static std::string number(std::size_t n)
  {
    std::string out;
    for(int k = 3; k >= 0; --k)
      out += static_cast<char>(n >> (8 * k) & 0xFF);
    return out;
  }

  static void write_chunk(std::ostream& os, const std::string& type, const std::string& data)
  {
    std::uint32_t crc = 0xFFFFFFFF;
    for(char c : type + data)
    {
      crc ^= static_cast<unsigned char>(c);
      for(int k = 0; k < 8; ++k)
        crc = crc & 1 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
    }
    os << number(data.size()) << type << data << number(crc ^ 0xFFFFFFFF);
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_PNG_ENCODER_H
